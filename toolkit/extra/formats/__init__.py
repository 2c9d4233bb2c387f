"""Motion files beside BVH, and what is guessed about files of unknown origin."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__)
