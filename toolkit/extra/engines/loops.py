"""A cycle of a motion, closed: the difference of its two ends is spread over the cycle."""

from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from toolkit.motion import Clip, root_frames, rotations as R
from toolkit.motion.loops import find as find
from toolkit.motion.tensors import through_numpy


@dataclass(frozen=True)
class Seam:
    """How well a cycle closes: its last frame beside its first one."""

    position: float  # largest distance between the two places of a joint, metres
    velocity: float  # largest change of a joint's velocity across the seam, m/s
    ordinary: float  # 95th percentile of such differences from frame to frame within the cycle, m/s


def close(clip: Clip, start: int, frames: int) -> Clip:
    """The cycle of ``frames`` + 1 frames from ``start``; its last frame repeats its first one.

    It begins at the origin, faces +z on average and does not turn from cycle to cycle. The
    differences of rotations, of the root's height and of their velocities at the two ends are
    removed by a cubic over the cycle, half at each end.

    Raises
    ------
    ValueError
        If the cycle and a frame on each side of it are not in the clip.
    """
    if not 1 <= start < start + frames + 1 < len(clip) or frames < 2:
        raise ValueError(f"{clip.name}: a cycle from frame {start} to {start + frames} needs a "
                         f"frame on each side; the clip has {len(clip)}")
    at = torch.arange(start - 1, start + frames + 2, device=clip.rotations.device)
    turns, root = clip.rotations[at].double(), clip.root_positions[at].double()
    t = (torch.arange(-1, frames + 2, device=at.device, dtype=torch.float64) / frames)[:, None]

    # Turn each frame so that the path is straight and the mean direction is +z.
    heading = _headings(clip)[at].double()
    drift = heading[-2] - heading[1]
    facing = heading[1:-2].mean()
    straight = R.yaw(-facing - drift * (t[:, 0] - 0.5))
    turns = torch.cat((R.multiply(straight, turns[:, 0])[:, None], turns[:, 1:]), 1)

    # Walk the turned steps from the origin, and close what is left without the steady movement.
    steps = R.rotate(straight[1:], root.diff(dim=0))
    path = torch.cat((torch.zeros_like(root[:1]), steps.cumsum(0)))
    path = path - path[1]
    path[:, 1] = root[:, 1]
    along = path[-2] - path[1]
    along = along * torch.tensor([1.0, 0.0, 1.0]).to(along)
    path = _closed(path - t * along, t) + (t * along)[1:-1]
    moved = _closed_turns(turns, t)
    kept = clip.cut(start, start + frames + 1)
    return kept.replace(rotations=R.unroll(moved).to(clip.rotations),
                        root_positions=path.to(clip.root_positions))


def in_place(cycle: Clip) -> Clip:
    """A closed cycle without its steady movement; sway and surge remain."""
    along = cycle.root_positions[-1] - cycle.root_positions[0]
    share = torch.arange(len(cycle), device=along.device)[:, None] / (len(cycle) - 1)
    return cycle.replace(root_positions=cycle.root_positions - (share * along).to(along))


def repeated(cycle: Clip, times: int) -> Clip:
    """A closed cycle several times in a row, its repeated frame once."""
    along = cycle.root_positions[-1] - cycle.root_positions[0]
    roots = [cycle.root_positions[:-1] + k * along for k in range(times)]
    turns = R.unroll(torch.cat([cycle.rotations[:-1]] * times))
    return cycle.replace(rotations=turns, root_positions=torch.cat(roots))


def seam(cycle: Clip) -> Seam:
    """How well a cycle closes; its last frame stands for the first one of the next cycle."""
    root = cycle.root_positions
    along = (root[-1] - root[0]) * torch.tensor([1.0, 0.0, 1.0]).to(root)
    places = cycle.global_positions
    steps = places.diff(dim=0)
    change = cycle.fps * steps.diff(dim=0).norm(dim=-1)
    return Seam(float((places[-1] - along - places[0]).norm(dim=-1).amax()),
                float(cycle.fps * (steps[0] - steps[-1]).norm(dim=-1).amax()),
                float(change.amax(-1).quantile(0.95)) if len(change) else 0.0)


def _headings(clip: Clip) -> Tensor:
    """Angle of the root frame about the vertical ``[F]``, radians, without jumps."""
    w, _, y, _ = root_frames(clip).rotations.unbind(-1)
    return through_numpy(np.unwrap, 2 * torch.atan2(y, w))


def _cubic(t: Tensor, gap: Tensor, change: Tensor) -> Tensor:
    """From -gap/2 at ``t`` = 0 to gap/2 at 1, with slopes -change/2 and change/2."""
    slopes = (t**3 - t**2) / 2 - (t**3 - 2 * t**2 + t) / 2
    return gap * (3 * t**2 - 2 * t**3 - 0.5) + change * slopes


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
