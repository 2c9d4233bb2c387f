"""A clip as SMPL-H and SMPL-X poses in a NumPy file (.npz), like AMASS (Mahmood et al. 2019)."""

import io
from pathlib import Path

import numpy as np
import torch
from scipy.spatial.transform import Rotation

from toolkit.extra.characters.retargeting import retarget
from toolkit.extra.formats import interpretation, npz
from toolkit.io.files import write_whole
from toolkit.motion import Clip, Skeleton, rotations as R

WIDTH = 156  # of the poses: 22 joints of the body, 30 of the fingers, which stay straight
SHAPES = 16  # numbers of the body's shape, zeros: the mean


def write(clip: Clip, path: Path, *, character, **_) -> None:
    """Write ``poses [F, 156]``, ``trans [F, 3]``, ``betas``, ``gender`` and ``mocap_framerate``.

    The clip is put on a skeleton with legs as long as those of SMPL's mean body (`npz.MEAN`): path
    and speed are scaled with them.
    Metres and rotation vectors; z is up, as in AMASS. The body is there twice: AMASS's SMPL-X files
    name it ``root_orient [F, 3]`` and ``pose_body [F, 63]``, and the rate ``mocap_frame_rate``.
    ``trans`` is the pelvis less its place in SMPL's template, known to about a centimetre. That of
    SMPL-X's is 12 cm away along y, which is level here: a reader of SMPL-X moves the whole path.
    """
    offsets = npz.rest_pose(22, npz.MEAN).float()
    body = Skeleton(npz.BODY, npz.PARENTS[:22], offsets, roles=npz.ROLES)
    made = retarget(clip if character is None else character.fitted(clip), body).to("cpu")

    # From y up to z up: only the root's rotation and place change
    turns, upright = R.normalize(made.rotations.double()), R.inverse(interpretation.upright("z"))
    turns[:, 0] = R.multiply(upright, turns[:, 0])
    place = R.rotate(upright, made.root_positions.double()) - torch.tensor(npz.ORIGIN)

    # Rotation vectors: the axis times the angle, at most half a turn
    vectors = Rotation.from_quat(turns.flatten(0, 1).numpy(), scalar_first=True).as_rotvec()
    poses = np.zeros((len(made), WIDTH))
    poses[:, :66] = vectors.reshape(len(made), -1)
    file = io.BytesIO()
    np.savez(file, poses=poses, root_orient=poses[:, :3], pose_body=poses[:, 3:66],
             trans=place.numpy(), betas=np.zeros(SHAPES), gender="neutral",
             mocap_framerate=made.fps, mocap_frame_rate=made.fps)
    write_whole(path, file.getvalue())
