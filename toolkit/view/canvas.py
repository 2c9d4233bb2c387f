"""A small software renderer of smooth surfaces: a depth buffer, soft shadows and shading, no OpenGL.

Parallel projection: camera space is x right, y up, z towards the viewer. Drawing finds the nearest triangle of every pixel;
normals and light are computed once at the end, for the visible pixels.
"""

from collections.abc import Sequence

import numpy as np
from scipy.ndimage import gaussian_filter, uniform_filter, zoom
from scipy.spatial.transform import Rotation

from toolkit.io.compilation import compiled

FAR = -1e9
COARSE = 4  # shadows are soft, so their pixels are this many times larger
SOFT, FADE = 0.03, 0.25  # metres of a shadow's edge; how much weaker it is for each metre of height
KEY, FILL = (v / np.linalg.norm(v) for v in np.float32([[-0.45, 0.75, 0.55], [0.8, 0.15, 0.4]]))  # towards two lamps


def orbit(azimuth: np.ndarray | float, elevation: float) -> np.ndarray:
    """World to camera space [..., 3, 3]: a turn by ``azimuth`` about the vertical, then a tilt by ``elevation``; radians."""
    elevation = elevation if abs(elevation) > 1e-3 else 1e-3  # from exactly the side, the floor would be a line
    turn = Rotation.from_rotvec(np.multiply.outer(azimuth, [0.0, 1.0, 0.0]))
    return (Rotation.from_rotvec([elevation, 0.0, 0.0]) * turn).as_matrix()


class Canvas:
    """An image that bodies are drawn into, with a depth for every pixel.

    It shows a ``window`` (x0, x1, y0, y1) of camera space in metres, with ``scale`` pixels per metre. Shadows and lines on
    the floor need the ``camera`` [3, 3], world to camera space, see `orbit`.
    """

    def __init__(self, window: tuple[float, float, float, float], scale: float, camera: np.ndarray | None = None):
        self.window, self.scale, self.camera = window, scale, np.eye(3) if camera is None else camera
        self.width, self.height = (round((window[i + 1] - window[i]) * scale) for i in (0, 2))
        self.x = (window[0] + (np.arange(self.width) + 0.5) / scale).astype(np.float32)
        self.y = (window[3] - (np.arange(self.height) + 0.5) / scale).astype(np.float32)
        self.depth = np.full((self.height, self.width), FAR, np.float32)
        self.owner = np.zeros((self.height, self.width), np.int32)
        self.shade = np.full((-(-self.height // COARSE), -(-self.width // COARSE)), FAR, np.float32)
        self._drawn, self._triangles = [], 0

    def draw(self, points: np.ndarray, normals: np.ndarray, triangles: np.ndarray, colors: np.ndarray,
             lamp: np.ndarray | None = None, floor: Sequence[float] = (0, 0, 0)) -> None:
        """Draw a surface: vertices and unit normals [V, 3] in camera space, triangles [T, 3], colours [V, 3], 0 to 1.

        Where ``lamp`` [3] points to the light, the surface darkens the floor, which goes through the point ``floor``.
        """
        seen = self._pixels(points, points[:, 2])
        fill(self.depth, self.owner, seen, triangles, self._triangles)
        self._triangles += len(triangles)
        self._drawn.append((seen[:, :2], normals.astype(np.float32), triangles, colors.astype(np.float32)))
        if lamp is not None:
            up = self.camera[:, 1]
            height = ((points - floor) @ up).clip(0)
            fallen = self._pixels(points - height[:, None] / (lamp @ up) * lamp, -height, COARSE)
            fill(self.shade, np.zeros(self.shade.shape, np.int32), fallen, triangles, 0)

    def _pixels(self, points: np.ndarray, depth: np.ndarray, size: int = 1) -> np.ndarray:
        """Column and row of points [V, 3], for pixels that are ``size`` times larger, and their depth [V]."""
        x, y = points[:, 0] - self.window[0], self.window[3] - points[:, 1]
        return np.stack((x * self.scale / size - 0.5, y * self.scale / size - 0.5, depth), 1).astype(np.float32)

    def lines(self, axes: np.ndarray, spacing: Sequence[float], start: Sequence[float], width: float) -> np.ndarray:
        """Share [H, W] of the pixels that lines of ``width`` pixels on the floor cover.

        A line crosses each of the horizontal ``axes`` [A, 3] every ``spacing`` metres; the floor below the origin of camera
        space is ``start`` metres from one.
        """
        covered = np.zeros(1)
        for axis, apart, first in zip(axes, spacing, start, strict=True):
            slope = (self.camera @ axis)[:2] / [1, self.camera[2, 1] ** 2]  # along the axis, per metre of the picture
            along = slope[0] * self.x + slope[1] * self.y[:, None] + first
            pixels = np.abs(along - apart * np.round(along / apart)) * self.scale / np.linalg.norm(slope)
            covered = np.maximum(covered, np.clip(0.5 * width + 0.5 - pixels, 0, 1))
        return covered

    def image(self, floor: np.ndarray, paper: np.ndarray, fine: int = 1) -> np.ndarray:
        """The shaded picture ``[H, W, 3]``, 0 to 1, averaged over squares of ``fine`` pixels.

        ``floor`` [H, W or 1, 3] is the background, ``paper`` [3] the colour of the light that edges reflect.
        """
        picture = np.broadcast_to(floor.astype(np.float32), (self.height, self.width, 3)).copy()
        if (shaded := self.shade > FAR / 2).any():
            soft = SOFT * self.scale / COARSE * np.array([abs(self.camera[2, 1]), 1])  # the camera looks down at the floor
            soft = gaussian_filter(np.where(shaded, np.exp(FADE * self.shade), 0), soft)
            soft = zoom(soft, COARSE, order=1, grid_mode=True, mode="nearest")[: self.height, : self.width, None]
            picture *= 1 - soft * np.array([0.36, 0.34, 0.31], np.float32)
        covered = self.depth > FAR / 2
        if covered.any():
            picture[covered] = self._lit(covered, paper.astype(np.float32))
        h, w = (n // fine * fine for n in picture.shape[:2])
        return sum(picture[i:h:fine, k:w:fine] for i in range(fine) for k in range(fine)) / fine**2

    def _lit(self, covered: np.ndarray, paper: np.ndarray) -> np.ndarray:
        """Colours [N, 3] of the covered pixels [H, W]."""
        rows, columns = (slice(v.min(), v.max() + 1) for v in np.nonzero(covered))
        seen, depth = covered[rows, columns], self.depth[rows, columns]
        blurred = near = np.where(seen, depth, depth[seen].min())
        for _ in range(2):
            blurred = uniform_filter(blurred, 2 * round(0.025 * self.scale) + 1, mode="nearest")
        crease = np.clip((blurred - near)[seen] * 2.2, 0, 0.35)  # unsharp mask of the depth
        n, color = self._normals(covered)
        key, fill = (np.clip(n @ lamp, 0, 1) for lamp in (KEY, FILL))
        light = 0.56 + 0.15 * n[:, 1] + 0.50 * key + 0.10 * fill - crease
        edge = (np.clip(1 - n[:, 2], 0, 1) ** 3 * 0.22)[:, None]
        lit = color * np.clip(light, 0, None)[:, None] * (1 - edge) + 0.55 * edge * paper
        return np.clip(lit + 0.10 * (key**8 * key**16)[:, None], 0, 1)

    def _normals(self, covered: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Normals and colours [N, 3] of the covered pixels."""
        rows, columns = np.nonzero(covered)
        first = np.cumsum([0, *(len(part[0]) for part in self._drawn)])
        triangles = np.concatenate([part[2] + k for part, k in zip(self._drawn, first, strict=False)])
        corners, normals, colors = (np.concatenate([part[i] for part in self._drawn]) for i in (0, 1, 3))
        hit = triangles[self.owner[covered]]
        a, b, c = (corners[hit[:, i]] for i in range(3))
        pixel = np.stack((columns, rows), 1).astype(np.float32)
        whole = _cross(b - a, c - a)
        whole = np.where(np.abs(whole) < 1e-12, 1, whole)
        u, v = _cross(c - b, pixel - b) / whole, _cross(a - c, pixel - c) / whole
        share = np.stack((u, v, 1 - u - v), 1).clip(0, 1)[..., None]
        mixed = (share * normals[hit]).sum(1)
        mixed *= np.where(mixed[:, 2:] < -0.05, -1, 1)  # the back of an open surface
        return mixed / np.maximum(np.linalg.norm(mixed, axis=1, keepdims=True), 1e-9), (share * colors[hit]).sum(1)


def _cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


@compiled(fastmath=False)
def fill(depth, owner, points, triangles, first):
    """Keep for each pixel the nearest depth and the number of its triangle, counted from ``first``.

    ``points`` [V, 3] are x and y in pixels, whose centres are at whole numbers, and z towards the viewer.
    """
    height, width = depth.shape
    for t in range(len(triangles)):
        ax, ay, az = points[triangles[t, 0]]
        bx, by, bz = points[triangles[t, 1]]
        cx, cy, cz = points[triangles[t, 2]]
        whole = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if whole == 0:
            continue
        left, right = max(int(np.ceil(min(ax, bx, cx))), 0), min(int(np.floor(max(ax, bx, cx))), width - 1)
        top, bottom = max(int(np.ceil(min(ay, by, cy))), 0), min(int(np.floor(max(ay, by, cy))), height - 1)
        for row in range(top, bottom + 1):
            for column in range(left, right + 1):
                u = ((cx - bx) * (row - by) - (cy - by) * (column - bx)) / whole
                v = ((ax - cx) * (row - cy) - (ay - cy) * (column - cx)) / whole
                if u >= -1e-6 and v >= -1e-6 and u + v <= 1.000001:
                    z = u * az + v * bz + (1 - u - v) * cz
                    if z > depth[row, column]:
                        depth[row, column], owner[row, column] = z, first + t
