"""What stands on a stage and from where it is seen: bodies, their poses, floor lines, cameras."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import torch

from toolkit.motion import Clip, on_cpu, root_frames
from toolkit.view.render import mannequin
from toolkit.view.render.mannequin import rgb
from toolkit.view.render.skin import Figure

BACK, SHADE, LINES = "#efece6", "#cdc8be", "#cbc5b9"
MARGIN = 0.1  # metres by which a body is wider than its joints, at least


def axes(azimuth: np.ndarray | float, tilt: float) -> np.ndarray:
    """Directions to the right, upwards and towards the viewer, the rows of ``[..., 3, 3]``.

    A camera with azimuth 0 looks at the front of what faces +z; it looks down by ``tilt``. Radians.
    """
    azimuth = np.asarray(azimuth, np.float64)
    sine, cosine, zero = np.sin(azimuth), np.cos(azimuth), np.zeros_like(azimuth)
    right = np.stack((cosine, zero, -sine), -1)
    back = np.stack((sine * np.cos(tilt), zero + np.sin(tilt), cosine * np.cos(tilt)), -1)
    return np.stack((right, np.cross(back, right), back), -2)


@dataclass(frozen=True, eq=False)
class Camera:
    """What a parallel projection shows: a point in its middle, from where, and how much."""

    target: np.ndarray  # [3]
    azimuth: float  # radians, see `axes`
    tilt: float
    height: float  # metres from the bottom to the top of the picture


@dataclass(frozen=True, eq=False)
class Lines:
    """Lines on the floor, which fade away from the middle."""

    reach: float = 14.0  # metres
    heading: float = 0.0  # radians from +z: of the lines that the first spacing is along
    spacing: tuple[float, float] = (1.0, 1.0)  # metres along the heading and across
    start: np.ndarray = field(default_factory=lambda: np.zeros(3))  # where two lines cross

    def segments(self) -> np.ndarray:
        """Ends ``[N, 2, 3]`` of pieces of lines around a crossing."""
        along, across = self.spacing
        z, x = (s * np.arange(-int(self.reach / s), int(self.reach / s) + 1) for s in self.spacing)
        places = np.stack(np.meshgrid(x, [0.0], z, indexing="ij"), -1).reshape(-1, 3)
        pieces = [np.stack((places, places + step), 1) for step in ([0, 0, along], [across, 0, 0])]
        return np.concatenate(pieces) @ axes(self.heading, 0.0)

    def crossing(self, point: np.ndarray) -> np.ndarray:
        """The crossing [3] nearest to a point."""
        along, across = self.spacing
        turn, size, flat = axes(self.heading, 0.0), np.array([across, 1.0, along]), [1, 0, 1]
        nearest = np.round(turn @ (point - self.start) / size) * flat
        return self.start * flat + (nearest * size) @ turn

    def colors(self, segments: np.ndarray) -> np.ndarray:
        """Colours ``[..., 3]`` of ends of the pieces, 0 to 1."""
        far = np.linalg.norm(segments, axis=-1, keepdims=True) / self.reach
        faded = np.clip(far, 0, 1) ** 0.7
        return rgb(LINES) * (1 - faded) + rgb(BACK) * faded


class Body:
    """The mannequin of a clip, or a character of one's own on whose rig the clip is.

    ``contacts`` [F, 2] colour the right and the left foot where they stand.
    """

    def __init__(self, clip: Clip, contacts: np.ndarray | None = None,
                 figure: Figure | None = None):
        self.clip, self.contacts, self.figure = clip, contacts, figure
        self.mannequin = mannequin.build(clip) if figure is None else None
        self.skin = self.mannequin.skin if figure is None else figure.skin

    def colors(self, frame: int) -> np.ndarray:
        """Colours [V, 3] of the vertices, 0 to 1."""
        if self.mannequin is None:
            return self.figure.mesh.colors / 255
        stands = None if self.contacts is None else self.contacts[frame] > 0.5
        return self.mannequin.colors(stands)

    def seen(self, frames: np.ndarray, path: np.ndarray, azimuth: np.ndarray | float,
             tilt: float) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest place [2] to the right and upwards, from points ``path`` [N, 3]."""
        positions, turn = self.clip.global_positions.double().numpy(), axes(azimuth, tilt)
        joints = (positions[frames] - path[:, None]) @ np.swapaxes(turn, -1, -2)
        # flesh is wider than joints
        flesh = Pose(self, frames[0]).mesh()[0]
        wider = [np.ptp(points, axis=0).max() for points in (flesh, positions[frames[0]])]
        margin = max(MARGIN, (wider[0] - wider[1]) / 2 + 0.05)
        return joints[..., :2].min((0, 1)) - margin, joints[..., :2].max((0, 1)) + margin


@dataclass(frozen=True, eq=False)
class Pose:
    """A frame of a body, turned and moved on the stage."""

    body: Body
    frame: int
    turn: np.ndarray = field(default_factory=lambda: np.eye(3))
    move: np.ndarray = field(default_factory=lambda: np.zeros(3))

    def mesh(self) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and normals [V, 3]."""
        clip, frame = self.body.clip, self.frame
        points, normals = self.body.skin.pose(clip.global_rotations[frame],
                                              clip.global_positions[frame])
        return points @ self.turn.T + self.move, normals @ self.turn.T


def cast(clips: Clip | Sequence[Clip], labels: Sequence[str] | None, contacts,
         figure: Figure | None = None) -> tuple[list[Clip], list[str], list]:
    """Clips, on the rig of a figure, with a label and contacts [F, 2] or None for each.

    ValueError if they do not fit.
    """
    clips = on_cpu(clips)
    if labels is None:
        labels = [clip.label for clip in clips]
    if not clips or len(labels) != len(clips):
        raise ValueError(f"expected clips and a label per clip; got {len(clips)} clips, "
                         f"{len(labels)} labels")

    # contacts may be an array, or one for each clip
    feet = [None] * len(clips) if contacts is None else contacts
    feet = feet if isinstance(feet, list | tuple) else [feet]
    feet = [None if one is None else np.asarray(one, dtype=np.float32) for one in feet]
    shapes = [getattr(one, "shape", None) for one in feet]
    if len(feet) != len(clips) or any(
            shape not in (None, (len(clip), 2)) for shape, clip in zip(shapes, clips, strict=True)):
        raise ValueError(f"contacts must be [F, 2] for each clip of {list(map(len, clips))} "
                         f"frames; got {shapes}")
    return [figure.fitted(clip) for clip in clips] if figure else clips, list(labels), feet


def steady_frames(clip: Clip) -> tuple[np.ndarray, np.ndarray]:
    """Floor positions [F, 3] and facing angles [F], radians, smoothed for a camera to follow.

    Skeletons without hips and shoulders are followed by their root, facing +Z.
    """
    from scipy.ndimage import gaussian_filter1d  # a live character starts without it

    sigma = 0.5 * clip.fps
    if clip.skeleton.has("hip", "shoulder"):
        frames = root_frames(clip)
        q = frames.rotations.double().numpy()
        angle = np.unwrap(2 * np.arctan2(q[:, 2], q[:, 0]))
        positions = frames.positions
    else:
        positions, angle = clip.root_positions * torch.tensor([1.0, 0.0, 1.0]), np.zeros(len(clip))
    smooth = gaussian_filter1d(positions.double().numpy(), 0.2 * sigma, axis=0, mode="nearest")
    return smooth, gaussian_filter1d(angle, sigma, mode="nearest")
