"""Prediction errors one step ahead from real input, compared with those of other styles."""

from pathlib import Path
from typing import Annotated

import typer

from toolkit import published
from toolkit.cli import verbs
from toolkit.io import bvh


def run(
    clip: Annotated[Path, typer.Option(help="A BVH file of the 100STYLE skeleton.")],
    style: Annotated[str, typer.Option(help="Style of the clip.")],
    parameters: verbs.Published = None,
    model: verbs.TrainedRun = None,
    start: Annotated[int, typer.Option(help="First frame (100STYLE: START of Frame_Cuts.csv).")] = 0,
    stop: Annotated[int | None, typer.Option(help="Frame after the last; default: the end.")] = None,
    beside: Annotated[str, typer.Option(help="Comma-separated styles for comparison.")] = "Zombie,Aeroplane",
) -> None:
    """Errors of the predicted next frames of a real clip with its own style, compared with other styles.

    The inputs are the features and phases of the clip. Its own style must have clearly smaller errors.
    """
    net, bank = published.either(model, parameters)
    motion = bvh.load(clip)
    names = [style, *(s for s in beside.split(",") if s and s != style)]
    rows = [published.one_step(net, bank, motion, name, (start, stop)) for name in names]
    print(f"{'style':<18}{'joint MSE':>10}{'contact corr. R':>17}{'L':>7}{'phase error':>13}")
    for row in rows:
        right, left = row["contact_correlation"]
        print(f"{row['style']:<18}{row['joint_mse']:>10.4f}{right:>17.3f}{left:>7.3f}{row['phase_error']:>13.3f}")
    print(f"{row['frames']} frames; joint MSE in the model's normalised units; the mean pose has about 1")
