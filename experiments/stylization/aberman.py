"""Baseline of Table 2: unpaired style transfer by AdaIN over 1-D convolutions (Aberman et al. 2020).

All joints of a frame are one vector; filters run over time only. A content encoder with instance normalisation removes the
style, a style encoder keeps it, and a decoder applies it as the means and deviations of its channels.

Departures from that paper: both encoders read the features of Park et al. 2021 (there: rotations for the content, positions
for the style, and a second style encoder for videos, which is not needed here). Loss, R1, batch, learning rates and weights
are those of `toolkit.stylization`, so that the two systems differ only in their networks.
"""

from itertools import pairwise

import torch
from torch import Tensor, nn
from torch.nn import functional
from torch.optim.lr_scheduler import CosineAnnealingLR
from tqdm.auto import trange

from experiments.stylization.holden import flat, unflat
from toolkit.features.splits import generator, mix
from toolkit.stylization import losses
from toolkit.stylization.data import CHANNELS, Motions, Statistics
from toolkit.stylization.training import Config

WIDTHS = (96, 144, 192)  # channels after the first layer and after each of the two halvings of time
KERNEL = 7  # frames
MARGIN = 5.0  # of the triplet loss: least difference of the distances to codes of another and of the same style


class Block(nn.Module):
    """Residual block [B, C, T] → [B, C', T]: normalise, leaky ReLU, convolve, twice.

    ``norm`` is None, ``"instance"``, or the length of a style code that gives the means and deviations.
    """

    def __init__(self, inputs: int, outputs: int, norm: int | str | None = None):
        super().__init__()
        self.norm = norm
        self.convolutions = nn.ModuleList(nn.Conv1d(width, outputs, KERNEL, padding="same") for width in (inputs, outputs))
        self.across = nn.Conv1d(inputs, outputs, 1, bias=False)
        if isinstance(norm, int):
            self.moments = nn.ModuleList(nn.Linear(norm, 2 * width) for width in (inputs, outputs))

    def forward(self, x: Tensor, code: Tensor | None = None) -> Tensor:
        """``[B, C', T]`` of ``[B, C, T]``."""
        skip = self.across(x)
        for i, convolution in enumerate(self.convolutions):
            x = x if self.norm is None else functional.instance_norm(x)
            if code is not None:
                scale, shift = self.moments[i](code)[..., None].chunk(2, 1)
                x = (1 + scale) * x + shift
            x = convolution(functional.leaky_relu(x, 0.2))
        return (x + skip) / 2**0.5


class Encoder(nn.Module):
    """Convolution over time and two blocks that halve it: [B, 7 N, T] → [B, 192, T/4]."""

    def __init__(self, features: int, norm: str | None = None):
        super().__init__()
        self.enter = nn.Conv1d(features, WIDTHS[0], KERNEL, padding="same")
        self.blocks = nn.ModuleList(Block(a, b, norm) for a, b in pairwise(WIDTHS))

    def forward(self, x: Tensor) -> Tensor:
        """``[B, 192, T/4]`` of ``[B, 7 N, T]``."""
        x = self.enter(x)
        for block in self.blocks:
            x = functional.avg_pool1d(block(x), 2)
        return functional.leaky_relu(x, 0.2)


class Aberman(nn.Module):
    """Content encoder, style encoder and decoder.

    Parameters
    ----------
    statistics
        Mean and deviation, to convert the physical units of the input to z-scores.
    style
        Length S of a style code.
    """

    def __init__(self, statistics: Statistics, style: int = 64):
        super().__init__()
        features = CHANNELS * statistics.mean.shape[-1]
        self.statistics = statistics
        self.content, self.style = Encoder(features, "instance"), Encoder(features)
        self.code = nn.Linear(WIDTHS[-1], style)
        self.decoder = nn.ModuleList(Block(a, b, style) for a, b in pairwise(WIDTHS[::-1]))
        self.leave = nn.Conv1d(WIDTHS[0], features, KERNEL, padding="same")

    def encode(self, z: Tensor) -> Tensor:
        """Style codes [B, S] of z-scores [B, 7, T, N] of any length: the maximum over time."""
        return self.code(self.style(flat(z)).amax(-1))

    def decode(self, z: Tensor, code: Tensor) -> Tensor:
        """z-scores [B, 7, T, N] with the content of z and style codes."""
        h = self.content(flat(z))
        for block in self.decoder:
            h = block(functional.interpolate(h, scale_factor=2.0, mode="linear"), code)
        return unflat(self.leave(functional.leaky_relu(h, 0.2)))

    def code_of(self, x: Tensor, domain: Tensor | None = None) -> Tensor:
        """Style codes [B, S] of references [B, 7, T, N]; the domain is not used."""
        return self.encode(self.statistics.apply(x))

    def translate(self, x: Tensor, code: Tensor) -> Tensor:
        """Motions [B, 7, T, N] with the content of x in the style of the codes; T must be a multiple of 4."""
        return self.statistics.invert(self.decode(self.statistics.apply(x), code))


class Discriminator(nn.Module):
    """Logits [B] that z-scores [B, 7, T, N] are real motions of domains [B]."""

    def __init__(self, joints: int, domains: int):
        super().__init__()
        self.trunk, self.heads = Encoder(CHANNELS * joints), nn.Linear(WIDTHS[-1], domains)

    def forward(self, z: Tensor, domain: Tensor) -> Tensor:
        """``[B]``."""
        return self.heads(self.trunk(flat(z)).mean(-1)).gather(1, domain[:, None])[:, 0]


def fit(motions: Motions, config: Config, progress: bool = False) -> Aberman:
    """Train by adversarial, content and triplet losses (that paper's section 3.3).

    It uses the iterations, batch, seed and betas of the config, the rates of generator and discriminator with their decay,
    and the weights ``adv``, ``r1``, and ``id`` for the content loss.
    """
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(mix(config.seed, 0))
        model = Aberman(motions.statistics())
        discriminator = Discriminator(motions.x.shape[-1], len(motions.domains))
    adams = [torch.optim.Adam(network.parameters(), config.rates[name], config.betas)
             for network, name in ((model, "generator"), (discriminator, "discriminator"))]
    decays = [CosineAnnealingLR(adam, config.iterations, config.final_rate * adam.defaults["lr"]) for adam in adams]
    z, domain, draw, weights = model.statistics.apply(motions.x), motions.domain, generator(config.seed, 1), config.weights
    members = [(domain == d).nonzero()[:, 0] for d in range(len(motions.domains))]
    for _ in trange(config.iterations, desc="Aberman 2020", disable=not progress):
        rows, others = torch.randint(len(z), (2, config.batch), generator=draw)
        kin = torch.stack([_one_of(members[d], draw) for d in domain[others]])  # other references of the same style
        source, reference, target = z[rows], z[others], domain[others]
        wanted, alike, own = model.encode(torch.cat((reference, z[kin], source))).chunk(3)
        fake, same = model.decode(torch.cat((source, source)), torch.cat((wanted, own))).chunk(2)

        real = reference.clone().requires_grad_()
        logits = discriminator(real, target)
        adversarial = losses.discriminator(logits, discriminator(fake.detach(), target))
        _descend(adams[1], adversarial + weights["r1"] * losses.r1(logits, real))

        apart = functional.triplet_margin_loss(wanted, alike, own, margin=MARGIN, reduction="none")
        apart = torch.where(domain[rows] == target, 0.0, apart).mean()
        fooled = weights["adv"] * losses.adversarial(discriminator(fake, target))
        _descend(adams[0], fooled + weights["id"] * losses.content(source, same) + apart)
        for decay in decays:
            decay.step()
    return model.eval()


def _one_of(rows: Tensor, draw: torch.Generator) -> Tensor:
    return rows[torch.randint(len(rows), (), generator=draw)]


def _descend(adam: torch.optim.Adam, loss: Tensor) -> None:
    adam.zero_grad(set_to_none=True)
    loss.backward()
    adam.step()
