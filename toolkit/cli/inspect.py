"""The verb `inspect`: what a motion file holds, and how it is understood."""

import math
from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from toolkit import registry
from toolkit.cli.verbs import Animation, Roles, Unit, Up, say
from toolkit.io import save as saving


def inspect(
    file: Annotated[Path, Argument(help="Motion file: BVH, glTF, VRM, FBX, NPZ.")],
    unit: Unit = "auto",
    up: Up = "auto",
    roles: Roles = None,
    animation: Animation = None,
    picture: Annotated[Path | None, Option(help="Strip of poses to write: .png.")] = None,
) -> None:
    """Show what a motion file holds, and how it is understood.

    That is joints, height, unit, axes, floor, roles, contacts and doubts.

    `--unit`, `--up` and `--roles` decide what was guessed wrongly; other verbs take them too.
    """
    if picture is not None:
        saving.check(picture, (".png",), file)
    found = registry.find("recording.inspection")(file, unit, up, roles, animation)
    say(found)
    if picture is not None:
        from toolkit import view  # imported on demand: it needs the drawing libraries

        floor = found.floor if math.isfinite(found.floor) else 0.0
        view.strip(found.clip.moved(shift=(0.0, -floor, 0.0)), picture)
        say(f"wrote {picture}")
