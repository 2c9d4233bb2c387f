"""Motion data: rotations, skeleton and clip, root trajectory, foot contacts, inverse kinematics."""

from toolkit import registry
from toolkit.motion import contacts, ik, rotations, trajectory
from toolkit.motion.clip import Clip, RootFrames, on_cpu, root_frames
from toolkit.motion.roles import ROLES
from toolkit.motion.skeleton import Skeleton, forward_kinematics, local_rotations

__all__ = ["ROLES", "Clip", "RootFrames", "Skeleton", "contacts", "forward_kinematics",
           "ik", "local_rotations", "on_cpu", "root_frames", "rotations", "trajectory"]
__getattr__ = registry.attributes(__name__)
