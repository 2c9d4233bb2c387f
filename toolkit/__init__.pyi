"""What ``import toolkit`` offers: for the loader, which imports it on first use, and for type checkers."""

from . import (
    course,
    datasets,
    evaluation,
    export,
    features,
    io,
    motion,
    networks,
    phases,
    runtime,
    shots,
    styles,
    stylization,
    training,
    view,
)
from .evaluation import metrics as metrics
from .io import bvh as bvh
from .io.load import inspect as inspect
from .io.load import load as load
from .motion import Clip as Clip
from .motion import Skeleton as Skeleton
from .motion import contacts as contacts
from .training import pretrained as pretrained
from .training import published as published

__version__: str
