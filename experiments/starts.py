"""How characters start and stand: how far they come in the first seconds, and how they drift when they are told to stand."""

import itertools
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.tables import Result, line
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.runtime import FPS, Command

STYLES = ("Akimbo", "ArmsAboveHead", "BentForward", "BigSteps", "Drunk", "HighKnees", "LeanBack", "LimpLeft", "Neutral",
          "Old", "PendulumHands", "Penguin", "Tiptoe", "WideLegs", "Zombie")  # known to both models
SPEEDS, WALK, STAND = (0.6, 0.9), 4 * FPS, 4 * FPS  # m/s; frames
COLUMNS = {
    "model": ["model"], "blends": ["styles and blends of two", 0], "speed": ["asked, m/s", 1],
    "one": ["way in 1 s / asked: median", 2], "one_most": ["most", 2],
    "two": ["in 2 s: median", 2], "two_least": ["least", 2], "two_most": ["most", 2],
    "drift": ["drift when told to stand, cm/s: median", 0, 100], "drift_most": ["most", 0, 100],
    "drifting": ["over 10 cm/s", 0],
}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    save: Annotated[Path | None, typer.Option(help="Add the rows to the result starts in this folder.")] = None,
) -> None:
    """The way of the first two seconds beside the way that is asked for, and the drift of those who are told to stand."""
    net, bank = published.either(model, parameters)
    net, name = runtime.compile(net), "embedded" if parameters is None else "published"
    blends = [(style,) for style in STYLES] + list(itertools.combinations(STYLES, 2))
    vectors, rows = torch.stack([bank.blend({style: 1 / len(names) for style in names}) for names in blends]), []
    for speed in SPEEDS:
        places, still = [], torch.zeros(1, 2)
        commands = [Command(torch.tensor([[0.0, speed]]))] * WALK + [Command(still)] * STAND
        for state in runtime.states(net, commands, vectors):
            places.append(state.root[:, :2])
        one, two = (places[seconds * FPS - 1][:, 1] / (speed * seconds) for seconds in (1, 2))
        drift = (places[-1] - places[-1 - STAND // 2]).norm(dim=-1) * FPS / (STAND // 2)
        rows.append({"model": name, "blends": len(blends), "speed": speed, "one": float(one.median()),
                     "one_most": float(one.max()), "two": float(two.median()), "two_least": float(two.min()),
                     "two_most": float(two.max()), "drift": float(drift.median()), "drift_most": float(drift.max()),
                     "drifting": int((drift > 0.1).sum())})
        print(line(COLUMNS, rows[-1]), flush=True)
    if save is not None:
        known = Result.load("starts", save).rows if (save / "starts.json").exists() else []
        Result("starts", "characters who start from standing, walk for four seconds and are told to stand for four",
               "python -m experiments starts", COLUMNS, [*(r for r in known if r["model"] != name), *rows]).save(save)
