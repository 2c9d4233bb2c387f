"""Scores of walks after the plan: two judges, the gate, quality, obedience."""

import hashlib
import json
import math
import os
import platform
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import torch

import toolkit
from toolkit.evaluation import findings
from toolkit.evaluation.metrics import sets
from toolkit.evaluation.metrics.bodies import hips_path
from toolkit.evaluation.table import CLIP, UNITS, Report, Statistic, average, interval, of_styles
from toolkit.extra.benchmark import tracks
from toolkit.extra.benchmark.judges import KINDS, Judges
from toolkit.io.files import write_whole
from toolkit.io.model_files import intact
from toolkit.motion import Clip
from toolkit.motion.trajectory import FPS

QUALITY = "skate", "jerk", "shake", "through", "motion", "slow-motion"
SETTLED = 1.0  # seconds after which a character has done what it is told


@dataclass(frozen=True)
class Scores:
    """Rows of a method: value and interval by name; and what they were measured with."""

    name: str
    rows: dict[str, tuple[float, float, float]]  # value, ends of the interval of 95 %
    about: dict[str, str | int | float]

    def __str__(self) -> str:
        lines = [f"StyleWalk {tracks.PLAN['version']}, {self.name}: {self.about['clips']} clips"]
        for row, (value, low, high) in self.rows.items():
            unit = "deg" if row == "direction" else UNITS.get(row, "")
            lines.append(f"  {row:<18}{value:10.4g}  [{low:.4g}, {high:.4g}] {unit}")
        return "\n".join(lines)

    def save(self, path: str | os.PathLike) -> None:
        """Write JSON, with None for a number that it does not have."""
        rows = {row: [value if math.isfinite(value) else None for value in values]
                for row, values in self.rows.items()}
        text = json.dumps({"name": self.name, "about": self.about, "rows": rows}, indent=1)
        write_whole(Path(path), (text + "\n").encode())

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Scores":
        """Read what `save` wrote; ValueError for any other file."""
        with intact(path, "the score of StyleWalk"):
            stored = json.loads(Path(path).read_text(encoding="utf-8"))
            rows = {row: tuple(math.nan if x is None else float(x) for x in (value, low, high))
                    for row, (value, low, high) in stored["rows"].items()}
            about = stored["about"] | {"clips": int(stored["about"]["clips"])}
            return cls(str(stored["name"]), rows, about)


def table(scored: Sequence[Scores]) -> Report:
    """One table of several methods; ValueError unless all have the same plan, judges and rows."""
    first = scored[0]
    for what in ("plan sha256", "judges sha256", "rows"):
        for other in scored[1:]:
            one, two = ([*s.rows] if what == "rows" else s.about.get(what) for s in (first, other))
            if one != two:
                raise ValueError(f"{first.name} and {other.name} cannot be compared: their "
                                 f"{what} differ")
    rows = [{"data": one.name, "n": one.about["clips"]}
            | {row: value for row, (value, *_) in one.rows.items()} for one in scored]
    intervals = {one.name: {row: ends for row, (_, *ends) in one.rows.items()} for one in scored}
    return Report(rows, list(first.rows), [], intervals)


def score(clips: Mapping[str, Clip], judges: Judges, name: str,
          files: Mapping[str, str | os.PathLike] | None = None) -> Scores:
    """Scores of clips by name: ``track_style_seed``, as in `toolkit.extra.benchmark.walk`.

    The rows: ``style`` by each judge, the share of clips whose style it names; ``agree``, those of
    which both name the same; ``fmd``, the Fréchet distance of the judge's features from recorded
    ones; ``defects``, the share of seconds in which `toolkit.evaluation.defects` finds something;
    measures of `toolkit.evaluation.MEASURES`; ``direction``, the mean angle between the way of the
    hips and the command; ``stop``, the speed of the hips a second after the command to stand. The
    last two have no value for other names of clips.

    Parameters
    ----------
    files
        Files by what they hold, whose hashes are stored: the model, the judges.

    Raises
    ------
    ValueError
        If there is no clip, or a clip lacks joints or lasts less than a second.
    """
    if not clips:
        raise ValueError(f"{name}: no clips to score")
    some = list(clips.values())
    styles = [_parts(key)[1] for key in clips]
    named = {judge: [judges.style(judge, clip) for clip in some] for judge in KINDS}
    found: dict[str, Statistic] = {}
    for judge, answers in named.items():
        known = [float(answer == style) if style in judges.styles else math.nan
                 for answer, style in zip(answers, styles, strict=True)]
        found[f"style {judge}"] = average(known)
    found["agree"] = average([float(a == b) for a, b in zip(*named.values(), strict=True)])
    for judge in KINDS:
        found[f"fmd {judge}"] = _distance(judges, judge, some, styles)
    found["defects"] = average([_defective(clip) for clip in some])
    found |= {key: average([CLIP[key](clip) for clip in some]) for key in QUALITY}
    obeyed = [_obedience(key, clip) for key, clip in clips.items()]
    for number, row in enumerate(("direction", "stop")):
        found[row] = average([each[number] for each in obeyed])
    rows = {row: (statistic(range(count)), *interval(count, statistic))
            for row, (count, statistic) in found.items()}
    hashes = {f"{what} sha256": hashlib.sha256(Path(file).read_bytes()).hexdigest()
              for what, file in (files or {}).items()}
    about = {"benchmark": tracks.PLAN["version"], "plan sha256": tracks.HASH, **hashes,
             "clips": len(some), "toolkit": toolkit.__version__, "torch": torch.__version__,
             "machine": f"{platform.system()} {platform.machine()}, Python "
                        f"{platform.python_version()}"}
    return Scores(name, rows, about)


def _parts(name: str) -> tuple[str, str, int]:
    """Track, style and seed of a clip's name; empty where it has another form."""
    track, _, rest = name.partition("_")
    style, _, seed = rest.rpartition("_")
    if track not in tracks.PLAN["tracks"] or not seed.isdecimal():
        words = name.split("_")
        return "", next((word for word in words if word in tracks.PLAN["styles"]), ""), 0
    return track, style, int(seed)


def _distance(judges: Judges, judge: str, clips: list[Clip], styles: list[str]) -> Statistic:
    features = [judges.features(judge, clip) for clip in clips]
    return of_styles(styles, lambda chosen: sets.frechet_distance(
        torch.cat([features[i] for i in chosen]), judges.reference(judge)))


def _defective(clip: Clip) -> float:
    """Share of a clip's seconds with a finding."""
    seconds = math.ceil(clip.seconds)
    marked = {second for found in findings.defects(clip)
              for second in range(int(found.start), min(math.ceil(found.end), seconds))}
    return len(marked) / seconds


def _obedience(name: str, clip: Clip) -> tuple[float, float]:
    """Mean angle between way and command, degrees, and speed while it should stand, m/s."""
    track, _, seed = _parts(name)
    if not track:
        return math.nan, math.nan
    orders = tracks.commands(track, 1.0, seed)[round(tracks.PLAN["warm_up"] * FPS):]
    clip = clip.resample(FPS)
    frames = min(len(orders), len(clip)) - 1
    velocity = hips_path(clip).double().diff(dim=0)[:frames] * FPS
    wanted = torch.tensor([order.velocity for order in orders[:frames]]).to(velocity)
    half = round(FPS / 2)  # a step's sway is no way
    means = [x.unfold(0, 2 * half, 1).mean(-1) for x in (velocity, wanted)]
    (x, z), (to_x, to_z) = (mean.T for mean in means)
    angle = torch.atan2(x * to_z - z * to_x, x * to_x + z * to_z).abs().rad2deg()
    moving = wanted.norm(dim=-1).unfold(0, 2 * half, 1).amin(-1) > 0
    stands = (wanted.norm(dim=-1) == 0).unfold(0, round(SETTLED * FPS), 1).all(-1)
    still = velocity.norm(dim=-1)[round(SETTLED * FPS) - 1:][stands]
    return float(angle[moving].mean()), float(still.mean())
