"""Ablation and comparison of Park et al. 2021 (Tables 1 and 2): ``python -m experiments stylization``.

Half of the takes train the classifiers that judge the results. The other half trains the generators, without a fifth, whose
windows are the sources and references of the evaluation.
"""

import json
import statistics
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.seven_models.models import machine, write_json
from experiments.stylization import aberman, classifier, holden
from experiments.stylization.classifier import Classifier
from experiments.stylization.evaluation import Judges, accuracy, evaluate, pairs
from toolkit import datasets
from toolkit.features.splits import generator
from toolkit.io import model_files
from toolkit.motion import Clip
from toolkit.stylization import training
from toolkit.stylization.data import Motions, build, split
from toolkit.stylization.losses import LOSSES
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.restyling import stylize
from toolkit.stylization.training import Config

app = typer.Typer(invoke_without_command=True)

OUT = Path("out/stylization")
ABLATION = {"adv+cyc+id": LOSSES[:3], "adv+cyc+id+sty": LOSSES[:4], "adv+cyc+id+sty+ds": LOSSES}
FULL = "adv+cyc+id+sty+ds"
BASELINES = {"Aberman 2020": aberman.fit, "Holden 2016": holden.fit}
PAPER = {
    "noise": dict(zip(ABLATION, ((14.14, 57.92), (8.58, 77.86), (9.09, 72.64)), strict=True)),
    "reference": {FULL: (6.82, 60.86), "Aberman 2020": (15.86, 42.81), "Holden 2016": (14.10, 37.99)},
}  # FMD and recognition accuracy of the content, %
JUDGES, TEST = 0.5, 0.2  # share of all takes for the classifiers; share of the other takes for the test
MEASURES = {"fmd": ("FMD", 1, 2), "content": ("content %", 100, 1), "style": ("style %", 100, 1),
            "diversity": ("diversity cm", 100, 2), "change": ("change cm", 100, 2),
            "contact_f1": ("contact F1", 1, 2), "contact_raw": ("raw F1", 1, 2)}  # title, scale, decimals
EXPLAINED = (
    "FMD: Fréchet distance of the content classifier's features from those of the generators' training motions; content,",
    "style: results whose content, target style is recognised; diversity: mean distance of a joint between two results for",
    "one source and style; change: the same between source and result; contact F1: agreement of foot contacts after",
    "foot-skate removal, raw: before it. mean ± deviation over the seeds. paper: other data, its own classifier.",
)


@dataclass(frozen=True)
class Plan:
    """Settings of all runs in a folder.

    ``data`` in words; ``iterations`` of every run; ``small`` networks and fast settings or the paper's; at most ``sources``
    restyled windows; ``epochs`` of the classifiers.
    """

    data: str
    iterations: int
    small: bool = False
    sources: int = 100
    epochs: int = 5

    def config(self, losses: tuple[str, ...], seed: int) -> Config:
        """Training settings of one stylizer."""
        return (Config.quick if self.small else Config)(losses=losses, iterations=self.iterations, seed=seed)


@app.callback()
def run(
    context: typer.Context,
    out: Annotated[Path, typer.Option(help="Folder of the runs; finished runs in it are not repeated.")] = OUT,
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(datasets.DATASETS)}.")] = "bandai",
    root: Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")] = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated domains; default: all.")] = None,
    gaits: Annotated[str | None, typer.Option(help="Comma-separated contents; default: all.")] = None,
    iterations: Annotated[int, typer.Option(min=1, help="Training iterations of every run; 100,000 in the paper.")] = 2000,
    small: Annotated[bool, typer.Option(help="Small networks and fast settings instead of the paper's.")] = True,
    seeds: Annotated[str, typer.Option(help="Comma-separated; every model has one run per seed.")] = "0",
    mirror: Annotated[bool, typer.Option(help="Add mirror images, as the paper does.")] = True,
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 100,
    epochs: Annotated[int, typer.Option(min=1, help="Training epochs of the classifiers.")] = 5,
) -> None:
    """The losses of Park et al. 2021 (Table 1), and their stylizer compared with two methods (Table 2).

    Trains and evaluates all models; stores and prints the results.
    """
    if context.invoked_subcommand is not None:
        return
    chosen = [None if names is None else names.split(",") for names in (styles, gaits)]
    motions = build(datasets.load(data, root, *chosen), mirror=mirror)
    domains, contents = (", ".join(names) for names in (motions.domains, motions.contents))
    described = f"{data} {len(motions):,} windows of {domains} in {contents}"
    print(described)
    try:
        numbers = [int(seed) for seed in seeds.split(",")]
    except ValueError as error:
        raise ValueError(f"--seeds must be comma-separated whole numbers, got {seeds!r}") from error
    show(compare(motions, Plan(described, iterations, small, sources, epochs), numbers, out, progress=True))
    print(f"wrote {out / 'comparison.json'}")


def compare(motions: Motions, plan: Plan, seeds: Sequence[int], folder: Path, progress: bool = False) -> dict:
    """Train and evaluate every model with every seed; finished runs in the folder are not repeated.

    Returns
    -------
    dict
        The content of ``comparison.json``: ``settings``, ``machine``, ``judges`` (accuracy of the classifiers on the
        generators' takes), ``unchanged`` (measures of unchanged sources with every other domain as target) and ``real``
        (measures of all test windows with their own domain), and for ``noise`` and ``reference`` the runs of each model, a
        row of measures per seed.

    Raises
    ------
    ValueError
        If the folder holds a comparison with other settings, or a style or content has too few takes for the split.
    """
    _settle(folder, plan)
    others, own = split(motions, JUDGES, 0)
    train, test = split(others, TEST, 1)
    for label in ("domain", "content"):
        names, parts = getattr(motions, f"{label}s"), [getattr(part, label) for part in (own, train, test)]
        if lacks := [name for k, name in enumerate(names) if not all((part == k).any() for part in parts)]:
            raise ValueError(f"{label} {', '.join(lacks)}: too few takes to split between classifiers, training and test")
    order = torch.randperm(len(test), generator=generator(0))
    sources = test.select(order[: plan.sources].sort().values)
    judges = _judges(own, train, plan, folder, progress)
    rows, target = pairs(sources)
    table = {
        "settings": {**asdict(plan), "seeds": list(seeds), "windows": {"judges": len(own), "training": len(train),
                     "test": len(test), "sources": len(sources)}}, "machine": machine("cpu"),
        "judges": {"content": accuracy(judges.content, others.x, others.content),
                   "style": accuracy(judges.style, others.x, others.domain)},
        "unchanged": judges.judge(sources.x[rows], sources.content[rows], target),
        "real": judges.judge(test.x, test.content, test.domain),
        "noise": {name: [] for name in ABLATION}, "reference": {name: [] for name in (*ABLATION, *BASELINES)},
    }
    for seed in seeds:
        for name in (*ABLATION, *BASELINES):
            path = folder / "measures" / f"{_slug(name)}-{seed}.json"
            if not path.exists():
                began = time.perf_counter()
                model = trained(name, train, plan, seed, folder, progress)
                seconds = time.perf_counter() - began
                ways = ("noise", "reference") if name in ABLATION else ("reference",)
                found = {by: evaluate(model, sources, test, judges, by=by, seed=seed) for by in ways}
                write_json(path, {by: {"seed": seed, "training_seconds": seconds, **row} for by, row in found.items()})
            for by, row in json.loads(path.read_text(encoding="utf-8")).items():
                table[by][name].append(row)
    write_json(folder / "comparison.json", table)
    return table


def trained(name: str, motions: Motions, plan: Plan, seed: int, folder: Path, progress: bool = False) -> torch.nn.Module:
    """One of the models: a stylizer is read from the folder or trained from its checkpoint; a baseline is trained."""
    if name in BASELINES:
        return BASELINES[name](motions, plan.config(LOSSES, seed), progress)
    path = folder / "runs" / f"{_slug(name)}-{seed}.safetensors"
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        checkpoint = path.with_suffix(".checkpoint")
        training.fit(motions, plan.config(ABLATION[name], seed), checkpoint, progress=progress).save(path)
        checkpoint.unlink(missing_ok=True)
    return Stylizer.load(path)


def _settle(folder: Path, plan: Plan) -> None:
    path, own = folder / "settings.json", asdict(plan)
    if path.exists():
        if why := model_files.difference(json.loads(path.read_text(encoding="utf-8")), own):
            raise ValueError(f"{folder}: holds a comparison with other settings ({why}); choose another --out")
    else:
        write_json(path, own)


def _judges(own: Motions, real: Motions, plan: Plan, folder: Path, progress: bool) -> Judges:
    made = {}
    for label in ("content", "domain"):
        path = folder / f"{label}.safetensors"
        if not path.exists():
            classifier.fit(own, label, epochs=plan.epochs, progress=progress).save(path)
        made[label] = Classifier.load(path, own.graph)
    return Judges(made["content"], made["domain"], classifier.features(made["content"], real.x))


def _slug(name: str) -> str:
    return name.lower().replace(" ", "-").replace("+", "-")


def show(table: dict) -> None:
    """Print the result of `compare`."""
    settings, on = table["settings"], table["machine"]
    print(f"\n{settings['iterations']:,} iterations, {'small' if settings['small'] else 'the paper’s'} networks")
    print("seeds " + ", ".join(map(str, settings["seeds"])) + "; windows: "
          + ", ".join(f"{k} {n:,}" for k, n in settings["windows"].items()))
    print(f"{on['device']}, {on['cores']} cores, {on['threads']} threads, torch {on['torch']}")
    print("classifiers on the generators' takes: " + ", ".join(f"{k} {100 * v:.1f} %" for k, v in table["judges"].items()))
    for by, title in (("noise", "Table 1: codes from noise"), ("reference", "Table 2: codes from references")):
        print(f"\n{title:<30}{'paper FMD':>11}{'content %':>11}" + "".join(f"{t:>14}" for t, *_ in MEASURES.values()))
        for name in ("real", "unchanged"):
            cells = "".join(f"{_cell([table[name]], key):>14}" for key in ("fmd", "content", "style"))
            print(f"{name + ' motion':<30}{'':>22}{cells}")
        for name, runs in table[by].items():
            printed = PAPER[by].get(name, ())
            print(f"{name:<30}" + "".join(f"{v:>11.2f}" for v in printed).rjust(22)
                  + "".join(f"{_cell(runs, key):>14}" for key in MEASURES))
    print("", *EXPLAINED, sep="\n")


def _cell(runs: list[dict], key: str) -> str:
    _, scale, decimals = MEASURES[key]
    values = [scale * row[key] for row in runs]
    spread = f" ± {statistics.stdev(values):.{decimals}f}" if len(values) > 1 else ""
    return f"{statistics.mean(values):.{decimals}f}{spread}"


def restyled(model: Stylizer, source: Clip, references: dict[str, Clip], seeds: Sequence[int]) -> dict[str, Clip]:
    """A clip and its restyled versions by label: for each domain with some noises and with its reference."""
    rows = {f"{source.style}: source": source}
    for domain, reference in references.items():
        rows |= {f"{domain}, noise {seed}": stylize(model, source, domain, seed) for seed in seeds}
        rows[f"{domain}, reference"] = stylize(model, source, domain, reference=reference)
    return rows


@app.command()
def strip(
    model: Annotated[Path, typer.Option(help="File of train-stylizer.")],
    domains: Annotated[str, typer.Option(help="Comma-separated target styles.")],
    source: Annotated[str, typer.Option(help="Style of the source.")],
    content: Annotated[str, typer.Option(help="Content of source and references, the first clip of each style.")],
    out: Annotated[Path, typer.Option(help="The picture to write (PNG).")],
    data: Annotated[str, typer.Option(help=f"Dataset: {', '.join(datasets.DATASETS)}.")] = "bandai",
    root: Annotated[Path | None, typer.Option(help="Folder that holds the dataset.")] = None,
    start: Annotated[float, typer.Option(help="First second of the source to show.")] = 0.0,
    seconds: Annotated[float, typer.Option(help="Seconds to show.")] = 2.0,
) -> None:
    """Draw the source and, for each domain, its results with three noises and a reference (Figure 1)."""
    from toolkit import view

    names = domains.split(",")
    clips = {clip.style: clip for clip in reversed(datasets.load(data, root, [source, *names], content))}
    rows = restyled(Stylizer.load(model), clips[source], {name: clips[name] for name in names}, (1, 2, 3))
    view.strip(list(rows.values()), out, labels=list(rows), start=start, stop=start + seconds)
    print(f"wrote {out}")
