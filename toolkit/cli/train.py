"""The verb `train`: a model on a dataset or a store."""

import math
from pathlib import Path
from typing import Annotated

from typer import Option

from toolkit import datasets, features, networks, registry, training
from toolkit.cli.motion_files import Target, dataset, target
from toolkit.cli.verbs import (
    ClipSeconds,
    Device,
    Listed,
    Mirror,
    Resume,
    Root,
    Seed,
    Selection,
    say,
)
from toolkit.features import splits
from toolkit.io import save as saving
from toolkit.training import distributed


def train(
    data: Annotated[str, Option(
        help=f"Dataset: {', '.join(datasets.DATASETS)}; or the folder of a store, or of recordings "
             "of your own.")],
    out: Annotated[Path, Option(
        help="File to write: model, style bank and training record (safetensors).")],
    root: Root = None,
    styles: Selection = None,
    gaits: Selection = None,
    skeleton: Target = None,
    mirror: Mirror = False,
    listed: Listed = False,
    clip_seconds: ClipSeconds = None,
    model: Annotated[str, Option(
        help=f"One of {', '.join(networks.MODELS)}; or MODULE:NAME, a model of your own that a "
             "module or a Python file registers.")] = "lpn-film",
    minutes: Annotated[float | None, Option(min=0, help="Time budget of the training.")] = None,
    epochs: Annotated[float | None, Option(
        help="Passes over the shortest style; 90 in the paper.")] = None,
    patience: Annotated[int | None, Option(
        help="Stop after so many test errors (one every 1000 steps) without a better one, and keep "
             "the best weights.")] = None,
    small: Annotated[bool, Option(
        "--small", help="Small sizes and fast settings; 30 s without a budget.")] = False,
    refit: Annotated[int, Option(
        help="Steps per style that fit FiLM's style vectors to frames after the training; 0: means "
             "over clips, as in the paper.")] = training.Config.refit,
    seed: Seed = 0,
    device: Device = "cpu",
    processes: Annotated[int, Option(
        help="Processes that share each minibatch (the extra `scale`), with --device cuda one GPU "
             "each; on several machines use `torchrun … -m toolkit train …` instead.")] = 1,
    precision: Annotated[str, Option(
        help="32, or bf16: faster on a GPU or with many style clips.")] = "32",
    slim: Annotated[bool, Option(
        "--slim", help="Write a small file, to which no style can be added.")] = False,
    resume: Resume = False,
) -> None:
    """Train a model and print its error on held-out frames, and those of two baselines."""
    budget = {} if epochs is None else {"epochs": epochs}
    if minutes is not None:
        budget["seconds"] = 60 * minutes
    config = (training.Config.quick if small else training.Config)(
        **budget, model=networks.imported(model), patience=patience, refit=refit, seed=seed,
        device=device, processes=processes, precision=precision)
    saving.check(out, ())
    # before the data, so that all processes read them at once; only one of them talks and writes
    first = distributed.start(config.device, config.processes).global_rank == 0
    store = registry.find("toolkit.features.store")
    if store.is_store(data):
        if root or gaits or mirror or listed or clip_seconds is not None:
            raise ValueError(f"{data}: a store has its own --root, --gaits, --mirror and --listed; "
                             "choose among its --styles")
        found = store.load(data, styles)
    else:
        data, root = dataset(data, root)
        options = {} if clip_seconds is None else {"seconds": clip_seconds}
        if skeleton is not None:
            if data != "folder":
                raise ValueError("--skeleton is for a folder of your own recordings")
            options["target"] = target(skeleton)
        clips = datasets.load(data, root, styles, gaits, **options)
        mirrored = datasets.may_mirror(data, root) if mirror else False
        if listed:
            parts = datasets.split(data, root)
            found = splits.listed(clips, parts, mirror=mirrored, progress=first)
        else:
            found = features.build(clips, mirror=mirrored, short="skip", progress=first)
    checkpoint = out.with_name(out.name + ".checkpoint")
    if first:
        say(f"{found.n_frames:,} frames of {len(found.styles)} styles")
    run = training.fit(found, config, checkpoint, resume=resume, progress=True)
    if not first:
        return
    run.save(out, slim=slim)
    checkpoint.unlink(missing_ok=True)
    say(
        "Held-out frames. Mean squared error of normalised outputs: the model, the model with "
        "another style's vector,\n"
        "predicting the mean, repeating the frame. Error of bone lengths in mm."
    )
    say(f"{'style':<20}{'model':>9}{'other':>9}{'mean':>9}{'repeat':>9}{'bone':>7}")
    rows = run.table()
    for row in rows:
        errors = "".join(f"{row.get(name, math.nan):>9.4f}"
                         for name in ("error", "other", "mean", "repeat"))
        say(f"{row['style']:<20}{errors}{1000 * row['bone']:>7.1f}")
    if rows and rows[-1]["error"] >= rows[-1]["repeat"]:
        say("The model predicts no better than repeating the frame: give it more time, or more "
            "motion.")
    say(f"{run.history[-1]['step']:,} steps in {run.history[-1]['elapsed']:.0f} s; wrote {out}")
