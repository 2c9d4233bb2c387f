"""The states of a character that walks a shot."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import torch
from torch import Tensor

from toolkit.extra.shots.following import Course, Heading, Pair
from toolkit.runtime import CharacterState, Command, start, step
from toolkit.runtime.recording import joined

GOLDEN = (math.sqrt(5) - 1) / 2  # the share of a cycle by which the next seed starts later
Asked = tuple[Pair, Pair, Tensor]  # velocity, facing and style of a frame


def first(model, shots: Sequence, styles,
          plans: Sequence[tuple[Course, Heading]]) -> CharacterState:
    """Characters at the start of their paths, each as much later in its gait cycle as its seed
    says.

    ``styles``: functions of the frame, see `Shot.style`. A model without phases has no gait cycle.
    """
    places = [course.curve.point(0.0) for course, _ in plans]
    angles = [heading.angle(0.0, place) for (_, heading), place in zip(plans, places, strict=True)]
    looks = [(math.sin(angle), math.cos(angle)) for angle in angles]
    state = start(model, torch.stack([style(0) for style in styles]), places, looks)
    later = [[math.tau * (shot.seed * GOLDEN % 1)] for shot in shots]
    later = torch.tensor(later, dtype=torch.float64)
    if not later.any() or not state.phase.shape[1]:
        return state
    if state.phase.shape[1] == 1:  # the one angle of a global phase
        return replace(state, phase=(state.phase + later.to(state.phase)) % math.tau)
    # local phases are vectors: all turn by the same angle
    vectors = torch.view_as_complex(state.phase.unflatten(1, (-1, 2)))
    turned = vectors * torch.exp(1j * later).to(vectors)
    return replace(state, phase=torch.view_as_real(turned).flatten(1))


def rolled(model, state: CharacterState, frames: int,
           ask: Callable[[int, Pair], Asked]) -> CharacterState:
    """The states of so many frames, as `toolkit.runtime.recording.joined`."""
    if hasattr(type(model), "roll"):  # compiled: the loop over frames, too
        return model.roll(state, frames, ask)
    states = []
    for frame in range(frames):
        velocity, facing, style = ask(frame, tuple(state.root[0, :2].tolist()))
        with torch.no_grad():
            state = step(model, state.with_style(style), Command(velocity, facing))
        states.append(state)
    return joined(states)
