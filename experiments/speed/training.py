"""Speed of a training step, compared with a plain implementation and the least possible time."""

import contextlib
import os
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Annotated
from unittest import mock

import numpy as np
import torch
import typer
from torch import Tensor, nn
from torch.utils.flop_counter import FlopCounterMode

from toolkit import datasets, features, networks
from toolkit.features import Features
from toolkit.networks import BlendedLinear
from toolkit.networks.film import Convolution
from toolkit.training import distributed, loop
from toolkit.training.minibatches import Minibatches
from toolkit.training.run import Config

STYLES = ("Neutral", "Zombie", "Strut", "Old")
TARGETS = {"toolkit": 1.5, "toolkit, one clip": 5.0}  # speed relative to the plain form


@dataclass(frozen=True)
class Form:
    """Implementation of a training step: the flags select the toolkit's way for three parts."""

    # scale inputs by their gates, one product; else blend the weights of every sample
    blend: bool = True
    convolve: bool = True  # by spectra of tiles; else torch's convolution
    adam: bool = True  # fused; else a loop over tensors
    clips: int = 32  # style clips per minibatch
    precision: str = "32"

    @contextlib.contextmanager
    def patched(self) -> Iterator[None]:
        """Use this implementation in networks and optimiser within the context."""
        plain = torch.optim.Adam
        with contextlib.ExitStack() as stack:
            if not self.blend:
                stack.enter_context(mock.patch.object(BlendedLinear, "forward", _blend_weights))
            if not self.convolve:
                stack.enter_context(mock.patch.object(Convolution, "forward", nn.Conv1d.forward))
            if not self.adam:
                adam = mock.patch("torch.optim.Adam",
                                  lambda *a, **k: plain(*a,
                                                        **(k | {"fused": False, "foreach": False})))
                stack.enter_context(adam)
            yield


PLAIN = Form(blend=False, convolve=False, adam=False)
FORMS = {
    "plain": PLAIN,
    "plain, fused Adam": replace(PLAIN, adam=True),
    "plain, one product": replace(PLAIN, blend=True),
    "plain, tiles": replace(PLAIN, convolve=True),
    "toolkit": Form(),
    "toolkit, bf16": Form(precision="bf16"),
    "toolkit, one clip": Form(clips=1),
    "toolkit, one clip, bf16": Form(clips=1, precision="bf16"),
}


def run(
    repeats: Annotated[int, typer.Option(min=1, help="Steps; the median is printed.")] = 9,
) -> None:
    """Milliseconds of a training step, compared with a plain implementation and the least possible
    time.

    They are for the paper's sizes and a batch of 32.
    """
    torch.set_num_threads(len(os.sched_getaffinity(0))
                          if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1)
    data = features.build(datasets.load("procedural", styles=list(STYLES), gaits=["FW"],
                                        seconds=30.0))
    _times(data, repeats)


def _times(data: Features, repeats: int) -> None:
    """A table of times; all implementations train the same model in turn, so that other load
    affects all of them.

    In its turn each makes two steps, and the second is timed: the first one gets the memory.
    """
    model = networks.build("lpn-film", data.layout, len(STYLES)).train()
    model.normalise(networks.normalisers(model.layout, data))
    count = sum(p.numel() for p in model.parameters())
    seconds: dict[str, list[float]] = {name: [] for name in FORMS}
    flops, optimisers = {}, {}
    for turn in range(-1, repeats):
        for name, form in FORMS.items():
            config = Config(clips_per_batch=form.clips, precision=form.precision)
            fabric = distributed.start(config.device, config.processes)
            with form.patched():
                adam = optimisers.setdefault(form.adam, loop.optimiser(model, config))
                objective = fabric.setup_module(distributed.Objective(
                    model, precision=config.precision))
                batches = Minibatches(data, config.batch, form.clips, config.seed)
                counter = FlopCounterMode(display=False) if turn < 0 else contextlib.nullcontext()
                with counter:
                    loop.step(fabric, objective, adam, batches, config, turn + 1, config.rate)
                began = time.perf_counter()
                loop.step(fabric, objective, adam, batches, config, turn + 1, config.rate)
            if turn < 0:
                flops[name] = counter.get_total_flops()
            else:
                seconds[name].append(time.perf_counter() - began)
    rates, update = {p: _product_rate(p) for p in ("32", "bf16")}, 7 * 4 * count / _bandwidth()
    print(f"a step of {count:,} parameters, batch 32, {torch.get_num_threads()} threads, median "
          f"of {repeats}")
    speeds = ", ".join(f"{rate / 1e9:.0f} GFLOP/s ({precision})"
                       for precision, rate in rates.items())
    print(f"floor: its matrix products at the rate of a large one, {speeds},")
    print(f"and 7 memory accesses per parameter for Adam at the rate of a copy, "
          f"{1e3 * update:.0f} ms")
    print(f"{'':<24}{'ms':>8}{'speed-up':>15}{'GFLOP':>8}{'floor ms':>10}")
    plain = float(np.median(seconds["plain"]))
    for name, form in FORMS.items():
        own = float(np.median(seconds[name]))
        floor = flops[name] / rates[form.precision] + update
        target = TARGETS.get(name, 0.0)
        print(f"{name:<24}{1e3 * own:>8.0f}{plain / own:>15.2f}{flops[name] / 1e9:>8.1f}"
              f"{1e3 * floor:>10.0f}"
              + (f"  target {target}: {'met' if plain / own >= target else 'MISSED'}"
                 if target else ""))


def _blend_weights(layer: BlendedLinear, x: Tensor, gates: Tensor) -> Tensor:
    weight = torch.einsum("bk,kio->bio", gates, layer.weight)
    return torch.einsum("bi,bio->bo", x, weight) + gates @ layer.bias


def _product_rate(precision: str, n: int = 2048) -> float:
    """Floating-point operations per second of a large matrix product."""
    a = torch.randn(n, n, dtype=torch.bfloat16 if precision == "bf16" else torch.float32)
    return 2 * n**3 / min(_timed(lambda: a @ a) for _ in range(5))


def _bandwidth(n: int = 1 << 26) -> float:
    """Bytes per second, read and written, of a large copy."""
    a, b = torch.zeros(n), torch.zeros(n)
    return 2 * 4 * n / min(_timed(lambda: b.copy_(a)) for _ in range(5))


def _timed(call) -> float:
    began = time.perf_counter()
    call()
    return time.perf_counter() - began
