"""The document of a glTF 2.0 file: its JSON text, checked member by member, and the arrays in its buffers."""

import base64
import binascii
import hashlib
import math
import struct
from functools import cached_property
from pathlib import Path
from urllib.parse import unquote

import numpy as np

from toolkit.io.files import parsed, read
from toolkit.io.nodes import LIMIT, MOST, printable

COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}  # glTF's types to numpy's
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Document:
    """The JSON text and the buffers of a file; every defect is a ValueError."""

    def __init__(self, path: Path):
        self.path = path
        data = read(path)
        self.size, self.digest, text, self.binary = len(data), hashlib.sha256(data).digest(), data, None
        if data[:4] == b"glTF":
            text, self.binary = _chunks(data)
        try:
            self.document = parsed(text)
        except ValueError as error:
            raise ValueError(f"no GLB file, and no JSON text ({error})") from None
        known = isinstance(self.document, dict)
        if not known or not str(member(self.document, "asset").get("version", "")).startswith("2."):
            raise ValueError("expected glTF version 2; older files can be converted in Blender")
        self.buffers, self.lists, self.doubts = {}, {}, []

    def listed(self, key: str) -> list[dict]:
        """A list of the document, checked once."""
        if key not in self.lists:
            self.lists[key] = members(self.document, key)
        return self.lists[key]

    @cached_property
    def parents(self) -> list[int]:
        """The parent of each node, -1 at the top."""
        nodes = self.listed("nodes")
        if len(nodes) > LIMIT:
            raise ValueError(f"more than {LIMIT} nodes")
        found = [-1] * len(nodes)
        for j, node in enumerate(nodes):
            for child in indices_of(node, "children", len(nodes)):
                if found[child] >= 0:
                    raise ValueError(f"node {child} has two parents")
                found[child] = j
        return found

    def array(self, index: object, width: int) -> np.ndarray:
        """The values ``[N, width]`` of an accessor, float64."""
        accessors = self.listed("accessors")
        accessor = accessors[index_of({"accessor": index}, "accessor", len(accessors))]
        kind, count = COMPONENTS.get(hashable(accessor.get("componentType"))), whole_of(accessor, "count")
        if kind is None or WIDTHS.get(hashable(accessor.get("type"))) != width:
            raise ValueError(f"accessor {index} has the wrong type for an animation")
        if "bufferView" in accessor:
            values = self._view(accessor, kind, count, width)
        elif count * width <= max(MOST, self.size):
            values = np.zeros((count, width), kind)
        else:
            raise ValueError(f"accessor {index} has {count} values and no data")
        if sparse := member(accessor, "sparse"):
            few_, values = whole_of(sparse, "count"), values.copy()
            at, new = member(sparse, "indices"), member(sparse, "values")
            rows = self._view(at, COMPONENTS.get(hashable(at.get("componentType")), ""), few_, 1)[:, 0]
            if len(rows) and not (rows.dtype.kind == "u" and int(rows.max()) < count):
                raise ValueError(f"accessor {index} has sparse values beyond its end")
            values[rows] = self._view(new, kind, few_, width)
        made = values.astype(np.float64)
        if accessor.get("normalized") and values.dtype.kind in "iu":
            made /= np.iinfo(values.dtype).max
            np.maximum(made, -1.0, out=made)
        if not -1e30 <= made.min(initial=0.0) <= made.max(initial=0.0) <= 1e30:  # false with NaN
            raise ValueError(f"accessor {index} has numbers that are not finite")
        return made

    def _view(self, of: dict, kind: str, count: int, width: int) -> np.ndarray:
        """Values ``[count, width]`` where they lie in a buffer."""
        views = self.listed("bufferViews")
        view = views[index_of(of, "bufferView", len(views))]
        if "EXT_meshopt_compression" in member(view, "extensions"):
            raise ValueError("its animation is compressed by EXT_meshopt_compression; unpack it with gltf-transform")
        element = np.dtype(kind).itemsize * width if kind else 0
        stride = whole_of(view, "byteStride", element) or element
        start, size, offset = (whole_of(*x, 0) for x in ((view, "byteOffset"), (view, "byteLength"), (of, "byteOffset")))
        buffer = self.buffer(index_of(view, "buffer", len(self.listed("buffers"))))
        end = offset + (count - 1) * stride + element if count else 0
        if not element or stride < element or end > size or start + size > len(buffer):
            raise ValueError("an accessor reaches beyond its buffer")
        return np.ndarray((count, width), kind, buffer, start + offset if count else 0, (stride, np.dtype(kind).itemsize))

    def buffer(self, index: int) -> memoryview | bytes:
        """The bytes of a buffer, read once."""
        if index not in self.buffers:
            uri = self.listed("buffers")[index].get("uri")
            if uri is None:
                self.buffers[index] = self.binary or b""
            elif not isinstance(uri, str):
                raise ValueError(f"buffer {index} has no address")
            elif uri.startswith("data:"):
                try:
                    self.buffers[index] = base64.b64decode(uri[uri.find(",") + 1 :], validate=True)
                except (binascii.Error, ValueError):
                    raise ValueError(f"buffer {index} is not base64 text") from None
            else:
                self.buffers[index] = self._beside(unquote(uri))
            self.size += len(self.buffers[index]) if uri else 0
        return self.buffers[index]

    def _beside(self, name: str) -> bytes:
        """A file in the folder of this one or below."""
        try:
            folder = self.path.parent.resolve()
            beside = (folder / name).resolve()
            if ":" in name or not beside.is_relative_to(folder) or not beside.is_file():
                raise ValueError(f"its buffer {printable(name)[:80]!r} is not beside it")
            return read(beside)
        except OSError as error:
            raise ValueError(f"its buffer {printable(name)[:80]!r} cannot be read ({error.strerror})") from error


def _chunks(data: bytes) -> tuple[bytes, memoryview | None]:
    """JSON text and binary chunk of a GLB file."""
    found, at = {}, 12
    if len(data) < 20:
        raise ValueError("the file ends before its JSON text")
    while at + 8 <= len(data):
        size, kind = struct.unpack_from("<I4s", data, at)
        if at + 8 + size > len(data):
            raise ValueError(f"the file is cut off: a chunk of {size} bytes begins at byte {at}")
        found.setdefault(kind, memoryview(data)[at + 8 : at + 8 + size])
        at += 8 + size
    if b"JSON" not in found:
        raise ValueError("the file has no JSON text")
    return bytes(found[b"JSON"]), found.get(b"BIN\0")


def member(of: dict, key: str) -> dict:
    """A member that is an object; {} if it is missing."""
    value = of.get(key, {})
    if not isinstance(value, dict):
        raise ValueError(f"{key} should be an object, got {type(value).__name__}")
    return value


def members(of: dict, key: str) -> list[dict]:
    """A member that is a list of objects; [] if it is missing."""
    value = of.get(key, [])
    if not isinstance(value, list) or not all(isinstance(x, dict) for x in value):
        raise ValueError(f"{key} should be a list of objects")
    return value


def whole_of(of: dict, key: str, default: int | None = None) -> int:
    """A member that is a whole number."""
    value = of.get(key, default)
    if type(value) is not int or not 0 <= value < 2**53:
        raise ValueError(f"{key} should be a whole number, got {str(value)[:20]!r}")
    return value


def index_of(of: dict, key: str, count: int) -> int:
    """A member that is the number of one of ``count`` things."""
    value = whole_of(of, key)
    if value >= count:
        raise ValueError(f"{key} {value} does not exist; there are {count}")
    return value


def indices_of(of: dict, key: str, count: int) -> list[int]:
    """A member that is a list of such numbers; [] if it is missing."""
    values = of.get(key, [])
    if not isinstance(values, list):
        raise ValueError(f"{key} should be a list")
    return [index_of({key: value}, key, count) for value in values]


def numbers_of(of: dict, key: str, count: int, default: tuple[float, ...] = ()) -> np.ndarray:
    """A member that is a list of ``count`` finite numbers."""
    values = of.get(key, default)
    if not isinstance(values, list | tuple) or len(values) != count or not all(
            type(v) in (int, float) and abs(v) < 1e30 and math.isfinite(v) for v in values):
        raise ValueError(f"{key} of a node should be {count} numbers")
    return np.array(values, np.float64)


def hashable(value: object) -> object:
    """The value where it is a number or a text; None for lists and objects."""
    return value if isinstance(value, int | str) else None


def unit(turns: np.ndarray) -> np.ndarray:
    """Quaternions of length 1."""
    length = np.linalg.norm(turns, axis=-1, keepdims=True)
    if not (length > 1e-6).all():
        raise ValueError("a rotation is no quaternion: its length is 0")
    return turns / length
