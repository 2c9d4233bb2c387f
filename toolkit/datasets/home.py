"""Where data lies on this machine: a folder per dataset, which `toolkit.datasets.fetch` fills and everything else finds.

The folder that the environment variable ``TOOLKIT_DATA`` names, or else the user's own data folder (on Linux
``~/.local/share/toolkit``).
"""

import functools
import logging
import os
from pathlib import Path

import platformdirs

FETCHED = ("100style", "lpn-film-100style", "bandai")
FOLDERS = {"lpn-film-100style": "lpn_film_100style"}  # the others are called like their dataset


def home() -> Path:
    """The folder that holds one folder per dataset; it need not exist."""
    return Path(os.environ.get("TOOLKIT_DATA") or platformdirs.user_data_dir("toolkit", appauthor=False))


def folder(name: str) -> Path:
    """Where a dataset lies if it was fetched or put there; it need not exist."""
    return home() / FOLDERS.get(name, name)


def find(name: str, layout: str, source: str) -> Path:
    """The folder of a dataset; the command line says once which one it uses (logger ``toolkit.datasets``).

    Raises
    ------
    ValueError
        If it is not there; the message says how to get it from its ``source`` and what ``layout`` it has.
    """
    path = folder(name)
    if not path.is_dir():
        get = f"python -m toolkit data fetch {name} gets it from {source}" if name in FETCHED else f"its home: {source}"
        raise ValueError(f"{name}: nothing at {path}; {get}; or give root=, the folder with {layout}, or set TOOLKIT_DATA "
                         f"to the folder that holds {path.name}/")
    _say(name, path)
    return path


@functools.cache
def _say(name: str, path: Path) -> None:
    logging.getLogger("toolkit.datasets").info("%s: %s", name, path)
