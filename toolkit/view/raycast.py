"""A small software renderer for rounded cones: exact silhouettes and shading with numpy alone, no OpenGL.

Parallel projection: camera space is x right, y up, z towards the viewer. Each shape is intersected in its own frame, where
it is two spheres and the cone that touches both. Drawing finds depths only; normals and light are computed once at the end,
for the visible pixels.
"""

import math
from collections.abc import Sequence

import numpy as np
from scipy.ndimage import uniform_filter, zoom
from scipy.spatial.transform import Rotation

from toolkit.view.body import Shape

FAR = -1e9
COARSE = 4  # shadows are soft, so their pixels are this many times larger
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
        self.shade = np.zeros((-(-self.height // COARSE), -(-self.width // COARSE)), np.float32)
        self._drawn = []

    def _span(self, low: np.ndarray, high: np.ndarray, step: int = 1) -> tuple[slice, slice]:
        """Rows and columns, ``step`` pixels each, that hold camera space from ``low`` to ``high`` [2]."""
        scale, (height, width) = self.scale / step, (-(-self.height // step), -(-self.width // step))
        c0, c1 = (int(np.clip((v - self.window[0]) * scale, 0, width)) for v in (low[0], high[0]))
        r0, r1 = (int(np.clip((self.window[3] - v) * scale, 0, height)) for v in (high[1], low[1]))
        return slice(r0, r1 + 1), slice(c0, c1 + 1)

    def draw(self, shapes: Sequence[Shape], places: np.ndarray, colors: np.ndarray) -> None:
        """Draw shapes at ``places`` [S, 3, 4] (own frame to camera space) in ``colors`` [S, 3], 0 to 1."""
        places = np.asarray(places, dtype=np.float64)
        backs = np.linalg.inv(places[:, :, :3])
        for shape, place, back, color in zip(shapes, places, backs, colors, strict=True):
            r, ends = np.array(shape.radii)[:, None], place[:2, 3] + np.array([[0.0], [shape.length]]) * place[:2, 1]
            rows, columns = self._span((ends - r).min(0), (ends + r).max(0))
            depth = _depth(shape, place[:, 3], back, self.x[columns], self.y[rows, None])
            nearer = depth > self.depth[rows, columns]
            self.depth[rows, columns][nearer] = depth[nearer]
            self.owner[rows, columns][nearer] = len(self._drawn)
            self._drawn.append((back, place[:, 3], (*shape.radii, shape.length), color))

    def shadow(self, shapes: Sequence[Shape], places: np.ndarray, lamp: np.ndarray,
               floor: Sequence[float] = (0, 0, 0)) -> None:
        """Darken the floor, which goes through the point ``floor``, below shapes; ``lamp`` points to the light.

        A shape's shadow is the hull of its two spheres' shadows, softer the higher they are.
        """
        up = self.camera[:, 1]
        length, radii = np.array([s.length for s in shapes]), np.array([s.radii for s in shapes])
        ends = np.stack((places[:, :, 3], places[:, :, 3] + places[:, :, 1] * length[:, None]), 1)  # [S, 2, 3]
        height = ((ends - floor) @ up).clip(0)
        ends = (ends - height[..., None] / (lamp @ up) * lamp)[..., :2]
        reach = (1.5 * radii + 0.1 * height)[..., None]
        rows, columns = self._span((ends - reach).min((0, 1)), (ends + reach).max((0, 1)), COARSE)
        x, y = (np.float32(COARSE / self.scale) * (np.arange(n) + 0.5) for n in self.shade.shape[::-1])
        stretch = np.array([1, 1 / up[2]])  # the camera looks down at the floor
        x, y = x[columns] + self.window[0], (self.window[3] - y[rows, None]) * stretch[1]

        def each(values: np.ndarray) -> np.ndarray:
            return values.astype(np.float32)[:, None, None]

        first, along = (ends[:, 0] * stretch), (ends[:, 1] - ends[:, 0]) * stretch
        dx, dy = x.astype(np.float32) - each(first[:, 0]), y.astype(np.float32) - each(first[:, 1])
        ax, ay = (each(a) for a in along.T)
        share = ((dx * ax + dy * ay) / np.maximum(ax * ax + ay * ay, 1e-9)).clip(0, 1)
        distance = np.hypot(dx - share * ax, dy - share * ay)
        radius, above = (each(a[:, 0]) + share * each(a[:, 1] - a[:, 0]) for a in (radii, height))
        cover = (0.5 - (distance - radius) / (0.024 + 0.2 * above)).clip(0, 1)
        self.shade[rows, columns] = 1 - (1 - self.shade[rows, columns]) * np.prod(1 - cover * cover * (3 - 2 * cover), 0)

    def lines(self, axes: np.ndarray, spacing: Sequence[float], start: Sequence[float], width: float) -> np.ndarray:
        """Share [H, W] of the pixels that lines of ``width`` pixels on the floor cover.

        A line crosses each of the horizontal ``axes`` [A, 3] every ``spacing`` metres; the floor below the origin of camera
        space is ``start`` metres from one.
        """
        covered = 0.0
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
        shaded = np.flatnonzero(self.shade.any(1))
        if len(shaded):
            start = max(shaded[0] - 1, 0)
            soft = zoom(self.shade[start : shaded[-1] + 2], COARSE, order=1, grid_mode=True, mode="nearest")
            rows = picture[start * COARSE :][: len(soft)]
            rows *= 1 - soft[: len(rows), : self.width, None] * np.array([0.36, 0.34, 0.31], np.float32)
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
        owner = self.owner[covered]
        back, centre, ends, colors = (np.array(values, np.float32) for values in zip(*self._drawn, strict=True))
        points = np.stack((self.x[columns], self.y[rows], self.depth[covered]), 1) - centre[owner]
        first, second, length = ends.T
        sine = (first - second) / length
        points = np.einsum("nij,nj->ni", back[owner], points)
        y = points[:, 1]
        second_ball = y > (length + second * sine)[owner]
        flank = (y > (first * sine)[owner]) & ~second_ball
        points[second_ball, 1] -= length[owner[second_ball]]
        radial = np.linalg.norm(points[flank][:, ::2], axis=1)
        points[flank, 1] = radial * (sine / np.sqrt(1 - sine**2))[owner[flank]]
        normals = np.einsum("ni,nij->nj", points, back[owner])  # by the inverse transpose
        return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9), colors[owner]


def _depth(shape: Shape, centre: np.ndarray, back: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Largest z ``[H, W]`` of a shape at camera x ``[W]`` and y ``[H, 1]``; NaN outside its silhouette.

    ``back`` [3, 3] transforms camera space, relative to ``centre``, to the cone's frame. There a line of sight is o + s·d
    with a unit vector d and o orthogonal to it. On the cone, radial distance · cos + y · sin = first radius, where the sine
    is the difference of the radii over the distance of the centres.
    """
    (first, second), length = shape.radii, shape.length
    speed = np.linalg.norm(back[:, 2])
    d = back[:, 2] / speed
    slope = d @ back[:, :2]
    across = back[:, :2] - np.outer(d, slope)
    x, y = x - np.float32(centre[0]), y - np.float32(centre[1])
    (xx, xy), (_, yy) = (across.T @ across).astype(np.float32)
    oy = np.float32(across[1, 0]) * x + np.float32(across[1, 1]) * y
    squared = xx * (x * x) + (yy * y + np.float32(2 * xy) * x) * y
    dy = float(d[1])
    with np.errstate(invalid="ignore"):
        s = np.sqrt(first**2 - squared)
        s = np.fmax(s, length * dy + np.sqrt(second**2 - length**2 * (1 - dy * dy) - squared + (2 * length) * oy))
        sine = (first - second) / length
        cosine = math.sqrt(1 - sine**2)
        steep = dy * sine / cosine
        width = (first / cosine) - (sine / cosine) * oy  # the cone's radius at o; it shrinks by steep · s
        a = 1 - dy**2 - steep**2
        if abs(a) > 1e-9:
            b = steep * width - dy * oy
            flank = (np.sqrt(b * b - a * (squared - oy * oy - width * width)) - b) / a
            at = oy + dy * flank
            s = np.fmax(s, np.where((at > first * sine) & (at < length + second * sine), flank, np.nan))
    return np.float32(centre[2]) + (s - np.float32(slope[0]) * x - np.float32(slope[1]) * y) * np.float32(1 / speed)
