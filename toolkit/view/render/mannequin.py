"""A mannequin that fits any skeleton: one smooth skinned surface, used by every renderer and by
glTF export.

It is modelled in a bind pose: limbs stretched, arms and legs spread, feet flat, facing +z. A
humanoid's comes from `toolkit.motion.anatomy`, so that its local axes and its pose of zero
rotations do not matter; that of another creature is the first frame of the clip. Flesh is rounded
cones (`toolkit.view.render.surface`), in metres of a body whose legs are `LEG` long.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from itertools import pairwise

import numpy as np
import torch
from matplotlib.colors import to_rgb

from toolkit.motion import Clip, Skeleton, anatomy, forward_kinematics, rotations as R
from toolkit.motion.clip import FEET, SIDES
from toolkit.view.render.skin import Skin, strongest
from toolkit.view.render.surface import Cone, Field, Part, polygonise

LEG = 0.87  # hip to ankle in metres of the body that the radii below are written for
COLORS = {
    "left": "#6a9fcb",
    "right": "#e39a6c",
    "middle": "#ebe6dd",
    "joint": "#46505c",
    "face": "#2b323b",
}
CONTACT = "#35c46a"
TINT = 0.55  # share of the own colour of a character in a crowd
# Styles and curves, in order.
PALETTE = ("#7b68c4", "#2fa596", "#d6598b", "#c9a227", "#5b8def", "#8a8f98")
PARTS = {  # in the order in which they are joined
    "trunk": Part(0.06, 0.0),
    "legs": Part(0.008, 0.05),
    "feet": Part(0.045, 0.04),
    "arms": Part(0.008, 0.05),
    "hands": Part(0.02, 0.025),
    "neck": Part(0.02, 0.05),
    "head": Part(0.03, 0.02),
    "bones": Part(0.01, 0.02),
}
SPREAD = {"arm": 50.0, "leg": 9.0}  # degrees from the T-pose: arms downwards, legs outwards
GROWN = {"hand": 2.7, "foot": 1.4, "head": 1.8}  # modelled so many times larger, for finer polygons
# Across, length, degrees.
FINGERS = ((0.032, 0.074, 17), (0.0105, 0.084, 6), (-0.0105, 0.078, -6), (-0.031, 0.06, -17))
# Metres over which vertices near two joints follow both, and over which colours change.
SHARES, TONES = 0.012, 0.004
LARGEST = 1e6  # metres from the origin that are drawn
TALL = 1.8  # metres: other creatures are modelled at this size
VERTICES = 3700  # about as many, for a body of any shape
TABLE = np.array([to_rgb(color) for color in COLORS.values()])  # [len(COLORS), 3]


@dataclass(frozen=True, eq=False)
class Mannequin:
    """The body of a skeleton."""

    skin: Skin
    tones: np.ndarray  # [V, len(COLORS)] share of each colour
    feet: np.ndarray  # [V, 2] share of the right and the left foot
    light: np.ndarray  # [V] ambient light, 0 to 1

    def colors(self, contacts: np.ndarray | None = None,
               tint: np.ndarray | None = None) -> np.ndarray:
        """Colour of every vertex [V, 3], 0 to 1.

        Feet (right, left) in contact by ``contacts`` [2] have a colour of their own. A ``tint`` [3]
        is mixed into all colours.
        """
        found = self.tones @ TABLE
        if tint is not None:
            found = (1 - TINT) * found + TINT * tint
        if contacts is not None:
            shares = (self.feet @ np.asarray(contacts, float))[:, None]
            found += shares * (np.array(to_rgb(CONTACT)) - found)
        return found * self.light[:, None]

    def packed(self, skeleton: Skeleton) -> dict:
        """The body as the browser's scene takes it (``scene/body.js`` describes the format)."""
        trunk = self.tones[:, [list(COLORS).index("middle")]]
        marks = np.concatenate((self.feet[:, ::-1], trunk, self.light[:, None]), 1)
        return self.skin.packed(skeleton, 255 * self.colors(), marks) | {
            "own": False, "follow": None
        }


def has_roles(clip: Clip, *parts: str) -> bool:
    """Whether the skeleton has these parts on both sides, such as "hip" (see
    `toolkit.motion.ROLES`).
    """
    return all(f"{side}_{part}" in clip.skeleton.roles for side in SIDES for part in parts)


def build(clip: Clip, vertices: int = VERTICES) -> Mannequin:
    """The mannequin of a clip's skeleton; skeletons that are no humanoids get plain bones.

    It has about as many ``vertices``.

    Raises
    ------
    ValueError
        If no bone is long enough for a body, or the motion too large for numbers of 32 bits.
    """
    reach = max(float(clip.skeleton.offsets.abs().max()), float(clip.root_positions.abs().max()))
    if reach > LARGEST:
        raise ValueError(
            f"{clip.name}: its positions reach {reach:.3g} m, and at most {LARGEST:g} m can be "
            "drawn; the unit of length may be wrong (--unit)"
        )
    return _build(_Pose.of(clip), vertices)


@dataclass(frozen=True, eq=False)
class _Pose:
    """The bind pose of a skeleton; poses that have the same body are equal."""

    name: str  # of a clip, for errors
    skeleton: Skeleton
    places: np.ndarray  # [J, 3] of the joints, metres
    turned: np.ndarray  # [J, 3, 3] their axes
    # Joint of a humanoid -> left, up and forward [3, 3] there, as columns.
    body: dict[int, np.ndarray]
    neck: list[int]  # from the chest to the head
    rises: tuple[float, ...]  # height of the left and right toe above the sole, metres

    @classmethod
    def of(cls, clip: Clip) -> "_Pose":
        clip = clip.to("cpu", torch.float32)
        try:
            found = anatomy.measure(clip)
        except ValueError:
            turned, places = forward_kinematics(clip.skeleton, clip.rotations[0], torch.zeros(3))
            axes = R.to_matrix(turned).double().numpy()
            return cls(clip.name, clip.skeleton, places.double().numpy(), axes, {}, [], ())
        skeleton, tilts = found.skeleton, {}
        for side, sign in zip(SIDES, (1.0, -1.0), strict=True):
            for kind, degrees in (("arm", -SPREAD["arm"]), ("leg", SPREAD["leg"])):
                turn = R.from_axis_angle(
                    torch.tensor([0.0, 0.0, 1.0]), torch.tensor(np.radians(sign * degrees)).float()
                )
                tilts |= {
                    joint: turn
                    for part, joint in anatomy.limb(skeleton, side, kind).items()
                    if part != "collar"
                }
        turned, body = [], {}
        for j, parent in enumerate(skeleton.parents):
            if j in found.axes:
                tilt = tilts.get(j, R.identity(1)[0])
                turned.append(R.multiply(tilt, R.inverse(found.axes[j].float())))
                body[j] = R.to_matrix(tilt).double().numpy()
            else:
                turned.append(
                    found.rest[j].float()
                    if parent < 0
                    else R.multiply(turned[parent], found.rest[j].float())
                )
        turned = torch.stack(turned)
        local = torch.cat(
            (turned[:1], R.multiply(R.inverse(turned[list(skeleton.parents[1:])]), turned[1:]))
        )
        places = forward_kinematics(skeleton, local, torch.zeros(3))[1].double().numpy()
        rises = tuple(_rise(clip, skeleton.role(f"{side}_toe")) for side in SIDES)
        axes = R.to_matrix(turned).double().numpy()
        return cls(clip.name, skeleton, places, axes, body, found.neck, rises)

    @cached_property
    def key(self) -> tuple:
        numbers = np.concatenate((self.places.ravel(), self.turned.ravel(), self.rises))
        rounded = (200 * numbers).round().astype(int).tobytes()
        return self.skeleton.names, self.skeleton.parents, tuple(self.neck), rounded

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Pose) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)


def _rise(clip: Clip, toe: int) -> float:
    """Height of a toe, or of an ankle without toe, above the sole.

    That of its lowest frames, in whole centimetres.
    """
    return round(float(clip.global_positions[:, toe, 1].quantile(0.05).clamp(0.0, 0.12)), 2)


@lru_cache(maxsize=16)
def _build(pose: _Pose, vertices: int) -> Mannequin:
    cones, scale = (
        _humanoid(pose)
        if pose.body
        else ([], max(float(np.ptp(pose.places, axis=0).max()) / TALL, 1e-6))
    )
    cones += _bones(pose, {cone.joint for cone in cones}, scale)
    if not cones:
        raise ValueError(f"{pose.name}: no bone is long enough to be given a body")
    pivots = _pivots(pose)
    model = [_grown(cone, *pivots[cone.joint], scale) for cone in cones]
    field = Field(model, PARTS)
    area = sum(
        np.pi * (2 * np.linalg.norm(c.end - c.start) + sum(c.radii)) * sum(c.radii) * (1 + c.by) / 2
        for c in model
    )
    points, normals, triangles = polygonise(field, (0.45 * area / vertices) ** 0.5)
    light = field.openness(points, normals)
    near = field.each(points)
    near -= near.min(1, keepdims=True)
    weights = np.zeros((len(points), len(pose.skeleton)))
    for i, cone in enumerate(cones):
        weights[:, cone.joint] = np.maximum(weights[:, cone.joint], np.exp(-near[:, i] / SHARES))
    joints, weights = strongest(weights)
    tones, feet = np.zeros((len(points), len(COLORS))), np.zeros((len(points), 2))
    for i, cone in enumerate(cones):
        share, tone = np.exp(-near[:, i] / TONES), list(COLORS).index(cone.tone)
        tones[:, tone] = np.maximum(tones[:, tone], share)
        if cone.foot:
            feet[:, FEET.index(cone.foot)] = np.maximum(feet[:, FEET.index(cone.foot)], share)
    factors, centres = (np.array([pivots[j][i] for j in range(len(pose.skeleton))]) for i in (0, 1))
    points *= scale
    back = (1 / factors[joints] - 1)[..., None] * (points[:, None] - centres[joints])
    points = points + (weights[..., None] * back).sum(1)
    inverse = np.concatenate(
        (pose.turned.swapaxes(1, 2), -pose.turned.swapaxes(1, 2) @ pose.places[..., None]), 2
    )
    skin = Skin(
        points.astype(np.float32), normals.astype(np.float32), triangles, joints, weights, inverse
    )
    feet /= np.maximum(tones.sum(1, keepdims=True), 1)
    return Mannequin(skin, tones / tones.sum(1, keepdims=True), feet, light)


def _pivots(pose: _Pose) -> list[tuple[float, np.ndarray]]:
    """For each joint how many times larger it is modelled, and about which point [3]."""
    found = [(1.0, np.zeros(3)) for _ in pose.places]
    if pose.body:
        roots = {
            pose.skeleton.role(f"{side}_{part}"): GROWN[part]
            for side in SIDES
            for part in ("hand", "foot")
        }
        for joint, factor in (
            roots | ({pose.neck[-1]: GROWN["head"]} if len(pose.neck) > 1 else {})
        ).items():
            for j in pose.skeleton.tree.below(joint):
                found[j] = factor, pose.places[joint]
    return found


def _grown(cone: Cone, factor: float, centre: np.ndarray, scale: float) -> Cone:
    """The cone as it is modelled: in metres of a person, larger by a factor about a point."""
    start, end = ((centre + factor * (point - centre)) / scale for point in (cone.start, cone.end))
    return replace(cone, start=start, end=end, radii=tuple(factor * r / scale for r in cone.radii))


def _bones(pose: _Pose, drawn: set[int], scale: float) -> list[Cone]:
    """Plain rounded bones for joints without flesh: fingers, tails, props, other creatures.

    A humanoid's toes are left out, and short bones that are no fingers, such as those of a face.
    """
    role, cones = pose.skeleton.role, []
    fingers, toes = (
        {j for side in SIDES for j in pose.skeleton.tree.below(role(f"{side}_{part}"))}
        if pose.body
        else set()
        for part in ("hand", "foot")
    )
    for j, p in enumerate(pose.skeleton.parents):
        start, end = pose.places[[p, j]]
        length = float(np.linalg.norm(end - start))
        least = 0.06 * scale if pose.body and j not in fingers else 0.008
        if (
            p >= 0
            and j not in toes
            and length > least
            and not (p in drawn and (j in drawn or pose.skeleton.is_end(j)))
        ):
            r = (
                min(max(0.16 * length, 0.008), 0.045 * scale)
                if pose.body
                else min(0.16 * length, 0.06 * scale)
            )
            cones.append(Cone(p, start, end, (r, 0.8 * r), "middle", "bones"))
    return cones


def _humanoid(pose: _Pose) -> tuple[list[Cone], float]:
    """Flesh of a humanoid, and how many times larger it is than the body of the radii."""
    places, role = pose.places, pose.skeleton.role
    leg = places[[role(f"left_{part}") for part in ("hip", "knee", "foot")]]
    s, cones = np.linalg.norm(np.diff(leg, axis=0), axis=1).sum() / LEG, []

    def put(joint: int, start: np.ndarray, end: np.ndarray, radii: tuple[float, float], tone: str,
            part: str, **more) -> None:
        cones.append(Cone(joint, start, end, (s * radii[0], s * radii[1]), tone, part, **more))

    _trunk(pose, s, put)
    _head(pose, s, put)
    for side, rise in zip(SIDES, pose.rises, strict=True):
        _leg(pose, side, s, put)
        _foot(pose, side, rise, s, put)
        _arm(pose, side, s, put)
        _hand(pose, side, s, put)
    return cones, s


def _between(a: np.ndarray, b: np.ndarray, share: float) -> np.ndarray:
    return a + share * (b - a)


LEFT, UP, AHEAD = np.eye(3)


def _trunk(pose: _Pose, s: float, put: Callable) -> None:
    role, places = pose.skeleton.role, pose.places
    hips, spine = role("hips"), pose.skeleton.trunk[::-1]
    left, right = (places[role(f"{side}_hip")] for side in SIDES)
    middle = (left + right) / 2
    for side, hip in zip(SIDES, (left, right), strict=True):  # the pelvis and the seat
        put(
            hips, middle + s * 0.03 * UP, _between(middle, hip, 0.5) + s * 0.03 * UP, (0.1, 0.1),
            side, "trunk", thin=AHEAD, by=0.88
        )
        low = _between(middle, hip, 0.75) - s * (0.02 * AHEAD + 0.045 * UP)
        put(hips, _between(middle, hip, 0.6) - s * 0.025 * AHEAD, low, (0.08, 0.074), side, "trunk")
    spine = spine[spine.index(hips) if hips in spine else 0 :]
    for lower, upper in pairwise(spine):
        start = (
            _between(places[lower], places[upper], 0.6)
            if lower == hips and len(spine) > 2
            else places[lower]
        )
        put(lower, start, places[upper], (0.116, 0.112), "middle", "trunk", thin=AHEAD, by=0.76)
    chest = spine[-1]
    left, right = (places[role(f"{side}_shoulder")] for side in SIDES)
    top, width = (left + right) / 2, min(max(0.37 * np.linalg.norm(left - right) / s, 0.125), 0.15)
    low = np.array(
        [top[0], max(places[chest][1], top[1] - s * 0.24), _between(places[chest], top, 0.3)[2]]
    )
    put(
        chest, low + s * 0.01 * AHEAD, top - s * (0.75 * width * UP - 0.01 * AHEAD),
        (0.86 * width, width), "middle", "trunk", thin=AHEAD, by=0.72
    )
    for side, shoulder in zip(SIDES, (left, right), strict=True):
        collar = pose.skeleton.parents[role(f"{side}_shoulder")]
        put(
            collar, _between(top, shoulder, 0.3) + s * 0.01 * UP, _between(top, shoulder, 0.92),
            (0.05, 0.05), "middle", "trunk"
        )
        breast = _between(top, shoulder, 0.55) + s * (0.04 * AHEAD - 0.075 * UP)
        put(
            chest, breast, _between(breast, top - s * 0.06 * UP + s * 0.045 * AHEAD, 0.6),
            (0.062, 0.06), "middle", "trunk"
        )


def _head(pose: _Pose, s: float, put: Callable) -> None:
    if len(pose.neck) < 2:
        return
    places, head = pose.places, pose.neck[-1]
    for lower, upper in pairwise(pose.neck):
        start = _between(places[lower], places[upper], 0.4 if lower == pose.neck[0] else 0.0)
        put(lower, start, places[upper] + s * 0.01 * UP, (0.058, 0.05), "middle", "neck")
    at = places[head]
    put(
        head, at + s * (0.05 * UP + 0.03 * AHEAD), at + s * (0.122 * UP + 0.012 * AHEAD),
        (0.066, 0.09), "middle", "head", thin=LEFT, by=0.86
    )
    put(
        head, at + s * (0.022 * UP + 0.062 * AHEAD), at + s * (0.05 * UP + 0.05 * AHEAD),
        (0.03, 0.05), "middle", "head"
    )
    eyes = at + s * (0.102 * UP + 0.075 * AHEAD)
    put(
        head, eyes - s * 0.03 * LEFT, eyes + s * 0.03 * LEFT, (0.033, 0.033), "face", "head",
        thin=UP, by=0.75
    )


def _leg(pose: _Pose, side: str, s: float, put: Callable) -> None:
    hip, knee, foot = (pose.skeleton.role(f"{side}_{part}") for part in ("hip", "knee", "foot"))
    a, b, c = pose.places[[hip, knee, foot]]
    middle, calf = _between(a, b, 0.4) + s * 0.008 * AHEAD, _between(b, c, 0.27) - s * 0.014 * AHEAD
    put(hip, a, middle, (0.08, 0.075), side, "legs")
    put(hip, middle, b, (0.075, 0.052), side, "legs")
    put(knee, b, calf, (0.05, 0.053), side, "legs")
    put(knee, calf, _between(b, c, 0.97), (0.053, 0.034), side, "legs")
    put(
        knee, b + s * 0.012 * AHEAD, b + s * (0.012 * AHEAD - 0.02 * UP), (0.042, 0.04), side,
        "legs"
    )


def _foot(pose: _Pose, side: str, rise: float, s: float, put: Callable) -> None:
    ankle, toe = (pose.skeleton.role(f"{side}_{part}") for part in ("foot", "toe"))
    left, up, ahead = pose.body[ankle].T
    inner = -left if side == "left" else left
    at, ball = pose.places[[ankle, toe]]
    if toe == ankle or (ball - at) @ ahead < 0.03 * s:  # no toe, or one below the ankle
        sole = min(at @ up - max(rise, 0.05 * s), ball @ up)
        toe, ball = ankle, at + 0.12 * s * ahead
    else:
        sole = ball @ up - min(rise, 0.05 * s)
    ball = ball + up * (sole - ball @ up)
    heel = at + up * (sole - at @ up) - 0.028 * s * ahead
    place = [
        heel + 0.036 * s * up, ball + s * (0.018 * inner + 0.03 * up),
        ball - s * (0.02 * inner - 0.027 * up)
    ]
    put(ankle, place[0], place[1], (0.036, 0.03), side, "feet", foot=side)
    put(ankle, place[0], place[2], (0.035, 0.027), side, "feet", foot=side)
    put(
        ankle, at - 0.005 * s * ahead, _between(at, ball, 0.72) + 0.012 * s * up, (0.037, 0.034),
        side, "feet", foot=side
    )
    put(ankle, at, heel + 0.045 * s * up, (0.036, 0.033), side, "feet", foot=side)
    put(
        toe, place[1], ball + s * (0.05 * ahead + 0.012 * inner + 0.024 * up), (0.03, 0.024), side,
        "feet", foot=side
    )
    put(
        toe, place[2], ball + s * (0.036 * ahead - 0.012 * inner + 0.023 * up), (0.027, 0.023),
        side, "feet", foot=side
    )


def _arm(pose: _Pose, side: str, s: float, put: Callable) -> None:
    shoulder, elbow, hand = (
        pose.skeleton.role(f"{side}_{part}") for part in ("shoulder", "elbow", "hand")
    )
    a, b, c = pose.places[[shoulder, elbow, hand]]
    put(shoulder, a, _between(a, b, 0.25), (0.054, 0.052), side, "arms")
    put(shoulder, _between(a, b, 0.25), b, (0.05, 0.036), side, "arms")
    bulge = _between(b, c, 0.25)
    put(elbow, b, bulge, (0.036, 0.041), side, "arms")
    put(elbow, bulge, c, (0.041, 0.026), side, "arms")


def _hand(pose: _Pose, side: str, s: float, put: Callable) -> None:
    hand = pose.skeleton.role(f"{side}_hand")
    along, back, thumb = pose.body[hand].T * np.array(
        [[1.0 if side == "left" else -1.0], [1.0], [1.0]]
    )
    at = pose.places[hand]
    children = pose.skeleton.tree.children
    own = [j for j in children[hand] if children[j]]  # the rig's own fingers
    for across, length, degrees in FINGERS:
        knuckle = at + s * (0.09 * along + across * thumb)
        put(
            hand, at + s * (0.012 * along + 0.5 * across * thumb), knuckle, (0.0155, 0.0105),
            "middle", "hands"
        )
        if len(own) < 3:
            angle = np.radians(degrees)
            out = np.cos(angle) * along + np.sin(angle) * thumb
            middle = knuckle + s * length * 0.5 * (out - 0.2 * back)
            put(hand, knuckle, middle, (0.0092, 0.0086), "middle", "hands")
            put(
                hand, middle, middle + s * length * 0.5 * (out - 0.6 * back), (0.0086, 0.0074),
                "middle", "hands"
            )
    if len(own) < 3:
        root, joint = (
            at + s * (0.022 * along + 0.016 * thumb),
            at + s * (0.062 * along + 0.052 * thumb - 0.014 * back)
        )
        put(hand, root, joint, (0.016, 0.0115), "middle", "hands")
        put(
            hand, joint, joint + s * (0.036 * along + 0.012 * thumb - 0.01 * back), (0.011, 0.0085),
            "middle", "hands"
        )
