"""Leads that did not become the recipe, to be trained again: ``python -m experiments stylization leads``.

A training gives up to three results: as it ends, with the moving average of its weights, and averaged with the mirror image.
"""

import copy
import time
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from unittest.mock import patch

import torch
from torch import Tensor

from experiments.stylization import convolutional, evaluation
from experiments.stylization.judges import Judges
from experiments.stylization.mirror import Symmetric
from experiments.stylization.sets import Task
from toolkit.stylization import losses, networks, training
from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.training import NETWORKS, Config

DECAY = 0.98  # of the moving average of weights, per iteration
TURN = 0.1  # metres per rad/s: how large the turn rate is written
TRAINED, AVERAGED, MIRRORED = KINDS = ("as trained", "moving average of the weights", "mean with the mirror image")
_made, _terms = training.translations, training.terms_of


@dataclass(frozen=True)
class Lead:
    """How a training differs from the recipe."""

    settings: dict = field(default_factory=dict)  # of `Config.quick`
    networks: Callable = networks.build
    turning: bool = False  # all networks see the turn rate of the root path
    parted: bool = False  # "id" has the code of the same window, "cyc" that of another one; the target of "sty" is constant
    kinds: tuple[str, ...] = (TRAINED,)


OWN = {"other_window": False, "warm_up": 150}
LEADS = {
    "the recipe": Lead(kinds=KINDS),
    "the turn rate is an input": Lead(turning=True),
    "own window for id, another for cyc": Lead(OWN, parted=True),
    "own window": Lead(OWN | {"encoder_learns": False}),
    "1-D convolutions": Lead(networks=convolutional.build, kinds=KINDS),
    "1-D convolutions, half the rates": Lead({"rates": dict(zip(NETWORKS, (1e-3, 5e-4, 5e-4, 5e-4), strict=True))},
                                             convolutional.build, kinds=KINDS),
}


def measured(lead: Lead, task: Task, config: Config, sources: Motions, judges: Judges, part: str) -> dict[str, dict]:
    """Train a lead by the processor's clock and measure it: by kind of result and by the way its codes are made."""
    averages: list[Tensor] = []

    def average(step: int, stylizer: Stylizer) -> None:
        with torch.no_grad():
            if step == 1:
                averages[:] = [weight.clone() for weight in _weights(stylizer)]
            else:
                torch._foreach_lerp_(averages, _weights(stylizer), 1 - min(DECAY, (1 + step) / (10 + step)))

    with ExitStack() as stack:
        if lead.turning:
            stack.enter_context(patch.object(training, "translations", _turned))
        if lead.parted:
            stack.enter_context(patch.object(training, "translations", _parted))
            stack.enter_context(patch.object(training, "terms_of", _constant))
        train = turning(task.train) if lead.turning else task.train
        run = training.fit(train, config, clock=time.process_time, networks=lead.networks, on_step=average)
    rows, target = evaluation.pairs(sources)
    chosen, references, found = sources.select(rows), task.references[part], {"iterations": run.history[-1]["step"]}
    seen = (turning(sources), turning(references)) if lead.turning else (sources, references)
    for kind in lead.kinds:
        model = copy.deepcopy(run.stylizer)
        if kind == AVERAGED:
            with torch.no_grad():
                torch._foreach_copy_(_weights(model), averages)
        model = Symmetric(model) if kind == MIRRORED else model
        found[kind] = {}
        for by in evaluation.WAYS[:2]:
            made = evaluation.results(model, *seen, by, config.seed)
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


def _turned(stylizer: Stylizer, batch: dict[str, Tensor], config: Config, from_noise: bool) -> dict[str, Tensor]:
    made = _made(stylizer, batch, config, from_noise)
    return made | {"fake": _with_turn(made["fake"], batch["x"][:, 0, :, 0])}


def _parted(stylizer: Stylizer, batch: dict[str, Tensor], config: Config, from_noise: bool) -> dict[str, Tensor]:
    made = _made(stylizer, batch, config, from_noise)
    return made | {"own": stylizer.encoder(batch["kin"], batch["domain"])}


def _constant(stylizer: Stylizer, discriminator: networks.Discriminator, batch: dict[str, Tensor], made: dict[str, Tensor],
              config: Config) -> dict[str, Tensor]:
    """The terms, with a "sty" that does not pull at the target code if E made it."""
    terms = _terms(stylizer, discriminator, batch, made, config)
    if "second" not in made:  # with `Config.fading`: codes from references
        terms["sty"] = losses.style(made["code"].detach(), stylizer.encoder(made["fake"], batch["target"]))
    return terms


def _weights(stylizer: Stylizer) -> list[Tensor]:
    return [weight for name in NETWORKS[:3] for weight in getattr(stylizer, name).parameters()]
