"""Looping cycles: the best place to cut a motion so that it repeats; the rest of the difference is spread over the cycle."""

from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.clip import Clip, root_frames
from toolkit.motion.contacts import velocities
from toolkit.motion.tensors import through_numpy

GLANCE = 0.1  # seconds: a difference of velocities counts as that of positions after this time
PHASE = 0.05  # metres that a difference of 1 between phase vectors counts as
LONGER = 0.02  # share by which a cycle must match better to be a second longer


@dataclass(frozen=True)
class Seam:
    """How well a cycle closes: its last frame beside its first one, in the character's own frame."""

    position: float  # largest distance between the two places of a joint, metres
    velocity: float  # largest difference between a joint's velocities before and after the seam, m/s
    ordinary: float  # 95th percentile of such differences from frame to frame within the cycle, m/s


def find(clip: Clip, shortest: float, longest: float, phases: Tensor | None = None) -> tuple[int, int]:
    """First frame and number of frames of the cycle that repeats best.

    The last frame, one cycle after the first, is compared with it: places and velocities of all joints in the root frame,
    and phase vectors.

    Parameters
    ----------
    clip : a motion that repeats; its first and last frames are only neighbours of a cycle
    shortest, longest : seconds of a cycle
    phases : Tensor [F, P], phase vectors

    Raises
    ------
    ValueError
        If the clip is shorter than the shortest cycle.
    """
    low, high = round(shortest * clip.fps), min(round(longest * clip.fps), len(clip) - 3)
    if not 2 <= low <= high:
        raise ValueError(f"{clip.name}: {clip.seconds:.1f} s hold no cycle of {shortest:g} to {longest:g} s")
    local, moves = _own(clip)
    rows = torch.cat((local.flatten(1), GLANCE * moves.flatten(1)), 1) / len(clip.skeleton) ** 0.5
    if phases is not None:
        rows = torch.cat((rows, PHASE * phases.to(rows).flatten(1)), 1)
    apart = torch.cdist(rows, rows)
    best, found = float("inf"), (1, low)
    for frames in range(low, high + 1):
        misfit = apart.diagonal(frames)[1:-1]
        start = int(misfit.argmin())
        cost = float(misfit[start]) + LONGER * (frames - low) / clip.fps
        if cost < best:
            best, found = cost, (start + 1, frames)
    return found


def close(clip: Clip, start: int, frames: int) -> Clip:
    """The cycle of ``frames`` + 1 frames from ``start``; the last frame repeats the first one, a cycle further on its path.

    It begins at the origin, faces +z on average and does not turn from cycle to cycle. The differences of rotations, of the
    root's height and of their velocities at the two ends are removed by a cubic over the cycle, half at each end.

    Raises
    ------
    ValueError
        If the cycle and a frame on each side of it are not in the clip.
    """
    if not 1 <= start < start + frames + 1 < len(clip) or frames < 2:
        raise ValueError(f"{clip.name}: a cycle from frame {start} to {start + frames} needs a frame on each side; the clip "
                         f"has {len(clip)}")
    at = torch.arange(start - 1, start + frames + 2, device=clip.rotations.device)  # with a frame on each side
    turns, root = clip.rotations[at].double(), clip.root_positions[at].double()
    t = (torch.arange(-1, frames + 2, device=at.device, dtype=torch.float64) / frames)[:, None]
    heading = _headings(clip)[at].double()
    drift = heading[-2] - heading[1]
    facing = heading[1:-2].mean()
    straight = R.yaw(-facing - drift * (t[:, 0] - 0.5))
    turns = torch.cat((R.multiply(straight, turns[:, 0])[:, None], turns[:, 1:]), 1)
    steps = R.rotate(straight[1:], root.diff(dim=0))
    path = torch.cat((torch.zeros_like(root[:1]), steps.cumsum(0)))
    path = path - path[1]
    path[:, 1] = root[:, 1]
    along = path[-2] - path[1]
    along = along * torch.tensor([1.0, 0.0, 1.0]).to(along)
    path = _closed(path - t * along, t) + (t * along)[1:-1]
    moved = _closed_turns(turns, t)
    kept = clip.cut(start, start + frames + 1)
    return kept.replace(rotations=R.unroll(moved).to(clip.rotations), root_positions=path.to(clip.root_positions))


def in_place(cycle: Clip) -> Clip:
    """A closed cycle without its steady movement; sway and surge remain."""
    along = cycle.root_positions[-1] - cycle.root_positions[0]
    share = torch.arange(len(cycle), device=along.device)[:, None] / (len(cycle) - 1)
    return cycle.replace(root_positions=cycle.root_positions - (share * along).to(along))


def repeated(cycle: Clip, times: int) -> Clip:
    """A closed cycle several times in a row, its repeated frame once."""
    along = cycle.root_positions[-1] - cycle.root_positions[0]
    roots = [cycle.root_positions[:-1] + k * along for k in range(times)]
    return cycle.replace(rotations=R.unroll(torch.cat([cycle.rotations[:-1]] * times)), root_positions=torch.cat(roots))


def seam(cycle: Clip) -> Seam:
    """How well a cycle closes; its last frame stands for the first one of the next cycle."""
    along = (cycle.root_positions[-1] - cycle.root_positions[0]) * torch.tensor([1.0, 0.0, 1.0]).to(cycle.root_positions)
    places = cycle.global_positions
    steps = places.diff(dim=0)
    change = cycle.fps * steps.diff(dim=0).norm(dim=-1)
    return Seam(float((places[-1] - along - places[0]).norm(dim=-1).amax()),
                float(cycle.fps * (steps[0] - steps[-1]).norm(dim=-1).amax()),
                float(change.amax(-1).quantile(0.95)) if len(change) else 0.0)


def _own(clip: Clip) -> tuple[Tensor, Tensor]:
    """Places and velocities ``[F, J, 3]`` of the joints in the root frame."""
    roots, places = root_frames(clip), clip.global_positions
    return roots.to_local(places), roots.turn_to_local(velocities(places, clip.fps))


def _headings(clip: Clip) -> Tensor:
    """Angle of the root frame about the vertical ``[F]``, radians, without jumps."""
    w, _, y, _ = root_frames(clip).rotations.unbind(-1)
    return through_numpy(np.unwrap, 2 * torch.atan2(y, w))


def _cubic(t: Tensor, gap: Tensor, change: Tensor) -> Tensor:
    """Corrections ``[F, ...]`` at ``t`` in [0, 1]: from -gap/2 to gap/2, with slopes -change/2 and change/2."""
    return gap * (3 * t**2 - 2 * t**3 - 0.5) + change * (-0.5 * (t**3 - 2 * t**2 + t) + 0.5 * (t**3 - t**2))


def _closed(values: Tensor, t: Tensor) -> Tensor:
    """Values of the cycle, without the frames beside it, whose two ends and their slopes agree."""
    n = len(values) - 3
    slopes = [(values[k + 1] - values[k - 1]) * n / 2 for k in (1, n + 1)]
    return values[1:-1] + _cubic(t[1:-1], values[1] - values[n + 1], slopes[0] - slopes[1])


def _closed_turns(turns: Tensor, t: Tensor) -> Tensor:
    """`_closed` for rotations ``[F, J, 4]``."""
    n = len(turns) - 3
    gap = _vector(turns[1], turns[n + 1])
    slopes = [_vector(turns[k + 1], turns[k - 1]) * n / 2 for k in (1, n + 1)]
    correction = _cubic(t[1:-1, :, None], gap, slopes[0] - slopes[1])
    angle = correction.norm(dim=-1)
    return R.multiply(R.from_axis_angle(R.normalize(correction), angle), turns[1:-1])


def _vector(a: Tensor, b: Tensor) -> Tensor:
    """Rotation vector ``[..., 3]`` of the turn from ``b`` to ``a``."""
    q = R.multiply(a, R.inverse(b))
    q = torch.where(q[..., :1] < 0, -q, q)
    length = q[..., 1:].norm(dim=-1, keepdim=True)
    return 2 * torch.atan2(length, q[..., :1]) * q[..., 1:] / length.clamp_min(1e-12)
