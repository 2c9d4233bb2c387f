"""The same work in an older checkout and in this one, in turns: is anything slower?"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Annotated

import typer

HERE = Path(__file__).parents[2]
SLOWER = 1.1  # a larger ratio is marked
ROUNDS = 7  # runs of each work, of which the median counts
CLIPS = (
    "clips = tk.datasets.load('procedural', styles=['Neutral', 'Zombie'], gaits=['FW'], seconds=20)"
)
MODEL = "model, bank = tk.pretrained()"
START = (
    f"{MODEL}; fast = tk.runtime.compile(model); go = tk.runtime.straight(speed=1.2, "
    f"seconds=1)[0]; "
    "first = tk.runtime.start(fast, torch.stack([bank['Zombie']] * {n}))"
)
WALK = "state = first\nfor _ in range(60): state = tk.runtime.step(fast, state, go)"
#: Preparation and timed statement of each work, in names that every version of the package has.
WORKS = {
    "network, 64 rows": (
        f"{MODEL}; made = model.layout; x = torch.zeros(64, made.n_inputs); "
        "phase = torch.zeros(64, 8); style = torch.stack([bank['Zombie']] * 64)",
        "for _ in range(20): model.predict(x, phase, style)"),
    "60 frames, 1 character": (START.format(n=1), WALK),
    "60 frames, 64 characters": (START.format(n=64), WALK),
    "phase fit, 1,200 frames": (CLIPS, "tk.phases.extract(clips[0])"),
    "BVH written, 1,200 frames": (CLIPS, "tk.bvh.save(clips[0], 'walk.bvh')"),
    "BVH read, 1,200 frames": (f"{CLIPS}; tk.bvh.save(clips[0], 'walk.bvh')",
                               "tk.bvh.load('walk.bvh')"),
    "BVH to features, 1,200 frames": (
        f"{CLIPS}; tk.bvh.save(clips[0], 'walk.bvh')",
        "clip = tk.bvh.load('walk.bvh').replace(style='a'); tk.features.build([clip])"),
    "5 training steps": (
        f"{CLIPS}; data = tk.features.build(clips)",
        "tk.training.fit(data, tk.training.Config(steps=5))"),
    "stylize, 10 s": (
        f"{CLIPS}; few = tk.stylization.Config.quick(iterations=2); "
        "run = tk.stylization.fit(tk.stylization.build(clips), few)",
        "tk.stylization.stylize(run.stylizer, clips[0].cut(0, 600), domain='Zombie', seed=3)"),
    "page": (MODEL, "tk.view.web(model, bank, 'page.html', half=True)"),
}
#: A process that holds one checkout: it does what a line of JSON says, and answers with seconds.
WORKER = """
import json, sys, time, warnings, torch, toolkit as tk
warnings.simplefilter("ignore")
torch.set_num_threads(1)
out, sys.stdout = sys.stdout, sys.stderr  # what the package prints is no answer
for line in sys.stdin:
    names, code = {"tk": tk, "torch": torch}, json.loads(line)
    if code["prepare"]:
        kept = names
        exec(code["prepare"], kept)
    began = time.process_time()
    exec(code["work"], kept)
    print(time.process_time() - began, file=out, flush=True)
"""


class Checkout:
    """A process that imports the package of one folder."""

    def __init__(self, tree: Path, folder: str) -> None:
        alone = {"PYTHONPATH": str(tree), "OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1"}
        self.process = subprocess.Popen(
            [sys.executable, "-c", WORKER], cwd=folder, env=os.environ | alone, text=True,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)

    def seconds(self, prepare: str, work: str) -> float:
        """Processor seconds of some work; nan if the process has ended with an error."""
        try:
            self.process.stdin.write(json.dumps({"prepare": prepare, "work": work}) + "\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            return float("nan")
        return float(self.process.stdout.readline() or "nan")


def compare(trees: list[Path], prepare: str, work: str) -> list[float]:
    """Median processor seconds of some work in each checkout, measured in turns."""
    taken: list[list[float]] = [[] for _ in trees]
    with tempfile.TemporaryDirectory() as folder:
        checkouts = [Checkout(tree, folder) for tree in trees]
        for turn in range(ROUNDS + 1):
            for checkout, seconds in zip(checkouts, taken, strict=True):
                # the first call prepares and compiles, and is not counted
                found = checkout.seconds("" if turn else prepare, work)
                seconds += [found] * (turn > 0)
        for checkout in checkouts:
            checkout.process.communicate()
    return [statistics.median(seconds) for seconds in taken]


def run(
    base: Annotated[Path, typer.Option(help="The older checkout, e.g. of `git worktree add`.")],
) -> None:
    """Processor time of the same work in an older checkout and in this one, as ratios, on one
    core.
    """
    if not (base / "toolkit" / "__init__.py").is_file():
        raise ValueError(f"{base}: is no checkout of the package: it has no toolkit/__init__.py")
    print(f"{'':<34}{'before, ms':>12}{'after, ms':>12}{'ratio':>8}")
    for name, (prepare, work) in WORKS.items():
        old, new = compare([base.resolve(), HERE], prepare, work)
        mark = " slower" if new > SLOWER * old else ""
        print(f"{name:<34}{1000 * old:>12.1f}{1000 * new:>12.1f}{new / old:>8.2f}{mark}",
              flush=True)
