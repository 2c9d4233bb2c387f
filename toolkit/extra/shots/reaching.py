"""Poses that meet pins (`toolkit.extra.shots.pins`), as ``view/scene/pins.js`` computes them.

The trunk leans and the hips sink by what an arm lacks, limbs are bent by IK, and feet stay where
they step.
"""

import math
from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.extra.shots.following import EASINGS, FPS, Course, Pair
from toolkit.extra.shots.keys import HANDS, LIMBS, Pin
from toolkit.extra.shots.pins import weights
from toolkit.motion import local_rotations, rotations as R
from toolkit.motion.ik import plant_feet, two_bone
from toolkit.motion.roles import CHAINS
from toolkit.motion.skeleton import FEET, Skeleton, forward_kinematics

LIFT = 0.1  # metres by which a foot goes up on its way
SOFT = 0.04  # share of an arm's length over which it is stretched more and more slowly
ROUNDS, REACH = 10, 0.93  # of the search for a lean; share of an arm's length that is used
FOLD = 0.4  # the least share: elbows fold no farther
SMOOTH = 0.04  # metres around this length, over which the body begins to follow gently
CARRY = 0.3  # seconds before and after a pin from which on its place goes along with the body
FAR = 1.2  # metres from the planned place beyond which a pin is left out
LEAN, SHIFT, SINK = 1.1, 0.15, 0.4  # most: radians of the trunk, metres of the hips
LOW, LOWEST = 0.3, 0.8  # metres below the shoulder between which hips begin to sink
LOOK, BEHIND = 1.2, 0.7  # radians of the head at most; before the back, where it gives up


def _place(course: Course, time: float) -> Pair:
    return course.curve.point(course.distance[min(round(time * FPS), len(course.distance) - 1)])


def pinned(skeleton: Skeleton, rotations: Tensor, root: Tensor,
           pins: Sequence[Pin], course: Course) -> tuple[Tensor, Tensor]:
    """Local rotations ``[F, J, 4]`` and root positions ``[F, 3]`` that meet the pins."""
    pins = [pin for pin in pins if all(
        math.dist(_place(course, time), (goal[0], goal[2])) <= FAR for time in (pin.at, pin.end)
        for limb in LIMBS if (goal := getattr(pin, limb)) is not None)]
    times = torch.arange(1, len(root) + 1, dtype=torch.float64) / FPS
    parts = {part: weights(pins, part, times) for part in (*LIMBS, "look", "pose")}
    chosen = torch.stack([total for _, total in parts.values()]).amax(0).nonzero()[:, 0]
    if not len(chosen):
        return rotations, root
    parts = {part: ([(pin, w[chosen].to(root)) for pin, w in found], total[chosen].to(root))
             for part, (found, total) in parts.items()}
    local, place = _posed(skeleton, rotations[chosen], root[chosen], parts["pose"][0])
    steps, before = forward_kinematics(skeleton, rotations[chosen], root[chosen])
    turned, p = forward_kinematics(skeleton, local, place)
    left = R.normalize(p[:, skeleton.role("left_hip")] - p[:, skeleton.role("right_hip")])
    down = left.new_tensor([0.0, -1.0, 0.0]).expand_as(left)
    back = torch.linalg.cross(down, left)

    def carried(pin: Pin) -> Tensor:
        """How far a pinned place goes along with the body before and after its time."""
        ways = []
        for now in times[chosen].tolist():
            held = min(max(now, pin.at), pin.end)
            share = EASINGS["smoother"](min(abs(now - held) / CARRY, 1.0))
            (x, z), (px, pz) = (_place(course, time) for time in (now, held))
            ways.append((share * (x - px), 0.0, share * (z - pz)))
        return root.new_tensor(ways)

    goals = {}  # of a limb: its goal, the weight of all pins, and place and weight of each
    for limb in LIMBS:
        own, found = p[:, skeleton.role(limb)], []
        goal = own
        for pin, w in parts[limb][0]:
            to, w = root.new_tensor(getattr(pin, limb)) + carried(pin), w[:, None]
            found.append((to, w))
            level = w if limb in HANDS else w * w  # a foot goes up first
            goal = goal + torch.cat((level, w, level), -1) * (to - goal)
            if limb not in HANDS:
                goal = goal - 4 * LIFT * w * (1 - w) * down
        goals[limb] = goal, parts[limb][1][:, None], found

    # the trunk leans and the hips move by what arms lack, and over the foot that stands
    spine = skeleton.trunk[::-1]
    bend, shift = _leaned(skeleton, p, spine, goals)
    for side, other in (FEET, FEET[::-1]):
        stands = p[:, skeleton.role(f"{other}_foot")] - place
        shift = shift + goals[f"{side}_foot"][1] * stands * stands.new_tensor([0.5, 0, 0.5])
    shares = {j: (k + 1) / len(spine) for k, j in enumerate(spine)}
    legs = set(skeleton.both("hip"))
    for j in range(1, len(skeleton)):
        above = skeleton.tree.up(j)
        if not legs.isdisjoint(above):
            turned[:, j] = steps[:, j]
        else:
            shares[j] = next(shares[i] for i in above if i in shares)
    for j, share in shares.items():
        turned[:, j] = R.multiply(_turn(share * bend), turned[:, j])
    place = place + shift
    p = forward_kinematics(skeleton, local_rotations(skeleton, turned), place)[1]

    # the head turns to what is looked at
    head = skeleton.neck[-1]
    ahead = R.rotate(turned[:, head], skeleton.facing_axis.to(root).expand(len(place), 3))
    aim = torch.zeros_like(place)
    for pin, w in parts["look"][0]:
        way = _looked(ahead, root.new_tensor(pin.look) - p[:, head])
        aim = aim + w[:, None] * (way - aim)
    for k, j in enumerate(skeleton.neck[1:], 1):
        turn = _turn(aim * k / (len(skeleton.neck) - 1))
        for i in skeleton.tree.below(j) if j == head else [j]:
            turned[:, i] = R.multiply(turn, turned[:, i])

    # arms are bent to their pins, with elbows that point down, outwards and back
    for limb in HANDS:
        side = limb.removesuffix("_hand")
        joints = _limb(skeleton, side, "arm")
        a, b, c = (p[:, j] for j in joints)
        upper, lower, out = b - a, c - b, left if side == "left" else -left
        for to, w in goals[limb][2]:
            line = R.normalize(to - a)
            pole = torch.linalg.cross(left, line) + 0.4 * out + 0.3 * (down + back)
            elbow, hand = two_bone(a, b, c, to, pole, soft=SOFT)
            upper = _swung(upper, elbow - a, out - back, w)
            lower = _swung(lower, hand - elbow, out - back, w)
        keep = goals[limb][1] > 0
        aims = R.between(b - a, upper), R.between(c - b, lower)
        for j in skeleton.tree.below(joints[0]):
            aim = aims[int(joints[1] in skeleton.tree.up(j))]
            turned[:, j] = torch.where(keep, R.multiply(aim, turned[:, j]), turned[:, j])

    # feet stay where they stepped, or go to their pins
    toes = []
    for side in FEET:
        foot, toe = (before[:, skeleton.role(f"{side}_{part}")] for part in ("foot", "toe"))
        toes.append(toe + goals[f"{side}_foot"][0] - foot)
    local = plant_feet(skeleton, local_rotations(skeleton, turned), place, torch.stack(toes, 1))
    return rotations.index_copy(0, chosen, local), root.index_copy(0, chosen, place)


def figure(skeleton: Skeleton) -> dict[str, list]:
    """The joints that `pinned` turns, for ``view/scene/pins.js``."""
    return {"spine": skeleton.trunk[::-1], "neck": skeleton.neck,
            "arms": [_limb(skeleton, side, "arm") for side in FEET],
            "facing": skeleton.facing_axis.tolist(), "names": list(skeleton.names)}


def _limb(skeleton: Skeleton, side: str, kind: str) -> list[int]:
    """Joints of an arm or a leg, outwards."""
    return [skeleton.role(f"{side}_{part}") for part in CHAINS[kind]]


def _posed(skeleton: Skeleton, local: Tensor, root: Tensor,
           found: list[tuple[Pin, Tensor]]) -> tuple[Tensor, Tensor]:
    """Poses blended towards those of pins, where they are and as they face."""
    facing = R.rotate(local[:, 0], skeleton.facing_axis.to(root).expand(len(root), 3))
    heading = R.yaw(torch.atan2(facing[:, 0], facing[:, 2]))
    mixed, height = local, root[:, 1]
    for pin, w in found:
        if unknown := pin.pose.keys() - set(skeleton.names):
            raise ValueError(f"a pin's pose has the joint {min(unknown)!r}; the skeleton has "
                             f"{', '.join(skeleton.names)}")
        goal = local.clone()
        for name, turn in pin.pose.items():
            goal[:, skeleton.names.index(name)] = root.new_tensor(turn)
        low = forward_kinematics(skeleton, goal, 0 * root)[1][..., 1].amin(-1)
        goal[:, 0] = R.multiply(heading, goal[:, 0])
        mixed, height = R.slerp(mixed, goal, w[:, None]), height - w * (low + height)
    return mixed, torch.stack((root[:, 0], height, root[:, 2]), -1)


def _leaned(skeleton: Skeleton, p: Tensor, spine: list[int],
            goals: dict) -> tuple[Tensor, Tensor]:
    """Rotation vector of the chest and shift of the hips ``[F, 3]`` with which arms reach.

    Joint k of the K of the spine turns by k / K of it. What a shoulder lacks is added to both,
    arm after arm, `ROUNDS` times.
    """
    bend, sink = torch.zeros_like(p[:, 0]), torch.zeros_like(p[:, 0, :1])
    move, bones = torch.zeros_like(bend), [b - a for a, b in zip(
        (p[:, j] for j in spine), (p[:, j] for j in spine[1:]), strict=False)]

    def shifted() -> Tensor:
        # hips that move aside sink as far as straight legs need
        drop = sink + move.square().sum(-1, keepdim=True)
        return move - torch.nn.functional.pad(drop, (1, 1))

    for _ in range(ROUNDS):
        for side in FEET:
            target, weight, _ = goals[f"{side}_foot"]
            hip, knee, foot = (p[:, j] for j in _limb(skeleton, side, "leg"))
            lack, _ = _lack(target - hip - shifted(), hip, knee, foot)
            sink = _limited(sink + weight * lack.clamp_min(0), SINK)
            target, weight, _ = goals[f"{side}_hand"]
            a, b, c = (p[:, j] for j in _limb(skeleton, side, "arm"))
            chest = p[:, spine[0]] + shifted()
            for k, bone in enumerate(bones, 1):
                chest = chest + R.rotate(_turn(bend * k / len(spine)), bone)
            shoulder = chest + R.rotate(_turn(bend), a - p[:, spine[-1]])
            way = target - shoulder
            size, far = _lack(way, a, b, c)
            lack = weight * size * way / far
            lever = shoulder - p[:, spine[0]] - shifted()
            bend = _limited(bend + 0.7 * torch.linalg.cross(lever, lack)
                            / lever.square().sum(-1, keepdim=True), LEAN)
            low = ((-way[:, 1:2] - LOW) / (LOWEST - LOW)).clamp(0, 1)
            move = _limited(move + lack * lack.new_tensor([1, 0, 1]) / 4, SHIFT)
            sink = _limited(sink + low * weight * size.clamp_min(0) / 2, SINK)
    return bend, shifted()


def _lack(way: Tensor, a: Tensor, b: Tensor, c: Tensor) -> tuple[Tensor, Tensor]:
    """By how much a limb is too short for a place, or too long (negative), and how far it is."""
    far = R.length(way).clamp_min(1e-6)
    full = R.length(b - a) + R.length(c - b)
    lack, spare = (torch.where(over > SMOOTH, over, (over + SMOOTH).clamp_min(0).square()
                               / (4 * SMOOTH)) for over in (far - REACH * full, FOLD * full - far))
    return lack - spare, far


def _arc(a: Tensor, b: Tensor) -> Tensor:
    """Rotation vector ``[F, 3]`` of the shortest turn from a direction to another."""
    axis = torch.linalg.cross(a, b)
    size = R.length(axis)
    return torch.atan2(size, (a * b).sum(-1, keepdim=True)) * axis / size.clamp_min(1e-9)


def _swung(a: Tensor, b: Tensor, aside: Tensor, w: Tensor) -> Tensor:
    """A direction between two, past a third one if they are opposite."""
    a, b = R.normalize(a), R.normalize(b)
    middle, turned = R.normalize(a + b + aside / 3), []
    for start, goal in ((a, middle), (middle, b)):
        turned.append(R.rotate(_turn(w * _arc(start, goal)), start))
    return R.rotate(_turn(w * _arc(*turned)), turned[0])


def _looked(ahead: Tensor, way: Tensor) -> Tensor:
    """Rotation vector ``[F, 3]`` of a head, at most `LOOK`, and none to what is behind it."""
    arc = _arc(ahead, way)
    fade = ((torch.pi - R.length(arc)) / BEHIND).clamp(0, 1)
    return fade**2 * (3 - 2 * fade) * _limited(arc, LOOK)


def _limited(v: Tensor, most: float) -> Tensor:
    """Vectors no longer than a limit, which they approach smoothly from nine tenths of it on."""
    size = R.length(v)
    over = (size / most - 0.9).clamp_min(0.0)
    soft = most * (1 - 0.1 * torch.exp(-10 * over))
    return v * torch.where(over > 0, soft / size.clamp_min(1e-9), 1.0)


def _turn(v: Tensor) -> Tensor:
    """The rotation of a rotation vector."""
    size = R.length(v)
    return R.from_axis_angle(v / size.clamp_min(1e-9), size[..., 0])
