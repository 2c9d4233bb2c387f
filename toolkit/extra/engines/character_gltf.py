"""A character's own file with a motion on it, in place of its animations, as glTF."""

import copy
import os
from pathlib import Path

import numpy as np
import torch

from toolkit.extra.characters.character import Character
from toolkit.extra.characters.gltf_mesh import opened
from toolkit.extra.engines import gltf
from toolkit.extra.formats.gltf import pose
from toolkit.extra.formats.gltf_file import Buffer, container
from toolkit.io.files import write_whole
from toolkit.motion import Clip, rotations as R


def write(clip: Clip, path: Path, *, title: str, source: Clip | None, progress: bool,
          character: Character | None) -> None:
    """A .glb file of the mannequin or of a character, for `toolkit.io.save`."""
    if character is None:
        gltf.save(clip, path)
    else:
        save(clip, path, character)


def save(clip: Clip, path: str | os.PathLike, character: Character) -> None:
    """Write the character as binary glTF with the clip on it, whole or not at all.

    Its nodes, meshes, materials and textures stay. A clip of another rig is retargeted. The
    animation is as in `toolkit.extra.engines.gltf.save`.

    Raises
    ------
    ValueError
        If the character's file was changed, keeps its numbers outside of itself, or has some that
        JSON lacks.
    """
    file = opened(character.path)
    if file.digest != character.mesh.digest:
        raise ValueError(f"{character.path}: was changed since it was read; run the command again")
    document = copy.deepcopy(file.document)
    if file.binary is None or len(document.get("buffers", ())) != 1:
        raise ValueError(f"{character.path}: keeps its mesh in other files; "
                         "convert it to one .glb first")
    made = character.fitted(clip.to("cpu", torch.float32))
    turns, places = made.global_rotations.double(), made.global_positions.double().numpy()

    tracks, frame = [], character.mesh.above
    for joint, parent in enumerate(made.skeleton.parents):
        node = document["nodes"][character.mesh.nodes[joint]]
        if "matrix" in node:  # an animated node has translation, rotation and scale
            _decompose(node)
        above = turns[:, parent]
        if parent < 0:
            axes = frame[:3, :3] / np.linalg.norm(frame[:3, :3], axis=0)
            above = R.from_matrix(torch.from_numpy(axes))[None]
        local = R.unroll(R.normalize(R.multiply(R.inverse(above), turns[:, joint])))
        values = local[:, [1, 2, 3, 0]].numpy()
        node["rotation"] = values[0].tolist()
        if np.ptp(values, axis=0).max() > gltf.STILL:
            tracks.append((character.mesh.nodes[joint], "rotation", values))
    inverse, top = np.linalg.inv(frame), character.mesh.nodes[0]
    root = places[:, 0] @ inverse[:3, :3].T + inverse[:3, 3]
    document["nodes"][top]["translation"] = root[0].tolist()
    tracks.append((top, "translation", root))

    views, accessors = document.get("bufferViews", []), document.get("accessors", [])
    buffer = Buffer(bytes(file.binary), views, accessors)
    document["animations"] = [gltf.animation(buffer, made, tracks)]
    try:
        whole = container(document, buffer)
    except ValueError:
        raise ValueError(f"{character.path}: its JSON text has NaN or Infinity, "
                         "which other programs cannot read") from None
    write_whole(path, whole)


def _decompose(node: dict) -> None:
    """A node's matrix as translation, rotation and scale."""
    move, turn, scale = (part[0] for part in pose(node))
    del node["matrix"]
    node |= {"translation": move.tolist(), "rotation": turn[[1, 2, 3, 0]].tolist(),
             "scale": scale.tolist()}
