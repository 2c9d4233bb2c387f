"""Animations and crowds, drawn by the software renderer."""

import os
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path

import numpy as np
import torch
from matplotlib.colors import to_rgb
from PIL import Image, ImageDraw, ImageFont
from scipy.ndimage import gaussian_filter1d

from toolkit.io.files import atomic_write
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, loops, on_cpu
from toolkit.view import body
from toolkit.view.canvas import Canvas
from toolkit.view.character import Character
from toolkit.view.picture import FLOOR, INK, PAPER, Shot, cast, steady_frames

LINE, GRID = "#bfbab0", 0.5  # lines on the floor; metres between them
BOTTOM = -0.3  # metres of floor shown below the feet
FINE = 2  # pictures are drawn this many times larger, then averaged
HEADING = 0.8  # metres that a radian between the headings at the ends of a loop counts as
ABOVE = 30.0, 32.0  # degrees of the camera over a crowd, about the vertical and above the floor
TINT, MARGIN = 0.55, 0.4  # of a crowd: share of a character's own colour, metres around all characters
SUFFIXES = (".gif", ".png", ".apng", ".webp", ".mp4")


def animate(clips: Clip | Sequence[Clip], path: str | os.PathLike, *, labels: Sequence[str] | None = None,
            columns: int | None = None, fps: float = 20.0, height: int = 200, view: float = 45.0, elevation: float = 12.0,
            contacts=None, caption: str = "", colors: int = 64, progress: bool = False,
            character: str | os.PathLike | Character | None = None) -> Path:
    """Write a looping animation of one or more motions, each in its own cell, on a floor whose lines show the travel.

    `loop` finds the part of a clip that repeats without a jump. A clip shorter than the longest starts again.

    Parameters
    ----------
    clips
        One clip or several.
    path
        File to write: ``.gif``, ``.png`` or ``.apng`` (animated), ``.webp`` or ``.mp4`` (H.264, needs PyAV).
    labels, columns
        Text of each cell, by default style and gait, else the clip's name; cells per row, by default all.
    fps
        Pictures per second.
    height
        Height of a cell in pixels; its width follows from how far the arms reach.
    view, elevation
        Degrees: the camera's angle from the facing direction (90 is from the right side) and above the floor.
    contacts
        Foot contacts [F, 2] (right, left), above one half where a foot stands, or one array per clip; shown on the feet.
    caption, progress
        Text below the picture; whether to show a bar.
    colors
        Number of colours of a ``.gif``: fewer make a smaller file.
    character
        A glTF or VRM file with a skinned mesh, drawn in place of the mannequin; the clips are put on its rig.

    Raises
    ------
    ValueError
        If there is no clip, the suffix is unknown, or labels or contacts do not fit the clips.
    ImportError
        If an ``.mp4`` is asked for and PyAV is missing.
    """
    path = _checked(path)
    figure = Character.of(character)
    clips, labels, contacts = cast(clips, labels, contacts, figure)
    shots = [_Follow(clip, con, view, elevation, figure) for clip, con in zip(clips, contacts, strict=True)]
    room = _room(shots, labels, height)
    length = max(round(clip.seconds * fps) for clip in clips)

    def drawn() -> Iterator[Image.Image]:
        for k in progress_bar(range(max(length, 1)), desc=path.name, show=progress):
            cells = [shot.cell(round(k * shot.clip.fps / fps) % len(shot.clip), *room) for shot in shots]
            yield _sheet(cells, columns or len(cells), labels, caption)

    return _write(drawn(), path, fps, colors)


def crowd(clips: Sequence[Clip], path: str | os.PathLike, *, fps: float = 12.5, width: int = 960, colors: int = 96,
          progress: bool = False) -> Path:
    """Write a looping animation of characters that share a floor, each in its own colour, seen by a fixed camera.

    Parameters
    ----------
    clips
        One per character, of one skeleton, length and rate.
    path, colors, progress
        As in `animate`.
    fps, width
        Pictures per second, 0 for the last frame alone; pixels.

    Raises
    ------
    ValueError
        If there is no clip, they differ in length, rate or skeleton, or the suffix is unknown.
    """
    path, clips = _checked(path), on_cpu(clips)
    if len({(len(clip), clip.fps, clip.skeleton.names) for clip in clips}) != 1:
        raise ValueError(f"a crowd needs clips of one length, rate and skeleton, got {len(clips)} that differ or none")
    first = clips[0]
    at = np.arange(max(1, round(first.seconds * fps))) / fps if fps else np.array([first.seconds])
    frames = np.minimum(np.round(at * first.fps).astype(int), len(first) - 1)
    still = np.zeros((len(first), 3))
    shots = [Shot(clip, None, frames, still, *np.radians(ABOVE)) for clip in clips]
    camera = shots[0].camera
    x0, y0 = np.min([shot.low for shot in shots], 0)[:2] - MARGIN
    x1, y1 = np.max([shot.high for shot in shots], 0)[:2] + MARGIN
    tints = [np.array(to_rgb(body.PALETTE[i % len(body.PALETTE)])) for i in range(len(clips))]
    looks = [shot.body.light[:, None] * ((1 - TINT) * shot.body.tones @ body.TABLE + TINT * tint)
             for shot, tint in zip(shots, tints, strict=True)]
    lamp = shots[0].tilt.T @ camera @ np.array([-0.35, 1.0, 0.25])

    def drawn() -> Iterator[Image.Image]:
        for k in progress_bar(range(len(frames)), desc=path.name, show=progress):
            canvas = Canvas((x0, x1, y0, y1), FINE * width / (x1 - x0), camera)
            for shot, look in zip(shots, looks, strict=True):
                shot.draw(canvas, k, lamp, colors=look)
            yield _image(_on_floor(canvas, np.eye(3)[::2], [2 * GRID, 2 * GRID], [0, 0]))

    return _write(drawn(), path, fps or 1.0, colors)


def loop(clip: Clip, shortest: float = 1.6, longest: float = 5.0) -> tuple[int, int]:
    """First and last (not included) frame of the part of a clip that best ends as it began, heading included.

    It is found by `toolkit.motion.loops.find` in the first half minute; ``shortest`` and ``longest`` are its seconds. Clips
    too short for that are taken whole. A ValueError if the skeleton has no hips or shoulders.
    """
    searched = clip.cut(stop=min(len(clip), round(30 * clip.fps)))
    if searched.seconds < shortest + 0.25:
        return 0, len(clip)
    heading = torch.from_numpy(steady_frames(searched, 0.5)[1])[:, None]
    start, frames = loops.find(searched, shortest, longest, HEADING / loops.PHASE * heading)
    return start, start + frames


class _Follow(Shot):
    """A clip seen by a camera that follows at a steady pace."""

    def __init__(self, clip: Clip, contacts: np.ndarray | None, view: float, elevation: float, figure: Character | None):
        walked, facing = steady_frames(clip, 0.5)
        straight = np.linspace(walked[0], walked[-1], len(walked))
        self.path = straight + gaussian_filter1d(walked - straight, 0.25 * clip.fps, axis=0, mode="wrap")
        azimuth = np.radians(view) - np.arctan2(np.sin(facing).mean(), np.cos(facing).mean())
        super().__init__(clip, contacts, np.arange(len(clip)), self.path, azimuth, np.radians(elevation), figure)
        travel = (walked[-1] - walked[0]) * (len(walked) / max(len(walked) - 1, 1))  # to where the next round begins
        length = float(np.linalg.norm(travel))
        along = travel / length if length > GRID else np.array([np.sin(facing[0]), 0.0, np.cos(facing[0])])
        self.axes = np.stack((along, np.cross(along, [0.0, 1.0, 0.0])))
        self.spacing = [length / round(length / GRID) if length > GRID else GRID, GRID]

    def cell(self, frame: int, reach: float, top: float, scale: float) -> np.ndarray:
        """Picture [H, W, 3] of a frame, 0 to 1: ``reach`` metres to either side, ``top`` high, ``scale`` pixels each."""
        canvas = Canvas((-reach, reach, BOTTOM, top), FINE * scale, self.camera)
        self.draw(canvas, frame, (-0.25, 1.0, 0.25))
        near = np.clip((0.3 - canvas.y) / 0.4, 0, 1)  # the floor fades into the paper
        return _on_floor(canvas, self.axes, self.spacing, self.axes @ (self.path[frame] - self.path[0]), near)


def _on_floor(canvas: Canvas, axes: np.ndarray, spacing: Sequence[float], start: Sequence[float],
              near: np.ndarray | float = 1.0) -> np.ndarray:
    """The canvas on a floor with lines, see `Canvas.lines`; ``near`` [H] is the floor's share, the rest is paper."""
    paper, ground, line = (np.array(to_rgb(c), np.float32) for c in (PAPER, FLOOR, LINE))
    near, covered = np.reshape(near, (-1, 1, 1)), canvas.lines(axes, spacing, start, FINE)[..., None]
    return canvas.image(paper * (1 - near) + ground * near + near * covered * (line - ground), paper, FINE)


def _image(picture: np.ndarray) -> Image.Image:
    return Image.fromarray((255 * picture + 0.5).astype(np.uint8))


def _room(shots: Sequence[_Follow], labels: Sequence[str], height: int) -> tuple[float, float, float]:
    """Metres to either side and upwards that every cell shows, with labels above the heads, and pixels per metre."""
    font = _font(height)
    text = max([font.getlength(name) + font.size for name in labels if name], default=0)
    scale = (height - (1.6 * font.size if text else 0)) / (max(shot.top + 0.05 for shot in shots) - BOTTOM)
    return max(0.7, text / 2 / scale, *(shot.reach + 0.03 for shot in shots)), BOTTOM + height / scale, scale


def _font(height: int) -> ImageFont.FreeTypeFont:
    return ImageFont.load_default(max(11, round(0.065 * height)))


def _sheet(cells: Sequence[np.ndarray], columns: int, labels: Sequence[str], caption: str) -> Image.Image:
    """Cells in rows, each with its label in the upper left corner; the caption below."""
    height, w, _ = cells[0].shape
    font, low = _font(height), height * -(-len(cells) // columns)
    width = max(columns * w, round(font.getlength(caption) + font.size))
    sheet = Image.new("RGB", (width, low + (2 * font.size if caption else 0)), PAPER)
    text = ImageDraw.Draw(sheet)
    for i, (cell, label) in enumerate(zip(cells, labels, strict=True)):
        x, y = i % columns * w, i // columns * height
        sheet.paste(_image(cell), (x, y))
        text.text((x + 0.5 * font.size, y + 0.4 * font.size), label, INK, font)
    text.text((0.5 * font.size, low + 0.3 * font.size), caption, INK, font)
    return sheet


def _checked(path: str | os.PathLike) -> Path:
    path = Path(path)
    if path.suffix not in SUFFIXES:
        raise ValueError(f"an animation is a {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]} file; got {path.name}")
    return path


def _write(frames: Iterable[Image.Image], path: Path, fps: float, colors: int) -> Path:
    """Write pictures of equal size as one looping file."""
    if path.suffix == ".mp4":
        return _film(frames, path, fps)
    frames = list(frames)
    options = {"save_all": True, "duration": round(1000 / fps), "loop": 0}
    if path.suffix == ".gif":  # one palette of a few colours, taken from some of the frames
        sample = np.concatenate([np.asarray(frame) for frame in frames[:: max(1, len(frames) // 6)]])
        palette = Image.fromarray(sample).quantize(colors, Image.Quantize.MEDIANCUT)
        frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
        options["optimize"] = False
    elif path.suffix == ".webp":
        options["quality"] = 80
    with atomic_write(path) as file:
        frames[0].save(file, Image.registered_extensions()[path.suffix], append_images=frames[1:], **options)
    return path


def _film(frames: Iterable[Image.Image], path: Path, fps: float) -> Path:
    """Write an MP4 that browsers play: H.264, 4:2:0 and therefore of even width and height."""
    try:
        import av
    except ImportError:
        raise ImportError(f"writing {path.name} needs PyAV: pip install av") from None
    with atomic_write(path) as file, av.open(file, "w", format="mp4", options={"movflags": "faststart"}) as film:
        stream = film.add_stream("libx264", rate=Fraction(fps).limit_denominator(1001), options={"crf": "18"})
        stream.pix_fmt = "yuv420p"
        for frame in frames:
            picture = np.asarray(frame)[: frame.height // 2 * 2, : frame.width // 2 * 2]
            if not stream.codec_context.is_open:
                stream.height, stream.width = picture.shape[:2]
            film.mux(stream.encode(av.VideoFrame.from_ndarray(np.ascontiguousarray(picture))))
        film.mux(stream.encode())
    return path
