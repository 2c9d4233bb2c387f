"""The trajectory window: where the root was and will be, seen from where it is (Mason et al. 2022, section 3.2)."""

import torch
from torch import Tensor

from toolkit import rotations as R
from toolkit.motion import RootFrames

FPS = 60
#: Sample offsets in frames at 60 Hz: six past ones, the current frame, five future ones.
SAMPLES = tuple(range(-60, 60, 10))
PAST, FUTURE = -SAMPLES[0], SAMPLES[-1]
CURRENT = SAMPLES.index(0)


def sample(roots: RootFrames, frames: Tensor, offsets: tuple[int, ...] = SAMPLES) -> tuple[Tensor, Tensor]:
    """Trajectory around given frames, each in the root frame of its own frame.

    Parameters
    ----------
    roots
        Root frames of F frames at 60 Hz.
    frames : Tensor [N]
        Frames to stand in.
    offsets
        Which frames to look at from there (S of them); all must lie inside the clip.

    Returns
    -------
    positions, directions : Tensor [N, S, 2]
        x (left) and z (forward) of the root's position, metres, and of its unit facing direction.

    Raises
    ------
    ValueError
        If a sample falls outside the clip.
    """
    at = frames[:, None] + torch.tensor(offsets)
    if int(at.min()) < 0 or int(at.max()) >= len(roots.rotations):
        raise ValueError(f"trajectory samples reach from frame {int(at.min())} to {int(at.max())}, "
                         f"the clip has {len(roots.rotations)}")  # fmt: skip
    here = RootFrames(roots.positions[frames], roots.rotations[frames])
    forward = torch.tensor([0.0, 0.0, 1.0])
    positions = here.to_local(roots.positions[at])
    directions = here.turn_to_local(R.rotate(roots.rotations[at], forward))
    return positions[..., [0, 2]], directions[..., [0, 2]]
