"""Leaks between the parts of a split: frames of the test that a training has seen, as they are or nearly so."""

import math
import os
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

from toolkit.datasets.blocks import GAP, PARTS, Split
from toolkit.io import files
from toolkit.motion.names import printable

MOST = 1000  # leaks that are listed

class _Entry(NamedTuple):
    part: str
    take: tuple[str, str]  # style and gait (or name) of the original
    start: int
    stop: float
    mirror: bool

    def __str__(self) -> str:
        frames = "all frames" if math.isinf(self.stop) else f"frames {self.start} to {self.stop}"
        return f"{frames}{' mirrored' if self.mirror else ''} of {self.part}"


def find(split: Split | Mapping[str, Any] | str | os.PathLike) -> list[str]:
    """Leaks in a split, one line each; an empty list if there is none.

    Parameters
    ----------
    split
        A `toolkit.datasets.blocks.Split`, a JSON file, or what such a file holds: ``train``, ``validation`` and ``test``
        (one may be missing); and, if wanted, ``gap``, frames between blocks of different parts of one take (by default
        `GAP`); ``whole_takes``, true if no take may be in two parts; ``unseen``, styles of the test alone.
        A block is ``[style, gait, start, stop]``, with ``true`` at the end for a mirror image, or an object with these names
        and ``"mirror": true``. A style or gait that ends in ``_M`` or ``_mirror`` is a mirror image, too. A name alone is a
        whole take; ``M012345`` is the mirror image of ``012345``, as in HumanML3D.

    Returns
    -------
    list of str
        Kinds: ``overlap``, ``gap`` (too small), ``twin`` (a mirror image of the other part's frames), ``same take``,
        ``unseen style``. At most `MOST`, and then a line that says that there are more.

    Raises
    ------
    ValueError
        If the file or a block is not in this form.
    """
    if isinstance(split, Split):
        what, split = split.dataset, split.to_json()
    elif isinstance(split, Mapping):
        what = "split"
    else:
        what, path = os.fspath(split), Path(split)
        try:
            split = files.parsed(files.read(path))
        except ValueError as error:
            raise ValueError(f"{path}: no JSON file ({error})") from None
    if not isinstance(split, Mapping) or sum(part in split for part in PARTS) < 2:
        raise ValueError(f"{what}: expected an object with lists of blocks, at least two of {', '.join(PARTS)}")
    gap, whole, unseen = split.get("gap", GAP), split.get("whole_takes", False), split.get("unseen", [])
    if not (isinstance(gap, int) and gap >= 0 and isinstance(whole, bool) and isinstance(unseen, list | tuple)
            and all(isinstance(style, str) for style in unseen)):
        raise ValueError(f"{what}: expected gap, a number of frames; whole_takes, true or false; unseen, a list of styles; "
                         f"got {gap!r:.60}, {whole!r:.60}, {unseen!r:.60}")
    takes: dict[tuple[str, str], list[_Entry]] = defaultdict(list)
    for part in PARTS:
        if not isinstance(blocks := split.get(part, []), list | tuple):
            raise ValueError(f"{what}: expected a list of blocks as {part}, got {blocks!r:.60}")
        for number, block in enumerate(blocks):
            entry = _entry(part, block, f"{what}: block {number} of {part}")
            takes[entry.take].append(entry)
    alone = frozenset(unseen)
    found = list(islice((line for entries in takes.values() for line in _leaks(entries, gap, whole, alone)), MOST + 1))
    return [*found[:MOST], f"and more: only {MOST} leaks are listed"] if len(found) > MOST else found


def _leaks(entries: list[_Entry], gap: int, whole: bool, unseen: frozenset[str]) -> Iterator[str]:
    """Leaks between blocks of one take."""
    style, gait = entries[0].take
    name = printable(f"{style[:60]} {gait[:60]}".strip())
    before: dict[str, list[_Entry]] = {}  # by part, the blocks so far that the next ones may be too near to
    for b in sorted(entries, key=lambda entry: (entry.start, entry.stop)):
        if style in unseen and b.part != "test":
            yield f"unseen style: {name}, {b}; {printable(style[:60])} is for the test alone"
        for part in sorted(before.keys() - {b.part}):
            before[part] = [a for a in before[part] if whole or b.start - a.stop < gap]
            for a in before[part]:
                between = b.start - a.stop
                kind = "twin" if a.mirror != b.mirror else "same take" if whole else "overlap" if between < 0 else "gap"
                why = f"; {between:g} frames between them, expected {gap}" if kind == "gap" else ""
                yield f"{kind}: {name}, {a} and {b}{why}"
        before.setdefault(b.part, []).append(b)


def _entry(part: str, block: Any, place: str) -> _Entry:
    """A block of a list; ValueError, which names the place, if it is none."""
    known = {"style", "gait", "start", "stop", "mirror"}
    if isinstance(block, str):
        block = {"gait": block}
    elif isinstance(block, list | tuple) and len(block) in (4, 5):
        block = dict(zip(("style", "gait", "start", "stop", "mirror"), block, strict=False))
    if not isinstance(block, Mapping) or not block.keys() <= known or "gait" not in block:
        raise ValueError(f"{place}: expected [style, gait, start, stop], an object with these names, or the name of a take; "
                         f"got {block!r:.100}")
    style, gait = block.get("style", ""), block["gait"]
    start, stop, mirror = block.get("start", 0), block.get("stop", math.inf), block.get("mirror", False)
    if not all(isinstance(text, str) for text in (style, gait)) or not isinstance(mirror, bool):
        raise ValueError(f"{place}: style and gait are names, mirror is true or false; "
                         f"got {style!r:.60}, {gait!r:.60}, {mirror!r:.60}")
    if type(start) is not int or not ((type(stop) is int and stop < 2**53) or stop == math.inf) or not 0 <= start < stop:
        raise ValueError(f"{place}: expected frame numbers 0 <= start < stop, got {start!r:.60} and {stop!r:.60}")
    original = tuple(re.sub(r"_(M|[Mm]irror(ed)?)$|^M(?=\d+$)", "", text) for text in (style, gait))
    return _Entry(part, original, start, stop, mirror or original != (style, gait))
