"""Joint positions: from HumanML3D's 263 numbers a frame, and a rigid skeleton fitted to positions.

The definitions are those of the dataset's public processing code (Guo et al. 2022,
github.com/EricGuo5513/HumanML3D). Those that matter:

- 20 frames per second, metres, y up, the character's left is +x.
- The root's rotation turns the facing direction *to* +z, i.e. from the world into the body's frame.
  Its velocity is the arcsine of the quaternion's y, which is half the angle.
- The root's velocity (x, z) is seen from the later frame's body.

Root velocities and local positions give the joints. The rotations, joint velocities and contacts
that follow them in a row are redundant.
"""

from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.motion import rotations as R

NAMES = ("pelvis", "left_hip", "right_hip", "spine1", "left_knee", "right_knee", "spine2",
         "left_ankle", "right_ankle", "spine3", "left_foot", "right_foot", "neck", "left_collar",
         "right_collar", "head", "left_shoulder", "right_shoulder", "left_elbow", "right_elbow",
         "left_wrist", "right_wrist")  # SMPL's
PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)
FPS = 20.0
BLOCKS = (1, 2, 1, 63, 126, 66, 4)  # turn, velocity, height, positions, then the redundant ones
WIDTH = sum(BLOCKS)


def to_joints(vectors: Tensor) -> Tensor:
    """Joint positions ``[F, 22, 3]`` of rows ``[F, 263]``.

    The first frame stands at the origin of the floor and faces +z.
    """
    turn, velocity, height, positions, *_ = vectors.split(BLOCKS, 1)

    # A row's velocities lead to the next frame, so frame 0 has no turn and stands at the origin
    half = torch.cat((turn.new_zeros(1), turn[:, 0].cumsum(0)))  # half the angles of F + 1 frames
    back = R.yaw(-2 * half)
    steps = torch.stack((velocity[:, 0], torch.zeros_like(half[1:]), velocity[:, 1]), -1)
    path = torch.cat((steps.new_zeros(1, 3), R.rotate(back[1:], steps).cumsum(0)))[:-1]

    joints = R.rotate(back[:-1, None], positions.unflatten(1, (-1, 3))) + path[:, None]
    root = path + torch.nn.functional.pad(height, (1, 1))
    return torch.cat((root[:, None], joints), 1)


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
