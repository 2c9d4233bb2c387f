"""Life (ours): slow changes of the style vector, so that a character does not repeat one cycle.

Without noise, the closed loop of the published network falls into one cycle: what a person does
from step to step, and from second to second, is lost. A style vector that wanders a little brings
it back, and the feet hardly suffer, because it is smooth and FiLM's scales stay. Networks trained
on recordings without pose mix-up need none.
"""

import math
from collections.abc import Callable
from typing import TypeAlias

import numpy as np
import torch
from torch import Tensor

from toolkit.motion import trajectory

PERIOD = trajectory.FPS  # frames from one random vector to the next
Styles: TypeAlias = Tensor | Callable[[int], Tensor]


def alive(style: Styles, amount: float, seed: int = 0) -> Styles:
    """A style that wanders: FiLM's shifts β become ``β · (1 + amount · y(t))``, its scales γ stay.

    y is smooth noise of mean 0 and deviation 1. γ and β of both layers are the quarters of a style.

    Parameters
    ----------
    style : Tensor [S] or [B, S], or a function of the frame number that returns one
    amount
        Deviation of the factor; with 0, ``style`` itself is returned. The published network looks
        alive at 0.25. For models with FiLM only.
    seed
        Of the noise. Rows of ``[B, S]`` have seeds of their own: ``seed``, ``seed + 1``, …
    """
    if not 0 <= amount < 1:
        raise ValueError(f"the amount of life must be in [0, 1), got {amount}")
    if amount == 0:
        return style
    kept: dict[int, Tensor] = {}

    def key(number: int, like: Tensor) -> Tensor:
        if number not in kept:
            kept.pop(number - 2, None)  # two are in use
            size = like.shape[-1]
            # 0 in the quarters γ1 and γ2, 1 in β1 and β2
            shifts = np.arange(size) * 4 // size % 2
            rows = [shifts * uniform(size, number, seed + row)
                    for row in range(like.shape[:-1].numel())]
            kept[number] = torch.from_numpy(np.stack(rows)).to(like).reshape(like.shape)
        return kept[number]

    def wandering(frame: int) -> Tensor:
        base = style(frame) if callable(style) else style
        number, rest = divmod(frame, PERIOD)
        share = rest / PERIOD
        angle = math.pi / 2 * share * share * (3 - 2 * share)
        noise = math.cos(angle) * key(number, base) + math.sin(angle) * key(number + 1, base)
        return base * (1 + amount * noise)

    return wandering


def uniform(size: int, number: int, seed: int) -> np.ndarray:
    """``size`` random numbers of mean 0 and deviation 1, by their place, ``number`` and ``seed``.

    A hash of 32-bit integers, because pages compute the same ones (`scene/life.js`).
    """
    key = np.array([number * 0x9E3779B1 + seed * 0x85EBCA77 & 0xFFFFFFFF], np.uint32)
    x = np.arange(size, dtype=np.uint32) * np.uint32(0xC2B2AE3D) + key
    for shift, factor in ((16, 0x7FEB352D), (15, 0x846CA68B)):
        x = (x ^ (x >> np.uint32(shift))) * np.uint32(factor)
    x ^= x >> np.uint32(16)
    return math.sqrt(3) * (x / 2**31 - 1)
