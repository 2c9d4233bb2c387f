"""A crowd: many characters in the compiled runtime, each in a style blend, who keep apart."""

import math
import random
import time
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice

import torch
from torch import Tensor

from toolkit import runtime
from toolkit.extra.shots.keys import SpeedKey, StyleKey
from toolkit.extra.shots.scene import Scene
from toolkit.extra.shots.shot import Shot
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.motion.tensors import summary
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS, pose

# metres: innermost radius, distance of rings, distance on a ring
INNER, RING, ROOM = 2.0, 1.35, 2.0
# metres at the start; rows of a stream; metres before the crossing; apart
SPACE, ROWS, BEFORE, APART = 2.4, 4, 6.0, 1.2
SLOWEST, FASTEST = 0.6, 1.3  # m/s
BODIES = 0.4  # metres between two bodies


@dataclass(frozen=True, eq=False)
class Crowd:
    """Recorded motion of N characters.

    Parameters
    ----------
    clips : one per character
    seconds : median processing time of a frame of all: commands, avoidance, step and pose
    """

    clips: list[Clip]
    seconds: float
    __repr__ = summary

    @property
    def report(self) -> str:
        """The processing time as text."""
        many = len(self.clips)
        return (f"{many} characters, {len(self.clips[0])} frames: {1e3 * self.seconds:.2f} ms a "
                f"frame, {1e6 * self.seconds / many:.0f} µs each, {1 / FPS / self.seconds:.1f} "
                "times real time")


def streams(bank: StyleBank, characters: int = 100, seed: int = 0, *,
            styles: Sequence[str] | None = None, apart: float = APART) -> Scene:
    """A scene of two streams that cross at a right angle: half walk to +x, half to +z.

    Each character has a blend of two of ``styles``, by default of all of the bank. They keep
    ``apart`` metres, see `Scene`.
    """
    if characters < 1:
        raise ValueError(f"characters must be 1 or more, got {characters}")
    rng, shots = random.Random(seed), []
    blends = _blends(list(styles or bank), characters, torch.Generator().manual_seed(seed))
    long = math.ceil(characters / (2 * ROWS))
    for k, blend in enumerate(blends):
        column, row = divmod(k // 2, ROWS)
        place = -BEFORE - SPACE * column, SPACE * (row - (ROWS - 1) / 2)
        along, aside = (value + rng.uniform(-0.15, 0.15) for value in place)
        ends = [(round(at, 2), round(aside, 2))
                for at in (along, along + SPACE * (long + ROWS) + 2 * BEFORE)]
        path = ends if k % 2 else [(aside, at) for at, aside in ends]
        speed = min(max(bank.speed(blend), SLOWEST), FASTEST)
        shots.append(Shot(path, [StyleKey(0, blend)], [SpeedKey(0, round(speed, 2))], seed=k,
                          name=_named(blend)))
    return Scene(shots, apart)


def walk(model, bank, characters: int = 100, seconds: float = 10.0, *, seed: int = 0,
         progress: bool = False) -> Crowd:
    """Let two `streams` of characters cross, for so many seconds at most.

    ``model``: an LPN-FiLM, plain or compiled. ``progress`` shows a bar.
    """
    compiled = model if hasattr(type(model), "roll") else runtime.compile(model)
    scene = streams(bank, characters, seed).spaced(compiled, bank, BODIES)
    poses, taken, began = [], [], time.perf_counter()
    with torch.no_grad():
        frames = islice(scene.states(compiled, bank), round(seconds * FPS))
        for state in progress_bar(frames, desc="crowd", unit="frame", show=progress):
            poses.append(pose(compiled, state))
            taken.append(time.perf_counter() - began)
            began = time.perf_counter()
    rotations, roots = (torch.stack(column, 1) for column in zip(*poses, strict=True))
    clips = [Clip(compiled.layout.skeleton, r, p, FPS, style=shot.name, name="crowd")
             for r, p, shot in zip(rotations, roots, scene.shots, strict=True)]
    return Crowd(clips, float(torch.tensor(taken).median()))


def places(characters: int) -> tuple[Tensor, Tensor, Tensor]:
    """Radius, angle and direction (1 or -1) of each character, ``[N]``, on rings of one density."""
    radii = INNER + RING * torch.arange(characters)
    rings = 1 + int((math.tau * radii.cumsum(0) < ROOM * characters).sum())
    radii = radii[:rings]
    ends = (characters * radii.cumsum(0) / radii.sum()).round().long()
    ring = torch.bucketize(torch.arange(characters), ends, right=True)
    first = torch.cat((torch.zeros(1, dtype=torch.long), ends))
    on_ring = (first[1:] - first[:-1])[ring]
    angle = math.tau * (torch.arange(characters) - first[ring]) / on_ring + ring
    return radii[ring], angle, 1.0 - 2.0 * (ring % 2)


def _named(blend: dict[str, float]) -> str:
    return " + ".join(f"{name} {share:.0%}" for name, share in blend.items())


def _blends(names: list[str], characters: int, seeded: torch.Generator) -> list[dict[str, float]]:
    """A random blend of two styles for each character."""
    blends = []
    for _ in range(characters):
        pair = torch.randperm(len(names), generator=seeded)[:2].tolist()
        share = float(torch.rand((), generator=seeded))
        shares = (share, 1 - share) if len(pair) > 1 else (1.0,)
        blends.append({names[i]: part for i, part in zip(pair, shares, strict=True)})
    return blends
