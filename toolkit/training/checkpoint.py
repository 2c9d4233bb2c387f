"""Checkpoints: the file from which a training run is resumed, and when it is written."""

import contextlib
import os
import signal
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import torch
from torch import Tensor, nn

from toolkit.io import model_files
from toolkit.motion.tensors import summary


@dataclass(frozen=True, eq=False)
class Checkpoint:
    """The full state of a run as one file; an interrupted write leaves no partial file."""

    part: str  # name of the run's numbers in the file
    networks: dict[str, nn.Module]  # what is trained
    adams: dict[str, torch.optim.Adam]  # the optimisers
    config: dict[str, Any]  # settings that must not change when the run is resumed, as JSON holds them
    __repr__ = summary

    def save(self, path: str | os.PathLike, numbers: dict[str, Any], more: dict[str, Tensor] | None = None,
             **parts: Any) -> None:
        """Write networks, optimisers, ``numbers`` and ``more`` tensors; ``parts`` describe what else can read the file."""
        tensors = {f"{name}.{k}": v for name, network in self.networks.items() for k, v in network.state_dict().items()}
        tensors |= {f"adam.{name}.{i}.{kind}": value for name, adam in self.adams.items()
                    for i, moments in adam.state_dict()["state"].items() for kind, value in moments.items()}
        model_files.write(path, tensors | (more or {}), {**parts, self.part: {**numbers, "config": self.config}})

    def load(self, path: str | os.PathLike) -> tuple[dict[str, Any], dict[str, Tensor]]:
        """Load a file into the newly built networks and optimisers; returns the file's numbers and tensors.

        ValueError if the file is not a checkpoint of this kind, or belongs to another config or other data.
        """
        tensors, parts = model_files.read(path, self.part)
        buffers = {f"{name}.{k}": v.cpu() for name, network in self.networks.items() for k, v in network.named_buffers()}
        with model_files.intact(path, "the checkpoint"):
            numbers = parts[self.part]
            why = model_files.difference(self.config, numbers.pop("config"))
            pairs = [(tensors[k], v) for k, v in buffers.items() if k in tensors]
            same = all(a.shape == b.shape and torch.allclose(a, b) for a, b in pairs)
        if why:
            raise ValueError(f"{path}: the run to resume differs in {why}")
        if not same:
            raise ValueError(f"{path}: the run to resume had other data (their means and deviations differ)")
        with model_files.intact(path, "the checkpoint"):
            for name, network in self.networks.items():
                network.load_state_dict(starting(tensors, f"{name}."))
            for name, adam in self.adams.items():
                moments: dict[int, dict[str, Tensor]] = {}
                for key, value in starting(tensors, f"adam.{name}.").items():
                    i, kind = key.split(".")
                    moments.setdefault(int(i), {})[kind] = value
                adam.load_state_dict({"state": moments, "param_groups": adam.state_dict()["param_groups"]})
        return numbers, tensors


def starting(tensors: dict[str, Tensor], start: str) -> dict[str, Tensor]:
    """The tensors whose names begin with ``start``, by the rest of their names."""
    return {name.removeprefix(start): value for name, value in tensors.items() if name.startswith(start)}


class Saver(contextlib.AbstractContextManager):
    """Saves a run every so many seconds, when it is interrupted and when it is done; always between two steps.

    Inside, the first Ctrl-C ends the step, saves and raises KeyboardInterrupt; the second interrupts at once. ``every`` and
    ``elapsed`` (time before the run was resumed) are in seconds. ``agree`` computes the means of numbers over all processes,
    so that all stop at the same step.
    """

    def __init__(self, save: Callable[[], None], every: float, elapsed: float = 0.0,
                 agree: Callable[..., list[float]] = lambda *numbers: list(numbers)):
        self.save, self.every, self.agree = save, every, agree
        self.began, self.saved = time.perf_counter() - elapsed, time.perf_counter()
        self.interrupted, self._before = threading.Event(), None

    def __enter__(self) -> "Saver":
        if threading.current_thread() is threading.main_thread():
            self._before = signal.signal(signal.SIGINT, self._interrupt)
        return self

    def _interrupt(self, *_) -> None:
        self.interrupted.set()
        signal.signal(signal.SIGINT, self._before)

    def __exit__(self, kind: type | None, *_) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)
        if kind is None:
            self.save()
            if self.interrupted.is_set():  # after the last step
                raise KeyboardInterrupt

    @property
    def elapsed(self) -> float:
        """Training time in seconds, with the time before the run was resumed."""
        return time.perf_counter() - self.began

    def stepped(self, on_step: Callable[..., None] | None, *arguments: Any) -> float:
        """End a step: call ``on_step``, save if due; returns the training time in seconds, the same in all processes."""
        if on_step:
            try:
                on_step(*arguments)
            except KeyboardInterrupt:
                self.interrupted.set()
        elapsed, stop = self.agree(self.elapsed, self.interrupted.is_set())
        if stop or time.perf_counter() - self.saved > self.every:
            self.save()
            self.saved = time.perf_counter()
        if stop:
            self.agree(0.0)  # all processes wait until the file is written
            raise KeyboardInterrupt
        return elapsed
