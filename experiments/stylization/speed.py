"""Processor time of one training iteration, with and without what makes it faster: ``experiments stylization speed``.

The forms take turns, because other work on the machine changes the speed of all. Weights and data do not change it.
"""

import contextlib
import time
from collections.abc import Iterator
from dataclasses import dataclass
from statistics import median
from unittest import mock

import torch
from torch import Tensor
from torch.nn import functional

from toolkit import datasets
from toolkit.stylization import layers, training
from toolkit.stylization.data import build
from toolkit.stylization.networks import Sizes

STYLES, FIRST = ("Neutral", "Zombie"), 2  # of the data; iterations that are not timed


@dataclass(frozen=True)
class Form:
    """Implementation of an iteration: each flag selects the toolkit's way for one part."""

    frozen: bool = True  # networks that are not updated get no gradients; else they do, unused
    slices: bool = True  # pairs of frames are averaged by slices; else by torch's pooling
    products: bool = True  # 1×1 convolutions are matrix products; else torch's convolutions
    lazy: bool = True  # R1 in every fourth iteration; else in every one
    bfloat16: bool = False

    @contextlib.contextmanager
    def chosen(self) -> Iterator[None]:
        """Inside, the stylizer is trained in this way."""
        with contextlib.ExitStack() as stack:
            if not self.frozen:
                stack.enter_context(mock.patch.object(training, "_frozen", return_value=contextlib.nullcontext()))
            if not self.slices:
                stack.enter_context(mock.patch.object(layers, "halved", lambda x: functional.avg_pool2d(x, (1, 2))))
            if not self.products:
                stack.enter_context(mock.patch.object(layers.Pointwise, "forward", _convolve))
            if self.bfloat16:
                stack.enter_context(torch.autocast("cpu", torch.bfloat16))
            yield


FORMS = {"plain": Form(frozen=False, slices=False, products=False, lazy=False),
         "networks that are not updated frozen (exact)": Form(slices=False, products=False, lazy=False),
         "pooling by slices (exact)": Form(products=False, lazy=False),
         "1×1 convolutions as matrix products (exact)": Form(lazy=False),
         "R1 in every fourth iteration: the toolkit's": Form(), "the same in bfloat16": Form(bfloat16=True)}


def _convolve(self: layers.Pointwise, x: Tensor) -> Tensor:
    return functional.conv2d(x, self.weight, self.bias)


def milliseconds(channels: int, iterations: int, repeats: int) -> dict[str, float]:
    """Processor time of an iteration of each form: the median of runs of so many iterations, in turns."""
    motions = build(datasets.load("procedural", styles=STYLES, gaits=["FW", "FR"], seconds=8.0))
    sizes = Sizes(channels=channels, hidden=128, detailed=True)
    times: dict[str, list[float]] = {name: [] for name in FORMS}
    for _ in range(repeats):
        for name, form in FORMS.items():
            config = training.Config.quick(sizes=sizes, warm_up=0, iterations=FIRST + iterations,
                                           r1_every=4 if form.lazy else 1)
            ends: list[float] = []
            with form.chosen():
                training.fit(motions, config, on_step=lambda step, _, ends=ends: ends.append(time.process_time()))
            times[name].append(1000 * (ends[-1] - ends[FIRST - 1]) / iterations)
    return {name: median(found) for name, found in times.items()}
