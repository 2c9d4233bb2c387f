"""What the verbs share: options, and a command line that imports a verb when it is run."""

import contextlib
import functools
import io
import logging
import sys
import warnings
from collections.abc import Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any, TextIO

import typer
from typer import Option
from typer.core import TyperCommand, TyperGroup


def names(text: str) -> list[str]:
    """Names that the user separated by commas."""
    return text.split(",")


def _roles(text: str) -> dict[str, str]:
    """Joints by role, from ROLE=JOINT separated by commas."""
    pairs = [pair.split("=", 1) for pair in text.split(",")]
    if any(len(pair) < 2 for pair in pairs):
        raise typer.BadParameter(f"expected ROLE=JOINT,…, for example left_toe=LToe; got {text!r}")
    return {role.strip(): joint for role, joint in pairs}


LONGEST = 1000  # letters of an error, which may quote a file or an argument
Published = Annotated[Path | None, Option(
    "--published", help="Folder of the published parameters, or lpn-film-100style once fetched.")]
TrainedRun = Annotated[Path | None, Option(
    "--model", help="File of a trained model, or procedural (the default), or recorded; "
                      "MODULE:FILE for a model of your own.")]
Root = Annotated[Path | None, Option(help="Folder that holds the dataset.")]
Selection = Annotated[Any, Option(
    parser=names, metavar="A,B,…", help="Names to use; by default all.")]
Mirror = Annotated[bool, Option(
    "--mirror", help="Add mirror images (100STYLE: of symmetric styles).")]
Listed = Annotated[bool, Option(
    "--listed", help="Train on the training part of the dataset's list (`data split`) and hold out "
                     "its test part; 100style and bandai.")]
Seed = Annotated[int, Option(min=0, max=2**31 - 1, help="The same seed gives the same result.")]
Device = Annotated[str, Option(help="cpu, cuda, …")]
Resume = Annotated[bool, Option(
    "--resume", help="Continue from OUT.checkpoint, which a stopped run leaves.")]
Unit = Annotated[str, Option(
    "--unit", metavar="METRES",
    help="Metres of one unit of length in a motion file, or m, cm, mm, inch, dm, CMU; by default "
         "from the body's height.")]
Up = Annotated[str, Option(
    "--up", help="Axis of a motion file that points up: x, y, z, -x, -y, -z, or auto.")]
Roles = Annotated[Any, Option(
    "--roles", parser=_roles, metavar="ROLE=JOINT,…",
    help="Joints by role, for example left_toe=LToe, in place of those that were found.")]
Animation = Annotated[str | None, Option(
    "--animation", metavar="NAME|NUMBER",
    help="Animation of a glTF or FBX file that holds several; by default the first, number 0.")]
ClipSeconds = Annotated[float | None, Option(help="Length of each procedural clip.")]


class Verb(TyperCommand):
    """A verb whose name and help are known before its module is imported."""

    def __init__(self, name: str, home: str, text: str):
        super().__init__(name, help=text)
        self.home = home

    @functools.cached_property
    def imported(self) -> TyperCommand | TyperGroup:
        """The verb with its options, or its group of verbs."""
        module, name = self.home.split(":")
        app = getattr(import_module(module), name)
        if isinstance(app, TyperGroup):
            return app
        if not isinstance(app, typer.Typer):
            function, app = app, typer.Typer(add_completion=False)
            app.command()(function)
        command = typer.main.get_command(app)
        command.help = command.help or self.help
        return command

    def make_context(self, *arguments, **options):
        """Parse the arguments of the verb, which then takes this one's place."""
        return self.imported.make_context(*arguments, **options)


def group(homes: Mapping[str, tuple[str, str]], text: str) -> TyperGroup:
    """A command line of verbs, with ``text`` as its help.

    ``homes`` holds for each verb ``"module:name"`` of a function or a typer application, and its
    help in one line.
    """
    commands = {name: Verb(name, *home) for name, home in homes.items()}
    return TyperGroup(commands=commands, no_args_is_help=True, help=text)


def execute(app: TyperGroup, arguments: list[str] | None = None) -> int:
    """Run a command line; returns the exit status. Bad input prints one line and gives status 2."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        # a pipe on Windows cannot encode letters such as → or ±
        sys.stdout.reconfigure(errors="replace")
    try:
        with _notices():
            app(arguments)
    except SystemExit as ended:
        return int(ended.code or 0)
    except (ValueError, OSError, ImportError) as error:
        place, why = getattr(error, "filename", None), getattr(error, "strerror", None)
        _print_error(f"error: {place}: {why}" if place and why else f"error: {error}")
        return 2
    except KeyboardInterrupt:
        _print_error("stopped")
        return 130
    return 0


@contextlib.contextmanager
def _notices() -> Iterator[None]:
    """Print warnings, and which data is used, as lines on stderr."""
    logger, lines = logging.getLogger("toolkit.datasets"), logging.Handler(logging.INFO)
    level = logger.level
    lines.emit = lambda record: _print_error(record.getMessage())
    logger.addHandler(lines)
    logger.setLevel(logging.INFO)
    with warnings.catch_warnings():
        warnings.showwarning = lambda message, *_, **__: _print_error(f"warning: {message}")
        try:
            yield
        finally:
            logger.removeHandler(lines)
            logger.setLevel(level)


def say(text: object, file: TextIO | None = None) -> None:
    """Print a text, on stdout or in a file.

    Characters that move the cursor or reorder text appear as their escapes.
    """
    from toolkit.motion.text import printable

    print("\n".join(map(printable, str(text).split("\n"))), file=file, flush=True)


def _print_error(line: str) -> None:
    training = sys.modules.get("toolkit.training.distributed")
    if training is None or training.first():  # of several processes, one talks
        line = "".join(c if c.isprintable() else repr(c)[1:-1] for c in line)
        print(line if len(line) < LONGEST else f"{line[:LONGEST]} …", file=sys.stderr)

