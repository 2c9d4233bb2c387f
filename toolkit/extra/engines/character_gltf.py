"""A character's own file with a motion on it, in place of its animations, as glTF."""

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


def write(clip: Clip, path: Path, *, character: Character | None, **_) -> None:
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
    document = file.document
    if file.binary is None or len(document.get("buffers", ())) != 1:
        raise ValueError(f"{character.path}: keeps its mesh in other files; "
                         "convert it to one .glb first")
    made = character.fitted(clip.to("cpu", torch.float32))
    for number in character.mesh.nodes:
        node = document["nodes"][number]
        if "matrix" in node:  # an animated node has translation, rotation and scale
            move, _, scale = pose(node)
            del node["matrix"]
            node.update(translation=move.tolist(), scale=scale.tolist())

    # The root's rotation and place below the node above it
    above = character.mesh.above
    axes = torch.from_numpy(above[:3, :3] / np.linalg.norm(above[:3, :3], axis=0))
    turns, inverse = made.rotations.double(), np.linalg.inv(above)
    turns[:, 0] = R.multiply(R.inverse(R.from_matrix(axes)), turns[:, 0])
    places = made.root_positions.double().numpy() @ inverse[:3, :3].T + inverse[:3, 3]

    views, accessors = document.get("bufferViews", []), document.get("accessors", [])
    buffer = Buffer(bytes(file.binary), views, accessors)
    gltf.animate(document, buffer, made, character.mesh.nodes, turns, places)
    try:
        whole = container(document, buffer)
    except ValueError:
        raise ValueError(f"{character.path}: its JSON text has NaN or Infinity, "
                         "which other programs cannot read") from None
    write_whole(path, whole)
