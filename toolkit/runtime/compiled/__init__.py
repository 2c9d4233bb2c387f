"""The runtime compiled for a processor: `toolkit.runtime` for N characters at once, many times as fast.

`network` has the network, `frame` the rest of a step, `ik` the pose to draw. Numba compiles each function for the present
processor at its first use, and stores it on disk.
"""

import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property, partial
from itertools import pairwise

import numpy as np
import torch
from torch import Tensor

from toolkit.features.layout import Layout
from toolkit.motion import trajectory
from toolkit.runtime.compiled import frame, ik, network
from toolkit.runtime.frame import CharacterState, pose, start, step
from toolkit.runtime.steering import Command

WORTHWHILE = 8  # least number of characters for one thread; this many are computed together
Ask = Callable[[int, tuple[float, float]], tuple[Sequence[float], Sequence[float], Tensor]]  # see `CompiledModel.roll`
KERNELS = (frame.steer, network.predict, frame.follow, ik.pose)


class CompiledModel:
    """A model with compiled `step` and `pose`, made by `toolkit.runtime.compile`; use it in place of a model.

    Its weights are copies: later training of the model does not change it.

    ``seconds`` is the time to prepare the kernels, ``compiled`` the number of those that were compiled; the others were read
    from disk. The options are those of `compile`.
    """

    def __init__(self, model, precision: str = "float32", skip: float = 0.0, threads: int = 1):
        name = getattr(model, "name", type(model).__name__)
        if name != "lpn-film":
            raise ValueError(f"only lpn-film can be compiled, got {name}")
        if precision not in network.PRECISIONS:
            raise ValueError(f"precision is one of {', '.join(network.PRECISIONS)}; got {precision!r}")
        if model.calibrated and precision != "float32":
            raise ValueError(f"a calibrated model needs precision float32, got {precision!r}")
        if not 0 <= skip < 1 / model.sizes.experts:
            raise ValueError(f"skip must be in [0, 1/{model.sizes.experts}), or no expert might be left; got {skip}")
        if not isinstance(threads, int) or threads < 1:
            raise ValueError(f"threads must be a whole number from 1, got {threads!r}")
        self.layout: Layout = model.layout
        self.name, self.sizes, self.style_size = model.name, model.sizes, model.style_size
        self.precision, self.skip, self.threads = precision, float(skip), threads
        for name in ("phases_mean", "phases_std", "outputs_mean"):  # needed by `toolkit.runtime.start`
            setattr(self, name, getattr(model, name).clone())
        self.weights = network.Weights.of(model, precision)
        self.dropped = np.float32(model.dropped if model.calibrated else 0.0)
        self._shapes = {"history": (trajectory.PAST + 1, 4), "future": (len(self.layout.ahead), 4), "drive": (1,),
                        "joints": (self.layout.n_clip,), "phase": (self.layout.n_phases,), "style": (self.style_size,),
                        "velocity": (2,), "facing": (2,), "contacts": (2,), "toes": (2, 3), "drift": (2, 2), "drop": (2,)}
        self._rules, self._body = frame.rules_of(self.layout), ik.Body.of(self.layout.skeleton)
        known, began = self._misses(), time.perf_counter()
        state = self.step(start(self, torch.zeros(1, self.style_size)), Command())
        self.pose(state)
        self.seconds, self.compiled = time.perf_counter() - began, self._misses() - known

    def __getattr__(self, name: str):
        raise AttributeError(f"a compiled model has no {name!r}; use the model from which it was compiled")

    def __repr__(self) -> str:
        ready = f"{self.compiled} kernels compiled" if self.compiled else "kernels ready"
        skip = f", experts below {self.skip:g} left out" if self.skip else ""
        return (f"CompiledModel({self.name}, {self.precision}{skip}, {self.weights.bytes / 1e6:.1f} MB, {self.threads} "
                f"thread{'s' * (self.threads > 1)}; {ready} in {self.seconds:.1f} s)")

    def step(self, state: CharacterState, command: Command) -> CharacterState:
        """`toolkit.runtime.step`."""
        old, count = frame.State(*(self._array(state, name) for name in frame.State._fields)), len(state.history)
        wanted, look = (_pairs(value, count) for value in (command.velocity, command.facing))
        new = frame.State(*map(np.empty_like, old[:-1]), old.style)
        x, z = np.empty((count, self.layout.n_inputs), np.float32), np.empty((count, self.layout.n_outputs), np.float32)

        self._share(partial(self._advance, old, new, wanted, look, x, z), count)
        return CharacterState(**dict(zip(new._fields, map(torch.from_numpy, new[:-1]), strict=False)), style=state.style)

    def roll(self, state: CharacterState, frames: int, ask: Ask) -> CharacterState:
        """So many `step` calls of one character, the same bits in two thirds of the time.

        Parameters
        ----------
        state
            Of one character, before the first step.
        frames
            1 or more.
        ask
            Function of the number of the step, from 0, and the place (x, z) of the root before it, that gives the commanded
            velocity and facing, and the style vector ``[S]``.

        Returns
        -------
        CharacterState
            The states after every step, along the leading axis; without the style, as it is large and known.
        """
        if len(state.history) != 1 or frames < 1:
            raise ValueError(f"one character and 1 frame or more are needed, got {len(state.history)} and {frames}")
        names = frame.State._fields[:-1]
        rows = {name: np.empty((frames + 1, 1, *self._shapes[name]), np.float32) for name in names}
        for name in names:
            rows[name][0] = self._array(state, name)
        wanted, look = np.empty((1, 2), np.float32), np.empty((1, 2), np.float32)
        x, z = np.empty((1, self.layout.n_inputs), np.float32), np.empty((1, self.layout.n_outputs), np.float32)
        columns, places = [rows[name] for name in names], rows["history"]
        for k in range(frames):
            wanted[0], look[0], style = ask(k, tuple(places[k, 0, -1, :2].tolist()))
            if style.shape != (self.style_size,):
                raise ValueError(f"a style needs {self.style_size} columns, got shape {list(style.shape)}")
            old = frame.State(*(column[k] for column in columns), style.numpy()[None])
            new = frame.State(*(column[k + 1] for column in columns), old.style)
            self._advance(old, new, wanted, look, x, z, 0, 1)
        held = {name: torch.from_numpy(column[1:, 0]) for name, column in rows.items()}
        return CharacterState(**held, style=held["history"].new_empty(frames, 0))

    def _advance(self, old: frame.State, new: frame.State, wanted: np.ndarray, look: np.ndarray, x: np.ndarray,
                 z: np.ndarray, start: int, stop: int) -> None:
        """One frame of characters ``start`` to ``stop``; ``x`` and ``z`` are room for the network's inputs and outputs."""
        frame.steer(old, wanted, look, self._rules, x, new, start, stop)
        network.predict(x, old.phase, old.style, self.weights, self.skip, self.dropped, z, start, stop)
        frame.follow(old, z, self._rules, self._body, new, start, stop)

    def pose(self, state: CharacterState, *, feet: bool = True, arms: bool = True) -> tuple[Tensor, Tensor]:
        """`toolkit.runtime.pose`."""
        given, count = [self._array(state, name) for name in ("history", "joints", "toes", "drop")], len(state.history)
        rotations, roots = np.empty((count, len(self.layout.skeleton), 4), np.float32), np.empty((count, 3), np.float32)
        self._share(partial(ik.pose, *given, self._body, bool(feet), bool(arms), rotations, roots), count)
        return torch.from_numpy(rotations), torch.from_numpy(roots)

    def predict(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """`toolkit.networks.Model.predict`."""
        given = []
        for name, value, width in (("x", x, self.layout.n_inputs), ("phases", phases, self.layout.n_phases),
                                   ("style", style, self.style_size)):
            if value.shape[-1] != width:
                raise ValueError(f"{name} needs {width} columns, got shape {list(value.shape)}")
            given.append(np.ascontiguousarray(value.detach().expand(len(x), width).numpy(), np.float32))
        z = np.empty((len(x), self.layout.n_outputs), np.float32)
        self._share(partial(network.predict, *given, self.weights, self.skip, self.dropped, z), len(x))
        return torch.from_numpy(z)

    def _array(self, state: CharacterState, name: str) -> np.ndarray:
        """A part of a state as an array for the kernels. They do not check bounds, so shapes are checked here."""
        tensor = getattr(state, name)
        if name == "style" and not tensor.stride(0):  # one style for all: not copied for each
            tensor = tensor[:1]
        array = (tensor.detach() if tensor.requires_grad else tensor).numpy()
        if array.shape[1:] != self._shapes[name] or len(array) not in (len(state.history), 1 if name == "style" else -1):
            raise ValueError(f"{name} needs {' x '.join(map(str, self._shapes[name]))} columns and a row for each of "
                             f"{len(state.history)} characters, got shape {list(tensor.shape)}")
        return np.ascontiguousarray(array, np.float32)

    def _share(self, work: Callable[[int, int], None], count: int) -> None:
        """Call ``work`` on ranges that divide ``count`` characters, one thread per range."""
        threads = min(self.threads, count // WORTHWHILE)
        if threads <= 1:
            work(0, count)
            return
        ends = [count * part // threads for part in range(threads + 1)]
        for done in [self._pool.submit(work, *span) for span in pairwise(ends)]:
            done.result()

    @cached_property
    def _pool(self) -> ThreadPoolExecutor:
        return ThreadPoolExecutor(self.threads)

    @staticmethod
    def _misses() -> int:
        return sum(sum(kernel.stats.cache_misses.values()) for kernel in KERNELS)


step.register(CompiledModel)(CompiledModel.step)
pose.register(CompiledModel)(CompiledModel.pose)


def compile(model, *, precision: str = "float32", skip: float = 0.0, threads: int = 1) -> CompiledModel:
    """The same model compiled for this processor, to take its place in `toolkit.runtime` and in `toolkit.view.Controller`.

    The first call on a machine compiles; the result's representation shows the time. Later calls read the code from disk.
    ``docs/runtime.md`` gives times, and differences from the plain model.

    Parameters
    ----------
    model
        An LPN-FiLM.
    precision
        Of the experts' weights: ``"float32"``, or ``"bfloat16"``, which takes half the memory and, for one character, two
        thirds of the time; outputs differ by about 5e-4 of their deviation.
    skip
        Leave out experts whose weight for a character is below this, and scale up the others. A frame loses at most this
        share for each expert that is left out.
    threads
        Number of threads that share the characters, at least eight characters each.

    Raises
    ------
    ValueError
        If the model is not an LPN-FiLM, or an option is out of its range.
    """
    return CompiledModel(model, precision, skip, threads)


def _pairs(value: Sequence[float] | Tensor, count: int) -> np.ndarray:
    """A command's numbers ``[1 or N, 2]``."""
    pairs = np.ascontiguousarray(value, np.float32).reshape(-1, 2)
    if len(pairs) not in (1, count):
        raise ValueError(f"a command for {count} characters needs one pair of numbers or {count}, got {len(pairs)}")
    return pairs
