"""Clips of a hundred styles without the recordings: rollouts of the published parameters along
random paths.

Such data favour networks of the same kind. An LPN-FiLM made them, so every frame (without the IK)
can be predicted exactly from the previous frame, its local phases and a FiLM vector. They show how
models handle a hundred styles, but not which model is best for recorded motion.
"""

import dataclasses
import math
import os
from collections.abc import Iterator, Sequence

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


def write(folder: str | os.PathLike, out: str | os.PathLike, styles: Sequence[str] | None = None,
          seconds: float = 12.0,
          seed: int = 0) -> list[str]:
    """Write rollouts of the published parameters in the layout of 100STYLE, for ``--data 100style
    --root OUT``.

    Parameters
    ----------
    folder
        The published parameters (`toolkit.training.published.load`).
    out
        Output folder, without a dataset.
    styles
        Names; by default all hundred.
    seconds
        Length of each clip; a style has one clip per key of `GAITS`.
    seed
        Seed of the paths, which are different for every style.

    Returns
    -------
    list of str
        Clips that were not written because the character fell.
    """
    fallen: list[str] = []
    names = list(styles or published.STYLES)
    about = "rollout of the published parameters of LPN-FiLM"
    infos = [StyleInfo(name, about, symmetric=False, stochastic=False,
                       notes="computed, not recorded") for name in names]

    def standing() -> Iterator[Clip]:
        for clip in roll_out(folder, names, seconds, seed):
            if metrics.upright(clip):
                yield clip
            else:
                fallen.append(f"{clip.style} {clip.gait}")

    style100.save(standing(), out, infos)
    return fallen


def roll_out(folder: str | os.PathLike, styles: Sequence[str], seconds: float = 12.0,
             seed: int = 0) -> Iterator[Clip]:
    """Clips of styles, gait by gait; all styles of a gait walk in one crowd, each along its own
    path.
    """
    model, bank = published.load(folder)
    vectors, warm = torch.stack([bank[style] for style in styles]), round(WARM_UP * FPS)
    for number, gait in enumerate(GAITS):
        orders = commands(gait, len(styles), warm + round(seconds * FPS),
                          splits.generator(seed, number))
        states = [dataclasses.replace(s, style=s.style[:, :0], history=s.history[:, -1:])
                  for s in runtime.states(model, orders, vectors, progress=True)][warm:]
        for i, style in enumerate(tqdm(styles, desc=gait, unit="clip", disable=None)):
            yield runtime.record(model, states, character=i).replace(style=style, gait=gait,
                                                                     name=f"{style} {gait}")


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
