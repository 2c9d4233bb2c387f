"""A second judge for dataset 2, a graph network (Park et al. 2021, section 7): ``experiments stylization network-judge``.

`experiments.stylization.judges` asks for movement and posture of a style. This network goes by the posture nearly alone: it
calls a source that is only moved to the mean pose of a style by the name of that style. So its shares are higher.
"""

from dataclasses import dataclass
from itertools import product
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import Tensor, nn
from torch.nn import functional

from experiments.seven_models.models import machine
from experiments.stylization import evaluation, sets
from experiments.stylization.floors import FLOORS
from experiments.tables import Result
from toolkit.evaluation import metrics
from toolkit.features.splits import generator, seeded
from toolkit.stylization import training
from toolkit.stylization.data import Motions, Statistics
from toolkit.stylization.layers import SLOPE, encoder, he_init

CHANNELS, EPOCHS, BATCH, RATE = 32, 5, 32, 2e-3
DROPOUT, NOISE, DECAY = 0.5, 0.05, 0.05  # of the features; on the motions, deviations; of the weights
COLUMNS: dict[str, list] = {
    "method": ["method"], "codes": ["style code from"], "fmd": ["FMD", 1], "content": ["content, %", 0, 100],
    "style": ["style, %", 0, 100], "both": ["both, %", 0, 100],
}


class Network(nn.Module):
    """The trunk of E and D, the mean over time and joints (the features), and a linear layer: logits ``[B, classes]``."""

    def __init__(self, motions: Motions, classes: int):
        super().__init__()
        self.statistics: Statistics = motions.statistics()
        self.trunk, self.head = encoder(motions.graph, CHANNELS), nn.Linear(4 * CHANNELS, classes)
        he_init(self)

    def features(self, x: Tensor) -> Tensor:
        """``[B, 4 C]`` of motions ``[B, 7, T, N]``, physical units."""
        return functional.leaky_relu(self.trunk(self.statistics.apply(x).transpose(2, 3)), SLOPE).mean((2, 3))

    def forward(self, x: Tensor) -> Tensor:
        """Logits of motions ``[B, 7, T, N]``, physical units."""
        return self.head(functional.dropout(self.features(x), DROPOUT, self.training))

    @classmethod
    def fit(cls, motions: Motions, label: str, epochs: int = EPOCHS) -> "Network":
        """Train a judge of the ``content`` or the ``domain``; all classes have the same weight."""
        truth, draw = getattr(motions, label), generator(0)
        counts = torch.bincount(truth).clamp_min(1)
        with seeded("cpu", 0):
            model = cls(motions, len(counts)).train()
            adam = torch.optim.AdamW(model.parameters(), RATE, weight_decay=DECAY)
            batches = [rows for _ in range(epochs) for rows in torch.randperm(len(motions), generator=draw).split(BATCH)]
            decay = torch.optim.lr_scheduler.CosineAnnealingLR(adam, len(batches))
            for rows in batches:
                x = motions.x[rows]
                noisy = x + NOISE * model.statistics.std * torch.randn_like(x)
                loss = functional.cross_entropy(model(noisy), truth[rows], 1 / counts)
                adam.zero_grad()
                loss.backward()
                adam.step()
                decay.step()
        return model.eval()


@dataclass(frozen=True, eq=False)
class NetworkJudges:
    """Judges of content and style, and the content judge's features of real motions; what `evaluation.measures` needs."""

    content: Network
    style: Network
    real: Tensor

    @classmethod
    def train(cls, motions: Motions, real: Motions, epochs: int = EPOCHS) -> "NetworkJudges":
        """Judges from some motions; ``real`` ones for the Fréchet distance."""
        content, style = (Network.fit(motions, label, epochs) for label in ("content", "domain"))
        return cls(content, style, _batched(content.features, real.x))

    @torch.no_grad()
    def judge(self, x: Tensor, content: Tensor, domain: Tensor) -> dict[str, float]:
        """Shares with recognised ``content``, ``style`` and ``both``, and ``fmd``, of motions that should have them."""
        features = _batched(self.content.features, x)
        kept = self.content.head(features).argmax(1) == content
        styled = _batched(self.style, x).argmax(1) == domain
        return {"fmd": metrics.frechet_distance(features, self.real),
                **{name: float(right.float().mean()) for name, right in
                   (("content", kept), ("style", styled), ("both", kept & styled))}}


def run(
    models: Annotated[list[Path], typer.Argument(help="Files of runs of our method in the comparison on dataset 2.")],
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 64,
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """Judge floors and models on the test windows of dataset 2 by a graph network."""
    torch.set_num_threads(1)
    task = sets.load("dataset-2")
    judges, runs = NetworkJudges.train(task.judged["test"]["content"], task.train), [training.load(path) for path in models]
    test, chosen = task.sources["test"], sets.some(task.sources["test"], sources)
    rows, target = evaluation.pairs(chosen)
    x, content = chosen.x[rows], chosen.content[rows]
    lines = [{"method": "real motion", **judges.judge(test.x, test.content, test.domain)}]
    lines += [{"method": name, **judges.judge(make(task.train)(chosen.select(rows), target), content, target)}
              for name, make in FLOORS.items()]
    for seconds, by in product(sorted({run.config.seconds for run in runs}), evaluation.WAYS):
        made = [evaluation.results(run.stylizer, chosen, task.references["test"], by, run.config.seed)
                for run in runs if run.config.seconds == seconds]
        found = [judges.judge(torch.cat(two), content.repeat(2), target.repeat(2)) for two in made]
        lines.append({"method": f"ours, {seconds:g} seconds", "codes": by,
                      **{key: [one[key] for one in found] for key in found[0]}})
    about = "Bandai-Namco dataset-2, test windows, a graph network as the judge; mean ± deviation over the seeds"
    result = Result("stylisation-network-judge", about, "python -m experiments stylization network-judge FILE… --store",
                    COLUMNS, lines, {"restyled sources": len(x), "models": len(runs), "epochs": EPOCHS, **machine("cpu")})
    print(f"{result.about}\n\n{result.markdown()}" + (f"wrote {result.save()}" if store else ""))


@torch.no_grad()
def _batched(function, x: Tensor) -> Tensor:
    return torch.cat([function(part) for part in x.split(64)])
