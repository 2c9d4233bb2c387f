"""Motion files and model files: read and written whole or not at all."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach(__name__, ["bvh", "files", "model_files"])
