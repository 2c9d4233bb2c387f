"""User commands, and how they are blended into the predicted trajectory (Mason et al. 2022, section 4.4; Zhang et al. 2018).

Shapes: B characters; world (x, z), metres and seconds.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit.motion import trajectory
from toolkit.motion.tensors import as_tensor, shown, summary
from toolkit.runtime.state import CharacterState

FPS = trajectory.FPS
GAIN = 0.25  # share of the difference between smoothed target and command that a frame removes
POSITION_BIAS, DIRECTION_BIAS = 0.75, 1.25  # exponents of the blend from the network's trajectory to the target
PROPORTIONAL, INTEGRAL, MAX_DRIVE = 1.5, 1.6, 12.0  # ours: gains (of the lag; per second) and limit of `speed_controller`
RETURN, SLOW, LOW = 3.0, 0.3, 0.2  # ours: gain of `steer` against a false velocity; it acts below this speed (m/s) or factor
LONGEST = 86_400.0  # seconds that `straight` and `follow` command: a day
LARGEST = 1e6  # of the numbers of a command: with much larger ones the network's output is not finite
LOOKAHEAD = 0.5  # seconds that a pilot looks ahead


@dataclass(frozen=True)
class Command:
    """A user command: ``velocity`` (x, z) in m/s and ``facing`` (x, z), both in the world.

    Each is a pair of numbers up to `LARGEST` for all characters or ``[B, 2]``; anything else is a ValueError. A zero facing
    keeps the current one.
    """

    velocity: Sequence[float] | Tensor = (0.0, 0.0)
    facing: Sequence[float] | Tensor = (0.0, 1.0)
    __repr__ = summary

    def __post_init__(self):
        for what, value in (("velocity", self.velocity), ("facing", self.facing)):
            if type(value) is tuple and len(value) == 2 and all(type(v) is float and abs(v) <= LARGEST for v in value):
                continue  # the checks below take ten times as long
            pairs = as_tensor(value, what).detach()
            if pairs.dim() not in (1, 2) or pairs.shape[-1] != 2:
                raise ValueError(f"{what} must be one pair (x, z), or [B, 2] of all characters; got {shown(value)}")
            if not pairs.is_meta and not bool((pairs.abs() <= LARGEST).all()):
                raise ValueError(f"{what} must be finite, up to {LARGEST:g}; got {shown(pairs.tolist())}")


Pilot = Callable[[CharacterState], Command]


def steer(state: CharacterState, command: Command,
          ahead: Sequence[int] = trajectory.SAMPLES[trajectory.SAMPLES.index(0) :]) -> tuple[Tensor, Tensor, Tensor]:
    """Smoothed velocity and facing ``[B, 2]``, and the future trajectory ``[B, S, 4]`` blended towards them (world).

    ``ahead`` are the offsets of the present and future samples, S in all, in frames (`toolkit.features.Layout.ahead`).

    Ours: the target velocity opposes a false velocity while the command is to stand, since the network would drift by 10 to
    25 cm/s, and while the speed factor is near 0, since a network can walk on by itself when it is.
    """
    like = {"dtype": state.velocity.dtype, "device": state.velocity.device}
    wanted, look = (torch.as_tensor(value, **like).reshape(-1, 2) for value in (command.velocity, command.facing))
    for pairs in (wanted, look):
        if len(pairs) not in (1, len(state.velocity)):
            raise ValueError(f"a command for {len(state.velocity)} characters needs one pair of numbers or "
                             f"{len(state.velocity)}, got {len(pairs)}")
    look = torch.where(look.norm(dim=-1, keepdim=True) > 1e-6, look, state.facing)
    velocity = torch.lerp(state.velocity, wanted, GAIN)
    facing = turn(state.facing, look, GAIN)
    t = torch.tensor(ahead[1:], **like) / ahead[-1]
    w_position, w_direction = 1 - (1 - t) ** POSITION_BIAS, 1 - (1 - t) ** DIRECTION_BIAS
    steps = state.future[:, 1:, :2] - state.future[:, :-1, :2]
    seconds = torch.tensor(ahead, **like).diff()[:, None] / FPS
    hold = (1.0 - torch.minimum(velocity.norm(dim=-1, keepdim=True) / SLOW, state.drive / LOW)).clamp_min(0.0)
    pull = state.drive * velocity + RETURN * hold * (velocity - _moved(state, -1))
    steps = torch.lerp(steps, pull[:, None] * seconds, w_position[:, None])
    positions = state.root[:, None, :2] + steps.cumsum(1)
    directions = turn(state.future[:, 1:, 2:], facing[:, None].expand_as(steps), w_direction)
    return velocity, facing, torch.cat((state.root[:, None], torch.cat((positions, directions), -1)), 1)


def speed_controller(state: CharacterState, velocity: Tensor) -> Tensor:
    """Drive ``[B, 1]`` of the next frame: grows while the character is slower than its command, shrinks while it is faster.

    Networks follow the blended trajectory at a fraction of its speed, and this fraction depends on the style. The published
    demo compensates for it by a table of target speeds "in its own units", several times the speed reached. We use an
    incremental proportional-integral controller instead. Its gains grow with the drive. So a command is in m/s for every
    model and style. Without the proportional part some styles alternate between walk and run, or stay in a run.
    """
    wanted, heading = velocity.norm(dim=-1, keepdim=True), unit(velocity)

    def lag(now: int) -> Tensor:
        reached = (_moved(state, now) * heading).sum(-1, keepdim=True)
        return ((wanted - reached) / wanted.clamp_min(0.5)).clamp(-1.0, 1.0)

    push = PROPORTIONAL * (lag(-1) - lag(-2)) + INTEGRAL / FPS * lag(-1)
    driven = (state.drive + state.drive.clamp_min(1.0) * push).clamp(0.0, MAX_DRIVE)
    return torch.where(wanted > 0.1, driven, torch.lerp(state.drive, torch.ones_like(driven), 0.05))


def _moved(state: CharacterState, now: int) -> Tensor:
    """Velocity ``[B, 2]`` of the root over half a second up to frame ``now`` of the history, m/s."""
    half_second = FPS // 2
    return (state.history[:, now, :2] - state.history[:, now - half_second, :2]) * (FPS / half_second)


def straight(speed: float = 1.2, seconds: float = 10.0, facing: Sequence[float] = (0.0, 1.0)) -> list[Command]:
    """Commands that walk straight ahead at ``speed`` m/s; ValueError if it is not finite or the time not 0 to `LONGEST`."""
    if not (math.isfinite(speed) and 0 <= seconds < math.inf):
        raise ValueError(f"speed and seconds must be finite and seconds not negative, got {speed} and {seconds}")
    if seconds > LONGEST:
        raise ValueError(f"commands are for at most {LONGEST:g} seconds, got {seconds:g}")
    forward = unit(as_tensor(facing, "facing", torch.float64))
    return [Command(tuple((speed * forward).tolist()), tuple(forward.tolist()))] * round(seconds * FPS)


def follow(points: Sequence[Sequence[float]], speed: float = 1.2, seconds: float | None = None) -> list[Pilot]:
    """Pilots that keep a character on a polyline at constant speed, facing along it, and stop at its end.

    Parameters
    ----------
    points
        Two or more different (x, z), metres.
    speed
        Metres per second.
    seconds
        Duration; by default the time that the path takes.
    """
    path = as_tensor(points, "points", torch.float64).cpu()
    legs = (path[1:] - path[:-1]).norm(dim=-1)
    if path.dim() != 2 or path.shape[1] != 2 or not len(legs) or not bool(((legs > 1e-6) & legs.isfinite()).all()):
        raise ValueError(f"a path needs two or more different (x, z) points, all finite; got {list(path.shape)}")
    ends = legs.cumsum(0)
    lasts = float(ends[-1]) / max(speed, 1e-300) if seconds is None else seconds
    if not (0 < speed < math.inf and 0 <= lasts <= LONGEST):
        raise ValueError("speed must be positive, seconds not negative and both finite, with at most "
                         f"{LONGEST:g} seconds in all; got {speed} and {lasts}")

    def point(distance: float) -> Tensor:
        leg = min(int((ends <= distance).sum()), len(legs) - 1)
        share = min(1.0, (distance - float(ends[leg] - legs[leg])) / float(legs[leg]))
        return torch.lerp(path[leg], path[leg + 1], share)

    def pilot(distance: float) -> Pilot:
        goal, ahead = point(distance + LOOKAHEAD * speed), point(distance + LOOKAHEAD * speed + 0.05)
        tangent = ahead - goal if float((ahead - goal).norm()) > 1e-6 else path[-1] - path[-2]
        return lambda state: towards(state, goal, tangent, speed)

    return [pilot(frame / FPS * speed) for frame in range(math.ceil(lasts * FPS))]


def towards(state: CharacterState, goal: Tensor, facing: Tensor, speed: float | Tensor) -> Command:
    """Command towards ``goal [2]`` or ``[B, 2]``, a path's point `LOOKAHEAD` later; late characters walk faster."""
    velocity = (goal.to(state.root) - state.root[:, :2]) / LOOKAHEAD
    fast = velocity.norm(dim=-1, keepdim=True).clamp_min(1e-6)
    return Command(velocity * (1.5 * speed / fast).clamp(max=1.0), facing)


def unit(v: Tensor) -> Tensor:
    """Vectors ``[..., n]`` at length 1."""
    return torch.nn.functional.normalize(v, dim=-1)


def turn(a: Tensor, b: Tensor, share: Tensor | float) -> Tensor:
    """Unit directions ``[..., 2]`` turned from a to b along the shorter way by a share ``[...]``."""
    angle = torch.atan2(a[..., 0], a[..., 1])
    difference = torch.atan2(b[..., 0], b[..., 1]) - angle
    angle = angle + share * torch.atan2(difference.sin(), difference.cos())
    return torch.stack((angle.sin(), angle.cos()), -1)
