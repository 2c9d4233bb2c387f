"""The verb `train-stylizer`: train the motion stylizer of Park et al. 2021."""

import dataclasses
from pathlib import Path
from typing import Annotated

from typer import Option

from toolkit import datasets
from toolkit.cli.motion_files import dataset
from toolkit.cli.verbs import ClipSeconds, Device, Resume, Root, Seed, Selection, say
from toolkit.io import save as saving
from toolkit.stylization.data import build
from toolkit.stylization.losses import LOSSES
from toolkit.stylization.training import Config, fit


def train_stylizer(
    data: Annotated[str, Option(
        help=f"Dataset: {', '.join(datasets.DATASETS)}; or a folder of your own clips.")],
    out: Annotated[Path, Option(help="File to write (safetensors).")],
    root: Root = None,
    styles: Selection = None,
    gaits: Selection = None,
    clip_seconds: ClipSeconds = None,
    losses: Annotated[str, Option(
        help="Comma-separated, also with weights, such as ds=3; Table 1 leaves out ds, then "
             "sty.")] = ",".join(LOSSES),
    iterations: Annotated[int | None, Option(
        help="By default the paper's 100,000; 2,000 with --small.")] = None,
    minutes: Annotated[float | None, Option(
        min=0, help="Train for this time; the rates decay over it.")] = None,
    small: Annotated[bool, Option(
        "--small", help="Small networks and fast settings, for a processor.")] = False,
    mirror: Annotated[bool, Option(help="Add mirror images, as the paper does.")] = True,
    seed: Seed = 0,
    device: Device = "cpu",
    slim: Annotated[bool, Option("--slim", help="Write a small file: 16 bits.")] = False,
    resume: Resume = False,
) -> None:
    """Train the motion stylizer of Park et al. 2021; print its losses over time.

    Its domains are the styles of the dataset, its contents the gaits. Ctrl-C stops it, and --resume
    goes on from there.
    """
    saving.check(out, ())
    data, root = dataset(data, root)
    budget: dict[str, float] = {} if iterations is None else {"iterations": iterations}
    if minutes is not None:
        budget = {"iterations": iterations or 10**9, "seconds": 60 * minutes}
    chosen = {name: weight for name, _, weight in (x.partition("=") for x in losses.split(","))}
    config = (Config.quick if small else Config)(
        losses=tuple(chosen), seed=seed, device=device, **budget)
    try:
        weights = {name: float(weight) for name, weight in chosen.items() if weight}
    except ValueError:
        raise ValueError(f"--losses: a weight is a number, as in ds=3; got {losses}") from None
    config = dataclasses.replace(config, weights=config.weights | weights)
    options = {} if clip_seconds is None else {"seconds": clip_seconds}
    motions = build(datasets.load(data, root, styles, gaits, **options), mirror=mirror)
    say(f"{len(motions):,} windows of {', '.join(motions.domains)}")
    checkpoint = out.with_name(out.name + ".checkpoint")
    try:
        run = fit(motions, config, checkpoint, resume=resume, progress=True)
    except KeyboardInterrupt:
        say(f"\nthe same command with --resume goes on from {checkpoint}")
        raise
    run.stylizer.save(out, slim=slim)
    checkpoint.unlink(missing_ok=True)
    last = run.history[-1] if run.history else {}
    terms = [name for name in last if name not in ("step", "elapsed")]
    say(f"{'step':>8}" + "".join(f"{name:>8}" for name in terms))
    for row in run.history[:: max(1, len(run.history) // 10)]:
        cells = (f"{row[name]:>8.3f}" if name in row else f"{'':>8}" for name in terms)
        say(f"{row['step']:>8,}" + "".join(cells))
    say(f"wrote {out}")
