"""Styles learnt from single clips, each judged by its walk beside the clip (`styles.compare`)."""

import math
import re
from collections import Counter
from pathlib import Path
from typing import Annotated

import typer

from experiments.tables import Result, Store
from toolkit import published, styles
from toolkit.cli import verbs
from toolkit.cli.style import fitted
from toolkit.io.load import load
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.training import Run
from toolkit.view import strip

STEPS = 150
ABOUT = "Styles learnt from one walking clip each, by their walk beside the clip."
COMMAND = ("python -m experiments added-styles --root DATA --kinds 'xia|foreign|pfnn|100style' "
           "[--model examples/models/recorded.safetensors] --store")
WAYS = {"error": "the vector of the least error", "walk": "the vector that walks best",
        "learn": "the best of all ways", "floor": "the nearest old style"}
COLUMNS = {"learnt": ["base", None], "good": ["good", 0], "weak": ["weak", 0],
           "failed": ["failed", 0], "refused": ["refused", 0], "excess": ["median excess", 2]}


def run(
    root: Annotated[Path, typer.Option(help="Folder of the data sets: bandai, xia, pfnn, foreign, "
                                            "100style.")],
    parameters: verbs.Published = None,
    model: verbs.TrainedRun = None,
    take: Annotated[int, typer.Option(help="Which take of each style of Bandai-Namco: 0 is the "
                                           "first, -1 the last.")] = -1,
    kinds: Annotated[str, typer.Option(help="Which clips: a part of their paths.")] = "",
    pictures: Annotated[Path | None, typer.Option(help="Folder for a strip of each clip.")] = None,
    store: Store = False,
) -> None:
    """Verdicts on a style of every walking clip, and on the nearest old style as a floor.

    The limits of the verdicts were chosen on the last take of each style.
    """
    net = published.either(model, parameters)
    base = "published" if parameters else "procedural" if model is None else model.stem
    found: dict[str, list[styles.Comparison]] = {way: [] for way in WAYS}
    refused = 0
    files = [file for file in clips(root, take) if re.search(kinds, str(file))]
    for file in progress_bar(files, desc="styles", unit="clip"):
        try:
            clip = fitted(load(file), net.model, net.bank)
            why = styles.not_a_walk(clip)
        except ValueError as error:
            why = str(error)
        if why:
            print(f"{file.name}: refused: {why}")
            refused += 1
            continue
        one = judged(net, clip)
        for way, compared in one.items():
            found[way].append(compared)
        print(file.name, *(f"{way}: {c.verdict} {c.excess:.2f}" for way, c in one.items()),
              sep="; ")
        print(one["learn"], flush=True)
        if pictures:
            cycles = one["learn"].cycles()
            strip(list(cycles.values()), pictures / f"{base}_{file.stem}.png",
                  labels=list(cycles), width=10, dpi=60)
    rows = []
    for way, compared in found.items():
        count = Counter(c.verdict for c in compared)
        excesses = sorted(c.excess for c in compared) or [math.nan]
        rows.append({"learnt": f"{base}: {WAYS[way]}", "good": count["good"],
                     "weak": count["weak"], "failed": count["failed"], "refused": refused,
                     "excess": excesses[len(excesses) // 2]})
        print(rows[-1])
    if store:
        Result("added-styles", ABOUT, COMMAND, COLUMNS, rows,
               {"steps": STEPS, "kinds": kinds, "take": take}).add()


def clips(root: Path, take: int) -> list[Path]:
    """A walk of each style of Bandai-Namco, runs of some, and walks of other sources."""
    takes: dict[str, list[Path]] = {}
    for file in sorted((root / "bandai").glob("dataset-*/*.bvh")):
        name = file.stem.rpartition("_")[0]
        if "_walk_" in name or "_run_" in name:
            takes.setdefault(name, []).append(file)
    others = ["xia/neutral_01_000.bvh", "xia/sexy_01_000.bvh", "xia/strutting_01_000.bvh",
              "foreign/bvh-toolbox__walk01.bvh", "foreign/bvh-python__test_freebvh.bvh",
              "foreign/pybvh__cmu_12_01_walk.bvh", "foreign/animateddrawings__zombie.bvh",
              "pfnn/LocomotionFlat04_000.bvh", "100style/Neutral_FW.bvh"]
    return [files[take] for files in takes.values()] + [root / other for other in others]


def judged(net: Run, clip: Clip) -> dict[str, styles.Comparison]:
    """Comparisons by `WAYS`."""
    made = styles.fine_tune(net.model, clip, "new", net.bank, steps=STEPS)
    walk = best = styles.choose(made, clip)[1]
    if walk.verdict != "good":  # else `learn` stops after the same way
        best = styles.learn(net.model, net.bank, [clip], "new", steps=STEPS).compared
    nearest = made.bank.nearest("new", 1)[0][0]
    return {"error": styles.compare(clip, made.model, "new", made.bank), "walk": walk,
            "learn": best, "floor": styles.compare(clip, net.model, nearest, net.bank)}
