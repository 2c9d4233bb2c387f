"""The verbs `shot` and `export director`."""

import dataclasses
import sys
from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from toolkit import runtime
from toolkit.cli.export import Figure, Half, Title, wrote
from toolkit.cli.verbs import Published, Selection, TrainedRun, say
from toolkit.evaluation.findings import told
from toolkit.extra import shots
from toolkit.io import save as saving
from toolkit.training import published


def shot(
    file: Annotated[Path, Argument(help="JSON file of one or more shots.")],
    out: Annotated[Path, Option(
        help=f"File to write: {', '.join(saving.suffixes())}; of several shots one file each.")],
    model: TrainedRun = None,
    parameters: Published = None,
    seed: Annotated[int | None, Option(help="In place of the seed of the shots.")] = None,
    bodies: Annotated[float | None, Option(
        min=0.0, help="Metres between the bodies of those who keep apart: each gets the room that "
        "its styles reach.")] = None,
) -> None:
    """Render a file of shots, say what cannot be met, and write the motion."""
    scene = shots.Scene.load(file)
    if seed is not None:
        seeded = [dataclasses.replace(asked, seed=seed) for asked in scene.shots]
        scene = dataclasses.replace(scene, shots=seeded)
    paths = [out]
    if len(scene.shots) > 1:
        paths = [out.with_stem(f"{out.stem}_{k}") for k in range(len(scene.shots))]
    for path in paths:
        saving.check(path)
    net, bank = published.either(model, parameters)
    try:
        # each shot is walked twice, to check it and to render it
        frames = sum(2 * len(asked.plan(bank)[0].distance) for asked in scene.shots)
        net = runtime.quick(net, frames, say)
        if bodies is not None:
            if scene.apart is None:
                raise ValueError('--bodies needs a scene with "apart"')
            scene = scene.spaced(net, bank, bodies)
        for line in scene.check(net, bank):
            say(line, sys.stderr)
    except ValueError as error:
        raise ValueError(f"{file}: {error}") from None
    clips = scene.render(net, bank)
    for path, asked, clip in zip(paths, scene.shots, clips, strict=True):
        saving.save(clip, path, title=asked.name, progress=True)
        say(f"{asked.name or 'shot'}: {len(clip)} frames, {clip.seconds:.1f} s; wrote {path}")
    say(told(clips, scene.apart))


def director(
    out: Annotated[Path, Option(help="Page to write: .html.")],
    file: Annotated[Path | None, Option("--shots", help="JSON file of the first shots.")] = None,
    model: TrainedRun = None,
    parameters: Published = None,
    title: Title = "Plan a shot",
    styles: Selection = None,
    half: Half = False,
    character: Figure = None,
) -> None:
    """Write one page in which shots are planned: a floor map, a timeline of styles, the characters
    that walk at once.
    """
    # imported on demand: it needs the drawing libraries
    from toolkit.extra.shots import director as desk

    saving.check(out, (".html",))
    first = None if file is None else shots.Scene.load(file)
    wrote(desk.web(*published.either(model, parameters), out, first, title=title, styles=styles,
                   half=half, character=character))
