"""Styles learnt from single clips, each judged by its walk beside the clip (`styles.compare`)."""

import warnings
from collections import Counter
from pathlib import Path
from statistics import median
from typing import Annotated

import typer

from experiments.tables import Result, Store
from toolkit import published, styles
from toolkit.cli import verbs
from toolkit.cli.style import fitted
from toolkit.io.files import below
from toolkit.io.load import load
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.training import Run
from toolkit.view import strip

STEPS = styles.fine_tuning.STEPS
ABOUT = "Styles learnt from one walking clip each, by their walk beside the clip."
COMMAND = ("python -m experiments added-styles --root DATA [--fresh] "
           "[--model examples/models/recorded.safetensors] --store")
WAYS = {"error": "the vector of the least error", "trained": "the best vector of a training",
        "searched": "after the search", "floor": "the nearest old style"}
COLUMNS = {"learnt": ["base", None], "good": ["good", 0], "weak": ["weak", 0],
           "failed": ["failed", 0], "excess": ["median excess", 2]}
EACH = {"clip": ["clip", None], "eye": ["by eye", None], "why": ["why", None],
        **{way: [name, None] for way, name in WAYS.items()},
        **{f"{way} excess": ["excess", 2] for way in WAYS}}
#: The recorded walks on which the limits of the verdicts were chosen.
CHOSE = ("xia/neutral_01_000", "xia/sexy_01_000", "xia/strutting_01_000",
         "foreign/bvh-toolbox__walk01", "foreign/bvh-python__test_freebvh",
         "foreign/pybvh__cmu_12_01_walk", "foreign/animateddrawings__zombie",
         "pfnn/LocomotionFlat04_000", "100style/Neutral_FW")
#: Styles that the pictures show as half of the clip's, though the verdict is good.
HALF = tuple(f"recorded: cmu_new/walk_{name}" for name in (
    "clap", "clap001", "raise_the_roof", "raise_the_roof001", "side_point2_", "side_point2_001",
    "side_punch", "sway"))


def run(
    root: Annotated[Path, typer.Option(help="Folder of motion files.")],
    parameters: verbs.Published = None,
    model: verbs.TrainedRun = None,
    fresh: Annotated[bool, typer.Option(
        "--fresh", help="The files that chose no limit, in place of those that did.")] = False,
    pictures: Annotated[Path | None, typer.Option(help="Folder for a strip of each clip.")] = None,
    store: Store = False,
) -> None:
    """Verdicts on a style of every walking clip, and on the nearest old style as a floor."""
    net = published.either(model, parameters)
    base = "published" if parameters else "procedural" if model is None else model.stem
    each = Result("added-styles-each", ABOUT, COMMAND, EACH, [], {"steps": STEPS})
    for file in progress_bar(files(root, fresh), desc="styles", unit="clip"):
        name = f"{base}: {file.parent.name}/{file.stem}"
        clip, why = walk(file, net)
        if clip is None:
            print(f"{name}: refused: {why}", flush=True)
            continue
        found = judged(net, clip)
        print(name, *(f"{way}: {c.verdict} {c.excess:.2f}" for way, c in found.items()), sep="; ")
        best = found["searched"]
        print(best, flush=True)
        row = {"clip": name, "eye": "weak" if name in HALF else best.verdict,
               "why": "; ".join(best.reasons)}
        for way, compared in found.items():
            row |= {way: compared.verdict, f"{way} excess": compared.excess}
        each.rows.append(row)
        if store:  # at once: a run takes hours
            each.add()
        if pictures:
            cycles = best.cycles()
            strip(list(cycles.values()), pictures / f"{name.replace('/', '_')}.png",
                  labels=list(cycles), width=10, dpi=60)
    # of all clips that are stored, also by other runs
    clips = Result.load(each.name).rows if store else each.rows
    clips = [row for row in clips if row["clip"].startswith(base)
             and (row["clip"].removeprefix(f"{base}: ") not in CHOSE) == fresh]
    rows = []
    for way, name in WAYS.items():
        count = Counter(row[way] for row in clips)
        rows.append({"learnt": f"{base}{', fresh clips' * fresh}: {name}",
                     **{verdict: count[verdict] for verdict in styles.comparison.VERDICTS},
                     "excess": median(row[f"{way} excess"] for row in clips)})
    result = Result("added-styles", ABOUT, COMMAND, COLUMNS, rows, {"steps": STEPS})
    print(result.markdown())
    if store:
        result.add()


def files(root: Path, fresh: bool) -> list[Path]:
    """The files on which the limits were chosen, or all others."""
    if not fresh:
        return [root / f"{name}.bvh" for name in CHOSE]
    return [file for file in below(root)
            if file.suffix == ".bvh" and f"{file.parent.name}/{file.stem}" not in CHOSE]


def walk(file: Path, net: Run) -> tuple[Clip | None, str]:
    """The clip of a file on the model's skeleton, or None and why it is no walk."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            clip = load(file)
        if why := styles.not_a_walk(clip):  # before the retargeting, which takes longer
            return None, why
        clip = fitted(clip, net.model, net.bank)
        why = styles.not_a_walk(clip)
    except ValueError as error:
        return None, str(error)
    return (None, why) if why else (clip, "")


def judged(net: Run, clip: Clip) -> dict[str, styles.Comparison]:
    """Comparisons by `WAYS`."""
    best = styles.learn(net.model, net.bank, [clip], "new", steps=STEPS)
    made = best.made
    nearest = made.bank.nearest("new", 1)[0][0]
    return {"error": styles.compare(clip, made.model, "new", made.bank),
            "trained": styles.choose(made, clip, rounds=0)[1], "searched": best.compared,
            "floor": styles.compare(clip, net.model, nearest, net.bank)}
