"""The field's measures by name, and one table of them: methods beside real motion."""

import functools
import math
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from typing import Any

import numpy as np
from torch import Tensor

from toolkit.evaluation.metrics import bodies, pairs, quality, sets, steps
from toolkit.evaluation.recognition import HIDDEN, Recogniser
from toolkit.motion import Clip, Skeleton
from toolkit.motion.tensors import as_tensor, at_rate

#: Measures of a clip; of a clip and the real clip with the same frames; of a recogniser and clips;
#: of these and real clips.
CLIP: dict[str, Callable[[Clip], float]] = {
    "skate-smoodi": steps.skate_smoodi,
    "skate-kimodo": steps.skate_kimodo,
    "skate-camdm": steps.skate_camdm,
    "skate-rsmt": steps.skate_rsmt,
    "skate": quality.skate,
    "floor": quality.floor,
    "through": quality.through,
    "stretch": quality.stretch,
    "jerk": quality.jerk,
    "shake": quality.shake,
    "motion": quality.motion,
    "slow-motion": quality.slow_motion,
    "speed": bodies.speed,
    "seconds": lambda clip: clip.seconds,
}
PAIR: dict[str, Callable[[Clip, Clip], float]] = {
    "npss": pairs.npss,
    "geodesic": pairs.geodesic,
    "global-position": pairs.global_position,
    "trajectory-error": pairs.trajectory_error,
    "stop": pairs.stop,
}
SET: dict[str, Callable[..., float]] = {
    "fmd": sets.fmd,
    "nearest": sets.nearest,
    "diversity": sets.diversity,
    "multimodality": sets.multimodality,
    "recognition-top1": sets.recognition,
}


class _Measures(dict[str, Callable[..., float]]):
    """Measures by name; the error of an unknown one lists the others."""

    def __missing__(self, name: str):
        raise KeyError(f"unknown measure {name!r}; known: {', '.join(self)}")


MEASURES = _Measures(CLIP | PAIR | SET)
POSITIONS = "global-position", "trajectory-error", "stop"  # those that need no rotations
UNITS = {"jerk": "m/s3", "seconds": "s"}
UNITS |= dict.fromkeys(("skate-rsmt", "skate", "speed", "stop"), "m/s")
UNITS |= dict.fromkeys(("global-position", "floor", "through", "stretch", "shake", "motion",
                        "slow-motion"), "m")
UNITS |= dict.fromkeys(("geodesic", "trajectory-error"), "rad")
BEST = dict.fromkeys(MEASURES, "lower") | {"recognition-top1": "higher"}
BEST |= dict.fromkeys(("jerk", "shake", "motion", "slow-motion", "speed", "seconds", "nearest",
                       "diversity", "multimodality"), "as real")
RESAMPLES, COVERED = 200, 0.95  # of the bootstrap; probability of an interval
#: What a method gave: a clip or array ``[F, J, 3]``, or several.
Motion = Any


@dataclass(frozen=True, eq=False)
class Joints:
    """Joint positions without rotations, where a clip is measured: its bones may stretch."""

    global_positions: Tensor  # [F, J, 3] metres
    skeleton: Skeleton
    fps: float
    style: str = ""
    name: str = "joints"

    def __len__(self) -> int:
        return len(self.global_positions)

    @property
    def seconds(self) -> float:
        """Duration, seconds."""
        return len(self) / self.fps

    def resample(self, fps: float) -> "Joints":
        """The same motion at another rate."""
        positions = at_rate(self.global_positions, self.fps, fps)
        return replace(self, global_positions=positions, fps=fps)


@dataclass(frozen=True)
class Report:
    """Means of the measures; print it for a table.

    ``rows`` has a dict for each method and one for ``real``: ``data``, its name; ``n``, the number
    of clips; and each measure of ``columns``, NaN where it has no value. ``intervals`` has the ends
    of each by name and measure: of 95 % of bootstraps over the clips, for ``fmd`` biased upwards,
    since a clip that is drawn twice makes a set less varied. ``notes`` says what is missing and
    why, and what not to trust.
    """

    rows: list[dict[str, str | int | float]]
    columns: list[str]
    notes: list[str]
    intervals: dict[str, dict[str, tuple[float, float]]]

    def __repr__(self) -> str:
        lines = [["measure", *(f"{row['data']} ({row['n']})" for row in self.rows), "unit", "best"]]
        for name in self.columns:
            values = [self._cell(row, name) for row in self.rows]
            lines.append([name, *values, UNITS.get(name, ""), BEST[name]])
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        padded = (map(str.ljust, line, widths) for line in lines)
        return "\n".join([*("  ".join(line).rstrip() for line in padded), *self.notes])

    def _cell(self, row: Mapping[str, Any], name: str) -> str:
        if math.isnan(row[name]):
            return "-"
        low, high = self.intervals[row["data"]][name]
        ends = "" if math.isnan(low) else f" [{low:.3g}, {high:.3g}]"
        return f"{row[name]:.4g}{ends}"

    def frame(self) -> Any:
        """The table as a pandas frame, which has ``to_latex``, ``to_csv`` and more.

        A row for each measure; for each method a column of values, ``low`` and ``high``.
        """
        pd, table = pandas(), {}
        for row in self.rows:
            method = row["data"]
            ends = [self.intervals[method][name] for name in self.columns]
            table[method, "value"] = [row[name] for name in self.columns]
            table[method, "low"], table[method, "high"] = zip(*ends, strict=True)
        return pd.DataFrame(table, index=pd.Index(self.columns, name="measure"))


def pandas() -> Any:
    """The package, or an ImportError that says how to install it."""
    try:
        return import_module("pandas")
    except ImportError:
        raise ImportError("tables as CSV or LaTeX need pandas: pip install pandas") from None


def report(clips: Motion | Mapping[str, Motion], real: Motion | None = None,
           recogniser: Recogniser | None = None) -> Report:
    """All measures of one or more methods beside those of real motion.

    Parameters
    ----------
    clips
        Clips of a method, every one with the same weight; or a dict of methods by name. Arrays
        ``[F, J, 3]`` of joint positions in metres, Y up, of the skeleton and the rate of the first
        real clip, take the place of clips; measures that need rotations have no value for them.
    real
        Real motion, for its own row. Where it has as many clips, and clip i has the joints, the
        frames and the rate of real clip i, the measures of pairs are those of these pairs; else the
        table leaves them out.
    recogniser
        A recogniser of styles (`toolkit.evaluation.recognition`), best one that saw neither;
        without it the measures of sets are left out. ``fmd`` and ``nearest`` compare with every
        second real clip of a style; the row of real clips compares the others with these. For
        ``fmd`` all rows have the same number of windows.

    Raises
    ------
    ValueError
        If a clip is too short or lacks joints, an array does not fit the skeleton, or a method
        has the name of the row of real motion.
    """
    data = dict(clips) if isinstance(clips, Mapping) else {"clips": clips}
    truth = None
    if real is not None:
        if "real" in data:
            raise ValueError("no method can have the name real, which is that of the real motion")
        data["real"] = truth = _listed(real, "real", None)
    data = {name: _listed(some, name, truth) for name, some in data.items()}
    notes, judged = [], {}
    if why := _unpaired(data, truth):
        notes.append(f"without the measures of pairs ({', '.join(PAIR)}): {why}")
    if recogniser is None:
        notes.append(f"without the measures of sets ({', '.join(SET)}): "
                     "they need a recogniser of styles")
    else:
        judged = _sets(_Cached(recogniser), data, truth, notes)
    rows, intervals = [], {}
    for name, some in data.items():
        found = {key: average([f(clip) for clip in some]) for key, f in CLIP.items()}
        if not why:
            both = list(zip(some, truth, strict=True))
            found |= {key: average([_paired(key, *pair) for pair in both]) for key in PAIR}
        found |= judged.get(name, {})
        rows.append({"data": name, "n": len(some)} | {
            key: statistic(range(count)) for key, (count, statistic) in found.items()})
        intervals[name] = {key: interval(*each) for key, each in found.items()}
    return Report(rows, list(found), notes, intervals)


#: The number n of clips, and a function of n indices of clips: ``range(n)`` gives the measure
#: itself, the bootstrap passes random indices.
Statistic = tuple[int, Callable[[Sequence[int]], float]]


class _Cached:
    """A recogniser that looks at a clip once."""

    def __init__(self, recogniser: Recogniser):
        self.styles, self.width = recogniser.styles, 2 * HIDDEN
        self.embed = functools.cache(recogniser.embed)
        self.of_clip = functools.cache(recogniser.of_clip)


def _listed(motion: Motion, what: str, real: Sequence[Clip] | None) -> list[Clip | Joints]:
    """The clips of a method; arrays of joint positions become `Joints`, as the real clips are."""
    single = isinstance(motion, Clip | Joints) or getattr(motion, "ndim", 0) == 3
    clips = [motion] if single else list(motion)
    if not clips:
        raise ValueError(f"{what}: no clips to measure")
    for number, one in enumerate(clips):
        if isinstance(one, Clip | Joints):
            continue
        if real is None:
            raise ValueError(f"{what}: arrays of joints need real clips, whose skeleton and rate "
                             "they have")
        skeleton, positions = real[0].skeleton, as_tensor(one, what)
        if positions.shape[1:] != (len(skeleton), 3):
            raise ValueError(f"{what}: expected joints [F, {len(skeleton)}, 3], "
                             f"got {list(positions.shape)}")
        clips[number] = Joints(positions, skeleton, real[0].fps, name=f"{what}[{number}]")
    return clips


def _unpaired(data: Mapping[str, Sequence], real: Sequence | None) -> str:
    """Why clip i is not to be compared with real clip i; empty if it is."""
    if real is None:
        return "they need real clips"
    for name, clips in data.items():
        if len(clips) != len(real):
            return f"{len(clips)} {name} and {len(real)} real ones are not pairs"
        try:
            for clip, truth in zip(clips, real, strict=True):
                pairs.check_pair(clip, truth)
        except ValueError as error:
            return str(error)
    return ""


def _paired(name: str, clip: Clip | Joints, real: Clip | Joints) -> float:
    rotations = isinstance(clip, Clip) and isinstance(real, Clip)
    return PAIR[name](clip, real) if rotations or name in POSITIONS else math.nan


def average(values: Sequence[float]) -> Statistic:
    """The mean of the numbers that are not NaN."""
    known = [value for value in values if not math.isnan(value)]
    if not known:
        return 1, lambda _: math.nan
    return len(known), lambda chosen: sum(known[i] for i in chosen) / len(chosen)


def _sets(judge: _Cached, data: Mapping[str, Sequence], real: Sequence | None,
          notes: list[str]) -> dict[str, dict[str, Statistic]]:
    """Measures of sets by method; a note where they cannot be trusted."""
    # Every second real clip of a style is the reference, and the row of real clips the others.
    groups: dict[str, list] = defaultdict(list)
    for clip in real or []:
        groups[clip.style].append(clip)
    chosen = list(groups.values())
    if min(map(len, chosen), default=0) < 2:
        chosen = [list(real or [])]
    reference = [clip for group in chosen for clip in group[::2]]
    compared = dict(data)
    if real is not None:
        compared["real"] = [clip for group in chosen for clip in group[1::2]]
    # only clips with rotations are judged
    able = [name for name, some in data.items() if all(isinstance(clip, Clip) for clip in some)]
    counts = {name: sum(len(judge.embed(clip)) for clip in compared[name]) for name in able}
    fewest = min((count for count in counts.values() if count > 1), default=0)
    if real is not None and fewest <= judge.width:
        notes.append(f"fmd of {fewest} windows: a covariance of {judge.width} features needs more "
                     "windows than features, so compare its values within this table only")
    found = {name: dict.fromkeys(SET, average([])) for name in data}
    enough = sum(len(judge.embed(clip)) for clip in reference) > 1
    for name in able:
        for key in ("diversity", "multimodality", "recognition-top1"):
            found[name][key] = _of(SET[key], judge, data[name])
        if enough and counts[name] > 1 and counts.get("real", 0) != 1:
            found[name]["fmd"] = _of(sets.fmd, judge, compared[name], reference, fewest)
            found[name]["nearest"] = _of(sets.nearest, judge, compared[name], reference)
    return found


def _of(measure: Callable[..., float], judge: _Cached, clips: Sequence, *others: Any) -> Statistic:
    """A measure of sets."""
    return of_styles([clip.style for clip in clips],
                     lambda chosen: measure(judge, [clips[i] for i in chosen], *others))


def of_styles(styles: Sequence[str], measure: Callable[[list[int]], float]) -> Statistic:
    """A `Statistic` of a measure of sets; its bootstrap draws for each clip one of its style.

    So each style keeps its number of clips. ``measure`` takes indices of clips.
    """
    alike = [[n for n, other in enumerate(styles) if other == style] for style in styles]

    def value(chosen: Sequence[int]) -> float:
        drawn = []
        for n, (choice, same) in enumerate(zip(chosen, alike, strict=True)):
            # choice n is clip n itself, n + k the k-th after it among those of its style
            drawn.append(same[(same.index(n) + int(choice) - n) % len(same)])
        return measure(drawn)

    return len(styles), value


def interval(count: int, statistic: Callable[[Sequence[int]], float]) -> tuple[float, float]:
    """Ends of the percentile interval of bootstraps over clips; NaN of one clip."""
    if count < 2 or math.isnan(statistic(range(count))):
        return math.nan, math.nan
    draws = np.random.default_rng(0).integers(0, count, (RESAMPLES, count))
    found = [statistic(draw) for draw in draws]
    low, high = np.quantile(found, [(1 - COVERED) / 2, (1 + COVERED) / 2])
    return float(low), float(high)
