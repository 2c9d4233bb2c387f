"""The procedural dataset: stylised locomotion from footsteps, with known contacts and phases.

It uses no recorded motion: a path is planned, then the footsteps along it, then the body over them
(docs/procedural.md). `toolkit.datasets.procedural_styles` has the parameters of a style.

Models were trained on these clips, and the same seed gives the same bytes. So the order of random
numbers and of operations here and in the modules ``procedural_…`` must stay as it is.
"""

import math
import os
import zlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from torch import Tensor

from toolkit.datasets.procedural_body import SKELETON, pose
from toolkit.datasets.procedural_steps import FPS, Plan, Truth, record, smooth, smooth_noise
from toolkit.datasets.procedural_styles import STYLES, Arm, Leg, Style
from toolkit.datasets.style100 import StyleInfo, save
from toolkit.datasets.takes import Names, check_names
from toolkit.io.files import atomic_write
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, rotations as R

__all__ = ["GAITS", "SKELETON", "STYLES", "Arm", "Leg", "Style", "Truth", "generate", "load",
           "truth", "write"]

#: Forwards, backwards and sidestep walk and run, idle, and a transition through all of them.
GAITS = ("FW", "BW", "FR", "BR", "SW", "SR", "ID", "TR1")
MARGIN = 60  # frames planned before and after the clip, so that it starts and ends in full motion
TRANSITION = 9.6  # usual seconds of a transition through walk, turn, run, walk, another direction


def load(styles: Names = None, gaits: Names = None, seconds: float = 8.0,
         seed: int = 0) -> list[Clip]:
    """One clip of every style in every gait, by `generate`; names in `STYLES` and `GAITS`."""
    return [generate(style, gait, seconds, seed) for style, gait in _pairs(styles, gaits)]


def generate(style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0,
             path: Tensor | None = None) -> Clip:
    """A clip in a style, at 60 Hz.

    Parameters
    ----------
    style, gait
        A name in `STYLES` or a `Style`, and one of `GAITS`, which selects the speed and direction
        of the path.
    seconds, seed
        Length; seed of the path and of the style's noise.
    path : Tensor [F, 3], optional
        Path to follow instead: x, z in metres and facing in radians (0 is +Z, positive turns left)
        at 60 Hz.

    Raises
    ------
    ValueError
        If style or gait is unknown, or the clip has fewer than two frames.
    """
    return truth(style, gait, seconds, seed, path)[0]


def truth(style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0,
          path: Tensor | None = None) -> tuple[Clip, Truth]:
    """The clip of `generate`, with its true contacts, phases and frequencies."""
    label = style if isinstance(style, str) else "custom"
    if isinstance(style, str):
        check_names([style], STYLES, "style", "procedural")
        style = STYLES[style]
    check_names([gait], GAITS, "gait", "procedural")
    frames = round(seconds * FPS) if path is None else len(path)
    if frames < 2:
        raise ValueError(f"a clip needs at least two frames, got {frames}")
    rng = np.random.default_rng([seed, zlib.crc32(f"{label} {gait}".encode())])
    if path is None:
        root = _random_path(style, gait, frames, rng)
    else:
        root = np.asarray(path, dtype=np.float64)

    # the path goes on beyond both ends, by its point reflection or, if it is short, straight
    if frames > MARGIN:
        margins = ((MARGIN, MARGIN), (0, 0))
        padded = np.pad(root, margins, mode="reflect", reflect_type="odd")
    else:
        ahead = np.arange(1, MARGIN + 1)[:, None]
        before = root[0] - ahead[::-1] * (root[1] - root[0])
        after = root[-1] + ahead * (root[-1] - root[-2])
        padded = np.concatenate((before, root, after))

    # footsteps, then the body over them
    plan = Plan(style, padded, rng)
    feet = {side: plan.foot(side) for side in plan.stepping}
    rotations, positions = pose(plan, feet)
    known = record(plan, feet)
    keep = slice(MARGIN, MARGIN + frames)
    name = f"procedural {label} {gait} seed {seed}"
    clip = Clip(SKELETON, R.unroll(rotations[keep]), positions[keep], FPS, label, gait, name)
    return clip, Truth(known.contacts[keep], known.phase[keep], known.frequency[keep])


def write(folder: str | os.PathLike, styles: Names = None, gaits: Names = None,
          seconds: float = 8.0, seed: int = 0) -> None:
    """Write the clips of `load` in the layout of 100STYLE, with the truth of each clip.

    The styles in the files are called ``Procedural<Style>``. ``<Style>_<GAIT>.npz`` holds the
    arrays of `Truth` of ``<Style>_<GAIT>.bvh``. Raises what `load` and `style100.save` raise.
    """
    folder = Path(folder)

    def clips() -> Iterator[Clip]:
        pairs = _pairs(styles, gaits)
        for style, gait in progress_bar(pairs, desc="procedural", unit="clip"):
            clip, known = truth(style, gait, seconds, seed)
            clip = clip.replace(style=f"Procedural{style}")
            with atomic_write(folder / f"{clip.style}_{gait}.npz") as file:
                arrays = {name: value.numpy() for name, value in vars(known).items()}
                np.savez_compressed(file, **arrays)
            yield clip

    infos = [StyleInfo(f"Procedural{name}", f"procedural: {name}", style.symmetric,
                       style.stagger > 0, "") for name, style in STYLES.items()]
    save(clips(), folder, infos)


def _pairs(styles: Names, gaits: Names) -> list[tuple[str, str]]:
    styles = check_names(list(STYLES) if styles is None else styles, STYLES, "style", "procedural")
    gaits = check_names(list(GAITS) if gaits is None else gaits, GAITS, "gait", "procedural")
    return [(style, gait) for style in styles for gait in gaits]


def _random_path(style: Style, gait: str, frames: int, rng: np.random.Generator) -> np.ndarray:
    """Root path ``[frames, 3]`` (x, z, facing) of a gait, which turns to either side in turn."""
    # parts of constant speed and turn, until the time is filled
    parts: list[tuple[float, np.ndarray, float]] = []
    sign, total, seconds = rng.choice([-1.0, 1.0]), 0.0, frames / FPS
    while total < seconds - 1e-6:
        new = _parts(style, gait, sign, seconds, rng)
        sign = -sign
        parts += new
        total += sum(part[0] for part in new)

    # left and forward velocity and turning of each frame
    duration, velocity, turn = map(np.array, zip(*parts, strict=True))
    edges = np.concatenate(([0.0], np.cumsum(duration))) * FPS
    at = np.searchsorted(edges, np.arange(frames), side="right") - 1
    velocity, rate = velocity[at] * style.speed, (turn / duration)[at]

    # random wandering, but not while the character stands
    pace = np.abs(velocity).sum(1) / style.speed
    going = np.minimum(pace, 1)
    wander = 0.35 * style.noise + 0.5 * style.stagger
    rate = rate + wander * going * smooth_noise(rng, frames, 35, 1)[:, 0]
    drift = style.speed * (0.12 * style.noise + 0.2 * style.stagger)
    velocity = velocity + drift * going[:, None] * smooth_noise(rng, frames, 30, 2)

    # from velocities in the character's frame to places in the world
    velocity, rate = smooth(velocity, 13), smooth(rate, 11)
    facing = rng.uniform(-math.pi, math.pi) + np.cumsum(rate) / FPS
    c, s = np.cos(facing), np.sin(facing)
    left, ahead = velocity.T
    world = np.stack((left * c + ahead * s, -left * s + ahead * c), 1) / FPS
    return np.concatenate((np.cumsum(world, 0), facing[:, None]), 1)


def _parts(style: Style, gait: str, sign: float, seconds: float,
           rng: np.random.Generator) -> list[tuple[float, np.ndarray, float]]:
    """The next parts of a path: seconds, (left, forward) / usual speed, turn in radians."""
    directions = [(0.0, 1.0), (0.0, style.run), (0.0, -0.65), (0.5, 0.0), (0.0, 0.0)]
    walk, run, back, side, stand = np.array(directions)
    if gait == "ID":
        return [(rng.uniform(4, 9), stand, 0.0)]
    if gait == "TR1":
        rounds = max(1, round(seconds / TRANSITION))
        turn = sign * rng.uniform(1.0, 2.6)
        other = [side, -side, back][rng.integers(3)]
        row = [(walk, 0.0), (walk, turn), (run, rng.normal(0, 0.4)), (walk, -0.6 * turn),
               (other, 0.0)]
        # a short clip leaves some of them out, the least important ones first
        count = min(max(round(seconds / rounds / 1.6) - 1, 1), 5)
        row = [row[k] for k in sorted((0, 2, 1, 3, 4)[:count])]
        share = np.concatenate(([0.5], rng.uniform(0.85, 1.15, count), [0.5]))
        share *= seconds / rounds / share.sum()
        row = [(stand, 0.0), *row, (stand, 0.0)]
        return [(part, velocity, turn) for part, (velocity, turn) in zip(share, row, strict=True)]
    sidewards, running = gait[0] == "S", gait[1] == "R"
    velocity = {"F": walk, "B": back, "S": sign * side}[gait[0]]
    velocity = velocity * (style.run if running else 1.0)
    if gait in ("BR", "SR"):
        velocity = velocity * 0.8
    length = rng.uniform(1.2, 3.0)
    # radians per second
    rate = rng.choice([0.0, 0.5, 1.1], p=[0.3, 0.45, 0.25]) * rng.uniform(0.7, 1.3)
    if sidewards:
        rate = rate * rng.choice([-1.0, 1.0]) * 0.35
    else:
        rate = rate * sign * (0.8 if running else 1.0)
    return [(length, velocity * rng.choice([0.65, 0.85, 1.0, 1.0, 1.1]), rate * length)]
