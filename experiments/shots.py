"""How well characters keep to the shots of ``examples/shots``: the path, the arrivals, the feet."""

import math
from collections.abc import Iterable
from pathlib import Path

import torch

from experiments.tables import Result, Store
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.extra.shots import Scene
from toolkit.extra.shots.feasibility import arrival, beside
from toolkit.extra.shots.following import FPS
from toolkit.extra.shots.shot import Shot

FOLDER = Path(__file__).parents[1] / "examples" / "shots"
COLUMNS = {
    "model": ["model"], "shot": ["shot"], "seconds": ["s", 1],
    "mean": ["mean distance, cm", 1, 100],
    "largest": ["largest", 1, 100], "floor": ["floor: mean", 1, 100],
    "floor_largest": ["largest", 1, 100],
    "end": ["from the end, cm", 1, 100], "floor_end": ["floor", 1, 100],
    "skate": ["skate, cm/s", 2, 100],
    "floor_skate": ["floor", 2, 100], "timed": ["times asked", 0], "arrived": ["met", 0],
    "check": ["check says"],
}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    store: Store = False,
) -> None:
    """Distance from the path, arrivals and foot skate of every shot, beside the pilot of
    `toolkit.runtime.follow`.
    """
    net, bank = published.either(model, parameters)
    net, rows = runtime.compile(net), []
    name = "embedded" if parameters is None else "published"
    for file in sorted(FOLDER.glob("*.json")):
        scene = Scene.load(file)
        if scene.apart is None:  # who keeps apart leaves the path: `experiments.crowds`
            for shot in scene.shots:
                rows.append({"model": name, **row(net, bank, shot)})
    found = Result("shots", "the shots of examples/shots; the floor is the pilot of "
                   "toolkit.runtime.follow on the same path", "python -m experiments shots --store",
                   COLUMNS, rows)
    found.show(store)


def row(net, bank, shot: Shot) -> dict[str, float | str]:
    """The numbers of `COLUMNS`."""
    plan = shot.plan(bank)
    course, goal = plan[0], plan[0].curve.point(plan[0].curve.length)
    mine, skate = measured(net, Scene([shot]).states(net, bank, [plan]))
    floor, slide = measured(net, followed(net, bank, shot, course))
    apart, plain = beside(course, mine), beside(course, floor)
    hits = [arrival(course.curve.point(knot), point.time, mine)
            for point, knot in zip(shot.path[1:], course.curve.knots[1:], strict=True)
            if point.time is not None]
    return {"shot": shot.name, "seconds": len(mine) / FPS, "mean": sum(apart) / len(apart),
            "largest": max(apart),
            "floor": sum(plain) / len(plain), "floor_largest": max(plain),
            "end": math.dist(mine[-1], goal),
            "floor_end": math.dist(floor[-1], goal), "skate": skate, "floor_skate": slide,
            "timed": len(hits),
            "arrived": sum(not late for late, _ in hits), "check": "; ".join(shot.check(net, bank))}


def followed(net, bank, shot: Shot, course) -> Iterable[runtime.CharacterState]:
    """The same path and styles by `toolkit.runtime.follow`, at the mean speed of the plan while it
    moves.
    """
    seconds = (len(course.distance) - 1) / FPS
    curve = course.curve
    points = [*list(zip(curve.x, curve.z, strict=True))[::4], curve.point(curve.length)]
    points = [p for k, p in enumerate(points) if not k or math.dist(p, points[k - 1]) > 1e-3]
    speed = course.distance[-1] / (course.end or seconds)
    first = runtime.start(net, shot.style(bank)(0), points[0], curve.tangent(0.0))
    return runtime.states(net, runtime.follow(points, speed, seconds), shot.style(bank), first)


def measured(net,
             states: Iterable[runtime.CharacterState]) -> tuple[list[tuple[float, float]], float]:
    """The root's place at each frame, and the foot skate, m/s, the larger one of both feet."""
    states = list(states)
    clip = runtime.record(net, states)
    skate = metrics.foot_skate(clip, torch.stack([s.contacts[0] for s in states]))
    return [tuple(s.root[0, :2].tolist()) for s in states], max(skate.values())
