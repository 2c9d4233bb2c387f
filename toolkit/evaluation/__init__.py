"""Measures of motion that the error one step ahead does not show, a recogniser of styles, and
defects of finished motion.
"""

from toolkit import registry

__getattr__, __dir__, __all__ = registry.modules(__name__, __path__, {
    "table": ["MEASURES", "report"], "findings": ["defects", "Finding"]})
