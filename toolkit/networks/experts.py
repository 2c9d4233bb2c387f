"""Gated experts (Mason et al. 2022, section 4.1): K sets of weights, blended for every sample.

A gating network (LPN, MANN) or a phase alone (PFNN) says how: from the phases p or the input frames
x it makes coefficients ``[B, K]`` that sum to one. Shapes: B samples, K experts. The numbers of
units and the ``dropout`` of each layer's inputs are those of `Sizes`.
"""

import math
from collections.abc import Callable, Sequence

import torch
import torch.nn.functional as F
from torch import Tensor, nn

SAMPLES = 32  # number of samples whose blended weights are in memory at a time
CONTROL_POINTS = 4  # K of the phase function


class BlendedLinear(nn.Module):
    """A dense layer whose weights are a blend of those of K experts: y = x (Σ αᵢ Wᵢ) + Σ αᵢ bᵢ.

    Σ αᵢ (x Wᵢ) is one matrix product: the inputs times each gate, side by side ``[B, K n_in]``,
    times the stacked weights of the experts ``[K n_in, n_out]``. For 32 samples this is five times
    as fast as to blend the weights for each sample, for one sample as fast.
    """

    def __init__(self, experts: int, n_in: int, n_out: int):
        super().__init__()
        # the bound of the published run: a product, where Xavier's has the sum
        bound = math.sqrt(6.0 / (n_in * n_out))
        self.weight = nn.Parameter(torch.empty(experts, n_in, n_out).uniform_(-bound, bound))
        self.bias = nn.Parameter(torch.zeros(experts, n_out))

    def forward(self, x: Tensor, gates: Tensor) -> Tensor:
        """``x [B, n_in]`` and ``gates [B, K]`` to ``[B, n_out]``."""
        scaled = (gates[:, :, None] * x[:, None, :]).flatten(1)
        return torch.addmm(gates @ self.bias, scaled, self.weight.flatten(0, 1))

    def scatter(self, x: Tensor, gates: Tensor) -> Tensor:
        """Σᵢ xᵢ² Wᵢⱼ² ``[B, n_out]`` of the blended weights W.

        This is y's variance per unit of relative variance of each input.
        It needs the blended weights, and computes them for a few samples at a time.
        """
        if torch.compiler.is_exporting():
            return self._scatter(x, gates)
        parts = zip(x.split(SAMPLES), gates.split(SAMPLES), strict=True)
        return torch.cat([self._scatter(*part) for part in parts])

    def _scatter(self, x: Tensor, gates: Tensor) -> Tensor:
        blended = torch.einsum("bk,kij->bij", gates, self.weight)
        return torch.einsum("bi,bij->bj", x.square(), blended.square())


class Experts(nn.Module):
    """The motion synthesis network Φ: three blended layers; the style modulates the hidden two."""

    def __init__(self, experts: int, n_in: int, hidden: int, n_out: int, dropout: float):
        super().__init__()
        sizes = ((n_in, hidden), (hidden, hidden), (hidden, n_out))
        self.layers = nn.ModuleList(BlendedLinear(experts, *size) for size in sizes)
        self.dropout = nn.Dropout(dropout)

    def forward(self, x: Tensor, gates: Tensor,
                modulate: Callable[[int, Tensor, Tensor], Tensor]) -> Tensor:
        """Normalised ``x [B, n_in]`` and ``gates [B, K]`` to output frames ``[B, n_out]``.

        ``modulate(layer, F [B, hidden], x [B, n]) -> h [B, hidden]`` is the styled activation of
        hidden layer 0 or 1, from the layer's linear output F and its inputs x.
        """
        *hidden, last = self.layers
        for i, layer in enumerate(hidden):
            x = self.dropout(x)
            x = modulate(i, layer(x, gates), x)
        return last(self.dropout(x), gates)


class Gating(nn.Module):
    """The gating network Ω of the LPN: phases to K positive coefficients that sum to one.

    The ``n_in`` phases are 8: sine and cosine of four local phases.
    """

    def __init__(self, n_in: int, hidden: int, experts: int, dropout: float):
        super().__init__()
        sizes = ((n_in, hidden), (hidden, hidden), (hidden, experts))
        self.layers = nn.ModuleList(nn.Linear(*size) for size in sizes)
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
    """The gating of the MANN (Zhang et al. 2018; section 5.1.3).

    Its inputs are velocities of hands and feet, ``columns`` of x, instead of phases.
    """

    def __init__(self, columns: Sequence[int], hidden: int, experts: int, dropout: float):
        super().__init__(len(columns), hidden, experts, dropout)
        self.columns = list(columns)

    def forward(self, phases: Tensor, x: Tensor) -> Tensor:
        """Normalised ``x [B, Dx]`` to gates ``[B, K]``; the phases are not used."""
        return super().forward(x[:, self.columns])


class CatmullRom(nn.Module):
    """The phase function of the PFNN (Holden et al. 2017): a closed spline through sets of weights.

    A point of a Catmull-Rom spline is a blend of its four nearest control points, of K =
    `CONTROL_POINTS`. The coefficients depend only on the distances d to them (in steps of 2π/K),
    sum to one and may be negative. So this is a gating without parameters.
    """

    def forward(self, phase: Tensor, x: Tensor | None = None) -> Tensor:
        """``phase [B, 1]``, an angle in radians, to gates ``[B, K]``; x is not used."""
        k = CONTROL_POINTS
        along = phase * (k / math.tau) - torch.arange(k, device=phase.device)
        d = ((along + k / 2) % k - k / 2).abs()
        near, far = 1 + d * d * (1.5 * d - 2.5), 2 + d * (d * (2.5 - 0.5 * d) - 4)
        return torch.where(d < 1, near, torch.where(d < 2, far, 0.0))
