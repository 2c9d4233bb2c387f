"""Measures of walks in closed loop, which the one-step error does not show, compared with limits."""

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import Tensor
from tqdm import tqdm

from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.io import bvh
from toolkit.motion.contacts import velocities
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.runtime.frame import planted, predicted, predicted_toes

WARM_UP = 4.0  # seconds that are not measured
SPEED_LIMIT, SKATE_LIMIT = 0.1, 5.0  # share of the commanded speed that may be missing; cm/s
LOOP = 2.0  # metres, radius of both loops of the course
#: Columns: what of the walk, its unit in the table / the measure's, title.
COLUMNS = {
    "speed": (1, "speed / command"), "drive": (1, "drive"), "before": (100, "skate before IK"),
    "skate": (100, "skate after IK"), "moved": (100, "IK moves toe"), "clearance": (100, "clearance"),
    "steps": (1, "steps/s"), "acceleration": (1, "acceleration"), "path": (100, "path"),
}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    calibrated: Annotated[bool, typer.Option("--calibrated", help="Use calibrated inference.")] = False,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; default: all.")] = None,
    seconds: Annotated[float, typer.Option(min=2.0, help="Duration of each walk, after a warm-up of 4 s.")] = 10.0,
    speed: Annotated[float, typer.Option(help="Metres per second of the second walk.")] = 1.0,
    real: Annotated[Path | None, typer.Option(help="A BVH file of real walking, measured in the same way.")] = None,
    start: Annotated[int, typer.Option(help="First frame of the real walking.")] = 0,
) -> None:
    """Feet and speed of every style in closed loop, at its natural speed and at a common one, and the error on a path."""
    net, bank = published.either(model, parameters)
    net.calibrated = calibrated
    names = list(bank.names) if styles is None else styles.split(",")
    bank = bank.select(names)
    course = eight(LOOP)
    laps = list(runtime.states(net, runtime.follow(course.tolist(), speed), bank.vectors, progress=True))
    paths = [_path_error(net, laps, i, course) for i in range(len(names))]
    del laps
    walks = {"its natural speed": [bank.speed(name) for name in names], f"{speed:g} m/s": [speed] * len(names)}
    for title, speeds in walks.items():
        rows = walk(net, bank, speeds, seconds)
        print(f"\nStraight ahead at {title}, {seconds:g} s after {WARM_UP:g} s of warm-up; skate in cm/s, of toes that the "
              "network predicts in contact;\nlengths in cm; acceleration of the toes in m/s², 99 %\n"
              f"{'style':<20}{'upright':>8}{'m/s':>6}" + "".join(f"{t:>17}" for _, t in COLUMNS.values()))
        for name, row, path, asked in zip(names, rows, paths, speeds, strict=True):
            row["path"] = path
            print(f"{name:<20}{'yes' if row['upright'] else 'NO':>8}{asked:>6.2f}" + _cells(row))
        for what, choose in (("median", torch.nanmedian), ("worst", lambda v: v.nan_to_num(-math.inf).max())):
            print(f"{what:<34}" + _cells({k: float(choose(torch.tensor([r[k] for r in rows]))) for k in COLUMNS}))
        if real is not None:
            feet = metrics.feet(bvh.load(real).cut(start))
            print(f"{'real: ' + real.stem:<34}" + _cells(dict.fromkeys(COLUMNS, math.nan) | feet))
        failed = {name: why for name, row in zip(names, rows, strict=True) if (why := _exceeded(row))}
        print(f"{len(names) - len(failed)} of {len(names)} styles upright, at {1 - SPEED_LIMIT:.0%} of the speed or more, "
              f"skate after IK up to {SKATE_LIMIT:g} cm/s" + "".join(f"; {name}: {why}" for name, why in failed.items()))


def walk(net: Model, bank: StyleBank, speeds: Sequence[float], seconds: float) -> list[dict[str, float]]:
    """Measures of `COLUMNS` of a straight walk in every style of a bank, at speeds in m/s, side by side."""
    state = runtime.start(net, bank.vectors)
    ahead = torch.tensor(speeds).to(state.velocity)[:, None] * state.velocity.new_tensor([0.0, 1.0])
    command, toes, seen = runtime.Command(ahead, (0.0, 1.0)), [], []
    with torch.no_grad():
        for _ in tqdm(range(round((WARM_UP + seconds) * runtime.FPS)), desc="walks", unit="frame", disable=None):
            new = predicted(net, state, command)
            toes.append(predicted_toes(net.layout, new))
            state = planted(net.layout, state, new)
            seen.append(state)
    first = round(WARM_UP * runtime.FPS)
    toes, seen = torch.stack(toes[first:], 1), seen[first:]
    return [_measure(net, seen, toes[i], i, speeds[i]) for i in range(len(bank))]


def eight(radius: float) -> Tensor:
    """Points (x, z) ``[97, 2]`` of two touching circles, first the left one; the start is straight ahead."""
    t = torch.linspace(0.0, 2 * math.pi, 49)
    left = torch.stack((radius * (1 - t.cos()), radius * t.sin()), -1)
    return torch.cat((left, left[1:] * torch.tensor([-1.0, 1.0])))


def _measure(net: Model, seen: list[runtime.CharacterState], toes: Tensor, i: int, speed: float) -> dict[str, float]:
    """``toes [F, 2, 3]``: the predicted positions of both toes before foot IK."""
    contact = torch.stack([s.contacts[i] for s in seen])
    try:
        clip = runtime.record(net, seen, character=i)
    except ValueError:  # a Clip refuses numbers that are not finite
        return dict.fromkeys(COLUMNS, math.nan) | {"upright": 0.0}
    on = contact > 0.5
    locked = torch.stack([s.toes[i] for s in seen])
    return metrics.feet(clip, contact) | {
        "upright": float(metrics.upright(clip)), "speed": metrics.speed(clip) / speed,
        "drive": float(torch.stack([s.drive[i] for s in seen]).mean()),
        "before": float(velocities(toes, runtime.FPS)[..., [0, 2]].norm(dim=-1)[on].mean()),
        "moved": float((locked - toes).norm(dim=-1)[on].mean()),
    }


def _path_error(net: Model, laps: list[runtime.CharacterState], i: int, course: Tensor) -> float:
    try:
        return metrics.path_error(runtime.record(net, laps, character=i), course)
    except ValueError:
        return math.nan


def _cells(row: dict[str, float]) -> str:
    return "".join(f"{'—' if math.isnan(row[k]) else f'{scale * row[k]:.2f}':>17}" for k, (scale, _) in COLUMNS.items())


def _exceeded(row: dict[str, float]) -> str:
    """The limits that a row exceeds, in words."""
    checks = {"not upright or not finite": row["upright"] == 1, f"speed {row['speed']:.2f}": row["speed"] >= 1 - SPEED_LIMIT,
              f"skate {100 * row['skate']:.1f} cm/s": not 100 * row["skate"] > SKATE_LIMIT}
    return ", ".join(why for why, good in checks.items() if not good)
