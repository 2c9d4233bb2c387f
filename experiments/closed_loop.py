"""Measures of walks in closed loop, which the one-step error does not show, compared with limits."""

import math
from itertools import islice
from typing import Annotated

import torch
import typer

from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.motion import Clip

CHUNK = 600  # frames per measurement: the states of 25 characters over ten minutes would need gigabytes
SPEED_LIMIT, SKATE_LIMIT = 0.25, 0.02  # share of the commanded speed, m/s
LOOP = 2.0  # metres, radius of both loops of the course
COLUMNS = {"speed": 8, "slowest": 9, "low": 7, "high": 6, "ik": 7, "plain": 7, "steps": 9, "fewest": 8, "path": 7}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; default: all.")] = None,
    seconds: Annotated[float, typer.Option(help="Duration of the straight walk.")] = 600.0,
    speed: Annotated[float, typer.Option(help="Metres per second.")] = 1.0,
) -> None:
    """Speed, hips, foot skate and path of every style in closed loop, compared with limits and with no foot IK.

    Every style walks straight ahead, then along an eight.
    """
    net, bank = published.either(model, parameters)
    names = list(bank.names) if styles is None else styles.split(",")
    vectors = torch.stack([bank[name] for name in names])
    rows: list[list[dict[str, float]]] = [[] for _ in names]
    ahead = runtime.states(net, runtime.straight(speed, seconds), vectors, progress=True)
    while chunk := list(islice(ahead, CHUNK)):
        for i, row in enumerate(rows):
            row.append(_measure(net, chunk, i))
    course = eight(LOOP)
    laps = list(runtime.states(net, runtime.follow(course.tolist(), speed), vectors, progress=True))
    table = {}
    for i, (name, row) in enumerate(zip(names, rows, strict=True)):
        mean, least, most = ({k: f([r[k] for r in row]) for k in row[0]} for f in (_mean, min, max))
        table[name] = {
            "upright": least["upright"], "speed": mean["speed"] / speed, "slowest": least["speed"] / speed,
            "low": least["low"], "high": most["high"], "ik": 100 * mean["ik"], "plain": 100 * mean["plain"],
            "steps": mean["steps"], "fewest": least["steps"], "path": 100 * _path_error(net, laps, i, course),
        }
    print(f"{'':<22}{'finite,':>8}{'speed/command':>17}{'hips (m)':>13}{'skate (cm/s)':>14}{'steps/s':>17}{'path':>7}")
    print(f"{'style':<22}{'upright':>8}{'mean':>8}{'slowest':>9}{'low':>7}{'high':>6}{'IK':>7}{'no IK':>7}{'mean':>9}"
          f"{'fewest':>8}{'(cm)':>7}")
    for name, row in table.items():
        print(f"{name:<22}{'yes' if row['upright'] else 'NO':>8}" + "".join(f"{row[k]:>{w}.2f}" for k, w in COLUMNS.items()))
    worst = {
        "upright": min(table, key=lambda n: table[n]["upright"]), "speed": max(table, key=lambda n: _off(table[n]["speed"])),
        "ik": max(table, key=lambda n: table[n]["ik"]), "fewest": min(table, key=lambda n: table[n]["fewest"]),
        "path": max(table, key=lambda n: table[n]["path"]),
    }
    print(f"{seconds:g} s at {speed:g} m/s; slowest and fewest: of any {CHUNK / runtime.FPS:g} s; skate: a toe's mean speed "
          f"while the network predicts contact; path: mean distance from an eight with loops of {LOOP:g} m radius")
    print("worst: " + ", ".join(f"{k} {table[n][k]:.2f} ({n})" for k, n in worst.items()))
    failed = {name: why for name, row in table.items() if (why := _exceeded(row))}
    print(f"{len(table) - len(failed)} of {len(table)} styles finite, upright, within {SPEED_LIMIT:.0%} of the speed, under "
          f"{100 * SKATE_LIMIT:g} cm/s" + "".join(f"; {name}: {why}" for name, why in failed.items()))


def eight(radius: float) -> torch.Tensor:
    """Points (x, z) ``[97, 2]`` of two touching circles, first the left one; the start is straight ahead."""
    t = torch.linspace(0.0, 2 * math.pi, 49)
    left = torch.stack((radius * (1 - t.cos()), radius * t.sin()), -1)
    return torch.cat((left, left[1:] * torch.tensor([-1.0, 1.0])))


def _measure(net, chunk: list[runtime.CharacterState], i: int) -> dict[str, float]:
    contact = torch.stack([s.contacts[i] for s in chunk])
    try:
        plain, clip = (runtime.record(net, chunk, feet=ik, arms=ik, character=i) for ik in (False, True))
    except ValueError:  # a Clip refuses numbers that are not finite
        return dict.fromkeys(("speed", "low", "high", "ik", "plain", "steps"), math.nan) | {"upright": 0.0}
    low, high = metrics.hips_height(clip)
    return {
        "upright": float(metrics.upright(clip)), "speed": metrics.speed(clip), "low": low, "high": high,
        "ik": _skate(clip, contact), "plain": _skate(plain, contact), "steps": metrics.step_rate(contact, clip.fps),
    }


def _skate(clip: Clip, contact: torch.Tensor) -> float:
    """Foot skate of the worse foot; NaN without any contact."""
    return max((v for v in metrics.foot_skate(clip, contact).values() if not math.isnan(v)), default=math.nan)


def _path_error(net, laps: list[runtime.CharacterState], i: int, course: torch.Tensor) -> float:
    try:
        return metrics.path_error(runtime.record(net, laps, character=i), course)
    except ValueError:
        return math.nan


def _mean(values: list[float]) -> float:
    return float(torch.tensor(values).nanmean())


def _off(ratio: float) -> float:
    return math.inf if math.isnan(ratio) else abs(ratio - 1.0)


def _exceeded(row: dict[str, float]) -> str:
    """The limits that a row exceeds, in words."""
    checks = {"not upright or not finite": row["upright"] == 1,
              f"speed {row['speed']:.2f}": _off(row["speed"]) <= SPEED_LIMIT,
              f"skate {row['ik']:.1f} cm/s": row["ik"] < 100 * SKATE_LIMIT}
    return ", ".join(why for why, good in checks.items() if not good)
