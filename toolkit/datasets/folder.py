"""A folder of one's own recordings: any files that can be read, with style and gait from a table, folders or names.

The table ``labels.csv`` has the columns ``file`` (path in the folder), ``style`` and, if wanted, ``gait``; files that it
does not list are left out. Columns ``unit`` and ``up`` decide what was guessed wrongly (`toolkit.load`). Without the table
the style is the name of the first sub-folder, and the gait that of the second one.
What folders do not give comes from the file's name, whose words are separated by ``_``, ``-`` or blanks: a word of `GAITS`
is the gait, and of the others the first that is not common to all files is the style.

Clips have the body joints alone (`toolkit.motion.retargeting.pruned`), and all the same ones.
"""

import os
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from toolkit.datasets.takes import Names, Source, Take
from toolkit.io import files, interpretation
from toolkit.io.load import READERS, read
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, trajectory
from toolkit.motion.names import of_file, printable
from toolkit.motion.retargeting import pruned, retarget

TABLE = "labels.csv"
COLUMNS = "file", "style", "gait"
GAITS = {word: word for word in ("walk", "run", "jog", "sneak", "crawl", "hop", "skip", "jump", "dance", "turn")}
GAITS |= {"walking": "walk", "running": "run", "jogging": "jog"}
GAITS |= dict.fromkeys(("idle", "idling", "stand", "standing"), "ID")
GAITS |= {gait.lower(): gait for gait in ("FW", "BW", "SW", "FR", "BR", "SR", "ID", "TR1", "TR2", "TR3")}
SHORTEST = (trajectory.SAMPLES[-1] - trajectory.SAMPLES[0] + 2) / trajectory.FPS  # seconds of a clip with one usable frame
ALIKE = 1.3  # ratio of sizes up to which two bodies are used together
SUFFIXES = tuple(READERS)


@dataclass(frozen=True)
class OwnTake(Take):
    """A file with what its table says about it."""

    unit: float | str = "auto"
    up: str = "auto"


@dataclass(frozen=True)
class Survey:
    """What a folder holds for a training."""

    takes: tuple[Take, ...]  # that are used
    frames: dict[Path, int]  # of the used files, at their own rate
    seconds: dict[Path, float]
    joints: tuple[int, int]  # body joints of the used files, and the most joints that one of them has
    left_out: dict[Path, str]  # files and why
    doubts: dict[Path, list[str]] = field(default_factory=dict)  # warnings about used files

    def lines(self, root: Path) -> Iterator[str]:
        """What is used, by style and gait, and what is left out and why."""
        minutes = sum(self.seconds.values()) / 60
        yield (f"{_files(len(self.takes))}, {sum(self.frames.values()):,} frames, {minutes:.1f} minutes; "
               f"{self.joints[0]} body joints of {self.joints[1]}")
        groups: dict[tuple[str, str], list[Path]] = defaultdict(list)
        for take in self.takes:
            groups[take.style, take.gait].append(take.path)
        for (style, gait), paths in sorted(groups.items()):
            yield (f"  {' '.join(filter(None, (style, gait)))}: {_files(len(paths))}, "
                   f"{sum(self.frames[p] for p in paths):,} frames, {sum(self.seconds[p] for p in paths):.1f} s")
        for path, found in self.doubts.items():
            yield from (printable(f"  doubtful: {path.relative_to(root)}: {doubt}") for doubt in found)
        if self.left_out:
            yield f"left out: {_files(len(self.left_out))}"
        for path, why in self.left_out.items():
            yield printable(f"  {path.relative_to(root)}: {why}")


@dataclass(frozen=True)
class Own(Source):
    """The recordings of a folder, as the other datasets have them."""

    target: Clip | None = None  # of a rig that all are retargeted to

    def find(self, root: str | os.PathLike | None) -> list[Take]:
        """All takes of a folder that can be used; ValueError if there is none."""
        return list(survey(root, self.target).takes)

    def folder(self, root: str | os.PathLike | None) -> Path:
        """The folder, which must be given."""
        if root is None:
            raise ValueError("a folder of one's own needs its path: root=FOLDER")
        return super().folder(root)

    def read(self, takes: Iterable[Take]) -> Iterator[Clip]:
        """Labelled clips of takes, with their body joints."""
        for take in progress_bar(list(takes), desc="files", unit="file"):
            yield _fitted(_load(take)[0], self.target)  # `survey` has listed the doubts


SOURCE = Own("folder", re.compile(".*"), f"recordings ({', '.join(SUFFIXES)}), and {TABLE} or a sub-folder per style", "")


def load(root: str | os.PathLike | None = None, styles: Names = None, gaits: Names = None, *,
         target: Clip | None = None) -> list[Clip]:
    """Clips of a folder, see `toolkit.datasets.takes.Source.load`; with ``target`` all on the rig of that clip."""
    return replace(SOURCE, target=target).load(root, styles, gaits)


def survey(root: str | os.PathLike, target: Clip | None = None) -> Survey:
    """Reads every file of a folder and says what a training can use; ValueError if that is nothing.

    The files must have the same body joints, and people of about the same size (`ALIKE`). Where they differ, those of the
    larger number of frames are used. With ``target``, a clip of a rig, all are retargeted to it.
    """
    folder = SOURCE.folder(root)
    found = ((path, path.stat()) for path in files.below(folder) if path.is_file())
    return _survey(folder, tuple((path, about.st_size, about.st_mtime_ns) for path, about in found), target)


@lru_cache(maxsize=1)  # a training asks twice
def _survey(folder: Path, _signature: tuple, target: Clip | None) -> Survey:
    takes, left_out = labelled(folder)
    rigs: dict[tuple, list[tuple[Take, int, float, int]]] = defaultdict(list)
    doubts: dict[Path, list[str]] = {}
    for take in progress_bar(takes, desc="reading", unit="file", show=len(takes) > 20):
        try:
            whole, doubtful = _load(take)
            clip = _fitted(whole, target)
        except (ValueError, OSError, ImportError) as error:
            left_out[take.path] = reason(error, take.path)
            continue
        if clip.seconds < SHORTEST:
            left_out[take.path] = f"{clip.seconds:.1f} s; a clip of {SHORTEST:.1f} s is needed"
            continue
        if doubtful:
            doubts[take.path] = doubtful
        shape = clip.skeleton.names, clip.skeleton.parents, _height(clip)
        shape = next((known for known in rigs if known[:2] == shape[:2] and 1 / ALIKE < known[2] / shape[2] < ALIKE), shape)
        rigs[shape].append((take, len(clip), clip.seconds, len(whole.skeleton)))
    if not rigs:
        why = "; ".join(f"{path.name}: {reason}" for path, reason in list(left_out.items())[:3])
        raise ValueError(f"{folder}: no file can be used{f' ({why})' if why else ''}; expected {SOURCE.layout}")
    most = max(rigs, key=lambda shape: sum(frames for _, frames, *_ in rigs[shape]))
    for shape, rows in rigs.items():
        if shape != most:
            differ = "a body of another size" if shape[:2] == most[:2] else "other joints"
            left_out |= {take.path: f"{differ} than most files; --skeleton retargets all files" for take, *_ in rows}
    rows = rigs[most]
    used = tuple(take for take, *_ in rows)
    return Survey(used, {take.path: frames for take, frames, *_ in rows}, {take.path: s for take, _, s, _ in rows},
                  (len(most[0]), max(joints for *_, joints in rows)), left_out,
                  {path: found for path, found in doubts.items() if path not in left_out})


def read_file(path: Path, unit: float | str = "auto", up: str = "auto",
              roles: Mapping[str, str] | None = None) -> tuple[Clip, list[str]]:
    """The clip of a file (`toolkit.load`), a floor far from zero moved there, and what is doubtful about it."""
    clip, found = interpretation.interpret(read(path), path, unit, up, roles)
    if abs(found.floor) > interpretation.FAR:
        clip = clip.moved(shift=(0.0, -found.floor, 0.0))
    return clip, found.doubts


def reason(error: Exception, path: Path) -> str:
    """What an error says about a file, without its name."""
    return str(error).removeprefix(str(path)).removeprefix(path.name).lstrip(",: ")


def labelled(folder: Path) -> tuple[list[Take], dict[Path, str]]:
    """Files of a folder with style and gait, and those that the table leaves out."""
    found = [path for path in files.below(folder) if path.suffix.lower() in SUFFIXES and path.is_file()]
    if (folder / TABLE).exists():
        table = _table(folder)
        return ([OwnTake(path, *table[path]) for path in found if path in table],
                {path: f"not listed in {TABLE}" for path in found if path not in table})
    words = {path: [w for w in re.split(r"[\W_]+", of_file(path.stem)) if w and not w.isdigit()] for path in found}
    common = set.intersection(*map(set, words.values())) if len(found) > 1 else set()
    takes = []
    for path in found:
        above = [of_file(part) for part in path.relative_to(folder).parts[:-1]]
        gait = above[1] if len(above) > 1 else next((GAITS[w.lower()] for w in words[path] if w.lower() in GAITS), "")
        named = [w for w in words[path] if w.lower() not in GAITS]
        named = [w for w in named if w not in common] or named or [of_file(path.stem)]
        takes.append(OwnTake(path, above[0] if above else named[0], GAITS.get(gait.lower(), gait)))
    return takes, {}


def _table(folder: Path) -> dict[Path, tuple]:
    """Style, gait, unit and up axis of each file that the table lists."""
    place, found = folder / TABLE, {}
    for number, row in files.table(place, COLUMNS[:2]):
        path, style, gait, unit, up = (row.get(column, "").strip() for column in (*COLUMNS, "unit", "up"))
        path = folder / os.fsdecode(path.encode())
        if not style or not path.is_file():
            raise ValueError(f"{place}, line {number}: {f'no file {str(path)!r}' if style else 'no style'}")
        try:
            unit = float(unit)
        except ValueError:
            unit = unit or "auto"
        found[path] = style, gait, unit, up or "auto"
    return found


def _fitted(clip: Clip, target: Clip | None) -> Clip:
    """The body joints of a clip, or the clip on a rig."""
    return pruned(clip) if target is None else retarget(clip, target)


def _files(count: int) -> str:
    return f"{count} file{'s' * (count != 1)}"


def _load(take: OwnTake) -> tuple[Clip, list[str]]:
    clip, doubts = read_file(take.path, take.unit, take.up)
    return clip.replace(style=take.style, gait=take.gait), doubts


def _height(clip: Clip) -> float:
    """Sum of the lengths of all bones, metres."""
    return float(clip.skeleton.offsets[1:].norm(dim=-1).sum())
