"""The embedded default: stylised locomotion made from footstep planning, with the true contacts and phases known.

No recorded motion is used. A path is planned first, then the footsteps along it; feet are planted in the world, swing in
arcs from print to print, and the legs follow by inverse kinematics to a pelvis that keeps within their reach. Trunk and
arms ride on the clock that the steps give. See `toolkit.datasets.procedural_styles` for what makes a style.
"""

import math
import zlib
from collections.abc import Sequence

import numpy as np
from torch import Tensor

from toolkit import rotations as R
from toolkit.datasets.procedural_body import SKELETON, pose
from toolkit.datasets.procedural_steps import FPS, Plan, Truth, record, smooth, wander
from toolkit.datasets.procedural_styles import STYLES, Arm, Leg, Style
from toolkit.motion import Clip

__all__ = ["GAITS", "SKELETON", "STYLES", "Arm", "Leg", "Style", "Truth", "generate", "load", "truth"]

#: Forwards, backwards and sidestep walk and run, idle, and a transition through all of them.
GAITS = ("FW", "BW", "FR", "BR", "SW", "SR", "ID", "TR1")
LEAD = 60  # frames planned before and after the clip, so that it starts and ends in full motion


def load(
    styles: str | Sequence[str] | None = None,
    gaits: str | Sequence[str] | None = None,
    seconds: float = 8.0,
    seed: int = 0,
) -> list[Clip]:
    """One clip of every style in every gait.

    Parameters
    ----------
    styles, gaits
        Names in `STYLES` and `GAITS`; all by default.
    seconds
        Length of each clip.
    seed
        The same seed gives the same clips, to the byte; another one other paths.

    Raises
    ------
    ValueError
        If a style or a gait is unknown; the message lists the names.
    """
    styles, gaits = ([x] if isinstance(x, str) else x for x in (styles, gaits))
    return [generate(s, g, seconds, seed) for s in styles or STYLES for g in gaits or GAITS]


def generate(style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0, path: Tensor | None = None) -> Clip:
    """A clip in a style, at 60 Hz.

    Parameters
    ----------
    style
        A name in `STYLES`, or a `Style` of your own.
    gait
        One of `GAITS`; decides the path, and so whether this is a walk or a run, forwards or not.
    seconds
        Length.
    seed
        Of the path and of the style's noise.
    path : Tensor [F, 3], optional
        Walk along this instead: x, z in metres and facing in radians (0 is +Z, positive turns left) at 60 Hz.

    Raises
    ------
    ValueError
        If style or gait is unknown, or the length is not positive.
    """
    return truth(style, gait, seconds, seed, path)[0]


def truth(
    style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0, path: Tensor | None = None
) -> tuple[Clip, Truth]:
    """As `generate`, and what is known about the clip beside it."""
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
    root = _path(style, gait, frames, rng) if path is None else np.asarray(path, dtype=np.float64)
    edges = np.pad(root, ((LEAD, LEAD), (0, 0)), mode="reflect", reflect_type="odd") if frames > LEAD else np.concatenate(
        (root[0] + np.arange(-LEAD, 0)[:, None] * (root[1] - root[0]), root,
         root[-1] + np.arange(1, LEAD + 1)[:, None] * (root[-1] - root[-2])))  # fmt: skip
    plan = Plan(style, edges, rng)
    feet = {side: plan.foot(side) for side in plan.stepping}
    rotations, positions = pose(plan, feet)
    known = record(plan, feet)
    keep = slice(LEAD, LEAD + frames)
    name = f"procedural {label} {gait} seed {seed}"
    clip = Clip(SKELETON, R.unroll(rotations[keep]), positions[keep], FPS, label, gait, name)
    return clip, Truth(known.contacts[keep], known.phase[keep], known.frequency[keep])


def _path(style: Style, gait: str, frames: int, rng: np.random.Generator) -> np.ndarray:
    """Root path ``[frames, 3]`` (x, z, facing) of a gait: random changes of speed and heading, left and right in turn."""
    walk, run = np.array([0.0, 1.0]), np.array([0.0, style.run])
    back, side = np.array([0.0, -0.65]), np.array([0.5, 0.0])
    stand = np.zeros(2)
    legs: list[tuple[float, np.ndarray, float]] = []  # seconds, (left, forward) in usual speeds, turn in radians
    sign = rng.choice([-1.0, 1.0])
    total = 0.0
    while total < frames / FPS:
        if gait == "TR1":
            share = min(1.4, max(0.6, frames / FPS / 7)) * rng.uniform(0.85, 1.15, 7)
            turn = sign * rng.uniform(1.0, 2.6)
            other = [side, -side, back][rng.integers(3)]
            row = [(stand, 0.0), (walk, 0.0), (walk, turn), (run, rng.normal(0, 0.4)), (walk, -0.6 * turn), (other, 0.0),
                   (stand, 0.0)]  # fmt: skip
            new = [(s, v, t) for s, (v, t) in zip(share, row, strict=True)]
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
        legs += new
        total += sum(n[0] for n in new)
    edges = np.concatenate(([0.0], np.cumsum([n[0] for n in legs]))) * FPS
    if gait == "TR1":  # the last round ends where the clip ends
        edges *= frames / edges[-1]
    at = np.searchsorted(edges, np.arange(frames), side="right") - 1
    velocity = np.array([n[1] for n in legs])[at] * style.speed
    rate = np.array([n[2] / n[0] for n in legs])[at]
    pace = np.abs(velocity).sum(1) / style.speed
    rate = rate + style.noise * 0.35 * np.minimum(pace, 1) * wander(rng, frames, 35, 1)[:, 0]
    velocity = velocity + style.noise * 0.12 * np.minimum(pace, 1)[:, None] * wander(rng, frames, 30, 2)
    velocity, rate = smooth(velocity, 13), smooth(rate, 11)
    facing = rng.uniform(-math.pi, math.pi) + np.cumsum(rate) / FPS
    c, s = np.cos(facing), np.sin(facing)
    world = np.stack((velocity[:, 0] * c + velocity[:, 1] * s, -velocity[:, 0] * s + velocity[:, 1] * c), 1) / FPS
    return np.concatenate((np.cumsum(world, 0), facing[:, None]), 1)
