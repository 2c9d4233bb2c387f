"""NumPy files (.npz, .npy) with motion: SMPL, SMPL-H, SMPL-X and AMASS, HumanML3D, and Kimodo's SOMA skeleton."""

import io
import lzma
import math
import os
import struct
import tokenize
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path
from typing import BinaryIO

import numpy as np
import torch
from torch import Tensor

from toolkit.io import files, humanml3d
from toolkit.io.recording import Recording
from toolkit.motion import Skeleton, forward_kinematics
from toolkit.motion import rotations as R
from toolkit.motion.clip import SIDES

BODY = humanml3d.NAMES
SMPL = (*BODY, "left_hand", "right_hand")
PARENTS = (*humanml3d.PARENTS, 20, 21)
WIDTHS = (66, 72, 156, 165)  # of poses: SMPL-H's body, SMPL, SMPL-H and SMPL-X with hands
COUNTS = {22: 22, 24: 24, 52: 22, 55: 22}  # joints of HumanML3D, SMPL, SMPL-H and SMPL-X, and how many of them are read
RATES = ("mocap_framerate", "mocap_frame_rate", "fps", "frame_rate", "framerate")
JOINTS = ("posed_joints", "joints", "positions", "new_joints", "joints3d", "motion", "arr_0")
VECTORS = ("new_joint_vecs", "vectors", "motion", "arr_0")
USUAL = 30.0  # frames per second where the file says nothing
RIGID = 0.01  # metres, or part of the height, by which given or fitted joints may miss their place
LARGEST = 1e6  # metres and radians
FITTED = 1_400_000  # joint positions to which a skeleton is fitted: 17 minutes at 60 Hz
PACKED, ROOM = 3, 30_000_000  # arrays may have the file's size times the first, plus the second, bytes as float64
ROLES = {"hips": "pelvis"} | {f"{side}_{part}": f"{side}_{name}" for side in SIDES for part, name in {
    "shoulder": "shoulder", "elbow": "elbow", "hand": "wrist", "hip": "hip", "knee": "knee", "foot": "ankle",
    "toe": "foot"}.items()}
# A T-pose facing +z, left +x, as shares of the body's height. Lengths of thigh, shank, upper arm, forearm and foot, and the
# shoulders' width are Drillis and Contini's (1966, in Winter 2009, figure 4.1); the rest is ours. None are SMPL's.
HEIGHT = 1.70
_LEFT = {"hip": (0.05, -0.05, 0.0), "knee": (0.0, -0.245, 0.0), "ankle": (0.0, -0.246, 0.0), "foot": (0.0, -0.03, 0.08),
         "collar": (0.035, 0.06, 0.0), "shoulder": (0.07, 0.0, 0.0), "elbow": (0.186, 0.0, 0.0), "wrist": (0.146, 0.0, 0.0),
         "hand": (0.05, 0.0, 0.0)}
_MIDDLE = {"pelvis": (0.0, 0.0, 0.0), "spine1": (0.0, 0.06, 0.0), "spine2": (0.0, 0.08, 0.0), "spine3": (0.0, 0.04, 0.0),
           "neck": (0.0, 0.12, 0.0), "head": (0.0, 0.05, 0.02)}
ORIGIN = (0.0, -0.23, 0.0)  # metres from the origin of SMPL's template to its pelvis, roughly
SOMA = {  # parent by joint (github.com/nv-tlabs/kimodo, kimodo/skeleton/definitions.py)
    "Hips": "", "Spine1": "Hips", "Spine2": "Spine1", "Chest": "Spine2", "Neck1": "Chest", "Neck2": "Neck1", "Head": "Neck2",
    "Jaw": "Head", "LeftEye": "Head", "RightEye": "Head",
    **{side + name: parent if parent == "Chest" else side + parent for side in ("Left", "Right") for name, parent in {
        "Shoulder": "Chest", "Arm": "Shoulder", "ForeArm": "Arm", "Hand": "ForeArm", "HandThumbEnd": "Hand",
        "HandMiddleEnd": "Hand"}.items()},
    **{side + name: parent if parent == "Hips" else side + parent for side in ("Left", "Right") for name, parent in {
        "Leg": "Hips", "Shin": "Leg", "Foot": "Shin", "ToeBase": "Foot"}.items()},
}
SOMA_ROLES = {"hips": "Hips"} | {f"{side}_{part}": side.title() + name for side in SIDES for part, name in {
    "shoulder": "Arm", "elbow": "ForeArm", "hand": "Hand", "hip": "Leg", "knee": "Shin", "foot": "Foot",
    "toe": "ToeBase"}.items()}  # LeftLeg is the hip here, not the knee as in other rigs
# what numpy raises for files that are not whole
_DAMAGED = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, struct.error, tokenize.TokenError, EOFError, KeyError,
            NotImplementedError, OverflowError, RuntimeError, SyntaxError, TypeError, ValueError)


@np.errstate(invalid="ignore", over="ignore")
def read(path: str | os.PathLike) -> Recording:
    """Read a NumPy file.

    What it holds is found from the names and shapes of its arrays:

    - ``poses [F, 66, 72, 156 or 165]`` and ``trans [F, 3]``, or ``root_orient``, ``pose_body`` (SMPL and AMASS;
      ``global_orient``, ``body_pose``, ``transl`` as well). Angles become the rotations of SMPL's 22 or 24 body joints;
      fingers and face are left out. Bone lengths come from the file if it has ``joints [F, 22 or more, 3]``. SMPL's own are
      part of a licensed model that we do not have: then the lengths are those of an average person, and a doubt says so.
    - ``posed_joints [F, J, 3]`` and ``global_rot_mats [F, J, 3, 3]``, J = 22 (SMPL) or 30 (SOMA), as Kimodo writes them.
    - ``[F, 22, 24, 52 or 55, 3]``, joint positions in SMPL's order (HumanML3D has the first 22), or ``[F, 263]``, its
      numbers (`toolkit.io.humanml3d`). A rigid skeleton is fitted to the positions.

    Raises
    ------
    ValueError
        If the file holds nothing of this kind, is damaged, holds Python objects (which we do not run), or numbers that are
        not finite.
    """
    with files.named(path):
        try:
            arrays = _arrays(Path(path))
        except _DAMAGED as error:
            said = " ".join(str(error).split())[:100]
            said = said if said.isprintable() and said else type(error).__name__
            raise ValueError(f"not a whole NumPy file ({said})") from error
        return _recording(arrays)


def _recording(arrays: Mapping[str, np.ndarray]) -> Recording:
    poses = _poses(arrays)
    if poses is not None:
        return _smpl(arrays, poses)
    shapes = {name: a.shape for name, a in arrays.items()}
    if "global_rot_mats" in shapes and "posed_joints" in shapes:
        return _kimodo(arrays)
    for name in VECTORS:
        if shapes.get(name, ())[1:] == (humanml3d.WIDTH,):
            return _fitted(humanml3d.to_joints(_tensor(arrays, name)), "HumanML3D", humanml3d.FPS, 1.0, "y")
    for name in JOINTS:
        if (shape := shapes.get(name, ()))[2:] == (3,) and shape[1] in COUNTS:
            rate = _rate(arrays)
            doubts = () if rate else (f"the file has no frame rate; {humanml3d.FPS:g} Hz was assumed, as in HumanML3D",)
            joints = _tensor(arrays, name)[:, : COUNTS[shape[1]]]
            return _fitted(joints, "joint positions", rate or humanml3d.FPS, None, None, doubts)
    held = ", ".join(f"{name} {list(shape)}" for name, shape in list(shapes.items())[:6])
    raise ValueError("no motion in it; expected poses and trans (SMPL, AMASS), joints [F, 22, 3], or HumanML3D's [F, 263]; "
                     f"it has {held if held.isprintable() and held else 'none of these'}; np.savez(path, poses=…, trans=…) "
                     "writes arrays under these names")


def _poses(arrays: Mapping[str, np.ndarray]) -> Tensor | None:
    """Axis-angle vectors ``[F, J, 3]`` of SMPL's joints; None if there are none."""
    if "poses" in arrays and arrays["poses"].ndim > 1:
        return _vectors(_tensor(arrays, "poses"), "poses", WIDTHS)
    for root, body in (("root_orient", "pose_body"), ("global_orient", "body_pose")):
        if root in arrays and body in arrays:
            first, rest = _tensor(arrays, root), _tensor(arrays, body)
            parts = _vectors(first, root, (3,)), _vectors(rest, body, (63, 69))
            if len(parts[0]) != len(parts[1]):
                raise ValueError(f"{root} and {body} differ in their frames: {len(first)} and {len(rest)}")
            return torch.cat(parts, 1)
    return None


def _vectors(values: Tensor, name: str, widths: tuple[int, ...]) -> Tensor:
    flat = values.flatten(1) if values.dim() > 1 else values[None]
    if values.dim() < 2 or flat.shape[1] not in widths or not len(flat):
        raise ValueError(f"{name} should be rotation vectors [F, {' or '.join(map(str, widths))}], got {list(values.shape)}")
    return flat.unflatten(1, (-1, 3))


def _smpl(arrays: Mapping[str, np.ndarray], poses: Tensor) -> Recording:
    count = 24 if poses.shape[1] == 24 else 22
    angle = poses[:, :count].norm(dim=-1)
    turns = R.from_axis_angle(poses[:, :count] / angle.clamp_min(1e-12)[..., None], angle)
    frames, offsets, doubts = len(turns), _rest(count), []
    if float(angle.max()) > 4 * math.pi:
        doubts.append(f"a joint turns by {float(angle.max()):.3g} radians: if the file has degrees, convert them")
    given = next((_tensor(arrays, name) for name in ("joints", "Jtr", "posed_joints") if name in arrays
                  and arrays[name].ndim == 3 and arrays[name].shape[0] == frames and arrays[name].shape[1] >= count
                  and arrays[name].shape[2] == 3), None)
    place = next((_tensor(arrays, name).flatten(1) for name in ("trans", "transl", "translation") if name in arrays
                  and arrays[name].ndim > 1), None)
    if place is not None and place.shape != (frames, 3):
        raise ValueError(f"the root's positions should be [{frames}, 3], got {list(place.shape)}")
    if given is not None:
        turned = forward_kinematics(Skeleton(SMPL[:count], PARENTS[:count], offsets), turns, given[:, 0])[0]
        offsets, error = _offsets(PARENTS[:count], turned, given[:, :count])
        if error > RIGID:
            raise ValueError(f"its joints and its poses disagree by up to {error:.3g} m")
        place = given[:, 0]
    else:
        origin = torch.tensor(ORIGIN, dtype=torch.float64)
        if place is None:
            doubts.append("the file has no positions of the root; it was kept in its place")
        place = (torch.zeros(frames, 3, dtype=torch.float64) if place is None else place) + origin
        doubts.append("bone lengths are those of an average person: SMPL's own come with its licensed model")
    rate = _rate(arrays)
    if not rate:
        doubts.append(f"the file has no frame rate; {USUAL:g} Hz was assumed")
    return Recording("SMPL poses", SMPL[:count], PARENTS[:count],
                     offsets, R.unroll(turns.float()), place, rate or USUAL, unit=1.0, roles=dict(ROLES),
                     doubts=tuple(doubts))


def _rest(count: int) -> Tensor:
    """Offsets ``[count, 3]`` of an average person, metres."""
    rows = []
    for name in SMPL[:count]:
        side, _, part = name.partition("_")
        x, y, z = _LEFT[part] if part else _MIDDLE[name]
        rows.append((-x if side == "right" else x, y, z))
    return HEIGHT * torch.tensor(rows, dtype=torch.float64)


def _kimodo(arrays: Mapping[str, np.ndarray]) -> Recording:
    joints, matrices = _tensor(arrays, "posed_joints"), _tensor(arrays, "global_rot_mats")
    frames, count = (*joints.shape, 0, 0)[:2]
    known = {len(SOMA): (tuple(SOMA), tuple(list(SOMA).index(p) if p else -1 for p in SOMA.values())),
             len(BODY): (BODY, humanml3d.PARENTS)}
    if not frames or joints.shape[2:] != (3,) or matrices.shape != (frames, count, 3, 3) or count not in known:
        raise ValueError("posed_joints [F, J, 3] and global_rot_mats [F, J, 3, 3] need J = "
                         f"{' or '.join(map(str, known))}; got {list(joints.shape)} and {list(matrices.shape)}")
    names, parents = known[count]
    product = matrices @ matrices.transpose(-1, -2)
    if float((product - torch.eye(3)).abs().max()) > 1e-2 or float(torch.linalg.det(matrices).min()) < 0:
        raise ValueError("global_rot_mats holds matrices that are no rotations")
    turned = R.from_matrix(matrices)
    offsets, error = _offsets(parents, turned, joints)
    if error > RIGID:
        raise ValueError(f"its joints and its rotations disagree by up to {error:.3g} m")
    above = R.inverse(turned[:, list(parents[1:])])
    local = torch.cat((turned[:, :1], R.multiply(above, turned[:, 1:])), 1)
    rate = _rate(arrays)
    return Recording(
        "Kimodo joints", names, parents, offsets, R.unroll(local.float()), joints[:, 0], rate or USUAL, unit=1.0, up="y",
        ends=tuple(name for name in names if name.endswith("End")), roles=dict(ROLES if names == BODY else SOMA_ROLES),
        doubts=() if rate else (f"the file has no frame rate; {USUAL:g} Hz was assumed, as Kimodo's",))


def _fitted(joints: Tensor, format_: str, fps: float, unit: float | None, up: str | None,
            doubts: tuple[str, ...] = ()) -> Recording:
    if not len(joints):
        raise ValueError("no frame in it")
    count = joints.shape[1]
    if len(joints) * count > FITTED:
        raise ValueError(f"{len(joints)} frames of {count} joints are more than {FITTED} positions; cut the file")
    offsets, rotations, error = humanml3d.fit(PARENTS[:count], _rest(count), joints)
    height = float((joints.amax(1) - joints.amin(1)).max())
    if error > RIGID * height:
        doubts += ("its bones change their lengths: joints of the rigid skeleton miss the recorded ones by up to "
                   f"{100 * error / height:.2g} % of the height",)
    return Recording(format_, SMPL[:count], PARENTS[:count], offsets, R.unroll(rotations.float()), joints[:, 0], fps,
                     unit=unit, up=up, roles=dict(ROLES), doubts=doubts)


def _offsets(parents: tuple[int, ...], world: Tensor, joints: Tensor) -> tuple[Tensor, float]:
    """Mean offsets ``[J, 3]`` of joints in their parents' frames, and the largest distance from them, metres."""
    above = list(parents[1:])
    bones = R.rotate(R.inverse(world[:, above]), joints[:, 1:] - joints[:, above])
    mean = bones.mean(0)
    return torch.cat((mean.new_zeros(1, 3), mean)), float((bones - mean).norm(dim=-1).max())


def _rate(arrays: Mapping[str, np.ndarray]) -> float | None:
    """Frames per second if the file says so."""
    for name in RATES:
        if name in arrays and arrays[name].size == 1:
            rate = float(arrays[name].reshape(()))
            if not (math.isfinite(rate) and 0 < rate < 1e6):
                raise ValueError(f"{name} should be frames per second, got {rate:g}")
            return rate
    return None


def _tensor(arrays: Mapping[str, np.ndarray], name: str) -> Tensor:
    """An array as float64; ValueError if a number is not finite or too large."""
    values = arrays[name].astype(np.float64)
    if not (np.abs(values) < LARGEST).all():  # false with NaN
        raise ValueError(f"{name} has numbers that are not finite, or beyond {LARGEST:g}")
    return torch.from_numpy(values)


def _arrays(path: Path) -> dict[str, np.ndarray]:
    """Arrays of numbers by name; none is unpacked that is larger than the file allows, and no Python object is made."""
    data = files.read(path)
    size, arrays, room = len(data), {}, PACKED * len(data) + ROOM
    if data[:2] != b"PK":
        return {"arr_0": _array(io.BytesIO(data), size, room)}
    with zipfile.ZipFile(io.BytesIO(data)) as packed:
        for member in packed.infolist():
            name = member.filename.removesuffix(".npy")
            if name not in _WANTED or name in arrays:
                continue
            if member.file_size > room:
                raise ValueError(f"array {name} unpacks to {member.file_size} bytes, from a file of {size}")
            with packed.open(member) as stream:
                arrays[name] = _array(stream, member.file_size, room)
            room -= 8 * arrays[name].size
    return arrays


_WANTED = {"poses", "trans", "transl", "translation", "root_orient", "pose_body", "global_orient", "body_pose", "Jtr",
           "global_rot_mats", *RATES, *JOINTS, *VECTORS}


def _array(stream: BinaryIO, size: int, room: int) -> np.ndarray:
    """The array of a .npy stream of ``size`` bytes; ValueError if it would have more than ``room`` bytes as float64."""
    version = np.lib.format.read_magic(stream)
    if version == (1, 0):
        shape, fortran, dtype = np.lib.format.read_array_header_1_0(stream)
    elif version == (2, 0):
        shape, fortran, dtype = np.lib.format.read_array_header_2_0(stream)
    else:
        raise ValueError(f"version {version} of the format holds no numbers")
    if dtype.hasobject:
        raise ValueError("it holds Python objects, which could run code; save plain arrays with numpy.savez")
    if dtype.kind not in "fiub":
        return np.zeros(0)  # names and the like
    count = math.prod(shape)
    wanted = count * dtype.itemsize
    data = stream.read(wanted) if wanted <= size and 8 * count <= room else b""
    if len(data) < wanted or 8 * count > room:
        raise ValueError(f"an array {list(shape)[:4]} of {wanted} bytes does not fit into the file's {size} bytes")
    values = np.frombuffer(data, dtype, count)
    return values.reshape(shape[::-1]).T if fortran else values.reshape(shape)
