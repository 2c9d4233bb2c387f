"""Export to other programs: clips as motion, web page, picture or film, networks as ONNX."""

import os
import pkgutil
from collections.abc import Sequence
from importlib import import_module
from pathlib import Path

import lazy_loader

from toolkit.export import gltf, onnx
from toolkit.io import bvh
from toolkit.io.load import READERS
from toolkit.motion import Clip
from toolkit.motion.retargeting import retarget

__all__ = ["SUFFIXES", "check", "gltf", "onnx", "retarget", "write"]
__getattr__ = lazy_loader.attach(__name__, [module.name for module in pkgutil.iter_modules(__path__)])[0]
SUFFIXES = (".bvh", ".html", ".png", ".mp4", ".gif", ".webp", ".apng", ".glb")  # .png: a strip of poses


def check(path: str | os.PathLike, suffixes: Sequence[str] = SUFFIXES, *read: str | os.PathLike | None) -> Path:
    """The path, if a file can be written there and is none of those that are ``read``; called before long work.

    Raises
    ------
    ValueError
        If the path is a folder, device or pipe, is read, cannot be written to, or has none of the ``suffixes`` (without any,
        all are accepted but those of motion files).
    ImportError
        If a drawing library that the suffix needs is not installed.
    """
    path = Path(path)
    if suffixes and path.suffix not in suffixes:
        raise ValueError(f"{path}: can write {', '.join(suffixes)}, not {path.suffix or 'a file without suffix'!r}")
    if not suffixes and path.suffix.lower() in READERS:
        raise ValueError(f"{path}: is the name of a motion file; give another")
    if path.exists() and not path.is_file():
        raise ValueError(f"{path}: is a {'folder' if path.is_dir() else 'device, pipe or socket'}; a file name is needed")
    if path.exists() and any(other is not None and os.path.exists(other) and path.samefile(other) for other in read):
        raise ValueError(f"{path}: is a file that is read; give another to write")
    folder = next(parent for parent in path.absolute().parents if parent.exists())
    if not (folder.is_dir() and os.access(folder, os.W_OK)):
        raise ValueError(f"{path}: cannot be written, {folder} is not a folder that can be written to")
    if suffixes and path.suffix in SUFFIXES and path.suffix != ".bvh":
        import_module("toolkit.view")  # imported on demand: it needs the drawing libraries
    return path


def write(clip: Clip, path: str | os.PathLike, *, title: str = "Motion", source: Clip | None = None,
          progress: bool = False, character: str | os.PathLike | None = None) -> None:
    """Write a clip as motion (.bvh, .glb), web page (.html), strip of poses (.png) or film; missing folders are made.

    The suffix of the path, one of `SUFFIXES`, selects the format. ``title`` names the motion in a page or picture.
    ``source``, the motion it was made from, is shown beside it in pages, pictures and films. ``progress`` shows a bar while
    a film is drawn. ``character`` is a glTF or VRM file with a skinned mesh: its file with the motion on it (.glb), its
    rig's motion (.bvh), or a page, picture or film in which it walks.

    Raises
    ------
    ValueError
        If the suffix is unknown, or the character cannot be read.
    """
    path, figure = check(path), None
    if character is not None:
        from toolkit.export import character_gltf
        from toolkit.view.character import Character

        figure = Character.load(character)
    if path.suffix == ".bvh":
        bvh.save(clip if figure is None else figure.fitted(clip), path)
    elif path.suffix == ".glb" and figure is not None:
        character_gltf.save(clip, path, figure)
    elif path.suffix == ".glb":
        gltf.save(clip, path)
    else:
        from toolkit import view

        clips, labels = ([clip], None) if source is None else ([source, clip], ["source", title])
        if path.suffix == ".html":
            view.html(clips, path, title=title, labels=labels, character=figure)
        elif path.suffix == ".png":
            view.strip(clips, path, labels=labels, character=figure)
        else:
            view.animate(clips, path, labels=labels, height=360, progress=progress, character=figure)
