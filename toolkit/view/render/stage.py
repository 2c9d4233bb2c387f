"""Bodies on a floor before a camera, drawn by pyvista, or by Pillow where there is no OpenGL.

pyvista must be used from the main thread only.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from toolkit.view.render.bodies import BACK, SHADE, Body, Camera, Lines, Pose, axes
from toolkit.view.render.opengl import explain_missing_opengl, opengl_works

# Linear light: the browser's sun of 1.5 and hemisphere of 2.25 over π, in their colours
# (scene/scene.js).
SUN, SKY, GROUND = np.float32([[0.477, 0.467, 0.445], [0.716] * 3, [0.493, 0.468, 0.427]])
FINE = 2  # pictures are drawn so much larger, and averaged
LOW = 0.003  # metres of the shadow above the floor
FAR = 50.0  # metres from the camera to its target


def lit(normals: np.ndarray, tones: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Colours [V, 3] uint8 of matt vertices with ``tones`` [V, 3], lit by sky, floor and a lamp."""
    up = 0.5 + 0.5 * normals[:, 1:2]
    lamp = np.clip(normals @ (light / np.linalg.norm(light)), 0, None)[:, None]
    linear = (tones**2.2).astype(np.float32) * (GROUND + up * (SKY - GROUND) + lamp * SUN)
    return (255 * np.clip(linear, 0, 1) ** np.float32(1 / 2.2)).astype(np.uint8)


@dataclass(eq=False)
class Stage:
    """Pictures of some bodies, drawn by Pillow, the far triangles first.

    Light is computed per vertex; a shadow is the body pressed flat along the light.
    """

    bodies: Sequence[Body]
    size: tuple[int, int]  # pixels, width and height
    light: np.ndarray  # [3] towards the lamp
    lines: Lines | None = None

    def __post_init__(self):
        counts = [len(body.skin.points) for body in self.bodies]
        first = np.cumsum([0, *counts])  # vertex of each body, and the number of all
        self.count = first[-1]
        self.triangles = np.concatenate([body.skin.triangles + k
                                         for body, k in zip(self.bodies, first, strict=False)])

    def draw(self, poses: Sequence[Pose], camera: Camera) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a pose of each body."""
        meshes = [pose.mesh() for pose in poses]
        points, normals = (np.concatenate(parts) for parts in zip(*meshes, strict=True))
        tones = np.concatenate([pose.body.colors(pose.frame) for pose in poses])
        flat = points - points[:, 1:2] * (self.light / self.light[1])
        flat[:, 1] = LOW
        return self._picture(points, lit(normals, tones, self.light), flat, camera)

    def _picture(self, points: np.ndarray, colors: np.ndarray, flat: np.ndarray,
                 camera: Camera) -> np.ndarray:
        """The picture of vertices, their colours, and vertices of the shadows, [V, 3] each."""
        width, height = (FINE * n for n in self.size)
        turn, scale = axes(camera.azimuth, camera.tilt), height / camera.height

        def seen(places: np.ndarray) -> np.ndarray:
            """Pixels to the right and downwards, and towards the viewer [..., 3]."""
            return (places - camera.target) @ turn.T * [scale, -scale, 1] + [
                width / 2, height / 2, 0]

        picture = Image.new("RGB", (width, height), BACK)
        draw = ImageDraw.Draw(picture)
        if self.lines is not None:
            pieces = self.lines.segments()
            ends = seen(pieces + self.lines.crossing(camera.target))[..., :2]
            tones = (255 * self.lines.colors(pieces.mean(1))).astype(int)
            for line, tone in zip(ends.reshape(-1, 4).tolist(), tones.tolist(), strict=True):
                draw.line(line, tuple(tone), FINE)
        shadow, corners = seen(flat)[self.triangles], seen(points)[self.triangles]
        order = np.argsort(corners[..., 2].mean(1))
        shapes = np.concatenate((shadow, corners[order]))[..., :2].reshape(-1, 6)
        tones = colors[self.triangles].mean(1)[order].astype(int)
        faces = [SHADE] * len(shadow) + [tuple(tone) for tone in tones.tolist()]
        for shape, face in zip(shapes.tolist(), faces, strict=True):
            draw.polygon(shape, face)
        return np.asarray(picture.reduce(FINE))

    def close(self) -> None:
        """Free what was used."""


class Rendered(Stage):
    """Pictures drawn by pyvista, off screen."""

    def __post_init__(self):
        import pyvista as pv

        super().__post_init__()
        large = [FINE * n for n in self.size]
        self.plotter = pv.Plotter(off_screen=True, window_size=large, lighting="none")
        self.plotter.disable_anti_aliasing()  # the picture is averaged
        self.plotter.set_background(BACK)
        empty = np.zeros((self.count, 3), np.float32)
        self.surface, self.shadow = (
            pv.PolyData.from_regular_faces(empty, self.triangles) for _ in range(2))
        self.surface.point_data["rgb"] = empty.astype(np.uint8)
        self._add(self.surface)
        self.plotter.add_mesh(self.shadow, color=SHADE, lighting=False)
        self.grid = None
        if self.lines is not None:
            ends = self.lines.segments()
            grid = pv.line_segments_from_points(np.float32(ends.reshape(-1, 3)))
            colors = 255 * self.lines.colors(ends).reshape(-1, 3)
            grid.point_data["rgb"] = colors.astype(np.uint8)
            self.grid = self._add(grid, line_width=FINE)

    def _add(self, mesh, **options):
        return self.plotter.add_mesh(mesh, scalars="rgb", rgb=True, lighting=False, **options)

    def _picture(self, points: np.ndarray, colors: np.ndarray, flat: np.ndarray,
                 camera: Camera) -> np.ndarray:
        self.surface.points, self.shadow.points = np.float32(points), np.float32(flat)
        self.surface.point_data["rgb"] = colors
        _, up, back = axes(camera.azimuth, camera.tilt)
        # VTK's own methods: pyvista's examine the whole scene each time
        lens = self.plotter.camera
        lens.SetPosition(camera.target + FAR * back)
        lens.SetFocalPoint(camera.target)
        lens.SetViewUp(up)
        lens.SetParallelProjection(True)
        lens.SetParallelScale(camera.height / 2)
        lens.SetClippingRange(0.2, 2 * FAR)
        if self.grid is not None:
            self.grid.SetPosition(self.lines.crossing(camera.target))
        self.plotter.render()
        picture = self.plotter.screenshot(return_img=True)
        return np.asarray(Image.fromarray(picture).reduce(FINE))

    def close(self) -> None:
        """Free the window."""
        self.plotter.close()


def open_stage(bodies: Sequence[Body], size: tuple[int, int], light: np.ndarray,
               lines: Lines | None = None) -> Stage:
    """The `Stage` that works here."""
    if opengl_works():
        return Rendered(bodies, size, light, lines)
    explain_missing_opengl()
    return Stage(bodies, size, light, lines)
