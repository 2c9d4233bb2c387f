"""What a moving body is: rotations, skeleton and clip, root trajectory, foot contacts, inverse kinematics, retargeting."""

from toolkit.motion import rotations
from toolkit.motion.clip import (
           ROLES,
           Clip,
           RootFrames,
           Skeleton,
           find_roles,
           forward_kinematics,
           local_rotations,
           on_cpu,
           root_frames,
)

from toolkit.motion import contacts, ik, retargeting, trajectory  # isort: skip

__all__ = ["ROLES", "Clip", "RootFrames", "Skeleton", "contacts", "find_roles", "forward_kinematics", "ik",
           "local_rotations", "on_cpu", "retargeting", "root_frames", "rotations", "trajectory"]
