"""BVH files: read and written in metres, seconds and radians, whatever unit and order they have."""

import math
import os
from collections import defaultdict
from collections.abc import Mapping
from numbers import Real
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit import registry
from toolkit.io.bvh_text import LARGEST, BVHError, Joint, contents, hierarchy, numbers
from toolkit.io.files import atomic_write
from toolkit.io.recording import Recording
from toolkit.motion import Clip, Skeleton, rotations as R

CENTIMETRE = 0.01
SMALL = 1_000_000  # joints times frames that a file of any size may have
MOVED = 2.5e-3  # of the longest bone: a larger change of a joint's distance is no rounding


def load(path: str | os.PathLike, *, unit: float | str = "auto", up: str = "auto",
         roles: Mapping[str, str] | None = None, style: str = "", gait: str = "") -> Clip:
    """Read a BVH file as `toolkit.load` does, with the same parameters.

    Raises
    ------
    BVHError
        If the file is not BVH or truncated, its frame count is wrong, or a number is missing or
        not finite.
    ValueError
        If unit, up or roles do not fit.
    """
    interpretation = registry.find("recording.interpretation")
    return interpretation.load(read(path), Path(path), unit, up, roles, style, gait)


def read(path: str | os.PathLike) -> Recording:
    """The motion in a BVH file, in its own unit and axes; BVHError as `load`.

    Channels may have any order, and any joint may have positions. Position channels replace a
    joint's OFFSET, or add to it in files where all of them stay near zero, as MakeHuman's do.
    Where they are constant, they become the skeleton's offset. A root whose only child moves
    relative to it (Bandai-Namco's ``joint_Root``) is merged with that child. End Sites become
    leaves named ``<parent>End``, ``<parent>2End`` and so on.
    """
    path = Path(path)
    data = contents(path)
    joints, motion = hierarchy(path, data)
    columns, fps = numbers(path, data, motion, sum(len(joint.channels) for joint in joints))
    frames = columns.shape[1]
    if len(joints) * frames > max(len(data), SMALL):  # joints without channels take no bytes
        raise BVHError(f"{path}: {len(joints)} joints in {frames} frames, "
                       f"but only {len(columns)} channels")
    rotations = _rotations(columns, joints)
    positions = _positions(columns, joints)
    for j, places in positions.items():
        if not (np.abs(places) < LARGEST).all():
            raise BVHError(f"{path}: positions of joint {joints[j].name} are beyond "
                           f"{LARGEST:g} units")
    doubts = _radians(columns, joints)
    del data, columns  # five times the bytes of the file

    # The distance of a joint to its parent is the median of its positions; few of them may move.
    offsets = np.array([joint.offset for joint in joints])
    for j, places in positions.items():
        offsets[j] = np.median(places, axis=0)
    limit = MOVED * max(np.linalg.norm(offsets[1:], axis=1), default=0.0)
    spreads = {j: float(np.ptp(places, axis=0).max()) for j, places in positions.items() if j}
    moving = {j: spread for j, spread in spreads.items() if spread > limit}
    names, parents = [joint.name for joint in joints], [joint.parent for joint in joints]
    root_positions = torch.from_numpy(positions[0])
    if 1 in moving and parents.count(0) == 1:  # merge the root with its child
        step = R.rotate(rotations[:, 0].double(), torch.from_numpy(positions[1]))
        root_positions = root_positions + step
        turns = R.unroll(R.multiply(rotations[:, 0], rotations[:, 1]))
        rotations = torch.cat((turns[:, None], rotations[:, 2:]), 1)
        names, parents, offsets = names[1:], [p - 1 for p in parents[1:]], offsets[1:]
        moving = {j - 1: spread for j, spread in moving.items() if j > 1}
    if moving:
        j = max(moving, key=moving.get)
        raise BVHError(f"{path}: joint {names[j]} changes its distance to its parent by up to "
                       f"{moving[j]:.4g} units of the file; only rigid skeletons are supported")
    ends = tuple(joint.name for joint in joints if joint.end)
    return Recording("BVH", tuple(names), tuple(parents), torch.from_numpy(offsets), rotations,
                     root_positions, fps, ends, doubts=doubts)


def save(clip: Clip, path: str | os.PathLike, *, unit: float = CENTIMETRE,
         order: str = "YXZ") -> None:
    """Write a BVH file, whole or not at all.

    Parameters
    ----------
    unit : metres of one unit of length in the file
    order : the order of every joint's rotation channels, such as "YXZ"

    Raises
    ------
    ValueError
        If the unit is no positive number, the order does not name each axis once, or a joint's
        name would be read differently: with braces, or with spaces other than single ones.
    """
    if not (isinstance(unit, Real) and unit > 0 and math.isfinite(unit)):
        raise ValueError(f"unit must be a positive number of metres, got {unit}")
    if sorted(order) != ["X", "Y", "Z"]:
        raise ValueError(f"order must name each of X, Y and Z once, such as 'YXZ'; got {order!r}")
    lines, joints = header(clip.skeleton, unit, order)
    angles = torch.rad2deg(R.to_euler(clip.rotations[:, joints].double(), order)).flatten(1)
    rows = torch.cat((clip.root_positions.double() / unit, angles), 1).cpu().numpy()
    lines += ["MOTION", f"Frames: {len(clip)}", f"Frame Time: {1 / clip.fps:.8f}"]
    with atomic_write(path) as file:
        file.write(("\n".join(lines) + "\n").encode())
        np.savetxt(file, rows, fmt="%.6f")


def header(skeleton: Skeleton, unit: float = CENTIMETRE,
           order: str = "YXZ") -> tuple[list[str], list[int]]:
    """The lines of a file before its motion, and the joints in the order of their channels.

    ValueError if a joint's name would be read differently.
    """
    for name in skeleton.names:
        if name != " ".join(name.split()) or "{" in name or "}" in name:
            raise ValueError(f"a BVH file cannot hold the joint name {name!r}; rename it")
    lines, visited = ["HIERARCHY"], []
    waiting = [(0, 0)]  # joints with their depths, (-1, depth) for a closing brace; last one first
    while waiting:
        joint, depth = waiting.pop()
        tab = "\t" * depth
        if joint < 0:
            lines.append(tab + "}")
            continue
        offset = (skeleton.offsets[joint].double() / unit).tolist() if depth else (0.0, 0.0, 0.0)
        end, kind = skeleton.is_end(joint), "JOINT" if depth else "ROOT"
        lines += [
            tab + ("End Site" if end else f"{kind} {skeleton.names[joint]}"),
            tab + "{",
            tab + "\tOFFSET " + " ".join(f"{v:.6f}" for v in offset),
        ]
        if not end:
            visited.append(joint)
            channels = [f"{axis}rotation" for axis in order]
            if not depth:
                channels = ["Xposition", "Yposition", "Zposition", *channels]
            lines.append(f"{tab}\tCHANNELS {len(channels)} {' '.join(channels)}")
        waiting.append((-1, depth))
        waiting += [(child, depth + 1) for child in reversed(skeleton.tree.children[joint])]
    return lines, visited


def _rotations(columns: np.ndarray, joints: list[Joint]) -> Tensor:
    """Local rotations ``[F, J, 4]``; joints with the same channel order are converted together."""
    from toolkit.io import decimals  # compiled, slow to import

    rotations = R.identity(columns.shape[1], len(joints))
    halves = (torch.from_numpy(columns) * (math.pi / 360)).float()  # of all angles, radians
    alike = defaultdict(list)  # joints by the order of their rotation channels
    for j, joint in enumerate(joints):
        order = "".join(name[0] for name in joint.channels if name.endswith("rotation"))
        alike[order].append(j)
    alike.pop("", None)
    for order, members in alike.items():
        # An axis without a channel comes last, with an angle of zero.
        every = order + "".join(axis for axis in "XYZ" if axis not in order)
        angles = torch.zeros(3, len(members), columns.shape[1])
        for i, axis in enumerate(order):
            angles[i] = halves[[joints[j].channels[f"{axis}rotation"] for j in members]]
        decimals.compose(angles.cos().numpy(), angles.sin().numpy(),
                         tuple(R.AXES[axis] for axis in every), np.array(members),
                         rotations.numpy())
    return rotations


def _positions(columns: np.ndarray, joints: list[Joint]) -> dict[int, np.ndarray]:
    """Positions ``[F, 3]`` relative to the parent, of the root and of joints with such channels."""
    positions = {}
    for j, joint in enumerate(joints):
        rows = {name[0]: row for name, row in joint.channels.items() if name.endswith("position")}
        if rows or not j:
            positions[j] = np.repeat([joint.offset], columns.shape[1], axis=0)
            for axis, row in rows.items():
                positions[j][:, R.AXES[axis]] = columns[row]
    # Where all positions but the root's stay near zero, they are relative to OFFSET.
    below = [j for j in positions if j]
    stated = sum(np.abs(joints[j].offset).sum() for j in below)
    if sum(np.abs(np.median(positions[j], axis=0)).sum() for j in below) < 0.1 * stated:
        for j in below:
            positions[j] += joints[j].offset
    return positions


def _radians(columns: np.ndarray, joints: list[Joint]) -> tuple[str, ...]:
    """A doubt if a motion's angles are so small that they may be radians."""
    rows = [row for joint in joints for name, row in joint.channels.items() if "rotation" in name]
    some = columns[rows, :: max(1, columns.shape[1] // 16)]
    largest = float(np.abs(some).max(initial=0.0))
    moves = float(np.ptp(some, axis=1).max(initial=0.0))
    if len(rows) < 30 or not (moves > 0.3 and largest < 6.5):
        return ()
    return (f"no joint turns by more than {largest:.2g} degrees: "
            "if the file has radians, convert them",)
