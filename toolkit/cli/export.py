"""The verb `export`: a character in a web page, its network as ONNX, a clip in any kind of file."""

from pathlib import Path
from typing import Annotated

import typer

from toolkit import export, published
from toolkit.cli import verbs
from toolkit.datasets.procedural import SKELETON
from toolkit.io import bvh

SKELETONS = {"100style": SKELETON}

app = typer.Typer(no_args_is_help=True, help="To other programs: web page, ONNX, glTF, BVH.")


@app.command("web")
def web(
    out: Annotated[Path, typer.Option(help="Page to write: .html.")],
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    title: Annotated[str, typer.Option(help="Of the page.")] = "A character in any style",
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    half: Annotated[bool, typer.Option("--half", help="Store numbers in 16 bits: half the size.")] = False,
) -> None:
    """One page that holds network, styles and scene, to be opened by a double click: the character walks in the browser."""
    from toolkit import view  # drawing libraries, only on demand

    export.check(out, (".html",))
    net, bank = published.either(model, parameters)
    chosen = None if styles is None else styles.split(",")
    _wrote([view.web(net, bank, out, title=title, styles=chosen, half=half)])


@app.command("onnx")
def onnx(
    out: Annotated[Path, typer.Option(help="File to write: .onnx; the style vectors go beside it.")],
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
) -> None:
    """The network (gating, experts, style vector as input), and its style vectors as a safetensors file."""
    export.check(out, (".onnx",))
    net, bank = published.either(model, parameters)
    _wrote(export.onnx.save(net, out, bank))


@app.command("clip")
def clip(
    source: Annotated[Path, typer.Argument(metavar="IN.bvh", help="Motion to read.")],
    out: Annotated[Path, typer.Argument(metavar="OUT", help=f"File to write: {', '.join(export.SUFFIXES)}.")],
    skeleton: Annotated[str | None, typer.Option(help=f"Onto another skeleton: {', '.join(SKELETONS)}.")] = None,
    unit: Annotated[float, typer.Option(min=1e-6, help="Metres of one unit of length in IN.bvh.")] = bvh.CENTIMETRE,
) -> None:
    """A BVH file as glTF (skinned mannequin with its animation), BVH, web page, strip of poses or film."""
    export.check(out)
    if skeleton is not None and skeleton not in SKELETONS:
        raise ValueError(f"--skeleton is one of {', '.join(SKELETONS)}; got {skeleton!r}")
    if out.exists() and out.samefile(source):
        raise ValueError(f"{out}: is the file that is read; give another to write")
    motion = bvh.load(source, unit=unit)
    if skeleton is not None:
        motion = export.retarget(motion, SKELETONS[skeleton])
    export.write(motion, out, title=source.stem, progress=True)
    _wrote([out])


def _wrote(files: list[Path]) -> None:
    for file in files:
        print(f"wrote {file}, {file.stat().st_size / 1e6:.2f} MB")
