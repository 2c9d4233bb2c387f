"""Strip pictures: poses at equal steps of time, one row per clip. Matplotlib only, no OpenGL."""

import io
import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import torch
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from scipy.ndimage import gaussian_filter1d

from toolkit.io.files import atomic_write
from toolkit.motion import Clip, on_cpu, root_frames
from toolkit.motion import rotations as R
from toolkit.view import body
from toolkit.view.raycast import Canvas

PAPER, FLOOR, INK = "#f7f6f3", "#dedbd4", "#2b323b"


class Picture(Figure):
    """A figure that a notebook shows even where nothing has set up pyplot."""

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=self.dpi, facecolor=self.get_facecolor())
        return buffer.getvalue()


def strip(clips: Clip | Sequence[Clip], path: str | os.PathLike | None = None, *, frames: int = 8,
          labels: Sequence[str] | None = None, start: float = 0.0, stop: float | None = None, view: float = 60.0,
          elevation: float = 9.0, contacts=None, title: str = "", width: float = 12.0,
          dpi: int = 150) -> Figure:
    """Picture of one or more motions, a row each, time from left to right.

    Parameters
    ----------
    clips
        One clip or several.
    path
        PNG file to write (any format matplotlib knows).
    frames
        Poses per row.
    labels
        Text of each row; by default style and gait, else the clip's name.
    start, stop
        Seconds of the clips that are shown (default: all).
    view, elevation
        Degrees: the camera's angle from the facing direction (90 is from the right side) and above the floor.
    contacts
        Foot contacts [F, 2] (right, left) above one half where a foot stands, or one array per clip; shown on the feet.
    title
        Text above the picture.
    width, dpi
        Inches and pixels per inch.

    Returns
    -------
    Figure

    Raises
    ------
    ValueError
        If there is no clip or no frame to show, or labels or contacts do not fit the clips.
    """
    clips = on_cpu(clips)
    labels = [label(clip) for clip in clips] if labels is None else list(labels)
    contacts = contact_list(contacts, clips)
    if not clips or frames < 1 or len(labels) != len(clips):
        raise ValueError(f"a strip needs clips, frames and a label per clip; got {len(clips)} clips, {frames} frames, "
                         f"{len(labels)} labels")
    rows = [_Row(clip, _instants(clip, frames, start, stop), view, elevation, con)
            for clip, con in zip(clips, contacts, strict=True)]
    spacing = max(row.spacing for row in rows)
    scale = 2 * dpi * width / (spacing * frames)
    images = [row.image(spacing, scale, room=0.34 * spacing * frames / width) for row in rows]  # for the label
    head = 0.42 if title else 0.0
    heights = [image.shape[0] / (2 * dpi) for image in images]
    figure = Picture(figsize=(width, sum(heights) + head), dpi=dpi, facecolor=PAPER)
    FigureCanvasAgg(figure)
    total = figure.get_figheight()
    if title:
        figure.text(0.2 / width, 1 - 0.23 / total, title, size=13, weight="bold", color=INK, va="center")
    for i, (image, text, row) in enumerate(zip(images, labels, rows, strict=True)):
        row_height = heights[i]
        axes = figure.add_axes((0, sum(heights[i + 1 :]) / total, 1, row_height / total))
        axes.imshow(image, extent=(0, width, 0, row_height), aspect="auto", interpolation="antialiased")
        axes.set_axis_off()
        axes.set(xlim=(0, width), ylim=(0, row_height))
        axes.text(0.2, row_height - 0.12, text, size=12, weight="bold", color=INK, va="top")
        for k, t in enumerate(row.times):
            axes.text((k + 0.5) * width / frames, 0.07, f"{t:.2f} s", size=7, color=INK, alpha=0.6, ha="center")
    if path is not None:
        with atomic_write(path) as file:
            figure.savefig(file, format=Path(path).suffix[1:] or "png", dpi=dpi, facecolor=PAPER)
    return figure


def label(clip: Clip) -> str:
    """What to call a clip on screen."""
    return " ".join(x for x in (clip.style, clip.gait) if x) or clip.name


def contact_list(contacts, clips: Sequence[Clip]) -> list[np.ndarray | None]:
    """One contact array [F, 2] (or None) per clip.

    Raises
    ------
    ValueError
        If there is not one per clip or a shape differs.
    """
    if contacts is None:
        return [None] * len(clips)
    per_clip = list(contacts) if isinstance(contacts, list | tuple) else [contacts]
    per_clip = [None if c is None else np.asarray(c, dtype=np.float32) for c in per_clip]
    shapes = [None if c is None else c.shape for c in per_clip]
    if len(per_clip) != len(clips) or any(s not in (None, (len(c), 2)) for s, c in zip(shapes, clips, strict=True)):
        raise ValueError(f"contacts must be [F, 2] for each clip of {[len(c) for c in clips]} frames; got {shapes}")
    return per_clip


def _instants(clip: Clip, frames: int, start: float, stop: float | None) -> np.ndarray:
    last = len(clip) - 1 if stop is None else min(round(stop * clip.fps), len(clip) - 1)
    first = round(start * clip.fps)
    if not 0 <= first <= last:
        raise ValueError(f"{clip.name}: no frame between {start} s and {stop} s; the clip lasts {clip.seconds:.2f} s")
    return np.linspace(first, last, frames).round().astype(int)


class _Row:
    """The poses of one clip in camera space, and how much room they need."""

    def __init__(self, clip: Clip, instants: np.ndarray, view: float, elevation: float, contacts: np.ndarray | None):
        self.times, self.shapes = instants / clip.fps, body.build(clip)
        self.contacts = None if contacts is None else contacts[instants] > 0.5
        positions, facing = steady_frames(clip, 0.5)
        turn = R.yaw(torch.from_numpy(np.radians(view) - facing[instants]).float())
        away = clip.global_positions[instants] - torch.from_numpy(positions[instants]).float()[:, None]
        local = R.rotate(turn[:, None], away)
        rotations = R.multiply(turn[:, None], clip.global_rotations[instants])
        self.places = body.placements(self.shapes, rotations, local).astype(np.float64)  # [F, S, 3, 4]
        e = np.radians(elevation)
        self.camera = np.array([[1, 0, 0], [0, np.cos(e), -np.sin(e)], [0, np.sin(e), np.cos(e)]])
        self.places = self.camera @ self.places
        low, high = body.bounds(self.shapes, self.places)
        self.spacing = max(0.7, 2 * max(-low[0], high[0]) + 0.04)
        self.top = high[1]

    def image(self, spacing: float, scale: float, room: float) -> np.ndarray:
        bottom, top = -0.26, self.top + max(0.2, room)
        canvas = Canvas((0.0, spacing * len(self.times), bottom, top), scale)
        up = self.camera[:, 1]
        lamp = self.camera @ np.array([-0.35, 1.0, 0.3])
        for k, places in enumerate(self.places):
            places = places.copy()
            places[..., 0, 3] += (k + 0.5) * spacing
            floor = np.array([(k + 0.5) * spacing, 0.0, 0.0])
            canvas.draw(self.shapes, places, body.colors(self.shapes, None if self.contacts is None else self.contacts[k]))
            canvas.shadow(self.shapes, places, up, floor, lamp)
        y = np.linspace(top, bottom, canvas.height)  # the floor fades into the paper at the horizon
        blend = np.clip((0.16 - y) / 0.2, 0, 1)[:, None]
        paper, ground = (np.array(to_rgb(c)) for c in (PAPER, FLOOR))
        return canvas.image((paper * (1 - blend) + ground * blend)[:, None], paper)


def steady_frames(clip: Clip, seconds: float) -> tuple[np.ndarray, np.ndarray]:
    """Floor positions [F, 3] and facing angles [F] in radians, smoothed over time, for a camera to follow.

    Skeletons without hips are followed by their root, facing +Z.
    """
    sigma = max(seconds * clip.fps, 1e-3)
    if {"left_hip", "right_hip", "left_shoulder", "right_shoulder"} <= set(clip.skeleton.roles):
        frames = root_frames(clip)
        q = frames.rotations.double().numpy()
        angle = np.unwrap(2 * np.arctan2(q[:, 2], q[:, 0]))
        positions = frames.positions
    else:
        positions, angle = clip.root_positions * torch.tensor([1.0, 0.0, 1.0]), np.zeros(len(clip))
    smooth = gaussian_filter1d(positions.double().numpy(), 0.2 * sigma, axis=0, mode="nearest")
    return smooth, gaussian_filter1d(angle, sigma, mode="nearest")
