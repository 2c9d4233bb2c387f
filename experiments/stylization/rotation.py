"""Every style of dataset 1 as a target, with a fixed recipe, two kinds of judges and intervals."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import Tensor

from experiments.seven_models.models import machine
from experiments.stylization import comparison, evaluation, sets
from experiments.stylization.floors import FLOORS
from experiments.stylization.judges import Judge, Judges, NetworkJudge
from experiments.tables import Result, Store
from toolkit.features.splits import generator
from toolkit.stylization import Stylizer

#: The twelve styles, in the three groups whose real clips the regression tells apart best.
GROUPS = (("active", "angry", "musical", "tired"),
          ("childish", "feminine", "normal", "not-confident"),
          ("happy", "masculinity", "old", "proud"))
KINDS = (Judge, NetworkJudge)
METHODS = ("ours", "1-D convolutions", "1-D convolutions, as many iterations")
WINDOWS = 48  # of a part, at most, that are restyled
DRAWS = 1000  # of the bootstrap
SHARES = ("content", "style", "both", "movement")
COLUMNS: dict[str, list] = {
    "method": ["method"],
    "codes": ["style code from"],
    "content": ["content, %"],
    "style": ["style, %"],
    "both": ["both, %"],
    "movement": ["style without mean pose, %"],
    "agree": ["judges agree, %", 0, 100],
    "diversity": ["diversity, °", 1],
}
Found = dict[tuple[str, str], list[dict[str, Tensor]]]


def run(
    out: Annotated[Path, typer.Option(help="Folder of the runs; none is repeated.")] = (
        comparison.OUT / "rotation"),
    seconds: Annotated[float, typer.Option(min=1, help="Processor time of a training.")] = 180,
    seeds: Annotated[str, typer.Option(help="Comma-separated; a run of each.")] = "0",
    store: Store = False,
) -> None:
    """Restyle to each of twelve styles with a recipe that was chosen on five of them."""
    torch.set_num_threads(1)
    motions, found, iterations = sets.dissimilar(), defaultdict(list), defaultdict(list)
    for number, styles in enumerate(GROUPS, 1):
        task = sets.few_takes(motions, styles, sets.CONTENTS)
        models = {}
        for seed in comparison.numbers_in(seeds):
            for method in METHODS:
                plan = comparison.Plan(seconds)
                if method == METHODS[2]:  # as many as ours had
                    plan = comparison.Plan(1e6, iterations=iterations["ours"][-1])
                path = out / "runs" / f"{number}-{comparison.slug(method)}-{seed}"
                models[method, seed], about = comparison.trained(
                    method.split(",")[0], task.train, plan.config(seed, warm_up=300), path, True)
                iterations[method].append(about["iterations"])
        for part in sets.FIFTHS:
            judges = [Judges.train(task.judged[part], task.train, kind) for kind in KINDS]
            real = task.sources[part]
            found["real motion", ""].append(judged(real, real.domain, [real.x], judges))
            if part in sets.PARTS:  # no generator learnt from it
                some = sets.some(real, WINDOWS)
                for name, made in restyled(task.train, some, task.references[part], models):
                    rows, target = evaluation.pairs(some)
                    found[name].append(judged(some.select(rows), target, made, judges))
    result = summary(found, iterations, seconds)
    print(f"\n{result.about}\n\n{result.markdown()}\n\n{result.numbers}")
    if store:
        print(f"wrote {result.save()}")


def restyled(train: sets.Motions, sources: sets.Motions, references: sets.Motions,
             models: Mapping[tuple[str, int], Stylizer]) -> Iterator[tuple]:
    """Results of floors and models for `evaluation.pairs`, by method and where codes come from."""
    rows, target = evaluation.pairs(sources)
    for floor, make in FLOORS.items():
        yield (floor, ""), [make(train)(sources.select(rows), target)]
    for (method, seed), model in models.items():
        for by in evaluation.WAYS:
            yield (method, by), evaluation.results(model, sources, references, by, seed)


def judged(sources: sets.Motions, target: Tensor, made: Sequence[Tensor],
           judges: Sequence[Judges]) -> dict[str, Tensor]:
    """What the judges say of results ``[P, 7, T, N]``, one or two for each source and target.

    ``right [2, 4, R]`` by judge and `SHARES`; of each result the ``take`` of its source, whether
    the judges ``agree`` on the style, whether no choice was made on the target style (``new``), and
    the ``angle`` to the other result.
    """
    count = len(made)
    content, domain = sources.content.repeat(count), target.repeat(count)
    x = torch.cat(list(made))
    right = [judge.right(x, content, domain) for judge in judges]
    names = [judge.style.named(x) for judge in judges]
    new = torch.tensor([name not in sets.STYLES for name in sources.domains])
    angle = evaluation.angles(*made) if count > 1 else torch.full((len(target),), torch.nan)
    return {"right": torch.stack([torch.stack([r[share] for share in SHARES]) for r in right]),
            "take": sources.take.repeat(count), "agree": names[0] == names[1],
            "new": new[domain], "angle": angle.repeat(count)}


def summary(found: Found, iterations: Mapping[str, list[int]], seconds: float) -> Result:
    """The table: shares by each judge, with the interval of each judge's "both" and movement."""
    lines, numbers = [], {"iterations": dict(iterations), "both on styles of no choice": {}}
    whole = {name: {key: torch.cat([part[key] for part in parts], -1) for key in parts[0]}
             for name, parts in found.items()}
    shift = whole["mean-pose shift", ""]
    for (method, codes), of in whole.items():
        ends = interval(of)
        cells = {}
        for k, share in enumerate(SHARES):
            cells[share] = " / ".join(
                f"{100 * float(of['right'][j, k].float().mean()):.0f}"
                + (f" ({100 * ends[0, j, k]:.0f} to {100 * ends[1, j, k]:.0f})" if k > 1 else "")
                for j in range(len(KINDS)))
        lines.append({"method": method, "codes": codes, **cells,
                      "agree": float(of["agree"].float().mean()),
                      "diversity": float(of["angle"].mean())})
        gain = interval(of, shift) if method != "real motion" else None
        numbers["both on styles of no choice"][f"{method} {codes}".strip()] = [
            float(of["right"][j, 2, of["new"]].float().mean()) for j in range(len(KINDS))]
        if gain is not None:
            numbers[f"{method} {codes}".strip() + ", both above the mean-pose shift"] = (
                gain[:, :, 2].tolist())
    about = (f"Bandai-Namco dataset 1, every one of twelve styles as a target; {seconds:g} seconds "
             f"of one processor thread for a training; regression / network as judges, with 95 % "
             f"intervals of a bootstrap over {len(shift['take'].unique())} takes")
    settings = {"seconds": seconds, "groups": GROUPS, "restyled": len(shift["take"]),
                **machine("cpu")}
    return Result("stylisation-rotation", about, "python -m experiments stylization-rotation "
                  "--store", COLUMNS, lines, settings, numbers)


def interval(of: Mapping[str, Tensor], less: Mapping[str, Tensor] | None = None) -> Tensor:
    """95 % intervals ``[2, 2, 4]`` of the shares, or of their gain over those of other results.

    Takes of sources are drawn with replacement, the same of both.
    """
    takes = of["take"].unique()
    draw = torch.randint(len(takes), (DRAWS, len(takes)), generator=generator(0))
    times = torch.nn.functional.one_hot(draw, len(takes)).sum(1).double()  # [draws, takes]
    shares = 0.0
    for sign, results in ((1, of), (-1, less)):
        if results is not None:
            own = (results["take"] == takes[:, None]).double()  # [takes, R]
            right = results["right"].double() @ own.T  # [2, 4, takes]
            shares = shares + sign * (right @ times.T) / (times @ own.sum(1))
    return shares.quantile(torch.tensor([0.025, 0.975], dtype=torch.double), dim=-1)
