"""Widgets of notebooks: players and the live character."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__)
