"""Plain skeletons drawn by matplotlib, for machines without OpenGL: the stage of `stage`, sketched.

Bones are lines, the far ones first and paler. A ring on the floor marks a foot that stands.
"""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from toolkit.motion import Skeleton
from toolkit.motion.clip import FEET, SIDES
from toolkit.motion.contacts import detect
from toolkit.view.render.bodies import BACK, SHADE, Body, Camera, Pose, axes
from toolkit.view.render.mannequin import COLORS, CONTACT, has_roles

DPI = 100
MIDDLE = "#8d8678"  # the trunk, which is darker than on the mannequin: a line has no shading
THICK, HEAD = 0.055, 0.1  # width of a bone and radius of a head, metres of a person of TALL
TALL = 1.75
PALE = 0.45  # how much the farthest bone is mixed with the background
RING = 0.09 * np.stack(
    [f(np.linspace(0, 2 * np.pi, 17)) for f in (np.sin, np.zeros_like, np.cos)], 1
)


@lru_cache(maxsize=16)
def _tones(skeleton: Skeleton) -> tuple[list[str], int | None]:
    """Colour of the bone above each joint, and the joint on top of a humanoid's head."""
    tones, trunk = [MIDDLE] * len(skeleton), set(range(len(skeleton)))
    for side in SIDES:
        for part in ("shoulder", "hip"):
            if f"{side}_{part}" in skeleton.roles:
                below = set(skeleton.tree.below(skeleton.role(f"{side}_{part}")))
                trunk -= below
                for j in below:
                    tones[j] = COLORS[side]
    parents, top = set(skeleton.parents), None
    if "left_shoulder" in skeleton.roles:
        heights = skeleton.offsets.double().numpy().copy()
        for j, parent in enumerate(skeleton.parents):
            heights[j] += heights[parent] if parent >= 0 else 0
        leaves = [j for j in trunk if j not in parents]
        top = max(leaves, key=lambda j: heights[j].max(), default=None)
    return tones, top


def _stands(body: Body) -> np.ndarray | None:
    """Which feet stand [F, 2]: as the body knows or as detected; None without feet."""
    if not has_roles(body.clip, "foot", "toe"):
        return None
    found = detect(body.clip).numpy() if body.contacts is None else body.contacts
    return found > 0.5


class Sketch:
    """Takes the place of `toolkit.view.render.stage.Stage`; all its projections are parallel."""

    def __init__(self, size: tuple[int, int], lines=None):
        self.size, self.lines = size, lines

    def load(self, bodies: Sequence, light: np.ndarray, layers: Sequence = ()) -> None:
        """Show other bodies; ``light`` [3] points to the lamp."""
        self.light, self._layers = light, sorted(layers, key=lambda layer: layer.height)
        self._stands = {body: _stands(body) for body in bodies}

    def draw(self, poses: Sequence[Pose], camera: Camera, *, frame: int = 0,
             shown: Sequence[str] = (), fine: bool = True) -> np.ndarray:
        """Picture [H, W, 3] uint8 of a pose of each body; the parameters are those of `Stage`."""
        width, height = self.size
        scale, turn = height / camera.height, axes(camera.azimuth, camera.tilt)

        def seen(points: np.ndarray) -> np.ndarray:
            """Pixels to the right and upwards, and metres towards the viewer [..., 3]."""
            x, y, depth = np.moveaxis((points - camera.target) @ turn.T, -1, 0)
            return np.stack((width / 2 + scale * x, height / 2 + scale * y, depth), -1)

        figure = Figure(figsize=(width / DPI, height / DPI), dpi=DPI, facecolor=BACK)
        paper = figure.add_axes((0, 0, 1, 1), xlim=(0, width), ylim=(0, height))
        paper.set_axis_off()
        if self.lines is not None:
            pieces = self.lines.segments()
            ends, middles = pieces + self.lines.crossing(camera.target), pieces.mean(1)
            paper.add_collection(LineCollection(
                seen(ends)[..., :2], colors=self.lines.colors(middles), lw=0.8, zorder=0
            ))
        for layer in self._layers:
            if layer.kind in shown:
                corners = seen(np.insert(layer.corners(frame), 1, layer.height, axis=1))[..., :2]
                paper.add_collection(PolyCollection(corners[layer.triangles], color=layer.color))

        bones, depths, tones, widths, shadows, heads = [], [], [], [], [], []
        for pose in poses:
            skeleton, joints = pose.body.clip.skeleton, pose.joints()
            colors, top = _tones(skeleton)
            if pose.body.tint is not None:
                colors = [pose.body.tint] * len(colors)
            size = min(max(np.ptp(joints[:, 1]) / TALL, 0.3), 2.0)
            pairs = np.array([[max(p, 0), j] for j, p in enumerate(skeleton.parents)])
            flat = joints - joints[:, 1:2] * (self.light / self.light[1])
            shadows.append(seen(flat)[pairs][..., :2])
            bones.append(seen(joints)[pairs])
            depths.append(bones[-1][..., 2].mean(1))
            tones += [to_rgb(color) for color in colors]
            widths += [scale * THICK * size * 72 / DPI] * len(pairs)
            if top is not None:
                middle = joints[[top, skeleton.parents[top]]].mean(0)
                heads.append((seen(middle)[:2], scale * HEAD * size, colors[top]))
            if pose.feet and self._stands[pose.body] is not None:
                self._rings(paper, pose, joints, seen, size)
        paper.add_collection(LineCollection(
            np.concatenate(shadows), colors=SHADE, lw=widths, capstyle="round", zorder=0.5
        ))
        depth = np.concatenate(depths)
        far = PALE * (depth.max() - depth) / max(np.ptp(depth), 1e-9)
        order = np.argsort(depth)
        mixed = np.array(tones) * (1 - far[:, None]) + np.array(to_rgb(BACK)) * far[:, None]
        paper.add_collection(LineCollection(
            np.concatenate(bones)[order][..., :2], colors=mixed[order],
            lw=np.array(widths)[order], capstyle="round", zorder=2
        ))
        for place, radius, color in heads:
            paper.add_patch(Circle(place, radius, color=color, zorder=3))
        canvas = FigureCanvasAgg(figure)
        canvas.draw()
        return np.asarray(canvas.buffer_rgba())[..., :3].copy()

    def _rings(self, paper, pose: Pose, joints: np.ndarray, seen, size: float) -> None:
        """A ring on the floor around each foot that stands."""
        for stands, side in zip(self._stands[pose.body][pose.frame], FEET, strict=True):
            if stands:
                ends = [pose.body.clip.skeleton.role(f"{side}_{part}") for part in ("foot", "toe")]
                middle = joints[ends].mean(0) * [1, 0, 1]
                ring = seen(middle + size * RING)[:, :2]
                paper.add_collection(PolyCollection([ring], color=CONTACT, zorder=1.7))

    def close(self) -> None:
        """Nothing is kept."""
