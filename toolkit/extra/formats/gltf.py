"""glTF 2.0 files (.glb, .gltf, .vrm, .vrma): the animation of a skeleton, resampled to one rate."""

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit.extra.formats.gltf_file import (
    Document,
    index_of,
    indices_of,
    member,
    members,
    numbers_of,
    unit_quaternions,
)
from toolkit.extra.formats.key_times import around, hermite, sampled
from toolkit.extra.formats.nodes import Node, chosen, record
from toolkit.io.files import named
from toolkit.io.recording import Recording
from toolkit.motion import rotations as R
from toolkit.motion.roles import SIDES
from toolkit.motion.text import printable

PATHS = {"translation": 3, "rotation": 4, "scale": 3}
BONES = {"shoulder": "UpperArm", "elbow": "LowerArm", "hand": "Hand", "hip": "UpperLeg",
         "knee": "LowerLeg", "foot": "Foot", "toe": "Toes"}  # our roles to VRM's bones
USUAL = 30.0  # frames per second where the keys say nothing


@np.errstate(invalid="ignore", over="ignore")
def read(path: str | os.PathLike, animation: str | int | None = None) -> Recording:
    """Read the motion of a glTF file.

    All channels are sampled at the rate of their keys (`key_times.frame_rate`), by the file's
    interpolation. A file without animation gives its rest pose as one frame. VRM and VRMA files say
    which joint has which role. Lengths are metres, and y is up: glTF demands both.

    Parameters
    ----------
    path : the file; buffers beside it are read from its own folder only
    animation : its name or index; by default the first one

    Raises
    ------
    ValueError
        If the file is not glTF 2.0 or damaged, holds no skeleton or not a rigid one, or needs an
        extension to be read.
    """
    with named(path):
        return _File(Path(path)).recording(animation)


@dataclass
class _Channel:
    """One property of one node over K keys."""

    keys: np.ndarray  # [K] seconds
    values: np.ndarray  # [K, 1 or 3, C]: with CUBICSPLINE between a slope before and a slope after
    kind: str  # LINEAR, STEP or CUBICSPLINE


class _File(Document):
    """The document, read as a motion."""

    def recording(self, animation: str | int | None) -> Recording:
        """An animation on the largest skeleton."""
        nodes, doubts = [], []
        for node, parent in zip(self.listed("nodes"), self.parents, strict=True):
            plain = not {"mesh", "camera", "extensions"} & node.keys()
            tracks = (part[None] for part in pose(node))
            nodes.append(Node(printable(node.get("name", "")), parent, *tracks, plain=plain))
        for skin in self.listed("skins"):
            for j in indices_of(skin, "joints", len(nodes)):
                nodes[j].joint = nodes[j].skinned = True
        roles = self._roles(nodes)

        animations = self.listed("animations")
        names = [printable(a.get("name", i)) for i, a in enumerate(animations)]
        index = chosen(names, animation, doubts)
        channels = self._channels(animations[index], len(nodes)) if animations else {}
        frames, fps = self._animate(nodes, channels)
        return record(nodes, frames, fps, format_="glTF", unit=1.0, up="y", roles=roles,
                      doubts=doubts)

    def _roles(self, nodes: list[Node]) -> dict[str, int] | None:
        """Nodes by role where a VRM extension names the bones; these nodes are joints."""
        extensions, bones = member(self.document, "extensions"), {}
        for key in ("VRMC_vrm", "VRMC_vrm_animation", "VRM"):
            humanoid = member(member(extensions, key), "humanoid")
            if isinstance(humanoid.get("humanBones"), dict):  # by name, since VRM 1.0
                listed = {bone: member(humanoid["humanBones"], bone)
                          for bone in humanoid["humanBones"]}
            else:  # a list in VRM 0
                listed = {str(e.get("bone")): e for e in members(humanoid, "humanBones")}
            bones |= {bone: index_of(entry, "node", len(nodes)) for bone, entry in listed.items()}
        if not bones:
            return None
        for j in bones.values():
            nodes[j].joint = True
        wanted = {"hips": "hips"}
        wanted |= {f"{side}_{part}": side + bone for side in SIDES for part, bone in BONES.items()}
        return {role: bones[bone] for role, bone in wanted.items() if bone in bones}

    def _channels(self, animation: dict, count: int) -> dict[tuple[int, str], _Channel]:
        """The channels of an animation by node and property."""
        samplers, found = members(animation, "samplers"), {}
        increasing = set()  # samplers share their key times, which are looked at once
        for channel in members(animation, "channels"):
            target = member(channel, "target")
            what = str(target.get("path"))
            if what not in PATHS or "node" not in target:
                continue  # weights of blend shapes, or a target of an extension
            j = index_of(target, "node", count)
            sampler = samplers[index_of(channel, "sampler", len(samplers))]
            kind = str(sampler.get("interpolation", "LINEAR"))
            if kind not in ("LINEAR", "STEP", "CUBICSPLINE"):
                raise ValueError(f"unknown interpolation {kind[:20]!r}")

            keys = self.array(sampler.get("input"), 1)[:, 0]
            if sampler["input"] not in increasing and not (len(keys) and (np.diff(keys) > 0).all()):
                raise ValueError("the key times of an animation do not increase")
            increasing.add(sampler["input"])

            values = self.array(sampler.get("output"), PATHS[what])
            if len(values) != len(keys) * (3 if kind == "CUBICSPLINE" else 1):
                raise ValueError(f"the {what} of node {j} has {len(values)} values "
                                 f"for {len(keys)} keys")
            found[j, what] = _Channel(keys, values.reshape(len(keys), -1, PATHS[what]), kind)
        return found

    def _animate(self, nodes: list[Node],
                 channels: dict[tuple[int, str], _Channel]) -> tuple[int, float]:
        """Sample the channels into the nodes' tracks: the number of frames, and their rate."""
        times = [channel.keys for channel in channels.values()]
        joints = sum(node.joint for node in nodes) + len({j for j, _ in channels})
        at, rate = sampled(times, USUAL, joints, self.size)
        for (j, what), channel in channels.items():
            track = _sample(channel, at, turn=what == "rotation")
            if np.ptp(track, axis=0).max() < 1e-12:
                track = track[:1]
            if what == "rotation":
                track = torch.from_numpy(track[:, [3, 0, 1, 2]])  # glTF has w last
            setattr(nodes[j], what, track)
            nodes[j].joint |= len(track) > 1 and what != "scale"
        return len(at), rate


def pose(node: dict) -> tuple[np.ndarray, Tensor, np.ndarray]:
    """Translation, rotation and scale of a node."""
    if "matrix" in node:
        matrix = numbers_of(node, "matrix", 16).reshape(4, 4).T  # column by column in the file
        scale = np.linalg.norm(matrix[:3, :3], axis=0)
        if np.linalg.det(matrix[:3, :3]) < 0:
            scale[0] *= -1
        axes = torch.from_numpy(matrix[:3, :3] / np.where(scale == 0, 1.0, scale))
        return matrix[:3, 3], R.from_matrix(axes), scale
    turn = unit_quaternions(numbers_of(node, "rotation", 4, (0.0, 0.0, 0.0, 1.0)))
    return (numbers_of(node, "translation", 3, (0.0,) * 3), torch.from_numpy(turn[[3, 0, 1, 2]]),
            numbers_of(node, "scale", 3, (1.0,) * 3))


def _sample(channel: _Channel, at: np.ndarray, turn: bool) -> np.ndarray:
    """Values ``[F, C]`` of a channel at the times ``at`` [F] (glTF 2.0, appendix C)."""
    keys, values, kind = channel.keys, channel.values, channel.kind
    own = values[:, values.shape[1] // 2]  # without the slopes
    if turn:
        own = unit_quaternions(own)
    if len(keys) == 1:
        return np.repeat(own, len(at), axis=0)

    i, span, t = around(keys, at, 1e-6)
    if kind == "STEP":
        return own[i + (at >= keys[-1] - 1e-6)]
    span, t = span[:, None], t[:, None]
    if kind == "LINEAR" and turn:
        first, second = (torch.from_numpy(own[k]) for k in (i, i + 1))
        return R.slerp(first, second, torch.from_numpy(t[:, 0])).numpy()
    if kind == "LINEAR":
        return own[i] + t * (own[i + 1] - own[i])
    made = hermite(t, own[i], own[i + 1], values[i, 2] * span, values[i + 1, 0] * span)
    return unit_quaternions(made) if turn else made
