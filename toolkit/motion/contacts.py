"""Foot contacts: when a toe stands on the floor (Mason et al. 2022, section 4.1.2)."""

import torch
from torch import Tensor

from toolkit.motion.clip import FEET, Clip

BALL = 0.01


def detect(
    clip: Clip, *, height: float = 0.01, speed: float = 0.15, majority: int = 5, floor: float | None = None
) -> Tensor:
    """Contacts of the right and the left foot.

    A frame is a contact when a ball of radius `height` round the toe meets the ball-thick floor and the toe is slower than
    `speed`; a majority vote over the frames around it then removes flicker.

    Parameters
    ----------
    clip
        The motion, any rate.
    height
        d_max, metres.
    speed
        v_max, metres per second.
    majority
        Half width of the vote in frames at 60 Hz.
    floor
        Height of a standing toe joint, metres. Rigs differ (their toe joint lies in the sole or above it), so by default it
        is read from the clip: the 5th percentile of the lower toe's height.

    Returns
    -------
    Tensor [F, 2]
        1 in contact, 0 otherwise; right, left.
    """
    toes = clip.global_positions[:, [clip.skeleton.role(f"{side}_toe") for side in FEET]]
    if floor is None:
        floor = toes[..., 1].amin(1).quantile(0.05)
    low = toes[..., 1] - floor <= height + BALL
    slow = velocities(toes, clip.fps).norm(dim=-1) <= speed
    half = max(1, round(majority * clip.fps / 60))
    votes = torch.nn.functional.pad((low & slow).to(toes.dtype).T[:, None], (half, half), mode="replicate")
    return torch.nn.functional.avg_pool1d(votes, 2 * half + 1, stride=1)[:, 0].T.round()


def velocities(positions: Tensor, fps: float) -> Tensor:
    """Backward differences over the first axis, per second; the first frame repeats the second's."""
    if len(positions) < 2:
        return torch.zeros_like(positions)
    steps = (positions[1:] - positions[:-1]) * fps
    return torch.cat((steps[:1], steps))
