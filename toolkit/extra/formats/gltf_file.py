"""The document of a glTF 2.0 file: its JSON text, checked member by member, and its arrays."""

import base64
import binascii
import hashlib
import json
import struct
from collections.abc import Sequence
from functools import cached_property
from pathlib import Path
from urllib.parse import unquote

import numpy as np

from toolkit.extra.formats.key_times import MOST
from toolkit.extra.formats.nodes import LIMIT
from toolkit.io.files import parsed, read
from toolkit.motion.text import printable

COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
NUMBERS = {kind: number for number, kind in COMPONENTS.items()}
KINDS = {(): "SCALAR", (2,): "VEC2", (3,): "VEC3", (4,): "VEC4", (4, 4): "MAT4"}  # shapes of a row
PACKED = ("EXT_meshopt_compression", "KHR_meshopt_compression")


class Document:
    """The JSON text and the buffers of a file; every defect is a ValueError."""

    def __init__(self, path: Path, data: bytes | None = None):
        self.path = path
        data = read(path) if data is None else data
        self.size = len(data)  # bytes of the file and of the buffers beside it
        self.digest = hashlib.sha256(data).digest()
        text, self.binary = _chunks(data) if data[:4] == b"glTF" else (data, None)
        try:
            self.document = parsed(text)
        except ValueError as error:
            raise ValueError(f"no GLB file, and no JSON text ({error})") from None
        asset = member(self.document, "asset") if isinstance(self.document, dict) else {}
        if not str(asset.get("version", "")).startswith("2."):
            raise ValueError("expected glTF version 2; older files can be converted in Blender")
        self.buffers: dict[int, memoryview | bytes] = {}
        self.lists: dict[str, list[dict]] = {}
        self.arrays: dict[int, np.ndarray] = {}
        self.decoded = 0  # values of all arrays

    def listed(self, key: str) -> list[dict]:
        """A list of the document, checked once."""
        if key not in self.lists:
            self.lists[key] = members(self.document, key)
        return self.lists[key]

    @property
    def unpacking(self) -> str:
        """What to do with a compressed file."""
        return f"`npx @gltf-transform/cli cp {self.path.name} plain.glb` unpacks it"

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

    def array(self, index: object, *widths: int) -> np.ndarray:
        """The values ``[N, width]`` of an accessor of one of some widths, float64.

        They are decoded once, so never change them.
        """
        accessors = self.listed("accessors")
        index = index_of({"accessor": index}, "accessor", len(accessors))
        width = WIDTHS.get(str(accessors[index].get("type")))
        if width not in widths:
            raise ValueError(f"accessor {index} should have {' or '.join(map(str, widths))} values "
                             "in a row")
        if index not in self.arrays:
            self.arrays[index] = self._decode(accessors[index], index, width)
        return self.arrays[index]

    def _decode(self, accessor: dict, index: int, width: int) -> np.ndarray:
        count = whole_of(accessor, "count")
        kind = COMPONENTS.get(whole_of(accessor, "componentType"))
        if kind is None or "bufferView" not in accessor or "sparse" in accessor:
            raise ValueError(f"accessor {index} has no numbers, sparse ones or an unknown type")
        values = self._values(accessor, kind, count, width)

        # Accessors may share their bytes. All together they stay in proportion to the file.
        self.decoded += count * width
        if self.decoded > MOST + self.size:
            raise ValueError(f"its accessors have {self.decoded} values, more than a file of "
                             f"{self.size} bytes should hold")
        made = values.astype(np.float64)
        if accessor.get("normalized") and values.dtype.kind in "iu":
            made = np.maximum(made / np.iinfo(values.dtype).max, -1.0)
        if not -1e30 <= made.min(initial=0.0) <= made.max(initial=0.0) <= 1e30:  # false with NaN
            raise ValueError(f"accessor {index} has numbers that are not finite")
        return made

    def _values(self, accessor: dict, kind: str, count: int, width: int) -> np.ndarray:
        """Values ``[count, width]`` of an accessor where they lie in a buffer."""
        view, data = self.view(accessor)
        if packed := [name for name in PACKED if name in member(view, "extensions")]:
            raise ValueError(f"it is compressed by {packed[0]}; {self.unpacking}")
        number = np.dtype(kind).itemsize
        row = number * width
        stride = whole_of(view, "byteStride", row) or row
        offset = whole_of(accessor, "byteOffset", 0)
        end = offset + (count - 1) * stride + row if count else 0
        if stride < row or end > len(data):
            raise ValueError("an accessor reaches beyond its buffer")
        return np.ndarray((count, width), kind, data, offset if count else 0, (stride, number))

    def view(self, of: dict) -> tuple[dict, memoryview]:
        """The buffer view of an accessor or an image, and its bytes."""
        views, buffers = self.listed("bufferViews"), self.listed("buffers")
        view = views[index_of(of, "bufferView", len(views))]
        start, size = whole_of(view, "byteOffset", 0), whole_of(view, "byteLength", 0)
        data = memoryview(self.buffer(index_of(view, "buffer", len(buffers))))
        return view, data[start : start + size]

    def buffer(self, index: int) -> memoryview | bytes:
        """The bytes of a buffer, read once."""
        if index not in self.buffers:
            uri = self.listed("buffers")[index].get("uri")
            if not isinstance(uri, str):
                self.buffers[index] = self.binary or b""
            elif uri.startswith("data:"):
                try:
                    self.buffers[index] = base64.b64decode(uri[uri.find(",") + 1 :], validate=True)
                except (binascii.Error, ValueError):
                    raise ValueError(f"buffer {index} is not base64 text") from None
            else:
                self.buffers[index] = self._beside(unquote(uri))
            if uri is not None:
                self.size += len(self.buffers[index])
        return self.buffers[index]

    def _beside(self, name: str) -> bytes:
        """A file in the folder of this one or below."""
        said = f"its buffer {printable(name)[:80]!r}"
        try:
            folder = self.path.parent.resolve()
            beside = (folder / name).resolve()
            if ":" in name or not beside.is_relative_to(folder) or not beside.is_file():
                raise ValueError(f"{said} is not beside it")
            return read(beside)
        except OSError as error:
            raise ValueError(f"{said} cannot be read ({error.strerror})") from error


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
    numbers = isinstance(values, list | tuple) and all(type(v) in (int, float) for v in values)
    # false with NaN
    if not numbers or len(values) != count or not all(abs(v) < 1e30 for v in values):
        raise ValueError(f"{key} of a node should be {count} numbers")
    return np.array(values, np.float64)


def unit_quaternions(turns: np.ndarray) -> np.ndarray:
    """Quaternions ``[..., 4]``, scaled to length 1."""
    length = np.linalg.norm(turns, axis=-1, keepdims=True)
    if not (length > 1e-6).all():
        raise ValueError("a rotation is no quaternion: its length is 0")
    return turns / length


def _padded(data: bytes, by: bytes = b"\0") -> bytes:
    """The bytes up to a multiple of four."""
    return data + by * (-len(data) % 4)


class Buffer:
    """The binary part and its description: one view and one accessor per array."""

    def __init__(self, data: bytes = b"", views: Sequence[dict] = (),
                 accessors: Sequence[dict] = ()):
        self.data = bytearray(_padded(data))
        self.views, self.accessors = list(views), list(accessors)

    def view(self, data: bytes, more: dict | None = None) -> int:
        """Index of the view of some bytes."""
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
                          | (more or {}))
        self.data += _padded(data)
        return len(self.views) - 1

    def add(self, values: np.ndarray, target: int | None = None, *, bounds: bool = False) -> int:
        """Index of the accessor of an array ``[N, ...]`` of float32, uint32 or uint16."""
        values = np.ascontiguousarray(values)
        view = self.view(values.tobytes(), {} if target is None else {"target": target})
        made = {"bufferView": view, "count": len(values),
                "componentType": NUMBERS[values.dtype.str], "type": KINDS[values.shape[1:]]}
        if bounds:
            flat = values.reshape(len(values), -1)
            made |= {"min": flat.min(0).tolist(), "max": flat.max(0).tolist()}
        self.accessors.append(made)
        return len(self.accessors) - 1


def container(document: dict, buffer: Buffer) -> bytes:
    """The .glb file: a header, a JSON chunk and a binary chunk; ValueError for NaN in the text."""
    document = document | {"bufferViews": buffer.views, "accessors": buffer.accessors}
    buffers = document.get("buffers", [{}])
    document["buffers"] = [buffers[0] | {"byteLength": len(buffer.data)}]
    text = json.dumps(document, separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    text = _padded(text.encode(errors="replace"), b" ")
    chunks = b""
    for kind, chunk in ((b"JSON", text), (b"BIN\0", bytes(buffer.data))):
        chunks += struct.pack("<I4s", len(chunk), kind) + chunk
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
