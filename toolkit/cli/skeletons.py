"""Skeletons that motion can be put on: the option `--skeleton`."""

from pathlib import Path
from typing import Annotated

import typer

from toolkit.cli import motion_files
from toolkit.datasets.procedural import SKELETON
from toolkit.motion import Clip, rotations

SKELETONS = {"100style": SKELETON}
Target = Annotated[str | None, typer.Option("--skeleton", help=f"Retarget to a skeleton: {', '.join(SKELETONS)}, or a file "
                                            "of it, best with a T-pose.")]


def target(skeleton: str) -> Clip:
    """The skeleton that the option names: a T-pose of one of `SKELETONS`, or the motion of a file."""
    if skeleton in SKELETONS:
        known = SKELETONS[skeleton]
        return Clip(known, rotations.identity(1, len(known)), [[0.0, 0.0, 0.0]], 60.0, name=skeleton)
    if not Path(skeleton).is_file():
        raise ValueError(f"--skeleton is one of {', '.join(SKELETONS)}, or a file; got {skeleton!r}")
    return motion_files.read(Path(skeleton))
