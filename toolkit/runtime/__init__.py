"""A character under control, one frame at a time (Mason et al. 2022, section 4.4)."""

from toolkit import registry
from toolkit.runtime.frame import FPS, pose, start, step, world_joints
from toolkit.runtime.recording import record, rollout, states
from toolkit.runtime.state import CharacterState
from toolkit.runtime.steering import Command, Pilot, follow, speed_controller, steer, straight

__all__ = ["FPS", "CharacterState", "Command", "Pilot", "compile", "follow", "pose", "record",
           "rollout", "speed_controller", "start", "states", "steer", "step", "straight",
           "world_joints"]
__getattr__ = registry.attributes(__name__)
