"""Shots: paths, styles, speeds and pauses planned over time, and characters that keep to them."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__, {
    "keys": ["Hold", "Pin", "Point", "SpeedKey", "StyleKey"], "pins": ["pose"], "scene": ["Scene"],
    "shot": ["VERSION", "Shot", "data", "parse", "save"]})
