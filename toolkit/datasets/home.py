"""Folders of the datasets on this machine, which `toolkit.datasets.fetch` fills.

They are in the folder that the environment variable ``TOOLKIT_DATA`` names, or else in the user's
data folder (on Linux ``~/.local/share/toolkit``).
"""

import functools
import logging
import os
from pathlib import Path

import platformdirs


def home() -> Path:
    """The folder with one sub-folder per dataset; it may not exist."""
    own = platformdirs.user_data_dir("toolkit", appauthor=False)
    return Path(os.environ.get("TOOLKIT_DATA") or own)


def folder(name: str) -> Path:
    """The folder of a dataset, with ``_`` for each ``-`` of its name; it may not exist."""
    return home() / name.replace("-", "_")


def find(name: str, layout: str, source: str) -> Path:
    """The folder of a dataset, which is logged once.

    The error for a missing one names its ``source`` and ``layout``.
    """
    path = folder(name)
    if not path.is_dir():
        raise ValueError(f"{name}: nothing at {path}; python -m toolkit data fetch {name} gets it "
                         f"from {source}; or give root=, the folder with {layout}, or set "
                         f"TOOLKIT_DATA to the folder that holds {path.name}/")
    _log(name, path)
    return path


@functools.cache
def _log(name: str, path: Path) -> None:
    logging.getLogger("toolkit.datasets").info("%s: %s", name, path)
