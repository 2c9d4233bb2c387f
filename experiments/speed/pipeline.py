"""Speed of preprocessing, from BVH files to a store of features, and of minibatches from the store
and from memory.
"""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import datasets, features
from toolkit.datasets import procedural
from toolkit.extra import store
from toolkit.features import Features
from toolkit.training import minibatches

GAITS = ("FW", "BW", "FR", "SW", "ID")
DATASET = 4_055_978  # frames of 100STYLE
FEW = 10  # files in the small run


def run(
    files: Annotated[int, typer.Option(min=2 * FEW,
                                       help="Files in the large run, five per style.")] = 200,
    seconds: Annotated[float,
                       typer.Option(help="Length of a file; the mean of 100STYLE is 84 s.")] = 84.0,
    workers: Annotated[int, typer.Option(min=1, help="Processes.")] = 2,
    steps: Annotated[int, typer.Option(help="Minibatches to read.")] = 500,
) -> None:
    """Frames per second of preprocessing, few files compared with many; minibatches from a store
    compared with memory.
    """
    with tempfile.TemporaryDirectory() as folder:
        drawn = Path(folder) / "drawn"
        procedural.write(drawn, "Neutral", GAITS, seconds)
        print(f"{'files':>6}{'frames':>12}{'s':>8}{'CPU s':>8}{'frames/s':>10}{'peak MB':>9}"
              f"{'bytes/frame':>13}")
        for n in (FEW, files):
            root, out = Path(folder) / f"data{n}", Path(folder) / f"store{n}"
            _multiply(drawn, root, n // len(GAITS))
            call = ["preprocess", "--data", "100style", "--root", str(root), "--out", str(out),
                    "--workers", str(workers)]
            elapsed, cpu, peak = _measured([sys.executable, "-m", "toolkit", *call])
            frames = n // len(GAITS) * len(GAITS) * round(60 * seconds)
            size = sum(path.stat().st_size for path in out.iterdir()) / frames
            rate = frames / elapsed
            print(f"{n:>6}{frames:>12,}{elapsed:>8.1f}{cpu:>8.1f}{rate:>10,.0f}"
                  f"{peak / 1e6:>9,.0f}{size:>13,.0f}")
        print(f"100STYLE, {DATASET:,} frames, at this rate: {DATASET / rate / 60:.1f} min "
              f"(target: under 6; "
              f"ai4animationpy: under 5 without phases), {DATASET * size / 1e9:.2f} GB")
        print(f"{workers} processes, from the start of Python to the last checksum; peak: "
              f"resident memory of all processes; "
              f"by CPU time {DATASET * cpu / frames / 60 / workers:.1f} min")

        root, out = (Path(folder) / f"{kind}{FEW}" for kind in ("data", "store"))
        sources = {"in memory": features.build(datasets.load("100style", root)),
                   "store": store.load(out)}
        print(f"\n{'32 frames and':<28}" + "".join(f"{name:>12}" for name in sources)
              + "   minibatches/s")
        kinds = {"1 style clip": (1, 0.0), "1 style clip, 30% mixed up": (1, 0.3),
                 "32 style clips": (32, 0.0)}
        for title, (clips, mixed) in kinds.items():
            rates = {name: _rate(data, clips, mixed, steps) for name, data in sources.items()}
            print(f"{title:<28}" + "".join(f"{rate:>12,.0f}" for rate in rates.values()))


def _multiply(drawn: Path, root: Path, styles: int) -> None:
    """A dataset of many styles, whose files are links to the files of one style."""
    root.mkdir()
    names = [f"Style{i}" for i in range(styles)]
    for table in ("Frame_Cuts.csv", "Dataset_List.csv"):
        header, *rows = (drawn / table).read_text(encoding="utf-8").splitlines()
        row = next(r for r in rows if r.startswith("ProceduralNeutral,"))
        lines = [header, *(row.replace("ProceduralNeutral", name, 1) for name in names)]
        (root / table).write_text("\n".join(lines) + "\n", encoding="utf-8")
    for path in drawn.glob("*.bvh"):
        for name in names:
            (root / path.name.replace("ProceduralNeutral", name)).hardlink_to(path)


def _measured(command: list[str]) -> tuple[float, float, float]:
    """Seconds, seconds of CPU time and peak resident memory, bytes, of a command with its child
    processes.
    """
    import psutil

    began, before, peak = time.perf_counter(), os.times(), 0
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    while process.poll() is None:
        total = 0
        for child in (psutil.Process(process.pid),
                      *psutil.Process(process.pid).children(recursive=True)):
            try:
                total += child.memory_info().rss
            except psutil.NoSuchProcess:
                continue
        peak = max(peak, total)
        time.sleep(0.05)
    if process.returncode:
        raise ValueError(f"{' '.join(command[2:])} failed with status {process.returncode}")
    after = os.times()
    cpu = (
        after.children_user - before.children_user + after.children_system - before.children_system
    )
    return time.perf_counter() - began, cpu, peak


def _rate(data: Features, clips: int, mixed: float, steps: int) -> float:
    """Minibatches per second of one thread; ``mixed`` is the share of frames with a pose mix-up."""
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    batches = minibatches.Minibatches(data, 32, clips, 0, mixed)
    began = time.perf_counter()
    for step in range(steps):
        batches[step]
    elapsed = time.perf_counter() - began
    torch.set_num_threads(threads)
    return steps / elapsed
