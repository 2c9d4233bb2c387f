"""A classifier of motions, for the evaluation of stylisation (Park et al. 2021, section 7).

Trained on contents (walk, run, …) it gives the features of the Fréchet Motion Distance and the recognition accuracy. Trained
on domains it recognises styles.
"""

import os

import torch
from torch import Tensor, nn
from torch.nn import functional
from tqdm.auto import trange

from toolkit.features.splits import generator, mix
from toolkit.io import model_files
from toolkit.stylization.data import CHANNELS, Motions, Statistics
from toolkit.stylization.graph import SkeletonGraph
from toolkit.stylization.layers import he_init, trunk

DROPOUT = 0.5  # of the features, in training
NOISE = 0.05  # standard deviations of noise on the motions, in training
DECAY = 0.05  # of the weights


class Classifier(nn.Module):
    """Spatial-temporal graph convolutions, their mean over time and joints (the features), and a linear layer.

    Departure from the paper, which uses the ten layers of Yan et al. 2018: the trunk is that of style encoder and
    discriminator (Table 3b, d), which is enough for a few hundred takes.

    Parameters
    ----------
    graph
        The skeleton.
    classes
        C names.
    statistics
        Mean and deviation, to convert the physical units of the input to z-scores.
    channels
        Channels of the first layer; the features are four times as many, 256.
    """

    def __init__(self, graph: SkeletonGraph, classes: tuple[str, ...], statistics: Statistics, channels: int = 64):
        super().__init__()
        self.classes, self.statistics, self.channels = tuple(classes), statistics, channels
        self.trunk = trunk(graph, channels)
        self.head = nn.Linear(4 * channels, len(classes))
        he_init(self)

    def features(self, x: Tensor) -> Tensor:
        """Features [B, 256] of motions [B, 7, T, N], physical units."""
        return self.trunk(self.statistics.apply(x).transpose(2, 3)).mean((2, 3))

    def forward(self, x: Tensor) -> Tensor:
        """Logits [B, C] of motions [B, 7, T, N], physical units."""
        return self.head(functional.dropout(self.features(x), DROPOUT, self.training))

    def save(self, path: str | os.PathLike) -> None:
        """Write weights, statistics and class names to one safetensors file."""
        model_files.write(path, self.state_dict(), {"classifier": {"classes": self.classes, "channels": self.channels}})

    @classmethod
    def load(cls, path: str | os.PathLike, graph: SkeletonGraph) -> "Classifier":
        """Read a classifier for motions of a skeleton; ValueError for any other file."""
        tensors, parts = model_files.read(path, "classifier")
        with model_files.intact(path, "the classifier is of another skeleton, or"):
            empty = torch.zeros(CHANNELS, 1, graph.sizes[0])
            model = cls(graph, statistics=Statistics(empty, empty), **parts["classifier"])
            model.load_state_dict(tensors)
        return model.eval()


def fit(motions: Motions, label: str, *, epochs: int = 5, batch: int = 32, rate: float = 2e-3, channels: int = 64,
        seed: int = 0, progress: bool = False) -> Classifier:
    """Train a classifier of a label, ``"content"`` or ``"domain"``; all classes have the same total weight.

    Raises
    ------
    ValueError
        If there is no such label.
    """
    if label not in ("content", "domain"):
        raise ValueError(f"a classifier learns content or domain, not {label!r}")
    classes, truth, x = getattr(motions, f"{label}s"), getattr(motions, label), motions.x
    counts = torch.bincount(truth, minlength=len(classes)).clamp_min(1)
    draw, batch = generator(seed, 1), min(batch, len(x))
    each = len(x) // batch
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(mix(seed, 0))
        model = Classifier(motions.graph, classes, motions.statistics(), channels).train()
        adam = torch.optim.AdamW(model.parameters(), lr=rate, weight_decay=DECAY)
        decay = torch.optim.lr_scheduler.CosineAnnealingLR(adam, epochs * each)
        noise = NOISE * model.statistics.std
        for step in trange(epochs * each, desc=f"{label} classifier", disable=not progress):
            if step % each == 0:
                order = torch.randperm(len(x), generator=draw).split(batch)
            rows = order[step % each]
            seen = x[rows] + noise * torch.randn_like(x[rows])
            loss = functional.cross_entropy(model(seen), truth[rows], 1 / counts)
            adam.zero_grad(set_to_none=True)
            loss.backward()
            adam.step()
            decay.step()
    return model.eval()


@torch.no_grad()
def features(model: Classifier, x: Tensor, batch: int = 64) -> Tensor:
    """Features [M, 256] of any number of motions [M, 7, T, N]."""
    return torch.cat([model.features(part) for part in x.split(batch)])


@torch.no_grad()
def recognise(model: Classifier, x: Tensor, batch: int = 64) -> Tensor:
    """Most probable classes [M] of motions [M, 7, T, N]."""
    return torch.cat([model(part).argmax(1) for part in x.split(batch)])
