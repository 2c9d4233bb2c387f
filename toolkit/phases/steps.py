"""Steps of a foot: when it stands in recorded motion, and the phase that its steps give.

Not in the paper, whose contact compares a toe with fixed limits of height and speed. Recordings
break fixed limits: a floor that drifts, a foot that slips or twists while it stands, a run in which
a toe never rests. A sinusoid fitted in a window of a whole cycle also averages over steps of
different length, at a start, a stop, a turn or a stumble. Here the limits follow from the movement
of the toe nearby, and every single step gives the phase.

Lengths are in leg lengths, from hip to toe, and speeds in leg lengths per second, so the result
does not depend on the unit.
"""

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.motion import Clip, contacts
from toolkit.motion.skeleton import Skeleton

SPIKE = 0.08  # seconds, width of the median filter that removes spikes of single frames
NOISE = 0.02  # seconds, standard deviation of the Gaussian that removes noise
NEARBY = 0.6  # seconds before and after a frame in which the limits are sought
BEFORE = 0.3  # seconds, less than a swing: the toe is not lower than in its stance
SLIP = 0.2  # largest speed of a foot that slips while it stands
SPEED, SHARE = 0.1, 0.1  # a toe stands up to this above its slip: a speed, a share of its peak
HEIGHT = 0.04  # largest height of a toe that stands, above its lowest point within `BEFORE`
RAISED = 0.05  # a toe that is so far above the other for most of the clip never stands
SURE = 1.5  # largest evidence of one frame
PENALTY = 0.03  # seconds of evidence that a change must be worth
WALK = 0.6  # share of a cycle in which a foot stands in a walk
EARLY = 1 / 3  # weight of the touch-down against the middle of a stance, where its share changes
NONE = 1e-6  # metres: a shorter leg counts as missing


class Steps:
    """A source: 1 while a foot stands, else 0. Hands take no steps, so their curve is 0.

    The stances are the path through standing and swinging with the least sum of the `evidence`
    against it and `PENALTY` for each change (Viterbi 1967), so a short doubt does not split a step.
    """

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Stances ``[F]`` of a limb."""
        if not limb.endswith("foot"):
            return clip.root_positions.new_zeros(len(clip))
        from toolkit.phases.viterbi import smoothest

        column = contacts.FEET.index(limb.removesuffix("_foot"))
        cost = evidence(clip)[:, column] / clip.fps
        # states: 0 swings, 1 stands
        standing = smoothest(np.stack((-cost, cost), 1), PENALTY * (1.0 - np.eye(2)))
        return torch.from_numpy(standing).to(clip.root_positions)


def evidence(clip: Clip) -> np.ndarray:
    """Evidence ``[F, 2]`` that the right and the left foot swing (positive) or stand (negative).

    It is the larger of ln(speed / limit) and height / `HEIGHT` − 1, within ± `SURE`. The least
    speed within `NEARBY` counts as slipping; the height is that above the recent lowest point. A
    foot that is `RAISED` in most frames always swings.
    """
    lengths = np.array([[leg_length(clip.skeleton, side)] for side in contacts.FEET])
    toes = contacts.toes_of(clip).double().cpu().numpy() / lengths

    # speed of the toes, without the noise of recordings
    filters, around = scipy.ndimage, 2 * round(NEARBY * clip.fps) + 1
    spike = 2 * round(SPIKE * clip.fps / 2) + 1
    toes = filters.median_filter(toes, (spike, 1, 1), mode="mirror")
    toes = filters.gaussian_filter1d(toes, NOISE * clip.fps, axis=0, mode="nearest")
    moves = np.gradient(toes, 1 / clip.fps, axis=0) if len(toes) > 1 else np.zeros_like(toes)
    speed = np.linalg.norm(moves, axis=-1)

    def least(values: np.ndarray, size: int) -> np.ndarray:
        return filters.minimum_filter1d(values, size, axis=0, mode="nearest")

    # slow for this toe at this time
    slip = np.minimum(least(speed, around), SLIP)
    peak = filters.maximum_filter1d(speed, around, axis=0, mode="nearest")
    limit = slip + np.maximum(SPEED, SHARE * (peak - slip))
    fast = np.log(np.maximum(speed, 1e-6) / limit)
    # and low: a knee that is lifted high rests at the top
    height = toes[..., 1]
    high = (height - least(height, 2 * round(BEFORE * clip.fps) + 1)) / HEIGHT - 1
    swings = np.maximum(fast, high)
    lowest = least(height, around)
    above = np.median(lowest - lowest.min(1, keepdims=True), axis=0)
    swings[:, above > RAISED] = SURE
    return np.clip(swings, -SURE, SURE)


def leg_length(skeleton: Skeleton, side: str) -> float:
    """Length of the bones from hip to toe, metres; ValueError if the toe is not below the hip."""
    start, end = (skeleton.role(f"{side}_{part}") for part in ("hip", "toe"))
    chain = skeleton.tree.up(end)
    bones = chain[: chain.index(start)] if start in chain else []
    length = float(skeleton.offsets[bones].norm(dim=-1).sum())
    if length < NONE:
        raise ValueError(f"{side}_foot: {length:g} m of bones from {skeleton.names[start]} down to "
                         f"{skeleton.names[end]}; check the roles of the skeleton")
    return length


def signal(contact: Tensor) -> Tensor | None:
    """Complex signal ``[F]`` of a 0/1 curve, whose angle grows by about π from middle to middle.

    None if the curve has other values or fewer than three changes.

    The middles are those of ones (standing) and of zeros (swinging); the angle is linear between
    them. Ones that last longer than the zeros on both sides together hold it for the rest of their
    time, because a foot that stands still makes no progress. The ends go on at the rate of the
    nearest half cycle.

    Where ones take the share `WALK` of a cycle, as in a walk, the angle is 0 in the middle of ones.
    A sinusoid has its maximum there; the phase of Holden et al. 2017 is fixed to the touch-down.
    The two move apart when a walk becomes a run. The angle keeps its distance from the middle for
    two thirds and from the touch-down for one third (`EARLY`). So at the k-th middle it is

        angle_k = π (k + (share_k − WALK) · EARLY),   even k standing, odd k swinging,

    where share_k is the part of the cycle around it in which the foot stands::

        1 ┌──────┐        ┌──────┐
        0 ┘      └────────┘      └──
              0       π       2π
    """
    value = contact.cpu().double().numpy()
    change = np.flatnonzero(np.diff(value)) + 0.5
    if len(change) < 3 or not np.isin(value, (0.0, 1.0)).all():
        return None
    length, middle = np.diff(change), (change[1:] + change[:-1]) / 2
    standing = value[np.ceil(change[:-1]).astype(int)] == 1
    # long stances: half of the time in which the angle is held
    pause = np.where(standing, np.maximum(length - 2 * _beside(length), 0.0), 0.0) / 2
    moving = length - 2 * pause
    # angle at each middle, later where the stances are longer than in a walk; the first may swing
    share = np.where(standing, moving, _beside(moving)) / (moving + _beside(moving))
    angle = np.pi * (np.arange(len(middle)) + (not standing[0]) + (share - WALK) * EARLY)
    # straight lines between the pauses, and far enough beyond both ends
    times, far = np.stack((middle - pause, middle + pause), 1).ravel(), len(value)
    rate = np.diff(angle) / (times[2::2] - times[1:-1:2])
    times = np.concatenate(([times[0] - far], times, [times[-1] + far]))
    angles = np.pad(angle.repeat(2), 1, mode="edge")
    angles[[0, -1]] += far * rate[[0, -1]] * [-1, 1]
    return torch.exp(1j * torch.from_numpy(np.interp(np.arange(far), times, angles)).to(contact))


def _beside(values: np.ndarray) -> np.ndarray:
    """Mean of both neighbours ``[N]``; an end has one neighbour."""
    padded = np.pad(values, 1, mode="reflect")
    return (padded[2:] + padded[:-2]) / 2
