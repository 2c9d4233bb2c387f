"""Checkpoints: everything that the rest of a training run depends on, as one file, written whole or not at all."""

import os
from dataclasses import dataclass, field

import torch
from torch import Tensor

from toolkit.io import model_files
from toolkit.motion.tensors import summary
from toolkit.networks import Model
from toolkit.training.run import Config


@dataclass(eq=False)
class Checkpoint:
    """State of a run after ``step`` steps and ``elapsed`` seconds.

    ``losses`` are the last step's; ``history`` has a row per evaluation; ``best`` are the weights with the least held-out
    error in it, kept where the run may stop early; ``moments`` are Adam's, by parameter.
    """

    model: Model
    step: int = 0
    elapsed: float = 0.0
    losses: dict[str, float] = field(default_factory=dict)
    history: list[dict] = field(default_factory=list)
    best: dict[str, Tensor] = field(default_factory=dict)
    moments: dict[int, dict[str, Tensor]] = field(default_factory=dict)
    __repr__ = summary

    @property
    def stalled(self) -> int:
        """Evaluations since the best one; 0 where nothing was held out, and rows say None."""
        errors = [row["held_out"] for row in self.history if row["held_out"] is not None]
        return len(errors) - 1 - errors.index(min(errors)) if errors else 0

    def save(self, path: str | os.PathLike, config: Config) -> None:
        """Write it, and the ``config`` that it is bound to."""
        tensors, description = self.model.parts()
        tensors |= {f"best.{name}": value for name, value in self.best.items()}
        tensors |= {f"adam.{i}.{name}": value for i, m in self.moments.items() for name, value in m.items()}
        numbers = {"step": self.step, "elapsed": self.elapsed, "losses": self.losses, "history": self.history,
                   "config": config.fixed()}
        model_files.write(path, tensors, {"model": description, "checkpoint": numbers})

    @classmethod
    def load(cls, path: str | os.PathLike, new: Model, config: Config) -> "Checkpoint":
        """Read one.

        Parameters
        ----------
        path
            The file.
        new
            The model that the run would start from: it must have this layout and these normalisers.
        config
            It must have been this one, in what counts.

        Raises
        ------
        ValueError
            If it is no checkpoint, or of another layout, config or data.
        """
        tensors, parts = model_files.read(path, "checkpoint")
        model, numbers = Model.from_parts(path, tensors, parts, new.layout), parts["checkpoint"]
        with model_files.intact(path, "the checkpoint"):
            why = model_files.difference(config.fixed(), numbers.pop("config"))
        if why:
            raise ValueError(f"{path}: the run to resume differs in {why}")
        if not all(torch.allclose(a, b) for a, b in zip(model.buffers(), new.buffers(), strict=True)):
            raise ValueError(f"{path}: the run to resume had other data (their means and deviations differ)")
        best = {name.removeprefix("best."): value for name, value in tensors.items() if name.startswith("best.")}
        moments: dict[int, dict[str, Tensor]] = {}
        with model_files.intact(path, "the checkpoint"):
            for name, value in tensors.items():
                if name.startswith("adam."):
                    _, i, kind = name.split(".")
                    moments.setdefault(int(i), {})[kind] = value
            found = cls(model, **numbers, best=best, moments=moments)
            if not (found.step >= 0 and found.elapsed >= 0 and isinstance(found.stalled, int)):
                raise ValueError(f"step {found.step}, {found.elapsed} s")
        return found
