"""Commands that are imported when they are run: help is quick, and what one of them needs may be missing for the others."""

import functools
import io
import logging
import sys
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path
from typing import Annotated

import typer
from typer.core import TyperCommand, TyperGroup

PUBLISHED = "Folder of the published parameters, or lpn-film-100style once fetched."
TrainedRun = Annotated[Path | None, typer.Option("--model", help="A trained run; the embedded one where not given.")]
Root = Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")]
Published = Annotated[Path | None, typer.Option("--published", help=PUBLISHED)]


def group(homes: Mapping[str, tuple[str, str]], **settings) -> typer.Typer:
    """A command line of verbs.

    Parameters
    ----------
    homes
        Verb to where it lives, as ``"module:name"`` of a function or a typer application, and its help in one line.
    **settings
        What `typer.Typer` takes.
    """

    class Verbs(TyperGroup):
        @property
        def commands(self) -> dict[str, TyperCommand | TyperGroup]:
            """All of them, imported: for what walks the whole tree."""
            return {name: _whole(home) for name, (home, _) in homes.items()}

        @commands.setter
        def commands(self, none: dict) -> None:
            """For the parent class, which would keep them here."""

        def list_commands(self, context: typer.Context) -> list[str]:
            return list(homes)

        def get_command(self, context: typer.Context, name: str) -> TyperCommand | None:
            """Enough of a verb to list it."""
            return TyperCommand(name, help=homes[name][1]) if name in homes else None

        def resolve_command(self, context: typer.Context, arguments: list[str]) -> tuple:
            name, _, rest = super().resolve_command(context, arguments)
            return name, _whole(homes[name][0]), rest

    app = typer.Typer(cls=Verbs, no_args_is_help=True, add_completion=False, **settings)
    app.callback()(lambda: None)
    return app


@functools.cache
def _whole(home: str) -> TyperCommand | TyperGroup:
    module, name = home.split(":")
    found = getattr(import_module(module), name)
    if isinstance(found, typer.Typer):
        return typer.main.get_group(found)
    app = typer.Typer(add_completion=False)
    app.command()(found)
    return typer.main.get_command(app)


def execute(app: typer.Typer, arguments: list[str] | None = None) -> int:
    """Run a command line; returns the exit status. Bad input is one line on stderr and status 2."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # a pipe on Windows has no letters like → or ±
    try:
        app(arguments, standalone_mode=True)
    except (ValueError, OSError, ImportError) as error:
        _say(f"error: {error}")
        return 2
    except KeyboardInterrupt:
        _say("stopped")
        return 130
    return 0


class Lines(logging.Handler):
    """Log records as lines on stderr."""

    def emit(self, record: logging.LogRecord) -> None:  # noqa: D102
        _say(record.getMessage())


def _say(line: str) -> None:
    from toolkit.training import distributed

    if distributed.first():  # of several processes that train together, one
        print("".join(c if c.isprintable() else repr(c)[1:-1] for c in line), file=sys.stderr)
