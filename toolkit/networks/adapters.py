"""Style as a shift of one hidden layer: one-hot labels and residual adapters (section 5).

The paper compares FiLM with both (Holden et al. 2017; Mason et al. 2018). A style vector holds all
parameters of one style, so vectors can be stored and blended like those of FiLM. Neither normalises
a layer.

The paper does not say how tables are initialised. We draw each style's shift from a normal
distribution of unit variance, so a short training can tell styles apart. With zeros, one-hot models
had not learnt it after 600 minibatches of 64.
"""

import math

import torch
import torch.nn.functional as F
from torch import Tensor, nn


class StyleTable(nn.Module):
    """Style vectors as learnt parameters ``[S, D]``; in the place of FiLM's generator."""

    def __init__(self, start: Tensor):
        super().__init__()
        self.vectors = nn.Parameter(start)

    def forward(self, style: int | Tensor | None) -> Tensor:
        """Style vectors: ``[1, D]`` for one style number, ``[M, D]`` for numbers ``[M]``.

        ValueError if a number is unknown, or None is given.
        """
        styles = len(self.vectors)
        if style is None:
            raise ValueError(f"this model has a table of {styles} styles: give the style's number")
        style = torch.atleast_1d(torch.as_tensor(style))
        if bool(((style < 0) | (style >= styles)).any()):
            raise ValueError(f"this model has styles 0 to {styles - 1}, got {style.tolist()}")
        return self.vectors[style]


class OneHot(nn.Module):
    """A one-hot style label beside x: it shifts the first hidden layer.

    Each of K ``experts`` or control points has its own shift; gates blend shifts in the same way as
    weights. The table has a row for each of ``styles``; with 0 the model only takes style vectors.
    """

    def __init__(self, experts: int, hidden: int, styles: int):
        super().__init__()
        self.experts, self.hidden, self.size = experts, hidden, experts * hidden
        start = torch.randn(styles, hidden).repeat(1, experts)
        self.generator = StyleTable(start) if styles else None

    def forward(self, layer: int, f: Tensor, style: Tensor, x: Tensor, gates: Tensor) -> Tensor:
        """ELU(F + Σ αᵢ sᵢ) of hidden layer 0, ELU(F) of hidden layer 1.

        ``style [B or 1, D]`` or ``[D]`` holds s₁ … s_K.
        """
        if layer == 0:
            f = f + (gates[:, :, None] * style.unflatten(-1, (self.experts, self.hidden))).sum(1)
        return F.elu(f)


class ResidualAdapter(nn.Module):
    """A linear layer per style, parallel to the second hidden layer: h₂ = ELU(F + x A + b).

    ``rank=None``: A is a full matrix. Otherwise it is a CP decomposition, A = V diag(Σ αᵢ cᵢ) U.
    The coefficients c have a row for each expert or control point, so they follow the phase. A
    style vector is (A, b) or (V, c, U, b). With the decomposition, a blend of vectors is not
    exactly a blend of the shifts, because A is a product.
    """

    def __init__(self, hidden: int, experts: int, rank: int | None, styles: int):
        super().__init__()
        full = rank is None
        self.shapes = (hidden, hidden), (1, hidden)
        if not full:
            self.shapes = (hidden, rank), (experts, rank), (rank, hidden), (1, hidden)
        self.widths = [rows * columns for rows, columns in self.shapes]
        self.size = sum(self.widths)
        # A = 0: in a decomposition only U, because with more zeros gradients are zero; b is random
        *factors, b = (torch.zeros(styles, width) for width in self.widths)
        if not full:
            v, c, _ = factors
            bound = math.sqrt(6.0 / self.widths[0])
            v.uniform_(-bound, bound)
            c.fill_(1.0)
        start = torch.cat((*factors, b.normal_()), 1)
        self.generator = StyleTable(start) if styles else None

    def forward(self, layer: int, f: Tensor, style: Tensor, x: Tensor, gates: Tensor) -> Tensor:
        """ELU(F) of hidden layer 0, ELU(F + x A + b) of hidden layer 1 and its inputs x."""
        if layer == 1:
            split = torch.atleast_2d(style).split(self.widths, -1)
            pairs = zip(split, self.shapes, strict=True)
            *factors, b = (part.unflatten(-1, shape) for part, shape in pairs)
            if len(factors) == 1:
                shift = _times(x, factors[0])
            else:
                v, c, u = factors
                shift = _times(_times(x, v) * _times(gates, c), u)
            f = f + shift + b[:, 0]
        return F.elu(f)


def _times(x: Tensor, matrices: Tensor) -> Tensor:
    """``x [B, n]`` times ``matrices [B, n, m]``, or ``[1, n, m]`` for one style in the batch."""
    return x @ matrices[0] if matrices.shape[0] == 1 else torch.bmm(x[:, None], matrices)[:, 0]
