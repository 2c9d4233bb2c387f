"""Limits of `toolkit.evaluation.defects` from recorded people, and its false alarms on others."""

import math
import warnings
from collections import defaultdict
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.tables import Result, Store
from toolkit import datasets
from toolkit.evaluation import findings
from toolkit.io import bvh
from toolkit.motion import Clip

#: Styles whose takes make the limits, and those whose takes chose `MARGIN`; all others are counted.
CALIBRATION = {"active", "angry", "childish", "happy", "masculinity", "musical", "exhausted"}
CHOICE = {"feminine", "not-confident", "old"}
FAMOUS = "angry_13_000", "neutral_01_000", "Neutral_FW"  # of Xia and 100STYLE, also for the limits
GAITS = "walk", "run", "dash", "turn", "_01_", "_13_", "Neutral_", "Locomotion"
JUMP = 2331  # frame in which the body of Holden's take jumps by 2.2 m
MARGIN = 1.3  # of 1.2, 1.3, 1.5 and 1.75 the least with alarms in under 1 % of the choice's seconds
RARE, RARER = 0.999, 0.9999  # quantiles of frames: of slides, of all other kinds
PLAIN = {"fold": 1.06, "floor": 1.7}  # margins of an angle near its end, of a few heights of takes


def takes(data: Path, every: int = 1) -> list[Clip]:
    """Recorded walks, runs and turns below a folder of datasets, named by their files.

    ``every`` takes the first of so many.
    """
    clips = []
    for folder in ("bandai", "pfnn", "xia"):
        files = sorted((data / folder).rglob("*.bvh"))
        for path in [path for path in files if any(gait in path.stem for gait in GAITS)][::every]:
            with warnings.catch_warnings(action="ignore"):  # of the jump
                unit = "auto" if folder == "bandai" else "CMU"
                clip = bvh.load(path, unit=unit).without_ends()
            clips.append(clip.cut(0, JUMP if folder == "pfnn" else None).replace(name=path.stem))
    recorded = datasets.load("100style", data / "100style")
    return clips + [clip.replace(name=f"Neutral_{clip.gait}") for clip in recorded]


def part(clip: Clip) -> str:
    """Which part a take belongs to: limits, choice, or alarms."""
    styles = set(clip.name.split("_"))
    if styles & CALIBRATION or clip.name in FAMOUS:
        return "limits"
    return "choice" if styles & CHOICE else "alarms"


def limits(clips: list[Clip]) -> dict[str, dict[str, tuple[float, float]]]:
    """`findings.LIMITS` of the takes for limits: three digits, walks and runs."""
    values: dict[str, dict[str, list]] = defaultdict(lambda: defaultdict(lambda: [[], []]))
    for clip in clips:
        fast = findings.runs(clip)
        for kind, joint, found, _ in findings.measured(clip):
            for pace, frames in enumerate((~fast, fast)):
                some = found[frames & ~found.isnan()]
                values[kind][findings.sideless(joint)][pace].append(some)
    made: dict[str, dict[str, tuple[float, float]]] = defaultdict(dict)
    for kind, joints in values.items():
        sign = -1 if kind in findings.LEAST else 1
        rare, margin = RARE if "slide" in kind else RARER, PLAIN.get(kind, MARGIN)
        for joint, paces in joints.items():
            walks, runs = (torch.cat(some) * sign for some in paces)
            ends = [sign * float(x.quantile(rare)) * margin**sign if len(x) > 99 else math.nan
                    for x in (walks, runs)]
            slow, quick = (float(f"{end:.3g}") for end in ends)
            made[kind][joint] = slow, max(quick, slow) if sign > 0 else min(quick, slow)
    return made


def alarms(clips: list[Clip]) -> tuple[float, dict[str, float]]:
    """Seconds of the clips, and those with a finding of each kind, and of any."""
    seconds, found = 0.0, defaultdict(float)
    for clip in clips:
        seconds += clip.seconds
        marked: dict[str, set[int]] = defaultdict(set)
        for finding in findings.defects(clip):
            times = range(int(finding.start), math.ceil(finding.end))
            marked[finding.kind] |= set(times)
            marked["any"] |= set(times)
        for kind, times in marked.items():
            found[kind] += len(times)
    return seconds, dict(found)


def run(
    data: Annotated[Path, typer.Option(help="Folder of bandai/, pfnn/, xia/ and 100style/.")],
    store: Store = False,
) -> None:
    """Limits of defects from recorded takes, and false alarms on takes that made none.

    The limits are printed as `toolkit.evaluation.findings.LIMITS` has them; the alarms are those of
    the limits in the module.
    """
    parts: dict[str, list[Clip]] = defaultdict(list)
    for clip in takes(data):
        parts[part(clip)].append(clip)
    found_limits = limits(parts["limits"])
    for kind, joints in found_limits.items():
        print(f'    "{kind}": {joints},')
    rows = []
    for name, clips in parts.items():
        seconds, found = alarms(clips)
        print(name, len(clips), "takes", round(seconds), "s", found)
        rows.append({"part": name, "takes": len(clips), "seconds": seconds,
                     "any": found.pop("any", 0) / seconds,
                     "kinds": ", ".join(f"{kind} {count:.0f}" for kind, count in found.items())})
    if store:
        columns = {"part": ["takes for"], "takes": ["takes", 0], "seconds": ["seconds", 0],
                   "any": ["seconds with an alarm, %", 1, 100], "kinds": ["seconds by kind"]}
        Result("defects", "False alarms on recorded walks, runs and turns of Bandai-Namco 1 and 2, "
               "Xia, Holden and 100STYLE; a style is in one part only.",
               "python -m experiments defects --data DATA --store", columns, rows,
               numbers=dict(found_limits)).save()
