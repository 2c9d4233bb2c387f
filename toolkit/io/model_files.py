"""Model files: one safetensors file, whose metadata holds JSON. Reading one never runs code.

A file holds one or more parts (a ``model``, a style ``bank``, a training ``run``), each named in
the metadata. A reader that needs one part accepts every file that has it.
"""

import contextlib
import json
import os
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor, nn

from toolkit.io.files import atomic_write, named, opened, parsed

FORMAT = "toolkit 1"
TENSORS = 10_000  # of a file
METADATA = 16_000_000  # bytes, of the description in a file
LARGEST = 1e30  # number of a file; the inverse of one is the smallest deviation
COMPUTED = 100_000_000  # most bytes of the buffers that a module computes and no file holds


def write(path: str | os.PathLike, tensors: dict[str, Tensor], parts: dict[str, Any]) -> None:
    """Write a file, whole or not at all; the same content gives the same bytes.

    ``parts`` are values for JSON by name; the name of a tensor starts with that of its part:
    ``model.gating.…``.
    """
    metadata = {"format": FORMAT, **{name: json.dumps(parts[name]) for name in sorted(parts)}}
    packed = save({name: t.detach().cpu().contiguous() for name, t in tensors.items()}, metadata)
    # The library writes metadata in an order that differs between processes: write its header anew.
    size = 8 + int.from_bytes(packed[:8], "little")
    header = json.loads(packed[8:size]) | {"__metadata__": metadata}
    text = json.dumps(header, separators=(",", ":"), ensure_ascii=False).encode()
    text += b" " * (-len(text) % 8)
    with atomic_write(path) as file:
        file.write(len(text).to_bytes(8, "little") + text)
        file.write(memoryview(packed)[size:])


def read(path: str | os.PathLike, part: str) -> tuple[dict[str, Tensor], dict[str, Any]]:
    """Tensors and parts of a file.

    ValueError if it is damaged, of another format, has no ``part`` or a tensor that is not `sound`.
    """
    path = Path(path)
    try:
        with named(path), opened(path), safe_open(path, framework="pt") as file:
            metadata, names = file.metadata() or {}, list(file.keys())
            if len(names) > TENSORS:
                raise ValueError(f"has {len(names)} tensors, more than {TENSORS}")
            tensors = {name: file.get_tensor(name).clone() for name in names}
    except SafetensorError as error:
        raise ValueError(f"{path}: not a whole safetensors file ({plain(error)})") from error
    found = metadata.pop("format", None)
    if found != FORMAT:
        raise ValueError(f"{path}: expected the format {FORMAT!r}, got {found!r}")
    if sum(map(len, metadata.values())) > METADATA:
        raise ValueError(f"{path}: its metadata is larger than {METADATA} bytes")
    with intact(path, "its metadata"):
        parts = {name: parsed(text) for name, text in metadata.items()}
    if part not in parts:
        there = ", ".join(sorted(parts)) or "nothing"
        raise ValueError(f"{path}: expected {part!r} in it, got {there}")
    with intact(path, "the file"):
        sound(tensors)
    return tensors, parts


def restore(build: Callable[[], nn.Module], tensors: dict[str, Tensor], start: str) -> nn.Module:
    """The module of ``build`` with the tensors whose names begin with ``start``, for evaluation.

    The module is first built on the meta device, which takes no memory, and its shapes are
    compared with those of the tensors: sizes in a file cannot take more memory than its tensors.
    Random numbers are not used.

    Raises
    ------
    ValueError
        If a tensor is missing or unknown, has another shape or kind of numbers, or buffers that are
        not in the file are too large.
    """
    own = starting(tensors, start)
    with torch.device("meta"):
        module = build()
    expected = module.state_dict()
    check(own, expected, exact=False)
    computed = sum(buffer.nbytes for name, buffer in module.named_buffers() if name not in expected)
    if computed > COMPUTED:
        raise ValueError(f"its buffers would take {computed:.3g} bytes")
    if computed:  # the meta device has shapes only
        with torch.random.fork_rng(devices=[]):
            module = build()
    own = {name: value.to(expected[name].dtype) for name, value in own.items()}
    module.load_state_dict(own, assign=not computed)
    return module.eval()


def check(tensors: dict[str, Tensor], expected: dict[str, Tensor], exact: bool = True) -> None:
    """ValueError if names, shapes or dtypes differ; unless ``exact``, floats of any width agree."""
    kinds = ({name: [*value.shape, value.dtype if exact or not value.is_floating_point()
                     else "float"] for name, value in part.items()}
             for part in (expected, tensors))
    if why := difference(*kinds):
        raise ValueError(f"it differs in tensor {why}")


def starting(tensors: dict[str, Tensor], start: str) -> dict[str, Tensor]:
    """The tensors whose names begin with ``start``, by the rest of their names."""
    return {name.removeprefix(start): value for name, value in tensors.items()
            if name.startswith(start)}


def sound(tensors: Mapping[str, Tensor]) -> None:
    """ValueError if a number is not finite or too large, or a deviation not positive.

    It names the tensor. Speeds may be NaN, which stands for unknown ones.
    """
    for name, value in tensors.items():
        if not (value.is_floating_point() and value.numel()):
            continue
        least, most = (value.nan_to_num() if name == "bank.speeds" else value).aminmax()
        if not -LARGEST < least <= most < LARGEST:
            raise ValueError(f"the tensor {name} has numbers that are not finite, or beyond "
                             f"{LARGEST:g}")
        if name.endswith("std") and least < 1 / LARGEST:
            raise ValueError(f"the tensor {name} has deviations that are not positive")


def alike(values: dict[str, Any], examples: dict[str, Any]) -> None:
    """ValueError if a JSON value is not of the kinds of an example; numbers must be finite.

    The one entry of a dictionary or list stands for any number of them. A tuple stands for a list
    of its length, None for null or any number.
    """
    for name, example in examples.items():
        if not _fits(values[name], example):
            raise ValueError(f"its {name} is {values[name]!r:.60}")


def _fits(value: Any, example: Any) -> bool:
    if isinstance(example, dict):
        inside = next(iter(example.values()))
        return isinstance(value, dict) and all(_fits(v, inside) for v in value.values())
    if isinstance(example, list | tuple):
        long = isinstance(value, list) and (isinstance(example, list) or len(value) == len(example))
        return long and all(_fits(v, example[0]) for v in value)
    if example is None:
        return value is None or type(value) in (int, float)
    known = (int,) if isinstance(example, int) else (int, float)
    return type(value) in known and abs(value) < LARGEST


@contextlib.contextmanager
def intact(path: str | os.PathLike, what: str) -> Iterator[None]:
    """An error from a value of the wrong kind becomes a ValueError: ``what`` is damaged."""
    try:
        yield
    except (ArithmeticError, AttributeError, LookupError, RuntimeError, TypeError,
            ValueError) as error:
        raise ValueError(f"{path}: {what} is damaged ({plain(error)})") from error


def plain(error: Exception) -> str:
    """The message of an error, which may quote a file, as a printable line of 300 characters."""
    said = f"{error} is missing" if type(error) is KeyError else str(error)
    return " ".join("".join(c if c.isprintable() else " " for c in said).split())[:300]


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
