"""A mannequin that fits any skeleton: rounded cones fixed to joints, used by every renderer.

A rounded cone is the convex hull of two spheres, scaled along one direction. Skeletons differ in their local axes
(Bandai-Namco's bones lie along X), so a direction such as "forward in the head's frame" is measured on the clip.
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
LARGEST = 1e6  # metres from the origin that are drawn
SMALLEST = 1e-6  # of a mannequin, where 1 is a person
ZERO = torch.zeros(3)
UP = torch.tensor([0.0, 1.0, 0.0])


@dataclass(frozen=True, eq=False)
class Bend:
    """The part of a shape's surface that follows another joint."""

    joint: int  # the other joint
    place: np.ndarray  # [3, 4], from the cone's own frame to that joint's, with the limb straight
    at: float  # metres along the cone's axis, where half of the surface follows the other joint
    width: float  # metres; at ``at + width`` all of it does


@dataclass(frozen=True, eq=False)
class Shape:
    """One rounded cone."""

    joint: int  # the joint it is fixed to
    place: np.ndarray  # [3, 4], from the cone's own frame (spheres at the origin and at +Y · length) to the joint's, metres
    length: float  # distance of the two spheres, metres
    radii: tuple[float, float]
    tone: str  # key of `COLORS`
    foot: str = ""  # "left" or "right" where contacts are shown
    bends: tuple[Bend, ...] = ()  # towards the joints beyond its ends, at most one each


def cone(joint: int, start: Tensor, end: Tensor, radii: tuple[float, float], tone: str, *, thin: Tensor | None = None,
         by: float = 1.0, foot: str = "") -> Shape:
    """Rounded cone from ``start`` to ``end`` [3] in the joint's frame, its thickness along ``thin`` scaled by ``by``."""
    start, end = (np.asarray(v, dtype=np.float64) for v in (start, end))
    length = np.linalg.norm(end - start)
    y = (end - start) / length if length > 1e-6 else np.eye(3)[1]
    across = np.eye(3)[np.abs(y).argmin()]
    z = across if thin is None else np.asarray(thin, dtype=np.float64)
    z = z - y * (y @ z)
    z = z if np.linalg.norm(z) > 1e-3 else np.cross(y, across)
    z = z / np.linalg.norm(z)
    length = max(float(length), 1.1 * abs(radii[0] - radii[1]), 1e-4)
    return Shape(joint, np.stack((np.cross(y, z), y, z * by, start), 1), length, tuple(map(float, radii)), tone, foot)


def _snap(v: Tensor) -> Tensor:
    """The signed coordinate axis nearest to a direction [3]."""
    i = v.abs().argmax()
    return torch.eye(3)[i] * v[i].sign()


class _Measured:
    """Directions and positions in the joints' own frames, averaged over a clip."""

    def __init__(self, clip: Clip):
        self.clip, self.skeleton = clip, clip.skeleton
        self.positions, self.rotations = clip.global_positions, clip.global_rotations
        facing = R.inverse(root_frames(clip).rotations)[:, None].expand(-1, len(clip.skeleton), -1)
        self.axes = R.to_matrix(R.multiply(facing, self.rotations)).mean(0)  # rows: the body's axes in joint coordinates
        self.legs = {j for side in SIDES for j in self.skeleton.ancestors(self.skeleton.role(f"{side}_foot"))}
        left, right = (self.skeleton.ancestors(self.skeleton.role(f"{side}_shoulder")) for side in ("left", "right"))
        self.spine = [j for j in left if j in right]  # from the chest down to the hips
        if (hips := self.skeleton.role("hips")) in self.spine:
            self.spine = self.spine[: self.spine.index(hips) + 1]
        hip, knee, foot = (self.skeleton.role(f"left_{part}") for part in ("hip", "knee", "foot"))
        self.scale = float(self.bone(hip, knee).norm() + self.bone(knee, foot).norm()) / LEG

    def children(self, joint: int) -> list[int]:
        return [j for j, p in enumerate(self.skeleton.parents) if p == joint]

    def bone(self, upper: int, lower: int) -> Tensor:
        """From a joint to one below it, in the frame of the upper one; twist bones may lie between."""
        if self.skeleton.parents[lower] == upper:
            return self.skeleton.offsets[lower]
        gap = self.positions[:, lower] - self.positions[:, upper]
        return R.rotate(R.inverse(self.rotations[:, upper]), gap).mean(0)

    def up(self, joint: int) -> Tensor:
        """Along the bones that continue a joint of the trunk, so that a bent spine has its own up direction."""
        along = sum((self.skeleton.offsets[j] for j in self.children(joint) if j not in self.legs), ZERO)
        return _snap(along if float(along.norm()) > 0.02 else self.axes[joint, 1])

    def forward(self, joint: int) -> Tensor:
        return _snap(self.axes[joint, 2] * (1 - self.up(joint).abs()))

    def onward(self, joint: int) -> Tensor:
        """Along the bones that continue any joint, else along the bone that ends there."""
        below = self.children(joint)
        offsets = self.skeleton.offsets[[j for j in below if j not in self.legs] or below].sum(0)
        return R.normalize(offsets if float(offsets.norm()) > 0.02 else self.skeleton.offsets[joint])

    def bend(self, shape: Shape, joint: int, width: float) -> Shape:
        """The shape with a bend towards the joint below or above its own, over ``width`` metres to either side.

        The limb counts as straight where the lower bone continues the upper one, with the clip's mean twist.
        """
        below = shape.joint in self.skeleton.ancestors(joint)
        lower, upper = (joint, shape.joint) if below else (shape.joint, joint)
        bone, local = self.bone(upper, lower), self.clip.rotations[:, lower]
        if self.skeleton.parents[lower] != upper:
            local = R.multiply(R.inverse(self.rotations[:, upper]), self.rotations[:, lower])
        local = R.unroll(local).mean(0)
        turn = R.normalize(local) if float(local.norm()) > 1e-3 else R.identity()
        turn = R.to_matrix(R.multiply(R.between(R.rotate(turn, self.onward(lower)), R.normalize(self.onward(upper))), turn))
        turn, bone = turn.double().numpy(), bone.double().numpy()
        shift = np.column_stack((np.zeros((3, 3)), bone))
        moved = turn.T @ (shape.place - shift) if below else turn @ shape.place + shift
        at = float((np.linalg.inv(shape.place[:, :3]) @ (below * bone - shape.place[:, 3]))[1])
        return replace(shape, bends=(*shape.bends, Bend(joint, moved, at, width if below else -width)))

    def palm(self, side: str) -> Tensor:
        """Direction of a palm in the hand's frame: the elbow's axis, or sideways for an arm that stays straight."""
        shoulder, elbow, hand = (self.skeleton.role(f"{side}_{part}") for part in ("shoulder", "elbow", "hand"))
        upper, lower = (self.positions[:, b] - self.positions[:, a] for a, b in ((shoulder, elbow), (elbow, hand)))
        axis = R.rotate(R.inverse(self.rotations[:, hand]), torch.linalg.cross(upper, lower)).mean(0)
        return R.normalize(axis if float(axis.norm()) > 1e-3 else self.axes[hand, 0])

    def pair(self, part: str, frame: int) -> tuple[Tensor, Tensor]:
        """Mean positions of the left and the right joint of that role, in the frame of another joint."""
        both = [self.positions[:, self.skeleton.role(f"{side}_{part}")] for side in SIDES]
        turn = R.inverse(self.rotations[:, frame])
        left, right = (R.rotate(turn, joint - self.positions[:, frame]).mean(0) for joint in both)
        return left, right

    def standing(self, foot: int, direction: Tensor, frame: int) -> Tensor:
        """World ``direction`` (broadcast [F, 3]) in a joint's frame, averaged over the frames in which the foot is low."""
        height = self.positions[:, foot, 1]
        low = height <= height.quantile(0.2)
        return R.normalize(R.rotate(R.inverse(self.rotations[low, frame]), direction.expand(len(height), 3)[low]).mean(0))


def has_roles(clip: Clip, *parts: str) -> bool:
    """Whether the skeleton has these parts on both sides, such as "hip" (see `toolkit.motion.ROLES`)."""
    return all(f"{side}_{part}" in clip.skeleton.roles for side in SIDES for part in parts)


_BUILT: WeakKeyDictionary[Clip, tuple[Shape, ...]] = WeakKeyDictionary()  # an entry lives as long as its clip


def build(clip: Clip) -> tuple[Shape, ...]:
    """The mannequin of a clip's skeleton; skeletons without hips, shoulders, elbows and feet get plain bones.

    ValueError if no bone is long enough to be drawn, or the motion is too large for numbers of 32 bits.
    """
    if clip not in _BUILT:
        reach = max(float(clip.skeleton.offsets.abs().max()), float(clip.root_positions.abs().max()))
        if reach > LARGEST:
            raise ValueError(f"{clip.name}: its positions reach {reach:.3g} m, and at most {LARGEST:g} m can be drawn; "
                             "the unit of length may be wrong (--unit)")
        if not (shapes := _build(clip)):
            raise ValueError(f"{clip.name}: no bone is long enough to be given a body")
        _BUILT[clip] = shapes
    return _BUILT[clip]


def _build(clip: Clip) -> tuple[Shape, ...]:
    if not has_roles(clip, "shoulder", "elbow", "hip", "foot"):
        return _bones(clip, set(), 1.0)
    m = _Measured(clip)
    if m.scale < SMALLEST:
        return _bones(clip, set(), 1.0)
    s, shapes, drawn = m.scale, [], set()
    for side in SIDES:
        for part in ("hip", "shoulder"):
            drawn.update(clip.skeleton.ancestors(clip.skeleton.role(f"{side}_{part}")))
        for build_limb in (_limb, _foot, _hand):
            shapes += build_limb(m, side, s, drawn)
    shapes += _torso(m, s) + _head(m, s, drawn)
    return (*shapes, *_bones(clip, drawn, s))


def _bones(clip: Clip, drawn: set[int], scale: float) -> tuple[Shape, ...]:
    """Plain capsules for the joints that are not drawn yet: fingers, tails, props, other creatures."""
    shapes = []
    for j, p in enumerate(clip.skeleton.parents):
        length = float(clip.skeleton.offsets[j].norm())
        if p >= 0 and j not in drawn and length > 0.008:
            r = min(max(0.16 * length, 0.008), 0.045 * scale)
            shapes.append(cone(p, ZERO, clip.skeleton.offsets[j], (r, 0.8 * r), "middle"))
    return tuple(shapes)


def _limb(m: _Measured, side: str, s: float, drawn: set[int]) -> list[Shape]:
    shapes = []
    for upper, lower in (("hip", "knee"), ("knee", "foot"), ("shoulder", "elbow"), ("elbow", "hand")):
        a, b = m.skeleton.role(f"{side}_{upper}"), m.skeleton.role(f"{side}_{lower}")
        bone, (r0, r1) = m.bone(a, b), RADII[upper]
        flesh = cone(a, 0.06 * bone, 0.94 * bone, (r0 * s, r1 * s), side)
        if lower != "foot":  # a foot does not continue its shin
            flesh = m.bend(flesh, b, 0.1 * s if lower == "hand" else 1.6 * r1 * s)
        if upper in ("knee", "elbow"):
            flesh = m.bend(flesh, m.skeleton.parents[a], 1.6 * r0 * s)
        shapes += [flesh, cone(b, ZERO, ZERO, (1.04 * r1 * s,) * 2, "joint")]
        drawn.update((a, b), m.skeleton.ancestors(b))
    shoulder = m.skeleton.role(f"{side}_shoulder")
    collar, bone = m.skeleton.parents[shoulder], m.skeleton.offsets[shoulder]
    return [*shapes, cone(shoulder, ZERO, ZERO, (0.056 * s,) * 2, "joint"),
            cone(collar, ZERO, 0.86 * bone, (0.046 * s, 0.05 * s), "middle")]


def _foot(m: _Measured, side: str, s: float, drawn: set[int]) -> list[Shape]:
    ankle = m.skeleton.role(f"{side}_foot")
    if f"{side}_toe" not in m.skeleton.roles:
        return []
    toe = m.skeleton.role(f"{side}_toe")
    to_toe = m.skeleton.offsets[toe]
    up = m.standing(ankle, UP, ankle)
    forward = R.normalize(to_toe - up * (up @ to_toe))
    r0, r1 = 0.038 * s, 0.036 * s
    rise = float(m.positions[:, toe, 1].quantile(0.05).clamp(0.0, 0.05 * s))  # of the joint above the sole
    sole = float(up @ to_toe) - rise
    heel = up * (sole + r0) - 0.012 * s * forward
    ball_of_foot = to_toe + up * (r1 - rise)
    flat = m.standing(ankle, UP, toe)
    ahead = m.standing(ankle, R.rotate(m.rotations[:, ankle], forward.expand(len(m.positions), 3)), toe)
    end = 0.038 * s * ahead + flat * (0.027 * s - rise)
    drawn.update(m.children(ankle) + m.children(toe))
    return [
        cone(ankle, ZERO, 0.75 * ball_of_foot, (0.042 * s, 0.034 * s), side, foot=side),
        cone(ankle, heel, ball_of_foot, (r0, r1), side, foot=side),
        cone(toe, flat * (r1 - rise), end, (0.99 * r1, 0.027 * s), side, foot=side),
    ]


def _hand(m: _Measured, side: str, s: float, drawn: set[int]) -> list[Shape]:
    hand = m.skeleton.role(f"{side}_hand")
    end = next((j for j in m.children(hand) if m.skeleton.is_end(j)), hand)
    bone = m.skeleton.offsets[end if float(m.skeleton.offsets[end].norm()) > 0.02 else hand]
    along, r = R.normalize(bone), 0.043 * s
    drawn.add(end)
    return [cone(hand, 0.035 * s * along, 0.13 * s * along, (r, 0.75 * r), side, thin=m.palm(side), by=0.55)]


def _torso(m: _Measured, s: float) -> list[Shape]:
    hips, chest = m.skeleton.role("hips"), m.spine[0]
    a, b = m.pair("hip", hips)
    middle, half = (a + b) / 2 + 0.025 * s * m.up(hips), 0.062 * s * R.normalize(a - b)
    shapes = [cone(hips, middle + half, middle - half, (0.1 * s,) * 2, "middle", thin=m.forward(hips), by=0.9)]
    for upper, lower in pairwise(m.spine):
        part = cone(lower, ZERO, m.skeleton.offsets[upper], (0.088 * s, 0.092 * s), "joint", thin=m.forward(lower), by=0.86)
        part = m.bend(part, upper, 0.07 * s)
        shapes.append(part if lower == hips else m.bend(part, m.skeleton.parents[lower], 0.07 * s))
    a, b = m.pair("shoulder", chest)
    wide = min(max(0.39 * float((a - b).norm()), 0.125 * s), 0.152 * s)
    top = (a + b) / 2 - m.up(chest) * 0.6 * wide
    bottom = top - m.up(chest) * 0.17 * s
    ribs = cone(chest, bottom, top, (0.76 * wide, wide), "middle", thin=m.forward(chest), by=0.74)
    return [*shapes, m.bend(ribs, m.skeleton.parents[chest], 0.07 * s) if chest != hips else ribs]


def _head(m: _Measured, s: float, drawn: set[int]) -> list[Shape]:
    skeleton = m.skeleton
    head = next((j for j, n in enumerate(skeleton.names) if "head" in n.lower() and not skeleton.is_end(j)), None)
    if head is None:
        return []
    shapes, j = [], head
    while j not in m.spine and j > 0:  # the neck, down to the chest
        p = skeleton.parents[j]
        last = p in m.spine  # the lowest part widens into the shoulders
        start, r0, tone = (0.45, 0.088, "middle") if last and j != head else (0.0, 0.05, "joint")
        neck = cone(p, start * skeleton.offsets[j], skeleton.offsets[j], (r0 * s, 0.05 * s), tone)
        neck = neck if last else m.bend(neck, skeleton.parents[p], 0.04 * s)
        shapes.append(m.bend(neck, j, 0.04 * s))
        drawn.add(j)
        j = p
    drawn.update(m.children(head))
    up, forward = m.up(head), m.forward(head)
    left, eyes = torch.linalg.cross(up, forward), (0.096 * up + 0.072 * forward) * s
    skull = cone(head, (0.045 * up + 0.022 * forward) * s, (0.118 * up + 0.008 * forward) * s, (0.068 * s, 0.09 * s),
                 "middle", thin=left, by=0.86)
    face = cone(head, eyes + 0.026 * s * left, eyes - 0.026 * s * left, (0.032 * s,) * 2, "face", thin=up, by=0.7)
    return [*shapes, skull, face]


def colors(shapes: tuple[Shape, ...], contacts: np.ndarray | None = None) -> np.ndarray:
    """Colour of every shape [S, 3], 0 to 1; feet (right, left) in contact by ``contacts`` [2] have a colour of their own."""
    table = np.array([to_rgb(COLORS[s.tone]) for s in shapes])
    if contacts is not None:
        table[[bool(s.foot and contacts[FEET.index(s.foot)]) for s in shapes]] = to_rgb(CONTACT)
    return table


def placements(shapes: tuple[Shape, ...], rotations: Tensor, positions: Tensor) -> np.ndarray:
    """World placement ``[..., S, 3, 4]`` of shapes, from global rotations ``[..., J, 4]`` and positions ``[..., J, 3]``."""
    return place([s.joint for s in shapes], [s.place for s in shapes], rotations, positions)


def place(joints, local, rotations: Tensor, positions: Tensor) -> np.ndarray:
    """World placement ``[..., *N, 3, 4]`` of frames ``local`` [*N, 3, 4] that are fixed to ``joints`` [*N]."""
    world = R.to_matrix(rotations[..., joints, :]) @ torch.from_numpy(np.array(local)).float()
    world[..., 3] += positions[..., joints, :]
    return world.numpy()


def bounds(shapes: tuple[Shape, ...], places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Lowest and highest coordinates [3] that shapes at ``places`` [..., S, 3, 4] reach."""
    ends = np.stack((places[..., 3], places[..., 3] + places[..., 1] * np.array([[s.length] for s in shapes])), -2)
    radii = np.array([s.radii for s in shapes])[..., None]
    axes = tuple(range(ends.ndim - 1))
    return (ends - radii).min(axes), (ends + radii).max(axes)
