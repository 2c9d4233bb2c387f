"""The verb `export`: a character in a web page, its network as ONNX, a clip in any kind of file."""

from pathlib import Path
from typing import Annotated

import typer

from toolkit import export, published
from toolkit.cli.verbs import Published, Selection, TrainedRun
from toolkit.datasets.procedural import SKELETON
from toolkit.io import bvh
from toolkit.motion import Clip, retargeting, rotations

SKELETONS = {"100style": SKELETON}

app = typer.Typer(no_args_is_help=True, add_completion=False,
                  help="Write files for other programs: web page, ONNX, glTF, BVH.")


@app.command("web")
def web(
    out: Annotated[Path, typer.Option(help="Page to write: .html.")],
    model: TrainedRun = None,
    parameters: Published = None,
    title: Annotated[str, typer.Option(help="Heading of the page.")] = "A character in any style",
    styles: Selection = None,
    half: Annotated[bool, typer.Option("--half", help="Store numbers in 16 bits: half the size.")] = False,
) -> None:
    """Write one page with network, styles and scene; opened by a double click, it shows a character to steer."""
    from toolkit import view  # imported on demand: it needs the drawing libraries

    export.check(out, (".html",))
    _wrote(view.web(*published.either(model, parameters), out, title=title, styles=styles, half=half))


@app.command("onnx")
def onnx(
    out: Annotated[Path, typer.Option(help="File to write: .onnx; the style vectors go beside it.")],
    model: TrainedRun = None,
    parameters: Published = None,
) -> None:
    """Write the network (gating, experts, style vector as input) as ONNX and its style vectors as safetensors."""
    export.check(out, (".onnx",))
    net, bank = published.either(model, parameters)
    _wrote(*export.onnx.save(net, out, bank))


@app.command("clip")
def clip(
    source: Annotated[Path, typer.Argument(metavar="IN.bvh", help="Motion to read.")],
    out: Annotated[Path, typer.Option(help=f"File to write: {', '.join(export.SUFFIXES)}.")],
    skeleton: Annotated[str | None, typer.Option(help=f"Retarget to a skeleton: {', '.join(SKELETONS)}, or a file of it, "
                                                 "best with a T-pose.")] = None,
    unit: Annotated[float, typer.Option(min=1e-6, help="Metres of one unit of length in IN.bvh.")] = bvh.CENTIMETRE,
) -> None:
    """Convert a BVH file to glTF (skinned mannequin with its animation), BVH, web page, strip of poses or film."""
    export.check(out)
    if out.exists() and out.samefile(source):
        raise ValueError(f"{out}: is the file that is read; give another to write")
    motion = bvh.load(source, unit=unit)
    if skeleton is not None:
        before, motion = motion, export.retarget(motion, _target(skeleton))
        print(retargeting.report(before, motion))
    export.write(motion, out, title=source.stem, progress=True)
    _wrote(out)


def _target(skeleton: str) -> Clip:
    """The skeleton that an option names: a T-pose of one of `SKELETONS`, or the motion of a file."""
    if skeleton in SKELETONS:
        known = SKELETONS[skeleton]
        return Clip(known, rotations.identity(1, len(known)), [[0.0, 0.0, 0.0]], 60.0, name=skeleton)
    if not Path(skeleton).is_file():
        raise ValueError(f"--skeleton is one of {', '.join(SKELETONS)}, or a file; got {skeleton!r}")
    return bvh.load(skeleton)


def _wrote(*files: Path) -> None:
    for file in files:
        print(f"wrote {file}, {file.stat().st_size / 1e6:.2f} MB")
