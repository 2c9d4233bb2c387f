"""The procedural dataset: stylised locomotion from footstep planning, with known contacts and phases.

It uses no recorded motion. It plans a path, then the footsteps along it. Each foot stays planted during its stance and
swings in an arc to its next footstep. Inverse kinematics gives the legs, from the feet to a pelvis that stays within their
reach. Trunk and arms follow the phase of the steps. `toolkit.datasets.procedural_styles` has the parameters of a style.
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
from toolkit.datasets.takes import Names
from toolkit.io.files import atomic_write
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.motion import rotations as R

__all__ = ["GAITS", "SKELETON", "STYLES", "Arm", "Leg", "Style", "Truth", "generate", "load", "truth", "write"]

#: Forwards, backwards and sidestep walk and run, idle, and a transition through all of them.
GAITS = ("FW", "BW", "FR", "BR", "SW", "SR", "ID", "TR1")
MARGIN = 60  # frames planned before and after the clip, so that it starts and ends in full motion


def load(styles: Names = None, gaits: Names = None, seconds: float = 8.0, seed: int = 0) -> list[Clip]:
    """One clip of every style in every gait.

    Parameters
    ----------
    styles, gaits
        Names in `STYLES` and `GAITS`; all by default.
    seconds
        Length of each clip.
    seed
        The same seed gives the same clips, byte for byte; another seed gives other paths.

    Raises
    ------
    ValueError
        If a style or a gait is unknown; the message lists the names.
    """
    return [generate(style, gait, seconds, seed) for style, gait in _pairs(styles, gaits)]


def generate(style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0, path: Tensor | None = None) -> Clip:
    """A clip in a style, at 60 Hz.

    Parameters
    ----------
    style, gait
        A name in `STYLES` or a `Style`, and one of `GAITS`, which selects the speed and direction of the path.
    seconds, seed
        Length; seed of the path and of the style's noise.
    path : Tensor [F, 3], optional
        Path to follow instead: x, z in metres and facing in radians (0 is +Z, positive turns left) at 60 Hz.

    Raises
    ------
    ValueError
        If style or gait is unknown, or the length is not positive.
    """
    return truth(style, gait, seconds, seed, path)[0]


def truth(style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0,
          path: Tensor | None = None) -> tuple[Clip, Truth]:
    """The clip of `generate`, with its true contacts, phases and frequencies."""
    label = style if isinstance(style, str) else "custom"
    if isinstance(style, str):
        if style not in STYLES:
            raise ValueError(f"unknown procedural style {style!r}; known are {', '.join(STYLES)}")
        style = STYLES[style]
    if gait not in GAITS:
        raise ValueError(f"unknown gait {gait!r}; known are {', '.join(GAITS)}")
    frames = round(seconds * FPS) if path is None else len(path)
    if frames < 2:
        raise ValueError(f"a clip needs at least two frames, got {seconds} seconds")
    rng = np.random.default_rng([seed, zlib.crc32(f"{label} {gait}".encode())])
    root = _random_path(style, gait, frames, rng) if path is None else np.asarray(path, dtype=np.float64)
    if frames > MARGIN:
        padded = np.pad(root, ((MARGIN, MARGIN), (0, 0)), mode="reflect", reflect_type="odd")
    else:
        ahead = np.arange(1, MARGIN + 1)[:, None]
        before, after = root[0] - ahead[::-1] * (root[1] - root[0]), root[-1] + ahead * (root[-1] - root[-2])
        padded = np.concatenate((before, root, after))
    plan = Plan(style, padded, rng)
    feet = {side: plan.foot(side) for side in plan.stepping}
    rotations, positions = pose(plan, feet)
    known = record(plan, feet)
    keep = slice(MARGIN, MARGIN + frames)
    name = f"procedural {label} {gait} seed {seed}"
    clip = Clip(SKELETON, R.unroll(rotations[keep]), positions[keep], FPS, label, gait, name)
    return clip, Truth(known.contacts[keep], known.phase[keep], known.frequency[keep])


def write(folder: str | os.PathLike, styles: Names = None, gaits: Names = None, seconds: float = 8.0, seed: int = 0) -> None:
    """Write the clips of `load` in the layout of 100STYLE (`toolkit.datasets.style100.save`), with the truth of each clip.

    The styles in the files are called ``Procedural<Style>``. ``<Style>_<GAIT>.npz`` holds the arrays of `Truth` of
    ``<Style>_<GAIT>.bvh``. A terminal shows a progress bar.

    Raises
    ------
    ValueError
        If a style or gait is unknown or comes twice, or the folder already holds a dataset.
    """
    folder = Path(folder)

    def clips() -> Iterator[Clip]:
        for style, gait in progress_bar(_pairs(styles, gaits), desc="procedural", unit="clip"):
            clip, known = truth(style, gait, seconds, seed)
            clip = clip.replace(style=f"Procedural{style}")
            with atomic_write(folder / f"{clip.style}_{gait}.npz") as file:
                np.savez_compressed(file, **{name: value.numpy() for name, value in vars(known).items()})
            yield clip

    infos = [StyleInfo(f"Procedural{n}", f"procedural: {n}", s.symmetric, s.stagger > 0, "") for n, s in STYLES.items()]
    save(clips(), folder, infos)


def _pairs(styles: Names, gaits: Names) -> list[tuple[str, str]]:
    styles, gaits = ([x] if isinstance(x, str) else list(x or every) for x, every in ((styles, STYLES), (gaits, GAITS)))
    return [(style, gait) for style in styles for gait in gaits]


def _random_path(style: Style, gait: str, frames: int, rng: np.random.Generator) -> np.ndarray:
    """Root path ``[frames, 3]`` (x, z, facing) of a gait: random changes of speed and heading, to either side in turn."""
    walk, run, back, side, stand = np.array([(0.0, 1.0), (0.0, style.run), (0.0, -0.65), (0.5, 0.0), (0.0, 0.0)])
    parts: list[tuple[float, np.ndarray, float]] = []  # seconds, (left, forward) / usual speed, turn in radians
    sign, total, seconds = rng.choice([-1.0, 1.0]), 0.0, frames / FPS
    rounds = max(1, round(seconds / 9.6))  # number of transitions; a whole one lasts about ten seconds
    while total < seconds - 1e-6:
        if gait == "TR1":
            turn = sign * rng.uniform(1.0, 2.6)
            other = [side, -side, back][rng.integers(3)]
            row = [(walk, 0.0), (walk, turn), (run, rng.normal(0, 0.4)), (walk, -0.6 * turn), (other, 0.0)]
            count = min(max(round(seconds / rounds / 1.6) - 1, 1), 5)
            row = [row[k] for k in sorted((0, 2, 1, 3, 4)[:count])]
            share = np.concatenate(([0.5], rng.uniform(0.85, 1.15, count), [0.5]))
            share *= seconds / rounds / share.sum()
            new = [(s, v, t) for s, (v, t) in zip(share, [(stand, 0.0), *row, (stand, 0.0)], strict=True)]
        elif gait == "ID":
            new = [(rng.uniform(4, 9), stand, 0.0)]
        else:
            kind = {"F": walk, "B": back, "S": sign * side}[gait[0]] * (style.run if gait[1] == "R" else 1.0)
            if gait in ("BR", "SR"):
                kind = kind * 0.8
            length = rng.uniform(1.2, 3.0)
            rate = rng.choice([0.0, 0.5, 1.1], p=[0.3, 0.45, 0.25]) * rng.uniform(0.7, 1.3)  # radians per second
            rate *= rng.choice([-1.0, 1.0]) if gait[0] == "S" else sign
            rate *= 0.35 if gait[0] == "S" else 0.8 if gait[1] == "R" else 1.0
            new = [(length, kind * rng.choice([0.65, 0.85, 1.0, 1.0, 1.1]), rate * length)]
        sign = -sign
        parts += new
        total += sum(n[0] for n in new)
    duration, velocity, turn = map(np.array, zip(*parts, strict=True))
    edges = np.concatenate(([0.0], np.cumsum(duration))) * FPS
    at = np.searchsorted(edges, np.arange(frames), side="right") - 1
    velocity, rate = velocity[at] * style.speed, (turn / duration)[at]
    pace = np.abs(velocity).sum(1) / style.speed
    going = np.minimum(pace, 1)
    rate = rate + (0.35 * style.noise + 0.5 * style.stagger) * going * smooth_noise(rng, frames, 35, 1)[:, 0]
    drift = style.speed * (0.12 * style.noise + 0.2 * style.stagger)
    velocity = velocity + drift * going[:, None] * smooth_noise(rng, frames, 30, 2)
    velocity, rate = smooth(velocity, 13), smooth(rate, 11)
    facing = rng.uniform(-math.pi, math.pi) + np.cumsum(rate) / FPS
    c, s = np.cos(facing), np.sin(facing)
    world = np.stack((velocity[:, 0] * c + velocity[:, 1] * s, -velocity[:, 0] * s + velocity[:, 1] * c), 1) / FPS
    return np.concatenate((np.cumsum(world, 0), facing[:, None]), 1)
