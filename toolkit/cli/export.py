"""The verb `export`: a character in a web page, its network as ONNX, a clip in any kind of file."""

import json
from pathlib import Path
from typing import Annotated

import typer

from toolkit import export, published, shots
from toolkit.cli import motion_files
from toolkit.cli.motion_files import Target, target
from toolkit.cli.rollout import blend_of
from toolkit.cli.verbs import Names, Published, Roles, Selection, TrainedRun, Unit, Up, say
from toolkit.export import pack as packs
from toolkit.motion import retargeting

Figure = Annotated[Path | None, typer.Option("--character", help="glTF or VRM file with a skinned mesh, in place of the "
                                             "mannequin.")]

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
    character: Figure = None,
    characters: Annotated[int, typer.Option(min=1, help="Number of characters; all but the first walk on rings.")] = 1,
) -> None:
    """Write one page with network, styles and scene; opened by a double click, it shows a character to steer."""
    from toolkit import view  # imported on demand: it needs the drawing libraries

    export.check(out, (".html",))
    _wrote(view.web(*published.either(model, parameters), out, title=title, styles=styles, half=half,
                    character=character, characters=characters))


@app.command("director")
def director(
    out: Annotated[Path, typer.Option(help="Page to write: .html.")],
    file: Annotated[Path | None, typer.Option("--shots", help="JSON file of the first shots.")] = None,
    model: TrainedRun = None,
    parameters: Published = None,
    title: Annotated[str, typer.Option(help="Heading of the page.")] = "Plan a shot",
    styles: Selection = None,
    half: Annotated[bool, typer.Option("--half", help="Store numbers in 16 bits: half the size.")] = False,
    character: Figure = None,
) -> None:
    """Write one page in which shots are planned: a floor map, a timeline of styles, the characters that walk at once."""
    from toolkit.view import director as desk  # imported on demand: it needs the drawing libraries

    export.check(out, (".html",))
    first = None if file is None else shots.Scene.load(file)
    _wrote(desk.web(*published.either(model, parameters), out, first, title=title, styles=styles, half=half,
                    character=character))


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
    source: Annotated[Path, typer.Argument(metavar="IN", help="Motion file: BVH, glTF, VRM, FBX, AMC, NPZ.")],
    out: Annotated[Path, typer.Option(help=f"File to write: {', '.join(export.SUFFIXES)}.")],
    skeleton: Target = None,
    character: Figure = None,
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
) -> None:
    """Convert a motion file to glTF (skinned mannequin with its animation), BVH, web page, strip of poses or film."""
    export.check(out, export.SUFFIXES, source, character, skeleton)
    motion = motion_files.read(source, unit, up, roles)
    if skeleton is not None:
        before, motion = motion, export.retarget(motion, target(skeleton))
        say(retargeting.report(before, motion))
    export.write(motion, out, title=source.stem, progress=True, character=character)
    _wrote(out)


@app.command("pack")
def pack(
    out: Annotated[Path, typer.Option(help="Folder to write: the cycles and manifest.json.")],
    style: Annotated[list[str], typer.Option(help="A style or a blend like Zombie=0.5,Old=0.5; once for each.")],
    model: TrainedRun = None,
    parameters: Published = None,
    gaits: Annotated[Names | None, typer.Option(parser=Names, metavar="A,B,…", help=f"Of {', '.join(packs.GAITS)}; by "
                                                "default all.")] = None,
    formats: Annotated[Names | None, typer.Option(parser=Names, metavar="A,B", help="glb, bvh; by default both.")] = None,
    in_place: Annotated[bool, typer.Option("--in-place", help="Without the steady movement of the root.")] = False,
    skeleton: Target = None,
    character: Figure = None,
) -> None:
    """Write looping cycles of styles (forward, back, left, right, run, idle) for games, and a manifest of them."""
    export.check(out / packs.MANIFEST, ())
    styles = {name: blend_of(name) for name in style}
    rig, writers = None if skeleton is None else target(skeleton), packs.WRITERS
    if character is not None:
        from toolkit.export import character_gltf
        from toolkit.view.character import Character

        if skeleton is not None:
            raise ValueError("give --skeleton or --character, whose rig it is")
        figure = Character.load(character)
        rig, writers = figure.rest, writers | {"glb": lambda clip, path: character_gltf.save(clip, path, figure)}
    made = packs.write(*published.either(model, parameters), out, styles, gaits=gaits or tuple(packs.GAITS),
                       formats=formats or tuple(packs.WRITERS), in_place=in_place,
                       target=rig, writers=writers, progress=True)
    rows = json.loads(made.read_text(encoding="utf-8"))["clips"]
    say(f"{'cycle':<28}{'m/s':>6}{'s':>7}{'seam cm/s':>11}{'usual':>7}")
    for row in rows:
        error = row["loop_error"]
        say(f"{row['style'] + ' ' + row['gait']:<28}{row['speed']:>6.2f}{row['duration']:>7.2f}"
            f"{error['velocity_cm_s']:>11.1f}{error['ordinary_velocity_change_cm_s']:>7.1f}")
    say(f"wrote {len(rows)} cycles and {made}")


def _wrote(*files: Path) -> None:
    for file in files:
        say(f"wrote {file}, {file.stat().st_size / 1e6:.2f} MB")
