"""Drawings on the floor around a character.

Its path, a footprint for every contact, the trajectory window.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from toolkit.motion import Clip, root_frames, trajectory
from toolkit.motion.contacts import FEET
from toolkit.view.render.mannequin import COLORS, PALETTE, has_roles

AHEAD, PAST = "#b9b3a7", "#8d8678"
POINTS = 400  # corners of a path at most: pairs of them, evenly over the clip
# Sideways and ahead, metres.
ARROW = np.array([[0, 0.09], [0.05, -0.05], [0, -0.02], [-0.05, -0.05]])


@dataclass(frozen=True, eq=False)
class Layer:
    """Flat triangles of one colour, whose corners move with the frame.

    Any renderer can draw them.
    """

    kind: str  # "path", "contacts" or "trajectory": shown and hidden together
    color: str
    height: float  # metres above the floor; higher layers cover lower ones
    triangles: np.ndarray  # [T, 3], indices of corners
    corners: Callable[[int], np.ndarray]  # frame to the corners [V, 2] (x and z, metres)


def layers(clip: Clip, contacts: np.ndarray | None = None) -> list[Layer]:
    """All layers of a clip; ``contacts`` [F, 2] are of the right and the left foot."""
    found = _path(clip)
    if contacts is not None:
        found += _footprints(clip, contacts)
    return found + _arrows(clip) if has_roles(clip, "hip", "shoulder") else found


def _repeated(triangles: np.ndarray, times: int, stride: int) -> np.ndarray:
    """Triangles [T, 3] of one figure, for ``times`` figures whose corners follow each other by
    ``stride``.
    """
    return (np.array(triangles) + stride * np.arange(times)[:, None, None]).reshape(-1, 3)


def _path(clip: Clip) -> list[Layer]:
    """The root's path, and over it the part up to the frame."""
    points = clip.root_positions[:, [0, 2]].double().numpy()
    along = np.gradient(points, axis=0) if len(points) > 1 else np.zeros_like(points)
    length = np.linalg.norm(along, axis=1, keepdims=True)
    side = np.where(length > 1e-6, along[:, ::-1] * [1, -1] / np.maximum(length, 1e-6), [1.0, 0.0])
    kept = np.unique(np.linspace(0, len(points) - 1, POINTS // 2).round().astype(int))
    edges = np.stack((points + 0.5 * side, points - 0.5 * side), 1)  # a metre apart
    middle = points[:, None]
    narrow, wide = (middle + width * (edges - middle) for width in (0.012, 0.028))
    triangles = _repeated([[0, 2, 1], [1, 2, 3]], len(kept) - 1, 2)
    whole = narrow[kept].reshape(-1, 2)

    def done(frame: int) -> np.ndarray:
        return wide[np.minimum(kept, frame)].reshape(-1, 2)

    return [
        Layer("path", AHEAD, 0.005, triangles, lambda frame: whole),
        Layer("path", PALETTE[0], 0.008, triangles, done)
    ]


def _footprints(clip: Clip, contacts: np.ndarray) -> list[Layer]:
    """An ellipse for each contact, where the foot is in the middle of it, shown from its first
    frame on.
    """
    turn = np.linspace(0, 2 * np.pi, 16, endpoint=False)
    ring = np.stack((0.042 * np.cos(turn), np.sin(turn)), 1)  # metres sideways, half lengths along
    fan = np.stack((0 * turn[2:], np.arange(1, 15), np.arange(2, 16)), 1).astype(int)
    found = []
    for i, side in enumerate(FEET):
        if f"{side}_toe" not in clip.skeleton.roles:
            continue
        ankle, end = clip.skeleton.role(f"{side}_foot"), clip.skeleton.end_site(f"{side}_toe")
        starts, stops = np.flatnonzero(np.diff(np.r_[0, contacts[:, i] > 0.5, 0])).reshape(-1, 2).T
        heel, toe = (
            clip.global_positions[(starts + stops) // 2, j][:, [0, 2]].double().numpy()
            for j in (ankle, end)
        )
        length = np.linalg.norm(toe - heel, axis=1, keepdims=True)
        along = (toe - heel) / np.maximum(length, 1e-6)
        across = along[:, ::-1] * [1, -1]
        along *= length / 2 + 0.04
        prints = (
            (heel + toe)[:, None] / 2 + ring[:, :1] * across[:, None] + ring[:, 1:] * along[:, None]
        )

        def corners(frame: int, prints=prints, starts=starts) -> np.ndarray:
            return np.where((starts <= frame)[:, None, None], prints, prints[:, :1]).reshape(-1, 2)

        found.append(
            Layer("contacts", COLORS[side], 0.011, _repeated(fan, len(prints), 16), corners)
        )
    return found


def _arrows(clip: Clip) -> list[Layer]:
    """The trajectory window (section 3.2).

    Positions and facing directions of the root, a second back and ahead.
    """
    roots = root_frames(clip)
    places = roots.positions[:, [0, 2]].double().numpy()
    ahead = np.stack([t.double().numpy() for t in trajectory.heading(roots.rotations)], 1)
    across = ahead[:, ::-1] * [1, -1]
    # [F, 4, 2].
    arrows = places[:, None] + ARROW[:, :1] * across[:, None] + ARROW[:, 1:] * ahead[:, None]
    offsets = np.round(np.array(trajectory.SAMPLES) * clip.fps / trajectory.FPS).astype(int)
    found = []
    for tone, samples in ((PAST, offsets[offsets < 0]), (PALETTE[0], offsets[offsets >= 0])):

        def corners(frame: int, samples=samples) -> np.ndarray:
            at = np.clip(frame + samples, 0, len(clip) - 1)
            # Outside of the clip, an arrow is a point.
            inside = (at == frame + samples)[:, None, None]
            return np.where(inside, arrows[at], places[at][:, None]).reshape(-1, 2)

        found.append(
            Layer(
                "trajectory", tone, 0.014, _repeated([[0, 1, 2], [0, 2, 3]], len(samples), 4),
                corners
            )
        )
    return found
