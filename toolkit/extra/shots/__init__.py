"""Shots: paths, styles, speeds and pauses planned over time, and characters that keep to them."""

import pkgutil

import lazy_loader

from toolkit.extra.shots.keys import Hold, Pin, Point, SpeedKey, StyleKey
from toolkit.extra.shots.pins import pose
from toolkit.extra.shots.scene import Scene
from toolkit.extra.shots.shot import VERSION, Shot, data, load, parse, save

__all__ = [
    "VERSION", "Hold", "Pin", "Point", "Scene", "Shot", "SpeedKey", "StyleKey", "data", "load",
    "parse", "pose", "save",
]
MODULES = [found.name for found in pkgutil.iter_modules(__path__)]
__getattr__ = lazy_loader.attach(__name__, MODULES)[0]
