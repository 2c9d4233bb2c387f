"""From joint positions to rotations: a rigid skeleton and its motion, fitted to recorded points."""

from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.motion import rotations as R


def fit(parents: Sequence[int], rest: Tensor, positions: Tensor) -> tuple[Tensor, Tensor, float]:
    """Skeleton and local rotations whose joints are nearest to positions.

    Bone lengths are the medians over the frames. A joint with one child turns the shortest way from its parent's rotation,
    since a twist about the bone cannot be seen. A joint with several children has the rotation that fits their mean
    arrangement best in the sense of least squares (Kabsch 1976). Rigid motion is reproduced exactly.

    Parameters
    ----------
    parents
        J, the root first with -1, parents before children.
    rest : Tensor [J, 3]
        Offsets from the parents in the pose of zero rotation; of bones with siblings only their mean direction is used.
    positions : Tensor [F, J, 3]

    Returns
    -------
    offsets : Tensor [J, 3]
    rotations : Tensor [F, J, 4], local
    error : the largest distance between a joint of the skeleton and its position
    """
    positions, rest = positions.double(), rest.double()
    bones = positions[:, 1:] - positions[:, list(parents[1:])]
    lengths = bones.norm(dim=-1).median(0).values
    bones, lengths = torch.cat((bones[:, :1], bones), 1), torch.cat((lengths[:1], lengths))  # row j belongs to joint j
    offsets = R.normalize(rest) * lengths[:, None]
    offsets[0] = 0.0
    local, world = R.identity(len(positions), len(parents)).double(), {-1: R.identity(len(positions)).double()}
    for j, parent in enumerate(parents):
        children = [child for child, p in enumerate(parents) if p == j]
        turned = world[parent]
        if len(children) == 1:
            turned = R.multiply(R.between(R.rotate(turned, offsets[children[0]]), bones[:, children[0]]), turned)
        elif children:
            there = bones[:, children]
            mean = R.rotate(R.inverse(_kabsch(offsets[children], there))[:, None], there).mean(0)
            offsets[children] = R.normalize(mean) * lengths[children, None]
            turned = _kabsch(offsets[children], there)
        world[j] = turned
        local[:, j] = R.multiply(R.inverse(world[parent]), turned)
    places = [positions[:, 0]]
    for j, parent in enumerate(parents[1:], 1):
        places.append(places[parent] + R.rotate(world[parent], offsets[j]))
    error = (torch.stack(places, 1) - positions).norm(dim=-1).max()
    return offsets, local, float(error)


def _kabsch(source: Tensor, target: Tensor) -> Tensor:
    """Rotations ``[F, 4]`` that turn vectors ``source [N, 3]`` nearest to ``target [F, N, 3]``."""
    left, _, right = torch.linalg.svd(target.transpose(1, 2) @ source)
    left = torch.cat((left[..., :2], left[..., 2:] * torch.linalg.det(left @ right)[:, None, None]), -1)
    return R.from_matrix(left @ right)
