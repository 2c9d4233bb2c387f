"""Styles that change over time (Mason et al. 2022, section 4.4)."""

import math
from collections.abc import Callable, Mapping
from itertools import pairwise

import numpy as np
import torch
from torch import Tensor

from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS

#: Interpolation weight as a function of the time share, both from 0 to 1.
EASINGS: dict[str, Callable[[float], float]] = {
    "linear": lambda t: t,
    "smooth": lambda t: t * t * (3 - 2 * t),  # starts and ends slowly
    "smoother": lambda t: t**3 * (t * (6 * t - 15) + 10),  # and with zero acceleration there
    "in": lambda t: t * t,  # starts slowly
    "out": lambda t: t * (2 - t),  # ends slowly
    "jump": lambda t: float(t >= 1),  # constant, then changes at once
}


def transition(bank: StyleBank, stops: Mapping[float, str | Mapping[str, float]],
               easing: str = "smooth") -> Callable[[int], Tensor]:
    """A style that changes from blend to blend, for ``style`` of `toolkit.runtime.rollout`.

    ``stops`` are times in seconds to the style or blend at that time, in order of time. The style
    is constant before the first and after the last stop, and changes between them by the
    ``easing``, one of `EASINGS`. The result is a function of the frame number (60 a second), which
    gives the style vector ``[D]``.

    ValueError if there is no stop, the times do not increase, the easing is unknown, or a blend is
    invalid (see `StyleBank.blend`).
    """
    seconds = [float(second) for second in stops]
    if not seconds or any(b <= a for a, b in pairwise(seconds)):
        raise ValueError(f"the times of a transition must increase, got {seconds}")
    if easing not in EASINGS:
        raise ValueError(f"unknown easing {easing!r}; known: {', '.join(EASINGS)}")
    blends = [{stop: 1.0} if isinstance(stop, str) else stop for stop in stops.values()]
    vectors = [bank.blend(blend) for blend in blends]

    def at(frame: int) -> Tensor:
        place = float(np.interp(frame / FPS, seconds, range(len(seconds))))
        before, after = vectors[math.floor(place)], vectors[math.ceil(place)]
        return torch.lerp(before, after, EASINGS[easing](place % 1))

    return at
