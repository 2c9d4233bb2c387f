"""Pictures, animations, web pages, notebook widgets and charts of motion. The only importer of drawing libraries."""

from importlib import import_module
from importlib.util import find_spec

_NEEDS = ("anywidget", "ipywidgets", "matplotlib", "PIL", "plotly", "pyvista", "sklearn")
if _missing := [name for name in _NEEDS if find_spec(name) is None]:
    raise ImportError(f'pages, pictures and widgets need {", ".join(_missing)}: pip install ".[view]"')

_HOME = {
    "animate": "animation", "contact_sheet": "animation", "crowd": "animation", "loop": "animation",
    "html": "page", "web": "live_page",
    "strip": "picture",
    "play": "player", "Player": "player",
    "Controller": "controller",
    "StyleBlender": "style_blender", "StyleTriangle": "triangle",
    "StyleExplorer": "explorer", "explore": "explorer",
    "phase_figure": "phase_figures", "phase_manifold": "phase_figures", "principal_axes": "phase_figures",
    "style_space": "figures", "training_curves": "figures", "trajectory_figure": "figures",
}
__all__ = sorted(_HOME)


def __getattr__(name: str):
    """Import a name on its first use: a web page needs no pyvista, a strip no plotly."""
    if name not in _HOME:
        raise AttributeError(f"toolkit.view has no {name!r}; it has {', '.join(__all__)}")
    return getattr(import_module(f"toolkit.view.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return __all__
