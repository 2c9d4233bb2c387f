"""Records and arrays of a binary FBX file, read where they are needed."""

import struct
import zlib
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

INSTEAD = ("save it as binary FBX 2011 or newer, as Autodesk's free FBX Converter does, "
           "or as BVH or GLB")
MAGIC = b"Kaydara FBX Binary  \0"
PACKED, ROOM = 3, 50_000_000  # arrays may unpack to PACKED times the file's size + ROOM bytes
MOST = 16  # properties of a record that are read
_SCALARS = {b"Y": "<h", b"C": "<B", b"B": "<B", b"I": "<i", b"F": "<f", b"D": "<d", b"L": "<q"}
_ARRAYS = {b"f": "<f4", b"d": "<f8", b"l": "<i8", b"i": "<i4", b"b": "u1", b"c": "u1"}


@dataclass
class Record:
    """A node of the file: its name, and where its properties and children are."""

    name: bytes
    properties: tuple[int, int, int]  # number, first byte, end
    children: tuple[int, int]  # first byte, end


class Records:
    """Records and arrays of the file."""

    def __init__(self, data: bytes):
        if not data.startswith(MAGIC):
            if b"FBXHeaderExtension" in data[:4000]:
                raise ValueError(f"it is a text FBX; {INSTEAD}")
            raise ValueError("it is no FBX file")
        if len(data) < 31 or not 7000 <= (version := int.from_bytes(data[23:27], "little")) < 8000:
            raise ValueError(f"only binary FBX version 7 can be read; {INSTEAD}")
        self.data, self.room = data, PACKED * len(data) + ROOM
        self.head = "<QQQB" if version >= 7500 else "<IIIB"

    def records(self, start: int, end: int) -> Iterator[Record]:
        """The records from a byte to another; an empty record ends them."""
        size = struct.calcsize(self.head)
        while start + size <= end:
            stop, count, length, name = struct.unpack_from(self.head, self.data, start)
            if not stop:
                return
            first = start + size + name
            if not first + length <= stop <= end:
                raise ValueError(f"the file is damaged at byte {start}")
            yield Record(self.data[first - name : first], (count, first, first + length),
                         (first + length, stop))
            start = stop

    def children(self, record: Record) -> Iterator[Record]:
        """The records inside a record."""
        return self.records(*record.children)

    def values(self, record: Record) -> list:
        """The first `MOST` properties of a record: numbers, bytes and arrays."""
        count, at, end = record.properties
        found = []
        for _ in range(min(count, MOST)):
            kind, at = self.data[at : at + 1], at + 1
            if kind in _SCALARS:
                size = struct.calcsize(_SCALARS[kind])
                value = struct.unpack(_SCALARS[kind], self._part(at, size, end))[0]
            elif kind in (b"S", b"R"):
                size = 4 + int.from_bytes(self._part(at, 4, end), "little")
                value = self._part(at, size, end)[4:]
            elif kind in _ARRAYS:
                length, packed, size = struct.unpack("<III", self._part(at, 12, end))
                data = self._part(at + 12, size, end)
                value, size = self._array(_ARRAYS[kind], length, packed, data), size + 12
            else:
                raise ValueError(f"the file is damaged at byte {at}")
            found.append(value)
            at += size
        return found

    def _part(self, at: int, size: int, end: int) -> bytes:
        if at + size > end:
            raise ValueError(f"the file is damaged at byte {at}")
        return self.data[at : at + size]

    def _array(self, kind: str, length: int, packed: int, data: bytes) -> np.ndarray:
        size = length * np.dtype(kind).itemsize
        self.room -= size
        if self.room < 0:
            raise ValueError("its arrays unpack to more than a file of this size should hold")
        if packed:
            try:
                data = zlib.decompressobj().decompress(data, size + 1)
            except zlib.error as error:
                raise ValueError("a packed array is damaged") from error
        if len(data) != size:
            raise ValueError(f"an array should have {size} bytes, it has {len(data)}")
        return np.frombuffer(data, kind)

    def properties(self, record: Record) -> dict[bytes, tuple]:
        """Numbers of the record's ``Properties70`` by name."""
        found = {}
        for table in self.children(record):
            if table.name == b"Properties70":
                for row in self.children(table):
                    values = self.values(row)
                    if row.name == b"P" and len(values) > 4:
                        name = values[0] if isinstance(values[0], bytes) else b""
                        found[name] = tuple(values[4:])
        return found
