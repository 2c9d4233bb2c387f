"""Shots rendered again after a change: only from the first frame on that the change reaches."""

import dataclasses
import math
from collections.abc import Callable, Sequence

import torch
from torch import Tensor

from toolkit.motion import Clip
from toolkit.networks.bank import StyleBank
from toolkit.runtime import CharacterState, Command, pose, start, step
from toolkit.shots.course import FPS, Course, Heading, Pair, command

GOLDEN = (math.sqrt(5) - 1) / 2  # the share of a cycle by which the next seed starts later
FIELDS = tuple(field.name for field in dataclasses.fields(CharacterState) if field.name != "style")
Asked = tuple[Pair, Pair, Tensor]  # velocity, facing and style of a frame


class Preview:
    """Renders the versions of one shot, the same bits as `Shot.render`; frames that a change does not reach are kept.

    A frame is kept as long as everything before it is: the first state, and velocity, facing and style of every command.

    Parameters
    ----------
    model, bank : as in `Shot.render`; compiled, a changed ten-second shot takes about as long as its network

    Attributes
    ----------
    kept : frames of the last render that were kept
    """

    def __init__(self, model, bank: StyleBank):
        self.model, self.bank, self.kept = model, bank, 0
        self._asked: list[Asked] = []
        self._first: CharacterState | None = None
        self._states: CharacterState | None = None

    def render(self, shot) -> Clip:
        """The motion of a `toolkit.shots.Shot`."""
        with torch.no_grad():
            drawn = pose(self.model, self.states(shot), feet=shot.feet, arms=shot.arms)
        return Clip(self.model.layout.skeleton, *drawn, FPS, name=shot.name)

    def states(self, shot, plan: tuple[Course, Heading] | None = None) -> CharacterState:
        """The states of a shot's frames, along the leading axis and without their style."""
        course, heading = plan = shot.plan(self.bank) if plan is None else plan
        style = shot.style(self.bank)
        state, count = first(self.model, [shot], [style], [plan]), len(course.distance) - 1
        if not count:
            raise ValueError(f"{shot.name}: has no frames")

        def ask(frame: int, place: Pair) -> Asked:
            return *command(course, heading, frame, place), style(frame)

        kept = self._unchanged(state, min(count, len(self._asked)), ask)
        asked, states = self._asked[:kept], [_frames(self._states, 0, kept)] if kept else []
        if kept < count:
            def note(frame: int, place: Pair) -> Asked:
                asked.append(ask(kept + frame, place))
                return asked[-1]

            last = _frames(self._states, kept - 1, kept, style(kept)) if kept else state
            states.append(_rolled(self.model, last, count - kept, note))
        self._states = CharacterState(*(torch.cat([getattr(part, field.name) for part in states])
                                        for field in dataclasses.fields(CharacterState)))
        self._first, self._asked, self.kept = state, asked, kept
        return self._states

    def _unchanged(self, first: CharacterState, most: int, ask: Callable[[int, Pair], Asked]) -> int:
        """The number of frames, at most ``most``, whose commands are those of the last render."""
        if not most or not all(torch.equal(getattr(first, name), getattr(self._first, name)) for name in FIELDS):
            return 0
        places = [*self._first.root[:, :2].tolist(), *self._states.root[:most, :2].tolist()]
        for frame, ((velocity, facing, style), place) in enumerate(zip(self._asked[:most], places, strict=False)):
            now = ask(frame, tuple(place))
            if now[:2] != (velocity, facing) or not torch.equal(now[2], style):
                return frame
        return most


def first(model, shots: Sequence, styles, plans: Sequence[tuple[Course, Heading]]) -> CharacterState:
    """Characters at the start of their paths, each as much later in its gait cycle as its seed says.

    ``styles``: functions of the frame, see `Shot.style`. A model without phases has no gait cycle.
    """
    places = [course.curve.point(0.0) for course, _ in plans]
    angles = [heading.angle(0.0, place) for (_, heading), place in zip(plans, places, strict=True)]
    looks = [(math.sin(angle), math.cos(angle)) for angle in angles]
    state = start(model, torch.stack([style(0) for style in styles]), places, looks)
    later = torch.tensor([[math.tau * (shot.seed * GOLDEN % 1)] for shot in shots], dtype=torch.float64)
    if not later.any() or not state.phase.shape[1]:
        return state
    if state.phase.shape[1] == 1:
        return dataclasses.replace(state, phase=(state.phase + later.to(state.phase)) % math.tau)
    s, c = later.sin().to(state.phase), later.cos().to(state.phase)
    x, y = state.phase[:, 0::2], state.phase[:, 1::2]
    return dataclasses.replace(state, phase=torch.stack((c * x - s * y, s * x + c * y), -1).flatten(1))


def _rolled(model, state: CharacterState, frames: int, ask: Callable[[int, Pair], Asked]) -> CharacterState:
    """The states of so many frames, along the leading axis and without their style."""
    if hasattr(type(model), "roll"):
        return model.roll(state, frames, ask)
    states = []
    for frame in range(frames):
        velocity, facing, style = ask(frame, tuple(state.root[0, :2].tolist()))
        with torch.no_grad():
            state = step(model, state.with_style(style), Command(velocity, facing))
        states.append(state)
    return CharacterState(**{name: torch.cat([getattr(s, name) for s in states]) for name in FIELDS},
                          style=state.style.new_empty(frames, 0))


def _frames(states: CharacterState, start: int, stop: int, style: Tensor | None = None) -> CharacterState:
    """Some frames of states along the leading axis; with a ``style [S]``, of one character that goes on from there."""
    parts = {name: getattr(states, name)[start:stop] for name in FIELDS}
    return CharacterState(**parts, style=states.style[start:stop] if style is None else style[None])
