"""The verb `evaluate`: the field's measures of anybody's motion files."""

import json
import math
from pathlib import Path
from typing import Annotated

import typer

from toolkit import evaluation, export
from toolkit.cli import motion_files
from toolkit.cli.verbs import Roles, Unit, Up, say
from toolkit.datasets import folder as own
from toolkit.evaluation.recognition import Recogniser
from toolkit.io.files import write_whole
from toolkit.motion import Clip, root_frames


def evaluate(
    folder: Annotated[Path, typer.Argument(help="Folder of motion files: BVH, glTF, VRM, FBX, AMC, NPZ; or one file.")],
    real: Annotated[Path | None, typer.Option(help="Folder of real motion; files of the same names are pairs.")] = None,
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
    recogniser: Annotated[Path | None, typer.Option(help="File of a recogniser of styles, for FMD, diversity and "
                                                    "recognition (the style of a file as in `train`).")] = None,
    out: Annotated[Path | None, typer.Option(help="JSON file for the rows of the table.")] = None,
) -> None:
    """Measure motion files with the field's measures, beside real ones.

    Files that cannot be read or measured are named, and left out.
    """
    if out is not None:
        export.check(out, ())
    judge = None if recogniser is None else Recogniser.load(recogniser)
    clips, truth = ({} if place is None else _clips(place, real is not None, judge, unit, up, roles)
                    for place in (folder, real))
    if real is not None and clips.keys() == truth.keys():
        truth = {name: truth[name] for name in clips}
    elif len(clips) == len(truth) > 1:
        raise ValueError(f"{folder} and {real}: as many files, but other names ({min(clips.keys() ^ truth.keys())}); "
                         "name pairs alike, or leave one file out")
    table = evaluation.report(clips.values(), truth.values() if real is not None else None, judge)
    say(table)
    if out is not None:
        rows = [{k: v if not isinstance(v, float) or math.isfinite(v) else None for k, v in row.items()}
                for row in table.rows]
        write_whole(out, (json.dumps({"rows": rows, "notes": table.notes}, indent=1) + "\n").encode())


def _clips(place: Path, paired: bool, judge: Recogniser | None, unit: float | str, up: str,
           roles: dict[str, str] | None) -> dict[str, Clip]:
    """Clips of a folder that can be measured, by path in it without suffix, with the styles that the folder gives."""
    if place.is_file():
        takes = [own.OwnTake(place, "", "")]
    elif place.is_dir():
        takes, _ = own.labelled(place)
    else:
        raise ValueError(f"{place}: no such file or folder")
    clips = {}
    for take in takes:
        path = take.path
        try:
            metres, axis = (take.unit if unit == "auto" else unit), (take.up if up == "auto" else up)
            clip = motion_files.read(path, metres, axis, roles).replace(style=take.style, gait=take.gait)
            for measure in evaluation.measures.CLIP.values():
                measure(clip)
            if paired:
                root_frames(clip)
            if judge is not None:
                judge.embed(clip)
        except (ValueError, OSError, ImportError) as error:
            say(f"left out: {path.name}: {own.reason(error, path)}")
            continue
        clips[path.relative_to(place).with_suffix("").as_posix() if place.is_dir() else path.stem] = clip
    if not clips:
        raise ValueError(f"{place}: no motion file that can be measured; suffixes: {', '.join(own.SUFFIXES)}")
    return clips
