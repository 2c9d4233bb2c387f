"""Numbers that nobody derived, as they were: they show a change, not that something is right.

``TOOLKIT_UNCHANGED=store python -m pytest FILE`` writes those of a file's tests anew.
"""

import json
import os
import re
import zlib
from collections.abc import Iterator
from dataclasses import is_dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import torch

STORED = Path(__file__).with_suffix(".json")


def digest(thing: Any) -> list[float]:
    """Six numbers of a thing and all that it holds: how many numbers, how many are not finite; of
    their inverse hyperbolic sines, so that huge ones hide no others, mean, deviation, and a sum in
    which each place counts differently; a checksum of its texts.
    """
    texts: list[str] = []
    x = np.concatenate([np.zeros(1), *_numbers(thing, texts)])
    finite = np.isfinite(x)
    x = np.arcsinh(np.where(finite, x, 0.0))
    mixed = (x * np.cos(np.arange(len(x)))).sum() / (np.linalg.norm(x) + 0.01)
    return [len(x), int((~finite).sum()), float(x.mean()), float(x.std()), float(mixed),
            zlib.crc32("\n".join(texts).encode())]


def _numbers(thing: Any, texts: list[str]) -> Iterator[np.ndarray]:
    if isinstance(thing, torch.Tensor | np.ndarray | float | int):
        yield np.ravel(np.asarray(thing, float))
    elif thing is None or isinstance(thing, str):
        texts.append(re.sub(r"\d+\.\d+", "#", str(thing)))  # rounded: the last digit may differ
    elif is_dataclass(thing):
        yield from _numbers(vars(thing), texts)
    else:
        for part in thing.items() if isinstance(thing, dict) else thing:
            yield from _numbers(part, texts)


def check(test: str, thing: Any, near: float = 1e-5) -> None:
    """Compare the `digest` of what a test found with the stored one."""
    stored = json.loads(STORED.read_bytes()) if STORED.exists() else {}
    found = digest(thing)
    if os.environ.get("TOOLKIT_UNCHANGED") == "store":
        stored[test] = [*found[:2], *(float(f"{x:.6g}") for x in found[2:-1]), found[-1]]
        rows = (json.dumps({name: stored[name]}, separators=(",", ":"))[1:-1]
                for name in sorted(stored))
        STORED.write_text("{\n" + ",\n".join(rows) + "\n}\n", encoding="utf-8")
    assert test in stored, f"{test}: no numbers are stored, see tests/unchanged.py"
    *before, texts = stored[test]
    assert (found[:-1], found[-1]) == (pytest.approx(before, rel=10 * near, abs=near), texts), (
        f"{test}: {found} is not {stored[test]}")


def constants(module: ModuleType) -> None:
    """Compare the numbers of a module with the stored ones, to the last digit."""
    values = {name: value for name, value in vars(module).items()
              if name.isupper() and isinstance(value, int | float | tuple | dict)}
    text = repr([(name, values[name]) for name in sorted(values)])
    check(f"constants of {module.__name__}", hex(zlib.crc32(text.encode())))
