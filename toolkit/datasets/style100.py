"""100STYLE (Mason et al. 2022, CC BY 4.0): 100 styles of locomotion, 60 Hz, ``<Style>_<GAIT>.bvh``.

Two tables come with the files. ``Frame_Cuts.csv`` has the first and last frame of the labelled
motion of each take (a T-pose and a walk into the style come before). ``Dataset_List.csv`` describes
the styles.
"""

import csv
import io
import os
import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from toolkit.datasets.takes import Names, Root, Source
from toolkit.io import bvh, files
from toolkit.motion import Clip

GAITS = {
    "BR": "Backwards Run", "BW": "Backwards Walk", "FR": "Forwards Run", "FW": "Forwards Walk",
    "SR": "Sidestep Run", "SW": "Sidestep Walk", "ID": "Idling", "TR1": "Transitions",
    "TR2": "Transitions", "TR3": "Transitions",
}
# the new styles of the published experiments
HELD_OUT = ("HandsInPockets", "Roadrunner", "Skip", "Star", "WildArms")
RATE = 60.0  # frames per second of the recordings and of the frame numbers in Frame_Cuts.csv
CUTS = [f"{gait}_{end}" for gait in sorted(GAITS) for end in ("START", "STOP")]
TABLES = {
    "Dataset_List.csv": ["Style Name", "Description", "Stochastic", "Symmetric", "Notes"],
    "Frame_Cuts.csv": ["STYLE_NAME", *CUTS],
}  # name: columns
_NO_YES = ("No", "Yes")

SOURCE = Source(
    name="100style",
    pattern=re.compile(rf"(?P<style>[^_]+)_(?P<gait>{'|'.join(GAITS)})\.bvh"),
    layout="<Style>_<GAIT>.bvh files, flat or in a folder per style, next to Frame_Cuts.csv and "
           "Dataset_List.csv",
    home="https://zenodo.org/records/8127870 (100STYLE.zip)",
    gaits=GAITS,
)


@dataclass(frozen=True)
class StyleInfo:
    """A row of ``Dataset_List.csv``."""

    name: str
    description: str
    symmetric: bool  # it may be mirrored
    stochastic: bool  # it has no fixed cycle
    notes: str


def load(root: Root = None, styles: Names = None, gaits: Names = None) -> list[Clip]:
    """Clips of the dataset, see `toolkit.datasets.takes.Source.load`; gaits are keys of `GAITS`.

    A clip has only the frames from START to STOP (excluded) of ``Frame_Cuts.csv``; a take without
    them is a ValueError. STOP may lie past the end.
    """
    cuts = frame_cuts(root)
    takes = SOURCE.choose(root, styles, gaits, known_styles={style for style, _ in cuts})
    for take in takes:
        if (take.style, take.gait) not in cuts:
            raise ValueError(f"{take.path}: Frame_Cuts.csv has no START and STOP for this take")
    clips = []
    for clip in SOURCE.read(takes):
        start, stop = (round(frame * clip.fps / RATE) for frame in cuts[clip.style, clip.gait])
        clips.append(clip.cut(start, stop))
    return clips


def save(clips: Iterable[Clip], folder: str | os.PathLike, infos: Iterable[StyleInfo]) -> None:
    """Write clips in the layout of this dataset; `load` reads them back.

    Parameters
    ----------
    clips
        At most one per style and gait. The tables are written after all clips.
    folder
        Created if it does not exist.
    infos
        Descriptions of the clips' styles.

    Raises
    ------
    ValueError
        If the folder already holds a dataset, a clip's style or gait does not fit this layout, or
        two clips have the same.
    """
    folder = Path(folder)
    if (folder / "Frame_Cuts.csv").exists():
        raise ValueError(f"{folder}: already holds a dataset (Frame_Cuts.csv); choose an empty "
                         "folder")
    by_name = {info.name: info for info in infos}
    cuts: dict[str, dict[str, object]] = {}
    for clip in clips:
        name = f"{clip.style}_{clip.gait}.bvh"
        if clip.style not in by_name or not SOURCE.pattern.fullmatch(name):
            raise ValueError(f"{clip.name}: {name} needs a described style without _ and a gait of "
                             f"{', '.join(GAITS)}")
        row = cuts.setdefault(clip.style, {"STYLE_NAME": clip.style})
        if f"{clip.gait}_STOP" in row:
            raise ValueError(f"{clip.name}: a second clip of {clip.style} {clip.gait}; the layout "
                             "has room for one")
        bvh.save(clip, folder / name)
        row[f"{clip.gait}_START"] = 0
        row[f"{clip.gait}_STOP"] = round(len(clip) * RATE / clip.fps)
    described = []
    for info in map(by_name.get, cuts):
        values = (info.name, info.description, _NO_YES[info.stochastic], _NO_YES[info.symmetric],
                  info.notes)
        described.append(dict(zip(TABLES["Dataset_List.csv"], values, strict=True)))
    for name, rows in (("Dataset_List.csv", described), ("Frame_Cuts.csv", cuts.values())):
        text = io.StringIO()
        writer = csv.DictWriter(text, TABLES[name], restval="N/A", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        files.write_whole(folder / name, text.getvalue().encode())


def frame_cuts(root: Root = None) -> dict[tuple[str, str], tuple[int, int]]:
    """START and STOP (frames at 60 Hz) of every take by (style, gait), from ``Frame_Cuts.csv``."""
    cuts = {}
    path, rows = _table(root, "Frame_Cuts.csv")
    for line, row in rows:
        for gait in GAITS:
            ends = row[f"{gait}_START"], row[f"{gait}_STOP"]
            if ends == ("N/A", "N/A"):  # there is no such take
                continue
            try:
                start, stop = map(int, ends)
            except (TypeError, ValueError):
                raise ValueError(f"{path}, line {line}: {gait} needs two frame numbers or N/A, got "
                                 f"{ends}") from None
            if not 0 <= start < stop < 2**31:
                raise ValueError(f"{path}, line {line}: {gait} starts at frame {start} and stops "
                                 f"at {stop}")
            cuts[row["STYLE_NAME"], gait] = start, stop
    return cuts


def styles(root: Root = None) -> dict[str, StyleInfo]:
    """Description of each style by its name, in the order of ``Dataset_List.csv``."""
    infos = {}
    path, rows = _table(root, "Dataset_List.csv")
    for line, row in rows:
        for column in ("Symmetric", "Stochastic"):
            if row[column] not in _NO_YES:
                raise ValueError(f"{path}, line {line}: {column} must be Yes or No, got "
                                 f"{row[column]!r}")
        name = row["Style Name"]
        infos[name] = StyleInfo(name, row["Description"], row["Symmetric"] == "Yes",
                                row["Stochastic"] == "Yes", row["Notes"] or "")
    return infos


def _table(root: Root, name: str) -> tuple[Path, list[tuple[int, dict[str, str]]]]:
    """Path and (line number, row) of one of `TABLES`; ValueError if it cannot be read."""
    folder = SOURCE.folder(root)
    path = next((path for path in files.below(folder) if path.name == name), None)
    if path is None:
        raise ValueError(f"100style: no {name} in {folder}; expected {SOURCE.layout}; get it at "
                         f"{SOURCE.home}")
    rows = files.table(path, TABLES[name])
    if not rows:
        raise ValueError(f"{path}: the table has no row")
    return path, rows
