"""Baseline of Table 2 in its authors' own form: unpaired style transfer (Aberman et al. 2020).

The content is read from rotations, the style from positions, both by 1-D convolutions. Each
convolution of the content encoder is followed by instance normalisation, and one residual block of
the decoder has AdaIN. The output is rotations; forward kinematics gives positions, so bones keep
their lengths. D judges short pieces of motion. Losses: LSGAN with feature matching, triplets of
style codes, and reconstruction of a motion with the style of another of its domain.

Departures: widths for which the generator is about as large as ours, the rates, decay, batch and R1
of our config, no second style encoder for videos and so no joint embedding; D sees positions and
their velocities in the root frame.
"""

import math
import time
from collections.abc import Iterator

import torch
from torch import Tensor, nn
from torch.nn import functional
from tqdm.auto import tqdm

from experiments.stylization.convolutional import flat, unflat
from toolkit.features.splits import generator, mix
from toolkit.motion import Skeleton, rotations as R
from toolkit.stylization import losses, training
from toolkit.stylization.data import FPS, Motions, Statistics
from toolkit.stylization.layers import SLOPE
from toolkit.stylization.training import Config

WIDTHS = (28, 40)  # channels after each of the two halvings of time
KERNEL, STYLE = 5, 64  # frames; length of a style code
MARGIN = 5.0  # of the triplet loss, between the distances to codes of another and of one style
TRIPLET, MATCHING = 0.3, 0.5  # weights; those of adversarial and reconstruction loss are 1


def convolution(inputs: int, outputs: int) -> nn.Conv1d:
    """A convolution that keeps the number of frames."""
    return nn.Conv1d(inputs, outputs, KERNEL, padding="same", padding_mode="replicate")


class Residual(nn.Module):
    """x + two convolutions, each normalised over time; a style code gives means and deviations."""

    def __init__(self, width: int, style: int = 0):
        super().__init__()
        self.convolutions = nn.ModuleList(convolution(width, width) for _ in range(2))
        self.moments = nn.ModuleList(nn.Linear(style, 2 * width) for _ in range(2 * bool(style)))

    def forward(self, x: Tensor, code: Tensor | None = None) -> Tensor:
        """``[B, C, T]`` of ``[B, C, T]``."""
        h = x
        for i, layer in enumerate(self.convolutions):
            h = functional.instance_norm(layer(h))
            if code is not None:
                scale, shift = self.moments[i](code)[..., None].chunk(2, 1)
                h = (1 + scale) * h + shift
            h = h if i else functional.leaky_relu(h, SLOPE)
        return x + h


class Generator(nn.Module):
    """Rotations ``[B, 4 N, T]`` and a style code to rotations ``[B, 4 N, T]``, z-scores."""

    def __init__(self, joints: int):
        super().__init__()
        a, b = WIDTHS
        self.down = nn.ModuleList((convolution(4 * joints, a), convolution(a, b)))
        self.content, self.styled = Residual(b), Residual(b, STYLE)
        self.up = nn.ModuleList((convolution(b, a), convolution(a, 4 * joints)))

    def forward(self, x: Tensor, code: Tensor) -> Tensor:
        """T is a multiple of 4."""
        for layer in self.down:
            x = functional.leaky_relu(functional.instance_norm(layer(x)), SLOPE)
            x = functional.avg_pool1d(x, 2)
        x = self.styled(self.content(x), code)
        for layer in self.up:
            x = functional.interpolate(functional.leaky_relu(x, SLOPE), scale_factor=2.0)
            x = layer(x)
        return x


class Trunk(nn.Module):
    """Two convolutions, each of which halves time: ``[B, C, T/4]``."""

    def __init__(self, inputs: int):
        super().__init__()
        a, b = WIDTHS
        self.layers = nn.ModuleList((convolution(inputs, a), convolution(a, b)))

    def forward(self, x: Tensor) -> Tensor:
        """Of ``[B, C, T]``."""
        for layer in self.layers:
            x = functional.avg_pool1d(functional.leaky_relu(layer(x), SLOPE), 2)
        return x


class Aberman(nn.Module):
    """Generator and style encoder on a skeleton; statistics convert physical units to z-scores."""

    def __init__(self, statistics: Statistics, skeleton: Skeleton):
        super().__init__()
        joints = len(skeleton)
        self.statistics, self.skeleton = statistics, skeleton
        self.generator, self.style = Generator(joints), Trunk(3 * joints)
        self.code = nn.Linear(WIDTHS[-1], STYLE)

    def encode(self, z: Tensor) -> Tensor:
        """Style codes [B, S] of z-scores [B, 7, T, N]: the maximum over time."""
        return self.code(self.style(flat(z[:, :3])).amax(-1))

    def decode(self, x: Tensor, code: Tensor) -> Tensor:
        """Motions [B, 7, T, N] with the content and height of x and style codes, physical units."""
        z = torch.cat((torch.zeros_like(x[:, :3]), self.statistics.apply(x)[:, 3:]), 1)
        made = unflat(self.generator(flat(z[:, 3:]), code), 4)
        turned = self.statistics.invert(torch.cat((z[:, :3], made), 1))[:, 3:]
        return torch.cat((self._positions(turned, x[:, :3, :, :1]), turned), 1)

    def _positions(self, rotations: Tensor, root: Tensor) -> Tensor:
        """Positions [B, 3, T, N] of rotations [B, 4, T, N]; ``root [B, 3, T, 1]``."""
        q, parents = rotations.permute(0, 2, 3, 1), list(self.skeleton.parents)
        bones = R.rotate(q[:, :, parents[1:]], self.skeleton.offsets[1:]).unbind(2)
        places = [root[..., 0].transpose(1, 2)]
        for joint, parent in enumerate(parents[1:]):
            places.append(places[parent] + bones[joint])
        return torch.stack(places, 2).permute(0, 3, 1, 2)

    @torch.no_grad()
    def code_of(self, x: Tensor, domain: Tensor | None = None) -> Tensor:
        """Style codes [B, S] of references [B, 7, T, N]; the domain is not used."""
        return self.encode(self.statistics.apply(x))

    @torch.no_grad()
    def translate(self, x: Tensor, code: Tensor) -> Tensor:
        """`decode`; T must be a multiple of 4."""
        return self.decode(x, code)


class Discriminator(nn.Module):
    """Values ``[B, T/4]`` of pieces of motion, and the mean over time of their features."""

    def __init__(self, joints: int, domains: int):
        super().__init__()
        self.trunk, self.heads = Trunk(6 * joints), nn.Conv1d(WIDTHS[-1], domains, 1)

    def forward(self, z: Tensor, domain: Tensor) -> tuple[Tensor, Tensor]:
        """Of z-scores ``[B, 7, T, N]`` of domains [B]."""
        speed = functional.pad(z[:, :3].diff(dim=2) * FPS / 10, (0, 0, 0, 1))
        h = self.trunk(flat(torch.cat((z[:, :3], speed), 1)))
        return self.heads(h)[torch.arange(len(z)), domain], h.mean(-1)


def budget(config: Config, progress: bool) -> Iterator[tuple[int, float]]:
    """Steps and their rates as a share of the first, until iterations or seconds are spent."""
    began, step = time.process_time(), 0
    with tqdm(desc="Aberman 2020", unit="step", disable=not progress) as bar:
        while True:
            spent = (time.process_time() - began) / config.seconds
            done = max(step / config.iterations, spent)
            if done >= 1:
                return
            share = (1 + math.cos(math.pi * done)) / 2
            yield step, config.final_rate + (1 - config.final_rate) * share
            step += 1
            bar.update()


def fit(motions: Motions, config: Config, progress: bool = False) -> Aberman:
    """Train for the time or the iterations of the config."""
    with torch.random.fork_rng(devices=[]):
        torch.manual_seed(mix(config.seed, 0))
        model = Aberman(motions.statistics(), motions.skeleton)
        discriminator = Discriminator(motions.x.shape[-1], len(motions.domains))
    networks = {"generator": model, "discriminator": discriminator}
    adams = {name: torch.optim.Adam(network.parameters(), config.rates[name], training.BETAS,
                                    fused=True) for name, network in networks.items()}
    domain, draw, statistics = motions.domain, generator(config.seed, 1), model.statistics
    x = statistics.invert(statistics.apply(motions.x))  # every quaternion with the sign of the mean
    members = [(domain == d).nonzero()[:, 0] for d in range(len(motions.domains))]
    for step, rate in budget(config, progress):
        for name, adam in adams.items():
            adam.param_groups[0]["lr"] = rate * config.rates[name]
        rows, others = torch.randint(len(x), (2, config.batch), generator=draw)
        # other motions of the domains of the sources, and of those of the references
        kin, alike = (torch.stack([_one_of(members[d], draw) for d in domain[r]])
                      for r in (rows, others))
        source, reference, target = x[rows], statistics.apply(x[others]), domain[others]
        seen = torch.cat((reference, statistics.apply(x[torch.cat((alike, kin))])))
        wanted, same, own = model.encode(seen).chunk(3)
        made = model.decode(torch.cat((source, source)), torch.cat((wanted, own)))
        fake, rebuilt = map(statistics.apply, made.chunk(2))

        real = reference.requires_grad_(step % config.r1_every == 0)
        values, matched = discriminator(real, target)
        refused = discriminator(fake.detach(), target)[0].square().mean()
        judged = (values - 1).square().mean() + refused
        if real.requires_grad:
            judged = judged + config.r1_every * losses.r1(values.mean(1), real)
        _descend(adams["discriminator"], judged)

        values, found = discriminator(fake, target)
        apart = functional.triplet_margin_loss(wanted, same, own, margin=MARGIN,
                                               reduction="none")
        apart = torch.where(domain[rows] == target, 0.0, apart).mean()
        matching = (found - matched.detach()).abs().mean()
        kept = (rebuilt - statistics.apply(source)).abs().mean()
        loss = (values - 1).square().mean() + kept + TRIPLET * apart + MATCHING * matching
        _descend(adams["generator"], loss)
    return model.eval()


def _one_of(rows: Tensor, draw: torch.Generator) -> Tensor:
    return rows[torch.randint(len(rows), (), generator=draw)]


def _descend(adam: torch.optim.Adam, loss: Tensor) -> None:
    adam.zero_grad(set_to_none=True)
    loss.backward()
    adam.step()
