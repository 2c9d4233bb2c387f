"""A small software renderer for rounded cones: exact silhouettes and shading with numpy alone, no OpenGL.

Parallel projection: camera space is x right, y up, z towards the viewer. Each shape is intersected in its own frame, where
it is a plain rounded cone (closed form after Inigo Quilez), so thinning costs nothing.
"""

import numpy as np
from scipy.ndimage import gaussian_filter, zoom

from toolkit.view.body import Shape

FAR = -1e9
COARSE = 4  # shadows are blurred, so their pixels are this many times larger


def _hits(shape: Shape, origins: np.ndarray, direction: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Distance [N] along unit ``direction`` [3] from ``origins`` [N, 3] (inf: a miss) and normals [N, 3], cone's frame."""
    (ra, rb), h = shape.radii, shape.length
    t, normals = np.full(len(origins), np.inf, np.float32), np.zeros_like(origins)
    rr, m0, m2 = ra - rb, h * h, h * direction[1]
    d2 = m0 - rr * rr
    k2 = d2 - m2 * m2
    m1, m3, m5 = h * origins[:, 1], origins @ direction, np.einsum("ni,ni->n", origins, origins)
    k1 = d2 * m3 - m1 * m2 + m2 * rr * ra
    k0 = d2 * m5 - m1 * m1 + m1 * rr * ra * 2 - m0 * ra * ra
    side = k1 * k1 - k0 * k2
    some = np.flatnonzero(side >= 0) if abs(k2) > 1e-9 else np.arange(len(origins))  # every hit meets the endless cone
    o, m1 = origins[some], m1[some]
    near, out = np.full(len(some), np.inf, np.float32), np.zeros_like(o)
    on_side = np.zeros(len(some), bool)
    if abs(k2) > 1e-9:
        reach = (-np.sqrt(side[some]) - k1[some]) / k2
        y = m1 - ra * rr + reach * m2
        on_side = (y > 0) & (y < d2)
        near[on_side] = reach[on_side]
        out[on_side] = (d2 * (o + reach[:, None] * direction) - y[:, None] * np.array([0, h, 0], np.float32))[on_side]
    for centre, r in ((0.0, ra), (h, rb)):  # the two spheres
        c = o - np.array([0, centre, 0], np.float32)
        b = c @ direction
        inside = b * b - np.einsum("ni,ni->n", c, c) + r * r
        reach = -b - np.sqrt(np.maximum(inside, 0))
        on_cap = (inside > 0) & ~on_side & (reach < near)
        near[on_cap] = reach[on_cap]
        out[on_cap] = (c + reach[:, None] * direction)[on_cap]
    t[some], normals[some] = near, out
    return t, normals


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
