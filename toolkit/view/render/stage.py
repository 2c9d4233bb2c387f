"""Bodies on a floor before a camera, drawn off screen by pyvista.

`open_stage` gives the drawings of `toolkit.view.render.sketch` where there is no OpenGL. VTK must
be used from the main thread only; `toolkit.view.widgets.player` takes care of that.
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.colors import to_rgb
from PIL import Image

from toolkit.view.render.bodies import BACK, SHADE, Body, Camera, Lines, Pose, axes
from toolkit.view.render.floor import Layer
from toolkit.view.render.opengl import explain_missing_opengl, opengl_works

# Linear light: the browser's sun of 1.5 and hemisphere of 2.25 over π, in their colours
# (scene/scene.js).
SUN, SKY, GROUND = np.float32(
    [[0.477, 0.467, 0.445], [0.716, 0.716, 0.716], [0.493, 0.468, 0.427]]
)
ANGLE = 32.0  # degrees that a camera with perspective sees from bottom to top


def lit(normals: np.ndarray, tones: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Colours [V, 3] uint8 of matt vertices with ``tones`` [V, 3], lit by sky, floor and a lamp."""
    up = 0.5 + 0.5 * normals[:, 1:2]
    lamp = np.clip(normals @ (light / np.linalg.norm(light)), 0, None)[:, None]
    linear = (tones**2.2).astype(np.float32) * (GROUND + up * (SKY - GROUND) + lamp * SUN)
    return (255 * np.clip(linear, 0, 1) ** np.float32(1 / 2.2)).astype(np.uint8)


# It returns a Stage or a Sketch, which have the same methods.
def open_stage(size: tuple[int, int], lines: Lines | None = None):
    """The stage that works here, of so many pixels: width and height."""
    if opengl_works():
        return Stage(size, lines)
    from toolkit.view.render.sketch import Sketch

    explain_missing_opengl()
    return Sketch(size, lines)


class Stage:
    """pyvista without multi-sampling and lights, its slowest parts.

    Light is computed per vertex; a shadow is the body pressed flat along the light.
    """

    def __init__(self, size: tuple[int, int], lines: Lines | None = None):
        import pyvista as pv
        from vtkmodules.util.numpy_support import numpy_to_vtk

        self.size, self.lines, self._pv, self._to_vtk = size, lines, pv, numpy_to_vtk
        theme = pv.themes.Theme()
        theme.multi_samples = 0
        self.plotter = pv.Plotter(off_screen=True, window_size=size, lighting="none", theme=theme)
        self.plotter.set_background(BACK)
        self._grid = None
        if lines is not None:
            ends = lines.segments()
            pairs = np.arange(2 * len(ends)).reshape(-1, 2)
            grid = pv.PolyData(np.float32(ends.reshape(-1, 3)),
                               lines=np.insert(pairs, 0, 2, axis=1).ravel())
            grid.point_data["rgb"] = (255 * lines.colors(ends).reshape(-1, 3)).astype(np.uint8)
            self._grid = self._add(grid, "grid")

    def _add(self, mesh, name: str, **options):
        """Add a mesh with a colour per point, in the place of an older one of that name."""
        return self.plotter.add_mesh(mesh, name=name, scalars="rgb", rgb=True, lighting=False,
                                     render=False, **options)

    def load(self, bodies: Sequence[Body], light: np.ndarray, layers: Sequence[Layer] = ()) -> None:
        """Show other bodies; ``light`` [3] points to the lamp."""
        self.light, self._layers = light, sorted(layers, key=lambda layer: layer.height)
        mesh = self._pv.PolyData.from_regular_faces
        self._meshes = []
        for i, body in enumerate(bodies):
            surface, flat = (
                mesh(np.zeros_like(body.skin.points), body.skin.triangles) for _ in range(2)
            )
            surface.point_data["rgb"] = np.zeros((surface.n_points, 3), np.uint8)
            culling = False if body.mannequin is None else "back"
            self._add(surface, f"body {i}", culling=culling)
            self.plotter.add_mesh(flat, name=f"shadow {i}", color=SHADE, lighting=False,
                                  render=False)
            self._meshes.append((surface, flat))
        self._floor = None
        if layers:
            corners = [np.insert(layer.corners(0), 1, layer.height, 1) for layer in self._layers]
            first = np.cumsum([0, *map(len, corners[:-1])])
            triangles = [x.triangles + k for x, k in zip(self._layers, first, strict=True)]
            self._floor = mesh(np.float32(np.concatenate(corners)), np.concatenate(triangles))
            tones = [255 * np.array(to_rgb(layer.color)) for layer in self._layers]
            tones = np.repeat(tones, [len(part) for part in corners], axis=0)
            self._floor.point_data["rgb"] = tones.astype(np.uint8)
            self._add(self._floor, "floor")

    def draw(self, poses: Sequence[Pose], camera: Camera, *, frame: int = 0,
             shown: Sequence[str] = (), fine: bool = True) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a pose of each body.

        Layers of the kinds that are ``shown`` are drawn as at a ``frame``. ``fine`` smooths the
        edges, in three times the time.
        """
        changed = []
        for pose, (surface, flat) in zip(poses, self._meshes, strict=True):
            points, normals = pose.mesh()
            surface.points[:] = points
            tones = pose.body.colors(pose.frame, pose.feet)
            surface.point_data["rgb"][:] = lit(normals, tones, self.light)
            surface.GetPointData().GetScalars().Modified()
            flat.points[:] = points - points[:, 1:2] * (self.light / self.light[1])
            flat.points[:, 1] = 0.003
            changed += [surface, flat]
        if self._floor is not None:
            # The corners of a hidden layer are one point.
            marks = [layer.corners(frame) * (layer.kind in shown) for layer in self._layers]
            self._floor.points[:, [0, 2]] = np.concatenate(marks)
            changed.append(self._floor)
        for mesh in changed:
            mesh.Modified()
            mesh.GetPoints().Modified()
        self._aim(camera)
        return self._read(2 if fine else 1)

    def _aim(self, camera: Camera) -> None:
        """Place the camera with VTK's own methods: pyvista's examine the whole scene each time."""
        _, up, back = axes(camera.azimuth, camera.tilt)
        lens, half = self.plotter.camera, camera.height / 2
        distance = half / np.tan(np.radians(ANGLE / 2)) if camera.perspective else 50.0
        lens.SetPosition(camera.target + distance * back)
        lens.SetFocalPoint(camera.target)
        lens.SetViewUp(up)
        lens.SetViewAngle(ANGLE)
        lens.SetParallelProjection(not camera.perspective)
        lens.SetParallelScale(half)
        lens.SetClippingRange(0.2, 100)
        if self._grid is not None:
            self._grid.SetPosition(self.lines.crossing(camera.target))

    def _read(self, scale: int) -> np.ndarray:
        """The camera's picture, drawn ``scale`` times larger and averaged."""
        width, height = (scale * n for n in self.size)
        window, picture = self.plotter.render_window, np.empty((height, width, 3), np.uint8)
        window.SetSize(width, height)
        if self._grid is not None:
            self._grid.prop.line_width = scale
        window.Render()
        same = self._to_vtk(picture.reshape(-1, 3))  # the memory of the picture
        window.GetPixelData(0, 0, width - 1, height - 1, 0, same, 0)
        picture = picture[::-1]
        return picture if scale == 1 else np.asarray(Image.fromarray(picture).reduce(scale))

    def close(self) -> None:
        """Free the window."""
        self.plotter.close()
