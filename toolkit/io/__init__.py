"""Motion files and model files: read and written whole or not at all."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__)
