"""Measures of the procedural neutral walk, compared with the straight parts of recorded neutral
walks.
"""

from itertools import pairwise
from pathlib import Path
from typing import Annotated

import numpy as np
import pandas as pd
import torch
import typer

from toolkit import datasets
from toolkit.datasets import procedural
from toolkit.motion import Clip, contacts, root_frames

RATE = 30.0  # Hz, of the slowest recording; all motion is resampled to it
SHORTEST = 2.0  # seconds, least length of a straight part
STRAIGHT = 0.35  # rad/s, highest turning rate of a straight part
MEASURES = (
    "speed (m/s)", "cadence (steps/min)", "step length (m)", "stance ratio of a toe",
    "hips bob per stride (mm)", "thigh fore and aft (deg)", "knee flexion, least (deg)",
    "knee flexion, range (deg)", "ankle, range (deg)", "upper arm fore and aft (deg)",
)


def run(
    data: Annotated[Path, typer.Option(help="Folder that holds 100style/ and bandai/.")]
) -> None:
    """Measures of a procedural walk, compared with recorded neutral walks of 100STYLE and
    Bandai-Namco.
    """
    parts = []
    for title, folder, choice in (("100STYLE", "100style", {"styles": "Neutral", "gaits": "FW"}),
                                  ("Bandai", "bandai", {"styles": "normal", "gaits": "walk"})):
        clips = datasets.load(folder, data / folder, **choice)
        parts += [{"takes": title} | measure(part)
                  for clip in clips for part in straight_parts(clip)]
    takes = pd.DataFrame(parts).groupby("takes")
    made = {title: measure(_walk(pace)) for title, pace in takes[MEASURES[0]].mean().items()}
    table = pd.concat({"least": takes.min().T, "most": takes.max().T,
                       "procedural, as fast": pd.DataFrame(made)}, axis=1)
    low, high = table["least"].min(axis=1), table["most"].max(axis=1)
    outside = table.index[pd.DataFrame(made).apply(lambda c: ~c.between(low, high)).any(axis=1)]
    print(table.round(2).to_string())
    print(f"outside the range of all {len(parts)} recorded parts: {', '.join(outside)}")


def straight_parts(clip: Clip) -> list[Clip]:
    """Parts of at least `SHORTEST` seconds of walking forwards without turns, at `RATE`."""
    clip = clip.resample(RATE)
    roots = root_frames(clip)
    half = round(RATE / 2)
    position = _mean(roots.positions[:, [0, 2]].double().numpy(), half)
    velocity = np.gradient(position, 1 / RATE, axis=0)
    turning = np.gradient(np.unwrap(np.arctan2(velocity[:, 0], velocity[:, 1])), 1 / RATE)
    good = (np.abs(turning) < STRAIGHT) & (np.hypot(*velocity.T) > 0.5)
    edges = np.flatnonzero(np.diff(np.concatenate(([0], good, [0]))))
    return [clip.cut(a, b) for a, b in edges.reshape(-1, 2).tolist() if b - a >= SHORTEST * RATE]


def measure(clip: Clip) -> dict[str, float]:
    """The values of `MEASURES` of a straight walk."""
    clip = clip.resample(RATE)
    points = clip.global_positions.double().numpy()
    at = {name: points[:, clip.skeleton.role(name)] for name in clip.skeleton.roles}
    hips = at["hips"]
    x, _, z = hips[-1] - hips[0]
    ahead = np.array([x, 0.0, z]) / np.hypot(x, z)
    apart = (at["left_foot"] - at["right_foot"]) @ ahead
    strides = np.flatnonzero((apart[:-1] < 0) & (apart[1:] >= 0))
    if len(strides) < 2:
        raise ValueError(f"{clip.name}: a part of {clip.seconds:.1f} s has no whole stride")
    first, *_, last = strides
    steps = 2 * (len(strides) - 1)
    seconds = (last - first) / RATE
    speed = (hips[last] - hips[first]) @ ahead / seconds

    both = {"thigh": [], "knee": [], "ankle": [], "arm": []}
    for side in ("left", "right"):
        hip, knee, foot, toe, shoulder, elbow = (
            at[f"{side}_{part}"][first:last]
            for part in ("hip", "knee", "foot", "toe", "shoulder", "elbow"))
        both["thigh"].append(_lean(knee - hip, ahead))
        both["knee"].append(_angle(knee - hip, foot - knee))
        both["ankle"].append(_angle(foot - knee, toe - foot))
        both["arm"].append(_lean(elbow - shoulder, ahead))

    def spread(name: str) -> float:
        return np.mean([np.ptp(np.percentile(curve, (1, 99))) for curve in both[name]])

    values = (
        speed,
        60 * steps / seconds,
        speed * seconds / steps,
        contacts.detect(clip)[first:last].mean(),
        1000 * np.mean([np.ptp(hips[a:b, 1]) for a, b in pairwise(strides)]),
        spread("thigh"),
        np.mean([np.percentile(curve, 1) for curve in both["knee"]]),
        spread("knee"),
        spread("ankle"),
        spread("arm"),
    )
    return dict(zip(MEASURES, map(float, values), strict=True))


def _walk(pace: float) -> Clip:
    """Twelve seconds of the procedural neutral style, straight ahead."""
    t = torch.arange(720) / 60
    return procedural.generate("Neutral", path=torch.stack((0 * t, pace * t, 0 * t), 1))


def _mean(x: np.ndarray, half: int) -> np.ndarray:
    padded = np.pad(x, ((half, half), (0, 0)), mode="reflect", reflect_type="odd")
    return np.lib.stride_tricks.sliding_window_view(padded, 2 * half + 1, axis=0).mean(-1)


def _lean(bone: np.ndarray, ahead: np.ndarray) -> np.ndarray:
    """Angle of a hanging bone from the vertical, positive forwards, degrees."""
    return np.degrees(np.arctan2(bone @ ahead, -bone[:, 1]))


def _angle(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Angle between two bones, degrees."""
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(1)))
