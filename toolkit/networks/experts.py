"""Gated experts (Mason et al. 2022, section 4.1): K sets of weights for one small network, blended anew for every sample.

Shapes: B samples, K experts, D features.
"""

import math
from collections.abc import Callable

import torch
import torch.nn.functional as F
from torch import Tensor, nn


class BlendedLinear(nn.Module):
    """A dense layer whose weights are a blend of K experts': y = x (Σ αᵢ Wᵢ) + Σ αᵢ bᵢ.

    The blend is never formed: Σ αᵢ (x Wᵢ) is one product of the inputs, scaled by each gate and laid side by side
    ``[B, K n_in]``, with the experts' weights stacked ``[K n_in, n_out]``. For 32 samples that is five times as fast as
    blending weights sample by sample, and as fast for one.

    Parameters
    ----------
    experts
        K.
    n_in, n_out
        Columns of x and y.
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


class Gating(nn.Module):
    """The gating network Ω: phases to K blending coefficients that sum to one; three dense layers, ELU, softmax.

    Parameters
    ----------
    n_in
        Columns of the gating input (8: sine and cosine of four local phases).
    hidden
        Units of both hidden layers.
    experts
        K.
    dropout
        Share of every layer's inputs that training drops.
    """

    def __init__(self, n_in: int, hidden: int, experts: int, dropout: float):
        super().__init__()
        self.layers = nn.ModuleList((nn.Linear(n_in, hidden), nn.Linear(hidden, hidden), nn.Linear(hidden, experts)))
        self.dropout = nn.Dropout(dropout)
        for layer in self.layers:
            nn.init.xavier_uniform_(layer.weight)  # U(±√(6 / (in + out)))
            nn.init.zeros_(layer.bias)

    def forward(self, phases: Tensor) -> Tensor:
        """Normalised ``phases [B, n_in]`` to gates ``[B, K]``."""
        first, second, last = self.layers
        h = F.elu(first(self.dropout(phases)))
        h = F.elu(second(self.dropout(h)))
        return torch.softmax(last(self.dropout(h)), -1)


class Experts(nn.Module):
    """The motion synthesis network Φ: three blended layers, whose two hidden ones a style modulates.

    Parameters
    ----------
    experts
        K.
    n_in, hidden, n_out
        Columns of x, of both hidden layers and of z.
    dropout
        Share of every layer's inputs that training drops.
    """

    def __init__(self, experts: int, n_in: int, hidden: int, n_out: int, dropout: float):
        super().__init__()
        sizes = ((n_in, hidden), (hidden, hidden), (hidden, n_out))
        self.layers = nn.ModuleList(BlendedLinear(experts, *size) for size in sizes)
        self.dropout = nn.Dropout(dropout)

    def forward(self, x: Tensor, gates: Tensor, modulate: Callable[[int, Tensor], Tensor]) -> Tensor:
        """Output frames ``[B, n_out]``.

        Parameters
        ----------
        x : Tensor [B, n_in]
            Normalised input frames.
        gates : Tensor [B, K]
            Blending coefficients.
        modulate
            ``(layer, F [B, hidden]) -> h [B, hidden]``: the activation of hidden layer 0 or 1, where the style comes in.
        """
        *hidden, last = self.layers
        for i, layer in enumerate(hidden):
            x = modulate(i, layer(self.dropout(x), gates))
        return last(self.dropout(x), gates)
