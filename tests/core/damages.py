"""Damages of a motion, each of a given size: what measures and the gate must see."""

import dataclasses
import math

import torch

from toolkit.motion import rotations as R
from toolkit.motion.ik import turn_arms, two_bone


def noise(clip, degrees, seed=0):
    """White noise on all joint rotations."""
    draw = torch.randn(*clip.rotations.shape[:2], 3, generator=torch.Generator().manual_seed(seed))
    return turned(clip, slice(None), draw * math.radians(degrees))


def turned(clip, joints, vectors):
    """Joints turned by rotation vectors ``[F, joints, 3]``, radians."""
    angle = vectors.norm(dim=-1)
    axis = vectors / angle.clamp_min(1e-9)[..., None]
    q = clip.rotations.clone()
    q[:, joints] = R.multiply(q[:, joints], R.from_axis_angle(axis, angle))
    return clip.replace(rotations=R.normalize(q))


def carried(clip, speed):
    """The whole body is carried sideways over the floor, m/s."""
    time = torch.arange(len(clip))[:, None] / clip.fps
    return clip.replace(root_positions=clip.root_positions + time * torch.tensor([speed, 0, 0]))


def shaken(clip, metres):
    """The root goes to and fro from frame to frame."""
    way = torch.ones(len(clip), 1)
    way[::2] = -1
    return clip.replace(root_positions=clip.root_positions + way * torch.tensor([metres, 0, 0]))


def jumped(clip, metres):
    """The root is elsewhere in one frame in the middle."""
    roots = clip.root_positions.clone()
    roots[len(clip) // 2, 1] += metres
    return clip.replace(root_positions=roots)


def leg(clip, metres, side="left"):
    """One leg longer, so that its toe sinks (or shorter: it hovers)."""
    skeleton = clip.skeleton
    offsets = skeleton.offsets.clone()
    foot = skeleton.role(f"{side}_foot")
    offsets[foot] *= 1 + metres / offsets[foot].norm()
    return clip.replace(skeleton=dataclasses.replace(skeleton, offsets=offsets))


def frozen(clip, share):
    """The upper body keeps its mean pose, to a share."""
    skeleton, q = clip.skeleton, R.unroll(clip.rotations).clone()
    above = skeleton.tree.below(skeleton.trunk[0])
    above = [j for j in above if j] if skeleton.trunk[0] else above
    mean = R.normalize(q[:, above].mean(0, keepdim=True))
    q[:, above] = R.normalize(q[:, above] * (1 - share) + mean * share)
    return clip.replace(rotations=q)


def through(clip, share, side="left"):
    """A hand is led towards the axis of the trunk, by a share of its distance."""
    skeleton, wanted = clip.skeleton, clip.global_positions.clone()
    shoulder, elbow, hand = (skeleton.role(f"{side}_{part}")
                             for part in ("shoulder", "elbow", "hand"))
    target = wanted[:, hand].lerp(wanted[:, skeleton.trunk[0]], share)
    wanted[:, elbow], wanted[:, hand] = two_bone(
        wanted[:, shoulder], wanted[:, elbow], wanted[:, hand], target)
    made = turn_arms(skeleton, clip.rotations, clip.root_positions, wanted)
    return clip.replace(rotations=made)


def slowed(clip, factor):
    """The same motion in more time."""
    return clip.replace(fps=clip.fps * factor).resample(clip.fps)


def shortened(clip, share):
    """Only the first part."""
    return clip.cut(0, max(4, round(len(clip) * share)))
