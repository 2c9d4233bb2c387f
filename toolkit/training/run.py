"""A training run: its config, and its result as one file."""

import json
import os
from collections.abc import Iterator
from dataclasses import asdict, dataclass, field
from numbers import Integral, Real
from pathlib import Path

import torch

from toolkit import registry
from toolkit.io import model_files
from toolkit.motion.tensors import summary
from toolkit.networks import Predictor, Sizes, imported
from toolkit.networks.bank import StyleBank
from toolkit.training.loss import STEPS

PRECISIONS = ("32", "bf16")
#: Settings that are whole numbers.
WHOLE = ("steps", "patience", "batch", "clips_per_batch", "refit", "seed", "evaluate_every",
         "processes")
SMALL, LARGE = 1e-30, 1e30
#: Least and largest value of the settings that are numbers.
RANGES = {
    **dict.fromkeys(WHOLE, (1, LARGE)), "refit": (0, LARGE), "seed": (0, LARGE),
    **dict.fromkeys(("epochs", "seconds", "rate", "max_gradient"), (SMALL, LARGE)),
    "style_rate": (0, LARGE),
    "final_rate": (0, 1), "pose_mixup": (0, 1), "held_out": (0, 0.99)}
PROCEDURAL = Path(__file__).with_name("pretrained.safetensors")
RECORDED = Path(__file__).parents[2] / "examples" / "models" / "recorded.safetensors"
TIMES = "elapsed", "processor"  # measured times in a history; two runs never have the same
KINDS = {"history": [{"": None}], "held_out": {"": {"": None}}, "baselines": {"": {"": None}}}
#: Learning rate of the style modulation / other rates in `Config.quick`. High rates destroy FiLM's
#: convolutions. Tables of styles need high rates, one-hot the highest, because a row is trained
#: only by the minibatches of its own style.
STYLE_RATES = {"film": 0.1, "onehot": 10.0, "resad": 1.0}


@dataclass(frozen=True)
class Config:
    """How to train: as in the paper, but for ``refit``, a departure of ours.

    Give one of ``epochs``, ``steps`` and ``seconds``, or none.
    """

    model: str = "lpn-film"  # one of `toolkit.networks.MODELS`, or your own, see `register`
    sizes: Sizes = field(default_factory=Sizes)  # how large the networks are
    styles: tuple[str, ...] = ()  # in the order in which minibatches cycle through them; empty: all
    epochs: float | None = None  # passes of the shortest style; 90 in the paper
    steps: int | None = None  # minibatches
    seconds: float | None = None  # wall time: the result depends on the machine
    # evaluations without a better held-out error, after which it stops and keeps the best weights
    patience: int | None = None
    batch: int = 32  # frames of one style per minibatch
    # style clips per minibatch, shared by its frames; 1 takes a third of the time of 32
    clips_per_batch: int = 32
    rate: float = 1e-4  # Adam's learning rate at the start
    # rate of the style modulation / ``rate``; its convolutions fail at rates from 1e-3 on
    style_rate: float = 1.0
    # last learning rate / first, with cosine decay between them; 1: constant
    final_rate: float = 1.0
    # norm to which gradients are clipped; without it, losses spike at rates from 1e-3 on
    max_gradient: float | None = None
    # share of frames whose input pose is mixed with another frame's, see `Minibatches`; 0 in the
    # paper
    pose_mixup: float = 0.0
    # steps per style that fit FiLM's vectors to frames after the training; 0: means of clips, as in
    # the paper
    refit: int = STEPS
    held_out: float = 0.1  # share of every style's frames that is kept for the test error
    evaluate_every: int = 1000  # steps between test errors in the history
    seed: int = 0  # of initial weights, held-out frames, minibatches and dropout
    precision: str = "32"  # "bf16": products in bfloat16, weights and Adam in float32
    device: str = "cpu"  # of torch: "cpu", "cuda", "cuda:1" …
    processes: int = 1  # on this machine, each with its own device; torchrun overrides it
    __repr__ = summary

    def __post_init__(self):
        registry.find(f"model.{self.model}")
        budgets = [name for name in ("epochs", "steps", "seconds")
                   if getattr(self, name) is not None]
        if len(budgets) > 1:
            raise ValueError(f"give one of epochs, steps and seconds, got {' and '.join(budgets)}")
        for name, (least, most) in RANGES.items():
            value, kind = getattr(self, name), Integral if name in WHOLE else Real
            if value is getattr(Config, name):  # None, of some
                continue
            if not (isinstance(value, kind) and least <= value <= most):
                whole = "whole " * (name in WHOLE)
                raise ValueError(f"{name} must be a {whole}number from {least:g} to {most:g}, "
                                 f"got {value!r}")
        if self.clips_per_batch > self.batch:
            raise ValueError(f"clips_per_batch must be at most the {self.batch} frames of a "
                             f"minibatch, got {self.clips_per_batch}")
        if self.precision not in PRECISIONS:
            raise ValueError(f"precision must be one of {', '.join(PRECISIONS)}, "
                             f"got {self.precision!r}")

    @classmethod
    def quick(cls, **changes) -> "Config":
        """Half a minute on two cores.

        Small sizes, one style clip per minibatch, pose mix-up, a high rate that decays.
        """
        style = str(changes.get("model", cls.model)).rpartition("-")[2]
        settings = {"sizes": Sizes.small(), "batch": 64, "clips_per_batch": 1, "rate": 2e-3,
                    "style_rate": STYLE_RATES.get(style, 1.0), "final_rate": 0.01,
                    "max_gradient": 1.0, "pose_mixup": 0.3}
        if not changes.keys() & {"epochs", "steps", "seconds"}:
            settings["seconds"] = 30.0
        return cls(**(settings | changes))

    @classmethod
    def from_json(cls, stored: dict) -> "Config":
        """A config as JSON holds it."""
        sizes, styles = Sizes(**stored["sizes"]), tuple(stored["styles"])
        settings = {"refit": 0, **stored, "sizes": sizes, "styles": styles}
        for old in ("bone_weight", "save_every"):  # of older files
            settings.pop(old, None)
        return cls(**settings)

    def fixed(self) -> dict:
        """The settings that must not change when a run is resumed, as JSON values."""
        free = {"device", "processes", "refit"}
        if self.patience is None:
            free.add("evaluate_every")
        settings = asdict(self).items()
        return json.loads(json.dumps({k: v for k, v in settings if k not in free}))


@dataclass(eq=False)
class Run:
    """A model and its style bank, from training or from a file; it unpacks as ``model, bank``.

    ``config`` is None if the toolkit did not train the model; then there are no errors either.
    ``held_out[style]`` and ``baselines[style]`` are mean squared errors of normalised outputs on
    held-out frames: ``mse``; ``other``, with another style's vector (if it is not much larger than
    ``mse``, the model ignores the vector); ``mean`` and ``repeat``, see `baselines`. ``bone`` is
    the error of bone lengths, metres. ``history`` has a row per evaluation; a file holds its rows
    without their `TIMES`, so that the same training writes the same bytes.
    """

    model: Predictor
    bank: StyleBank
    config: Config | None = None
    history: list[dict[str, float]] = field(default_factory=list)
    held_out: dict[str, dict[str, float]] = field(default_factory=dict)
    baselines: dict[str, dict[str, float]] = field(default_factory=dict)

    def __iter__(self) -> Iterator[Predictor | StyleBank]:
        return iter((self.model, self.bank))

    def __repr__(self) -> str:
        facts = {"model": self.model.name, "styles": self.bank.names}
        if self.held_out:
            facts["held_out"] = self.table()[-1]["error"]
        return summary(self, facts)

    def save(self, path: str | os.PathLike, *, slim: bool = False) -> None:
        """Write model, bank and numbers to one file, also for `StyleBank.load`.

        ``slim`` leaves out the FiLM generator and stores the experts in 16 bits. The file has a
        third of the size or less, and can only be used with the bank's styles.
        """
        tensors, parts = self.parts(generator=not slim)
        if slim:
            for name in tensors:
                if name.startswith("model.experts"):
                    tensors[name] = tensors[name].half()
        model_files.write(path, tensors, parts)

    def parts(self, *, generator: bool = True) -> tuple[dict[str, torch.Tensor], dict]:
        """Its tensors and description, as `toolkit.io.model_files` stores them."""
        tensors, description = self.model.parts(generator=generator)
        config = None if self.config is None else asdict(self.config)
        history = [{name: value for name, value in row.items() if name not in TIMES}
                   for row in self.history]
        numbers = {"config": config, "history": history, "held_out": self.held_out,
                   "baselines": self.baselines}
        parts = {"model": description, "bank": list(self.bank.names), "run": numbers}
        return tensors | self.bank.tensors, parts

    def table(self) -> list[dict[str, str | float]]:
        """Held-out error and both baselines: a row per style, and one of means over styles."""
        rows = []
        for style, errors in self.held_out.items():
            named = {"error" if name == "mse" else name: value for name, value in errors.items()}
            rows.append({"style": style, **named, **self.baselines[style]})
        if not rows:
            return []
        numbers = [name for name in rows[0] if name != "style"]
        means = {name: sum(row[name] for row in rows) / len(rows) for name in numbers}
        return [*rows, {"style": "overall", **means}]


def load(path: str | os.PathLike) -> Run:
    """Read a run that `Run.save` wrote; ValueError for any other file."""
    tensors, parts = model_files.read(path, "run")
    model = Predictor.from_parts(path, tensors, parts)
    bank = StyleBank.from_parts(path, tensors, parts)
    with model_files.intact(path, "the record of the run"):
        if bank.vectors.shape[1] != model.style_size:
            raise ValueError(f"style vectors [{bank.vectors.shape[1]}] of a model that takes "
                             f"[{model.style_size}]")
        model_files.alike(parts["run"], KINDS)
        config = parts["run"].pop("config")
        config = None if config is None else Config.from_json(config)
        run = Run(model, bank, config, **parts["run"])
        run.table()
    return run


def pretrained(name: str = "procedural") -> Run:
    """A trained small LPN-FiLM and its styles, ``model, bank = pretrained()``.

    ``"procedural"``, which is part of the package, was trained on computed walks. ``"recorded"``
    was trained on people (Bandai-Namco, CC BY-NC 4.0, not for commercial use); it is a file of the
    repository, and where it is not there, a FileNotFoundError says so. Both come without the FiLM
    generator, so they cannot make style vectors of new clips. `docs/embedded_model.md` describes
    the data and the commands. ValueError for another name.
    """
    if name not in ("procedural", "recorded"):
        raise ValueError(f"no model {name!r}: procedural or recorded")
    return load(model_file(name))


def included() -> list[str]:
    """The names that `pretrained` knows here: a package has no recorded model."""
    return ["procedural", *(["recorded"] if RECORDED.exists() else [])]


def model_file(given: str | os.PathLike) -> Path:
    """The file of a model that a command names: ``procedural``, ``recorded``, or a path.

    Of ``MODULE:FILE`` the module, which registers a model of one's own, is imported.
    """
    if str(given) == "procedural":
        return PROCEDURAL
    if str(given) != "recorded":
        return Path(imported(str(given)))
    if not RECORDED.exists():
        raise FileNotFoundError(
            f"{RECORDED}: the recorded model is not part of the package (CC BY-NC 4.0); it is in "
            "the repository, in examples/models; docs/embedded_model.md has the command that "
            "trains it")
    return RECORDED
