"""Features of motion (Mason et al. 2022, section 3.2): columns, and x, z and y of clips."""

from toolkit import registry
from toolkit.features import layout, splits

from toolkit.features.features import (  # isort: skip
    CLIP_FRAMES, CLIP_HOP, FRAME_KINDS, KINDS, Features, Frames, OwnFeatures, Split, build,
    check_style, frames, joint_features, mean_velocity, natural_speed, own_features,
    recordings, seen_from, usable,
)
from toolkit.features.layout import CHANNELS, Layout, pack_joints, split_joints
from toolkit.features.statistics import Normaliser, Rows, moments

__all__ = [
    "CHANNELS", "CLIP_FRAMES", "CLIP_HOP", "FRAME_KINDS", "KINDS", "Features", "Frames", "Layout",
    "Normaliser", "OwnFeatures", "Rows", "Split", "build", "check_style", "frames",
    "joint_features", "layout", "mean_velocity", "moments", "natural_speed", "own_features",
    "pack_joints", "recordings", "seen_from", "split_joints", "splits", "usable",
]
__getattr__ = registry.attributes(__name__)
