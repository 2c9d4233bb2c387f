"""The command line's verbs ``train-stylizer`` and ``stylize``."""

import os
from pathlib import Path
from typing import Annotated

import typer

from toolkit import datasets, export
from toolkit.evaluation import metrics
from toolkit.io import bvh
from toolkit.motion import contacts
from toolkit.stylization.data import build
from toolkit.stylization.losses import LOSSES
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.restyling import stylize
from toolkit.stylization.training import Config, fit

app = typer.Typer()


@app.command("train-stylizer")
def train_stylizer(
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(datasets.DATASETS)}.")],
    out: Annotated[Path, typer.Option(help="The file to write: networks and training curve (safetensors).")],
    root: Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")] = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated domains; all where not given.")] = None,
    gaits: Annotated[str | None, typer.Option(help="Comma-separated contents; all where not given.")] = None,
    losses: Annotated[str, typer.Option(help="Comma-separated; Table 1 leaves out ds, then sty.")] = ",".join(LOSSES),
    iterations: Annotated[int | None, typer.Option(help="100,000 in the paper; fewer by --small.")] = None,
    small: Annotated[bool, typer.Option("--small", help="Small networks and fast settings, for a processor.")] = False,
    mirror: Annotated[bool, typer.Option(help="Add mirror images, as the paper does.")] = True,
    seed: Annotated[int, typer.Option(help="The same seed gives the same result.")] = 0,
    device: Annotated[str, typer.Option(help="Where to train, e.g. cuda.")] = "cpu",
    resume: Annotated[bool, typer.Option("--resume", help="Go on from OUT.checkpoint, which a stopped run leaves.")] = False,
) -> None:
    """Train the motion stylizer of Park et al. 2021; print how its losses went."""
    if out.is_dir() or not os.access(out.parent if out.parent.exists() else Path(), os.W_OK):
        raise ValueError(f"{out}: cannot be written")
    budget = {} if iterations is None else {"iterations": iterations}
    config = (Config.quick if small else Config)(losses=tuple(losses.split(",")), seed=seed, device=device, **budget)
    chosen = [None if names is None else names.split(",") for names in (styles, gaits)]
    motions = build(datasets.load(data, root, *chosen), mirror=mirror)
    print(f"{len(motions):,} windows of {', '.join(motions.domains)}")
    out.parent.mkdir(parents=True, exist_ok=True)
    checkpoint = out.with_name(out.name + ".checkpoint")
    run = fit(motions, config, checkpoint, resume=resume, progress=True)
    run.save(out)
    checkpoint.unlink(missing_ok=True)
    terms = [name for name in run.history[-1] if name not in ("step", "elapsed")] if run.history else []
    print(f"{'step':>8}" + "".join(f"{name:>8}" for name in terms))
    for row in run.history[:: max(1, len(run.history) // 10)]:
        print(f"{row['step']:>8,}" + "".join(f"{row[name]:>8.3f}" for name in terms))
    print(f"wrote {out}")


@app.command("stylize")
def stylize_(
    model: Annotated[Path, typer.Option(help="What train-stylizer wrote.")],
    clip: Annotated[Path, typer.Option(help="The BVH file to restyle, on the skeleton of the training data.")],
    out: Annotated[Path, typer.Option(help=f"File to write: {', '.join(export.SUFFIXES)} (pictures: beside the source).")],
    domain: Annotated[str | None, typer.Option(help="Target style; of the reference where one is given.")] = None,
    seed: Annotated[int, typer.Option(help="Noise: other seeds, other variants of the style.")] = 0,
    reference: Annotated[Path | None, typer.Option(help="A BVH file of the domain, whose style is taken.")] = None,
    feet: Annotated[bool, typer.Option(help="Take away foot skate.")] = True,
) -> None:
    """Restyle a clip, by noise or by a reference clip; print how much feet slide that should stand."""
    export.check(out)
    if domain is None:
        raise ValueError(f"say which style by --domain: {', '.join(Stylizer.load(model).domains)}")
    source = bvh.load(clip)
    style = None if reference is None else bvh.load(reference)
    made = stylize(Stylizer.load(model), source, domain, seed, reference=style, feet=feet)
    export.write(made, out, title=domain, source=source, progress=True)
    standing = contacts.detect(source)
    before, after = (sum(metrics.foot_skate(c, standing[: len(c)]).values()) * 50 for c in (source, made))
    print(f"{len(made)} frames; feet that should stand slide by {after:.1f} cm/s, in the source {before:.1f}; wrote {out}")
