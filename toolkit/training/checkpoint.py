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

SAVE_EVERY = 120.0  # seconds between checkpoints
COUNTED = 2**24  # Adam's own number of steps, a float32, grows no further

@dataclass(frozen=True, eq=False)
class Checkpoint:
    """The full state of a run as one file; an interrupted write leaves no partial file."""

    part: str  # name of the run's numbers in the file
    networks: dict[str, nn.Module]  # what is trained
    adams: dict[str, torch.optim.Adam]  # the optimisers
    config: dict[str, Any]  # settings that must not change when the run is resumed, for JSON
    kinds: dict[str, Any]  # an example of the numbers, among them step and elapsed
    __repr__ = summary

    def save(self, path: str | os.PathLike, numbers: dict[str, Any],
             more: dict[str, Tensor] | None = None, **parts: Any) -> None:
        """Write networks, optimisers, ``numbers`` and ``more`` tensors.

        ``parts`` describe what else can read the file.
        """
        tensors = dict(more or {})
        for name, network in self.networks.items():
            tensors |= {f"{name}.{key}": value for key, value in network.state_dict().items()}
        for name, adam in self.adams.items():
            for i, moments in adam.state_dict()["state"].items():
                tensors |= {f"adam.{name}.{i}.{kind}": value for kind, value in moments.items()}
        parts[self.part] = {**numbers, "config": self.config}
        model_files.write(path, tensors, parts)

    def load(self, path: str | os.PathLike) -> tuple[dict[str, Any], dict[str, Tensor]]:
        """Load a file into the newly built networks and optimisers; its numbers and tensors.

        ValueError if it is no checkpoint of this kind, of another config or other data, or damaged.
        """
        tensors, parts = model_files.read(path, self.part)
        with model_files.intact(path, "the checkpoint"):
            numbers = parts[self.part]
            why = model_files.difference(self.config, numbers.pop("config"))
            same = all(self._same_data(tensors, name) for name in self.networks)
        if why:
            raise ValueError(f"{path}: the run to resume differs in {why}")
        if not same:
            raise ValueError(f"{path}: the run to resume had other data (their means and "
                             "deviations differ)")
        with model_files.intact(path, "the checkpoint"):
            # everything is checked before anything is changed
            own = {name: model_files.starting(tensors, f"{name}.") for name in self.networks}
            for name, network in self.networks.items():
                model_files.check(own[name], network.state_dict())
            moments = {name: _moments(model_files.starting(tensors, f"adam.{name}."), adam)
                       for name, adam in self.adams.items()}
            model_files.alike(numbers, self.kinds)
            made = max((int(kinds["step"]) for of in moments.values() for kinds in of.values()),
                       default=0)
            if min(numbers["step"], COUNTED) != made or numbers["elapsed"] < 0:
                raise ValueError(f"its step is {numbers['step']} after {numbers['elapsed']} s, and "
                                 f"the moments of Adam are those of step {made}")
            for name, network in self.networks.items():
                network.load_state_dict(own[name])
            for name, adam in self.adams.items():
                groups = adam.state_dict()["param_groups"]
                adam.load_state_dict({"state": moments[name], "param_groups": groups})
        return numbers, tensors

    def _same_data(self, tensors: dict[str, Tensor], name: str) -> bool:
        """Whether a network's buffers, the statistics of its data, are those of a file."""
        for key, buffer in self.networks[name].named_buffers():
            stored = tensors.get(f"{name}.{key}", buffer.cpu())
            if stored.shape != buffer.shape or not torch.allclose(stored, buffer.cpu()):
                return False
        return True


def _moments(tensors: dict[str, Tensor], adam: torch.optim.Adam) -> dict[int, dict[str, Tensor]]:
    """Adam's state from a file's tensors, by number of the parameter; empty before its first step.

    The tensors are compared with the parameters, because the fused Adam reads and writes as many
    numbers as a parameter has, however many a moment has.
    """
    if not tensors:
        return {}
    parameters = [p for group in adam.param_groups for p in group["params"]]
    expected = {}
    for i, parameter in enumerate(parameters):
        expected |= {f"{i}.step": torch.zeros(()), f"{i}.exp_avg": parameter,
                     f"{i}.exp_avg_sq": parameter}
    model_files.check(tensors, expected)
    moments = {i: model_files.starting(tensors, f"{i}.") for i in range(len(parameters))}
    for i, kinds in moments.items():
        if kinds["step"] < 1 or bool((kinds["exp_avg_sq"] < 0).any()):
            raise ValueError(f"Adam's parameter {i} has a step below 1 or a negative square")
    return moments


class Saver(contextlib.AbstractContextManager):
    """Saves a run between two steps: every `SAVE_EVERY`, and when it is interrupted or done.

    Inside, the first Ctrl-C ends the step, saves and raises KeyboardInterrupt; the second
    interrupts at once. ``elapsed`` is the time before the run was resumed, seconds. ``agree``
    computes the means of numbers over all processes, so that all stop at the same step.
    """

    def __init__(self, save: Callable[[], None], elapsed: float = 0.0,
                 agree: Callable[..., list[float]] = lambda *numbers: list(numbers)):
        self.save, self.agree = save, agree
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

    def stepped(self) -> float:
        """End a step, save if due; returns the training time, seconds, the same in all processes.
        """
        elapsed, stop = self.agree(self.elapsed, self.interrupted.is_set())
        if stop or time.perf_counter() - self.saved > SAVE_EVERY:
            self.save()
            self.saved = time.perf_counter()
        if stop:
            self.agree(0.0)  # all processes wait until the file is written
            raise KeyboardInterrupt
        return elapsed
