"""Command line: ``python -m experiments seven-models`` trains, measures and shows the seven models
of Table 2.
"""

import math
from pathlib import Path
from typing import Annotated

import pandas as pd
import typer

from experiments.seven_models import failures, hundred, load, models, recorded, results, vectors
from experiments.tables import Result
from toolkit import datasets, networks, training
from toolkit.evaluation.recognition import Recogniser
from toolkit.extra import store
from toolkit.features import Features
from toolkit.training import Run
from toolkit.training.loss import STEPS

PUBLISHED = "Folder of the published parameters, or lpn-film-100style once fetched."
app = typer.Typer(invoke_without_command=True)

Names = Annotated[str | None, typer.Option(help="Comma-separated names; default: all.")]
Out = Annotated[Path, typer.Option(help="Folder of the runs; finished runs in it are not "
                                        "repeated.")]
OUT = Path("out/comparison")
Named = Annotated[str
                  | None, typer.Option(help="Store the result under this name in docs/results.")]


@app.callback()
def compare(
    context: typer.Context,
    data: Annotated[str
                    | None,
                    typer.Option(help=f"Dataset: {', '.join(datasets.DATASETS)}; or a store's "
                                      f"folder.")] = None,
    root: Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")] = None,
    styles: Names = None,
    gaits: Names = None,
    clip_seconds: Annotated[float, typer.Option(help="Length of procedural clips.")] = 20.0,
    names: Annotated[str, typer.Option("--models", help="Comma-separated names, or all.")] = "all",
    seeds: Annotated[int, typer.Option(min=1, help="Runs of every model, seeds 0, 1, …")] = 3,
    steps: Annotated[int, typer.Option(min=1, help="Training steps of every run.")] = 4000,
    size: Annotated[str,
                    typer.Option(help=f"Sizes: {', '.join(models.SIZES)}.")] = "small",
    listed: Annotated[bool, typer.Option(
        "--listed", help="Hold out the test part of the dataset's list (`data split`).")]
    = False,
    out: Out = OUT,
    device: Annotated[str, typer.Option(help="Device of the training: cpu, cuda.")] = "cpu",
) -> None:
    """The seven models of Table 2, trained on the same data, compared one step ahead and in closed
    loop.

    All runs have the same number of steps. The results are stored and printed; runs of other seeds
    or models that the folder of the same comparison already holds are in the table, too.
    """
    if context.invoked_subcommand is not None:
        return
    if data is None:
        raise ValueError(f"--data is missing: a dataset ({', '.join(datasets.DATASETS)}) or the "
                         f"folder of a store")
    if size not in models.SIZES:
        raise ValueError(f"unknown size {size!r}; known: {', '.join(models.SIZES)}")
    chosen = tuple(networks.MODELS) if names == "all" else tuple(names.split(","))
    if unknown := [name for name in chosen if name not in networks.MODELS]:
        raise ValueError(f"unknown model {unknown[0]!r}; known: {', '.join(networks.MODELS)}")
    source = {"data": data, "root": None if root is None else str(root.resolve()), "styles": styles,
              "gaits": gaits,
              "clip_seconds": clip_seconds if data == "procedural" else None, "listed": listed}
    found = load(**source)
    print(f"{_described(source)}: {found.n_frames:,} frames of {len(found.styles)} styles")
    show(models.compare(found, source, models.Plan(size, steps, device), chosen, seeds, out, True))
    print(f"wrote {out / 'comparison.json'}")


@app.command()
def table2() -> None:
    """Parameters of the built models at the paper's sizes (25 joints, 95 styles), compared with the
    printed Table 2.
    """
    rows = networks.table2()
    columns = ["A.S.N.", "S.M.N.", "P.S.R."]
    columns += [f"printed {name}" for name in columns]
    table = {row.name: [row.synthesis, row.style, row.per_style, *row.printed] for row in rows}
    print(pd.DataFrame(table, columns).T.map("{:,}".format).to_string())
    for note, counted in {row.note: row.style_as_printed for row in rows if row.note}.items():
        names = ", ".join(row.name for row in rows if row.note == note)
        print(f"S.M.N. of {names}: {note}; counted so, {counted:,}")


@app.command("ceiling")
def ceiling_(parameters: Annotated[Path, typer.Option("--published", help=PUBLISHED)],
             out: Out = OUT) -> None:
    """The same measures of the published network, on data that it made: the best that a model can
    do there.
    """
    _, data, plan = _opened(out)
    recogniser = models.judge(data, out)
    models.ceiling(parameters, data, recogniser, plan, out)
    show(models.collect(data, plan, recogniser, out))


@app.command("store")
def store_(name: Annotated[str, typer.Option(help="Name of the stored result.")],
           about: Annotated[str, typer.Option(help="A sentence: the data and the budget.")],
           out: Out = OUT) -> None:
    """Store the table of a comparison as a result that the pages of docs/ draw (`python -m
    experiments tables`).
    """
    settings, data, plan = _opened(out)
    table = models.collect(data, plan, models.judge(data, out), out)
    print(f"wrote {results.comparison(name, about, _command(settings), table).save()}")


@app.command("recorded")
def recorded_(model: Annotated[str, typer.Option(help="Which model's runs.")] = "lpn-film",
              result: Named = None,
              out: Out = OUT) -> None:
    """Held-out recordings, followed by the runs of a comparison with --listed: the field's
    measures.
    """
    settings = models.read_json(out / models.SETTINGS)
    source = settings["source"]
    if not source.get("listed"):
        raise ValueError(f"{out}: its comparison was not made with --listed, so no take is held "
                         f"out as a whole")
    root = source["root"]
    parts = datasets.split(source["data"], root)
    names = {block.gait for block in parts.test if block.style in settings["frames"]}
    clips = [clip for clip in datasets.load(source["data"], root)
             if clip.name.removesuffix(".bvh") in names]
    runs = _runs(out, model)
    rows = recorded.compared(runs, clips, Recogniser.load(out / "recogniser.safetensors"))
    about = (
        f"{len(clips)} held-out takes of {len(settings['frames'])} styles, followed for "
        f"{recorded.SECONDS:g} s each time"
    )
    Result(result or "recorded", about, _command(settings) + f", then recorded --model {model}",
           results.RECORDED, rows,
           {"takes": len(clips), "styles": len(settings["frames"]), "seeds": len(runs),
            "seconds": recorded.SECONDS, "walks": len(recorded.moments(clips))},
           ).show(result is not None)


@app.command("vectors")
def vectors_(model: Annotated[str, typer.Option(help="Which model's runs.")] = "lpn-film",
             result: Named = None,
             out: Out = OUT) -> None:
    """Style vectors of one clip, of the mean of many, and fitted to frames, on held-out frames and
    in closed loop.
    """
    settings, data, _ = _opened(out)
    runs = _runs(out, model)
    rows = vectors.compared(runs, data, models.judge(data, out), progress=True)
    Result(result or "vectors", f"{model}, {len(settings['frames'])} styles",
           _command(settings) + f", then vectors --model {model}", results.VECTORS, rows,
           {"styles": len(settings["frames"]), "seeds": len(runs), "steps": settings["steps"],
            "held-out frames of a style": vectors.FRAMES,
            "steps for each style": STEPS}).show(result is not None)


@app.command("failures")
def failures_(
    out: Out = OUT,
    result: Annotated[str
                      | None, typer.Option(help="Store the cases as "
                                                "docs/results/RESULT-CASE.json.")] = None,
) -> None:
    """The failure cases of section 5.1, measured on the runs of a finished comparison."""
    settings, data, plan = _opened(out)
    for case in failures.cases(data, plan, out, result or "case", _command(settings)):
        case.show(result is not None)


@app.command("hundred")
def hundred_(
    parameters: Annotated[Path, typer.Option("--published", help=PUBLISHED)],
    out: Annotated[Path, typer.Option(help="Folder for the clips, in the layout of 100STYLE.")],
    seconds: Annotated[float, typer.Option(help="Length of each of a style's eight clips.")] = 12.0,
) -> None:
    """Make clips of a hundred styles with the published parameters, in the layout of 100STYLE.

    Such data favour networks of the same kind.
    """
    fallen = hundred.write(parameters, out, seconds)
    print(f"without clips in which the character fell: {', '.join(fallen) or 'none'}")
    print(f"wrote {len(list(out.glob('*.bvh')))} clips; compare with --data 100style --root {out}")


def _opened(out: Path) -> tuple[dict, Features, models.Plan]:
    """Settings, data and plan of the comparison in a folder."""
    settings = models.read_json(out / models.SETTINGS)
    plan = models.Plan(settings["size"], settings["steps"])
    return settings, load(**settings["source"]), plan


def _runs(out: Path, model: str) -> list[Run]:
    """The finished runs of a model in a folder."""
    paths = sorted((out / "runs").glob(f"{model}-*.safetensors"))
    if not paths:
        raise ValueError(f"{out}: has no run of {model}")
    return [training.load(path) for path in paths]


def _command(settings: dict) -> str:
    """The command of a comparison, with the places of this machine left out."""
    source = settings["source"]
    data = "STORE" if store.is_store(source["data"]) else source["data"]
    options = {"styles": source["styles"], "gaits": source["gaits"],
               "root": source["root"] and "ROOT"}
    words = [f"--{name} {value}" for name, value in options.items() if value]
    words += ["--listed"] if source.get("listed") else []
    return " ".join(["python -m experiments seven-models --data", data, *words,
                     f"--size {settings['size']}",
                     f"--steps {settings['steps']}"])


def _described(source: dict) -> str:
    """Description of the data."""
    seconds = source["clip_seconds"]
    parts = (
        Path(source["data"]).name, source["styles"], source["gaits"],
        seconds and f"{seconds:g} s per clip"
    )
    return "; ".join(part.replace(",", ", ") for part in parts if part)


def show(table: dict) -> None:
    """Print the result of `experiments.seven_models.models.compare`."""
    settings = table["settings"]
    about = f"{_described(settings['source'])}: {len(settings['frames'])} styles"
    found = results.comparison("comparison", about, _command(settings), table)
    found.show(store=False)
    if math.isfinite(table["recogniser"]):
        print(f"The recogniser, trained on the training part, names {table['recogniser']:.0%} of "
              f"held-out seconds rightly. docs/comparison.md explains the columns.")
