"""Measures of motion that a mean squared error does not show. Metres, seconds, radians.

Where a measure has a source, its docstring names it and says where we depart from it.
`toolkit.evaluation.table` sorts those of the field by what they need.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach(__name__, submod_attrs={
    "bodies": ["hips_height", "hips_path", "on_feet", "path_error", "speed", "upright"],
    "pairs": ["check_pair", "geodesic", "global_position", "npss", "phase_error", "stop",
              "trajectory_error"],
    "quality": ["floor", "jerk", "motion", "shake", "skate", "slow_motion", "stretch", "through"],
    "sets": ["diversity", "fmd", "frechet_distance", "multimodality", "nearest", "recognition"],
    "steps": ["feet", "foot_skate", "skate_camdm", "skate_kimodo", "skate_rsmt", "skate_smoodi",
              "step_rate"],
})
