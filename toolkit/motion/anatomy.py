"""Anatomy of a humanoid rig: the axes that its joints have in a T-pose, whatever their local frames and its rest pose are.

Rigs differ in the pose of zero rotation (T-pose, A-pose, or no pose of a body at all: bones of Bandai-Namco lie along x,
bones of Blender and Mixamo along their own y) and in joints along spine and limbs. We compare them in one canonical pose: a
T-pose that faces +z, with straight legs and flat feet. ``global rotation × axes`` is how far a joint has turned from there,
which means the same on every rig.

The axes are measured in a pose of a standing figure: the pose of zero rotations, or that of a clip without motion (a bind
pose). In such a pose the bones of limbs are turned the shortest way into the T-pose. Other rigs are measured over a motion.
There the axes of hips and legs are the signed coordinate axes nearest to the body's own axes, turned so that the bone has
its direction in the T-pose. Arms mostly hang, so their axes are found from the bone and the elbow's axis. A foot is flat
where it is lowest. Spine, neck, head, collars and hands have the axes of their parent, up to turns of 90 degrees.
"""

from dataclasses import dataclass, replace
from itertools import pairwise

import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.clip import Clip, root_frames
from toolkit.motion.roles import ROLES, SIDES
from toolkit.motion.skeleton import Skeleton, forward_kinematics
from toolkit.motion.tensors import as_tensor, summary

LIMB_ROLES = tuple(role for role in ROLES if not role.endswith("toe"))  # a rig without toes stands on its ankles
PARTS = {"arm": ("collar", "shoulder", "elbow", "hand"), "leg": ("hip", "knee", "foot", "toe")}  # from the trunk outwards
STEEP = 0.3  # sine between a foot's bone and the vertical below which it does not show where the foot points
SHORT = 0.01  # metres; a shorter leg is none
STRAIGHT = 0.02  # sine of the mean bend below which an arm's elbow axis cannot be found
NEAR = 0.85  # cosine up to which axes count as turned by multiples of 90 degrees
STILL = 1e-3  # change of quaternions up to which a clip shows one pose
FLAT = 0.1  # share of the frames in which a foot is lowest: there it lies flat on the floor


@dataclass(frozen=True, eq=False)
class Anatomy:
    """What retargeting knows of a rig; `measure` makes it."""

    skeleton: Skeleton  # with toes: the role of a missing one is given to the ankle
    axes: dict[int, Tensor]  # joint -> rotation [4] from the canonical axes to the joint's own, in the T-pose
    rest: Tensor  # [J, 4] local rotations of joints that nothing moves
    bones: dict[int, Tensor]  # joint of a limb -> vector [3] to the limb's next joint, in its own frame, metres
    spine: list[int]  # from the hips up to the chest
    neck: list[int]  # from the chest up to the head
    __repr__ = summary

    @property
    def leg(self) -> float:
        """Hip to ankle along the bones, metres."""
        return sum(float(self.bones[self.skeleton.role(f"left_{part}")].norm()) for part in ("hip", "knee"))


def measure(rig: Clip | Skeleton) -> Anatomy:
    """The anatomy of a skeleton, or of a clip's skeleton.

    Raises
    ------
    ValueError
        If roles are missing, the legs have no length, or a skeleton is given alone whose zero rotations are no standing
        figure: then a clip of it is needed.
    """
    clip, skeleton = (None, rig) if isinstance(rig, Skeleton) else (rig, rig.skeleton)
    name = "the skeleton" if clip is None else clip.name
    if lacking := [role for role in LIMB_ROLES if role not in skeleton.roles]:
        raise ValueError(f"{name}: cannot find its {', '.join(lacking)} among {', '.join(skeleton.names)}")
    skeleton = with_toes(skeleton)
    like = clip.rotations if clip is not None else torch.zeros(0)
    zero = R.identity(len(skeleton), dtype=like.dtype, device=like.device)
    found = _posed(skeleton, zero, upright=False)
    if found is None and clip is not None:
        clip = clip.replace(skeleton=skeleton)
        still = float((clip.rotations - clip.rotations[:1]).abs().amax()) < STILL
        found = _posed(skeleton, clip.rotations[0], upright=True) if still else _moving(clip)
    if found is None:
        raise ValueError(f"{name}: its zero rotations are no standing figure; give a file of it with a T-pose or a motion")
    if found.leg < SHORT:
        raise ValueError(f"{name}: its legs have no length")
    return found


def with_toes(skeleton: Skeleton) -> Skeleton:
    """The skeleton with a toe on both feet: where none is known, the ankle has that role, too."""
    roles = skeleton.roles
    lacking = {f"{side}_toe": roles[f"{side}_foot"] for side in SIDES if f"{side}_toe" not in roles}
    return replace(skeleton, roles=roles | lacking) if lacking else skeleton


def limb(skeleton: Skeleton, side: str, kind: str) -> dict[str, int]:
    """Joints of an arm or a leg by part, from the trunk outwards; a collar or a toe that the rig lacks is left out."""
    joints = {part: skeleton.role(f"{side}_{part}") for part in PARTS[kind] if part != "collar"}
    if kind == "arm" and (collar := skeleton.parents[joints["shoulder"]]) not in skeleton.trunk:
        return {"collar": collar, **joints}
    if kind == "leg" and (joints["toe"] == joints["foot"]):
        del joints["toe"]
    return joints


def chains(skeleton: Skeleton) -> tuple[list[int], list[int]]:
    """Joints of the spine, from hips to chest, and of the neck, from chest to head."""
    chest, spine, hips = skeleton.trunk[0], skeleton.trunk[::-1], skeleton.role("hips")
    ends = [j for j, name in enumerate(skeleton.names) if name.lower().endswith("head") and chest in skeleton.ancestors(j)]
    head = skeleton.role("head") if "head" in skeleton.roles else next(iter(ends), chest)
    above = [head, *skeleton.ancestors(head)]
    return spine[spine.index(hips) if hips in spine else 0 :], above[: above.index(chest) + 1][::-1]


def _canonical(side: str, part: str) -> tuple[float, float, float]:
    """Direction of a limb's bone in the T-pose."""
    if part in ("hip", "knee"):
        return 0.0, -1.0, 0.0
    return (1.0 if side == "left" else -1.0), 0.0, 0.0


def _posed(skeleton: Skeleton, local: Tensor, *, upright: bool) -> Anatomy | None:
    """The anatomy from local rotations ``[J, 4]`` of a standing figure with straight limbs; None if they are not one.

    ``upright``: the figure stands on the floor of the world, else its up direction is that of its trunk.
    """
    turned, places = forward_kinematics(skeleton, local, torch.zeros_like(local[0, :3]))
    body = _body(skeleton, places, upright)
    if body is None:
        return None
    axes, bones = {}, {}
    spine, neck = chains(skeleton)
    own = R.inverse(turned)
    for joint in (*spine, *neck):
        axes[joint] = R.multiply(own[joint], body)
    for side in SIDES:
        for kind in PARTS:
            joints, swing = limb(skeleton, side, kind), R.identity(1)[0].to(body)
            for (part, joint), onward in zip(joints.items(), [*list(joints.values())[1:], None], strict=True):
                if onward is not None:
                    bones[joint] = R.rotate(own[joint], places[onward] - places[joint])
                    along = R.rotate(R.inverse(body), places[onward] - places[joint])
                    swing = _swing(along, side, part)
                    if swing is None:
                        return None
                axes[joint] = R.multiply(own[joint], R.multiply(body, R.inverse(swing)))
    if not _straight(skeleton, body, places):
        return None
    rest = local.clone()
    rest[0] = R.multiply(R.inverse(body), local[0])
    return Anatomy(skeleton, axes, rest, bones, spine, neck)


def _body(skeleton: Skeleton, places: Tensor, upright: bool) -> Tensor | None:
    """Rotation ``[4]`` from the canonical axes to the body's in a pose; None where hips and shoulders do not show it."""
    hips, shoulders = ([places[skeleton.role(f"{side}_{part}")] for side in SIDES] for part in ("hip", "shoulder"))
    across = [a - b for a, b in (hips, shoulders)]
    up = (shoulders[0] + shoulders[1] - hips[0] - hips[1]) / 2
    if min(float(v.norm()) for v in (*across, up)) < 1e-3 or float(R.normalize(across[0]) @ R.normalize(across[1])) < 0.5:
        return None
    left, up = R.normalize(R.normalize(across[0]) + R.normalize(across[1])), R.normalize(up)
    if abs(float(left @ up)) > 0.4:
        return None
    if upright:
        up = as_tensor([0.0, 1.0, 0.0], "up", places)
    left = R.normalize(left - (left @ up) * up)
    body = R.from_matrix(torch.stack((left, up, torch.linalg.cross(left, up)), 1))
    return body if upright else _tidy(body[None])


def _swing(along: Tensor, side: str, part: str) -> Tensor | None:
    """The shortest turn ``[4]`` of a limb's bone, in the body's axes, into the T-pose; None if it points elsewhere."""
    if part == "collar":
        return R.identity(1)[0].to(along)
    if part == "foot":
        flat = along * as_tensor([1.0, 0.0, 1.0], "plane", along)
        if float(flat.norm()) < STEEP * float(along.norm()):  # an End Site below the ankle
            return R.identity(1)[0].to(along)
        ahead = as_tensor([0.0, 0.0, 1.0], "ahead", along)
        return R.between(flat, ahead) if float(flat[2]) > 0.2 * float(flat.norm()) else None
    wanted = as_tensor(_canonical(side, part), "wanted", along)
    share = float(R.normalize(along) @ wanted)
    return None if share < (0.8 if part in ("hip", "knee") else -0.3) else R.between(along, wanted)


def _straight(skeleton: Skeleton, body: Tensor, places: Tensor) -> bool:
    """Whether arms and legs are stretched."""
    for side in SIDES:
        for a, b, c in (("hip", "knee", "foot"), ("shoulder", "elbow", "hand")):
            a, b, c = (places[skeleton.role(f"{side}_{part}")] for part in (a, b, c))
            if float(R.normalize(b - a) @ R.normalize(c - b)) < 0.75:
                return False
    return True


def _moving(clip: Clip) -> Anatomy:
    """The anatomy from a motion."""
    skeleton, axes, bones = clip.skeleton, {}, {}
    spine, neck = chains(skeleton)
    axes[spine[0]] = _axes(clip, spine[0])
    for chain in (spine, neck):
        for parent, joint in pairwise(chain):
            axes[joint] = _onward(clip, joint, axes[parent])
    for side in SIDES:
        for kind in PARTS:
            joints = limb(skeleton, side, kind)
            for (part, joint), onward in zip(joints.items(), [*list(joints.values())[1:], None], strict=True):
                if onward is not None:
                    gap = clip.global_positions[:, onward] - clip.global_positions[:, joint]
                    bones[joint] = R.rotate(R.inverse(clip.global_rotations[:, joint]), gap).mean(0)
                if part in ("foot", "toe"):
                    axes[joint] = _flat(clip, joint, joints["foot"], bones.get(joints["foot"]))
                elif part == "hand":
                    axes[joint] = _onward(clip, joint, axes[joints["elbow"]])
                elif part == "collar":
                    axes[joint] = _onward(clip, joint, axes[spine[-1]])
                else:
                    wanted = as_tensor(_canonical(side, part), "wanted", clip.rotations)
                    aimed = _aim(_axes(clip, joint), bones[joint], wanted)
                    axes[joint] = aimed if kind == "leg" else _arm(clip, side, joint, bones[joint], wanted, aimed)
    mean = R.normalize(R.unroll(clip.rotations).mean(0))
    return Anatomy(skeleton, axes, mean, bones, spine, neck)


def _axes(clip: Clip, joint: int) -> Tensor:
    """Axes of a joint's frame nearest to the body's left, up and forward over the clip, as a rotation ``[4]``."""
    facing = R.inverse(root_frames(clip).rotations)
    return R.inverse(_nearest(R.multiply(facing, clip.global_rotations[:, joint])))


def _onward(clip: Clip, joint: int, axes: Tensor) -> Tensor:
    """Axes of a joint from those of its parent: rigs turn them by multiples of 90 degrees, motion turns them by less."""
    return R.multiply(R.inverse(_nearest(clip.rotations[:, joint])), axes)


def _nearest(turns: Tensor) -> Tensor:
    """The rotation ``[4]`` that maps coordinate axes to coordinate axes and is nearest to the mean of ``turns [F, 4]``."""
    mean = R.to_matrix(turns).mean(0)
    axes, left = torch.zeros_like(mean), mean.clone()
    for _ in range(2):  # the two largest entries in turn
        row, column = divmod(int(left.abs().argmax()), 3)
        axes[row, column] = mean[row, column].sign()
        left[row], left[:, column] = 0.0, 0.0
    missing = int((axes.abs().sum(0) == 0).nonzero()[0])
    axes[:, missing] = torch.linalg.cross(axes[:, (missing + 1) % 3], axes[:, (missing + 2) % 3])
    return R.from_matrix(axes)


def _tidy(turn: Tensor, near: float = NEAR) -> Tensor:
    """A rotation ``[1, 4]`` as ``[4]``, exactly between coordinate axes where it is nearly so."""
    nearest = _nearest(turn)
    apart = (R.to_matrix(turn[0]) * R.to_matrix(nearest)).sum(0)  # cosines of the three axes
    return nearest if float(apart.min()) > near else turn[0]


def _aim(axes: Tensor, bone: Tensor, wanted: Tensor) -> Tensor:
    """Axes ``[4]`` turned the shortest way so that the canonical direction ``wanted`` [3] lies along the bone."""
    return R.multiply(R.between(R.normalize(R.rotate(axes, wanted)), R.normalize(bone)), axes)


def _flat(clip: Clip, joint: int, foot: int, bone: Tensor | None) -> Tensor:
    """Axes of a foot or its toe: up is the world's where the foot is lowest, forward is the foot's bone."""
    places = clip.global_positions[:, [foot, *(j for j, p in enumerate(clip.skeleton.parents) if p == foot)], 1].sum(1)
    low = places <= places.quantile(FLAT)
    world = clip.global_rotations[low]
    ahead = R.rotate(root_frames(clip).rotations[low], as_tensor([0.0, 0.0, 1.0], "ahead", places))
    up = torch.zeros_like(ahead)
    up[:, 1] = 1.0
    if bone is not None and float(bone.norm()) > 1e-3:
        along = R.normalize(R.rotate(world[:, foot], bone))
        ahead = ahead if float(along[:, ::2].norm(dim=-1).mean()) < STEEP else along
    up, ahead = (R.normalize(R.rotate(R.inverse(world[:, joint]), v).mean(0)) for v in (up, ahead))
    left = R.normalize(torch.linalg.cross(up, ahead))
    found = R.from_matrix(torch.stack((left, up, torch.linalg.cross(left, up)), 1))
    return _tidy(found[None], near=0.985)


def _arm(clip: Clip, side: str, joint: int, bone: Tensor, wanted: Tensor, aimed: Tensor) -> Tensor:
    """Axes of an arm in the T-pose, where the elbow's axis is vertical; those of a straight arm are ``aimed``."""
    shoulder, elbow, hand = (clip.skeleton.role(f"{side}_{part}") for part in ("shoulder", "elbow", "hand"))
    upper, lower = (clip.global_positions[:, b] - clip.global_positions[:, a] for a, b in ((shoulder, elbow), (elbow, hand)))
    bent = torch.linalg.cross(R.normalize(upper), R.normalize(lower))
    along, hinge = R.normalize(bone), R.rotate(R.inverse(clip.global_rotations[:, joint]), bent).mean(0)
    hinge = hinge - along * (along @ hinge)
    if float(hinge.norm()) < STRAIGHT:
        return aimed
    hinge = R.normalize(hinge)
    down = as_tensor([0.0, -1.0 if side == "left" else 1.0, 0.0], "down", wanted)
    source = torch.stack((along, hinge, torch.linalg.cross(along, hinge)), 1)
    target = torch.stack((wanted, down, torch.linalg.cross(wanted, down)), 1)
    return R.from_matrix(source @ target.T)
