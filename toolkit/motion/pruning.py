"""Body joints: the part of a rig that a model of locomotion needs, without fingers, face, twist bones, clothes and props."""

from itertools import pairwise

import torch

from toolkit.motion import rotations as R
from toolkit.motion.anatomy import LIMB_ROLES, chains
from toolkit.motion.clip import Clip
from toolkit.motion.roles import LIMBS, ROLES, SIDES
from toolkit.motion.skeleton import Skeleton, local_rotations

RIGID = 0.003  # metres that a joint may move in the frame of the joint above a twist bone, which then is left out
TWIST = ("twist", "roll")  # parts of names of joints that only share a limb's rotation


def body_joints(skeleton: Skeleton) -> list[int]:
    """Indices of the body joints: those between hips, head, hands and toes, and the End Sites of these.

    ValueError if a role of `toolkit.motion.anatomy.LIMB_ROLES` is missing.
    """
    if lacking := [role for role in LIMB_ROLES if role not in skeleton.roles]:
        raise ValueError(f"cannot find its {', '.join(lacking)} among {', '.join(skeleton.names)}")
    tips = {skeleton.role(role) for role in ROLES if role in skeleton.roles} | {chains(skeleton)[1][-1]}
    paths = [[tip, *skeleton.ancestors(tip)] for tip in tips]
    shared = set(paths[0]).intersection(*paths)
    kept = {j for path in paths for j in path} - (shared - {max(shared)})  # from the lowest joint above all of them
    ends = {j for j, parent in enumerate(skeleton.parents) if parent in kept and skeleton.is_end(j)
            and (parent in tips or skeleton.parents.count(parent) == 1)}
    return sorted(kept | ends)


def pruned(clip: Clip) -> Clip:
    """The same motion of the body joints alone; the clip itself if it has no others.

    A bone that splits a limb's, such as a twist bone, is left out, too, where the joint below it stays in place to within
    `RIGID`.
    """
    old = clip.skeleton
    kept = body_joints(old)
    roles, places, turned = set(old.roles.values()), clip.global_positions, clip.global_rotations
    split = {j for side in SIDES for parts in LIMBS.values() for upper, lower in pairwise(parts)
             for j in old.ancestors(old.role(f"{side}_{lower}")) if old.role(f"{side}_{upper}") in old.ancestors(j)}
    split |= {j for j in kept if any(word in old.names[j].lower() for word in TWIST)}
    for joint in [j for j in kept if j in split and old.names[j] not in roles]:
        below = [j for j in kept if _above(old, j, kept) == joint]
        above = _above(old, joint, kept)
        if above >= 0 and below:
            local = R.rotate(R.inverse(turned[:, above, None]), places[:, below] - places[:, above, None])
            if float((local - local.mean(0)).norm(dim=-1).amax()) < RIGID:
                kept.remove(joint)
    if len(kept) == len(old):
        return clip
    parents = [_above(old, j, kept) for j in kept]
    offsets = torch.zeros(len(kept), 3)
    for i, (joint, parent) in enumerate(zip(kept, parents, strict=True)):
        if parent == old.parents[joint] or parent < 0:
            offsets[i] = old.offsets[joint]
        else:
            offsets[i] = R.rotate(R.inverse(turned[:, parent]), places[:, joint] - places[:, parent]).mean(0).float().cpu()
    names = [old.names[j] for j in kept]
    skeleton = Skeleton(names, [kept.index(p) if p >= 0 else -1 for p in parents], offsets,
                        {role: name for role, name in old.roles.items() if name in names},
                        [name for name in old.ends if name in names])
    return clip.replace(skeleton=skeleton, rotations=R.unroll(local_rotations(skeleton, turned[:, kept])),
                        root_positions=places[:, kept[0]])


def _above(skeleton: Skeleton, joint: int, kept: list[int]) -> int:
    """The nearest ancestor of a joint that is kept; -1 for none."""
    return next((j for j in skeleton.ancestors(joint) if j in kept), -1)
