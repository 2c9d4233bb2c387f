"""Motion datasets with one interface: the files of public datasets, and a procedural dataset that needs no files.

Where ``root`` is None, the folder is the one with the name of the dataset (``100style``, ``bandai``, ``xia``) in the folder
that the environment variable ``TOOLKIT_DATA`` names, or else in the user's data folder, where ``python -m toolkit data
fetch`` puts it (`toolkit.datasets.home`).
"""

import difflib
import inspect
import os
import pkgutil
from collections import Counter
from collections.abc import Callable
from types import ModuleType

import lazy_loader

from toolkit.datasets import bandai, folder, home, procedural, style100, xia
from toolkit.datasets.blocks import split
from toolkit.datasets.takes import Names, Take
from toolkit.motion import Clip

__all__ = ["DATASETS", "Take", "available", "bandai", "contents", "folder", "home", "load", "may_mirror", "procedural",
           "split", "style100", "where", "xia"]
__getattr__ = lazy_loader.attach(__name__, [module.name for module in pkgutil.iter_modules(__path__)])[0]

DATASETS = {"procedural": procedural, "100style": style100, "bandai": bandai, "xia": xia, "folder": folder}


def load(name: str, root: str | os.PathLike | None = None, styles: Names = None, gaits: Names = None,
         **options) -> list[Clip]:
    """Clips of a dataset, in the order of style and file name.

    Parameters
    ----------
    name
        ``"procedural"``, ``"100style"``, ``"bandai"`` or ``"xia"``; ``"folder"`` for a folder of your own.
    root
        The folder that holds the files; the procedural dataset has none.
    styles, gaits
        Names to keep; None for all.
    **options
        Options of the dataset's own ``load``: ``seconds``, ``seed`` (procedural), ``cut`` (100style), ``dataset`` (bandai).

    Raises
    ------
    ValueError
        If the dataset, a style or a gait is unknown, or the folder is not one of this dataset.
    BVHError
        If a file is malformed; the message names the file and the line.
    """
    module = _module(name, root)
    place = {} if module is procedural else {"root": root}
    known = inspect.signature(module.load).parameters
    if other := [option for option in options if option not in known]:
        raise ValueError(f"{name} has no option {other[0]!r}; its options are {', '.join(known)}")
    return module.load(**place, styles=styles, gaits=gaits, **options)


def contents(name: str, root: str | os.PathLike | None = None) -> dict[str, dict[str, int]]:
    """Number of takes of each style and gait, without reading any motion; the errors of ``root`` are those of `load`."""
    module = _module(name, root)
    if module is procedural:
        return {style: dict.fromkeys(procedural.GAITS, 1) for style in procedural.STYLES}
    takes = module.SOURCE.find(root)
    known = style100.styles(root) if module is style100 else sorted({take.style for take in takes})
    return {style: dict(Counter(take.gait for take in takes if take.style == style)) for style in known}


def available(name: str) -> bool:
    """Whether `load` works without a ``root``: the dataset's folder exists on this machine, or it needs none."""
    return _module(name, None) is procedural or home.folder(name).is_dir()


def where(name: str) -> str:
    """Description of the data that `load` uses without a ``root``; ValueError if they are not on this machine."""
    module = _module(name, None)
    return "procedural: computed here" if module is procedural else f"{name}: {module.SOURCE.folder(None)}"


def may_mirror(name: str, root: str | os.PathLike | None = None) -> Callable[[Clip | Take], bool]:
    """Which clips of a dataset may be mirrored: symmetric styles, as 100STYLE's table lists them; idling never."""
    styles = style100.styles(root) if name == "100style" else {}
    return lambda clip: clip.gait != "ID" and (clip.style not in styles or styles[clip.style].symmetric)


def _module(name: str, root: str | os.PathLike | None) -> ModuleType:
    if name not in DATASETS:
        near = difflib.get_close_matches(str(name), DATASETS, n=1)
        guess = f"did you mean {near[0]!r}? " if near else ""
        raise ValueError(f"unknown dataset {name!r}; {guess}known: {', '.join(DATASETS)}")
    if name == "procedural" and root is not None:
        raise ValueError(f"the procedural dataset is computed and reads no folder; leave root={os.fspath(root)!r} out")
    return DATASETS[name]
