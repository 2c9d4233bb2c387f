"""Linear blend skinning: vertices near a joint follow two joints, so that limbs bend as one surface.

The transforms of both joints are added up by weight, as game engines do. The same shapes (`toolkit.view.body.Shape`) are
skinned here for pyvista and in the browser (``scene/body.js``); the software renderer draws exact cones, which do not bend.
"""

from collections.abc import Sequence

import numpy as np
from torch import Tensor

from toolkit.view.body import Shape, place

HOSTS = 3  # joints that a shape's vertices follow: its own and at most one beyond each end
FLANK = 4  # rings between the two caps


class Skin:
    """The surface of S shapes as one buffer of vertices, with ``around`` vertices around and ``along`` rings in each cap.

    ``triangles`` [T, 3] are indices of vertices, shape after shape; ``owners`` [S V] is the shape of each vertex.
    """

    def __init__(self, shapes: Sequence[Shape], around: int = 16, along: int = 5):
        parts = [surface(shape, around, along) for shape in shapes]
        points, normals, triangles = (np.stack([part[i] for part in parts]) for i in range(3))
        count = points.shape[1]
        self.triangles = (triangles + count * np.arange(len(shapes))[:, None, None]).reshape(-1, 3)
        self.owners = np.repeat(np.arange(len(shapes)), count)
        shares = np.stack([weights(shape, y) for shape, y in zip(shapes, points[..., 1], strict=True)])[..., None]
        thin = np.array([np.linalg.norm(shape.place[:, 2]) for shape in shapes])[:, None]
        normals[..., 2] /= thin**2  # normals are transformed by the inverse transpose
        homogeneous = np.concatenate((points, np.ones_like(points[..., :1])), -1)
        self._points = (shares * homogeneous[:, :, None]).reshape(len(shapes), count, -1).astype(np.float32)
        self._normals = (shares * normals[:, :, None]).reshape(len(shapes), count, -1).astype(np.float32)

    def pose(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and unit normals [S V, 3] in the world, for `placements` [S, HOSTS, 3, 4]."""
        normals = self._normals @ places[..., :3].swapaxes(2, 3).reshape(len(places), -1, 3)
        normals /= np.sqrt(np.einsum("svi,svi->sv", normals, normals))[..., None]
        return self.points(places), normals.reshape(-1, 3)

    def points(self, places: np.ndarray) -> np.ndarray:
        """The vertices [S V, 3] alone."""
        return (self._points @ places.swapaxes(2, 3).reshape(len(places), -1, 3)).reshape(-1, 3)


def weights(shape: Shape, y: np.ndarray) -> np.ndarray:
    """Skinning weights [V, HOSTS] of a shape's own joint and its bends' joints, at heights ``y`` [V] in its own frame."""
    shares = np.zeros((len(y), HOSTS))
    for i, bend in enumerate(shape.bends, start=1):
        t = np.clip(0.5 + 0.5 * (y - bend.at) / bend.width, 0, 1)
        shares[:, i] = t * t * (3 - 2 * t)
    shares[:, 0] = 1 - shares.sum(1)
    return shares


def placements(shapes: Sequence[Shape], rotations: Tensor, positions: Tensor) -> np.ndarray:
    """World placement ``[..., S, HOSTS, 3, 4]`` of S shapes by each joint that they follow.

    From global rotations ``[..., J, 4]`` and positions ``[..., J, 3]``.
    """
    hosts = [[(s.joint, s.place), *((bend.joint, bend.place) for bend in s.bends)] for s in shapes]
    hosts = [row + row[:1] * (HOSTS - len(row)) for row in hosts]  # the own joint again, with weight zero
    joints, places = ([[host[i] for host in row] for row in hosts] for i in (0, 1))
    return place(joints, places, rotations, positions)


def surface(shape: Shape, around: int = 16, along: int = 5) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices [V, 3] and normals [V, 3] in the cone's own frame, and triangles [T, 3]."""
    (r0, r1), h = shape.radii, shape.length
    tilt = np.arcsin((r0 - r1) / h)
    flank = 0.5 - 0.5 * np.cos(np.pi * np.arange(1, FLANK + 1) / (FLANK + 1))  # denser at the ends, where it bends
    caps = np.linspace(-np.pi / 2, tilt, along + 1), np.linspace(tilt, np.pi / 2, along + 1)
    angles = np.concatenate((caps[0], np.full(FLANK, tilt), caps[1]))
    share = np.concatenate((np.zeros(along + 1), flank, np.ones(along + 1)))  # from one sphere to the other
    turn = np.linspace(0, 2 * np.pi, around, endpoint=False)
    ring = np.stack((np.cos(turn), np.zeros(around), np.sin(turn)), 1)
    normals = np.cos(angles)[:, None, None] * ring + np.sin(angles)[:, None, None] * np.eye(3)[1]
    vertices = normals * (r0 + share * (r1 - r0))[:, None, None] + (share * h)[:, None, None] * np.eye(3)[1]
    i, k = np.meshgrid(np.arange(len(angles) - 1), np.arange(around), indexing="ij")
    a, b = i * around + k, i * around + (k + 1) % around
    triangles = np.concatenate((np.stack((a, a + around, b), -1), np.stack((b, a + around, b + around), -1)), 0)
    return vertices.reshape(-1, 3), normals.reshape(-1, 3), triangles.reshape(-1, 3)
