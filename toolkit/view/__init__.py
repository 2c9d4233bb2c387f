"""Pictures, animations, web pages, notebook widgets and charts of motion.

The only importer of drawing libraries.
"""

from importlib.util import find_spec

import lazy_loader

from toolkit import registry

_NEEDS = ("anywidget", "ipywidgets", "matplotlib", "PIL", "plotly", "pyvista", "sklearn")
if _missing := [name for name in _NEEDS if find_spec(name) is None]:
    raise ImportError(
        f'pages, pictures and widgets need {", ".join(_missing)}: pip install ".[view]"'
    )

_find, __dir__, __all__ = lazy_loader.attach(
    __name__,
    ["charts", "frontend", "pages", "render", "widgets", "writers"],
    {
        "charts": ["style_space", "training_curves", "trajectory_figure"],
        "pages.live_page": ["web"], "pages.page": ["html"],
        "render.animation": ["animate", "crowd", "loop"], "render.picture": ["strip"],
        "widgets.controller": ["Controller"], "widgets.explorer": ["StyleExplorer", "explore"],
        "widgets.player": ["Player", "play"],
        "widgets.corners": ["StyleTriangle"], "widgets.style_blender": ["StyleBlender"]
    },
)
__getattr__ = registry.attributes(__name__, _find)
