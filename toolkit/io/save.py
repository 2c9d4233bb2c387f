"""A clip written to a file of any kind: `save` by its suffix, `check` before long work."""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from toolkit import registry
from toolkit.io import bvh
from toolkit.io.load import readers
from toolkit.motion import Clip


def suffixes() -> tuple[str, ...]:
    """The suffixes of files that can be written: ``.bvh``, and those of `toolkit.registry`."""
    return (".bvh", *(f".{name}" for name in registry.names("writer")))


def check(path: str | os.PathLike, among: Sequence[str] | None = None,
          *read: str | os.PathLike | None) -> Path:
    """The path, if a file can be written there; called before long work.

    Parameters
    ----------
    among
        The suffixes that it may have, by default `suffixes`. If there are none, it may have any
        suffix but that of a motion file.
    read
        Files that are read, which must not be overwritten.

    Raises
    ------
    ValueError
        If the path is a folder, device or pipe, is read, cannot be written to, or has another
        suffix; or if a drawing library that the suffix needs is not installed.
    """
    path, among = Path(path), suffixes() if among is None else among
    if among and path.suffix not in among:
        got = path.suffix or "a file without suffix"
        raise ValueError(f"{path}: can write {', '.join(among)}, not {got!r}")
    if not among and path.suffix.lower() in readers():
        raise ValueError(f"{path}: is the name of a motion file; give another")
    if path.exists():
        if not path.is_file():
            kind = "folder" if path.is_dir() else "device, pipe or socket"
            raise ValueError(f"{path}: is a {kind}; a file name is needed")
        if any(other is not None and os.path.exists(other) and path.samefile(other)
               for other in read):
            raise ValueError(f"{path}: is a file that is read; give another to write")
    folder = next(parent for parent in path.absolute().parents if parent.exists())
    if not (folder.is_dir() and os.access(folder, os.W_OK)):
        raise ValueError(f"{path}: cannot be written, {folder} is not a folder that can be "
                         "written to")
    if among and path.suffix in suffixes()[1:]:
        registry.find(f"writer{path.suffix}")  # a missing library is said now
    return path


def figure_of(given: Any) -> Any:
    """The character (`toolkit.extra.characters`) in a file; a character or None as it is."""
    if isinstance(given, str | os.PathLike):
        return registry.find("character.load").load(given)
    return given


def save(clip: Clip, path: str | os.PathLike, *, title: str = "", source: Clip | None = None,
         progress: bool = False, character: Any = None) -> None:
    """Write a clip as motion (.bvh, .glb, .npz, .usdc), page (.html), strip (.png) or film.

    Missing folders are made.

    Parameters
    ----------
    path
        Its suffix, one of `suffixes`, selects the format.
    title
        Names the motion in a page or picture.
    source
        The motion that it was made from, shown beside it in pages, pictures and films.
    progress
        Show a bar while a film is drawn.
    character
        A file with a skinned mesh, or what `figure_of` returns for it: its file with the motion
        on it (.glb), its rig's motion (.bvh), or a page, picture or film in which it walks.

    Raises
    ------
    ValueError
        If the suffix is unknown, or the character cannot be read.
    """
    path = check(path)
    character = figure_of(character)
    if path.suffix == ".bvh":
        bvh.save(clip if character is None else character.fitted(clip), path)
    else:
        write = registry.find(f"writer{path.suffix}")
        write(clip, path, title=title, source=source, progress=progress, character=character)
