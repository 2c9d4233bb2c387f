"""Speed of the procedural dataset, compared with forward kinematics of the same frames."""

import hashlib
import time
from typing import Annotated

import numpy as np
import torch
import typer

from toolkit.datasets import procedural
from toolkit.motion import Clip, forward_kinematics

TARGET = 20_000  # frames per second of one core


def run(
    seconds: Annotated[float, typer.Option(help="Length of each clip.")] = 20.0,
    repeats: Annotated[int, typer.Option(help="Repetitions; the median is printed.")] = 5,
) -> None:
    """Frames per second of the procedural dataset on one core, compared with forward kinematics; does a seed repeat?

    Times are process times of one thread. Clips of the same seed must be the same bytes.
    """
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        made, kinematics, hashes = [], [], set()
        for _ in range(repeats):
            start = time.process_time()
            clips = procedural.load(gaits=("FW", "SW", "FR"), seconds=seconds)
            made.append(time.process_time() - start)
            start = time.process_time()
            for clip in clips:
                forward_kinematics(clip.skeleton, clip.rotations, clip.root_positions)
            kinematics.append(time.process_time() - start)
            hashes.add(digest(clips))
    finally:
        torch.set_num_threads(threads)
    frames = sum(map(len, clips))
    rate = frames / float(np.median(made))
    print(f"{len(clips)} clips of {seconds:g} s, {frames:,} frames; one core, median of {repeats}")
    print(f"generation          {rate:>10,.0f} frames/s   (target {TARGET:,}: {'met' if rate >= TARGET else 'MISSED'})")
    print(f"forward kinematics  {frames / float(np.median(kinematics)):>10,.0f} frames/s   of the same frames")
    print(f"same seed           {'the same bytes' if len(hashes) == 1 else 'DIFFERENT BYTES'}, {' '.join(sorted(hashes))}")


def digest(clips: list[Clip]) -> str:
    """Hash of the arrays of clips."""
    data = hashlib.sha256()
    for clip in clips:
        data.update(clip.rotations.numpy().tobytes() + clip.root_positions.numpy().tobytes())
    return data.hexdigest()[:16]
