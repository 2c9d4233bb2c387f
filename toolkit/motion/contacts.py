"""Foot contacts: when a toe stands on the floor (Mason et al. 2022, section 4.1.2)."""

import torch
from torch import Tensor

from toolkit.motion.clip import FEET, Clip

BALL = 0.01  # thickness of the floor, metres


def detect(clip: Clip, *, height: float = 0.01, speed: float = 0.15, majority: int = 5,
           floor: float | None = None) -> Tensor:
    """Contacts ``[F, 2]`` of the right and the left foot: 1 in contact, 0 otherwise.

    A foot is in contact when its toe is low and slow; a majority vote over the neighbouring frames then removes flicker.

    Parameters
    ----------
    clip : the motion, at any rate
    height : d_max, metres; a toe is low when it is at most this and `BALL` above the floor
    speed : v_max, metres per second
    majority : half the width of the vote, in frames at 60 Hz
    floor : height of a standing toe joint, metres; by default the clip's `standing_height`, because rigs differ
    """
    toes = clip.global_positions[:, [clip.skeleton.role(f"{side}_toe") for side in FEET]]
    low = toes[..., 1] - (standing_height(clip) if floor is None else floor) <= height + BALL
    slow = velocities(toes, clip.fps).norm(dim=-1) <= speed
    half = max(1, round(majority * clip.fps / 60))
    votes = torch.nn.functional.pad((low & slow).to(toes.dtype).T[:, None], (half, half), mode="replicate")
    return torch.nn.functional.avg_pool1d(votes, 2 * half + 1, stride=1)[:, 0].T.round()


def standing_height(clip: Clip) -> Tensor:
    """Height of a toe joint that stands on the floor, metres: the 5th percentile of the lower toe's height."""
    return clip.global_positions[:, [clip.skeleton.role(f"{side}_toe") for side in FEET], 1].amin(1).quantile(0.05)


def velocities(positions: Tensor, fps: float) -> Tensor:
    """Backward differences over the first axis, per second; the first frame repeats the second's."""
    if len(positions) < 2:
        return torch.zeros_like(positions)
    steps = (positions[1:] - positions[:-1]) * fps
    return torch.cat((steps[:1], steps))
