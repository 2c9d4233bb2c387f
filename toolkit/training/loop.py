"""Training (Mason et al. 2022, section 4.3): one plain loop over a config.

Frames, style clips and dropout of step n depend only on the seed and n (dropout also on the
process, if there are several). A run that was stopped and resumed therefore ends with the same
weights as a run without a stop, bit for bit.
"""

import math
import os
import time
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import torch
from torch import Tensor

from toolkit import networks
from toolkit.features import Features, Layout, check_style, splits
from toolkit.io import model_files
from toolkit.io.progress import progress_bar
from toolkit.motion.tensors import summary
from toolkit.networks import Predictor
from toolkit.networks.adapters import StyleTable
from toolkit.networks.bank import StyleBank
from toolkit.training import distributed
from toolkit.training.checkpoint import Checkpoint, Saver
from toolkit.training.distributed import Alone, Objective
from toolkit.training.loss import baselines, evaluate, make_bank, observed, refit
from toolkit.training.minibatches import DROPOUT, INIT, Minibatches
from toolkit.training.run import Config, Run


@dataclass(eq=False)
class State:
    """State of a run after ``step`` steps, ``elapsed`` and ``processor`` seconds of this process.

    ``losses`` are those of the last step; ``history`` has a row per evaluation. ``best`` are the
    weights with the least held-out error so far; they are kept only if the run may stop early.
    """

    step: int = 0
    elapsed: float = 0.0
    processor: float = 0.0
    losses: dict[str, float] = field(default_factory=dict)
    history: list[dict] = field(default_factory=list)
    best: dict[str, Tensor] = field(default_factory=dict)
    __repr__ = summary

    @property
    def numbers(self) -> dict:
        """All but the tensors."""
        return {name: value for name, value in vars(self).items() if name != "best"}

    @property
    def stalled(self) -> int:
        """Evaluations since the best one; 0 if nothing was held out (errors are then None)."""
        errors = [row["held_out"] for row in self.history if row["held_out"] is not None]
        return len(errors) - 1 - errors.index(min(errors)) if errors else 0


def fit(data: Features, config: Config | None = None,
        checkpoint: str | os.PathLike | None = None, *, resume: bool = True,
        progress: bool = False) -> Run:
    """Train a model.

    Parameters
    ----------
    data
        Features; a share is held out and never trained on.
    config
        Training settings; by default those of the paper, but for `refit`.
    checkpoint, resume
        File for the state of the run, written at intervals and on an interrupt; whether to resume
        from it if it exists.

    Raises
    ------
    ValueError
        If a style is unknown or has no frames, or as of `Checkpoint.load`.
    KeyboardInterrupt
        If interrupted; the checkpoint is written first.
    """
    config = config or Config()
    fabric = distributed.start(config.device, config.processes)
    first = fabric.global_rank == 0
    for style in config.styles:
        check_style(style, data.styles)
    styles = config.styles or tuple(data.styles)
    train, test = splits.split(data, config.held_out, config.seed, styles)
    if config.patience and not any(map(len, test.inputs.values())):
        raise ValueError(f"patience needs held-out frames; held_out={config.held_out} leaves none "
                         "of these data")

    # model and optimiser, new or from the checkpoint
    with splits.seeded(fabric.device, config.seed, INIT):
        model = networks.build(config.model, data.layout, len(styles), config.sizes)
    model.normalise(networks.normalisers(model.layout, train))
    model.ground = train.ground()
    model = model.to(fabric.device)
    batches = Minibatches(train, config.batch, config.clips_per_batch, config.seed,
                          config.pose_mixup, model.memory)
    if batches.fewest < fabric.world_size:
        raise ValueError(f"{fabric.world_size} processes cannot share a minibatch of "
                         f"{batches.fewest} frames")
    timed, limit = config.seconds is not None, config.seconds  # or steps
    if not timed:
        limit = config.steps or max(1, round((config.epochs or 90) * batches.steps_per_epoch))
    adam, state = optimiser(model, config), State()
    if checkpoint and resume and Path(checkpoint).exists():
        state = restore(checkpoint, model, adam, config)
    objective = Objective(model, fabric.global_rank, fabric.world_size, config.precision)
    objective = fabric.setup_module(objective)

    def save() -> None:
        if checkpoint and first:
            best = {f"best.{name}": value for name, value in state.best.items()}
            _checkpoint(model, adam, config).save(checkpoint, state.numbers, best,
                                                  model=model.parts()[1])

    def assess() -> None:
        # at most 1,000 frames per style, style vectors from at most 8 clips
        errors = evaluate(model, make_bank(model, train, 8), test, 1000)
        error = sum(e["mse"] for e in errors.values()) / len(errors) if errors else None
        row = {"step": state.step, "elapsed": state.elapsed, "processor": state.processor}
        state.history.append({**row, **state.losses, "held_out": error})
        if config.patience and state.stalled == 0:
            state.best = {name: value.clone() for name, value in model.state_dict().items()}

    def spent() -> float:
        return min(state.elapsed, limit) if timed else state.step

    form = "{l_bar}{bar}| {n:.0f}/{total:.0f} s, {remaining} left{postfix}" if timed else None
    bar = progress_bar(total=limit, bar_format=form, desc="training", initial=spent(), unit="step",
                       show=progress and first)
    smooth, before = math.nan, time.process_time() - state.processor
    saver = Saver(save, state.elapsed, partial(_mean, fabric))
    with saver, bar:
        model.train()
        while (done := spent() / limit) < 1:
            if config.patience and state.stalled >= config.patience:
                break
            # cosine decay of the rate; dropout masks that depend only on seed, step and process
            share = (1 + math.cos(math.pi * done)) / 2
            rate = config.rate * (config.final_rate + (1 - config.final_rate) * share)
            rank = fabric.global_rank  # rank 0 draws as a single process does
            stream = (state.step, rank) if rank else (state.step,)
            with splits.seeded(fabric.device, config.seed, DROPOUT, *stream):
                state.losses = step(fabric, objective, adam, batches, config, state.step, rate)
            state.step += 1
            state.elapsed, state.processor = saver.elapsed, time.process_time() - before

            # what is shown, assessed and saved
            loss = state.losses["loss"]
            smooth = loss if math.isnan(smooth) else 0.98 * smooth + 0.02 * loss
            bar.set_postfix(loss=f"{smooth:.3f}", refresh=False)
            bar.update(spent() - bar.n)
            if state.step % config.evaluate_every == 0:
                assess()
            state.elapsed = saver.stepped()
        if not state.history or state.history[-1]["step"] != state.step:
            assess()

    # the result: the best weights, a vector for each style, errors on held-out frames
    if state.best:
        model.load_state_dict(state.best)
    model.eval()
    bank = make_bank(model, train)
    if config.refit and not isinstance(model.generator, StyleTable):
        bank = refit(model, bank, train, config.refit, config.seed, config.pose_mixup,
                     progress and first)
    held_out = evaluate(model, bank, test)
    if len(bank) > 1:
        shifted = StyleBank(bank.names, bank.vectors.roll(1, 0))
        for style, error in evaluate(model, shifted, test).items():
            held_out[style]["other"] = error["mse"]
    return Run(model.cpu(), bank, config, state.history, held_out, baselines(model.cpu(), test))


def restore(path: str | os.PathLike, model: Predictor, adam: torch.optim.Adam,
            config: Config) -> State:
    """Load a checkpoint into a newly built model and its optimiser; returns the state of the run.

    ValueError if it has another layout, or as of `Checkpoint.load`.
    """
    described = model_files.read(path, "checkpoint")[1]
    with model_files.intact(path, "the model's description"):
        stored = Layout.from_json(described["model"]["layout"])
    expected = replace(model.layout, phase=stored.phase)  # another model is another config
    if why := stored.difference(expected):
        raise ValueError(f"{path}: the layout is not the expected one: {why}")
    numbers, tensors = _checkpoint(model, adam, config).load(path)
    with model_files.intact(path, "the checkpoint"):
        state = State(**numbers, best=model_files.starting(tensors, "best."))
        if state.best:
            model_files.check(state.best, model.state_dict())
        state.stalled  # noqa: B018 (all rows have their errors)
    return state


def _checkpoint(model: Predictor, adam: torch.optim.Adam, config: Config) -> Checkpoint:
    kinds = {"step": 0, "elapsed": 0.0, "processor": 0.0, "losses": {"": 0.0},
             "history": [{"": None}]}
    return Checkpoint("checkpoint", {"model": model}, {"model": adam}, config.fixed(), kinds)


def optimiser(model: Predictor, config: Config) -> torch.optim.Adam:
    """Adam over the synthesis network and, as a group with a rate of its own, the style."""
    style = model.style_parameters()
    known = set(map(id, style))
    rest = [parameter for parameter in model.parameters() if id(parameter) not in known]
    groups = [{"params": rest}, {"params": style}]
    return torch.optim.Adam(groups, lr=config.rate, fused=True)


def step(fabric: Alone, objective: torch.nn.Module, adam: torch.optim.Adam,
         batches: Minibatches, config: Config, number: int, rate: float) -> dict[str, float]:
    """Gradient descent on minibatch ``number`` at learning rate ``rate``; its losses.

    The losses are those of `distributed.Objective`, which ``fabric`` (`distributed.start`) has set
    up. ValueError if the loss is not finite.
    """
    model = objective.model
    x, p, z, y = observed(model, *(rows.to(fabric.device) for rows in batches[number]))
    for group, share in zip(adam.param_groups, (1.0, config.style_rate), strict=True):
        group["lr"] = rate * share
    errors = objective(x, p, z, y, number % len(batches.styles))
    adam.zero_grad(set_to_none=True)
    fabric.backward(errors[0])
    if config.max_gradient is not None:
        torch.nn.utils.clip_grad_norm_(model.parameters(), config.max_gradient)
    adam.step()
    values = dict(zip(("loss", "mse", "bone"), _mean(fabric, *errors.tolist()), strict=True))
    if not math.isfinite(values["loss"]):
        raise ValueError(f"training diverged at step {number}: loss {values['loss']}; lower the "
                         "rate or set max_gradient")
    return values


def _mean(fabric: Alone, *numbers: float) -> list[float]:
    """Means over the processes, so that all of them make the same decisions."""
    if fabric.world_size == 1:
        return list(numbers)
    own = torch.tensor(numbers, dtype=torch.float64, device=fabric.device)
    return fabric.all_reduce(own, reduce_op="mean").tolist()
