"""From nothing to a stylised character under control: in seconds the embedded one, in a minute one trained here."""

import math
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import datasets, features, published, runtime, training
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.io import bvh
from toolkit.motion import Clip
from toolkit.runtime import FPS, crowd

app = typer.Typer(help="Something to look at in a minute.")

STYLES = ("Neutral", "Zombie", "Aeroplane")
GAITS = ("FW", "BW", "SW", "TR1")
SPEED = 1.0  # metres per second


@dataclass(frozen=True)
class Demo:
    """What the demo made: the run, the clip, its predicted contacts [F, 2], blend weights ``{style: [F]}``, measurements."""

    run: training.Run
    clip: Clip
    contacts: torch.Tensor
    weights: dict[str, list[float]]
    report: list[str]


def path(laps: int = 1) -> torch.Tensor:
    """A figure of eight on the floor: (x, z) points ``[P, 2]`` in metres, starting along +z."""
    t = torch.linspace(0.0, 2 * math.pi * laps, 96 * laps + 1)
    return torch.stack((2.0 * torch.sin(2 * t), 6.0 * torch.sin(t)), -1)


def blend_weights(frames: int) -> dict[str, torch.Tensor]:
    """Weights ``[frames]`` of the three styles: each alone for a while, then into the next, at last all three together."""
    corners = torch.cat((torch.eye(3), torch.eye(3)[:1], torch.full((1, 3), 1 / 3)))
    position = torch.linspace(0.0, len(corners) - 1.0, frames)
    index = position.floor().long().clamp(max=len(corners) - 2)
    share = ((position - index) * 2.0 - 0.5).clamp(0.0, 1.0)  # half of every leg holds, half moves
    share = share * share * (3.0 - 2.0 * share)
    mixed = torch.lerp(corners[index], corners[index + 1], share[:, None])
    return dict(zip(STYLES, mixed.T, strict=True))


def stroll(model, bank, *, progress: bool = False) -> tuple[Clip, Clip, torch.Tensor, dict[str, torch.Tensor]]:
    """Walk along `path` through `blend_weights`: the clip with IK and without, predicted contacts [F, 2], the weights."""
    commands = runtime.follow(path(), SPEED)
    weights = blend_weights(len(commands))
    vectors = [bank.blend({s: float(w[frame]) for s, w in weights.items()}) for frame in range(len(commands))]
    states = list(runtime.states(model, commands, lambda frame: vectors[frame], progress=progress))
    contact = torch.stack([s.contacts[0] for s in states])
    plain, clip = (runtime.record(model, states, feet=ik, arms=ik) for ik in (False, True))
    return clip, plain, contact, weights


def greet(folder: Path) -> Path:
    """The embedded model under control in a web page: something to play with while the demo's own model is trained."""
    from toolkit import view

    title = "The embedded model under your control"
    return view.web(*training.pretrained(), folder / "embedded.html", title=title, half=True)


def make(seconds: float = 35.0, *, data_seconds: float = 60.0, seed: int = 0, progress: bool = False) -> Demo:
    """Generate procedural motion, train a small LPN-FiLM on it, and drive a character along `path` through a style blend.

    Parameters
    ----------
    seconds
        Time budget of training.
    data_seconds
        Length of each of the twelve procedural clips.
    seed
        Of the data and the training.
    progress
        Show bars.
    """
    began = time.perf_counter()
    clips = datasets.load("procedural", styles=STYLES, gaits=GAITS, seconds=data_seconds, seed=seed)
    data = features.build(clips, progress=progress)
    prepared = time.perf_counter()
    run = training.fit(data, training.Config.quick(seconds=seconds, seed=seed), progress=progress)
    trained = time.perf_counter()

    clip, plain, contact, weights = stroll(run.model, run.bank, progress=progress)
    rolled = time.perf_counter()

    error = run.table()[-1]
    low, high = metrics.hips_height(clip)
    skate = {name: max(metrics.foot_skate(c, contact).values()) for name, c in (("without", plain), ("with", clip))}
    report = [
        f"data       {data.n_frames:,} frames of {len(data.styles)} styles, made in {prepared - began:.1f} s",
        f"training   {run.history[-1]['step']:,} steps in {trained - prepared:.1f} s, "
        f"{sum(p.numel() for p in run.model.parameters()):,} parameters with those of the FiLM generator",
        f"held out   mean squared error {error['error']:.4f} (predicting the mean {error['mean']:.4f}, "
        f"repeating the frame {error['repeat']:.4f})",
        f"rollout    {len(clip):,} frames, {(rolled - trained) / len(clip) * 1000:.1f} ms each "
        f"(real time is {1000 / runtime.FPS:.1f})",
        f"speed      {metrics.speed(clip):.2f} m/s, asked for {SPEED:.2f}; {metrics.path_error(clip, path()) * 100:.0f} cm "
        "from the path on average",
        f"hips       {low:.2f} to {high:.2f} m high, {'' if metrics.upright(clip) else 'NOT '}upright all the way",
        f"foot skate {skate['with'] * 100:.1f} cm/s in contact with foot IK, {skate['without'] * 100:.1f} without",
    ]
    return Demo(run, clip, contact, {s: w.tolist() for s, w in weights.items()}, report)


def write(demo: Demo, folder: Path) -> list[Path]:
    """Leave the demo's files in a folder: BVH, web page, strip picture, text, the trained model, a page to steer it in."""
    from toolkit import view

    folder.mkdir(parents=True, exist_ok=True)
    names = "walk.bvh", "walk.html", "strip.png", "report.txt", "model.safetensors", "controller.html"
    files = [folder / name for name in names]
    bvh.save(demo.clip, files[0])
    view.html(demo.clip, files[1], title="A stylised character under control", labels=["figure of eight"],
              contacts=demo.contacts, styles=demo.weights,
              caption="Procedural data, a small LPN-FiLM trained in under a minute, "
                      f"blending {' → '.join(STYLES)}.")
    rows = [demo.clip.cut(*span) for span in _solo_spans(len(demo.clip))]
    view.strip(rows, files[2], labels=[*STYLES, "all three"])
    files[3].write_text("\n".join(demo.report) + "\n", encoding="utf-8")
    demo.run.save(files[4])
    view.web(demo.run.model, demo.run.bank, files[5], title="Trained in under a minute, and under your control")
    return files


def _solo_spans(frames: int) -> list[tuple[int, int]]:
    """Two seconds each: every style alone, then all three, as `blend_weights` holds them."""
    leg = frames / 4
    centres = [0.12 * leg, leg, 2 * leg, 3.9 * leg]
    starts = [min(max(0, round(c - 60)), frames - 120) for c in centres]
    return [(s, s + 120) for s in starts]


def write_crowd(made: crowd.Crowd, folder: Path, *, progress: bool = False) -> list[Path]:
    """Leave a moving picture, a still one and the numbers in a folder."""
    from toolkit import view

    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / name for name in ("crowd.gif", "crowd.png", "crowd.txt")]
    view.crowd([clip.cut(stop=3 * FPS) for clip in made.clips], files[0], fps=8.0, width=640, colors=64, progress=progress)
    view.crowd(made.clips, files[1], fps=0, width=1200)
    files[2].write_text("\n".join([made.report, *(clip.style for clip in made.clips)]) + "\n", encoding="utf-8")
    return files


@app.callback(invoke_without_command=True)
def demo_(
    context: typer.Context,
    out: Annotated[Path, typer.Option(help="Folder for what it leaves.")] = Path("out/demo"),
    seconds: Annotated[float, typer.Option(help="Training time.")] = 35.0,
    seed: Annotated[int, typer.Option(help="Of data and training.")] = 0,
) -> None:
    """Train a small model on the embedded data and drive a character through a blend of three styles."""
    if context.invoked_subcommand is not None:
        return
    print(f"The embedded model walks already: open {greet(out)} in a browser.")
    print(f"Meanwhile motion is made, and a small model is trained on it for {seconds:g} s.")
    made = make(seconds, seed=seed, progress=True)
    files = write(made, out)
    print("\n".join(made.report))
    print("\nLook at it:")
    for file in [out / "embedded.html", *files]:
        print(f"  {file}")
    print(f"\nNext: open {files[-1]} in a browser and walk; `make lab` starts JupyterLab on the notebooks.")


@app.command("crowd")
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
    for file in write_crowd(made, out, progress=True):
        print(f"  {file}")
