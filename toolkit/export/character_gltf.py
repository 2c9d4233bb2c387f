"""A character's own glTF file with a motion on it: its nodes, meshes, materials and textures stay, its animations do not."""

import copy
import os

import numpy as np
import torch

from toolkit.export.gltf import STILL, Buffer, container
from toolkit.io.files import write_whole
from toolkit.io.gltf_file import Document
from toolkit.motion import Clip
from toolkit.motion import rotations as R
from toolkit.view.character import Character


def save(clip: Clip, path: str | os.PathLike, character: Character) -> None:
    """Write the character as binary glTF with the clip on it, whole or not at all.

    A clip of another rig is retargeted (`toolkit.view.character.Character.fitted`). The animation holds the rotations of the
    rig's joints and the translation of its root at the clip's rate, linear between frames.

    Raises
    ------
    ValueError
        If the character's file was changed, keeps its numbers outside of itself, or has some that JSON lacks.
    """
    file = Document(character.path)
    if file.digest != character.mesh.digest:
        raise ValueError(f"{character.path}: was changed since it was read; run the command again")
    document = copy.deepcopy(file.document)
    if file.binary is None or len(document.get("buffers", ())) != 1:
        raise ValueError(f"{character.path}: keeps its mesh in other files; convert it to one .glb first")
    made = character.fitted(clip.to("cpu", torch.float32))
    buffer = Buffer(bytes(file.binary), document.get("bufferViews", []), document.get("accessors", []))
    nodes, skeleton = document["nodes"], made.skeleton
    turns, places = made.global_rotations.double(), made.global_positions.double().numpy()
    times = buffer.add((np.arange(len(made)) / made.fps).astype(np.float32), "SCALAR", bounds=True)
    samplers, channels = [], []

    def track(joint: int, what: str, values: np.ndarray, kind: str) -> None:
        channels.append({"sampler": len(samplers), "target": {"node": character.mesh.nodes[joint], "path": what}})
        samplers.append({"input": times, "output": buffer.add(values.astype(np.float32), kind), "interpolation": "LINEAR"})

    frame = character.mesh.above
    for joint in range(len(skeleton)):
        node, parent = nodes[character.mesh.nodes[joint]], skeleton.parents[joint]
        if "matrix" in node:  # an animated node has translation, rotation and scale
            _decompose(node)
        above = R.from_matrix(torch.from_numpy(_axes(frame)))[None] if parent < 0 else turns[:, parent]
        local = R.unroll(R.normalize(R.multiply(R.inverse(above), turns[:, joint])))
        values = local[:, [1, 2, 3, 0]].numpy()
        node["rotation"] = values[0].tolist()
        if np.ptp(values, axis=0).max() > STILL:
            track(joint, "rotation", values, "VEC4")
    inverse = np.linalg.inv(frame)
    root = places[:, 0] @ inverse[:3, :3].T + inverse[:3, 3]
    nodes[character.mesh.nodes[0]]["translation"] = root[0].tolist()
    track(0, "translation", root, "VEC3")
    name = " ".join(x for x in (clip.style, clip.gait) if x) or clip.name
    document["animations"] = [{"name": name, "samplers": samplers, "channels": channels}]
    document |= {"bufferViews": buffer.views, "accessors": buffer.accessors,
                 "buffers": [document["buffers"][0] | {"byteLength": len(buffer.data)}]}
    try:
        whole = container(document, bytes(buffer.data))
    except ValueError:
        raise ValueError(f"{character.path}: its JSON text has NaN or Infinity, which other programs cannot read") from None
    write_whole(path, whole)


def _axes(frame: np.ndarray) -> np.ndarray:
    """The rotation in a transform with a scale."""
    return frame[:3, :3] / np.linalg.norm(frame[:3, :3], axis=0)


def _decompose(node: dict) -> None:
    """A node's matrix as translation, rotation and scale."""
    matrix = np.array(node.pop("matrix"), float).reshape(4, 4).T
    turn = R.from_matrix(torch.from_numpy(_axes(matrix)))[[1, 2, 3, 0]]
    node |= {"translation": matrix[:3, 3].tolist(), "rotation": turn.tolist(),
             "scale": np.linalg.norm(matrix[:3, :3], axis=0).tolist()}
