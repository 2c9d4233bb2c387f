"""glTF 2.0: a clip as a skinned mannequin with its animation, in one binary file (.glb).

The container is a JSON text and one buffer behind a header of 12 bytes; what takes thought (which numbers, in which order)
every library leaves to its caller, so none is used.
"""

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

FLOAT, UINT, USHORT = 5126, 5125, 5123  # component types of glTF's accessors
SLOTS = 4  # joints that a vertex may follow in glTF's JOINTS_0 and WEIGHTS_0
STILL = 1e-6  # a channel that changes by less is left out, quaternion components and metres


def save(clip: Clip, path: str | os.PathLike) -> None:
    """Write a clip as binary glTF, whole or not at all.

    A node per point of the skeleton, under its name; the mannequin of `toolkit.view` as a skinned mesh, a material per
    colour, every vertex following up to three joints; an animation of the joints' rotations and the root's translation at
    the clip's own rate, linear between frames. Metres, y up, facing +z at zero rotation, as glTF asks. Joints that keep
    their rotation have no channel.

    The bind pose has zero rotations, but straight limbs where the skin bends (`toolkit.view.body.Bend`), so that one inverse
    bind matrix per joint gives exactly the skin of the toolkit's own pictures.

    Parameters
    ----------
    clip
        The motion.
    path
        The file to write.

    Raises
    ------
    ValueError
        If no bone is long enough to be given a body.
    """
    from toolkit.view import body  # drawing libraries, only on demand

    clip = clip.to("cpu", torch.float32)
    skeleton, shapes = clip.skeleton, body.build(clip)
    if not shapes:
        raise ValueError(f"{clip.name}: no bone is long enough to be given a body")
    bind = _bind_pose(skeleton, shapes)
    buffer = _Buffer()
    moving = [j for j in range(len(skeleton)) if float(np.ptp(clip.rotations[:, j].numpy(), axis=0).max()) > STILL]
    turns = R.normalize(R.unroll(clip.rotations).double())[..., [1, 2, 3, 0]].float().numpy()
    nodes = [{"name": name, "translation": skeleton.offsets[j].tolist(), "rotation": turns[0, j].tolist()}
             for j, name in enumerate(skeleton.names)]
    nodes[0]["translation"] = clip.root_positions[0].tolist()
    for j, parent in enumerate(skeleton.parents[1:], 1):
        nodes[parent].setdefault("children", []).append(j)
    title = " ".join(x for x in (clip.style, clip.gait) if x) or clip.name
    nodes.append({"name": "Mannequin", "mesh": 0, "skin": 0})
    tones = list(dict.fromkeys(shape.tone for shape in shapes))
    surfaces = [[shape for shape in shapes if shape.tone == tone] for tone in tones]
    primitives = [_primitive(buffer, surface, bind, i) for i, surface in enumerate(surfaces)]
    inverse = torch.linalg.inv(bind).transpose(1, 2).float().numpy()  # glTF's matrices are written column by column
    skin = {"joints": list(range(len(skeleton))), "skeleton": 0, "inverseBindMatrices": buffer.add(inverse, "MAT4")}
    document = {
        "asset": {"version": "2.0", "generator": "toolkit"},
        "scene": 0,
        "scenes": [{"name": title, "nodes": [0, len(skeleton)]}],
        "nodes": nodes,
        "meshes": [{"name": "Mannequin", "primitives": primitives}],
        "skins": [skin],
        "materials": [_material(tone, body.COLORS[tone]) for tone in tones],
    }
    if len(clip) > 1:
        document["animations"] = [_animation(buffer, clip, turns, moving, title)]
    document |= buffer.description()
    with atomic_write(path) as file:
        file.write(_container(document, bytes(buffer.data)))


class _Buffer:
    """The binary part, and what describes it: one view per array."""

    def __init__(self):
        self.data, self.views, self.accessors = bytearray(), [], []

    def add(self, values: np.ndarray, kind: str, target: int | None = None, *, bounds: bool = False) -> int:
        """Index of the accessor of an array ``[N, ...]`` of float32, uint32 or uint16."""
        values = np.ascontiguousarray(values)
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": values.nbytes}
        self.views.append(view | ({} if target is None else {"target": target}))
        self.data += values.tobytes() + b"\0" * (-values.nbytes % 4)
        component = {"f4": FLOAT, "u4": UINT, "u2": USHORT}[values.dtype.str[1:]]
        made = {"bufferView": len(self.views) - 1, "componentType": component, "count": len(values), "type": kind}
        if bounds:
            flat = values.reshape(len(values), -1)
            made |= {"min": flat.min(0).tolist(), "max": flat.max(0).tolist()}
        self.accessors.append(made)
        return len(self.accessors) - 1

    def description(self) -> dict:
        """What the document says of it."""
        return {"buffers": [{"byteLength": len(self.data)}], "bufferViews": self.views, "accessors": self.accessors}


def _bind_pose(skeleton: Skeleton, shapes: Sequence) -> Tensor:
    """World matrices ``[J, 4, 4]`` of the joints in the pose in which the surface is put down.

    A bend places the same cone in two neighbouring joints' frames; their ratio is how the lower one sits on the upper.
    """
    turns = R.identity(len(skeleton)).double()
    for shape in shapes:
        for bend in shape.bends:
            below = skeleton.parents[bend.joint] == shape.joint
            lower = bend.joint if below else shape.joint
            upper, own = (shape.place, bend.place) if below else (bend.place, shape.place)
            turns[lower] = R.from_matrix(torch.from_numpy(upper[:, :3] @ np.linalg.inv(own[:, :3])))
    rotations, positions = forward_kinematics(skeleton, turns, skeleton.offsets[0].double())
    matrices = torch.eye(4, dtype=torch.float64).repeat(len(skeleton), 1, 1)
    matrices[:, :3, :3], matrices[:, :3, 3] = R.to_matrix(rotations), positions
    return matrices


def _primitive(buffer: _Buffer, shapes: Sequence, bind: Tensor, material: int) -> dict:
    """The shapes of one colour as one surface in the bind pose."""
    from toolkit.view.skin import surface, weights

    points, normals, triangles, joints, shares = [], [], [], [], []
    for shape in shapes:
        vertices, outward, faces = surface(shape)
        triangles.append(faces + sum(map(len, points)))
        world = bind[shape.joint].numpy() @ np.vstack((shape.place, np.eye(4)[3]))
        points.append(vertices @ world[:3, :3].T + world[:3, 3])
        outward = outward @ np.linalg.inv(world[:3, :3])  # the inverse transpose: the cone may be thinned
        normals.append(outward / np.linalg.norm(outward, axis=1, keepdims=True))
        share = np.pad(weights(shape, vertices[:, 1]), ((0, 0), (0, 1)))
        hosts = [shape.joint, *(bend.joint for bend in shape.bends)]
        shares.append(share)
        joints.append((share > 0) * np.array(hosts + [0] * (SLOTS - len(hosts))))
    points, normals, shares = (np.concatenate(v).astype(np.float32) for v in (points, normals, shares))
    attributes = {
        "POSITION": buffer.add(points, "VEC3", 34962, bounds=True),
        "NORMAL": buffer.add(normals, "VEC3", 34962),
        "JOINTS_0": buffer.add(np.concatenate(joints).astype(np.uint16), "VEC4", 34962),
        "WEIGHTS_0": buffer.add(shares, "VEC4", 34962),
    }
    indices = buffer.add(np.concatenate(triangles).astype(np.uint32).reshape(-1), "SCALAR", 34963)
    return {"attributes": attributes, "indices": indices, "material": material}


def _material(tone: str, color: str) -> dict:
    linear = [(int(color[i : i + 2], 16) / 255) ** 2.2 for i in (1, 3, 5)]
    surface = {"baseColorFactor": [*linear, 1.0], "metallicFactor": 0.0, "roughnessFactor": 0.8}
    return {"name": tone, "pbrMetallicRoughness": surface}


def _animation(buffer: _Buffer, clip: Clip, turns: np.ndarray, moving: Sequence[int], title: str) -> dict:
    """Rotations of joints that move and the root's translation."""
    times = buffer.add((np.arange(len(clip)) / clip.fps).astype(np.float32), "SCALAR", bounds=True)
    tracks = [(j, "rotation", turns[:, j], "VEC4") for j in moving]
    places = clip.root_positions.numpy()
    if float(np.ptp(places, axis=0).max()) > STILL or not tracks:
        tracks.insert(0, (0, "translation", places, "VEC3"))
    return {
        "name": title,
        "samplers": [{"input": times, "output": buffer.add(values, kind), "interpolation": "LINEAR"}
                     for _, _, values, kind in tracks],
        "channels": [{"sampler": i, "target": {"node": joint, "path": what}}
                     for i, (joint, what, _, _) in enumerate(tracks)],
    }


def _container(document: dict, data: bytes) -> bytes:
    """The .glb file: header, JSON chunk, binary chunk, each a whole number of four bytes."""
    text = json.dumps(document, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 4)
    chunks = b"".join(struct.pack("<I4s", len(chunk), kind) + chunk for kind, chunk in ((b"JSON", text), (b"BIN\0", data)))
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
