"""The verb `demo`: steer the embedded model in a page, train a small model and steer that; walk a crowd."""

import math
import time
from itertools import pairwise
from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import datasets, features, published, runtime, training
from toolkit.cli.verbs import Published, Seed, TrainedRun, say
from toolkit.evaluation import metrics
from toolkit.io import bvh
from toolkit.io.files import write_whole
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS
from toolkit.shots import crowd
from toolkit.styles.transitions import transition

app = typer.Typer(add_completion=False, help="Make something to look at in a minute.")

STYLES = ("Neutral", "Zombie", "Aeroplane")
GAITS = ("FW", "BW", "SW", "TR1")
SPEED = 1.0  # metres per second
OUT = typer.Option(help="Folder to write.")


def blend_weights(frames: int) -> torch.Tensor:
    """Weights ``[frames, 3]`` of the styles: each alone for a while, then the next, at last all three in equal parts."""
    corners = [*STYLES, STYLES[0], dict.fromkeys(STYLES, 1 / 3)]
    leg = frames / FPS / (len(corners) - 1)
    stops = {(k + side) * leg: corner for k, corner in enumerate(corners) for side in (-0.25, 0.25)}
    at = transition(StyleBank(STYLES, torch.eye(3)), stops)
    return torch.stack([at(frame) for frame in range(frames)])


def embedded(folder: Path) -> Path:
    """Write the page that steers the embedded model."""
    from toolkit import view

    title = "The embedded model under your control"
    return view.web(*training.pretrained(), folder / "embedded.html", title=title, half=True)


def make(folder: Path, seconds: float = 35.0, *, data_seconds: float = 60.0, seed: int = 0,
         progress: bool = False) -> list[Path]:
    """Train a small LPN-FiLM for some seconds on procedural motion and let it walk a figure of eight through a style blend.

    Each of the twelve clips is ``data_seconds`` long. The ``folder`` gets the walk as BVH, page and strip, the measurements,
    the model and a page to steer it in.
    """
    from toolkit import view

    times = [time.perf_counter()]
    clips = datasets.load("procedural", styles=STYLES, gaits=GAITS, seconds=data_seconds, seed=seed)
    data = features.build(clips, progress=progress)
    times.append(time.perf_counter())
    run = training.fit(data, training.Config.quick(seconds=seconds, seed=seed), progress=progress)
    times.append(time.perf_counter())

    t = torch.linspace(0.0, 2 * math.pi, 97)
    eight = torch.stack((2.0 * torch.sin(2 * t), 6.0 * torch.sin(t)), -1)  # (x, z) in metres, starts along +z
    commands = runtime.follow(eight, SPEED)
    weights = blend_weights(len(commands))
    vectors = [run.bank.blend(dict(zip(STYLES, row, strict=True))) for row in weights.tolist()]
    states = list(runtime.states(run.model, commands, lambda frame: vectors[frame], progress=progress))
    contacts = torch.stack([s.contacts[0] for s in states])
    plain, clip = (runtime.record(run.model, states, feet=ik, arms=ik) for ik in (False, True))
    times.append(time.perf_counter())

    prepared, trained, rolled = (b - a for a, b in pairwise(times))
    error = run.table()[-1]
    low, high = metrics.hips_height(clip)
    without, with_ik = (max(metrics.foot_skate(c, contacts).values()) * 100 for c in (plain, clip))
    report = [
        f"data       {data.n_frames:,} frames of {len(data.styles)} styles, made in {prepared:.1f} s",
        f"training   {run.history[-1]['step']:,} steps in {trained:.1f} s, "
        f"{sum(p.numel() for p in run.model.parameters()):,} parameters with those of the FiLM generator",
        f"held out   mean squared error {error['error']:.4f} (predicting the mean {error['mean']:.4f}, "
        f"repeating the frame {error['repeat']:.4f})",
        f"rollout    {len(clip):,} frames, {rolled / len(clip) * 1000:.1f} ms each (real time is {1000 / FPS:.1f})",
        f"speed      {metrics.speed(clip):.2f} m/s, asked for {SPEED:.2f}; {metrics.path_error(clip, eight) * 100:.0f} cm "
        "from the path on average",
        f"hips       {low:.2f} to {high:.2f} m high, {'' if metrics.upright(clip) else 'NOT '}upright all the way",
        f"foot skate {with_ik:.1f} cm/s in contact with foot IK, {without:.1f} without",
    ]

    folder.mkdir(parents=True, exist_ok=True)
    names = "walk.bvh", "walk.html", "strip.png", "report.txt", "model.safetensors", "controller.html"
    files = [folder / name for name in names]
    bvh.save(clip, files[0])
    view.html(clip, files[1], title="A stylised character under control", labels=["figure of eight"], contacts=contacts,
              styles=dict(zip(STYLES, weights.T.tolist(), strict=True)),
              caption=f"Procedural data, a small LPN-FiLM trained in under a minute, blending {' → '.join(STYLES)}.")
    centres = [round(legs * len(clip) / 4) for legs in (0.12, 1, 2, 3.9)]  # of each style alone and of all three
    starts = [min(max(0, centre - 60), len(clip) - 120) for centre in centres]
    view.strip([clip.cut(start, start + 120) for start in starts], files[2], labels=[*STYLES, "all three"])
    if error["error"] >= error["repeat"]:
        report.append("the model predicts no better than repeating the frame: give it more time (--minutes 5)")
    _write(files[3], report)
    run.save(files[4])
    view.web(run.model, run.bank, files[5], title="Trained in under a minute, and under your control")
    return files


def _write(path: Path, lines: list[str]) -> None:
    write_whole(path, ("\n".join(lines) + "\n").encode())


@app.callback(invoke_without_command=True)
def demo_(
    context: typer.Context,
    out: Annotated[Path, OUT] = Path("out/demo"),
    minutes: Annotated[float, typer.Option(help="Time budget of the training.")] = 0.6,
    seed: Seed = 0,
) -> None:
    """Make something to look at: train a small model here and let it walk through a blend of three styles."""
    if context.invoked_subcommand is not None:
        return
    page = embedded(out)
    say(f"Open {page} in a browser: the embedded model walks there.")
    say(f"Meanwhile motion is generated (a minute), and a small model learns it for {60 * minutes:g} s.")
    files = make(out, 60 * minutes, seed=seed, progress=True)
    say(files[3].read_text(encoding="utf-8"))
    say("Look at it:")
    for file in [page, *files]:
        say(f"  {file}")
    say(f"\nNext: open {files[-1]} in a browser and walk; `make lab` starts JupyterLab on the notebooks.")


@app.command("crowd")
def demo_crowd(
    out: Annotated[Path, OUT] = Path("out/crowd"),
    characters: Annotated[int, typer.Option(help="Number of characters.")] = 100,
    seconds: Annotated[float, typer.Option(help="Length of the motion.")] = 10.0,
    model: TrainedRun = None,
    parameters: Published = None,
    threads: Annotated[int, typer.Option(help="Processor cores to use.")] = 1,
    seed: Seed = 0,
) -> None:
    """Let two crowds cross, each character in its own style blend; write a picture, an animation and the time taken."""
    say("The runtime is compiled at its first use; that takes a while.")
    net, bank = published.either(model, parameters)
    compiled = runtime.compile(net, threads=threads)
    made = crowd.walk(compiled, bank, characters, seconds, seed=seed, progress=True)
    say(f"{compiled}\n{made.report}")
    from toolkit import view

    out.mkdir(parents=True, exist_ok=True)
    files = [out / name for name in ("crowd.gif", "crowd.png", "crowd.txt")]
    view.crowd([clip.cut(stop=3 * FPS) for clip in made.clips], files[0], fps=8.0, width=640, colors=64, progress=True)
    view.crowd(made.clips, files[1], fps=0, width=1200)
    _write(files[2], [made.report, *(clip.style for clip in made.clips)])
    for file in files:
        say(f"  {file}")
