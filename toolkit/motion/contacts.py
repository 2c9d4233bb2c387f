"""Foot contacts: when a toe stands on the floor (Mason et al. 2022, section 4.1.2)."""

import math

import torch
from torch import Tensor
from torch.nn import functional

from toolkit.motion.clip import Clip
from toolkit.motion.skeleton import FEET as FEET

BALL = 0.01  # metres (ours): thickness of the floor
HEIGHT = 0.01  # d_max of the paper, metres
REACH = 0.06  # metres above the floor in which a slow toe may stand; a lifted foot is higher
MAJORITY = 5 / 60  # seconds, half the width of the majority vote
DRIFT = 0.02  # metres over a clip: a floor that rises or falls by less is level


def detect(clip: Clip, *, height: float | None = None, speed: float | Tensor = 0.15) -> Tensor:
    """Contacts ``[F, 2]`` of the right and the left foot: 1 in contact, 0 otherwise.

    A foot is in contact when its toe is low and slow; a majority vote over the neighbouring frames
    then removes flicker.

    Departure from the paper: there d_max is 1 cm, or chosen by hand for a motion, and there is no
    vote. In recordings with markers on the toes, a standing toe moves up and down by several
    centimetres, and 1 cm leaves out most of a step. By default our d_max follows from the clip and
    is 1 cm or more: the 95th percentile of a toe's heights above the floor, where it is slow and
    not above `REACH`.

    Parameters
    ----------
    clip : the motion, at any rate
    height : d_max, metres; a toe is low up to this and `BALL` above the floor
    speed : v_max, metres per second, one or of each frame ``[F, 1]``
    """
    if height is not None and not abs(height) <= 1:
        raise ValueError(f"the contact height must be from -1 to 1 metres, got {height:g}")
    toes = toes_of(clip)
    above = toes[..., 1] - floor_height(clip)[:, None]
    slow = velocities(toes, clip.fps).norm(dim=-1) <= speed
    if height is None:
        standing = above.where(slow & (above <= REACH), math.nan)
        height = standing.nanquantile(0.95, dim=0).nan_to_num(HEIGHT).clamp_min(HEIGHT)
    low = above <= height + BALL
    half = max(1, round(MAJORITY * clip.fps))
    votes = (low & slow).to(toes.dtype).T[:, None]
    votes = functional.pad(votes, (half, half), mode="replicate")
    return functional.avg_pool1d(votes, 2 * half + 1, stride=1)[:, 0].T.round()


def floor_height(clip: Clip) -> Tensor:
    """Height ``[F]`` of a standing toe joint, metres, see `floor_line`."""
    return floor_line(toes_of(clip)[..., 1].amin(1), max(1, round(clip.fps)), DRIFT)


def floor_line(lower: Tensor, part: int, drift: float) -> Tensor:
    """The floor ``[F]`` below a lower toe's heights ``lower [F]``.

    It is fitted to the lowest height in each block of ``part`` frames; its slope is the median of
    those between all pairs of blocks (Theil and Sen). A line that changes by less than ``drift``,
    or that fits little better than a level floor, is level.
    """
    level = lower.quantile(0.05).expand(len(lower))
    if lower.is_meta or len(lower) < 4 * part:
        return level
    lowest = lower[: len(lower) // part * part].view(-1, part).amin(1)
    if float(lowest.amax() - lowest.amin()) < drift:
        return level
    at = torch.arange(len(lowest), device=lower.device)
    first, second = torch.triu_indices(len(lowest), len(lowest), 1, device=lower.device)
    slope = ((lowest[second] - lowest[first]) / (second - first)).median()
    tilted = lowest - slope * at
    spread = [(x - x.median()).abs().median() for x in (lowest, tilted)]
    if float(slope.abs()) * len(lowest) < drift or float(spread[1]) > 0.5 * float(spread[0]):
        return level
    tilt = slope * torch.arange(len(lower), device=lower.device) / part
    return tilt + (lower - tilt).quantile(0.05)


def standing_height(clip: Clip) -> Tensor:
    """Height of a standing toe joint, metres: the 5th percentile of the lower toe's height."""
    return toes_of(clip)[..., 1].amin(1).quantile(0.05)


def toes_of(clip: Clip) -> Tensor:
    """Positions ``[F, 2, 3]`` of the right and the left toe."""
    return clip.global_positions[:, clip.skeleton.both("toe")]


def velocities(positions: Tensor, fps: float) -> Tensor:
    """Backward differences over the first axis, per second; the first repeats the second."""
    if len(positions) < 2:
        return torch.zeros_like(positions)
    steps = (positions[1:] - positions[:-1]) * fps
    return torch.cat((steps[:1], steps))
