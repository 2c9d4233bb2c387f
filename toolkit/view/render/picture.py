"""Strip pictures: poses at equal steps of time, one row per clip.

What still and moving pictures of clips share.
"""

import io
import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import torch
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from scipy.ndimage import gaussian_filter1d

from toolkit.io.files import atomic_write
from toolkit.motion import Clip, on_cpu, root_frames
from toolkit.view.render import mannequin as body
from toolkit.view.render.bodies import BACK, Body, Camera, Pose, axes
from toolkit.view.render.skin import Figure as Character, figure_of
from toolkit.view.render.stage import open_stage

PAPER, INK = "#f7f6f3", "#2b323b"
TILT = 0.16  # radians by which the camera looks down
BOTTOM = -0.26  # metres of floor shown below the feet


class Picture(Figure):
    """A figure that a notebook shows even where nothing has set up pyplot."""

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=self.dpi, facecolor=self.get_facecolor())
        return buffer.getvalue()


def strip(
    clips: Clip | Sequence[Clip], path: str | os.PathLike | None = None, *, frames: int = 8,
    labels: Sequence[str] | None = None, start: float = 0.0, stop: float | None = None,
    view: float = 60.0, contacts=None, width: float = 12.0, dpi: int = 150,
    character: str | os.PathLike | Character | None = None
) -> Figure:
    """Picture of one or more motions, a row each, time from left to right.

    Parameters
    ----------
    clips, labels, contacts, view, character
        As in `toolkit.view.animate`; a label is the text of a row.
    path
        PNG file to write (any format matplotlib knows).
    frames, start, stop
        Poses per row; the seconds of the clips that are shown (default: all).
    width, dpi
        Inches, and pixels per inch.

    Raises
    ------
    ValueError
        If there is no clip or no frame to show, or labels or contacts do not fit the clips.
    """
    own = figure_of(character)
    clips, labels, contacts = cast(clips, labels, contacts, own)
    if frames < 1:
        raise ValueError(f"a strip needs frames, got {frames}")
    rows = []
    for clip, feet in zip(clips, contacts, strict=True):
        end = len(clip) - 1 if stop is None else min(round(stop * clip.fps), len(clip) - 1)
        if not 0 <= round(start * clip.fps) <= end:
            raise ValueError(
                f"{clip.name}: no frame between {start} s and {stop} s; the clip lasts "
                f"{clip.seconds:.2f} s"
            )
        instants = np.linspace(round(start * clip.fps), end, frames).round().astype(int)
        walked, facing = steady_frames(clip, 0.5)
        rows.append(_Row(Body(clip, feet, own), instants, walked[instants],
                         facing[instants] - np.radians(view), TILT))
    # All rows have the columns of the widest body, and room for the label above the tallest.
    spacing = max(0.7, *(2 * row.reach + 0.04 for row in rows))
    room = max(0.2, 0.34 * spacing * frames / width)
    images = [row.draw(spacing, round(dpi * width), room) for row in rows]
    heights = [image.shape[0] / dpi for image in images]
    total = sum(heights)
    figure = Picture(figsize=(width, total), dpi=dpi, facecolor=BACK)
    FigureCanvasAgg(figure)
    for i, (image, text, row) in enumerate(zip(images, labels, rows, strict=True)):
        high = heights[i]
        axes = figure.add_axes((0, sum(heights[i + 1 :]) / total, 1, high / total))
        axes.imshow(image, extent=(0, width, 0, high), aspect="auto", interpolation="antialiased")
        axes.set_axis_off()
        axes.set(xlim=(0, width), ylim=(0, high))
        axes.text(0.2, high - 0.12, text, size=12, weight="bold", color=INK, va="top",
                  parse_math=False)
        for k, frame in enumerate(row.frames):
            axes.text((k + 0.5) * width / frames, 0.07, f"{frame / row.body.clip.fps:.2f} s",
                      size=7, color=INK, alpha=0.6, ha="center")
    if path is not None:
        with atomic_write(path) as file:
            figure.savefig(file, format=Path(path).suffix[1:] or "png", dpi=dpi, facecolor=BACK)
    return figure


class _Row:
    """Some ``frames`` [N] of a body, side by side.

    Each has the point ``path`` [N, 3] of the floor in its middle and is seen from an own
    ``azimuth`` [N]. ``reach`` and ``top`` are how far the body goes to either side and upwards.
    """

    def __init__(self, body: Body, frames: np.ndarray, path: np.ndarray, azimuth: np.ndarray,
                 tilt: float):
        self.body, self.frames, self.path = body, frames, path
        self.turns, self.tilt = axes(azimuth, 0.0), tilt
        low, high = body.seen(frames, path, azimuth, tilt)
        self.reach, self.top = max(-low[0], high[0]), high[1]

    def draw(self, spacing: float, pixels: int, room: float) -> np.ndarray:
        """Picture [H, W, 3], ``spacing`` metres for each frame and ``room`` above the heads."""
        wide, high = spacing * len(self.frames), self.top + room - BOTTOM
        middle = np.array([wide / 2, (self.top + room + BOTTOM) / 2 / np.cos(self.tilt), 0.0])
        poses = []
        for k, (frame, place, turn) in enumerate(
            zip(self.frames, self.path, self.turns, strict=True)
        ):
            column = np.array([(k + 0.5) * spacing, 0.0, 0.0])
            poses.append(Pose(self.body, frame, turn, column - turn @ place))
        stage = open_stage((pixels, round(pixels * high / wide)))
        try:
            stage.load([self.body] * len(poses), np.array([-0.35, 1.0, 0.3]))
            return stage.draw(poses, Camera(middle, 0.0, self.tilt, high))
        finally:
            stage.close()


def cast(clips: Clip | Sequence[Clip], labels: Sequence[str] | None, contacts,
         figure: Character | None = None) -> tuple[list[Clip], list[str], list]:
    """Clips, on the rig of a figure, with a label and contacts [F, 2] or None for each.

    ValueError if they do not fit.
    """
    clips = on_cpu(clips)
    labels = (
        [" ".join(x for x in (c.style, c.gait) if x) or c.name for c in clips]
        if labels is None
        else list(labels)
    )
    if not clips or len(labels) != len(clips):
        raise ValueError(
            f"expected clips and a label per clip; got {len(clips)} clips, {len(labels)} labels"
        )
    return (
        clips if figure is None else [figure.fitted(clip) for clip in clips], labels,
        per_clip(contacts, clips)
    )


def per_clip(contacts, clips: Sequence[Clip]) -> list[np.ndarray | None]:
    """Contacts ``[F, 2]`` or None of each clip, from an array or a list of them.

    A ValueError if they do not fit.
    """
    contacts = (
        [None] * len(clips)
        if contacts is None
        else contacts
        if isinstance(contacts, list | tuple)
        else [contacts]
    )
    contacts = [None if feet is None else np.asarray(feet, dtype=np.float32) for feet in contacts]
    shapes, lengths = (
        [None if feet is None else feet.shape for feet in contacts], [len(clip) for clip in clips]
    )
    if len(shapes) != len(clips) or any(
        s not in (None, (n, 2)) for s, n in zip(shapes, lengths, strict=True)
    ):
        raise ValueError(f"contacts must be [F, 2] for each clip of {lengths} frames; got {shapes}")
    return contacts


def steady_frames(clip: Clip, seconds: float) -> tuple[np.ndarray, np.ndarray]:
    """Floor positions [F, 3] and facing angles [F] in radians, smoothed over time, for a camera to
    follow.

    Skeletons without hips and shoulders are followed by their root, facing +Z.
    """
    sigma = max(seconds * clip.fps, 1e-3)
    if body.has_roles(clip, "hip", "shoulder"):
        frames = root_frames(clip)
        q = frames.rotations.double().numpy()
        angle = np.unwrap(2 * np.arctan2(q[:, 2], q[:, 0]))
        positions = frames.positions
    else:
        positions, angle = clip.root_positions * torch.tensor([1.0, 0.0, 1.0]), np.zeros(len(clip))
    smooth = gaussian_filter1d(positions.double().numpy(), 0.2 * sigma, axis=0, mode="nearest")
    return smooth, gaussian_filter1d(angle, sigma, mode="nearest")
