"""Takes of a dataset: BVH files found in a folder, with style and gait read from the file names."""

import os
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from toolkit.datasets import home
from toolkit.io import bvh, files
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.motion.tensors import similar

Names = str | Iterable[str] | None
Root = str | os.PathLike | None  # a dataset's folder; None: its folder on this machine


@dataclass(frozen=True)
class Take:
    """One recorded file, with the style and the gait that its name gives."""

    path: Path
    style: str
    gait: str


@dataclass(frozen=True)
class Source:
    """Where the files of a dataset are and how they are named."""

    name: str  # in `toolkit.datasets.load`
    pattern: re.Pattern  # of the file names; its groups are ``style`` and ``gait``
    layout: str  # description of a folder of this dataset, for error messages
    home: str  # where users get the dataset, for error messages
    gaits: Iterable[str] = ()  # that are known even if a folder has no file of them

    def load(self, root: Root = None, styles: Names = None, gaits: Names = None) -> list[Clip]:
        """Clips of the dataset, by path.

        ``root`` is a folder with the files, at any depth; by default the dataset's folder on this
        machine. ``styles`` and ``gaits`` are names to keep; None for all that the folder has.

        Raises
        ------
        ValueError
            If the folder, a style or a gait does not exist; BVHError if a file is malformed.
        """
        return list(self.read(self.choose(root, styles, gaits)))

    def folder(self, root: Root) -> Path:
        """The dataset's folder: ``root``, or its folder on this machine."""
        if root is None:
            return home.find(self.name, self.layout, self.home)
        folder = Path(root)
        if not folder.is_dir():
            problem = "is not a folder" if folder.exists() else "does not exist"
            raise ValueError(f"{self.name}: {folder} {problem}; expected a folder with "
                             f"{self.layout}; get it at {self.home}")
        return folder

    def find(self, root: Root) -> list[Take]:
        """All takes in a folder and its sub-folders, by path; ValueError if there is none."""
        folder = self.folder(root)
        found = ((path, self.pattern.fullmatch(path.name)) for path in files.below(folder))
        takes = [Take(path, name["style"], name["gait"]) for path, name in found if name]
        if not takes:
            raise ValueError(f"{self.name}: no matching BVH file in {folder}; expected "
                             f"{self.layout}; get it at {self.home}")
        return takes

    def choose(self, root: Root, styles: Names, gaits: Names,
               known_styles: Iterable[str] = ()) -> list[Take]:
        """The takes of some styles and gaits (None: all).

        ValueError if a name is unknown, or no file matches a style or gait of the call. A style of
        ``known_styles`` and a gait of `gaits` is known even if the folder has no file of it.
        """
        takes = self.find(root)
        known = {take.style for take in takes} | set(known_styles)
        wanted_styles = check_names(styles, known, "style", self.name)
        known = {take.gait for take in takes} | set(self.gaits)
        wanted_gaits = check_names(gaits, known, "gait", self.name)
        kept = [t for t in takes if t.style in wanted_styles and t.gait in wanted_gaits]
        missing = [] if styles is None else sorted(set(wanted_styles) - {t.style for t in kept})
        missing += [] if gaits is None else sorted(set(wanted_gaits) - {t.gait for t in kept})
        if missing:
            there = sorted({f"{take.style} {take.gait}" for take in takes})
            raise ValueError(f"{self.name}: no file of {_listed(missing)} in "
                             f"{self.folder(root)}; it has {_listed(there)}")
        return kept

    def read(self, takes: list[Take]) -> Iterator[Clip]:
        """Labelled clips of takes; more than 20 show a progress bar on a terminal."""
        for take in progress_bar(takes, desc=self.name, unit="file", show=len(takes) > 20):
            yield bvh.load(take.path, unit="cm", up="y", style=take.style, gait=take.gait)


def check_names(names: Names, known: Iterable[str], what: str, dataset: str) -> list[str]:
    """The names as a list, all known ones for None; ValueError, with similar names, for others."""
    known = sorted(known)
    if names is None:
        return known
    names = [names] if isinstance(names, str) else list(names)
    if not names:
        raise ValueError(f"{dataset}: an empty list of {what}s; None means all of them: "
                         f"{_listed(known)}")
    for name in names:
        if name not in known:
            near = " or ".join(similar(name, known))
            guess = f"did you mean {near}? " if near else ""
            raise ValueError(f"{dataset}: unknown {what} {name!r}; {guess}it has {_listed(known)}")
    return names


def _listed(names: list[str], most: int = 25) -> str:
    if len(names) <= most:
        return ", ".join(names)
    return (f"{', '.join(names[:4])} … {names[-1]}, {len(names)} in all "
            "(python -m toolkit data list shows them)")
