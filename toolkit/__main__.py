"""Command line: ``python -m toolkit VERB``. One verb per job; bad input is one line on stderr and exit status 2."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from toolkit import datasets

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
