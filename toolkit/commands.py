"""The verbs of the command line that belong to no single part: data, preprocess, train, rollout, demo."""

import math
import os
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import (
    crowd,
    datasets,
    demo,
    engine,
    export,
    features,
    metrics,
    networks,
    published,
    runtime,
    store,
    training,
    verbs,
)
from toolkit.datasets.commands import data_fetch
from toolkit.motion import Clip

data_app = typer.Typer(no_args_is_help=True, help="Get datasets and look at them.")
data_app.command("fetch")(data_fetch)
demo_app = typer.Typer(help="Something to look at in a minute.")

Root = Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")]


@data_app.command("table1")
def data_table1(root: Root = None) -> None:
    """Print Table 1 of Mason et al. 2022, counted from 100STYLE's Frame_Cuts.csv."""
    rows = datasets.style100.table1(root)
    print(f"{'Motion gait':<16}{'Frames':>11}{'Time (m)':>10}{'Ratio (%)':>11}")
    for row in rows:
        print(f"{row.gait:<16}{row.frames:>11,}{row.minutes:>10}{row.ratio:>11.1f}")


@data_app.command("list")
def data_list(
    name: Annotated[str, typer.Argument(help=f"Dataset: {', '.join(datasets.DATASETS)}.")], root: Root = None
) -> None:
    """List a dataset's styles and how many takes of each gait the folder holds."""
    for style, gaits in datasets.contents(name, root).items():
        print(f"{style:<20}" + (", ".join(f"{gait} {n}" for gait, n in gaits.items()) or "no file here"))


@data_app.command("write")
def data_write(
    name: Annotated[str, typer.Argument(help="Dataset: procedural.")],
    out: Annotated[Path, typer.Option(help="Folder to write.")],
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    gaits: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    seconds: Annotated[float, typer.Option(help="Length of each clip.")] = 8.0,
    seed: Annotated[int, typer.Option(help="The same seed gives the same files.")] = 0,
) -> None:
    """Write the computed dataset as files in 100STYLE's layout, with the true contacts and phases beside them."""
    if name != "procedural":
        raise ValueError(f"only the procedural dataset can be written, not {name!r}")
    from toolkit.datasets import procedural

    procedural.write(out, *(None if names is None else names.split(",") for names in (styles, gaits)), seconds, seed)
    print(f"wrote {len(list(out.glob('*.bvh')))} clips; read them by toolkit.datasets.load('100style', root={str(out)!r})")


def preprocess(
    data: Annotated[str, typer.Option(help="Dataset of files: 100style, bandai, xia.")],
    out: Annotated[Path, typer.Option(help="Folder of the store; where a run was stopped, the same command goes on.")],
    root: Root = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    gaits: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    source: Annotated[str, typer.Option(help="Phase source.")] = "hybrid",
    mirror: Annotated[bool, typer.Option("--mirror", help="Add mirror images (100STYLE: of symmetric styles).")] = False,
    workers: Annotated[int | None, typer.Option(min=1, help="Processes; one per processor where not given.")] = None,
    scheduler: Annotated[str | None, typer.Option(help="Address of a Dask scheduler to do the work.")] = None,
) -> None:
    """Compute the features, phases and contacts of all files into a store, which `train --data OUT` reads from the disk."""
    chosen = {kind: None if names is None else names.split(",") for kind, names in (("styles", styles), ("gaits", gaits))}
    mirrored = _symmetric(data, root) if mirror else None
    made = store.preprocess(data, root, out, **chosen, source=source, mirror=mirrored, workers=workers,
                            scheduler=scheduler, progress=True)  # fmt: skip
    found = store.load(out)
    print(f"{found.n_frames:,} frames of {len(found.styles)} styles in {out}"
          + ("" if made else ": finished before, all checksums are right, nothing to do"))  # fmt: skip


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
                "precision": precision}  # fmt: skip
    config = (training.Config.quick if small else training.Config)(**budget, **settings)
    if out.is_dir():
        raise ValueError(f"{out}: is a folder; --out needs a file name")
    out.parent.mkdir(parents=True, exist_ok=True)
    if not os.access(out.parent, os.W_OK):
        raise ValueError(f"{out.parent}: cannot be written to")
    engine.start(config)  # before the data, so that all processes read them at once
    options = {} if clip_seconds is None else {"seconds": clip_seconds}
    chosen = [None if names is None else names.split(",") for names in (styles, gaits)]
    if store.is_store(data) or Path(data).is_dir():
        if root or gaits or mirror or options:
            raise ValueError(f"{data}: a store has its own --root, --gaits and --mirror; choose among its --styles")
        found = store.load(data, chosen[0])
    else:
        clips = datasets.load(data, root, *chosen, **options)
        found = features.build(clips, mirror=_symmetric(data, root) if mirror else False, short="skip",
                               progress=engine.first())  # fmt: skip
    checkpoint = out.with_name(out.name + ".checkpoint")
    if engine.first():
        print(f"{found.n_frames:,} frames of {len(found.styles)} styles")
    run = training.fit(found, config, checkpoint, resume=resume, progress=True, log=log)
    if not engine.first():
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


@demo_app.callback(invoke_without_command=True)
def demo_(
    context: typer.Context,
    out: Annotated[Path, typer.Option(help="Folder for what it leaves.")] = Path("out/demo"),
    seconds: Annotated[float, typer.Option(help="Training time.")] = 35.0,
    seed: Annotated[int, typer.Option(help="Of data and training.")] = 0,
) -> None:
    """Train a small model on the embedded data and drive a character through a blend of three styles."""
    if context.invoked_subcommand is not None:
        return
    print(f"The embedded model walks already: open {demo.greet(out)} in a browser.")
    print(f"Meanwhile motion is made, and a small model is trained on it for {seconds:g} s.")
    made = demo.make(seconds, seed=seed, progress=True)
    files = demo.write(made, out)
    print("\n".join(made.report))
    print("\nLook at it:")
    for file in [out / "embedded.html", *files]:
        print(f"  {file}")
    print(f"\nNext: open {files[-1]} in a browser and walk; `make lab` starts JupyterLab on the notebooks.")


@demo_app.command("crowd")
def demo_crowd(
    out: Annotated[Path, typer.Option(help="Folder for what it leaves.")] = Path("out/crowd"),
    characters: Annotated[int, typer.Option(help="How many.")] = 100,
    seconds: Annotated[float, typer.Option(help="How long they walk.")] = 10.0,
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    threads: Annotated[int, typer.Option(help="Processor cores to share.")] = 1,
    seed: Annotated[int, typer.Option(help="Of the style blends.")] = 0,
) -> None:
    """A crowd on one processor core, each in a style blend of its own: a picture, a moving one, and how fast it was."""
    print("The runtime is compiled the first time; that takes a while.")
    net, bank = published.either(model, parameters)
    compiled = runtime.compile(net, threads=threads)
    made = crowd.walk(compiled, bank, characters, seconds, seed=seed, progress=True)
    print(f"{compiled}\n{made.report}")
    for file in crowd.write(made, out, progress=True):
        print(f"  {file}")


def rollout(
    style: Annotated[str, typer.Option(help="A style, or a blend like Zombie=0.5,Old=0.5.")],
    out: Annotated[Path, typer.Option(help=f"File to write: {', '.join(export.SUFFIXES)} (.png: a strip).")],
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    seconds: Annotated[float, typer.Option(help="How long to walk.")] = 10.0,
    speed: Annotated[float, typer.Option(help="Metres per second.")] = 1.2,
    ik: Annotated[bool, typer.Option(help="Foot and arm IK.")] = True,
) -> None:
    """Walk straight ahead in a style, write it, and print what was measured."""
    export.check(out)
    net, bank = published.either(model, parameters)
    commands = runtime.straight(speed, seconds)
    states = list(runtime.states(net, commands, bank.blend(_blend(style)), progress=True))
    clip = runtime.record(net, states, feet=ik, arms=ik).replace(style=style, gait="FW")
    export.write(clip, out, title=style, progress=True)
    low, high = metrics.hips_height(clip)
    skate = metrics.foot_skate(clip, torch.stack([s.contacts[0] for s in states]))
    print(f"{len(clip)} frames, {metrics.speed(clip):.2f} m/s for {speed:.2f} asked, hips {low:.2f} to {high:.2f} m, "
          f"foot skate right {skate['right'] * 100:.1f} left {skate['left'] * 100:.1f} cm/s; wrote {out}")  # fmt: skip


def _symmetric(data: str, root: Path | None) -> Callable[[Clip | datasets.Take], bool]:
    """Which clips may be mirrored: 100STYLE says of its styles which are symmetric; idling never is."""
    styles = datasets.style100.styles(root) if data == "100style" else {}
    return lambda clip: clip.gait != "ID" and (clip.style not in styles or styles[clip.style].symmetric)


def _blend(text: str) -> dict[str, float]:
    if "=" not in text:
        return {text: 1.0}
    try:
        return {name.strip(): float(weight) for name, weight in (part.split("=") for part in text.split(","))}
    except ValueError:
        raise ValueError(f"a blend is written like Zombie=0.5,Old=0.5; got {text!r}") from None
