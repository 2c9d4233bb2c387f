"""Speed of a training step, compared with a plain implementation."""

import contextlib
import os
import time
from collections.abc import Iterator
from unittest import mock

import numpy as np
import torch
from torch import Tensor, nn

from toolkit import datasets, features, networks
from toolkit.networks import BlendedLinear
from toolkit.networks.film import Convolution
from toolkit.training import distributed, loop
from toolkit.training.minibatches import Minibatches
from toolkit.training.run import Config

STYLES = ("Neutral", "Zombie", "Strut", "Old")
REPEATS = 9  # steps, of which the median is printed
#: Style clips per minibatch and precision.
FORMS = {
    "plain": (32, "32"),
    "toolkit": (32, "32"),
    "toolkit, bf16": (32, "bf16"),
    "toolkit, one clip": (1, "32"),
    "toolkit, one clip, bf16": (1, "bf16"),
}


@contextlib.contextmanager
def plain() -> Iterator[None]:
    """Inside, every sample blends its weights, torch convolves, and Adam loops over tensors."""
    adam, slow = torch.optim.Adam, {"fused": False, "foreach": False}
    with (
        mock.patch.object(BlendedLinear, "forward", _blend_weights),
        mock.patch.object(Convolution, "forward", nn.Conv1d.forward),
        mock.patch("torch.optim.Adam", lambda *a, **k: adam(*a, **(k | slow))),
    ):
        yield


def run() -> None:
    """Milliseconds of a training step, compared with a plain implementation.

    They are for the paper's sizes and a batch of 32. All implementations train the same model in
    turn, so that other load affects all of them. In its turn each makes two steps, and the second
    is timed: the first one gets the memory.
    """
    torch.set_num_threads(len(os.sched_getaffinity(0))
                          if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)
    data = features.build(datasets.load("procedural", styles=list(STYLES), gaits=["FW"],
                                        seconds=30.0))
    model = networks.build("lpn-film", data.layout, len(STYLES)).train()
    model.normalise(networks.normalisers(model.layout, data))
    seconds: dict[str, list[float]] = {name: [] for name in FORMS}
    optimisers: dict[bool, torch.optim.Optimizer] = {}
    for turn in range(-1, REPEATS):  # the first turn is not counted
        for name, (clips, precision) in FORMS.items():
            config = Config(clips_per_batch=clips, precision=precision)
            fabric = distributed.start(config.device, config.processes)
            with plain() if name == "plain" else contextlib.nullcontext():
                adam = optimisers.setdefault(name == "plain", loop.optimiser(model, config))
                objective = fabric.setup_module(distributed.Objective(model, precision=precision))
                batches = Minibatches(data, config.batch, clips, config.seed)
                for _ in range(2):
                    began = time.perf_counter()
                    loop.step(fabric, objective, adam, batches, config, turn + 1, config.rate)
            if turn >= 0:
                seconds[name].append(time.perf_counter() - began)

    count = sum(p.numel() for p in model.parameters())
    print(f"a step of {count:,} parameters, batch 32, {torch.get_num_threads()} threads, median "
          f"of {REPEATS}\n{'':<24}{'ms':>8}{'speed-up':>15}")
    usual = float(np.median(seconds["plain"]))
    for name, taken in seconds.items():
        own = float(np.median(taken))
        print(f"{name:<24}{1e3 * own:>8.0f}{usual / own:>15.2f}")


def _blend_weights(layer: BlendedLinear, x: Tensor, gates: Tensor) -> Tensor:
    weight = torch.einsum("bk,kio->bio", gates, layer.weight)
    return torch.einsum("bi,bio->bo", x, weight) + gates @ layer.bias
