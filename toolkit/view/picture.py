"""Strip pictures: poses at equal steps of time, one row per clip; what still and moving pictures of clips share."""

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
from toolkit.view import body
from toolkit.view.canvas import Canvas, orbit
from toolkit.view.character import Character

PAPER, FLOOR, INK = "#f7f6f3", "#dedbd4", "#2b323b"
BOTTOM = -0.26  # metres of floor shown below the feet


class Picture(Figure):
    """A figure that a notebook shows even where nothing has set up pyplot."""

    def _repr_png_(self) -> bytes:
        buffer = io.BytesIO()
        self.savefig(buffer, format="png", dpi=self.dpi, facecolor=self.get_facecolor())
        return buffer.getvalue()


def strip(clips: Clip | Sequence[Clip], path: str | os.PathLike | None = None, *, frames: int = 8,
          labels: Sequence[str] | None = None, start: float = 0.0, stop: float | None = None, view: float = 60.0,
          elevation: float = 9.0, contacts=None, width: float = 12.0,
          dpi: int = 150, character: str | os.PathLike | Character | None = None) -> Figure:
    """Picture of one or more motions, a row each, time from left to right.

    Parameters
    ----------
    clips, labels, contacts, view, elevation, character
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
    own = Character.of(character)
    clips, labels, contacts = cast(clips, labels, contacts, own)
    if frames < 1:
        raise ValueError(f"a strip needs frames, got {frames}")
    shots = []
    for clip, con in zip(clips, contacts, strict=True):
        end = len(clip) - 1 if stop is None else min(round(stop * clip.fps), len(clip) - 1)
        if not 0 <= round(start * clip.fps) <= end:
            raise ValueError(f"{clip.name}: no frame between {start} s and {stop} s; the clip lasts {clip.seconds:.2f} s")
        instants = np.linspace(round(start * clip.fps), end, frames).round().astype(int)
        walked, facing = steady_frames(clip, 0.5)
        shots.append(Shot(clip, con, instants, walked, np.radians(view) - facing[instants], np.radians(elevation), own))
    spacing = max(0.7, *(2 * shot.reach + 0.04 for shot in shots))
    scale, room = 2 * dpi * width / (spacing * frames), max(0.2, 0.34 * spacing * frames / width)  # for the label
    images = [_row(shot, spacing, scale, shot.top + room) for shot in shots]
    heights = [image.shape[0] / (2 * dpi) for image in images]
    total = sum(heights)
    figure = Picture(figsize=(width, total), dpi=dpi, facecolor=PAPER)
    FigureCanvasAgg(figure)
    for i, (image, text, shot) in enumerate(zip(images, labels, shots, strict=True)):
        axes = figure.add_axes((0, sum(heights[i + 1 :]) / total, 1, heights[i] / total))
        axes.imshow(image, extent=(0, width, 0, heights[i]), aspect="auto", interpolation="antialiased")
        axes.set_axis_off()
        axes.set(xlim=(0, width), ylim=(0, heights[i]))
        axes.text(0.2, heights[i] - 0.12, text, size=12, weight="bold", color=INK, va="top", parse_math=False)
        for k, t in enumerate(shot.times):
            axes.text((k + 0.5) * width / frames, 0.07, f"{t:.2f} s", size=7, color=INK, alpha=0.6, ha="center")
    if path is not None:
        with atomic_write(path) as file:
            figure.savefig(file, format=Path(path).suffix[1:] or "png", dpi=dpi, facecolor=PAPER)
    return figure


def _row(shot: "Shot", spacing: float, scale: float, top: float) -> np.ndarray:
    """Picture [H, W, 3] of a shot's frames side by side, on a floor that fades into the paper at the horizon."""
    canvas = Canvas((0.0, spacing * len(shot.frames), BOTTOM, top), scale, shot.camera[0])
    for k in range(len(shot.frames)):
        shot.draw(canvas, k, (-0.35, 1.0, 0.3), shift=(k + 0.5) * spacing)
    y = np.linspace(top, BOTTOM, canvas.height)
    blend = np.clip((0.16 - y) / 0.2, 0, 1)[:, None]
    paper, ground = (np.array(to_rgb(c)) for c in (PAPER, FLOOR))
    return canvas.image((paper * (1 - blend) + ground * blend)[:, None], paper)


class Shot:
    """Some ``frames`` [N] of a clip as a camera sees them.

    The point ``path`` [F, 3] of the floor is at the origin of camera space. The camera's angles are those of
    `toolkit.view.canvas.orbit`; there may be an azimuth for each of the frames. ``low`` and ``high`` [3] are bounds of the
    body in camera space; ``reach`` and ``top`` are its largest distances from the origin to the left or right, and upwards.
    Metres. A ``figure``, on whose rig the clip is, is drawn in place of the mannequin.
    """

    def __init__(self, clip: Clip, contacts: np.ndarray | None, frames: np.ndarray, path: np.ndarray,
                 azimuth: np.ndarray | float, elevation: float, figure: Character | None = None):
        self.clip, self.frames, self.times, self.body = clip, frames, frames / clip.fps, body.build(clip)
        self.skin, self.own = (self.body.skin, None) if figure is None else (figure.skin, figure.mesh.colors / 255)
        self.camera, self.tilt = orbit(azimuth, elevation), orbit(0.0, elevation)
        self.contacts = None if contacts is None else contacts[frames] > 0.5
        self.path = path[frames]
        seen = [self._seen(k)[0] for k in range(len(frames))]
        self.low, self.high = np.min([x.min(0) for x in seen], 0), np.max([x.max(0) for x in seen], 0)
        self.reach, self.top = max(-self.low[0], self.high[0]), self.high[1]

    def _seen(self, k: int) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and normals [V, 3] of one of the frames in camera space."""
        frame, camera = self.frames[k], self.camera[k] if self.camera.ndim == 3 else self.camera
        points, normals = self.skin.pose(self.clip.global_rotations[frame], self.clip.global_positions[frame])
        return (points - self.path[k]) @ camera.T, normals @ camera.T

    def draw(self, canvas: Canvas, k: int, lamp: Sequence[float], shift: float = 0.0,
             colors: np.ndarray | None = None) -> None:
        """Draw one of the frames with its shadow, ``shift`` metres to the right; the lamp goes along with the camera.

        ``colors`` [V, 3] of the vertices may be others than the body's.
        """
        right, (points, normals), colors = (shift, 0, 0), self._seen(k), self.own if colors is None else colors
        if colors is None:
            colors = self.body.colors(None if self.contacts is None else self.contacts[k])
        canvas.draw(points + right, normals, self.skin.triangles, colors, self.tilt @ np.array(lamp), right)


def cast(clips: Clip | Sequence[Clip], labels: Sequence[str] | None, contacts,
         figure: Character | None = None) -> tuple[list[Clip], list[str], list]:
    """Clips, on the rig of a figure, with a label and contacts [F, 2] or None for each; ValueError if they do not fit."""
    clips = on_cpu(clips)
    labels = [" ".join(x for x in (c.style, c.gait) if x) or c.name for c in clips] if labels is None else list(labels)
    if not clips or len(labels) != len(clips):
        raise ValueError(f"expected clips and a label per clip; got {len(clips)} clips, {len(labels)} labels")
    return clips if figure is None else [figure.fitted(clip) for clip in clips], labels, per_clip(contacts, clips)


def per_clip(contacts, clips: Sequence[Clip]) -> list[np.ndarray | None]:
    """Contacts ``[F, 2]`` or None of each clip, from an array or a list of them; a ValueError if they do not fit."""
    contacts = [None] * len(clips) if contacts is None else contacts if isinstance(contacts, list | tuple) else [contacts]
    contacts = [None if feet is None else np.asarray(feet, dtype=np.float32) for feet in contacts]
    shapes, lengths = [None if feet is None else feet.shape for feet in contacts], [len(clip) for clip in clips]
    if len(shapes) != len(clips) or any(s not in (None, (n, 2)) for s, n in zip(shapes, lengths, strict=True)):
        raise ValueError(f"contacts must be [F, 2] for each clip of {lengths} frames; got {shapes}")
    return contacts


def steady_frames(clip: Clip, seconds: float) -> tuple[np.ndarray, np.ndarray]:
    """Floor positions [F, 3] and facing angles [F] in radians, smoothed over time, for a camera to follow.

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
