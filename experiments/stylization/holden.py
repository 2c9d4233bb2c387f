"""Baseline of Table 2: motion editing with Gram matrices (Holden, Saito, Komura 2016, section 7.2).

A convolutional autoencoder over time learns hidden units of motion without labels. To restyle a
source, gradient descent changes its hidden units until their Gram matrix (correlations of the
units, independent of time) equals the reference's, with a penalty for the change.

Departures: the decoder has its own weights and unpools by copying, the features are those of Park
et al. 2021 (positions and quaternions, no velocities and contacts), and both terms are means, so
that one weight fits any length.
"""

import math
import time
from collections.abc import Iterator

import torch
from torch import Tensor, nn
from torch.nn import functional
from tqdm.auto import tqdm

from toolkit.features.splits import generator, mix
from toolkit.stylization.data import CHANNELS, Motions, Statistics
from toolkit.stylization.training import Config

HIDDEN, KERNEL = 256, 25  # hidden units; width of a filter in frames
#: Weight of the Gram matrices' distance: with 5 few results change, with 40 content is lost.
STYLE = 20.0
EDITS, STEP = 150, 0.02  # of the editing by gradient descent (Adam)
SPARSITY = 1e-5  # weight of the sum of absolute weights per hidden unit
CORRUPTED = 0.2  # share of the input values that are set to zero in training
RATE, BATCH, ENOUGH = 1e-3, 32, 5000  # of training: Adam's rate, windows, iterations at most


class Holden(nn.Module):
    """Autoencoder [B, 7, T, N] → hidden units [B, H, T/2] → [B, 7, T, N], and their editing."""

    def __init__(self, statistics: Statistics):
        super().__init__()
        features = CHANNELS * statistics.mean.shape[-1]
        self.statistics = statistics
        self.encoder = nn.Conv1d(features, HIDDEN, KERNEL, padding=KERNEL // 2)
        self.decoder = nn.Conv1d(HIDDEN, features, KERNEL, padding=KERNEL // 2)

    def generators(self) -> list[nn.Module]:
        """The parts whose parameters are counted."""
        return [self.encoder, self.decoder]

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
        """Motions [B, 7, T, N] with the content of x and the Gram matrices of code; T is even."""
        content = self.encode(self.statistics.apply(x))
        hidden = content.clone().requires_grad_()
        adam = torch.optim.Adam([hidden], lr=STEP)
        for _ in range(EDITS):
            with torch.enable_grad():
                energy = self.energy(hidden, content, code).sum()
                (hidden.grad,) = torch.autograd.grad(energy, hidden)
            adam.step()
        return self.statistics.invert(self.decode(hidden.relu()))

    def energy(self, hidden: Tensor, content: Tensor, code: Tensor) -> Tensor:
        """Objective [B]: mean squared distances to the content and to the Gram matrices."""
        style = (gram(hidden) - code).square().mean((1, 2))
        return (hidden - content).square().mean((1, 2)) + STYLE * style


def flat(x: Tensor) -> Tensor:
    """[B, C, T, N] as [B, C N, T]: all features of a frame in one vector."""
    return x.transpose(2, 3).flatten(1, 2)


def unflat(x: Tensor, channels: int = CHANNELS) -> Tensor:
    """Inverse of `flat`."""
    return x.unflatten(1, (channels, -1)).transpose(2, 3)


def budget(config: Config, name: str, progress: bool = False) -> Iterator[tuple[int, float]]:
    """Steps and their rates as a share of the first, until iterations or seconds are spent."""
    began, step = time.process_time(), 0
    with tqdm(desc=name, unit="step", disable=not progress) as bar:
        while True:
            spent = (time.process_time() - began) / config.seconds
            done = max(step / config.iterations, spent)
            if done >= 1:
                return
            share = (1 + math.cos(math.pi * done)) / 2
            yield step, config.final_rate + (1 - config.final_rate) * share
            step += 1
            bar.update()


def gram(hidden: Tensor) -> Tensor:
    """Gram matrices [B, H, H] of hidden units [B, H, T]: products of two units, mean over time."""
    return hidden @ hidden.transpose(1, 2) / hidden.shape[-1]


def fit(motions: Motions, config: Config, progress: bool = False) -> Holden:
    """Train the autoencoder to reconstruct motions from a part of their features.

    It uses the time or iterations (at most `ENOUGH`) and the seed of the config, and larger
    batches.
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
            rebuilt = model.decode(model.encode(functional.dropout(real, CORRUPTED)))
            weights = sum(p.abs().sum() for p in model.parameters())
            loss = (rebuilt - real).square().mean() + SPARSITY * weights / HIDDEN
            adam.zero_grad(set_to_none=True)
            loss.backward()
            adam.step()
    return model.eval()
