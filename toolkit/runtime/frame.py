"""A character under control, one frame at a time.

The method is that of Mason et al. 2022, section 4.4, and Zhang et al. 2018.
``step(model, state, command) -> state`` has no hidden state: a state can be kept, replayed and
branched. All tensors have a leading axis of B characters, so that one call moves a crowd.
"""

import functools
from collections.abc import Sequence
from dataclasses import replace

import torch
from torch import Tensor

from toolkit.features import Layout, pack_joints, seen_from, split_joints
from toolkit.motion import local_rotations, rotations as R, trajectory
from toolkit.motion.ik import foot_lock, hold_feet, plant_feet, solve_legs, swivelled, turn_arms
from toolkit.motion.skeleton import FEET
from toolkit.motion.tensors import shown
from toolkit.networks.phase import advance, initial_pose
from toolkit.runtime.state import CharacterState, Remembering, pairs_of, vectors_of
from toolkit.runtime.steering import MOVES, Command, standing, steer, turn

FPS = trajectory.FPS
STANDS = 0.9  # share of standing (`steering.standing`) from which feet stay on the ground
LANDING = 0.5  # seconds in which the contact of a foot in the air rises to 1 then
HIGH = 0.08  # metres over the ground: what a toe is higher is not lifted
LIFTED = 0.1  # metres over the ground: a higher foot stays there, as in hops on one leg
# Metres (ours): a frame corrects the integrated position of a joint by at most so much. Not of a
# leg: the published network then glides. With 1 cm, arms lag behind a hop, and HopLeft glides.
JUMP = 0.02
CORRECTION = 0.85  # share of the network's prediction in the next frame's trajectory


def start(model, style: Tensor, position: Sequence[float] = (0.0, 0.0),
          facing: Sequence[float] = (0.0, 1.0)) -> CharacterState:
    """A character standing still in the model's `toolkit.networks.phase.initial_pose`; on its
    device and in its dtype.

    Parameters
    ----------
    style : Tensor [S] or [B, S]
        Style vector, or one per character. Arrays and lists are accepted, here and below.
    position, facing
        World position (x, z) of the root, metres, and its facing direction (x, z); pairs or ``[B,
        2]``.

    Raises
    ------
    ValueError
        If the model or style is invalid, a pair does not fit the characters or is not finite, or
        facing is zero.
    """
    if not hasattr(model, "layout"):
        raise ValueError(f"expected a model (of a run: run.model), got {shown(model)}")
    layout: Layout = model.layout
    phase, joints = initial_pose(model)
    style = vectors_of(style, joints)
    if style.shape[1] != model.style_size:
        raise ValueError(f"style needs {model.style_size} columns, got shape {list(style.shape)}")

    # The root, alike for all past and future frames.
    look = R.normalize(pairs_of(facing, "facing", style))
    root = torch.cat((pairs_of(position, "position", style), look), -1)
    if not root.is_meta and not bool(root.isfinite().all() & look.any(-1).all()):
        raise ValueError("position and facing must be finite, and facing not zero; "
                         f"got {shown(position)}, {shown(facing)}")

    # A character that stands still, with both feet on the ground.
    state = CharacterState(
        history=root[:, None].repeat(1, trajectory.PAST + 1, 1),
        future=root[:, None].repeat(1, len(layout.ahead), 1),
        joints=_orthonormal(joints.expand(len(style), -1)),
        phase=phase.expand(len(style), -1),
        style=style,
        velocity=torch.zeros_like(look),
        facing=look,
        drive=torch.ones_like(look[:, :1]),
        asked=torch.zeros_like(look),
        aside=torch.zeros_like(look[:, :1]),
        rest=torch.ones_like(look[:, :1]),
        contacts=torch.ones_like(look),
        toes=look.new_zeros(len(look), 2, 3),
        drift=look.new_zeros(len(look), 2, 3),
        drop=torch.zeros_like(look),
        swivel=torch.zeros_like(look),
    )
    toes = predicted_toes(layout, state)
    toes[..., 1] = model.ground
    state = replace(state, toes=toes)
    if model.memory:  # it has stood there before
        x = _input_frame(layout, state, state.future)
        return Remembering(**vars(state), memory=x[:, None].expand(-1, model.memory, -1))
    return state


def _input_frame(layout: Layout, state: CharacterState, future: Tensor) -> Tensor:
    """x ``[B, Dx]`` of a state, with a future trajectory ``[B, S, 4]``, world."""
    past = state.history[:, [trajectory.PAST + o for o in layout.behind]]
    window = _to_local(torch.cat((past, future), 1), state.root).flatten(1)
    return layout.pack_input(trajectory=window, joints=state.joints)


@functools.singledispatch
def step(model, state: CharacterState, command: Command) -> CharacterState:
    """The next frame, 1/60 s later.

    The future trajectory is blended towards the command. The network predicts the next frame. Pose,
    phase and trajectory are blends of this prediction and the previous values (section 4.4, with
    the constants of the published run). The pose after foot IK is the next input.

    Departures from the published run, in which all positions are half predicted and half
    integrated: a leg in contact (from one half on) is only integrated, joints outside the legs are
    corrected by at most `JUMP`, and toes in the air are raised by the model's ``lift``. A character
    that is to stand gives up its motion, turn and phase, and its low feet come down; one that
    starts does so slowly. For the phase see `toolkit.networks.phase.advance`.
    """
    return planted(model, state, predicted(model, state, command))


def predicted(model, state: CharacterState, command: Command) -> CharacterState:
    """The next frame before foot IK.

    Its ``toes``, ``drift``, ``drop`` and ``swivel`` are those of ``state``.
    """
    layout: Layout = model.layout

    # Trajectory: the past, and the future blended towards the command, seen from the root.
    steered = steer(state, command, layout.ahead)
    root, future = state.root, steered.future
    x = _input_frame(layout, state, future)

    # Prediction of the network, from the frames that it remembers and this one.
    if isinstance(steered, Remembering):
        x = torch.cat((steered.memory, x[:, None]), 1)
        steered = replace(steered, memory=x[:, 1:])
    out = layout.unpack_output(model.predict(x, state.phase, state.style))

    # Root: a character that is to stand stops walking first, and stops turning once it looks into
    # the commanded direction.
    path = out["trajectory"].unflatten(-1, (-1, 4))
    path = _to_world(torch.cat((path[..., :2], R.normalize(path[..., 2:])), -1), root)
    stand = standing(steered, root)
    place = torch.lerp(path[:, 0, :2], root[:, :2], steered.rest)
    new_root = torch.cat((place, turn(path[:, 0, 2:], root[:, 2:], stand[:, 0])), -1)

    # Future trajectory from the new root on: 85 % the network's, 15 % the steered one that went in.
    ahead = torch.lerp(future, path, CORRECTION)
    ahead = torch.cat((ahead[..., :2], R.normalize(ahead[..., 2:])), -1)
    ahead = torch.cat((new_root[:, None], ahead[:, 1:]), 1)

    # Contacts: while the character stands, a low foot comes down and then stays there.
    contacts = out["contacts"].clamp(0.0, 1.0)
    low = state.toes[..., 1] < model.ground + LIFTED
    rising = contacts.maximum((state.contacts + 1 / (LANDING * FPS)).clamp_max(1.0))
    contacts = torch.where((stand > STANDS) & low, rising, contacts)

    # Pose: integrated positions, moved half of the way to the predicted ones; outside the legs by
    # at most `JUMP`. A leg in contact is only integrated, so that toes do not jump.
    was, now, legs = split_joints(state.joints), split_joints(out["joints"]), leg_joints(layout)
    share = torch.full_like(was["position"][..., :1], 0.5)
    share[:, legs, 0] *= 1.0 - (2 * contacts).clamp_max(1.0).repeat_interleave(3, -1)
    position = was["position"] + now["velocity"] / FPS
    change = share * (now["position"] - position)
    limited = R.limited(change, JUMP)
    limited[:, legs] = change[:, legs]
    position = position + limited

    # A model may have a factor `lift` on the height of toes in the air, up to `HIGH`.
    swing = model.lift - 1.0
    toes = legs[2::3]
    height = position[:, toes, 1]
    in_the_air = 1.0 - (2 * contacts).clamp_max(1.0)
    position[:, toes, 1] += swing * in_the_air * (height - model.ground).clamp(0.0, HIGH)

    # At a start, `held` falls from 1 to 0: pose and phase go the share 1 - held of a frame.
    moves = R.length(steered.velocity) > MOVES
    held = torch.where(moves, steered.rest, 0.0)
    position = torch.lerp(position, was["position"], held[:, None])
    for axis in ("forward", "up"):
        now[axis] = torch.lerp(now[axis], was[axis], held[:, None])

    # The same pose, seen from the new root.
    joints = to_frame(_orthonormal(pack_joints(**now | {"position": position})), root, new_root)

    # Phase: it stops while the character stands on both feet.
    phase = advance(layout, state.phase, out)
    still = (stand * contacts.amin(-1, keepdim=True)).maximum(held)
    phase = torch.lerp(phase, state.phase, still)
    history = torch.cat((state.history[:, 1:], new_root[:, None]), 1)
    return replace(steered, history=history, future=ahead, joints=joints, phase=phase,
                   contacts=contacts)


def leg_joints(layout: Layout) -> list[int]:
    """Feature joints of knee, foot and toe, right and then left."""
    roles = [f"{side}_{part}" for side in FEET for part in ("knee", "foot", "toe")]
    return [layout.names.index(layout.skeleton.roles[role]) for role in roles]


def planted(model, state: CharacterState, new: CharacterState) -> CharacterState:
    """The frame ``new``, which follows ``state``, after foot lock and foot IK."""
    layout, skeleton, count = model.layout, model.layout.skeleton, len(new.joints)
    # The pose that was fed back and the new one, in the world: [2 B, ...], then split.
    joints = torch.cat((state.joints, new.joints))
    world = world_joints(joints, torch.cat((state.root, new.root)))
    rotations = R.from_forward_up(world["forward"], world["up"])
    legs = leg_joints(layout)
    before, now = world["position"][:, legs[2::3]].split(count)  # toes, [B, 2, 3] each
    feet = rotations[:, legs[1::3]].split(count)  # [B, 2, 4] each
    swivel = hold_feet(state.swivel, *feet, new.contacts, 1 / FPS)

    # Foot lock. How much higher over its ankle is a toe than in the rest pose?
    ankles, balls = skeleton.both("foot"), skeleton.both("toe")
    soles = skeleton.offsets[balls].to(now)
    if ankles == balls:  # without toes, the foot has both roles
        soles = torch.zeros_like(soles)
    raised = (R.rotate(feet[1], soles) - soles)[..., 1]
    left = torch.stack((new.root[:, 3], -new.root[:, 2]), -1)
    locked, drift = foot_lock(state.toes, state.drift, before, now, state.contacts, new.contacts,
                              left, model.ground, raised, 1 / FPS)

    # The legs bend towards these toes. The next frame is predicted from them, seen from the root.
    bent, drop, toes = solve_legs(skeleton, rotations[count:, skeleton.feature_of],
                                  world["position"][count:, 0], locked, new.contacts, state.drop,
                                  swivel, 1 / FPS)
    x, z, sin, cos = new.root.unbind(-1)
    floor = torch.stack((x, torch.zeros_like(x), z), -1)[:, None]
    back = R.inverse(R.yaw(torch.atan2(sin, cos)))[:, None]
    parts = split_joints(new.joints)
    position = parts["position"].clone()
    position[:, legs] = R.rotate(back, torch.stack(bent, 2).flatten(1, 2) - floor)
    return replace(new, joints=pack_joints(**parts | {"position": position}), toes=toes,
                   drift=drift, drop=drop, swivel=swivel)


@functools.singledispatch
def pose(model, state: CharacterState, *, feet: bool = True,
         arms: bool = True) -> tuple[Tensor, Tensor]:
    """Local rotations ``[B, J', 4]`` and root positions ``[B, 3]`` of the whole skeleton, to draw.

    ``model``: plain, compiled, or only its layout. ``feet``: hold toes in contact in place.
    ``arms``: turn arm bones to the predicted positions.
    """
    layout: Layout = getattr(model, "layout", model)
    skeleton, world = layout.skeleton, world_joints(state.joints, state.root)
    rotation = R.from_forward_up(world["forward"], world["up"])[:, skeleton.feature_of]
    if feet:
        rotation = swivelled(skeleton, rotation, state.swivel)
    local = local_rotations(skeleton, rotation)
    root = world["position"][:, 0]

    # Arm IK: bones point at the predicted positions.
    if arms:
        wanted = world["position"].new_zeros(len(root), len(skeleton), 3)
        wanted[:, list(skeleton.feature_joints)] = world["position"]
        local = turn_arms(skeleton, local, root, wanted)

    # Foot IK: the hips sink, so that legs reach the toes.
    if feet:
        drop = state.drop[:, 0]
        root = root - torch.stack((0 * drop, drop, 0 * drop), -1)
        local = plant_feet(skeleton, local, root, state.toes)
    return local, root


def world_joints(joints: Tensor, root: Tensor) -> dict[str, Tensor]:
    """A pose's position, forward, up and velocity in the world, each ``[B, J, 3]``."""
    return split_joints(seen_from(joints, *root.split(2, -1)))


def predicted_toes(layout: Layout, state: CharacterState) -> Tensor:
    """World positions ``[B, 2, 3]`` of the right and left toe in the pose."""
    return world_joints(state.joints, state.root)["position"][:, leg_joints(layout)[2::3]]


def _matrix(root: Tensor) -> Tensor:
    """``[B, 2, 2]`` that turns root-frame (x, z) into the world's.

    The direction (sin, cos) is the root's +z.
    """
    x, z = root[:, 2], root[:, 3]
    return torch.stack((torch.stack((z, x), -1), torch.stack((-x, z), -1)), -2)


def _to_world(samples: Tensor, root: Tensor) -> Tensor:
    turned = torch.einsum("bij,bskj->bski", _matrix(root), samples.unflatten(-1, (2, 2)))
    return torch.cat((turned[..., 0, :] + root[:, None, :2], turned[..., 1, :]), -1)


def _to_local(samples: Tensor, root: Tensor) -> Tensor:
    shifted = torch.cat((samples[..., :2] - root[:, None, :2], samples[..., 2:]), -1)
    return torch.einsum("bji,bskj->bski", _matrix(root), shifted.unflatten(-1, (2, 2))).flatten(-2)


def _orthonormal(joints: Tensor) -> Tensor:
    parts = split_joints(joints)
    forward = R.normalize(parts["forward"])
    up = R.normalize(parts["up"] - (parts["up"] * forward).sum(-1, keepdim=True) * forward)
    return pack_joints(**parts | {"forward": forward, "up": up})


def to_frame(joints: Tensor, old: Tensor, new: Tensor) -> Tensor:
    """A pose in the root frame ``old`` seen from the root frame ``new`` (world, ``[B, 4]``)."""
    return seen_from(joints, *_to_local(old[:, None], new)[:, 0].split(2, -1))
