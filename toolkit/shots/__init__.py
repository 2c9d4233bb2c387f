"""Shots: paths, styles, speeds and pauses planned over time, and characters that keep to them."""

from toolkit.shots import pilots
from toolkit.shots.preview import Preview
from toolkit.shots.scene import Scene
from toolkit.shots.shot import Hold, Point, Shot, SpeedKey, StyleKey, load, parse, save

__all__ = ["Hold", "Point", "Preview", "Scene", "Shot", "SpeedKey", "StyleKey", "load", "parse", "pilots", "save"]
