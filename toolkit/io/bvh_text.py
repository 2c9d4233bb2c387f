"""The text of a BVH file: its joints, and the numbers behind the word MOTION.

`toolkit.io.bvh` makes motion of them.
"""

import itertools
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from toolkit.io import files
from toolkit.motion.text import shows

JOINTS = 20_000  # of a file, with End Sites
LARGEST = 1e30  # limit of lengths in the file's unit; in any unit float32 holds them
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
class Joint:
    """A joint or an End Site of a file."""

    name: str
    parent: int  # index of a joint, -1 for the root
    end: bool  # whether it is an End Site
    offset: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])  # in the file's unit
    channels: dict[str, int] = field(default_factory=dict)  # "Xposition" …: row of numbers


def contents(path: Path) -> bytes:
    """The bytes of a file in UTF-8, with decimal points."""
    try:
        data = files.read(path)
    except OSError as error:
        raise BVHError(f"{path}: cannot be read ({error.strerror})") from error
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        data = data.decode("utf-16", errors="replace").encode()
    data = data.removeprefix(b"\xef\xbb\xbf")  # UTF-8's mark
    if b"," in data and not re.search(rb"\d\.\d", data):
        data = re.sub(rb"(?<=\d),(?=\d)", b".", data)
    return data


def _lines(data: bytes) -> list[str]:
    return data.decode(errors="replace").splitlines()


def hierarchy(path: Path, data: bytes) -> tuple[list[Joint], int]:
    """Joints and End Sites, parents first, and the offset in bytes behind the word MOTION."""
    motion = _MOTION.search(data)
    lines = _lines(data[: motion.end()] if motion else data)
    first = next((i for i, line in enumerate(lines) if line.strip()), 0)
    start = lines[first] if lines else ""
    if not start.strip().upper().startswith("HIERARCHY"):
        raise BVHError(f"{path}, line {first + 1}: expected HIERARCHY, got {start[:40]!r}")
    if not motion:
        raise BVHError(f"{path}, line {len(lines)}: the file ends before MOTION")

    joints: list[Joint] = []
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
        for part in re.split("([{}])", line) if "{" in line or "}" in line else [line]:
            if words := part.split():
                yield number, words


def _joint(words: list[str], joints: list[Joint], names: set[str], inside: list[int]) -> Joint:
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
    return Joint(name, inside[-1] if inside else -1, kind == "END")


def _offset(words: list[str]) -> list[float]:
    offset = [_number(word) for word in words[:3]]
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


def numbers(path: Path, data: bytes, start: int, width: int) -> tuple[np.ndarray, float]:
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
