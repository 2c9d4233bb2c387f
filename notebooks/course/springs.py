"""A cut between two motions without a jump (Bollo, "Inertialization", GDC 2018)."""

import torch
from torch import Tensor

from toolkit.motion.springs import spring


def inertialise(before: Tensor, after: Tensor, fps: float, rate: float) -> Tensor:
    """Frames ``after [F, ...]`` that continue ``before [E, ...]`` without a jump.

    The differences of value and velocity at the cut become an offset that decays as a `spring`.
    After the cut only the new motion is needed, so that a transition costs no second evaluation.
    Both parts have two frames or more.
    """
    velocity = (before[-1] - before[-2]) * fps
    offset = before[-1] + velocity / fps - after[0]
    drift = velocity - (after[1] - after[0]) * fps
    return torch.stack([frame + spring(offset, drift, rate, k / fps)[0]
                        for k, frame in enumerate(after)])
