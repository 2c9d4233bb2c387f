"""The judges of StyleWalk, and its rows: recorded takes, floors, and models trained alike."""

import runpy
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import nn

from experiments.matching import frame_time
from experiments.tables import Result, Store
from toolkit import features, networks, training
from toolkit.datasets import bandai
from toolkit.evaluation.metrics.bodies import hips_path
from toolkit.extra import matching
from toolkit.extra.benchmark import PLAN, Judges, commands, score, walk
from toolkit.extra.benchmark.judges import CHANNELS, FILE, KINDS, WINDOW, windows
from toolkit.motion import Clip, rotations as R
from toolkit.motion.trajectory import FPS
from toolkit.training import Run, published

PARTS = 4  # of the takes of a style and gait: of each judge, the reference, the floors
CARRIED, NOISE = 0.5, 1.0  # m/s sideways, degrees
STEPS, BATCH, RATE = 600, 64, 3e-3  # of the judges
JITTER, OFFSET = 0.05, 0.3  # augmentation: deviations of noise per frame, per window
TRAINED = 5000  # steps of each model
OUTSIDE = "gru", "low-rank", "vq-codebook", "flow-transformer"  # the models of examples/models


def parts(data: Path) -> list[list[Clip]]:
    """Takes of the second Bandai-Namco set in parts that have no take in common."""
    groups: dict[tuple[str, str], list[Clip]] = defaultdict(list)
    for clip in bandai.load(data / "bandai" / "dataset-2"):
        if clip.seconds > 2:
            groups[clip.style, clip.gait].append(clip)
    return [[clip for group in groups.values() for clip in group[k::PARTS]] for k in range(PARTS)]


def train(parts: Sequence[Sequence[Clip]], seed: int = 0) -> Judges:
    """Judges of labelled clips in three parts: of the first judge, of the second, the reference."""
    styles = sorted({clip.style for clip in parts[0]})
    seen = [[windows(clip) for clip in part] for part in parts]
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(seed)
        made = Judges(styles, sum(map(len, seen[2])))
        every = torch.cat([*seen[0], *seen[1]])
        made.mean, made.std = every.mean((0, 1)), every.std((0, 1)).clamp_min(0.02)
        for name, clips, some in zip(KINDS, parts, seen, strict=False):
            judge, x = made.judges[name], (torch.cat(some) - made.mean) / made.std
            labels = torch.cat([torch.full((len(one),), styles.index(clip.style))
                                for clip, one in zip(clips, some, strict=True)])
            adam = torch.optim.AdamW(judge.parameters(), lr=RATE, weight_decay=1e-2)
            for _ in range(STEPS):
                rows = torch.randint(len(x), (BATCH,))
                noisy = x[rows] + JITTER * torch.randn(BATCH, WINDOW, CHANNELS)
                noisy = noisy + OFFSET * torch.randn(BATCH, 1, CHANNELS)
                loss = nn.functional.cross_entropy(judge.out(judge.features(noisy)), labels[rows])
                adam.zero_grad()
                loss.backward()
                adam.step()
        made.eval()
        for name in KINDS:
            features = [made.features(name, clip) for clip in parts[2]]
            setattr(made, f"reference_{name}", torch.cat(features))
    return made


def floors(clips: list[Clip]) -> dict[str, dict[str, Clip]]:
    """Recorded clips, and what must not be taken for a good answer."""
    named = {f"take_{clip.style}_{number}": clip for number, clip in enumerate(clips)}
    draw = torch.Generator().manual_seed(0)
    made: dict[str, dict[str, Clip]] = {"recorded": named}
    for name, clip in named.items():
        roots, q = clip.root_positions, R.unroll(clip.rotations)
        time = torch.arange(len(clip))[:, None] / clip.fps
        still = q[:1].expand_as(q)
        mean = R.normalize(q.mean(0, keepdim=True)).expand_as(q)
        small = torch.deg2rad(NOISE * torch.randn(*q.shape[:2], 3, generator=draw))
        angle = small.norm(dim=-1)
        turned = R.multiply(q, R.from_axis_angle(small / angle[..., None], angle))
        for floor, changed in {
            "first pose": clip.replace(rotations=still),
            "mean pose": clip.replace(rotations=mean),
            "noise": clip.replace(rotations=R.normalize(turned)),
            "slide": clip.replace(root_positions=roots + time * torch.tensor([CARRIED, 0, 0])),
        }.items():
            made.setdefault(floor, {})[name] = changed
    return made


def nearest(clips: list[Clip]) -> dict[str, Clip]:
    """For each walk of the plan the take of its style whose path is the nearest, and no steering.

    A take is turned so that its first second leads ahead.
    """
    takes = []
    for clip in (clip.resample(FPS) for clip in clips):
        way = hips_path(clip)[FPS - 1] - hips_path(clip)[0]
        clip = clip.moved(turn=-float(torch.atan2(way[0], way[1])))
        takes.append((clip, hips_path(clip) - hips_path(clip)[:1]))
    found = {}
    for style in PLAN["styles"]:
        own = [take for take in takes if take[0].style == style]
        walks = [len(path) / path.diff(dim=0).norm(dim=-1).sum() for clip, path in own
                 if clip.gait == "walk"]
        pace = FPS / float(torch.stack(walks).median())
        for track in PLAN["tracks"]:
            for seed in PLAN["seeds"]:
                orders = commands(track, pace, seed)[round(PLAN["warm_up"] * FPS):]
                asked = torch.tensor([order.velocity for order in orders]).cumsum(0) / FPS
                far = [(path[:len(asked)] - asked[:len(path)]).norm(dim=-1).mean()
                       for _, path in own]
                best = own[int(torch.stack(far).argmin())][0]
                found[f"{track}_{style}_{seed}"] = best.cut(0, len(asked))
    return found


def models(clips: list[Clip], folder: Path) -> dict[str, Run]:
    """The seven models and four of other kinds, trained alike, and motion matching in the same
    data. A finished training is read from the folder.
    """
    data = features.build(clips, mirror=True, short="skip")
    for name in OUTSIDE:
        runpy.run_path(f"examples/models/{name.replace('-', '_')}.py")
    runs = {}
    for name in (*networks.MODELS, *OUTSIDE):
        file = folder / f"{name}.safetensors"
        if not file.is_file():
            config = training.Config.quick(model=name, steps=TRAINED)
            training.fit(data, config, file.with_suffix(".checkpoint"), progress=True).save(file)
        runs[name] = training.load(file)
    return runs | {"motion matching": matching.match(data)}


def run(
    data: Annotated[Path, typer.Option(help="Folder that holds bandai/.")],
    out: Annotated[Path, typer.Option(help="Folder of the trained models.")] = Path(
        "out/stylewalk"),
    store: Store = False,
) -> None:
    """Score floors, takes and models by judges, which are trained once."""
    torch.set_num_threads(1)  # sums of two threads train other judges
    taken = parts(data)
    if not FILE.is_file():  # those of a version stay
        train(taken[:3]).save(FILE)
    judges = Judges.load()
    scored = [score(clips, judges, name) for name, clips in floors(taken[3]).items()]
    seen = [clip for part in taken[:3] for clip in part]
    scored.append(score(nearest(seen), judges, "nearest take"))
    runs = {f"{name} model": published.either(name, None) for name in ("procedural", "recorded")}
    folder = data / "lpn_film_100style"
    if folder.is_dir():
        runs["published model"] = published.either(None, folder)
    out.mkdir(parents=True, exist_ok=True)
    runs |= models(seen, out)
    frame = {}
    for name, (model, bank) in runs.items():
        scored.append(score(walk(model, bank, progress=True), judges, name))
        frame[name] = frame_time(model, bank.vectors[:1])
    rows = []
    for one in scored:
        print(one, flush=True)
        rows.append({"method": one.name}
                    | {row.replace(" ", "-"): value for row, (value, *_) in one.rows.items()}
                    | ({"ms": frame[one.name]} if one.name in frame else {}))
    if store:
        decimals = {"ms": 1, "fmd": 2, "jerk": 0, "direction": 1, "shake": 4}
        columns = {"method": ["method"]} | {
            row.replace(" ", "-"): [row, decimals.get(row.split()[0], 3)]
            for row in (*scored[0].rows, "ms")}
        intervals = {one.name: {row: ends for row, (_, *ends) in one.rows.items()}
                     for one in scored}
        Result("stylewalk", "StyleWalk 1: recorded takes of Bandai-Namco 2 that no judge saw, "
               "floors made from them, and models.",
               "python -m experiments stylewalk --data DATA --store", columns, rows,
               numbers={"intervals": intervals}).save()
