"""Writers of files: glTF, OpenUSD, SMPL and ONNX."""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__)
