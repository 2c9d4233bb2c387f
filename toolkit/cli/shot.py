"""The verb `shot`: render a file of shots, say what cannot be met, write the motion."""

import dataclasses
import sys
from pathlib import Path
from typing import Annotated

import typer

from toolkit import export, published, shots
from toolkit.cli.verbs import Published, TrainedRun


def shot(
    file: Annotated[Path, typer.Argument(help="JSON file of one or more shots.")],
    out: Annotated[Path, typer.Option(help=f"File to write: {', '.join(export.SUFFIXES)}; of several shots one file each.")],
    model: TrainedRun = None,
    parameters: Published = None,
    seed: Annotated[int | None, typer.Option(help="In place of the seed of the shots.")] = None,
) -> None:
    """Render a file of shots, say what cannot be met, and write the motion."""
    export.check(out)
    scene = shots.load(file)
    net, bank = published.either(model, parameters)
    for k, asked in enumerate(scene):
        asked = asked if seed is None else dataclasses.replace(asked, seed=seed)
        path = out if len(scene) == 1 else out.with_stem(f"{out.stem}_{k}")
        for line in asked.check(net, bank):
            print(f"shot {k}: {line}", file=sys.stderr)
        clip = asked.render(net, bank)
        export.write(clip, path, title=asked.name, progress=True)
        print(f"{asked.name}: {len(clip)} frames, {clip.seconds:.1f} s; wrote {path}")
