"""StyleWalk: a frozen benchmark of steered walks in a style, for models and for anybody's files."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__, {
    "tracks": ["PLAN", "commands", "walk"], "scores": ["score", "table", "Scores"],
    "judges": ["Judges"]})
