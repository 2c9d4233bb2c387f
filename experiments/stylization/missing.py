"""The stylizer without one of its losses, on motion: measures, and a film. ``experiments stylization missing``.

The setting is that of the toy in notebook 08a. Plain walks, runs and side steps are the sources. The target domain mixes two
styles, arms up and arms forward, and nobody tells the networks which clip has which: these are the *versions* of one style.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import Tensor

from experiments.seven_models.models import machine
from experiments.stylization.floors import FLOORS
from experiments.stylization.judges import Judge
from experiments.tables import Result
from toolkit import view
from toolkit.datasets import procedural
from toolkit.features.splits import generator
from toolkit.motion import Clip
from toolkit.stylization import data, training
from toolkit.stylization.data import Motions
from toolkit.stylization.losses import LOSSES
from toolkit.stylization.networks import Sizes, Stylizer
from toolkit.stylization.restyling import stylize

PLAIN, VERSIONS, GAITS = "Neutral", ("ArmsAboveHead", "Zombie"), ("FW", "FR", "SW")
DOMAINS = ("plain", "arms")
LEARNT, JUDGED, TESTED = range(12), range(100, 112), range(200, 206)  # seeds of clips
CONTENT = 2.0  # weight of "cyc" and "id"; the others have 1
SECONDS = 2.2  # of a clip: one window
USUAL = 700  # iterations
MISSING = ("none", *LOSSES)
COLUMNS: dict[str, list] = {
    "method": ["missing loss"], "inside": ["accepted, %", 0, 100], "content": ["gait kept, %", 0, 100],
    "own": ["moved in the own style, cm", 1, 100], "version": ["version of the reference, %", 0, 100],
    "spread": ["two noises apart, cm", 1, 100],
}


def config(missing: str, iterations: int, seed: int) -> training.Config:
    """All losses but one, from the first iteration to the last; networks and steps are small."""
    weights = dict.fromkeys((*LOSSES, "r1"), 1.0) | {"cyc": CONTENT, "id": CONTENT, "r1": 5.0}
    if missing == "adv":
        weights["adv"] = 0.0
    kept = tuple(name for name in LOSSES if name != missing or name == "adv")
    return training.Config.quick(losses=kept, weights=weights, iterations=iterations, seed=seed, batch=4, warm_up=0,
                                 sizes=Sizes(channels=8, hidden=64, detailed=True), other_window=False,
                                 encoder_learns=False, fading=False)


def clips(seeds: Sequence[int]) -> list[Clip]:
    """Plain clips and clips of both versions, in all gaits."""
    return [clip for seed in seeds
            for clip in procedural.load((PLAIN, *VERSIONS), GAITS, seconds=SECONDS, seed=seed)]


def mixed(seeds: Sequence[int]) -> Motions:
    """Windows of `clips` in the two domains."""
    return data.build([clip.replace(style=DOMAINS[clip.style != PLAIN]) for clip in clips(seeds)], mirror=True)


@dataclass(frozen=True, eq=False)
class Referee:
    """Judges of the gait and of the style, with the windows that they have not seen."""

    gait: Judge
    style: Judge
    plain: Motions
    versions: Motions

    @classmethod
    def train(cls) -> "Referee":
        """Judges from clips of their own."""
        own, test = (data.build(clips(seeds), (PLAIN, *VERSIONS), mirror=True) for seeds in (JUDGED, TESTED))
        return cls(Judge.train(own, "content"), Judge.train(own, "domain"), test.select(test.domain == 0),
                   test.select(test.domain > 0))

    def measures(self, first: Tensor, second: Tensor, copied: Tensor, wanted: Tensor, own: tuple[Tensor, Tensor]) -> dict:
        """`COLUMNS` of results with two noises, with references of the ``wanted`` versions, and in the own style."""
        both, gaits = torch.cat((first, second)), self.plain.content.repeat(2)
        return {"inside": 1 - float(self.style.right(both, torch.zeros(len(both))).float().mean()),
                "content": float(self.gait.right(both, gaits).float().mean()), "own": apart(*own),
                "version": float(self.style.right(copied, wanted).float().mean()), "spread": apart(first, second)}

    @torch.no_grad()
    def score(self, model: Stylizer) -> dict[str, float]:
        """`measures` of a stylizer."""
        draw, x = generator(0, "missing"), self.plain.x
        noise = torch.randn(2, len(x), model.sizes.latent, generator=draw)
        first, second = (model.translate(x, model.code_from(z, DOMAINS[1])) for z in noise)
        chosen = torch.randint(len(self.versions), (len(x),), generator=draw)
        copied = model.translate(x, model.code_of(self.versions.x[chosen], DOMAINS[1]))
        real = torch.cat((x, self.versions.x))
        domain = torch.tensor([0] * len(x) + [1] * len(self.versions))
        return self.measures(first, second, copied, self.versions.domain[chosen],
                             (real, model.translate(real, model.code_of(real, domain))))

    def floors(self, train: Motions) -> dict[str, dict[str, float]]:
        """`measures` of what needs no network: the source, and the source shifted by the mean poses of the domains."""
        x, wanted = self.plain.x, torch.ones(len(self.plain), dtype=torch.long)
        wanted[1::2] = 2
        shifted = FLOORS["mean-pose shift"](train)(_as(self.plain, train), torch.ones_like(wanted))
        return {name: self.measures(made, made, made, wanted, (x, x))
                for name, made in (("unchanged source", x), ("mean-pose shift", shifted))}


def _as(motions: Motions, train: Motions) -> Motions:
    """Plain windows, with the domains of the training."""
    return Motions(train.graph, motions.x, motions.root_velocity, torch.zeros_like(motions.domain), motions.content,
                   motions.take, train.domains, motions.contents)


def apart(a: Tensor, b: Tensor) -> float:
    """Mean distance of joints of motions ``[P, 7, T, N]``, metres."""
    return float((a - b)[:, :3].norm(dim=1).mean())


def trained(missing: str, train: Motions, iterations: int, seed: int, folder: Path) -> training.Run:
    """A stylizer without a loss: from its file, if it was trained before."""
    path = folder / f"{missing}-{iterations}-{seed}.safetensors"
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        training.fit(train, config(missing, iterations, seed), progress=True).save(path)
    return training.load(path)


def film(models: dict[str, Stylizer], path: Path) -> None:
    """One run without each loss: three noises, two references, and a clip of the target style in its own style."""
    source, *references = procedural.load((PLAIN, *VERSIONS), "FW", seconds=4.0, seed=TESTED[0])
    rows, labels = [], []
    for name, model in models.items():
        made = [stylize(model, source, DOMAINS[1], k) for k in (1, 2, 3)]
        made += [stylize(model, source, DOMAINS[1], reference=clip) for clip in references]
        made.append(stylize(model, references[0], DOMAINS[1], reference=references[0]))
        rows += [clip.cut(60, 60 + 120) for clip in made]
        labels += [f"{name}: noise {k}" for k in (1, 2, 3)] + [f"like {v}" for v in VERSIONS] + ["own style"]
    view.animate(rows, path, labels=labels, columns=6, fps=10, height=130)


def missing(
    out: Annotated[Path, typer.Option(help="Folder of the runs; finished ones are not repeated.")] = Path("out/missing"),
    losses: Annotated[str, typer.Option(help=f"Comma-separated: {', '.join(MISSING)}.")] = ",".join(MISSING),
    iterations: Annotated[int, typer.Option(min=1, help="Of each training.")] = USUAL,
    seeds: Annotated[str, typer.Option(help="Comma-separated.")] = "0,1",
    picture: Annotated[Path | None, typer.Option(help="Film of the stylizers of the first seed.")] = None,
    store: Annotated[bool, typer.Option(help="Write the rows into the table's file in docs/results.")] = False,
) -> None:
    """The stylizer without each of its losses, on procedural motion: measures, and a film."""
    torch.set_num_threads(1)
    train, referee, rows, shown = mixed(LEARNT), Referee.train(), [], {}
    for name in losses.split(","):
        found = []
        for seed in map(int, seeds.split(",")):
            run = trained(name, train, iterations, seed, out)
            shown.setdefault(name, run.stylizer)
            found.append(referee.score(run.stylizer))
            print(name, seed, {k: round(v, 3) for k, v in found[-1].items()})
        label = name if iterations == USUAL else f"{name}, {iterations:,} iterations"
        rows.append({"method": label, **{key: [one[key] for one in found] for key in found[0]}})
    rows += [{"method": name, **values} for name, values in referee.floors(train).items()]
    real = {"gait": float(referee.gait.right(referee.plain.x, referee.plain.content).float().mean()),
            "style": float(referee.style.right(referee.versions.x, referee.versions.domain).float().mean())}
    command = f"python -m experiments stylization missing --seeds {seeds} --iterations {iterations} --store"
    result = Result("stylisation-missing", f"Procedural {', '.join((PLAIN, *VERSIONS))}; {USUAL} iterations where "
                    "a row does not say another number; mean ± deviation over the seeds", command, COLUMNS, rows,
                    {"iterations": iterations, "seeds": seeds.count(",") + 1, "training windows": len(train),
                     "scored windows": len(referee.plain), **machine("cpu")}, {"judges are right": real})
    print(f"{result.about}\n\n{result.markdown()}\njudges on real windows: {real}")
    if store:
        print(f"wrote {result.add()}")
    if picture is not None:
        film(shown, picture)
