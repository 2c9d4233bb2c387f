"""Model files: one safetensors file, whose metadata holds JSON. Reading one never runs code.

A file holds one or more parts (a ``model``, a style ``bank``, a training ``run``), each named in the metadata. A reader that
needs one part accepts every file that has it.
"""

import contextlib
import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor

from toolkit.io.files import atomic_write

FORMAT = "toolkit 1"


def write(path: str | os.PathLike, tensors: dict[str, Tensor], parts: dict[str, Any]) -> None:
    """Write a file, whole or not at all; the same content gives the same bytes.

    ``parts`` are values for JSON by name; the name of a tensor starts with that of its part: ``model.gating.…``.
    """
    metadata = {"format": FORMAT, **{name: json.dumps(value) for name, value in parts.items()}}
    packed = save({name: t.detach().cpu().contiguous() for name, t in tensors.items()}, metadata)
    size = 8 + int.from_bytes(packed[:8], "little")
    header = json.loads(packed[8:size])  # the order of its metadata differs between processes
    header["__metadata__"] = metadata
    text = json.dumps(header, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 8)
    with atomic_write(path) as file:
        file.write(len(text).to_bytes(8, "little") + text)
        file.write(memoryview(packed)[size:])


def read(path: str | os.PathLike, part: str) -> tuple[dict[str, Tensor], dict[str, Any]]:
    """Tensors and parts of a file; ValueError if it cannot be read, has another format, or lacks ``part``."""
    path = Path(path)
    try:
        with safe_open(path, framework="pt") as file:
            metadata = file.metadata() or {}
            tensors = {name: file.get_tensor(name).clone() for name in file.keys()}  # noqa: SIM118 (not a dict)
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror or 'no such file'})") from error
    except SafetensorError as error:
        raise ValueError(f"{path}: not a whole safetensors file ({plain(error)})") from error
    found = metadata.pop("format", None)
    if found != FORMAT:
        raise ValueError(f"{path}: expected the format {FORMAT!r}, got {found!r}")
    try:
        parts = {name: json.loads(text) for name, text in metadata.items()}
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{path}: its metadata is damaged ({plain(error)})") from error
    if part not in parts:
        raise ValueError(f"{path}: expected a {part} in it, got {', '.join(sorted(parts)) or 'nothing'}")
    return tensors, parts


@contextlib.contextmanager
def intact(path: str | os.PathLike, what: str) -> Iterator[None]:
    """Inside, an error from a value of the wrong kind becomes a ValueError of one line: ``what`` is damaged."""
    try:
        yield
    except (AttributeError, IndexError, KeyError, OverflowError, RuntimeError, TypeError, ValueError) as error:
        raise ValueError(f"{path}: {what} is damaged ({plain(error)})") from error


def plain(error: Exception) -> str:
    """The message of an error, which may quote a file, as one printable line of at most 300 characters."""
    return " ".join("".join(c if c.isprintable() else " " for c in str(error)).split())[:300]


def difference(expected: dict[str, Any], got: dict[str, Any]) -> str:
    """The first key at which two dictionaries differ, in words; empty where they are equal."""
    for key in dict.fromkeys((*expected, *got)):
        a, b = expected.get(key), got.get(key)
        if a != b:
            if isinstance(a, (list, tuple)) and isinstance(b, (list, tuple)):
                if len(a) != len(b):
                    return f"{key}: expected {len(a)}, got {len(b)}"
                a, b = next((x, y) for x, y in zip(a, b, strict=True) if x != y)
            return f"{key}: expected {a!r}, got {b!r}"
    return ""
