"""Motion on other skeletons: that of another humanoid, or the body joints of a rig alone.

`retarget` keeps the other skeleton's bone lengths, axes and rest pose. Limbs keep their directions
in the world (`toolkit.extra.characters.anatomy`), the path is scaled by leg length, and legs are
bent a little where another leg or foot would slide, sink or float. `report` measures the error of a
result. `pruned` leaves out what a model of locomotion does not need: fingers, face, twist bones,
clothes and props.
"""

from collections import Counter, defaultdict
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise, product

import numpy as np
import torch
from torch import Tensor

from toolkit.extra.characters.anatomy import LIMB_ROLES, Anatomy, limb, measure, with_toes
from toolkit.motion import rotations as R
from toolkit.motion.clip import Clip
from toolkit.motion.contacts import detect, standing_height, toes_of, velocities
from toolkit.motion.ik import two_bone
from toolkit.motion.roles import CHAINS, ROLES, SIDES
from toolkit.motion.skeleton import FEET, Skeleton, forward_kinematics, local_rotations
from toolkit.motion.tensors import through_numpy

SAME = 0.002  # metres that bones of equal names may differ on the same skeleton
# height of a standing joint, shares of the leg: usual, and the largest believed
TOE, ANKLE = (0.02, 0.12), (0.1, 0.2)
SOFT = 0.01  # share of a leg's length, near full stretch, over which it follows more slowly
BONES = [bone for parts in CHAINS.values() for bone in pairwise(parts)]  # of arms and legs
RIGID = 0.003  # metres that a joint below a twist bone may move, if the bone is left out
TWIST = ("twist", "roll")  # parts of names of joints that only share a limb's rotation


def retarget(clip: Clip, target: Skeleton | Clip, *, feet: bool = True) -> Clip:
    """The clip on another skeleton.

    Limbs keep their world directions by role; spine and neck are interpolated along their length.
    The path of the hips is scaled by the ratio of the leg lengths, and shifted so that the toes
    stand on the floor y = 0. Twist bones, fingers and other joints without a counterpart follow
    their parents in the rest pose.

    Parameters
    ----------
    clip
        A motion with the roles of `anatomy.LIMB_ROLES`. Without a toe or a collar
        the ankle stands on the floor, and the shoulder follows the chest.
    target
        The skeleton, if its zero rotations are a standing figure (a T-pose, an A-pose, arms that
        hang), facing any way. Or a clip of it, from whose first frame or motion its axes are
        measured. A clip whose skeleton is equal to within `SAME` is returned unchanged.
    feet
        Bend the legs so that feet in contact move as in the clip, at its height above the floor,
        and none is below it.

    Raises
    ------
    ValueError
        If one of the two has not the roles, has legs without length, or its axes cannot be
        measured.
    """
    skeleton = target if isinstance(target, Skeleton) else target.skeleton
    if _same(clip.skeleton, skeleton):
        return clip
    source, goal = measure(clip), measure(target)
    clip = clip.replace(skeleton=source.skeleton)
    turned = _turned(clip, source, goal)
    own, there = _comparable(source.skeleton, goal.skeleton)
    clip, goal = clip.replace(skeleton=own), replace(goal, skeleton=there)

    # The path, seen between the hip joints
    scale = goal.leg / source.leg
    middle = scale * clip.global_positions[:, own.both("hip")].mean(1)
    made = _compose(clip, goal, turned, middle)

    # Lifted so that toes in contact are as high as in the clip
    usual, most = TOE if there.roles["left_toe"] != there.roles["left_foot"] else ANKLE
    stands = scale * float(standing_height(clip))
    if not 0 <= stands <= most * goal.leg:  # the clip's floor is elsewhere
        stands = usual * goal.leg
    rises = scale * (toes_of(clip)[..., 1] - standing_height(clip)) - toes_of(made)[..., 1]
    rises = rises[detect(clip) > 0.5]
    lift = stands + float(rises.median() if len(rises) else -standing_height(made))
    middle[:, 1] += lift
    made = made.moved(shift=(0.0, lift, 0.0))
    if feet:
        made = _compose(clip, goal, _plant(clip, made, turned, scale, stands), middle)
    return made.replace(skeleton=skeleton)


@dataclass(frozen=True)
class Report:
    """The error of a retargeted clip. Angles in degrees, lengths in cm, speeds in cm/s."""

    scale: float  # of the path: the ratio of the leg lengths
    direction: float  # mean angle between the bones of arms and legs here and there
    worst: float  # its largest value
    below: float  # how far a toe is below its standing height at most
    above: float  # how far a toe in contact is from its height in the clip (scaled), on average
    skate: tuple[float, float]  # speed of toes in contact: of the clip (scaled), of the result

    def __str__(self) -> str:
        return (f"limbs {self.direction:.1f}° off on average, {self.worst:.1f}° at most; "
                f"toes in contact {self.above:.1f} cm off their height, "
                f"{self.below:.1f} cm below the floor at most; "
                f"foot skate {self.skate[0]:.1f} → {self.skate[1]:.1f} cm/s")


def report(clip: Clip, made: Clip) -> Report:
    """How far a result of `retarget` is from its clip."""
    own, there = _comparable(with_toes(clip.skeleton), with_toes(made.skeleton))
    clip, made = clip.replace(skeleton=own), made.replace(skeleton=there)
    directions = []
    for c in (clip, made):
        starts, ends = ([c.skeleton.role(f"{side}_{bone[end]}") for side in SIDES for bone in BONES]
                        for end in (0, 1))
        directions.append(c.global_positions[:, ends] - c.global_positions[:, starts])
    angles = torch.rad2deg(R.angle(*directions))

    scale, standing = measure(made).leg / measure(clip).leg, detect(clip) > 0.5
    height = toes_of(made)[..., 1] - standing_height(made)
    off = height - scale * (toes_of(clip)[..., 1] - standing_height(clip))
    speeds = [velocities(by * toes_of(c), c.fps)[..., ::2].norm(dim=-1)
              for c, by in ((clip, scale), (made, 1.0))]
    above, *skate = (100 * float(v[standing].mean()) if bool(standing.any()) else 0.0
                     for v in (off.abs(), *speeds))
    below = max(0.0, -100 * float(height.min()))
    return Report(scale, float(angles.mean()), float(angles.max()), below, above, tuple(skate))


def _same(own: Skeleton, other: Skeleton) -> bool:
    if (own.names, own.parents) != (other.names, other.parents):
        return False
    return bool(((own.offsets - other.offsets)[1:].norm(dim=-1) < SAME).all())


def _comparable(*skeletons: Skeleton) -> list[Skeleton]:
    """The skeletons; if one has no toes, both with the ankles in the role of the toes."""
    if all(s.roles[f"{side}_toe"] != s.roles[f"{side}_foot"] for s in skeletons for side in SIDES):
        return list(skeletons)
    return [replace(s, roles=s.roles | {f"{side}_toe": s.roles[f"{side}_foot"] for side in SIDES})
            for s in skeletons]


def leaders(source: Anatomy, goal: Anatomy) -> dict[int, tuple[int, int, float]]:
    """For each joint of the goal that follows the source: two joints there and a share.

    Arms and legs follow the joint with the same role, spine and neck the place at the same share of
    their length. The share is how far that place is from the first joint to the second.
    """
    found, own, other = {}, source.skeleton, goal.skeleton
    for side, kind in product(SIDES, CHAINS):
        joints, there = (limb(skeleton, side, kind) for skeleton in (own, other))
        found |= {there[part]: (joints[part], joints[part], 0.0) for part in joints
                  if part in there}
    for from_, to in ((own.trunk[::-1], other.trunk[::-1]), (own.neck, other.neck)):
        for i, joint in enumerate(to):
            place = i / max(len(to) - 1, 1) * (len(from_) - 1)
            below = min(int(place), max(len(from_) - 2, 0))
            found[joint] = from_[below], from_[min(below + 1, len(from_) - 1)], place - below
    return found


def _turned(clip: Clip, source: Anatomy, goal: Anatomy) -> dict[int, Tensor]:
    """World rotations ``[F, 4]`` of joints with `leaders`: from the T-pose as far as these."""
    turned = {}
    for joint, (a, b, share) in leaders(source, goal).items():
        first, second = (R.multiply(clip.global_rotations[:, j], source.axes[j]) for j in (a, b))
        turned[joint] = R.multiply(R.slerp(first, second, share) if share else first,
                                   R.inverse(goal.axes[joint]))
    return turned


def _compose(clip: Clip, goal: Anatomy, turned: dict[int, Tensor], middle: Tensor) -> Clip:
    """The clip of world rotations, with the ``middle [F, 3]`` of the hip joints.

    Joints without a world rotation keep their rest pose.
    """
    skeleton, rest = goal.skeleton, goal.rest.to(clip.rotations)
    world: list[Tensor] = []
    for joint, parent in enumerate(skeleton.parents):
        if joint in turned and not skeleton.is_end(joint):
            world.append(turned[joint])
        else:
            world.append(rest[0].expand(len(clip), 4) if parent < 0
                         else R.multiply(world[parent], rest[joint]))
    local = R.normalize(R.unroll(local_rotations(skeleton, torch.stack(world, 1))))
    placed = forward_kinematics(skeleton, local, torch.zeros_like(middle))[1]
    placed = placed[:, skeleton.both("hip")].mean(1)
    return clip.replace(skeleton=skeleton, rotations=local, root_positions=middle - placed)


def _plant(clip: Clip, made: Clip, turned: dict[int, Tensor], scale: float,
           floor: float) -> dict[int, Tensor]:
    """The world rotations with legs bent: toes in contact move over the floor as the clip's do.

    ``floor`` is the height of a standing toe. A toe keeps its mean place in each contact. Its
    correction is interpolated between contacts.
    """
    skeleton = made.skeleton
    wanted, toes, contact = scale * toes_of(clip), toes_of(made), detect(clip)
    wanted[..., 1] += floor - scale * standing_height(clip)
    turned, hips = dict(turned), made.global_positions[:, skeleton.both("hip")]
    for foot, side in enumerate(FEET):
        hip, knee, ankle = (skeleton.role(f"{side}_{part}") for part in ("hip", "knee", "foot"))
        a, b, c = (made.global_positions[:, j] for j in (hip, knee, ankle))
        standing = (contact[:, foot] > 0.5).cpu().numpy()
        shift = through_numpy(partial(_corrections, standing=standing),
                              wanted[:, foot] - toes[:, foot])
        shift[:, 1] = torch.maximum(shift[:, 1], floor - toes[:, foot, 1])
        full = ((b - a).norm(dim=-1) + (c - b).norm(dim=-1))[:, None]
        # a leg without correction keeps its bend
        soft = (1 - R.length(c - a) / full).clamp(0.0, SOFT)
        middle, end = two_bone(a, b, c, c + shift, soft=soft, left=hips[:, 1] - hips[:, 0])
        for joint, old, new in ((hip, b - a, middle - a), (knee, c - b, end - middle)):
            turned[joint] = R.multiply(R.between(old, new), turned[joint])
    return turned


def _corrections(gap: np.ndarray, standing: np.ndarray) -> np.ndarray:
    """Corrections ``[F, 3]`` of a toe: its gap to the clip's, without the mean of each contact."""
    frames = np.flatnonzero(standing)
    if not len(frames):
        return np.zeros_like(gap)
    kept = gap[frames].copy()
    for contact in np.split(np.arange(len(frames)), np.flatnonzero(np.diff(frames) > 1) + 1):
        kept[contact, ::2] -= kept[contact, ::2].mean(0)
    made = [np.interp(np.arange(len(gap)), frames, column) for column in kept.T]
    return np.stack(made, 1).astype(gap.dtype)


def body_joints(skeleton: Skeleton) -> list[int]:
    """Indices of the joints between hips, head, hands and toes, and of the End Sites of these.

    ValueError if a role of `anatomy.LIMB_ROLES` is missing.
    """
    if lacking := [role for role in LIMB_ROLES if role not in skeleton.roles]:
        raise ValueError(f"cannot find its {', '.join(lacking)} among {', '.join(skeleton.names)}")
    tips = {skeleton.role(role) for role in ROLES if role in skeleton.roles}
    tips.add(skeleton.neck[-1])
    paths = [skeleton.tree.up(tip) for tip in tips]
    # Joints above all of them are left out, but for the lowest one
    shared = set(paths[0]).intersection(*paths)
    kept = {j for path in paths for j in path} - (shared - {max(shared)})
    children = Counter(skeleton.parents)
    kept |= {j for j, parent in enumerate(skeleton.parents) if skeleton.is_end(j)
             and parent in kept and (parent in tips or children[parent] == 1)}
    return sorted(kept)


def pruned(clip: Clip) -> Clip:
    """The same motion of the body joints alone; the clip itself if it has no others.

    A bone that splits a limb's, such as a twist bone, is left out, too, where the joint below it
    stays in place to within `RIGID`.
    """
    old = clip.skeleton
    body = body_joints(old)
    roles, places, turned = set(old.roles.values()), clip.global_positions, clip.global_rotations

    # Joints without a role between two parts of a limb, or called a twist bone
    split = {j for j in body if any(word in old.names[j].lower() for word in TWIST)}
    for side in SIDES:
        for upper, lower in BONES:
            start = old.role(f"{side}_{upper}")
            path = old.tree.up(old.role(f"{side}_{lower}"))[1:]
            split |= set(path[: path.index(start)] if start in path else ())

    # The parent of each joint that is kept, and their children
    parents, children = {}, defaultdict(list)
    for j in body:
        above = old.parents[j]
        while above >= 0 and above not in parents:
            above = old.parents[above]
        parents[j] = above
        children[above].append(j)
    for joint in [j for j in body if j in split and old.names[j] not in roles]:
        above, below = parents[joint], children[joint]
        if above >= 0 and below:
            apart = places[:, below] - places[:, above, None]
            local = R.rotate(R.inverse(turned[:, above, None]), apart)
            if float((local - local.mean(0)).norm(dim=-1).amax()) < RIGID:
                del parents[joint]
                parents |= dict.fromkeys(below, above)
                children[above] += below
    if len(parents) == len(old):
        return clip
    kept, place = list(parents), {j: i for i, j in enumerate(parents)}

    offsets = old.offsets[kept].clone()
    for i, (joint, parent) in enumerate(parents.items()):
        if parent != old.parents[joint] and parent >= 0:  # over a joint that was left out
            apart = places[:, joint] - places[:, parent]
            offsets[i] = R.rotate(R.inverse(turned[:, parent]), apart).mean(0).float().cpu()
    names = [old.names[j] for j in kept]
    skeleton = Skeleton(names, [place.get(p, -1) for p in parents.values()], offsets,
                        {role: name for role, name in old.roles.items() if name in names},
                        [name for name in old.ends if name in names])
    rotations = R.unroll(local_rotations(skeleton, turned[:, kept]))
    return clip.replace(skeleton=skeleton, rotations=rotations, root_positions=places[:, kept[0]])
