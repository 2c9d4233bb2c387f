"""Clips out of the toolkit: one call for every kind of file, told by its suffix."""

import os
from pathlib import Path

from toolkit import bvh
from toolkit.motion import Clip

SUFFIXES = (".bvh", ".html", ".png", ".mp4", ".gif", ".webp", ".apng")  # .png: a strip of poses


def check(path: str | os.PathLike) -> Path:
    """The path, if `write` knows its suffix; a ValueError otherwise, before long work is done for it."""
    path = Path(path)
    if path.suffix not in SUFFIXES:
        raise ValueError(f"{path}: can write {', '.join(SUFFIXES)}, not {path.suffix or 'a file without suffix'!r}")
    return path


def write(clip: Clip, path: str | os.PathLike, *, title: str, source: Clip | None = None, progress: bool = False) -> None:
    """Write a clip as motion (.bvh), web page (.html), strip of poses (.png) or film; folders are made.

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
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.suffix == ".bvh":
        bvh.save(clip, path)
        return
    from toolkit import view  # drawing libraries, only on demand

    clips, labels = ([clip], None) if source is None else ([source, clip], ["source", title])
    if path.suffix == ".html":
        view.html(clips, path, title=title, labels=labels)
    elif path.suffix == ".png":
        view.strip(clips, path, labels=labels)
    else:
        view.animate(clips, path, labels=labels, height=360, progress=progress)
