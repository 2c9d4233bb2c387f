"""Ablation and comparison of Park et al. 2021 (Tables 1, 2): ``python -m experiments stylization``.

All methods have the same processor time, the same clips and generators of nearly one size. Every
run is resumed from its checkpoint, so that the command goes on where it was stopped.
"""

import time
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.seven_models.models import machine, read_json, settle, write_json
from experiments.stylization import aberman, convolutional, evaluation, sets
from experiments.stylization.floors import FLOORS, shift_and_scale
from experiments.stylization.judges import Judges
from experiments.stylization.sets import Task
from experiments.tables import Result, Store
from toolkit.stylization import networks, training
from toolkit.stylization.data import Motions
from toolkit.stylization.losses import LOSSES
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.training import Config

OUT = Path("out/stylization")
USUAL, SCORED = 60.0, "test"  # seconds of the comparison; the part of the data
SEEDS = range(3)  # of the runs of a method
BLEND = ", blend"  # after the name of a method: half of it, half shift and scale
OURS: dict[str, dict] = {  # what differs from `Config.quick`
    "ours": {},
    "ours without ds": {"losses": LOSSES[:4]},
    "ours without sty and ds": {"losses": LOSSES[:3]},
    "ours with the paper's ds": {"fading": False, "warm_up": 0},
}
METHODS = (*OURS, "1-D convolutions", "Aberman et al. 2020")
COLUMNS: dict[str, list] = {
    "method": ["method"],
    "codes": ["style code from"],
    "fmd": ["FMD", 0],
    "content": ["content, %", 0, 100],
    "style": ["style, %", 0, 100],
    "both": ["both, %", 0, 100],
    "movement": ["style without mean pose, %", 0, 100],
    "diversity": ["diversity, °", 1],
}


@dataclass(frozen=True)
class Plan:
    """Settings of all runs in a folder: processor time and iterations of a training, sources."""

    seconds: float
    sources: int = 64
    iterations: int = 10**9

    def config(self, seed: int, **changes) -> Config:
        """Training settings of one model."""
        return Config.quick(seed=seed, seconds=self.seconds, iterations=self.iterations, **changes)


def run(
    out: Annotated[Path, typer.Option(help="Folder of the runs; none is repeated.")] = OUT,
    seconds: Annotated[float, typer.Option(min=1, help="Processor time of a training.")] = USUAL,
    methods: Annotated[str, typer.Option(help="Comma-separated.")] = ",".join(METHODS),
    store: Store = False,
) -> None:
    """The losses of Park et al. 2021 (Table 1), and their stylizer compared with two others.

    Trains and measures all methods with every seed on one thread, and prints the table.
    """
    torch.set_num_threads(1)
    names = methods.split(",")
    if unknown := [name for name in names if name not in METHODS]:
        raise ValueError(f"unknown: {', '.join(unknown)}; known: {', '.join(METHODS)}")
    plan = Plan(seconds)
    settle(out, asdict(plan))
    task = sets.walks_and_runs()
    for seed in SEEDS:
        for method in names:
            measure(method, task, plan, seed, out, progress=True)
    summary(task, plan, out).show(store)


def measure(method: str, task: Task, plan: Plan, seed: int, folder: Path,
            progress: bool = False) -> dict:
    """Measures of one run by the way its codes are made; trained, or read if that was done."""
    path = folder / "measures" / f"{slug(method)}-{seed}.json"
    if not path.exists():
        config = plan.config(seed, **OURS.get(method, {}))
        model, numbers = trained(method, task.train, config, folder / "runs" / path.stem, progress)
        judges, sources = judges_of(task), sources_of(task, plan)
        ways = evaluation.WAYS if isinstance(model, Stylizer) else evaluation.WAYS[1:]
        rows, target = evaluation.pairs(sources)
        chosen, found = sources.select(rows), {}
        shift = shift_and_scale(task.train)(chosen, target)
        for by in ways:
            made = evaluation.results(model, sources, task.references[SCORED], by, seed)
            found[by] = evaluation.measures(chosen, target, made, judges)
            made = [evaluation.blend(motion, shift) for motion in made]
            found[by + BLEND] = evaluation.measures(chosen, target, made, judges)
        write_json(path, {"seed": seed, **numbers, "measures": found})
    return read_json(path)


def trained(method: str, motions: Motions, config: Config, path: Path,
            progress: bool = False) -> tuple:
    """One of the models, and numbers of its training; a stylizer goes on from its checkpoint."""
    start = time.process_time()
    if method == "Aberman et al. 2020":
        model = aberman.fit(motions, config, progress)
        return model, {"seconds": time.process_time() - start, "parameters": _size(model.generator)}
    path.parent.mkdir(parents=True, exist_ok=True)
    make = networks.build if method in OURS else convolutional.build
    run = training.fit(motions, config, path.with_suffix(".checkpoint"), progress=progress,
                       networks=make, clock=time.process_time)
    run.stylizer.save(path.with_suffix(".safetensors"), slim=True)
    last = run.history[-1] if run.history else {"step": 0, "elapsed": 0.0}
    return run.stylizer, {"seconds": last["elapsed"], "iterations": last["step"],
                          "parameters": _size(run.stylizer.generator)}


def summary(task: Task, plan: Plan, folder: Path) -> Result:
    """The table from all finished runs in the folder, with real motion and floors."""
    lines, numbers = list(_floors(task, plan)), {}
    for method in METHODS:
        paths = sorted((folder / "measures").glob(f"{slug(method)}-[0-9]*.json"))
        found = [read_json(path) for path in paths]
        if not found:
            continue
        numbers[method] = {key: [run[key] for run in found] for key in found[0]
                           if key != "measures"}
        for by, measured in found[0]["measures"].items():
            values = {key: [run["measures"][by][key] for run in found] for key in measured}
            blended = BLEND * by.endswith(BLEND)
            lines.append({"method": method + blended, "codes": by.removesuffix(BLEND), **values})
    real = task.sources[SCORED]
    about = (f"Bandai-Namco dataset 2, {', '.join(real.domains)} in {', '.join(real.contents)}; "
             f"{plan.seconds:g} seconds of one processor thread for each training, test windows; "
             "mean ± deviation over the seeds")
    settings = {
        "seconds": plan.seconds,
        "sources": plan.sources,
        "most seeds of a method": max((len(n["seed"]) for n in numbers.values()), default=0),
        "training windows": len(task.train),
        "scored windows": len(real),
        "restyled sources": len(sources_of(task, plan)),
        "styles": len(real.domains),
        "contents": len(real.contents),
        **machine("cpu"),
    }
    command = (f"python -m experiments stylization --seconds {plan.seconds:g} "
               f"--methods \"{','.join(numbers)}\" --store")
    ending = "" if plan.seconds == USUAL else f"-{plan.seconds:g}-seconds"
    return Result(f"stylisation-dataset-2{ending}", about, command, COLUMNS, lines, settings,
                  {"runs": numbers})


def _floors(task: Task, plan: Plan) -> Iterator[dict]:
    """Rows of real motion and of the floors."""
    judges, sources = judges_of(task), sources_of(task, plan)
    rows, target = evaluation.pairs(sources)
    real, chosen = task.sources[SCORED], sources.select(rows)
    held = judges.judge(real.x, real.content, real.domain)
    yield {"method": "real motion", **held, "diversity": evaluation.own_diversity(task.train)}
    kinds = torch.stack((chosen.content, target))
    most = [float(kind.bincount().max()) / len(target) for kind in kinds]
    pair = float(kinds.unique(dim=1, return_counts=True)[1].max()) / len(target)
    yield {"method": "most frequent class", "content": most[0], "style": most[1], "both": pair,
           "movement": most[1]}
    for floor, make in FLOORS.items():
        made = make(task.train)(chosen, target)
        found = evaluation.measures(chosen, target, [made], judges)
        yield {"method": floor, **found, "diversity": None}


def judges_of(task: Task) -> Judges:
    """Judges of the scored windows. The FMD is to their own windows, which no generator saw."""
    judged = task.judged[SCORED]
    return Judges.train(judged, judged["style"])


def sources_of(task: Task, plan: Plan) -> Motions:
    """The windows that are restyled."""
    return sets.some(task.sources[SCORED], plan.sources)


def _size(network: torch.nn.Module) -> int:
    return sum(p.numel() for p in network.parameters())


def slug(name: str) -> str:
    """A name as part of a file name."""
    return "-".join("".join(c if c.isalnum() else " " for c in name.lower()).split())
