"""Inverse kinematics: where the joints of a limb go so that its end is where it should be. Torch, any leading shape."""

import math
from itertools import pairwise

import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.clip import FEET, Skeleton, forward_kinematics, local_rotations
from toolkit.motion.tensors import as_tensor


def two_bone(
    a: Tensor, b: Tensor, c: Tensor, target: Tensor, pole: Tensor | None = None, *, soft: float | Tensor = 0.01
) -> tuple[Tensor, Tensor]:
    """Bend a limb of two bones so that its end meets a target; the law of cosines with a soft limit near full stretch.

    The bones keep their lengths. Within the last `soft` of full stretch the end follows the target ever more slowly and
    never reaches full stretch, so that a knee does not snap straight (there its angle changes infinitely fast with
    distance). A target nearer than the folded limb can reach is pushed out to where it can.

    Parameters
    ----------
    a, b, c : Tensor [..., 3]
        Positions of the limb's root, middle and end as they are now (hip, knee, ankle); they give the bones' lengths and,
        without a pole, the side to bend to.
    target : Tensor [..., 3]
        Where the end should be, metres.
    pole : Tensor [..., 3], optional
        Direction (not a point) that the middle joint bends towards, any length; by default the side that it bends to now,
        carried along by the shortest turn of the line from `a` to `c` into that from `a` to the target. It should not be
        parallel to the line from `a` to the target; if it is, some direction across is taken.
    soft : float or Tensor [..., 1]
        Share of the full length over which the limit acts; 0 is a hard limit.

    Returns
    -------
    middle, end : Tensor [..., 3]
        New positions of `b` and `c`.

    Raises
    ------
    ValueError
        If `soft` is not in [0, 1).
    """
    if not isinstance(soft, int | float):
        soft = as_tensor(soft, "soft", a)
    limits = soft.aminmax() if isinstance(soft, Tensor) else (soft, soft)
    if not all(0 <= float(limit) < 1 for limit in limits):
        raise ValueError(f"soft must be in [0, 1), got {limits[0]:g} to {limits[1]:g}")
    upper, lower = (b - a).norm(dim=-1, keepdim=True), (c - b).norm(dim=-1, keepdim=True)
    full = upper + lower
    reach = target - a
    wanted = reach.norm(dim=-1, keepdim=True)
    line = R.normalize(torch.where(wanted > 1e-9, reach, c - a + 1e-9))
    margin = (soft * full).clamp_min(1e-9)
    over = (wanted - (full - margin)).clamp_min(0.0)
    distance = torch.where(over > 0, full - margin * torch.exp(-over / margin), wanted)
    distance = torch.maximum(distance, (upper - lower).abs() + 1e-6 * full)

    side = R.rotate(R.between(c - a, line), b - a) if pole is None else pole
    side = R.normalize(side)
    across = side - (side * line).sum(-1, keepdim=True) * line
    aside = torch.linalg.cross(line, R.least_axis(line))
    across = R.normalize(torch.where(across.norm(dim=-1, keepdim=True) > 1e-5, across, aside))
    along = (upper**2 - lower**2 + distance**2) / (2 * distance)
    height = (upper**2 - along**2).clamp_min(0.0).sqrt()
    return a + along * line + height * across, a + distance * line


SLACK = 0.15  # metres that a held toe may stay behind its prediction
RETURN = 10.0  # per second: how fast a toe that was let go comes back to its prediction


def hold(
    toes: Tensor, drift: Tensor, before: Tensor, predicted: Tensor, contacts: Tensor, left: Tensor, seconds: float
) -> tuple[Tensor, Tensor]:
    """Hold toes in contact where they landed (foot-contact IK, Mason et al. 2022, section 4.4).

    Departure from the paper, where a toe's target stays where it was by a share that grows with the contact: a share below
    1 creeps in every frame of whose contact the network is not sure, and lets go within a frame or two. Ours holds a toe
    wholly while contact is more likely than not. What then parts it from its prediction dies away as a critically damped
    spring that starts from rest, so that nothing pops. Only x and z are held; the height stays the network's. A toe is
    dragged along once it is `SLACK` behind, or a quarter of the way sideways to where the other one should be, so that a
    character that turns on the spot does not cross its legs.

    Parameters
    ----------
    toes : Tensor [..., 2, 3]
        Targets of the frame before, right and left, world, metres.
    drift : Tensor [..., 2, 2]
        How fast they were parting from their predictions (x, z), m/s.
    before, predicted : Tensor [..., 2, 3]
        The network's toes in the frame before and now.
    contacts : Tensor [..., 2]
        Now, in [0, 1].
    left : Tensor [..., 2]
        Unit vector (x, z) to the character's left.
    seconds
        Between the frames.

    Returns
    -------
    toes, drift : Tensor [..., 2, 3], [..., 2, 2]
        Of this frame.
    """
    offset, behind = (toes - before)[..., ::2], (toes - predicted)[..., ::2]
    behind = behind * (SLACK / behind.norm(dim=-1, keepdim=True).clamp_min(SLACK))
    push, fade = drift + RETURN * offset, math.exp(-RETURN * seconds)
    held = contacts[..., None] > 0.5
    now = torch.where(held, behind, fade * (offset + push * seconds))
    inwards = torch.stack((left, -left), -2)
    apart = ((predicted.flip(-2) - predicted)[..., ::2] * inwards).sum(-1, keepdim=True).clamp_min(0.0)
    now = now - ((now * inwards).sum(-1, keepdim=True) - apart / 4).clamp_min(0.0) * inwards
    drift = torch.where(held, (now - offset) / seconds, fade * (drift - RETURN * push * seconds))
    return predicted + torch.stack((now[..., 0], torch.zeros_like(contacts), now[..., 1]), -1), drift


def plant_feet(skeleton: Skeleton, rotations: Tensor, root: Tensor, toes: Tensor) -> Tensor:
    """Bend the legs so that the toes meet their targets; the feet keep their orientation (foot-contact IK, section 4.4).

    Parameters
    ----------
    skeleton
        With the roles hip, knee, foot and toe on both sides.
    rotations : Tensor [..., J, 4]
        Local rotations.
    root : Tensor [..., 3]
        Root position.
    toes : Tensor [..., 2, 3]
        Targets, right and left, world.

    Returns
    -------
    Tensor [..., J, 4]
        New local rotations.
    """
    turned, positions = forward_kinematics(skeleton, rotations, root)
    legs = [[skeleton.role(f"{side}_{part}") for side in FEET] for part in ("hip", "knee", "foot", "toe")]
    a, b, c, toe = (positions[..., joints, :] for joints in legs)
    middle, end = two_bone(a, b, c, toes - (toe - c))
    turn = R.between(torch.stack((b - a, c - b)), torch.stack((middle - a, end - middle)))
    for joints, aim in zip(legs, turn, strict=False):
        turned[..., joints, :] = R.multiply(aim, turned[..., joints, :])
    follow = [skeleton.parents[j] if skeleton.is_end(j) else j for j in range(len(skeleton))]
    return local_rotations(skeleton, turned[..., follow, :])


def turn_arms(skeleton: Skeleton, rotations: Tensor, root: Tensor, wanted: Tensor) -> Tensor:
    """Turn every arm bone so that its end points at its predicted position: rotation follows position (section 4.4).

    Parameters
    ----------
    skeleton
        With the roles shoulder, elbow and hand on both sides.
    rotations : Tensor [..., J, 4]
        Local rotations.
    root : Tensor [..., 3]
        Root position.
    wanted : Tensor [..., J, 3]
        Predicted positions, world; rows of joints outside the arms are not read.

    Returns
    -------
    Tensor [..., J, 4]
        New local rotations.
    """
    turned, positions = forward_kinematics(skeleton, rotations, root)
    arms = [[skeleton.role(f"{side}_{part}") for side in FEET] for part in ("shoulder", "elbow", "hand")]
    chain = [[skeleton.parents[joint] for joint in arms[0]], *arms]
    tips = [skeleton.tip(f"{side}_hand") for side in FEET]
    for joints, children in pairwise([*chain, tips] if not set(tips) & set(arms[-1]) else chain):
        bone = R.rotate(turned[..., joints, :], skeleton.offsets[children].to(rotations))
        aim = R.between(bone, wanted[..., children, :] - positions[..., joints, :])
        turned[..., joints, :] = R.multiply(aim, turned[..., joints, :])
        positions[..., children, :] = positions[..., joints, :] + R.rotate(aim, bone)
    follow = [skeleton.parents[j] if skeleton.is_end(j) else j for j in range(len(skeleton))]
    return local_rotations(skeleton, turned[..., follow, :])
