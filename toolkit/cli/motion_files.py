"""Motion files of the verbs: read with the floor at zero, doubts as lines on stderr."""

import sys
from collections.abc import Mapping
from pathlib import Path

from toolkit.io import interpretation, load
from toolkit.motion import Clip
from toolkit.motion.names import printable


def read(path: Path, unit: float | str = "auto", up: str = "auto", roles: Mapping[str, str] | None = None) -> Clip:
    """The clip of a motion file, see `toolkit.load`; a floor far from zero is moved there."""
    clip, found = interpretation.interpret(load.read(path), path, unit, up, roles)
    if abs(found.floor) > interpretation.FAR:
        clip = clip.moved(shift=(0.0, -found.floor, 0.0))
    for doubt in found.doubts:
        print(printable(f"{path.name}: {doubt}"), file=sys.stderr)
    return clip
