"""Pictures of motion: the mannequin, pyvista, strips of poses, films."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__)
