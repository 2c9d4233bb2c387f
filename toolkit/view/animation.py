"""Moving pictures and contact sheets: clips seen by a camera that goes along, drawn by the software renderer."""

import os
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path

import numpy as np
import torch
from matplotlib.colors import to_rgb
from PIL import Image, ImageDraw, ImageFont
from scipy.ndimage import gaussian_filter1d
from tqdm import tqdm

from toolkit.io.files import atomic_write
from toolkit.motion import Clip, on_cpu
from toolkit.motion import rotations as R
from toolkit.view import body
from toolkit.view.picture import FLOOR, INK, PAPER, contact_list, label, steady_frames
from toolkit.view.raycast import Canvas

LINE, GRID = "#bfbab0", 0.5  # lines on the floor; metres between them
BOTTOM = -0.3  # metres of floor shown below the feet
FINE = 2  # drawn this many times larger, then averaged
SUFFIXES = (".gif", ".png", ".apng", ".webp", ".mp4")


def animate(clips: Clip | Sequence[Clip], path: str | os.PathLike, *, labels: Sequence[str] | None = None,
            columns: int | None = None, fps: float = 20.0, height: int = 200, view: float = 45.0, elevation: float = 12.0,
            contacts=None, caption: str = "", colors: int = 64, progress: bool = False) -> Path:
    """Write a looping picture of one or more motions, each in a cell of its own, on a floor whose lines show the travel.

    The clips are shown as they are; `loop` finds the part of a clip that repeats without a jump. A clip that is shorter than
    the longest starts again.

    Parameters
    ----------
    clips
        One clip or several.
    path
        File to write: ``.gif``, ``.png`` or ``.apng`` (animated), ``.webp`` or ``.mp4`` (H.264, needs PyAV).
    labels
        Text of each cell; by default style and gait, else the clip's name.
    columns
        Cells per row; by default all in one row.
    fps
        Pictures per second.
    height
        Pixels of a cell from top to bottom; its width follows from how far the arms reach.
    view, elevation
        Degrees: the camera's angle from the facing direction (90 is from the right side) and above the floor.
    contacts
        Foot contacts [F, 2] (right, left) above one half where a foot stands, or one array per clip; shown on the feet.
    caption
        Text below the picture.
    colors
        Of a ``.gif``: fewer make a smaller file.
    progress
        Show a bar.

    Raises
    ------
    ValueError
        If there is no clip, the suffix is another one, or labels or contacts do not fit the clips.
    ImportError
        If a film is asked for and PyAV is missing.
    """
    path = Path(path)
    if path.suffix not in SUFFIXES:
        raise ValueError(f"an animation is a {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]} file; got {path.name}")
    shots, labels = _shots(clips, labels, contacts, view, elevation)
    columns = columns or len(shots)
    room = _room(shots, labels, height)
    length = max(round(shot.clip.seconds * fps) for shot in shots)

    def drawn() -> Iterator[Image.Image]:
        for k in tqdm(range(max(length, 1)), desc=path.name, disable=not progress):
            cells = [shot.draw(round(k * shot.clip.fps / fps) % len(shot.clip), *room) for shot in shots]
            yield _sheet(cells, columns, labels, caption)

    return write(drawn(), path, fps, colors)


def write(frames: Iterable[Image.Image], path: Path, fps: float, colors: int) -> Path:
    """Write pictures of equal size as one looping file, see `animate`."""
    if path.suffix == ".mp4":
        _film(frames, path, fps)
        return path
    frames = list(frames)
    how = {"save_all": True, "duration": round(1000 / fps), "loop": 0}
    if path.suffix == ".gif":
        frames = _reduce(frames, colors)
        how["optimize"] = False
    elif path.suffix == ".webp":
        how["quality"] = 80
    with atomic_write(path) as file:
        frames[0].save(file, Image.registered_extensions()[path.suffix], append_images=frames[1:], **how)
    return path


def contact_sheet(clips: Clip | Sequence[Clip], path: str | os.PathLike | None = None, *, columns: int = 8,
                  labels: Sequence[str] | None = None, strides: int = 2, height: int = 140, view: float = 45.0,
                  elevation: float = 12.0, contacts=None, progress: bool = False) -> Image.Image:
    """A row of poses for every clip, evenly over about two strides, time from left to right.

    Parameters
    ----------
    clips
        One clip or several.
    path
        Picture file to write (any format Pillow knows).
    columns
        Poses per row.
    labels
        Text of each row; by default style and gait, else the clip's name.
    strides
        How many strides of each clip (see `loop`).
    height
        Pixels of the highest row.
    view, elevation, contacts, progress
        As in `animate`.

    Raises
    ------
    ValueError
        If there is no clip or no column, or labels or contacts do not fit the clips.
    """
    shots, labels = _shots(clips, labels, contacts, view, elevation)
    if columns < 1:
        raise ValueError(f"a contact sheet needs columns, got {columns}")
    reach, _, scale = _room(shots, [], height)
    cells = []
    for shot in tqdm(shots, desc="contact sheet", disable=not progress):
        start, stop = loop(shot.clip, strides)
        poses = np.linspace(start, stop, columns, endpoint=False).round().astype(int)
        cells += [shot.draw(frame, reach, shot.top, scale) for frame in poses]  # every row as high as it needs
    sheet = _sheet(cells, columns, labels)
    if path is not None:
        with atomic_write(path) as file:
            sheet.save(file, Image.registered_extensions()[Path(path).suffix.lower()])
    return sheet


def loop(clip: Clip, strides: int = 2) -> tuple[int, int]:
    """First and last (not included) frame of the part of a clip that shows some strides and best ends as it began.

    The stride is the first lag, of 0.4 to 3 seconds, at which the body looks again much as it did: the dips of YIN's
    normalised difference (de Cheveigné, Kawahara 2002), of poses instead of sound. Clips too short for that are taken whole.
    """
    longest = min(round(3 * clip.fps), (len(clip) - 1) // strides, len(clip) - round(0.25 * clip.fps))
    shortest = round(0.4 * clip.fps)
    if longest < shortest + 2:
        return 0, len(clip)
    path, facing = steady_frames(clip, 0.5)
    away = clip.global_positions - torch.from_numpy(path).float()[:, None]
    pose = R.rotate(R.yaw(torch.from_numpy(-facing).float())[:, None], away).flatten(1).numpy()

    def apart(rows: np.ndarray, lag: int) -> np.ndarray:
        return ((rows[lag:] - rows[:-lag]) ** 2).sum(1)

    lags = np.arange(1, longest + 1)
    mean = np.array([apart(pose, lag).mean() for lag in lags])
    mean = mean * lags / np.maximum(mean.cumsum(), 1e-9)
    dips = [k for k in range(shortest, longest - 1) if mean[k] <= min(mean[k - 1], mean[k + 1])]
    stride = lags[next((k for k in dips if mean[k] < 1.5 * mean[dips].min() + 0.05), shortest + mean[shortest:].argmin())]
    rows = np.column_stack((pose, np.gradient(pose, axis=0) * (0.1 * clip.fps), 4 * facing))  # the seam is smooth, too
    totals = range(round(0.93 * strides * stride), min(round(1.07 * strides * stride), len(clip) - 1) + 1)
    total = min(totals, key=lambda n: apart(rows, n).min())
    start = int(apart(rows, total).argmin())
    return start, start + total


class _Shot:
    """A clip seen by a camera that goes along at a steady pace, in cells of one size."""

    def __init__(self, clip: Clip, contacts: np.ndarray | None, view: float, elevation: float):
        self.clip, self.shapes = clip, body.build(clip)
        self.contacts = None if contacts is None else contacts > 0.5
        walked, facing = steady_frames(clip, 0.5)
        straight = np.linspace(walked[0], walked[-1], len(walked))
        self.path = straight + gaussian_filter1d(walked - straight, 0.25 * clip.fps, axis=0, mode="wrap")
        angle = np.radians(view) - np.arctan2(np.sin(facing).mean(), np.cos(facing).mean())
        e = np.radians(elevation)
        self.turn = np.array([[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]])
        tilt = np.array([[1, 0, 0], [0, np.cos(e), -np.sin(e)], [0, np.sin(e), np.cos(e)]])
        self.camera, self.lamp = tilt @ self.turn, tilt @ np.array([-0.25, 1.0, 0.25])
        places = body.placements(self.shapes, clip.global_rotations, clip.global_positions).astype(np.float64)
        places[..., 3] -= self.path[:, None]
        self.places = self.camera @ places
        self.sine = np.sin(e)
        low, high = body.bounds(self.shapes, self.places)
        self.reach, self.top = max(-low[0], high[0]) + 0.03, high[1] + 0.05
        travel = (walked[-1] - walked[0]) * (len(walked) / max(len(walked) - 1, 1))  # to where the next round begins
        length = float(np.linalg.norm(travel))
        along = travel / length if length > GRID else np.array([np.sin(facing[0]), 0.0, np.cos(facing[0])])
        self.axes = np.stack((along, np.cross(along, [0.0, 1.0, 0.0])))
        self.spacing = np.array([length / round(length / GRID) if length > GRID else GRID, GRID])

    def draw(self, frame: int, reach: float, top: float, scale: float) -> np.ndarray:
        """Picture [H, W, 3] of a frame, 0 to 1: ``reach`` metres to either side, ``top`` high, ``scale`` pixels each."""
        canvas = Canvas((-reach, reach, BOTTOM, top), FINE * scale)
        places = self.places[frame]
        canvas.draw(self.shapes, places, body.colors(self.shapes, None if self.contacts is None else self.contacts[frame]))
        canvas.shadow(self.shapes, places, self.camera[:, 1], np.zeros(3), self.lamp)
        paper, ground, line = (np.array(to_rgb(c), np.float32) for c in (PAPER, FLOOR, LINE))
        near = np.clip((0.3 - canvas.y) / 0.4, 0, 1)[:, None, None]  # the floor fades into the paper
        floor = np.broadcast_to(paper * (1 - near) + ground * near, (canvas.height, canvas.width, 3)).copy()
        rows = np.flatnonzero(near[:, 0, 0] > 0)
        floor[rows] += (near[rows, :, 0] * self._lines(canvas, rows, frame))[..., None] * (line - ground)
        picture = canvas.image(floor, paper)
        h, w = (n // FINE * FINE for n in picture.shape[:2])
        return sum(picture[i:h:FINE, k:w:FINE] for i in range(FINE) for k in range(FINE)) / FINE**2

    def _lines(self, canvas: Canvas, rows: np.ndarray, frame: int) -> np.ndarray:
        """How much of each pixel [R, W] of the floor a line covers."""
        covered = 0.0
        for axis, spacing in zip(self.axes, self.spacing, strict=True):
            sideways, _, deep = self.turn @ axis
            slope = np.array([sideways, -deep / self.sine])  # of the place along the axis, per metre of picture
            place = slope[0] * canvas.x + slope[1] * canvas.y[rows, None] + axis @ (self.path[frame] - self.path[0])
            pixels = np.abs(place - spacing * np.round(place / spacing)) * canvas.scale / np.linalg.norm(slope)
            covered = np.maximum(covered, np.clip(0.5 * FINE + 0.5 - pixels, 0, 1))
        return covered


def _shots(clips, labels, contacts, view: float, elevation: float) -> tuple[list[_Shot], list[str]]:
    clips = on_cpu(clips)
    labels = [label(clip) for clip in clips] if labels is None else list(labels)
    if not clips or len(labels) != len(clips):
        raise ValueError(f"a picture needs clips and a label per clip; got {len(clips)} clips, {len(labels)} labels")
    contacts = contact_list(contacts, clips)
    return [_Shot(clip, con, view, elevation) for clip, con in zip(clips, contacts, strict=True)], labels


def _room(shots: Sequence[_Shot], labels: Sequence[str], height: int) -> tuple[float, float, float]:
    """Metres to either side and upwards that every cell shows, labels above the heads, and pixels per metre."""
    font = _font(height)
    text = max([font.getlength(name) + font.size for name in labels if name], default=0)
    top = max(shot.top for shot in shots) + (0.2 if text else 0.0)
    scale = height / (top - BOTTOM)
    return max(0.7, text / 2 / scale, *(shot.reach for shot in shots)), top, scale


def _font(height: int) -> ImageFont.FreeTypeFont:
    return ImageFont.load_default(max(11, round(0.065 * height)))


def _sheet(cells: Sequence[np.ndarray], columns: int, labels: Sequence[str], caption: str = "") -> Image.Image:
    """Cells in rows, each with its label in the upper left corner, or one label per row in the margin; the caption below."""
    w, tops = cells[0].shape[1], np.cumsum([0, *(cell.shape[0] for cell in cells[::columns])])
    font = _font(max(cell.shape[0] for cell in cells))
    size = font.size
    apart = len(cells) // len(labels)  # cells per label
    margin = 0 if len(labels) == len(cells) else round(max(font.getlength(name) for name in labels) + size)
    width = max(margin + columns * w, round(font.getlength(caption) + size))
    sheet = Image.new("RGB", (width, tops[-1] + (2 * size if caption else 0)), PAPER)
    text = ImageDraw.Draw(sheet)
    for i, cell in enumerate(cells):
        x, y = i % columns * w, int(tops[i // columns])
        sheet.paste(Image.fromarray((255 * cell + 0.5).astype(np.uint8)), (margin + x, y))
        if i % apart == 0:
            text.text((x + 0.5 * size, y + 0.4 * size), labels[i // apart], INK, font)
    text.text((0.5 * size, tops[-1] + 0.3 * size), caption, INK, font)
    return sheet


def _film(frames: Iterable[Image.Image], path: Path, fps: float) -> None:
    """Write an MP4 that browsers play: H.264, 4:2:0 and so of even width and height."""
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


def _reduce(frames: list[Image.Image], colors: int) -> list[Image.Image]:
    """The same pictures with one palette of a few colours, taken from some of them."""
    some = frames[:: max(1, len(frames) // 6)]
    width, height = some[0].size
    sample = Image.new("RGB", (width, height * len(some)))
    for k, frame in enumerate(some):
        sample.paste(frame, (0, k * height))
    palette = sample.quantize(colors, Image.Quantize.MEDIANCUT)
    return [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
