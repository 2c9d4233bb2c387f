"""Baseline of Table 2: motion editing with Gram matrices (Holden, Saito, Komura 2016, section 7.2).

A convolutional autoencoder over time learns hidden units of motion without labels. To restyle a source, gradient descent
changes its hidden units until their Gram matrix (correlations of the units, independent of time) equals the reference's,
with a penalty for the change.

Departures from that paper: the decoder has its own weights and unpools by copying, the features are those of Park et al.
2021 (positions and quaternions, no velocities and contacts), and both terms are means, so that one weight fits any length.
"""

import math
import time
from collections.abc import Callable, Iterator

import torch
from torch import Tensor, nn
from torch.nn import functional
from tqdm.auto import tqdm

from toolkit.features.splits import generator, mix
from toolkit.stylization.data import CHANNELS, Motions, Statistics
from toolkit.stylization.training import Config

SPARSITY = 1e-5  # weight of the sum of absolute weights per hidden unit
CORRUPTED = 0.2  # share of the input values that are set to zero in training
RATE, BATCH, ENOUGH = 1e-3, 32, 5000  # of training: Adam's rate, windows per iteration, iterations until convergence


class Holden(nn.Module):
    """Autoencoder [B, 7, T, N] → hidden units [B, H, T/2] → [B, 7, T, N], and the editing of hidden units.

    Parameters
    ----------
    statistics
        Mean and deviation, to convert the physical units of the input to z-scores.
    hidden, kernel
        Hidden units H and the width of a filter in frames.
    style_weight
        Weight of the Gram matrices' distance, relative to the hidden units'. Chosen on walks and runs of Bandai, where 5
        changes the style of a quarter of the results, 20 of nearly all, and 40 only loses content.
    steps, rate
        Gradient descent (Adam) of the editing.
    """

    def __init__(self, statistics: Statistics, hidden: int = 256, kernel: int = 25, *, style_weight: float = 20.0,
                 steps: int = 150, rate: float = 0.02):
        super().__init__()
        features = CHANNELS * statistics.mean.shape[-1]
        self.statistics, self.style_weight, self.steps, self.rate = statistics, style_weight, steps, rate
        self.encoder = nn.Conv1d(features, hidden, kernel, padding=kernel // 2)
        self.decoder = nn.Conv1d(hidden, features, kernel, padding=kernel // 2)

    def encode(self, z: Tensor) -> Tensor:
        """Hidden units [B, H, T/2] of z-scores [B, 7, T, N]."""
        return functional.relu(functional.max_pool1d(self.encoder(flat(z)), 2))

    def decode(self, hidden: Tensor) -> Tensor:
        """z-scores [B, 7, T, N] of hidden units [B, H, T/2]."""
        return unflat(self.decoder(hidden.repeat_interleave(2, -1)))

    @torch.no_grad()
    def code_of(self, x: Tensor, domain: Tensor | None = None) -> Tensor:
        """Gram matrices [B, H, H] of references [B, 7, T, N]; the domain is not used."""
        return gram(self.encode(self.statistics.apply(x)))

    @torch.no_grad()
    def translate(self, x: Tensor, code: Tensor) -> Tensor:
        """Motions [B, 7, T, N] with the content of x and the Gram matrices of code; T must be even."""
        content = self.encode(self.statistics.apply(x))
        hidden = content.clone().requires_grad_()
        adam = torch.optim.Adam([hidden], lr=self.rate)
        for _ in range(self.steps):
            with torch.enable_grad():
                (hidden.grad,) = torch.autograd.grad(self.energy(hidden, content, code).sum(), hidden)
            adam.step()
        return self.statistics.invert(self.decode(hidden.relu()))

    def energy(self, hidden: Tensor, content: Tensor, code: Tensor) -> Tensor:
        """Objective [B] of the editing: mean squared distances to the content and to the Gram matrices."""
        return (hidden - content).square().mean((1, 2)) + self.style_weight * (gram(hidden) - code).square().mean((1, 2))


def flat(x: Tensor) -> Tensor:
    """[B, C, T, N] as [B, C N, T]: all features of a frame in one vector."""
    return x.transpose(2, 3).flatten(1, 2)


def unflat(x: Tensor, channels: int = CHANNELS) -> Tensor:
    """Inverse of `flat`."""
    return x.unflatten(1, (channels, -1)).transpose(2, 3)


def budget(config: Config, name: str, progress: bool = False,
           clock: Callable[[], float] = time.process_time) -> Iterator[tuple[int, float]]:
    """Steps and their rates (as a share of the first, on the config's cosine) until its iterations or seconds are spent."""
    began, step = clock(), 0
    with tqdm(desc=name, unit="step", disable=not progress) as bar:
        while (done := max(step / config.iterations, (clock() - began) / config.seconds)) < 1:
            yield step, config.final_rate + (1 - config.final_rate) * (1 + math.cos(math.pi * done)) / 2
            step += 1
            bar.update()


def gram(hidden: Tensor) -> Tensor:
    """Gram matrices [B, H, H] of hidden units [B, H, T]: products of two units, mean over time."""
    return hidden @ hidden.transpose(1, 2) / hidden.shape[-1]


def fit(motions: Motions, config: Config, progress: bool = False) -> Holden:
    """Train the autoencoder to reconstruct motions from a part of their features.

    It uses the time or iterations (at most `ENOUGH`) and the seed of the config, and a larger batch.
    """
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(mix(config.seed, 0))
        model = Holden(motions.statistics())
        draw, z = generator(config.seed, 1), model.statistics.apply(motions.x)
        adam = torch.optim.Adam(model.parameters(), RATE)
        for step, _ in budget(config, "Holden 2016", progress):
            if step == ENOUGH:
                break
            real = z[torch.randint(len(z), (BATCH,), generator=draw)]
            error = (model.decode(model.encode(functional.dropout(real, CORRUPTED))) - real).square().mean()
            loss = error + SPARSITY * sum(p.abs().sum() for p in model.parameters()) / len(model.encoder.bias)
            adam.zero_grad(set_to_none=True)
            loss.backward()
            adam.step()
    return model.eval()
