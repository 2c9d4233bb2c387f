"""What content is missing, the posture of references, leads: ``python -m experiments stylization content`` and others."""

import itertools
import json
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.seven_models.models import machine, write_json
from experiments.stylization import comparison, evaluation, leads, lost_content, posture, sets
from experiments.stylization.comparison import app
from experiments.stylization.floors import FLOORS
from experiments.stylization.mirror import Symmetric
from experiments.tables import Result

TITLES: dict[str, list] = {
    "method": ["method"], "codes": ["style code from"], "content": ["content, %", 0, 100],
    "gait": ["walk or run, %", 0, 100],
}
FURTHER: dict[str, list] = {
    "movement_of_recorded": ["content, movement recorded, %", 0, 100],
    "pose_of_recorded": ["content, pose recorded, %", 0, 100],
    **{key: comparison.COLUMNS[key] for key in lost_content.KEPT},
}
SHOWN = ("fmd", "domain_fmd", "content", "style", "both", "movement", "diversity", "contact_f1", "acceleration")
OF_NOISE = ("fmd", "content", "both", "movement", "diversity")


@app.command()
def content(
    models: Annotated[list[Path], typer.Argument(help="Files of runs.")],
    data: Annotated[str, typer.Option(help=f"One of {', '.join(sets.SETS)}: what they were trained on.")] = "dataset-2",
    part: Annotated[str, typer.Option(help=f"What is judged: {', '.join(sets.PARTS)}.")] = "validation",
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 64,
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """Which contents are recognised in the results of runs, also averaged with their mirror images, and of floors.

    Runs with the same budget are seeds of one method.
    """
    torch.set_num_threads(1)
    task, plan = sets.load(data), comparison.Plan(0, sources, part)
    runs = comparison.runs_of(models, task)
    judges, some = comparison.judges_of(task, part), comparison.sources_of(task, plan)
    rows, target = evaluation.pairs(some)
    chosen = some.select(rows)
    recorded = lost_content.of_style_and_content(task.train, chosen, target)
    floors = {name: make(task.train)(chosen, target) for name, make in FLOORS.items()}
    if recorded is not None:
        floors["nearest real clip of style and content"] = recorded
    lines = [{"method": name, **lost_content.line(judges, [made], chosen, target, recorded)}
             for name, made in floors.items()]
    kinds = {"ours": lambda model: model, "ours, mean with the mirror image": Symmetric}
    for seconds in dict.fromkeys(run.config.seconds for run in runs):
        own = [run for run in runs if run.config.seconds == seconds]
        for (name, kind), by in itertools.product(kinds.items(), evaluation.WAYS[:2]):
            made = [evaluation.results(kind(run.stylizer), some, task.references[part], by, run.config.seed) for run in own]
            found = [lost_content.line(judges, one, chosen, target, recorded) for one in made]
            lines.append({"method": f"{name}, {seconds:g} seconds", "codes": by,
                          **{key: [one[key] for one in found] for key in found[0]}})
    columns = TITLES | {name: [f"{name}, %", 0, 100] for name in some.contents} | FURTHER
    columns = {key: title for key, title in columns.items() if any(key in one for one in lines)}
    about = f"Bandai-Namco {data}, {part} windows; mean ± deviation over the seeds"
    result = Result(f"stylisation-content-{data}-{part}", about,
                    f"python -m experiments stylization content FILE … --data {data} --part {part} --store", columns, lines,
                    {"restyled sources": len(some), "runs": len(runs), **machine("cpu")})
    print(f"{result.about}\n\n{result.markdown()}" + (f"wrote {result.save()}" if store else ""))


@app.command("posture")
def show_posture(
    models: Annotated[list[Path], typer.Argument(help="Files of runs; those with the same budget are seeds of one method.")],
    data: Annotated[str, typer.Option(help=f"One of {', '.join(sets.SETS)}: what they were trained on.")] = "dataset-1",
    part: Annotated[str, typer.Option(help=f"What is judged: {', '.join(sets.PARTS)}.")] = "validation",
    shares: Annotated[str, typer.Option(help="Comma-separated: hundredths of the reference's posture.")] = "0,25,50,75",
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 64,
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """What a share of the reference's posture, added to results, gives and costs; floor: the mean-pose shift."""
    torch.set_num_threads(1)
    percents, task, plan = comparison.numbers_in(shares, "--shares"), sets.load(data), comparison.Plan(0, sources, part)
    runs = comparison.runs_of(models, task)
    judges, some, references = comparison.judges_of(task, part), comparison.sources_of(task, plan), task.references[part]
    held = judges.judge(task.sources[part].x, task.sources[part].content, task.sources[part].domain)
    lines = [{"method": "real motion", **held, "diversity": evaluation.own_diversity(task.train)}]
    for by, share in itertools.product(evaluation.WAYS[1:], [percent / 100 for percent in percents]):
        lines.append({"method": "mean-pose shift", "codes": by, "share": share,
                      **posture.shifted(task.train, some, references, judges, by, share, 0)})
        for seconds in dict.fromkeys(run.config.seconds for run in runs):
            found = [posture.line(run.stylizer, some, references, judges, by, share, run.config.seed)
                     for run in runs if run.config.seconds == seconds]
            lines.append({"method": f"ours, {seconds:g} seconds", "codes": by, "share": share,
                          **{key: [one[key] for one in found] for key in found[0]}})
    columns = {"method": ["method"], "codes": ["reference"], "share": ["share of its posture", 2],
               **{key: title for key, title in list(comparison.COLUMNS.items())[2:] if key in lines[1]},
               "follows": ["follows the reference", 2]}
    result = Result(f"stylisation-posture-{data}-{part}", f"Bandai-Namco {data}, {part} windows; mean ± deviation over the "
                    "seeds", f"python -m experiments stylization posture FILE … --data {data} --part {part} --shares "
                    f"{shares} --store", columns, sorted(lines, key=lambda line: (line.get("codes", ""), line["method"])),
                    {"restyled sources": len(some), "runs": len(runs), **machine("cpu")})
    print(f"{result.about}\n\n{result.markdown()}" + (f"wrote {result.save()}" if store else ""))


@app.command("leads")
def show_leads(
    out: Annotated[Path, typer.Option(help="Folder of the measures; finished runs are not repeated.")] = Path("out/leads"),
    data: Annotated[str, typer.Option(help=f"One of {', '.join(sets.SETS)}.")] = "dataset-2",
    seconds: Annotated[float, typer.Option(min=1, help="Processor time of each training.")] = 180.0,
    sources: Annotated[int, typer.Option(min=2, help="Largest number of restyled windows.")] = 64,
    seeds: Annotated[str, typer.Option(help="Comma-separated.")] = "0",
    rows: Annotated[str, typer.Option(help=f"Separated by semicolons: {'; '.join(leads.LEADS)}.")] = "the recipe",
    part: Annotated[str, typer.Option(help=f"What is scored: {', '.join(sets.PARTS)}.")] = "validation",
    store: Annotated[bool, typer.Option(help="Write the table's file in docs/results.")] = False,
) -> None:
    """Train leads that did not become the recipe and score them; shows all that the folder holds."""
    torch.set_num_threads(1)
    task, plan = sets.load(data), comparison.Plan(seconds, sources, part)
    judges, some = comparison.judges_of(task, plan.part), comparison.sources_of(task, plan)
    for name in rows.split(";"):
        if name not in leads.LEADS:
            raise ValueError(f"unknown lead {name!r}; known: {'; '.join(leads.LEADS)}")
        for seed in comparison.numbers_in(seeds):
            run = f"{data}-{seconds:g}-{comparison.slug(name)}-{seed}"
            path = out / f"{run}{'' if part == 'validation' else '-test'}.json"
            if not path.exists():
                lead = leads.LEADS[name]
                numbers, models = leads.fit(lead, task, plan.config(seed, **lead.settings),
                                            out / "runs" / f"{run}.safetensors")
                found = leads.measured(lead, models, some, task.references[part], judges, seed)
                write_json(path, {"data": data, "lead": name, "seconds": seconds, "seed": seed, "part": part,
                                  **numbers, **found})
    lines = []
    for stored in (json.loads(path.read_text(encoding="utf-8")) for path in sorted(out.glob("*.json"))):
        for kind in (kind for kind in leads.KINDS if kind in stored):
            noise, reference = stored[kind]["noise"], stored[kind]["reference"]
            lines.append({**{key: stored[key] for key in ("data", "seconds", "lead", "seed", "iterations")}, "kind": kind,
                          "part": stored.get("part", "validation"), "gap": stored.get("gap"),
                          **{key: reference[key] for key in SHOWN}, **{f"noise_{key}": noise[key] for key in OF_NOISE}})
    titles = comparison.COLUMNS
    columns = {"data": ["data"], "seconds": ["seconds", 0], "lead": ["lead"], "kind": ["result"], "part": ["windows"],
               "seed": ["seed", 0], "iterations": ["iterations", 0], "gap": ["D's logit: trained with − not seen", 1],
               **{key: titles[key] for key in SHOWN},
               **{f"noise_{key}": [f"noise: {titles[key][0]}", *titles[key][1:]] for key in OF_NOISE}}
    result = Result("stylisation-leads", "Leads, style codes from references and from noise",
                    "python -m experiments stylization leads --data DATA --seconds S --rows \"LEAD;LEAD\" --part P --store",
                    columns, lines, {"restyled sources": sources, **machine("cpu")})
    print(result.markdown() + (f"wrote {result.save()}" if store else ""))
