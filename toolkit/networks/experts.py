"""Gated experts (Mason et al. 2022, section 4.1): K sets of weights for one small network, blended for every sample.

Shapes: B samples, K experts, D features.
"""

import math
from collections.abc import Callable

import torch
from torch import Tensor, nn

SAMPLES = 32  # number of samples whose blended weights are in memory at a time


class BlendedLinear(nn.Module):
    """A dense layer whose weights are a blend of those of K experts: y = x (Σ αᵢ Wᵢ) + Σ αᵢ bᵢ.

    Blended weights are not computed. Σ αᵢ (x Wᵢ) is one matrix product: the inputs times each gate, side by side
    ``[B, K n_in]``, times the stacked weights of the experts ``[K n_in, n_out]``. For 32 samples this is five times as fast
    as to blend the weights for each sample; for one sample both take the same time. The numbers are ``experts``, K, and
    the columns ``n_in`` of x and ``n_out`` of y.
    """

    def __init__(self, experts: int, n_in: int, n_out: int):
        super().__init__()
        bound = math.sqrt(6.0 / (n_in * n_out))
        self.weight = nn.Parameter(torch.empty(experts, n_in, n_out).uniform_(-bound, bound))
        self.bias = nn.Parameter(torch.zeros(experts, n_out))

    def forward(self, x: Tensor, gates: Tensor) -> Tensor:
        """``x [B, n_in]`` and ``gates [B, K]`` to ``[B, n_out]``."""
        scaled = (gates[:, :, None] * x[:, None, :]).flatten(1)
        return torch.addmm(gates @ self.bias, scaled, self.weight.flatten(0, 1))

    def scatter(self, x: Tensor, gates: Tensor) -> Tensor:
        """Σᵢ xᵢ² Wᵢⱼ² ``[B, n_out]`` of the blended weights W: y's variance per unit of relative variance of each input.

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
    """The motion synthesis network Φ: three blended layers. The style modulates the two hidden layers.

    The numbers are ``experts``, K, and columns of x (``n_in``), of both hidden layers and of z (``n_out``); ``dropout`` is
    the share of every layer's inputs that training drops.
    """

    def __init__(self, experts: int, n_in: int, hidden: int, n_out: int, dropout: float):
        super().__init__()
        sizes = ((n_in, hidden), (hidden, hidden), (hidden, n_out))
        self.layers = nn.ModuleList(BlendedLinear(experts, *size) for size in sizes)
        self.dropout = nn.Dropout(dropout)

    def forward(self, x: Tensor, gates: Tensor, modulate: Callable[[int, Tensor, Tensor], Tensor]) -> Tensor:
        """Output frames ``[B, n_out]``.

        Parameters
        ----------
        x : Tensor [B, n_in]
            Normalised input frames.
        gates : Tensor [B, K]
            Blending coefficients.
        modulate
            ``(layer, F [B, hidden], x [B, n]) -> h [B, hidden]``: the styled activation of hidden layer 0 or 1, from the
            layer's linear output F and its inputs x.
        """
        *hidden, last = self.layers
        for i, layer in enumerate(hidden):
            x = self.dropout(x)
            x = modulate(i, layer(x, gates), x)
        return last(self.dropout(x), gates)
