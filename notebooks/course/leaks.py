"""Leaks between the parts of a split: test frames that a training has seen, exactly or nearly."""

import json
import math
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any, NamedTuple

import torch
from torch import Tensor

from toolkit.datasets.blocks import GAP, PARTS, Split
from toolkit.motion.text import printable

MOST = 1000  # leaks that are listed


class _Entry(NamedTuple):
    part: str
    take: tuple[str, str]  # style and gait (or name) of the original
    start: int
    stop: float
    mirror: bool

    def __str__(self) -> str:
        frames = f"frames {self.start} to {self.stop}"
        if math.isinf(self.stop):
            frames = "all frames"
        return f"{frames}{' mirrored' if self.mirror else ''} of {self.part}"


def find(split: Split | Mapping[str, Any]) -> list[str]:
    """Leaks in a split, one line each; an empty list if there is none.

    Parameters
    ----------
    split
        A `toolkit.datasets.blocks.Split`, or the JSON values of one: ``train``, ``validation`` and
        ``test`` (one may be missing); and, if wanted, ``gap``, frames between blocks of different
        parts of one take (by default `GAP`); ``whole_takes``, true if no take may be in two parts;
        ``unseen``, styles of the test alone.
        A block is ``[style, gait, start, stop]``, with ``true`` at the end for a mirror image. A
        style or gait that ends in ``_M`` or ``_mirror`` is a mirror image, too. A name alone is a
        whole take; ``M012345`` is the mirror image of ``012345``, as in HumanML3D.

    Returns
    -------
    list of str
        Kinds: ``overlap``, ``gap`` (too small), ``twin`` (a mirror image of the other part's
        frames), ``same take``, ``unseen style``. At most `MOST`, and a line if there are more.

    Raises
    ------
    ValueError
        If it or a block is not in this form.
    """
    if isinstance(split, Split):
        split = json.loads(json.dumps(vars(split)))
    if not isinstance(split, Mapping) or sum(part in split for part in PARTS) < 2:
        raise ValueError("expected an object with lists of blocks, at least two of "
                         f"{', '.join(PARTS)}")
    gap, whole = split.get("gap", GAP), split.get("whole_takes", False)
    unseen = split.get("unseen", [])
    lists = isinstance(unseen, list) and all(isinstance(style, str) for style in unseen)
    if not (lists and isinstance(gap, int) and gap >= 0 and isinstance(whole, bool)):
        raise ValueError("expected gap, a number of frames; whole_takes, true or false; unseen, a "
                         f"list of styles; got {gap!r:.60}, {whole!r:.60}, {unseen!r:.60}")
    takes: dict[tuple[str, str], list[_Entry]] = defaultdict(list)
    for part in PARTS:
        if not isinstance(blocks := split.get(part, []), list):
            raise ValueError(f"expected a list of blocks as {part}, got {blocks!r:.60}")
        for number, block in enumerate(blocks):
            if not (entry := _entry(part, block)):
                raise ValueError(f"block {number} of {part}: expected [style, gait, start, stop], "
                                 "0 <= start < stop, and true for a mirror image, or the name of a "
                                 f"take; got {block!r:.100}")
            takes[entry.take].append(entry)
    leaks = (leak for entries in takes.values()
             for leak in _leaks(entries, gap, whole, frozenset(unseen)))
    found = list(islice(leaks, MOST + 1))
    if len(found) > MOST:
        found[MOST] = f"and more: only {MOST} leaks are listed"
    return found


def from_middle(frames: int, takes: int) -> Tensor:
    """Distance of each frame from the middle of its take, frames; the takes are equally long."""
    if frames % takes:
        raise ValueError(f"{frames} frames are not {takes} takes of one length")
    length = frames // takes
    return (torch.arange(frames) % length - length / 2).abs()


def _entry(part: str, block: Any) -> _Entry | None:
    """A block of a list, None if it is none."""
    whole = isinstance(block, str)
    match ["", block, 0, math.inf] if whole else block:
        case [str(style), str(gait), int(start), int(stop) | float(stop), *mirror]:
            framed = whole or (isinstance(stop, int) and 0 <= start < stop < 2**53)
            if not framed or mirror not in ([], [True], [False]):
                return None
        case _:
            return None
    mirrored = r"_(M|[Mm]irror(ed)?)$|^M(?=\d+$)"
    original = re.sub(mirrored, "", style), re.sub(mirrored, "", gait)
    return _Entry(part, original, start, stop, mirror == [True] or original != (style, gait))


def _leaks(entries: list[_Entry], gap: int, whole: bool, unseen: frozenset[str]) -> Iterator[str]:
    """Leaks between blocks of one take."""
    style, gait = entries[0].take
    name = printable(f"{style[:60]} {gait[:60]}".strip())
    before: dict[str, list[_Entry]] = {}  # by part, blocks that the next ones may be too near to
    for b in sorted(entries, key=lambda entry: (entry.start, entry.stop)):
        if style in unseen and b.part != "test":
            yield f"unseen style: {name}, {b}; {printable(style[:60])} is for the test alone"
        for part in sorted(before.keys() - {b.part}):
            before[part] = [a for a in before[part] if whole or b.start - a.stop < gap]
            for a in before[part]:
                between = b.start - a.stop
                if a.mirror != b.mirror:
                    kind = "twin"
                elif whole:
                    kind = "same take"
                else:
                    kind = "overlap" if between < 0 else "gap"
                why = f"; {between:g} frames between them, expected {gap}" if kind == "gap" else ""
                yield f"{kind}: {name}, {a} and {b}{why}"
        before.setdefault(b.part, []).append(b)
