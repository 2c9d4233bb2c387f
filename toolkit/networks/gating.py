"""How the experts' weights are blended, frame by frame: by a gating network (LPN, MANN) or by a phase alone (PFNN).

Each takes the phases p and the input frames x, uses one of them, and gives coefficients ``[B, K]`` that sum to one.
"""

import math
from collections.abc import Sequence

import torch
import torch.nn.functional as F
from torch import Tensor, nn

CONTROL_POINTS = 4  # K of the phase function


class Gating(nn.Module):
    """The gating network Ω of the LPN: phases to K positive coefficients; three dense layers, ELU, softmax.

    It has ``n_in`` inputs (8: sine and cosine of four local phases), ``hidden`` units in both hidden layers and ``experts``
    outputs, K. ``dropout`` is the share of every layer's inputs that training drops.
    """

    def __init__(self, n_in: int, hidden: int, experts: int, dropout: float):
        super().__init__()
        self.layers = nn.ModuleList((nn.Linear(n_in, hidden), nn.Linear(hidden, hidden), nn.Linear(hidden, experts)))
        self.dropout = nn.Dropout(dropout)
        for layer in self.layers:
            nn.init.xavier_uniform_(layer.weight)  # U(±√(6 / (in + out)))
            nn.init.zeros_(layer.bias)

    def forward(self, phases: Tensor, x: Tensor | None = None) -> Tensor:
        """Normalised ``phases [B, n_in]`` to gates ``[B, K]``; x is not used."""
        first, second, last = self.layers
        h = F.elu(first(self.dropout(phases)))
        h = F.elu(second(self.dropout(h)))
        return torch.softmax(last(self.dropout(h)), -1)


class VelocityGating(Gating):
    """The gating of the MANN (Zhang et al. 2018; section 5.1.3): its inputs are the velocities of hands and feet in x
    instead of phases: ``columns`` of x. Other arguments are those of `Gating`.
    """

    def __init__(self, columns: Sequence[int], hidden: int, experts: int, dropout: float):
        super().__init__(len(columns), hidden, experts, dropout)
        self.columns = list(columns)

    def forward(self, phases: Tensor, x: Tensor) -> Tensor:
        """Normalised ``x [B, Dx]`` to gates ``[B, K]``; the phases are not used."""
        return super().forward(x[:, self.columns])


class CatmullRom(nn.Module):
    """The phase function of the PFNN (Holden et al. 2017; section 5): a closed spline through K sets of weights,
    at equal distances of the phase.

    A point of a Catmull-Rom spline is a blend of its four nearest control points. The coefficients depend only on the
    distances to them (in steps of 2π/K). So this is a gating for the same blended layers as the others. Its coefficients
    sum to one and may be negative. It has no parameters. ``points`` is the number K of control points, four or more.
    """

    def __init__(self, points: int = CONTROL_POINTS):
        super().__init__()
        if points < 4:
            raise ValueError(f"a closed Catmull-Rom curve needs 4 control points or more, got {points}")
        self.points = points

    def forward(self, phase: Tensor, x: Tensor | None = None) -> Tensor:
        """``phase [B, 1]``, an angle in radians, to gates ``[B, K]``; x is not used."""
        along = phase * (self.points / math.tau) - torch.arange(self.points, device=phase.device)
        d = ((along + self.points / 2) % self.points - self.points / 2).abs()
        near, far = 1 + d * d * (1.5 * d - 2.5), 2 + d * (d * (2.5 - 0.5 * d) - 4)
        return torch.where(d < 1, near, torch.where(d < 2, far, 0.0))
