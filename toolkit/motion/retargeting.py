"""Retargeting: the world rotations of a motion on another skeleton, with that skeleton's bone lengths.

Rigs differ in names, in joints along the spine and in their local axes (Bandai-Namco's bones lie along x). We first estimate
the axes that each joint of the clip has in a T-pose. For hips and legs they are the signed coordinate axes nearest to the
body's own axes over the clip, turned so that the bone has the direction of the new skeleton's bone. Arms mostly hang, so
their axes are found from the bone and the elbow's axis. Spine, neck, head and hands have the axes of their parent.
"""

from itertools import pairwise

import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.clip import SIDES, Clip, Skeleton, local_rotations, root_frames
from toolkit.motion.contacts import standing_height
from toolkit.motion.tensors import as_tensor

STRAIGHT = 0.02  # sine of the mean bend below which an arm's elbow axis cannot be found
PARTS = {"arm": ("collar", "shoulder", "elbow", "hand"), "leg": ("hip", "knee", "foot", "toe")}  # from the trunk outwards


def retarget(clip: Clip, skeleton: Skeleton) -> Clip:
    """The clip on a skeleton whose zero rotations are a T-pose facing +z, as 100STYLE's are.

    Limbs keep their world rotations by role; spine and neck are interpolated along their length. The root's path is scaled
    by the ratio of the leg lengths, and shifted so that the toes stand on the floor. Joints without a counterpart follow
    their parents. A clip whose skeleton has the same names and parents is returned unchanged, with its own bone lengths.
    ValueError if the clip's skeleton lacks one of the limbs, or its legs have no length.
    """
    own = clip.skeleton
    if (own.names, own.parents) == (skeleton.names, skeleton.parents):
        return clip
    if lacking := [role for role in skeleton.roles if role not in own.roles]:
        raise ValueError(f"{clip.name}: cannot find its {', '.join(lacking)} among {', '.join(own.names)}")
    if not _leg(own):
        raise ValueError(f"{clip.name}: its legs have no length")
    turned = _limbs(clip, skeleton) | _trunk(clip, skeleton)
    world = clip.rotations.new_empty(len(clip), len(skeleton), 4)
    for joint, parent in enumerate(skeleton.parents):
        world[:, joint] = turned[joint] if joint in turned else world[:, parent]
    scale = _leg(skeleton) / _leg(own)
    made = clip.replace(skeleton=skeleton, rotations=R.unroll(local_rotations(skeleton, world)),
                        root_positions=scale * clip.global_positions[:, own.role("hips")])
    return made.moved(shift=(0.0, scale * float(standing_height(clip)) - float(standing_height(made)), 0.0))


def _leg(skeleton: Skeleton) -> float:
    """Hip to ankle along the bones, metres."""
    return sum(float(skeleton.offsets[skeleton.role(f"left_{part}")].norm()) for part in ("knee", "foot"))


def _axes(clip: Clip, joint: int) -> Tensor:
    """Axes of a joint's frame nearest to the body's left, up and forward over the clip, as a rotation ``[4]``."""
    facing = R.inverse(root_frames(clip).rotations)
    return R.inverse(_nearest(R.multiply(facing, clip.global_rotations[:, joint])))


def _onward(clip: Clip, joint: int, axes: Tensor) -> Tensor:
    """Axes of a joint from those of its parent: rigs turn them by multiples of 90 degrees, motion turns them by less."""
    return R.multiply(R.inverse(_nearest(clip.rotations[:, joint])), axes)


def _nearest(turns: Tensor) -> Tensor:
    """The rotation ``[4]`` that maps coordinate axes to coordinate axes and is nearest to the mean of ``turns [F, 4]``."""
    mean = R.to_matrix(turns).mean(0)
    axes, left = torch.zeros_like(mean), mean.clone()
    for _ in range(2):  # the two largest entries in turn
        row, column = divmod(int(left.abs().argmax()), 3)
        axes[row, column] = mean[row, column].sign()
        left[row], left[:, column] = 0.0, 0.0
    missing = int((axes.abs().sum(0) == 0).nonzero()[0])
    axes[:, missing] = torch.linalg.cross(axes[:, (missing + 1) % 3], axes[:, (missing + 2) % 3])
    return R.from_matrix(axes)


def _aim(axes: Tensor, bone: Tensor, wanted: Tensor) -> Tensor:
    """Axes ``[4]`` turned the shortest way so that the new skeleton's bone ``wanted`` [3] lies along the clip's."""
    return R.multiply(R.between(R.normalize(R.rotate(axes, wanted)), R.normalize(bone)), axes)


def _trunk(clip: Clip, skeleton: Skeleton) -> dict[int, Tensor]:
    """World rotations ``[F, 4]`` of hips, spine, neck and head."""
    chains = []
    for s in (clip.skeleton, skeleton):
        chest, spine = s.trunk[0], s.trunk[::-1]
        head = next((j for j, name in enumerate(s.names) if name.lower().endswith("head")), chest)
        above = [head, *s.ancestors(head)]
        neck = above[: above.index(chest) + 1][::-1] if chest in above else [chest]
        hips = s.role("hips")
        chains.append((spine[spine.index(hips) if hips in spine else 0 :], neck))
    first = chains[0][0][0]
    turned, axes = {}, {first: _axes(clip, first)}
    for from_, to in zip(*chains, strict=True):
        for parent, joint in pairwise(from_):
            axes[joint] = _onward(clip, joint, axes[parent])
        world = [R.multiply(clip.global_rotations[:, j], axes[j]) for j in from_]
        for i, joint in enumerate(to):
            place = i / max(len(to) - 1, 1) * (len(from_) - 1)
            below = min(int(place), max(len(from_) - 2, 0))
            turned[joint] = R.slerp(world[below], world[min(below + 1, len(from_) - 1)], place - below)
    return turned


def _limbs(clip: Clip, skeleton: Skeleton) -> dict[int, Tensor]:
    """World rotations ``[F, 4]`` of arms and legs."""
    own, turned = clip.skeleton, {}
    for side in SIDES:
        for limb, parts in PARTS.items():
            axes = None
            for part, onward in zip(parts, (*parts[1:], None), strict=True):
                joint, there = _part(own, side, part), _part(skeleton, side, part)
                if onward is None:
                    axes = _onward(clip, joint, axes) if limb == "arm" else _axes(clip, joint)
                else:
                    bone, wanted = (s.offsets[_part(s, side, onward)].to(clip.rotations) for s in (own, skeleton))
                    bent = limb == "arm" and part != "collar"
                    axes = _arm(clip, side, joint, bone, wanted) if bent else _aim(_axes(clip, joint), bone, wanted)
                turned[there] = R.multiply(clip.global_rotations[:, joint], axes)
    return turned


def _part(skeleton: Skeleton, side: str, part: str) -> int:
    """Index of a part of a limb; a collar is the parent of a shoulder."""
    return skeleton.parents[skeleton.role(f"{side}_shoulder")] if part == "collar" else skeleton.role(f"{side}_{part}")


def _arm(clip: Clip, side: str, joint: int, bone: Tensor, wanted: Tensor) -> Tensor:
    """Axes of an arm in the T-pose, where the elbow's axis is vertical; a straight arm is treated like a leg."""
    shoulder, elbow, hand = (clip.skeleton.role(f"{side}_{part}") for part in ("shoulder", "elbow", "hand"))
    upper, lower = (clip.global_positions[:, b] - clip.global_positions[:, a] for a, b in ((shoulder, elbow), (elbow, hand)))
    bent = torch.linalg.cross(R.normalize(upper), R.normalize(lower))
    along, hinge = R.normalize(bone), R.rotate(R.inverse(clip.global_rotations[:, joint]), bent).mean(0)
    hinge = hinge - along * (along @ hinge)
    if float(hinge.norm()) < STRAIGHT:
        return _aim(_axes(clip, joint), bone, wanted)
    hinge = R.normalize(hinge)
    down = as_tensor([0.0, -1.0 if side == "left" else 1.0, 0.0], "down", wanted)
    across = R.normalize(wanted)
    source = torch.stack((along, hinge, torch.linalg.cross(along, hinge)), 1)
    target = torch.stack((across, down, torch.linalg.cross(across, down)), 1)
    return R.from_matrix(source @ target.T)
