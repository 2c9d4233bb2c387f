"""Stylised character animation: Mason et al. 2022 and Park et al. 2021 in plain Python.

Glossary of shapes: B batch, F frames, J joints, K experts, D features. Metres, seconds, radians, Y up, left is +X.

>>> import toolkit as tk
>>> clips = tk.datasets.load("procedural", styles=["Neutral", "Zombie"])
>>> data = tk.features.build(clips)
"""

import importlib

from toolkit import (
    bvh,
    comparison,
    contacts,
    datasets,
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
)
from toolkit.motion import Clip, Skeleton
from toolkit.training import pretrained

__version__ = "0.1.0"
__all__ = [
    "Clip", "Skeleton", "bvh", "comparison", "contacts", "datasets", "evaluation", "export", "features", "ik",
    "metrics", "motion", "networks", "phases", "pretrained", "published", "recognition", "rotations", "runtime",
    "sampling", "steering", "store", "styles", "stylization", "training", "trajectory", "view",
]  # fmt: skip


def __getattr__(name: str):
    if name == "view":  # pulls in plotting and rendering libraries, so only on demand
        return importlib.import_module("toolkit.view")
    raise AttributeError(f"module 'toolkit' has no attribute {name!r}")
