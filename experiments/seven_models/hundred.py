"""A hundred-style set where the recorded one is not at hand: the published parameters, rolled out along varied paths.

Such data favour their own kind of network. An LPN-FiLM made them: every frame is, but for the IK, what one can predict
exactly from the frame before, its local phases and a FiLM vector, with the artifacts of one and without the surprises of a
person. So they tell how models cope with a hundred styles, and not which one models people best.
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
    "BW": (math.pi, (0.4, 0.9)),
    "SW": (math.pi / 2, (0.4, 0.8)),
    "TR1": (0.0, (-0.5, 2.5)),
}  # angle from facing to going, and range of speeds, m/s; below 0 stands
WARM_UP = 2.0  # seconds from standing on that are left out
LEG = (1.2, 3.0)  # seconds of one speed and one rate of turning
TURNING = 1.2  # radians per second, at most


def write(folder: str | os.PathLike, out: str | os.PathLike, styles: Sequence[str] | None = None, seconds: float = 12.0,
          seed: int = 0) -> list[str]:
    """Roll the published parameters out and write them as 100STYLE is laid out, for ``--data 100style --root OUT``.

    Parameters
    ----------
    folder
        The published parameters (`toolkit.published.load`).
    out
        Folder to write; it must not hold a dataset.
    styles
        Which; all hundred where not given.
    seconds
        Length of each of a style's clips, one per key of `GAITS`.
    seed
        Of the paths; every style has its own.

    Returns
    -------
    list of str
        Clips that were left out, because the character fell.
    """
    fallen: list[str] = []
    names = list(styles or published.STYLES)
    about = "rolled out of the published parameters of LPN-FiLM"
    infos = [StyleInfo(name, about, symmetric=False, stochastic=False, notes="computed, not recorded") for name in names]

    def standing() -> Iterator[Clip]:
        for clip in roll_out(folder, names, seconds, seed):
            if metrics.upright(clip):
                yield clip
            else:
                fallen.append(f"{clip.style} {clip.gait}")

    style100.save(standing(), out, infos)
    return fallen


def roll_out(folder: str | os.PathLike, styles: Sequence[str], seconds: float = 12.0, seed: int = 0) -> Iterator[Clip]:
    """Clips of styles, gait by gait; all styles of a gait walk as one crowd, each along a path of its own."""
    model, bank = published.load(folder)
    vectors, warm = torch.stack([bank[style] for style in styles]), round(WARM_UP * FPS)
    for number, gait in enumerate(GAITS):
        orders = commands(gait, len(styles), warm + round(seconds * FPS), splits.generator(seed, number))
        states = [dataclasses.replace(s, style=s.style[:, :0], history=s.history[:, -1:])
                  for s in runtime.states(model, orders, vectors, progress=True)][warm:]
        for i, style in enumerate(tqdm(styles, desc=gait, unit="clip", disable=None)):
            yield runtime.record(model, states, character=i).replace(style=style, gait=gait, name=f"{style} {gait}")


def commands(gait: str, count: int, frames: int, draw: torch.Generator) -> list[Command]:
    """Commands for a crowd: random speeds and curves, each kept for some seconds."""
    angle, (slowest, fastest) = GAITS[gait]
    side = 1.0 if gait != "SW" else torch.where(torch.rand(count, generator=draw) < 0.5, -1.0, 1.0)
    speeds, rates = (_steps(count, frames, draw, *limits) for limits in ((slowest, fastest), (-TURNING, TURNING)))
    facing = rates.cumsum(0) / FPS
    going = facing + angle * side
    velocity = speeds.clamp_min(0.0)[..., None] * torch.stack((going.sin(), going.cos()), -1)
    return [Command(v, f) for v, f in zip(velocity, torch.stack((facing.sin(), facing.cos()), -1), strict=True)]


def _steps(count: int, frames: int, draw: torch.Generator, low: float, high: float) -> Tensor:
    """Random numbers ``[frames, count]`` between two limits that change now and then."""
    rows = torch.empty(frames, count)
    for i in range(count):
        at = 0
        while at < frames:
            length, value = torch.rand(2, generator=draw).tolist()
            end = at + round((LEG[0] + (LEG[1] - LEG[0]) * length) * FPS)
            rows[at:end, i] = low + (high - low) * value
            at = end
    return rows
