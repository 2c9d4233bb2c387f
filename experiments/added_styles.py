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
from toolkit.motion import Clip
from toolkit.styles import comparison
from toolkit.training import Run
from toolkit.view import strip

COMMAND = ("python -m experiments added-styles --root DATA [--fresh] "
           "[--model examples/models/recorded.safetensors] --store")
WAYS = {"trained": "one step ahead", "added": "style add", "floor": "the nearest old style"}
COLUMNS = {"learnt": ["model, clips", None], "good": ["good", 0], "weak": ["weak", 0],
           "failed": ["failed", 0], "excess": ["median excess", 2],
           "second": ["on a second take", 2], "takes": ["takes", 0]}
EACH = {"clip": ["clip", None], "why": ["style add says", None],
        **{way: [name, None] for way, name in WAYS.items()},
        **{f"{way} {column}": [column, 2] for way in WAYS for column in ("excess", "second")},
        "take second": ["second", 2]}
#: The recorded walks on which the limits of the verdicts were chosen.
CHOSE = ("xia/neutral_01_000", "xia/sexy_01_000", "xia/strutting_01_000",
         "foreign/bvh-toolbox__walk01", "foreign/bvh-python__test_freebvh",
         "foreign/pybvh__cmu_12_01_walk", "foreign/animateddrawings__zombie",
         "pfnn/LocomotionFlat04_000", "100style/Neutral_FW")


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
    each = Result("added-styles-each", __doc__, COMMAND, EACH, [])
    for file in files(root, fresh):
        name = f"{base}: {file.parent.name}/{file.stem}"
        clip, why = walk(file, net)
        if clip is None:
            print(f"{name}: refused: {why}", flush=True)
            continue
        best, found = judged(net, clip, second_take(file, net))
        print(name, *(f"{key}: {value}" for key, value in found.items()), best, flush=True)
        each.rows.append({"clip": name, "why": "; ".join(best.reasons), **found})
        if store:  # at once
            each.add()
        if pictures:
            strip(list(best.clips.values()), pictures / f"{name.replace('/', '_')}.png",
                  labels=list(best.clips), width=10, dpi=60)
    # of all clips that are stored, also by other runs
    clips = Result.load(each.name).rows if store else each.rows
    clips = [row for row in clips if row["clip"].startswith(base)
             and (row["clip"].removeprefix(f"{base}: ") not in CHOSE) == fresh]
    rows = []
    for way, name in WAYS.items():
        count = Counter(row[way] for row in clips)
        seconds = [row[f"{way} second"] for row in clips if f"{way} second" in row]
        rows.append({"learnt": f"{base}{', fresh' * fresh}: {name}",
                     **{verdict: count[verdict] for verdict in comparison.VERDICTS},
                     "excess": median(row[f"{way} excess"] for row in clips),
                     "second": median(seconds) if seconds else None, "takes": len(seconds)})
    result = Result("added-styles", __doc__, COMMAND, COLUMNS, rows)
    print(result.markdown())
    if store:
        result.add()


def files(root: Path, fresh: bool) -> list[Path]:
    """The files on which the limits were chosen, or all others."""
    return [file for file in below(root) if file.suffix == ".bvh"
            and (f"{file.parent.name}/{file.stem}" not in CHOSE) == fresh]


def walk(file: Path, net: Run) -> tuple[Clip | None, str]:
    """The clip of a file on the model's skeleton, or None and why it is no walk."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            clip = fitted(load(file), net.model, net.bank)
        why = styles.not_a_walk(clip)
    except ValueError as error:
        return None, str(error)
    return (None, why) if why else (clip, "")


def second_take(file: Path, net: Run) -> Clip | None:
    """A walk in the same folder whose name differs in the last number only."""
    others = [other for other in sorted(file.parent.glob("*.bvh")) if other != file
              and other.stem.rstrip("0123456789") == file.stem.rstrip("0123456789")]
    return next((clip for other in others if (clip := walk(other, net)[0])), None)


def judged(net: Run, clip: Clip, second: Clip | None) -> tuple[comparison.Comparison, dict]:
    """The comparison of the learnt style, and cells of `EACH`."""
    best = styles.learn(net.model, net.bank, [clip], "new")
    made, found = best.made, {}
    nearest = made.bank.nearest("new", 1)[0][0]
    for way, model, bank, name in (
            ("trained", made.model, styles.choose(made, clip, rounds=0)[0], "new"),
            ("added", made.model, best.bank, "new"), ("floor", net.model, net.bank, nearest)):
        compared = styles.compare(clip, model, name, bank)
        found |= {way: compared.verdict, f"{way} excess": compared.excess}
        if second is not None:
            beside = styles.compare(second, model, name, bank)
            found[f"{way} second"] = beside.excess
    if second is not None:  # two takes have different paths
        own = comparison.measures(*map(comparison.middle, (clip, second)))
        found["take second"] = max(comparison.difference(beside.rows | {"style": own}, what)
                                   for what in own if what not in ("speed", "direction"))
    return best.compared, found
