"""A rigid skeleton fitted to joint positions, and SMPL's joints."""

from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.motion import rotations as R

NAMES = ("pelvis", "left_hip", "right_hip", "spine1", "left_knee", "right_knee", "spine2",
         "left_ankle", "right_ankle", "spine3", "left_foot", "right_foot", "neck", "left_collar",
         "right_collar", "head", "left_shoulder", "right_shoulder", "left_elbow", "right_elbow",
         "left_wrist", "right_wrist")  # SMPL's
PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)
FPS = 20.0  # of HumanML3D's positions (Guo et al. 2022)


def fit(parents: Sequence[int], rest: Tensor, positions: Tensor) -> tuple[Tensor, Tensor, float]:
    """Skeleton and local rotations whose joints are nearest to positions.

    Bone lengths are the medians over the frames. A joint with one child turns the shortest way from
    its parent's rotation, since a twist about the bone cannot be seen. A joint with several
    children has the rotation that fits their mean arrangement best in the sense of least squares
    (Kabsch 1976). Rigid motion is reproduced exactly.

    Parameters
    ----------
    parents
        J, the root first with -1, parents before children.
    rest : Tensor [J, 3]
        Offsets from the parents in the pose of zero rotation; of bones with siblings only their
        mean direction is used.
    positions : Tensor [F, J, 3]

    Returns
    -------
    offsets : Tensor [J, 3]
    rotations : Tensor [F, J, 4], local
    error : the largest distance between a joint of the skeleton and its position
    """
    positions, rest, above = positions.double(), rest.double(), list(parents[1:])
    bones = torch.zeros_like(positions)  # from the parent, row j belongs to joint j
    bones[:, 1:] = positions[:, 1:] - positions[:, above]
    lengths = bones.norm(dim=-1).median(0).values
    offsets = R.normalize(rest) * lengths[:, None]

    local = R.identity(len(positions), len(parents)).double()
    world = {-1: R.identity(len(positions)).double()}
    for j, parent in enumerate(parents):
        children = [child for child, p in enumerate(parents) if p == j]
        turned = world[parent]
        if len(children) == 1:
            bone = R.rotate(turned, offsets[children[0]])
            turned = R.multiply(R.between(bone, bones[:, children[0]]), turned)
        elif children:
            # The bones' mean arrangement in the joint's frame, then the rotation that fits it best
            there = bones[:, children]
            mean = R.rotate(R.inverse(_kabsch(offsets[children], there))[:, None], there).mean(0)
            offsets[children] = R.normalize(mean) * lengths[children, None]
            turned = _kabsch(offsets[children], there)
        world[j] = turned
        local[:, j] = R.multiply(R.inverse(world[parent]), turned)

    places = [positions[:, 0]]
    for j, parent in enumerate(above, 1):
        places.append(places[parent] + R.rotate(world[parent], offsets[j]))
    error = (torch.stack(places, 1) - positions).norm(dim=-1).max()
    return offsets, local, float(error)


def _kabsch(source: Tensor, target: Tensor) -> Tensor:
    """Rotations ``[F, 4]`` that turn vectors ``source [N, 3]`` nearest to ``target [F, N, 3]``."""
    left, _, right = torch.linalg.svd(target.transpose(1, 2) @ source)
    # without a reflection
    sign = torch.linalg.det(left @ right)[:, None, None]
    left = torch.cat((left[..., :2], left[..., 2:] * sign), -1)
    return R.from_matrix(left @ right)
