"""The computations of a step before and after the network, for many characters: `toolkit.runtime.step` in scalar loops.

Each function corresponds to the function of that name in `toolkit.runtime`, or to a part of it, and computes in doubles.
Constants are arguments (`Rules`), so that compiled code on disk never holds an old constant.
"""

import math
from collections import namedtuple

import numpy as np
from numba import njit

from toolkit.io.compilation import compiled
from toolkit.motion import ik as held
from toolkit.motion import trajectory
from toolkit.motion.clip import FEET
from toolkit.networks import phase
from toolkit.runtime import frame, steering
from toolkit.runtime.compiled import ik
from toolkit.runtime.compiled.ik import FORWARD, POSITION, UP, VELOCITY
from toolkit.runtime.state import CharacterState

State = namedtuple("State", sorted(CharacterState.__dataclass_fields__, key="style".__eq__))
State.__doc__ = "`toolkit.runtime.CharacterState` as float32 arrays; the style comes last, ``[N or 1, S]``."


Rules = namedtuple("Rules", """
    trajectory_in joints_in trajectory_out joints_out phases updates contacts toes
    samples position_shares direction_shares half_second seconds
    fps gain correction proportional integral max_drive stand_still slow low slack let_go pull soft room deepest fall""")
Rules.__doc__ = """Columns of x and z, toes among the joints, constants of `toolkit.runtime` and `toolkit.motion.ik`."""


def rules_of(layout) -> Rules:
    """The rules of a layout."""
    t = np.array(layout.ahead) / layout.ahead[-1]
    return Rules(
        trajectory_in=layout.inputs["trajectory"].start, joints_in=layout.inputs["joints"].start,
        trajectory_out=layout.outputs["trajectory"].start, joints_out=layout.outputs["joints"].start,
        phases=layout.outputs["phases"].start, updates=layout.outputs["phase_updates"].start,
        contacts=layout.outputs["contacts"].start,
        toes=tuple(layout.names.index(layout.skeleton.roles[f"{side}_toe"]) for side in FEET),
        samples=np.array(layout.samples) + trajectory.PAST, position_shares=1 - (1 - t) ** steering.POSITION_BIAS,
        direction_shares=1 - (1 - t) ** steering.DIRECTION_BIAS, half_second=trajectory.FPS // 2,
        seconds=np.diff(layout.ahead, prepend=0) / trajectory.FPS, fps=float(trajectory.FPS),
        gain=steering.GAIN, correction=frame.CORRECTION, proportional=steering.PROPORTIONAL,
        integral=steering.INTEGRAL, max_drive=steering.MAX_DRIVE, stand_still=steering.RETURN, slow=steering.SLOW,
        low=steering.LOW, slack=held.SLACK, let_go=held.RETURN, pull=phase.PULL, soft=held.SOFT, room=held.ROOM,
        deepest=held.DEEPEST, fall=held.FALL,
    )


@njit(nogil=True)
def _unit2(x, z):
    length = max(math.sqrt(x * x + z * z), 1e-12)
    return x / length, z / length


@njit(nogil=True)
def _turn2(a, b, share):
    """Direction a turned towards b along the shorter way, as `toolkit.runtime.steering.turn`."""
    angle = math.atan2(a[0], a[1])
    angle += share * math.atan2(a[1] * b[0] - a[0] * b[1], a[0] * b[0] + a[1] * b[1])
    return math.sin(angle), math.cos(angle)


@njit(nogil=True)
def _lerp(a, b, share):
    return a + share * (b - a)


@njit(nogil=True)
def _pair(row):
    return np.float64(row[0]), np.float64(row[1])


@njit(nogil=True)
def _moved(history, now, rules):
    """Velocity of the root over half a second up to frame ``now`` of the history, m/s."""
    here, there = _pair(history[now]), _pair(history[now - rules.half_second])
    scale = rules.fps / rules.half_second
    return (here[0] - there[0]) * scale, (here[1] - there[1]) * scale


@njit(nogil=True)
def _govern(history, drive, velocity, rules):
    wanted = math.hypot(velocity[0], velocity[1])
    if wanted <= 0.1:
        return _lerp(drive, 1.0, 0.05)
    x, z = _unit2(velocity[0], velocity[1])
    last = len(history) - 1
    (x1, z1), (x2, z2) = _moved(history, last, rules), _moved(history, last - 1, rules)
    lag = min(max((wanted - (x1 * x + z1 * z)) / max(wanted, 0.5), -1.0), 1.0)
    before = min(max((wanted - (x2 * x + z2 * z)) / max(wanted, 0.5), -1.0), 1.0)
    push = rules.proportional * (lag - before) + rules.integral / rules.fps * lag
    return min(max(drive + max(drive, 1.0) * push, 0.0), rules.max_drive)


@compiled()
def steer(old, wanted, look, rules, x, new, start, stop):
    """Fill x, and velocity, facing, drive and future of the new state (section 4.4).

    ``wanted``, ``look`` are the command's velocity and facing ``[N or 1, 2]``, ``x [N, Dx]``.
    """
    current = len(rules.samples) - len(rules.position_shares)
    for b in range(start, stop):
        row, history, future, bent = b if len(wanted) > 1 else 0, old.history[b], old.future[b], new.future[b]
        vx, vz = _pair(old.velocity[b])
        vx, vz = _lerp(vx, wanted[row, 0], rules.gain), _lerp(vz, wanted[row, 1], rules.gain)
        facing, goal = _pair(old.facing[b]), _pair(look[b if len(look) > 1 else 0])
        if math.hypot(goal[0], goal[1]) > 1e-6:
            facing = _turn2(facing, goal, rules.gain)
        new.velocity[b, 0], new.velocity[b, 1] = vx, vz
        new.facing[b, 0], new.facing[b, 1] = facing
        drive = np.float64(old.drive[b, 0])
        new.drive[b, 0] = _govern(history, drive, (vx, vz), rules)

        moved = _moved(history, len(history) - 1, rules)
        hold = rules.stand_still * max(1.0 - min(math.hypot(vx, vz) / rules.slow, drive / rules.low), 0.0)
        pull_x, pull_z = drive * vx + hold * (vx - moved[0]), drive * vz + hold * (vz - moved[1])
        root_x, root_z = _pair(history[-1])
        sin, cos = np.float64(history[-1, 2]), np.float64(history[-1, 3])
        px, pz = root_x, root_z
        bent[0] = history[-1]
        for s in range(1, len(future)):
            share = rules.position_shares[s]
            px += _lerp(np.float64(future[s, 0]) - future[s - 1, 0], pull_x * rules.seconds[s], share)
            pz += _lerp(np.float64(future[s, 1]) - future[s - 1, 1], pull_z * rules.seconds[s], share)
            dx, dz = _turn2(_pair(future[s, 2:]), facing, rules.direction_shares[s])
            bent[s, 0], bent[s, 1], bent[s, 2], bent[s, 3] = px, pz, dx, dz
        for s in range(len(rules.samples)):
            sample = history[rules.samples[s]] if s < current else bent[s - current]
            px, pz, (dx, dz) = sample[0] - root_x, sample[1] - root_z, _pair(sample[2:])
            at = rules.trajectory_in + 4 * s
            x[b, at], x[b, at + 1] = cos * px - sin * pz, sin * px + cos * pz
            x[b, at + 2], x[b, at + 3] = cos * dx - sin * dz, sin * dx + cos * dz
        x[b, rules.joints_in : rules.joints_in + old.joints.shape[1]] = old.joints[b]


@njit(nogil=True)
def _toes(history, joints, rules, place):
    """Positions of the pose's toes ``[2, 3]``, world."""
    root = ik.triple(history[-1])
    heading = _unit2(root[2], np.float64(history[-1, 3]))
    for side in range(2):
        toe = ik.to_world(heading, ik.triple(joints[12 * rules.toes[side] :]))
        place[side, 0], place[side, 1], place[side, 2] = ik.plus(toe, (root[0], 0.0, root[1]))


@njit(nogil=True)
def _hold(toes, drift, before, predicted, contacts, left, rules, new_toes, new_drift):
    """`toolkit.motion.ik.foot_lock` of one character."""
    seconds = 1 / rules.fps
    fade = math.exp(-rules.let_go * seconds)
    for side in range(2):
        offset_x, offset_z = toes[side, 0] - before[side, 0], toes[side, 2] - before[side, 2]
        push_x, push_z = drift[side, 0] + rules.let_go * offset_x, drift[side, 1] + rules.let_go * offset_z
        held = contacts[side] > 0.5
        if held:
            x, z = toes[side, 0] - predicted[side, 0], toes[side, 2] - predicted[side, 2]
            scale = rules.slack / max(math.hypot(x, z), rules.slack)
            x, z = x * scale, z * scale
        else:
            x, z = fade * (offset_x + push_x * seconds), fade * (offset_z + push_z * seconds)
        inwards = left if side == 0 else (-left[0], -left[1])
        other = 1 - side
        to_x, to_z = predicted[other, 0] - predicted[side, 0], predicted[other, 2] - predicted[side, 2]
        apart = max(to_x * inwards[0] + to_z * inwards[1], 0.0)
        over = max(x * inwards[0] + z * inwards[1] - apart / 4, 0.0)
        x, z = x - over * inwards[0], z - over * inwards[1]
        if held:
            new_drift[side, 0], new_drift[side, 1] = (x - offset_x) / seconds, (z - offset_z) / seconds
        else:
            new_drift[side, 0] = fade * (drift[side, 0] - rules.let_go * push_x * seconds)
            new_drift[side, 1] = fade * (drift[side, 1] - rules.let_go * push_z * seconds)
        new_toes[side, 0], new_toes[side, 1] = predicted[side, 0] + x, predicted[side, 1]
        new_toes[side, 2] = predicted[side, 2] + z


@njit(nogil=True)
def _joints(was, now, turn, shift, rules, joints):
    """The new pose ``[12 J]`` in the new root frame; positions are means of the predicted and the integrated ones."""
    for j in range(0, len(was), 12):
        old, velocity = ik.triple(was[j + POSITION :]), ik.triple(now[j + VELOCITY :])
        sum_ = ik.plus(old, ik.triple(now[j + POSITION :]))
        position = ik.plus((0.5 * sum_[0], 0.5 * sum_[1], 0.5 * sum_[2]), velocity, 0.5 / rules.fps)
        forward, up = ik.unit(ik.triple(now[j + FORWARD :])), ik.triple(now[j + UP :])
        up = ik.unit(ik.plus(up, forward, -ik.dot(up, forward)))
        for at, vector in ((POSITION, position), (FORWARD, forward), (UP, up), (VELOCITY, velocity)):
            joints[j + at], joints[j + at + 1], joints[j + at + 2] = ik.to_world(turn, vector)
        joints[j + POSITION] += shift[0]
        joints[j + POSITION + 2] += shift[1]


@njit(nogil=True)
def _advance(phase, update, predicted, pull, new):
    """`toolkit.networks.phase.advance` of one limb."""
    (dx, dy), (x, y) = _pair(update), _pair(phase)
    x, y = x + dx, y + dy
    share = min(pull * math.hypot(dx, dy) / max(math.hypot(x, y), 1e-6), 0.5)
    new[0], new[1] = _lerp(x, predicted[0], share), _lerp(y, predicted[1], share)


@compiled()
def follow(old, z, rules, body, new, start, stop):
    """Fill the rest of the new state from the network's outputs ``z [N, Dz]`` (section 4.4)."""
    width, count = old.joints.shape[1], old.phase.shape[1]
    before, predicted = np.empty((2, 3)), np.empty((2, 3))
    for b in range(start, stop):
        history, future, out = new.history[b], new.future[b], z[b]
        root_x, root_z = _pair(old.history[b, -1])
        sin, cos = np.float64(old.history[b, -1, 2]), np.float64(old.history[b, -1, 3])
        history[:-1] = old.history[b, 1:]
        for s in range(len(future)):
            px, pz = _pair(out[rules.trajectory_out + 4 * s :])
            dx, dz = _pair(out[rules.trajectory_out + 4 * s + 2 :])
            dx, dz = _unit2(dx, dz)
            px, pz = cos * px + sin * pz + root_x, cos * pz - sin * px + root_z
            dx, dz = cos * dx + sin * dz, cos * dz - sin * dx
            if s == 0:
                history[-1, 0], history[-1, 1], history[-1, 2], history[-1, 3] = px, pz, dx, dz
                future[0] = history[-1]
            else:
                share = rules.correction
                future[s, 0], future[s, 1] = _lerp(future[s, 0], px, share), _lerp(future[s, 1], pz, share)
                dx, dz = _lerp(future[s, 2], dx, share), _lerp(future[s, 3], dz, share)
                future[s, 2], future[s, 3] = _unit2(dx, dz)

        new_x, new_z = _pair(history[-1])
        new_sin, new_cos = np.float64(history[-1, 2]), np.float64(history[-1, 3])
        turn = _unit2(sin * new_cos - cos * new_sin, cos * new_cos + sin * new_sin)
        dx, dz = root_x - new_x, root_z - new_z
        shift = new_cos * dx - new_sin * dz, new_sin * dx + new_cos * dz
        _joints(old.joints[b], out[rules.joints_out : rules.joints_out + width], turn, shift, rules, new.joints[b])
        for i in range(0, count, 2):
            _advance(old.phase[b, i:], out[rules.updates + i :], out[rules.phases + i :], rules.pull, new.phase[b, i:])
        for side in range(2):
            new.contacts[b, side] = min(max(out[rules.contacts + side], 0.0), 1.0)
        _toes(old.history[b], old.joints[b], rules, before)
        _toes(history, new.joints[b], rules, predicted)
        left = new_cos, -new_sin
        _hold(old.toes[b], old.drift[b], before, predicted, new.contacts[b], left, rules, new.toes[b], new.drift[b])
        ik.plant(body, rules, new.toes[b], history[-1], new.contacts[b], old.drop[b], new.drop[b], new.joints[b])
