"""The trajectory window: past and future of the root in its present frame.

Source: Mason et al. 2022, section 3.2.
"""

import torch
from torch import Tensor

from toolkit.motion.clip import RootFrames

FPS = 60
#: Default sample offsets of a `toolkit.features.Layout`, frames: six past, five future ones.
SAMPLES = tuple(range(-60, 60, 10))
WHOLE = SAMPLES[-1] - SAMPLES[0] + 2  # frames of a clip with one whole window and the next one
PAST = -SAMPLES[0]  # frames of the past that a character keeps; no offset reaches further back


def sample(roots: RootFrames, frames: Tensor,
           offsets: tuple[int, ...] = SAMPLES) -> tuple[Tensor, Tensor]:
    """Trajectory around given frames, each in the root frame of its own frame.

    Parameters
    ----------
    roots : root frames of F frames at 60 Hz
    frames : Tensor [N], the frames that the trajectory is relative to
    offsets : S frame numbers relative to those; ValueError if a sample falls outside the clip

    Returns
    -------
    positions, directions : Tensor [N, S, 2]
        (x left, z forward) of the root in metres and of its unit facing direction
    """
    at = frames[:, None] + torch.tensor(offsets, device=frames.device)
    if int(at.min()) < 0 or int(at.max()) >= len(roots.rotations):
        raise ValueError(f"trajectory samples reach from frame {int(at.min())} to {int(at.max())}, "
                         f"the clip has {len(roots.rotations)}")
    sin, cos = heading(roots.rotations[frames][:, None])
    x, _, z = (roots.positions[at] - roots.positions[frames][:, None]).unbind(-1)
    sin_there, cos_there = heading(roots.rotations[at])
    positions = torch.stack((cos * x - sin * z, sin * x + cos * z), -1)
    directions = sin_there * cos - cos_there * sin, cos_there * cos + sin_there * sin
    return positions, torch.stack(directions, -1)


def heading(rotations: Tensor) -> tuple[Tensor, Tensor]:
    """Sine and cosine of the angle of rotations ``[..., 4]`` about the vertical."""
    w, _, y, _ = rotations.unbind(-1)
    return 2 * w * y, w * w - y * y
