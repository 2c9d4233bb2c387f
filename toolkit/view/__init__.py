"""Pictures, animations, web pages, notebook widgets and charts of motion. The only importer of drawing libraries."""

import pkgutil
from importlib.util import find_spec

import lazy_loader

_NEEDS = ("anywidget", "ipywidgets", "matplotlib", "PIL", "plotly", "pyvista", "sklearn")
if _missing := [name for name in _NEEDS if find_spec(name) is None]:
    raise ImportError(f'pages, pictures and widgets need {", ".join(_missing)}: pip install ".[view]"')

__getattr__, __dir__, __all__ = lazy_loader.attach(__name__, [module.name for module in pkgutil.iter_modules(__path__)], {
    "animation": ["animate", "crowd", "loop"],
    "controller": ["Controller"],
    "director": ["Director"],
    "explorer": ["StyleExplorer", "explore"],
    "figures": ["style_space", "training_curves", "trajectory_figure"],
    "live_page": ["web"],
    "page": ["html"],
    "phase_figures": ["phase_figure", "phase_manifold", "principal_axes"],
    "picture": ["strip"],
    "player": ["Player", "play"],
    "style_blender": ["StyleBlender", "StyleTriangle"],
})
