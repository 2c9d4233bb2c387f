"""Rows that are computed on demand, and means and standard deviations over many of them."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit.motion.tensors import summary

CHUNK = 1 << 18  # numbers in memory at a time in sums over all rows
CONSTANT = 1e-5  # standard deviation below which a column is only centred

Moments = tuple[int, Tensor, Tensor]  # number, mean [D] and variance [D]


@dataclass(frozen=True, eq=False)
class Rows:
    """Rows that are computed on demand: indexing gives a tensor, as on the first axis of one."""

    derive: Callable[[Tensor], Tensor]  # computes rows from frame numbers
    at: Tensor  # [N] frame numbers of all rows
    __repr__ = summary

    def __len__(self) -> int:
        return len(self.at)

    def __getitem__(self, key: int | slice | Tensor) -> Tensor:
        at = self.at[key]
        return self.derive(at) if at.dim() else self.derive(at[None])[0]

    def select(self, mask: Tensor) -> "Rows":
        """The rows where a mask ``[N]`` is true, also computed on demand."""
        return Rows(self.derive, self.at[mask])


@dataclass(frozen=True)
class Normaliser:
    """Column-wise z-score; statistics are computed in float64."""

    mean: Tensor  # [D]
    std: Tensor  # [D], 1 for a constant column
    __repr__ = summary

    @classmethod
    def of(cls, *rows: Tensor | Rows) -> "Normaliser":
        """Statistics over all rows of tensors ``[..., D]``."""
        return cls.merged((moments(r) for r in rows), rows[0][:1].dtype)

    @classmethod
    def merged(cls, parts: Iterable[Moments], dtype: torch.dtype = torch.float32) -> "Normaliser":
        """Statistics of the union of sets of rows, given the `moments` of each."""
        _, mean, variance = _merge(parts)
        std = torch.where(variance.sqrt() < CONSTANT, 1.0, variance.sqrt())
        return cls(mean.to(dtype), std.to(dtype))

    def apply(self, x: Tensor) -> Tensor:
        """Physical units → normalised, on the device of the statistics and in their dtype."""
        return (x.to(self.mean) - self.mean) / self.std

    def invert(self, x: Tensor) -> Tensor:
        """Normalised → physical units."""
        return x * self.std + self.mean


def moments(rows: Tensor | Rows) -> Moments:
    """Number, mean ``[D]`` and variance ``[D]`` of rows ``[..., D]``, float64."""
    step = max(1, CHUNK // max(1, rows[:1].numel()))
    parts = []
    for first in range(0, max(1, len(rows)), step):
        part = rows[first : first + step].flatten(0, -2).double()
        n = max(1, len(part))
        mean = part.sum(0) / n
        parts.append((len(part), mean, (part - mean).square().sum(0) / n))
    return _merge(parts)


def _merge(parts: Iterable[Moments]) -> Moments:
    """The moments of a union, from those of its parts (Chan, Golub and LeVeque 1983)."""
    parts = iter(parts)
    n, mean, variance = next(parts)
    for more, mean_there, variance_there in parts:
        n += more
        share, apart = more / max(1, n), mean_there - mean
        mean = mean + share * apart
        spread = share * (1 - share) * apart.square()
        variance = variance + share * (variance_there - variance) + spread
    return n, mean, variance
