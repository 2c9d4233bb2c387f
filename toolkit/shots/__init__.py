"""Shots: paths, styles, speeds and pauses planned over time, and characters that keep to them."""

from toolkit.shots import crowd, pilots
from toolkit.shots.preview import Preview
from toolkit.shots.scene import Scene
from toolkit.shots.shot import VERSION, Hold, Point, Shot, SpeedKey, StyleKey, data, load, parse, save

__all__ = ["VERSION", "Hold", "Point", "Preview", "Scene", "Shot", "SpeedKey", "StyleKey", "crowd", "data", "load",
           "parse", "pilots", "save"]
