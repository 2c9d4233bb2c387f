"""Your own style modulation compared with FiLM: python examples/own_modulation.py

A modulation is a torch module with three members. `forward(layer, f, style, x, gates)` returns the
activation of hidden layer 0 or 1. `size` is the length of a style vector. `generator` makes style
vectors from style clips.

The modulation of this example adds a low-rank residual to each hidden layer. All styles share its
directions; each style has its own strengths. The generator sees only the mean and the deviation of
each column of a clip. Data, loss, minibatches, held-out error and runtime are those of the package.
"""

import math
import os

import torch
import torch.nn.functional as F
from torch import nn

import toolkit as tk
from toolkit.features import splits
from toolkit.training import distributed, loop, loss, minibatches

FAST = bool(os.environ.get("TOOLKIT_FAST"))
STEPS, SECONDS = (60, 12.0) if FAST else (1000, 60.0)
TINY = tk.networks.Sizes(hidden=64, film_channels=8, film_kernel=5, film_dense=32, dropout=0.0)
SIZES = TINY if FAST else tk.networks.Sizes.small()


class LowRank(nn.Module):
    """h = ELU(LN(F) + U (c ∘ V x) + β): each style has its own c and β; all styles share U and
    V.
    """

    def __init__(self, layout, hidden, rank=32):
        super().__init__()
        self.widths, self.size = (rank, hidden), 2 * (rank + hidden)
        self.down = nn.ModuleList(nn.Linear(n, rank, bias=False) for n in (layout.n_inputs, hidden))
        self.up = nn.ModuleList(nn.Linear(rank, hidden, bias=False) for _ in range(2))
        self.generator = Statistics(nn.Linear(2 * layout.n_clip, 128), nn.ELU(),
                                    nn.Linear(128, self.size))

    def forward(self, layer, f, style, x, gates):
        """Activation ``[B, hidden]`` of a hidden layer, from its value ``f`` and its inputs
        ``x``.
        """
        strength, shift = style.chunk(2, -1)[layer].split(self.widths, -1)
        return F.elu(tk.networks.layer_norm(f) + self.up[layer](strength * self.down[layer](x))
                     + shift)


class Statistics(nn.Sequential):
    """Style vectors ``[M, D]`` from the means and deviations of normalised clips ``[M, 240, 12
    J]``.
    """

    def forward(self, clips):
        """Dense layers on the mean and the deviation over time."""
        return super().forward(torch.cat((clips.mean(1), clips.std(1)), -1))


def train(model):
    """Train a model; returns its bank of style vectors and the held-out error of each style."""
    fabric, adam = distributed.start(CONFIG), loop.optimiser(model, CONFIG)
    objective = fabric.setup_module(distributed.Objective(model.train(), CONFIG.bone_weight, 0, 1))
    for number in range(STEPS):
        rate = CONFIG.rate * (1 + math.cos(math.pi * number / STEPS)) / 2
        loop.step(fabric, objective, adam, BATCHES, CONFIG, number, rate)
    bank = loss.make_bank(model.eval(), TRAINED_ON)
    return bank, {style: e["mse"] for style, e in loss.evaluate(model, bank, HELD_OUT).items()}


CONFIG = tk.training.Config.quick(steps=STEPS, sizes=SIZES)
takes = tk.datasets.load("procedural", styles=("Neutral", "Zombie", "Aeroplane"), gaits="FW",
                         seconds=SECONDS)
data = tk.features.build(takes)
TRAINED_ON, HELD_OUT = splits.split(data, CONFIG.held_out, CONFIG.seed, tuple(data.styles))
BATCHES = minibatches.Minibatches(TRAINED_ON, CONFIG.batch, CONFIG.clips_per_batch, CONFIG.seed,
                                  CONFIG.pose_mixup)

errors, clips = {}, {}
for name in ("lpn-film", "lpn-lowrank"):
    torch.manual_seed(0)
    statistics = tk.networks.normalisers("lpn-film", TRAINED_ON)
    model = tk.networks.build("lpn-film", data.layout, len(data.styles), SIZES, statistics)
    if name == "lpn-lowrank":
        model.modulation, model.name = LowRank(data.layout, SIZES.hidden), name
    bank, errors[name] = train(model)
    clips[name] = tk.runtime.rollout(model, tk.runtime.straight(1.0, 6.0), bank["Zombie"])
    count = sum(p.numel() for p in model.modulation.parameters())
    print(f"{name}: style modulation of {count:,} parameters, {model.style_size} numbers a style")
    print("  held-out error "
          + ", ".join(f"{style} {error:.3f}" for style, error in errors[name].items()))
    print(f"  a zombie asked for 1 m/s walks at {tk.metrics.speed(clips[name]):.2f} m/s")
