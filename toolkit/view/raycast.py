"""A small software renderer for rounded cones: exact silhouettes and shading with numpy alone, no OpenGL.

Parallel projection: camera space is x right, y up, z towards the viewer. Each shape is intersected in its own frame, where
it is a plain rounded cone (two spheres and the cone that touches both), so thinning costs nothing.
"""

import numpy as np
from scipy.ndimage import gaussian_filter, zoom

from toolkit.view.body import Shape

FAR = -1e9
COARSE = 4  # shadows are blurred, so their pixels are this many times larger


def _hits(shape: Shape, origins: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Distance [N] along unit ``direction`` [3] from ``origins`` [N, 3] (inf: a miss) and normals [N, 3], cone's frame.

    The surface is two spheres on the y axis and the cone that touches both: where its normal leans by an angle whose sine is
    the difference of the radii over the distance of the centres, radial distance · cos + y · sin = first radius.
    """
    (first, second), length = shape.radii, shape.length
    distance, normals = np.full(len(origins), np.inf, np.float32), np.zeros_like(origins)
    along, squared = origins @ direction, np.einsum("ni,ni->n", origins, origins)
    for centre, radius in ((0.0, first), (length, second)):
        half = along - centre * direction[1]
        inside = half**2 - (squared - 2 * centre * origins[:, 1] + centre**2) + radius**2
        t = np.where(inside >= 0, -half - np.sqrt(np.maximum(inside, 0)), np.inf)
        closer = t < distance
        distance[closer] = t[closer]
        normals[closer] = (origins[closer] + t[closer, None] * direction - np.float32([0, centre, 0])) / np.float32(radius)
    sine = (first - second) / length if length > abs(first - second) else 1.0
    cosine = np.sqrt(1 - sine**2)
    if cosine > 1e-6:  # otherwise one sphere holds the other
        flat = np.array([1.0, 0.0, 1.0], np.float32)
        steep = direction[1] * sine / cosine
        width = (first - origins[:, 1] * sine) / cosine  # the cone's radius at the origin's height; it shrinks by steep · t
        a = 1 - direction[1] ** 2 - steep**2
        b = along - origins[:, 1] * direction[1] + width * steep
        root = b**2 - a * (squared - origins[:, 1] ** 2 - width**2)
        some = np.flatnonzero(root >= 0) if abs(a) > 1e-9 else np.arange(0)
        for sign in (-1.0, 1.0):
            t = (sign * np.sqrt(root[some]) - b[some]) / a
            point = origins[some] + t[:, None] * direction
            between = (point[:, 1] > first * sine) & (point[:, 1] < length + second * sine)
            hit = between & (width[some] - steep * t > 0) & (t < distance[some])
            where = some[hit]
            distance[where] = t[hit]
            radial = point[hit] * flat
            normals[where] = radial * (cosine / np.linalg.norm(radial, axis=1, keepdims=True)) + np.float32([0, sine, 0])
    return distance, normals


class Canvas:
    """An image that shapes are drawn into, with a depth for every pixel.

    Parameters
    ----------
    window
        (x0, x1, y0, y1) of camera space, metres.
    scale
        Pixels per metre.
    """

    def __init__(self, window: tuple[float, float, float, float], scale: float):
        self.window, self.scale = window, scale
        self.width, self.height = (round((window[i + 1] - window[i]) * scale) for i in (0, 2))
        self.depth = np.full((self.height, self.width), FAR, np.float32)
        self.normal = np.zeros((self.height, self.width, 3), np.float32)
        self.color = np.zeros((self.height, self.width, 3), np.float32)
        self.shade = np.zeros((-(-self.height // COARSE), -(-self.width // COARSE)), np.float32)

    def _pixels(self, x: tuple[float, float], y: tuple[float, float], step: int = 1) -> tuple[slice, slice, np.ndarray]:
        height, width = -(-self.height // step), -(-self.width // step)
        scale = self.scale / step
        c0, c1 = (int(np.clip((v - self.window[0]) * scale, 0, width)) for v in x)
        r0, r1 = (int(np.clip((self.window[3] - v) * scale, 0, height)) for v in (y[1], y[0]))
        rows, columns = slice(r0, r1 + 1), slice(c0, c1 + 1)
        px = self.window[0] + (np.arange(width)[columns] + 0.5) / scale
        py = self.window[3] - (np.arange(height)[rows] + 0.5) / scale
        grid = np.stack((*np.meshgrid(px, py), np.full((len(py), len(px)), 10.0)), -1)
        return rows, columns, grid.astype(np.float32)

    def draw(self, shape: Shape, place: np.ndarray, color: np.ndarray) -> None:
        """Draw a shape at ``place`` [3, 4] (its own frame to camera space) in ``color`` [3], 0 to 1."""
        ends = place[:, 3], place[:, 3] + place[:, 1] * shape.length
        low = np.minimum(*(e - r for e, r in zip(ends, shape.radii, strict=True)))
        high = np.maximum(*(e + r for e, r in zip(ends, shape.radii, strict=True)))
        rows, columns, grid = self._pixels((low[0], high[0]), (low[1], high[1]))
        if not grid.size:
            return
        back = np.linalg.inv(place[:, :3]).astype(np.float32)
        direction = -back[:, 2]
        speed = np.linalg.norm(direction)
        origins = (grid.reshape(-1, 3) - place[:, 3].astype(np.float32)) @ back.T
        t, normals = _hits(shape, origins, direction / speed)
        depth = (10.0 - t / speed).reshape(grid.shape[:2]).astype(np.float32)
        nearer = depth > self.depth[rows, columns]
        normals = normals @ back  # a normal goes with the inverse transpose
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
        self.depth[rows, columns][nearer] = depth[nearer]
        self.normal[rows, columns][nearer] = normals.reshape(grid.shape)[nearer]
        self.color[rows, columns][nearer] = color

    def shadow(self, shape: Shape, place: np.ndarray, up: np.ndarray, floor: np.ndarray, light: np.ndarray) -> None:
        """Darken the floor (through ``floor``, normal ``up``) where ``light`` [3], towards the lamp, is covered."""
        ends = np.stack((place[:, 3], place[:, 3] + place[:, 1] * shape.length))
        drop = ends - np.outer((ends - floor) @ up / (light @ up), light)  # the spheres' centres seen from the lamp
        r = 1.6 * max(shape.radii)
        rows, columns, grid = self._pixels((drop[:, 0].min() - r, drop[:, 0].max() + r),
                                           (drop[:, 1].min() - r, drop[:, 1].max() + r), COARSE)  # fmt: skip
        if not grid.size:
            return
        points = grid.reshape(-1, 3)
        points[:, 2] = floor[2] - ((points[:, :2] - floor[:2]) @ up[:2]) / up[2]
        back = np.linalg.inv(place[:, :3])
        direction = (back @ light).astype(np.float32)
        origins = (points - place[:, 3]) @ back.T
        t, _ = _hits(shape, origins.astype(np.float32), direction / np.linalg.norm(direction))
        self.shade[rows, columns][np.isfinite(t).reshape(grid.shape[:2])] = 1.0

    def image(self, floor: np.ndarray, paper: np.ndarray) -> np.ndarray:
        """The shaded picture ``[H, W, 3]``, 0 to 1: ``floor`` [H, 3] (a colour for every row of pixels) behind."""
        s = self.scale
        covered = self.depth > FAR / 2
        soft = gaussian_filter(self.shade, 0.025 * s / COARSE)
        soft = zoom(soft, COARSE, order=1)[: self.height, : self.width, None]
        picture = floor[:, None].astype(np.float32) * (1 - soft * np.array([0.36, 0.34, 0.31], np.float32))
        if not covered.any():
            return picture
        near = np.where(covered, self.depth, self.depth[covered].min())
        crease = np.clip((gaussian_filter(near, 0.03 * s) - near)[covered] * 2.2, 0, 0.35)  # unsharp mask of the depth
        n = self.normal[covered]
        key = np.clip(n @ _unit(-0.45, 0.75, 0.55), 0, 1)
        fill = np.clip(n @ _unit(0.8, 0.15, 0.4), 0, 1)
        light = 0.56 + 0.15 * n[:, 1] + 0.50 * key + 0.10 * fill - crease
        edge = (np.clip(1 - n[:, 2], 0, 1) ** 3 * 0.22)[:, None]
        lit = self.color[covered] * np.clip(light, 0, None)[:, None] * (1 - edge) + 0.55 * edge * paper.astype(np.float32)
        picture[covered] = np.clip(lit + 0.10 * key[:, None] ** 24, 0, 1)
        return picture


def _unit(*v: float) -> np.ndarray:
    v = np.array(v, np.float32)
    return v / np.linalg.norm(v)
