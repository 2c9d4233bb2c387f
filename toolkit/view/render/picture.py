"""Strip pictures: poses of the whole step cycle, one row per clip."""

import io
import math
import os
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from toolkit.io.files import atomic_write
from toolkit.io.save import figure_of
from toolkit.motion import Clip, root_frames
from toolkit.view.render.bodies import BACK, Body, Camera, Pose, axes, cast, steady_frames
from toolkit.view.render.skin import Character
from toolkit.view.render.stage import open_stage

PAPER, INK = "#f7f6f3", "#2b323b"
TILT = 0.16  # radians by which the camera looks down
VIEW = 60.0  # degrees of the camera from the facing direction
BOTTOM = -0.26  # metres of floor shown below the feet
STEP = 0.1  # metres by which a foot is ahead of the other in a step, at least


class Picture(Figure):
    """A figure that a notebook shows even where nothing has set up pyplot."""

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=self.dpi, facecolor=self.get_facecolor())
        return buffer.getvalue()


def strip(
    clips: Clip | Sequence[Clip], path: str | os.PathLike | None = None, *, frames: int = 8,
    labels: Sequence[str] | None = None, contacts=None, width: float = 12.0, dpi: int = 150,
    character: Character = None
) -> Figure:
    """Picture of one or more motions, a row each, time from left to right.

    Poses of a walk are at equal steps of its phase, so that each shows another part of a stride
    (`instants`).

    Parameters
    ----------
    clips, labels, contacts, character
        As in `toolkit.view.play`; a label is the text of a row.
    path
        PNG file to write (any format matplotlib knows).
    frames
        Poses per row.
    width, dpi
        Inches, and pixels per inch.

    Raises
    ------
    ValueError
        If there is no frame to show, or as of `toolkit.view.play`.
    """
    own = figure_of(character)
    clips, labels, contacts = cast(clips, labels, contacts, own)
    if frames < 1:
        raise ValueError(f"a strip needs frames, got {frames}")
    rows = []
    for clip, feet in zip(clips, contacts, strict=True):
        at = instants(clip, frames)
        walked, facing = steady_frames(clip)
        rows.append((Body(clip, feet, own), at, walked[at], facing[at] - np.radians(VIEW)))
    # All rows have the columns of the widest body, and room for the label above the tallest.
    seen = [body.seen(at, walked, azimuth, TILT) for body, at, walked, azimuth in rows]
    spacing = max(0.7, *(2 * max(-low[0], high[0]) + 0.04 for low, high in seen))
    room = max(0.2, 0.34 * spacing * frames / width)
    images = [_drawn(*row, high[1] + room, spacing, round(dpi * width))
              for row, (_, high) in zip(rows, seen, strict=True)]
    heights = [image.shape[0] / dpi for image in images]
    total = sum(heights)
    figure = Picture(figsize=(width, total), dpi=dpi, facecolor=BACK)
    bottom = total
    for image, high, text, (body, at, *_) in zip(images, heights, labels, rows, strict=True):
        bottom -= high
        axes = figure.add_axes((0, bottom / total, 1, high / total))
        axes.imshow(image, extent=(0, width, 0, high), aspect="auto", interpolation="antialiased")
        axes.set_axis_off()
        axes.set(xlim=(0, width), ylim=(0, high))
        axes.text(0.2, high - 0.12, text, size=12, weight="bold", color=INK, va="top",
                  parse_math=False)
        for k, frame in enumerate(at):
            axes.text((k + 0.5) * width / frames, 0.07, f"{frame / body.clip.fps:.2f} s",
                      size=7, color=INK, alpha=0.6, ha="center")
    if path is not None:
        with atomic_write(path) as file:
            figure.savefig(file, format=Path(path).suffix[1:] or "png", dpi=dpi, facecolor=BACK)
    return figure


def instants(clip: Clip, count: int) -> np.ndarray:
    """Frames ``[count]`` at which a strip shows a clip.

    At equal times, a strip can show the same pose of each stride. So N poses are k/N of a stride
    apart, k without a common factor with N: each shows another part of the stride. Without strides
    they are at equal times.
    """
    even = np.linspace(0, len(clip) - 1, count).round().astype(int)
    if not clip.skeleton.has("foot", "hip", "shoulder") or len(clip) <= count:
        return even
    # how far the left foot is ahead of the right one, and the phase of its analytic signal
    right, left = clip.global_positions[:, clip.skeleton.both("foot")].unbind(1)
    curve = root_frames(clip).turn_to_local(left - right)[:, 2].double().numpy()
    if curve.std() < STEP:
        return even
    ahead = np.fft.fftfreq(len(curve)) > 0
    phase = np.unwrap(np.angle(np.fft.ifft(ahead * np.fft.fft(curve))))
    strides = np.maximum.accumulate(phase) / (2 * np.pi)
    steps = int((strides[-1] - strides[0]) * count / max(count - 1, 1))  # in parts of a stride
    while steps > 1 and math.gcd(steps, count) > 1:
        steps -= 1
    if steps < 1:
        return even
    phases = strides[0] + np.arange(count) * steps / count
    return np.searchsorted(strides, phases).clip(max=len(clip) - 1)


def _drawn(body: Body, frames: np.ndarray, path: np.ndarray, azimuth: np.ndarray, top: float,
           spacing: float, pixels: int) -> np.ndarray:
    """Picture [H, W, 3] of ``frames`` [N] of a body, side by side, ``spacing`` metres for each.

    Each has the point ``path`` [N, 3] of the floor in its middle and is seen from an own
    ``azimuth`` [N], up to the height ``top``.
    """
    wide, high = spacing * len(frames), top - BOTTOM
    middle = np.array([wide / 2, (top + BOTTOM) / 2 / np.cos(TILT), 0.0])
    poses = []
    for frame, place, turn in zip(frames, path, axes(azimuth, 0.0), strict=True):
        column = np.array([(len(poses) + 0.5) * spacing, 0.0, 0.0])
        poses.append(Pose(body, frame, turn, column - turn @ place))
    stage = open_stage([body] * len(poses), (pixels, round(pixels * high / wide)),
                       np.array([-0.35, 1.0, 0.3]))
    with closing(stage):
        return stage.draw(poses, Camera(middle, 0.0, TILT, high))
