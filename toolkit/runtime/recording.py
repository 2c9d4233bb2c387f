"""Walks: the states of all frames of a sequence of commands, and the clips that they make."""

import dataclasses
from collections.abc import Iterable, Iterator, Sequence

import torch

from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.runtime.frame import FPS, pose, start, step
from toolkit.runtime.life import Styles, alive
from toolkit.runtime.state import CharacterState
from toolkit.runtime.steering import Command, Pilot


def states(model, commands: Sequence[Command | Pilot], style: Styles,
           first: CharacterState | None = None, progress: bool = False, life: float = 0.0,
           seed: int = 0) -> Iterator[CharacterState]:
    """Yield the state after every command.

    ``style`` is a vector, or a function of the frame number for live blending. With ``life`` the
    style wanders (`toolkit.runtime.life.alive`). No gradients are recorded; the states are ordinary
    tensors, which a loss may use.
    """
    style = alive(style, life, seed)
    at = style if callable(style) else (lambda _: style)
    state = start(model, at(0)) if first is None else first
    commands = progress_bar(commands, desc="rollout", unit="frame", show=progress)
    for frame, command in enumerate(commands):
        with torch.no_grad():  # not around the yield: the caller would lose its gradients
            state = state.with_style(at(frame))
            state = step(model, state, command(state) if callable(command) else command)
        yield state


def rollout(model, commands: Sequence[Command | Pilot], style: Styles, ik: bool = True,
            first: CharacterState | None = None, progress: bool = False,
            life: float | None = None, seed: int = 0) -> Clip:
    """Let one character follow commands; record the motion of the model's whole skeleton.

    Parameters
    ----------
    model
        Made by `toolkit.networks.build`, or loaded.
    commands
        One per frame at 60 Hz: a command, or a function that computes it from the state.
    style : Tensor [S] or callable
        Style vector, or a function that computes it from the frame number.
    ik
        Hold feet in contact in place, and turn arm bones to the predicted positions.
    first
        Initial state; by default the character stands at the origin.
    life, seed
        How much the style wanders, see `toolkit.runtime.life.alive`; by default the amount that
        belongs to the model.
    """
    life = model.life if life is None else life
    recorded = states(model, commands, style, first, progress, life, seed)
    return record(model, recorded, feet=ik, arms=ik)


def record(model, recorded: Iterable[CharacterState], *, feet: bool = True, arms: bool = True,
           character: int = 0) -> Clip:
    """The motion of one character in a sequence of states, see `rollout`.

    ``feet`` and ``arms`` switch their IK on. A ValueError if there are no states.
    """
    recorded = list(recorded)
    if not recorded:
        raise ValueError("no frames to record: a rollout needs at least one command")
    return _clip(model, joined(recorded, character), feet=feet, arms=arms)


def record_all(model, recorded: Sequence[CharacterState]) -> list[Clip]:
    """The motions of the B characters of states, as `record` makes them one by one, but sooner."""
    together = vars(joined(recorded, slice(None)))
    return [_clip(model, CharacterState(**{name: part[:, i] for name, part in together.items()}))
            for i in range(len(recorded[0].root))]


def joined(recorded: Sequence[CharacterState], character: int | slice = 0) -> CharacterState:
    """The states of one character ``[F, …]``, or of several ``[F, B, …]``; without the style, which
    is large.
    """
    names = [f.name for f in dataclasses.fields(CharacterState) if f.name != "style"]
    parts = {name: torch.stack([getattr(s, name)[character] for s in recorded]) for name in names}
    return CharacterState(**parts, style=parts["facing"][..., :0])  # no columns


def _clip(model, walked: CharacterState, **options: bool) -> Clip:
    return Clip(model.layout.skeleton, *pose(model, walked, **options), FPS, name="rollout")
