"""From a state to a pose that can be drawn, feet planted and arms turned.

This is `toolkit.runtime.pose` in loops. Each function is that of the same name in `rotations`, `ik`
or `toolkit.runtime`, on tuples of doubles.
"""

import math

import numpy as np
from numba import njit

from toolkit.features.layout import CHANNELS
from toolkit.io.compilation import compiled

#: Columns of the twelve of a joint.
POSITION, FORWARD = 3 * CHANNELS.index("position"), 3 * CHANNELS.index("forward")
UP, VELOCITY = 3 * CHANNELS.index("up"), 3 * CHANNELS.index("velocity")


@njit
def triple(row):
    """The first three numbers of a row."""
    return np.float64(row[0]), np.float64(row[1]), np.float64(row[2])


@njit
def put(row, v):
    """Write a vector into the first three numbers of a row."""
    row[0], row[1], row[2] = v


@njit
def plus(a, b, share=1.0):
    """a + share · b."""
    return a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2]


@njit
def times(a, share):
    """share · a."""
    return share * a[0], share * a[1], share * a[2]


@njit
def dot(a, b):
    """Inner product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@njit
def _cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


@njit
def unit(a):
    """A vector at length 1."""
    length = max(math.sqrt(dot(a, a)), 1e-12)
    return a[0] / length, a[1] / length, a[2] / length


@njit
def _across(a):
    """A unit vector perpendicular to a: its cross product with the axis farthest from it."""
    x, y, z = abs(a[0]), abs(a[1]), abs(a[2])
    axis = (1.0, 0.0, 0.0) if x <= y and x <= z else (0.0, 1.0, 0.0) if y <= z else (0.0, 0.0, 1.0)
    return unit(_cross(a, axis))


@njit
def multiply(a, b):
    """The rotation b, then a."""
    return (
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    )


@njit
def yaw(angle):
    """Rotation about the vertical."""
    return math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0


@njit
def rotate(q, v):
    """A vector turned by a rotation."""
    u = q[1], q[2], q[3]
    t = _cross(u, v)
    t = 2 * t[0], 2 * t[1], 2 * t[2]
    return plus(plus(v, t, q[0]), _cross(u, t))


@njit
def to_world(heading, v):
    """A vector of the root frame in the world, from the (sine, cosine) of the root's heading."""
    return heading[1] * v[0] + heading[0] * v[2], v[1], heading[1] * v[2] - heading[0] * v[0]


@njit
def _between(a, b):
    a, b = unit(a), unit(b)
    w, (x, y, z) = 1.0 + dot(a, b), _cross(a, b)
    if w < 1e-6:
        x, y, z = _across(a)
        return 0.0, x, y, z
    length = math.sqrt(w * w + x * x + y * y + z * z)
    return w / length, x / length, y / length, z / length


@njit
def from_forward_up(forward, up):
    """`toolkit.motion.rotations.from_forward_up`."""
    c = unit(forward)
    a = unit(_cross(up, c))
    b = _cross(c, a)
    # four times w², x², y², z² of the quaternion, and their products
    p, q, r = a[0], b[1], c[2]
    diagonal = 1 + p + q + r, 1 + p - q - r, 1 - p + q - r, 1 - p - q + r
    x, y, z = b[2] - c[1], c[0] - a[2], a[1] - b[0]
    xy, xz, yz = b[0] + a[1], c[0] + a[2], c[1] + b[2]
    # dividing by the largest of the four loses no digits
    best = 0
    for i in range(1, 4):
        if diagonal[i] > diagonal[best]:
            best = i
    if best == 0:
        w, x, y, z = diagonal[0], x, y, z
    elif best == 1:
        w, x, y, z = x, diagonal[1], xy, xz
    elif best == 2:
        w, x, y, z = y, xy, diagonal[2], yz
    else:
        w, x, y, z = z, xz, yz, diagonal[3]
    length = math.sqrt(w * w + x * x + y * y + z * z)
    length = -length if w < 0 else length
    return w / length, x / length, y / length, z / length


@njit
def _two_bone(body, a, b, c, target, left, soft):
    upper_bone, lower_bone, reach = plus(b, a, -1.0), plus(c, b, -1.0), plus(target, a, -1.0)
    upper, lower = math.sqrt(dot(upper_bone, upper_bone)), math.sqrt(dot(lower_bone, lower_bone))
    wanted = math.sqrt(dot(reach, reach))
    full = upper + lower
    line = unit(reach if wanted > 1e-9 else plus(plus(c, a, -1.0), (1.0, 1.0, 1.0), 1e-9))
    margin = max(soft * full, 1e-9)
    over = wanted - (full - margin)
    distance = full - margin * math.exp(-over / margin) if over > 0 else wanted
    distance = max(distance, abs(upper - lower) + 1e-6 * full)
    side = unit(rotate(_between(plus(c, a, -1.0), line), upper_bone))
    across = plus(side, line, -dot(side, line))
    # A knee that bends backwards is mirrored to the front; that of a straight leg goes there.
    front = _cross(line, unit(left))
    across = plus(across, front, -2 * min(dot(across, front), 0.0))
    across = plus(across, front, max(body.straight - math.sqrt(dot(across, across)), 0.0))
    across = unit(across) if math.sqrt(dot(across, across)) > 1e-5 else _across(line)
    along = (upper * upper - lower * lower + distance * distance) / (2 * distance)
    height = math.sqrt(max(upper * upper - along * along, 0.0))
    return plus(plus(a, line, along), across, height), plus(a, line, distance)


@njit
def _read(q, j):
    return q[j, 0], q[j, 1], q[j, 2], q[j, 3]


@njit
def _write(q, j, value):
    q[j, 0], q[j, 1], q[j, 2], q[j, 3] = value


@njit
def _kinematics(body, turned, places):
    """Positions ``[J', 3]`` of all points but the root, from world rotations ``[J', 4]``."""
    for j in range(1, len(body.parents)):
        parent = body.parents[j]
        bone = rotate(_read(turned, parent), triple(body.offsets[j]))
        put(places[j], plus(triple(places[parent]), bone))


@njit
def _turn_arms(body, turned, places, joints, heading, floor):
    _kinematics(body, turned, places)
    for i in range(len(body.arms)):
        joint, child = body.arms[i]
        goal = plus(floor, to_world(heading, triple(joints[12 * body.own[child] :])))
        at = triple(places[joint])
        bone = rotate(_read(turned, joint), triple(body.offsets[child]))
        aim = _between(bone, plus(goal, at, -1.0))
        _write(turned, joint, multiply(aim, _read(turned, joint)))
        put(places[child], plus(at, rotate(aim, bone)))


@njit
def _left(body, places):
    """From the right hip to the left one."""
    return plus(triple(places[body.legs[1][0]]), triple(places[body.legs[0][0]]), -1.0)


@njit
def _plant_feet(body, turned, places, toes):
    _kinematics(body, turned, places)
    left = _left(body, places)
    for side in range(2):
        hip, knee, foot, toe = body.legs[side]
        a, b, c = triple(places[hip]), triple(places[knee]), triple(places[foot])
        target = plus(plus(triple(toes[side]), triple(places[toe]), -1.0), c)
        middle, end = _two_bone(body, a, b, c, target, left, body.soft)
        upper = _between(plus(b, a, -1.0), plus(middle, a, -1.0))
        lower = _between(plus(c, b, -1.0), plus(end, middle, -1.0))
        _write(turned, hip, multiply(upper, _read(turned, hip)))
        _write(turned, knee, multiply(lower, _read(turned, knee)))


@njit
def _sink(drop, need, rules):
    """The last lines of `toolkit.motion.ik.sink`."""
    seconds, before, speed = 1 / rules.fps, np.float64(drop[0]), np.float64(drop[1])
    need = min(need, before + rules.fall * seconds)
    fade, push = math.exp(-rules.let_go * seconds), speed + rules.let_go * (before - need)
    above = fade * (before - need + push * seconds)
    if above > 0:
        return need + above, fade * (speed - rules.let_go * push * seconds)
    return need, (need - before) / seconds


@njit
def _uncross(ankles, left, lengths, contacts, rules):
    """`toolkit.motion.ik.uncross`, in place."""
    far = max(math.hypot(left[0], left[2]), 1e-12)
    x, z = left[0] / far, left[2] / far
    dx, dz = ankles[1, 0] - ankles[0, 0], ankles[1, 2] - ankles[0, 2]
    aside, along = dx * x + dz * z, abs(dz * x - dx * z)
    for side in range(2):
        need = rules.aside * lengths[side]
        need -= rules.crossing * max(along - rules.passed * lengths[side], 0.0)
        free = 1.0 - min(2.0 * np.float64(contacts[side]), 1.0)
        push = min(max(need - aside, 0.0), rules.push) * free
        push = push if side else -push
        ankles[side, 0] += push * x
        ankles[side, 2] += push * z


@njit
def plant(body, rules, toes, root, contacts, old_drop, new_drop, swivel, joints):
    """Set legs of a pose ``[12 J]``, and the drop, by foot IK: `toolkit.motion.ik.solve_legs`."""
    # places in the root frame, down to the toes
    places, need = np.empty((len(body.parents), 3)), 0.0
    put(places[0], triple(joints))
    for i in range(len(body.chains)):
        j = body.chains[i]
        above = body.parents[j]
        block = joints[12 * body.features[above] :]
        turn = from_forward_up(triple(block[FORWARD:]), triple(block[UP:]))
        put(places[j], plus(triple(places[above]), rotate(turn, triple(body.offsets[j]))))
    sin, cos = np.float64(root[2]), np.float64(root[3])
    length = max(math.hypot(sin, cos), 1e-12)
    into = -sin / length, cos / length  # turns from the world into the root frame
    floor = np.float64(root[0]), 0.0, np.float64(root[1])
    soles, targets, lengths = np.empty((2, 3)), np.empty((2, 3)), np.empty(2)
    for side in range(2):
        hip, knee, foot, toe = body.legs[side]
        a, b, c = triple(places[hip]), triple(places[knee]), triple(places[foot])
        sole = rotate(yaw(np.float64(swivel[side])), plus(triple(places[toe]), c, -1.0))
        put(soles[side], sole)
        goal = to_world(into, plus(triple(toes[side]), floor, -1.0))
        put(targets[side], plus(goal, sole, -1.0))
        bone, shin = plus(b, a, -1.0), plus(c, b, -1.0)
        lengths[side] = math.sqrt(dot(bone, bone)) + math.sqrt(dot(shin, shin))
    left = _left(body, places)
    _uncross(targets, left, lengths, contacts, rules)
    for side in range(2):
        # how far the hips must sink so that the leg reaches: `toolkit.motion.ik.sink`
        hip, full = triple(places[body.legs[side][0]]), lengths[side]
        x, y, z = plus(hip, triple(targets[side]), -1.0)
        lack = y - math.sqrt(max(((1 - rules.soft) * full) ** 2 - x * x - z * z, (full / 2) ** 2))
        room = rules.room * full
        lack = lack if lack > room else max(lack + room, 0.0) ** 2 / (4 * room)
        need = max(need, min(lack, rules.deepest * full) * min(2 * np.float64(contacts[side]), 1.0))
    drop, new_drop[1] = _sink(old_drop, need, rules)
    new_drop[0] = drop
    down = 0.0, -drop, 0.0
    for side in range(2):
        hip, knee, foot, toe = body.legs[side]
        a, b, c = triple(places[hip]), triple(places[knee]), triple(places[foot])
        sole, target = triple(soles[side]), triple(targets[side])
        # the drawn leg is never quite straight in the air, and its toe is where it gets
        held = min(2 * np.float64(contacts[side]), 1.0)
        if held < 1.0:
            soft = rules.swing + held * (rules.soft - rules.swing)
            below = plus(a, down), plus(b, down), plus(c, down)
            _, target = _two_bone(body, *below, target, left, soft)
            there = to_world((sin / length, cos / length), plus(target, sole))
            put(toes[side], plus(there, floor))
        middle, end = _two_bone(body, a, b, c, target, left, rules.soft)
        for point, place in ((knee, middle), (foot, end), (toe, plus(end, sole))):
            put(joints[12 * body.own[point] :], place)


@compiled()
def pose(histories, poses, toes, drops, swivels, body, feet, arms, rotations, roots):
    """Fill local ``rotations [N, J', 4]`` and ``roots [N, 3]``.

    ``histories [N, 61, 4]``, ``poses [N, 12 J]``, ``toes [N, 2, 3]``, ``drops [N, 2]`` and
    ``swivels [N, 2]`` are of `toolkit.runtime.CharacterState`.
    """
    points = len(body.parents)
    turned, places = np.empty((points, 4)), np.empty((points, 3))
    for b in range(len(histories)):
        joints, root = poses[b], histories[b, -1]
        x, z, sin = triple(root)
        cos = np.float64(root[3])
        length = max(math.hypot(sin, cos), 1e-12)
        heading, floor = (sin / length, cos / length), (x, 0.0, z)
        for j in range(points):
            block = joints[12 * body.features[j] :]
            forward, up = triple(block[FORWARD:]), triple(block[UP:])
            _write(turned, j, from_forward_up(to_world(heading, forward), to_world(heading, up)))
        if feet:
            for side in range(2):
                leg = body.legs[side]
                for j in leg[2 : 3 + (leg[3] != leg[2])]:  # without toes, the foot has both roles
                    turn = yaw(np.float64(swivels[b, side]))
                    _write(turned, j, multiply(turn, _read(turned, j)))
        put(places[0], plus(floor, to_world(heading, triple(joints))))
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
        put(roots[b], triple(places[0]))
        # local rotations: each relative to the parent's
        rotations[b, 0] = turned[0]
        for j in range(1, points):
            w, x, y, z = _read(turned, body.parents[j])
            _write(rotations[b], j, multiply((w, -x, -y, -z), _read(turned, j)))
