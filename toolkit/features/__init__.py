"""Features of motion (Mason et al. 2022, section 3.2): columns, x, z and y of clips, and a store of them on the disk."""

import pkgutil

import lazy_loader

from toolkit.features import layout, splits

from toolkit.features.features import (CLIP_FRAMES, CLIP_HOP, FRAME_KINDS, KINDS, Features, Frames,  # isort: skip
                                       Normaliser, OwnFeatures, Rows, Split, build, check_style, check_style_clips,
                                       clip_starts, frames, group_features, joint_features, mean_velocity, moments,
                                       natural_speed, own_features, usable)
from toolkit.features.layout import CHANNELS, Layout, pack_joints, split_joints

__all__ = ["CHANNELS", "CLIP_FRAMES", "CLIP_HOP", "FRAME_KINDS", "KINDS", "Features", "Frames", "Layout", "Normaliser",
           "OwnFeatures", "Rows", "Split", "build", "check_style", "check_style_clips", "clip_starts", "frames",
           "group_features", "joint_features", "layout", "mean_velocity", "moments", "natural_speed", "own_features",
           "pack_joints", "split_joints", "splits", "usable"]
__getattr__ = lazy_loader.attach(__name__, [module.name for module in pkgutil.iter_modules(__path__)])[0]
