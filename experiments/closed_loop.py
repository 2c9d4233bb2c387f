"""Measures of walks in closed loop, which the one-step error does not show, compared with
limits.
"""

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import Tensor
from tqdm import tqdm

from experiments.tables import RESULTS, Result
from toolkit import features, phases, published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.features import split_joints
from toolkit.io import bvh
from toolkit.motion import Clip, root_frames, rotations as R
from toolkit.motion.contacts import FEET, velocities
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.runtime.frame import planted, predicted, predicted_toes

MISBEHAVES = "Drunk"  # of the published styles, as its authors know
WARM_UP = 4.0  # seconds that are not measured
SPEED_LIMIT, SKATE_LIMIT = 0.1, 5.0  # share of the commanded speed that may be missing; cm/s
LOOP = 2.0  # metres, radius of both loops of the course
#: Columns: what of the walk, its unit in the table / the measure's, title.
COLUMNS = {
    "speed": (1, "speed / command"), "drive": (1, "drive"), "before": (100, "skate before IK"),
    "skate": (100, "skate after IK"), "moved": (100, "IK moves toe"),
    "clearance": (100, "clearance"),
    "steps": (1, "steps/s"), "acceleration": (1, "acceleration"), "bob": (100, "hips bob"),
    "hips": (1, "hips acc."),
    "path": (100, "path"),
}
STORED, AIMS = "closed-loop", {  # the result, and what was asked of the published network
    "natural speed": {"skate": 0.005, "worst": 0.05, "before": 0.015, "least": 0.9},
    "1 m/s": {"skate": 0.02, "worst": 0.05, "before": 0.03, "least": 0.9},
}
#: Columns of the stored result, in the order of the pages.
SUMMARY = {
    "walk": ["walk"], "styles": ["styles", 0], "upright": ["upright", 0],
    "skate": ["toes in contact, cm/s: median", 2, 100],
    "worst": ["worst", 1, 100], "which": ["of"], "before": ["before IK", 1, 100],
    "moved": ["IK moves a toe, cm", 1, 100],
    "speed": ["speed / command", 2], "least": ["least", 2], "drive": ["drive", 1],
    "bob": ["hips bob, cm", 1, 100],
    "hips": ["hips' acceleration, m/s²", 1], "steps": ["Neutral: steps/s", 2],
    "clearance": ["clearance, cm", 1, 100],
    "acceleration": ["toe acceleration, m/s²", 0],
}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    calibrated: Annotated[bool, typer.Option("--calibrated",
                                             help="Use calibrated inference.")] = False,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; default: all.")] = None,
    seconds: Annotated[float, typer.Option(
        min=2.0, help="Duration of each walk, after a warm-up of 4 s.")] = 10.0,
    speeds: Annotated[str,
                      typer.Option(help="Of the walks: m/s, or natural.")] = "natural,0.7,1",
    real: Annotated[Path
                    | None, typer.Option(help="A BVH file of real walking, measured in the same "
                                              "way.")] = None,
    start: Annotated[int, typer.Option(help="First frame of the real walking.")] = 0,
    path: Annotated[bool, typer.Option("--path",
                                       help="Also the distance from a figure of eight.")] = False,
    store: Annotated[bool, typer.Option(
        "--store", help=f"Write the rows into docs/results/{STORED}.json.")] = False,
) -> None:
    """Feet and speed of every style in closed loop, at its natural speed and at a common one, and
    the error on a path.

    Beside them the real walking, and the network's predictions of its next frames as a style of its
    name.
    """
    net, bank = published.either(model, parameters)
    net.calibrated = calibrated
    kind = "published" if parameters else "embedded" if model is None else "trained"
    kind += ", calibrated" * calibrated
    names = [name for name in bank.names if not parameters
             or name != MISBEHAVES] if styles is None else styles.split(",")
    real = None if real is None else bvh.load(real)
    kept, found = {} if real is None else _real(net, bank, real, start, kind), {}
    bank = bank.select(names)
    paths = [math.nan] * len(names)
    if path:
        course = eight(LOOP)
        laps = list(runtime.states(net, runtime.follow(course.tolist(), 1.0), bank.vectors,
                                   progress=True))
        paths = [_path_error(net, laps, i, course) for i in range(len(names))]
        del laps
    for speed in speeds.split(","):
        title = "natural speed" if speed == "natural" else f"{float(speed):g} m/s"
        asked = [bank.speed(name) if speed == "natural" else float(speed) for name in names]
        rows = walk(net, bank, asked, seconds)
        print(f"\nStraight ahead at {title}, {seconds:g} s after {WARM_UP:g} s of warm-up; skate "
              f"in cm/s, of toes that the "
              "network predicts in contact;\nlengths in cm; acceleration of toes, and up and "
              "down of hips, in m/s², 99 %\n"
              f"{'style':<20}{'upright':>8}{'m/s':>6}"
              + "".join(f"{t:>17}" for _, t in COLUMNS.values()))
        for name, row, apart, wanted in zip(names, rows, paths, asked, strict=True):
            row["path"] = apart
            print(f"{name:<20}{'yes' if row['upright'] else 'NO':>8}{wanted:>6.2f}" + _cells(row))
        for what, choose in (("median", torch.nanmedian),
                             ("worst", lambda v: v.nan_to_num(-math.inf).max())):
            print(f"{what:<34}"
                  + _cells({k: float(choose(torch.tensor([r[k] for r in rows]))) for k in COLUMNS}))
        for what, row in kept.items():
            print(f"{what:<34}" + _cells(dict.fromkeys(COLUMNS, math.nan) | row))
        found[f"{kind}, {title}"] = _summary(dict(zip(names, rows, strict=True)))
        failed = {name: why for name, row in zip(names, rows, strict=True)
                  if (why := _exceeded(row))}
        print(f"{len(names) - len(failed)} of {len(names)} styles upright, at "
              f"{1 - SPEED_LIMIT:.0%} of the speed or more, "
              f"skate after IK up to {SKATE_LIMIT:g} cm/s"
              + "".join(f"; {name}: {why}" for name, why in failed.items()))
    if store:
        _store(kept | found | {f"aim, {walk}": aims for walk, aims in AIMS.items() if parameters})


def walk(net: Model, bank: StyleBank, speeds: Sequence[float],
         seconds: float) -> list[dict[str, float]]:
    """Measures of `COLUMNS` of a straight walk in every style of a bank, at speeds in m/s, side by
    side.
    """
    state = runtime.start(net, bank.vectors)
    ahead = torch.tensor(speeds).to(state.velocity)[:, None] * state.velocity.new_tensor([0.0, 1.0])
    command, toes, seen = runtime.Command(ahead, (0.0, 1.0)), [], []
    with torch.no_grad():
        for _ in tqdm(range(round((WARM_UP + seconds) * runtime.FPS)), desc="walks", unit="frame",
                      disable=None):
            new = predicted(net, state, command)
            toes.append(predicted_toes(net.layout, new))
            state = planted(net.layout, state, new)
            seen.append(state)
    first = round(WARM_UP * runtime.FPS)
    toes, seen = torch.stack(toes[first:], 1), seen[first:]
    return [_measure(net, seen, toes[i], i, speeds[i]) for i in range(len(bank))]


def eight(radius: float) -> Tensor:
    """Points (x, z) ``[97, 2]`` of two touching circles, first the left one; the start is straight
    ahead.
    """
    t = torch.linspace(0.0, 2 * math.pi, 49)
    left = torch.stack((radius * (1 - t.cos()), radius * t.sin()), -1)
    return torch.cat((left, left[1:] * torch.tensor([-1.0, 1.0])))


def _measure(net: Model, seen: list[runtime.CharacterState], toes: Tensor, i: int,
             speed: float) -> dict[str, float]:
    """``toes [F, 2, 3]``: the predicted positions of both toes before foot IK."""
    contact = torch.stack([s.contacts[i] for s in seen])
    try:
        clip = runtime.record(net, seen, character=i)
    except ValueError:  # a Clip refuses numbers that are not finite
        return dict.fromkeys(COLUMNS, math.nan) | {"upright": 0.0}
    on = contact > 0.5
    locked = torch.stack([s.toes[i] for s in seen])
    return metrics.feet(clip, contact) | hips(clip) | {
        "upright": float(metrics.upright(clip)), "speed": metrics.speed(clip) / speed,
        "drive": float(torch.stack([s.drive[i] for s in seen]).mean()),
        "before": float(velocities(toes, runtime.FPS)[..., [0, 2]].norm(dim=-1)[on].mean()),
        "moved": float((locked - toes).norm(dim=-1)[on].mean()),
    }


def hips(clip: Clip) -> dict[str, float]:
    """Height of the hips: ``bob``, from its 1st to its 99th percentile, metres; ``hips``, 99 % of
    its acceleration, m/s².
    """
    height = clip.root_positions[:, 1]
    return {"bob": float(height.quantile(0.99) - height.quantile(0.01)),
            "hips": float((height.diff(n=2) * clip.fps**2).abs().quantile(0.99))}


def ahead(net: Model, style: Tensor, clip: Clip, start: int = 0) -> dict[str, float]:
    """``before`` of predictions one step ahead from the real frames of a clip at 60 Hz, and
    ``skate`` of these frames.

    Toes of each pose are those of the runtime before foot IK. Both speeds are of toes that the
    network predicts in contact, between neighbouring frames: no error of a prediction reaches the
    next.
    """
    layout, rows = net.layout, features.frames(clip, phases.extract(clip), start, None,
                                               net.layout.samples)
    z = net.predict(rows.inputs, net.observe(rows.phases, rows.outputs)[0], style)
    out, roots = layout.unpack_output(z), root_frames(clip)
    was, now = split_joints(rows.inputs[:, layout.inputs["joints"]]), split_joints(out["joints"])
    ends = [layout.names.index(layout.skeleton.roles[f"{side}_toe"]) for side in FEET]
    toes = torch.lerp(was["position"] + now["velocity"] / runtime.FPS, now["position"],
                      0.5)[:, ends]
    toes = R.rotate(roots.rotations[rows.index, None], toes) + roots.positions[rows.index, None]
    true = clip.global_positions[rows.index
                                 + 1][:, [clip.skeleton.role(f"{side}_toe") for side in FEET]]
    on = out["contacts"] > 0.5
    before, skate = (float(velocities(x, runtime.FPS)[..., [0, 2]].norm(dim=-1)[on].mean())
                     for x in (toes, true))
    return {"before": before, "skate": skate}


def _real(net: Model, bank: StyleBank, clip: Clip, start: int,
          kind: str) -> dict[str, dict[str, float]]:
    """Rows of a real take, and of the predictions from it in the style of its name."""
    clip = clip.resample(runtime.FPS)
    rows = {f"real: {clip.name}": metrics.feet(clip.cut(start)) | hips(clip.cut(start))}
    style = Path(clip.name).stem.split("_")[0]
    return rows | ({f"{kind}, one step ahead: {clip.name}": ahead(net, bank[style], clip, start)}
                   if style in bank else {})


def _summary(rows: Mapping[str, Mapping[str, float]]) -> dict[str, float | str]:
    """A row of `SUMMARY`, without its name, from those of styles."""
    held = {key: torch.tensor([row[key] for row in rows.values()]) for key in COLUMNS}
    of_neutral = {key: rows["Neutral"][key] for key in ("steps", "clearance", "acceleration")
                  if "Neutral" in rows}
    medians = {key: float(held[key].nanmedian()) for key in SUMMARY if key in held
               and key not in of_neutral}
    worst = int(held["skate"].nan_to_num(-math.inf).argmax())
    return medians | of_neutral | {
        "styles": len(rows), "upright": sum(row["upright"] for row in rows.values()),
        "worst": float(held["skate"][worst]),
        "which": list(rows)[worst], "least": float(held["speed"].min()),
    }


def _store(rows: Mapping[str, Mapping[str, float | str]]) -> None:
    """Put rows in place of those of the same name in the stored result."""
    Result(STORED,
           "Straight walks, ten seconds after four of warm-up: medians over styles; beside them "
           "a real take and "
           "predictions of its next frames from itself; the aims are for the published network",
           "python -m experiments closed-loop [--published DATA/lpn_film_100style] --real "
           "DATA/100style/Neutral_FW.bvh "
           "--start 327 [--calibrated] --store", SUMMARY,
           [{"walk": name, **row} for name, row in rows.items()],
           ).add(RESULTS)


def _path_error(net: Model, laps: list[runtime.CharacterState], i: int, course: Tensor) -> float:
    try:
        return metrics.path_error(runtime.record(net, laps, character=i), course)
    except ValueError:
        return math.nan


def _cells(row: dict[str, float]) -> str:
    return "".join(f"{'—' if math.isnan(row[k]) else f'{scale * row[k]:.2f}':>17}"
                   for k, (scale, _) in COLUMNS.items())


def _exceeded(row: dict[str, float]) -> str:
    """The limits that a row exceeds, in words."""
    checks = {"not upright or not finite": row["upright"] == 1,
              f"speed {row['speed']:.2f}": row["speed"] >= 1 - SPEED_LIMIT,
              f"skate {100 * row['skate']:.1f} cm/s": not 100 * row["skate"] > SKATE_LIMIT}
    return ", ".join(why for why, good in checks.items() if not good)
