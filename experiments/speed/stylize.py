"""Speed of stylisation: restyling a clip of 1,000 frames with networks of the paper's size."""

import timeit

import torch

from toolkit import datasets
from toolkit.stylization import build, stylize
from toolkit.stylization.data import FPS
from toolkit.stylization.networks import Sizes, build as networks

FRAMES = 1000  # of the clip, at 30 Hz
REPEATS = 5  # of which the shortest counts


def run() -> None:
    """Seconds to restyle a clip on two threads, compared with its duration (real time).

    The weights are random, which does not change the speed.
    """
    (walk,) = datasets.load("procedural", styles=["Neutral"], gaits=["FW"],
                            seconds=FRAMES / FPS + 1)
    clip = walk.resample(FPS).cut(0, FRAMES)
    motions = build([clip])
    torch.set_num_threads(2)
    torch.manual_seed(0)
    model = networks(motions.graph, motions.domains, Sizes(), motions.statistics())[0].eval()
    taken = min(timeit.repeat(lambda: stylize(model, clip.replace(), domain=model.domains[0]),
                              number=1, repeat=REPEATS))
    parameters = sum(p.numel() for p in model.generator.parameters())
    print(f"{len(clip):,} frames, G of {parameters:,} parameters: {taken:.3f} s, "
          f"{clip.seconds / taken:.0f} x real time")
