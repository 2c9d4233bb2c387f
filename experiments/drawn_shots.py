"""Shots drawn at random: how well characters keep to them, and whether what `Shot.check` says is right.

Paths, styles, speeds, pauses and times lie in the range in which the styles walk, by a rule that shares nothing with the
plan: a walker of constant acceleration `PUSH`. Even seeds served to choose the gains of `toolkit.shots.course`, odd seeds
are the results.
"""

import dataclasses
import math
import random
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.shots import followed
from experiments.tables import Result
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.networks.bank import StyleBank
from toolkit.runtime import CharacterState
from toolkit.shots import Scene, Shot
from toolkit.shots.course import FPS, Curve
from toolkit.shots.feasibility import BESIDE, arrival, beside

PUSH = 1.0  # m/s², of the independent rule
SLOWEST = 0.25  # m/s: styles of a lower natural speed are not drawn, they hardly walk
PATIENCE = (0.9, 1.3)  # times the walker's, of an arrival time
STRAY = 0.3  # metres from the path, at most, of a shot that is met


def draw(seed: int, bank: StyleBank, hard: bool = False) -> Shot:
    """The shot of a seed; a ``hard`` one asks for twice to four times the speed, or for less than half of the time."""
    rng = random.Random(seed)
    names = [name for name in bank.names if bank.speed(name) >= SLOWEST]
    styles = [(4.0 * k, _blend(rng, names)) for k in range(rng.choice((1, 1, 2, 3)))]
    smooth = rng.random() < 0.6
    points, angle = [(0.0, 0.0)], rng.uniform(-math.pi, math.pi)
    for _ in range(rng.randint(2, 6)):
        leg, (x, z) = rng.uniform(1.5, 4.0), points[-1]
        points.append((x + leg * math.sin(angle), z + leg * math.cos(angle)))
        angle += math.radians(rng.uniform(-70, 70) if smooth else rng.uniform(-50, 50))
    knots = Curve(points, smooth).knots
    kind, share = rng.random(), rng.uniform(0.75, 1.25)
    holds = [(rng.uniform(0.8, 2.0), None, rng.uniform(0.2, 0.8) * knots[-1])] if rng.random() < 0.3 else []
    facing = look = None
    if kind < 0.15:
        facing = _direction(angle + rng.uniform(-1.5, 1.5))
    elif kind < 0.25:
        look = (rng.uniform(-8, 8), rng.uniform(-8, 8))
    share *= 0.7 if kind < 0.25 else 1.0  # sideways and backwards are slower
    share *= rng.uniform(2.0, 4.0) if hard else 1.0
    keyed = kind < 0.25 or hard or rng.random() < 0.5
    speeds = [(time, share * bank.speed(blend)) for time, blend in styles] if keyed else []
    timed = sorted(rng.sample(range(1, len(points)), rng.randint(1, 2))) if rng.random() < 0.5 else []
    shot = Shot(points, styles, speeds, holds, smooth=smooth, facing=facing, look_at=look, seed=seed, name=f"drawn {seed}")
    walker = [(key.time, key.speed) for key in shot.speeds] or [(time, bank.speed(blend)) for time, blend in styles]
    last, path = 0.0, list(shot.path)
    for k in timed:
        time = _walked(walker, knots[k], [(at, pause) for pause, _, at in holds])
        time *= rng.uniform(*PATIENCE) * (0.45 if hard else 1.0)
        last = max(time, last + (knots[k] - knots[timed[0]]) / walker[0][1] * PATIENCE[1])
        path[k] = dataclasses.replace(path[k], time=round(last, 2))
    return dataclasses.replace(shot, path=path)


def _blend(rng: random.Random, names: Sequence[str]) -> dict[str, float]:
    first, second = rng.sample(names, 2)
    share = rng.choice((1.0, round(rng.uniform(0.3, 0.7), 2)))
    return {first: 1.0} if share == 1.0 else {first: share, second: round(1 - share, 2)}


def _direction(angle: float) -> tuple[float, float]:
    return math.sin(angle), math.cos(angle)


def _walked(keys: Sequence[tuple[float, float]], goal: float, pauses: Sequence[tuple[float, float]]) -> float:
    """Seconds in which a walker with keyed speeds covers a distance, from standing, with all pauses before it."""
    at = speed = now = 0.0
    while at < goal:
        speed = min(speed + PUSH / FPS, [v for time, v in keys if time <= now][-1])
        at, now = at + speed / FPS, now + 1 / FPS
    return now + sum(pause + 2 * speed / PUSH for where, pause in pauses if where < goal)


@dataclasses.dataclass(frozen=True)
class Outcome:
    """What came of a shot: metres, m/s; ``met``: path and all arrivals."""

    mean: float
    worst: float
    end: float
    arrived: int
    timed: int
    skate: float
    said: tuple[str, ...] = ()  # by `Shot.check` of the same walk

    @property
    def met(self) -> bool:
        """Whether the mean and the largest distance and all arrivals are within the limits."""
        return self.mean <= BESIDE and self.worst <= STRAY and self.arrived == self.timed


def outcomes(net, bank: StyleBank, shots: Sequence[Shot], feet: bool = True) -> list[Outcome]:
    """What comes of each shot; all are rendered side by side."""
    plans = [shot.plan(bank) for shot in shots]
    states = list(Scene(shots).states(net, bank, plans))
    found = []
    for k, (shot, (course, _)) in enumerate(zip(shots, plans, strict=True)):
        own = states[: len(course.distance) - 1]
        places = [tuple(place) for place in torch.stack([s.root[k, :2] for s in own]).tolist()]
        apart = beside(course, places)
        hits = [arrival(course.curve.point(at), point.time, places) for point, at in
                zip(shot.path[1:], course.curve.knots[1:], strict=True) if point.time is not None]
        skate = _skate(net, own, k) if feet else math.nan
        found.append(Outcome(sum(apart) / len(apart), max(apart), math.dist(places[-1], course.curve.point(math.inf)),
                             sum(not seconds for seconds, _ in hits), len(hits), skate,
                             tuple(shot.unmet(bank, plans[k], places))))
    return found


def _skate(net, states: Sequence[CharacterState], character: int) -> float:
    clip = runtime.record(net, states, character=character)
    return max(metrics.foot_skate(clip, torch.stack([s.contacts[character] for s in states])).values())


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    count: Annotated[int, typer.Option(min=1, help="Number of shots.")] = 30,
    chosen: Annotated[bool, typer.Option("--chosen", help="The seeds that served to choose the gains.")] = False,
    save: Annotated[Path | None, typer.Option(help="Add the row to the result drawn-shots in this folder.")] = None,
) -> None:
    """Shots drawn at random: paths, arrivals, feet beside runtime.follow, and how often Shot.check is right."""
    net, bank = published.either(model, parameters)
    found = row(runtime.compile(net), bank, [2 * k + (not chosen) for k in range(count)])
    for name, value in found.items():
        print(f"{name:<12}{COLUMNS[name][0]:<60}{value:>10.4g}")
    if save is not None:
        Result("drawn-shots", f"{count} shots drawn at random, odd seeds, on which no gain was chosen; check is judged on "
               f"them and on {count} that ask for too much, from another start of the gait cycle; floor: runtime.follow, of "
               "the shots that it can express", "python -m experiments drawn-shots", {"model": ["model"]} | COLUMNS,
               [{"model": "embedded" if parameters is None else "published", **found}]).add(save)


#: Keys of a row: title, decimals, scale.
COLUMNS = {
    "shots": ["shots", 0], "mean": ["mean distance, cm", 1, 100], "worst": ["worst mean", 1, 100],
    "largest": ["largest distance", 1, 100], "arrived": ["arrivals met", 0], "timed": ["of", 0],
    "met": ["shots met", 0], "skate": ["skate, cm/s", 2, 100], "skate_worst": ["worst skate", 2, 100],
    "skating": ["over 1 cm/s", 0], "plain": ["shots of the floor", 0], "plain_mean": ["their mean distance", 1, 100],
    "floor_mean": ["that of the floor", 1, 100], "plain_largest": ["their largest", 1, 100],
    "floor_largest": ["that of the floor", 1, 100], "false": ["check warns, met", 0], "right": ["check warns, not met", 0],
    "silent": ["check silent, met", 0], "missed": ["check silent, not met", 0],
}


def row(net, bank: StyleBank, seeds: Sequence[int]) -> dict[str, float]:
    """The numbers of `COLUMNS`.

    `check` has another start of the gait cycle than the walks by which it is judged. Half of those shots ask for too much.
    """
    shots = [draw(seed, bank) for seed in seeds]
    found = outcomes(net, bank, shots)
    skates = [o.skate for o in found if math.isfinite(o.skate)]
    simple = [k for k, shot in enumerate(shots) if _simple(shot)]
    floor = [_floor(net, bank, shots[k]) for k in simple]
    hard = [draw(seed, bank, hard=True) for seed in seeds]
    told = [bool(o.said) for o in (*found, *outcomes(net, bank, hard, feet=False))]
    again = [dataclasses.replace(shot, seed=shot.seed + 1) for shot in (*shots, *hard)]
    met = [o.met for o in outcomes(net, bank, again, feet=False)]
    count = lambda said, good: sum(t is said and m is good for t, m in zip(told, met, strict=True))  # noqa: E731
    return {
        "shots": len(shots), "mean": _mean(o.mean for o in found), "worst": max(o.mean for o in found),
        "largest": max(o.worst for o in found), "arrived": sum(o.arrived for o in found),
        "timed": sum(o.timed for o in found), "met": sum(o.met for o in found), "skate": _mean(skates),
        "skate_worst": max(skates), "skating": sum(s > 0.01 for s in skates), "plain": len(simple),
        "plain_mean": _mean(found[k].mean for k in simple), "floor_mean": _mean(mean for mean, _ in floor),
        "plain_largest": max((found[k].worst for k in simple), default=math.nan),
        "floor_largest": max((largest for _, largest in floor), default=math.nan),
        "false": count(True, True), "right": count(True, False), "silent": count(False, True), "missed": count(False, False),
    }


def _mean(values) -> float:
    values = list(values)
    return sum(values) / len(values) if values else math.nan


def _simple(shot: Shot) -> bool:
    """Whether `toolkit.runtime.follow` can express the path: without pauses and times, facing along it."""
    return not (shot.holds or shot.facing or shot.look_at or any(p.time for p in shot.path))


def _floor(net, bank: StyleBank, shot: Shot) -> tuple[float, float]:
    course = shot.plan(bank)[0]
    apart = beside(course, [tuple(s.root[0, :2].tolist()) for s in followed(net, bank, shot, course)])
    return sum(apart) / len(apart), max(apart)
