"""The verb `shot`: render a file of shots, say what cannot be met, write the motion."""

import dataclasses
import sys
from pathlib import Path
from typing import Annotated

import typer

from toolkit import export, published, shots
from toolkit.cli.verbs import Published, TrainedRun, say


def shot(
    file: Annotated[Path, typer.Argument(help="JSON file of one or more shots.")],
    out: Annotated[Path, typer.Option(help=f"File to write: {', '.join(export.SUFFIXES)}; of several shots one file each.")],
    model: TrainedRun = None,
    parameters: Published = None,
    seed: Annotated[int | None, typer.Option(help="In place of the seed of the shots.")] = None,
) -> None:
    """Render a file of shots, say what cannot be met, and write the motion."""
    scene = shots.Scene.load(file)
    if seed is not None:
        scene = dataclasses.replace(scene, shots=[dataclasses.replace(asked, seed=seed) for asked in scene.shots])
    paths = [out] if len(scene.shots) == 1 else [out.with_stem(f"{out.stem}_{k}") for k in range(len(scene.shots))]
    for path in paths:
        export.check(path)
    net, bank = published.either(model, parameters)
    try:
        for line in scene.check(net, bank):
            say(line, sys.stderr)
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from None
    for path, asked, clip in zip(paths, scene.shots, scene.render(net, bank), strict=True):
        export.write(clip, path, title=asked.name, progress=True)
        say(f"{asked.name or 'shot'}: {len(clip)} frames, {clip.seconds:.1f} s; wrote {path}")
