"""The functions of all modules of the package, for the loader and for type checkers."""

from .bodies import (
    hips_height as hips_height,
    hips_path as hips_path,
    on_feet as on_feet,
    path_error as path_error,
    posture as posture,
    speed as speed,
    upright as upright,
)
from .pairs import (
    check_pair as check_pair,
    geodesic as geodesic,
    global_position as global_position,
    global_quaternion as global_quaternion,
    npss as npss,
    orientation_error as orientation_error,
    phase_error as phase_error,
    stop as stop,
    trajectory_error as trajectory_error,
)
from .quality import (
    floor as floor,
    jerk as jerk,
    motion as motion,
    shake as shake,
    skate as skate,
    slow_motion as slow_motion,
    stretch as stretch,
    through as through,
)
from .sets import (
    diversity as diversity,
    fmd as fmd,
    frechet_distance as frechet_distance,
    multimodality as multimodality,
    nearest as nearest,
    recognition as recognition,
)
from .steps import (
    feet as feet,
    foot_skate as foot_skate,
    skate_camdm as skate_camdm,
    skate_kimodo as skate_kimodo,
    skate_rsmt as skate_rsmt,
    skate_smoodi as skate_smoodi,
    step_rate as step_rate,
)
