"""Skinned characters of one's own, and motion retargeted to their rigs."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__)
