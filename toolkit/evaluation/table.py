"""One table of all measures: a row of the clips, and a row of the real data."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from toolkit.evaluation import measures
from toolkit.evaluation.recognition import Recogniser
from toolkit.motion import Clip


@dataclass(frozen=True)
class Report:
    """Means of the measures; print it for a table.

    ``rows`` has a dict for ``clips`` and one for ``real``: ``data``, its name; ``n``, the number of clips; and each
    measure of ``columns``, NaN where it has no value. ``notes`` says which measures are missing and why.
    """

    rows: list[dict[str, str | int | float]]
    columns: list[str]
    notes: list[str]

    def __repr__(self) -> str:
        head = ["measure", *(f"{row['data']} ({row['n']})" for row in self.rows), "unit", "best"]
        body = [[name, *(_shown(row[name]) for row in self.rows), measures.UNITS.get(name, ""), measures.BEST[name]]
                for name in self.columns]
        widths = [max(map(len, column)) for column in zip(head, *body, strict=True)]
        lines = ["  ".join(f"{text:<{w}}" for text, w in zip(line, widths, strict=True)).rstrip() for line in (head, *body)]
        return "\n".join([*lines, *self.notes])


def _shown(value: float) -> str:
    return "-" if math.isnan(value) else f"{value:.4g}"


def report(clips: Clip | Iterable[Clip], real: Clip | Iterable[Clip] | None = None,
           recogniser: Recogniser | None = None) -> Report:
    """All measures of clips beside those of real motion.

    Parameters
    ----------
    clips
        One or several; every clip has the same weight.
    real
        Real motion, for its own row. Where it has as many clips, and clip i has the joints, the frames and the rate of real
        clip i, the measures of pairs are those of these pairs; else the table leaves them out.
    recogniser
        A recogniser of styles (`toolkit.evaluation.recognition`), best one that saw neither; without it the measures of sets
        are left out. The real row's ``fmd`` is that of every second real clip from the others: what chance gives.

    Raises
    ------
    ValueError
        If there is no clip, or a clip is too short or lacks the joints that a measure needs.
    """
    clips, real = _listed(clips, "clips"), None if real is None else _listed(real, "real")
    columns, notes = list(measures.CLIP), []
    rows = {"clips": clips} | ({} if real is None else {"real": real})
    values = {name: {measure: _mean(map(f, some)) for measure, f in measures.CLIP.items()} for name, some in rows.items()}
    why = "they need real clips" if real is None else _unpaired(clips, real)
    if why:
        notes.append(f"without the measures of pairs ({', '.join(measures.PAIR)}): {why}")
    else:
        columns += measures.PAIR
        for name, some in rows.items():
            values[name] |= {measure: _mean(map(f, some, real)) for measure, f in measures.PAIR.items()}
    if recogniser is None:
        notes.append(f"without the measures of sets ({', '.join(measures.SET)}): they need a recogniser of styles")
    else:
        columns += measures.SET
        for name, some in rows.items():
            alone = {measure: f(recogniser, some) for measure, f in measures.SET.items() if measure != "fmd"}
            values[name] |= {"fmd": _fmd(name, recogniser, clips, real), **alone}
    return Report([{"data": name, "n": len(some), **{c: values[name][c] for c in columns}} for name, some in rows.items()],
                  columns, notes)


def _listed(clips: Clip | Iterable[Clip], what: str) -> list[Clip]:
    clips = [clips] if isinstance(clips, Clip) else list(clips)
    if not clips:
        raise ValueError(f"{what}: no clips to measure")
    return clips


def _mean(values: Iterable[float]) -> float:
    """Mean of the numbers that are not NaN."""
    known = [value for value in values if not math.isnan(value)]
    return sum(known) / len(known) if known else math.nan


def _unpaired(clips: Sequence[Clip], real: Sequence[Clip]) -> str:
    """Why clip i is not to be compared with real clip i; empty if it is."""
    if len(clips) != len(real):
        return f"{len(clips)} clips and {len(real)} real ones are not pairs"
    for clip, truth in zip(clips, real, strict=True):
        try:
            measures.check_pair(clip, truth)
        except ValueError as error:
            return str(error)
    return ""


def _fmd(name: str, recogniser: Recogniser, clips: list[Clip], real: list[Clip] | None) -> float:
    made, truth = (clips, real) if name == "clips" else (real[::2], real[1::2])
    if not truth or any(sum(len(recogniser.embed(clip)) for clip in some) < 2 for some in (made, truth)):
        return math.nan
    return measures.fmd(recogniser, made, truth)
