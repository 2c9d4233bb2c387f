"""Speed of stylisation: restyling a clip of 1,000 frames with networks of the paper's size,
compared with real time.
"""

import time
from collections.abc import Callable
from typing import Annotated

import numpy as np
import torch
import typer

from toolkit import datasets
from toolkit.stylization import build, stylize
from toolkit.stylization.data import FPS, describe, prepare
from toolkit.stylization.networks import Sizes, build as networks
from toolkit.stylization.restyling import lock_feet

TARGET = 1.0  # seconds for 1,000 frames on two cores


def run(
    frames: Annotated[int, typer.Option(help="Length of the clip at 30 Hz.")] = 1000,
    repeats: Annotated[int, typer.Option(help="Repetitions; the median is printed.")] = 5,
    threads: Annotated[int, typer.Option(help="Number of threads.")] = 2,
) -> None:
    """Seconds to restyle a clip, step by step, compared with its duration (real time).

    The weights are random, which does not change the speed.
    """
    (walk,) = datasets.load("procedural", styles=["Neutral"], gaits=["FW"],
                            seconds=frames / FPS + 1)
    clip = walk.resample(FPS).cut(0, frames)
    motions = build([clip])
    torch.manual_seed(0)
    model = networks(motions.graph, motions.domains, Sizes(), motions.statistics())[0].eval()
    source, code = prepare(clip), torch.zeros(model.sizes.code)
    x = describe(source)[0][None, :, : frames - frames % 4]
    parts = {
        "features of the source": lambda: describe(prepare(clip)),
        "the stylizer G": lambda: model.translate(x, code[None]),
        "foot-skate removal": lambda: lock_feet(source.replace(), source),
        "all of stylize()": lambda: stylize(model, clip.replace(), domain=model.domains[0]),
    }
    before = torch.get_num_threads()
    torch.set_num_threads(threads)
    try:
        times = {name: np.median([_seconds(work) for _ in range(repeats)], axis=0)
                 for name, work in parts.items()}
    finally:
        torch.set_num_threads(before)
    parameters = sum(p.numel() for p in model.generator.parameters())
    print(f"{len(clip):,} frames, G of {parameters:,} parameters, {threads} threads; median of "
          f"{repeats}")
    for name, (wall, processor) in times.items():
        rate = len(clip) / wall
        speed = f"{rate:>10,.0f} frames/s{rate / FPS:>7.0f} x real time"
        print(f"{name:<24}{wall:>8.3f} s, {processor:.3f} s of CPU time {speed}")
    whole = times["all of stylize()"][0] * 1000 / len(clip)
    print(f"1,000 frames in {whole:.2f} s   (target {TARGET:g} s: "
          f"{'met' if whole < TARGET else 'MISSED'})")


def _seconds(work: Callable[[], object]) -> tuple[float, float]:
    """Wall time and CPU time."""
    start = time.perf_counter(), time.process_time()
    work()
    return time.perf_counter() - start[0], time.process_time() - start[1]
