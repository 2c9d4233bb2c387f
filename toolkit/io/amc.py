"""Acclaim files: the motion of an .amc file on the skeleton of its .asf file (CMU's motion capture library).

Each bone has an axis frame C, given by angles in world axes. Its rotation M is composed of the angles of its degrees of
freedom, the first one applied first. The bone's world rotation is G = G(parent) · C · M · C⁻¹, and it reaches from its
parent's end along G · direction · length (Lander 1998, "Working with motion capture file formats").
"""

import os
import re
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit.io import files
from toolkit.io.recording import Recording
from toolkit.motion import rotations as R

CMU = 120.0  # frames per second of CMU's recordings; the files do not say
CMU_LENGTH, INCH = 0.45, 0.0254  # in CMU's files one unit is 1 / 0.45 inches
ORDER = ("tx", "ty", "tz", "rx", "ry", "rz")  # of the root's numbers, by default
LARGEST = 1e30  # limit of lengths and angles
BONES, BYTES = 10_000, 5_000_000  # limits for the bones and the size of an .asf file
SMALL = 1_000_000  # joints and End Sites times frames that a file of any size may have
LIMBS = {"shoulder": "humerus", "elbow": "radius", "hand": "wrist", "hip": "femur", "knee": "tibia", "foot": "foot",
         "toe": "toes"}  # our roles to Vicon's bones, which begin with l or r
_NAME = re.compile(rb"^[^\S\n]*([A-Za-z_][^\s]*)", re.MULTILINE)
_FRAME = re.compile(rb"^[^\S\n]*\d+[^\S\n]*$", re.MULTILINE)


def read(path: str | os.PathLike, asf: str | os.PathLike | None = None, fps: float | None = None) -> Recording:
    """Read an .amc file, or the rest pose of an .asf file as one frame.

    A joint stands where its bone begins and has the bone's name; the last bone of a chain also has an End Site.

    Parameters
    ----------
    path, asf
        The .amc file and its skeleton; by default the .asf file of the same name, of the part of the name before the first
        ``_`` (02.asf for 02_01.amc), or the only one in the folder.
    fps
        Frames per second, which the file does not say; by default 120, as CMU's.

    Raises
    ------
    ValueError
        If there is no skeleton, a file is damaged, or a bone changes its length.
    """
    path = Path(path)
    rest = path.suffix.lower() == ".asf"
    with files.named(path):
        skeleton = path if rest else Path(asf) if asf is not None else _beside(path)
        with files.named(path if rest else f"{path}: its skeleton {skeleton}"):
            if skeleton.stat().st_size > BYTES:
                raise ValueError(f"a skeleton should not have more than {BYTES} bytes")
            bones = _Skeleton(files.read(skeleton))
        angles, in_degrees = (np.zeros((bones.width, 1)), True) if rest else _motion(files.read(path), bones)
        said = "an ASF file has no motion: its rest pose was read" if rest else None if fps else (
            f"an AMC file has no frame rate; {CMU:g} Hz was assumed, as in CMU's recordings")
        return bones.recording(torch.from_numpy(angles), in_degrees, fps or CMU, said)


def _beside(path: Path) -> Path:
    """The .asf file that belongs to an .amc file."""
    found = {p.stem.lower(): p for p in sorted(path.parent.iterdir()) if p.suffix.lower() == ".asf"}
    stem = path.stem.lower()
    for name in (stem, stem.split("_")[0]):
        if name in found:
            return found[name]
    if len(found) == 1:
        return next(iter(found.values()))
    raise ValueError(f"needs its skeleton; put {path.stem.split('_')[0]}.asf beside it, or give asf=")


class _Skeleton:
    """Root and bones of an .asf file."""

    def __init__(self, data: bytes):
        sections, key = {}, None
        for line in data.decode(errors="replace").splitlines():
            line = line.split("#", 1)[0].strip()
            if line.startswith(":"):
                key, *first = line[1:].split(None, 1)
                key = key.lower()
                sections[key] = first
            elif line and key:
                sections[key].append(line)
        if missing := [key for key in ("root", "bonedata", "hierarchy") if key not in sections]:
            raise ValueError(f"no section :{missing[0]}")
        units = _fields(sections.get("units", []))
        self.length = _numbers(units.get("length", ["1"]), 1, "length")[0]
        self.degrees = not units.get("angle", ["deg"])[0].lower().startswith("rad")
        if self.length <= 0:
            raise ValueError(f"the unit of length must be positive, got {self.length:g}")
        root = _fields(sections["root"])
        order = [word.lower() for word in root.get("order", [*ORDER])]
        place = _numbers(root.get("position", ["0"] * 3), 3, "position")
        turn = _numbers(root.get("orientation", ["0"] * 3), 3, "orientation")
        axis = root.get("axis", ["XYZ"])[0]
        self.names, self.dofs, self.frames = ["root"], [_dof(order, "the root")], [self._frame(turn, axis)]
        self.bones, self.place = [np.zeros(3)], np.array(place)
        self._read_bones(sections["bonedata"])
        self._link(sections["hierarchy"])
        self.width = sum(map(len, self.dofs))

    def _frame(self, angles: list[float], order: str) -> Tensor:
        """Rotation ``[4]`` of angles about world axes in their order."""
        order = order.upper()
        if sorted(order) != ["X", "Y", "Z"]:
            raise ValueError(f"expected an order of axes like XYZ, got {order[:10]!r}")
        angles = torch.tensor(angles, dtype=torch.float64)
        angles = torch.deg2rad(angles) if self.degrees else angles
        return R.from_euler(angles.flip(0), order[::-1])

    def _read_bones(self, lines: list[str]) -> None:
        bone, taken = None, {"root"}
        for line in lines:
            key, *words = line.split()
            key = key.lower()
            if key == "begin":
                bone = {}
            elif key == "end" and bone is not None:
                name = " ".join(bone.get("name", []))
                if not name.isprintable() or not name or name in taken or len(self.names) == BONES:
                    raise ValueError(f"a bone without a name of its own: {name[:40]!r}")
                taken.add(name)
                direction = np.array(_numbers(bone.get("direction", []), 3, f"direction of {name}"))
                length = _numbers(bone.get("length", []), 1, f"length of {name}")[0]
                *angles, order = bone.get("axis", ["0", "0", "0", "XYZ"])
                self.names.append(name)
                self.bones.append(direction / max(float(np.linalg.norm(direction)), 1e-12) * length)
                self.frames.append(self._frame(_numbers(angles, 3, f"axis of {name}"), order))
                self.dofs.append(_dof([word.lower() for word in bone.get("dof", [])], name))
                bone = None
            elif bone is not None and key not in bone:
                bone[key] = words
        if bone is not None:
            raise ValueError("a bone without its end")

    def _link(self, lines: list[str]) -> None:
        """Parents, and the bones sorted so that a parent comes first."""
        index, parents = {name: j for j, name in enumerate(self.names)}, {}
        children = {j: [] for j in range(len(self.names))}
        for line in lines:
            parent, *below = line.split()
            if parent.lower() in ("begin", "end"):
                continue
            for name in below:
                if name not in index or parent not in index or index[name] in parents or name == "root":
                    raise ValueError(f"wrong line in the hierarchy: {line[:40]!r}")
                parents[index[name]] = index[parent]
                children[index[parent]].append(index[name])
        order, stack = [], [0]
        while stack:
            order.append(stack.pop())
            stack.extend(reversed(children[order[-1]]))
        if len(order) != len(self.names):
            lost = next(name for j, name in enumerate(self.names) if j not in order)
            raise ValueError(f"bone {lost} does not hang on the root")
        self.parents = [-1 if not j else order.index(parents[j]) for j in order]
        self.names, self.dofs, self.frames, self.bones = (
            [of[j] for j in order] for of in (self.names, self.dofs, self.frames, self.bones))

    def recording(self, angles: Tensor, in_degrees: bool, fps: float, doubt: str | None) -> Recording:
        """Angles ``[D, F]`` of all degrees of freedom in the skeleton's order as a recording."""
        frames, joints, column = angles.shape[1], len(self.names), 0
        leaves = sorted(set(range(joints)) - set(self.parents))
        rotations = R.identity(frames, joints + len(leaves), dtype=torch.float32)
        root_positions = torch.from_numpy(self.place).repeat(frames, 1)
        for j, dof in enumerate(self.dofs):
            turns = {name[1]: angles[column + i] for i, name in enumerate(dof) if name[0] == "r"}
            if not j:
                for i, name in enumerate(dof):
                    if name[0] == "t":
                        root_positions[:, "xyz".index(name[1])] += angles[i]
            column += len(dof)
            order = "".join(turns).upper()
            order += "".join(axis for axis in "XYZ" if axis not in order)
            missing = [torch.zeros(frames, dtype=torch.float64)] * (3 - len(turns))
            values = torch.stack([*turns.values(), *missing], -1)
            own = R.from_euler((torch.deg2rad(values) if in_degrees else values).flip(-1), order[::-1])
            axes = self.frames[j]
            rotations[:, j] = R.multiply(R.multiply(axes, own), R.inverse(axes))
        offsets = [np.zeros(3)] + [self.bones[p] for p in self.parents[1:]] + [self.bones[j] for j in leaves]
        ends = []
        for j in leaves:
            name = f"{self.names[j]}End"
            while name in self.names:
                name += "End"
            ends.append(name)
        return Recording(
            "AMC", (*self.names, *ends), (*self.parents, *leaves), torch.from_numpy(np.stack(offsets)), R.unroll(rotations),
            root_positions, fps, ends=tuple(ends), unit=INCH / CMU_LENGTH if abs(self.length - CMU_LENGTH) < 1e-6 else None,
            roles=self._roles(), doubts=() if doubt is None else (doubt,))

    def _roles(self) -> dict[str, str] | None:
        """Roles where the bones have Vicon's names."""
        roles = {f"{side}_{part}": side[0] + bone for side in ("left", "right") for part, bone in LIMBS.items()}
        return {"hips": "root", **roles} if set(roles.values()) <= set(self.names) else None


def _fields(lines: list[str]) -> dict[str, list[str]]:
    return {words[0].lower(): words[1:] or [""] for words in map(str.split, lines) if words}


def _numbers(words: list[str], count: int, what: str) -> list[float]:
    try:
        numbers = [float(word.replace("_", "?")) for word in words]
    except ValueError:
        numbers = []
    if len(numbers) != count or not all(abs(number) < LARGEST for number in numbers):
        raise ValueError(f"the {what} should be {count} numbers, got {' '.join(words)[:40]!r}")
    return numbers


def _dof(words: list[str], name: str) -> list[str]:
    """Degrees of freedom like rx, each once; positions only at the root."""
    known = ORDER if name == "the root" else ORDER[3:]
    if len(set(words)) != len(words) or not set(words) <= set(known):
        raise ValueError(f"the degrees of freedom of {name} should be of {' '.join(known)}, got {' '.join(words)[:40]!r}")
    return words


def _motion(data: bytes, bones: _Skeleton) -> tuple[np.ndarray, bool]:
    """The numbers ``[D, F]`` of all bones in the skeleton's order, and whether angles are in degrees."""
    data = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    start = _FRAME.search(data)
    if not start:
        raise ValueError("no frame in it: expected a line with the number 1")
    head = data[: start.start()].upper()
    in_degrees = b":DEGREES" in head or (b":RADIANS" not in head and bones.degrees)
    body = data[start.start() :]
    frames = sum(1 for _ in _FRAME.finditer(body))
    second = _FRAME.search(body, start.end() - start.start())
    first = body[start.end() - start.start() : second.start() if second else len(body)]
    if first.count(b"\n") > 2 * len(bones.names) + BONES:
        raise ValueError(f"frame 1 has more lines than the skeleton's {len(bones.names)} bones")
    listed = [words for words in map(bytes.split, first.splitlines()) if words]
    names = [words[0].decode(errors="replace") for words in listed]
    index = {name: j for j, name in enumerate(bones.names)}
    for name, words in zip(names, listed, strict=True):
        if name not in index or names.count(name) > 1:
            raise ValueError(f"frame 1: {name[:40]!r} is no bone of the skeleton, or appears twice")
        if len(words) - 1 != (wanted := len(bones.dofs[index[name]])):
            raise ValueError(f"frame 1: {name} has {len(words) - 1} numbers, the skeleton says {wanted}")
    if not listed:
        raise ValueError("frame 1 has no bones")
    if 2 * frames * (len(bones.names) + 4) > max(SMALL, len(data) // 4):
        raise ValueError(f"{frames} frames of {len(bones.names)} bones are more than {len(data)} bytes can hold")
    if body.count(b"\n") > 2 * frames * (1 + len(listed)) + BONES:
        raise ValueError(f"{frames} frames of {len(listed)} bones should have fewer lines")
    width = 1 + sum(len(words) - 1 for words in listed)
    rows = _rows(body, [words[0] for words in listed], frames, width)
    given, at = {}, 1
    for name, words in zip(names, listed, strict=True):
        given[name] = slice(at, at + len(words) - 1)
        at += len(words) - 1
    if not (np.abs(rows) < LARGEST).all():
        raise ValueError(f"frame {int((~(np.abs(rows) < LARGEST)).any(1).argmax()) + 1}: a number is not finite")
    still = np.zeros((frames, bones.width))
    columns = [rows[:, given[name]] if name in given else still[:, : len(dof)]
               for name, dof in zip(bones.names, bones.dofs, strict=True)]
    return np.ascontiguousarray(np.concatenate(columns, 1).T), in_degrees


def _rows(body: bytes, names: list[bytes], frames: int, width: int) -> np.ndarray:
    """Frame number and values of each frame, ``[F, width]``; every frame must list the same bones."""
    from toolkit.io import decimals  # compiled, slow to import

    found = _NAME.findall(body)
    if found != names * frames:
        at = next((i for i, (a, b) in enumerate(zip(found, names * frames, strict=False)) if a != b), len(found))
        said = found[at].decode(errors="replace")[:40] if at < len(found) else "its end"
        raise ValueError(f"frame {at // len(names) + 1}: expected {names[at % len(names)].decode(errors='replace')[:40]}, "
                         f"got {said!r}")
    del found
    joined = _NAME.sub(b" ", body)  # a line per bone: join those of a frame
    lines = [line for line in joined.splitlines() if line.strip()]
    step = 1 + len(names)
    if len(lines) != frames * step:
        raise ValueError(f"{frames} frames of {len(names)} bones need {frames * step} lines, the file has {len(lines)}")
    counts = np.fromiter((len(line.split()) for line in lines), np.int64, len(lines)).reshape(frames, step)
    if (counts != counts[0]).any():
        raise ValueError(f"frame {int((counts != counts[0]).any(1).argmax()) + 1}: another number of values than in frame 1")
    columns = np.empty((width, frames))
    text = b"\n".join(b" ".join(lines[i : i + step]) for i in range(0, len(lines), step))
    if not decimals.read(np.frombuffer(text, np.uint8), 0, columns):
        words = text.replace(b"_", b"?").split()  # only Python accepts 1_000
        try:
            columns = np.fromiter(map(float, words), np.float64, len(words)).reshape(frames, width).T
        except ValueError as error:
            raise ValueError(f"not a number: {str(error)[-60:]}") from None
    return columns.T
