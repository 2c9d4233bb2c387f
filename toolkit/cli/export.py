"""The verbs `export web` and `export clip`: a character in a page, a clip in any kind of file."""

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from toolkit import registry
from toolkit.cli import motion_files
from toolkit.cli.motion_files import Target, target
from toolkit.cli.verbs import Animation, Published, Roles, Selection, TrainedRun, Unit, Up, say
from toolkit.evaluation.findings import told
from toolkit.io import save as saving
from toolkit.training import published

Figure = Annotated[Path | None, Option(
    "--character", help="glTF, VRM or FBX file with a skinned mesh, in place of the mannequin.")]
Title = Annotated[str, Option(help="Heading of the page.")]
Half = Annotated[bool, Option("--half", help="Store numbers in 16 bits: half the size.")]


def web(
    out: Annotated[Path, Option(help="Page to write: .html.")],
    model: TrainedRun = None,
    parameters: Published = None,
    title: Title = "A character in any style",
    styles: Selection = None,
    half: Half = False,
    character: Figure = None,
    characters: Annotated[int, Option(
        min=1, help="Number of characters; all but the first walk on rings.")] = 1,
) -> None:
    """Write one page with network, styles and scene, which shows a character to steer."""
    from toolkit import view  # imported on demand: it needs the drawing libraries

    saving.check(out, (".html",))
    page = view.web(*published.either(model, parameters), out, title=title, styles=styles,
                    half=half, character=character, characters=characters)
    wrote(page)


def clip(
    source: Annotated[Path, Argument(metavar="IN", help="Motion file.")],
    out: Annotated[Path, Option(help=f"File to write: {', '.join(saving.suffixes())}.")],
    skeleton: Target = None,
    character: Figure = None,
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
    animation: Animation = None,
) -> None:
    """Convert a motion file to glTF (a skinned mannequin), BVH, web page, strip or film."""
    saving.check(out, saving.suffixes(), source, character, skeleton)
    figure = saving.figure_of(character)  # a file that is no character is refused now
    motion = motion_files.read(source, unit, up, roles, animation)
    if skeleton is not None:
        retargeting = registry.find("toolkit.motion.retargeting")
        before, motion = motion, retargeting.retarget(motion, target(skeleton))
        say(retargeting.report(before, motion))
    saving.save(motion, out, title=source.stem, progress=True, character=figure)
    wrote(out)
    say(told(motion if figure is None else figure.fitted(motion)))


def wrote(*files: Path) -> None:
    """Print which files were written."""
    for file in files:
        say(f"wrote {file}, {file.stat().st_size / 1e6:.2f} MB")
