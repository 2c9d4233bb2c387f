"""The verb `rollout`: walk straight ahead in a style or a blend, write and measure the motion."""

import math
import warnings
from pathlib import Path
from typing import Annotated

import torch
from typer import Option

from toolkit import runtime
from toolkit.cli.export import Figure
from toolkit.cli.verbs import Published, TrainedRun, say
from toolkit.evaluation import metrics
from toolkit.evaluation.findings import told
from toolkit.io import save as saving
from toolkit.training import published

HARDLY = 0.5  # of the speed that was asked: a doubt


def rollout(
    style: Annotated[str, Option(help="A style, or a blend like Zombie=0.5,Old=0.5.")],
    out: Annotated[Path, Option(
        help=f"File to write: {', '.join(saving.suffixes())} (.png: a strip).")],
    model: TrainedRun = None,
    parameters: Published = None,
    seconds: Annotated[float, Option(help="Length of the motion.", min=0.02, max=3600)] = 10.0,
    speed: Annotated[float | None, Option(
        help="Metres per second; default: natural for the style.")] = None,
    life: Annotated[float | None, Option(
        help="How much the style wanders, 0 to 1; default: as the model needs.")] = None,
    seed: Annotated[int, Option(help="Of this wandering.")] = 0,
    ik: Annotated[bool, Option(help="Foot and arm IK.")] = True,
    character: Figure = None,
) -> None:
    """Walk straight ahead in a style, write the motion and print measurements."""
    saving.check(out, None, character)
    figure = saving.figure_of(character)  # a file that is no character is refused now
    net, bank = published.either(model, parameters)
    blend = blend_of(style)
    speed = bank.speed(blend) if speed is None else speed
    commands = runtime.straight(speed, seconds)
    life = net.life if life is None else life
    net = runtime.quick(net, len(commands), say)
    states = list(runtime.states(net, commands, bank.blend(blend), progress=True, life=life,
                                 seed=seed))
    clip = runtime.record(net, states, feet=ik, arms=ik).replace(style=style, gait="FW")
    saving.save(clip, out, title=style, progress=True, character=figure)
    low, high = metrics.hips_height(clip)
    went = metrics.speed(clip)
    slid = metrics.foot_skate(clip, torch.stack([state.contacts[0] for state in states])).values()
    skate = max((each for each in slid if not math.isnan(each)), default=0.0)
    if seconds > 1 and went < HARDLY * speed:
        warnings.warn(f"the character hardly walks: {went:.2f} m/s for {speed:.2f} asked",
                      stacklevel=2)
    say(f"{len(clip)} frames, {went:.2f} m/s for {speed:.2f} asked, hips {low:.2f} to {high:.2f} m,"
        f" foot skate {skate * 100:.1f} cm/s; wrote {out}")
    say(told(clip if figure is None else figure.fitted(clip)))


def blend_of(text: str) -> dict[str, float]:
    """Shares by style, of a style's name or a blend like Zombie=0.5,Old=0.5.

    ValueError if it is neither.
    """
    if "=" not in text:
        return {text: 1.0}
    try:
        parts = (part.split("=") for part in text.split(","))
        return {name.strip(): float(weight) for name, weight in parts}
    except ValueError:
        raise ValueError(f"a blend is written like Zombie=0.5,Old=0.5; got {text!r}") from None
