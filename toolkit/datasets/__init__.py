"""Motion datasets with one interface: public ones, and a procedural one that needs no files.

Where ``root`` is None, the folder is that of the dataset on this machine (`toolkit.datasets.home`),
where ``python -m toolkit data fetch`` puts it.
"""

import inspect
import os
from collections import Counter
from collections.abc import Callable
from types import ModuleType

from toolkit import registry
from toolkit.datasets import bandai, folder, home, procedural, style100
from toolkit.datasets.blocks import split
from toolkit.datasets.takes import Names, Root, Take, check_names
from toolkit.motion import Clip

__all__ = ["DATASETS", "Take", "available", "bandai", "contents", "folder", "home", "load",
           "may_mirror", "procedural", "split", "style100", "where"]
__getattr__ = registry.modules(__name__, __path__)[0]

DATASETS = {"procedural": procedural, "100style": style100, "bandai": bandai, "folder": folder}


def load(name: str, root: Root = None, styles: Names = None, gaits: Names = None,
         **options) -> list[Clip]:
    """Clips of a dataset, in the order of style and file name.

    Parameters
    ----------
    name
        ``"procedural"``, ``"100style"`` or ``"bandai"``; ``"folder"`` for a folder of your own.
    root
        The folder that holds the files; the procedural dataset has none.
    styles, gaits
        Names to keep; None for all.
    **options
        Options of the dataset's own ``load``: ``seconds``, ``seed`` (procedural), ``dataset``
        (bandai), ``target`` (folder).

    Raises
    ------
    ValueError
        If the dataset, a style or a gait is unknown, or the folder is not one of this dataset.
    BVHError
        If a file is malformed; the message names the file and the line.
    """
    module = _module(name, root)
    place = {} if module is procedural else {"root": root}
    if options:
        check_names(options, inspect.signature(module.load).parameters, "option", name)
    return module.load(**place, styles=styles, gaits=gaits, **options)


def contents(name: str, root: Root = None) -> dict[str, dict[str, int]]:
    """Number of takes of each style and gait, without reading any motion; errors as of `load`."""
    module = _module(name, root)
    if module is procedural:
        return {style: dict.fromkeys(procedural.GAITS, 1) for style in procedural.STYLES}
    takes = module.SOURCE.find(root)
    known = style100.styles(root) if module is style100 else sorted({t.style for t in takes})
    return {style: dict(Counter(take.gait for take in takes if take.style == style))
            for style in known}


def available(name: str) -> bool:
    """Whether `load` works without a ``root``: the data are on this machine, or none are needed."""
    return _module(name, None) is procedural or home.folder(name).is_dir()


def where(name: str) -> str:
    """Description of the data that `load` uses without a ``root``; ValueError if there are none."""
    module = _module(name, None)
    if module is procedural:
        return "procedural: computed here"
    return f"{name}: {module.SOURCE.folder(None)}"


def may_mirror(name: str, root: Root = None) -> Callable[[Clip | Take], bool]:
    """Which clips may be mirrored: all but idling and styles that are known to be asymmetric."""
    styles = procedural.STYLES if name == "procedural" else {}
    if name == "100style":
        styles = style100.styles(root)

    def may(clip: Clip | Take) -> bool:
        return clip.gait != "ID" and (clip.style not in styles or styles[clip.style].symmetric)

    return may


def _module(name: str, root: Root) -> ModuleType:
    check_names([name], DATASETS, "dataset", "toolkit")
    if name == "procedural" and root is not None:
        raise ValueError("the procedural dataset is computed and reads no folder; leave "
                         f"root={os.fspath(root)!r} out")
    return DATASETS[name]
