"""Training (Mason et al. 2022, section 4.3): one plain loop over a config.

Frames, style clips and dropout of step n depend only on the seed and n. A run that was stopped and resumed therefore ends
with the same weights as a run without a stop, bit for bit.
"""

import contextlib
import ctypes
import math
import os
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import torch
from torch import Tensor

from toolkit import networks
from toolkit.features import KINDS, Features, check_style, splits
from toolkit.features.splits import seeded
from toolkit.io import model_files
from toolkit.io.progress import progress_bar
from toolkit.motion.tensors import summary
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.networks.film import FilmGenerator
from toolkit.training import distributed
from toolkit.training.checkpoint import Checkpoint, Saver, starting
from toolkit.training.distributed import Alone, Objective
from toolkit.training.loss import baselines, evaluate, make_bank, refit
from toolkit.training.minibatches import DROPOUT, INIT, Minibatches
from toolkit.training.run import Config, Run, load, pretrained

if TYPE_CHECKING:
    from lightning_fabric import Fabric

__all__ = ["Config", "Run", "fit", "load", "pretrained"]

LOG_EVERY = 10  # steps between the training losses that TensorBoard shows
M_TRIM_THRESHOLD, M_MMAP_MAX = -1, -4  # options of glibc's mallopt


@dataclass(eq=False)
class State:
    """State of a run after ``step`` steps, ``elapsed`` seconds and ``processor`` seconds of this process.

    ``losses`` are those of the last step; ``history`` has a row per evaluation. ``best`` are the weights with the least
    held-out error so far; they are kept only if the run may stop early.
    """

    step: int = 0
    elapsed: float = 0.0
    processor: float = 0.0
    losses: dict[str, float] = field(default_factory=dict)
    history: list[dict] = field(default_factory=list)
    best: dict[str, Tensor] = field(default_factory=dict)
    __repr__ = summary

    @property
    def stalled(self) -> int:
        """Evaluations since the best one; 0 if nothing was held out (errors in the history are then None)."""
        errors = [row["held_out"] for row in self.history if row["held_out"] is not None]
        return len(errors) - 1 - errors.index(min(errors)) if errors else 0


def fit(data: Features, config: Config | None = None, checkpoint: str | os.PathLike | None = None, *, resume: bool = True,
        progress: bool = False, on_step: Callable[[int, float], None] | None = None,
        log: str | os.PathLike | None = None) -> Run:
    """Train a model.

    Parameters
    ----------
    data
        Features; a share is held out and never trained on.
    config
        Training settings; by default those of the paper.
    checkpoint, resume
        File for the state of the run, written at intervals and on an interrupt; whether to resume from it if it exists.
    progress
        Show a bar.
    on_step
        Called with the step's number and loss after every step; a KeyboardInterrupt it raises stops the run.
    log
        Folder for TensorBoard: losses and learning rate every `LOG_EVERY` steps, the held-out error at every evaluation.

    Raises
    ------
    ValueError
        If a style is unknown or has no frames, or the checkpoint is of another layout or config.
    KeyboardInterrupt
        If interrupted; the checkpoint is written first.
    """
    config = config or Config()
    fabric, first = distributed.start(config), distributed.first()
    for style in config.styles:
        check_style(style, data.styles)
    train, test = splits.split(data, config.held_out, config.seed, config.styles or tuple(data.styles))
    if config.patience and not any(map(len, test.inputs.values())):
        raise ValueError(f"patience needs held-out frames; held_out={config.held_out} leaves none of these data")
    batches = Minibatches(train, config.batch, config.clips_per_batch, config.seed, config.pose_mixup)
    if batches.fewest < fabric.world_size:
        raise ValueError(f"{fabric.world_size} processes cannot share a minibatch of {batches.fewest} frames")
    with seeded(fabric.device, config.seed, INIT):
        model = networks.build(config.model, data.layout, len(batches.styles), config.sizes,
                               networks.normalisers(config.model, train)).to(fabric.device)
    adam = optimiser(model, config)
    state = restore(checkpoint, model, adam, config) if checkpoint and resume and Path(checkpoint).exists() else State()
    objective = fabric.setup_module(Objective(model, config.bone_weight, fabric.global_rank, fabric.world_size,
                                             config.precision))
    total = None if config.seconds else config.steps or max(1, round((config.epochs or 90) * batches.steps_per_epoch))

    def save() -> None:
        if checkpoint and first:
            numbers = {name: value for name, value in vars(state).items() if name != "best"}
            best = {f"best.{name}": value for name, value in state.best.items()}
            _checkpoint(model, adam, config).save(checkpoint, numbers, best, model=model.parts()[1])

    def assess(draw: Callable[[dict[str, float], int], None]) -> None:
        error = _held_out(model, train, test)
        state.history.append({"step": state.step, "elapsed": state.elapsed, "processor": state.processor, **state.losses,
                              "held_out": error})
        if config.patience and state.stalled == 0:
            state.best = {name: value.clone() for name, value in model.state_dict().items()}
        draw({} if error is None else {"held_out": error}, state.step)

    bar = progress_bar(total=total or config.seconds, initial=state.step if total else state.elapsed, desc="training",
                       unit="step" if total else "s", show=progress and first,
                       bar_format=None if total else "{l_bar}{bar}| {n:.0f}/{total:.0f} s, {remaining} left{postfix}")
    smooth, before = math.nan, time.process_time() - state.processor
    saver = Saver(save, config.save_every, state.elapsed, partial(_mean, fabric))
    with saver, _tensorboard(log if first else None, state.step) as draw, bar, reused_memory():
        model.train()
        while (done := state.step / total if total else state.elapsed / config.seconds) < 1:
            if config.patience and state.stalled >= config.patience:
                break
            rate = config.rate * (config.final_rate + (1 - config.final_rate) * (1 + math.cos(math.pi * done)) / 2)
            with seeded(fabric.device, config.seed, DROPOUT, state.step):
                state.losses = step(fabric, objective, adam, batches, config, state.step, rate)
            state.step += 1
            state.elapsed, state.processor = saver.elapsed, time.process_time() - before
            smooth = state.losses["loss"] if math.isnan(smooth) else 0.98 * smooth + 0.02 * state.losses["loss"]
            bar.set_postfix(loss=f"{smooth:.3f}", refresh=False)
            bar.update((state.step if total else min(state.elapsed, config.seconds)) - bar.n)
            if state.step % LOG_EVERY == 0:
                draw({**state.losses, "rate": rate}, state.step)
            if state.step % config.evaluate_every == 0:
                assess(draw)
            state.elapsed = saver.stepped(on_step, state.step, state.losses["loss"])
        if not state.history or state.history[-1]["step"] != state.step:
            assess(draw)
    if state.best:
        model.load_state_dict(state.best)
    model.eval()
    bank = make_bank(model, train)
    if config.refit and isinstance(model.modulation.generator, FilmGenerator):
        bank = refit(model, bank, train, config.refit, config.seed, config.pose_mixup, progress and first)
    held_out, shifted = evaluate(model, bank, test), StyleBank(bank.names, bank.vectors.roll(1, 0))
    for style, error in (evaluate(model, shifted, test) if len(bank) > 1 else {}).items():
        held_out[style]["other"] = error["mse"]
    return Run(model.cpu(), bank, config, state.history, held_out, baselines(model.cpu(), test))


@contextlib.contextmanager
def reused_memory() -> Iterator[None]:
    """Inside, glibc keeps the memory that the main thread frees; results stay the same.

    Otherwise large tensors return to the system at once, and a third of a step of the paper's size with one style clip goes
    into mapping and clearing the pages of new gradients.
    """
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None) if sys.platform == "linux" else None
    if mallopt is None:
        yield
        return
    mallopt(M_MMAP_MAX, 0)
    mallopt(M_TRIM_THRESHOLD, 2**31 - 1)
    try:
        yield
    finally:
        mallopt(M_MMAP_MAX, 65536)
        mallopt(M_TRIM_THRESHOLD, 128 * 1024)
        ctypes.CDLL(None).malloc_trim(0)


def restore(path: str | os.PathLike, model: Model, adam: torch.optim.Adam, config: Config) -> State:
    """Load a checkpoint into a newly built model and its optimiser; returns the state of the run.

    ValueError if it is not a checkpoint, or belongs to another layout, config or other data.
    """
    Model.from_parts(path, *model_files.read(path, "checkpoint"), model.layout)  # its error names the difference of layouts
    numbers, tensors = _checkpoint(model, adam, config).load(path)
    with model_files.intact(path, "the checkpoint"):
        state = State(**numbers, best=starting(tensors, "best."))
        if not (state.step >= 0 and state.elapsed >= 0 and isinstance(state.stalled, int)):
            raise ValueError(f"its step is {state.step} and its time {state.elapsed} s")
    return state


def _checkpoint(model: Model, adam: torch.optim.Adam, config: Config) -> Checkpoint:
    return Checkpoint("checkpoint", {"model": model}, {"model": adam}, config.fixed())


def optimiser(model: Model, config: Config) -> torch.optim.Adam:
    """Adam over the synthesis network and, as a group with a rate of its own, the style modulation."""
    style, rest = list(model.modulation.parameters()), [*model.gating.parameters(), *model.experts.parameters()]
    return torch.optim.Adam([{"params": rest}, {"params": style}], lr=config.rate, fused=True)


def step(fabric: "Fabric | Alone", objective: torch.nn.Module, adam: torch.optim.Adam, batches: Minibatches, config: Config,
         number: int, rate: float) -> dict[str, float]:
    """Gradient descent on minibatch ``number`` at learning rate ``rate``; its loss, mean squared and bone-length error.

    `distributed.start` gives ``fabric``, which has set up the ``objective``; ValueError if the loss is not finite.
    """
    model = objective.model
    x, p, z, y = (rows.to(fabric.device) for rows in batches[number])
    x, p, z, y = (model.normaliser(kind).apply(rows) for kind, rows in
                  zip(KINDS, (x, *model.observe(p, z), y), strict=True))
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
        raise ValueError(f"training diverged at step {number}: loss {values['loss']}; lower the rate or set max_gradient")
    return values


def _mean(fabric: "Fabric | Alone", *numbers: float) -> list[float]:
    """Means over the processes, so that all of them make the same decisions."""
    if fabric.world_size == 1:
        return list(numbers)
    return fabric.all_reduce(torch.tensor(numbers, dtype=torch.float64, device=fabric.device), reduce_op="mean").tolist()


def _held_out(model: Model, train: Features, test: Features) -> float | None:
    """Test error, the mean over styles; at most 1,000 frames per style, and style vectors from at most 8 clips."""
    errors = evaluate(model, make_bank(model, train, 8), test, 1000)
    return sum(e["mse"] for e in errors.values()) / len(errors) if errors else None


@contextlib.contextmanager
def _tensorboard(folder: str | os.PathLike | None, step: int) -> Iterator[Callable[[dict[str, float], int], None]]:
    """A function that logs numbers of a step to the folder, if any; older entries for steps after ``step`` are dropped."""
    if folder is None:
        yield lambda numbers, step: None
        return
    try:
        from torch.utils.tensorboard import SummaryWriter
    except ImportError:
        raise ValueError('logs need TensorBoard: pip install ".[scale]"') from None
    with SummaryWriter(os.fspath(folder), purge_step=step + 1) as writer:

        def draw(numbers: dict[str, float], step: int) -> None:
            for name, value in numbers.items():
                writer.add_scalar(name, value, step)

        yield draw
