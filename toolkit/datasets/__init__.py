"""Motion datasets behind one call: files of the public ones, and a procedural one that needs no files.

Where ``root`` is None, the folder is the one called like the dataset (``100style``, ``bandai``, ``xia``) in the folder that
the environment variable ``TOOLKIT_DATA`` names, or else in the user's data folder, where ``python -m toolkit data fetch``
puts it (`toolkit.datasets.home`).
"""

import difflib
import importlib
import os
from collections import Counter
from collections.abc import Callable, Iterable
from types import ModuleType

from toolkit.datasets import bandai, home, procedural, style100, xia
from toolkit.datasets.takes import Take
from toolkit.motion import Clip

__all__ = ["DATASETS", "Take", "available", "bandai", "contents", "home", "load", "may_mirror", "procedural", "style100",
           "where", "xia"]

DATASETS = {"procedural": "procedural", "100style": "style100", "bandai": "bandai", "xia": "xia"}  # name: module


def load(
    name: str,
    root: str | os.PathLike | None = None,
    styles: str | Iterable[str] | None = None,
    gaits: str | Iterable[str] | None = None,
    **options,
) -> list[Clip]:
    """Clips of a dataset, in the order of style and file name.

    Parameters
    ----------
    name
        ``"procedural"``, ``"100style"``, ``"bandai"`` or ``"xia"``.
    root
        The folder that holds the files; the procedural dataset has none.
    styles, gaits
        Names to keep; None for all.
    **options
        What the dataset's own ``load`` takes: ``seconds``, ``seed`` (procedural), ``cut`` (100style), ``dataset`` (bandai).

    Raises
    ------
    ValueError
        If the dataset, a style or a gait is unknown, or the folder is not one of this dataset.
    BVHError
        If a file is malformed; the message names the file and the line.
    """
    module = _module(name, root)
    if name == "procedural":
        return module.load(styles=styles, gaits=gaits, **options)
    return module.load(root, styles, gaits, **options)


def contents(name: str, root: str | os.PathLike | None = None) -> dict[str, dict[str, int]]:
    """How many takes of each gait each style has, without reading any motion.

    Raises
    ------
    ValueError
        If the dataset is unknown or the folder is not one of this dataset.
    """
    module = _module(name, root)
    if name == "procedural":
        return {style: dict.fromkeys(module.GAITS, 1) for style in module.STYLES}
    takes = module.SOURCE.find(root)
    known = style100.styles(root) if name == "100style" else sorted({take.style for take in takes})
    return {style: dict(Counter(take.gait for take in takes if take.style == style)) for style in known}


def available(name: str) -> bool:
    """Whether `load` finds a dataset without a ``root``: its folder is where data lies on this machine, or it needs none.

    Raises
    ------
    ValueError
        If the dataset is unknown.
    """
    _module(name, None)
    return name == "procedural" or home.folder(name).is_dir()


def where(name: str) -> str:
    """Which data `load` uses without a ``root``, in words.

    Raises
    ------
    ValueError
        If the dataset is unknown or not there.
    """
    module = _module(name, None)
    return "procedural: computed here" if name == "procedural" else f"{name}: {module.SOURCE.folder(None)}"


def may_mirror(name: str, root: str | os.PathLike | None = None) -> Callable[[Clip | Take], bool]:
    """Which clips of a dataset may be mirrored: 100STYLE says which styles are symmetric; idling never is."""
    styles = style100.styles(root) if name == "100style" else {}
    return lambda clip: clip.gait != "ID" and (clip.style not in styles or styles[clip.style].symmetric)


def _module(name: str, root: str | os.PathLike | None) -> ModuleType:
    if name not in DATASETS:
        near = difflib.get_close_matches(str(name), DATASETS, n=1)
        guess = f"did you mean {near[0]!r}? " if near else ""
        raise ValueError(f"unknown dataset {name!r}; {guess}known: {', '.join(DATASETS)}")
    if name == "procedural" and root is not None:
        raise ValueError(f"the procedural dataset is computed and reads no folder; leave root={os.fspath(root)!r} out")
    return importlib.import_module(f"toolkit.datasets.{DATASETS[name]}")
