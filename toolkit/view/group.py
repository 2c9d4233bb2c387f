"""Many characters in one scene, drawn by the software renderer: no OpenGL, no page."""

import os
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
from matplotlib.colors import to_rgb
from PIL import Image
from tqdm import tqdm

from toolkit.motion import Clip, on_cpu
from toolkit.view import body
from toolkit.view.animation import FINE, GRID, LINE, SUFFIXES, write
from toolkit.view.picture import FLOOR, PAPER
from toolkit.view.raycast import Canvas

TINT = 0.55  # share of a character's own colour in its parts
MARGIN = 0.4  # metres around them all


def crowd(clips: Sequence[Clip], path: str | os.PathLike, *, fps: float = 12.5, width: int = 960, view: float = 30.0,
          elevation: float = 32.0, colors: int = 96, progress: bool = False) -> Path:
    """Write a looping picture of characters that share a floor, each in a colour of its own, seen by a camera that stands.

    Parameters
    ----------
    clips
        One per character, of one skeleton, length and rate; each is where its root says.
    path
        File to write: ``.gif``, ``.png`` (animated), ``.webp`` or ``.mp4`` (H.264, needs PyAV).
    fps
        Pictures per second; none (0) writes the last frame alone.
    width
        Pixels.
    view, elevation
        Degrees: the camera's angle about the vertical and above the floor.
    colors
        Of a ``.gif``.
    progress
        Show a bar.

    Raises
    ------
    ValueError
        If there is no clip, they differ in length, rate or skeleton, or the suffix is another one.
    """
    path = Path(path)
    if path.suffix not in SUFFIXES:
        raise ValueError(f"a crowd is a {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]} file; got {path.name}")
    clips = on_cpu(clips)
    if len({(len(clip), clip.fps, clip.skeleton.names) for clip in clips}) != 1:
        raise ValueError(f"a crowd needs clips of one length, rate and skeleton, got {len(clips)} that differ or none")
    seconds = clips[0].seconds
    at = np.arange(max(1, round(seconds * fps))) / fps if fps else np.array([seconds])
    frames = np.minimum(np.round(at * clips[0].fps).astype(int), len(clips[0]) - 1)
    shapes = body.build(clips[0])
    angle, e = np.radians(view), np.radians(elevation)
    turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
    camera = np.array([[1, 0, 0], [0, np.cos(e), -np.sin(e)], [0, np.sin(e), np.cos(e)]]) @ turn
    places = np.stack([camera @ body.placements(shapes, clip.global_rotations[frames], clip.global_positions[frames])
                       for clip in clips], 1)
    low, high = body.bounds(shapes, places.reshape(-1, *places.shape[2:]))
    low, high = low[:2] - MARGIN, high[:2] + MARGIN
    scale, lamp = width / (high[0] - low[0]), camera @ np.array([-0.35, 1.0, 0.25])
    tints = [np.array(to_rgb(body.PALETTE[i % len(body.PALETTE)])) for i in range(len(clips))]
    looks = [(1 - TINT) * body.colors(shapes) + TINT * tint for tint in tints]
    paper = np.array(to_rgb(PAPER), np.float32)

    def drawn() -> Iterator[Image.Image]:
        for k in tqdm(range(len(frames)), desc=path.name, disable=not progress):
            canvas = Canvas((low[0], high[0], low[1], high[1]), FINE * scale)
            for place, look in zip(places[k], looks, strict=True):
                canvas.draw(shapes, place, look)
                canvas.shadow(shapes, place, camera[:, 1], np.zeros(3), lamp)
            picture = canvas.image(_floor(canvas, turn, np.sin(e)), paper)
            h, w = (n // FINE * FINE for n in picture.shape[:2])
            small = sum(picture[i:h:FINE, j:w:FINE] for i in range(FINE) for j in range(FINE)) / FINE**2
            yield Image.fromarray((255 * small + 0.5).astype(np.uint8))

    return write(drawn(), path, fps or 1.0, colors)


def _floor(canvas: Canvas, turn: np.ndarray, sine: float) -> np.ndarray:
    """Colours [H, W, 3] of the floor, with lines `GRID` metres apart."""
    ground, line = (np.array(to_rgb(c), np.float32) for c in (FLOOR, LINE))
    covered = 0.0
    for axis in np.eye(3)[::2]:
        sideways, _, deep = turn @ axis
        slope = np.array([sideways, -deep / sine])
        place = slope[0] * canvas.x + slope[1] * canvas.y[:, None]
        pixels = np.abs(place - 2 * GRID * np.round(place / (2 * GRID))) * canvas.scale / np.linalg.norm(slope)
        covered = np.maximum(covered, np.clip(0.5 * FINE + 0.5 - pixels, 0, 1))
    return ground + covered[..., None].astype(np.float32) * (line - ground)
