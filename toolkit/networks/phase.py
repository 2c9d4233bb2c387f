"""How a model represents the limbs' local phases: all (LPN), one global angle (PFNN), none (MANN).

Data always hold local phases. This module holds all that depends on the model's representation,
`Layout.phase`.
"""

import dataclasses
import math

import torch
from torch import Tensor

from toolkit.features import Features, Layout, Normaliser, Rows, pack_joints, split_joints
from toolkit.phases import LIMBS

PULL = 0.5  # share of the way to the predicted local phase, for each radian that the phase moves
#: Sine of each limb's phase in a character that is about to step; the cosine is 0.
ABOUT_TO_STEP = {"left_hand": -1.0, "right_hand": 1.0, "left_foot": 1.0, "right_foot": -1.0}


def global_phase(p: Tensor, limbs: tuple[str, ...] = LIMBS) -> Tensor:
    """The global phase ``[..., 1]``, an angle in [0, 2π), of the limbs' phases ``[..., 2 K]``.

    It is the angle of the right foot's phase vector minus the left's. In a walk the feet are half a
    cycle apart, so both give the same angle. If only one leg moves, its vector determines the
    angle. Like the PFNN's phase, the vectors follow foot contacts if there are any (section 5.1.1).
    While both feet stand or move alike, the angle is noise and may jump.
    """
    feet = p.unflatten(-1, (len(limbs), 2))
    right, left = (feet[..., limbs.index(f"{side}_foot"), :] for side in ("right", "left"))
    sin, cos = (right - left).unbind(-1)
    return torch.atan2(sin, cos)[..., None] % math.tau


def observe(layout: Layout, p: Tensor, z: Tensor) -> tuple[Tensor, Tensor]:
    """Phases ``[B, 2 K]`` and output frames ``[B, Dz]`` of data in a model's columns."""
    if layout.phase == "local":
        return p, z
    blocks = dataclasses.replace(layout, phase="local").unpack_output(z)
    there = blocks.pop("phases")
    del blocks["phase_updates"]
    if layout.phase == "none":
        return p[..., :0], layout.pack_output(**blocks)
    here, there = (global_phase(phases, layout.phase_limbs) for phases in (p, there))
    update = (there - here + math.pi) % math.tau - math.pi
    return here, layout.pack_output(**blocks, phase_updates=update)


def normalisers(layout: Layout, data: Features) -> dict[str, Normaliser]:
    """Statistics of data in the columns of a model's layout; a global phase stays in radians."""
    found = data.normalisers()
    if layout.phase == "local":
        return found

    def observed(style: str) -> Rows:
        p, z = data.phases[style], data.outputs[style]
        return Rows(lambda at: observe(layout, p[at], z[at])[1], torch.arange(len(z)))

    phases = Normaliser(torch.zeros(layout.n_phases), torch.ones(layout.n_phases))
    return found | {"phases": phases, "outputs": Normaliser.of(*map(observed, data.styles))}


def advance(layout: Layout, phase: Tensor, out: dict[str, Tensor]) -> Tensor:
    """The phase of the next frame, of this ``phase`` and the blocks ``out`` of a predicted frame.

    A global phase is the phase plus its update, modulo 2π. For local phases, the sum q = p + Δp̂ of
    each limb moves towards the predicted p̂ by a share `PULL` · ‖Δp̂‖ / ‖q‖, at most one half.

    Departure from the published run, where the share is always one half. In closed loop that
    shrinks amplitudes: steps get rarer and feet slide. Our share, in a walk about a twentieth,
    keeps the sums from drifting, and cannot stop a phase, which would make the character glide.
    """
    if layout.phase == "local":
        update = out["phase_updates"].unflatten(-1, (-1, 2))
        predicted = out["phases"].unflatten(-1, (-1, 2))
        total = phase.unflatten(-1, (-1, 2)) + update
        length = total.norm(dim=-1, keepdim=True).clamp_min(1e-6)
        share = PULL * update.norm(dim=-1, keepdim=True) / length
        return torch.lerp(total, predicted, share.clamp_max(0.5)).flatten(-2)
    return (phase + out["phase_updates"]) % math.tau if layout.phase == "global" else phase


def initial_pose(model) -> tuple[Tensor, Tensor]:
    """A phase ``[n_phases]`` and a pose ``[12 J]`` of a character that is about to step.

    The phase is half a deviation from the mean of the data: nearer to it, some styles slide or jump
    at their first step. The pose is the mean pose. In a model without phases, it must start the
    step: hands and feet are two deviations ahead of or behind their means, and move back (from the
    mean pose a MANN glided for four seconds before it stepped).
    """
    layout, joints = model.layout, model.layout.outputs["joints"]
    pose, limbs = model.outputs_mean[joints], layout.phase_limbs
    if layout.phase == "none":
        mean, std = split_joints(pose.clone()), split_joints(model.outputs_std[joints])
        ahead = pose.new_tensor([ABOUT_TO_STEP[limb] for limb in LIMBS])
        for channel, way in (("position", 2.0), ("velocity", -2.0)):
            mean[channel][layout.limbs, 2] += way * ahead * std[channel][layout.limbs, 2]
        return model.phases_mean, pack_joints(**mean)
    sines = pose.new_tensor([ABOUT_TO_STEP.get(limb, 0.0) for limb in limbs])
    vectors = torch.stack((sines, torch.zeros_like(sines)), 1).flatten()
    if layout.phase == "global":
        return global_phase(vectors, limbs), pose
    return model.phases_mean + 0.5 * model.phases_std * vectors, pose
