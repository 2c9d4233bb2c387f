"""Measures of motion: what an error one step ahead does not tell."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach(
    __name__, ["classifier", "metrics", "models", "phases", "recognition", "stylization"]
)
