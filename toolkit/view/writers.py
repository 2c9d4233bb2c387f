"""What `toolkit.io.save` writes with the drawing libraries.

Pages, strips of poses and films of one clip; see `toolkit.io.save.save` for the parameters.
"""

from pathlib import Path

from toolkit.motion import Clip
from toolkit.view.pages.page import html
from toolkit.view.render.animation import animate
from toolkit.view.render.picture import strip


def write(clip: Clip, path: Path, *, title: str, source: Clip | None, progress: bool,
          character) -> None:
    """Write a web page, a strip of poses or a film, by the suffix of the path."""
    clips, labels = [clip], [title] if title else None
    if source is not None:
        clips, labels = [source, clip], ["source", title]
    if path.suffix == ".html":
        html(clips, path, title=title or "Motion", labels=labels, character=character)
    elif path.suffix == ".png":
        strip(clips, path, labels=labels, character=character)
    else:
        animate(clips, path, labels=labels, height=360, progress=progress, character=character)
