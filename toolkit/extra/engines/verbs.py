"""The verbs `export onnx` and `export pack`: networks and looping cycles for game engines."""

import json
from pathlib import Path
from typing import Annotated

from typer import Option

from toolkit import registry
from toolkit.cli.export import Figure, wrote
from toolkit.cli.motion_files import Target, target
from toolkit.cli.rollout import blend_of
from toolkit.cli.verbs import Names, Published, TrainedRun, say
from toolkit.extra.engines import onnx as onnx_files, pack as packs
from toolkit.io import save as saving
from toolkit.training import published


def onnx(
    out: Annotated[Path, Option(help="File to write: .onnx; the style vectors go beside it.")],
    model: TrainedRun = None,
    parameters: Published = None,
) -> None:
    """Write the network (gating, experts) as ONNX and its style vectors as safetensors."""
    saving.check(out, (".onnx",))
    net, bank = published.either(model, parameters)
    wrote(*onnx_files.save(net, out, bank))


def pack(
    out: Annotated[Path, Option(help="Folder to write: the cycles and manifest.json.")],
    style: Annotated[list[str], Option(help="A style or a blend like Zombie=0.5,Old=0.5; "
                                            "once for each.")],
    model: TrainedRun = None,
    parameters: Published = None,
    gaits: Annotated[Names | None, Option(parser=Names, metavar="A,B,…", help="Of "
                                          f"{', '.join(packs.GAITS)}; by default all.")] = None,
    formats: Annotated[Names | None, Option(parser=Names, metavar="A,B",
                                            help="glb, bvh; by default both.")] = None,
    in_place: Annotated[bool, Option("--in-place",
                                     help="Without the steady movement of the root.")] = False,
    skeleton: Target = None,
    character: Figure = None,
) -> None:
    """Write looping cycles of styles (forward, back, left, right, run, idle) and a manifest."""
    saving.check(out / packs.MANIFEST, ())
    if skeleton is not None and character is not None:
        raise ValueError("give --skeleton or --character, whose rig it is")
    made = packs.write(
        *published.either(model, parameters), out, {name: blend_of(name) for name in style},
        gaits=gaits or tuple(packs.GAITS), formats=formats or packs.FORMATS, in_place=in_place,
        target=None if skeleton is None else target(skeleton),
        character=None if character is None else registry.find("character.load").load(character),
        progress=True)
    rows = json.loads(made.read_text(encoding="utf-8"))["clips"]
    say(f"{'cycle':<28}{'m/s':>6}{'s':>7}{'seam cm/s':>11}{'usual':>7}")
    for row in rows:
        error = row["loop_error"]
        say(f"{row['style'] + ' ' + row['gait']:<28}{row['speed']:>6.2f}{row['duration']:>7.2f}"
            f"{error['velocity_cm_s']:>11.1f}{error['ordinary_velocity_change_cm_s']:>7.1f}")
    say(f"wrote {len(rows)} cycles and {made}")
