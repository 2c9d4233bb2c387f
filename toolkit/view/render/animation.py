"""Moving pictures of clips."""

import math
import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import ExitStack
from fractions import Fraction
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from scipy.ndimage import gaussian_filter1d

from toolkit.io.files import atomic_write
from toolkit.io.progress import progress_bar
from toolkit.io.save import figure_of
from toolkit.motion import Clip
from toolkit.view.render.bodies import BACK, Body, Camera, Lines, Pose, axes, cast, steady_frames
from toolkit.view.render.picture import INK
from toolkit.view.render.skin import Character
from toolkit.view.render.stage import open_stage

TILT = 0.21  # radians by which the camera looks down
GRID = 0.5  # metres between lines on the floor
BOTTOM = -0.3  # metres of floor shown below the feet
COLORS = 64  # of a GIF
ROW = 5  # cells that are put into one row
SUFFIXES = (".gif", ".png", ".apng", ".webp", ".mp4")


def animate(
    clips: Clip | Sequence[Clip], path: str | os.PathLike, *, labels: Sequence[str] | None = None,
    fps: float = 20.0, height: int = 200, view: float = 45.0, contacts=None,
    progress: bool = False, character: Character = None
) -> Path:
    """Write a looping animation of one or more motions, each in a cell, on a floor with lines.

    Parameters
    ----------
    clips, labels, contacts, character
        As in `toolkit.view.play`; a label is the text of a cell.
    path
        File to write: ``.gif``, ``.png`` or ``.apng`` (animated), ``.webp`` or ``.mp4`` (H.264).
    fps
        Pictures per second.
    height
        Height of a cell in pixels; its width follows from how far the arms reach.
    view
        Degrees of the camera from the facing direction; 90 is from the right side.

    Raises
    ------
    ValueError
        If the suffix is unknown, or as of `toolkit.view.play`.
    """
    path = Path(path)
    if path.suffix not in SUFFIXES:
        raise ValueError(f"an animation is a {', '.join(SUFFIXES[:-1])} or {SUFFIXES[-1]} file; "
                         f"got {path.name}")
    figure = figure_of(character)
    clips, labels, contacts = cast(clips, labels, contacts, figure)
    shots = [_Follow(Body(clip, feet, figure), view)
             for clip, feet in zip(clips, contacts, strict=True)]
    room = _room(shots, labels, height)
    length = max(round(clip.seconds * fps) for clip in clips)

    def drawn() -> Iterator[Image.Image]:
        with ExitStack() as stages:
            for shot in shots:
                shot.open(*room)
                stages.callback(shot.stage.close)
            for k in progress_bar(range(max(length, 1)), desc=path.name, show=progress):
                cells = [shot.cell(k / fps) for shot in shots]
                yield _sheet(cells, labels)

    return _write(drawn(), path, fps)


class _Follow:
    """A body seen by a camera that follows it at a steady pace, in degrees from where it faces."""

    def __init__(self, body: Body, view: float):
        self.body, clip = body, body.clip
        walked, facing = steady_frames(clip)
        # A smooth path whose ends fit together, as those of a loop do.
        straight = np.linspace(walked[0], walked[-1], len(walked))
        swings = gaussian_filter1d(walked - straight, 0.25 * clip.fps, axis=0, mode="wrap")
        self.path = straight + swings
        self.azimuth = np.arctan2(np.sin(facing).mean(), np.cos(facing).mean()) - np.radians(view)
        low, high = body.seen(np.arange(len(clip)), self.path, self.azimuth, TILT)
        self.reach, self.top = max(-low[0], high[0]), high[1]
        # Lines across the way are so far apart that the next round begins on one.
        travel = (walked[-1] - walked[0]) * (len(walked) / max(len(walked) - 1, 1))
        length, heading, apart = float(np.linalg.norm(travel)), facing[0], GRID
        if length > GRID:
            heading = np.arctan2(travel[0], travel[2])
            apart = length / round(length / GRID)
        self.lines = Lines(3.0, heading, (apart, GRID), self.path[0])

    def open(self, reach: float, top: float, scale: float) -> None:
        """Open a stage: ``reach`` metres to either side, ``top`` high, ``scale`` pixels each."""
        self.height, self.middle = top - BOTTOM, (top + BOTTOM) / 2 / np.cos(TILT)
        self.stage = open_stage([self.body], (round(2 * reach * scale), round(self.height * scale)),
                                np.array([-0.25, 1.0, 0.25]) @ axes(self.azimuth, 0.0), self.lines)

    def cell(self, seconds: float) -> Image.Image:
        """The picture at a time; a clip that is over starts again."""
        frame = round(seconds * self.body.clip.fps) % len(self.body.clip)
        target = self.path[frame] + [0.0, self.middle, 0.0]
        camera = Camera(target, self.azimuth, TILT, self.height)
        return Image.fromarray(self.stage.draw([Pose(self.body, frame)], camera))


def _room(shots: Sequence[_Follow], labels: Sequence[str],
          height: int) -> tuple[float, float, float]:
    """Metres to either side and upwards that every cell shows, and pixels per metre.

    Labels are above the heads.
    """
    font = _font(height)
    text = max([font.getlength(name) + font.size for name in labels if name], default=0)
    top = max(shot.top + 0.05 for shot in shots)
    scale = (height - (1.6 * font.size if text else 0)) / (top - BOTTOM)
    reach = max(0.7, text / 2 / scale, *(shot.reach + 0.03 for shot in shots))
    return reach, BOTTOM + height / scale, scale


def _font(height: int) -> ImageFont.FreeTypeFont:
    return ImageFont.load_default(max(11, round(0.065 * height)))


def _sheet(cells: Sequence[Image.Image], labels: Sequence[str]) -> Image.Image:
    """Cells in rows, each with its label in the upper left corner."""
    count, (width, height) = len(cells), cells[0].size
    columns = count if count <= ROW else math.ceil(math.sqrt(count))
    sheet = Image.new("RGB", (columns * width, height * math.ceil(count / columns)), BACK)
    text, font = ImageDraw.Draw(sheet), _font(height)
    for i, (cell, label) in enumerate(zip(cells, labels, strict=True)):
        x, y = i % columns * width, i // columns * height
        sheet.paste(cell, (x, y))
        text.text((x + 0.5 * font.size, y + 0.4 * font.size), label, INK, font)
    return sheet


def _write(frames: Iterable[Image.Image], path: Path, fps: float) -> Path:
    """Write pictures of equal size as one looping file."""
    if path.suffix == ".mp4":
        return _film(frames, path, fps)
    frames = list(frames)
    options = {"save_all": True, "duration": round(1000 / fps), "loop": 0}
    if path.suffix == ".gif":  # one palette of a few colours, taken from some of the frames
        sample = np.concatenate(frames[:: max(1, len(frames) // 6)])
        palette = Image.fromarray(sample).quantize(COLORS, Image.Quantize.MEDIANCUT)
        frames = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
        options["optimize"] = False
    elif path.suffix == ".webp":
        options["quality"] = 80
    with atomic_write(path) as file:
        frames[0].save(file, Image.registered_extensions()[path.suffix],
                       append_images=frames[1:], **options)
    return path


def _film(frames: Iterable[Image.Image], path: Path, fps: float) -> Path:
    """Write an MP4 that browsers play: H.264, 4:2:0 and therefore of even width and height."""
    import av  # here, as only films need it

    with (
        atomic_write(path) as file,
        av.open(file, "w", format="mp4", options={"movflags": "faststart"}) as film
    ):
        stream = film.add_stream(
            "libx264", rate=Fraction(fps).limit_denominator(1001), options={"crf": "18"}
        )
        stream.pix_fmt = "yuv420p"
        for frame in frames:
            picture = np.asarray(frame)[: frame.height // 2 * 2, : frame.width // 2 * 2]
            if not stream.codec_context.is_open:
                stream.height, stream.width = picture.shape[:2]
            film.mux(stream.encode(av.VideoFrame.from_ndarray(np.ascontiguousarray(picture))))
        film.mux(stream.encode())
    return path
