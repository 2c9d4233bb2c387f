"""The verbs `benchmark run` and `benchmark score`."""

import dataclasses
from pathlib import Path
from typing import Annotated

import typer
from typer import Argument, Option

from toolkit.cli import motion_files
from toolkit.cli.evaluate import check_table, method_names, write_table
from toolkit.cli.verbs import Published, Roles, Unit, Up, say
from toolkit.extra import benchmark
from toolkit.io import bvh, save as saving
from toolkit.io.load import readers
from toolkit.training import published
from toolkit.training.run import model_file

app = typer.Typer(no_args_is_help=True, add_completion=False,
                  help="Score steered walks in a style by the benchmark StyleWalk.")
Judging = Annotated[Path | None, Option(
    "--judges", help="File of the judges; by default the one in examples/models of a checkout.")]
Out = Annotated[Path | None, Option(help="JSON file for the scores.")]


@app.command()
def run(
    model: Annotated[Path | None, Argument(
        help="File of a model, or procedural (the default), or recorded; MODULE:FILE for a model "
             "of your own.")] = None,
    parameters: Published = None,
    judges: Judging = None,
    out: Out = None,
    clips: Annotated[Path | None, Option(help="Folder for the walks, as BVH.")] = None,
) -> None:
    """Let a model walk all tracks in all styles that it knows, and score the walks."""
    _check(out)
    judging = benchmark.Judges.load(judges)
    walks = benchmark.walk(*published.either(model, parameters), progress=True)
    if clips is not None:
        clips.mkdir(parents=True, exist_ok=True)
        for name, clip in walks.items():
            bvh.save(clip, clips / f"{name}.bvh")
    files = {"judges": judges or benchmark.judges.FILE}
    if parameters is None:
        files["model"] = model_file(model or "procedural")
    _tell(benchmark.score(walks, judging, str(model or parameters or "procedural"), files), out)


@app.command()
def score(
    folder: Annotated[Path, Argument(help="Folder of motion files named track_style_seed.")],
    judges: Judging = None,
    out: Out = None,
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
) -> None:
    """Score anybody's motion files."""
    if not folder.is_dir():
        raise ValueError(f"{folder}: no such folder")
    _check(out)
    judging = benchmark.Judges.load(judges)
    paths = [path for path in sorted(folder.glob("*")) if path.suffix.lower() in readers()]
    if len({path.stem for path in paths}) < len(paths):
        raise ValueError(f"{folder}: two files have the same name but for the suffix")
    clips = {path.stem: motion_files.read(path, unit, up, roles) for path in paths}
    files = {"judges": judges or benchmark.judges.FILE}
    _tell(benchmark.score(clips, judging, folder.name, files), out)


@app.command()
def table(
    files: Annotated[list[Path], Argument(help="Files that run and score wrote.")],
    out: Annotated[Path, Option(help="File for the table: .tex or .csv.")],
) -> None:
    """Write one table of several methods, which the stems of the files name."""
    check_table(out)
    names = method_names([file.stem for file in files])
    scored = [dataclasses.replace(benchmark.Scores.load(file), name=name)
              for name, file in zip(names, files, strict=True)]
    write_table(benchmark.table(scored), out)


def _check(out: Path | None) -> None:
    """Refuse a file that cannot be written, before minutes of work."""
    if out is not None:
        saving.check(out, (".json",))


def _tell(scores, out: Path | None) -> None:
    """Print scores, and write them."""
    say(scores)
    if out is not None:
        scores.save(out)
