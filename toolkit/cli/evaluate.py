"""The verb `evaluate`: the field's measures of anybody's motion files."""

import json
import math
from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from toolkit import evaluation
from toolkit.cli import motion_files
from toolkit.cli.verbs import Roles, Unit, Up, say
from toolkit.datasets import folder as own
from toolkit.evaluation.recognition import Recogniser
from toolkit.io import save as saving
from toolkit.io.files import write_whole
from toolkit.io.load import readers
from toolkit.motion import Clip, root_frames


def evaluate(
    folders: Annotated[list[Path], Argument(
        help="Folder of motion files, or one file; several folders are several methods.")],
    real: Annotated[Path | None, Option(
        help="Folder of real motion; files of the same names are pairs.")] = None,
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
    recogniser: Annotated[Path | None, Option(
        help="File of a recogniser of styles, for FMD, diversity and recognition (the style of a "
             "file as in `train`).")] = None,
    out: Annotated[Path | None, Option(help="File for the table: .json, .csv or .tex.")] = None,
) -> None:
    """Measure motion files with the field's measures, beside real ones.

    Files that cannot be read or measured are named, and left out.
    """
    if out is not None:
        check_table(out, ".json")
    names = method_names([folder.absolute().name for folder in folders])
    judge = None if recogniser is None else Recogniser.load(recogniser)
    named = {} if real is None else _clips(real, True, judge, unit, up, roles)
    methods = {}
    for name, folder in zip(names, folders, strict=True):
        clips = _clips(folder, real is not None, judge, unit, up, roles)
        if clips.keys() == named.keys():
            clips = {clip: clips[clip] for clip in named}
        elif len(clips) == len(named) > 1:
            other = min(clips.keys() ^ named.keys())
            raise ValueError(f"{folder} and {real}: as many files, but other names ({other}); name "
                             "pairs alike, or leave one file out")
        methods[name if len(folders) > 1 else "clips"] = list(clips.values())
    table = evaluation.report(methods, list(named.values()) or None, judge)
    say(table)
    if out is None:
        return
    if out.suffix == ".json":
        rows = [{name: _finite(value) for name, value in row.items()} for row in table.rows]
        text = json.dumps({"rows": rows, "notes": table.notes}, indent=1) + "\n"
        write_whole(out, text.encode())
    else:
        write_table(table, out)


def method_names(names: list[str]) -> list[str]:
    """The names, if none of them is there twice."""
    for name in names:
        if names.count(name) > 1:
            raise ValueError(f"two methods have the name {name}; rename one's file or folder")
    return names


def check_table(out: Path, *others: str) -> None:
    """Refuse a file for a table that cannot be written, before minutes of work."""
    saving.check(out, (*others, ".csv", ".tex"))
    if out.suffix not in others:
        evaluation.table.pandas()


def write_table(table: evaluation.table.Report, out: Path) -> None:
    """Write CSV or, for the ending .tex, LaTeX for the package booktabs."""
    frame = table.frame()
    text = frame.to_csv() if out.suffix == ".csv" else frame.to_latex(
        float_format="%.3g", na_rep="--", escape=True)
    write_whole(out, text.encode())


def _finite(value: object) -> object:
    """The value, None for a number that JSON does not have."""
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _clips(place: Path, paired: bool, judge: Recogniser | None, unit: float | str, up: str,
           roles: dict[str, str] | None) -> dict[str, Clip]:
    """Clips that can be measured, by path in the folder without suffix, with their styles."""
    if place.is_file():
        takes = [own.OwnTake(place, "", "")]
    elif place.is_dir():
        takes = own.labelled(place)
    else:
        raise ValueError(f"{place}: no such file or folder")
    clips = {}
    for take in takes:
        path = take.path
        try:
            metres = take.unit if unit == "auto" else unit
            clip = motion_files.read(path, metres, take.up if up == "auto" else up, roles)
            clip = clip.replace(style=take.style, gait=take.gait)
            for measure in evaluation.table.CLIP.values():
                measure(clip)
            if paired:
                root_frames(clip)
            if judge is not None:
                judge.embed(clip)
        except (ValueError, OSError, ImportError) as error:
            say(f"left out: {path.name}: {own.reason(error, path)}")
            continue
        name = path.relative_to(place) if place.is_dir() else Path(path.name)
        plain = name.with_suffix("").as_posix()
        clips[name.as_posix() if plain in clips else plain] = clip
    if not clips:
        raise ValueError(f"{place}: no motion file that can be measured; suffixes: "
                         f"{', '.join(readers())}")
    return clips
