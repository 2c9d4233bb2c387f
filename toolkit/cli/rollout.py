"""The verb `rollout`: walk straight ahead in a style or a blend, write the motion and measure it."""

import warnings
from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import export, published, runtime
from toolkit.cli.verbs import Published, TrainedRun, say
from toolkit.evaluation import metrics

HARDLY = 0.5  # of the speed that was asked: a doubt


def rollout(
    style: Annotated[str, typer.Option(help="A style, or a blend like Zombie=0.5,Old=0.5.")],
    out: Annotated[Path, typer.Option(help=f"File to write: {', '.join(export.SUFFIXES)} (.png: a strip).")],
    model: TrainedRun = None,
    parameters: Published = None,
    seconds: Annotated[float, typer.Option(help="Length of the motion.", min=0.02, max=3600)] = 10.0,
    speed: Annotated[float | None, typer.Option(help="Metres per second; default: natural for the style.")] = None,
    ik: Annotated[bool, typer.Option(help="Foot and arm IK.")] = True,
) -> None:
    """Walk straight ahead in a style, write the motion and print measurements: speed, hips' height and foot skate."""
    export.check(out)
    net, bank = published.either(model, parameters)
    blend = blend_of(style)
    vector, speed = bank.blend(blend), bank.speed(blend) if speed is None else speed
    states = list(runtime.states(net, runtime.straight(speed, seconds), vector, progress=True))
    clip = runtime.record(net, states, feet=ik, arms=ik).replace(style=style, gait="FW")
    export.write(clip, out, title=style, progress=True)
    low, high = metrics.hips_height(clip)
    went, skate = metrics.speed(clip), metrics.foot_skate(clip, torch.stack([s.contacts[0] for s in states]))
    if seconds > 1 and went < HARDLY * speed:
        warnings.warn(f"the character hardly walks: {went:.2f} m/s for {speed:.2f} asked", stacklevel=2)
    say(f"{len(clip)} frames, {went:.2f} m/s for {speed:.2f} asked, hips {low:.2f} to {high:.2f} m, "
        f"foot skate right {skate['right'] * 100:.1f} left {skate['left'] * 100:.1f} cm/s; wrote {out}")


def blend_of(text: str) -> dict[str, float]:
    """Shares by style, of a style's name or a blend like Zombie=0.5,Old=0.5; ValueError if it is neither."""
    if "=" not in text:
        return {text: 1.0}
    try:
        return {name.strip(): float(weight) for name, weight in (part.split("=") for part in text.split(","))}
    except ValueError:
        raise ValueError(f"a blend is written like Zombie=0.5,Old=0.5; got {text!r}") from None
