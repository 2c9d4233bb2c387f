"""Classifiers that judge restyled motion, and the features of the Fréchet Motion Distance.

Departure from Park et al. 2021 (section 7), who train a graph network of ten layers: a window is
described by the mean, the deviation and mean speed over time of each number of each joint;
principal components (95 % of the variance) and a logistic regression name the class. Few takes are
enough for it, and it is trained in a second. `NetworkJudge` is of another kind: a small network of
convolutions over time, which sees the order of the frames.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import torch
from sklearn.decomposition import PCA
from sklearn.linear_model import LogisticRegression
from sklearn.pipeline import Pipeline, make_pipeline
from sklearn.preprocessing import StandardScaler
from torch import Tensor, nn

from experiments.stylization.convolutional import flat
from toolkit.evaluation import metrics
from toolkit.features.splits import generator, seeded
from toolkit.stylization.data import FRAMES, Motions, Statistics

STRENGTH = 0.03  # C of the logistic regression: few takes need a strong penalty
WIDTH, DROPPED = 48, 0.3  # channels of a network that judges, and the share that is dropped
STEPS, RATE, DECAY = 300, 2e-3, 0.05  # of its training
PIECE, MOVED = 56, 0.3  # frames of a piece it learns from; by which it is moved, z-scores


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

    def named(self, x: Tensor) -> Tensor:
        """The class of each motion, ``[M]``."""
        return torch.from_numpy(self.pipeline.predict(self.described(x)))

    def features(self, x: Tensor) -> Tensor:
        """Principal components ``[M, K]``."""
        return torch.from_numpy(self.pipeline[:-1].transform(self.described(x)))


@dataclass(frozen=True, eq=False)
class NetworkJudge:
    """A classifier like `Judge`: convolutions over time, then the mean over time.

    It learns from pieces of windows that are moved as a whole, so that it does not learn a few
    poses by heart. Without ``posture``, every number has mean 0 over a window.
    """

    statistics: Statistics
    posture: bool
    network: nn.Module

    @classmethod
    def train(cls, motions: Motions, label: str, posture: bool = True) -> "NetworkJudge":
        """Fit a judge of a ``label`` of motions; all classes have the same weight."""
        truth = getattr(motions, label)
        weight = 1 / truth.bincount().clamp_min(1)[truth]
        with seeded("cpu", 0):
            judge = cls(motions.statistics(), posture, network_judge(motions, int(truth.max()) + 1))
            z, draw = judge.described(motions.x), generator(0)
            adam = torch.optim.AdamW(judge.network.parameters(), RATE, weight_decay=DECAY)
            rates = torch.optim.lr_scheduler.LinearLR(adam, 1, 0, STEPS)
            for _ in range(STEPS):
                rows = torch.multinomial(weight, 32, replacement=True, generator=draw)
                start = int(torch.randint(FRAMES - PIECE + 1, (1,), generator=draw))
                x = z[rows, :, start : start + PIECE]
                if posture:
                    x = x + MOVED * torch.randn(*x.shape[:2], 1, generator=draw)
                loss = nn.functional.cross_entropy(judge.network(x), truth[rows])
                adam.zero_grad()
                loss.backward()
                adam.step()
                rates.step()
        judge.network.eval()
        return judge

    def described(self, x: Tensor) -> Tensor:
        """z-scores ``[M, 7 N, T]``."""
        z = flat(self.statistics.apply(x))
        return z if self.posture else z - z.mean(2, keepdim=True)

    @torch.no_grad()
    def named(self, x: Tensor) -> Tensor:
        """The class of each motion, ``[M]``."""
        return self.network(self.described(x)).argmax(1)


def network_judge(motions: Motions, classes: int) -> nn.Sequential:
    """The layers of a `NetworkJudge`."""
    layers: list[nn.Module] = []
    inputs = motions.x.shape[1] * motions.x.shape[3]
    for _ in range(3):
        layers += [nn.Dropout(DROPPED), nn.Conv1d(inputs, WIDTH, 5, 2), nn.ReLU()]
        inputs = WIDTH
    return nn.Sequential(*layers, nn.AdaptiveAvgPool1d(1), nn.Flatten(), nn.Linear(WIDTH, classes))


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
    def train(cls, motions: Mapping[str, Motions], real: Motions,
              kind: type = Judge) -> "Judges":
        """Judges of one kind from motions by label (`sets.Task.judged`)."""
        return cls(kind.train(motions["content"], "content"),
                   kind.train(motions["style"], "domain"),
                   kind.train(motions["style"], "domain", posture=False), real)

    def right(self, x: Tensor, content: Tensor, domain: Tensor) -> dict[str, Tensor]:
        """Whether each motion is recognised, ``[M]``: its ``content``, its ``style``, ``both``, and
        its style without the mean pose (``movement``).
        """
        kept, styled = self.content.named(x) == content, self.style.named(x) == domain
        return {"content": kept, "style": styled, "both": kept & styled,
                "movement": self.movement.named(x) == domain}

    def judge(self, x: Tensor, content: Tensor, domain: Tensor) -> dict[str, float]:
        """Measures of motions x [M, 7, T, N] that should have a content and a domain, [M] each.

        Shares of `right`. ``fmd`` is the Fréchet distance to as many real motions.
        """
        found, real = self.content.features(x), self.content.features(self.real.x)
        shares = self.right(x, content, domain)
        return {"fmd": _equal_counts(found, real),
                **{name: float(right.float().mean()) for name, right in shares.items()}}


def _equal_counts(a: Tensor, b: Tensor) -> float:
    """Fréchet distance of as many rows of one as of the other, chosen at random."""
    count, draw = min(len(a), len(b)), generator(0)
    a, b = (rows[torch.randperm(len(rows), generator=draw)[:count]] for rows in (a, b))
    return metrics.frechet_distance(a, b)
