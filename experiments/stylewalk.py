"""The judges of StyleWalk, and the rows of its floors, from recorded takes."""

from collections import defaultdict
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.tables import Result
from toolkit.datasets import bandai
from toolkit.extra.benchmark import Judges, score, walk
from toolkit.extra.benchmark.judges import FILE, train
from toolkit.motion import Clip, rotations as R
from toolkit.training import published

PARTS = 4  # of the takes of a style and gait: of each judge, the reference, the floors
CARRIED, NOISE = 0.5, 1.0  # m/s sideways, degrees


def parts(data: Path) -> list[list[Clip]]:
    """Takes of the second Bandai-Namco set in parts that have no take in common."""
    groups: dict[tuple[str, str], list[Clip]] = defaultdict(list)
    for clip in bandai.load(data / "bandai" / "dataset-2"):
        if clip.seconds > 2:
            groups[clip.style, clip.gait].append(clip)
    return [[clip for group in groups.values() for clip in group[k::PARTS]] for k in range(PARTS)]


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
    store: Annotated[bool, typer.Option(
        "--store", help="Write the judges and docs/results/stylewalk.json.")] = False,
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
