"""Pictures, animations, web pages and notebook widgets of motion.

The only importer of drawing libraries.
"""

from importlib.util import find_spec

import lazy_loader

from toolkit import registry

_NEEDS = ("anywidget", "ipywidgets", "matplotlib", "PIL", "pyvista")
if _missing := [name for name in _NEEDS if find_spec(name) is None]:
    raise ImportError(
        f'pages, pictures and widgets need {", ".join(_missing)}: pip install ".[view]"'
    )

_find, __dir__, __all__ = lazy_loader.attach(
    __name__,
    ["frontend", "pages", "render", "widgets", "writers"],
    {
        "pages.live_page": ["web"], "pages.page": ["html"],
        "render.animation": ["animate"], "render.picture": ["strip"],
        "widgets.controller": ["Controller"],
        "widgets.player": ["Player", "play"],
    },
)
__getattr__ = registry.attributes(__name__, _find)
