"""A mannequin that fits any skeleton: rounded cones fixed to joints, shared by every way of drawing.

A rounded cone is the convex hull of two spheres, thinned along one direction. One description (`Shape`) serves the software
renderer, pyvista and the browser; the last two bend it where it meets other joints (`toolkit.view.skin`). Rigs differ in
their local axes (Bandai-Namco's bones lie along X), so directions such as "forward in the head's frame" are measured on the
clip, never assumed.
"""

from dataclasses import dataclass, replace
from itertools import pairwise
from weakref import WeakKeyDictionary

import numpy as np
import torch
from matplotlib.colors import to_rgb
from torch import Tensor

from toolkit.motion import Clip, root_frames
from toolkit.motion import rotations as R
from toolkit.motion.clip import FEET, SIDES

LEG = 0.87  # hip to ankle in metres of the body that the radii below are written for
COLORS = {"left": "#6a9fcb", "right": "#e39a6c", "middle": "#ebe6dd", "joint": "#46505c", "face": "#2b323b"}
CONTACT = "#35c46a"
PALETTE = ("#7b68c4", "#2fa596", "#d6598b", "#c9a227", "#5b8def", "#8a8f98")  # styles and curves, in order
RADII = {  # upper joint's role -> radii at the two ends of the bone below it
    "hip": (0.077, 0.054), "knee": (0.053, 0.035), "foot": (0.041, 0.030),
    "shoulder": (0.049, 0.037), "elbow": (0.037, 0.027),
}


@dataclass(frozen=True, eq=False)
class Bend:
    """Where a shape's surface passes to another joint.

    Parameters
    ----------
    joint
        The other joint.
    place : ndarray [3, 4]
        From the cone's own frame to that joint's, in a straight limb.
    at, width
        Along the cone's axis, metres: half of the surface follows the other joint at ``at``, all of it at ``at + width``.
    """

    joint: int
    place: np.ndarray
    at: float
    width: float


@dataclass(frozen=True, eq=False)
class Shape:
    """One rounded cone.

    Parameters
    ----------
    joint
        The joint it is fixed to.
    place : ndarray [3, 4]
        From the cone's own frame (first sphere at the origin, second at +Y · ``length``) to the joint's frame, metres.
    length, radii
        Distance of the two spheres and their radii, metres.
    tone
        Key of `COLORS`.
    foot
        "left" or "right" where it lights up on contact.
    bends
        To the joints beyond its ends, at most one each.
    """

    joint: int
    place: np.ndarray
    length: float
    radii: tuple[float, float]
    tone: str
    foot: str = ""
    bends: tuple[Bend, ...] = ()


def cone(joint: int, start: Tensor, end: Tensor, radii: tuple[float, float], tone: str, *, thin: Tensor | None = None,
         by: float = 1.0, foot: str = "") -> Shape:
    """Rounded cone from ``start`` to ``end`` [3] in the joint's frame, its thickness along ``thin`` scaled by ``by``."""
    start, end = (np.asarray(v, dtype=np.float64) for v in (start, end))
    length = max(float(np.linalg.norm(end - start)), 1.1 * abs(radii[0] - radii[1]), 1e-4)
    y = end - start if np.linalg.norm(end - start) > 1e-6 else np.eye(3)[1]
    y = y / np.linalg.norm(y)
    z = np.eye(3)[np.abs(y).argmin()] if thin is None else np.asarray(thin, dtype=np.float64)
    z = z - y * (y @ z)
    z = z / max(np.linalg.norm(z), 1e-9) if np.linalg.norm(z) > 1e-3 else np.cross(y, np.eye(3)[np.abs(y).argmin()])
    z = z / np.linalg.norm(z)
    return Shape(joint, np.stack((np.cross(y, z), y, z * by, start), 1), length, tuple(map(float, radii)), tone, foot)


def _snap(v: Tensor) -> Tensor:
    """The signed coordinate axis nearest to a direction [3]."""
    i = v.abs().argmax()
    return torch.eye(3)[i] * v[i].sign()


class _Measured:
    """Directions and places in joints' own frames, averaged over a clip."""

    def __init__(self, clip: Clip):
        self.clip, self.skeleton = clip, clip.skeleton
        self.positions, self.rotations = clip.global_positions, clip.global_rotations
        facing = R.inverse(root_frames(clip).rotations)[:, None].expand(-1, len(clip.skeleton), -1)
        self.axes = R.to_matrix(R.multiply(facing, self.rotations)).mean(0)  # rows: the body's axes in joint coordinates
        self.legs = {j for side in SIDES for j in self.skeleton.ancestors(self.skeleton.role(f"{side}_foot"))}

    def up(self, joint: int) -> Tensor:
        """Along the bones that go on from a joint of the trunk: a bent spine takes its own up with it."""
        bones = [self.skeleton.offsets[j] for j, p in enumerate(self.skeleton.parents) if p == joint and j not in self.legs]
        along = sum(bones, torch.zeros(3))
        return _snap(along if float(along.norm()) > 0.02 else self.axes[joint, 1])

    def forward(self, joint: int) -> Tensor:
        return _snap(self.axes[joint, 2] * (1 - self.up(joint).abs()))

    def onward(self, joint: int) -> Tensor:
        """Along the bones that go on from any joint, else along the one that ends there."""
        below = [j for j, p in enumerate(self.skeleton.parents) if p == joint]
        offsets = self.skeleton.offsets[[j for j in below if j not in self.legs] or below].sum(0)
        return R.normalize(offsets if float(offsets.norm()) > 0.02 else self.skeleton.offsets[joint])

    def bend(self, shape: Shape, joint: int, width: float) -> Shape:
        """Let a shape bend towards the next joint or the one above its own, over ``width`` metres to either side.

        The limb is straight where the lower bone goes on along the upper, with the clip's mean twist.
        """
        below = self.skeleton.parents[joint] == shape.joint
        lower, upper = (joint, shape.joint) if below else (shape.joint, joint)
        bone = self.skeleton.offsets[lower]
        local = R.unroll(self.clip.rotations[:, lower]).mean(0)
        turn = R.normalize(local) if float(local.norm()) > 1e-3 else R.identity()
        turn = R.to_matrix(R.multiply(R.between(R.rotate(turn, self.onward(lower)), R.normalize(self.onward(upper))), turn))
        turn, bone = turn.double().numpy(), bone.double().numpy()
        moved = shape.place.copy()
        if below:
            moved[:, 3] -= bone
            moved = turn.T @ moved
        else:
            moved = turn @ moved
            moved[:, 3] += bone
        origin = bone if below else np.zeros(3)
        at = float((np.linalg.inv(shape.place[:, :3]) @ (origin - shape.place[:, 3]))[1])
        return replace(shape, bends=(*shape.bends, Bend(joint, moved, at, width if below else -width)))

    def left(self, joint: int) -> Tensor:
        return torch.linalg.cross(self.up(joint), self.forward(joint))

    def palm(self, side: str) -> Tensor:
        """Where a palm looks, in the hand's frame: along the elbow's axis, sideways for an arm that stays straight."""
        shoulder, elbow, hand = (self.skeleton.role(f"{side}_{part}") for part in ("shoulder", "elbow", "hand"))
        upper, lower = (self.positions[:, b] - self.positions[:, a] for a, b in ((shoulder, elbow), (elbow, hand)))
        axis = R.rotate(R.inverse(self.rotations[:, hand]), torch.linalg.cross(upper, lower)).mean(0)
        return R.normalize(axis if float(axis.norm()) > 1e-3 else self.axes[hand, 0])

    def place(self, joint: int, frame: int) -> Tensor:
        """Mean position of ``joint`` in the frame of another."""
        return R.rotate(R.inverse(self.rotations[:, frame]), self.positions[:, joint] - self.positions[:, frame]).mean(0)

    def standing(self, foot: int, direction: Tensor, frame: int) -> Tensor:
        """World ``direction`` (broadcast [F, 3]) in a joint's frame, averaged over the frames in which the foot is low."""
        height = self.positions[:, foot, 1]
        low = height <= height.quantile(0.2)
        return R.normalize(R.rotate(R.inverse(self.rotations[low, frame]), direction.expand(len(height), 3)[low]).mean(0))


_BUILT: WeakKeyDictionary[Clip, tuple[Shape, ...]] = WeakKeyDictionary()  # as long as the clips live


def build(clip: Clip) -> tuple[Shape, ...]:
    """The mannequin of a clip's skeleton.

    Skeletons without hips, shoulders and feet (see `toolkit.motion.ROLES`) get plain bones.
    """
    if clip not in _BUILT:
        _BUILT[clip] = _build(clip)
    return _BUILT[clip]


def _build(clip: Clip) -> tuple[Shape, ...]:
    skeleton, roles = clip.skeleton, clip.skeleton.roles
    humanoid = all(f"{side}_{part}" in roles for side in SIDES for part in ("shoulder", "elbow", "hip", "foot"))
    if not humanoid:
        return _bones(clip, set(), 1.0)
    m = _Measured(clip)
    leg = sum(float(skeleton.offsets[skeleton.role(f"left_{part}")].norm()) for part in ("knee", "foot"))
    scale = leg / LEG
    used, shapes = set(), []
    for side in SIDES:
        for build_limb in (_limb, _foot, _hand):
            shapes += build_limb(m, side, scale, used)
    shapes += _torso(m, scale, used) + _head(m, scale, used)
    return (*shapes, *_bones(clip, used, scale))


def _bones(clip: Clip, used: set[int], scale: float) -> tuple[Shape, ...]:
    """Plain capsules for whatever has no role: fingers, tails, props, other creatures."""
    shapes = []
    for j, p in enumerate(clip.skeleton.parents):
        length = float(clip.skeleton.offsets[j].norm())
        if p >= 0 and j not in used and length > 0.008:
            r = min(max(0.16 * length, 0.008), 0.045 * scale)
            shapes.append(cone(p, torch.zeros(3), clip.skeleton.offsets[j], (r, 0.8 * r), "middle"))
    return tuple(shapes)


def _limb(m: _Measured, side: str, s: float, used: set[int]) -> list[Shape]:
    shapes = []
    for upper, lower in (("hip", "knee"), ("knee", "foot"), ("shoulder", "elbow"), ("elbow", "hand")):
        a, b = m.skeleton.role(f"{side}_{upper}"), m.skeleton.role(f"{side}_{lower}")
        bone, (r0, r1) = m.skeleton.offsets[b], RADII[upper]
        flesh = cone(a, 0.06 * bone, 0.94 * bone, (r0 * s, r1 * s), side)
        if lower != "foot":  # a foot does not go on along its shin
            flesh = m.bend(flesh, b, 0.1 * s if lower == "hand" else 1.6 * r1 * s)
        if upper in ("knee", "elbow"):
            flesh = m.bend(flesh, m.skeleton.parents[a], 1.6 * r0 * s)
        shapes.append(flesh)
        shapes.append(cone(b, torch.zeros(3), torch.zeros(3), (1.04 * r1 * s,) * 2, "joint"))
        used.update((a, b))
    shoulder = m.skeleton.role(f"{side}_shoulder")
    collar = m.skeleton.parents[shoulder]
    shapes.append(cone(shoulder, torch.zeros(3), torch.zeros(3), (0.056 * s,) * 2, "joint"))
    shapes.append(cone(collar, torch.zeros(3), 0.86 * m.skeleton.offsets[shoulder], (0.046 * s, 0.05 * s), "middle"))
    used.add(collar)
    return shapes


def _foot(m: _Measured, side: str, s: float, used: set[int]) -> list[Shape]:
    ankle = m.skeleton.role(f"{side}_foot")
    if f"{side}_toe" not in m.skeleton.roles:
        return []
    toe = m.skeleton.role(f"{side}_toe")
    to_toe = m.skeleton.offsets[toe]
    up = m.standing(ankle, torch.tensor([0.0, 1.0, 0.0]), ankle)
    forward = R.normalize(to_toe - up * (up @ to_toe))
    r0, r1 = 0.038 * s, 0.036 * s
    rise = float(m.positions[:, toe, 1].quantile(0.05).clamp(0.0, 0.05 * s))  # the joint above the sole
    sole = float(up @ to_toe) - rise
    heel = up * (sole + r0) - 0.012 * s * forward
    ball = to_toe + up * (r1 - rise)
    flat = m.standing(ankle, torch.tensor([0.0, 1.0, 0.0]), toe)
    ahead = m.standing(ankle, R.rotate(m.rotations[:, ankle], forward.expand(len(m.positions), 3)), toe)
    tip = 0.038 * s * ahead + flat * (0.027 * s - rise)
    used.update(j for j, p in enumerate(m.skeleton.parents) if p in (ankle, toe))
    return [
        cone(ankle, torch.zeros(3), 0.75 * ball, (0.042 * s, 0.034 * s), side, foot=side),
        cone(ankle, heel, ball, (r0, r1), side, foot=side),
        cone(toe, flat * (r1 - rise), tip, (0.99 * r1, 0.027 * s), side, foot=side),
    ]


def _hand(m: _Measured, side: str, s: float, used: set[int]) -> list[Shape]:
    hand = m.skeleton.role(f"{side}_hand")
    end = next((j for j, p in enumerate(m.skeleton.parents) if p == hand and m.skeleton.is_end(j)), hand)
    along = m.skeleton.offsets[end] if end != hand and float(m.skeleton.offsets[end].norm()) > 0.02 else None
    along = R.normalize(m.skeleton.offsets[hand] if along is None else along)
    used.add(end)
    palm, r = m.palm(side), 0.043 * s
    return [cone(hand, 0.035 * s * along, 0.13 * s * along, (r, 0.75 * r), side, thin=palm, by=0.55)]


def _torso(m: _Measured, s: float, used: set[int]) -> list[Shape]:
    skeleton = m.skeleton
    hips = skeleton.role("hips")
    left, right = skeleton.role("left_hip"), skeleton.role("right_hip")
    shoulders = skeleton.role("left_shoulder"), skeleton.role("right_shoulder")
    spine, chest = skeleton.trunk, skeleton.trunk[0]
    used.update((left, right, *(j for limb in (left, right, *shoulders) for j in skeleton.ancestors(limb))))
    a, b = m.place(left, hips), m.place(right, hips)
    across = R.normalize(a - b)
    middle, half = (a + b) / 2 + 0.025 * s * m.up(hips), 0.062 * s
    shapes = [cone(hips, middle + half * across, middle - half * across, (0.1 * s,) * 2, "middle",
                   thin=m.forward(hips), by=0.9)]
    for upper, lower in pairwise(spine):
        part = cone(lower, torch.zeros(3), skeleton.offsets[upper], (0.088 * s, 0.092 * s), "joint", thin=m.forward(lower),
                    by=0.86)
        part = m.bend(part, upper, 0.07 * s)
        shapes.append(part if lower == hips else m.bend(part, skeleton.parents[lower], 0.07 * s))
    a, b = (m.place(shoulder, chest) for shoulder in shoulders)
    width = float((a - b).norm()) / 2
    wide = min(max(0.78 * width, 0.125 * s), 0.152 * s)
    top = (a + b) / 2 - m.up(chest) * 0.6 * wide
    bottom = top - m.up(chest) * 0.17 * s
    ribs = cone(chest, bottom, top, (0.76 * wide, wide), "middle", thin=m.forward(chest), by=0.74)
    return [*shapes, m.bend(ribs, skeleton.parents[chest], 0.07 * s) if chest != hips else ribs]


def _head(m: _Measured, s: float, used: set[int]) -> list[Shape]:
    skeleton = m.skeleton
    spine = skeleton.trunk
    chain = [j for j, n in enumerate(skeleton.names) if "head" in n.lower() and not skeleton.is_end(j)]
    if not chain:
        return []
    head, shapes, j = chain[0], [], chain[0]
    while j not in spine and j > 0:  # the neck, down to the chest
        p = skeleton.parents[j]
        last = p in spine  # the lowest part widens into the shoulders
        start, r0, tone = (0.45, 0.088, "middle") if last and j != head else (0.0, 0.05, "joint")
        neck = cone(p, start * skeleton.offsets[j], skeleton.offsets[j], (r0 * s, 0.05 * s), tone)
        neck = neck if last else m.bend(neck, skeleton.parents[p], 0.04 * s)
        shapes.append(m.bend(neck, j, 0.04 * s))
        used.add(j)
        j = p
    used.update(j for j, p in enumerate(skeleton.parents) if p == head)
    up, forward, left = m.up(head), m.forward(head), m.left(head)
    shapes.append(cone(head, (0.045 * up + 0.022 * forward) * s, (0.118 * up + 0.008 * forward) * s,
                       (0.068 * s, 0.09 * s), "middle", thin=left, by=0.86))
    eyes = (0.096 * up + 0.072 * forward) * s
    return [*shapes, cone(head, eyes + 0.026 * s * left, eyes - 0.026 * s * left, (0.032 * s,) * 2, "face",
                          thin=up, by=0.7)]


def colors(shapes: tuple[Shape, ...], contacts: np.ndarray | None = None) -> np.ndarray:
    """Colour of every shape [S, 3], 0 to 1; feet (right, left) that ``contacts`` [2] says stand light up."""
    table = np.array([to_rgb(COLORS[s.tone]) for s in shapes])
    if contacts is not None:
        table[[bool(s.foot and contacts[FEET.index(s.foot)]) for s in shapes]] = to_rgb(CONTACT)
    return table


def placements(shapes: tuple[Shape, ...], rotations: Tensor, positions: Tensor) -> np.ndarray:
    """World placement ``[..., S, 3, 4]`` of shapes, of global rotations ``[..., J, 4]`` and positions ``[..., J, 3]``."""
    joints = [s.joint for s in shapes]
    local = torch.from_numpy(np.stack([s.place for s in shapes])).float()
    turn = R.to_matrix(rotations[..., joints, :])
    world = turn @ local
    world[..., 3] += positions[..., joints, :]
    return world.numpy()


def bounds(shapes: tuple[Shape, ...], places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Lowest and highest coordinates [3] that shapes at ``places`` [..., S, 3, 4] reach."""
    ends = np.stack((places[..., 3], places[..., 3] + places[..., 1] * np.array([[s.length] for s in shapes])), -2)
    radii = np.array([s.radii for s in shapes])[..., None]
    axes = tuple(range(ends.ndim - 1))
    return (ends - radii).min(axes), (ends + radii).max(axes)
