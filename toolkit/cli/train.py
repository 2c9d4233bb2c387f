"""The verb `train`: any of the seven models on a dataset or a store."""

import math
import os
from pathlib import Path
from typing import Annotated

import typer

from toolkit import datasets, features, networks, training
from toolkit.cli.verbs import Root
from toolkit.features import store
from toolkit.training import distributed


def train(
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(datasets.DATASETS)}; or the folder of a store.")],
    out: Annotated[Path, typer.Option(help="The file to write: model, style bank and numbers (safetensors).")],
    root: Root = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    gaits: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    mirror: Annotated[bool, typer.Option("--mirror", help="Add mirror images (100STYLE: of symmetric styles).")] = False,
    clip_seconds: Annotated[float | None, typer.Option(help="Length of procedural clips.")] = None,
    model: Annotated[str, typer.Option(help=f"One of {', '.join(networks.MODELS)}.")] = "lpn-film",
    minutes: Annotated[float | None, typer.Option(help="Time budget.")] = None,
    epochs: Annotated[float | None, typer.Option(help="Passes of the shortest style; 90 as in the paper.")] = None,
    patience: Annotated[int | None, typer.Option(help="Stop after so many test errors (one every 1000 steps) without a "
                                                 "better one, and keep the best weights.")] = None,
    small: Annotated[bool, typer.Option("--small", help="Small sizes and fast settings; 30 s without a budget.")] = False,
    seed: Annotated[int, typer.Option(help="The same seed gives the same result.")] = 0,
    device: Annotated[str, typer.Option(help="cpu, cuda, …")] = "cpu",
    processes: Annotated[int, typer.Option(help="How many share each minibatch, a GPU each with --device cuda; on several "
                                           "machines `torchrun … -m toolkit train …` instead.")] = 1,
    precision: Annotated[str, typer.Option(help="32, or bf16: faster on a GPU or with many style clips.")] = "32",
    log: Annotated[Path | None, typer.Option(help="Folder for TensorBoard curves (the extra `scale`).")] = None,
    slim: Annotated[bool, typer.Option("--slim", help="A small file that runs its styles but cannot add any.")] = False,
    resume: Annotated[bool, typer.Option("--resume", help="Go on from OUT.checkpoint, which a stopped run leaves.")] = False,
) -> None:
    """Train a model; print the error on held-out frames beside predicting the mean and repeating the frame."""
    budget = {"epochs": epochs, "seconds": None if minutes is None else 60 * minutes}
    budget = {name: value for name, value in budget.items() if value is not None}
    settings = {"model": model, "patience": patience, "seed": seed, "device": device, "processes": processes,
                "precision": precision}
    config = (training.Config.quick if small else training.Config)(**budget, **settings)
    if out.is_dir():
        raise ValueError(f"{out}: is a folder; --out needs a file name")
    out.parent.mkdir(parents=True, exist_ok=True)
    if not os.access(out.parent, os.W_OK):
        raise ValueError(f"{out.parent}: cannot be written to")
    distributed.start(config)  # before the data, so that all processes read them at once
    options = {} if clip_seconds is None else {"seconds": clip_seconds}
    chosen = [None if names is None else names.split(",") for names in (styles, gaits)]
    if store.is_store(data) or Path(data).is_dir():
        if root or gaits or mirror or options:
            raise ValueError(f"{data}: a store has its own --root, --gaits and --mirror; choose among its --styles")
        found = store.load(data, chosen[0])
    else:
        clips = datasets.load(data, root, *chosen, **options)
        found = features.build(clips, mirror=datasets.may_mirror(data, root) if mirror else False, short="skip",
                               progress=distributed.first())
    checkpoint = out.with_name(out.name + ".checkpoint")
    if distributed.first():
        print(f"{found.n_frames:,} frames of {len(found.styles)} styles")
    run = training.fit(found, config, checkpoint, resume=resume, progress=True, log=log)
    if not distributed.first():
        return
    run.save(out, slim=slim)
    checkpoint.unlink(missing_ok=True)
    print("held-out frames: mean squared error of normalised outputs; with another style's vector; of the mean and of the")
    print("frame repeated; error of bone lengths, mm")
    print(f"{'style':<20}{'model':>9}{'other':>9}{'mean':>9}{'repeat':>9}{'bone':>7}")
    for row in run.table():
        errors = "".join(f"{row.get(k, math.nan):>9.4f}" for k in ("error", "other", "mean", "repeat"))
        print(f"{row['style']:<20}{errors}{1000 * row['bone']:>7.1f}")
    if row["error"] >= row["repeat"]:
        print("It predicts no better than by repeating the frame: give it more time, or more motion.")
    print(f"{run.history[-1]['step']:,} steps in {run.history[-1]['elapsed']:.0f} s; wrote {out}")
