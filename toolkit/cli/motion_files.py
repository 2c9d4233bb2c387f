"""What verbs read: motion files, folders of recordings, skeletons to retarget to."""

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

from typer import Option

from toolkit import datasets
from toolkit.cli.verbs import say
from toolkit.datasets import folder as own
from toolkit.datasets.procedural import SKELETON
from toolkit.motion import Clip, rotations

Target = Annotated[str | None, Option(
    "--skeleton", help="Retarget to a skeleton: 100style, or a file of it, best with a T-pose.")]


def read(path: Path, unit: float | str = "auto", up: str = "auto",
         roles: Mapping[str, str] | None = None, animation: str | None = None) -> Clip:
    """The clip of a motion file (`datasets.folder.read_file`); doubts are printed on stderr."""
    clip, doubts = own.read_file(path, unit, up, roles, animation)
    for doubt in doubts:
        say(f"{path.name}: {doubt}", sys.stderr)
    return clip


def target(skeleton: str) -> Clip:
    """The skeleton that ``--skeleton`` names: 100STYLE's in a T-pose, or a file's motion."""
    if skeleton == "100style":
        pose = rotations.identity(1, len(SKELETON))
        return Clip(SKELETON, pose, [[0.0, 0.0, 0.0]], 60.0, name=skeleton)
    if not Path(skeleton).is_file():
        raise ValueError(f"--skeleton is 100style or a file; got {skeleton!r}")
    return read(Path(skeleton))


def dataset(data: str, root: Path | None) -> tuple[str, Path | None]:
    """Name and folder of the dataset that ``--data`` names, which may be a folder of one's own."""
    if data in datasets.DATASETS or not Path(data).is_dir():
        return data, root
    if root is not None:
        raise ValueError(f"{data}: is the folder to read; --root is for datasets with a name")
    return "folder", Path(data)
