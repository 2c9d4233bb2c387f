"""A crowd: many characters at once through the compiled runtime, each with its own style blend, walking on rings."""

import math
import time
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.motion.tensors import summary
from toolkit.runtime.compiled import CompiledModel, compile
from toolkit.runtime.frame import FPS, pose, start, step
from toolkit.runtime.steering import LOOKAHEAD, towards

INNER, APART, ROOM = 2.0, 1.35, 2.0  # metres: innermost radius, distance of rings, distance on a ring
SETTLED = 3.0  # seconds of walking before the recording starts


@dataclass(frozen=True, eq=False)
class Crowd:
    """Recorded motion of N characters.

    Parameters
    ----------
    clips
        One per character.
    blends
        Style name to share, one blend per character.
    seconds
        Median processing time of one frame for all characters: commands, step and pose.
    """

    clips: list[Clip]
    blends: list[dict[str, float]]
    seconds: float
    __repr__ = summary

    @property
    def report(self) -> str:
        """The processing time as text."""
        many = len(self.clips)
        return (f"{many} characters, {len(self.clips[0])} frames: {1e3 * self.seconds:.2f} ms a frame, "
                f"{1e6 * self.seconds / many:.0f} µs each, {1 / FPS / self.seconds:.1f} times real time")


def walk(model, bank, characters: int = 100, seconds: float = 10.0, *, speed: float | None = None, seed: int = 0,
         threads: int = 1, progress: bool = False) -> Crowd:
    """Let characters walk on rings around the origin; neighbouring rings walk in opposite directions.

    Parameters
    ----------
    model, bank
        An LPN-FiLM, plain or compiled, and its styles.
    characters
        Number of characters.
    seconds
        Recorded time, after `SETTLED` seconds that are not recorded.
    speed
        Metres per second; by default the mean, in each ring, of the natural speeds.
    seed
        Random seed of the blends.
    threads
        Number of processor threads.
    progress
        Show a bar.
    """
    if characters < 1:
        raise ValueError(f"characters must be 1 or more, got {characters}")
    compiled = model if isinstance(model, CompiledModel) else compile(model, threads=threads)
    radii, angles, ways = places(characters)
    blends = _blends(list(bank), characters, torch.Generator().manual_seed(seed))
    speeds = torch.tensor([bank.speed(blend) if speed is None else speed for blend in blends])
    for radius in radii.unique():
        speeds[radii == radius] = speeds[radii == radius].mean()
    position, facing = _on_ring(radii, angles, ways)
    state = start(compiled, torch.stack([bank.blend(blend) for blend in blends]), position, facing)
    poses, taken = [], []
    with torch.no_grad():
        frames = range(round((SETTLED + seconds) * FPS))
        for frame in progress_bar(frames, desc="crowd", unit="frame", show=progress):
            began = time.perf_counter()
            goal, tangent = _on_ring(radii, angles + ways * speeds / radii * (frame / FPS + LOOKAHEAD), ways)
            state = step(compiled, state, towards(state, goal, tangent, speeds[:, None]))
            drawn = pose(compiled, state)
            taken.append(time.perf_counter() - began)
            if frame >= SETTLED * FPS:
                poses.append(drawn)
    rotations, roots = (torch.stack(column, 1) for column in zip(*poses, strict=True))
    names = (" + ".join(f"{name} {share:.0%}" for name, share in blend.items()) for blend in blends)
    skeleton = compiled.layout.skeleton
    clips = [Clip(skeleton, r, p, FPS, style=name, name="crowd") for r, p, name in zip(rotations, roots, names, strict=True)]
    return Crowd(clips, blends, float(torch.tensor(taken).median()))


def places(characters: int) -> tuple[Tensor, Tensor, Tensor]:
    """Radius, angle and walking direction (1 or -1) of each character, ``[N]``; all rings have the same density."""
    radii = INNER + APART * torch.arange(characters)
    rings = 1 + int((math.tau * radii.cumsum(0) < ROOM * characters).sum())
    radii = radii[:rings]
    ends = (characters * radii.cumsum(0) / radii.sum()).round().long()
    ring = torch.bucketize(torch.arange(characters), ends, right=True)
    first = torch.cat((torch.zeros(1, dtype=torch.long), ends))
    on_ring = (first[1:] - first[:-1])[ring]
    angle = math.tau * (torch.arange(characters) - first[ring]) / on_ring + ring
    return radii[ring], angle, 1.0 - 2.0 * (ring % 2)


def _on_ring(radii: Tensor, angles: Tensor, ways: Tensor) -> tuple[Tensor, Tensor]:
    """Position (x, z) and walking direction at angles on rings, each ``[N, 2]``."""
    out = torch.stack((angles.sin(), angles.cos()), -1)
    return radii[:, None] * out, ways[:, None] * torch.stack((out[:, 1], -out[:, 0]), -1)


def _blends(names: list[str], characters: int, seeded: torch.Generator) -> list[dict[str, float]]:
    """A random blend of two styles for each character."""
    blends = []
    for _ in range(characters):
        pair = torch.randperm(len(names), generator=seeded)[:2].tolist()
        share = float(torch.rand((), generator=seeded))
        blends.append({names[i]: part for i, part in zip(pair, (share, 1 - share), strict=False)} if len(pair) > 1 else
                      {names[0]: 1.0})
    return blends
