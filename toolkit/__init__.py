"""Stylised character animation: Mason et al. 2022 and Park et al. 2021 in plain Python.

Glossary of shapes: B batch, F frames, J joints, K experts, D features.
Units and axes: metres, seconds, radians, Y up, left is +X.

>>> import toolkit as tk
>>> clips = tk.datasets.load("procedural", styles=["Neutral", "Zombie"])
>>> data = tk.features.build(clips)
"""

import difflib
from typing import Any

import lazy_loader

from toolkit import extra as extra, registry

__version__ = "0.2.0"
_lazy, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> Any:
    """A module, imported when it is first used, or a name of one."""
    near = difflib.get_close_matches(name, __all__, 1)
    if near and name not in __all__:
        raise AttributeError(f"toolkit has no {name!r}; did you mean {near[0]!r}?")
    return _lazy(name)


for _kind in ("html", "png", "mp4", "gif", "webp", "apng"):
    registry.register(f"writer.{_kind}", "toolkit.view.writers:write")
