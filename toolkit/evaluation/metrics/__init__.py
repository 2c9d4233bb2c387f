"""Measures of motion that a mean squared error does not show. Metres, seconds, radians.

Where a measure has a source, its docstring names it and says where we depart from it.
`toolkit.evaluation.table` sorts those of the field by what they need.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
