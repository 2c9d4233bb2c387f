"""What a step computes before and after the network: `toolkit.runtime.step` in scalar loops.

A function with the name of one in `toolkit.runtime`, `toolkit.motion.ik` or
`toolkit.networks.phase` computes the same, in doubles. Constants are arguments (`Rules`), so that
compiled code on disk never holds an old constant.
"""

import math
from collections import namedtuple

import numpy as np
from numba import njit

from toolkit.extra.compiled import ik
from toolkit.extra.compiled.ik import FORWARD, POSITION, UP, VELOCITY
from toolkit.io.compilation import compiled
from toolkit.runtime.state import CharacterState

_PARTS = [name for name in CharacterState.__dataclass_fields__ if name != "style"]
State = namedtuple("State", [*_PARTS, "style"])
State.__doc__ = "`CharacterState` as float32 arrays; the style comes last, ``[N or 1, S]``."


@njit
def _unit2(x, z):
    length = max(math.sqrt(x * x + z * z), 1e-12)
    return x / length, z / length


@njit
def _turn2(a, b, share, most=math.inf):
    """Direction a turned towards b along the shorter way, as `toolkit.runtime.steering.turn`."""
    angle = math.atan2(a[0], a[1])
    by = share * math.atan2(a[1] * b[0] - a[0] * b[1], a[0] * b[0] + a[1] * b[1])
    angle += min(max(by, -most), most)
    return math.sin(angle), math.cos(angle)


@njit
def _lerp(a, b, share):
    return a + share * (b - a)


@njit
def _mix(a, b, share):
    return ik.plus(ik.times(a, 1.0 - share), b, share)


@njit
def _pair(row):
    return np.float64(row[0]), np.float64(row[1])


@njit
def _moved(history, now, rules):
    """Velocity of the root over half a second up to frame ``now`` of the history, m/s."""
    here, there = _pair(history[now]), _pair(history[now - rules.half_second])
    scale = rules.fps / rules.half_second
    return (here[0] - there[0]) * scale, (here[1] - there[1]) * scale


@njit
def _speed_controller(history, drive, velocity, rules):
    wanted = math.hypot(velocity[0], velocity[1])
    if wanted <= rules.moves:
        return _lerp(drive, 1.0, 0.05)
    x, z = _unit2(velocity[0], velocity[1])
    last = len(history) - 1
    (x1, z1), (x2, z2) = _moved(history, last, rules), _moved(history, last - 1, rules)
    lag = min(max((wanted - (x1 * x + z1 * z)) / max(wanted, 0.5), -1.0), 1.0)
    before = min(max((wanted - (x2 * x + z2 * z)) / max(wanted, 0.5), -1.0), 1.0)
    push = rules.proportional * (lag - before) + rules.integral / rules.fps * lag
    return min(max(drive + max(drive, 1.0) * push, 0.0), rules.max_drive)


@njit
def _direction_controller(old, b, velocity, rules, new):
    """`toolkit.runtime.steering.direction_controller` of one character."""
    asked_x = _lerp(np.float64(old.asked[b, 0]), velocity[0], rules.asked)
    asked_z = _lerp(np.float64(old.asked[b, 1]), velocity[1], rules.asked)
    new.asked[b, 0], new.asked[b, 1] = asked_x, asked_z
    aside, speed = np.float64(old.aside[b, 0]), math.hypot(velocity[0], velocity[1])
    if speed <= rules.moves:
        new.aside[b, 0] = rules.forget * aside
        return 0.0, 0.0
    x, z = _unit2(velocity[0], velocity[1])
    moved = _moved(old.history[b], len(old.history[b]) - 1, rules)
    lateral = (moved[0] - asked_x) * z - (moved[1] - asked_z) * x
    aside = min(max(aside + rules.sideways_sum * lateral, -1.0), 1.0)
    new.aside[b, 0] = aside
    push = _moves(speed, rules) * (rules.sideways * lateral + aside)
    push *= max(np.float64(old.drive[b, 0]), 1.0)
    return -push * z, push * x


@njit
def _moves(speed, rules):
    """Share of walking."""
    return min(max((speed - rules.moves) / (rules.slow - rules.moves), 0.0), 1.0)


@njit
def _standing(rest, facing, direction, rules):
    """`toolkit.runtime.steering.standing` of one character."""
    along = direction[0] * facing[0] + direction[1] * facing[1]
    share = (along - rules.may_stand) / (rules.aligned - rules.may_stand)
    return rest * min(max(share, 0.0), 1.0)


@compiled()
def steer(old, wanted, look, rules, x, new):
    """Fill x, and of the new state the smoothed command, the controllers and the future.

    ``wanted``, ``look`` are the command's velocity and facing ``[N or 1, 2]``, ``x [N, Dx]``.
    """
    current = len(rules.samples) - len(rules.position_shares)
    for b in range(len(old.history)):
        history, future, bent = old.history[b], old.future[b], new.future[b]
        # the command, smoothed, and the factor on its speed
        goal_x, goal_z = _pair(wanted[b if len(wanted) > 1 else 0])
        vx, vz = _pair(old.velocity[b])
        dx, dz = rules.gain * (goal_x - vx), rules.gain * (goal_z - vz)
        share = rules.fastest / max(math.hypot(dx, dz), rules.fastest)
        vx, vz = vx + share * dx, vz + share * dz
        facing, goal = _pair(old.facing[b]), _pair(look[b if len(look) > 1 else 0])
        if math.hypot(goal[0], goal[1]) > 1e-6:
            facing = _turn2(facing, goal, rules.gain, rules.spin)
        new.velocity[b, 0], new.velocity[b, 1] = vx, vz
        new.facing[b, 0], new.facing[b, 1] = facing
        drive = np.float64(old.drive[b, 0])
        new.drive[b, 0] = _speed_controller(history, drive, (vx, vz), rules)
        pace = rules.standing if math.hypot(vx, vz) < rules.moves else -rules.starting
        rest = min(max(np.float64(old.rest[b, 0]) + pace, 0.0), 1.0)
        new.rest[b, 0] = rest

        # the target velocity, which counteracts a velocity that differs from the command
        moved = _moved(history, len(history) - 1, rules)
        still = 1.0 - min(math.hypot(vx, vz) / rules.slow, drive / rules.low)
        hold = rules.stand_still * max(still, 0.0)
        across = _direction_controller(old, b, (vx, vz), rules, new)
        asked, pace = _pair(new.asked[b]), max(math.hypot(moved[0], moved[1]), rules.slow)
        walks = min(math.hypot(goal_x, goal_z) / pace, 1.0)
        pull_x = drive * vx + hold * (_lerp(vx, asked[0], walks) - moved[0]) + across[0]
        pull_z = drive * vz + hold * (_lerp(vz, asked[1], walks) - moved[1]) + across[1]

        # from 0 to 1: it does not go where it should
        speed = math.hypot(vx, vz)
        along = (moved[0] * vx + moved[1] * vz) / (rules.low * max(speed * speed, 1e-6))
        slowly = min(max(2.0 - math.hypot(moved[0], moved[1]) / rules.slow, 0.0), 1.0)
        astray = _moves(speed, rules) * slowly * min(max(1.0 - along, 0.0), 1.0)

        # the future trajectory, step by step from the root
        root_x, root_z = _pair(history[-1])
        px, pz = root_x, root_z
        bent[0] = history[-1]
        for s in range(1, len(future)):
            share = _lerp(rules.position_shares[s], 1.0, max(rest, astray))
            seconds = rules.seconds[s]
            (x1, z1), (x2, z2) = _pair(future[s - 1]), _pair(future[s])
            px += _lerp(x2 - x1, pull_x * seconds, share)
            pz += _lerp(z2 - z1, pull_z * seconds, share)
            share = _lerp(rules.direction_shares[s], 1.0, rest)
            dx, dz = _turn2(_pair(future[s, 2:]), facing, share)
            bent[s, 0], bent[s, 1], bent[s, 2], bent[s, 3] = px, pz, dx, dz

        # the network's inputs: the trajectory seen from the root, and the pose
        sin, cos = _pair(history[-1, 2:])
        for s in range(len(rules.samples)):
            sample = history[rules.samples[s]] if s < current else bent[s - current]
            px, pz, (dx, dz) = sample[0] - root_x, sample[1] - root_z, _pair(sample[2:])
            at = rules.trajectory_in + 4 * s
            x[b, at], x[b, at + 1] = cos * px - sin * pz, sin * px + cos * pz
            x[b, at + 2], x[b, at + 3] = cos * dx - sin * dz, sin * dx + cos * dz
        x[b, rules.joints_in : rules.joints_in + old.joints.shape[1]] = old.joints[b]


@njit
def _toes(history, joints, rules, place):
    """Positions of the pose's toes ``[2, 3]``, world."""
    root = ik.triple(history[-1])
    heading = _unit2(root[2], np.float64(history[-1, 3]))
    for side in range(2):
        toe = ik.to_world(heading, ik.triple(joints[12 * rules.legs[side, 2] :]))
        ik.put(place[side], ik.plus(toe, (root[0], 0.0, root[1])))


@njit
def _foot_lock(toes, drift, before, predicted, was, contacts, left, raised, rules, new_toes,
               new_drift):
    """`toolkit.motion.ik.foot_lock` of one character."""
    seconds = 1 / rules.fps
    fade = math.exp(-rules.let_go * seconds)
    most = rules.settle if min(contacts[0], contacts[1]) > rules.both else 0.0
    for side in range(2):
        toe, there = ik.triple(toes[side]), ik.triple(predicted[side])
        speed = ik.triple(drift[side])
        offset = ik.plus(toe, ik.triple(before[side]), -1.0)
        push = ik.plus(speed, offset, rules.let_go)
        held = contacts[side] > 0.5
        # in contact the toe stays where it was, if near; else its offset decays by a spring, and
        # less if it lands
        stays = ik.plus(toe, there, -1.0)
        stays = ik.times(stays, rules.slack / max(math.sqrt(ik.dot(stays, stays)), rules.slack))
        now = ik.times(ik.plus(offset, push, seconds), fade)
        lands = contacts[side] > was[side] and there[1] < rules.ground + rules.uneven
        share = min(2 * np.float64(contacts[side]), 1.0) if lands else 0.0
        share *= min(2 * np.float64(was[1 - side]), 1.0)
        if held:
            now = stays
        else:
            now = _lerp(now[0], stays[0], share), now[1], _lerp(now[2], stays[2], share)
        # an offset towards the other toe is at most a quarter of their distance, or near
        inwards = (left[0], 0.0, left[1]) if side == 0 else (-left[0], 0.0, -left[1])
        apart = ik.dot(ik.plus(ik.triple(predicted[1 - side]), there, -1.0), inwards)
        over = max(ik.dot(now, inwards) - max(apart / 4, rules.near), 0.0)
        now = ik.plus(now, inwards, -over)
        # toes of a body on both feet go to the ground, and a locked toe far off it
        down = rules.ground - there[1] - now[1]
        high = -down - rules.uneven - rules.heel * max(raised[side], 0.0)
        far = max(high, down - rules.sunk, 0.0)
        far = far * rules.level if most > 0.0 or held else 0.0
        down = min(max(down, -most - far), most + far)
        now = now[0], now[1] + down, now[2]
        slower = ik.times(ik.plus(speed, push, -rules.let_go * seconds), fade)
        change = ik.times(ik.plus(now, offset, -1.0), 1 / seconds)
        if held:
            slower = change
        elif share > 0.0:
            slower = change[0], slower[1], change[2]
        ik.put(new_drift[side], slower)
        ik.put(new_toes[side], ik.plus(there, now))


@njit
def _foot(history, joints, rules, side):
    """World rotation of a predicted foot."""
    heading = _unit2(*_pair(history[-1, 2:]))
    block = joints[12 * rules.legs[side, 1] :]
    forward, up = ik.triple(block[FORWARD:]), ik.triple(block[UP:])
    return ik.from_forward_up(ik.to_world(heading, forward), ik.to_world(heading, up))


@njit
def _hold_foot(swivel, before, predicted, contact, rules):
    """`toolkit.motion.ik.hold_feet` of one foot."""
    w, x, y, z = before
    w, _, y, _ = ik.multiply(predicted, (w, -x, -y, -z))
    held = swivel - 2.0 * math.atan2(y if w > 0.0 else -y, abs(w))
    held = min(max(held, -rules.swivel), rules.swivel)
    free = math.exp(-rules.let_go / rules.fps) * swivel
    return _lerp(free, held, min(2.0 * np.float64(contact), 1.0))


@njit
def _joints(was, now, turn, shift, contacts, held, rules, joints):
    """The new pose ``[12 J]`` in the new root frame.

    Positions are means of the predicted and the integrated ones; legs in contact are integrated
    only, and toes in the air are lifted.
    """
    shares, lifts = np.full(len(was) // 12, 0.5), np.zeros(len(was) // 12)
    limits = np.full(len(was) // 12, rules.jump)
    for side in range(2):
        free = 1.0 - min(2.0 * contacts[side], 1.0)
        for part in range(3):
            shares[rules.legs[side, part]] *= free
            limits[rules.legs[side, part]] = 1e6
        lifts[rules.legs[side, 2]] = rules.lift * free
    for j in range(0, len(was), 12):
        old, velocity = ik.triple(was[j + POSITION :]), ik.triple(now[j + VELOCITY :])
        integrated = ik.plus(old, velocity, 1.0 / rules.fps)
        predicted = ik.triple(now[j + POSITION :])
        change = ik.plus(predicted, integrated, -1.0)
        share, most = shares[j // 12], limits[j // 12]
        far = share * math.sqrt(ik.dot(change, change))
        position = ik.plus(integrated, change, share * most / max(far, most))
        swing = lifts[j // 12] * min(max(position[1] - rules.ground, 0.0), rules.high)
        position = position[0], position[1] + swing, position[2]
        forward, up = ik.triple(now[j + FORWARD :]), ik.triple(now[j + UP :])
        # a start: the pose goes the share 1 - held of a frame
        position = _mix(position, old, held)
        forward = ik.unit(_mix(forward, ik.triple(was[j + FORWARD :]), held))
        up = _mix(up, ik.triple(was[j + UP :]), held)
        up = ik.unit(ik.plus(up, forward, -ik.dot(up, forward)))
        parts = ((POSITION, position), (FORWARD, forward), (UP, up), (VELOCITY, velocity))
        for at, vector in parts:
            ik.put(joints[j + at :], ik.to_world(turn, vector))
        joints[j + POSITION] += shift[0]
        joints[j + POSITION + 2] += shift[1]


@njit
def _advance(phase, update, predicted, pull, new):
    """`toolkit.networks.phase.advance` of one limb."""
    (dx, dy), (x, y) = _pair(update), _pair(phase)
    x, y = x + dx, y + dy
    share = min(pull * math.hypot(dx, dy) / max(math.hypot(x, y), 1e-6), 0.5)
    new[0], new[1] = _lerp(x, predicted[0], share), _lerp(y, predicted[1], share)


@compiled()
def after_network(old, z, rules, body, new):
    """Fill the rest of the new state from the network's outputs ``z [N, Dz]`` (section 4.4).

    This is the end of `toolkit.runtime.frame.predicted`, and `toolkit.runtime.frame.planted`.
    """
    width, count = old.joints.shape[1], old.phase.shape[1]
    before, predicted, raised = np.empty((2, 3)), np.empty((2, 3)), np.empty(2)
    for b in range(len(old.history)):
        history, future, out = new.history[b], new.future[b], z[b]
        # the trajectory: sample 0 is the new root, the others are blended with the old ones
        root_x, root_z = _pair(old.history[b, -1])
        sin, cos = _pair(old.history[b, -1, 2:])
        history[:-1] = old.history[b, 1:]
        rest = np.float64(new.rest[b, 0])
        stand = _standing(rest, _pair(new.facing[b]), (sin, cos), rules)
        for s in range(len(future)):
            px, pz = _pair(out[rules.trajectory_out + 4 * s :])
            dx, dz = _pair(out[rules.trajectory_out + 4 * s + 2 :])
            dx, dz = _unit2(dx, dz)
            px, pz = cos * px + sin * pz + root_x, cos * pz - sin * px + root_z
            dx, dz = cos * dx + sin * dz, cos * dz - sin * dx
            if s == 0:
                # a character that is to stand gives up its way first, and its turn once it looks
                # where it should
                px, pz = _lerp(px, root_x, rest), _lerp(pz, root_z, rest)
                dx, dz = _turn2((dx, dz), (sin, cos), stand)
                history[-1, 0], history[-1, 1], history[-1, 2], history[-1, 3] = px, pz, dx, dz
                future[0] = history[-1]
            else:
                share = rules.correction
                future[s, 0] = _lerp(future[s, 0], px, share)
                future[s, 1] = _lerp(future[s, 1], pz, share)
                dx, dz = _lerp(future[s, 2], dx, share), _lerp(future[s, 3], dz, share)
                future[s, 2], future[s, 3] = _unit2(dx, dz)

        # contacts: while the character stands, a low foot comes down and then stays there
        for side in range(2):
            contact = min(max(out[rules.contacts + side], 0.0), 1.0)
            if stand > rules.stands and old.toes[b, side, 1] < rules.ground + rules.lifted:
                contact = max(contact, min(old.contacts[b, side] + rules.landing, 1.0))
            new.contacts[b, side] = contact

        # the pose, moved from the old root frame to the new one
        new_x, new_z = _pair(history[-1])
        new_sin, new_cos = _pair(history[-1, 2:])
        turn = _unit2(sin * new_cos - cos * new_sin, cos * new_cos + sin * new_sin)
        dx, dz = root_x - new_x, root_z - new_z
        shift = new_cos * dx - new_sin * dz, new_sin * dx + new_cos * dz
        pose = new.joints[b]
        now = out[rules.joints_out : rules.joints_out + width]
        speed = math.hypot(np.float64(new.velocity[b, 0]), np.float64(new.velocity[b, 1]))
        held = rest if speed > rules.moves else 0.0  # a start
        _joints(old.joints[b], now, turn, shift, new.contacts[b], held, rules, pose)

        # phases, which rest while the character stands on both feet
        both = min(np.float64(new.contacts[b, 0]), np.float64(new.contacts[b, 1]))
        still = max(stand * both, held)
        for i in range(0, count, 2):
            update, predicted_phase = out[rules.updates + i :], out[rules.phases + i :]
            _advance(old.phase[b, i:], update, predicted_phase, rules.pull, new.phase[b, i:])
            for k in range(i, i + 2):
                new.phase[b, k] = _lerp(new.phase[b, k], old.phase[b, k], still)

        # foot lock and foot IK
        _toes(old.history[b], old.joints[b], rules, before)
        _toes(history, pose, rules, predicted)
        left, toes, contacts = (new_cos, -new_sin), new.toes[b], new.contacts[b]
        toes_were, drift, new_drift, was = old.toes[b], old.drift[b], new.drift[b], old.contacts[b]
        for side in range(2):
            were = _foot(old.history[b], old.joints[b], rules, side)
            are, angle = _foot(history, pose, rules, side), np.float64(old.swivel[b, side])
            new.swivel[b, side] = _hold_foot(angle, were, are, contacts[side], rules)
            foot, toe = body.legs[side][2:]
            sole = ik.triple(body.offsets[toe])
            raised[side] = ik.rotate(are, sole)[1] - sole[1] if toe != foot else 0.0
        _foot_lock(
            toes_were, drift, before, predicted, was, contacts, left, raised, rules, toes, new_drift
        )
        drops = old.drop[b], new.drop[b]
        ik.plant(body, rules, toes, history[-1], contacts, *drops, new.swivel[b], pose)
