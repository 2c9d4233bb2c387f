"""glTF 2.0 files (.glb, .gltf, .vrm, .vrma): the animation of a skeleton, resampled to one rate."""

import os
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit.io.files import named
from toolkit.io.gltf_file import Document, hashable, index_of, indices_of, member, members, numbers_of, unit
from toolkit.io.nodes import Node, frame_rate, printable, record, sample_times
from toolkit.io.recording import Recording
from toolkit.motion import rotations as R
from toolkit.motion.clip import SIDES
from toolkit.motion.tensors import few

PATHS = {"translation": 3, "rotation": 4, "scale": 3}
BONES = {"shoulder": "UpperArm", "elbow": "LowerArm", "hand": "Hand", "hip": "UpperLeg", "knee": "LowerLeg", "foot": "Foot",
         "toe": "Toes"}  # our roles to VRM's bones, without the side
USUAL = 30.0  # frames per second where the keys say nothing


@np.errstate(invalid="ignore", over="ignore")
def read(path: str | os.PathLike) -> Recording:
    """Read the motion of a glTF file.

    All channels of the first animation are sampled at the rate of their keys, by the file's interpolation (LINEAR, STEP or
    CUBICSPLINE). If the keys are not at equal distances, the rate is the first usual one that meets all of them, otherwise
    30 Hz. A file without animation gives its rest pose as one frame. VRM and VRMA files say which joint has which role.
    Lengths are metres, and y is up: glTF demands both.

    Parameters
    ----------
    path : the file; buffers beside it are read from its own folder only

    Raises
    ------
    ValueError
        If the file is not glTF 2.0 or damaged, holds no skeleton or not a rigid one, or needs an extension to be read.
    """
    with named(path):
        return _File(Path(path)).recording()


class _File(Document):
    """The document, read as a motion."""

    def recording(self) -> Recording:
        """The first animation on the largest skeleton."""
        nodes = [Node(printable(node.get("name", "")), parent, *pose(node), plain=not any(
            key in node for key in ("mesh", "camera", "extensions")))
            for node, parent in zip(self.listed("nodes"), self.parents, strict=True)]
        for skin in self.listed("skins"):
            for j in indices_of(skin, "joints", len(nodes)):
                nodes[j].joint = nodes[j].skinned = True
        roles = self._roles(nodes)
        frames, fps = self._animate(nodes)
        if any(node.joint for node in nodes) and all(len(n.rotation) == len(n.translation) == 1 for n in nodes):
            self.doubts.append("no joint is animated; the pose of the nodes is given as it is")
        return record(nodes, frames, fps, format_="glTF", unit=1.0, up="y", roles=roles, doubts=self.doubts)

    def _roles(self, nodes: list[Node]) -> dict[str, int] | None:
        """Nodes by role where a VRM extension names the bones; these nodes are joints."""
        extensions = member(self.document, "extensions")
        bones = {}
        for key in ("VRMC_vrm", "VRMC_vrm_animation", "VRM"):
            humanoid = member(member(extensions, key), "humanoid")
            if isinstance(humanoid.get("humanBones"), dict):
                listed = ((bone, entry) for bone, entry in humanoid["humanBones"].items() if isinstance(entry, dict))
            else:
                listed = ((str(entry.get("bone")), entry) for entry in members(humanoid, "humanBones"))
            bones |= {bone: index_of(entry, "node", len(nodes)) for bone, entry in listed}
        for j in bones.values():
            nodes[j].joint = True
        wanted = {"hips": "hips"} | {f"{side}_{part}": f"{side}{bone}" for side in SIDES for part, bone in BONES.items()}
        return {role: bones[bone] for role, bone in wanted.items() if bone in bones} if bones else None

    def _animate(self, nodes: list[Node]) -> tuple[int, float]:
        """Sample one animation into the nodes' tracks: the number of frames, and their rate."""
        channels = self._channels(len(nodes))
        if not channels:
            return 1, USUAL
        times = [times for *_, times, _, _ in channels]
        rate = frame_rate(times, USUAL)
        at = sample_times(times, rate, sum(node.joint for node in nodes) + len({j for j, *_ in channels}), self.size)
        for j, what, keys, accessor, kind in channels:
            width = PATHS[what]
            values = self.array(accessor, width)
            rows = len(keys) * (3 if kind == "CUBICSPLINE" else 1)
            if len(values) != rows:
                raise ValueError(f"the {what} of node {j} has {len(values)} values for {len(keys)} keys")
            track = _sample(keys, values.reshape(len(keys), -1, width), at, kind, what == "rotation")
            if np.ptp(track, axis=0).max() < 1e-12:
                track = track[:1]
            setattr(nodes[j], what, torch.from_numpy(track[:, [3, 0, 1, 2]]) if what == "rotation" else track)
            nodes[j].joint = nodes[j].joint or (len(track) > 1 and what != "scale")
        return len(at), rate

    def _channels(self, count: int) -> list[tuple]:
        """Node, path, key times, accessor of the values and interpolation of each channel."""
        animations = self.listed("animations")
        if len(animations) > 1:
            names = few(printable(a.get("name", i)) for i, a in enumerate(animations))
            self.doubts.append(f"the file holds {len(animations)} animations ({names}); the first was read")
        if not animations:
            return []
        samplers, channels = members(animations[0], "samplers"), []
        for channel in members(animations[0], "channels"):
            target = member(channel, "target")
            if hashable(target.get("path")) not in PATHS or "node" not in target:
                continue  # weights of blend shapes, or a target of an extension
            sampler = samplers[index_of(channel, "sampler", len(samplers))]
            kind, times = hashable(sampler.get("interpolation", "LINEAR")), self.array(sampler.get("input"), 1)[:, 0]
            if kind not in ("LINEAR", "STEP", "CUBICSPLINE"):
                raise ValueError(f"unknown interpolation {str(kind)[:20]!r}")
            if not len(times) or not (np.diff(times) > 0).all():
                raise ValueError("the key times of an animation do not increase")
            channels.append((index_of(target, "node", count), target["path"], times, sampler.get("output"), kind))
        return channels



def pose(node: dict) -> tuple[np.ndarray, Tensor, np.ndarray]:
    """Translation, rotation and scale of a node, one row each."""
    if "matrix" in node:
        matrix = numbers_of(node, "matrix", 16).reshape(4, 4).T
        scale = np.linalg.norm(matrix[:3, :3], axis=0)
        if np.linalg.det(matrix[:3, :3]) < 0:
            scale[0] *= -1
        axes = torch.from_numpy(matrix[:3, :3] / np.where(scale == 0, 1.0, scale))
        return matrix[None, :3, 3], R.from_matrix(axes)[None], scale[None]
    turn = numbers_of(node, "rotation", 4, (0.0, 0.0, 0.0, 1.0))[None]
    return (numbers_of(node, "translation", 3, (0.0, 0.0, 0.0))[None], torch.from_numpy(unit(turn)[:, [3, 0, 1, 2]]),
            numbers_of(node, "scale", 3, (1.0, 1.0, 1.0))[None])


def _sample(keys: np.ndarray, values: np.ndarray, at: np.ndarray, kind: str, turn: bool) -> np.ndarray:
    """Values ``[F, C]`` at the times ``at`` [F] of ``values [K, 1 or 3, C]`` at the keys [K] (glTF 2.0, appendix C)."""
    own = values[:, values.shape[1] // 2]
    own = unit(own) if turn else own
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
    return unit(made) if turn else made
