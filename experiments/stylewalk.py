"""The judges of StyleWalk, and the rows of its floors, from recorded takes."""

from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import nn

from experiments.tables import Result, Store
from toolkit.datasets import bandai
from toolkit.extra.benchmark import Judges, score, walk
from toolkit.extra.benchmark.judges import CHANNELS, FILE, KINDS, WINDOW, windows
from toolkit.motion import Clip, rotations as R
from toolkit.training import published

PARTS = 4  # of the takes of a style and gait: of each judge, the reference, the floors
CARRIED, NOISE = 0.5, 1.0  # m/s sideways, degrees
STEPS, BATCH, RATE = 600, 64, 3e-3
JITTER, OFFSET = 0.05, 0.3  # augmentation: deviations of noise per frame, per window


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


def run(
    data: Annotated[Path, typer.Option(help="Folder that holds bandai/.")],
    store: Store = False,
) -> None:
    """Train the judges of StyleWalk, and score floors, recorded takes and models."""
    torch.set_num_threads(1)  # sums of two threads train other judges
    taken = parts(data)
    judges = train(taken[:3])
    if store:
        judges.save(FILE)
        judges = Judges.load()
    scored = [score(clips, judges, name) for name, clips in floors(taken[3]).items()]
    for name in ("procedural", "recorded"):
        walks = walk(*published.either(name, None), progress=True)
        scored.append(score(walks, judges, f"{name} model"))
    folder = data / "lpn_film_100style"
    if folder.is_dir():
        scored.append(score(walk(*published.either(None, folder)), judges, "published model"))
    rows = []
    for one in scored:
        print(one, flush=True)
        rows.append({"method": one.name} | {row: value for row, (value, *_) in one.rows.items()})
    if store:
        decimals = {"fmd": 2, "jerk": 0, "direction": 1, "shake": 4}
        columns = {"method": ["method"]} | {
            row: [row, decimals.get(row.split()[0], 3)] for row in scored[0].rows}
        intervals = {one.name: {row: ends for row, (_, *ends) in one.rows.items()}
                     for one in scored}
        Result("stylewalk", "StyleWalk 1: recorded takes of Bandai-Namco 2 that no judge saw, "
               "floors made from them, and models.",
               "python -m experiments stylewalk --data DATA --store", columns, rows,
               numbers={"intervals": intervals}).save()
