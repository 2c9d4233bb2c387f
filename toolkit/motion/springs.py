"""Critically damped springs. Tensors of any shape.

Source: Holden, "Spring-It-On: The Game Developer's Spring-Roll-Call", 2021.
"""

import math

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
