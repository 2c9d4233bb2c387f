"""What draws a clip frame by frame: pyvista off screen where OpenGL works, the software renderer where it does not.

VTK must only be touched from the main thread; `toolkit.view.player` sees to that.
"""

import numpy as np
import torch
from matplotlib.colors import to_rgb

from toolkit import rotations as R
from toolkit.motion import Clip
from toolkit.view import body
from toolkit.view.opengl import explain_missing_opengl, opengl_works
from toolkit.view.picture import FLOOR, PAPER, steady_frames
from toolkit.view.raycast import Canvas

SHADE, LINES, TRAIL, AHEAD = "#cdc8be", "#d3cec3", body.PALETTE[0], "#b9b3a7"
LIGHT = np.array([-0.10, 1.0, 0.55])  # towards the lamp, facing +Z


def make(clip: Clip, contacts: np.ndarray | None, size: tuple[int, int]) -> "Stage | Sketch":
    """The best renderer there is."""
    if opengl_works():
        return Stage(clip, contacts, size)
    explain_missing_opengl()
    return Sketch(clip, contacts, size)


class _Scene:
    """Everything about a clip that drawing needs, whichever way it is drawn.

    ``angle`` is the camera's azimuth in degrees from where the body faces at first, ``distance`` in metres.
    """

    def __init__(self, clip: Clip, contacts: np.ndarray | None, size: tuple[int, int]):
        self.size = size
        self.angle, self.distance = -50.0, 3.8
        self.follow = self.show_contacts = self.show_trail = True
        self.load(clip, contacts)

    def load(self, clip: Clip, contacts: np.ndarray | None) -> None:
        """Show another clip."""
        self.clip, self.contacts = clip, None if contacts is None else np.asarray(contacts) > 0.5
        self.shapes = body.build(clip)
        self.places = body.placements(self.shapes, clip.global_rotations, clip.global_positions)
        self.path, facing = steady_frames(clip, 0.8)
        self.facing = float(facing[0])
        self.height = 0.54 * float(clip.global_positions[0, :, 1].max())

    def colors(self, frame: int) -> np.ndarray:
        """Colour of every shape [S, 3]: standing feet light up."""
        return body.colors(self.shapes, self.contacts[frame] if self.show_contacts and self.contacts is not None else None)

    def centre(self, frame: int) -> np.ndarray:
        """The point on the floor that the camera looks over."""
        return self.path[frame if self.follow else len(self.path) // 2]


class Stage(_Scene):
    """pyvista: one light, no multi-sampling, a grid of lines, and a shadow that is the body pressed flat."""

    def __init__(self, clip: Clip, contacts: np.ndarray | None, size: tuple[int, int]):
        import pyvista as pv

        self.pv = pv
        theme = pv.themes.Theme()
        theme.multi_samples = 0
        self.plotter = pv.Plotter(off_screen=True, window_size=size, lighting="none", theme=theme)
        self.plotter.set_background(FLOOR, top=PAPER)
        self.lamp = pv.Light(light_type="scene light", intensity=0.95)
        self.plotter.add_light(self.lamp)
        super().__init__(clip, contacts, size)

    def load(self, clip: Clip, contacts: np.ndarray | None) -> None:
        """Show another clip."""
        super().load(clip, contacts)
        pv = self.pv
        parts = [body.surface(shape) for shape in self.shapes]
        self.vertices, self.normals = (np.stack([p[i] for p in parts]).astype(np.float32) for i in (0, 1))
        count = self.vertices.shape[1]
        faces = np.concatenate([p[2] + i * count for i, p in enumerate(parts)])
        points = np.zeros((len(parts) * count, 3), np.float32)
        self.body = pv.PolyData.from_regular_faces(points, faces)
        self.body.point_data["rgb"] = np.zeros((len(points), 3), np.uint8)
        self.body.point_data.active_normals = np.tile(np.array([[0, 1, 0]], np.float32), (len(points), 1))
        self.flat = pv.PolyData.from_regular_faces(points.copy(), faces)
        q = R.yaw(torch.tensor(self.facing))
        self.light = R.rotate(q, torch.from_numpy(LIGHT).float()).numpy()
        self.lamp.position, self.lamp.focal_point = tuple(10 * self.light), (0, 0, 0)
        add = self.plotter.add_mesh
        add(self.body, name="body", scalars="rgb", rgb=True, smooth_shading=False, ambient=0.62, diffuse=0.50,
            specular=0.12, specular_power=18, render=False).prop.interpolation = "Gouraud"  # fmt: skip
        add(self.flat, name="shadow", color=SHADE, lighting=False, render=False)
        self.grid = add(self._grid(), name="grid", scalars="rgb", rgb=True, lighting=False, line_width=1, render=False)
        track = clip.root_positions.numpy() * np.array([1, 0, 1]) + np.array([0, 0.006, 0])
        if len(track) < 2:
            track = np.repeat(track, 2, 0)
        self.track = track
        self.ahead = add(pv.lines_from_points(track), name="ahead", color=AHEAD, line_width=2, lighting=False, render=False)
        self.walked = pv.lines_from_points(track + np.array([0, 0.006, 0]))
        self.behind = add(self.walked, name="behind", color=TRAIL, line_width=4, lighting=False, render=False)

    def _grid(self, reach: int = 14):
        """Lines a metre apart, fading into the background."""
        steps, points = np.arange(-reach, reach + 1.0), []
        for x in steps:
            for z in steps[:-1]:
                points += [(x, 0, z), (x, 0, z + 1), (z, 0, x), (z + 1, 0, x)]
        points = np.array(points, np.float32)
        cells = np.column_stack((np.full(len(points) // 2, 2), np.arange(len(points)).reshape(-1, 2)))
        grid = self.pv.PolyData(points, lines=cells.ravel())
        fade = np.clip(np.linalg.norm(points, axis=1) / reach, 0, 1)[:, None] ** 0.7
        far = (np.array(to_rgb(PAPER)) + np.array(to_rgb(FLOOR))) / 2
        grid.point_data["rgb"] = (255 * (np.array(to_rgb("#c3bdb0")) * (1 - fade) + far * fade)).astype(np.uint8)
        return grid

    def draw(self, frame: int) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a frame."""
        places = self.places[frame]
        turn = places[:, :, :3]
        points = self.vertices @ turn.transpose(0, 2, 1) + places[:, None, :, 3]
        normals = self.normals @ np.linalg.inv(turn)
        normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
        self.body.points[:] = points.reshape(-1, 3)
        self.body.point_data.active_normals[:] = normals.reshape(-1, 3)
        self.body.point_data["rgb"][:] = np.repeat((255 * self.colors(frame)).astype(np.uint8), points.shape[1], 0)
        flat = points.reshape(-1, 3) - points.reshape(-1, 3)[:, 1:2] * (self.light / self.light[1]).astype(np.float32)
        flat[:, 1] = 0.003
        self.flat.points[:] = flat
        for mesh in (self.body, self.flat):
            mesh.Modified()
            mesh.GetPoints().Modified()
        self.body.GetPointData().GetNormals().Modified()
        self.body.GetPointData().GetScalars().Modified()
        walked = self.track + np.array([0, 0.006, 0])
        walked[frame + 1 :] = walked[frame]
        self.walked.points[:] = walked
        self.walked.GetPoints().Modified()
        self.walked.Modified()
        for actor in (self.ahead, self.behind):
            actor.visibility = self.show_trail
        self._aim(frame)
        self.plotter.render()
        return self.plotter.screenshot(return_img=True)

    def _aim(self, frame: int) -> None:
        centre = self.centre(frame)
        a = self.facing + np.radians(self.angle)
        target = centre + np.array([0, self.height, 0])
        camera = self.plotter.camera
        camera.position = tuple(target + self.distance * np.array([np.sin(a), 0.14, np.cos(a)]))
        camera.focal_point, camera.up, camera.view_angle = tuple(target), (0, 1, 0), 32
        camera.clipping_range = (0.2, 60)
        self.grid.position = tuple(np.round(centre))

    def close(self) -> None:
        """Free the window."""
        self.plotter.close()


class Sketch(_Scene):
    """The software renderer: slower, needs nothing."""

    def draw(self, frame: int) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a frame."""
        width, height = self.size
        a, tilt = self.facing + np.radians(self.angle), 0.14
        camera = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
        camera = camera @ np.array([[np.cos(a), 0, -np.sin(a)], [0, 1, 0], [np.sin(a), 0, np.cos(a)]])
        places = self.places[frame].astype(np.float64)
        places[..., 3] -= self.centre(frame)
        places = camera @ places
        metres = 0.57 * self.distance  # seen from top to bottom, as in the other renderer
        middle = self.height * np.cos(tilt)
        window = (-metres * width / height / 2, metres * width / height / 2, middle - metres / 2, middle + metres / 2)
        canvas = Canvas(window, height / metres)
        floor = np.zeros(3)
        lamp = camera @ R.rotate(R.yaw(torch.tensor(self.facing)), torch.from_numpy(LIGHT).float()).numpy()
        canvas.draw(self.shapes, places, self.colors(frame))
        canvas.shadow(self.shapes, places, camera[:, 1], floor, lamp)
        low, high = np.array(to_rgb(FLOOR)), np.array(to_rgb(PAPER))
        blend = np.linspace(1, 0, canvas.height)[:, None]
        picture = canvas.image((high * blend + low * (1 - blend))[:, None], high)[:height, :width]
        return (255 * np.clip(picture, 0, 1)).astype(np.uint8)

    def close(self) -> None:
        """Nothing to free."""
