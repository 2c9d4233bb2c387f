"""Dropout in the hidden layers, and calibration for it: held-out error and feet in closed loop, several seeds."""

import dataclasses
import statistics
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments import closed_loop
from experiments.tables import Result
from toolkit import datasets, features, training
from toolkit.features import splits
from toolkit.networks.model import Sizes
from toolkit.training import Run
from toolkit.training.loss import evaluate

#: Columns of the stored result.
COLUMNS = {"form": ["dropout"], "error": ["held-out error", 4], "upright": ["upright", 0],
           "skate": ["toes in contact at 1 m/s, cm/s: median", 2, 100], "worst": ["worst style", 1, 100],
           "before": ["before IK", 1, 100], "natural": ["worst style at its natural speed", 1, 100]}


def run(
    out: Annotated[Path, typer.Option(help="Folder of the trained models; one that is there is not trained again.")],
    epochs: Annotated[int, typer.Option(min=1, help="Of each training.")] = 4,
    seeds: Annotated[int, typer.Option(min=1, help="Trainings for each dropout.")] = 3,
    clip_seconds: Annotated[float, typer.Option(min=5.0, help="Length of each procedural clip.")] = 15.0,
    walks: Annotated[float, typer.Option(min=2.0, help="Seconds of each walk, after a warm-up of 4 s.")] = 10.0,
    store: Annotated[bool, typer.Option("--store", help="Write the table's file in docs/results.")] = False,
) -> None:
    """Train with and without dropout, and compare held-out error and feet, with and without calibration."""
    data = features.build(datasets.load("procedural", seconds=clip_seconds))
    rows = []
    for dropout in (0.0, 0.1):
        trained = [_trained(data, out, dropout, seed, epochs) for seed in range(seeds)]
        for calibrated in (False, True)[: 2 if dropout else 1]:
            found = [_measure(one, data, calibrated, walks) for one in trained]
            row = {key: [one[key] for one in found] for key in found[0]}
            rows.append({"form": f"{dropout:g}{', calibrated' * calibrated}", **row})
            print(rows[-1])
    result = Result("dropout", f"Procedural styles, {epochs} epochs, a run for each of {seeds} seeds; walks of all styles",
                    f"python -m experiments dropout --out FOLDER --epochs {epochs} --walks {walks:g} --store", COLUMNS, rows,
                    {"epochs": epochs, "seeds": seeds, "seconds of a clip": clip_seconds, "seconds of a walk": walks})
    print(result.markdown() + (f"wrote {result.add()}" if store else ""))


def _trained(data: features.Features, out: Path, dropout: float, seed: int, epochs: int) -> Run:
    path = out / f"d{dropout:g}_s{seed}.safetensors"
    if not path.exists():
        sizes = dataclasses.replace(Sizes.small(), dropout=dropout)
        out.mkdir(parents=True, exist_ok=True)
        training.fit(data, training.Config.quick(epochs=epochs, seed=seed, sizes=sizes)).save(path)
    return training.load(path)


def _measure(trained: Run, data: features.Features, calibrated: bool, seconds: float) -> dict[str, float]:
    trained.model.calibrated = calibrated
    config, bank = trained.config, trained.bank
    test = splits.split(data, config.held_out, config.seed, tuple(data.styles))[1]
    errors = evaluate(trained.model, bank, test, 500).values()
    walked = [closed_loop.walk(trained.model, bank, speeds, seconds)
              for speeds in ([1.0] * len(bank), [bank.speed(name) for name in bank.names])]
    skates = torch.tensor([[row["skate"] for row in rows] for rows in walked])
    worst, natural = skates.nan_to_num(float("inf")).amax(1).tolist()
    return {"error": statistics.mean(one["mse"] for one in errors), "upright": sum(row["upright"] for row in walked[0]),
            "skate": float(skates[0].nanmedian()), "worst": worst,
            "before": statistics.median(row["before"] for row in walked[0]), "natural": natural}
