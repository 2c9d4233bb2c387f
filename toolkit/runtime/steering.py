"""User commands, and how they are blended into the predicted trajectory (see `runtime.frame`).

Shapes: B characters; world (x, z), metres and seconds.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import torch
from torch import Tensor

from toolkit.motion import rotations as R, trajectory
from toolkit.motion.tensors import as_tensor, shown, summary
from toolkit.runtime.state import CharacterState, pairs_of

FPS = trajectory.FPS
GAIN = 0.25  # share of the difference between smoothed target and command that a frame removes
# Ours: m/s² and radians per second by which the smoothed target changes at most. With a half turn
# in a few frames, knees and wrists jumped.
FASTEST, SPIN = 4.0, math.pi
# Exponents of the blend from the network's trajectory to the target.
POSITION_BIAS, DIRECTION_BIAS = 0.75, 1.25
# Ours: gains (of the lag; per second) and limit of `speed_controller`.
PROPORTIONAL, INTEGRAL, MAX_DRIVE = 1.5, 1.6, 12.0
# Ours: gain of `steer` against a false velocity; it acts below this speed (m/s) or factor.
RETURN, SLOW, LOW = 3.0, 0.3, 0.2
# Ours: gains (of the lateral speed; of its sum a frame) of `direction_controller`.
SIDEWAYS, SIDEWAYS_SUM = 1.0, 0.02
FORGET = 0.95  # share of `CharacterState.aside` that is left after a frame of standing
# Ours: seconds in which `CharacterState.rest` grows to 1, and falls to 0.
STANDING, STARTING = 0.6, 0.2
ASKED = 1 / 15  # share of the difference that a frame removes, for `CharacterState.asked`
ALIGNED = 0.87, 0.985  # cosines of the angle to the commanded facing: may begin to stand, may stand
MOVES = 0.1  # m/s; slower commands are to stand
LONGEST = 86_400.0  # seconds that `straight` and `follow` command: a day
LARGEST = 1e6  # number of a command: with much larger ones the network's output is not finite
LOOKAHEAD = 0.5  # seconds that a pilot looks ahead


@dataclass(frozen=True, eq=False)
class Command:
    """A user command: ``velocity`` (x, z) in m/s and ``facing`` (x, z), both in the world.

    Each is a pair of numbers up to `LARGEST` for all characters or ``[B, 2]``; anything else is a
    ValueError. A zero facing keeps the current one.
    """

    velocity: Sequence[float] | Tensor = (0.0, 0.0)
    facing: Sequence[float] | Tensor = (0.0, 1.0)
    __repr__ = summary

    def __post_init__(self):
        for what, value in (("velocity", self.velocity), ("facing", self.facing)):
            # A pair of floats is checked here, because the checks below take ten times as long.
            is_pair = type(value) is tuple and len(value) == 2
            if is_pair and all(type(v) is float and abs(v) <= LARGEST for v in value):
                continue
            pairs = as_tensor(value, what).detach()
            if pairs.dim() not in (1, 2) or pairs.shape[-1] != 2:
                raise ValueError(f"{what} must be one pair (x, z), or [B, 2] of all characters; "
                                 f"got {shown(value)}")
            if not pairs.is_meta and not bool((pairs.abs() <= LARGEST).all()):
                got = shown(pairs.tolist())
                raise ValueError(f"{what} must be finite, up to {LARGEST:g}; got {got}")


Pilot = Callable[[CharacterState], Command]


def steer(state: CharacterState, command: Command,
          ahead: Sequence[int] = trajectory.SAMPLES[trajectory.SAMPLES.index(0) :],
          ) -> CharacterState:
    """The state with its future trajectory ``[B, S, 4]`` blended towards the command.

    ``ahead`` are the offsets of the present and future samples, S in all, in frames
    (`toolkit.features.Layout.ahead`).

    Departures from the published run:

    - The smoothed target changes by at most `FASTEST` and `SPIN`.
    - The target velocity is corrected for the error of the root's: its lateral part while the
      character walks (`direction_controller`), all of it while the command or the speed factor is
      near 0, since a network can walk on by itself. The error is the difference from ``asked``, the
      command as slowly as a character follows it, or, if it is to stop, from the smoothed command.
    - While the command is to stand, the weights of the blend grow to 1.
    - A character that is to walk, but stands or slowly goes elsewhere, follows the target alone: a
      network that has learnt to walk backwards may begin with that.
    """
    wanted = pairs_of(command.velocity, "velocity", state.velocity)
    look = pairs_of(command.facing, "facing", state.velocity)

    # Smoothed command; a zero facing keeps the current one.
    look = torch.where(R.length(look) > 1e-6, look, state.facing)
    change = GAIN * (wanted - state.velocity)
    velocity = state.velocity + R.limited(change, FASTEST / FPS)
    facing = turn(state.facing, look, GAIN, SPIN / FPS)

    # Standing: a share that grows while the command is to stand.
    speed = R.length(velocity)
    change = torch.where(speed < MOVES, 1 / (STANDING * FPS), -1 / (STARTING * FPS))
    rest = (state.rest + change).clamp(0.0, 1.0)

    # Target velocity, of three parts: the command times the factor of the speed controller; the
    # correction of one that is to stand or stop (`slow` is 1) to the velocity that it should have,
    # `wanted_now`; and `across`, against the lateral velocity.
    asked, aside, across = direction_controller(state, velocity)
    slow = (1.0 - torch.minimum(speed / SLOW, state.drive / LOW)).clamp_min(0.0)
    moved = _moved(state, -1)
    walks = R.length(wanted) / R.length(moved).clamp_min(SLOW)
    wanted_now = torch.lerp(velocity, asked, walks.clamp_max(1.0))
    pull = state.drive * velocity + RETURN * slow * (wanted_now - moved) + across

    # A character that stands still, or goes elsewhere at low speed, does not go where it should.
    along = (moved * R.normalize(velocity)).sum(-1, keepdim=True) / (LOW * speed).clamp_min(1e-6)
    slowly = (2.0 - R.length(moved) / SLOW).clamp(0.0, 1.0)
    astray = _moves(speed) * slowly * (1.0 - along).clamp(0.0, 1.0)

    # Shares of the target in the blend: they grow with time, with standing, and if it goes astray.
    t = state.velocity.new_tensor(ahead[1:]) / ahead[-1]
    w_position = torch.lerp(1 - (1 - t) ** POSITION_BIAS, torch.ones_like(t), rest.maximum(astray))
    w_direction = torch.lerp(1 - (1 - t) ** DIRECTION_BIAS, torch.ones_like(t), rest)

    # Positions: the steps between the samples are blended, not the samples, and added up from the
    # root.
    steps = state.future[:, 1:, :2] - state.future[:, :-1, :2]
    seconds = state.velocity.new_tensor(ahead).diff()[:, None] / FPS
    steps = torch.lerp(steps, pull[:, None] * seconds, w_position[..., None])
    positions = state.root[:, None, :2] + steps.cumsum(1)

    # Directions turn towards the facing.
    directions = turn(state.future[:, 1:, 2:], facing[:, None].expand_as(steps), w_direction)
    future = torch.cat((state.root[:, None], torch.cat((positions, directions), -1)), 1)
    return replace(
        state, velocity=velocity, facing=facing, future=future, asked=asked, aside=aside, rest=rest,
        drive=speed_controller(state, velocity))


def direction_controller(state: CharacterState, velocity: Tensor) -> tuple[Tensor, Tensor, Tensor]:
    """``asked [B, 2]``, ``aside [B, 1]`` and the change ``[B, 2]`` of the target velocity, m/s.

    The first two are those of the next frame.

    Networks do not walk exactly where they are told to: in half of the published one's styles, the
    direction of a straight walk was over 5 degrees wrong. A proportional-integral controller
    opposes the lateral velocity over half a second, compared with the command smoothed over the
    same time, so that turns are no errors.
    """
    # The lateral velocity, positive to the left.
    asked = torch.lerp(state.asked, velocity, ASKED)
    heading = R.normalize(velocity)
    left = torch.stack((heading[:, 1], -heading[:, 0]), -1)
    lateral = ((_moved(state, -1) - asked) * left).sum(-1, keepdim=True)

    # Its sum over time, which a standing character forgets.
    moves = R.length(velocity) > MOVES
    learnt = (state.aside + SIDEWAYS_SUM * lateral).clamp(-1.0, 1.0)
    aside = torch.where(moves, learnt, FORGET * state.aside)

    # Proportional and integral part, against the lateral velocity.
    push = _moves(R.length(velocity)) * (SIDEWAYS * lateral + aside)
    return asked, aside, -push * state.drive.clamp_min(1.0) * left


def standing(state: CharacterState, root: Tensor) -> Tensor:
    """Share ``[B, 1]`` of standing still.

    It is `rest`, once the root ``[B, 4]`` looks into the commanded direction.
    """
    along = (root[:, 2:] * state.facing).sum(-1, keepdim=True)
    return state.rest * ((along - ALIGNED[0]) / (ALIGNED[1] - ALIGNED[0])).clamp(0.0, 1.0)


def speed_controller(state: CharacterState, velocity: Tensor) -> Tensor:
    """Drive ``[B, 1]`` of the next frame.

    It grows while the character is slower than its command, and shrinks while it is faster.

    Networks follow the blended trajectory at a fraction of its speed, which depends on the style.
    The published demo compensates for it by a table of target speeds, several times the speed
    reached. Here a command is in m/s for every model and style, by an incremental
    proportional-integral controller. Without the proportional part some styles alternate between
    walk and run, or stay in a run.
    """
    wanted, heading = R.length(velocity), R.normalize(velocity)

    def lag(now: int) -> Tensor:
        reached = (_moved(state, now) * heading).sum(-1, keepdim=True)
        return ((wanted - reached) / wanted.clamp_min(0.5)).clamp(-1.0, 1.0)

    # Incremental form: the change of the lag, and the lag itself.
    push = PROPORTIONAL * (lag(-1) - lag(-2)) + INTEGRAL / FPS * lag(-1)
    driven = (state.drive + state.drive.clamp_min(1.0) * push).clamp(0.0, MAX_DRIVE)

    # While the command is to stand, the drive goes back to 1.
    relaxed = torch.lerp(state.drive, torch.ones_like(driven), 0.05)
    return torch.where(wanted > MOVES, driven, relaxed)


def _moves(speed: Tensor) -> Tensor:
    """Share of walking, which grows with a commanded speed from `MOVES` to `SLOW`."""
    return ((speed - MOVES) / (SLOW - MOVES)).clamp(0.0, 1.0)


def _moved(state: CharacterState, now: int) -> Tensor:
    """Velocity ``[B, 2]`` of the root, m/s: over half a second up to ``now`` (-1: at present)."""
    half_second = FPS // 2
    moved = state.history[:, now, :2] - state.history[:, now - half_second, :2]
    return moved * (FPS / half_second)


def straight(speed: float = 1.2, seconds: float = 10.0,
             facing: Sequence[float] = (0.0, 1.0)) -> list[Command]:
    """Commands that walk straight ahead at ``speed`` m/s.

    ValueError if ``seconds`` is not 0 to `LONGEST`, ``facing`` is zero, or `Command` refuses it.
    """
    speed, seconds = as_tensor((speed, seconds), "speed and seconds", torch.float64).tolist()
    if not 0 <= seconds <= LONGEST:
        raise ValueError(f"seconds must be from 0 to {LONGEST:g}, got {seconds}")
    forward = R.normalize(as_tensor(facing, "facing", torch.float64))
    if not forward.any():
        raise ValueError("facing is the direction of the walk, and must not be zero")
    command = Command(tuple((speed * forward).tolist()), tuple(forward.tolist()))
    return [command] * round(seconds * FPS)


def follow(points: Sequence[Sequence[float]], speed: float = 1.2,
           seconds: float | None = None) -> list[Pilot]:
    """Pilots that keep a character on a polyline at constant speed, facing along it, and stop at
    its end.

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
    speed = float(as_tensor(speed, "speed", torch.float64))
    pairs = path.dim() == 2 and path.shape[1] == 2 and len(path) > 1
    legs = (path[1:] - path[:-1]).norm(dim=-1) if pairs else path.new_tensor([math.nan])
    ends = legs.cumsum(0)  # distances along the path at the ends of its legs
    if seconds is None:
        seconds = float(ends[-1]) / max(speed, 1e-300)
    if not (((legs > 1e-6) & legs.isfinite()).all() and 0 < speed < math.inf
            and 0 <= seconds <= LONGEST):
        raise ValueError("a path needs two or more different (x, z) points, all finite, a positive "
                         f"speed and 0 to {LONGEST:g} s; got {list(path.shape)}, {speed:g} m/s, "
                         f"{seconds} s")

    def point(distance: float) -> Tensor:
        leg = min(int((ends <= distance).sum()), len(legs) - 1)
        share = min(1.0, (distance - float(ends[leg] - legs[leg])) / float(legs[leg]))
        return torch.lerp(path[leg], path[leg + 1], share)

    def pilot(distance: float) -> Pilot:
        goal = point(distance + LOOKAHEAD * speed)
        ahead = point(distance + LOOKAHEAD * speed + 0.05)
        tangent = ahead - goal if float((ahead - goal).norm()) > 1e-6 else path[-1] - path[-2]
        return lambda state: towards(state, goal, tangent, speed)

    return [pilot(frame / FPS * speed) for frame in range(math.ceil(seconds * FPS))]


def towards(state: CharacterState, goal: Tensor, facing: Tensor, speed: float | Tensor) -> Command:
    """Command towards ``goal [2]`` or ``[B, 2]``, a path's point `LOOKAHEAD` later.

    Late characters walk faster.
    """
    velocity = (goal.to(state.root) - state.root[:, :2]) / LOOKAHEAD
    fast = R.length(velocity).clamp_min(1e-6)
    return Command(velocity * (1.5 * speed / fast).clamp(max=1.0), facing)


def turn(a: Tensor, b: Tensor, share: Tensor | float, most: float = math.inf) -> Tensor:
    """Unit directions ``[..., 2]`` turned from a towards b, the shorter way.

    By a share ``[...]`` of the angle between them, but at most by ``most`` radians.
    """
    angle = torch.atan2(a[..., 0], a[..., 1])
    difference = torch.atan2(b[..., 0], b[..., 1]) - angle
    angle = angle + (share * torch.atan2(difference.sin(), difference.cos())).clamp(-most, most)
    return torch.stack((angle.sin(), angle.cos()), -1)
