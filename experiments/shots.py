"""How well characters keep to the shots of ``examples/shots``: the path, the arrivals, the feet."""

import math
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.shots import Scene
from toolkit.shots.course import FPS
from toolkit.shots.feasibility import arrival, beside
from toolkit.shots.shot import Shot

FOLDER = Path(__file__).parents[1] / "examples" / "shots"


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    folder: Annotated[Path, typer.Option(help="Folder of shot files.")] = FOLDER,
    plain: Annotated[bool, typer.Option("--plain", help="The plain runtime, not the compiled one.")] = False,
) -> None:
    """Distance from the path, arrivals and foot skate of every shot, beside the pilot of `toolkit.runtime.follow`."""
    net, bank = published.either(model, parameters)
    net = net if plain else runtime.compile(net)
    print("Distances in cm, skate in cm/s of toes in contact, of the worse foot; floor: runtime.follow")
    print(f"{'shot':<18}{'s':>6}{'mean':>7}{'worst':>7}{'floor':>7}{'worst':>7}  {'end':>5}{'floor':>7}{'skate':>7}"
          f"{'floor':>7}  arrivals (s, cm); check")
    for file in sorted(folder.glob("*.json")):
        scene = Scene.load(file)
        if scene.apart is None:  # who keeps apart leaves the path: `experiments.crowds`
            for shot in scene.shots:
                print(row(net, bank, shot))


def row(net, bank, shot: Shot) -> str:
    """A line of the table."""
    plan = shot.plan(bank)
    course, goal = plan[0], plan[0].curve.point(plan[0].curve.length)
    mine, skate = measured(net, shot.states(net, bank, plan))
    floor, slide = measured(net, followed(net, bank, shot, course))
    cells = [f"{shot.name:<18}{len(mine) / FPS:>6.1f}"]
    for places in (mine, floor):
        apart = beside(course, places)
        cells.append(f"{100 * sum(apart) / len(apart):>7.1f}{100 * max(apart):>7.1f}")
    cells.append("  " + "".join(f"{100 * math.dist(places[-1], goal):>{w}.1f}" for w, places in ((5, mine), (7, floor))))
    cells.append(f"{100 * skate:>7.2f}{100 * slide:>7.2f}  ")
    for point, knot in zip(shot.path[1:], course.curve.knots[1:], strict=True):
        if point.time is not None:
            seconds, metres = arrival(course.curve.point(knot), point.time, mine)
            cells.append(f"({seconds:.2f}, {100 * metres:.0f}) ")
    return "".join(cells) + "; ".join(shot.check(net, bank))


def followed(net, bank, shot: Shot, course) -> Iterable[runtime.CharacterState]:
    """The same path and styles by `toolkit.runtime.follow`, at the mean speed of the plan while it moves."""
    seconds = (len(course.distance) - 1) / FPS
    curve = course.curve
    points = [*list(zip(curve.x, curve.z, strict=True))[::4], curve.point(curve.length)]
    points = [p for k, p in enumerate(points) if not k or math.dist(p, points[k - 1]) > 1e-3]
    speed = course.distance[-1] / (course.end or seconds)
    first = runtime.start(net, shot.style(bank)(0), points[0], curve.tangent(0.0))
    return runtime.states(net, runtime.follow(points, speed, seconds), shot.style(bank), first)


def measured(net, states: Iterable[runtime.CharacterState]) -> tuple[list[tuple[float, float]], float]:
    """The root's place at each frame, and the foot skate, m/s, the larger one of both feet."""
    states = list(states)
    clip = runtime.record(net, states)
    skate = metrics.foot_skate(clip, torch.stack([s.contacts[0] for s in states]))
    return [tuple(s.root[0, :2].tolist()) for s in states], max(skate.values())
