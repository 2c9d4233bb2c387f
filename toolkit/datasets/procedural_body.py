"""Body pose over procedural footsteps.

The pelvis stays within reach of the feet, and trunk and arms follow the phase of the steps.
"""

import math
from collections.abc import Sequence

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.datasets.procedural_steps import FOOT, FPS, Foot, Plan, smooth, smooth_noise
from toolkit.datasets.procedural_styles import Arm
from toolkit.motion import Skeleton, forward_kinematics, rotations as R
from toolkit.motion.ik import two_bone
from toolkit.motion.roles import SIDES

# name, parent, offset from the parent; of the limbs for the right side, with x outwards
_TRUNK = (("Hips", -1, 0, 0, 0), ("Chest", 0, 0, 0.130, 0), ("Chest2", 1, 0, 0.103, 0),
          ("Chest3", 2, 0, 0.093, 0), ("Chest4", 3, 0, 0.093, 0), ("Neck", 4, 0, 0.133, 0),
          ("Head", 5, 0, 0.090, 0), ("HeadEnd", 6, 0, 0.171, 0))
_ARM = (("Collar", 4, 0.032, 0.075, 0), ("Shoulder", 8, 0.158, 0, 0), ("Elbow", 9, 0.312, 0, 0),
        ("Wrist", 10, 0.255, 0, 0), ("WristEnd", 11, 0.191, 0, 0))
_LEG = (("Hip", 0, 0.107, 0.001, 0), ("Knee", 18, 0, -0.437, 0), ("Ankle", 19, 0, -0.432, 0),
        ("Toe", 20, *FOOT), ("ToeEnd", 21, 0, -0.013, 0.049))
SPINE = ("Chest", "Chest2", "Chest3", "Chest4")


def _skeleton() -> Skeleton:
    rows = list(_TRUNK)
    for limb in (_ARM, _LEG):
        for side, sign, shift in (("Right", -1, 0), ("Left", 1, 5)):
            for i, (name, parent, x, y, z) in enumerate(limb):
                rows.append((side + name, parent + shift * (i > 0), sign * x, y, z))
    names, parents = [row[0] for row in rows], [row[1] for row in rows]
    return Skeleton(names, parents, torch.tensor([row[2:] for row in rows]))


#: 100STYLE's 28 points: same names, order and axes, lengths to the millimetre; zero rotation is a
#: T-pose facing +Z.
SKELETON = _skeleton()
_J = {name: j for j, name in enumerate(SKELETON.names)}
SURGE = 0.02  # metres, amplitude ahead of a constant speed, twice per stride
FOLDED = 0.34  # metres, least distance of hip joint and ankle
DORSAL, PLANTAR = 0.6, -0.8  # radians, largest flexion of an ankle in the swing: 35° and 45°
_FOOT = torch.tensor(FOOT, dtype=torch.float64)
_X = torch.tensor([1.0, 0.0, 0.0], dtype=torch.float64)
_Z = torch.tensor([0.0, 0.0, 1.0], dtype=torch.float64)


class _Rhythm:
    """What trunk and arms follow, over F frames: phase of the steps, how much, noise, breath."""

    def __init__(self, plan: Plan):
        style, frames = plan.style, len(plan.t)
        self.amount = smooth(np.minimum(plan.pace, 1.5) ** 0.6 * (plan.pace > 0.02), 8)
        self.still = np.clip(1 - self.amount, 0, 1)
        self.beat = plan.clock - plan.middle  # 0 in the middle of the left foot's swing
        self.sin, self.cos = self.amount * np.sin(self.beat), self.amount * np.cos(self.beat)
        self.cos2 = self.amount * np.cos(2 * self.beat)
        loud = style.noise + 2 * style.stagger
        self.noise = loud * smooth_noise(plan.rng, frames, 22, 8).T
        self.breath = 0.6 * np.sin(2 * math.pi * 0.25 / FPS * plan.t)
        self.hopping = len(plan.stepping) == 1
        self.even = 0.0 if self.hopping else 1.0  # share of what differs between two steps


def pose(plan: Plan, feet: dict[str, Foot]) -> tuple[Tensor, Tensor]:
    """Local rotations ``[F, J, 4]`` and root positions ``[F, 3]``."""
    rhythm = _Rhythm(plan)
    local = _upper_body(plan, rhythm)

    # legs from the feet to a pelvis within their reach
    turned, hips = _legs(plan, rhythm, feet, local[:, :1])
    for i, name in enumerate(("Left", "Right")):
        local[:, [_J[name + part] for part in ("Hip", "Knee", "Ankle", "Toe")]] = turned[:, i]

    # hands that rest on the body
    for side in SIDES:
        arm = plan.style.arm(side)
        if arm.hand_at is not None:
            _pin_hand(local, hips, side, arm)
    return local.float(), hips.float()


def _upper_body(plan: Plan, rhythm: _Rhythm) -> Tensor:
    """Local rotations ``[F, J, 4]`` of pelvis, trunk, head and arms."""
    style, run, noise = plan.style, plan.running, rhythm.noise
    amount, sin, cos, even = rhythm.amount, rhythm.sin, rhythm.cos, rhythm.even
    # degrees: turn to the left, forward pitch, roll to the right
    euler = np.zeros((len(plan.t), len(SKELETON), 3))

    def turn(joints: Sequence[str], y=0.0, x=0.0, z=0.0) -> None:
        """Add a rotation, shared by some joints."""
        angles = np.stack(np.broadcast_arrays(y, x, z, np.zeros(len(plan.t)))[:3], 1)
        for name in joints:
            euler[:, _J[name]] += angles / len(joints)

    # the pelvis turns with the swinging leg and drops on its side; the chest turns against it
    lean_in = np.degrees(np.arctan(plan.ahead * plan.turning / 9.81))  # against the centrifugal
    bank = smooth(np.clip(lean_in, -20, 20), 8)
    speedup = 1 + 0.4 * run
    turn(["Hips"], -style.yaw * speedup * sin * even, style.tilt + 3 * run,
         -style.drop * cos * even - 0.5 * bank)
    lean = style.lean + 5 * run + style.lean_swing * rhythm.cos2 + rhythm.breath + 3 * noise[0]
    turn(SPINE,
         (style.yaw + style.twist_swing) * speedup * sin * even + 2.5 * noise[1],
         lean,
         -style.bend + (style.bend_swing + style.drop) * cos * even - 0.3 * bank + 3 * noise[2])

    # neck and head cancel a share of the trunk's motion, but not its posture, and look ahead
    trunk = euler[:, _J["Hips"]] + euler[:, [_J[name] for name in SPINE]].sum(1)
    undo = -style.steady * trunk
    undo += style.steady * np.array([0, style.tilt + style.lean, -style.bend])
    look = np.degrees(0.25 * smooth(plan.turning, 10))
    turn(["Neck", "Head"],
         undo[:, 0] + look + 4 * noise[3],
         undo[:, 1] - 6 * run,
         undo[:, 2] - style.head_roll + style.head_swing * cos + 3 * noise[4])
    turn(["Neck"], 0, style.neck)
    turn(["Head"], 0, style.head)

    # arms swing against the legs, and bend when running
    twist = np.zeros((len(plan.t), 2))
    for i, side in enumerate(SIDES):
        arm, sign, name = style.arm(side), 1 if side == "left" else -1, side.capitalize()
        phase = arm.ratio * plan.clock - plan.middle - math.radians(arm.phase) + math.pi * i
        swing = -amount * np.sin(phase)
        loose = (arm.run_elbow > arm.elbow) * run
        flex = arm.forward + arm.swing * (1 + 0.3 * run) * swing + 4 * noise[5 + i] - 4 * loose
        out = arm.out + arm.out_swing * cos + 3 * noise[7] + 4 * loose
        elbow = arm.elbow + arm.elbow_swing * swing + run * (arm.run_elbow - arm.elbow)
        elbow = elbow + 2 * noise[5 + i]
        turn([name + "Collar"], 0, 0, sign * style.shrug)
        turn([name + "Shoulder"], 0, -flex, sign * (out - 90 - style.shrug))
        turn([name + "Elbow"], -sign * np.clip(elbow, 0, 140))
        turn([name + "Wrist"], -sign * arm.wrist)
        twist[:, i] = arm.twist * (1 - 0.6 * loose)

    local = R.from_euler(torch.from_numpy(np.radians(euler)), "YXZ")
    facing = torch.from_numpy(plan.root[:, 2])
    local[:, 0] = R.multiply(R.yaw(facing), local[:, 0])
    shoulders = [_J["LeftShoulder"], _J["RightShoulder"]]
    twisted = R.from_axis_angle(_X, torch.from_numpy(np.radians(twist)))
    local[:, shoulders] = R.multiply(local[:, shoulders], twisted)
    return local


def _hips(plan: Plan, rhythm: _Rhythm) -> tuple[np.ndarray, np.ndarray]:
    """Places ``[F, 3]`` of the hips at height zero, and the heights ``[F]`` that the style wants.

    The hips follow the path and sway over the standing foot.
    """
    style, frames, run, amount = plan.style, len(plan.t), plan.running, rhythm.amount
    unrest = 0.012 * rhythm.still * rhythm.even
    side = -style.sway * rhythm.cos * rhythm.even
    side = side + unrest * smooth_noise(plan.rng, frames, 50, 1)[:, 0]
    side = side + 0.04 * style.stagger * smooth_noise(plan.rng, frames, 30, 1)[:, 0]
    if rhythm.hopping:
        side = side + (0.02 if plan.stepping[0] == "left" else -0.02)
    surge = SURGE * amount * np.sin(2 * rhythm.beat) * rhythm.even
    front = style.forward + 0.04 * style.noise * rhythm.noise[3] * amount - surge
    c, s = np.cos(plan.root[:, 2]), np.sin(plan.root[:, 2])
    x = plan.root[:, 0] + side * c + front * s
    z = plan.root[:, 1] - side * s + front * c
    if rhythm.hopping:
        up = style.bob * amount * np.cos(rhythm.beat)
    else:
        up = (style.bob * (1 - run) - 0.03 * run) * rhythm.cos2
    sink = min(max(style.height - 0.75, 0.1), 0.2) / 2  # runners land with bent knees
    wanted = style.height + (0.01 + 0.004 * rhythm.breath) * rhythm.still - sink * run + up
    return np.stack((x, np.zeros(frames), z), 1), wanted


def _legs(plan: Plan, rhythm: _Rhythm, feet: dict[str, Foot],
          pelvis: Tensor) -> tuple[Tensor, Tensor]:
    """Local rotations ``[F, 2, 4, 4]`` of hip, knee, ankle and toe, and the hips ``[F, 3]``.

    The left leg comes first: arrays are ``[F, 2]``, positions ``[F, 2, 3]``.
    """
    shape = len(plan.t), len(SIDES)
    yaw, pitch, toe_pitch, air, slack, kick = (np.zeros(shape) for _ in range(6))
    ankles = torch.zeros(*shape, 3, dtype=torch.float64)
    for name, foot in feet.items():  # a raised leg has none
        i = SIDES.index(name)
        yaw[:, i], pitch[:, i] = foot.yaw, foot.pitch
        air[:, i], slack[:, i], kick[:, i] = foot.air, foot.slack, foot.kick
        toe_pitch[:, i] = foot.pitch - np.minimum(foot.pitch, 0) * foot.flatness
        sole = R.rotate(_foot_rotation(foot.yaw, foot.pitch), _FOOT)
        ankles[:, i] = torch.from_numpy(foot.toe) - sole

    # from the hips to the hip joints, and the length of a leg
    joints = [_J["LeftHip"], _J["RightHip"]]
    offsets = R.rotate(pelvis, SKELETON.offsets[joints].double())
    knee, ankle = SKELETON.offsets[[_J["LeftKnee"], _J["LeftAnkle"]], 1]
    length = float(-knee - ankle)

    # the height of the hips at which the first leg would be straight
    hips, wanted = _hips(plan, rhythm)
    ceiling = np.full(len(hips), 9.0)
    for name, foot in feet.items():
        i = SIDES.index(name)
        gap = (ankles[:, i] - offsets[:, i]).numpy() - hips
        flat = np.minimum(np.hypot(gap[:, 0], gap[:, 2]), 0.9 * length)
        straight = gap[:, 1] + 0.1 * foot.air + np.sqrt((0.999 * length) ** 2 - flat**2)
        ceiling = np.minimum(ceiling, straight)

    # the hips are as high as style and legs allow: a smooth minimum of both
    run = plan.running
    low = (1 - run) * _below(ceiling, 4) + run * _below(ceiling, 9)
    hips[:, 1] = (wanted + low - np.sqrt((wanted - low) ** 2 + 0.002**2)) / 2
    hips = torch.from_numpy(hips)
    hip = hips[:, None] + offsets
    facing = R.yaw(torch.from_numpy(plan.root[:, 2]))

    # the raised leg of a hopping style is bent backwards
    for i, name in enumerate(SIDES):
        if name not in feet:
            bent = torch.tensor([0.0, -0.47, -0.27], dtype=torch.float64)
            ankles[:, i] = hips + offsets[:, i] + R.rotate(facing, bent)
            ankles[:, i, 1] += torch.from_numpy(0.03 * rhythm.sin)
            yaw[:, i] = plan.root[:, 2]
            pitch[:, i] = toe_pitch[:, i] = -1.1

    # in the swing a kicking leg is straight: its direction is blended with that of the kick …
    reach = ankles - hip
    far = R.length(reach)
    angles = [math.radians(plan.style.leg(side).kick) for side in SIDES]
    angle = torch.tensor(angles, dtype=torch.float64)
    aim = torch.stack((0 * angle, -torch.cos(angle), torch.sin(angle)), -1) * angle.sign()[:, None]
    weight = torch.from_numpy(kick)[..., None] * angle.sign()[:, None]
    kicked = R.rotate(facing[:, None], aim)
    aim = R.normalize((1 - weight) * reach / far + weight * kicked)

    # … and its length with that of a straight one; no leg folds completely
    folded = (FOLDED - far + ((FOLDED - far) ** 2 + 0.0025).sqrt()) / 2
    far = far + torch.from_numpy(air)[..., None] * folded
    ankles = hip + aim * (far + weight**3 * (0.985 * length - far))

    # the knee points between the directions of pelvis and foot; a swing may miss its target
    turn = R.yaw(torch.from_numpy(yaw))
    line = R.normalize(ankles - hip)
    pole = torch.linalg.cross(line, R.rotate(pelvis, _X) + R.rotate(turn, _X))
    rest = SKELETON.rest_positions.double()
    straight = [hip + (rest[[_J["Left" + part], _J["Right" + part]]] - rest[joints])
                for part in ("Knee", "Ankle")]
    soft = torch.from_numpy(0.002 + 0.04 * slack)[..., None]
    knee, ankle = two_bone(hip, *straight, ankles, pole, soft=soft)
    hinge = R.normalize(torch.linalg.cross(pole, line))
    thigh, shin = (R.from_matrix(torch.stack((hinge, y, torch.linalg.cross(hinge, y)), -1))
                   for y in (R.normalize(hip - knee), R.normalize(knee - ankle)))

    # in the swing the foot follows the shin, within the range of the ankle
    up = knee - ankle
    lean = torch.atan2((up * R.rotate(turn, _Z)).sum(-1), up[..., 1]).numpy()
    for limit, sign in ((DORSAL, 1), (PLANTAR, -1)):
        excess = sign * (pitch + lean - limit)
        excess = sign * air * (excess + np.sqrt(excess**2 + 0.01)) / 2
        pitch, toe_pitch = pitch - excess, toe_pitch - excess

    # world rotations from the pelvis outwards, as local ones
    sole, toes = (torch.stack([_foot_rotation(yaw[:, i], tilt[:, i]) for i in (0, 1)], 1)
                  for tilt in (pitch, toe_pitch))
    chain = torch.stack((pelvis.expand(-1, 2, 4), thigh, shin, sole, toes), 2)
    return R.multiply(R.inverse(chain[:, :, :-1]), chain[:, :, 1:]), hips


def _below(ceiling: np.ndarray, half: int) -> np.ndarray:
    """A smooth curve just below another one, from its minimum in windows of ± `half` frames."""
    low = scipy.ndimage.minimum_filter1d(ceiling, 2 * half + 1, mode="nearest")
    hann = np.hanning(2 * half + 3)[1:-1]
    padded = np.pad(low, half, mode="edge")
    return np.convolve(padded, hann / hann.sum(), mode="valid") - 0.001


def _foot_rotation(yaw: np.ndarray, pitch: np.ndarray) -> Tensor:
    angles = np.stack((yaw, -pitch, np.zeros_like(yaw)), -1)
    return R.from_euler(torch.from_numpy(angles), "YXZ")


def _pin_hand(local: Tensor, hips: Tensor, side: str, arm: Arm) -> None:
    """Set shoulder and elbow so that the wrist stays at `Arm.hand_at` in the hips' frame."""
    sign, name = (1.0 if side == "left" else -1.0), side.capitalize()
    turned, positions = forward_kinematics(SKELETON, local, hips)
    shoulder, elbow, wrist = (_J[name + part] for part in ("Shoulder", "Elbow", "Wrist"))
    outwards, up, front = arm.hand_at
    place = torch.tensor([sign * outwards, up, front], dtype=local.dtype)
    backwards = torch.tensor([sign * 0.7, 0.0, -1.0], dtype=local.dtype)
    target, pole = hips + R.rotate(local[:, 0], place), R.rotate(local[:, 0], backwards)
    b, c = two_bone(*(positions[:, j] for j in (shoulder, elbow, wrist)), target, pole)

    # the upper arm's x axis lies along it, and its z axis in the plane of the bent arm
    upper, lower = R.normalize(b - positions[:, shoulder]), R.normalize(c - b)
    x = sign * upper
    z = R.normalize(lower - (lower * upper).sum(-1, keepdim=True) * upper)
    world = R.from_matrix(torch.stack((x, torch.linalg.cross(z, x), z), -1))
    local[:, shoulder] = R.multiply(R.inverse(turned[:, _J[name + "Collar"]]), world)
    bend = torch.atan2((lower * z).sum(-1), (lower * upper).sum(-1))
    local[:, elbow] = R.yaw(-sign * bend)
