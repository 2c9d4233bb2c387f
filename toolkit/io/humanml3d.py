"""Joint positions: HumanML3D's 263 numbers a frame and back (Guo et al. 2022), and a rigid skeleton fitted to positions.

The definitions are those of the dataset's public processing code (github.com/EricGuo5513/HumanML3D). Those that matter:

- 20 frames per second, metres, y up, the character's left is +x. F + 1 frames of joints give F rows, since velocities are
  differences to the next frame.
- In the first frame the body faces along (up × across), where across is the sum of the hips' and the shoulders' vectors
  from left to right. In all other frames across is their *difference*, shoulders minus hips, and the direction is smoothed
  over time by a Gaussian of 20 frames. So the body turns by several degrees between the first two frames, and the last 80
  rows depend on where the clip ends.
- The root's rotation turns the facing direction *to* +z, i.e. from the world into the body's frame. Its velocity is the
  arcsine of the quaternion's y, which is half the angle. The root's velocity (x, z) is seen from the later frame's body,
  the joints' velocities from the earlier frame's.
- Every bone's rotation is the shortest one from a fixed direction (legs and arms point down, toes and head forward),
  relative to the bone before it. All chains begin at the root's rotation, also those of the arms. The six numbers are the
  first two columns of the matrix.
- A foot is in contact while ankle or toe moves by less than √0.002 m = 4.5 cm a frame, i.e. 0.9 m/s, whatever its height.

Positions are recovered from root velocities and local positions alone; rotations and joint velocities are redundant.
"""

from collections.abc import Sequence

import scipy
import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.tensors import as_tensor, through_numpy

NAMES = ("pelvis", "left_hip", "right_hip", "spine1", "left_knee", "right_knee", "spine2", "left_ankle", "right_ankle",
         "spine3", "left_foot", "right_foot", "neck", "left_collar", "right_collar", "head", "left_shoulder",
         "right_shoulder", "left_elbow", "right_elbow", "left_wrist", "right_wrist")  # SMPL's
PARENTS = (-1, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 12, 13, 14, 16, 17, 18, 19)
FPS = 20.0
WIDTH = 263
SMOOTH = 20.0  # frames, standard deviation
STILL = 0.002  # square metres
FEET = ("left_ankle", "left_foot", "right_ankle", "right_foot")
_UP, _DOWN, _FORWARD, _LEFT, _RIGHT = (0, 1, 0), (0, -1, 0), (0, 0, 1), (1, 0, 0), (-1, 0, 0)
_DIRECTIONS = {"left_hip": _LEFT, "left_collar": _LEFT, "right_hip": _RIGHT, "right_collar": _RIGHT, "spine1": _UP,
               "spine2": _UP, "spine3": _UP, "neck": _UP, "head": _FORWARD, "left_foot": _FORWARD, "right_foot": _FORWARD}
_PARTS = {"turn": 1, "velocity": 2, "height": 1, "positions": 63, "rotations": 126, "velocities": 66, "contacts": 4}


def to_vectors(joints: Tensor) -> Tensor:
    """The representation ``[F, 263]`` of joint positions ``[F + 1, 22, 3]`` in the order of `NAMES`, metres.

    Position and direction on the floor do not matter: the first frame is turned to face +z, as in the dataset. Heights are
    taken as they are: HumanML3D's clips have their lowest point at 0, and bone lengths of one person.
    """
    joints = as_tensor(joints, "joints")
    if joints.dim() != 3 or joints.shape[1:] != (len(NAMES), 3) or len(joints) < 2:
        raise ValueError(f"expected joints [F + 1, {len(NAMES)}, 3], F >= 1, got {list(joints.shape)}")
    joints = R.rotate(facing(joints[:1]), joints)
    turn = facing(joints)
    step, moves = R.multiply(turn[1:], R.inverse(turn[:-1])), joints[1:] - joints[:-1]
    local = joints - joints[:, :1] * joints.new_tensor([1.0, 0.0, 1.0])
    feet = [NAMES.index(name) for name in FEET]
    parts = {
        "turn": (step[:, 2] * step[:, 0].sign()).clamp(-1, 1).asin()[:, None],
        "velocity": R.rotate(turn[1:], moves[:, 0])[:, ::2],
        "height": joints[:-1, 0, 1:2],
        "positions": R.rotate(turn[:-1, None], local[:-1, 1:]),
        "rotations": R.to_matrix(_bones(joints[:-1], turn[:-1]))[..., :2].transpose(-1, -2),
        "velocities": R.rotate(turn[:-1, None], moves),
        "contacts": (moves[:, feet].square().sum(-1) < STILL).to(joints),
    }
    return torch.cat([parts[name].flatten(1) for name in _PARTS], 1)


def to_joints(vectors: Tensor, *, last: bool = False) -> Tensor:
    """Joint positions ``[F, 22, 3]`` of the representation ``[F, 263]``.

    The first frame stands at the origin of the floor and faces +z. With ``last`` there are F + 1 frames: the
    velocities of the last row give one more.
    """
    vectors = as_tensor(vectors, "vectors")
    if vectors.dim() != 2 or vectors.shape[1] != WIDTH or not len(vectors):
        raise ValueError(f"expected HumanML3D's numbers [F, {WIDTH}], F >= 1, got {list(vectors.shape)}")
    parts = dict(zip(_PARTS, vectors.split([*_PARTS.values()], 1), strict=True))
    half = torch.cat((parts["turn"].new_zeros(1), parts["turn"][:, 0].cumsum(0)))  # angles of F + 1 frames
    back = R.yaw(-2 * half)
    velocity = torch.stack((parts["velocity"][:, 0], torch.zeros_like(half[1:]), parts["velocity"][:, 1]), -1)
    path = torch.cat((velocity.new_zeros(1, 3), R.rotate(back[1:], velocity).cumsum(0)))[:-1]
    joints = R.rotate(back[:-1, None], parts["positions"].unflatten(1, (-1, 3))) + path[:, None]
    root = path + torch.nn.functional.pad(parts["height"], (1, 1))
    joints = torch.cat((root[:, None], joints), 1)
    if last:
        after = joints[-1:] + R.rotate(back[-2:-1, None], parts["velocities"][-1:].unflatten(1, (-1, 3)))
        joints = torch.cat((joints, after))
    return joints


def facing(joints: Tensor) -> Tensor:
    """Rotations ``[F, 4]`` that turn the facing direction of joints ``[F, 22, 3]`` to +z; the first is not smoothed."""
    right, left = ([NAMES.index(f"{side}_{part}") for part in ("hip", "shoulder")] for side in ("right", "left"))
    hips, shoulders = (joints[:, right] - joints[:, left]).unbind(1)
    up, ahead = joints.new_tensor(_UP), joints.new_tensor(_FORWARD)
    first, others = (torch.linalg.cross(up.expand_as(across), R.normalize(across))
                     for across in (hips[:1] + shoulders[:1], shoulders - hips))
    others = through_numpy(lambda x: scipy.ndimage.gaussian_filter1d(x, SMOOTH, axis=0, mode="nearest"), others)
    forward = torch.cat((first, others[1:]))
    return R.between(forward, ahead.expand_as(forward))


def _bones(joints: Tensor, turn: Tensor) -> Tensor:
    """Rotations ``[F, 21, 4]`` of the bones, each relative to the one before it in its chain."""
    world = {}
    for j, parent in enumerate(PARENTS[1:], 1):
        rest = joints.new_tensor(_DIRECTIONS.get(NAMES[j], _DOWN)).expand(len(joints), 3)
        world[j] = R.between(rest, joints[:, j] - joints[:, parent])
    first = {j for j, name in enumerate(NAMES) if PARENTS[j] == 0 or name.endswith("collar")}
    before = [turn if j in first else world[PARENTS[j]] for j in world]
    return R.multiply(R.inverse(torch.stack(before, 1)), torch.stack([*world.values()], 1))


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
