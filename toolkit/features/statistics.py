"""Rows that are computed on demand, and means and standard deviations over many of them."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit.motion.tensors import summary

CHUNK = 1 << 18  # numbers in memory at a time in sums over all rows
CONSTANT = 1e-5  # standard deviation below which a column is only centred


@dataclass(frozen=True, eq=False)
class Rows:
    """Rows that are computed on demand: indexing gives a tensor, as on the first axis of one."""

    derive: Callable[[Tensor], Tensor]  # computes rows from their places
    at: Tensor  # [N] frame of each row, or [N, 2] first frame and number of frames
    __repr__ = summary

    def __len__(self) -> int:
        return len(self.at)

    def __getitem__(self, key: int | slice | Tensor) -> Tensor:
        at = self.at[key]
        one = at.dim() < self.at.dim()
        return self.derive(at[None])[0] if one else self.derive(at)

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
    def merged(cls, parts: Iterable[Tensor], dtype: torch.dtype = torch.float32) -> "Normaliser":
        """Statistics of the union of sets of rows, given the `moments` of each."""
        n, total, squares = torch.stack(list(parts)).sum(0)
        mean = total / n.clamp_min(1)
        std = (squares / n.clamp_min(1) - mean.square()).clamp_min(0).sqrt()
        return cls(mean.to(dtype), torch.where(std < CONSTANT, 1.0, std).to(dtype))

    def apply(self, x: Tensor) -> Tensor:
        """Physical units → normalised, on the device of the statistics and in their dtype."""
        return (x.to(self.mean) - self.mean) / self.std

    def invert(self, x: Tensor) -> Tensor:
        """Normalised → physical units."""
        return x * self.std + self.mean


def moments(rows: Tensor | Rows) -> Tensor:
    """Number, sum and sum of squares ``[3, D]`` of rows ``[..., D]``, float64.

    Those of a union are the sum over its parts.
    """
    width = rows[:1].shape[-1]
    found = torch.zeros(3, width, dtype=torch.float64, device="cpu")
    step = max(1, CHUNK // max(1, rows[:1].numel()))
    for first in range(0, len(rows), step):
        part = rows[first : first + step].reshape(-1, width).double()
        found += torch.stack((part.new_full((width,), len(part)), part.sum(0),
                              part.square().sum(0))).cpu()
    return found
