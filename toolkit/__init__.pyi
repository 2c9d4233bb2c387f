"""What ``import toolkit`` offers.

The loader, which imports each name on first use, and type checkers read this file.
"""

from . import (
    datasets,
    evaluation,
    features,
    io,
    motion,
    networks,
    phases,
    runtime,
    styles,
    stylization,
    training,
    view,
)
from .evaluation import metrics as metrics
from .extra import shots as shots
from .extra.formats.inspection import inspect as inspect
from .io import bvh as bvh
from .io.load import load as load
from .io.save import save as save
from .motion import Clip as Clip, Skeleton as Skeleton, contacts as contacts
from .training import pretrained as pretrained, published as published

__version__: str
