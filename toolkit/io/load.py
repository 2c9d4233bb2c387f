"""Motion of any format as a clip."""

import os
from collections.abc import Mapping
from pathlib import Path

from toolkit import registry
from toolkit.io import bvh
from toolkit.io.recording import Recording
from toolkit.motion import Clip

SEVERAL = (".glb", ".gltf", ".vrm", ".vrma", ".fbx")  # files that may hold several animations


def readers() -> tuple[str, ...]:
    """The suffixes of files that can be read: ``.bvh``, and those of `toolkit.registry`."""
    return (".bvh", *(f".{name}" for name in registry.names("reader")))


def load(path: str | os.PathLike, unit: float | str = "auto", up: str = "auto",
         roles: Mapping[str, str] | None = None, *, animation: str | int | None = None,
         style: str = "", gait: str = "") -> Clip:
    """Read a motion file as a clip in metres, seconds and with Y up.

    Unit and up axis are found from the body: people are 1.3 to 2.1 m tall, and their heads are
    above their feet. Roles are found from the joints' names and the tree. What is doubtful is said
    in one UserWarning, which names the option that decides; with ``unit`` and ``up`` given, nothing
    is guessed and nothing is said. The floor is not moved.

    Parameters
    ----------
    path : a file of one of the formats in `readers`
    unit : metres of one unit of length in the file, one of m, cm, mm, inch, dm, CMU, or "auto"
    up : the file's axis that points up: "x", "y", "z", "-x", "-y", "-z", or "auto"
    roles : joints by role (`toolkit.motion.ROLES`), in place of those that were found
    animation : name or index of an animation of a glTF or FBX file, by default the first
    style, gait : labels for the clip

    Raises
    ------
    ValueError
        If the format is unknown, the file cannot be read, or unit, up or roles do not fit.
    """
    path = Path(path)
    interpretation = registry.find("recording.interpretation")
    return interpretation.load(read(path, animation), path, unit, up, roles, style, gait)


def read(path: str | os.PathLike, animation: str | int | None = None) -> Recording:
    """The motion in a file, in its own unit and axes; ValueError if it cannot be read."""
    path = Path(path)
    suffix = path.suffix.lower()
    if suffix not in readers():
        raise ValueError(f"{path.name}: no reader for this kind of file; "
                         f"there are readers for {', '.join(readers())}")
    if animation is not None and suffix not in SEVERAL:
        raise ValueError(f"{path.name}: a file of this kind has one motion; "
                         f"animation= is for {', '.join(SEVERAL)}")
    if suffix == ".bvh":
        return bvh.read(path)
    reader = registry.find(f"reader{suffix}")
    return reader(path) if animation is None else reader(path, animation)
