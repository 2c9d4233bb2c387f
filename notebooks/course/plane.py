"""The five losses of Park et al. 2021 on points of the plane: a toy in which each loss can be
switched off.

A motion is a point (x, y). Its content is x. Its style is y: a plain walk has y near -1, a walk of
the target domain has any y of a tall box around 1, and every y there is another version of the
style. A stylizer G moves points of the plain domain into the other one. An encoder E computes a
code from a point, and a mapping network F from noise. The discriminator is replaced by a judge that
is always right: the squared distance of a point from the box of the domain. Like a discriminator,
it judges one result at a time. So it cannot see that all results are equal.

As in `toolkit.stylization.training`, codes come from noise and from references in turn, and codes
of references train G alone. Sources are always plain.
"""

import math
from collections.abc import Sequence
from itertools import pairwise, product

import torch
from torch import Tensor, nn

from toolkit.stylization.losses import LOSSES

MIDDLE = torch.tensor([[0.0, -1.0], [0.0, 1.0]])  # of the boxes: plain domain, target domain
HALF = torch.tensor([[1.0, 0.1], [1.0, 0.6]])  # half of their width and height
WEIGHTS = {"adv": 3.0, "cyc": 2.0, "id": 1.0, "sty": 1.0, "ds": 0.8}
DIVERSE = 0.5  # bound of the diversity loss
HIDDEN, BATCH, RATE = 16, 64, 0.01
NOISES = (-0.8, 0.0, 0.8)  # three codes' noises, for pictures and measures
SWITCHES = tuple(tuple(name for name, on in zip(LOSSES, bits, strict=True) if on)
                 for bits in product((True, False), repeat=len(LOSSES)))  # all 32 sets of losses


class Networks(nn.Module):
    """R small networks with the same sizes, evaluated at once."""

    def __init__(self, runs: int, sizes: Sequence[int], draw: torch.Generator):
        super().__init__()
        self.weights = nn.ParameterList(
            nn.Parameter(torch.randn(runs, a, b, generator=draw) / math.sqrt(a))
            for a, b in pairwise(sizes)
        )
        self.biases = nn.ParameterList(
            nn.Parameter(0.5 * torch.randn(runs, 1, b, generator=draw)) for b in sizes[1:]
        )

    def forward(self, x: Tensor) -> Tensor:
        """``x [R, B, inputs]`` to ``[R, B, outputs]``."""
        for k, (weight, bias) in enumerate(zip(self.weights, self.biases, strict=True)):
            x = torch.baddbmm(bias, torch.tanh(x) if k else x, weight)
        return x


def points(domain: int, places: Tensor) -> Tensor:
    """Points ``[..., 2]`` of a domain, from places ``[..., 2]`` in its box, in [0, 1]."""
    return MIDDLE[domain] + HALF[domain] * (2 * places - 1)


def outside(point: Tensor, domain: int) -> Tensor:
    """Squared distance ``[...]`` of points ``[..., 2]`` from the box of a domain.

    0 for a point that the judge accepts.
    """
    return ((point - MIDDLE[domain]).abs() - HALF[domain]).clamp_min(0.0).square().sum(-1)


class Toy:
    """R stylizers of the plane, one for each set of losses.

    Parameters
    ----------
    losses
        Names of the losses that are on (`LOSSES`), for each stylizer.
    seed
        Of the initial numbers and of all draws.
    """

    def __init__(self, losses: Sequence[Sequence[str]], seed: int = 0):
        self.losses, self.draw = (
            [tuple(names) for names in losses], torch.Generator().manual_seed(seed)
        )
        if unknown := {name for names in self.losses for name in names} - set(LOSSES):
            raise ValueError(
                f"unknown losses {', '.join(sorted(unknown))}; known: {', '.join(LOSSES)}"
            )
        runs = len(self.losses)
        self.generator = Networks(runs, (3, HIDDEN, HIDDEN, 2), self.draw)
        self.encoder = Networks(runs, (2, HIDDEN, 1), self.draw)
        self.mapping = Networks(runs, (1, HIDDEN, 1), self.draw)
        self.weights = {
            name: torch.tensor([WEIGHTS[name] * (name in names) for names in self.losses])
            for name in LOSSES
        }

    def code_of(self, point: Tensor) -> Tensor:
        """Codes ``[R, B, 1]`` of points ``[R, B, 2]`` (E)."""
        return torch.tanh(self.encoder(point))

    def code_from(self, noise: Tensor) -> Tensor:
        """Codes ``[R, B, 1]`` of noise ``[R, B, 1]`` in [-1, 1] (F)."""
        return torch.tanh(self.mapping(noise))

    def restyle(self, point: Tensor, code: Tensor) -> Tensor:
        """Points ``[R, B, 2]`` in the style of codes ``[R, B, 1]`` (G)."""
        return self.generator(torch.cat((point, code), -1))

    def terms(self, x: Tensor, code: Tensor, other: Tensor) -> dict[str, Tensor]:
        """The five losses ``[R]`` of sources ``[R, B, 2]`` and two codes for each.

        Equation 12 subtracts "ds".
        """
        own, fake, second = self.code_of(x), self.restyle(x, code), self.restyle(x, other)
        return {
            "adv": outside(fake, 1).mean(1),
            "cyc": (self.restyle(fake, own) - x).square().sum(-1).mean(1),
            "id": (self.restyle(x, own) - x).square().sum(-1).mean(1),
            "sty": (self.code_of(fake) - code).abs().mean((1, 2)),
            "ds": (fake - second).abs().sum(-1).clamp(max=DIVERSE).mean(1)
        }

    def train(self, steps: int = 800) -> "Toy":
        """Train all stylizers; they share the draws of points and noise."""
        parts = [
            *self.generator.parameters(), *self.encoder.parameters(), *self.mapping.parameters()
        ]
        adam = torch.optim.Adam(parts, RATE)
        for n in range(steps):
            x = self._batch(0)
            if n % 2:
                code, other = (self.code_from(self._noise()) for _ in range(2))
            else:
                code, other = (self.code_of(self._batch(1)).detach() for _ in range(2))
            terms = self.terms(x, code, other)
            loss = sum(
                (-1 if name == "ds" else 1) * self.weights[name] * term
                for name, term in terms.items()
            )
            adam.zero_grad()
            loss.sum().backward()
            adam.step()
        return self

    def _batch(self, domain: int) -> Tensor:
        return points(domain, torch.rand(BATCH, 2, generator=self.draw)).expand(
            len(self.losses), BATCH, 2
        )

    def _noise(self) -> Tensor:
        return (2 * torch.rand(BATCH, 1, generator=self.draw) - 1).expand(
            len(self.losses), BATCH, 1
        )

    @torch.no_grad()
    def results(self, count: int = 24) -> tuple[Tensor, Tensor]:
        """Plain points ``[count, 2]`` from left to right, and their results ``[R, 3, count, 2]``
        for `NOISES`.
        """
        draw = torch.Generator().manual_seed(1)
        places = torch.stack((torch.linspace(0, 1, count), torch.rand(count, generator=draw)), -1)
        x = points(0, places)
        every = x.expand(len(self.losses), count, 2)
        made = [
            self.restyle(every, self.code_from(torch.full((len(self.losses), count, 1), z)))
            for z in NOISES
        ]
        return x, torch.stack(made, 1)

    @torch.no_grad()
    def measures(self) -> dict[str, Tensor]:
        """What each loss is for, ``[R]`` each.

        ``inside``: share of results that the judge accepts (adv); ``content``: correlation of the
        results' x with the source's, without its sign: 1 if the content can be restored, even from
        its mirror image (cyc); ``own``: mean distance of a point from itself in its own style (id);
        ``version``: share of the variance of the references' y that the results reproduce, 1 is all
        (sty); ``spread``: mean distance of the results of two noises (ds).
        """
        x, made = self.results(200)
        runs, every = len(self.losses), x.expand(len(self.losses), 200, 2)
        references = points(1, torch.rand(200, 2, generator=torch.Generator().manual_seed(2)))
        copied = self.restyle(every, self.code_of(references.expand(runs, 200, 2)))[..., 1]
        return {
            "inside": (outside(made, 1) < 0.01).float().mean((1, 2)),
            "content": torch.stack(
                [_correlation(made[:, k, :, 0], x[:, 0]) for k in range(len(NOISES))]
            )
            .abs()
            .mean(0),
            "own": (self.restyle(every, self.code_of(every)) - x).norm(dim=-1).mean(1),
            "version": 1 - (copied - references[:, 1]).square().mean(1) / references[:, 1].var(),
            "spread": (made[:, 0] - made[:, -1]).norm(dim=-1).mean(1),
        }


def _correlation(a: Tensor, b: Tensor) -> Tensor:
    """Correlation of each row of ``[R, N]`` with ``[N]``."""
    a, b = a - a.mean(1, keepdim=True), b - b.mean()
    return (a * b).sum(1) / (a.norm(dim=1) * b.norm()).clamp_min(1e-9)


def riddles(steps: int) -> Toy:
    """Three stylizers without one loss each, of exercise 08a.3."""
    missing = ("ds", "adv", "cyc")
    return Toy([[name for name in LOSSES if name != off] for off in missing], 2).train(steps)
