"""Motion matching beside the embedded network: quality in closed loop, memory, and time a frame as
the data grow.
"""

import time
import timeit
from typing import Annotated

import torch
import typer

import toolkit as tk
from experiments.seven_models.models import HELD_OUT, Plan, average, closed_loop
from experiments.tables import Result, Store
from toolkit.evaluation import recognition
from toolkit.extra import matching
from toolkit.features import splits

STYLES = ("Neutral", "Zombie", "Aeroplane", "Crouch")
ROWS = (10_000, 100_000, 1_000_000)  # of the data, for the times
FRAMES = 30  # of a run, for the times
MEASURES = {"recognised": ["recognised, %", 0, 100], "upright": ["upright, %", 0, 100],
            "speed": ["speed / asked", 2], "path": ["path, cm", 1, 100],
            "skate": ["skate", 1, 100], "skate_ik": ["skate with IK", 1, 100],
            "steps": ["steps/s", 2]}
COLUMNS = {"model": ["model"], **MEASURES, "megabytes": ["MB", 1], "frame": ["ms a prediction", 2]}


def run(seconds: Annotated[float, typer.Option(help="Length of each procedural clip.")] = 10.0,
        store: Store = False) -> None:
    """Walks of motion matching and of the embedded network, in styles that both know."""
    network, bank = tk.pretrained()
    data = tk.features.build(tk.datasets.load("procedural", styles=STYLES, seconds=seconds))
    train = splits.split(data, HELD_OUT, 0, STYLES)[0]
    recogniser = recognition.train(train)
    rows = []
    for name, (model, known) in {"embedded LPN-FiLM": (network, bank.select(STYLES)),
                                 "motion matching": matching.match(data)}.items():
        found = closed_loop(model, known, data, recogniser, Plan(walk=6.0, radius=1.0))
        rows.append({"model": name, **{key: average([row[key] for row in found.values()])
                                       for key in MEASURES},
                     "megabytes": megabytes(model), "frame": frame_time(model, known.vectors[:1])})
    model, known = matching.match(data)
    whole = model.rows, model.frames, model.numbers
    for count in ROWS:
        drawn = torch.randint(len(whole[0]), (count,), generator=splits.generator(0, count))
        model.rows, model.frames, model.numbers = (part[drawn] for part in whole)
        rows.append({"model": f"motion matching, {count:,} rows", "megabytes": megabytes(model),
                     "frame": frame_time(model, known.vectors[:1])})
    found = Result("matching", f"{len(STYLES)} procedural styles, {data.n_frames:,} frames, walks "
                   "straight ahead and along a figure of eight", "python -m experiments matching "
                   "--store", COLUMNS, rows, {"styles": len(STYLES), "frames": data.n_frames})
    found.show(store)


def megabytes(model) -> float:
    """Memory of parameters and buffers."""
    return sum(t.nbytes for t in (*model.parameters(), *model.buffers())) / 1e6


def frame_time(model, style: torch.Tensor) -> float:
    """Milliseconds of processor time of a `predict` for one character, the least of five runs."""
    x, phases = model.inputs_mean[None], model.phases_mean[None]
    taken = timeit.repeat(lambda: model.predict(x, phases, style), timer=time.process_time,
                          number=FRAMES, repeat=5)
    return 1000 * min(taken) / FRAMES
