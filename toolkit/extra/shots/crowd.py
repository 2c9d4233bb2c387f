"""Places of many characters: two streams that cross, rings on which a page's crowd walks."""

import math
import random
from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.extra.shots.keys import SpeedKey, StyleKey
from toolkit.extra.shots.scene import Scene
from toolkit.extra.shots.shot import Shot
from toolkit.networks.bank import StyleBank

# metres: innermost radius, distance of rings, distance on a ring
INNER, RING, ROOM = 2.0, 1.35, 2.0
# metres at the start; rows of a stream; metres before the crossing; apart
SPACE, ROWS, BEFORE, APART = 2.4, 4, 6.0, 1.2
SLOWEST, FASTEST = 0.6, 1.3  # m/s


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
