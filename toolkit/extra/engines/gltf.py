"""glTF 2.0: a clip as a skinned mannequin with its animation, in one binary file (.glb)."""

import os
from collections.abc import Sequence

import numpy as np
import torch
from torch import Tensor

from toolkit.extra.formats.gltf_file import Buffer, container
from toolkit.io.files import write_whole
from toolkit.motion import Clip, rotations as R

STILL = 1e-6  # a channel that changes by less is left out, quaternion components and metres
VERTICES, INDICES = 34962, 34963  # targets of glTF's buffer views


def save(clip: Clip, path: str | os.PathLike) -> None:
    """Write a clip as binary glTF, whole or not at all.

    The file has a node per joint and end site, under its name. The mannequin of `toolkit.view` is a
    skinned mesh with a colour per vertex; each vertex follows one joint. The animation holds the
    joints' rotations and the root's translation at the clip's rate, linear between frames; joints
    that keep their rotation have no channel. Metres, y up, facing +z at zero rotation, as glTF
    demands. ValueError if no bone is long enough for a body.
    """
    from toolkit.view.render import mannequin  # imported on demand: it needs the drawing libraries

    clip = clip.to("cpu", torch.float32)
    skeleton, figure, buffer = clip.skeleton, mannequin.build(clip), Buffer()

    nodes = [{"name": name, "translation": offset}
             for name, offset in zip(skeleton.names, skeleton.offsets.tolist(), strict=True)]
    for j, parent in enumerate(skeleton.parents[1:], 1):
        nodes[parent].setdefault("children", []).append(j)
    nodes.append({"name": "Mannequin", "mesh": 0, "skin": 0})

    inverse = np.zeros((len(skeleton), 4, 4), np.float32)  # glTF's matrices go column by column
    inverse[:, :, :3], inverse[:, 3, 3] = figure.skin.inverse.swapaxes(1, 2), 1.0
    skin = {"joints": list(range(len(skeleton))), "skeleton": 0,
            "inverseBindMatrices": buffer.add(inverse)}
    surface = {"metallicFactor": 0.0, "roughnessFactor": 0.8}
    document = {
        "asset": {"version": "2.0", "generator": "toolkit"},
        "scene": 0,
        "scenes": [{"name": clip.label, "nodes": [0, len(skeleton)]}],
        "nodes": nodes,
        "meshes": [{"name": "Mannequin", "primitives": [_primitive(buffer, figure)]}],
        "skins": [skin],
        "materials": [{"name": "Mannequin", "pbrMetallicRoughness": surface}],
    }
    animate(document, buffer, clip, range(len(skeleton)), clip.rotations,
            clip.root_positions.numpy())
    write_whole(path, container(document, buffer))


def _primitive(buffer: Buffer, figure) -> dict:
    """The surface in the bind pose, its colours in linear light."""
    skin = figure.skin
    attributes = {
        "POSITION": buffer.add(skin.points, VERTICES, bounds=True),
        "NORMAL": buffer.add(skin.normals, VERTICES),
        "JOINTS_0": buffer.add(skin.joints.astype(np.uint16), VERTICES),
        "WEIGHTS_0": buffer.add(skin.weights, VERTICES),
        "COLOR_0": buffer.add((figure.colors() ** 2.2).astype(np.float32), VERTICES),
    }
    indices = buffer.add(skin.triangles.astype(np.uint32).reshape(-1), INDICES)
    return {"attributes": attributes, "indices": indices, "material": 0}


def animate(document: dict, buffer: Buffer, clip: Clip, nodes: Sequence[int], rotations: Tensor,
            places: np.ndarray) -> None:
    """Give nodes the pose of a clip's first frame, and the document an animation of the clip.

    ``rotations [F, J, 4]`` are those of the nodes, ``places [F, 3]`` translations of the first one.
    What keeps its value has no channel. A clip of one frame is no animation.
    """
    turns = R.normalize(R.unroll(rotations).double())[..., [1, 2, 3, 0]].float().numpy()
    tracks = [(nodes[0], "translation", places)]
    tracks += [(node, "rotation", turns[:, j]) for j, node in enumerate(nodes)]
    for node, what, values in tracks:
        document["nodes"][node][what] = values[0].tolist()
    document.pop("animations", None)
    if len(clip) == 1:
        return
    times = buffer.add((np.arange(len(clip)) / clip.fps).astype(np.float32), bounds=True)
    samplers, channels = [], []
    moving = [track for track in tracks if np.ptp(track[2], axis=0).max() > STILL]
    for node, what, values in moving or tracks[:1]:
        channels.append({"sampler": len(samplers), "target": {"node": node, "path": what}})
        samplers.append({"input": times, "output": buffer.add(values.astype(np.float32)),
                         "interpolation": "LINEAR"})
    document["animations"] = [{"name": clip.label, "samplers": samplers, "channels": channels}]
