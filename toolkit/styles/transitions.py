"""Styles that change over time (Mason et al. 2022, section 4.4)."""

from bisect import bisect_right
from collections.abc import Callable, Mapping
from itertools import pairwise

import torch
from torch import Tensor

from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS
from toolkit.shots.course import EASINGS


def transition(bank: StyleBank, stops: Mapping[float, str | Mapping[str, float]],
               easing: str | Callable[[float], float] = "smooth") -> Callable[[int], Tensor]:
    """A style that changes from blend to blend, for the parameter ``style`` of `toolkit.runtime.rollout`.

    Parameters
    ----------
    bank
        Bank of the styles.
    stops
        Time in seconds to the style or blend at that time, in order of time. The style is constant before the first and
        after the last stop.
    easing
        One of `EASINGS`, or a function from the time share to the interpolation weight, both from 0 to 1.

    Returns
    -------
    callable
        From the frame number (60 a second) to the style vector ``[D]``.

    Raises
    ------
    ValueError
        If there is no stop, the times do not increase, the easing is unknown, or a blend is invalid (see `StyleBank.blend`).
    """
    seconds = [float(second) for second in stops]
    if not seconds or any(b <= a for a, b in pairwise(seconds)):
        raise ValueError(f"the times of a transition must increase, got {seconds}")
    if not callable(easing) and easing not in EASINGS:
        raise ValueError(f"unknown easing {easing!r}; known: {', '.join(EASINGS)}")
    ease = easing if callable(easing) else EASINGS[easing]
    vectors = [bank.blend({stop: 1.0} if isinstance(stop, str) else stop) for stop in stops.values()]

    def at(frame: int) -> Tensor:
        now = frame / FPS
        leg = bisect_right(seconds, now) - 1
        if leg < 0 or leg == len(seconds) - 1:
            return vectors[max(leg, 0)]
        share = (now - seconds[leg]) / (seconds[leg + 1] - seconds[leg])
        return torch.lerp(vectors[leg], vectors[leg + 1], ease(share))

    return at
