"""Stylised character animation: Mason et al. 2022 and Park et al. 2021 in plain Python.

Glossary of shapes: B batch, F frames, J joints, K experts, D features.
Units and axes: metres, seconds, radians, Y up, left is +X.

>>> import toolkit as tk
>>> clips = tk.datasets.load("procedural", styles=["Neutral", "Zombie"])
>>> data = tk.features.build(clips)
"""

import lazy_loader

from toolkit import extra as extra, registry

__version__ = "0.2.0"
# a module is imported when it is first used
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)

for _kind in ("html", "png", "mp4", "gif", "webp", "apng"):
    registry.register(f"writer.{_kind}", "toolkit.view.writers:write")
