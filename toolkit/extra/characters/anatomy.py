"""Anatomy of a humanoid rig: which axes of each joint point left, up and forward in a T-pose.

Rigs differ in the pose of zero rotations (T-pose, A-pose, or no pose of a body at all) and in the
axes of their joints. We compare them in one canonical pose: a T-pose that faces +z, with straight
legs and flat feet, where left, up and forward are x, y and z. `Anatomy.axes` holds for each joint
the rotation from these axes to the joint's own. ``global rotation × axes`` is how far the joint has
turned from the T-pose, which means the same on every rig.

The axes are measured in one of two ways:

- In the pose of a standing figure with straight limbs: that of zero rotations, or that of a clip
  without motion (a bind pose). Bones of limbs are turned the shortest way into the T-pose.
- Over a motion, where there is no such pose. Hips and legs have the coordinate axes nearest to the
  body's own, turned so that the bone has its direction in the T-pose. Arms mostly hang, so their
  axes are found from the bone and the elbow's axis. A foot is flat where it is lowest. Spine, neck,
  head, collars and hands have the axes of their parent, up to turns of 90 degrees.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise, product

import torch
from scipy.spatial.transform import Rotation
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.clip import Clip, root_frames
from toolkit.motion.roles import ROLES, SIDES
from toolkit.motion.skeleton import Skeleton, forward_kinematics
from toolkit.motion.tensors import summary

LIMB_ROLES = tuple(role for role in ROLES if not role.endswith("toe"))  # a rig may lack toes
#: From the trunk outwards.
PARTS = {"arm": ("collar", "shoulder", "elbow", "hand"), "leg": ("hip", "knee", "foot", "toe")}
STEEP = 0.3  # sine from the vertical below which a foot's bone does not show where the foot points
SHORT = 0.01  # metres; a shorter leg is none
STRAIGHT = 0.02  # sine of the mean bend below which an arm's elbow axis cannot be found
NEAR, NEAR_FOOT = 0.85, 0.985  # cosines from which axes count as turned by multiples of 90 degrees
#: The 24 rotations between coordinate axes, matrices ``[24, 3, 3]``.
AXES = torch.from_numpy(Rotation.create_group("O").as_matrix().round())
STILL = 1e-3  # change of quaternions up to which a clip shows one pose
FLAT = 0.1  # share of the frames in which a foot is lowest: there it lies flat on the floor


@dataclass(frozen=True, eq=False)
class Anatomy:
    """What retargeting knows of a rig; `measure` makes it."""

    skeleton: Skeleton  # with toes: the role of a missing one is given to the ankle
    axes: dict[int, Tensor]  # joint -> rotation [4] from the canonical axes to the joint's own
    rest: Tensor  # [J, 4] local rotations of joints that nothing moves
    bones: dict[int, Tensor]  # joint of a limb -> vector [3] to the next one, in its frame, metres
    __repr__ = summary

    @property
    def leg(self) -> float:
        """Hip to ankle along the bones, metres."""
        return sum(float(self.bones[self.skeleton.role(role)].norm())
                   for role in ("left_hip", "left_knee"))


def measure(rig: Clip | Skeleton) -> Anatomy:
    """The anatomy of a skeleton, or of a clip's skeleton.

    Raises
    ------
    ValueError
        If roles are missing, the legs have no length, or a skeleton is given alone whose zero
        rotations are no standing figure: then a clip of it is needed.
    """
    clip, skeleton = (None, rig) if isinstance(rig, Skeleton) else (rig, rig.skeleton)
    name = "the skeleton" if clip is None else clip.name
    if lacking := [role for role in LIMB_ROLES if role not in skeleton.roles]:
        raise ValueError(f"{name}: cannot find its {', '.join(lacking)} among "
                         f"{', '.join(skeleton.names)}")
    skeleton = with_toes(skeleton)
    like = clip.rotations if clip is not None else torch.zeros(0)
    zero = R.identity(len(skeleton), dtype=like.dtype, device=like.device)
    found = _from_pose(skeleton, zero, upright=False)
    if found is None and clip is not None:
        clip = clip.replace(skeleton=skeleton)
        if float((clip.rotations - clip.rotations[:1]).abs().amax()) < STILL:
            found = _from_pose(skeleton, clip.rotations[0], upright=True)
        else:
            found = _from_motion(clip)
    if found is None:
        raise ValueError(f"{name}: its zero rotations are no standing figure; "
                         "give a file of it with a T-pose or a motion")
    if found.leg < SHORT:
        raise ValueError(f"{name}: its legs have no length")
    return found


def with_toes(skeleton: Skeleton) -> Skeleton:
    """The skeleton with a toe on both feet: where none is known, the ankle has that role, too."""
    roles = skeleton.roles
    lacking = {f"{side}_toe": roles[f"{side}_foot"] for side in SIDES if f"{side}_toe" not in roles}
    return replace(skeleton, roles=roles | lacking) if lacking else skeleton


def limb(skeleton: Skeleton, side: str, kind: str) -> dict[str, int]:
    """Joints of an arm or a leg by part, outwards, without a collar or a toe that the rig lacks."""
    joints = {part: skeleton.role(f"{side}_{part}") for part in PARTS[kind] if part != "collar"}
    if kind == "arm" and (collar := skeleton.parents[joints["shoulder"]]) not in skeleton.trunk:
        return {"collar": collar, **joints}
    if kind == "leg" and joints["toe"] == joints["foot"]:
        del joints["toe"]
    return joints


def _outwards(joints: dict[str, int]) -> Iterator[tuple[str, int, int | None]]:
    """Part, joint and next joint of a limb; None at its end."""
    order = list(joints.values())
    return zip(joints, order, [*order[1:], None], strict=True)


def _t_pose_direction(like: Tensor, side: str, part: str) -> Tensor:
    """Direction ``[3]`` of a limb's bone in the T-pose: legs point down, arms to their side."""
    if part in ("hip", "knee"):
        return like.new_tensor([0.0, -1.0, 0.0])
    return like.new_tensor([1.0 if side == "left" else -1.0, 0.0, 0.0])


# Of a pose -------------------------------------------------------------------------------------


def _from_pose(skeleton: Skeleton, local: Tensor, *, upright: bool) -> Anatomy | None:
    """The anatomy from local rotations ``[J, 4]``; None if they are no standing figure.

    ``upright``: up is the world's, else it is that of the trunk.
    """
    turned, places = forward_kinematics(skeleton, local, torch.zeros_like(local[0, :3]))
    body = _body_axes(skeleton, places, upright)
    if body is None or not _limbs_are_straight(skeleton, places):
        return None
    own = R.inverse(turned)
    middle = (*skeleton.trunk, *skeleton.neck)
    axes, bones = {joint: R.multiply(own[joint], body) for joint in middle}, {}
    for side, kind in product(SIDES, PARTS):
        for part, joint, beyond in _outwards(limb(skeleton, side, kind)):
            if beyond is not None:  # the last joint turns with the bone before it
                bone = places[beyond] - places[joint]
                bones[joint] = R.rotate(own[joint], bone)
                swing = _swing(R.rotate(R.inverse(body), bone), side, part)
                if swing is None:
                    return None
            axes[joint] = R.multiply(own[joint], R.multiply(body, R.inverse(swing)))
    rest = local.clone()
    rest[0] = R.multiply(R.inverse(body), local[0])
    return Anatomy(skeleton, axes, rest, bones)


def _body_axes(skeleton: Skeleton, places: Tensor, upright: bool) -> Tensor | None:
    """Rotation ``[4]`` from the canonical axes to the body's, from joints' ``places [J, 3]``.

    None where hips and shoulders do not show it.
    """
    left_hip, right_hip, left_shoulder, right_shoulder = (
        places[skeleton.role(f"{side}_{part}")] for part in ("hip", "shoulder") for side in SIDES)
    hips, shoulders = left_hip - right_hip, left_shoulder - right_shoulder
    up = (left_shoulder + right_shoulder - left_hip - right_hip) / 2
    if min(float(v.norm()) for v in (hips, shoulders, up)) < 1e-3:
        return None
    hips, shoulders, up = (R.normalize(v) for v in (hips, shoulders, up))
    left = R.normalize(hips + shoulders)
    if float(hips @ shoulders) < 0.5 or abs(float(left @ up)) > 0.4:
        return None
    if upright:
        up = places.new_tensor([0.0, 1.0, 0.0])
    body = R.from_forward_up(torch.linalg.cross(left, up), up)
    return body if upright else _rounded(body, NEAR)


def _limbs_are_straight(skeleton: Skeleton, places: Tensor) -> bool:
    """Whether arms and legs are stretched."""
    for side, parts in product(SIDES, (PARTS["arm"][1:], PARTS["leg"][:3])):
        a, b, c = (places[skeleton.role(f"{side}_{part}")] for part in parts)
        if float(R.normalize(b - a) @ R.normalize(c - b)) < 0.75:
            return False
    return True


def _swing(bone: Tensor, side: str, part: str) -> Tensor | None:
    """The shortest turn ``[4]`` of a bone, in the body's axes, into the T-pose.

    None if the bone points elsewhere than that of a standing figure.
    """
    none = R.identity(1)[0].to(bone)
    if part == "collar":
        return none
    if part == "foot":
        flat = bone * bone.new_tensor([1.0, 0.0, 1.0])
        if float(flat.norm()) < STEEP * float(bone.norm()):  # an End Site below the ankle
            return none
        forward = float(flat[2]) > 0.2 * float(flat.norm())
        return R.between(flat, bone.new_tensor([0.0, 0.0, 1.0])) if forward else None
    wanted = _t_pose_direction(bone, side, part)
    least = 0.8 if part in ("hip", "knee") else -0.3  # arms may hang
    return R.between(bone, wanted) if float(R.normalize(bone) @ wanted) >= least else None


# Of a motion -----------------------------------------------------------------------------------


def _from_motion(clip: Clip) -> Anatomy:
    """The anatomy from a motion."""
    skeleton, turned, places = clip.skeleton, clip.global_rotations, clip.global_positions
    spine = skeleton.trunk[::-1]
    axes, bones = {spine[0]: _mean_axes(clip, spine[0])}, {}
    for parent, joint in (*pairwise(spine), *pairwise(skeleton.neck)):
        axes[joint] = _inherited(clip, joint, axes[parent])
    for side, kind in product(SIDES, PARTS):
        joints = limb(skeleton, side, kind)
        for part, joint, beyond in _outwards(joints):
            if beyond is not None:
                bone = places[:, beyond] - places[:, joint]
                bones[joint] = R.rotate(R.inverse(turned[:, joint]), bone).mean(0)
            if part == "collar":
                axes[joint] = _inherited(clip, joint, axes[spine[-1]])
            elif part == "hand":
                axes[joint] = _inherited(clip, joint, axes[joints["elbow"]])
            elif part in ("foot", "toe"):
                axes[joint] = _foot_axes(clip, joint, joints["foot"], bones.get(joints["foot"]))
            else:
                axes[joint] = _bone_axes(clip, side, part, joint, bones[joint])
    return Anatomy(skeleton, axes, R.normalize(R.unroll(clip.rotations).mean(0)), bones)


def _bone_axes(clip: Clip, side: str, part: str, joint: int, bone: Tensor) -> Tensor:
    """Axes of a joint of a limb with the direction of its bone in the T-pose."""
    wanted = _t_pose_direction(clip.rotations, side, part)
    if part in PARTS["arm"]:
        hinge = _elbow_axis(clip, side, joint, bone)
        if hinge is not None:  # vertical in the T-pose
            down = wanted.new_tensor([0.0, -1.0 if side == "left" else 1.0, 0.0])
            return R.multiply(R.from_forward_up(bone, hinge),
                              R.inverse(R.from_forward_up(wanted, down)))

    # The axes nearest to the body's, turned the shortest way
    near = _mean_axes(clip, joint)
    return R.multiply(R.between(R.rotate(near, wanted), bone), near)


def _mean_axes(clip: Clip, joint: int) -> Tensor:
    """Axes ``[4]`` of a joint's frame nearest to the body's left, up and forward over the clip."""
    facing = R.inverse(root_frames(clip).rotations)
    return R.inverse(_nearest(R.multiply(facing, clip.global_rotations[:, joint])))


def _inherited(clip: Clip, joint: int, axes: Tensor) -> Tensor:
    """Axes of a joint from those of its parent.

    Rigs turn them by multiples of 90 degrees, motion turns them by less.
    """
    return R.multiply(R.inverse(_nearest(clip.rotations[:, joint])), axes)


def _nearest(turns: Tensor) -> Tensor:
    """The rotation ``[4]`` between coordinate axes nearest to the mean of ``turns [F, 4]``."""
    mean = R.to_matrix(turns).mean(0)
    axes = AXES.to(mean)
    return R.from_matrix(axes[(axes * mean).sum((1, 2)).argmax()])


def _rounded(turn: Tensor, near: float) -> Tensor:
    """A rotation ``[4]``, exactly between coordinate axes where all cosines are above ``near``."""
    nearest = _nearest(turn[None])
    cosines = (R.to_matrix(turn) * R.to_matrix(nearest)).sum(0)
    return nearest if float(cosines.min()) > near else turn


def _foot_axes(clip: Clip, joint: int, foot: int, bone: Tensor | None) -> Tensor:
    """Axes of a foot or its toe where the foot is lowest: up is the world's, forward its bone's."""
    points = [foot, *(j for j, p in enumerate(clip.skeleton.parents) if p == foot)]
    height = clip.global_positions[:, points, 1].sum(1)
    low = height <= height.quantile(FLAT)
    turned = clip.global_rotations[low]
    ahead = R.rotate(root_frames(clip).rotations[low], height.new_tensor([0.0, 0.0, 1.0]))
    if bone is not None and float(bone.norm()) > 1e-3:
        along = R.normalize(R.rotate(turned[:, foot], bone))
        if float(along[:, ::2].norm(dim=-1).mean()) >= STEEP:
            ahead = along
    up = height.new_tensor([0.0, 1.0, 0.0])
    own = R.inverse(turned[:, joint])
    up, ahead = (R.normalize(R.rotate(own, v).mean(0)) for v in (up, ahead))
    left = torch.linalg.cross(up, ahead)
    return _rounded(R.from_forward_up(torch.linalg.cross(left, up), up), NEAR_FOOT)


def _elbow_axis(clip: Clip, side: str, joint: int, bone: Tensor) -> Tensor | None:
    """The axis ``[3]`` about which an elbow bends, in a joint's frame; None of a straight arm."""
    parts = PARTS["arm"][1:]
    shoulder, elbow, hand = (clip.global_positions[:, clip.skeleton.role(f"{side}_{part}")]
                             for part in parts)
    bent = torch.linalg.cross(R.normalize(elbow - shoulder), R.normalize(hand - elbow))
    hinge = R.rotate(R.inverse(clip.global_rotations[:, joint]), bent).mean(0)
    along = R.normalize(bone)
    hinge = hinge - along * (along @ hinge)
    return None if float(hinge.norm()) < STRAIGHT else hinge

