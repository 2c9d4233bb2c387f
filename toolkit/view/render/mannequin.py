"""A wooden mannequin that fits any skeleton, used by every renderer and by glTF export.

Each part is a rounded cone that follows one joint, in the joint's own axes, so that no bind pose is
needed. Where a part lies on its joint follows from the next joint, and from where up and ahead are:
those of a skeleton whose zero rotations stand upright, or else means over the clip, and the floor
under a standing foot. Lengths are in metres of a body whose legs are `LEG` long.
"""

import copy
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import torch

from toolkit.motion import Clip, Skeleton, rotations as R
from toolkit.motion.clip import root_frames
from toolkit.motion.roles import SIDES
from toolkit.motion.skeleton import FEET
from toolkit.view.render.skin import SLOTS, Skin

LEG = 0.87  # hip to ankle in metres of the body that the lengths below are written for
COLORS = {"left": "#6a9fcb", "right": "#e39a6c", "middle": "#ebe6dd", "joint": "#46505c",
          "face": "#2b323b"}
CONTACT = "#35c46a"
# Styles and curves, in order.
PALETTE = ("#7b68c4", "#2fa596", "#d6598b", "#c9a227", "#5b8def", "#8a8f98")
LARGEST = 1e6  # metres from the origin that are drawn
TALL = 1.8  # metres: the height of other creatures, whose bones are as thick as a person's
VERTICES = 6000  # about as many, for a body of any shape
SAMPLES = 120  # frames of a clip from which places are read
LIMBS = ("hip", "knee", "foot", "shoulder", "elbow", "hand")


def rgb(color: str) -> np.ndarray:
    """Red, green and blue [3], 0 to 1, of a colour such as "#6a9fcb"."""
    return np.frombuffer(bytes.fromhex(color[1:]), np.uint8) / 255


TABLE = np.array([rgb(color) for color in COLORS.values()])  # [len(COLORS), 3]


@dataclass(frozen=True, eq=False)
class Mannequin:
    """The body of a skeleton."""

    skin: Skin
    tones: np.ndarray  # [V, len(COLORS)] share of each colour
    feet: np.ndarray  # [V, 2] share of the right and the left foot
    light: np.ndarray  # [V] ambient light, 0 to 1

    def colors(self, contacts: np.ndarray | None = None) -> np.ndarray:
        """Colour of every vertex [V, 3], 0 to 1.

        Feet (right, left) in contact by ``contacts`` [2] have a colour of their own.
        """
        found = self.tones @ TABLE
        if contacts is not None:
            shares = (self.feet @ np.asarray(contacts, float))[:, None]
            found += shares * (rgb(CONTACT) - found)
        return found * self.light[:, None]

    def packed(self, skeleton: Skeleton) -> dict:
        """The body as the browser's scene takes it (``scene/body.js`` describes the format)."""
        trunk = self.tones[:, [list(COLORS).index("middle")]]
        marks = np.concatenate((self.feet[:, ::-1], trunk, self.light[:, None]), 1)
        return self.skin.packed(skeleton, 255 * self.colors(), marks) | {
            "own": False, "follow": None
        }


@dataclass(frozen=True, eq=False)
class Part:
    """A rounded cone in a joint's axes: the hull of two spheres, pressed flat in a direction."""

    joint: int
    start: np.ndarray  # [3] metres
    end: np.ndarray
    radii: tuple[float, float]
    tone: str  # of `COLORS`
    thin: np.ndarray | None = None  # direction in which it is pressed flat,
    by: float = 1.0  # to this share of its thickness
    foot: str = ""  # "left" or "right" where contacts are shown

    def mesh(self, around: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Vertices and normals [V, 3], triangles [T, 3], and light [V], which is less at the ends.

        It has ``around`` vertices in a ring.
        """
        # y along the part, z where it is pressed flat
        length = np.linalg.norm(self.end - self.start)
        y = (self.end - self.start) / length if length > 1e-6 else np.array([0.0, 1.0, 0.0])
        z = self.thin
        if z is None or np.linalg.norm(np.cross(y, z)) < 1e-3:
            z = np.eye(3)[np.abs(y).argmin()]
        x = _unit(np.cross(y, z))
        axes = np.stack((x, y, np.cross(x, y)))

        # a half sphere at each end; the rings where they begin lie where the cone touches them
        slope = np.clip((self.radii[0] - self.radii[1]) / max(length, 1e-9), -0.9, 0.9)
        tilt, rings = np.arcsin(slope), max(1, around // 4)
        heights = np.concatenate((np.linspace(-np.pi / 2, tilt, rings + 1),
                                  np.linspace(tilt, np.pi / 2, rings + 1)))
        radii = np.repeat(self.radii, rings + 1)
        angles = 2 * np.pi * np.arange(around) / around
        ring = np.stack((np.cos(angles), 0 * angles, np.sin(angles)), -1)
        normals = (np.cos(heights)[:, None, None] * ring
                   + np.sin(heights)[:, None, None] * [0.0, 1.0, 0.0])
        points = radii[:, None, None] * normals
        points[rings + 1 :, :, 1] += length
        points[..., 2] *= self.by
        normals[..., 2] /= self.by

        rows, columns = np.meshgrid(np.arange(2 * rings + 1), np.arange(around), indexing="ij")
        a, b = rows * around + columns, rows * around + (columns + 1) % around
        quads = np.stack((a, a + around, b, b, a + around, b + around), -1)
        normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
        light = np.repeat(1 - 0.22 * np.abs(np.sin(heights)) ** 3, around)
        return (points.reshape(-1, 3) @ axes + self.start, normals.reshape(-1, 3) @ axes,
                quads.reshape(-1, 3), light)


def build(clip: Clip, vertices: int = VERTICES) -> Mannequin:
    """The mannequin of a clip's skeleton; skeletons that are no humanoids get plain bones.

    It has about as many ``vertices``. ValueError if no bone is long enough for a body, or the
    motion too large for numbers of 32 bits.
    """
    reach = max(float(clip.skeleton.offsets.abs().max()), float(clip.root_positions.abs().max()))
    if reach > LARGEST:
        raise ValueError(f"{clip.name}: its positions reach {reach:.3g} m, and at most "
                         f"{LARGEST:g} m can be drawn; the unit of length may be wrong (--unit)")
    parts = _humanoid(clip) if clip.skeleton.has(*LIMBS, "toe") else []
    parts += _bones(clip, {part.joint for part in parts})
    if not parts:
        raise ValueError(f"{clip.name}: no bone is long enough to be given a body")
    # a part has a² / 2 + 2 a vertices for a ring of a, and thick parts have larger rings
    ring = np.sqrt([max(part.radii) for part in parts])
    ring *= np.sqrt(2 * vertices / (ring**2).sum())
    meshes = [part.mesh(max(4, round(a - 2))) for part, a in zip(parts, ring, strict=True)]
    counts = [len(points) for points, *_ in meshes]
    points, normals, triangles, light = map(np.concatenate, zip(*meshes, strict=True))
    # the triangles of a part count its own vertices
    first = np.cumsum([0, *counts[:-1]])
    triangles += np.repeat(first, [len(mesh[2]) for mesh in meshes])[:, None]
    joints, weights = (np.zeros((len(points), SLOTS), t) for t in (int, np.float32))
    joints[:, 0], weights[:, 0] = np.repeat([part.joint for part in parts], counts), 1.0
    inverse = np.tile(np.eye(3, 4), (len(clip.skeleton), 1, 1))
    skin = Skin(points.astype(np.float32), normals.astype(np.float32), triangles, joints, weights,
                inverse)
    tones = np.eye(len(COLORS))[np.repeat([list(COLORS).index(p.tone) for p in parts], counts)]
    feet = np.array([[part.foot == side for side in FEET] for part in parts], float)
    return Mannequin(skin, tones, np.repeat(feet, counts, axis=0), light)


def _bones(clip: Clip, drawn: set[int]) -> list[Part]:
    """Plain rounded bones for joints without a part: fingers, tails, props, other creatures.

    A humanoid's short bones that are no fingers, such as those of a face, are left out.
    """
    skeleton, offsets = clip.skeleton, clip.skeleton.offsets.double().numpy()
    fingers, toes = set(), set()
    for side in SIDES if drawn else ():
        fingers.update(skeleton.tree.below(skeleton.role(f"{side}_hand")))
        toes.update(skeleton.tree.below(skeleton.role(f"{side}_foot")))
    scale = max(float(np.ptp(skeleton.rest_positions.numpy(), axis=0).max()) / TALL, 1e-6)
    parts = []
    for j, parent in enumerate(skeleton.parents[1:], 1):
        length = float(np.linalg.norm(offsets[j]))
        least = 0.06 * scale if drawn and j not in fingers else 0.008
        known = parent in drawn and (j in drawn or skeleton.is_end(j))
        if j not in toes and length > least and not known:
            r = min(0.16 * length, (0.045 if drawn else 0.06) * scale)
            r = max(r, 0.008) if drawn else r
            parts.append(Part(parent, np.zeros(3), offsets[j], (r, 0.8 * r), "middle"))
    return parts


class _Places:
    """Mean places and directions in the axes of joints, over frames of a clip.

    Their unit of length is ``scale`` metres.
    """

    def __init__(self, clip: Clip):
        count = min(len(clip), SAMPLES)
        frames = torch.linspace(0, len(clip) - 1, count).round().long()
        clip = clip.to("cpu", torch.float64)
        self.clip, self.role = clip, clip.skeleton.role
        self.axes = R.to_matrix(clip.global_rotations[frames]).numpy()
        self.joints = clip.global_positions[frames].numpy()
        turned = R.to_matrix(root_frames(clip).rotations[frames]).numpy()
        self.body = dict(zip(("left", "up", "ahead"), np.moveaxis(turned, -1, 0), strict=True))
        self.used, self.scale = np.arange(count), 1.0
        self.rest = self._standing()

    def _standing(self) -> dict[str, np.ndarray]:
        """Left, up and ahead [3] of the zero rotations; empty if these are no standing figure."""
        places = self.clip.skeleton.rest_positions.double().numpy()
        up, bones = np.array([0.0, 1.0, 0.0]), []
        for side in SIDES:
            hip, foot, shoulder = (places[self.role(f"{side}_{p}")]
                                   for p in ("hip", "foot", "shoulder"))
            bones += [hip - foot, shoulder - hip]
        across = places[self.role("left_hip")] - places[self.role("right_hip")]
        if min(_unit(bone) @ up for bone in bones) < 0.9 or abs(_unit(across) @ up) > 0.1:
            return {}
        left = _unit(across * [1.0, 0.0, 1.0])
        return {"left": left, "up": up, "ahead": np.cross(left, up)}

    def place(self, joint: int, points: np.ndarray) -> np.ndarray:
        """Mean place [3] of points ``[F, 3]`` in the axes of a joint."""
        away = (points - self.joints[:, joint])[self.used] / self.scale
        return np.einsum("fji,fj->i", self.axes[self.used, joint], away) / len(self.used)

    def joint(self, joint: int, other: int) -> np.ndarray:
        """Mean place [3] of another joint."""
        return self.place(joint, self.joints[:, other])

    def along(self, joint: int, direction: str) -> np.ndarray:
        """Where left, up or ahead of the body is, of length 1."""
        if self.rest:
            return self.rest[direction]
        return _unit(self.place(joint, self.joints[:, joint] + self.body[direction]))

    def moved(self, joint: int, point: np.ndarray, other: int) -> np.ndarray:
        """A place [3] in the axes of a joint, in those of another."""
        return self.place(other, self.axes[:, joint] @ (self.scale * point)
                          + self.joints[:, joint])


def _unit(vector: np.ndarray) -> np.ndarray:
    return vector / max(np.linalg.norm(vector), 1e-9)


def _humanoid(clip: Clip) -> list[Part]:
    found = _Places(clip)
    role, none = found.role, np.zeros(3)
    hip, knee, foot = (role(f"left_{part}") for part in LIMBS[:3])
    leg = np.linalg.norm(found.joint(hip, knee)) + np.linalg.norm(found.joint(knee, foot))
    found.scale = s = leg / LEG
    if s < 1e-6:
        return []
    parts: list[Part] = []

    def put(joint: int, start: np.ndarray, end: np.ndarray, radii: Sequence[float], tone: str,
            **more) -> None:
        parts.append(Part(joint, s * start, s * end, (s * radii[0], s * radii[1]), tone, **more))

    _trunk(found, put)
    for side in SIDES:
        hip, knee, foot, shoulder, elbow, hand = (role(f"{side}_{part}") for part in LIMBS)
        # thigh, shin, upper arm, forearm, each with the ball at its start
        for joint, end, ball, radii, tone in (
                (hip, knee, 0.08, (0.073, 0.047), side), (knee, foot, 0.046, (0.05, 0.03), side),
                (shoulder, elbow, 0.05, (0.043, 0.034), side),
                (elbow, hand, 0.034, (0.036, 0.024), side)):
            bone = found.joint(joint, end)
            put(joint, none, none, (ball, ball), "joint")
            put(joint, 0.1 * bone, 0.93 * bone, radii, tone)
        put(hand, none, none, (0.026, 0.026), "joint")
        put(foot, none, none, (0.034, 0.034), "joint", foot=side)
        _hand(found, side, put)
        _foot(found, side, put)
    return parts


def _trunk(found: _Places, put) -> None:
    """Pelvis, waist, chest, shoulders, neck and head."""
    role, skeleton = found.role, found.clip.skeleton
    hips, spine = role("hips"), skeleton.trunk[::-1]
    ahead = found.along(hips, "ahead")
    sides = [found.joint(hips, role(f"{side}_hip")) for side in SIDES]
    middle = sum(sides) / 2
    up = _unit(found.joint(hips, spine[1]) - middle) if len(spine) > 1 else found.along(hips, "up")
    for side, hip in zip(SIDES, sides, strict=True):
        out = hip - middle
        put(hips, middle + 0.25 * out + 0.035 * up, middle + 0.7 * out + 0.015 * up,
            (0.102, 0.07), side, thin=ahead, by=0.92)

    chest = spine[-1]
    shoulders = [found.joint(chest, role(f"{side}_shoulder")) for side in SIDES]
    top, ahead = sum(shoulders) / 2, found.along(chest, "ahead")
    across = np.linalg.norm(shoulders[0] - shoulders[1])
    width = min(max(0.37 * across, 0.125), 0.15)
    for lower, upper in pairwise(spine):
        put(lower, np.zeros(3), found.joint(lower, upper), (0.104, 0.1), "middle",
            thin=found.along(lower, "ahead"), by=0.78)
    up = found.along(chest, "up") if found.rest else _unit(top)
    put(chest, top - 0.25 * up, top - 0.8 * width * up, (0.84 * width, width), "middle",
        thin=ahead, by=0.74)
    for side, shoulder in zip(SIDES, shoulders, strict=True):
        collar = skeleton.parents[role(f"{side}_shoulder")]
        inner = top + 0.3 * (shoulder - top) - 0.01 * up
        ends = [found.moved(chest, point, collar)
                for point in (inner, top + 0.9 * (shoulder - top))]
        put(collar, *ends, (0.056, 0.05), "middle")

    neck = skeleton.neck
    if len(neck) < 2:
        return
    for lower, upper in pairwise(neck):
        end = found.joint(lower, upper)
        put(lower, (0.35 if lower == neck[0] else 0.0) * end, end, (0.046, 0.042), "middle")
    head = neck[-1]
    up, left = found.along(head, "up"), found.along(head, "left")
    if not found.rest:  # a head that is always bowed shows in the neck
        up = _unit(up + _unit(found.place(head, 2 * found.joints[:, head]
                                          - found.joints[:, neck[-2]])))
    ahead = np.cross(left, up)
    put(head, 0.045 * up + 0.03 * ahead, 0.122 * up + 0.012 * ahead, (0.064, 0.09), "middle",
        thin=left, by=0.86)
    eyes = 0.104 * up + 0.076 * ahead
    put(head, eyes - 0.03 * left, eyes + 0.03 * left, (0.033, 0.033), "face", thin=up, by=0.75)


def _hand(found: _Places, side: str, put) -> None:
    """A mitten with a thumb, flat across the palm; the fingers of a rig are bones of their own."""
    role, children = found.role, found.clip.skeleton.tree.children
    elbow, hand = role(f"{side}_elbow"), role(f"{side}_hand")
    out = _unit(found.place(hand, 2 * found.joints[:, hand] - found.joints[:, elbow]))
    ahead, palm = found.along(hand, "ahead"), found.along(hand, "left")
    palm = _unit(palm - (palm @ out) * out)
    thumb = np.cross(out, palm)
    thumb *= np.sign(thumb @ ahead) or 1.0
    put(hand, 0.03 * out, 0.085 * out, (0.03, 0.039), "middle", thin=palm, by=0.55)
    if sum(bool(children[j]) for j in children[hand]) < 3:
        put(hand, 0.09 * out, 0.155 * out, (0.037, 0.024), "middle", thin=palm, by=0.5)
        put(hand, 0.04 * out + 0.026 * thumb, 0.085 * out + 0.05 * thumb, (0.015, 0.011),
            "middle")


def _foot(found: _Places, side: str, put) -> None:
    """Heel, instep and toes; the sole is the floor in the frames where the foot is lowest."""
    ankle, toe = (found.role(f"{side}_{part}") for part in ("foot", "toe"))
    heights = found.joints[:, [ankle, toe], 1] / found.scale
    total = heights.sum(1)
    found = copy.copy(found)
    found.used = np.flatnonzero(total <= np.quantile(total, 0.1))
    up, at = found.along(ankle, "up"), np.zeros(3)
    ankle_height, toe_height = np.median(heights[found.used], axis=0)
    ball = found.joint(ankle, toe)
    ahead = ball - (ball @ up) * up
    if np.linalg.norm(ahead) < 0.03:  # no toe, or one below the ankle
        toe, ahead = ankle, found.along(ankle, "ahead")
        ball = 0.12 * _unit(ahead - (ahead @ up) * up)
        sole = -min(max(ankle_height, 0.05), 0.12)
    else:
        sole = ball @ up - min(max(toe_height, 0.01), 0.05)
    ahead = _unit(ahead)
    left = np.cross(up, ahead)
    ball = ball + up * (sole - ball @ up)
    heel = up * sole - 0.03 * ahead
    put(ankle, heel + 0.036 * up, ball + 0.03 * up, (0.036, 0.034), side, foot=side)
    put(ankle, at, 0.72 * ball + 0.012 * up, (0.036, 0.034), side, foot=side)
    put(ankle, at, heel + 0.045 * up, (0.035, 0.034), side, foot=side)
    inside = heel / 2 + 0.035 * ahead
    put(ankle, inside, (inside + ball) / 2 + 0.015 * up, (0.036, 0.034), side, foot=side)
    for sign, length in ((1, 0.05), (-1, 0.042)):
        ends = (ball + 0.016 * sign * left + 0.027 * up,
                ball + length * ahead + 0.013 * sign * left + 0.022 * up)
        put(toe, *(found.moved(ankle, point, toe) for point in ends), (0.027, 0.022), side,
            foot=side)
