"""Classifiers that judge restyled motion, and the features of the Fréchet Motion Distance.

Departure from Park et al. 2021 (section 7), who train a graph network of ten layers: a window is
described by the mean, the deviation and mean speed over time of each number of each joint;
principal components (95 % of the variance) and a logistic regression name the class. Few takes are
enough for it, and it is trained in a second.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import torch
from sklearn.decomposition import PCA
from sklearn.linear_model import LogisticRegression
from sklearn.pipeline import Pipeline, make_pipeline
from sklearn.preprocessing import StandardScaler
from torch import Tensor

from toolkit.evaluation import metrics
from toolkit.features.splits import generator
from toolkit.stylization.data import Motions, Statistics

STRENGTH = 0.03  # C of the logistic regression: few takes need a strong penalty


@dataclass(frozen=True, eq=False)
class Judge:
    """A classifier of the ``content`` or the ``domain`` of motions ``x [M, 7, T, N]``.

    With ``posture`` False it does not see the mean pose of a window, and can only go by how the
    motion changes.
    """

    statistics: Statistics
    posture: bool
    pipeline: Pipeline

    @classmethod
    def train(cls, motions: Motions, label: str, posture: bool = True) -> "Judge":
        """Fit a judge of a ``label`` of motions; all classes have the same weight."""
        regression = LogisticRegression(C=STRENGTH, max_iter=1000, class_weight="balanced")
        pipeline = make_pipeline(StandardScaler(), PCA(0.95, random_state=0), regression)
        judge = cls(motions.statistics(), posture, pipeline)
        pipeline.fit(judge.described(motions.x), getattr(motions, label).numpy())
        return judge

    def described(self, x: Tensor) -> np.ndarray:
        """Means, deviations and mean speeds over time, ``[M, D]``."""
        z = self.statistics.apply(x)
        parts = [z.std(2), z.diff(dim=2).abs().mean(2)]
        return torch.cat([z.mean(2), *parts] if self.posture else parts, 1).flatten(1).numpy()

    def right(self, x: Tensor, truth: Tensor) -> Tensor:
        """Whether the class of each motion is recognised, ``[M]``."""
        return torch.from_numpy(self.pipeline.predict(self.described(x))) == truth

    def features(self, x: Tensor) -> Tensor:
        """Principal components ``[M, K]``."""
        return torch.from_numpy(self.pipeline[:-1].transform(self.described(x)))


@dataclass(frozen=True, eq=False)
class Judges:
    """Judges of the content, of the style, and of the style without the mean pose.

    ``real`` are the motions to which distances are taken.
    """

    content: Judge
    style: Judge
    movement: Judge
    real: Motions

    @classmethod
    def train(cls, motions: Mapping[str, Motions], real: Motions) -> "Judges":
        """Judges from motions by label (`sets.Task.judged`)."""
        return cls(Judge.train(motions["content"], "content"),
                   Judge.train(motions["style"], "domain"),
                   Judge.train(motions["style"], "domain", posture=False), real)

    def judge(self, x: Tensor, content: Tensor, domain: Tensor) -> dict[str, float]:
        """Measures of motions x [M, 7, T, N] that should have a content and a domain, [M] each.

        Shares with recognised ``content``, ``style``, ``both``, and style without mean pose
        (``movement``). ``fmd`` is the Fréchet distance to as many real motions, ``domain_fmd`` the
        mean over domains of that to as many of the domain.
        """
        kept, styled = self.content.right(x, content), self.style.right(x, domain)
        found, real = self.content.features(x), self.content.features(self.real.x)
        each = [_equal_counts(found[domain == d], real[self.real.domain == d])
                for d in domain.unique()]
        shares = {"content": kept, "style": styled, "both": kept & styled,
                  "movement": self.movement.right(x, domain)}
        return {"fmd": _equal_counts(found, real), "domain_fmd": sum(each) / len(each),
                **{name: float(right.float().mean()) for name, right in shares.items()}}


def _equal_counts(a: Tensor, b: Tensor) -> float:
    """Fréchet distance of as many rows of one as of the other, chosen at random."""
    count, draw = min(len(a), len(b)), generator(0)
    a, b = (rows[torch.randperm(len(rows), generator=draw)[:count]] for rows in (a, b))
    return metrics.frechet_distance(a, b)
