"""Training, validation and test parts of a dataset without leaks, as lists of takes and frames.

Neighbouring frames are almost equal, and the features of a frame reach 60 frames back and 51 ahead.
So the parts are whole takes, or contiguous blocks with `GAP` frames between them that belong to no
part. A block's mirror image belongs to the part of the block.
"""

import hashlib
import json
import os
import re
from collections import defaultdict
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from toolkit.datasets import bandai, style100
from toolkit.datasets.takes import Root
from toolkit.io import files

PARTS = "train", "validation", "test"
# frames at 60 Hz between blocks of a take: a style clip, longer than the window of a frame (112)
GAP = 240
SHARE = 0.1  # of a take (of a style's takes) for validation, and for the test
LEAST = 240  # frames of a block: one style clip
HEADER = 200_000  # bytes of a BVH file in which its number of frames is looked for


class Block(NamedTuple):
    """Frames ``start`` to ``stop`` (not included) of a take, as its file counts them.

    In 100STYLE style and gait name the take, and the frames are those of Frame_Cuts.csv. In
    Bandai's dataset several takes have the same style and content: there ``gait`` is the file's
    name without suffix.
    """

    style: str
    gait: str
    start: int
    stop: int


@dataclass(frozen=True)
class Split:
    """A dataset in three parts; mirror images belong to the part of their original."""

    dataset: str
    train: list[Block] = field(repr=False)
    validation: list[Block] = field(repr=False)
    test: list[Block] = field(repr=False)
    unseen: tuple[str, ...] = ()  # styles of the test alone
    gap: int = GAP  # frames between blocks of different parts of a take
    whole_takes: bool = False  # no take belongs to two parts

    def save(self, path: str | os.PathLike) -> None:
        """Write a JSON file."""
        files.write_whole(Path(path), (json.dumps(vars(self)) + "\n").encode())


def split(name: str, root: Root = None) -> Split:
    """The split of ``"100style"`` or ``"bandai"``; the same at every call and on every machine.

    100STYLE: the five styles that the published experiments hold out (`style100.HELD_OUT`) are the
    test's alone. From each take of the others, a tenth, and at least `LEAST` frames, goes to the
    test and as much to validation. A take that is too short for both gives one of them; an even
    shorter one, as many of idling, belongs to the training part. Frame_Cuts.csv is enough for it.
    STOP may lie past a file's end.

    Bandai: whole takes, of each style a tenth, and at least one, for the test and for validation;
    it needs the files.

    Raises
    ------
    ValueError
        If the dataset has no such split, or its tables or files are not in ``root``.
    """
    if name == "100style":
        return _style100(root)
    if name == "bandai":
        return _bandai(root)
    raise ValueError(f"no split of {name!r}; known: 100style, bandai")


def _style100(root: Root) -> Split:
    parts: dict[str, list[Block]] = {part: [] for part in PARTS}
    for (style, gait), (start, stop) in sorted(style100.frame_cuts(root).items()):
        if style in style100.HELD_OUT:
            parts["test"].append(Block(style, gait, start, stop))
            continue
        for part, first, last in _cut(stop - start, draw(style, gait)):
            parts[part].append(Block(style, gait, start + first, start + last))
    return Split("100style", **parts, unseen=style100.HELD_OUT)


def _cut(n: int, draw: int) -> Iterable[tuple[str, int, int]]:
    """Parts of a take of n frames; a random number decides which end and part is held out."""
    at_start, for_test = draw % 2, draw // 2 % 2
    held = max(LEAST, round(SHARE * n))
    if n >= 4 * held + 2 * GAP:
        sizes = {"train": n - 2 * (held + GAP), "validation": held, "test": held}
    elif n >= 3 * held + GAP:
        sizes = {"train": n - held - GAP, "test" if for_test else "validation": held}
    else:
        sizes = {"train": n}
    first = 0
    for part in reversed(sizes) if at_start else sizes:
        yield part, first, first + sizes[part]
        first += sizes[part] + GAP


def _bandai(root: Root) -> Split:
    by_style: dict[str, list[Block]] = defaultdict(list)
    for take in bandai.SOURCE.find(root):
        block = Block(take.style, take.path.stem, 0, _frames(take.path))
        by_style[take.style].append(block)
    parts: dict[str, list[Block]] = {part: [] for part in PARTS}
    for blocks in by_style.values():
        blocks.sort(key=lambda block: draw(block.gait))
        held = max(1, round(SHARE * len(blocks))) if len(blocks) >= len(PARTS) else 0
        parts["test"] += blocks[:held]
        parts["validation"] += blocks[held : 2 * held]
        parts["train"] += blocks[2 * held :]
    for blocks in parts.values():
        blocks.sort()
    return Split("bandai", **parts, whole_takes=True)


def _frames(path: Path) -> int:
    """Number of frames that a BVH file states."""
    head = files.read(path, HEADER)
    if found := re.search(rb"^Frames:[ \t]*(\d{1,9})\s*$", head, re.MULTILINE):
        return int(found[1])
    raise ValueError(f"{path}: no line 'Frames: N' in its first {HEADER} bytes")


def draw(*names: str) -> int:
    """A random number that depends on the names alone."""
    return int.from_bytes(hashlib.sha256(" ".join(names).encode()).digest()[:8], "little")
