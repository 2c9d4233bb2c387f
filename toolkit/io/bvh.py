"""BVH files: read and written in metres, seconds and radians, whatever unit and channel order the file has."""

import itertools
import os
import re
from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit.io import files, interpretation
from toolkit.io.files import atomic_write
from toolkit.io.recording import Recording
from toolkit.motion import Clip
from toolkit.motion import names as names_
from toolkit.motion import rotations as R

CENTIMETRE = 0.01
JOINTS = 20_000  # of a file, with End Sites
SMALL = 1_000_000  # joints times frames that a file of any size may have
LARGEST = 1e30  # limit of lengths in the file's unit; in any unit float32 holds them
MOVED = 2.5e-3  # of the longest bone: a change of a joint's distance to its parent that is no rounding
RATES = (24.0, 25.0, 30.0, 48.0, 50.0, 60.0, 72.0, 75.0, 90.0, 100.0, 120.0, 144.0, 180.0, 200.0, 240.0, 250.0)  # usual ones
CHANNELS = frozenset(f"{axis}{kind}" for axis in "XYZ" for kind in ("position", "rotation"))
_MOTION = re.compile(rb"[\r\n][^\S\r\n]*MOTION[^\S\r\n]*(?=[\r\n]|\Z)", re.IGNORECASE)
_POINT, _COMMA = re.compile(rb"\d\.\d"), re.compile(rb"(?<=\d),(?=\d)")  # decimals
_TIMING = re.compile(rb"\s*Frames[^\r\n:]*:([^\r\n]*)[\r\n]\s*Frame Time[^\r\n:]*:([^\r\n]*)", re.IGNORECASE)


class BVHError(ValueError):
    """A file that cannot be read as BVH; the message names the file and the line."""


def load(path: str | os.PathLike, *, unit: float | str = "auto", up: str = "auto", roles: Mapping[str, str] | None = None,
         style: str = "", gait: str = "") -> Clip:
    """Read a BVH file as `toolkit.load` does; with ``unit`` and ``up`` given, nothing is guessed.

    Parameters
    ----------
    path : the file
    unit : metres of one unit of length in the file, or "auto"
    up : the file's axis that points up: "x", "y", "z", "-x", "-y", "-z", or "auto"
    roles : joints by role (`toolkit.motion.ROLES`), where names and tree do not show them
    style, gait : labels for the clip

    Raises
    ------
    BVHError
        If the file is not BVH or truncated, its frame count is wrong, or a number is missing or not finite.
    ValueError
        If unit, up or roles do not fit.
    """
    recording = read(path)
    try:
        return interpretation.load(recording, Path(path), unit, up, roles, style, gait)
    except ValueError as error:
        raise BVHError(f"{path}: {str(error).removeprefix(f'{Path(path).name}: ')}") from error


def read(path: str | os.PathLike) -> Recording:
    """The motion in a BVH file, in its own unit and axes.

    Channels may have any order, and any joint may have positions. Position channels replace a joint's OFFSET, or add to it
    in files where all of them stay near zero, as MakeHuman's do; where they are constant they become the skeleton's offset.
    A root whose only child moves relative to it (Bandai-Namco's ``joint_Root``) is merged with that child. End Sites become
    leaves named ``<parent>End``, ``<parent>2End`` and so on.

    Raises
    ------
    BVHError
        As `load`.
    """
    path = Path(path)
    try:
        data = files.read(path)
    except OSError as error:
        raise BVHError(f"{path}: cannot be read ({error.strerror})") from error
    if data[:2] in (b"\xff\xfe", b"\xfe\xff"):
        data = data.decode("utf-16", errors="replace").encode()
    if b"," in data and not _POINT.search(data):
        data = _COMMA.sub(b".", data)
    header, motion = _split(path, data)
    names, parents, offsets, channels, ends = _parse_hierarchy(path, header)
    columns, fps = _parse_motion(path, data, motion, sum(len(c) for c in channels))
    if len(names) * columns.shape[1] > max(len(data), SMALL):  # joints without channels take no bytes per frame
        raise BVHError(f"{path}: {len(names)} joints in {columns.shape[1]} frames, but only {len(columns)} channels")
    number = itertools.count()
    rows = [{channel: next(number) for channel in of_joint} for of_joint in channels]  # of columns
    rotations, offsets = _rotations(columns, rows), np.asarray(offsets)
    placed, positions = _positions(columns, rows, offsets)
    if not (near := (np.abs(positions) < LARGEST).all((1, 2))).all():
        raise BVHError(f"{path}: positions of joint {names[placed[near.argmin()]]} are beyond {LARGEST:g} units")
    doubts = _radians(columns, rows)
    del data, columns  # five times the bytes of the file
    offsets[placed] = np.median(positions, axis=1)
    limit = MOVED * max(np.linalg.norm(offsets[1:], axis=1), default=0.0)
    spreads = zip(placed[1:], np.ptp(positions[1:], axis=1).max(1, initial=0.0).tolist(), strict=True)
    moving = {j: spread for j, spread in spreads if spread > limit}
    root_positions = torch.from_numpy(positions[0])
    if 1 in moving and parents.count(0) == 1:  # the joint below the root moves: merge the two
        root_positions = root_positions + R.rotate(rotations[:, 0].double(), torch.from_numpy(positions[placed.index(1)]))
        rotations = torch.cat((R.unroll(R.multiply(rotations[:, 0], rotations[:, 1]))[:, None], rotations[:, 2:]), 1)
        names, parents, offsets = names[1:], [p - 1 for p in parents[1:]], offsets[1:]
        moving = {j - 1: s for j, s in moving.items() if j > 1}
    if moving:
        joint = max(moving, key=moving.get)
        raise BVHError(f"{path}: joint {names[joint]} changes its distance to its parent by up to {moving[joint]:.4g} units "
                       "of the file; only rigid skeletons are supported")
    return Recording("BVH", tuple(names), tuple(parents), torch.from_numpy(offsets), rotations, root_positions,
                     fps, tuple(ends), doubts=doubts)


def _radians(columns: np.ndarray, rows: list[dict[str, int]]) -> tuple[str, ...]:
    """A doubt if a motion's angles are so small that they may be radians."""
    turns = [i for channels in rows for c, i in channels.items() if c.endswith("rotation")]
    some = columns[turns, :: max(1, columns.shape[1] // 16)]
    largest, moves = float(np.abs(some).max(initial=0.0)), float(np.ptp(some, axis=1).max(initial=0.0))
    if len(turns) < 30 or not (moves > 0.3 and largest < 6.5):
        return ()
    return (f"no joint turns by more than {largest:.2g} degrees: if the file has radians, convert them",)


def save(clip: Clip, path: str | os.PathLike, *, unit: float = CENTIMETRE, order: str = "YXZ") -> None:
    """Write a BVH file, whole or not at all.

    ``unit`` is the length of one unit in the file, metres. ``order`` is that of every joint's rotation channels. ValueError
    for a joint's name that would be read differently: with braces, or with spaces that are not single ones within it.
    """
    skeleton, lines, visited = clip.skeleton, ["HIERARCHY"], []
    if wrong := [name for name in skeleton.names if name != " ".join(name.split()) or "{" in name or "}" in name]:
        raise ValueError(f"{clip.name}: a BVH file cannot hold the joint name {wrong[0]!r}; rename it")
    children = defaultdict(list)
    for joint, parent in enumerate(skeleton.parents):
        children[parent].append(joint)
    waiting = [(0, 0)]  # joints to write with their depths, and (-1, depth) for a closing brace; the last comes first
    while waiting:
        joint, depth = waiting.pop()
        if joint < 0:
            lines.append("\t" * depth + "}")
            continue
        tab, end = "\t" * depth, skeleton.is_end(joint)
        offset = (skeleton.offsets[joint].double() / unit if depth else torch.zeros(3)).tolist()
        lines.append(f"{tab}End Site" if end else f"{tab}{'JOINT' if depth else 'ROOT'} {skeleton.names[joint]}")
        lines.extend((tab + "{", f"{tab}\tOFFSET " + " ".join(f"{v:.6f}" for v in offset)))
        if not end:
            visited.append(joint)
            channels = [f"{a}position" for a in ("" if depth else "XYZ")] + [f"{a}rotation" for a in order]
            lines.append(f"{tab}\tCHANNELS {len(channels)} {' '.join(channels)}")
        waiting += [(-1, depth), *((child, depth + 1) for child in reversed(children[joint]))]
    angles = torch.rad2deg(R.to_euler(clip.rotations[:, visited].double(), order)).flatten(1)
    rows = torch.cat((clip.root_positions.double() / unit, angles), 1).cpu().numpy()
    lines += ["MOTION", f"Frames: {len(clip)}", f"Frame Time: {1 / clip.fps:.8f}"]
    with atomic_write(path) as file:
        file.write(("\n".join(lines) + "\n").encode())
        np.savetxt(file, rows, fmt="%.6f")


def _lines(data: bytes) -> list[str]:
    return data.decode(errors="replace").splitlines()


def _split(path: Path, data: bytes) -> tuple[list[str], int]:
    """Header lines, and the offset in bytes behind MOTION."""
    motion = _MOTION.search(data)
    lines = _lines(data[: motion.end()] if motion else data)
    first = next((i for i, line in enumerate(lines) if line.lstrip("\ufeff").strip()), 0)
    if not lines or not lines[first].lstrip("\ufeff").strip().upper().startswith("HIERARCHY"):
        raise BVHError(f"{path}, line {first + 1}: expected HIERARCHY, got {(lines or [''])[first][:40]!r}")
    if not motion:
        raise BVHError(f"{path}, line {len(lines)}: the file ends before MOTION")
    return [""] * first + lines[first + 1 : -1], motion.end()


def _parse_hierarchy(path: Path, lines: list[str]) -> tuple[list[str], list[int], list[list], list[list[str]], list[str]]:
    """Names, parents, offsets and channels of all joints and End Sites, and the names of the End Sites."""
    names, parents, offsets, channels, stack = [], [], [], [], []
    waiting, ends, taken = False, set(), set()

    def fail(number: int, problem: str) -> BVHError:
        return BVHError(f"{path}, line {number}: {problem}")

    statements = ((number, part.split()) for number, line in enumerate(lines, 2)
                  for part in (re.split("([{}])", line) if "{" in line or "}" in line else (line,)) if part.strip())
    for number, words in statements:
        key = words[0].upper()
        if waiting and key != "{":
            raise fail(number, f"expected {{ after joint {names[-1]!r}, got {' '.join(words)[:40]!r}")
        if key in ("ROOT", "JOINT", "END"):
            if key == "ROOT" and names and not stack:
                raise fail(number, "a second ROOT: the file holds several figures; keep one of them")
            if (key == "ROOT") == bool(stack):
                raise fail(number, f"unexpected {words[0]}")
            if len(words) < 2:
                raise fail(number, f"{words[0]} without a name")
            name = " ".join(words[1:])
            if not names_.shows(name):
                raise fail(number, f"a joint's name has characters that cannot be printed: {name[:40]!r}")
            if stack and stack[-1] in ends:
                raise fail(number, f"unexpected {words[0]} inside an End Site")
            if key == "END":
                name = names[stack[-1]] + "End"
                ends.add(len(names))
            elif name in taken:
                raise fail(number, f"joint {name} appears twice")
            else:
                taken.add(name)
            if len(names) >= JOINTS:
                raise fail(number, f"more than {JOINTS} joints and End Sites")
            names.append(name)
            parents.append(stack[-1] if stack else -1)
            offsets.append([0.0, 0.0, 0.0])
            channels.append([])
            waiting = True
        elif key == "{" and waiting:
            stack.append(len(names) - 1)
            waiting = False
        elif key == "}" and stack:
            stack.pop()
        elif key == "OFFSET" and stack:
            try:
                offsets[stack[-1]] = [float(w) for w in words[1:4]]
            except ValueError:
                offsets[stack[-1]] = []
            if len(offsets[stack[-1]]) != 3 or not all(abs(x) < LARGEST for x in offsets[stack[-1]]):
                raise fail(number, f"OFFSET needs three finite numbers, got {' '.join(words[1:])!r}")
        elif key == "CHANNELS" and stack and stack[-1] not in ends:
            wanted = [word.capitalize() for word in words[2:]]
            if words[1:2] != [str(len(wanted))] or not CHANNELS.issuperset(wanted) or len(set(wanted)) != len(wanted):
                raise fail(number, "CHANNELS needs its count and names like Xposition or Yrotation, got "
                           f"{' '.join(words[1:])!r}")
            channels[stack[-1]] = wanted
        else:
            raise fail(number, f"unexpected {' '.join(words)[:40]!r}")
    if stack or waiting or not names:
        problem = f"MOTION inside joint {names[-1 if waiting else stack[-1]]!r}, a brace is missing" if names else "no ROOT"
        raise fail(len(lines) + 2, problem)
    numbers = defaultdict(lambda: itertools.chain(("",), itertools.count(2)))  # of the End Sites of each joint
    for j in sorted(ends):  # after all joints, which keep their names
        tried = (f"{names[parents[j]]}{number}End" for number in numbers[parents[j]])
        names[j] = next(name for name in tried if name not in taken)
        taken.add(names[j])
    return names, parents, offsets, channels, [names[j] for j in sorted(ends)]


def _parse_motion(path: Path, data: bytes, start: int, width: int) -> tuple[np.ndarray, float]:
    """Channels ``[width, F]`` and frames per second."""

    def fail(end: int, problem: str, below: int = 0) -> BVHError:
        return BVHError(f"{path}, line {len(_lines(data[:end])) + below}: {problem}")

    timing = _TIMING.match(data, start)
    try:
        frames, frame_time = int(timing[1]), float(timing[2])
    except (TypeError, ValueError):
        raise fail(start, "expected 'Frames: N' and 'Frame Time: S' after MOTION", below=1) from None
    if not (frame_time > 0 and np.isfinite([frame_time, 1.0 / frame_time]).all()):
        raise fail(timing.end(2), f"frame time must be positive, got {frame_time}")
    from toolkit.io import decimals  # compiled, slow to import

    columns = np.empty((width, frames if 0 < 2 * frames * width <= len(data) else 0))  # a number takes two bytes or more
    if not (columns.size and decimals.read(np.frombuffer(data, np.uint8), timing.end(), columns)):
        rows = [(below, line) for below, line in enumerate(_lines(data[timing.end() :])) if line.strip()]
        if frames != len(rows) or not frames:
            raise fail(timing.end(1), f"header says {frames} frames, the file holds {len(rows)}")
        read = []  # no array of the size that the header claims: the file may be shorter
        for below, line in rows:
            words, numbers = line.split(), []
            if len(words) != width:
                raise fail(timing.end(), f"expected {width} numbers, got {len(words)}", below)
            for i, word in enumerate(words, 1):
                try:
                    numbers.append(float(word.replace("_", "?")))  # only Python accepts 1_000
                except ValueError:
                    numbers.append(np.nan)
                if not np.isfinite(numbers[-1]):
                    raise fail(timing.end(), f"channel {i} is not a finite number: {word!r}", below)
            read.append(np.array(numbers))
        columns = np.stack(read, 1)
    return columns, _rate(timing[2].decode(errors="replace").strip(), frame_time)


def _rate(text: str, frame_time: float) -> float:
    """Frames per second of a frame time, which files round: 0.033333 and 0.0333 are 30 Hz, 0.0083 is 120 Hz."""
    fps, unit = 1.0 / frame_time, 10.0 ** -len(text.partition(".")[2])  # of the last decimal
    if fps > 0.5 and abs(fps - round(fps)) < 0.02:
        return float(round(fps))
    near = min(RATES, key=lambda rate: abs(fps - rate))
    return near if abs(1 / near - frame_time) < unit and abs(fps / near - 1) < 0.015 else fps


def _rotations(columns: np.ndarray, rows: list[dict[str, int]]) -> Tensor:
    """Local rotations ``[F, J, 4]``; joints with the same channel order are converted together."""
    from toolkit.io import decimals  # compiled, slow to import

    rotations, alike = R.identity(columns.shape[1], len(rows)), defaultdict(dict)
    for j, channels in enumerate(rows):
        if turns := {c[0]: i for c, i in channels.items() if c.endswith("rotation")}:
            order = "".join(turns)
            alike[order + "".join(axis for axis in "XYZ" if axis not in order)][j] = list(turns.values())
    turns = sorted(i for group in alike.values() for own in group.values() for i in own)
    place = {i: n for n, i in enumerate(turns)}
    still = len(turns)  # row of an axis without a channel
    groups = [(tuple(R.AXES[axis] for axis in order), np.array(list(group)),
               np.array([[place[i] for i in own] + [still] * (3 - len(own)) for own in group.values()]))
              for order, group in alike.items()]
    if turns and turns[-1] - turns[0] == still - 1:
        turns = slice(turns[0], turns[-1] + 1)  # without a copy
    for start in range(0, columns.shape[1] if groups else 0, 2048):  # a few MB at a time
        part = columns[turns, start : start + 2048]
        halves = np.zeros((still + 1, part.shape[1]), np.float32)
        with np.errstate(over="ignore"):  # rotations that are not finite are refused later
            np.multiply(part, np.pi / 360, out=halves[:-1], casting="same_kind")
        cosines, sines = torch.from_numpy(halves).cos().numpy(), torch.from_numpy(halves).sin_().numpy()
        for axes, joints, of in groups:
            decimals.compose(cosines, sines, of, axes, joints, rotations.numpy(), start)
    return rotations


def _positions(columns: np.ndarray, rows: list[dict[str, int]], offsets: np.ndarray) -> tuple[list[int], np.ndarray]:
    """The root and every joint with position channels, and their positions ``[N, F, 3]`` relative to the parent."""
    placed = [j for j, channels in enumerate(rows) if not j or any(c.endswith("position") for c in channels)]
    positions = np.repeat(offsets[placed][:, None], columns.shape[1], axis=1)
    for n, j in enumerate(placed):
        moves = {R.AXES[c[0]]: i for c, i in rows[j].items() if c.endswith("position")}
        positions[n][:, list(moves)] = columns[list(moves.values())].T
    if len(placed) > 1:
        below = offsets[placed[1:]]
        if np.abs(np.median(positions[1:], axis=1)).sum() < 0.1 * np.abs(below).sum():  # relative to OFFSET
            positions[1:] += below[:, None]
    return placed, positions
