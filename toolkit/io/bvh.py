"""Biovision Hierarchy files: read and written in metres, seconds and radians, whatever the file's own units and order."""

import os
import re
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit.io.files import atomic_write
from toolkit.motion import Clip, Skeleton
from toolkit.motion import rotations as R

CENTIMETRE = 0.01
SMALL = 1_000_000  # joints times frames that any file may have
LARGEST = 1e30  # units of length: what a file may say, and what float32 holds in any unit


class BVHError(ValueError):
    """A file that is not a readable BVH; the message names the file and the line."""


def load(path: str | os.PathLike, *, unit: float = CENTIMETRE, style: str = "", gait: str = "") -> Clip:
    """Read a BVH file.

    Any channel order, positions on any joint, End Sites and line endings. Position channels replace a joint's OFFSET: where
    they stay constant they become the skeleton's offset; a root that never moves above a joint that does (Bandai-Namco's
    ``joint_Root``) is merged into it. End Sites become leaves named ``<parent>End``, ``<parent>2End`` and so on.

    Parameters
    ----------
    path
        The file.
    unit
        Metres of one unit of length in the file.
    style, gait
        Labels for the clip.

    Raises
    ------
    BVHError
        If the file is truncated, its frame count is wrong, a number is missing or not finite, or the text is no BVH.
    """
    path = Path(path)
    try:
        data = path.read_bytes()
    except OSError as error:
        raise BVHError(f"{path}: cannot be read ({error.strerror})") from error
    header, motion = _split(path, data)
    names, parents, offsets, channels, ends = _parse_hierarchy(path, header)
    columns, fps = _parse_motion(path, data, motion, sum(len(c) for c in channels))

    if len(names) * columns.shape[1] > max(len(data), SMALL):  # joints without channels cost the file nothing
        size = f"{len(names)} joints in {columns.shape[1]} frames"
        raise BVHError(f"{path}: {size}, of which only {len(columns)} channels move")
    rotations, offsets = _rotations(torch.from_numpy(columns), channels), np.asarray(offsets) * unit
    positions = _positions(columns, channels, offsets, unit)
    for j, moves in positions.items():
        if not (np.abs(moves) < LARGEST * unit).all():
            raise BVHError(f"{path}: the positions of joint {names[j]} are not of this world, beyond {LARGEST:g}")
    for j, moves in positions.items():
        offsets[j] = np.median(moves, axis=0)
    spread = {j: float(np.ptp(moves, axis=0).max()) for j, moves in positions.items() if j}
    moving = {j: s for j, s in spread.items() if s > 1e-3}
    root_positions = torch.from_numpy(positions[0])
    if 1 in moving and parents.count(0) == 1:  # the real root hangs below a carrier: merge the two
        root_positions = root_positions + R.rotate(rotations[:, 0].double(), torch.from_numpy(positions[1]))
        rotations = torch.cat((R.multiply(rotations[:, 0], rotations[:, 1])[:, None], rotations[:, 2:]), 1)
        names, parents, offsets = names[1:], [p - 1 for p in parents[1:]], offsets[1:]
        moving = {j - 1: s for j, s in moving.items() if j > 1}
    if moving:
        joint = max(moving, key=moving.get)
        raise BVHError(f"{path}: joint {names[joint]} changes its distance to its parent by up to "
                       f"{moving[joint] * 1000:.0f} mm; only rigid skeletons are supported")
    skeleton = Skeleton(tuple(names), tuple(parents), offsets, ends=tuple(ends))
    try:
        return Clip(skeleton, R.unroll(rotations), root_positions, fps, style, gait, path.name)
    except ValueError as error:
        raise BVHError(f"{path}: {str(error).removeprefix(path.name + ': ')}") from error


def save(clip: Clip, path: str | os.PathLike, *, unit: float = CENTIMETRE, order: str = "YXZ") -> None:
    """Write a BVH file, whole or not at all.

    Parameters
    ----------
    clip
        The motion.
    path
        The file to write.
    unit
        Metres of one unit of length in the file (0.01: centimetres, as in all common datasets).
    order
        Rotation channels of every joint; the default is 100STYLE's.
    """
    skeleton = clip.skeleton
    lines = ["HIERARCHY"]
    children = [[c for c, p in enumerate(skeleton.parents) if p == j] for j in range(len(skeleton))]
    visited = []

    def write(joint: int, depth: int) -> None:
        tab = "\t" * depth
        end = skeleton.is_end(joint)
        lines.append(f"{tab}End Site" if end else f"{tab}{'JOINT' if depth else 'ROOT'} {skeleton.names[joint]}")
        lines.append(tab + "{")
        offset = skeleton.offsets[joint].double() / unit if depth else torch.zeros(3)
        lines.append(f"{tab}\tOFFSET " + " ".join(f"{v:.6f}" for v in offset.tolist()))
        if not end:
            visited.append(joint)
            channels = [f"{a}rotation" for a in order]
            channels = channels if depth else [f"{a}position" for a in "XYZ"] + channels
            lines.append(f"{tab}\tCHANNELS {len(channels)} {' '.join(channels)}")
        for child in children[joint]:
            write(child, depth + 1)
        lines.append(tab + "}")

    write(0, 0)
    angles = torch.rad2deg(R.to_euler(clip.rotations[:, visited].double(), order)).flatten(1)
    rows = torch.cat((clip.root_positions.double() / unit, angles), 1).cpu().numpy()
    lines += ["MOTION", f"Frames: {len(clip)}", f"Frame Time: {1 / clip.fps:.8f}"]
    with atomic_write(path) as file:
        file.write(("\n".join(lines) + "\n").encode())
        np.savetxt(file, rows, fmt="%.6f")


_MOTION = re.compile(rb"[\r\n][^\S\r\n]*MOTION[^\S\r\n]*(?=[\r\n]|\Z)", re.IGNORECASE)
_TIMING = re.compile(rb"\s*Frames[^\r\n:]*:([^\r\n]*)[\r\n]\s*Frame Time[^\r\n:]*:([^\r\n]*)", re.IGNORECASE)


def _lines(data: bytes) -> list[str]:
    return data.decode(errors="replace").splitlines()


def _split(path: Path, data: bytes) -> tuple[list[str], int]:
    """Header lines, and where MOTION ends."""
    motion = _MOTION.search(data)
    lines = _lines(data[: motion.end()] if motion else data)
    if not lines or not lines[0].lstrip("\ufeff").strip().upper().startswith("HIERARCHY"):
        raise BVHError(f"{path}, line 1: expected HIERARCHY, got {(lines or [''])[0][:40]!r}")
    if not motion:
        raise BVHError(f"{path}, line {len(lines)}: the file ends before MOTION")
    return lines[1:-1], motion.end()


def _parse_hierarchy(path: Path, lines: list[str]) -> tuple[list[str], list[int], list[list[float]], list[list[str]],
                                                            list[str]]:
    """Names, parents, offsets and channels of all points, and the names of the End Sites among them."""
    names, parents, offsets, channels, stack = [], [], [], [], []
    joint, waiting, ends, taken = -1, False, set(), set()

    def fail(number: int, problem: str) -> BVHError:
        return BVHError(f"{path}, line {number}: {problem}")

    for number, words in _words(lines):
        key = words[0].upper()
        if waiting and key != "{":
            raise fail(number, f"expected {{ after joint {names[-1]}, got {' '.join(words)[:40]!r}")
        if key in ("ROOT", "JOINT", "END"):
            if (key != "ROOT" and not stack) or (key == "ROOT" and names):
                raise fail(number, f"unexpected {words[0]}")
            if len(words) < 2:
                raise fail(number, f"{words[0]} without a name")
            if not "".join(words).isprintable():
                raise fail(number, f"a joint's name has characters that cannot be printed: {' '.join(words[1:])[:40]!r}")
            if stack and stack[-1] in ends:
                raise fail(number, f"unexpected {words[0]} inside an End Site")
            name = names[stack[-1]] + "End" if key == "END" else " ".join(words[1:])
            if key != "END" and name in taken:
                raise fail(number, f"joint {name} appears twice")
            names.append(name)
            parents.append(stack[-1] if stack else -1)
            offsets.append([0.0, 0.0, 0.0])
            channels.append([])
            joint, waiting = len(names) - 1, True
            if key == "END":
                ends.add(joint)
            else:
                taken.add(name)
        elif key == "{":
            if not waiting:
                raise fail(number, "unexpected {")
            stack.append(joint)
            waiting = False
        elif key == "}":
            if not stack:
                raise fail(number, "unexpected }")
            stack.pop()
        elif key == "OFFSET" and stack:
            try:
                offsets[stack[-1]] = [float(w) for w in words[1:4]]
            except ValueError:
                raise fail(number, f"OFFSET needs three numbers, got {' '.join(words[1:])!r}") from None
            if len(offsets[stack[-1]]) != 3 or not all(abs(x) < LARGEST for x in offsets[stack[-1]]):
                raise fail(number, f"OFFSET needs three finite numbers, got {' '.join(words[1:])!r}")
        elif key == "CHANNELS" and stack and stack[-1] not in ends:
            known = {f"{a}{kind}" for a in "XYZ" for kind in ("position", "rotation")}
            wanted = [word.capitalize() for word in words[2:]]
            if words[1:2] != [str(len(wanted))] or not set(wanted) <= known or len(set(wanted)) != len(wanted):
                got = " ".join(words[1:])
                raise fail(number, f"CHANNELS needs its count and names like Xposition or Yrotation, got {got!r}")
            channels[stack[-1]] = wanted
        else:
            raise fail(number, f"unexpected {' '.join(words)[:40]!r}")
    if stack or waiting or not names:
        problem = f"MOTION inside joint {names[joint if waiting else stack[-1]]}, a brace is missing" if names else "no ROOT"
        raise fail(len(lines) + 2, problem)
    for j in sorted(ends):  # after all joints, which keep their names
        tried = (f"{names[parents[j]]}{number}End" for number in ("", *range(2, len(names) + 2)))
        names[j] = next(name for name in tried if name not in taken)
        taken.add(names[j])
    return names, parents, offsets, channels, [names[j] for j in sorted(ends)]


def _words(lines: list[str]) -> Iterator[tuple[int, list[str]]]:
    """Words of the header by line; braces stand alone even where a file writes them behind a name."""
    for number, line in enumerate(lines, 2):
        words = line.replace("{", " { ").replace("}", " } ").split()
        run: list[str] = []
        for word in words:
            if word in "{}":
                if run:
                    yield number, run
                yield number, [word]
                run = []
            else:
                run.append(word)
        if run:
            yield number, run


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
        read = []  # not one array of a size that the file only claims
        for below, line in rows:
            try:
                read.append(np.array(_numbers(line, width)))
            except ValueError as error:
                raise fail(timing.end(), str(error), below) from None
        columns = np.stack(read, 1)
    fps = 1.0 / frame_time
    return columns, float(round(fps)) if abs(fps - round(fps)) < 0.02 else fps


def _numbers(line: str, width: int) -> list[float]:
    words, numbers = line.split(), []
    if len(words) != width:
        raise ValueError(f"expected {width} numbers, got {len(words)}")
    for i, word in enumerate(words, 1):
        try:
            numbers.append(float(word.replace("_", "?")))  # Python alone reads 1_000
        except ValueError:
            numbers.append(np.nan)
        if not np.isfinite(numbers[-1]):
            raise ValueError(f"channel {i} is not a finite number: {word!r}")
    return numbers


def _rotations(columns: Tensor, channels: list[list[str]]) -> Tensor:
    """Local rotations ``[F, J, 4]``; joints that turn in the same order are done at once."""
    rotations = R.identity(columns.shape[1], len(channels))
    alike, first = defaultdict(dict), 0
    for j, names in enumerate(channels):
        turns = {c[0]: i for i, c in enumerate(names, first) if c.endswith("rotation")}
        if turns:
            alike["".join(turns)][j] = list(turns.values())
        first += len(names)
    for order, turns in alike.items():
        order += "".join(axis for axis in "XYZ" if axis not in order)
        for start in range(0, columns.shape[1], 2048):  # a few MB at a time
            part = columns[:, start : start + 2048]
            angles = torch.zeros(3, len(turns), part.shape[1])
            for i, places in enumerate(zip(*turns.values(), strict=True)):
                angles[i] = torch.deg2rad(part[list(places)])
            rotations[start : start + 2048, list(turns)] = R.from_euler(angles.permute(2, 1, 0), order)
    return rotations


def _positions(columns: np.ndarray, channels: list[list[str]], offsets: np.ndarray, unit: float) -> dict[int, np.ndarray]:
    """Metres ``[F, 3]`` from the parent, of the root and of every joint with position channels."""
    positions, first = {}, 0
    for j, names in enumerate(channels):
        moves = {R.AXES[c[0]]: i for i, c in enumerate(names, first) if c.endswith("position")}
        if moves or not j:
            positions[j] = np.repeat(offsets[j : j + 1], columns.shape[1], axis=0)
            positions[j][:, list(moves)] = columns[list(moves.values())].T * unit
        first += len(names)
    return positions
