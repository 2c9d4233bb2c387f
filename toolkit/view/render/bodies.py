"""What stands on a stage and from where it is seen: bodies, their poses, floor lines, cameras."""

from dataclasses import dataclass, field

import numpy as np
from matplotlib.colors import to_rgb

from toolkit.motion import Clip
from toolkit.view.render import mannequin
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
    """What a picture shows: a point in its middle, from where, and how many metres of height."""

    target: np.ndarray  # [3]
    azimuth: float  # radians, see `axes`
    tilt: float
    height: float  # metres from the bottom to the top of the picture, at the target
    perspective: bool = False  # otherwise a parallel projection


@dataclass(frozen=True, eq=False)
class Lines:
    """Lines on the floor, which fade away from the middle."""

    reach: float = 14.0  # metres
    heading: float = 0.0  # radians from +z: of the lines that the first spacing is along
    spacing: tuple[float, float] = (1.0, 1.0)  # metres along the heading and across
    start: np.ndarray = field(default_factory=lambda: np.zeros(3))  # where two lines cross

    def segments(self) -> np.ndarray:
        """Ends ``[N, 2, 3]`` of pieces of lines around a crossing."""
        (along, across), steps = self.spacing, [int(self.reach / s) for s in self.spacing]
        z, x = (s * np.arange(-n, n + 1) for s, n in zip((along, across), steps, strict=True))
        places = np.stack(np.meshgrid(x, [0.0], z, indexing="ij"), -1).reshape(-1, 3)
        pieces = [np.stack((places, places + step), 1) for step in ([0, 0, along], [across, 0, 0])]
        return np.concatenate(pieces) @ axes(self.heading, 0.0)

    def crossing(self, point: np.ndarray) -> np.ndarray:
        """The crossing [3] nearest to a point."""
        across, along = self.spacing[::-1]
        turn, size = axes(self.heading, 0.0), np.array([across, 1.0, along])
        nearest = np.round(turn @ (point - self.start) / size) * [1, 0, 1]
        return self.start * [1, 0, 1] + (nearest * size) @ turn

    def colors(self, segments: np.ndarray) -> np.ndarray:
        """Colours ``[..., 3]`` of ends of the pieces, 0 to 1."""
        far = np.linalg.norm(segments, axis=-1, keepdims=True) / self.reach
        faded = np.clip(far, 0, 1) ** 0.7
        return to_rgb(LINES) * (1 - faded) + to_rgb(BACK) * faded


class Body:
    """The mannequin of a clip, or a character of one's own on whose rig the clip is.

    ``contacts`` [F, 2] colour the right and the left foot where they stand; a ``tint`` [3] colours
    the whole mannequin.
    """

    def __init__(self, clip: Clip, contacts: np.ndarray | None = None,
                 figure: Figure | None = None, tint: np.ndarray | None = None):
        self.clip, self.contacts, self.tint, self.figure = clip, contacts, tint, figure
        self.mannequin = mannequin.build(clip) if figure is None else None
        self.skin = self.mannequin.skin if figure is None else figure.skin

    def colors(self, frame: int, feet: bool = True) -> np.ndarray:
        """Colours [V, 3] of the vertices, 0 to 1; ``feet`` shows the standing feet."""
        if self.mannequin is None:
            return self.figure.mesh.colors / 255
        stands = self.contacts[frame] > 0.5 if feet and self.contacts is not None else None
        return self.mannequin.colors(stands, self.tint)

    def seen(self, frames: np.ndarray, path: np.ndarray, azimuth: np.ndarray | float,
             tilt: float) -> tuple[np.ndarray, np.ndarray]:
        """Lowest and highest place [2] to the right and upwards, from points ``path`` [N, 3]."""
        positions, turn = self.clip.global_positions.double().numpy(), axes(azimuth, tilt)
        joints = (positions[frames] - path[:, None]) @ np.swapaxes(turn, -1, -2)
        low, high = (pick(joints[..., :2], (0, 1)) for pick in (np.min, np.max))
        first = frames[0]
        flesh = self.skin.pose(self.clip.global_rotations[first], self.clip.global_positions[first])
        wider = [np.ptp(points, axis=0).max() for points in (flesh[0], positions[first])]
        margin = max(MARGIN, (wider[0] - wider[1]) / 2 + 0.05)
        return low - margin, high + margin


@dataclass(frozen=True, eq=False)
class Pose:
    """A frame of a body, turned and moved on the stage."""

    body: Body
    frame: int
    turn: np.ndarray = field(default_factory=lambda: np.eye(3))
    move: np.ndarray = field(default_factory=lambda: np.zeros(3))
    feet: bool = True  # show which feet stand

    def mesh(self) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and normals [V, 3]."""
        clip = self.body.clip
        points, normals = self.body.skin.pose(
            clip.global_rotations[self.frame], clip.global_positions[self.frame]
        )
        return points @ self.turn.T + self.move, normals @ self.turn.T

    def joints(self) -> np.ndarray:
        """Places of the joints [J, 3]."""
        return (
            self.body.clip.global_positions[self.frame].double().numpy() @ self.turn.T + self.move
        )
