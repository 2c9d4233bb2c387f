"""From a character's state to a pose that can be drawn, feet planted and arms turned: `toolkit.runtime.pose` in loops.

Each function is that of the same name in `rotations`, `ik` or `toolkit.runtime`, on tuples of doubles.
"""

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numba import njit

from toolkit.features.layout import CHANNELS
from toolkit.io.compilation import compiled
from toolkit.motion.clip import FEET
from toolkit.motion.ik import SOFT

POSITION, FORWARD, UP, VELOCITY = (3 * CHANNELS.index(name) for name in ("position", "forward", "up", "velocity"))


class Body(NamedTuple):
    """The skeleton of J' points as arrays."""

    parents: np.ndarray  # [J']
    offsets: np.ndarray  # [J', 3]
    features: np.ndarray  # [J'] index of the feature joint that gives a point its rotation, its own or its parent's
    own: np.ndarray  # [J'] index of a point's own feature joint, -1 if it has none
    ends: np.ndarray  # [E] points that follow their parents
    legs: np.ndarray  # [2, 4] hip, knee, foot and toe, right and left
    chains: np.ndarray  # [C] all points from the hips to the toes, without the hips; parents come before children
    arms: np.ndarray  # [A, 2] arm joints and the points at their bones' other ends, from the body outwards

    @classmethod
    def of(cls, skeleton) -> "Body":
        """The arrays of a skeleton."""
        joints, parents = list(skeleton.feature_joints), skeleton.parents
        toes = [skeleton.role(f"{side}_toe") for side in FEET]
        arms = [[skeleton.role(f"{side}_{part}") for side in FEET] for part in ("shoulder", "elbow", "hand")]
        chain = [[parents[joint] for joint in arms[0]], *arms]
        ends = [skeleton.end_site(f"{side}_hand") for side in FEET]
        bones = pairwise([*chain, ends] if not set(ends) & set(arms[-1]) else chain)
        return cls(
            parents=np.array(parents), offsets=skeleton.offsets.double().numpy(),
            features=np.array([joints.index(j if j in joints else parents[j]) for j in range(len(skeleton))]),
            own=np.array([joints.index(j) if j in joints else -1 for j in range(len(skeleton))]),
            ends=np.array([j for j in range(len(skeleton)) if skeleton.is_end(j)], dtype=np.int64),
            legs=np.array([[skeleton.role(f"{side}_{part}") for part in ("hip", "knee", "foot", "toe")] for side in FEET]),
            chains=np.array(sorted({j for toe in toes for j in (toe, *skeleton.ancestors(toe))} - {0})),
            arms=np.array([pair for level in bones for pair in zip(*level, strict=True)]),
        )


@njit(nogil=True)
def triple(row):
    """The first three numbers of a row."""
    return np.float64(row[0]), np.float64(row[1]), np.float64(row[2])


@njit(nogil=True)
def plus(a, b, share=1.0):
    """a + share · b."""
    return a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]


@njit(nogil=True)
def dot(a, b):
    """Inner product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@njit(nogil=True)
def _cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@njit(nogil=True)
def unit(a):
    """A vector at length 1."""
    length = max(math.sqrt(dot(a, a)), 1e-12)
    return a[0] / length, a[1] / length, a[2] / length


@njit(nogil=True)
def _across(a):
    """A unit vector perpendicular to a unit vector: its cross product with the coordinate axis farthest from it."""
    x, y, z = abs(a[0]), abs(a[1]), abs(a[2])
    axis = (1.0, 0.0, 0.0) if x <= y and x <= z else (0.0, 1.0, 0.0) if y <= z else (0.0, 0.0, 1.0)
    return unit(_cross(a, axis))


@njit(nogil=True)
def _multiply(a, b):
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


@njit(nogil=True)
def _rotate(q, v):
    u = q[1], q[2], q[3]
    t = _cross(u, v)
    t = 2 * t[0], 2 * t[1], 2 * t[2]
    return plus(plus(v, t, q[0]), _cross(u, t))


@njit(nogil=True)
def to_world(heading, v):
    """A vector of the root frame in world coordinates, from the (sine, cosine) of the root's heading."""
    return heading[1] * v[0] + heading[0] * v[2], v[1], heading[1] * v[2] - heading[0] * v[0]


@njit(nogil=True)
def _between(a, b):
    a, b = unit(a), unit(b)
    w, (x, y, z) = 1.0 + dot(a, b), _cross(a, b)
    if w < 1e-6:
        x, y, z = _across(a)
        return 0.0, x, y, z
    length = math.sqrt(w * w + x * x + y * y + z * z)
    return w / length, x / length, y / length, z / length


@njit(nogil=True)
def _from_forward_up(forward, up):
    c = unit(forward)
    a = unit(_cross(up, c))
    b = _cross(c, a)
    diagonal = 1 + a[0] + b[1] + c[2], 1 + a[0] - b[1] - c[2], 1 - a[0] + b[1] - c[2], 1 - a[0] - b[1] + c[2]
    x, y, z = b[2] - c[1], c[0] - a[2], a[1] - b[0]
    xy, xz, yz = b[0] + a[1], c[0] + a[2], c[1] + b[2]
    best = 0
    for i in range(1, 4):
        if diagonal[i] > diagonal[best]:
            best = i
    if best == 0:
        q = diagonal[0], x, y, z
    elif best == 1:
        q = x, diagonal[1], xy, xz
    elif best == 2:
        q = y, xy, diagonal[2], yz
    else:
        q = z, xz, yz, diagonal[3]
    length = math.sqrt(q[0] ** 2 + q[1] ** 2 + q[2] ** 2 + q[3] ** 2)
    length = -length if q[0] < 0 else length
    return q[0] / length, q[1] / length, q[2] / length, q[3] / length


@njit(nogil=True)
def _two_bone(a, b, c, target, soft=SOFT):
    upper_bone, lower_bone, reach = plus(b, a, -1.0), plus(c, b, -1.0), plus(target, a, -1.0)
    upper, lower = math.sqrt(dot(upper_bone, upper_bone)), math.sqrt(dot(lower_bone, lower_bone))
    wanted = math.sqrt(dot(reach, reach))
    full = upper + lower
    line = unit(reach if wanted > 1e-9 else plus(plus(c, a, -1.0), (1.0, 1.0, 1.0), 1e-9))
    margin = max(soft * full, 1e-9)
    over = wanted - (full - margin)
    distance = full - margin * math.exp(-over / margin) if over > 0 else wanted
    distance = max(distance, abs(upper - lower) + 1e-6 * full)
    side = unit(_rotate(_between(plus(c, a, -1.0), line), upper_bone))
    across = plus(side, line, -dot(side, line))
    across = unit(across) if math.sqrt(dot(across, across)) > 1e-5 else _across(line)
    along = (upper * upper - lower * lower + distance * distance) / (2 * distance)
    height = math.sqrt(max(upper * upper - along * along, 0.0))
    return plus(plus(a, line, along), across, height), plus(a, line, distance)


@njit(nogil=True)
def _read(q, j):
    return q[j, 0], q[j, 1], q[j, 2], q[j, 3]


@njit(nogil=True)
def _write(q, j, value):
    q[j, 0], q[j, 1], q[j, 2], q[j, 3] = value


@njit(nogil=True)
def _kinematics(body, turned, places):
    """Positions ``[J', 3]`` of all points but the root, from world rotations ``[J', 4]`` and the root's position."""
    for j in range(1, len(body.parents)):
        parent = body.parents[j]
        bone = _rotate(_read(turned, parent), triple(body.offsets[j]))
        places[j, 0], places[j, 1], places[j, 2] = plus(triple(places[parent]), bone)


@njit(nogil=True)
def _turn_arms(body, turned, places, joints, heading, floor):
    _kinematics(body, turned, places)
    for i in range(len(body.arms)):
        joint, child = body.arms[i]
        goal = plus(floor, to_world(heading, triple(joints[12 * body.own[child] :])))
        bone, at = _rotate(_read(turned, joint), triple(body.offsets[child])), triple(places[joint])
        aim = _between(bone, plus(goal, at, -1.0))
        _write(turned, joint, _multiply(aim, _read(turned, joint)))
        places[child, 0], places[child, 1], places[child, 2] = plus(at, _rotate(aim, bone))


@njit(nogil=True)
def _plant_feet(body, turned, places, toes):
    _kinematics(body, turned, places)
    for side in range(2):
        hip, knee, foot, toe = body.legs[side]
        a, b, c = triple(places[hip]), triple(places[knee]), triple(places[foot])
        target = plus(plus(triple(toes[side]), triple(places[toe]), -1.0), c)
        middle, end = _two_bone(a, b, c, target)
        upper = _between(plus(b, a, -1.0), plus(middle, a, -1.0))
        lower = _between(plus(c, b, -1.0), plus(end, middle, -1.0))
        _write(turned, hip, _multiply(upper, _read(turned, hip)))
        _write(turned, knee, _multiply(lower, _read(turned, knee)))


@njit(nogil=True)
def _sink(drop, need, rules):
    """The last lines of `toolkit.motion.ik.sink`."""
    seconds, before, speed = 1 / rules.fps, np.float64(drop[0]), np.float64(drop[1])
    need = min(need, before + rules.fall * seconds)
    fade, push = math.exp(-rules.let_go * seconds), speed + rules.let_go * (before - need)
    above = fade * (before - need + push * seconds)
    if above > 0:
        return need + above, fade * (speed - rules.let_go * push * seconds)
    return need, (need - before) / seconds


@njit(nogil=True)
def plant(body, rules, toes, root, contacts, old_drop, new_drop, joints):
    """Set knees, feet and toes of a pose ``[12 J]``, and the drop, by foot IK, see `toolkit.motion.ik.solve_legs`."""
    places, need = np.empty((len(body.parents), 3)), 0.0
    places[0, 0], places[0, 1], places[0, 2] = triple(joints)
    for i in range(len(body.chains)):
        j = body.chains[i]
        above = body.parents[j]
        block = joints[12 * body.features[above] :]
        bone = _rotate(_from_forward_up(triple(block[FORWARD:]), triple(block[UP:])), triple(body.offsets[j]))
        places[j, 0], places[j, 1], places[j, 2] = plus(triple(places[above]), bone)
    sin, cos = np.float64(root[2]), np.float64(root[3])
    length = max(math.hypot(sin, cos), 1e-12)
    for side in range(2):
        hip, knee, foot, toe = body.legs[side]
        a, b, c, tip = triple(places[hip]), triple(places[knee]), triple(places[foot]), triple(places[toe])
        x, z = np.float64(toes[side, 0]) - root[0], np.float64(toes[side, 2]) - root[1]
        sole = plus(tip, c, -1.0)
        target = plus(to_world((-sin / length, cos / length), (x, np.float64(toes[side, 1]), z)), sole, -1.0)
        bone, shin, (x, y, z) = plus(b, a, -1.0), plus(c, b, -1.0), plus(a, target, -1.0)
        full = math.sqrt(dot(bone, bone)) + math.sqrt(dot(shin, shin))
        lack = y - math.sqrt(max(((1 - rules.soft) * full) ** 2 - x * x - z * z, (full / 2) ** 2))
        room = rules.room * full
        lack = lack if lack > room else max(lack + room, 0.0) ** 2 / (4 * room)
        need = max(need, min(lack, rules.deepest * full) * min(2 * np.float64(contacts[side]), 1.0))
        middle, end = _two_bone(a, b, c, target, rules.soft)
        for point, place in ((knee, middle), (foot, end), (toe, plus(end, sole))):
            at = 12 * body.own[point]
            joints[at], joints[at + 1], joints[at + 2] = place
    new_drop[0], new_drop[1] = _sink(old_drop, need, rules)


@compiled()
def pose(histories, poses, toes, drops, body, feet, arms, rotations, roots, start, stop):
    """Fill rows ``start`` to ``stop`` of local rotations ``[N, J', 4]`` and root positions ``[N, 3]`` (section 4.4).

    ``histories [N, 61, 4]``, ``poses [N, 12 J]``, ``toes [N, 2, 3]`` and ``drops [N, 2]`` are of
    `toolkit.runtime.CharacterState`.
    """
    points = len(body.parents)
    turned, places = np.empty((points, 4)), np.empty((points, 3))
    for b in range(start, stop):
        joints, root = poses[b], histories[b, -1]
        x, z, sin, cos = np.float64(root[0]), np.float64(root[1]), np.float64(root[2]), np.float64(root[3])
        length = max(math.hypot(sin, cos), 1e-12)
        heading, floor = (sin / length, cos / length), (x, 0.0, z)
        for j in range(points):
            block = joints[12 * body.features[j] :]
            forward, up = triple(block[FORWARD:]), triple(block[UP:])
            _write(turned, j, _from_forward_up(to_world(heading, forward), to_world(heading, up)))
        places[0, 0], places[0, 1], places[0, 2] = plus(floor, to_world(heading, triple(joints)))
        if arms:
            _turn_arms(body, turned, places, joints, heading, floor)
        if feet or arms:
            for j in body.ends:
                turned[j] = turned[body.parents[j]]
        if feet:
            places[0, 1] -= np.float64(drops[b, 0])
            _plant_feet(body, turned, places, toes[b])
            for j in body.ends:
                turned[j] = turned[body.parents[j]]
        roots[b, 0], roots[b, 1], roots[b, 2] = places[0]
        rotations[b, 0] = turned[0]
        for j in range(1, points):
            w, x, y, z = _read(turned, body.parents[j])
            q = _multiply((w, -x, -y, -z), _read(turned, j))
            rotations[b, j, 0], rotations[b, j, 1], rotations[b, j, 2], rotations[b, j, 3] = q
