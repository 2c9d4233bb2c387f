"""Out to other programs: clips as motion, page, picture or film, the network as ONNX."""

import os
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

from toolkit.export import gltf, onnx
from toolkit.io import bvh
from toolkit.motion import Clip
from toolkit.motion.retargeting import retarget

__all__ = ["SUFFIXES", "check", "gltf", "onnx", "retarget", "write"]
SUFFIXES = (".bvh", ".html", ".png", ".mp4", ".gif", ".webp", ".apng", ".glb")  # .png: a strip of poses


def check(path: str | os.PathLike, suffixes: Sequence[str] = SUFFIXES) -> Path:
    """The path, if its suffix is one of those and it is no folder; else a ValueError, before long work is done for it.

    An ImportError names what is not installed for it.
    """
    path = Path(path)
    if path.suffix not in suffixes:
        raise ValueError(f"{path}: can write {', '.join(suffixes)}, not {path.suffix or 'a file without suffix'!r}")
    if path.is_dir():
        raise ValueError(f"{path}: is a folder; a file name is needed")
    if path.suffix in SUFFIXES and path.suffix != ".bvh":
        import_module("toolkit.view")  # drawing libraries, only on demand; an ImportError names the extra
    return path


def write(clip: Clip, path: str | os.PathLike, *, title: str = "Motion", source: Clip | None = None,
          progress: bool = False) -> None:
    """Write a clip as motion (.bvh, .glb), web page (.html), strip of poses (.png) or film; folders are made.

    Parameters
    ----------
    clip
        The motion.
    path
        The file; its suffix, one of `SUFFIXES`, says which kind.
    title
        What the motion is called in a page or picture.
    source
        What it was made of, shown beside it in pages, pictures and films.
    progress
        Show a bar while a film is drawn.

    Raises
    ------
    ValueError
        If the suffix is another.
    """
    path = check(path)
    if path.suffix in (".bvh", ".glb"):
        (bvh if path.suffix == ".bvh" else gltf).save(clip, path)
        return
    from toolkit import view

    path.parent.mkdir(parents=True, exist_ok=True)
    clips, labels = ([clip], None) if source is None else ([source, clip], ["source", title])
    if path.suffix == ".html":
        view.html(clips, path, title=title, labels=labels)
    elif path.suffix == ".png":
        view.strip(clips, path, labels=labels)
    else:
        view.animate(clips, path, labels=labels, height=360, progress=progress)
