"""Styles as vectors: a bank of names, and blends of them (Mason et al. 2022, section 4.4)."""

import math
import os
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit.features import check_style
from toolkit.io import model_files
from toolkit.motion.tensors import as_tensor, summary
from toolkit.motion.text import checked

WALK = 1.0  # m/s, used if a bank has no known speed


@dataclass(frozen=True, eq=False)
class StyleBank(Mapping[str, Tensor]):
    """Style vectors by name: a mapping, in the order of the names.

    ValueError if the numbers differ, a name repeats or a vector is not finite.
    """

    names: tuple[str, ...]  # S unique names
    vectors: Tensor  # [S, D] style vectors
    speeds: Tensor | None = None  # [S] natural speed of each style, m/s; NaN if unknown
    broken: Tensor | None = None  # [S] whether a walk in the style is mostly defects; menus say so
    __eq__, __hash__ = object.__eq__, object.__hash__

    def __post_init__(self):
        object.__setattr__(self, "names", checked(self.names, "a style"))
        object.__setattr__(self, "vectors", as_tensor(self.vectors, "style vectors"))
        count = len(self.names)
        if self.vectors.dim() != 2 or len(self.vectors) != count:
            raise ValueError(f"{count} styles need vectors [{count}, D], got "
                             f"{list(self.vectors.shape)}")
        speeds = [math.nan] * count if self.speeds is None else self.speeds
        object.__setattr__(self, "speeds", as_tensor(speeds, "speeds"))
        broken = [False] * count if self.broken is None else self.broken
        object.__setattr__(self, "broken", torch.as_tensor(broken, dtype=torch.bool))
        for what, values in (("speeds", self.speeds), ("marks", self.broken)):
            if values.shape != (count,):
                raise ValueError(f"{count} styles need {what} [{count}], got {list(values.shape)}")
        finite = zip(self.names, self.vectors.isfinite().all(-1).tolist(), strict=True)
        if bad := [name for name, known in finite if not known]:
            raise ValueError(f"the style vector of {', '.join(bad)} is not finite")

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return summary(self, {"styles": len(self), "vectors": self.vectors, "names": self.names})

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __getitem__(self, name: str) -> Tensor:
        """The style vector ``[D]`` of a name; the error of an unknown one lists close names."""
        return self.vectors[self._index(name)]

    def _index(self, name: str) -> int:
        check_style(name, self.names)
        return self.names.index(name)

    def blend(self, blend: Mapping[str, float], *deeper: Mapping[str, float]) -> Tensor:
        """Barycentric blend ``[D]`` of style vectors, one for all layers or one for each.

        Weights by style sum to one. Where one is outside of [0, 1], the vector is outside the range
        of the known styles, and a warning says so.

        ``deeper`` are blends of the next hidden layers, if they differ from the first. A FiLM
        vector (γ1, β1, γ2, β2) has two equal parts, one per hidden layer, so it takes one more.

        ValueError if a style is unknown, a weight is not finite, weights do not sum to one, or the
        length of the vectors is not a multiple of the number of blends.
        """
        if deeper:
            size, layers = self.vectors.shape[1], 1 + len(deeper)
            if size % layers:
                raise ValueError(f"vectors [{size}] cannot be cut into {layers} equal layers")
            whole = [self.blend(b) for b in (blend, *deeper)]
            return torch.cat([vector.chunk(layers)[i] for i, vector in enumerate(whole)])
        shares = {name: float(weight) for name, weight in blend.items()}
        for name, share in shares.items():
            if not math.isfinite(share):
                raise ValueError(f"the weight of style {name!r} must be finite, got {share}")
        if abs(sum(shares.values()) - 1) > 1e-4:
            raise ValueError(f"the weights of a blend must sum to 1, got {sum(shares.values()):g}")
        outside = [f"{name} {share:g}" for name, share in shares.items()
                   if not -1e-4 <= share <= 1 + 1e-4]
        if outside:
            warnings.warn(f"the blend extrapolates ({', '.join(outside)}): the model never saw "
                          "such styles", stacklevel=2)
        return torch.stack([share * self[name] for name, share in shares.items()]).sum(0)

    def speed(self, style: str | Mapping[str, float]) -> float:
        """The natural speed of a style or a blend, m/s.

        A style of unknown speed counts with the mean of the bank's known speeds, or with `WALK` if
        none is known.
        """
        known = self.speeds[self.speeds.isfinite()]
        usual = known.mean() if len(known) else torch.tensor(WALK)
        speeds = torch.where(self.speeds.isfinite(), self.speeds, usual)
        blend = {style: 1.0} if isinstance(style, str) else style
        return sum(float(share) * float(speeds[self._index(name)])
                   for name, share in blend.items())

    def merge(self, other: "StyleBank") -> "StyleBank":
        """A new bank with another's styles after its own.

        ValueError if the vectors differ in length, or a style is in both with different vectors.
        """
        if self.vectors.shape[1] != other.vectors.shape[1]:
            raise ValueError(f"vectors [{self.vectors.shape[1]}] cannot be merged with vectors "
                             f"[{other.vectors.shape[1]}]")
        if differ := [n for n in other if n in self and not torch.equal(self[n], other[n])]:
            raise ValueError(f"both banks have {', '.join(differ)}, with different vectors")
        new = other.select(name for name in other if name not in self.names)
        both = zip(self.tensors.values(), new.tensors.values(), strict=True)
        return StyleBank((*self.names, *new.names), *map(torch.cat, both))

    def select(self, names: Iterable[str]) -> "StyleBank":
        """A new bank of some of the styles, in the order given."""
        names = tuple(names)
        chosen = list(map(self._index, names))
        return StyleBank(names, *(values[chosen] for values in self.tensors.values()))

    def labels(self) -> dict[str, str]:
        """What menus call the styles, by name: those that walk badly are marked."""
        return {name: f"{name} (broken)" if bad else name
                for name, bad in zip(self.names, self.broken.tolist(), strict=True)}

    @property
    def tensors(self) -> dict[str, Tensor]:
        """The tensors that a file stores; names are stored separately."""
        return {"bank.vectors": self.vectors, "bank.speeds": self.speeds,
                "bank.broken": self.broken}

    def nearest(self, style: str | Tensor, k: int = 5) -> list[tuple[str, float]]:
        """The ``k`` styles nearest to another style, or to a vector ``[D]``, and their distances.

        The distances are Euclidean; the nearest style is first.
        """
        known = isinstance(style, str)
        vector = self[style] if known else as_tensor(style, "a style", self.vectors)
        apart = (self.vectors - vector).double().norm(dim=-1)
        found = [(self.names[i], float(apart[i])) for i in apart.argsort(stable=True).tolist()]
        return [pair for pair in found if not (known and pair[0] == style)][:k]

    def save(self, path: str | os.PathLike) -> None:
        """Write to a safetensors file, whole or not at all."""
        model_files.write(path, self.tensors, {"bank": list(self.names)})

    @classmethod
    def load(cls, path: str | os.PathLike) -> "StyleBank":
        """Read a bank, also that of a training run."""
        return cls.from_parts(path, *model_files.read(path, "bank"))

    @classmethod
    def from_parts(cls, path: str | os.PathLike, tensors: dict[str, Tensor],
                   parts: dict) -> "StyleBank":
        """The bank among what `toolkit.io.model_files.read` returned for ``path``."""
        with model_files.intact(path, "the style bank"):
            return cls(parts["bank"], tensors["bank.vectors"], tensors.get("bank.speeds"),
                       tensors.get("bank.broken"))
