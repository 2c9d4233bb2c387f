"""Closed loop: every style walks straight ahead, and what the one-step error does not show is measured."""

from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import metrics, published, runtime


def run(
    model: Annotated[Path | None, typer.Option(help="A trained run; the embedded one where not given.")] = None,
    parameters: Annotated[Path | None, typer.Option("--published", help="Folder of the published parameters.")] = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    seconds: Annotated[float, typer.Option(help="How long to walk.")] = 60.0,
    speed: Annotated[float, typer.Option(help="Metres per second.")] = 1.0,
) -> None:
    """Walk every style straight ahead, and measure what the one-step error does not show."""
    net, bank = published.either(model, parameters)
    names = list(bank.names) if styles is None else styles.split(",")
    vectors = torch.stack([bank[name] for name in names])
    recorded = list(runtime.states(net, runtime.straight(speed, seconds), vectors, progress=True))
    print(f"{'style':<20}{'finite':>8}{'upright':>9}{'speed':>8}{'hips (m)':>13}{'skate with IK':>15}{'without (cm/s)':>16}")
    for i, name in enumerate(names):
        contact = torch.stack([s.contacts[i] for s in recorded])
        try:
            plain, clip = (runtime.record(net, recorded, ik=ik, character=i) for ik in (False, True))
        except ValueError:  # a Clip refuses numbers that are not finite
            print(f"{name:<20}{'no':>8}")
            continue
        low, high = metrics.hips_height(clip)
        skate = [max(metrics.foot_skate(c, contact).values()) * 100 for c in (clip, plain)]
        print(f"{name:<20}{'yes':>8}{'yes' if metrics.upright(clip) else 'NO':>9}{metrics.speed(clip):>8.2f}"
              f"{f'{low:.2f}-{high:.2f}':>13}{skate[0]:>15.1f}{skate[1]:>16.1f}")  # fmt: skip
    print(f"{seconds:g} s at {speed:g} m/s; speed in m/s, foot skate of the worse foot while the network says contact")
