"""A training run: its config, and its result as one file."""

import dataclasses
import json
import math
import os
from collections.abc import Iterator
from dataclasses import dataclass, field
from importlib import resources

import torch

from toolkit.io import model_files
from toolkit.motion.tensors import summary
from toolkit.networks import MODELS, Model, Sizes
from toolkit.networks.bank import StyleBank
from toolkit.training.loss import STEPS

PRECISIONS = ("32", "bf16")
#: Learning rate of the style modulation / other rates in `Config.quick`. High rates destroy FiLM's convolutions. Tables of
#: styles need high rates, one-hot the highest, because a row is trained only by the minibatches of its own style.
STYLE_RATES = {"film": 0.1, "onehot": 10.0, "resad": 1.0}


@dataclass(frozen=True)
class Config:
    """How to train: as in the paper, but for ``refit``. Give one of ``epochs``, ``steps`` and ``seconds``, or none."""

    model: str = "lpn-film"  # one of toolkit.networks.MODELS
    sizes: Sizes = field(default_factory=Sizes)
    styles: tuple[str, ...] = ()  # which, in the fixed order in which minibatches cycle through them; empty: all
    epochs: float | None = None  # passes of the shortest style; 90 in the paper
    steps: int | None = None  # minibatches
    seconds: float | None = None  # wall time; unlike with epochs and steps, the result depends on the machine
    patience: int | None = None  # stop after so many evaluations without a better held-out error, and keep the best weights
    batch: int = 32  # frames of one style per minibatch
    clips_per_batch: int = 32  # style clips per minibatch, shared by its frames; 1 takes a third of the time of 32
    rate: float = 1e-4  # Adam's learning rate at the start
    style_rate: float = 1.0  # rate of the style modulation / rate; its convolutions fail at rates from 1e-3 on
    final_rate: float = 1.0  # last learning rate / first, with cosine decay between them; 1: constant
    max_gradient: float | None = None  # norm to which gradients are clipped; without it, losses spike at rates from 1e-3 on
    bone_weight: float = 1.0  # of the bone-length loss
    pose_mixup: float = 0.0  # share of frames whose input pose is mixed with another frame's (see Minibatches); the paper: 0
    refit: int = STEPS  # steps per style that fit FiLM's vectors to frames after the training; 0: means of clips (the paper)
    held_out: float = 0.1  # share of every style's frames kept for the test error
    evaluate_every: int = 1000  # steps between test errors in the history
    save_every: float = 120.0  # seconds between checkpoints
    seed: int = 0
    precision: str = "32"  # "32": float32; "bf16": products in bfloat16 by autocast, weights and Adam in float32
    device: str = "cpu"
    processes: int = 1  # on this machine, each with its own device; torchrun overrides it
    __repr__ = summary

    def __post_init__(self):
        if self.model not in MODELS:
            raise ValueError(f"unknown model {self.model!r}; known: {', '.join(MODELS)}")
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
                             f"{self.style_rate} and {self.final_rate}")
        for name, right, wanted in (
            ("refit", self.refit >= 0, "not be negative"), ("seed", self.seed >= 0, "not be negative"),
            ("pose_mixup", 0 <= self.pose_mixup <= 1, "be in [0, 1]"), ("held_out", 0 <= self.held_out < 1, "be in [0, 1)"),
            ("evaluate_every", self.evaluate_every >= 1, "be a whole number from 1"),
            ("precision", self.precision in PRECISIONS, f"be one of {', '.join(PRECISIONS)}"),
            ("processes", 1 <= self.processes <= self.batch, f"be from 1 to the {self.batch} frames of a minibatch"),
        ):  # fmt: skip
            if not right:
                raise ValueError(f"{name} must {wanted}, got {getattr(self, name)!r}")
        if self.patience is not None and (self.patience < 1 or not self.held_out):
            raise ValueError(f"patience must be a whole number from 1, and needs held-out frames; got {self.patience} and "
                             f"held_out {self.held_out}")
        try:
            torch.device(self.device)
        except RuntimeError:
            raise ValueError(f"device must be cpu, cuda, cuda:1 or another that torch knows, got {self.device!r}") from None

    @classmethod
    def quick(cls, **changes) -> "Config":
        """Half a minute on two cores: small sizes, one style clip per minibatch, pose mix-up, a high rate that decays."""
        settings = {"sizes": Sizes.small(), "batch": 64, "clips_per_batch": 1, "rate": 2e-3, "pose_mixup": 0.3,
                    "final_rate": 0.01, "max_gradient": 1.0,
                    "style_rate": STYLE_RATES.get(str(changes.get("model", cls.model)).rpartition("-")[2], 1.0)}
        if not changes.keys() & {"epochs", "steps", "seconds"}:
            settings["seconds"] = 30.0
        return cls(**(settings | changes))

    @classmethod
    def from_json(cls, stored: dict) -> "Config":
        """A config as JSON holds it."""
        stored = {"pose_mixup" if name == "stray" else name: value for name, value in stored.items()}  # files before 0.2
        return cls(**{"refit": 0, **stored, "sizes": Sizes(**stored["sizes"]), "styles": tuple(stored["styles"])})

    def fixed(self) -> dict:
        """The settings that must not change when a run is resumed, as JSON values."""
        free = {"save_every", "device", "processes", "refit"} | ({"evaluate_every"} if self.patience is None else set())
        return json.loads(json.dumps({k: v for k, v in dataclasses.asdict(self).items() if k not in free}))


@dataclass(eq=False)
class Run:
    """A model and its style bank, from training or from a file; it unpacks as ``model, bank = run``.

    ``config`` is None if the toolkit did not train the model; then there are no errors either. ``held_out[style]`` and
    ``baselines[style]`` are mean squared errors of normalised outputs on held-out frames: ``mse``; ``other``, with another
    style's vector (if it is not much larger than ``mse``, the model ignores the vector); ``mean`` and ``repeat``, see
    `baselines`. ``bone`` is the error of bone lengths, metres. ``history`` has a row per evaluation.
    """

    model: Model
    bank: StyleBank
    config: Config | None = None
    history: list[dict[str, float]] = field(default_factory=list)
    held_out: dict[str, dict[str, float]] = field(default_factory=dict)
    baselines: dict[str, dict[str, float]] = field(default_factory=dict)

    def __iter__(self) -> Iterator[Model | StyleBank]:
        return iter((self.model, self.bank))

    def __repr__(self) -> str:
        facts = {"model": self.model.name, "styles": self.bank.names}
        return summary(self, facts | {"held_out": self.table()[-1]["error"]} if self.held_out else facts)

    def save(self, path: str | os.PathLike, *, slim: bool = False) -> None:
        """Write model, bank and numbers to one safetensors file; `Model.load` and `StyleBank.load` read it too.

        ``slim`` leaves out the FiLM generator and stores the experts in 16 bits. The file has a third of the size or less,
        and can only be used with the bank's styles.
        """
        tensors, parts = self.parts(generator=not slim)
        if slim:
            tensors = {name: t.half() if name.startswith("model.experts") else t for name, t in tensors.items()}
        model_files.write(path, tensors, parts)

    def parts(self, *, generator: bool = True) -> tuple[dict[str, torch.Tensor], dict]:
        """Its tensors and description, as `toolkit.io.model_files` stores them."""
        tensors, description = self.model.parts(generator=generator)
        config = None if self.config is None else dataclasses.asdict(self.config)
        numbers = {"config": config, "history": self.history, "held_out": self.held_out, "baselines": self.baselines}
        return tensors | self.bank.tensors, {"model": description, "bank": list(self.bank.names), "run": numbers}

    def table(self) -> list[dict[str, str | float]]:
        """Held-out error and both baselines: a row per style, and a row with the means over styles."""
        if not self.held_out:
            return []
        rows = [{"style": s, "error": e["mse"], **{k: v for k, v in e.items() if k != "mse"}, **self.baselines[s]}
                for s, e in self.held_out.items()]
        overall = {k: sum(row[k] for row in rows) / len(rows) for k in rows[0] if k != "style"}
        return [*rows, {"style": "overall", **overall}]


def load(path: str | os.PathLike) -> Run:
    """Read a run that `Run.save` wrote; ValueError for any other file."""
    tensors, parts = model_files.read(path, "run")
    model, bank = Model.from_parts(path, tensors, parts, None), StyleBank.from_parts(path, tensors, parts)
    with model_files.intact(path, "the record of the run"):
        config = parts["run"].pop("config")
        run = Run(model, bank, None if config is None else Config.from_json(config), **parts["run"])
        run.table()
    return run


def pretrained() -> Run:
    """The embedded default, ``model, bank = pretrained()``: a small LPN-FiLM and its style vectors. No network access.

    It was trained on procedural styles. It comes without the FiLM generator, so it cannot make style vectors of new clips.
    `docs/embedded_model.md` describes the data and the command.
    """
    with resources.as_file(resources.files("toolkit.training") / "pretrained.safetensors") as path:
        return load(path)
