"""Renderers of clips frame by frame: pyvista off screen where OpenGL works, the software renderer where it does not.

VTK must only be used from the main thread; `toolkit.view.player` takes care of that.
"""

import numpy as np
import torch
from matplotlib.colors import to_rgb
from PIL import Image, ImageDraw

from toolkit.motion import Clip
from toolkit.motion import rotations as R
from toolkit.view import body, floor
from toolkit.view.canvas import Canvas, orbit
from toolkit.view.character import Character
from toolkit.view.opengl import explain_missing_opengl, opengl_works
from toolkit.view.picture import steady_frames

BACK, SHADE, LINES = "#efece6", "#cdc8be", "#cbc5b9"
LIGHT = torch.tensor([-0.08, 1.0, 0.51])  # towards the lamp, facing +Z
# linear light: the browser's sun of 1.5 and hemisphere of 2.25 over π, in their colours (scene/scene.js)
SUN, SKY, GROUND = np.float32([[0.477, 0.467, 0.445], [0.716, 0.716, 0.716], [0.493, 0.468, 0.427]])
TILT = 0.2  # the camera looks down, radians


def best(size: tuple[int, int], clip: Clip, contacts: np.ndarray | None = None,
         figure: Character | None = None) -> "PyvistaRenderer | SoftwareRenderer":
    """The best renderer that works here, of a clip."""
    if opengl_works():
        return PyvistaRenderer(size, clip, contacts, figure)
    explain_missing_opengl()
    return SoftwareRenderer(size, clip, contacts, figure)


class Scene:
    """A clip and the camera, for any renderer.

    ``contacts`` [F, 2] are of the right and the left foot. A ``figure``, on whose rig the clip is, is drawn in place of the
    mannequin.
    """

    def __init__(self, size: tuple[int, int], clip: Clip, contacts: np.ndarray | None = None,
                 figure: Character | None = None):
        self.size = size
        self.angle, self.distance = -50.0, 3.8  # the camera's: degrees from where the body faces at first, metres
        self.follow = True  # whether the camera follows the body
        self.shown = {"path", "contacts"}  # kinds of layers on the floor; contacts also colour the standing feet
        self.load(clip, contacts, figure)

    def load(self, clip: Clip, contacts: np.ndarray | None = None, figure: Character | None = None) -> None:
        """Show another clip."""
        self.clip, self.contacts, self.figure = clip, contacts, figure
        self.body = body.build(clip) if figure is None else None
        self.skin = figure.skin if self.body is None else self.body.skin
        self.path, facing = steady_frames(clip, 0.8)
        self.facing = float(facing[0])
        self.light = R.rotate(R.yaw(torch.tensor(self.facing)), LIGHT).numpy()  # towards the lamp
        self.height = 0.54 * float(clip.global_positions[0, :, 1].max())
        self.layers = sorted(floor.layers(clip, contacts), key=lambda layer: layer.height)

    def mesh(self, frame: int) -> tuple[np.ndarray, np.ndarray]:
        """Vertices and normals [V, 3]."""
        return self.skin.pose(self.clip.global_rotations[frame], self.clip.global_positions[frame])

    def lit(self, normals: np.ndarray, tones: np.ndarray) -> np.ndarray:
        """Colour [V, 3] uint8 of vertices with ``tones`` [V, 3]: matt, lit by sky, floor and one lamp, as in a page."""
        up = 0.5 + 0.5 * normals[:, 1:2]
        lamp = np.clip(normals @ (self.light / np.linalg.norm(self.light)), 0, None)[:, None]
        linear = (tones**2.2).astype(np.float32) * (GROUND + up * (SKY - GROUND) + lamp * SUN)
        return (255 * np.clip(linear, 0, 1) ** np.float32(1 / 2.2)).astype(np.uint8)

    def colors(self, frame: int) -> np.ndarray:
        """Colours [V, 3] of the vertices: standing feet have their own."""
        if self.body is None:
            return self.figure.mesh.colors / 255
        on = self.contacts is not None and "contacts" in self.shown
        return self.body.colors(self.contacts[frame] > 0.5 if on else None)

    def marks(self, frame: int) -> list[np.ndarray]:
        """Corners [V, 2] of the layers on the floor, the lower ones first; those of a hidden layer are one point."""
        return [layer.corners(frame) * (layer.kind in self.shown) for layer in self.layers]

    def look(self, frame: int) -> tuple[np.ndarray, float]:
        """The point on the floor that the camera looks at, and its azimuth."""
        return self.path[frame if self.follow else len(self.path) // 2], self.facing + np.radians(self.angle)

    def close(self) -> None:
        """Free the window, where there is one."""


class PyvistaRenderer(Scene):
    """pyvista without multi-sampling and lights, its slowest parts: light is per vertex, the shadow a flat body."""

    def __init__(self, size: tuple[int, int], *shown):
        import pyvista as pv
        from vtkmodules.util.numpy_support import numpy_to_vtk

        self.pv, self._to_vtk = pv, numpy_to_vtk
        theme = pv.themes.Theme()
        theme.multi_samples = 0
        self.plotter = pv.Plotter(off_screen=True, window_size=size, lighting="none", theme=theme)
        self.plotter.set_background(BACK)
        self.plotter.camera.SetViewUp(0, 1, 0)
        self.plotter.camera.SetViewAngle(32)
        self.grid = self._add(self._grid(), "grid", line_width=1)
        super().__init__(size, *shown)

    def _add(self, mesh, name: str, **options):
        """Add a mesh with a colour per point, in the place of an older one of that name."""
        return self.plotter.add_mesh(mesh, name=name, scalars="rgb", rgb=True, lighting=False, render=False, **options)

    def load(self, clip: Clip, contacts: np.ndarray | None = None, figure: Character | None = None) -> None:
        """Show another clip."""
        super().load(clip, contacts, figure)
        mesh = self.pv.PolyData.from_regular_faces
        self.surface, self.flat = (mesh(np.zeros_like(self.skin.points), self.skin.triangles) for _ in range(2))
        self.surface.point_data["rgb"] = np.zeros((self.surface.n_points, 3), np.uint8)
        marks = self.marks(0)
        counts = [len(corners) for corners in marks]
        first = np.cumsum([0, *counts[:-1]])
        places = [np.insert(flat, 1, layer.height, axis=1) for layer, flat in zip(self.layers, marks, strict=True)]
        self.floor = mesh(
            np.concatenate(places).astype(np.float32),
            np.concatenate([layer.triangles + k for layer, k in zip(self.layers, first, strict=True)]))
        tones = np.repeat([255 * np.array(to_rgb(layer.color)) for layer in self.layers], counts, axis=0)
        self.floor.point_data["rgb"] = tones.astype(np.uint8)
        self._add(self.surface, "body", culling=False if self.body is None else "back")
        self.plotter.add_mesh(self.flat, name="shadow", color=SHADE, lighting=False, render=False)
        self._add(self.floor, "floor")

    def _grid(self, reach: int = 14):
        """Lines a metre apart, fading into the background."""
        steps = np.arange(-reach, reach + 1.0, dtype=np.float32)
        x, z = (v.ravel() for v in np.meshgrid(steps, steps[:-1], indexing="ij"))
        points = np.stack((x, 0 * x, z, x, 0 * x, z + 1, z, 0 * x, x, z + 1, 0 * x, x), 1).reshape(-1, 3)
        lines = np.insert(np.arange(len(points)).reshape(-1, 2), 0, 2, axis=1)
        grid = self.pv.PolyData(points, lines=lines.ravel())
        fade = np.clip(np.linalg.norm(points, axis=1) / reach, 0, 1)[:, None] ** 0.7
        grid.point_data["rgb"] = (255 * (to_rgb(LINES) * (1 - fade) + to_rgb(BACK) * fade)).astype(np.uint8)
        return grid

    def draw(self, frame: int, *, fine: bool = False) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a frame; ``fine`` with smooth edges, in three times the time."""
        points, normals = self.mesh(frame)
        self.surface.points[:] = points
        self.surface.point_data["rgb"][:] = self.lit(normals, self.colors(frame))
        self.flat.points[:] = points - points[:, 1:2] * (self.light / self.light[1])
        self.flat.points[:, 1] = 0.003
        self.floor.points[:, [0, 2]] = np.concatenate(self.marks(frame))
        for mesh in (self.surface, self.flat, self.floor):
            mesh.Modified()
            mesh.GetPoints().Modified()
        self.surface.GetPointData().GetScalars().Modified()
        centre, a = self.look(frame)
        target = centre + np.array([0, self.height, 0])
        camera = self.plotter.camera  # VTK's own methods: pyvista's examine the whole scene each time
        camera.SetPosition(target + self.distance * np.array([np.sin(a), TILT, np.cos(a)]))
        camera.SetFocalPoint(target)
        camera.SetClippingRange(0.2, 60)
        self.grid.SetPosition(np.round(centre))
        return self._read(2 if fine else 1)

    def _read(self, scale: int) -> np.ndarray:
        """The camera's picture, drawn ``scale`` times larger and averaged."""
        width, height = (scale * n for n in self.size)
        window, picture = self.plotter.render_window, np.empty((height, width, 3), np.uint8)
        window.SetSize(width, height)
        self.grid.prop.line_width = scale
        window.Render()
        window.GetPixelData(0, 0, width - 1, height - 1, 0, self._to_vtk(picture.reshape(-1, 3)), 0)  # the same memory
        return picture[::-1] if scale == 1 else np.asarray(Image.fromarray(picture[::-1]).reduce(scale))

    def close(self) -> None:
        """Free the window."""
        self.plotter.close()


class SoftwareRenderer(Scene):
    """The software renderer: slower, needs no OpenGL."""

    def draw(self, frame: int, *, fine: bool = False) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a frame; its edges are never smooth."""
        width, height = self.size
        centre, a = self.look(frame)
        camera, metres, middle = orbit(-a, TILT), 0.57 * self.distance, self.height * np.cos(TILT)  # as high as with pyvista
        window = (-metres * width / height / 2, metres * width / height / 2, middle - metres / 2, middle + metres / 2)
        canvas = Canvas(window, height / metres, camera)
        points, normals = self.mesh(frame)
        canvas.draw((points - centre) @ camera.T, normals @ camera.T, self.skin.triangles, self.colors(frame),
                    camera @ self.light)
        ground = Image.new("RGB", (canvas.width, canvas.height), BACK)
        draw = ImageDraw.Draw(ground)
        for layer, corners in zip(self.layers, self.marks(frame), strict=True):
            x, y, _ = camera @ (np.insert(corners, 1, 0.0, axis=1) - centre).T
            pixels = np.stack(((x - window[0]) * canvas.scale, (window[3] - y) * canvas.scale), 1)
            for triangle in pixels[layer.triangles]:
                draw.polygon(triangle.ravel().tolist(), fill=layer.color)
        picture = canvas.image(np.asarray(ground, np.float32) / 255, np.array(to_rgb(BACK)))[:height, :width]
        return (255 * np.clip(picture, 0, 1)).astype(np.uint8)
