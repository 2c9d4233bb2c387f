"""What `toolkit.io.save` writes with the drawing libraries.

Pages, strips of poses and films of one clip.
"""

from pathlib import Path

from toolkit.motion import Clip
from toolkit.view.pages.page import html
from toolkit.view.render.animation import animate
from toolkit.view.render.picture import strip


def page(
    clip: Clip, path: Path, *, title: str, source: Clip | None, progress: bool, character
) -> None:
    """A web page; see `toolkit.io.save.save` for the parameters, here and below."""
    clips, labels = _shown(clip, source, title)
    html(clips, path, title=title or "Motion", labels=labels, character=character)


def poses(
    clip: Clip, path: Path, *, title: str, source: Clip | None, progress: bool, character
) -> None:
    """A strip of poses."""
    clips, labels = _shown(clip, source, title)
    strip(clips, path, labels=labels, character=character)


def film(
    clip: Clip, path: Path, *, title: str, source: Clip | None, progress: bool, character
) -> None:
    """A film or an animated picture."""
    clips, labels = _shown(clip, source, title)
    animate(clips, path, labels=labels, height=360, progress=progress, character=character)


def _shown(clip: Clip, source: Clip | None, title: str) -> tuple[list[Clip], list[str] | None]:
    return ([clip], [title] if title else None) if source is None else (
        [source, clip], ["source", title])
