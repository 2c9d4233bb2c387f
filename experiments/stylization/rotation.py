"""Every style of dataset 1 as a target, with a fixed recipe, two kinds of judges and intervals."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

import torch
from torch import Tensor

from experiments.seven_models.models import machine
from experiments.stylization import comparison, evaluation, sets
from experiments.stylization.floors import FLOORS
from experiments.stylization.judges import Judge, Judges, NetworkJudge
from experiments.tables import Result, Store
from toolkit.features.splits import generator
from toolkit.stylization import Motions, Stylizer
from toolkit.stylization.training import Config

#: The twelve styles, in the three groups whose real clips the regression tells apart best.
GROUPS = (("active", "angry", "musical", "tired"),
          ("childish", "feminine", "normal", "not-confident"),
          ("happy", "masculinity", "old", "proud"))
KINDS = {"regression": Judge, "network": NetworkJudge}
METHODS = ("ours", "1-D convolutions")
ITERATIONS, SEEDS = 2000, [0, 1, 2]  # of the trainings
WINDOWS = 48  # of a part, at most, that are restyled
DRAWS = 1000  # of the bootstrap
SHARES = ("content", "style", "both", "movement")
COLUMNS: dict[str, list] = {
    "method": ["method"],
    "codes": ["style code from"],
    "content": ["content, %"],
    "style": ["style, %"],
    "both": ["both, %"],
    "seeds": ["both of each seed, %"],
    "movement": ["style without mean pose, %"],
    "agree": ["judges agree, %", 0, 100],
    "diversity": ["diversity, °", 1],
}
Found = dict[tuple[str, str], list[dict[str, Tensor]]]
Models = dict[tuple[str, int], Stylizer]  # by method and seed


def run(store: Store = False) -> None:
    """Restyle to each of twelve styles with a recipe that was chosen on five of them.

    No finished training is repeated.
    """
    torch.set_num_threads(1)
    motions, trainings = sets.dissimilar(), []
    tasks = [sets.few_takes(motions, styles, sets.CONTENTS) for styles in GROUPS]
    models: list[Models] = [{} for _ in tasks]
    for seed in SEEDS:
        for group, task in enumerate(tasks):
            for method in METHODS:
                path = comparison.OUT / "rotation" / f"{group + 1}-{comparison.slug(method)}-{seed}"
                config = Config.quick(seed=seed, iterations=ITERATIONS)
                model, about = comparison.trained(method, task.train, config, path, True)
                models[group][method, seed] = model
                trainings.append({"group": group + 1, "method": method, "seed": seed, **about})
    found = defaultdict(list)
    for task, some in zip(tasks, models, strict=True):
        for name, part in scored(task, some):
            found[name].append(part)
    result = summary(found, trainings)
    result.show(store)


def scored(task: sets.Task, models: Models) -> Iterator[tuple[tuple[str, str], dict[str, Tensor]]]:
    """`judged` of real windows, of floors and of models, by method and where codes come from.

    Real windows are those of all takes, each judged by judges that did not learn from it. Windows
    are restyled that no generator learnt from.
    """
    for part in sets.FIFTHS:
        judges = [Judges.train(task.judged[part], task.train, kind) for kind in KINDS.values()]
        real = task.sources[part]
        yield ("real motion", ""), judged(real, real.domain, [real.x], judges)
        if part in sets.PARTS:
            some = sets.some(real, WINDOWS)
            rows, target = evaluation.pairs(some)
            sources = some.select(rows)
            floors = {name: make(task.train)(sources, target) for name, make in FLOORS.items()}
            for name, made in floors.items():
                said = judged(sources, target, [made], judges)
                yield (name, ""), said
            yield ("most frequent class", ""), said | {
                "right": guessed(sources, target), "agree": torch.ones_like(said["agree"])}
            for (method, seed), model in models.items():
                for by in evaluation.WAYS:
                    made = evaluation.results(model, some, task.references[part], by, seed)
                    yield (method, by), judged(sources, target, made, judges, seed)
                    made = [evaluation.blend(x, floors["shift and scale"]) for x in made]
                    blended = judged(sources, target, made, judges, seed)
                    yield (method + comparison.BLEND, by), blended


def guessed(sources: Motions, target: Tensor) -> Tensor:
    """``right`` of `judged` where every result is called the most frequent content and style."""
    content = sources.content == sources.content.mode().values
    style = target == target.mode().values
    return torch.stack((content, style, content & style, style)).expand(len(KINDS), -1, -1)


def judged(sources: Motions, target: Tensor, made: Sequence[Tensor],
           judges: Sequence[Judges], seed: int = 0) -> dict[str, Tensor]:
    """What the judges say of results ``[P, 7, T, N]``, one or two for each source and target.

    ``right [2, 4, R]`` by judge and `SHARES`; of each result the ``take`` of its source, whether
    the judges ``agree`` on the style, whether no choice was made on the target style (``new``), the
    ``angle`` to the other result and the ``seed`` of the model.
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
            "new": new[domain], "angle": angle.repeat(count),
            "seed": torch.full((len(x),), seed)}


def summary(found: Found, trainings: list[dict]) -> Result:
    """The table: shares by each judge, "both" and movement with their intervals and by seed."""
    whole = {name: {key: torch.cat([part[key] for part in parts], -1) for key in parts[0]}
             for name, parts in found.items()}
    shift = whole["shift and scale", ""]
    lines, gains, new = [], {}, {}
    for (method, codes), of in whole.items():
        name = f"{method} {codes}".strip()
        shares, ends = of["right"].double().mean(-1), interval(of)
        line = {"method": method, "codes": codes}
        for k, share in enumerate(SHARES):
            texts = [f"{100 * shares[j, k]:.0f}" + (
                f" ({100 * ends[0, j, k]:.0f}–{100 * ends[1, j, k]:.0f})" if k > 1 else "")
                for j in range(len(KINDS))]
            line[share] = " / ".join(texts)
        if (learnt := method.startswith(METHODS)):
            each = [100 * of["right"][:, SHARES.index("both"), of["seed"] == seed].float().mean(-1)
                    for seed in SEEDS]  # [2] by each judge
            line["seeds"] = " / ".join(", ".join(f"{share:.0f}" for share in judge)
                                       for judge in torch.stack(each, 1))
        lines.append(line | {"agree": float(of["agree"].float().mean()),
                             "diversity": float(of["angle"].mean())})
        new[name] = of["right"][:, :, of["new"]].double().mean(-1).tolist()
        if learnt:
            gains[name] = interval(of, shift).tolist()
    about = (f"Bandai-Namco dataset 1, each of twelve styles as a target; {ITERATIONS} iterations "
             f"of each training, {len(SEEDS)} seeds; by the regression / the network, 95 % "
             f"intervals over {len(shift['take'].unique())} takes of sources")
    settings = {"iterations": ITERATIONS, "seeds": SEEDS, "groups": GROUPS,
                "results of a floor": len(shift["take"]),
                "real windows": len(whole["real motion", ""]["take"]), **machine("cpu")}
    numbers = {"trainings": trainings, "order": [list(KINDS), list(SHARES)],
               "styles of no choice": new, "interval of the gain over shift and scale": gains}
    return Result("stylisation-rotation", about,
                  "python -m experiments stylization-rotation --store", COLUMNS, lines, settings,
                  numbers)


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
