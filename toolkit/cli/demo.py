"""The verb `demo`: steer the embedded model in a page, train a small model and steer that."""

import math
import time
from itertools import pairwise
from pathlib import Path
from typing import Annotated

import torch
from typer import Option

from toolkit import datasets, features, runtime, training
from toolkit.cli.verbs import Seed, say
from toolkit.evaluation import metrics
from toolkit.io import bvh
from toolkit.io.files import write_whole
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS
from toolkit.styles.transitions import transition
from toolkit.training.run import included

STYLES = ("Neutral", "Zombie", "Aeroplane")
GAITS = ("FW", "BW", "SW", "TR1")
SPEED = 1.0  # metres per second
#: A page that shows one of several others.
SWITCH = """<!doctype html>
<meta charset="utf-8">
<title>The embedded models</title>
<body style="margin: 0; height: 100vh; display: flex; flex-direction: column">
<p style="margin: 8px">The model was trained on motion that is: {links}</p>
<iframe name="model" src="{first}" onload="this.focus()" style="flex: 1; border: 0"></iframe>
"""
NAMES = ("walk.bvh", "walk.html", "report.txt", "model.safetensors", "controller.html")


def blend_weights(frames: int) -> torch.Tensor:
    """Weights ``[frames, 3]``: each style alone for a while, at last all three in equal parts."""
    corners = [*STYLES, STYLES[0], dict.fromkeys(STYLES, 1 / 3)]
    leg = frames / FPS / (len(corners) - 1)
    stops = {}
    for k, corner in enumerate(corners):
        stops |= {(k - 0.25) * leg: corner, (k + 0.25) * leg: corner}
    at = transition(StyleBank(STYLES, torch.eye(3)), stops)
    return torch.stack([at(frame) for frame in range(frames)])


def embedded(folder: Path) -> Path:
    """Write the page that steers the embedded models: of procedural motion and, in a checkout, of
    recorded people.
    """
    from toolkit import view

    names = included()
    pages = [view.web(*training.pretrained(name), folder / f"{name}.html", half=True,
                      title=f"The {name} model under your control") for name in names]
    links = " or ".join(f'<a href="{page.name}" target="model">{name}</a>'
                        for name, page in zip(names, pages, strict=True))
    made = folder / "embedded.html"
    write_whole(made, SWITCH.format(links=links, first=pages[-1].name).encode())
    return made


def make(folder: Path, seconds: float = 35.0, *, data_seconds: float = 60.0, seed: int = 0,
         progress: bool = False) -> list[Path]:
    """Train a small LPN-FiLM and let it walk a figure of eight through a style blend.

    It learns for some seconds from twelve procedural clips of ``data_seconds`` each. The ``folder``
    gets the walk as BVH and page, the measurements, the model and a page to steer it in.
    """
    from toolkit import view

    # data and training
    times = [time.perf_counter()]
    clips = datasets.load("procedural", styles=STYLES, gaits=GAITS, seconds=data_seconds, seed=seed)
    data = features.build(clips, progress=progress)
    times.append(time.perf_counter())
    run = training.fit(data, training.Config.quick(seconds=seconds, seed=seed), progress=progress)
    times.append(time.perf_counter())

    # the walk, with and without IK
    t = torch.linspace(0.0, 2 * math.pi, 97)
    eight = torch.stack((2.0 * torch.sin(2 * t), 6.0 * torch.sin(t)), -1)  # (x, z), starts along +z
    commands = runtime.follow(eight, SPEED)
    weights = blend_weights(len(commands))
    vectors = weights @ run.bank.select(STYLES).vectors
    states = list(runtime.states(run.model, commands, lambda frame: vectors[frame],
                                 progress=progress))
    contacts = torch.stack([state.contacts[0] for state in states])
    plain, clip = (runtime.record(run.model, states, feet=ik, arms=ik) for ik in (False, True))
    times.append(time.perf_counter())

    # what was measured
    prepared, trained, rolled = (b - a for a, b in pairwise(times))
    error = run.table()[-1]
    away = metrics.path_error(clip, eight) * 100
    skate = [max(metrics.foot_skate(c, contacts).values()) * 100 for c in (plain, clip)]
    report = [
        f"data       {data.n_frames:,} frames of {len(data.styles)} styles in {prepared:.1f} s",
        f"training   {run.history[-1]['step']:,} steps in {trained:.1f} s",
        f"held out   mean squared error {error['error']:.4f} (predicting the mean "
        f"{error['mean']:.4f}, repeating the frame {error['repeat']:.4f})",
        f"rollout    {len(clip):,} frames, {rolled / len(clip) * 1000:.1f} ms each (real time is "
        f"{1000 / FPS:.1f}), {away:.0f} cm from the path on average",
        f"foot skate {skate[1]:.1f} cm/s in contact with foot IK, {skate[0]:.1f} without",
    ]
    if error["error"] >= error["repeat"]:
        report.append("the model predicts no better than repeating the frame: give it more time "
                      "(--minutes 5)")

    # the files
    folder.mkdir(parents=True, exist_ok=True)
    files = [folder / name for name in NAMES]
    bvh.save(clip, files[0])
    view.html(clip, files[1], title="A stylised character under control", contacts=contacts,
              labels=["figure of eight"], styles=dict(zip(STYLES, weights.T.tolist(), strict=True)),
              caption="Procedural data, a small LPN-FiLM trained in under a minute, blending "
                      f"{' → '.join(STYLES)}.")
    write_whole(files[2], ("\n".join(report) + "\n").encode())
    run.save(files[3])
    view.web(run.model, run.bank, files[4],
             title="Trained in under a minute, and under your control")
    return files


def demo(
    out: Annotated[Path, Option(help="Folder to write.")] = Path("out/demo"),
    minutes: Annotated[float, Option(min=0, help="Time budget of the training.")] = 0.6,
    seed: Seed = 0,
) -> None:
    """Make something to look at: a small model is trained, and walks through three styles."""
    page = embedded(out)
    say(f"Open {page} in a browser: the embedded models walk there.\nMeanwhile motion is generated "
        f"(a minute), and a small model learns it for {60 * minutes:g} s.")
    files = make(out, 60 * minutes, seed=seed, progress=True)
    say(files[2].read_text(encoding="utf-8"))
    say("Look at it:")
    for file in [page, *files]:
        say(f"  {file}")
    say(f"\nNext: open {files[-1]} in a browser and walk; `make lab` starts JupyterLab on the "
        "notebooks.")
