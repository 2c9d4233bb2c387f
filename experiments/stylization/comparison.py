"""Ablation and comparison of Park et al. 2021 (Tables 1 and 2): ``python -m experiments stylization``.

All methods have the same processor time, the same clips and generators of nearly one size (but Holden's). Every run is
resumed from its checkpoint and stored as a small file when it is done, so that the command goes on where it was stopped.
"""

import json
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.seven_models.models import machine, write_json
from experiments.stylization import aberman, codes, convolutional, evaluation, holden, looks, missing, sets, speed
from experiments.stylization.floors import FLOORS
from experiments.stylization.judges import Judges
from experiments.stylization.sets import Task
from experiments.tables import Result
from toolkit.io import model_files
from toolkit.stylization import networks, training
from toolkit.stylization.data import Motions
from toolkit.stylization.losses import LOSSES
from toolkit.stylization.networks import Stylizer
from toolkit.stylization.training import Config

app = typer.Typer(invoke_without_command=True)
app.command()(looks.strip)
app.command()(missing.missing)

OUT = Path("out/stylization")
USUAL = 60.0  # seconds of the comparison
OURS: dict[str, dict] = {  # what differs from the recipe
    "ours": {}, "ours without ds": {"losses": LOSSES[:4]}, "ours without sty and ds": {"losses": LOSSES[:3]},
    "ours with own window": {"other_window": False, "encoder_learns": False, "warm_up": 150},
    "ours with the paper's ds": {"fading": False, "warm_up": 0},
}
METHODS = (*OURS, "1-D convolutions", "Aberman et al. 2020", "Holden et al. 2016")
GRAPH, DENSE = networks.build, convolutional.build
PAPER = {"noise": {"ours": (9.09, 0.7264), "ours without ds": (8.58, 0.7786), "ours without sty and ds": (14.14, 0.5792)},
         "reference": {"ours": (6.82, 0.6086), "Aberman et al. 2020": (15.86, 0.4281),
                       "Holden et al. 2016": (14.10, 0.3799)}}
RECIPE: dict[str, dict] = {
    "the recipe": {}, "content losses of squares": {"squared": True}, "a source's code from its own window":
    {"other_window": False}, "no training as an autoencoder first": {"warm_up": 0},
    "100 iterations as an autoencoder": {"warm_up": 100}, "ds as in the paper": {"fading": False},
    "E learns from noise alone": {"encoder_learns": False}, "R1 in every iteration": {"r1_every": 1},
    "a generator as in Table 3": {"sizes": replace(networks.Sizes.small(), detailed=False)},
}  # what the recipe is without one of its departures
COLUMNS: dict[str, list] = {
    "method": ["method"], "codes": ["style code from"], "fmd": ["FMD", 0], "domain_fmd": ["FMD per style", 0],
    "content": ["content, %", 0, 100], "style": ["style, %", 0, 100], "both": ["both, %", 0, 100],
    "movement": ["style without mean pose, %", 0, 100], "diversity": ["diversity, °", 1], "bone": ["bone error, cm", 1, 100],
    "contact_f1": ["contact F1", 2], "acceleration": ["acceleration", 2], "paper_fmd": ["the paper: FMD", 1],
    "paper_content": ["the paper: content, %", 0, 100],
}


@dataclass(frozen=True)
class Plan:
    """Settings of all runs in a folder: processor time of each training, sources at most, and the part that is scored."""

    seconds: float
    sources: int = 64
    part: str = "test"
    iterations: int = 10**9

    def config(self, seed: int, **changes) -> Config:
        """Training settings of one model."""
        return Config.quick(seed=seed, seconds=self.seconds, iterations=self.iterations, **changes)


@app.callback()
def run(
    context: typer.Context,
    out: Annotated[Path, typer.Option(help="Folder of the runs; finished runs in it are not repeated.")] = OUT,
    data: Annotated[str, typer.Option(help=f"Comma-separated: {', '.join(sets.SETS)}.")] = ",".join(sets.SETS),
    seconds: Annotated[float, typer.Option(min=1, help="Processor time of each training.")] = USUAL,
    seeds: Annotated[str, typer.Option(help="Comma-separated; every method has one run per seed.")] = "0,1,2",
    methods: Annotated[str, typer.Option(help="Comma-separated.")] = ",".join(METHODS),
    part: Annotated[str, typer.Option(help=f"What is scored: {', '.join(sets.PARTS)}.")] = "test",
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 64,
    store: Annotated[bool, typer.Option(help="Write the tables' files in docs/results.")] = False,
) -> None:
    """The losses of Park et al. 2021 (Table 1), and their stylizer compared with two methods (Table 2).

    Trains and measures all methods with every seed on one thread, and prints the tables.
    """
    if context.invoked_subcommand is not None:
        return
    torch.set_num_threads(1)
    chosen, names = _words(data, sets.SETS), _words(methods, METHODS)
    plan, numbers = Plan(seconds, sources, part), numbers_in(seeds)
    _settle(out, plan)
    tasks = {name: sets.load(name) for name in chosen}
    for seed in numbers:
        for name, task in tasks.items():
            for method in names:
                measure(method, task, plan, seed, out, name, progress=True)
    for name, task in tasks.items():
        result = summary(name, task, plan, out)
        print(f"\n{result.about}\n\n{result.markdown()}")
        if store:
            print(f"wrote {result.save()}")


def measure(method: str, task: Task, plan: Plan, seed: int, folder: Path, name: str, progress: bool = False) -> dict:
    """Measures of one run by the way its codes are made; trained and measured, or read if that was done."""
    path = folder / "measures" / f"{name}-{slug(method)}-{seed}.json"
    if not path.exists():
        model, numbers = trained(method, task.train, plan.config(seed), folder / "runs" / path.stem, progress)
        ways = evaluation.WAYS if isinstance(model, Stylizer) else evaluation.WAYS[1:]
        found = _scored(model, task, plan, seed, ways, judges_of(task, plan.part))
        write_json(path, {"seed": seed, **numbers, "measures": found})
    return json.loads(path.read_text(encoding="utf-8"))


def trained(method: str, motions: Motions, config: Config, path: Path, progress: bool = False) -> tuple:
    """One of the models, and numbers of its training. A stylizer is resumed from its checkpoint."""
    start = time.process_time()
    if method in ("Aberman et al. 2020", "Holden et al. 2016"):
        model = (aberman if method.startswith("Aberman") else holden).fit(motions, config, progress)
        generators = [model.generator] if method.startswith("Aberman") else [model.encoder, model.decoder]
        return model, {"seconds": time.process_time() - start, "parameters": sum(map(_size, generators))}
    path.parent.mkdir(parents=True, exist_ok=True)
    checkpoint, make = path.with_suffix(".checkpoint"), DENSE if method not in OURS else GRAPH
    config = replace(config, **OURS.get(method, {}))
    stored = path.with_suffix(".safetensors")
    if stored.exists():
        run = training.load(stored)
    else:
        run = training.fit(motions, config, checkpoint, progress=progress, networks=make, clock=time.process_time)
        if make is GRAPH:
            run.save(stored)
    checkpoint.unlink(missing_ok=True)
    last = run.history[-1] if run.history else {"step": 0, "elapsed": 0.0}
    return run.stylizer, {"seconds": last["elapsed"], "iterations": last["step"],
                          "parameters": _size(run.stylizer.generator)}


def summary(name: str, task: Task, plan: Plan, folder: Path) -> Result:
    """The table of a dataset from all finished runs in the folder; floors and real motion are measured."""
    judges, sources = judges_of(task, plan.part), sources_of(task, plan)
    rows, target = evaluation.pairs(sources)
    real = task.sources[plan.part]
    held = judges.judge(real.x, real.content, real.domain)
    lines = [{"method": "real motion", **held, "diversity": evaluation.own_diversity(task.train)}]
    for floor, make in FLOORS.items():
        made = make(task.train)(sources.select(rows), target)
        found = evaluation.measures(sources.select(rows), target, [made], judges)
        lines.append({"method": floor, **found, "diversity": None})
    numbers: dict[str, dict] = {}
    for method in METHODS:
        found = [json.loads(path.read_text(encoding="utf-8"))
                 for path in sorted((folder / "measures").glob(f"{name}-{slug(method)}-[0-9]*.json"))]
        if not found:
            continue
        numbers[method] = {key: [run[key] for run in found] for key in found[0] if key != "measures"}
        for by in found[0]["measures"]:
            values = {key: [run["measures"][by][key] for run in found] for key in found[0]["measures"][by] if key in COLUMNS}
            printed = dict(zip(("paper_fmd", "paper_content"), PAPER.get(by, {}).get(method, ()), strict=False))
            lines.append({"method": method, "codes": by, **values, **printed})
    fmd = {(line["method"], line.get("codes")): line["fmd"] for line in lines}
    shares = {by: [a / b for a, b in zip(fmd["ours", by], fmd["1-D convolutions", by], strict=False)]
              for by in evaluation.WAYS if ("ours", by) in fmd and ("1-D convolutions", by) in fmd}
    seeds = max((len(found["seed"]) for found in numbers.values()), default=0)
    lines = [{key: value for key, value in line.items() if key in COLUMNS} for line in lines]
    about = (f"Bandai-Namco {name}, {', '.join(real.domains)} in {', '.join(real.contents)}; {plan.seconds:g} seconds of "
             f"one processor thread for each training, {plan.part} windows; mean ± deviation over the seeds")
    settings = {**{k: v for k, v in asdict(plan).items() if k != "iterations"}, "most seeds of a method": seeds,
                "training windows": len(task.train), "scored windows": len(real), "restyled sources": len(sources),
                "styles": len(real.domains), "contents": len(real.contents), **machine("cpu")}
    command = (f"python -m experiments stylization --data {name} --seconds {plan.seconds:g} --methods "
               f"\"{','.join(numbers)}\" --store")
    longer = "" if plan.seconds == USUAL else f"-{plan.seconds:g}-seconds"
    return Result(f"stylisation-{name}{longer}", about, command, COLUMNS, lines, settings,
                  {"runs": numbers, "FMD of ours as a share of that of 1-D convolutions, by seed": shares})


@app.command()
def recipe(
    out: Annotated[Path, typer.Option(help="Folder of the runs; finished runs are not repeated.")] = Path("out/recipe"),
    data: Annotated[str, typer.Option(help=f"One of {', '.join(sets.SETS)}.")] = "dataset-2",
    seconds: Annotated[float, typer.Option(min=1, help="Processor time of each training.")] = USUAL,
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 64,
    seeds: Annotated[str, typer.Option(help="Comma-separated.")] = "0",
    rows: Annotated[str, typer.Option(help=f"Comma-separated: {', '.join(RECIPE)}.")] = ",".join(RECIPE),
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """What each departure of the recipe from the paper is worth: without each in turn, on the validation windows."""
    torch.set_num_threads(1)
    plan, lines, numbers = Plan(seconds, sources, "validation"), [], numbers_in(seeds)
    columns = dict(list(COLUMNS.items())[:11])
    _settle(out, plan)
    task = sets.load(data)
    judges = judges_of(task, plan.part)
    for name in _words(rows, RECIPE):
        found = []
        for seed in numbers:
            path = out / "measures" / f"{data}-{slug(name)}-{seed}.json"
            if not path.exists():
                checkpoint = out / f"{path.stem}.checkpoint"
                made = training.fit(task.train, plan.config(seed, **RECIPE[name]), checkpoint, progress=True,
                                    clock=time.process_time)
                write_json(path, {"iterations": made.history[-1]["step"] if made.history else 0} |
                           _scored(made.stylizer, task, plan, seed, evaluation.WAYS, judges))
                checkpoint.unlink(missing_ok=True)
            found.append(json.loads(path.read_text(encoding="utf-8")))
        lines += [{"method": name if name == "the recipe" else f"instead: {name}", "codes": by,
                   "iterations": [one["iterations"] for one in found],
                   **{key: [one[by][key] for one in found] for key in list(columns)[2:]}} for by in evaluation.WAYS]
    columns["iterations"] = ["iterations", 0]
    about = f"Bandai-Namco {data}, {seconds:g} seconds of one processor thread for each training, validation windows"
    result = Result(f"stylisation-recipe-{data}", about, f"python -m experiments stylization recipe --data {data} --sources "
                    f"{sources} --seeds {seeds} --rows \"{rows}\" --store", columns, lines,
                    {"seconds": seconds, "restyled sources": sources, "seeds": len(numbers), **machine("cpu")})
    print(f"{about}\n\n{result.markdown()}" + (f"wrote {result.save()}" if store else ""))


@app.command()
def curve(
    data: Annotated[str, typer.Option(help=f"One of {', '.join(sets.SETS)}.")] = "dataset-2",
    seconds: Annotated[float, typer.Option(min=1, help="Processor time of the training.")] = 600.0,
    points: Annotated[int, typer.Option(min=1, help="Measurements.")] = 8,
    out: Annotated[Path, typer.Option(help="File for the trained run.")] = OUT / "curve.safetensors",
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 64,
    seed: Annotated[int, typer.Option(help="Seed of the run.")] = 0,
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """The measures of the recipe over its training, on the validation windows; the trained run is written, too."""
    torch.set_num_threads(1)
    task, plan, rows, spent = sets.load(data), Plan(seconds, sources, "validation"), [], 0.0
    judges, ways, began = judges_of(task, plan.part), ("noise", "reference"), time.process_time()

    def look(step: int, stylizer: Stylizer, last: bool = False) -> None:
        nonlocal spent
        now = time.process_time()
        if last or now - began - spent >= (len(rows) // len(ways) + 1) * seconds / points:
            found = _scored(stylizer, task, plan, seed, ways, judges)
            rows.extend({"codes": by, "iteration": step, "seconds": now - began - spent, **found[by]} for by in ways)
            spent += time.process_time() - now

    run = training.fit(task.train, plan.config(seed, log_every=10), progress=True, on_step=look,
                       clock=lambda: time.process_time() - spent)
    if len(rows) < points * len(ways):
        look(run.history[-1]["step"] if run.history else 0, run.stylizer, last=True)
    out.parent.mkdir(parents=True, exist_ok=True)
    run.save(out)
    chosen = sources_of(task, plan)
    pairs, target = evaluation.pairs(chosen)
    for floor in ("unchanged source", "mean-pose shift"):
        made = FLOORS[floor](task.train)(chosen.select(pairs), target)
        rows.append({"codes": floor, **evaluation.measures(chosen.select(pairs), target, [made], judges)})
    columns = {"codes": COLUMNS["codes"], "iteration": ["iteration", 0], "seconds": ["seconds", 0],
               **dict(list(COLUMNS.items())[2:9])}
    command = (f"python -m experiments stylization curve --data {data} --seconds {seconds:g} --points {points} "
               f"--sources {sources} --store")
    result = Result(f"stylisation-progress-{data}", f"Bandai-Namco {data}, the recipe, validation windows, one seed; the "
                    "last rows are floors", command, columns, [{k: row[k] for k in columns if k in row} for row in rows],
                    {"seconds": seconds, "seed": seed, "restyled sources": len(chosen), **machine("cpu")})
    print(result.markdown() + (f"wrote {result.save()}" if store else ""))


@app.command("speed")
def show_speed(
    channels: Annotated[str, typer.Option(help="Comma-separated: channels of the first layer.")] = "16,64",
    iterations: Annotated[int, typer.Option(min=4, help="Timed iterations of each run.")] = 8,
    repeats: Annotated[int, typer.Option(min=1, help="Runs of each form; the median counts.")] = 3,
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """Processor time of a training iteration on one thread, with and without what makes it faster."""
    torch.set_num_threads(1)
    widths = numbers_in(channels, "--channels")
    found = [speed.milliseconds(width, iterations, repeats) for width in widths]
    columns = {"form": ["an iteration, each row with what the rows above have"],
               **{f"ms_{width}": [f"{width} channels, ms", 0] for width in widths}}
    rows = [{"form": name, **{f"ms_{width}": times[name] for width, times in zip(widths, found, strict=True)}}
            for name in speed.FORMS]
    result = Result("stylisation-speed", "Processor time of a training iteration of the stylizer on one thread, batch 8, 23 "
                    "joints", "python -m experiments stylization speed --store", columns, rows,
                    {"iterations": iterations, "repeats": repeats, **machine("cpu")})
    print(result.markdown() + (f"wrote {result.save()}" if store else ""))


@app.command("codes")
def show_codes(
    models: Annotated[list[Path], typer.Argument(help="Files of runs; the losses are those of the first one's recipe.")],
    data: Annotated[str, typer.Option(help=f"One of {', '.join(sets.SETS)}: what they were trained on.")] = "dataset-1",
    store: Annotated[bool, typer.Option(help="Write the tables' files in docs/results.")] = False,
) -> None:
    """What the codes of references hold, on validation windows, and which loss makes them alike, on training windows."""
    torch.set_num_threads(1)
    task = sets.load(data)
    runs = runs_of(models, task)
    alike = [run for run in runs if replace(run.config, seed=0) == replace(runs[0].config, seed=0)]
    pulls = [codes.pulls(run, task.train) for run in alike]
    command, settings = f"python -m experiments stylization codes FILE … --data {data} --store", {**machine("cpu")}
    titles = {"recipe": ["a source's own code"], "seed": ["seed", 0], "iterations": ["iterations", 0],
              "between": ["spread between domains", 2], "within": ["within", 3], "noise": ["of noise, within", 2],
              "degrees": ["two references, °", 1], "degrees_wide": ["their codes further apart, °", 1],
              "degrees_noise": ["two noises, °", 1], "follows": ["follows the reference", 2]}
    rows = [{"recipe": f"of {'another' if run.config.other_window else 'its own'} window", "seed": run.config.seed,
             "iterations": run.history[-1]["step"],
             **codes.spreads(run.stylizer, task.sources["validation"], task.references["validation"])} for run in runs]
    spread = Result("stylisation-codes", f"Bandai-Namco {data}, codes of the validation windows", command, titles, rows,
                    settings | {"codes further apart": codes.AS_WIDE})
    pull = Result("stylisation-pulls", f"Bandai-Namco {data}, training windows; mean ± deviation over {codes.BATCHES} "
                  f"batches of {len(alike)} models", command, {"loss": ["loss"], "pull": ["pull, thousandths", 1]},
                  [{"loss": name, "pull": [1000 * value for found in pulls for value in found[name]]} for name in pulls[0]],
                  settings | {"batches": codes.BATCHES, "models": len(alike)})
    for result in (spread, pull):
        print(f"{result.about}\n\n{result.markdown()}" + (f"wrote {result.save()}" if store else ""))


def _scored(stylizer: Stylizer, task: Task, plan: Plan, seed: int, ways: Sequence[str], judges: Judges) -> dict[str, dict]:
    """Measures of a stylizer by each of the ways to make its codes."""
    return {by: evaluation.evaluate(stylizer, sources_of(task, plan), task.references[plan.part], judges, by=by, seed=seed)
            for by in ways}


def judges_of(task: Task, part: str) -> Judges:
    """Judges of a part's windows."""
    return Judges.train(task.judged[part], task.train)


def sources_of(task: Task, plan: Plan) -> Motions:
    """The windows that are restyled."""
    return sets.some(task.sources[plan.part], plan.sources)


def _settle(folder: Path, plan: Plan) -> None:
    path, own = folder / "settings.json", asdict(plan)
    if path.exists():
        if why := model_files.difference(json.loads(path.read_text(encoding="utf-8")), own):
            raise ValueError(f"{folder}: holds a comparison with other settings ({why}); choose another --out")
    else:
        write_json(path, own)


def _size(network: torch.nn.Module) -> int:
    return sum(p.numel() for p in network.parameters())


def slug(name: str) -> str:
    """A name as part of a file name."""
    return "-".join("".join(c if c.isalnum() else " " for c in name.lower()).split())


def _words(text: str, known: Sequence[str]) -> list[str]:
    names = text.split(",")
    if unknown := [name for name in names if name not in known]:
        raise ValueError(f"unknown: {', '.join(unknown)}; known: {', '.join(known)}")
    return names


def runs_of(paths: Sequence[Path], task: Task) -> list[training.Run]:
    """The runs in files; ValueError if one has other styles than the task."""
    runs = [training.load(path) for path in paths]
    for path, run in zip(paths, runs, strict=True):
        if run.stylizer.domains != task.train.domains:
            raise ValueError(f"{path}: was trained on {', '.join(run.stylizer.domains)}; the data have "
                             f"{', '.join(task.train.domains)}")
    return runs


def numbers_in(text: str, option: str = "--seeds") -> list[int]:
    """Whole numbers of an option."""
    try:
        return [int(number) for number in text.split(",")]
    except ValueError as error:
        raise ValueError(f"{option} must be comma-separated whole numbers, got {text!r}") from error
