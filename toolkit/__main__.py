"""Command line: ``python -m toolkit VERB``. One verb per job; bad input is one line on stderr and exit status 2."""

import sys
from pathlib import Path
from typing import Annotated

import typer

app = typer.Typer(no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False, help=__doc__)
data_app = typer.Typer(no_args_is_help=True, help="Look at datasets.")
bench_app = typer.Typer(no_args_is_help=True, help="Measure, and print what it is compared with.")
app.add_typer(data_app, name="data")
app.add_typer(bench_app, name="bench")

Root = Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")]


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
