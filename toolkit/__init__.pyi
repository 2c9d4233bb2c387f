"""What ``import toolkit`` offers: for the loader, which imports it on first use, and for type checkers."""

from . import (
    bvh,
    comparison,
    contacts,
    crowd,
    datasets,
    demo,
    evaluation,
    export,
    features,
    ik,
    metrics,
    motion,
    networks,
    phases,
    published,
    recognition,
    rotations,
    runtime,
    sampling,
    steering,
    store,
    styles,
    stylization,
    training,
    trajectory,
    view,
)
from .motion import Clip as Clip
from .motion import Skeleton as Skeleton
from .training import pretrained as pretrained

__version__: str
