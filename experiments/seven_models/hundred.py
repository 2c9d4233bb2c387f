"""Clips of a hundred styles without the recordings: rollouts of the published parameters along
random paths.

Such data favour networks of the same kind. An LPN-FiLM made them, so every frame (without the IK)
can be predicted exactly from the previous frame, its local phases and a FiLM vector. They show how
models handle a hundred styles, but not which model is best for recorded motion.
"""

import dataclasses
import math
from collections.abc import Iterator
from pathlib import Path

import torch
from torch import Tensor
from tqdm import tqdm

from toolkit import published, runtime
from toolkit.datasets import style100
from toolkit.datasets.style100 import StyleInfo
from toolkit.evaluation import metrics
from toolkit.features import splits
from toolkit.motion import Clip
from toolkit.runtime import FPS, Command

GAITS = {
    "FW": (0.0, (0.5, 1.6)),
    "FR": (0.0, (1.6, 3.0)),
    "BW": (math.pi, (0.4, 0.9)),
    "BR": (math.pi, (0.9, 1.8)),
    "SW": (math.pi / 2, (0.4, 0.8)),
    "SR": (math.pi / 2, (0.8, 1.6)),
    "ID": (0.0, (-1.0, 0.0)),
    "TR1": (0.0, (-0.5, 2.5)),
}  # angle from facing to velocity, and range of speeds, m/s; negative speeds are standing
WARM_UP = 2.0  # seconds at the start that are removed
SEGMENT = (1.2, 3.0)  # seconds of constant speed and turning rate
TURNING = 1.2  # radians per second, highest turning rate


def write(folder: Path, out: Path, seconds: float) -> list[str]:
    """Write rollouts of the published parameters in a folder, in the layout of 100STYLE.

    A style has one clip of so many seconds for each of `GAITS`. Returns the style and gait of clips
    that were not written because the character fell.
    """
    fallen: list[str] = []
    model, bank = published.load(folder)
    about = "rollout of the published parameters of LPN-FiLM"
    infos = [StyleInfo(name, about, symmetric=False, stochastic=False,
                       notes="computed, not recorded") for name in bank.names]

    def standing() -> Iterator[Clip]:
        """The clips; all styles of a gait walk in one crowd, each along its own path."""
        warm = round(WARM_UP * FPS)
        for number, gait in enumerate(GAITS):
            orders = commands(gait, len(bank), warm + round(seconds * FPS),
                              splits.generator(0, number))
            states = [dataclasses.replace(s, style=s.style[:, :0], history=s.history[:, -1:])
                      for s in runtime.states(model, orders, bank.vectors, progress=True)][warm:]
            for i, style in enumerate(tqdm(bank.names, desc=gait, unit="clip", disable=None)):
                clip = runtime.record(model, states, character=i).replace(
                    style=style, gait=gait, name=f"{style} {gait}")
                if metrics.upright(clip):
                    yield clip
                else:
                    fallen.append(f"{style} {gait}")

    style100.save(standing(), out, infos)
    return fallen


def commands(gait: str, count: int, frames: int, draw: torch.Generator) -> list[Command]:
    """Commands for a crowd: random speeds and turning rates that are constant for some seconds."""
    angle, (slowest, fastest) = GAITS[gait]
    side = 1.0 if gait not in ("SW", "SR") else torch.where(torch.rand(count, generator=draw) < 0.5,
                                                            -1.0, 1.0)
    turning = 0.0 if gait == "ID" else TURNING
    speeds, rates = (_steps(count, frames, draw, *limits)
                     for limits in ((slowest, fastest), (-turning, turning)))
    facing = rates.cumsum(0) / FPS
    going = facing + angle * side
    velocity = speeds.clamp_min(0.0)[..., None] * torch.stack((going.sin(), going.cos()), -1)
    return [Command(v, f)
            for v, f in zip(velocity, torch.stack((facing.sin(), facing.cos()), -1), strict=True)]


def _steps(count: int, frames: int, draw: torch.Generator, low: float, high: float) -> Tensor:
    """Piecewise constant random numbers ``[frames, count]`` between two limits."""
    rows = torch.empty(frames, count)
    for i in range(count):
        at = 0
        while at < frames:
            length, value = torch.rand(2, generator=draw).tolist()
            end = at + round((SEGMENT[0] + (SEGMENT[1] - SEGMENT[0]) * length) * FPS)
            rows[at:end, i] = low + (high - low) * value
            at = end
    return rows
