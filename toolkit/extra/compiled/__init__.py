"""The runtime compiled for a processor: `toolkit.runtime` for N characters at once.

`network` has the network, `frame` the rest of a step, `ik` the pose to draw. Numba compiles each
function for the present processor at its first use, and stores it on disk.
"""

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit.extra.compiled import frame, ik, network
from toolkit.features.layout import Layout
from toolkit.runtime import rules
from toolkit.runtime.frame import CharacterState, pose, start, step
from toolkit.runtime.steering import Command

KERNELS = (frame.steer, network.gate, network.modulate, network.scale, frame.after_network, ik.pose)
READ, MADE = 120, 1500  # least frames for which kernels are read, and are compiled, by `quick`
Pair = tuple[float, float]
Ask = Callable[[int, Pair], tuple[Sequence[float], Sequence[float], Tensor]]  # see `roll`


class CompiledModel:
    """A model compiled for this processor, to take its place in `toolkit.runtime`.

    `toolkit.runtime.compile` is its name there. The first call on a machine compiles, later calls
    read the code from disk. The weights are copies: later training of the model does not change
    them. ``docs/runtime.md`` gives times, and differences from the plain model.

    Raises
    ------
    ValueError
        If the model is not an LPN-FiLM, or is calibrated.
    """

    def __init__(self, model):
        name = getattr(model, "name", type(model).__name__)
        if isinstance(model, CompiledModel):
            raise ValueError("the model is a compiled one already")
        if name != "lpn-film":
            raise ValueError(f"only lpn-film can be compiled, got {name}")
        if model.calibrated:
            raise ValueError("a calibrated model cannot be compiled; set model.calibrated = False")
        self.layout: Layout = model.layout
        self.name, self.sizes, self.style_size = model.name, model.sizes, model.style_size
        self.life, self.ground, self.memory = model.life, model.ground, model.memory
        for buffer in ("phases_mean", "phases_std", "outputs_mean"):  # `toolkit.runtime.start`
            setattr(self, buffer, getattr(model, buffer).clone())
        self.weights = network.Weights.of(model)
        self._rules, self._body = rules.rules_of(model), rules.Body.of(model.layout.skeleton)

        # shapes of the parts of a state, one row a character
        state = start(self, torch.zeros(1, self.style_size))
        self._shapes = {part: getattr(state, part).shape[1:] for part in frame.State._fields}

        self.pose(self.step(state, Command()))  # compiles the kernels, or reads them from disk

    def step(self, state: CharacterState, command: Command) -> CharacterState:
        """`toolkit.runtime.step`."""
        count = len(state.history)
        old = frame.State(*self._arrays(state, frame.State._fields))
        new = frame.State(*map(np.empty_like, old[:-1]), old.style)
        wanted, look = _pairs(command.velocity, count), _pairs(command.facing, count)
        self._advance(old, new, wanted, look, *self._room(count))
        parts = dict(zip(new._fields[:-1], map(torch.from_numpy, new[:-1]), strict=True))
        return CharacterState(**parts, style=state.style)

    def roll(self, state: CharacterState, frames: int, ask: Ask) -> CharacterState:
        """So many `step` calls of one character, the same bits in two thirds of the time.

        Parameters
        ----------
        state
            Of one character, before the first step.
        frames
            1 or more.
        ask
            Function of the number of the step, from 0, and the place (x, z) of the root before it,
            that gives the commanded velocity and facing, and the style vector ``[S]``.

        Returns
        -------
        CharacterState
            The states after every step, along the leading axis; without the style, as it is large
            and known.
        """
        if len(state.history) != 1 or frames < 1:
            raise ValueError("one character and 1 frame or more are needed, got "
                             f"{len(state.history)} and {frames}")
        # row 0 is the given state, row k the state after k steps
        rows = {}
        parts = frame.State._fields[:-1]
        for name, first in zip(parts, self._arrays(state, parts), strict=True):
            rows[name] = np.empty((frames + 1, 1, *self._shapes[name]), np.float32)
            rows[name][0] = first
        wanted, look = np.empty((1, 2), np.float32), np.empty((1, 2), np.float32)
        x, z = self._room(1)
        for k in range(frames):
            place = tuple(rows["history"][k, 0, -1, :2].tolist())
            wanted[0], look[0], style = ask(k, place)
            if style.shape != (self.style_size,):
                raise ValueError(f"a style needs {self.style_size} columns, got shape "
                                 f"{list(style.shape)}")
            vector = style.numpy()[None]
            old = frame.State(*(values[k] for values in rows.values()), vector)
            new = frame.State(*(values[k + 1] for values in rows.values()), vector)
            self._advance(old, new, wanted, look, x, z)
        parts = {name: torch.from_numpy(values[1:, 0]) for name, values in rows.items()}
        return CharacterState(**parts, style=parts["history"].new_empty(frames, 0))

    def pose(self, state: CharacterState, *, feet: bool = True,
             arms: bool = True) -> tuple[Tensor, Tensor]:
        """`toolkit.runtime.pose`."""
        count = len(state.history)
        given = self._arrays(state, ("history", "joints", "toes", "drop", "swivel"))
        rotations = np.empty((count, len(self.layout.skeleton), 4), np.float32)
        roots = np.empty((count, 3), np.float32)
        ik.pose(*given, self._body, bool(feet), bool(arms), rotations, roots)
        return torch.from_numpy(rotations), torch.from_numpy(roots)

    def _advance(self, old, new, wanted, look, x, z) -> None:
        """One frame of all characters; ``x`` and ``z`` are from `_room`."""
        frame.steer(old, wanted, look, self._rules, x, new)
        network.predict(x, old.phase, old.style, self.weights, z)
        frame.after_network(old, z, self._rules, self._body, new)

    def _room(self, count: int) -> tuple[np.ndarray, np.ndarray]:
        """Arrays for the network's inputs and outputs."""
        return (np.empty((count, self.layout.n_inputs), np.float32),
                np.empty((count, self.layout.n_outputs), np.float32))

    def _arrays(self, state: CharacterState, parts: Sequence[str]) -> list[np.ndarray]:
        """Parts of a state for the kernels. They do not check bounds, so shapes are checked."""
        arrays, count = [], len(state.history)
        for name in parts:
            tensor, shape = getattr(state, name), self._shapes[name]
            if name == "style" and not tensor.stride(0):  # one style for all: not copied for each
                tensor = tensor[:1]
            if tensor.requires_grad:
                tensor = tensor.detach()
            array = np.ascontiguousarray(tensor.numpy(), np.float32)
            # shapes are numpy's, as asking torch takes longer
            right = array.shape[1:] == shape
            if not right or (len(array) != count and (name, len(array)) != ("style", 1)):
                raise ValueError(f"{name} needs {' x '.join(map(str, shape))} columns and a row "
                                 f"for each of {count} characters, got shape {list(array.shape)}")
            arrays.append(array)
        return arrays


step.register(CompiledModel)(CompiledModel.step)
pose.register(CompiledModel)(CompiledModel.pose)


def quick(model, frames: int, say: Callable[[str], object] | None = None):
    """The model compiled if so many frames are worth it, else as it is.

    ``say`` is told before kernels are compiled, which takes half a minute, once on a machine.
    """
    if getattr(model, "name", "") != "lpn-film" or getattr(model, "calibrated", True):
        return model
    if (model.outputs_mean.device.type, model.outputs_mean.dtype) != ("cpu", torch.float32):
        return model
    kept = all(map(_kept, KERNELS))
    if frames < (READ if kept else MADE):
        return model
    if say is not None and not kept:
        say("The runtime is compiled, which takes half a minute; it is kept for the next time.")
    return CompiledModel(model)


def _kept(kernel) -> bool:
    """Whether the disk has a kernel."""
    code, folder = kernel.py_func.__code__, kernel.stats.cache_path
    name = f"*{code.co_name}-{code.co_firstlineno}.*.nbi"
    return folder is not None and any(Path(folder).glob(name))


def _pairs(value: Sequence[float] | Tensor, count: int) -> np.ndarray:
    """A command's numbers ``[1 or N, 2]``."""
    pairs = np.ascontiguousarray(value, np.float32).reshape(-1, 2)
    if len(pairs) not in (1, count):
        raise ValueError(f"a command for {count} characters needs one pair of numbers or {count}, "
                         f"got {len(pairs)}")
    return pairs
