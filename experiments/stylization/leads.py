"""Leads that did not become the recipe, to be trained again: ``python -m experiments stylization leads``.

A training gives several kinds of results: as it ends, with the moving average of its weights, averaged with the mirror
image, and with half of the reference's posture.
"""

import copy
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from unittest.mock import patch

import torch
from torch import Tensor

from experiments.stylization import convolutional, evaluation
from experiments.stylization.judges import Judges
from experiments.stylization.mirror import Symmetric
from experiments.stylization.posture import Postured
from experiments.stylization.sets import Task
from toolkit.stylization import networks, training
from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Discriminator, Stylizer
from toolkit.stylization.training import NETWORKS, Config

HALF = 0.5  # of the reference's posture
DECAY = 0.98  # of the moving average of weights, per iteration
TURN = 0.1  # metres per rad/s: how large the turn rate is written
TRAINED, AVERAGED, MIRRORED = ("as trained", "moving average of the weights", "mean with the mirror image")
POSTURED, BOTH = (f"{kind}, half of the reference's posture" for kind in (TRAINED, MIRRORED))
KINDS = (TRAINED, AVERAGED, MIRRORED, POSTURED, BOTH)
ALL = (TRAINED, MIRRORED, POSTURED, BOTH)
_made, _terms = training.translations, training.terms_of


@dataclass(frozen=True)
class Lead:
    """How a training differs from the recipe."""

    settings: dict = field(default_factory=dict)  # of `Config.quick`
    networks: Callable = networks.build
    turning: bool = False  # all networks see the turn rate of the root path
    parted: bool = False  # "id" has the code of the same window, "cyc" that of another one; the target of "sty" is constant
    kept: float = 0.0  # weight of the difference between the content features of a source and of its result
    spread: bool = False  # "ds" for codes from references, too
    kinds: tuple[str, ...] = (TRAINED,)

    def translations(self, stylizer: Stylizer, batch: dict[str, Tensor], config: Config,
                     from_noise: bool) -> dict[str, Tensor]:
        """`training.translations` of this lead."""
        made = _made(stylizer, batch, config, from_noise)
        if self.parted:
            made["own"] = stylizer.encoder(batch["kin"], batch["domain"])
        if self.turning:
            made["fake"] = _with_turn(made["fake"], batch["x"][:, 0, :, 0])
        if from_noise:
            return made
        if self.spread:
            with torch.no_grad():
                made["second"] = stylizer.generator(batch["x"], stylizer.encoder(batch["references"][1], batch["target"]))
        return made | {"constant": made["code"].detach()} if self.parted else made

    def terms_of(self, stylizer: Stylizer, discriminator: Discriminator, batch: dict[str, Tensor],
                 made: dict[str, Tensor], config: Config) -> dict[str, Tensor]:
        """`training.terms_of` of this lead."""
        terms = _terms(stylizer, discriminator, batch, made | {"code": made.get("constant", made["code"])}, config)
        if self.kept:
            with torch.no_grad():
                content = stylizer.generator.encode(batch["x"])[0]
            terms["cyc"] = terms["cyc"] + self.kept * (stylizer.generator.encode(made["fake"])[0] - content).abs().mean()
        return terms


OWN = {"other_window": False, "warm_up": 150}
WEIGHTS = Config.quick().weights
LEADS = {
    "the recipe": Lead(kinds=KINDS[:3]),
    "the turn rate is an input": Lead(turning=True),
    "own window for id, another for cyc": Lead(OWN, parted=True),
    "turn rate, own window for id, twice cyc and id": Lead(
        OWN | {"weights": WEIGHTS | {"cyc": 2.0, "id": 2.0}}, turning=True, parted=True, kinds=ALL),
    "no autoencoder first": Lead({"warm_up": 0}),
    "no autoencoder first, ds as in the paper": Lead({"warm_up": 0, "fading": False}),
    "content features kept": Lead(kept=1.0),
    "turn rate, own window for id": Lead(OWN, turning=True, parted=True, kinds=ALL),
    "turn rate, own window for id, content features kept": Lead(OWN, turning=True, parted=True, kept=1.0),
    "own window for id, ds of references": Lead(OWN, parted=True, spread=True),
    "1-D convolutions": Lead(networks=convolutional.build, kinds=KINDS[:3]),
    "1-D convolutions, half the rates": Lead({"rates": dict(zip(NETWORKS, (1e-3, 5e-4, 5e-4, 5e-4), strict=True))},
                                             convolutional.build, kinds=KINDS[:3]),
    "1-D convolutions, four times R1": Lead({"weights": WEIGHTS | {"r1": 20.0}}, convolutional.build),
}


def fit(lead: Lead, task: Task, config: Config, path: Path) -> tuple[dict[str, float], dict[str, Stylizer]]:
    """Train a lead by the processor's clock; numbers of the training, and the stylizer of each kind of result.

    ``gap`` is by how much D's mean logit of the motions that it was trained with is above that of the validation's.

    The run is written to ``path``, and read from it if it is there. Only the toolkit's own networks without their moving
    average can be.
    """
    averages: list[Tensor] = []

    def average(step: int, stylizer: Stylizer) -> None:
        with torch.no_grad():
            if step == 1:
                averages[:] = [weight.clone() for weight in _weights(stylizer)]
            else:
                torch._foreach_lerp_(averages, _weights(stylizer), 1 - min(DECAY, (1 + step) / (10 + step)))

    stored = lead.networks is networks.build and AVERAGED not in lead.kinds
    if stored and path.exists():
        run = training.load(path)
    else:
        with patch.object(training, "translations", lead.translations), patch.object(training, "terms_of", lead.terms_of):
            train = turning(task.train) if lead.turning else task.train
            run = training.fit(train, config, clock=time.process_time, networks=lead.networks, on_step=average)
        if stored:
            path.parent.mkdir(parents=True, exist_ok=True)
            run.save(path)
    made = {TRAINED: run.stylizer, MIRRORED: Symmetric(run.stylizer), POSTURED: Postured(run.stylizer, HALF),
            BOTH: Postured(Symmetric(run.stylizer), HALF)}
    if AVERAGED in lead.kinds:
        made[AVERAGED] = copy.deepcopy(run.stylizer)
        with torch.no_grad():
            torch._foreach_copy_(_weights(made[AVERAGED]), averages)
    windows = (task.train, task.references["validation"])
    known, new = (_logit(run, turning(part) if lead.turning else part) for part in windows)
    return {"iterations": run.history[-1]["step"], "gap": known - new}, {kind: made[kind] for kind in lead.kinds}


def measured(lead: Lead, models: dict[str, Stylizer], sources: Motions, references: Motions, judges: Judges,
             seed: int) -> dict[str, dict]:
    """Measures of the results of a lead: by kind of result and by the way its codes are made."""
    rows, target = evaluation.pairs(sources)
    chosen, found = sources.select(rows), {}
    seen = (turning(sources), turning(references)) if lead.turning else (sources, references)
    for kind, model in models.items():
        found[kind] = {}
        for by in evaluation.WAYS[:2]:
            made = evaluation.results(model, *seen, by, seed)
            if lead.turning:
                made = [_with_turn(x, torch.zeros(())) for x in made]
            found[kind][by] = evaluation.measures(chosen, target, made, judges)
    return found


def turning(motions: Motions) -> Motions:
    """Motions with the turn rate in the place of the root's sideways position, which is 0 in the root frame."""
    return replace(motions, x=_with_turn(motions.x, TURN * motions.root_velocity[..., 2]))


def _with_turn(x: Tensor, turn: Tensor) -> Tensor:
    x = x.clone()
    x[:, 0, :, 0] = turn
    return x


@torch.no_grad()
def _logit(run: training.Run, motions: Motions) -> float:
    """Mean logit of D for motions and their own domains."""
    parts = zip(run.stylizer.statistics.apply(motions.x).split(evaluation.BATCH), motions.domain.split(evaluation.BATCH),
                strict=True)
    return float(torch.cat([run.discriminator(*part) for part in parts]).mean())


def _weights(stylizer: Stylizer) -> list[Tensor]:
    return [weight for name in NETWORKS[:3] for weight in getattr(stylizer, name).parameters()]
