"""Body pose over procedural footsteps: a pelvis within reach of the feet, and trunk and arms that follow the step phase."""

import math
from collections.abc import Sequence

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.datasets.procedural_steps import FOOT, FPS, Foot, Plan, smooth, smooth_noise
from toolkit.datasets.procedural_styles import Arm
from toolkit.motion import Skeleton, forward_kinematics
from toolkit.motion import rotations as R
from toolkit.motion.clip import SIDES
from toolkit.motion.ik import two_bone

_SPINE = (("Hips", -1, 0, 0, 0), ("Chest", 0, 0, 0.130, 0), ("Chest2", 1, 0, 0.103, 0), ("Chest3", 2, 0, 0.093, 0),
          ("Chest4", 3, 0, 0.093, 0), ("Neck", 4, 0, 0.133, 0), ("Head", 5, 0, 0.090, 0), ("HeadEnd", 6, 0, 0.171, 0))
_ARM = (("Collar", 4, 0.032, 0.075, 0), ("Shoulder", 8, 0.158, 0, 0), ("Elbow", 9, 0.312, 0, 0),
        ("Wrist", 10, 0.255, 0, 0), ("WristEnd", 11, 0.191, 0, 0))
_LEG = (("Hip", 0, 0.107, 0.001, 0), ("Knee", 18, 0, -0.437, 0), ("Ankle", 19, 0, -0.432, 0),
        ("Toe", 20, *FOOT), ("ToeEnd", 21, 0, -0.013, 0.049))


def _skeleton() -> Skeleton:
    rows = list(_SPINE)
    for limb in (_ARM, _LEG):
        for side, sign, shift in (("Right", -1, 0), ("Left", 1, 5)):
            rows += [(side + n, p + shift * (i > 0), sign * x, y, z) for i, (n, p, x, y, z) in enumerate(limb)]
    return Skeleton([r[0] for r in rows], [r[1] for r in rows], torch.tensor([r[2:] for r in rows]))


#: 100STYLE's 28 points: same names, order and axes, lengths to the millimetre; zero rotation is a T-pose facing +Z.
SKELETON = _skeleton()
_J = {name: j for j, name in enumerate(SKELETON.names)}
FOLDED = 0.34  # metres, least distance of hip joint and ankle
_FOOT = torch.tensor(FOOT, dtype=torch.float64)


def pose(plan: Plan, feet: dict[str, Foot]) -> tuple[Tensor, Tensor]:
    """Local rotations ``[F, J, 4]`` and root positions ``[F, 3]``."""
    style, frames, run = plan.style, len(plan.t), plan.running
    amount = smooth(np.minimum(plan.pace, 1.5) ** 0.6 * (plan.pace > 0.02), 8)
    still = np.clip(1 - amount, 0, 1)
    beat = plan.clock - plan.middle  # 0 in the middle of the left foot's swing
    sin, cos, cos2 = amount * np.sin(beat), amount * np.cos(beat), amount * np.cos(2 * beat)
    noise = (style.noise + 2 * style.stagger) * smooth_noise(plan.rng, frames, 22, 8).T
    breath = 0.6 * np.sin(2 * math.pi * 0.25 / FPS * plan.t)
    bank = smooth(np.clip(np.degrees(np.arctan(plan.ahead * plan.turning / 9.81)), -20, 20), 8)
    hopping = len(plan.stepping) == 1

    euler = np.zeros((frames, len(SKELETON), 3))  # degrees: turn to the left, forward pitch, roll to the right

    def turn(joints: Sequence[str], y=0.0, x=0.0, z=0.0) -> None:
        for name in joints:
            euler[:, _J[name]] += np.stack(np.broadcast_arrays(y, x, z, np.zeros(frames))[:3], 1) / len(joints)

    speedup = 1 + 0.4 * run
    even = 0.0 if hopping else 1.0
    turn(["Hips"], -style.yaw * speedup * sin * even, style.tilt + 3 * run, -style.drop * cos * even - 0.5 * bank)
    spine = ["Chest", "Chest2", "Chest3", "Chest4"]
    lean = style.lean + 5 * run + style.lean_swing * cos2 + breath + 3 * noise[0]
    turn(spine, style.twist + (style.yaw + style.twist_swing) * speedup * sin * even + 2.5 * noise[1], lean,
         -style.bend + (style.bend_swing + style.drop) * cos * even - 0.3 * bank + 3 * noise[2])
    undo = -style.steady * (euler[:, _J["Hips"]] + euler[:, [_J[s] for s in spine]].sum(1))
    undo += style.steady * np.array([style.twist, style.tilt + style.lean, -style.bend])
    turn(["Neck", "Head"], undo[:, 0] + style.head_turn + np.degrees(0.25 * smooth(plan.turning, 10)) + 4 * noise[3],
         undo[:, 1] - 6 * run, undo[:, 2] - style.head_roll + style.head_swing * cos + 3 * noise[4])
    turn(["Neck"], 0, style.neck)
    turn(["Head"], 0, style.head)

    twist = np.zeros((frames, 2))
    for i, side in enumerate(SIDES):
        arm, sign, name = style.arm(side), 1 if side == "left" else -1, side.capitalize()
        swing = -amount * np.sin(arm.ratio * plan.clock - plan.middle - math.radians(arm.phase) + math.pi * i)
        loose = (arm.run_elbow > arm.elbow) * run
        flex = arm.forward + arm.swing * (1 + 0.3 * run) * swing + 4 * noise[5 + i] - 4 * loose
        out = arm.out + arm.out_swing * cos + 3 * noise[7] + 4 * loose
        elbow = arm.elbow + arm.elbow_swing * swing + run * (arm.run_elbow - arm.elbow) + 2 * noise[5 + i]
        turn([name + "Collar"], 0, 0, sign * style.shrug)
        turn([name + "Shoulder"], 0, -flex, sign * (out - 90 - style.shrug))
        turn([name + "Elbow"], -sign * np.clip(elbow, 0, 140))
        turn([name + "Wrist"], -sign * arm.wrist)
        twist[:, i] = arm.twist * (1 - 0.6 * loose)

    local = R.from_euler(torch.from_numpy(np.radians(euler)), "YXZ")
    facing = torch.from_numpy(plan.root[:, 2])
    local[:, 0] = R.multiply(R.yaw(facing), local[:, 0])
    shoulders = [_J["LeftShoulder"], _J["RightShoulder"]]
    along = torch.tensor([1.0, 0.0, 0.0], dtype=torch.float64)
    local[:, shoulders] = R.multiply(local[:, shoulders], R.from_axis_angle(along, torch.from_numpy(np.radians(twist))))

    # the hips follow the path, sway over the standing foot, and are as high as style and legs allow
    side = -style.sway * cos * even + 0.012 * still * even * smooth_noise(plan.rng, frames, 50, 1)[:, 0]
    side = side + 0.04 * style.stagger * smooth_noise(plan.rng, frames, 30, 1)[:, 0]
    if hopping:
        side = side + (0.02 if plan.stepping[0] == "left" else -0.02)
    front = style.forward + 0.04 * style.noise * noise[3] * amount - style.surge * amount * np.sin(2 * beat) * even
    c, s = np.cos(plan.root[:, 2]), np.sin(plan.root[:, 2])
    hips = np.stack((plan.root[:, 0] + side * c + front * s, np.zeros(frames), plan.root[:, 1] - side * s + front * c), 1)
    up = style.bob * amount * np.cos(beat) if hopping else (style.bob * (1 - run) - 0.03 * run) * cos2
    sink = min(max(style.height - 0.75, 0.1), 0.2) / 2  # runners land with bent knees
    wanted = style.height + (0.01 + 0.004 * breath) * still - sink * run + up
    joints = [_J["LeftHip"], _J["RightHip"]]
    offsets = R.rotate(local[:, :1], SKELETON.offsets[joints].double())  # [F, 2, 3] hips → hip joint
    length = float(-SKELETON.offsets[_J["LeftKnee"], 1] - SKELETON.offsets[_J["LeftAnkle"], 1])

    ankles = torch.zeros(frames, 2, 3, dtype=torch.float64)
    yaws, pitches, toes, airs, slacks, kicks = (np.zeros((frames, 2)) for _ in range(6))
    ceiling = np.full(frames, 9.0)
    for name, foot in feet.items():
        i = SIDES.index(name)
        yaws[:, i], pitches[:, i], airs[:, i] = foot.yaw, foot.pitch, foot.air
        slacks[:, i], kicks[:, i] = foot.slack, foot.kick
        toes[:, i] = foot.pitch - np.minimum(foot.pitch, 0) * foot.flatness
        ankles[:, i] = torch.from_numpy(foot.toe) - R.rotate(_foot_rotation(foot.yaw, foot.pitch), _FOOT)
        gap = (ankles[:, i] - offsets[:, i]).numpy() - hips
        flat = np.minimum(np.hypot(gap[:, 0], gap[:, 2]), 0.9 * length)
        ceiling = np.minimum(ceiling, gap[:, 1] + 0.1 * foot.air + np.sqrt((0.999 * length) ** 2 - flat**2))
    low = (1 - run) * _below(ceiling, 4) + run * _below(ceiling, 9)
    hips[:, 1] = (wanted + low - np.sqrt((wanted - low) ** 2 + 0.002**2)) / 2
    hips = torch.from_numpy(hips)

    for i, name in enumerate(SIDES):
        if name not in feet:  # the raised leg is bent backwards
            bent = torch.tensor([0.0, -0.47, -0.27], dtype=torch.float64)
            ankles[:, i] = hips + offsets[:, i] + R.rotate(R.yaw(facing), bent)
            ankles[:, i, 1] += torch.from_numpy(0.03 * sin)
            yaws[:, i], pitches[:, i], toes[:, i] = plan.root[:, 2], -1.1, -1.1
    a = hips[:, None] + offsets
    # in the swing a kicking leg is straight, and no leg folds completely
    reach = ankles - a
    far = reach.norm(dim=-1, keepdim=True)
    kick = torch.tensor([math.radians(style.leg(side).kick) for side in SIDES], dtype=torch.float64)
    aim = torch.stack((0 * kick, -torch.cos(kick), torch.sin(kick)), -1) * kick.sign()[:, None]
    weight = torch.from_numpy(kicks)[..., None] * kick.sign()[:, None]
    aim = R.normalize((1 - weight) * reach / far + weight * R.rotate(R.yaw(facing)[:, None], aim))
    folded = (FOLDED - far + ((FOLDED - far) ** 2 + 0.0025).sqrt()) / 2
    far = far + torch.from_numpy(airs)[..., None] * folded
    ankles = a + aim * (far + weight**3 * (0.985 * length - far))
    line = R.normalize(ankles - a)
    left = R.rotate(local[:, :1], along) + R.rotate(R.yaw(torch.from_numpy(yaws)), along)
    pole = torch.linalg.cross(line, left)
    rest = SKELETON.rest_positions.double()
    knee = [_J["LeftKnee"], _J["RightKnee"]]
    ankle = [_J["LeftAnkle"], _J["RightAnkle"]]
    soft = torch.from_numpy(0.002 + 0.04 * slacks)[..., None]  # in the swing a leg may miss its target
    b, e = two_bone(a, a + (rest[knee] - rest[joints]), a + (rest[ankle] - rest[joints]), ankles, pole, soft=soft)
    hinge = R.normalize(torch.linalg.cross(pole, line))
    thigh, shin = (R.from_matrix(torch.stack((hinge, y, torch.linalg.cross(hinge, y)), -1))
                   for y in (R.normalize(a - b), R.normalize(b - e)))
    # in the swing the foot follows the shin: at most 35° of dorsiflexion and 45° of plantar flexion
    front = R.rotate(R.yaw(torch.from_numpy(yaws)), torch.tensor([0.0, 0.0, 1.0], dtype=torch.float64))
    shin_lean = torch.atan2(((b - e) * front).sum(-1), (b - e)[..., 1]).numpy()
    for limit, sign in ((0.6, 1), (-0.8, -1)):
        excess = sign * (pitches + shin_lean - limit)
        excess = sign * airs * (excess + np.sqrt(excess**2 + 0.01)) / 2
        pitches, toes = pitches - excess, toes - excess
    feet_q, toes_q = (torch.stack([_foot_rotation(yaws[:, i], x[:, i]) for i in (0, 1)], 1) for x in (pitches, toes))
    chain = torch.stack((local[:, :1].expand(-1, 2, 4), thigh, shin, feet_q, toes_q), 2)
    relative = R.multiply(R.inverse(chain[:, :, :-1]), chain[:, :, 1:])
    for i, name in enumerate(("Left", "Right")):
        local[:, [_J[name + part] for part in ("Hip", "Knee", "Ankle", "Toe")]] = relative[:, i]
    for side in SIDES:
        if style.arm(side).hand_at is not None:
            _pin_hand(local, hips, side, style.arm(side))
    return local.float(), hips.float()


def _below(ceiling: np.ndarray, half: int) -> np.ndarray:
    """A smooth curve just below another one, from its minimum in windows of ± `half` frames."""
    low = scipy.ndimage.minimum_filter1d(ceiling, 2 * half + 1, mode="nearest")
    hann = np.hanning(2 * half + 3)[1:-1]
    return np.convolve(np.pad(low, half, mode="edge"), hann / hann.sum(), mode="valid") - 0.001


def _foot_rotation(yaw: np.ndarray, pitch: np.ndarray) -> Tensor:
    return R.from_euler(torch.from_numpy(np.stack((yaw, -pitch, np.zeros_like(yaw)), -1)), "YXZ")


def _pin_hand(local: Tensor, hips: Tensor, side: str, arm: Arm) -> None:
    """Set shoulder and elbow in ``local`` so that the wrist stays at `Arm.hand_at` in the hips' frame."""
    sign, name = (1.0 if side == "left" else -1.0), side.capitalize()
    turned, positions = forward_kinematics(SKELETON, local, hips)
    shoulder, elbow, wrist = (_J[name + part] for part in ("Shoulder", "Elbow", "Wrist"))
    outwards, up, front = arm.hand_at
    target = hips + R.rotate(local[:, 0], torch.tensor([sign * outwards, up, front], dtype=local.dtype))
    pole = R.rotate(local[:, 0], torch.tensor([sign * 0.7, 0.0, -1.0], dtype=local.dtype))
    b, c = two_bone(*(positions[:, j] for j in (shoulder, elbow, wrist)), target, pole)
    upper, lower = R.normalize(b - positions[:, shoulder]), R.normalize(c - b)
    x = sign * upper
    z = R.normalize(lower - (lower * upper).sum(-1, keepdim=True) * upper)
    world = R.from_matrix(torch.stack((x, torch.linalg.cross(z, x), z), -1))
    local[:, shoulder] = R.multiply(R.inverse(turned[:, _J[name + "Collar"]]), world)
    bend = torch.atan2((lower * z).sum(-1), (lower * upper).sum(-1))
    local[:, elbow] = R.yaw(-sign * bend)
