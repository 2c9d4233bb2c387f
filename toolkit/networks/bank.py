"""Styles as vectors: a bank of names, and blends of them (Mason et al. 2022, section 4.4)."""

import difflib
import math
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit.networks import weights


@dataclass(frozen=True, eq=False)
class StyleBank:
    """Style vectors by name.

    Parameters
    ----------
    names
        S unique names.
    vectors : Tensor [S, D]
        Their style vectors, in the same order.

    Raises
    ------
    ValueError
        If the numbers differ, a name repeats or a vector is not finite.
    """

    names: tuple[str, ...]
    vectors: Tensor

    def __post_init__(self):
        object.__setattr__(self, "names", tuple(self.names))
        if self.vectors.dim() != 2 or len(self.vectors) != len(self.names):
            raise ValueError(f"{len(self.names)} styles need vectors [{len(self.names)}, D], got {list(self.vectors.shape)}")
        if repeated := sorted({n for n in self.names if self.names.count(n) > 1}):
            raise ValueError(f"style names repeat: {', '.join(repeated)}")
        if bad := [n for n, ok in zip(self.names, self.vectors.isfinite().all(-1).tolist(), strict=True) if not ok]:
            raise ValueError(f"the style vector of {', '.join(bad)} is not finite")

    def __len__(self) -> int:
        return len(self.names)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __getitem__(self, name: str) -> Tensor:
        """The style vector ``[D]`` of a name; an unknown one is a ValueError that lists close names."""
        check_style(name, self.names)
        return self.vectors[self.names.index(name)]

    def blend(self, blend: Mapping[str, float]) -> Tensor:
        """Barycentric blend ``[D]`` of style vectors.

        Parameters
        ----------
        blend
            Style to weight. Weights sum to one; negative ones extrapolate.

        Raises
        ------
        ValueError
            If a style is unknown, a weight is not finite, or they do not sum to one.
        """
        shares = {name: float(weight) for name, weight in blend.items()}
        for name, share in shares.items():
            if not math.isfinite(share):
                raise ValueError(f"the weight of style {name!r} must be finite, got {share}")
        if not shares or abs(sum(shares.values()) - 1) > 1e-4:
            raise ValueError(f"the weights of a blend must sum to 1, got {sum(shares.values()):g}")
        return torch.stack([share * self[name] for name, share in shares.items()]).sum(0)

    def add(self, name: str, vector: Tensor) -> "StyleBank":
        """A new bank with one more style; a name that exists gets the new vector."""
        if vector.shape != self.vectors.shape[1:]:
            raise ValueError(f"style {name!r} needs a vector [{self.vectors.shape[1]}], got {list(vector.shape)}")
        rows = dict(zip(self.names, self.vectors, strict=True)) | {name: vector}
        return StyleBank(tuple(rows), torch.stack([*rows.values()]))

    def save(self, path: str | os.PathLike) -> None:
        """Write to a safetensors file, whole or not at all."""
        weights.write(path, {"bank.vectors": self.vectors}, {"bank": list(self.names)})

    @classmethod
    def load(cls, path: str | os.PathLike) -> "StyleBank":
        """Read a bank, of `save` or of a training run."""
        return cls.from_parts(path, *weights.read(path, "bank"))

    @classmethod
    def from_parts(cls, path: str | os.PathLike, tensors: dict[str, Tensor], parts: dict) -> "StyleBank":
        """The bank among what `toolkit.networks.weights.read` returned for ``path``."""
        try:
            return cls(tuple(parts["bank"]), tensors["bank.vectors"])
        except (KeyError, TypeError, ValueError) as error:
            raise ValueError(f"{path}: the style bank is damaged ({error})") from error


def check_style(name: str, names: Iterable[str]) -> None:
    """Raise a ValueError that lists close names unless ``name`` is one of ``names``."""
    names = list(names)
    if name in names:
        return
    by_lower = {n.lower(): n for n in names}
    close = [by_lower[n] for n in difflib.get_close_matches(str(name).lower(), by_lower, cutoff=0.5)]
    some = ", ".join(names[:8]) + (f" and {len(names) - 8} more" if len(names) > 8 else "")
    raise ValueError(f"unknown style {name!r}; " + (f"close to it: {', '.join(close)}" if close else f"there is {some}"))
