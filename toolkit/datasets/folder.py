"""A folder of one's own recordings, with style and gait from a table, folders or names.

The table ``labels.csv`` has the columns ``file`` (path in the folder), ``style`` and, if wanted,
``gait``; files that it does not list are left out. Columns ``unit`` and ``up`` decide what was
guessed wrongly (`toolkit.load`). Without the table the style is the name of the first sub-folder,
and the gait that of the second one. What folders do not give comes from the file's name, whose
words are separated by ``_``, ``-`` or blanks: a word of `GAITS` is the gait, and of the others the
first that is not common to all files is the style.

Clips have the body joints alone (`toolkit.extra.characters.retargeting.pruned`), and all the same
ones. `survey` reads all files and says which of them can be used together.
"""

import logging
import os
import re
import warnings
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from toolkit import registry
from toolkit.datasets import style100
from toolkit.datasets.takes import Names, Root, Source, Take
from toolkit.io import files
from toolkit.io.load import read, readers
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, trajectory
from toolkit.motion.text import printable

TABLE = "labels.csv"
COLUMNS = "file", "style", "gait", "unit", "up"
_WORDS = ("walk", "run", "jog", "sneak", "crawl", "hop", "skip", "jump", "dance", "turn")
GAITS = {word: word for word in _WORDS}
GAITS |= {"walking": "walk", "running": "run", "jogging": "jog"}
GAITS |= dict.fromkeys(("idle", "idling", "stand", "standing"), "ID")
GAITS |= {code.lower(): code for code in style100.GAITS}
SHORTEST = trajectory.WHOLE / trajectory.FPS  # seconds of a clip with one usable frame
NAMED = 10  # files that a warning names
ALIKE = 1.3  # ratio of sizes up to which two bodies are used together

# The files and their labels ---------------------------------------------------------------------


@dataclass(frozen=True)
class OwnTake(Take):
    """A file with what its table says about it."""

    unit: float | str = "auto"
    up: str = "auto"


def labelled(folder: Path) -> list[OwnTake]:
    """Files of a folder with style and gait, without those that its table does not list."""
    if (folder / TABLE).exists():
        return _table(folder)
    found = [path for path in files.below(folder)
             if path.suffix.lower() in readers() and path.is_file()]

    # words of the names, without numbers; those common to all files say nothing
    words = {}
    for path in found:
        parts = re.split(r"[\W_]+", path.stem)
        words[path] = [word for word in parts if word and not word.isdigit()]
    common = set.intersection(*map(set, words.values())) if len(found) > 1 else set()

    takes = []
    for path in found:
        above = path.relative_to(folder).parts[:-1]
        gaits = [word for word in words[path] if word.lower() in GAITS]
        gait = above[1] if len(above) > 1 else (gaits or [""])[0]
        named = [word for word in words[path] if word.lower() not in GAITS]
        named = [word for word in named if word not in common] or named or [path.stem]
        style = above[0] if above else named[0]
        takes.append(OwnTake(path, style, GAITS.get(gait.lower(), gait)))
    return takes


def _table(folder: Path) -> list[OwnTake]:
    """The files that the table lists, by path."""
    place, takes = folder / TABLE, {}
    for number, row in files.table(place, COLUMNS[:2]):
        path, style, gait, unit, up = (row.get(column, "").strip() for column in COLUMNS)
        path = folder / path
        if not style:
            raise ValueError(f"{place}, line {number}: no style")
        if not (path.is_file() and path.is_relative_to(folder)):
            raise ValueError(f"{place}, line {number}: no file {str(path)!r}")
        takes[path] = OwnTake(path, style, gait, unit or "auto", up or "auto")
    return [takes[path] for path in sorted(takes)]


# One file ---------------------------------------------------------------------------------------


def read_file(path: Path, unit: float | str = "auto", up: str = "auto",
              roles: Mapping[str, str] | None = None,
              animation: str | None = None) -> tuple[Clip, list[str]]:
    """The clip of a file (`toolkit.load`), and what is doubtful about it.

    A floor far from zero is moved there.
    """
    interpretation = registry.find("recording.interpretation")
    clip, found = interpretation.interpret(read(path, animation), path, unit, up, roles)
    if abs(found.floor) > interpretation.FAR:
        clip = clip.moved(shift=(0.0, -found.floor, 0.0))
    return clip, found.doubts


def reason(error: Exception, path: Path) -> str:
    """What an error says about a file, without its name."""
    return str(error).removeprefix(str(path)).removeprefix(path.name).lstrip(",: ")


def _labelled_clip(take: OwnTake, target: Clip | None) -> tuple[Clip, list[str], int]:
    """The clip of a take, its body joints alone or on a rig; doubts; joints of the file."""
    whole, doubts = read_file(take.path, take.unit, take.up)
    whole = whole.replace(style=take.style, gait=take.gait)
    rigs = registry.find("toolkit.motion.retargeting")
    clip = rigs.pruned(whole) if target is None else rigs.retarget(whole, target)
    return clip, doubts, len(whole.skeleton)


# All files --------------------------------------------------------------------------------------


class Row(NamedTuple):
    """A file that can be used."""

    take: Take
    frames: int  # at the file's own rate
    seconds: float
    joints: int  # in the file
    doubts: list[str]


@dataclass(frozen=True)
class Survey:
    """What a folder holds for a training."""

    rows: list[Row]
    joints: int  # of the body
    left_out: dict[Path, str]  # files and why

    @property
    def takes(self) -> list[Take]:
        """Those that are used."""
        return [row.take for row in self.rows]

    def lines(self, root: Path) -> Iterator[str]:
        """What is used, by style and gait, and what is doubtful about it."""
        minutes = sum(row.seconds for row in self.rows) / 60
        yield (f"{_files(len(self.rows))}, {sum(row.frames for row in self.rows):,} frames, "
               f"{minutes:.1f} minutes; {self.joints} body joints of "
               f"{max(row.joints for row in self.rows)}")
        groups: dict[str, list[Row]] = defaultdict(list)
        for row in self.rows:
            groups[f"{row.take.style} {row.take.gait}".strip()].append(row)
        for label, rows in sorted(groups.items()):
            frames, seconds = sum(row.frames for row in rows), sum(row.seconds for row in rows)
            yield f"  {label}: {_files(len(rows))}, {frames:,} frames, {seconds:.1f} s"
        for row in self.rows:
            for doubt in row.doubts:
                yield printable(f"  doubtful: {row.take.path.relative_to(root)}: {doubt}")

    def warn(self, root: Path) -> None:
        """Warn of the files that are left out, and say why; at most `NAMED` are named."""
        if not self.left_out:
            return
        some = [f"{path.relative_to(root)}: {why}" for path, why in sorted(self.left_out.items())]
        if len(some) > NAMED:
            some[NAMED:] = [f"{len(some) - NAMED} more (toolkit.datasets.folder.survey)"]
        message = f"{root}: {_files(len(self.left_out))} left out: {'; '.join(some)}"
        warnings.warn(printable(message), stacklevel=5)


def survey(root: str | os.PathLike, target: Clip | None = None) -> Survey:
    """Reads every file of a folder and says what a training can use; ValueError if that is nothing.

    The files must have the same body joints, and people of about the same size (`ALIKE`). Where
    they differ, those of the larger number of frames are used. With ``target``, a clip of a rig,
    all are retargeted to it.
    """
    # files that can be read, by their body: names and parents of its joints, and its size
    rows: dict[tuple, list[Row]] = defaultdict(list)
    left_out: dict[Path, str] = {}
    folder = SOURCE.folder(root)
    takes = labelled(folder)
    for take in progress_bar(takes, desc="reading", unit="file", show=len(takes) > 20):
        try:
            clip, doubts, joints = _labelled_clip(take, target)
        except (ValueError, OSError, ImportError) as error:
            left_out[take.path] = reason(error, take.path)
            continue
        if clip.seconds < SHORTEST:
            left_out[take.path] = f"{clip.seconds:.1f} s; a clip of {SHORTEST:.1f} s is needed"
            continue
        skeleton = clip.skeleton
        size = float(skeleton.offsets[1:].norm(dim=-1).sum())
        body = skeleton.names, skeleton.parents, size
        body = next((known for known in rows if known[:2] == body[:2]
                     and 1 / ALIKE < known[2] / size < ALIKE), body)
        rows[body].append(Row(take, len(clip), clip.seconds, joints, doubts))
    if not rows:
        some = "; ".join(f"{path.name}: {why}" for path, why in list(left_out.items())[:3])
        raise ValueError(f"{folder}: no file can be used{f' ({some})' if some else ''}; expected "
                         f"{SOURCE.layout}")

    # those of the body with the most frames are used
    most = max(rows, key=lambda body: sum(row.frames for row in rows[body]))
    used = rows.pop(most)
    for body, others in rows.items():
        differ = "a body of another size" if body[:2] == most[:2] else "other joints"
        for row in others:
            left_out[row.take.path] = f"{differ} than most files; --skeleton retargets all files"
    return Survey(used, len(most[0]), left_out)


def _files(count: int) -> str:
    return f"{count} file{'s' * (count != 1)}"


# The folder as a dataset ------------------------------------------------------------------------


@dataclass(frozen=True)
class Own(Source):
    """The recordings of a folder, as the other datasets have them."""

    target: Clip | None = None  # of a rig that all are retargeted to

    def find(self, root: Root) -> list[Take]:
        """All takes of a folder that can be used, by `survey`; a warning names the other files.

        What is used is logged.
        """
        found, folder = survey(root, self.target), self.folder(root)
        for line in found.lines(folder):
            logging.getLogger("toolkit.datasets").info("%s", line)
        found.warn(folder)
        return found.takes

    def folder(self, root: Root) -> Path:
        """The folder, which must be given."""
        if root is None:
            raise ValueError("a folder of one's own needs its path: root=FOLDER")
        return super().folder(root)

    def read(self, takes: Iterable[Take]) -> Iterator[Clip]:
        """Labelled clips of takes, with their body joints; `survey` has listed the doubts."""
        for take in progress_bar(list(takes), desc="files", unit="file"):
            yield _labelled_clip(take, self.target)[0]


SOURCE = Own("folder", re.compile(".*"),
             f"recordings ({', '.join(readers())}), and {TABLE} or a sub-folder per style", "")


def load(root: Root = None, styles: Names = None, gaits: Names = None, *,
         target: Clip | None = None) -> list[Clip]:
    """Clips of a folder, see `toolkit.datasets.takes.Source.load`.

    With ``target`` all are on the rig of that clip.
    """
    return replace(SOURCE, target=target).load(root, styles, gaits)
