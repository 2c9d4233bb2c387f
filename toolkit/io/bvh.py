"""BVH files: read and written in metres, seconds and radians, whatever unit and order they have."""

import itertools
import math
import os
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit import registry
from toolkit.io import files
from toolkit.io.files import atomic_write
from toolkit.io.recording import Recording
from toolkit.motion import Clip, rotations as R
from toolkit.motion.text import shows

CENTIMETRE = 0.01
JOINTS = 20_000  # of a file, with End Sites
SMALL = 1_000_000  # joints times frames that a file of any size may have
LARGEST = 1e30  # limit of lengths in the file's unit; in any unit float32 holds them
MOVED = 2.5e-3  # of the longest bone: a larger change of a joint's distance is no rounding
#: Usual frame rates.
RATES = (24.0, 25.0, 30.0, 48.0, 50.0, 60.0, 72.0, 75.0, 90.0, 100.0, 120.0, 144.0, 180.0, 200.0,
         240.0, 250.0)
CHANNELS = frozenset(f"{axis}{kind}" for axis in "XYZ" for kind in ("position", "rotation"))
_MOTION = re.compile(rb"[\r\n][^\S\r\n]*MOTION[^\S\r\n]*(?=[\r\n]|\Z)", re.IGNORECASE)
_TIMING = re.compile(rb"\s*Frames[^\r\n:]*:([^\r\n]*)[\r\n]\s*Frame Time[^\r\n:]*:([^\r\n]*)",
                     re.IGNORECASE)


class BVHError(ValueError):
    """A file that cannot be read as BVH; the message names the file and the line."""


@dataclass
class _Joint:
    """A joint or an End Site of a file."""

    name: str
    parent: int  # index of a joint, -1 for the root
    end: bool  # whether it is an End Site
    offset: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])  # in the file's unit
    channels: dict[str, int] = field(default_factory=dict)  # "Xposition" …: row of numbers


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
    recording, interpretation = read(path), registry.find("recording.interpretation")
    try:
        return interpretation.load(recording, Path(path), unit, up, roles, style, gait)
    except ValueError as error:
        said = str(error).removeprefix(f"{Path(path).name}: ")
        raise BVHError(f"{path}: {said}") from error


def read(path: str | os.PathLike) -> Recording:
    """The motion in a BVH file, in its own unit and axes; BVHError as `load`.

    Channels may have any order, and any joint may have positions. Position channels replace a
    joint's OFFSET, or add to it in files where all of them stay near zero, as MakeHuman's do.
    Where they are constant, they become the skeleton's offset. A root whose only child moves
    relative to it (Bandai-Namco's ``joint_Root``) is merged with that child. End Sites become
    leaves named ``<parent>End``, ``<parent>2End`` and so on.
    """
    path = Path(path)
    data = _text(path)
    joints, motion = _hierarchy(path, data)
    columns, fps = _numbers(path, data, motion, sum(len(joint.channels) for joint in joints))
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
    if not (unit > 0 and math.isfinite(unit)):
        raise ValueError(f"unit must be a positive number of metres, got {unit}")
    if sorted(order) != ["X", "Y", "Z"]:
        raise ValueError(f"order must name each of X, Y and Z once, such as 'YXZ'; got {order!r}")
    skeleton = clip.skeleton
    for name in skeleton.names:
        if name != " ".join(name.split()) or "{" in name or "}" in name:
            raise ValueError(f"{clip.name}: a BVH file cannot hold the joint name {name!r}; "
                             "rename it")
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
    angles = torch.rad2deg(R.to_euler(clip.rotations[:, visited].double(), order)).flatten(1)
    rows = torch.cat((clip.root_positions.double() / unit, angles), 1).cpu().numpy()
    lines += ["MOTION", f"Frames: {len(clip)}", f"Frame Time: {1 / clip.fps:.8f}"]
    with atomic_write(path) as file:
        file.write(("\n".join(lines) + "\n").encode())
        np.savetxt(file, rows, fmt="%.6f")


def _text(path: Path) -> bytes:
    """The bytes of a file in UTF-8, with decimal points."""
    try:
        data = files.read(path)
    except OSError as error:
        raise BVHError(f"{path}: cannot be read ({error.strerror})") from error
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.decode("utf-16", errors="replace").encode()
    if b"," in data and not re.search(rb"\d\.\d", data):
        data = re.sub(rb"(?<=\d),(?=\d)", b".", data)
    return data


def _lines(data: bytes) -> list[str]:
    return data.decode(errors="replace").splitlines()


def _hierarchy(path: Path, data: bytes) -> tuple[list[_Joint], int]:
    """Joints and End Sites, parents first, and the offset in bytes behind the word MOTION."""
    motion = _MOTION.search(data)
    lines = _lines(data[: motion.end()] if motion else data)
    first = next((i for i, line in enumerate(lines) if line.lstrip("\ufeff").strip()), 0)
    start = lines[first] if lines else ""
    if not start.lstrip("\ufeff").strip().upper().startswith("HIERARCHY"):
        raise BVHError(f"{path}, line {first + 1}: expected HIERARCHY, got {start[:40]!r}")
    if not motion:
        raise BVHError(f"{path}, line {len(lines)}: the file ends before MOTION")

    joints: list[_Joint] = []
    names: set[str] = set()  # of joints, without End Sites
    inside: list[int] = []  # joints whose braces are open, from the root down
    opening = False  # whether the brace of the last joint is still to come
    for number, words in _statements(lines[first + 1 : -1], first + 2):
        try:
            key = words[0].upper()
            if opening and key != "{":
                got = " ".join(words)[:40]
                raise ValueError(f"expected {{ after joint {joints[-1].name!r}, got {got!r}")
            if key in ("ROOT", "JOINT", "END"):
                joints.append(_joint(words, joints, names, inside))
                opening = True
            elif key == "{" and opening:
                inside.append(len(joints) - 1)
                opening = False
            elif key == "}" and inside:
                inside.pop()
            elif key == "OFFSET" and inside:
                joints[inside[-1]].offset = _offset(words[1:])
            elif key == "CHANNELS" and inside and not joints[inside[-1]].end:
                joints[inside[-1]].channels = _channels(words[1:])
            else:
                raise ValueError(f"unexpected {' '.join(words)[:40]!r}")
        except ValueError as error:
            raise BVHError(f"{path}, line {number}: {error}") from None
    if opening or inside or not joints:
        which = joints[-1 if opening else inside[-1]].name if joints else ""
        problem = f"MOTION inside joint {which!r}, a brace is missing" if joints else "no ROOT"
        raise BVHError(f"{path}, line {len(lines)}: {problem}")

    # The file's numbers are in the order of the channels. End Sites get names that are free.
    row = itertools.count()
    for joint in joints:
        joint.channels = {channel: next(row) for channel in joint.channels}
        if joint.end:
            above = joints[joint.parent].name
            tried = (f"{above}{n}End" for n in itertools.chain(("",), itertools.count(2)))
            joint.name = next(name for name in tried if name not in names)
            names.add(joint.name)
    return joints, motion.end()


def _statements(lines: list[str], first: int) -> Iterator[tuple[int, list[str]]]:
    """Line number and words of every statement; a brace is a statement of its own."""
    for number, line in enumerate(lines, first):
        for part in re.split("([{}])", line) if "{" in line or "}" in line else (line,):
            if words := part.split():
                yield number, words


def _joint(words: list[str], joints: list[_Joint], names: set[str], inside: list[int]) -> _Joint:
    """The joint of a line such as ``JOINT Chest``; ValueError if it cannot stand there."""
    kind, name = words[0].upper(), " ".join(words[1:])
    if kind == "ROOT" and joints and not inside:
        raise ValueError("a second ROOT: the file holds several figures; keep one of them")
    if (kind == "ROOT") == bool(inside):
        raise ValueError(f"unexpected {words[0]}")
    if not name:
        raise ValueError(f"{words[0]} without a name")
    if not shows(name):
        raise ValueError(f"a joint's name has characters that cannot be printed: {name[:40]!r}")
    if inside and joints[inside[-1]].end:
        raise ValueError(f"unexpected {words[0]} inside an End Site")
    if kind != "END" and name in names:
        raise ValueError(f"joint {name} appears twice")
    if len(joints) >= JOINTS:
        raise ValueError(f"more than {JOINTS} joints and End Sites")
    if kind != "END":
        names.add(name)
    return _Joint(name, inside[-1] if inside else -1, kind == "END")


def _offset(words: list[str]) -> list[float]:
    try:
        offset = [float(word) for word in words[:3]]
    except ValueError:
        offset = []
    if len(offset) != 3 or not all(abs(x) < LARGEST for x in offset):
        raise ValueError(f"OFFSET needs three finite numbers, got {' '.join(words)!r}")
    return offset


def _channels(words: list[str]) -> dict[str, int]:
    wanted = dict.fromkeys((word.capitalize() for word in words[1:]), 0)
    counted = words[:1] == [str(len(wanted))] and len(words) == len(wanted) + 1
    if not counted or wanted.keys() - CHANNELS:
        raise ValueError("CHANNELS needs its count and names like Xposition or Yrotation, got "
                         f"{' '.join(words)!r}")
    return wanted


def _numbers(path: Path, data: bytes, start: int, width: int) -> tuple[np.ndarray, float]:
    """The numbers behind MOTION as ``[width, F]``, and frames per second."""

    def fail(end: int, problem: str, below: int = 0) -> BVHError:
        return BVHError(f"{path}, line {len(_lines(data[:end])) + below}: {problem}")

    timing = _TIMING.match(data, start)
    try:
        frames, frame_time = int(timing[1]), float(timing[2])
    except (TypeError, ValueError):
        problem = "expected 'Frames: N' and 'Frame Time: S' after MOTION"
        raise fail(start, problem, below=1) from None
    if not (frame_time > 0 and np.isfinite([frame_time, 1.0 / frame_time]).all()):
        raise fail(timing.end(2), f"frame time must be positive, got {frame_time}")
    fps = _rate(timing[2].decode(errors="replace").strip(), frame_time)

    # Most files hold plain decimals, which a compiled loop reads. It takes two bytes or more for
    # a number: a header that says more frames than the file can hold makes no array.
    if 0 < 2 * frames * width <= len(data):
        from toolkit.io import decimals  # compiled, slow to import

        columns = np.empty((width, frames))
        if decimals.read(np.frombuffer(data, np.uint8), timing.end(), columns):
            return columns, fps

    # Others are read line by line, and the first line that is wrong is named.
    rows = [(n, line) for n, line in enumerate(_lines(data[timing.end() :])) if line.strip()]
    if frames != len(rows) or not frames:
        raise fail(timing.end(1), f"header says {frames} frames, the file holds {len(rows)}")
    read = []
    for below, line in rows:
        words = line.split()
        if len(words) != width:
            raise fail(timing.end(), f"expected {width} numbers, got {len(words)}", below)
        read.append(np.array([_number(word) for word in words]))
        if not (finite := np.isfinite(read[-1])).all():
            i = int(finite.argmin())
            problem = f"channel {i + 1} is not a finite number: {words[i]!r}"
            raise fail(timing.end(), problem, below)
    return np.stack(read, 1), fps


def _number(word: str) -> float:
    """The number that a word is, else NaN; only Python takes 1_000 for a number."""
    try:
        return math.nan if "_" in word else float(word)
    except ValueError:
        return math.nan


def _rate(text: str, frame_time: float) -> float:
    """Frames per second of a frame time, which files round: 0.0333 is 30 Hz, 0.0083 is 120 Hz."""
    fps, last_decimal = 1.0 / frame_time, 10.0 ** -len(text.partition(".")[2])
    if fps > 0.5 and abs(fps - round(fps)) < 0.02:
        return float(round(fps))
    near = min(RATES, key=lambda rate: abs(fps - rate))
    rounded = abs(1 / near - frame_time) < last_decimal and abs(fps / near - 1) < 0.015
    return near if rounded else fps


def _rotations(columns: np.ndarray, joints: list[_Joint]) -> Tensor:
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


def _positions(columns: np.ndarray, joints: list[_Joint]) -> dict[int, np.ndarray]:
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


def _radians(columns: np.ndarray, joints: list[_Joint]) -> tuple[str, ...]:
    """A doubt if a motion's angles are so small that they may be radians."""
    rows = [row for joint in joints for name, row in joint.channels.items() if "rotation" in name]
    some = columns[rows, :: max(1, columns.shape[1] // 16)]
    largest = float(np.abs(some).max(initial=0.0))
    moves = float(np.ptp(some, axis=1).max(initial=0.0))
    if len(rows) < 30 or not (moves > 0.3 and largest < 6.5):
        return ()
    return (f"no joint turns by more than {largest:.2g} degrees: "
            "if the file has radians, convert them",)
