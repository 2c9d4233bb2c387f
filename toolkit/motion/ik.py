"""Inverse kinematics of legs and arms, and the foot lock. Tensors of any leading shape.

A frame of a character uses them in this order: `hold_feet` says where the feet should point,
`foot_lock` where the toes should be, `solve_legs` bends the predicted legs towards them, and
lets the hips `sink` where a leg is too short. For a drawn pose, `swivelled`, `turn_arms` and
`plant_feet` turn bones of a skeleton.
"""

import math
from itertools import pairwise

import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.roles import CHAINS
from toolkit.motion.skeleton import FEET, Skeleton, forward_kinematics, local_rotations
from toolkit.motion.springs import spring

LEG = *CHAINS["leg"], "toe"  # parts of a leg
# Shares of a leg's length over which it stretches more and more slowly: with its toe in contact,
# and in the air, where a knee that is nearly straight would move too fast.
SOFT, SWING = 0.01, 0.03
STRAIGHT = 0.1  # sine of the angle of thigh and leg below which the knee is drawn to the front
NEAR = 0.08  # metres that a locked toe may always be off its prediction towards the other toe
SLACK = 0.3  # metres that a locked toe may stay behind its prediction
RETURN = 10.0  # per second: decay of a released toe's offset from its prediction, and of the hips'
ROOM = 0.035  # of a leg's length: half of the range over which hips begin to sink gently
DEEPEST = 0.115  # of a leg's length: hips sink at most so far
FALL = 0.6  # m/s, at which they sink at most
# Ankles are at least ASIDE of a leg's length apart sideways, until one is PASSED of it ahead of the
# other; for each metre more, this least distance falls by CROSSING metres.
ASIDE, PASSED, CROSSING = 0.05, 0.15, 1.5
PUSH = 2.0  # m/s, at which a foot is pushed out at most
BOTH = 0.99  # contact of both feet from which the body stands on both
UNEVEN, SUNK = 0.02, 0.01  # metres that a toe may be over and under the height of standing toes
HEEL = 2.0  # length from heel to toe, over that from ankle to toe; generous
LEVEL = 0.2  # seconds: time constant with which a larger distance decays to it
SWIVEL = 0.8  # radians by which a standing foot may be turned from its prediction
SETTLE = 0.04  # m/s, at which toes of a body on both feet go to the height of standing toes


def two_bone(a: Tensor, b: Tensor, c: Tensor, target: Tensor, pole: Tensor | None = None, *,
             soft: float | Tensor = SOFT, left: Tensor | None = None) -> tuple[Tensor, Tensor]:
    """Bend a limb of two bones so that its end meets a target, by the law of cosines.

    The bones keep their lengths. Over the last share ``soft`` of the full length, the end follows
    the target more and more slowly. It never reaches full stretch, where the angle of the knee
    changes infinitely fast with the distance. A target too near for the folded limb is moved out to
    the nearest distance that the limb can reach.

    Parameters
    ----------
    a, b, c : Tensor [..., 3]
        Positions of the limb's root, middle and end before (hip, knee, ankle), metres.
    target : Tensor [..., 3], wanted position of the end, metres
    pole : Tensor [..., 3]
        Direction (not a point) that the middle joint bends towards, of any length, not parallel to
        the line from `a` to the target. By default the limb bends to the same side as before,
        turned with the line from `a` to its end.
    soft : share of the full length, in [0, 1), a number or Tensor [..., 1]
    left : Tensor [..., 3]
        From the right hip to the left one: a knee that bends backwards is mirrored to the front,
        and that of a leg which is nearly `STRAIGHT` goes there, because its side is chance.

    Returns
    -------
    middle, end : Tensor [..., 3], new positions of `b` and `c`
    """
    # The end lies on the line from the root to the target, as far away as the target, but not
    # beyond the soft limit nor nearer than the folded limb.
    upper, lower = R.length(b - a), R.length(c - b)
    full = upper + lower
    reach = target - a
    wanted = R.length(reach)
    line = R.normalize(torch.where(wanted > 1e-9, reach, c - a + 1e-9))
    margin = (soft * full).clamp_min(1e-9)
    over = (wanted - (full - margin)).clamp_min(0.0)
    distance = torch.where(over > 0, full - margin * torch.exp(-over / margin), wanted)
    distance = torch.maximum(distance, (upper - lower).abs() + 1e-6 * full)

    # The middle lies beside this line, on the side of the pole: ``across`` is that direction.
    side = R.normalize(R.rotate(R.between(c - a, line), b - a) if pole is None else pole)
    across = side - (side * line).sum(-1, keepdim=True) * line
    if left is not None:
        front = torch.linalg.cross(line, R.normalize(left).expand_as(line))
        across = across - 2 * (across * front).sum(-1, keepdim=True).clamp_max(0.0) * front
        across = across + (STRAIGHT - R.length(across)).clamp_min(0.0) * front
    aside = torch.linalg.cross(line, R.least_axis(line))
    across = R.normalize(torch.where(R.length(across) > 1e-5, across, aside))

    # How far along the line and beside it, by the law of cosines.
    along = (upper**2 - lower**2 + distance**2) / (2 * distance)
    square = upper**2 - along**2
    beside = torch.where(square > 0, square, 1.0).sqrt() * (square > 0)  # finite gradient at 0
    return a + along * line + beside * across, a + distance * line


def foot_lock(toes: Tensor, drift: Tensor, before: Tensor, predicted: Tensor, was: Tensor,
              contacts: Tensor, left: Tensor, ground: float, raised: Tensor,
              seconds: float) -> tuple[Tensor, Tensor]:
    """Lock toes in contact where they landed (foot-contact IK, Mason et al. 2022, section 4.4).

    The paper does not say how its toes get their targets; this rule is ours. (A blend of the last
    position and the prediction, weighted by contact, slides where the weight is below 1.)

    - A toe in contact (above one half) is locked in three dimensions, `SLACK` from its prediction
      at most.
    - A released toe starts from rest: its offset from the prediction decays like a critically
      damped spring.
    - A toe that lands (low, with growing contact, the other one in contact) is slowed down before
      it is locked, by twice both contacts.
    - Towards the other toe, an offset is at most a quarter of their distance, or `NEAR` if this is
      more, so that the legs do not cross in a turn on the spot.
    - The network lets toes land up to 5 cm over the ground. With both in contact they settle. One
      locked toe settles only where it is `SUNK` under the ground or `UNEVEN` over it; a walk on
      the heels may hold it as high as a foot that stands on its heel does.

    Parameters
    ----------
    toes : Tensor [..., 2, 3], targets in the frame before, right and left, world, metres
    drift : Tensor [..., 2, 3], velocity of their offset from the predictions, m/s
    before : Tensor [..., 2, 3], toes of the pose that was fed back, after IK, in the frame before
    predicted : Tensor [..., 2, 3], the network's toes in this frame
    was, contacts : Tensor [..., 2], in the frame before and in this one, in [0, 1]
    left : Tensor [..., 2], unit vector (x, z) to the character's left
    ground : height of a standing toe, metres
    raised : Tensor [..., 2], how much higher over its ankle a toe is than in the rest pose, metres
    seconds : between the frames

    Returns
    -------
    toes, drift : Tensor [..., 2, 3], of this frame
    """
    # All offsets are from the prediction. That of a held toe is such that the toe stays in its
    # place; that of a free one decays. A toe that lands is between, but for its height.
    offset, behind = toes - before, R.limited(toes - predicted, SLACK)
    free, slower = spring(offset, drift, RETURN, seconds)
    held = contacts[..., None] > 0.5
    lands = (contacts > was)[..., None] & (predicted[..., 1:2] < ground + UNEVEN)
    share = (2 * contacts).clamp_max(1.0) * (2 * was.flip(-1)).clamp_max(1.0)
    share = torch.where(lands, share[..., None], 0.0)
    share = torch.cat((share, torch.zeros_like(share), share), -1).where(~held, 1.0)
    now = torch.lerp(free, behind, share)

    # The legs do not cross: an offset goes only so far towards the other toe.
    left = torch.stack((left[..., 0], torch.zeros_like(left[..., 0]), left[..., 1]), -1)
    inwards = torch.stack((left, -left), -2)  # of the right toe, of the left toe
    apart = ((predicted.flip(-2) - predicted) * inwards).sum(-1, keepdim=True)
    crossing = (now * inwards).sum(-1, keepdim=True) - (apart / 4).clamp_min(NEAR)
    now = now - crossing.clamp_min(0.0) * inwards

    # Toes settle: of a body on both feet, and a locked one that is far too high or too low.
    both = (contacts.amin(-1, keepdim=True) > BOTH)[..., None]
    rise = (ground - predicted - now)[..., 1:2]  # to the ground; negative: the toe is above it
    high = -rise - UNEVEN - HEEL * raised[..., None].clamp_min(0.0)
    far = torch.maximum(high, rise - SUNK).clamp_min(0.0) * (both | held)
    most = (SETTLE * both.to(far) + far / LEVEL) * seconds
    now = now + torch.nn.functional.pad(rise.clamp(-most, most), (1, 1))
    return predicted + now, torch.where(share > 0, (now - offset) / seconds, slower)


def hold_feet(swivel: Tensor, before: Tensor, predicted: Tensor, contacts: Tensor,
              seconds: float) -> Tensor:
    """Angles ``[..., 2]`` about the vertical that keep feet which stand as they were.

    The network turns both feet with the body. The heel of a standing foot then sweeps around its
    locked toe. So a foot in contact keeps its direction, at most `SWIVEL` off the prediction; in
    the air the angle decays with `RETURN`. The ankles that are fed back follow it, the rotations
    that are fed back are the predicted ones. This rule is ours as well.

    Parameters
    ----------
    swivel : Tensor [..., 2], angles of the frame before, right and left, radians
    before, predicted : Tensor [..., 2, 4], world rotations of the network's feet, before and now
    contacts : Tensor [..., 2], a foot is held in full from one half
    seconds : between the frames
    """
    change = R.multiply(predicted, R.inverse(before))
    w, y = change[..., 0], change[..., 2]
    # 2 atan2(y, w) is the turn about the vertical since the frame before: undo it
    held = (swivel - 2 * torch.atan2(y * w.sign(), w.abs())).clamp(-SWIVEL, SWIVEL)
    return torch.lerp(math.exp(-RETURN * seconds) * swivel, held, (2 * contacts).clamp_max(1.0))


def swivelled(skeleton: Skeleton, turned: Tensor, swivel: Tensor) -> Tensor:
    """World rotations ``[..., J, 4]`` with feet and toes turned by angles ``[..., 2]``."""
    turned, turn = turned.clone(), R.yaw(swivel)
    feet, toes = map(skeleton.both, ("foot", "toe"))
    for joints in (feet, toes)[: 1 + (feet != toes)]:  # without toes, the foot has both roles
        turned[..., joints, :] = R.multiply(turn, turned[..., joints, :])
    return turned


def sink(drop: Tensor, hips: Tensor, ankles: Tensor, length: Tensor, contacts: Tensor,
         seconds: float) -> Tensor:
    """How far the hips go down so that the legs reach the ankles of toes in contact.

    This rule is ours, too: without it, the toe of a leg that is too short for its target slides.
    The network predicts hips and toes apart from each other, and a locked toe stays behind its
    prediction, so that targets are up to 7 % of a leg's length too far. The hips sink by what the
    leg that needs most lacks (smoothly, over `ROOM` on both sides of its reach), at most by
    `DEEPEST` and with `FALL`. They come back as a critically damped spring. Only the drawn hips
    sink: where the network got them back, some styles kept them down, and glided.

    Parameters
    ----------
    drop : Tensor [..., 2], metres down and m/s, of the frame before
    hips, ankles : Tensor [..., 2, 3], predicted hip joints and wanted ankles, metres
    length : Tensor [..., 2], of the legs
    contacts : Tensor [..., 2], a leg counts in full from one half
    seconds : between the frames

    Returns
    -------
    Tensor [..., 2]
        The drop of this frame.
    """
    # What a leg lacks: the height of its hip above that at which the ankle is just within reach.
    apart = hips - ankles
    level = ((1 - SOFT) * length).square() - apart[..., ::2].square().sum(-1)
    height, room = apart[..., 1], ROOM * length
    lack = height - torch.maximum(level, (length / 2).square()).sqrt()
    need = torch.where(lack > room, lack, (lack + room).clamp_min(0.0).square() / (4 * room))
    need = torch.minimum(need, DEEPEST * length) * (2 * contacts).clamp_max(1.0)

    # The hips go down to what the worse leg needs, at most with `FALL`, and come back as a spring.
    need = torch.minimum(need.amax(-1), drop[..., 0] + FALL * seconds)
    above, speed = spring(drop[..., 0] - need, drop[..., 1], RETURN, seconds)
    speed = torch.where(above > 0, speed, (need - drop[..., 0]) / seconds)
    return torch.stack((need + above.clamp_min(0.0), speed), -1)


def solve_legs(skeleton: Skeleton, turned: Tensor, root: Tensor, toes: Tensor, contacts: Tensor,
               drop: Tensor, swivel: Tensor,
               seconds: float) -> tuple[list[Tensor], Tensor, Tensor]:
    """Bend predicted legs so that toes meet their targets, and let the hips sink (§ 4.4).

    The legs that are fed back to the network hang from the predicted hips, the drawn ones from hips
    that `sink`. In the air, a target moves to where the drawn leg gets, which is never quite
    straight.

    Parameters
    ----------
    turned : Tensor [..., J, 4], the predicted rotations in the world
    root : Tensor [..., 3], the root's position in the world, metres
    toes : Tensor [..., 2, 3], the targets in the world, right and left
    contacts, drop, seconds
        As in `sink`.
    swivel : Tensor [..., 2], from `hold_feet`

    Returns
    -------
    legs : Tensors [..., 2, 3], knees, feet and toes
    drop : Tensor [..., 2], of this frame
    toes : Tensor [..., 2, 3], the targets that the drawn legs reach
    """
    # Predicted positions of the legs' joints, from the root down. Feet keep their orientation but
    # for the swivel, so that a toe at its target has its ankle at ``target``.
    pairs, legs = map(skeleton.both, LEG), leg_chain(skeleton)
    above, places = [skeleton.parents[j] for j in legs], {0: root}
    bones = R.rotate(turned[..., above, :], skeleton.offsets[legs].to(root)).unbind(-2)
    for j, parent, bone in zip(legs, above, bones, strict=True):
        places[j] = places[parent] + bone
    a, b, c, toe = (torch.stack([places[j] for j in pair], -2) for pair in pairs)
    sole = R.rotate(R.yaw(swivel), toe - c)
    length = (b - a).norm(dim=-1) + (c - b).norm(dim=-1)
    target = uncross(toes - sole, _left(a), length, contacts, seconds)

    # The drawn legs; in the air, they decide where the toes get.
    now = sink(drop, a, target, length, contacts, seconds)
    down = torch.nn.functional.pad(now[..., None, :1], (1, 1))  # [..., 1, 3]: (0, drop, 0)
    held = (2 * contacts).clamp_max(1.0)[..., None]
    soft = SWING + held * (SOFT - SWING)
    _, reached = two_bone(a - down, b - down, c - down, target, soft=soft)
    target = torch.where(held < 1, reached, target)
    toes = torch.where(held < 1, target + sole, toes)

    # The legs that are fed back.
    knee, ankle = two_bone(a, b, c, target, left=_left(a))
    return [knee, ankle, ankle + sole], now, toes


def uncross(ankles: Tensor, left: Tensor, length: Tensor, contacts: Tensor,
            seconds: float) -> Tensor:
    """Wanted ankles ``[..., 2, 3]``, of which one in the air passes beside the other.

    Where a body turns or goes aside, predicted feet pass through the one that stands. Recorded
    ankles that pass are `ASIDE` of a leg's length or more apart sideways in 95 % of the frames of
    walks, runs and turns. Farther ahead than `PASSED`, legs may cross. A foot is pushed out at most
    with `PUSH`. This rule is ours, too.

    Parameters
    ----------
    ankles : Tensor [..., 2, 3], right and left, metres
    left : Tensor [..., 1, 3], from the right hip to the left one
    length, contacts : Tensor [..., 2], of the legs
    seconds : between the frames
    """
    left = R.normalize(left * left.new_tensor([1.0, 0.0, 1.0]))
    ahead = torch.stack((-left[..., 2], left[..., 1], left[..., 0]), -1)
    outwards, way = torch.cat((-left, left), -2), ankles - ankles.flip(-2)
    aside, along = (way * outwards).sum(-1), (way * ahead).sum(-1).abs()
    need = ASIDE * length - CROSSING * (along - PASSED * length).clamp_min(0.0)
    push = (need - aside).clamp(0.0, PUSH * seconds) * (1.0 - (2 * contacts).clamp_max(1.0))
    return ankles + push[..., None] * outwards


def turn_arms(skeleton: Skeleton, rotations: Tensor, root: Tensor, wanted: Tensor) -> Tensor:
    """Local rotations ``[..., J, 4]`` with arm bones turned towards predicted positions (§ 4.4).

    ``rotations [..., J, 4]`` are local, ``root [..., 3]`` is the root's position and ``wanted [...,
    J, 3]`` are predicted positions in the world, metres; only rows of arm joints are read.
    """
    turned, positions = forward_kinematics(skeleton, rotations, root)
    for joints, ends in arm_bones(skeleton):
        aim(skeleton, turned, positions, joints, ends, wanted)
    return _ends_follow(skeleton, turned)


def aim(skeleton: Skeleton, turned: Tensor, positions: Tensor, joints: list[int], ends: list[int],
        wanted: Tensor) -> None:
    """Turn joints so that the bones to their ``ends`` point at ``wanted [..., J, 3]`` positions.

    All are in the world. It changes ``turned [..., J, 4]`` and ``positions [..., J, 3]``.
    """
    bone = R.rotate(turned[..., joints, :], skeleton.offsets[ends].to(turned))
    turn = R.between(bone, wanted[..., ends, :] - positions[..., joints, :])
    turned[..., joints, :] = R.multiply(turn, turned[..., joints, :])
    positions[..., ends, :] = positions[..., joints, :] + R.rotate(turn, bone)


def plant_feet(skeleton: Skeleton, rotations: Tensor, root: Tensor, toes: Tensor,
               soles: Tensor | None = None) -> Tensor:
    """Local rotations ``[..., J, 4]`` with the legs bent so that toes meet their targets (§ 4.4).

    ``rotations [..., J, 4]`` are local, ``root [..., 3]`` is the root's position and ``toes [...,
    2, 3]`` are the targets, right and left, in the world, metres. The feet keep their orientation,
    or turn so that the toe lies in the direction ``soles [..., 2, 3]`` from the ankle.
    """
    turned, positions = forward_kinematics(skeleton, rotations, root)
    legs = [*map(skeleton.both, LEG)]
    if soles is not None:
        wanted = positions.clone()
        wanted[..., legs[3], :] = positions[..., legs[2], :] + soles
        aim(skeleton, turned, positions, legs[2], legs[3], wanted)
    a, b, c, toe = (positions[..., joints, :] for joints in legs)
    middle, end = two_bone(a, b, c, toes - (toe - c), left=_left(a))
    turn = R.between(torch.stack((b - a, c - b)), torch.stack((middle - a, end - middle)))
    for joints, aimed in zip(legs, turn, strict=False):
        turned[..., joints, :] = R.multiply(aimed, turned[..., joints, :])
    return _ends_follow(skeleton, turned)


def leg_chain(skeleton: Skeleton) -> list[int]:
    """All points from the root to the toes, without the root; parents come before children."""
    return sorted({j for toe in skeleton.both("toe") for j in skeleton.tree.up(toe)} - {0})


def arm_bones(skeleton: Skeleton) -> list[tuple[list[int], list[int]]]:
    """Joints of both arms and the points at their bones' other ends, from the collars outwards.

    The last ones are the End Sites of the hands, where there are any.
    """
    arms = [*map(skeleton.both, CHAINS["arm"])]
    chain = [[skeleton.parents[joint] for joint in arms[0]], *arms]
    ends = [skeleton.end_site(f"{side}_hand") for side in FEET]
    if not set(ends) & set(arms[-1]):
        chain.append(ends)
    return list(pairwise(chain))


def _left(hips: Tensor) -> Tensor:
    """From the right to the left hip ``[..., 1, 3]``, of both ``[..., 2, 3]``."""
    return hips[..., 1:, :] - hips[..., :1, :]


def _ends_follow(skeleton: Skeleton, turned: Tensor) -> Tensor:
    """Local rotations of those in the world ``[..., J, 4]``; End Sites follow their parents."""
    follow = [skeleton.parents[j] if skeleton.is_end(j) else j for j in range(len(skeleton))]
    return local_rotations(skeleton, turned[..., follow, :])
