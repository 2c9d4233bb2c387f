"""Critically damped springs, and inertialisation with them. Tensors of any shape.

Source: Holden, "Spring-It-On: The Game Developer's Spring-Roll-Call", 2021; Bollo,
"Inertialization", GDC 2018.
"""

import math

import torch
from torch import Tensor


def spring(offset: Tensor, velocity: Tensor, rate: float, seconds: float) -> tuple[Tensor, Tensor]:
    """Offset from the rest position and its velocity after any time; no overshoot from rest.

    x(t) = (x₀ + (v₀ + λ x₀) t) exp(−λ t) solves ẍ = −2 λ ẋ − λ² x exactly, so that two steps of t /
    2 equal one of t.

    Parameters
    ----------
    offset, velocity
        Of any unit, and the same per second.
    rate
        λ, per second: after 1 / λ seconds from rest, 74 % of the offset is left; after 5 / λ, 4 %.
    seconds
        Time step.
    """
    push, fade = velocity + rate * offset, math.exp(-rate * seconds)
    return fade * (offset + push * seconds), fade * (velocity - rate * push * seconds)


def inertialise(before: Tensor, after: Tensor, fps: float, rate: float) -> Tensor:
    """Frames ``after [F, ...]`` that continue ``before [E, ...]`` without a jump.

    The differences of value and velocity at the cut become an offset that decays as a `spring`.
    After the cut only the new motion is needed, so that a transition costs no second evaluation.
    Both parts have two frames or more.
    """
    velocity = (before[-1] - before[-2]) * fps
    offset = before[-1] + velocity / fps - after[0]
    drift = velocity - (after[1] - after[0]) * fps
    return torch.stack([frame + spring(offset, drift, rate, k / fps)[0]
                        for k, frame in enumerate(after)])
