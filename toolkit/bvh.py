"""Biovision Hierarchy files: read and written in metres, seconds and radians, whatever the file's own units and order."""

import io
import os
import tempfile
import warnings
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pandas as pd
import torch

from toolkit import rotations as R
from toolkit.motion import Clip, Skeleton

CENTIMETRE = 0.01


class BVHError(ValueError):
    """A file that is not a readable BVH; the message names the file and the line."""


def load(path: str | os.PathLike, *, unit: float = CENTIMETRE, style: str = "", gait: str = "") -> Clip:
    """Read a BVH file.

    Any channel order, positions on any joint, End Sites and line endings. Position channels replace a joint's OFFSET: where
    they stay constant they become the skeleton's offset; a root that never moves above a joint that does (Bandai-Namco's
    ``joint_Root``) is merged into it. End Sites become leaves named ``<parent>End``.

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
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise BVHError(f"{path}: cannot be read ({error.strerror})") from error
    header, motion, first_line = _split(path, text)
    names, parents, offsets, channels = _parse_hierarchy(path, header)
    values, fps = _parse_motion(path, motion, first_line, sum(len(c) for c in channels))

    frames, n = len(values), len(names)
    rotations = R.identity(frames, n, dtype=torch.float64)
    positions = np.broadcast_to(np.asarray(offsets), (frames, n, 3)).copy()
    column = 0
    for j, names_of_channels in enumerate(channels):
        block = values[:, column : column + len(names_of_channels)]
        column += len(names_of_channels)
        order = "".join(c[0] for c in names_of_channels if c.endswith("rotation"))
        angles = [block[:, i] for i, c in enumerate(names_of_channels) if c.endswith("rotation")]
        for i, c in enumerate(names_of_channels):
            if c.endswith("position"):
                positions[:, j, R.AXES[c[0]]] = block[:, i]
        for axis, angle in zip(order, angles, strict=True):
            turn = R.from_axis_angle(torch.eye(3, dtype=torch.float64)[R.AXES[axis]], torch.from_numpy(np.radians(angle)))
            rotations[:, j] = R.multiply(rotations[:, j], turn)
    positions *= unit

    spread = np.ptp(positions[:, 1:], axis=0).max(-1, initial=0.0) if n > 1 else np.zeros(0)
    moving = {j: s for j, s in enumerate(spread.tolist(), 1) if s > 1e-3}
    root_positions = torch.from_numpy(positions[:, 0].copy())
    if 1 in moving and parents.count(0) == 1:  # the real root hangs below a carrier: merge the two
        root_positions = root_positions + R.rotate(rotations[:, 0], torch.from_numpy(positions[:, 1].copy()))
        rotations = torch.cat((R.multiply(rotations[:, 0], rotations[:, 1])[:, None], rotations[:, 2:]), 1)
        names, parents, positions = names[1:], [p - 1 for p in parents[1:]], positions[:, 1:]
        moving = {j - 1: s for j, s in moving.items() if j > 1}
    if moving:
        joint = max(moving, key=moving.get)
        raise BVHError(f"{path}: joint {names[joint]} changes its distance to its parent by up to "
                       f"{moving[joint] * 1000:.0f} mm; only rigid skeletons are supported")  # fmt: skip
    skeleton = Skeleton(tuple(names), tuple(parents), torch.from_numpy(np.median(positions, axis=0)))
    return Clip(skeleton, R.unroll(rotations), root_positions, fps, style, gait, path.name)


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
    rows = torch.cat((clip.root_positions.double() / unit, angles), 1).numpy()
    lines += ["MOTION", f"Frames: {len(clip)}", f"Frame Time: {1 / clip.fps:.8f}"]
    with atomic_write(path) as file:
        file.write(("\n".join(lines) + "\n").encode())
        np.savetxt(file, rows, fmt="%.6f")


class atomic_write:  # noqa: N801 (used like a function)
    """Context manager: a binary file that takes its name only when it was written whole."""

    def __init__(self, path: str | os.PathLike):
        self.path = Path(path)

    def __enter__(self) -> io.BufferedWriter:
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self.file = tempfile.NamedTemporaryFile(dir=self.path.parent, prefix=f".{self.path.name}.", delete=False)
        return self.file

    def __exit__(self, kind, *_) -> None:
        self.file.close()
        temporary = Path(self.file.name)
        if kind is None:
            mask = os.umask(0)
            os.umask(mask)
            temporary.chmod(0o666 & ~mask)
            temporary.replace(self.path)
        else:
            temporary.unlink(missing_ok=True)


def _split(path: Path, text: str) -> tuple[list[str], list[str], int]:
    """Header lines, motion lines, and the line number of the first motion line."""
    lines = text.splitlines()
    if not lines or not lines[0].lstrip("\ufeff").strip().upper().startswith("HIERARCHY"):
        raise BVHError(f"{path}, line 1: expected HIERARCHY, got {(lines or [''])[0][:40]!r}")
    for i, line in enumerate(lines):
        if line.strip().upper() == "MOTION":
            return lines[1:i], lines[i + 1 :], i + 2
    raise BVHError(f"{path}, line {len(lines)}: the file ends before MOTION")


def _parse_hierarchy(path: Path, lines: list[str]) -> tuple[list[str], list[int], list[list[float]], list[list[str]]]:
    names, parents, offsets, channels, stack = [], [], [], [], []
    joint, waiting = -1, False

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
            name = names[stack[-1]] + "End" if key == "END" else " ".join(words[1:])
            if name in names:
                if key != "END":
                    raise fail(number, f"joint {name} appears twice")
                name = f"{name[:-3]}{sum(n.startswith(name[:-3]) and n.endswith('End') for n in names) + 1}End"
            names.append(name)
            parents.append(stack[-1] if stack else -1)
            offsets.append([0.0, 0.0, 0.0])
            channels.append([])
            joint, waiting = len(names) - 1, True
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
            if len(offsets[stack[-1]]) != 3 or not np.isfinite(offsets[stack[-1]]).all():
                raise fail(number, f"OFFSET needs three finite numbers, got {' '.join(words[1:])!r}")
        elif key == "CHANNELS" and stack:
            known = {f"{a}{kind}" for a in "XYZ" for kind in ("position", "rotation")}
            wanted = words[2:]
            if words[1:2] != [str(len(wanted))] or not set(wanted) <= known or len(set(wanted)) != len(wanted):
                got = " ".join(words[1:])
                raise fail(number, f"CHANNELS needs its count and names like Xposition or Yrotation, got {got!r}")
            channels[stack[-1]] = wanted
        else:
            raise fail(number, f"unexpected {' '.join(words)[:40]!r}")
    if stack or waiting or not names:
        problem = f"MOTION inside joint {names[joint if waiting else stack[-1]]}, a brace is missing" if names else "no ROOT"
        raise fail(len(lines) + 2, problem)
    return names, parents, offsets, channels


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


def _parse_motion(path: Path, lines: list[str], first_line: int, width: int) -> tuple[np.ndarray, float]:
    body = [(first_line + i, text) for i, line in enumerate(lines) if (text := line.strip())]
    try:
        (frames_at, frames_line), (time_at, time_line), *rows = body
        frames, frame_time = int(frames_line.split(":")[1]), float(time_line.split(":")[1])
        if not (frames_line.lower().startswith("frames") and time_line.lower().startswith("frame time")):
            raise ValueError
    except (ValueError, IndexError):
        raise BVHError(f"{path}, line {first_line}: expected 'Frames: N' and 'Frame Time: S' after MOTION") from None
    if not (frame_time > 0 and np.isfinite(frame_time)):
        raise BVHError(f"{path}, line {time_at}: frame time must be positive, got {frame_time}")
    if frames != len(rows) or not frames:
        raise BVHError(f"{path}, line {frames_at}: header says {frames} frames, the file holds {len(rows)}")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            text = io.StringIO("\n".join(line for _, line in rows))
            values = pd.read_csv(text, header=None, sep=r"\s+", dtype=np.float64, na_filter=False).to_numpy()
    except (ValueError, Warning):
        values = np.empty((0, 0))
    if values.shape != (frames, width) or not np.isfinite(values).all():
        raise _first_bad_row(path, rows, width)
    fps = 1.0 / frame_time
    return values, float(round(fps)) if abs(fps - round(fps)) < 0.02 else fps


def _first_bad_row(path: Path, rows: list[tuple[int, str]], width: int) -> BVHError:
    for number, line in rows:
        words = line.split()
        if len(words) != width:
            return BVHError(f"{path}, line {number}: expected {width} numbers, got {len(words)}")
        for i, word in enumerate(words, 1):
            try:
                finite = np.isfinite(float(word))
            except ValueError:
                finite = False
            if not finite:
                return BVHError(f"{path}, line {number}: channel {i} is not a finite number: {word!r}")
    return BVHError(f"{path}, line {rows[0][0]}: the motion block cannot be read")
