"""The posture of the reference, added to results: how far results then differ and follow it, and what it costs."""

from dataclasses import dataclass

import torch
from torch import Tensor

from experiments.stylization import evaluation
from experiments.stylization.floors import mean_pose_shift
from experiments.stylization.judges import Judges
from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Sizes, Stylizer


@dataclass(frozen=True)
class Postured:
    """A stylizer whose codes of references also hold a share of their posture, as `toolkit.stylization.stylize` adds it."""

    model: Stylizer
    share: float

    @property
    def sizes(self) -> Sizes:
        """Sizes of the networks."""
        return self.model.sizes

    def code_of(self, x: Tensor, domain: Tensor) -> Tensor:
        """`Stylizer.code_of`, and the posture after it."""
        return torch.cat((self.model.code_of(x, domain), self.share * self.model.posture_of(x, domain).flatten(1)), 1)

    def code_from(self, z: Tensor, domain: Tensor) -> Tensor:
        """`Stylizer.code_from`, and no posture."""
        code = self.model.code_from(z, domain)
        return torch.cat((code, code.new_zeros(len(code), self.model.statistics.mean.numel())), 1)

    def translate(self, x: Tensor, code: Tensor) -> Tensor:
        """`Stylizer.translate` with both."""
        posture = code[:, self.sizes.code :].view(len(x), x.shape[1], 1, -1)
        return self.model.translate(x, code[:, : self.sizes.code], posture)


def line(model: Stylizer, sources: Motions, references: Motions, judges: Judges, by: str, share: float,
         seed: int) -> dict[str, float]:
    """Measures of the results of a model with a share of the posture."""
    made = evaluation.results(Postured(model, share), sources, references, by, seed)
    return _measured(sources, references, judges, by, seed, made)


def shifted(train: Motions, sources: Motions, references: Motions, judges: Judges, by: str, share: float,
            seed: int) -> dict[str, float]:
    """The same of the mean-pose shift, which has no network."""
    rows, target = evaluation.pairs(sources)
    statistics = train.statistics()
    moved = statistics.apply(mean_pose_shift(train)(sources.select(rows), target))
    made = []
    for chosen in evaluation.drawn(sources, references, by, seed):
        posture = statistics.apply(references.x[chosen]).mean(2, keepdim=True) - statistics.poses[target]
        made.append(statistics.invert(moved + share * posture))
    return _measured(sources, references, judges, by, seed, made)


def _measured(sources: Motions, references: Motions, judges: Judges, by: str, seed: int,
              made: list[Tensor]) -> dict[str, float]:
    """`evaluation.measures`, and ``follows``: the cosine between the difference of the mean poses of two results and that of
    their references.
    """
    rows, target = evaluation.pairs(sources)
    found = evaluation.measures(sources.select(rows), target, made, judges)
    first, second = evaluation.drawn(sources, references, by, seed)
    moved, asked = ((a - b)[:, :3].mean(2).flatten(1) for a, b in (made, (references.x[first], references.x[second])))
    return found | {"follows": float(torch.cosine_similarity(moved, asked).mean())}
