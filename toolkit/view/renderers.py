"""Renderers of clips frame by frame: pyvista off screen where OpenGL works, the software renderer where it does not.

VTK must only be used from the main thread; `toolkit.view.player` takes care of that.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from matplotlib.colors import to_rgb
from PIL import Image, ImageDraw

from toolkit.motion import Clip
from toolkit.motion import rotations as R
from toolkit.view import body, floor
from toolkit.view.canvas import Canvas, orbit
from toolkit.view.character import Character as Figure
from toolkit.view.opengl import explain_missing_opengl, opengl_works
from toolkit.view.picture import steady_frames

BACK, SHADE, LINES = "#efece6", "#cdc8be", "#cbc5b9"
LIGHT = torch.tensor([-0.08, 1.0, 0.51])  # towards the lamp, facing +Z
# linear light: the browser's sun of 1.5 and hemisphere of 2.25 over π, in their colours (scene/scene.js)
SUN, SKY, GROUND = np.float32([[0.477, 0.467, 0.445], [0.716, 0.716, 0.716], [0.493, 0.468, 0.427]])
TILT = 0.2  # the camera looks down, radians
TINT = 0.55  # share of its own colour in the trunk of each of several characters in one scene


@dataclass(frozen=True, eq=False)
class Character:
    """A clip to draw and what is shown with it."""

    clip: Clip
    contacts: np.ndarray | None = None  # [F, 2] right, left, above one half where a foot stands
    phases: np.ndarray | None = None  # [F, 4, 2] (sin, cos) of left hand, right hand, left foot, right foot
    label: str = ""
    figure: Figure | None = None  # drawn in place of the mannequin; the clip is on its rig


def best(characters: Sequence[Character], size: tuple[int, int]) -> "PyvistaRenderer | SoftwareRenderer":
    """The best renderer that works here."""
    if opengl_works():
        return PyvistaRenderer(characters, size)
    explain_missing_opengl()
    return SoftwareRenderer(characters, size)


class Scene:
    """Characters in one scene and the camera, for any renderer."""

    def __init__(self, characters: Sequence[Character], size: tuple[int, int]):
        self.size = size
        self.angle, self.distance = -50.0, 3.8  # the camera's: degrees from where the first body faces at first, metres
        self.follow = True  # whether the camera follows the characters
        self.shown = {"path", "contacts"}  # kinds of layers on the floor; contacts also colour the standing feet
        self.load(characters)

    def load(self, characters: Sequence[Character]) -> None:
        """Show other characters."""
        self.characters = list(characters)
        clips = [character.clip for character in characters]
        self.bodies = [body.build(one.clip) if one.figure is None else None for one in characters]
        self.skins = [one.figure.skin if mannequin is None else mannequin.skin
                      for one, mannequin in zip(self.characters, self.bodies, strict=True)]
        self.paths, facings = zip(*(steady_frames(clip, 0.8) for clip in clips), strict=True)
        self.facing = float(facings[0][0])
        self.light = R.rotate(R.yaw(torch.tensor(self.facing)), LIGHT).numpy()  # towards the lamp
        self.height = 0.54 * max(float(clip.global_positions[0, :, 1].max()) for clip in clips)
        self.layers = [floor.layers(one.clip, one.contacts, self.color(i)) for i, one in enumerate(characters)]

    def color(self, character: int) -> str:
        """Colour that tells a character from the others in the scene."""
        return body.PALETTE[character % len(body.PALETTE)]

    def meshes(self, frames: Sequence[int]) -> list[tuple[np.ndarray, np.ndarray]]:
        """Vertices and normals [V, 3] of every character."""
        return [skin.pose(one.clip.global_rotations[frame], one.clip.global_positions[frame])
                for one, skin, frame in zip(self.characters, self.skins, frames, strict=True)]

    def lit(self, normals: np.ndarray, tones: np.ndarray) -> np.ndarray:
        """Colour [V, 3] uint8 of vertices with ``tones`` [V, 3]: matt, lit by sky, floor and one lamp, as in a page."""
        up = 0.5 + 0.5 * normals[:, 1:2]
        lamp = np.clip(normals @ (self.light / np.linalg.norm(self.light)), 0, None)[:, None]
        linear = (tones**2.2).astype(np.float32) * (GROUND + up * (SKY - GROUND) + lamp * SUN)
        return (255 * np.clip(linear, 0, 1) ** np.float32(1 / 2.2)).astype(np.uint8)

    def colors(self, frames: Sequence[int]) -> list[np.ndarray]:
        """Colours [V, 3] of every character's vertices: standing feet have their own, and so have trunks of several."""
        found, middle = [], np.array(to_rgb(body.COLORS["middle"]))
        for i, (one, mannequin, frame) in enumerate(zip(self.characters, self.bodies, frames, strict=True)):
            on = one.contacts is not None and "contacts" in self.shown
            tint = middle + TINT * (np.array(to_rgb(self.color(i))) - middle) if len(self.characters) > 1 else None
            found.append(one.figure.mesh.colors / 255 if mannequin is None
                         else mannequin.colors(one.contacts[frame] > 0.5 if on else None, tint))
        return found

    def marks(self, frames: Sequence[int]) -> list[tuple[floor.Layer, np.ndarray]]:
        """Layers on the floor, the lower ones first, with their corners [V, 2]; those of a hidden layer are one point."""
        found = [(layer, layer.corners(frame) * (layer.kind in self.shown))
                 for layers, frame in zip(self.layers, frames, strict=True) for layer in layers]
        return sorted(found, key=lambda mark: mark[0].height)

    def look(self, frames: Sequence[int]) -> tuple[np.ndarray, float, float]:
        """The point on the floor that the camera looks at, its distance, which keeps all in view, and its azimuth."""
        at = [path[frame if self.follow else len(path) // 2] for path, frame in zip(self.paths, frames, strict=True)]
        centre = np.mean(at, 0)
        distance = self.distance + 1.6 * float(np.linalg.norm(at - centre, axis=1).max())
        return centre, distance, self.facing + np.radians(self.angle)

    def close(self) -> None:
        """Free the window, where there is one."""


class PyvistaRenderer(Scene):
    """pyvista without multi-sampling and lights, its slowest parts: light is per vertex, the shadow a flat body."""

    def __init__(self, characters: Sequence[Character], size: tuple[int, int]):
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
        super().__init__(characters, size)

    def _add(self, mesh, name: str, **options):
        """Add a mesh with a colour per point, in the place of an older one of that name."""
        return self.plotter.add_mesh(mesh, name=name, scalars="rgb", rgb=True, lighting=False, render=False, **options)

    def load(self, characters: Sequence[Character]) -> None:
        """Show other characters."""
        super().load(characters)
        mesh = self.pv.PolyData.from_regular_faces
        first = np.cumsum([0, *(len(skin.points) for skin in self.skins)])
        faces = np.concatenate([skin.triangles + k for skin, k in zip(self.skins, first, strict=False)])
        self.body, self.flat = (mesh(np.zeros((first[-1], 3), np.float32), faces) for _ in range(2))
        self.body.point_data["rgb"] = np.zeros((self.body.n_points, 3), np.uint8)
        marks = self.marks([0] * len(self.characters))
        counts = [len(corners) for _, corners in marks]
        first = np.cumsum([0, *counts[:-1]])
        self.floor = mesh(
            np.concatenate([np.insert(corners, 1, layer.height, axis=1) for layer, corners in marks]).astype(np.float32),
            np.concatenate([layer.triangles + k for (layer, _), k in zip(marks, first, strict=True)]))
        tones = np.repeat([255 * np.array(to_rgb(layer.color)) for layer, _ in marks], counts, axis=0)
        self.floor.point_data["rgb"] = tones.astype(np.uint8)
        self._add(self.body, "body", culling=False if None in self.bodies else "back")
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

    def draw(self, frames: Sequence[int], *, fine: bool = False) -> np.ndarray:
        """Picture [H, W, 3] uint8 with each character at its frame; ``fine`` with smooth edges, in three times the time."""
        points, normals = (np.concatenate(part) for part in zip(*self.meshes(frames), strict=True))
        self.body.points[:] = points
        self.body.point_data["rgb"][:] = self.lit(normals, np.concatenate(self.colors(frames)))
        self.flat.points[:] = points - points[:, 1:2] * (self.light / self.light[1])
        self.flat.points[:, 1] = 0.003
        self.floor.points[:, [0, 2]] = np.concatenate([corners for _, corners in self.marks(frames)])
        for mesh in (self.body, self.flat, self.floor):
            mesh.Modified()
            mesh.GetPoints().Modified()
        self.body.GetPointData().GetScalars().Modified()
        centre, distance, a = self.look(frames)
        target = centre + np.array([0, self.height, 0])
        camera = self.plotter.camera  # VTK's own methods: pyvista's examine the whole scene each time
        camera.SetPosition(target + distance * np.array([np.sin(a), TILT, np.cos(a)]))
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

    def draw(self, frames: Sequence[int], *, fine: bool = False) -> np.ndarray:
        """Picture [H, W, 3] uint8 with each character at its frame; its edges are never smooth."""
        width, height = self.size
        centre, distance, a = self.look(frames)
        camera, metres, middle = orbit(-a, TILT), 0.57 * distance, self.height * np.cos(TILT)  # as high as with pyvista
        window = (-metres * width / height / 2, metres * width / height / 2, middle - metres / 2, middle + metres / 2)
        canvas = Canvas(window, height / metres, camera)
        meshes, lamp = self.meshes(frames), camera @ self.light
        for skin, (points, normals), colors in zip(self.skins, meshes, self.colors(frames), strict=True):
            canvas.draw((points - centre) @ camera.T, normals @ camera.T, skin.triangles, colors, lamp)
        ground = Image.new("RGB", (canvas.width, canvas.height), BACK)
        draw = ImageDraw.Draw(ground)
        for layer, corners in self.marks(frames):
            x, y, _ = camera @ (np.insert(corners, 1, 0.0, axis=1) - centre).T
            pixels = np.stack(((x - window[0]) * canvas.scale, (window[3] - y) * canvas.scale), 1)
            for triangle in pixels[layer.triangles]:
                draw.polygon(triangle.ravel().tolist(), fill=layer.color)
        picture = canvas.image(np.asarray(ground, np.float32) / 255, np.array(to_rgb(BACK)))[:height, :width]
        return (255 * np.clip(picture, 0, 1)).astype(np.uint8)
