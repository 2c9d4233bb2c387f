"""NumPy files (.npz, .npy) with motion: SMPL and AMASS poses, HumanML3D, joint positions."""

import io
import math
import os
from collections.abc import Mapping, Sequence

import numpy as np
import torch
from torch import Tensor

from toolkit.extra.formats import humanml3d
from toolkit.io import files
from toolkit.io.recording import Recording
from toolkit.motion import Skeleton, forward_kinematics, rotations as R
from toolkit.motion.roles import SIDES

BODY = humanml3d.NAMES
SMPL = (*BODY, "left_hand", "right_hand")
PARENTS = (*humanml3d.PARENTS, 20, 21)
PARTS = {"shoulder": "shoulder", "elbow": "elbow", "hand": "wrist", "hip": "hip", "knee": "knee",
         "foot": "ankle", "toe": "foot"}
ROLES = {"hips": "pelvis"} | {
    f"{side}_{part}": f"{side}_{name}" for side in SIDES for part, name in PARTS.items()}

# A T-pose facing +z, left +x, as shares of the body's height. Lengths of thigh, shank, upper arm,
# forearm and foot, and the shoulders' width are Drillis and Contini's (1966, in Winter 2009, figure
# 4.1); the rest is ours. None are SMPL's.
# SMPL's mean body (betas 0) has shorter legs, of 0.77 m from hip to ankle.
HEIGHT, MEAN = 1.70, 1.57
_REST = {"hip": (0.05, -0.05, 0.0), "knee": (0.0, -0.245, 0.0), "ankle": (0.0, -0.246, 0.0),
         "foot": (0.0, -0.03, 0.08), "collar": (0.035, 0.06, 0.0), "shoulder": (0.07, 0.0, 0.0),
         "elbow": (0.186, 0.0, 0.0), "wrist": (0.146, 0.0, 0.0), "hand": (0.05, 0.0, 0.0),
         "pelvis": (0.0, 0.0, 0.0), "spine1": (0.0, 0.06, 0.0), "spine2": (0.0, 0.08, 0.0),
         "spine3": (0.0, 0.04, 0.0), "neck": (0.0, 0.12, 0.0), "head": (0.0, 0.05, 0.02)}
# Metres from the origin of the template to its pelvis, roughly: of SMPL and SMPL-H, of SMPL-X
ORIGIN, ORIGIN_X = (0.0, -0.23, 0.02), (0.0, -0.35, 0.01)

# Names of arrays, the first that is there counts
RATES = ("mocap_framerate", "mocap_frame_rate", "fps", "frame_rate", "framerate")
JOINTS = ("posed_joints", "joints", "positions", "new_joints", "joints3d", "motion", "arr_0")
VECTORS = ("new_joint_vecs", "vectors", "motion", "arr_0")
PLACES = ("trans", "transl", "translation")
NAMED = "parent_indices"  # in a file whose joints have names of their own
KIMODO = "global_rot_mats"  # in the files of Kimodo, which do not name their rate
WANTED = {"poses", "root_orient", "pose_body", "global_orient", "body_pose", "Jtr", "betas", NAMED,
          KIMODO, *RATES, *JOINTS, *VECTORS, *PLACES}
WIDTHS = (66, 72, 156, 165)  # of poses: SMPL-H's body, SMPL, SMPL-H and SMPL-X with hands
COUNTS = {22: 22, 24: 24, 52: 22, 55: 22}  # joints of HumanML3D, SMPL, -H, -X: how many are read

USUAL = 30.0  # frames per second where the file says nothing
RIGID = 0.01  # metres, or share of the height, by which given or fitted joints may miss their place
LARGEST = 1e6  # metres and radians
FITTED = 1_400_000  # joint positions to which a skeleton is fitted: 17 minutes at 60 Hz
PACKED, ROOM = 3, 30_000_000  # arrays may have PACKED times the file's size + ROOM bytes as float64


@np.errstate(invalid="ignore", over="ignore")
def read(path: str | os.PathLike) -> Recording:
    """Read a NumPy file.

    What it holds is found from the names and shapes of its arrays:

    - ``poses [F, 66, 72, 156 or 165]`` and ``trans [F, 3]``, or ``root_orient``, ``pose_body``
      (SMPL and AMASS; ``global_orient``, ``body_pose``, ``transl`` as well). Angles become the
      rotations of SMPL's 22 or 24 body joints; fingers and face are left out. Bone lengths come
      from the file if it has ``joints [F, 22 or more, 3]``. SMPL's own are part of a licensed model
      that we do not have: then they are those of an average person, and a doubt says so.
    - ``[F, 22, 24, 52 or 55, 3]``, joint positions in SMPL's order (HumanML3D has the first 22), or
      ``[F, 263]``, its numbers (`toolkit.extra.formats.humanml3d`). A rigid skeleton is fitted.

    Raises
    ------
    ValueError
        If the file holds nothing of this kind, is damaged, holds Python objects (which we do not
        run), or numbers that are not finite.
    """
    with files.named(path):
        data = files.read(path)
        try:
            arrays = _arrays(data)
        except Exception as error:  # numpy, zipfile and zlib raise a dozen kinds for damaged files
            said = " ".join(str(error).split())[:100]
            if "allow_pickle" in said:
                said = "it holds Python objects, which could run code; save plain arrays with "\
                       "numpy.savez"
            said = said if said.isprintable() and said else type(error).__name__
            raise ValueError(f"not a whole NumPy file ({said})") from error

        if NAMED in arrays:
            raise ValueError("its joints have names of their own, as AI4AnimationPy writes them; "
                             "its Motion.SaveToGLB writes a .glb")
        poses = _poses(arrays)
        if poses is not None:
            return _smpl(arrays, poses)
        for name in VECTORS:
            if name in arrays and arrays[name].shape[1:] == (humanml3d.WIDTH,):
                joints = humanml3d.to_joints(_tensor(arrays, name))
                return _fitted(joints, "HumanML3D", humanml3d.FPS, [], unit=1.0, up="y")
        for name in JOINTS:
            shape = arrays[name].shape if name in arrays else ()
            if len(shape) == 3 and shape[1] in COUNTS and shape[2] == 3:
                doubts: list[str] = []
                usual = (30.0, "Kimodo") if KIMODO in arrays else (humanml3d.FPS, "HumanML3D")
                rate = _rate(arrays, *usual, doubts)
                joints = _tensor(arrays, name)[:, : COUNTS[shape[1]]]
                return _fitted(joints, "joint positions", rate, doubts)
        held = ", ".join(f"{name} {list(array.shape)}" for name, array in arrays.items())
        raise ValueError(
            "no motion in it; expected poses and trans (SMPL, AMASS), or joints [F, 22, 3]; it has "
            f"{held[:200] or 'none of these'}; np.savez(path, poses=…, trans=…) writes arrays "
            "under these names; kimodo_convert makes BVH of Kimodo's files")


def _poses(arrays: Mapping[str, np.ndarray]) -> Tensor | None:
    """Axis-angle vectors ``[F, J, 3]`` of SMPL's joints; None if there are none."""
    if "poses" in arrays and arrays["poses"].ndim > 1:
        return _vectors(arrays, "poses", WIDTHS)
    for root, body in (("root_orient", "pose_body"), ("global_orient", "body_pose")):
        if {root, body} <= arrays.keys():
            first, rest = _vectors(arrays, root, (3,)), _vectors(arrays, body, (63, 69))
            if len(first) != len(rest):
                raise ValueError(f"{root} and {body} differ in their frames: "
                                 f"{len(first)} and {len(rest)}")
            return torch.cat((first, rest), 1)
    return None


def _vectors(arrays: Mapping[str, np.ndarray], name: str, widths: Sequence[int]) -> Tensor:
    values = _tensor(arrays, name)
    width = values[0].numel() if values.dim() > 1 and len(values) else 0
    if width not in widths:
        raise ValueError(f"{name} should be rotation vectors [F, {' or '.join(map(str, widths))}], "
                         f"got {list(values.shape)}")
    return values.reshape(len(values), -1, 3)


def _smpl(arrays: Mapping[str, np.ndarray], poses: Tensor) -> Recording:
    """SMPL's joints with rotations; bone lengths are the file's or those of an average person."""
    count = 24 if poses.shape[1] == 24 else 22
    angle = poses[:, :count].norm(dim=-1)
    turns = R.from_axis_angle(poses[:, :count] / angle.clamp_min(1e-12)[..., None], angle)
    mean = "betas" in arrays and not arrays["betas"].any()
    frames, doubts = len(turns), []
    offsets = rest_pose(count, MEAN if mean else HEIGHT)
    if float(angle.max()) > 4 * math.pi:
        doubts.append(f"a joint turns by {float(angle.max()):.3g} radians: "
                      "if the file has degrees, convert them")
    place = torch.zeros(frames, 3, dtype=torch.float64)
    known = [name for name in PLACES if name in arrays and arrays[name].ndim > 1]
    if known:
        place = _tensor(arrays, known[0]).flatten(1)
        if place.shape != (frames, 3):
            raise ValueError(f"the root's positions should be [{frames}, 3], "
                             f"got {list(place.shape)}")

    shapes = {name: arrays[name].shape for name in ("joints", "Jtr", "posed_joints")
              if name in arrays}
    fit = [name for name, shape in shapes.items() if len(shape) == 3 and shape[0] == frames
           and shape[1] >= count and shape[2] == 3]
    if fit:
        given = _tensor(arrays, fit[0])
        skeleton = Skeleton(SMPL[:count], PARENTS[:count], offsets)
        place, above = given[:, 0], list(PARENTS[1:count])
        world = forward_kinematics(skeleton, turns, place)[0]
        bones = R.rotate(R.inverse(world[:, above]), given[:, 1:count] - given[:, above])
        offsets[1:] = bones.mean(0)
        if (error := float((bones - offsets[1:]).norm(dim=-1).max())) > RIGID:
            raise ValueError(f"its joints and its rotations disagree by up to {error:.3g} m")
    else:
        if not known:
            doubts.append("the file has no positions of the root; it was kept in its place")
        # SMPL-X has 55 joints, and 21 of a body that stands apart from the root
        x = poses.shape[1] == 55 or (poses.shape[1] == 22 and "poses" not in arrays)
        place = place + torch.tensor(ORIGIN_X if x else ORIGIN, dtype=torch.float64)
        doubts.append("bone lengths are those of an average person: "
                      "SMPL's own come with its licensed model")
    rate = _rate(arrays, USUAL, "", doubts)
    return Recording("SMPL poses", SMPL[:count], PARENTS[:count], offsets, R.unroll(turns.float()),
                     place, rate, unit=1.0, roles=dict(ROLES), doubts=tuple(doubts))


def rest_pose(count: int, height: float = HEIGHT) -> Tensor:
    """Offsets ``[count, 3]`` of an average person of that height, metres."""
    rows = []
    for name in SMPL[:count]:
        side, _, part = name.rpartition("_")
        x, y, z = _REST[part]
        rows.append((-x if side == "right" else x, y, z))
    return height * torch.tensor(rows, dtype=torch.float64)


def _fitted(joints: Tensor, format_: str, fps: float, doubts: list[str], unit: float | None = None,
            up: str | None = None) -> Recording:
    """A rigid skeleton fitted to positions ``[F, J, 3]``."""
    frames, count = joints.shape[:2]
    if not frames:
        raise ValueError("no frame in it")
    if frames * count > FITTED:
        raise ValueError(f"{frames} frames of {count} joints are more than {FITTED} positions; "
                         "cut the file")
    offsets, rotations, error = humanml3d.fit(PARENTS[:count], rest_pose(count), joints)
    height = float((joints.amax(1) - joints.amin(1)).max())
    if error > RIGID * height:
        doubts.append("its bones change their lengths: joints of the rigid skeleton miss the "
                      f"recorded ones by up to {100 * error / height:.2g} % of the height")
    return Recording(format_, SMPL[:count], PARENTS[:count], offsets, R.unroll(rotations.float()),
                     joints[:, 0], fps, unit=unit, up=up, roles=dict(ROLES), doubts=tuple(doubts))


def _rate(arrays: Mapping[str, np.ndarray], usual: float, whose: str, doubts: list[str]) -> float:
    """Frames per second; the usual ones, with a doubt, if the file does not say."""
    for name in RATES:
        if name in arrays and arrays[name].size == 1:
            rate = float(arrays[name].reshape(()))
            if not 0 < rate < LARGEST:
                raise ValueError(f"{name} should be frames per second, got {rate:g}")
            return rate
    like = f", as in {whose}" if whose else ""
    doubts.append(f"the file has no frame rate; {usual:g} Hz was assumed{like}")
    return usual


def _tensor(arrays: Mapping[str, np.ndarray], name: str) -> Tensor:
    """An array as float64; ValueError if a number is not finite or too large."""
    values = arrays[name].astype(np.float64)
    if not (np.abs(values) < LARGEST).all():  # false with NaN
        raise ValueError(f"{name} has numbers that are not finite, or beyond {LARGEST:g}")
    return torch.from_numpy(values)


def _arrays(data: bytes) -> dict[str, np.ndarray]:
    """The arrays that are `WANTED`, by name; no Python object is made. Texts are left out.

    ValueError if they would take much more memory than the file.
    """
    room = PACKED * len(data) + ROOM
    loaded = np.load(io.BytesIO(data), allow_pickle=False)
    if isinstance(loaded, np.ndarray):
        arrays = {"arr_0": loaded}
    else:
        packed = {info.filename.removesuffix(".npy"): info for info in loaded.zip.infolist()}
        names = [name for name in loaded.files if name in WANTED]
        if (size := sum(packed[name].file_size for name in names)) > room:
            raise ValueError(f"{', '.join(names)} unpack to {size} bytes, from a file of "
                             f"{len(data)}")
        arrays = {name: loaded[name] for name in names}
    arrays = {name: array for name, array in arrays.items() if array.dtype.kind in "fiub"}
    if (size := 8 * sum(array.size for array in arrays.values())) > room:
        raise ValueError(f"its arrays take {size} bytes as numbers of 64 bits, from a file of "
                         f"{len(data)}")
    return arrays
