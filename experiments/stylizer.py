"""The stylizer of the package on procedural clips that it was not trained on, beside floors.

Judges learn from clips of other seeds. Every window is restyled to every other style of the model.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.stylization import evaluation, floors, sets
from experiments.stylization.judges import Judges, NetworkJudge
from experiments.tables import Result, Store
from toolkit.datasets import procedural
from toolkit.stylization import Motions, Stylizer, build, pretrained

GAITS = ("FW", "BW", "FR", "SW", "ID")  # of its training
SECONDS, JUDGED, LEARNT = 2.3, 6, 12  # of a clip; clips of a kind in a set and for the judges
FIRST, STEP, WINDOWS, SETS = 300, 10, 70, 3  # seeds of the first set, the next; windows; sets
BY_NETWORK = ["by a network, %", 0, 100]
COLUMNS: dict[str, list] = {
    "method": ["method"],
    "content": ["content, %", 0, 100],
    "content2": BY_NETWORK,
    "style": ["style, %", 0, 100],
    "style2": BY_NETWORK,
    "both": ["both, %", 0, 100],
    "both2": BY_NETWORK,
    "movement": ["style without mean pose, %", 0, 100],
    "movement2": BY_NETWORK,
    "fmd": ["FMD", 1],
    "diversity": ["diversity, °", 1],
}


def run(
    model: Annotated[Path | None, typer.Option(help="By default the one in the package.")] = None,
    store: Store = False,
) -> None:
    """The stylizer of the package on clips that it was not trained on, beside floors."""
    torch.set_num_threads(1)
    stylizer = pretrained() if model is None else Stylizer.load(model)
    learnt = clips(stylizer, range(100, 100 + LEARNT))
    labels = {"content": learnt, "style": learnt}
    judges = Judges.train(labels, learnt), Judges.train(labels, learnt, NetworkJudge)
    found: dict[str, dict[str, list[float]]] = {}
    for seed in range(SETS):
        first = FIRST + STEP * seed
        for method, row in rows(stylizer, judges, clips(stylizer, range(first, first + JUDGED))):
            for name, value in row.items():
                if name in COLUMNS:
                    found.setdefault(method, {}).setdefault(name, []).append(value)
    about = (f"The stylizer of the package, {len(stylizer.domains)} styles and {len(GAITS)} gaits "
             f"of procedural clips; mean ± deviation over {SETS} sets of clips")
    result = Result("stylizer", about, "python -m experiments stylizer --store", COLUMNS,
                    [{"method": method, **values} for method, values in found.items()],
                    {"windows of a set": WINDOWS, "clips for the judges": len(learnt)})
    result.show(store)


def clips(stylizer: Stylizer, seeds: range) -> Motions:
    """Windows of clips of these seeds, with the model's styles."""
    options = {"styles": list(stylizer.domains), "gaits": GAITS, "seconds": SECONDS}
    return build([clip for seed in seeds for clip in procedural.load(seed=seed, **options)])


def rows(stylizer: Stylizer, judges: tuple[Judges, Judges],
         motions: Motions) -> Iterator[tuple[str, dict]]:
    """Measures of real motion, of floors and of the stylizer, by what they are of."""
    first, second = judges

    def judged(x: torch.Tensor, content: torch.Tensor, domain: torch.Tensor) -> dict:
        said = second.right(x, content, domain).items()
        return first.judge(x, content, domain) | {
            f"{name}2": float(right.float().mean()) for name, right in said}

    some = sets.some(motions, WINDOWS)
    real = judged(some.x, some.content, some.domain)
    yield "real motion", real | {"diversity": evaluation.own_diversity(motions)}
    chosen, target = evaluation.pairs(some)
    sources = some.select(chosen)
    most = float(sources.content.bincount().max()) / len(target)
    style = float(target.bincount().max()) / len(target)
    yield "most frequent class", {"content": most, "style": style, "movement": style,
                                "content2": most, "style2": style, "movement2": style}
    shift, poses = (floors.shift_of(known)(sources, target)
                    for known in (stylizer, floors.without_amplitudes(stylizer)))
    made = {"unchanged source": [sources.x], "mean-pose shift": [poses], "shift and scale": [shift]}
    for by in ("noise", "reference"):
        raw, network = (evaluation.results(stylizer, some, motions, by, 0, smooth)
                        for smooth in (False, True))
        made[f"blend, {by}"] = [evaluation.blend(x, shift) for x in network]
        made[f"the network, {by}"] = network
        made[f"the network, not smoothed, {by}"] = raw
    for method, motion in made.items():
        twice = sources.content.repeat(len(motion)), target.repeat(len(motion))
        yield method, judged(torch.cat(motion), *twice)
        if len(motion) > 1:
            yield method, {"diversity": float(evaluation.angles(*motion).mean())}
