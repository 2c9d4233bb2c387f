"""The takes of a dataset: BVH files found in a folder, their style and gait read from the file name."""

import difflib
import os
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from tqdm import tqdm

from toolkit.datasets import home
from toolkit.io import bvh
from toolkit.motion import Clip


@dataclass(frozen=True)
class Take:
    """One recorded file, and what its name says about it."""

    path: Path
    style: str
    gait: str


@dataclass(frozen=True)
class Source:
    """Where a dataset's files are and how they are named.

    Parameters
    ----------
    name
        The dataset's name in `toolkit.datasets.load`.
    pattern
        Matches the file names that belong to the dataset; groups ``style`` and ``gait``.
    layout
        What a folder of this dataset holds, in words.
    home
        Where its users get it.
    gaits
        What the ``gait`` group is called here, where the file name has a code.
    """

    name: str
    pattern: re.Pattern
    layout: str
    home: str
    gaits: Mapping[str, str] | None = None

    def folder(self, root: str | os.PathLike | None) -> Path:
        """The dataset's folder: ``root``, or else where data lies on this machine (`toolkit.datasets.home`)."""
        folder = home.find(self.name, self.layout, self.home) if root is None else Path(root)
        if not folder.is_dir():
            problem = "is not a folder" if folder.exists() else "does not exist"
            raise ValueError(f"{self.name}: {folder} {problem}; expected a folder with {self.layout}; get it at {self.home}")
        return folder

    def find(self, root: str | os.PathLike | None) -> list[Take]:
        """All takes in a folder and its sub-folders, by path; files named otherwise are not part of the dataset.

        Raises
        ------
        ValueError
            If the folder does not exist or holds no such file.
        """
        folder, takes = self.folder(root), []
        for path in sorted(folder.rglob("*.bvh")):
            if match := self.pattern.fullmatch(path.name):
                takes.append(Take(path, match["style"], (self.gaits or {}).get(match["gait"], match["gait"])))
        if not takes:
            raise ValueError(f"{self.name}: no matching BVH file in {folder}; expected {self.layout}; get it at {self.home}")
        return takes

    def choose(
        self,
        root: str | os.PathLike | None,
        styles: str | Iterable[str] | None,
        gaits: str | Iterable[str] | None,
        known_styles: Iterable[str] = (),
        known_gaits: Iterable[str] = (),
    ) -> list[Take]:
        """The takes of some styles and gaits (None: all).

        Raises
        ------
        ValueError
            If a name is unknown, or no file matches a style or gait that was asked for.
        """
        takes = self.find(root)
        wanted_styles = _check_names(styles, {t.style for t in takes} | set(known_styles), "style", self.name)
        wanted_gaits = _check_names(gaits, {t.gait for t in takes} | set(known_gaits), "gait", self.name)
        kept = [t for t in takes if t.style in wanted_styles and t.gait in wanted_gaits]
        missing = [] if styles is None else sorted(set(wanted_styles) - {t.style for t in kept})
        missing += [] if gaits is None else sorted(set(wanted_gaits) - {t.gait for t in kept})
        if missing:
            within = f" with gait {_listed(wanted_gaits)}" if styles is not None and gaits is not None else ""
            raise ValueError(f"{self.name}: no file of {_listed(missing)}{within} in {self.folder(root)}; it has "
                             f"{_listed(sorted({f'{t.style} {t.gait}' for t in takes}))}")
        return kept

    def read(self, takes: list[Take], unit: float = bvh.CENTIMETRE) -> Iterator[Clip]:
        """Clips of takes, with their labels; a progress bar on a terminal where there are many."""
        hide = None if len(takes) > 20 else True
        for take in tqdm(takes, desc=self.name, unit="file", disable=hide):
            yield bvh.load(take.path, unit=unit, style=take.style, gait=take.gait)


def _check_names(names: str | Iterable[str] | None, known: Iterable[str], what: str, dataset: str) -> list[str]:
    """The names asked for, all known ones for None; an unknown one is refused with those that it may have meant."""
    known = sorted(known)
    if names is None:
        return known
    names = [names] if isinstance(names, str) else list(names)
    if not names:
        raise ValueError(f"{dataset}: an empty list of {what}s; None means all of them: {_listed(known)}")
    for name in names:
        if name not in known:
            near = difflib.get_close_matches(str(name), known, n=3, cutoff=0.5)
            guess = f"did you mean {' or '.join(near)}? " if near else ""
            raise ValueError(f"{dataset}: unknown {what} {name!r}; {guess}it has {_listed(known)}")
    return names


def _listed(names: list[str], most: int = 25) -> str:
    if len(names) <= most:
        return ", ".join(names)
    return f"{', '.join(names[:4])} … {names[-1]}, {len(names)} in all (python -m toolkit data list shows them)"
