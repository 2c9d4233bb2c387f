"""The field's measures by name, and one table of them: a row of the clips, a row of real data."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from toolkit.evaluation.metrics import pairs, sets, steps
from toolkit.evaluation.recognition import Recogniser
from toolkit.motion import Clip

#: Measures of a clip; of a clip and the real clip with the same frames; of a recogniser and clips.
CLIP: dict[str, Callable[[Clip], float]] = {
    "skate-smoodi": steps.skate_smoodi,
    "skate-kimodo": steps.skate_kimodo,
    "skate-camdm": steps.skate_camdm,
    "skate-rsmt": steps.skate_rsmt,
}
PAIR: dict[str, Callable[[Clip, Clip], float]] = {
    "npss": pairs.npss,
    "geodesic": pairs.geodesic,
    "global-position": pairs.global_position,
    "global-quaternion": pairs.global_quaternion,
    "trajectory-error": pairs.trajectory_error,
    "orientation-error": pairs.orientation_error,
}
SET: dict[str, Callable[..., float]] = {
    "fmd": sets.fmd,
    "diversity": sets.diversity,
    "multimodality": sets.multimodality,
    "recognition-top1": sets.recognition,
}
MEASURES: dict[str, Callable[..., float]] = CLIP | PAIR | SET
UNITS = {"skate-rsmt": "m/s", "global-position": "m"}
UNITS |= dict.fromkeys(("geodesic", "trajectory-error", "orientation-error"), "rad")
BEST = dict.fromkeys(MEASURES, "lower") | {"recognition-top1": "higher"}
BEST |= dict.fromkeys(("diversity", "multimodality"), "as real")


@dataclass(frozen=True)
class Report:
    """Means of the measures; print it for a table.

    ``rows`` has a dict for ``clips`` and one for ``real``: ``data``, its name; ``n``, the number of
    clips; and each measure of ``columns``, NaN where it has no value. ``notes`` says which measures
    are missing and why.
    """

    rows: list[dict[str, str | int | float]]
    columns: list[str]
    notes: list[str]

    def __repr__(self) -> str:
        lines = [["measure", *(f"{row['data']} ({row['n']})" for row in self.rows), "unit", "best"]]
        for name in self.columns:
            values = ["-" if math.isnan(row[name]) else f"{row[name]:.4g}" for row in self.rows]
            lines.append([name, *values, UNITS.get(name, ""), BEST[name]])
        widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
        padded = (map(str.ljust, line, widths) for line in lines)
        return "\n".join([*("  ".join(line).rstrip() for line in padded), *self.notes])


def report(clips: Clip | Iterable[Clip], real: Clip | Iterable[Clip] | None = None,
           recogniser: Recogniser | None = None) -> Report:
    """All measures of clips beside those of real motion.

    Parameters
    ----------
    clips
        One or several; every clip has the same weight.
    real
        Real motion, for its own row. Where it has as many clips, and clip i has the joints, the
        frames and the rate of real clip i, the measures of pairs are those of these pairs; else the
        table leaves them out.
    recogniser
        A recogniser of styles (`toolkit.evaluation.recognition`), best one that saw neither;
        without it the measures of sets are left out. The real row's ``fmd`` is that of every second
        real clip from the others: what chance gives.

    Raises
    ------
    ValueError
        If there is no clip, or a clip is too short or lacks the joints that a measure needs.
    """
    rows = {"clips": _listed(clips, "clips")}
    if real is not None:
        rows["real"] = _listed(real, "real")
    clips, real = rows["clips"], rows.get("real")
    columns, notes = list(CLIP), []
    values = {name: {key: _mean([f(clip) for clip in some]) for key, f in CLIP.items()}
              for name, some in rows.items()}
    why = "they need real clips" if real is None else _unpaired(clips, real)
    if why:
        notes.append(f"without the measures of pairs ({', '.join(PAIR)}): {why}")
    else:
        columns += PAIR
        for name, some in rows.items():
            values[name] |= {key: _mean(list(map(f, some, real))) for key, f in PAIR.items()}
    if recogniser is None:
        notes.append(f"without the measures of sets ({', '.join(SET)}): "
                     "they need a recogniser of styles")
    else:
        columns += SET
        for name, some in rows.items():
            values[name]["fmd"] = _fmd(name, recogniser, clips, real)
            values[name] |= {key: f(recogniser, some) for key, f in SET.items() if key != "fmd"}
    return Report([{"data": name, "n": len(some), **values[name]} for name, some in rows.items()],
                  columns, notes)


def _listed(clips: Clip | Iterable[Clip], what: str) -> list[Clip]:
    clips = [clips] if isinstance(clips, Clip) else list(clips)
    if not clips:
        raise ValueError(f"{what}: no clips to measure")
    return clips


def _mean(values: list[float]) -> float:
    """Mean of the numbers that are not NaN."""
    known = [value for value in values if not math.isnan(value)]
    return sum(known) / len(known) if known else math.nan


def _unpaired(clips: Sequence[Clip], real: Sequence[Clip]) -> str:
    """Why clip i is not to be compared with real clip i; empty if it is."""
    if len(clips) != len(real):
        return f"{len(clips)} clips and {len(real)} real ones are not pairs"
    try:
        for clip, truth in zip(clips, real, strict=True):
            pairs.check_pair(clip, truth)
    except ValueError as error:
        return str(error)
    return ""


def _fmd(name: str, recogniser: Recogniser, clips: list[Clip], real: list[Clip] | None) -> float:
    made, truth = (clips, real) if name == "clips" else (real[::2], real[1::2])
    for some in (made, truth):  # a covariance needs two windows
        if not some or sum(len(recogniser.embed(clip)) for clip in some) < 2:
            return math.nan
    return sets.fmd(recogniser, made, truth)
