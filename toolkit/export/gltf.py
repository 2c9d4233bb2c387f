"""glTF 2.0: a clip as a skinned mannequin with its animation, in one binary file (.glb): a JSON text and one buffer."""

import json
import os
import struct
from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor

from toolkit.io.files import atomic_write
from toolkit.motion import Clip, Skeleton, forward_kinematics
from toolkit.motion import rotations as R

COMPONENTS = {"f4": 5126, "u4": 5125, "u2": 5123}  # numpy's types to glTF's
SLOTS = 4  # joints that a vertex may follow in glTF's JOINTS_0 and WEIGHTS_0
STILL = 1e-6  # a channel that changes by less is left out, quaternion components and metres
VERTICES, INDICES = 34962, 34963  # targets of glTF's buffer views


def save(clip: Clip, path: str | os.PathLike) -> None:
    """Write a clip as binary glTF, whole or not at all; a ValueError if no bone is long enough for a body.

    The file has a node per joint and end site, under its name. The mannequin of `toolkit.view` is a skinned mesh with a
    material per colour; every vertex follows up to three joints. The animation holds the joints' rotations and the root's
    translation at the clip's rate, linear between frames; joints that keep their rotation have no channel. Metres, y up,
    facing +z at zero rotation, as glTF demands.

    In the bind pose all rotations are zero, but limbs are straight where the skin bends (`toolkit.view.body.Bend`), so that
    one inverse bind matrix per joint gives exactly the skin of the toolkit's own pictures.
    """
    from toolkit.view import body  # imported on demand: it needs the drawing libraries

    clip = clip.to("cpu", torch.float32)
    skeleton, shapes = clip.skeleton, body.build(clip)
    bind, buffer = _bind_pose(skeleton, shapes), Buffer()
    turns = R.normalize(R.unroll(clip.rotations).double())[..., [1, 2, 3, 0]].float().numpy()
    nodes = [{"name": name, "translation": skeleton.offsets[j].tolist(), "rotation": turns[0, j].tolist()}
             for j, name in enumerate(skeleton.names)]
    nodes[0]["translation"] = clip.root_positions[0].tolist()
    for j, parent in enumerate(skeleton.parents[1:], 1):
        nodes[parent].setdefault("children", []).append(j)
    title = " ".join(x for x in (clip.style, clip.gait) if x) or clip.name
    nodes.append({"name": "Mannequin", "mesh": 0, "skin": 0})
    surfaces = [[shape for shape in shapes if shape.tone == tone] for tone in dict.fromkeys(shape.tone for shape in shapes)]
    primitives = [_primitive(buffer, surface, bind) | {"material": i} for i, surface in enumerate(surfaces)]
    inverse = torch.linalg.inv(bind).transpose(1, 2).float().numpy()  # glTF's matrices are written column by column
    skin = {"joints": list(range(len(skeleton))), "skeleton": 0, "inverseBindMatrices": buffer.add(inverse, "MAT4")}
    document = {
        "asset": {"version": "2.0", "generator": "toolkit"},
        "scene": 0,
        "scenes": [{"name": title, "nodes": [0, len(skeleton)]}],
        "nodes": nodes,
        "meshes": [{"name": "Mannequin", "primitives": primitives}],
        "skins": [skin],
        "materials": [_material(surface[0].tone, body.colors(surface)[0]) for surface in surfaces],
    }
    if len(clip) > 1:
        document["animations"] = [_animation(buffer, clip, turns) | {"name": title}]
    document |= {"buffers": [{"byteLength": len(buffer.data)}], "bufferViews": buffer.views, "accessors": buffer.accessors}
    with atomic_write(path) as file:
        file.write(container(document, bytes(buffer.data)))


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


def _bind_pose(skeleton: Skeleton, shapes: Sequence) -> Tensor:
    """World matrices ``[J, 4, 4]`` of the bind pose, from the cone that each bend places in the frames of two joints."""
    turns = R.identity(len(skeleton)).double()
    for shape in shapes:
        for bend in shape.bends:
            below = shape.joint in skeleton.ancestors(bend.joint)
            lower = bend.joint if below else shape.joint
            upper, own = (shape.place, bend.place) if below else (bend.place, shape.place)
            turns[lower] = R.from_matrix(torch.from_numpy(upper[:, :3] @ np.linalg.inv(own[:, :3])))
    rotations, positions = forward_kinematics(skeleton, turns, skeleton.offsets[0].double())
    matrices = torch.eye(4, dtype=torch.float64).repeat(len(skeleton), 1, 1)
    matrices[:, :3, :3], matrices[:, :3, 3] = R.to_matrix(rotations), positions
    return matrices


def _primitive(buffer: Buffer, shapes: Sequence, bind: Tensor) -> dict:
    """The shapes of one colour as one surface in the bind pose."""
    from toolkit.view.skin import surface, weights

    rows, triangles, count = [], [], 0
    for shape in shapes:
        vertices, normals, faces = surface(shape)
        triangles.append(faces + count)
        count += len(vertices)
        world = bind[shape.joint].numpy() @ np.vstack((shape.place, np.eye(4)[3]))
        normals = normals @ np.linalg.inv(world[:3, :3])  # the inverse transpose: the cone may be thinned
        normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
        shares = np.pad(weights(shape, vertices[:, 1]), ((0, 0), (0, 1)))
        hosts = [shape.joint, *(bend.joint for bend in shape.bends)]
        joints = (shares > 0) * np.array(hosts + [0] * (SLOTS - len(hosts)))
        rows.append((vertices @ world[:3, :3].T + world[:3, 3], normals, joints, shares))
    points, normals, joints, shares = map(np.concatenate, zip(*rows, strict=True))
    attributes = {
        "POSITION": buffer.add(points.astype(np.float32), "VEC3", VERTICES, bounds=True),
        "NORMAL": buffer.add(normals.astype(np.float32), "VEC3", VERTICES),
        "JOINTS_0": buffer.add(joints.astype(np.uint16), "VEC4", VERTICES),
        "WEIGHTS_0": buffer.add(shares.astype(np.float32), "VEC4", VERTICES),
    }
    indices = buffer.add(np.concatenate(triangles).astype(np.uint32).reshape(-1), "SCALAR", INDICES)
    return {"attributes": attributes, "indices": indices}


def _material(tone: str, color: np.ndarray) -> dict:
    surface = {"baseColorFactor": [*(c**2.2 for c in color.tolist()), 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.8}
    return {"name": tone, "pbrMetallicRoughness": surface}


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
    """The .glb file: a header, a JSON chunk and a binary chunk, each a multiple of four bytes long."""
    text = json.dumps(document, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    chunks = b"".join(struct.pack("<I4s", len(chunk), kind) + chunk for kind, chunk in ((b"JSON", text), (b"BIN\0", data)))
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
