"""Trunk and limbs as points on the axes of their bones, and arms that keep clear of the body."""

import numpy as np
import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.clip import Clip
from toolkit.motion.roles import SIDES
from toolkit.motion.skeleton import local_rotations
from toolkit.motion.tensors import through_numpy

POINTS = 6  # of a bone, between which distances are measured
# Metres that forearms keep from the axes of trunk and thighs. Recorded people, too, are seldom much
# nearer (`toolkit.evaluation.findings.LIMITS`).
TRUNK, THIGH = 0.085, 0.065
DROP = 0.1  # metres below the shoulder from which turning the arm moves a point well aside
WIDEST = 1.0  # radians by which an arm is turned at most
EASE = 0.2  # seconds: half of the time in which a correction comes, and goes
ROUNDS = 2  # the turned arm moves on an arc, not straight


def trunk(clip: Clip) -> Tensor:
    """Points ``[F, N, 3]`` on the axis of the trunk, from above the hips to the shoulders."""
    p, skeleton = clip.global_positions.double(), clip.skeleton
    hips, chest = p[:, skeleton.role("hips")], p[:, skeleton.trunk[0]]
    shoulders = p[:, skeleton.both("shoulder")].mean(1)
    return torch.cat((_points(hips, chest)[:, 1:], _points(chest, shoulders)[:, 1:]), 1)


def limbs(clip: Clip) -> dict[str, Tensor]:
    """Points ``[F, N, 3]`` on the bones of the limbs, without their first, by the end's role."""
    p, skeleton = clip.global_positions.double(), clip.skeleton
    bones = ("elbow", "hand"), ("hip", "knee"), ("knee", "foot")
    return {f"{side}_{end}": _points(p[:, skeleton.role(f"{side}_{start}")],
                                     p[:, skeleton.role(f"{side}_{end}")])[:, 1:]
            for side in SIDES for start, end in bones}


def _points(a: Tensor, b: Tensor) -> Tensor:
    return a[:, None].lerp(b[:, None], torch.linspace(0, 1, POINTS).to(a)[:, None])


def arms_out(clip: Clip, trunk_gap: float = TRUNK, thigh_gap: float = THIGH) -> Clip:
    """The clip with arms turned away from the body where a forearm is in its trunk or thighs.

    Both arms turn about the shoulder, sideways, by about the angle (at most `WIDEST`) that brings
    all points of the forearm as far as the gaps (metres) from the axes of trunk and thighs. Before
    and after such a moment the angle grows and falls within twice `EASE`.
    """
    skeleton = clip.skeleton
    points, places = limbs(clip), clip.global_positions.double()
    thighs, axis = torch.cat([points[f"{side}_knee"] for side in SIDES], 1), trunk(clip)
    left, right = (places[:, skeleton.role(f"{side}_hip")] for side in ("left", "right"))
    across = R.normalize((left - right) * left.new_tensor([1.0, 0.0, 1.0]))
    down = across.new_tensor([0.0, -1.0, 0.0]).expand_as(across)
    for side, outwards in (("left", across), ("right", -across)):
        shoulder = skeleton.role(f"{side}_shoulder")
        below = skeleton.tree.below(shoulder)
        for _ in range(ROUNDS):
            arm = limbs(clip)[f"{side}_hand"]
            lack = torch.maximum(_lack(arm, axis, outwards, trunk_gap),
                                 _lack(arm, thighs, outwards, thigh_gap))
            if not bool(lack.any()):
                break
            drop = (places[:, None, shoulder, 1] - arm[..., 1]).clamp_min(DROP)
            angle = covering((lack / drop).amax(1).clamp_max(WIDEST), clip.fps)
            turn = R.from_axis_angle(torch.linalg.cross(down, outwards), angle).to(clip.rotations)
            turned = clip.global_rotations.clone()
            turned[:, below] = R.normalize(R.multiply(turn[:, None], turned[:, below]))
            clip = clip.replace(rotations=local_rotations(skeleton, turned))
    return clip


def _lack(points: Tensor, others: Tensor, outwards: Tensor, gap: float) -> Tensor:
    """How far points ``[F, N, 3]`` must go ``outwards [F, 3]`` to be ``gap`` from all others."""
    apart = points[:, :, None] - others[:, None]
    along = (apart * outwards[:, None, None]).sum(-1)
    across = apart.square().sum(-1) - along.square()  # squared, from the line outwards
    # outwards, a point leaves the ball of radius ``gap`` where along² = gap² - across
    lack = (gap**2 - across).clamp_min(0.0).sqrt() - along
    return lack.where(across < gap**2, 0.0).amax(2)


def covering(need: Tensor, fps: float) -> Tensor:
    """A smooth curve ``[F]``, nowhere below ``need [F]``; 0 farther than twice `EASE` from it."""
    import scipy.ndimage  # a live character needs none

    reach, filters = max(1, round(EASE * fps)), scipy.ndimage

    def smooth(curve: np.ndarray) -> np.ndarray:
        high = filters.maximum_filter1d(curve, 2 * reach + 1, mode="nearest")
        return filters.gaussian_filter1d(high, reach / 2, mode="nearest", radius=reach)

    return through_numpy(smooth, need.clamp_min(0.0))
