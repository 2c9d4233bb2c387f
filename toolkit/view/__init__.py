"""Look at motion: web page, strip picture, notebook player, charts. The only importer of drawing libraries."""

from importlib import import_module

_HOME = {
    "html": "page", "strip": "picture",
    "play": "player", "Player": "player",
    "StyleBlender": "blender", "StyleTriangle": "blender",
    "phase_figure": "figures", "style_space": "figures", "training_curves": "figures", "trajectory_figure": "figures",
}  # fmt: skip
__all__ = ["Player", "StyleBlender", "StyleTriangle", "html", "phase_figure", "play", "strip", "style_space",
           "training_curves", "trajectory_figure"]  # fmt: skip


def __getattr__(name: str):
    """Import what is asked for: a web page needs no pyvista, a strip no plotly."""
    if name not in _HOME:
        raise AttributeError(f"toolkit.view has no {name!r}; it has {', '.join(__all__)}")
    return getattr(import_module(f"toolkit.view.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return __all__
