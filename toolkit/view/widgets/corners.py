"""A blend of three styles as a widget: names and shares, which a triangle with a marker shows."""

import math
from collections.abc import Iterable, Mapping, Sequence

import traitlets

from toolkit.view.frontend import PageWidget


class Corners(PageWidget):
    """A widget with three styles, ``names``, and their shares, ``weights``: traits that can be
    observed, linked and set.

    Names must be in the bank, where there is one; shares are scaled to sum to one.
    """

    _bank = None

    names = traitlets.List(traitlets.Unicode(), ["A", "B", "C"], minlen=3, maxlen=3).tag(sync=True)
    weights = traitlets.List(traitlets.Float(), [1 / 3] * 3, minlen=3, maxlen=3).tag(sync=True)

    @traitlets.validate("names")
    def _known(self, proposal: dict) -> list[str]:
        for name in proposal["value"]:
            if self._bank is not None and name not in self._bank:
                raise traitlets.TraitError(f"unknown style {name!r}")
        return proposal["value"]

    @traitlets.validate("weights")
    def _sum_to_one(self, proposal: dict) -> list[float]:
        shares = proposal["value"]
        if not _fit(shares):
            raise traitlets.TraitError(
                f"weights must be three shares >= 0 and not all zero, got {shares}")
        return [w / sum(shares) for w in shares]

    @property
    def blend(self) -> dict[str, float]:
        """Style to share; a style at two corners has both shares."""
        blend: dict[str, float] = {}
        for name, share in zip(self.names, self.weights, strict=True):
            blend[name] = blend.get(name, 0.0) + share
        return blend


def _fit(shares: Sequence[float]) -> bool:
    """Whether shares are finite, not negative, and not all zero."""
    return all(w >= 0 for w in shares) and 0 < sum(shares) < math.inf


def corners(bank, weights: Mapping[str, float],
            others: Iterable[str]) -> tuple[list[str], list[float]]:
    """Three styles and their shares, which sum to one, of a blend of one to three.

    ``others`` fill up, with share zero.
    """
    for name in weights:
        bank[name]  # raises if unknown
    shares = [float(w) for w in weights.values()]
    if len(shares) > 3 or not _fit(shares):
        raise ValueError("a blend needs one to three weights >= 0 and not all zero, got "
                         f"{dict(weights)}")
    names = [*weights, *(name for name in others if name not in weights), *weights, *weights]
    return names[:3], [w / sum(shares) for w in shares] + [0.0] * (3 - len(shares))
