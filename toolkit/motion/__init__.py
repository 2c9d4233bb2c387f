"""Motion data: rotations, skeleton and clip, root trajectory, foot contacts, inverse kinematics, retargeting."""

from toolkit.motion import contacts, ik, retargeting, rotations, trajectory

from toolkit.motion.clip import (ROLES, Clip, RootFrames, Skeleton, find_roles, forward_kinematics,  # isort: skip
                                 local_rotations, on_cpu, root_frames)

__all__ = ["ROLES", "Clip", "RootFrames", "Skeleton", "contacts", "find_roles", "forward_kinematics", "ik",
           "local_rotations", "on_cpu", "retargeting", "root_frames", "rotations", "trajectory"]
