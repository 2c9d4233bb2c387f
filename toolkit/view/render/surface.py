"""One smooth surface around rounded cones: an implicit function, its polygons and ambient
occlusion.

A rounded cone is the convex hull of two spheres, pressed flat along one direction. Cones of one
part, and then the parts, are joined by a smooth minimum of their distances (the quadratic one of
Quilez, iquilezles.org/articles/smin). The zero set is polygonised once in a bind pose by surface
nets (Gibson 1998): one vertex in each cell that the surface crosses, which is then moved onto the
surface along the gradient.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

FAR = 1.0  # metres: distance where no cone is near
THIN = 0.85  # cells: no cone is thinner where cells are searched, so that none slips through
PROJECTIONS = 4  # Newton steps onto the surface
# Occlusion: metres above the surface, weight.
OPEN = ((0.015, 0.35), (0.04, 0.3), (0.09, 0.3), (0.18, 0.25))


@dataclass(frozen=True)
class Part:
    """How cones of a part are joined among themselves, and the part to those before it.

    Metres over which they blend.
    """

    inside: float
    outside: float


@dataclass(frozen=True, eq=False)
class Cone:
    """A rounded cone in the bind pose, from its ``start`` to its ``end`` [3], metres."""

    joint: int  # the joint that it follows
    start: np.ndarray
    end: np.ndarray
    radii: tuple[float, float]
    tone: str  # key of `toolkit.view.render.mannequin.COLORS`
    part: str
    thin: np.ndarray | None = None  # direction in which it is pressed flat
    by: float = 1.0  # to this share of its thickness
    foot: str = ""  # "left" or "right" where contacts are shown


class Field:
    """Distance to the joined surface of cones, as a function of points.

    It is exact to first order near the surface. ``order`` are the parts in the order in which they
    are joined.
    """

    def __init__(self, cones: Sequence[Cone], order: dict[str, Part]):
        self.parts = [
            (part, [i for i, cone in enumerate(cones) if cone.part == name])
            for name, part in order.items()
        ]
        self.starts = np.array([cone.start for cone in cones], dtype=np.float64)
        along = np.array([cone.end for cone in cones]) - self.starts
        self.radii = np.array([cone.radii for cone in cones])
        # Of two spheres of which none holds the other.
        least = 1.1 * np.abs(self.radii[:, 0] - self.radii[:, 1])
        self.lengths = np.maximum(np.linalg.norm(along, axis=1), np.maximum(least, 1e-4))
        self.into = np.array(
            [_frame(vector, cone.thin, cone.by) for vector, cone in zip(along, cones, strict=True)]
        )
        ends = self.starts + along
        self.low = np.minimum(self.starts, ends) - self.radii.max(1)[:, None]
        self.high = np.maximum(self.starts, ends) + self.radii.max(1)[:, None]

    def cone(self, i: int, points: np.ndarray, least: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
        """Distance [N] of points [N, 3] to one cone, and its gradient [N, 3].

        Radii are ``least`` at least.
        """
        q = (points - self.starts[i]) @ self.into[i].T
        r0, r1 = np.maximum(self.radii[i], least)
        around = np.hypot(q[:, 0], q[:, 2])
        slope = (r0 - r1) / self.lengths[i]
        y = np.clip(q[:, 1] - around * slope / np.sqrt(1 - slope**2), 0, self.lengths[i])
        q[:, 1] -= y
        length = np.maximum(np.sqrt((q * q).sum(1)), 1e-12)
        gradient = (q / length[:, None]) @ self.into[i]
        steep = np.sqrt((gradient * gradient).sum(1))
        return (length - (r0 - slope * y)) / steep, gradient / steep[:, None]

    def _near(self, i: int, columns: np.ndarray, reach: float) -> np.ndarray:
        """Indices of the points, ``columns`` [3, N], in the box that holds a cone and what is
        within ``reach``.
        """
        inside = True
        for values, low, high in zip(
            columns, self.low[i] - reach, self.high[i] + reach, strict=True
        ):
            inside = inside & (values > low) & (values < high)
        return np.flatnonzero(inside)

    def __call__(self, points: np.ndarray, least: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
        """Distance [N] and gradient [N, 3]."""
        total, columns = (
            (np.full(len(points), FAR), np.zeros((len(points), 3))), np.ascontiguousarray(points.T)
        )
        for part, cones in self.parts:
            own = np.full(len(points), FAR), np.zeros((len(points), 3))
            reach = max(part.inside, part.outside) + 0.03 + least
            for i in cones:
                near = self._near(i, columns, reach)
                _join(own, near, self.cone(i, points[near], least), part.inside)
            near = np.flatnonzero(own[0] < FAR)
            _join(total, near, (own[0][near], own[1][near]), part.outside)
        return total

    def each(self, points: np.ndarray) -> np.ndarray:
        """Distances [N, C] to each of the cones; `FAR` where one is not near."""
        found, columns = (
            np.full((len(points), len(self.radii)), FAR), np.ascontiguousarray(points.T)
        )
        for i in range(len(self.radii)):
            near = self._near(i, columns, 0.12)
            found[near, i] = self.cone(i, points[near])[0]
        return found

    def openness(self, points: np.ndarray, normals: np.ndarray) -> np.ndarray:
        """Ambient light [N], 0 to 1, that other parts of the surface leave to its points."""
        hidden = sum(
            weight * np.clip(1 - self(points + h * normals)[0] / h, 0, 1) for h, weight in OPEN
        )
        return 1 - np.clip(hidden, 0, 1)


def _frame(along: np.ndarray, thin: np.ndarray | None, by: float) -> np.ndarray:
    """Matrix [3, 3] from the world's axes to a cone's own.

    Y along it, z where it is pressed flat, stretched back.
    """
    length = np.linalg.norm(along)
    y = along / length if length > 1e-6 else np.eye(3)[1]
    z = np.eye(3)[np.abs(y).argmin()] if thin is None else np.asarray(thin, dtype=np.float64)
    z = z - y * (y @ z)
    z = z if np.linalg.norm(z) > 1e-3 else np.eye(3)[np.abs(y).argmin()] - y * y[np.abs(y).argmin()]
    z = z / np.linalg.norm(z)
    return np.stack((np.cross(y, z), y, z / by))


def _join(
    into: tuple[np.ndarray, np.ndarray], where: np.ndarray, other: tuple[np.ndarray, np.ndarray],
    blend: float
) -> None:
    """Smooth minimum of distances, and its gradients, at some of the points."""
    (a, ga), (b, gb) = (into[0][where], into[1][where]), other
    share = np.clip(1 - np.abs(a - b) / max(blend, 1e-9), 0, 1)
    first = np.where(a < b, 1 - share / 2, share / 2)[:, None]
    into[0][where] = np.minimum(a, b) - share * share * blend / 4
    into[1][where] = first * ga + (1 - first) * gb


def polygonise(field: Field, cell: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Vertices [V, 3], unit normals [V, 3] and triangles [T, 3] of a field's zero set.

    Edges are about ``cell`` long.
    """
    low = field.low.min(0) - 2.5 * cell
    counts = np.ceil((field.high.max(0) + 2.5 * cell - low) / cell).astype(int)
    axes = [low[i] + cell * np.arange(counts[i]) for i in range(3)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)
    values = field(grid, THIN * cell)[0].reshape(counts)
    inside = values < 0
    corners = [
        tuple(slice(k, n - 1 + k) for k, n in zip(corner, counts, strict=True))
        for corner in np.ndindex(2, 2, 2)
    ]
    number = sum(inside[corner].astype(np.int8) for corner in corners)
    cells = (number > 0) & (number < 8)
    index = np.full(cells.shape, -1)
    index[cells] = np.arange(cells.sum())
    points, triangles = low + cell * (np.argwhere(cells) + 0.5), []
    for axis in range(3):  # an edge of the grid between inside and outside has four cells around it
        ahead = np.moveaxis(inside, axis, 0)
        crossed = np.moveaxis(ahead[1:] != ahead[:-1], 0, axis)
        crossed = crossed[tuple(slice(None) if i == axis else slice(1, -1) for i in range(3))]
        edges = np.argwhere(crossed)
        edges += np.array([int(i != axis) for i in range(3)])
        out = inside[tuple(edges.T)]  # the surface looks along the axis
        u, v = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
        quads = np.stack([index[tuple((edges - step).T)] for step in (u + v, v, 0 * u, u)], 1)
        quads[~out] = quads[~out, ::-1]
        triangles.append(quads)
    quads = np.concatenate(triangles)
    for _ in range(PROJECTIONS):
        points = _relaxed(points, quads)
        for _ in range(2):
            distance, gradient = field(points)
            squared = np.maximum((gradient * gradient).sum(1), 0.05)
            points = points - np.clip(distance / squared, -cell, cell)[:, None] * gradient
    gradient = field(points)[1]
    normals = gradient / np.maximum(np.linalg.norm(gradient, axis=1, keepdims=True), 1e-9)
    a, b, c, d = (points[quads[:, i]] for i in range(4))
    across = (np.linalg.norm(a - c, axis=1) <= np.linalg.norm(b - d, axis=1))[:, None]
    halves = [np.where(across, quads[:, first], quads[:, second])
              for first, second in (([0, 1, 2], [0, 1, 3]), ([0, 2, 3], [1, 2, 3]))]
    return points, normals, np.concatenate(halves)


def _relaxed(points: np.ndarray, quads: np.ndarray) -> np.ndarray:
    """Vertices halfway to the mean of their neighbours."""
    total, count = np.zeros_like(points), np.zeros(len(points))
    for k in range(4):
        for step in (1, 3):
            np.add.at(total, quads[:, k], points[quads[:, (k + step) % 4]])
            np.add.at(count, quads[:, k], 1)
    return 0.5 * points + 0.5 * total / np.maximum(count, 1)[:, None]
