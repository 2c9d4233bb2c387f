"""The same work with an older checkout of the package and with this one: is anything slower?"""

import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Annotated

import typer

from experiments.tables import Result

HERE = Path(__file__).parents[2]
SLOWER = 1.1  # a ratio above it is marked
COLUMNS = {"work": ["work"], "before": ["before, ms", 1, 1000], "after": ["after, ms", 1, 1000],
           "ratio": ["after / before", 2]}
CLIP = "clip, = tk.datasets.load('procedural', styles=['Zombie'], gaits=['FW'], seconds=50); "
DATA = "data = tk.features.build(tk.datasets.load('procedural', styles=['Neutral', 'Zombie'], gaits=['FW'], seconds=20)); "
WALK = ("model, bank = tk.pretrained(); net = tk.runtime.compile(model); "
        "state = tk.runtime.start(net, torch.stack([bank['Zombie']] * {n})); "
        "go = tk.runtime.straight(speed=1.2, seconds=1)[0]; ")
STEPS = "s = state\nfor _ in range(60): s = tk.runtime.step(net, s, go)"
#: Preparation and timed statement of each work, in names that both packages have. Without preparation: a command line.
WORKS = {
    "import": (None, ["-c", "import toolkit"]),
    "--help": (None, ["-m", "toolkit", "--help"]),
    "train --help": (None, ["-m", "toolkit", "train", "--help"]),
    "BVH written, 3,000 frames": (CLIP, "tk.bvh.save(clip, 'walk.bvh')"),
    "BVH read, 3,000 frames": (CLIP + "tk.bvh.save(clip, 'walk.bvh')", "tk.bvh.load('walk.bvh')"),
    "phases fitted, 3,000 frames": (CLIP, "tk.phases.extract(clip)"),
    "features, 3,000 frames": (CLIP, "tk.features.build([clip])"),
    "20 training steps, full size": (DATA, "tk.training.fit(data, tk.training.Config(steps=20))"),
    "20 training steps, small": (DATA, "tk.training.fit(data, tk.training.Config.quick(steps=20))"),
    "runtime, 1 character, a second": (WALK.format(n=1), STEPS),
    "runtime, 64 characters, a second": (WALK.format(n=64), STEPS),
    "runtime, 512 characters, a second": (WALK.format(n=512), STEPS),
    "rollout, 5 s": ("model, bank = tk.pretrained()", "tk.runtime.rollout(model, tk.runtime.straight(speed=1.2, seconds=5), "
                                                      "style=bank['Zombie'])"),
    "page": ("model, bank = tk.pretrained()", "tk.view.web(model, bank, 'page.html', half=True)"),
    "stylize, 10 s": (
        "clips = tk.datasets.load('procedural', styles=['Neutral', 'Zombie'], gaits=['FW'], seconds=20); "
        "run = tk.stylization.fit(tk.stylization.build(clips), tk.stylization.Config.quick(iterations=2))",
        "tk.stylization.stylize(run.stylizer, clips[0].cut(0, 600), domain='Zombie', seed=3)"),
    "demo, 36 s of training": (None, ["-m", "toolkit", "demo"]),
}
TIMER = """
import json, sys, time, warnings, torch, toolkit as tk
warnings.simplefilter("ignore")
torch.set_num_threads(1)
before, work, rounds = sys.argv[1:]
names = {"tk": tk, "torch": torch}
exec(before, names)
work, taken = compile(work, "work", "exec"), []
for _ in range(int(rounds) + 1):
    started = time.process_time()
    exec(work, names)
    taken.append(time.process_time() - started)
print(json.dumps(taken[1:]))
"""


def run(
    before: Annotated[Path, typer.Option(help="Folder of the older checkout, e.g. of `git worktree add FOLDER aa43f56`.")],
    rounds: Annotated[int, typer.Option(min=1, help="Runs of each work; the median is printed.")] = 5,
    only: Annotated[str, typer.Option(help="Works whose name contains this text.")] = "",
    store: Annotated[bool, typer.Option(help="Add the rows to the stored result before-after.")] = False,
) -> None:
    """Processor time of the same work with an older checkout and with this one, on one core."""
    if not (before / "toolkit" / "__init__.py").is_file():
        raise ValueError(f"{before}: is no checkout of the package: it has no toolkit/__init__.py")
    print(f"{'':<36}{'before':>10}{'after':>10}{'after / before':>16}")
    rows = []
    for name in (name for name in WORKS if only in name):
        old, new = measure(*WORKS[name], [before.resolve(), HERE], rounds)
        ratio = new / old if old and new else float("nan")
        rows.append({"work": name, "before": old, "after": new, "ratio": ratio})
        said = "".join(f"{'failed' if t is None else f'{1000 * t:.1f} ms':>10}" for t in (old, new))
        print(f"{name:<36}{said}{ratio:>16.2f}{' slower' if ratio > SLOWER else ''}", flush=True)
    if store:
        commit = subprocess.check_output(["git", "-C", before, "rev-parse", "--short", "HEAD"], text=True).strip()
        Result("before-after", f"processor time of the same work at {commit} and now, on one core; median of {rounds} runs",
               f"python -m experiments before-after --before FOLDER --rounds {rounds} --store", COLUMNS, rows).add()


def measure(before: str | None, work: str | list[str], trees: list[Path], rounds: int) -> list[float | None]:
    """Median processor seconds in each tree, in turns; None where it fails."""
    taken: list[list[float]] = [[] for _ in trees]
    with tempfile.TemporaryDirectory() as folder:
        turns = rounds if before is None else 2
        for turn in range(turns + (before is None)):
            for tree, seconds in zip(trees, taken, strict=True):
                found = _command(tree, work, folder) if before is None else _timed(tree, before, work, rounds, folder)
                if turn or before is not None:  # the first run of a command may compile
                    seconds += found
    return [statistics.median(seconds) if seconds else None for seconds in taken]


def _timed(tree: Path, before: str, work: str, rounds: int, folder: str) -> list[float]:
    done = _run(tree, ["-c", TIMER, before, work, str(rounds)], folder)
    return [] if done is None else json.loads(done.splitlines()[-1])


def _command(tree: Path, arguments: list[str], folder: str) -> list[float]:
    before = _children()
    return [] if _run(tree, arguments, folder) is None else [_children() - before]


def _children() -> float:
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def _run(tree: Path, arguments: list[str], folder: str) -> str | None:
    """Output of a Python process that imports the package of a tree; None, and the error on standard error, if it fails."""
    environment = os.environ | {"PYTHONPATH": str(tree), "OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1"}
    done = subprocess.run([sys.executable, *arguments], cwd=folder, env=environment, capture_output=True, text=True,
                          encoding="utf-8")
    if done.returncode:
        print(f"{tree}: {done.stderr.strip().splitlines()[-1:]}", file=sys.stderr)
    return None if done.returncode else done.stdout
