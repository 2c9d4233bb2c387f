"""Whether characters do what they are told, and whether they live: all styles side by side."""

import math
from collections.abc import Callable
from typing import Annotated

import torch
import typer
from torch import Tensor
from tqdm import tqdm

from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.features import split_joints
from toolkit.networks import Model
from toolkit.runtime.frame import FPS, planted, predicted, predicted_toes
from toolkit.runtime.life import alive

WARM_UP, MEASURED = 3.0, 8.0  # seconds
TURN = math.pi / 4  # radians per second, on the circle
SLOW = 1.5  # seconds: what moves more slowly than this is slow motion
UPPER = "chest", "spine", "neck", "right_elbow", "left_elbow", "right_hand", "left_hand"
TRACKS = "natural", "1 m/s", "2 m/s", "circle", "sideways", "backward", "stop"
MISBEHAVES = "Drunk"  # of the published styles, as its authors know


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    tracks: Annotated[str, typer.Option(help="Comma-separated.")] = ",".join(TRACKS),
    styles: Annotated[str | None, typer.Option(help="Comma-separated; default: all.")] = None,
    life: Annotated[float, typer.Option(help="How much the styles wander.")] = 0.0,
    seed: Annotated[int, typer.Option(help="Of this wandering.")] = 0,
) -> None:
    """Direction, stop, feet in three dimensions and slow motion of every style in closed loop.

    Each measure is printed as the median of the styles, the worst, and its style. Recorded takes
    have a slow motion of 1.6 cm (Neutral) to 6.6 cm (Swimming).
    """
    net, bank = published.either(model, parameters)
    names = list(bank.names) if styles is None else styles.split(",")
    bank = bank.select([name for name in names if not parameters or name != MISBEHAVES])
    for track in tracks.split(","):
        rows = measured(net, bank, track, life, seed)
        print(f"\n{track}, {len(bank)} styles, life {life:g}")
        for measure, (values, unit) in rows.items():
            worst = int(values.nan_to_num(0.0).abs().argmax())
            print(f"{measure:<34}{float(values.nanmedian()):8.2f}{float(values[worst]):8.2f} {unit}"
                  f"  {bank.names[worst]}")


def measured(net: Model, bank, track: str, life: float, seed: int) -> dict[str, tuple[Tensor, str]]:
    """Measures of a track by name: one value for each style of the bank, and a unit."""
    pace = torch.tensor([bank.speed(name) for name in bank.names])
    if track != "natural":
        speeds = {"1 m/s": 1.0, "2 m/s": 2.0, "sideways": 0.7, "backward": 0.7}
        pace = torch.full_like(pace, speeds.get(track, 1.0))
    states = walk(net, alive(bank.vectors, life, seed), commands(track, pace))
    roots, joints, contacts, toes, raw = states
    first = round(WARM_UP * FPS)
    if track == "stop":
        ways = (roots[:, 15:, :2] - roots[:, :-15, :2]).norm(dim=-1) * 4
        both = (contacts[:, first + FPS :].amin(-1) > 0.5).float().mean(1)
        return {"speed after 1 s": (ways[:, first + FPS :].amax(1), "m/s"),
                "time with a foot in the air": (1 - both, "of the time")}
    on = (contacts[:, first + 1 :] > 0.5) & (contacts[:, first:-1] > 0.5)
    rows = {"toes in contact, three dimensions": (speed(toes[:, first:], on), "cm/s"),
            "the same before IK, on the floor": (speed(raw[:, first:, :, ::2], on), "cm/s")}
    if track == "circle":
        return rows
    angle = {"sideways": math.pi / 2, "backward": math.pi}.get(track, 0.0)
    way = roots[:, -1, :2] - roots[:, first, :2]
    along = way[:, 0] * math.sin(angle) + way[:, 1] * math.cos(angle)
    across = way[:, 0] * math.cos(angle) - way[:, 1] * math.sin(angle)
    rows |= {"direction": (torch.atan2(across, along).abs().rad2deg(), "degrees"),
             "speed / command": (along / MEASURED / pace, "")}
    return rows | {"slow motion of the upper body": (slow_motion(net, joints[:, first:]), "cm")}


def commands(track: str, pace: Tensor) -> list[runtime.Command]:
    """One command a frame for all characters, whose speeds are ``pace [B]``, m/s."""
    made = []
    for frame in range(round((WARM_UP + MEASURED) * FPS)):
        seconds = frame / FPS
        angle = {"circle": TURN * seconds, "sideways": math.pi / 2,
                 "backward": math.pi}.get(track, 0.0)
        way = torch.tensor([math.sin(angle), math.cos(angle)])
        moves = 0.0 if track == "stop" and seconds >= WARM_UP else 1.0
        look = way[None] if track == "circle" else (0.0, 1.0)
        made.append(runtime.Command(moves * pace[:, None] * way, look))
    return made


def walk(net: Model, style: Tensor | Callable,
         orders: list[runtime.Command]) -> tuple[Tensor, ...]:
    """Roots, poses, contacts, toes, and toes as predicted, each ``[B, F, ...]``."""
    at = style if callable(style) else (lambda _: style)
    state, seen = runtime.start(net, at(0)), []
    with torch.no_grad():
        for frame, order in enumerate(tqdm(orders, unit="frame", disable=None)):
            state = state.with_style(at(frame))
            new = predicted(net, state, order)
            raw = predicted_toes(net.layout, new)
            state = planted(net.layout, state, new)
            seen.append((state.root, state.joints, state.contacts, state.toes, raw))
    return tuple(torch.stack(part, 1) for part in zip(*seen, strict=True))


def speed(toes: Tensor, on: Tensor) -> Tensor:
    """Mean speed ``[B]``, cm/s, of toes ``[B, F, 2, D]`` in contact ``[B, F - 1, 2]``."""
    moved = (toes[:, 1:] - toes[:, :-1]).norm(dim=-1) * FPS * 100
    return (moved * on).sum((1, 2)) / on.sum((1, 2))


def slow_motion(net: Model, joints: Tensor) -> Tensor:
    """Deviation ``[B]``, cm, of the mean positions over `SLOW` seconds of the upper body."""
    layout = net.layout
    names = [layout.skeleton.roles.get(role) for role in UPPER]
    places = [layout.names.index(name) for name in names if name in layout.names]
    points = split_joints(joints.flatten(0, 1))["position"].unflatten(0, joints.shape[:2])
    points = points[:, :, places] - points[:, :, :1] * points.new_tensor([1.0, 0.0, 1.0])
    window = round(SLOW * FPS)
    means = points.unfold(1, window, 1).mean(-1)
    around = means - means.mean(1, keepdim=True)
    return 100 * around.square().sum(-1).mean(1).sqrt().mean(-1)
