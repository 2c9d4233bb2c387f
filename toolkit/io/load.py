"""Motion of any format: `load` gives a clip in metres with Y up, `inspect` says what was found and guessed."""

import os
from collections.abc import Mapping
from importlib import import_module
from pathlib import Path

from toolkit.io import interpretation
from toolkit.io.recording import Recording
from toolkit.motion import Clip

READERS = {  # by suffix: module with ``read(path) -> Recording``, imported when it is first used
    ".bvh": "toolkit.io.bvh", ".glb": "toolkit.io.gltf", ".gltf": "toolkit.io.gltf",
    ".vrm": "toolkit.io.gltf", ".vrma": "toolkit.io.gltf", ".fbx": "toolkit.io.fbx", ".amc": "toolkit.io.amc",
    ".npz": "toolkit.io.npz", ".npy": "toolkit.io.npz",
}


def load(path: str | os.PathLike, unit: float | str = "auto", up: str = "auto", roles: Mapping[str, str] | None = None, *,
         style: str = "", gait: str = "") -> Clip:
    """Read a motion file as a clip in metres, seconds and with Y up.

    Unit and up axis are found from the body: people are 1.3 to 2.1 m tall, and their heads are above their feet. Roles are
    found from the joints' names and the tree. What is doubtful is said in one UserWarning, which names the option that
    decides; with ``unit`` and ``up`` given, nothing is guessed and nothing is said. The floor is not moved.

    Parameters
    ----------
    path : a file of one of the formats in `READERS`
    unit : metres of one unit of length in the file, a name of `toolkit.io.interpretation.UNITS`, or "auto"
    up : the file's axis that points up: "x", "y", "z", "-x", "-y", "-z", or "auto"
    roles : joints by role (`toolkit.motion.ROLES`), in place of those that were found
    style, gait : labels for the clip

    Raises
    ------
    ValueError
        If the format is unknown, the file cannot be read, or unit, up or roles do not fit.
    """
    path = Path(path)
    return interpretation.load(read(path), path, unit, up, roles, style, gait)


def read(path: str | os.PathLike) -> Recording:
    """The motion in a file, in its own unit and axes; ValueError in one line if it cannot be read."""
    path = Path(path)
    if path.suffix.lower() not in READERS:
        raise ValueError(f"{path.name}: no reader for this kind of file; there are readers for {', '.join(READERS)}")
    try:
        reader = import_module(READERS[path.suffix.lower()])
    except ModuleNotFoundError as error:
        raise ValueError(f"{path.name}: the reader of {path.suffix} files needs {error.name}") from error
    return reader.read(path)
