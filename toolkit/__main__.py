"""Command line: ``python -m toolkit VERB``. One verb per job; bad input is one line on stderr and exit status 2."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from toolkit import datasets, features, training

app = typer.Typer(no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False, help=__doc__)
data_app = typer.Typer(no_args_is_help=True, help="Look at datasets.")
bench_app = typer.Typer(no_args_is_help=True, help="Measure, and print what it is compared with.")
app.add_typer(data_app, name="data")
app.add_typer(bench_app, name="bench")

Root = Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")]


@data_app.command("table1")
def data_table1(root: Root = None) -> None:
    """Print Table 1 of Mason et al. 2022, counted from 100STYLE's Frame_Cuts.csv."""
    rows = datasets.style100.table1(root)
    print(f"{'Motion gait':<16}{'Frames':>11}{'Time (m)':>10}{'Ratio (%)':>11}")
    for row in rows:
        print(f"{row.gait:<16}{row.frames:>11,}{row.minutes:>10}{row.ratio:>11.1f}")


@data_app.command("list")
def data_list(
    name: Annotated[str, typer.Argument(help=f"Dataset: {', '.join(datasets.DATASETS)}.")], root: Root = None
) -> None:
    """List a dataset's styles and how many takes of each gait the folder holds."""
    for style, gaits in datasets.contents(name, root).items():
        print(f"{style:<20}" + (", ".join(f"{gait} {n}" for gait, n in gaits.items()) or "no file here"))


@app.command()
def train(
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(datasets.DATASETS)}.")],
    out: Annotated[Path, typer.Option(help="The file to write: model, style bank and numbers (safetensors).")],
    root: Root = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    gaits: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    minutes: Annotated[float | None, typer.Option(help="Time budget.")] = None,
    epochs: Annotated[float | None, typer.Option(help="Passes of the shortest style; 90 as in the paper.")] = None,
    small: Annotated[bool, typer.Option("--small", help="Small sizes and fast settings; 30 s without a budget.")] = False,
    seed: Annotated[int, typer.Option(help="The same seed gives the same result.")] = 0,
    resume: Annotated[bool, typer.Option("--resume", help="Go on from OUT.checkpoint, which a stopped run leaves.")] = False,
) -> None:
    """Train LPN-FiLM; print the error on held-out frames beside predicting the mean and repeating the frame."""
    budget = {"epochs": epochs, "seconds": None if minutes is None else 60 * minutes}
    budget = {name: value for name, value in budget.items() if value is not None}
    config = (training.Config.quick if small else training.Config)(**budget, seed=seed)
    if out.is_dir():
        raise ValueError(f"{out}: is a folder; --out needs a file name")
    clips = datasets.load(data, root, *(None if names is None else names.split(",") for names in (styles, gaits)))
    found = features.build(clips, short="skip", progress=True)
    print(f"{found.n_frames:,} frames of {len(found.styles)} styles")
    checkpoint = out.with_name(out.name + ".checkpoint")
    run = training.fit(found, config, checkpoint, resume=resume, progress=True)
    run.save(out)
    checkpoint.unlink(missing_ok=True)
    print("held-out frames, mean squared error of normalised outputs")
    print(f"{'style':<20}{'model':>9}{'mean':>9}{'repeat':>9}{'bone (mm)':>11}")
    for row in run.table():
        print(f"{row['style']:<20}{row['error']:>9.4f}{row['mean']:>9.4f}{row['repeat']:>9.4f}{1000 * row['bone']:>11.1f}")
    print(f"{run.history[-1]['step']:,} steps in {run.history[-1]['elapsed']:.0f} s; wrote {out}")


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status."""
    try:
        app(arguments, standalone_mode=True)
    except (ValueError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("stopped", file=sys.stderr)
        return 130
    return 0


if __name__ == "__main__":
    sys.exit(main())
