"""glTF 2.0 files (.glb, .gltf, .vrm, .vrma): the animation of a skeleton, resampled to one rate."""

import base64
import binascii
import json
import math
import os
import struct
from pathlib import Path
from urllib.parse import unquote

import numpy as np
import torch
from torch import Tensor

from toolkit.io.nodes import LIMIT, MOST, Node, frame_rate, printable, record, sample_times
from toolkit.io.recording import Recording
from toolkit.motion import rotations as R
from toolkit.motion.clip import SIDES
from toolkit.motion.tensors import few

COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}  # glTF's types to numpy's
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
PATHS = {"translation": 3, "rotation": 4, "scale": 3}
BONES = {"shoulder": "UpperArm", "elbow": "LowerArm", "hand": "Hand", "hip": "UpperLeg", "knee": "LowerLeg", "foot": "Foot",
         "toe": "Toes"}  # our roles to VRM's bones, without the side
VALUES = 2_000_000  # values of a JSON text, which takes up to 70 bytes for each
USUAL = 30.0  # frames per second where the keys say nothing


class GLTFError(ValueError):
    """A file that cannot be read as glTF; the message names the file."""


@np.errstate(invalid="ignore", over="ignore")
def read(path: str | os.PathLike, animation: str | int | None = None) -> Recording:
    """Read the motion of a glTF file.

    All channels of one animation are sampled at the rate of their keys, by the file's interpolation (LINEAR, STEP or
    CUBICSPLINE). If the keys are not at equal distances, the rate is the first usual one that meets all of them, otherwise
    30 Hz. A file without animation gives its rest pose as one frame. VRM and VRMA files say which joint has which role.
    Lengths are metres, and y is up: glTF demands both.

    Parameters
    ----------
    path : the file; buffers beside it are read from its own folder only
    animation : name or number of the animation; by default the first

    Raises
    ------
    GLTFError
        If the file is not glTF 2.0 or damaged, holds no skeleton or not a rigid one, or needs an extension to be read.
    """
    path = Path(path)
    try:
        return _File(path).recording(animation)
    except OSError as error:
        raise GLTFError(f"{path}: cannot be read ({error.strerror})") from error
    except ValueError as error:
        raise GLTFError(f"{path}: {error}") from error


class _File:
    """The document and its buffers."""

    def __init__(self, path: Path):
        self.path = path
        data = path.read_bytes()
        self.size, text, self.binary = len(data), data, None
        if data[:4] == b"glTF":
            text, self.binary = _chunks(data)
        if sum(text.count(sign) for sign in (b",", b"[", b"{")) > VALUES:
            raise ValueError(f"its JSON text has more than {VALUES} values")
        try:
            self.document = json.loads(text)
        except (ValueError, RecursionError) as error:
            raise ValueError("it is neither a GLB file nor JSON text") from error
        if not isinstance(self.document, dict) or not str(_dict(self.document, "asset").get("version", "")).startswith("2."):
            raise ValueError("expected glTF version 2; older files can be converted in Blender")
        self.buffers, self.lists, self.doubts = {}, {}, []

    def _list(self, key: str) -> list[dict]:
        """A list of the document, checked once."""
        if key not in self.lists:
            self.lists[key] = _dicts(self.document, key)
        return self.lists[key]

    def recording(self, wanted: str | int | None) -> Recording:
        """The chosen animation on the largest skeleton."""
        described = self._list("nodes")
        if len(described) > LIMIT:
            raise ValueError(f"more than {LIMIT} nodes")
        nodes = [Node(printable(node.get("name", "")), -1, *_pose(node), plain=not any(
            key in node for key in ("mesh", "camera", "extensions"))) for node in described]
        for j, node in enumerate(described):
            for child in _indices(node, "children", len(nodes)):
                if nodes[child].parent >= 0:
                    raise ValueError(f"node {child} has two parents")
                nodes[child].parent = j
        for skin in self._list("skins"):
            for j in _indices(skin, "joints", len(nodes)):
                nodes[j].joint = nodes[j].skinned = True
        roles = self._roles(nodes)
        frames, fps = self._animate(nodes, wanted)
        if any(node.joint for node in nodes) and all(len(n.rotation) == len(n.translation) == 1 for n in nodes):
            self.doubts.append("no joint is animated; the pose of the nodes is given as it is")
        return record(nodes, frames, fps, format_="glTF", unit=1.0, up="y", roles=roles, doubts=self.doubts)

    def _roles(self, nodes: list[Node]) -> dict[str, int] | None:
        """Nodes by role where a VRM extension names the bones; these nodes are joints."""
        extensions = _dict(self.document, "extensions")
        bones = {}
        for key in ("VRMC_vrm", "VRMC_vrm_animation", "VRM"):
            humanoid = _dict(_dict(extensions, key), "humanoid")
            if isinstance(humanoid.get("humanBones"), dict):
                listed = ((bone, entry) for bone, entry in humanoid["humanBones"].items() if isinstance(entry, dict))
            else:
                listed = ((str(entry.get("bone")), entry) for entry in _dicts(humanoid, "humanBones"))
            bones |= {bone: _index(entry, "node", len(nodes)) for bone, entry in listed}
        for j in bones.values():
            nodes[j].joint = True
        wanted = {"hips": "hips"} | {f"{side}_{part}": f"{side}{bone}" for side in SIDES for part, bone in BONES.items()}
        return {role: bones[bone] for role, bone in wanted.items() if bone in bones} if bones else None

    def _animate(self, nodes: list[Node], wanted: str | int | None) -> tuple[int, float]:
        """Sample one animation into the nodes' tracks: the number of frames, and their rate."""
        channels = self._channels(wanted, len(nodes))
        if not channels:
            return 1, USUAL
        times = [times for *_, times, _, _ in channels]
        rate = frame_rate(times, USUAL)
        at = sample_times(times, rate, sum(node.joint for node in nodes) + len({j for j, *_ in channels}), self.size)
        for j, what, keys, accessor, kind in channels:
            width = PATHS[what]
            values = self._array(accessor, width)
            rows = len(keys) * (3 if kind == "CUBICSPLINE" else 1)
            if len(values) != rows:
                raise ValueError(f"the {what} of node {j} has {len(values)} values for {len(keys)} keys")
            track = _sample(keys, values.reshape(len(keys), -1, width), at, kind, what == "rotation")
            if np.ptp(track, axis=0).max() < 1e-12:
                track = track[:1]
            setattr(nodes[j], what, torch.from_numpy(track[:, [3, 0, 1, 2]]) if what == "rotation" else track)
            nodes[j].joint = nodes[j].joint or (len(track) > 1 and what != "scale")
        return len(at), rate

    def _channels(self, wanted: str | int | None, count: int) -> list[tuple]:
        """Node, path, key times, accessor of the values and interpolation of each channel."""
        animations = self._list("animations")
        names = [printable(a.get("name", i)) for i, a in enumerate(animations)]
        if wanted is None and len(animations) > 1:
            self.doubts.append(f"the file holds {len(animations)} animations ({few(names)}); the first was read")
        if wanted is not None and wanted not in names and wanted not in range(len(names)):
            raise ValueError(f"no animation {wanted!r}; it has {few(names) or 'none'}")
        if not animations:
            return []
        animation = animations[names.index(wanted) if wanted in names else wanted or 0]
        samplers, channels = _dicts(animation, "samplers"), []
        for channel in _dicts(animation, "channels"):
            target = _dict(channel, "target")
            if _hashable(target.get("path")) not in PATHS or "node" not in target:
                continue  # weights of blend shapes, or a target of an extension
            sampler = samplers[_index(channel, "sampler", len(samplers))]
            kind, times = _hashable(sampler.get("interpolation", "LINEAR")), self._array(sampler.get("input"), 1)[:, 0]
            if kind not in ("LINEAR", "STEP", "CUBICSPLINE"):
                raise ValueError(f"unknown interpolation {str(kind)[:20]!r}")
            if not len(times) or not (np.diff(times) > 0).all():
                raise ValueError("the key times of an animation do not increase")
            channels.append((_index(target, "node", count), target["path"], times, sampler.get("output"), kind))
        return channels

    def _array(self, index: object, width: int) -> np.ndarray:
        """The values ``[N, width]`` of an accessor, float64."""
        accessors = self._list("accessors")
        accessor = accessors[_index({"accessor": index}, "accessor", len(accessors))]
        kind, count = COMPONENTS.get(_hashable(accessor.get("componentType"))), _whole(accessor, "count")
        if kind is None or WIDTHS.get(_hashable(accessor.get("type"))) != width:
            raise ValueError(f"accessor {index} has the wrong type for an animation")
        if "bufferView" in accessor:
            values = self._view(accessor, kind, count, width)
        elif count * width <= max(MOST, self.size):
            values = np.zeros((count, width), kind)
        else:
            raise ValueError(f"accessor {index} has {count} values and no data")
        if sparse := _dict(accessor, "sparse"):
            few_, values = _whole(sparse, "count"), values.copy()
            at, new = _dict(sparse, "indices"), _dict(sparse, "values")
            rows = self._view(at, COMPONENTS.get(_hashable(at.get("componentType")), ""), few_, 1)[:, 0]
            if len(rows) and not (rows.dtype.kind == "u" and int(rows.max()) < count):
                raise ValueError(f"accessor {index} has sparse values beyond its end")
            values[rows] = self._view(new, kind, few_, width)
        made = values.astype(np.float64)
        if accessor.get("normalized") and values.dtype.kind in "iu":
            made = np.maximum(made / np.iinfo(values.dtype).max, -1.0)
        if not np.isfinite(made).all() or np.abs(made).max(initial=0.0) > 1e30:
            raise ValueError(f"accessor {index} has numbers that are not finite")
        return made

    def _view(self, of: dict, kind: str, count: int, width: int) -> np.ndarray:
        """Values ``[count, width]`` where they lie in a buffer."""
        views = self._list("bufferViews")
        view = views[_index(of, "bufferView", len(views))]
        if "EXT_meshopt_compression" in _dict(view, "extensions"):
            raise ValueError("its animation is compressed by EXT_meshopt_compression; unpack it with gltf-transform")
        element = np.dtype(kind).itemsize * width if kind else 0
        stride = _whole(view, "byteStride", element) or element
        start, size, offset = (_whole(*x, 0) for x in ((view, "byteOffset"), (view, "byteLength"), (of, "byteOffset")))
        buffer = self._buffer(_index(view, "buffer", len(self._list("buffers"))))
        end = offset + (count - 1) * stride + element if count else 0
        if not element or stride < element or end > size or start + size > len(buffer):
            raise ValueError("an accessor reaches beyond its buffer")
        return np.ndarray((count, width), kind, buffer, start + offset if count else 0, (stride, np.dtype(kind).itemsize))

    def _buffer(self, index: int) -> memoryview | bytes:
        if index not in self.buffers:
            uri = self._list("buffers")[index].get("uri")
            if uri is None:
                self.buffers[index] = self.binary or b""
            elif not isinstance(uri, str):
                raise ValueError(f"buffer {index} has no address")
            elif uri.startswith("data:"):
                try:
                    self.buffers[index] = base64.b64decode(uri[uri.find(",") + 1 :], validate=True)
                except (binascii.Error, ValueError):
                    raise ValueError(f"buffer {index} is not base64 text") from None
            else:
                self.buffers[index] = self._beside(unquote(uri))
            self.size += len(self.buffers[index]) if uri else 0
        return self.buffers[index]

    def _beside(self, name: str) -> bytes:
        """A file in the folder of this one or below."""
        try:
            folder = self.path.parent.resolve()
            beside = (folder / name).resolve()
            if ":" in name or not beside.is_relative_to(folder) or not beside.is_file():
                raise ValueError(f"its buffer {printable(name)[:80]!r} is not beside it")
            return beside.read_bytes()
        except OSError as error:
            raise ValueError(f"its buffer {printable(name)[:80]!r} cannot be read ({error.strerror})") from error


def _chunks(data: bytes) -> tuple[bytes, memoryview | None]:
    """JSON text and binary chunk of a GLB file."""
    found, at = {}, 12
    if len(data) < 20:
        raise ValueError("the file ends before its JSON text")
    while at + 8 <= len(data):
        size, kind = struct.unpack_from("<I4s", data, at)
        if at + 8 + size > len(data):
            raise ValueError(f"the file is cut off: a chunk of {size} bytes begins at byte {at}")
        found.setdefault(kind, memoryview(data)[at + 8 : at + 8 + size])
        at += 8 + size
    if b"JSON" not in found:
        raise ValueError("the file has no JSON text")
    return bytes(found[b"JSON"]), found.get(b"BIN\0")


def _pose(node: dict) -> tuple[np.ndarray, Tensor, np.ndarray]:
    """Translation, rotation and scale of a node, one row each."""
    if "matrix" in node:
        matrix = _numbers(node, "matrix", 16).reshape(4, 4).T
        scale = np.linalg.norm(matrix[:3, :3], axis=0)
        if np.linalg.det(matrix[:3, :3]) < 0:
            scale[0] *= -1
        axes = torch.from_numpy(matrix[:3, :3] / np.where(scale == 0, 1.0, scale))
        return matrix[None, :3, 3], R.from_matrix(axes)[None], scale[None]
    turn = _numbers(node, "rotation", 4, (0.0, 0.0, 0.0, 1.0))[None]
    return (_numbers(node, "translation", 3, (0.0, 0.0, 0.0))[None], torch.from_numpy(_unit(turn)[:, [3, 0, 1, 2]]),
            _numbers(node, "scale", 3, (1.0, 1.0, 1.0))[None])


def _sample(keys: np.ndarray, values: np.ndarray, at: np.ndarray, kind: str, turn: bool) -> np.ndarray:
    """Values ``[F, C]`` at the times ``at`` [F] of ``values [K, 1 or 3, C]`` at the keys [K] (glTF 2.0, appendix C)."""
    own = values[:, values.shape[1] // 2]
    own = _unit(own) if turn else own
    if len(keys) == 1:
        return np.repeat(own, len(at), axis=0)
    at = np.clip(at, keys[0], keys[-1])
    i = np.clip(np.searchsorted(keys, at + 1e-6, "right") - 1, 0, len(keys) - 1)
    if kind == "STEP":
        return own[i]
    i = np.minimum(i, len(keys) - 2)
    span = keys[i + 1] - keys[i]
    t = np.clip((at - keys[i]) / span, 0.0, 1.0)[:, None]
    if kind == "LINEAR" and turn:
        return R.slerp(*(torch.from_numpy(own[k]) for k in (i, i + 1)), torch.from_numpy(t[:, 0])).numpy()
    if kind == "LINEAR":
        return own[i] + t * (own[i + 1] - own[i])
    out, into = values[i, 2] * span[:, None], values[i + 1, 0] * span[:, None]
    made = ((2 * t**3 - 3 * t**2 + 1) * own[i] + (t**3 - 2 * t**2 + t) * out + (3 * t**2 - 2 * t**3) * own[i + 1]
            + (t**3 - t**2) * into)
    return _unit(made) if turn else made


def _unit(turns: np.ndarray) -> np.ndarray:
    """Quaternions of length 1."""
    length = np.linalg.norm(turns, axis=-1, keepdims=True)
    if not (length > 1e-6).all():
        raise ValueError("a rotation is no quaternion: its length is 0")
    return turns / length


def _dict(of: dict, key: str) -> dict:
    """A member that is an object; {} if it is missing."""
    value = of.get(key, {})
    if not isinstance(value, dict):
        raise ValueError(f"{key} should be an object, got {type(value).__name__}")
    return value


def _dicts(of: dict, key: str) -> list[dict]:
    """A member that is a list of objects; [] if it is missing."""
    value = of.get(key, [])
    if not isinstance(value, list) or not all(isinstance(x, dict) for x in value):
        raise ValueError(f"{key} should be a list of objects")
    return value


def _whole(of: dict, key: str, default: int | None = None) -> int:
    value = of.get(key, default)
    if type(value) is not int or not 0 <= value < 2**53:
        raise ValueError(f"{key} should be a whole number, got {str(value)[:20]!r}")
    return value


def _index(of: dict, key: str, count: int) -> int:
    value = _whole(of, key)
    if value >= count:
        raise ValueError(f"{key} {value} does not exist; there are {count}")
    return value


def _indices(of: dict, key: str, count: int) -> list[int]:
    values = of.get(key, [])
    if not isinstance(values, list):
        raise ValueError(f"{key} should be a list")
    return [_index({key: value}, key, count) for value in values]


def _numbers(of: dict, key: str, count: int, default: tuple[float, ...] = ()) -> np.ndarray:
    values = of.get(key, default)
    if not isinstance(values, list | tuple) or len(values) != count or not all(
            type(v) in (int, float) and abs(v) < 1e30 and math.isfinite(v) for v in values):
        raise ValueError(f"{key} of a node should be {count} numbers")
    return np.array(values, np.float64)


def _hashable(value: object) -> object:
    return value if isinstance(value, int | str) else None
