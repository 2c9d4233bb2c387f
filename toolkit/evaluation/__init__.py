"""Measures of motion that the error one step ahead does not show, a recogniser of styles, and
defects of finished motion.
"""

import pkgutil

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach(
    __name__,
    [module.name for module in pkgutil.iter_modules(__path__)],
    {"table": ["MEASURES", "report"], "findings": ["defects", "Finding"]},
)
