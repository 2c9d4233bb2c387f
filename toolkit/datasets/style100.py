"""100STYLE (Mason et al. 2022, CC BY 4.0): 100 styles of locomotion, 60 Hz, files ``<Style>_<GAIT>.bvh``.

Two tables come with it: ``Frame_Cuts.csv``, where each take starts and stops being what its name says (a T-pose and a walk
into the style come first), and ``Dataset_List.csv``, what each style is.
"""

import csv
import io
import math
import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from toolkit.datasets.takes import Source
from toolkit.io import bvh
from toolkit.io.files import atomic_write
from toolkit.motion import Clip

GAITS = {
    "BR": "Backwards Run",
    "BW": "Backwards Walk",
    "FR": "Forwards Run",
    "FW": "Forwards Walk",
    "SR": "Sidestep Run",
    "SW": "Sidestep Walk",
    "ID": "Idling",
    "TR1": "Transitions",
    "TR2": "Transitions",
    "TR3": "Transitions",
}
HELD_OUT = ("HandsInPockets", "Roadrunner", "Skip", "Star", "WildArms")  # kept for new styles in the published training
RATE = 60.0  # frames per second, of the recordings and of the frame numbers in Frame_Cuts.csv

SOURCE = Source(
    name="100style",
    pattern=re.compile(rf"(?P<style>[^_]+)_(?P<gait>{'|'.join(GAITS)})\.bvh"),
    layout="<Style>_<GAIT>.bvh files, flat or in a folder per style, next to Frame_Cuts.csv and Dataset_List.csv",
    home="https://zenodo.org/records/8127870 (100STYLE.zip)",
)


@dataclass(frozen=True)
class StyleInfo:
    """One style of ``Dataset_List.csv``.

    A style that is not ``symmetric`` must not be mirrored; a ``stochastic`` one has no fixed cycle.
    """

    name: str
    description: str
    symmetric: bool
    stochastic: bool
    notes: str


@dataclass(frozen=True)
class Table1Row:
    """One row of the paper's Table 1: a gait, its frames, minutes and share of all frames in percent, as printed."""

    gait: str
    frames: int
    minutes: int
    ratio: float


def load(
    root: str | os.PathLike | None = None,
    styles: str | Iterable[str] | None = None,
    gaits: str | Iterable[str] | None = None,
    *,
    cut: bool = True,
) -> list[Clip]:
    """Clips of the dataset.

    Parameters
    ----------
    root
        A folder with the files and the two tables, at any depth.
    styles, gaits
        Which ones; None for all that the folder has. Gaits are the keys of `GAITS`.
    cut
        Keep only the frames from START to STOP (not included) of ``Frame_Cuts.csv``; STOP may lie past the end.

    Raises
    ------
    ValueError
        If the folder, a table, a style or a gait is not there, or a take has no cut; BVHError if a file is malformed.
    """
    cuts = frame_cuts(root)
    takes = SOURCE.choose(root, styles, gaits, known_styles={style for style, _ in cuts}, known_gaits=GAITS)
    for take in takes if cut else ():
        if (take.style, take.gait) not in cuts:
            raise ValueError(f"{take.path}: Frame_Cuts.csv has no START and STOP for this take")
    clips = []
    for clip in SOURCE.read(takes):
        if cut:
            start, stop = (round(frame * clip.fps / RATE) for frame in cuts[clip.style, clip.gait])
            clip = clip.cut(start, stop)
        clips.append(clip)
    return clips


def save(clips: Iterable[Clip], folder: str | os.PathLike, infos: Iterable[StyleInfo]) -> None:
    """Write clips as this dataset is laid out: ``<Style>_<GAIT>.bvh`` and the two tables, so that `load` reads them back.

    Parameters
    ----------
    clips
        At most one of each style and gait; they are written as they come, the tables last, each file whole or not at all.
    folder
        Where to; made if it is not there.
    infos
        What the clips' styles are.

    Raises
    ------
    ValueError
        If the folder already holds a dataset, or a clip's style or gait has no place in this layout or comes twice.
    """
    folder = Path(folder)
    if (folder / "Frame_Cuts.csv").exists():
        raise ValueError(f"{folder}: already holds a dataset (Frame_Cuts.csv); choose an empty folder")
    by_name = {info.name: info for info in infos}
    cuts: dict[str, dict[str, int]] = {}
    for clip in clips:
        name = f"{clip.style}_{clip.gait}.bvh"
        if clip.style not in by_name or not SOURCE.pattern.fullmatch(name):
            raise ValueError(f"{clip.name}: {name} needs a described style without _ and a gait of {', '.join(GAITS)}")
        if clip.gait in cuts.setdefault(clip.style, {}):
            raise ValueError(f"{clip.name}: a second clip of {clip.style} {clip.gait}; the layout has room for one")
        bvh.save(clip, folder / name)
        cuts[clip.style][clip.gait] = round(len(clip) * RATE / clip.fps)
    about = [("Style Name", "Description", "Stochastic", "Symmetric", "Notes")]
    about += [(i.name, i.description, *("Yes" if x else "No" for x in (i.stochastic, i.symmetric)), i.notes)
              for i in map(by_name.get, cuts)]
    ends = [("STYLE_NAME", *(f"{gait}_{end}" for gait in sorted(GAITS) for end in ("START", "STOP")))]
    ends += [(style, *(x for gait in sorted(GAITS) for x in ((0, stops[gait]) if gait in stops else ("N/A", "N/A"))))
             for style, stops in cuts.items()]
    for name, rows in (("Dataset_List.csv", about), ("Frame_Cuts.csv", ends)):
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows(rows)
        with atomic_write(folder / name) as file:
            file.write(text.getvalue().encode())


def frame_cuts(root: str | os.PathLike | None = None) -> dict[tuple[str, str], tuple[int, int]]:
    """START and STOP (frames at 60 Hz) of every take by (style, gait); takes that do not exist (``N/A``) are left out.

    Raises
    ------
    ValueError
        If the table is not there, or a line of it cannot be read.
    """
    cuts = {}
    columns = ["STYLE_NAME", *(f"{gait}_{end}" for gait in GAITS for end in ("START", "STOP"))]
    path, rows = _table(root, "Frame_Cuts.csv", columns)
    for line, row in rows:
        for gait in GAITS:
            ends = row[f"{gait}_START"], row[f"{gait}_STOP"]
            if ends == ("N/A", "N/A"):
                continue
            try:
                start, stop = map(int, ends)
            except (TypeError, ValueError):
                raise ValueError(f"{path}, line {line}: {gait} needs two frame numbers or N/A, got {ends}") from None
            if not 0 <= start < stop < 2**31:
                raise ValueError(f"{path}, line {line}: {gait} starts at frame {start} and stops at {stop}")
            cuts[row["STYLE_NAME"], gait] = start, stop
    return cuts


def styles(root: str | os.PathLike | None = None) -> dict[str, StyleInfo]:
    """What each style is, by name in the table's order.

    Raises
    ------
    ValueError
        If the table is not there, or a line of it cannot be read.
    """
    infos = {}
    path, rows = _table(root, "Dataset_List.csv", ["Style Name", "Description", "Stochastic", "Symmetric", "Notes"])
    for line, row in rows:
        flags = {}
        for column in ("Symmetric", "Stochastic"):
            if row[column] not in ("Yes", "No"):
                raise ValueError(f"{path}, line {line}: {column} must be Yes or No, got {row[column]!r}")
            flags[column.lower()] = row[column] == "Yes"
        name = row["Style Name"]
        infos[name] = StyleInfo(name, row["Description"], notes=row["Notes"] or "", **flags)
    return infos


def published_order(root_or_names: str | os.PathLike | Iterable[str] | None = None) -> list[str]:
    """Style names in the index order of the published parameters: 95 in alphabetical order, then the five of `HELD_OUT`.

    Parameters
    ----------
    root_or_names
        The dataset's folder, or the 100 names in any order.

    Raises
    ------
    ValueError
        If these are not 100 names with the five held-out ones among them.
    """
    from_folder = root_or_names is None or isinstance(root_or_names, str | os.PathLike)
    names = set(styles(root_or_names) if from_folder else root_or_names)
    if len(names) != 100 or not names >= set(HELD_OUT):
        missing = sorted(set(HELD_OUT) - names)
        raise ValueError(f"the published order needs all 100 styles; got {len(names)}"
                         + (f", without {', '.join(missing)}" if missing else ""))
    return sorted(names - set(HELD_OUT)) + list(HELD_OUT)


def table1(root: str | os.PathLike | None = None) -> list[Table1Row]:
    """The paper's Table 1, counted from ``Frame_Cuts.csv``: eight gaits (TR1 to TR3 merged) and the total.

    Every printed number comes out, if two columns are read as shares of a rounded total by the largest remainder, so that
    each column adds up. Ratios share 100.0 % (Backwards Walk is 18.949 %, printed 19.0). Minutes share 1125: the frames
    last 1126.7 minutes at 60 Hz (so Backwards Run and Transitions, 120.6 and 218.6, are printed 120 and 218), and 1125 is
    that total to the nearest quarter of an hour. The paper does not say how it rounds.
    """
    frames = dict.fromkeys(GAITS.values(), 0)
    for (_, gait), (start, stop) in frame_cuts(root).items():
        frames[GAITS[gait]] += stop - start
    if not (total := sum(frames.values())):
        raise ValueError(f"{SOURCE.folder(root)}: Frame_Cuts.csv has no frame of any take")
    total_minutes = 15 * round(total / RATE / 60 / 15)
    minutes, tenths = _apportion(list(frames.values()), total_minutes), _apportion(list(frames.values()), 1000)
    rows = [Table1Row(g, n, m, t / 10) for (g, n), m, t in zip(frames.items(), minutes, tenths, strict=True)]
    return [*rows, Table1Row("Total", total, total_minutes, 100.0)]


def _apportion(counts: list[int], total: int) -> list[int]:
    """Whole numbers proportional to ``counts`` that add up to ``total``: the largest remainders are rounded up."""
    shares = [n * total / sum(counts) for n in counts]
    whole = [math.floor(s) for s in shares]
    by_remainder = sorted(range(len(counts)), key=lambda i: whole[i] - shares[i])
    for i in by_remainder[: total - sum(whole)]:
        whole[i] += 1
    return whole


def _table(root: str | os.PathLike | None, name: str, columns: list[str]) -> tuple[Path, list[tuple[int, dict[str, str]]]]:
    """Path and (line number, row) of a CSV in the dataset's folder, with the columns checked."""
    folder = SOURCE.folder(root)
    path = next(iter(sorted(folder.rglob(name))), None)
    if path is None:
        raise ValueError(f"100style: no {name} in {folder}; expected {SOURCE.layout}; get it at {SOURCE.home}")
    with path.open(encoding="utf-8-sig", errors="replace", newline="") as file:
        reader = csv.DictReader(file, restval="")
        try:
            if missing := [c for c in columns if c not in (reader.fieldnames or [])]:
                raise ValueError(f"{path}, line 1: expected the columns {', '.join(columns)}; without {', '.join(missing)}")
            rows = [(reader.line_num, row) for row in reader]
        except csv.Error as error:
            raise ValueError(f"{path}, line {reader.line_num + 1}: {error}") from error
    if not rows:
        raise ValueError(f"{path}: the table has no row")
    return path, rows
