"""Pilots: functions (state, seconds) → `toolkit.runtime.Command` that can be combined, and written by users.

>>> from toolkit.shots import pilots
>>> walk = pilots.keep_distance(pilots.orbit((0, 0), 2.0, speed=1.0), lambda seconds: [(2.0, 0.0)], apart=0.8)
>>> walk = pilots.sequence((6.0, walk), (2.0, pilots.stop()))
>>> clip = tk.runtime.rollout(model, pilots.commands(walk, 8.0), bank["Neutral"])
"""

import functools
import math
from collections.abc import Callable, Sequence

import torch
from torch import Tensor

from toolkit.runtime import CharacterState, Command
from toolkit.runtime import Pilot as FramePilot
from toolkit.runtime.steering import unit
from toolkit.shots.course import FPS, LONGEST, Course, Heading, Pair, command

Pilot = Callable[[CharacterState, float], Command]  # of the state of B characters and the time, seconds
Places = Callable[[float], Sequence[Pair]]  # world (x, z) at a time

PULL = 2.0  # 1/s: gain of a distance that should be closed
NUDGE = 0.05  # seconds between two places of a leader whose velocity is estimated


def commands(pilot: Pilot, seconds: float) -> list[FramePilot]:
    """A pilot as commands for `toolkit.runtime.rollout`, one for each frame of so many seconds."""
    if not 0 <= seconds <= LONGEST:
        raise ValueError(f"seconds must be from 0 to {LONGEST:g}, got {seconds}")
    return [functools.partial(_now, pilot, frame / FPS) for frame in range(round(seconds * FPS))]


def _now(pilot: Pilot, seconds: float, state: CharacterState) -> Command:
    return pilot(state, seconds)


def keep(course: Course, heading: Heading) -> Pilot:
    """Keep to a planned course (`toolkit.shots.Shot.plan`)."""

    def pilot(state: CharacterState, seconds: float) -> Command:
        frame = round(seconds * FPS)
        asked = [command(course, heading, frame, tuple(place)) for place in state.root[:, :2].tolist()]
        return Command(*(torch.tensor(pairs, dtype=torch.float64) for pairs in zip(*asked, strict=True)))

    return pilot


def path(points: Sequence[Pair], speed: float, *, smooth: bool = True) -> Pilot:
    """Walk a curve through points at a speed, m/s, facing along it, and stand at its end."""
    return waypoints([(x, z, None) for x, z in points], speed, smooth=smooth)


def waypoints(points: Sequence[tuple[float, float, float | None]], speed: float, *, smooth: bool = True) -> Pilot:
    """Walk through points (x, z, seconds or None), at each in time; the ``speed``, m/s, is scaled where a time is given."""
    from toolkit.shots.shot import Shot

    return keep(*Shot(points, "any", [(0.0, speed)], smooth=smooth).plan())


def stop(facing: Pair = (0.0, 0.0)) -> Pilot:
    """Stand, facing a direction (x, z); zero keeps the present one."""
    return lambda state, seconds: Command((0.0, 0.0), facing)


def follow(leader: Callable[[float], Pair], distance: float = 1.0, speed: float = 2.0) -> Pilot:
    """Stay at a distance from a leader, whose place is a function of time, and face it; ``speed`` is the most, m/s."""

    def pilot(state: CharacterState, seconds: float) -> Command:
        now, before = (state.root.new_tensor(leader(t)) for t in (seconds, max(seconds - NUDGE, 0.0)))
        way = now - state.root[:, :2]
        velocity = (now - before) / NUDGE + PULL * (way - distance * unit(way))
        return Command(_limited(velocity, speed), unit(way))

    return pilot


def orbit(centre: Pair, radius: float, speed: float, *, left: bool = True) -> Pilot:
    """Walk a circle, with the centre to the left or the right hand."""

    def pilot(state: CharacterState, seconds: float) -> Command:
        out = state.root[:, :2] - state.root.new_tensor(centre)
        apart = out.norm(dim=-1, keepdim=True)
        out = unit(out)
        along = torch.stack((out[:, 1], -out[:, 0]), -1) * (1.0 if left else -1.0)
        return Command(_limited(speed * along + PULL * (radius - apart) * out, 1.5 * speed), along)

    return pilot


def keep_distance(pilot: Pilot, others: Places, apart: float = 0.8) -> Pilot:
    """Another pilot's command, without the part of its velocity that leads closer to others than so many metres."""

    def kept(state: CharacterState, seconds: float) -> Command:
        wanted = pilot(state, seconds)
        velocity = torch.as_tensor(wanted.velocity).to(state.root).expand(len(state.root), 2)
        for place in others(seconds):
            away = state.root[:, :2] - state.root.new_tensor(place)
            distance, away = away.norm(dim=-1, keepdim=True), unit(away)
            least = PULL * (apart - distance)  # velocity away from the other
            velocity = velocity + (least - (velocity * away).sum(-1, keepdim=True)).clamp_min(0.0) * away
        return Command(velocity, wanted.facing)

    return kept


def sequence(*parts: tuple[float, Pilot]) -> Pilot:
    """Pilots one after the other, each for so many seconds and with its own time from 0; the last one goes on."""
    if not parts or not all(math.isfinite(lasts) and lasts > 0 for lasts, _ in parts):
        raise ValueError("a sequence needs pairs (seconds above 0, pilot)")

    def pilot(state: CharacterState, seconds: float) -> Command:
        for lasts, part in parts[:-1]:
            if seconds < lasts - 1e-9:
                return part(state, seconds)
            seconds -= lasts
        return parts[-1][1](state, seconds)

    return pilot


def mix(first: Pilot, second: Pilot, share: Callable[[float], float]) -> Pilot:
    """The blend of two pilots' commands; ``share`` of the second is a function of time."""

    def pilot(state: CharacterState, seconds: float) -> Command:
        a, b, weight = first(state, seconds), second(state, seconds), share(seconds)
        pairs = zip((a.velocity, a.facing), (b.velocity, b.facing), strict=True)
        return Command(*(torch.lerp(*(torch.as_tensor(v).to(state.root) for v in both), weight) for both in pairs))

    return pilot


def _limited(velocity: Tensor, most: float) -> Tensor:
    return velocity * (most / velocity.norm(dim=-1, keepdim=True).clamp_min(1e-12)).clamp(max=1.0)
