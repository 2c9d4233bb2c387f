"""StyleWalk: a frozen benchmark of steered walks in a style, for models and for anybody's files."""

import pkgutil

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach(
    __name__,
    [module.name for module in pkgutil.iter_modules(__path__)],
    {"tracks": ["PLAN", "commands", "walk"], "scores": ["score", "table", "Scores"],
     "judges": ["Judges"]},
)
