"""glTF 2.0: a clip as a skinned mannequin with its animation, in one binary file (.glb): a JSON text and one buffer."""

import json
import os
import struct
from collections.abc import Sequence

import numpy as np
import torch

from toolkit.io.files import write_whole
from toolkit.motion import Clip
from toolkit.motion import rotations as R

COMPONENTS = {"f4": 5126, "u4": 5125, "u2": 5123}  # numpy's types to glTF's
STILL = 1e-6  # a channel that changes by less is left out, quaternion components and metres
VERTICES, INDICES = 34962, 34963  # targets of glTF's buffer views


def save(clip: Clip, path: str | os.PathLike) -> None:
    """Write a clip as binary glTF, whole or not at all; a ValueError if no bone is long enough for a body.

    The file has a node per joint and end site, under its name. The mannequin of `toolkit.view` is a skinned mesh with a
    colour per vertex; every vertex follows up to four joints. The animation holds the joints' rotations and the root's
    translation at the clip's rate, linear between frames; joints that keep their rotation have no channel. Metres, y up,
    facing +z at zero rotation, as glTF demands.

    The vertices are those of the mannequin's bind pose (`toolkit.view.body`), so that one inverse bind matrix per joint
    gives exactly the skin of the toolkit's own pictures.
    """
    from toolkit.view import body  # imported on demand: it needs the drawing libraries

    clip = clip.to("cpu", torch.float32)
    skeleton, mannequin, buffer = clip.skeleton, body.build(clip), Buffer()
    turns = R.normalize(R.unroll(clip.rotations).double())[..., [1, 2, 3, 0]].float().numpy()
    nodes = [{"name": name, "translation": skeleton.offsets[j].tolist(), "rotation": turns[0, j].tolist()}
             for j, name in enumerate(skeleton.names)]
    nodes[0]["translation"] = clip.root_positions[0].tolist()
    for j, parent in enumerate(skeleton.parents[1:], 1):
        nodes[parent].setdefault("children", []).append(j)
    title = " ".join(x for x in (clip.style, clip.gait) if x) or clip.name
    nodes.append({"name": "Mannequin", "mesh": 0, "skin": 0})
    inverse = np.zeros((len(skeleton), 4, 4), np.float32)  # glTF's matrices are written column by column
    inverse[:, :, :3], inverse[:, 3, 3] = mannequin.skin.inverse.swapaxes(1, 2), 1.0
    skin = {"joints": list(range(len(skeleton))), "skeleton": 0, "inverseBindMatrices": buffer.add(inverse, "MAT4")}
    document = {
        "asset": {"version": "2.0", "generator": "toolkit"},
        "scene": 0,
        "scenes": [{"name": title, "nodes": [0, len(skeleton)]}],
        "nodes": nodes,
        "meshes": [{"name": "Mannequin", "primitives": [_primitive(buffer, mannequin) | {"material": 0}]}],
        "skins": [skin],
        "materials": [{"name": "Mannequin", "pbrMetallicRoughness": {"metallicFactor": 0.0, "roughnessFactor": 0.8}}],
    }
    if len(clip) > 1:
        document["animations"] = [_animation(buffer, clip, turns) | {"name": title}]
    document |= {"buffers": [{"byteLength": len(buffer.data)}], "bufferViews": buffer.views, "accessors": buffer.accessors}
    write_whole(path, container(document, bytes(buffer.data)))


class Buffer:
    """The binary part and its description: one view and one accessor per array."""

    def __init__(self, data: bytes = b"", views: Sequence[dict] = (), accessors: Sequence[dict] = ()):
        self.data, self.views, self.accessors = bytearray(data + b"\0" * (-len(data) % 4)), list(views), list(accessors)

    def add(self, values: np.ndarray, kind: str, target: int | None = None, *, bounds: bool = False) -> int:
        """Index of the accessor of an array ``[N, ...]`` of float32, uint32 or uint16."""
        values = np.ascontiguousarray(values)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": values.nbytes}
        self.views.append(view | ({} if target is None else {"target": target}))
        self.data += values.tobytes() + b"\0" * (-values.nbytes % 4)
        component = COMPONENTS[values.dtype.str[1:]]
        made = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values), "type": kind}
        if bounds:
            flat = values.reshape(len(values), -1)
            made |= {"min": flat.min(0).tolist(), "max": flat.max(0).tolist()}
        self.accessors.append(made)
        return len(self.accessors) - 1


def _primitive(buffer: Buffer, mannequin) -> dict:
    """The surface in the bind pose, its colours in linear light."""
    skin = mannequin.skin
    attributes = {
        "POSITION": buffer.add(skin.points, "VEC3", VERTICES, bounds=True),
        "NORMAL": buffer.add(skin.normals, "VEC3", VERTICES),
        "JOINTS_0": buffer.add(skin.joints.astype(np.uint16), "VEC4", VERTICES),
        "WEIGHTS_0": buffer.add(skin.weights, "VEC4", VERTICES),
        "COLOR_0": buffer.add((mannequin.colors() ** 2.2).astype(np.float32), "VEC3", VERTICES),
    }
    indices = buffer.add(skin.triangles.astype(np.uint32).reshape(-1), "SCALAR", INDICES)
    return {"attributes": attributes, "indices": indices}


def _animation(buffer: Buffer, clip: Clip, turns: np.ndarray) -> dict:
    """Rotations of joints that move and the root's translation."""
    times = buffer.add((np.arange(len(clip)) / clip.fps).astype(np.float32), "SCALAR", bounds=True)
    moving = np.flatnonzero(np.ptp(clip.rotations.numpy(), axis=0).max(1) > STILL).tolist()
    tracks = [(j, "rotation", turns[:, j], "VEC4") for j in moving]
    places = clip.root_positions.numpy()
    if float(np.ptp(places, axis=0).max()) > STILL or not tracks:
        tracks.insert(0, (0, "translation", places, "VEC3"))
    return {
        "samplers": [{"input": times, "output": buffer.add(values, kind), "interpolation": "LINEAR"}
                     for _, _, values, kind in tracks],
        "channels": [{"sampler": i, "target": {"node": joint, "path": what}} for i, (joint, what, *_) in enumerate(tracks)],
    }


def container(document: dict, data: bytes) -> bytes:
    """The .glb file: a header, a JSON chunk and a binary chunk, each a multiple of four bytes; ValueError for NaN in it."""
    text = json.dumps(document, separators=(",", ":"), ensure_ascii=False, allow_nan=False).encode(errors="replace")
    text += b" " * (-len(text) % 4)
    chunks = b"".join(struct.pack("<I4s", len(chunk), kind) + chunk for kind, chunk in ((b"JSON", text), (b"BIN\0", data)))
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
