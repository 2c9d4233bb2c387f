"""Shots: paths, styles, speeds and pauses planned over time, and characters that keep to them."""

import pkgutil

import lazy_loader

from toolkit.extra.shots import crowd
from toolkit.extra.shots.keys import Hold, Point, SpeedKey, StyleKey
from toolkit.extra.shots.scene import Scene
from toolkit.extra.shots.shot import VERSION, Shot, data, load, parse, save

__all__ = [
    "VERSION", "Hold", "Point", "Scene", "Shot", "SpeedKey", "StyleKey", "crowd", "data", "load",
    "parse", "save",
]
MODULES = [found.name for found in pkgutil.iter_modules(__path__)]
__getattr__ = lazy_loader.attach(__name__, MODULES)[0]
