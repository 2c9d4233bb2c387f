"""Training (Mason et al. 2022, section 4.3): one plain loop over a config, and checkpoints.

What step n does is a pure function of the seed and n: its frames, its style clips and its dropout. A run that was stopped
and resumed therefore ends with the same weights as one that was not, bit for bit.
"""

import contextlib
import dataclasses
import json
import math
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from importlib import resources
from pathlib import Path

import torch
from torch import Tensor
from tqdm.auto import tqdm

from toolkit import networks, sampling
from toolkit.evaluation import baselines, evaluate, loss_terms, make_bank
from toolkit.features import Features
from toolkit.networks import Model, Sizes, weights
from toolkit.networks.bank import StyleBank, check_style
from toolkit.sampling import DROPOUT, INIT, Minibatches


@dataclass(frozen=True)
class Config:
    """How to train; the defaults are the paper's. Give one of ``epochs``, ``steps`` and ``seconds``, or none."""

    model: str = "lpn-film"  # one of toolkit.networks.MODELS
    sizes: Sizes = field(default_factory=Sizes)
    styles: tuple[str, ...] = ()  # which, in the fixed order in which minibatches cycle through them; empty: all
    epochs: float | None = None  # passes of the shortest style; 90 in the paper
    steps: int | None = None  # minibatches
    seconds: float | None = None  # wall time; what it reaches depends on the machine, unlike the other two
    batch: int = 32  # frames of one style per minibatch
    clips_per_batch: int = 32  # style clips per minibatch, shared by its frames; 1 takes a fifth of the time of 32
    rate: float = 1e-4  # Adam's learning rate at the start
    style_rate: float = 1.0  # the style modulation's rate as a share of that; its convolutions die of rates from 1e-3 on
    final_rate: float = 1.0  # learning rate at the end as a share of the first, on a cosine between; 1: constant
    max_gradient: float | None = None  # norm to which gradients are clipped; rates from 1e-3 on spike without
    bone_weight: float = 1.0  # of the bone-length loss
    stray: float = 0.0  # share of frames whose input pose strays to another style's (see Minibatches); the paper: 0
    held_out: float = 0.1  # share of every style's frames kept for the test error
    evaluate_every: int = 1000  # steps between test errors in the history
    save_every: float = 120.0  # seconds between checkpoints
    seed: int = 0
    device: str = "cpu"

    def __post_init__(self):
        budgets = {k: v for k in ("epochs", "steps", "seconds") if (v := getattr(self, k)) is not None}
        if len(budgets) > 1:
            raise ValueError(f"give one of epochs, steps and seconds, got {' and '.join(budgets)}")
        for name, value in budgets.items():
            if not 0 < value < math.inf:
                raise ValueError(f"{name} must be positive and finite, got {value}")
        if self.batch < 1 or not 1 <= self.clips_per_batch <= self.batch:
            raise ValueError(f"clips_per_batch must be from 1 to batch, got {self.clips_per_batch} and {self.batch}")
        if not (0 < self.rate < math.inf and 0 <= self.style_rate < math.inf and 0 <= self.final_rate <= 1):
            raise ValueError(f"rate must be positive, style_rate not negative and final_rate in [0, 1]; got {self.rate}, "
                             f"{self.style_rate} and {self.final_rate}")  # fmt: skip
        if self.seed < 0:
            raise ValueError(f"seed must not be negative, got {self.seed}")
        if not 0 <= self.stray <= 1:
            raise ValueError(f"stray must be in [0, 1], got {self.stray}")
        if not 0 <= self.held_out < 1:
            raise ValueError(f"held_out must be in [0, 1), got {self.held_out}")

    @classmethod
    def quick(cls, **changes) -> "Config":
        """Half a minute on two cores: small sizes, one style clip per minibatch, straying poses, a high rate that decays."""
        settings = {"sizes": Sizes.small(), "batch": 64, "clips_per_batch": 1, "rate": 2e-3, "style_rate": 0.1,
                    "stray": 0.3, "final_rate": 0.01, "max_gradient": 1.0}  # fmt: skip
        if not changes.keys() & {"epochs", "steps", "seconds"}:
            settings["seconds"] = 30.0
        return cls(**(settings | changes))

    def fixed(self) -> dict:
        """What must not change when a run is resumed, as JSON holds it."""
        free = ("save_every", "evaluate_every", "device")
        return json.loads(json.dumps({k: v for k, v in dataclasses.asdict(self).items() if k not in free}))


@dataclass(eq=False)
class Run:
    """What training made.

    ``held_out[style]`` and ``baselines[style]`` are mean squared errors of normalised outputs on held-out frames: ``mse``;
    ``other``, with another style's vector (where it is not much larger, the model does not listen to the vector); and the
    ``mean`` and ``repeat`` of `baselines`. ``bone`` is the error of bone lengths, metres. ``history`` has a row per
    evaluation.
    """

    model: Model
    bank: StyleBank
    config: Config
    history: list[dict[str, float]]
    held_out: dict[str, dict[str, float]]
    baselines: dict[str, dict[str, float]]

    def save(self, path: str | os.PathLike, *, slim: bool = False) -> None:
        """Write model, bank and numbers to one safetensors file; `Model.load` and `StyleBank.load` read it too.

        ``slim`` leaves out the FiLM generator and keeps 16 bits of the experts: a third of the size or less, to run with the
        bank's styles.
        """
        tensors, description = self.model.parts(generator=not slim)
        if slim:
            tensors = {name: t.half() if name.startswith("model.experts") else t for name, t in tensors.items()}
        numbers = {"config": dataclasses.asdict(self.config), "history": self.history, "held_out": self.held_out,
                   "baselines": self.baselines}  # fmt: skip
        weights.write(path, tensors | {"bank.vectors": self.bank.vectors},
                      {"model": description, "bank": list(self.bank.names), "run": numbers})  # fmt: skip

    def table(self) -> list[dict[str, str | float]]:
        """Held-out error beside both baselines: a row per style and one over all styles, each style counting the same."""
        if not self.held_out:
            return []
        rows = [{"style": s, "error": e["mse"], **{k: v for k, v in e.items() if k != "mse"}, **self.baselines[s]}
                for s, e in self.held_out.items()]  # fmt: skip
        overall = {k: sum(row[k] for row in rows) / len(rows) for k in rows[0] if k != "style"}
        return [*rows, {"style": "overall", **overall}]


def load(path: str | os.PathLike) -> Run:
    """Read a run that `Run.save` wrote; a file that is none is a one-line ValueError."""
    tensors, parts = weights.read(path, "run")
    model, bank = Model.from_parts(path, tensors, parts, None), StyleBank.from_parts(path, tensors, parts)
    try:
        return Run(model, bank, _config(parts["run"].pop("config")), **parts["run"])
    except (KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{path}: the record of the run is damaged ({error})") from error


def pretrained() -> tuple[Model, StyleBank]:
    """The embedded default: a small LPN-FiLM trained on procedural styles, and its style vectors. No network access.

    It comes without the FiLM generator, so it cannot make style vectors of new clips. `toolkit/data/README.md` says what it
    was trained on and with which command.
    """
    with resources.as_file(resources.files("toolkit") / "data" / "pretrained.safetensors") as path:
        return Model.load(path), StyleBank.load(path)


def fit(data: Features, config: Config | None = None, checkpoint: str | os.PathLike | None = None, *, resume: bool = True,
        progress: bool = False, on_step: Callable[[int, float], None] | None = None) -> Run:  # fmt: skip
    """Train a model.

    Parameters
    ----------
    data
        Features; a share is held out and never trained on.
    config
        How; the paper's way where not given.
    checkpoint
        File for the state of the run, written now and then and when it is interrupted.
    resume
        Go on from the checkpoint if there is one.
    progress
        Show a bar.
    on_step
        Called with the step's number and loss after every step; a KeyboardInterrupt it raises stops the run.

    Raises
    ------
    ValueError
        If a style is unknown or has no frames, or the checkpoint is of another layout or config.
    KeyboardInterrupt
        When interrupted, after the checkpoint was written.
    """
    config = config or Config()
    torch.device(config.device)
    for style in config.styles:
        check_style(style, data.styles)
    train, test = sampling.split(data, config.held_out, config.seed, config.styles or tuple(data.styles))
    batches = Minibatches(train, config.batch, config.clips_per_batch, config.seed, config.stray)
    with _seeded(config, INIT):
        model = networks.build(config.model, data.layout, len(batches.styles), config.sizes, train.normalisers())
    state = {"step": 0, "elapsed": 0.0, "history": []}
    moments: dict[int, dict[str, Tensor]] = {}
    if checkpoint and resume and Path(checkpoint).exists():
        model, moments, state = _restore(checkpoint, model, config)
    model.to(config.device)
    style, rest = list(model.modulation.parameters()), [*model.gating.parameters(), *model.experts.parameters()]
    adam = torch.optim.Adam([{"params": rest}, {"params": style}], lr=config.rate, fused=True)
    if moments:
        adam.load_state_dict({"state": moments, "param_groups": adam.state_dict()["param_groups"]})
    total = None if config.seconds else config.steps or max(1, round((config.epochs or 90) * batches.steps_per_epoch))
    began, saved = time.perf_counter() - state["elapsed"], time.perf_counter()

    def save() -> None:
        if checkpoint:
            _checkpoint(checkpoint, model, adam, state, config)

    bar = tqdm(total=total or config.seconds, desc="training", unit="step" if total else "s", disable=not progress,
               bar_format=None if total else "{l_bar}{bar}| {n:.0f}/{total:.0f} s{postfix}")  # fmt: skip
    smooth = math.nan
    with _whole_steps() as interrupted, bar:
        model.train()
        while True:
            done = state["step"] / total if total else state["elapsed"] / config.seconds
            if done >= 1:
                break
            state |= _step(model, adam, batches, config, state["step"], done)
            state["step"] += 1
            state["elapsed"] = time.perf_counter() - began
            smooth = state["loss"] if math.isnan(smooth) else 0.98 * smooth + 0.02 * state["loss"]
            bar.set_postfix(loss=f"{smooth:.3f}", refresh=False)
            bar.update((state["step"] if total else min(state["elapsed"], config.seconds)) - bar.n)
            if state["step"] % config.evaluate_every == 0:
                state["history"].append(_row(model, train, test, state))
                state["elapsed"] = time.perf_counter() - began
            try:
                if on_step:
                    on_step(state["step"], state["loss"])
                if interrupted.is_set():
                    raise KeyboardInterrupt
            except KeyboardInterrupt:
                save()
                raise
            if checkpoint and time.perf_counter() - saved > config.save_every:
                save()
                saved = time.perf_counter()
        if not state["history"] or state["history"][-1]["step"] != state["step"]:
            state["history"].append(_row(model, train, test, state))
    save()
    model.eval()
    bank = make_bank(model, train)
    held_out, shifted = evaluate(model, bank, test), StyleBank(bank.names, bank.vectors.roll(1, 0))
    for style, error in (evaluate(model, shifted, test) if len(bank) > 1 else {}).items():
        held_out[style]["other"] = error["mse"]
    return Run(model.cpu(), bank, config, state["history"], held_out, baselines(model.cpu(), test))


def _step(model: Model, adam: torch.optim.Adam, batches: Minibatches, config: Config, step: int,
          done: float) -> dict[str, float]:  # fmt: skip
    """One step of gradient descent; its loss, mean squared error and bone-length error."""
    x, p, z, y = (model.normaliser(kind).apply(rows.to(config.device)) for kind, rows in
                  zip(("inputs", "phases", "outputs", "clips"), batches[step], strict=True))  # fmt: skip
    rate = config.rate * (config.final_rate + (1 - config.final_rate) * (1 + math.cos(math.pi * done)) / 2)
    for group, share in zip(adam.param_groups, (1.0, config.style_rate), strict=True):
        group["lr"] = rate * share
    with _seeded(config, DROPOUT, step):
        styles = model.encode(y)
        styles = styles if len(styles) == 1 else styles[torch.arange(len(x), device=styles.device) % len(styles)]
        mse, bone = loss_terms(model, model(x, p, styles), z)
    loss = mse + config.bone_weight * bone
    adam.zero_grad(set_to_none=True)
    loss.backward()
    if config.max_gradient is not None:
        torch.nn.utils.clip_grad_norm_(model.parameters(), config.max_gradient)
    adam.step()
    values = dict(zip(("loss", "mse", "bone"), torch.stack((loss, mse, bone)).tolist(), strict=True))
    if not math.isfinite(values["loss"]):
        raise ValueError(f"training diverged at step {step}: loss {values['loss']}; lower the rate or set max_gradient")
    return values


def _row(model: Model, train: Features, test: Features, state: dict) -> dict:
    """A row of the history; the test error on at most 1,000 frames of every style, its vector of at most 8 clips."""
    model.eval()
    errors = evaluate(model, make_bank(model, train, 8), test, 1000)
    model.train()
    held_out = sum(e["mse"] for e in errors.values()) / len(errors) if errors else None
    now = {key: state[key] for key in ("step", "elapsed", "loss", "mse", "bone")}
    return {**now, "held_out": held_out}


@contextlib.contextmanager
def _seeded(config: Config, *numbers: int) -> Iterator[None]:
    """Inside, torch's global generators start from a seed of these numbers; outside, they go on as if nothing was."""
    device = torch.device(config.device)
    with torch.random.fork_rng(devices=[] if device.type == "cpu" else [device.index or 0]):
        torch.manual_seed(sampling.mix(config.seed, *numbers))
        yield


@contextlib.contextmanager
def _whole_steps() -> Iterator[threading.Event]:
    """Inside, the first Ctrl-C sets the event and lets the step end; the second interrupts at once."""
    event = threading.Event()
    if threading.current_thread() is not threading.main_thread():
        yield event
        return
    before = signal.getsignal(signal.SIGINT)

    def handle(*_) -> None:
        event.set()
        signal.signal(signal.SIGINT, before)

    signal.signal(signal.SIGINT, handle)
    try:
        yield event
    finally:
        signal.signal(signal.SIGINT, before)


def _config(stored: dict) -> Config:
    return Config(**{**stored, "sizes": Sizes(**stored["sizes"]), "styles": tuple(stored["styles"])})


def _checkpoint(path: str | os.PathLike, model: Model, adam: torch.optim.Adam, state: dict, config: Config) -> None:
    """Write everything the rest of the run depends on."""
    tensors, description = model.parts()
    for i, moments in adam.state_dict()["state"].items():
        tensors |= {f"adam.{i}.{name}": value for name, value in moments.items()}
    weights.write(path, tensors, {"model": description, "checkpoint": {**state, "config": config.fixed()}})


def _restore(path: str | os.PathLike, new: Model, config: Config) -> tuple[Model, dict[int, dict[str, Tensor]], dict]:
    """Model, Adam's moments and state of the run in a checkpoint; it must have ``new``'s layout and data, and ``config``."""
    tensors, parts = weights.read(path, "checkpoint")
    model, state = Model.from_parts(path, tensors, parts, new.layout), parts["checkpoint"]
    if why := weights.difference(config.fixed(), state.pop("config", {})):
        raise ValueError(f"{path}: the run to resume differs in {why}")
    if not all(torch.allclose(a, b) for a, b in zip(model.buffers(), new.buffers(), strict=True)):
        raise ValueError(f"{path}: the run to resume had other data (their means and deviations differ)")
    moments: dict[int, dict[str, Tensor]] = {}
    for name, value in tensors.items():
        if name.startswith("adam."):
            _, i, kind = name.split(".")
            moments.setdefault(int(i), {})[kind] = value
    return model, moments, state
