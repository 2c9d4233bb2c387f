"""Looping cycles: the best place to cut a motion so that it repeats."""

import torch
from torch import Tensor

from toolkit.motion.clip import Clip, root_frames
from toolkit.motion.contacts import velocities

GLANCE = 0.1  # seconds: a difference of velocities counts as that of positions after this time
PHASE = 0.05  # metres that a difference of 1 between phase vectors counts as
LONGER = 0.02  # share by which a cycle must match better to be a second longer


def find(clip: Clip, shortest: float, longest: float,
         phases: Tensor | None = None) -> tuple[int, int]:
    """First frame and number of frames of the cycle that repeats best.

    The last frame, one cycle after the first, is compared with it: places and velocities of all
    joints in the root frame, and phase vectors.

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
        raise ValueError(f"{clip.name}: {clip.seconds:.1f} s hold no cycle of {shortest:g} to "
                         f"{longest:g} s")
    roots = root_frames(clip)
    places = roots.to_local(clip.global_positions)
    moves = roots.turn_to_local(velocities(clip.global_positions, clip.fps))
    rows = torch.cat((places.flatten(1), GLANCE * moves.flatten(1)), 1)
    rows = rows / len(clip.skeleton) ** 0.5
    if phases is not None:
        rows = torch.cat((rows, PHASE * phases.to(rows).flatten(1)), 1)

    # A diagonal of the distances between frames holds all cycles of one length.
    apart = torch.cdist(rows, rows)
    best, found = float("inf"), (1, low)
    for frames in range(low, high + 1):
        misfit = apart.diagonal(frames)[1:-1]
        start = int(misfit.argmin())
        cost = float(misfit[start]) + LONGER * (frames - low) / clip.fps
        if cost < best:
            best, found = cost, (start + 1, frames)
    return found
