"""Baseline of Table 2: the same system with 1-D convolutions in place of graph convolutions.

All joints of a frame are one vector, and filters run over time only, as in Aberman et al. 2020.
Everything else is that of `toolkit.stylization`: instance normalisation, AdaIN, a shortcut around
each block, codes by domain from references and noise, losses, recipe. So a difference in the
results is a difference of the networks.
"""

from itertools import pairwise

from torch import Tensor, nn
from torch.nn import functional

from toolkit.stylization import networks
from toolkit.stylization.data import CHANNELS, Statistics
from toolkit.stylization.graph import SkeletonGraph
from toolkit.stylization.layers import SLOPE, AdaIN, Skip, he_init
from toolkit.stylization.networks import Discriminator, Sizes, Stylizer

KERNEL = 5  # frames
SHARES = 2.75, 4, 4.75  # widths as shares of `Sizes.channels`


def flat(x: Tensor) -> Tensor:
    """[B, C, T, N] as [B, C N, T]: all features of a frame in one vector."""
    return x.transpose(2, 3).flatten(1, 2)


def unflat(x: Tensor, channels: int = CHANNELS) -> Tensor:
    """Inverse of `flat`."""
    return x.unflatten(1, (channels, -1)).transpose(2, 3)


def widths(sizes: Sizes) -> tuple[int, int, int]:
    """Channels of the three levels of time, for which G is as large as with graph convolutions."""
    return tuple(round(sizes.channels * share) for share in SHARES)


class Block(nn.Module):
    """Residual block ``[B, C, T]`` → ``[B, C', T]``: (shortcut + residual) / √2.

    The residual is twice: normalise, leaky ReLU, convolve.
    """

    def __init__(self, inputs: int, outputs: int, norm: str = "none", code: int = 0):
        super().__init__()
        made = {"none": lambda c: nn.Identity(), "in": lambda c: nn.InstanceNorm1d(c, affine=True),
                "adain": lambda c: AdaIN(code, c)}[norm]
        self.convolutions = nn.ModuleList(nn.Conv1d(c, outputs, KERNEL, padding="same")
                                          for c in (inputs, outputs))
        self.shortcut = nn.Conv1d(inputs, outputs, 1, bias=False)
        self.norms = nn.ModuleList(made(c) for c in (inputs, outputs))

    def forward(self, x: Tensor, code: Tensor | None = None) -> Tensor:
        """``[B, C', T]`` of ``[B, C, T]``."""
        h = x
        for norm, convolution in zip(self.norms, self.convolutions, strict=True):
            h = norm(h) if code is None else norm(h[:, :, None], code)[:, :, 0]
            h = convolution(functional.leaky_relu(h, SLOPE))
        return (h + self.shortcut(x)) / 2**0.5


class Encoder(nn.Module):
    """1×1 convolution and two blocks, each of which halves time: ``[B, C, T/4]``."""

    def __init__(self, joints: int, sizes: Sizes, norm: str = "none"):
        super().__init__()
        self.enter = nn.Conv1d(CHANNELS * joints, widths(sizes)[0], 1)
        self.blocks = nn.ModuleList(Block(a, b, norm) for a, b in pairwise(widths(sizes)))

    def forward(self, z: Tensor) -> Tensor:
        """Of z-scores ``[B, 7, T, N]``."""
        return self.shrink(self.enter(flat(z)))

    def shrink(self, h: Tensor) -> Tensor:
        """The blocks alone."""
        for block in self.blocks:
            h = functional.avg_pool1d(block(h), 2)
        return h


class Generator(nn.Module):
    """Motion stylizer G: the interface of `toolkit.stylization.networks.Generator`."""

    def __init__(self, joints: int, sizes: Sizes):
        super().__init__()
        self.encoder = Encoder(joints, sizes, "in")
        self.decoder = nn.ModuleList(Block(a, b, "adain", sizes.code)
                                     for a, b in pairwise(widths(sizes)[::-1]))
        self.skip = Skip(sizes.code, widths(sizes)[0]) if sizes.detailed else None
        self.lower = nn.Conv1d(widths(sizes)[0], CHANNELS * joints, 1)

    def encode(self, z: Tensor) -> tuple[Tensor, ...]:
        """Content ``[B, C, 1, T/4]``, and early features."""
        early = self.encoder.enter(flat(z))
        return self.encoder.shrink(early)[:, :, None], early[:, :, None]

    def decode(self, content: tuple[Tensor, ...], code: Tensor) -> Tensor:
        """Motion ``[B, 7, T, N]`` of content in the style of ``code [B, S]``."""
        h, early = content[0][:, :, 0], content[1]
        for block in self.decoder:
            h = block(functional.interpolate(h, scale_factor=2.0, mode="linear"), code)
        if self.skip is not None:
            h = h + self.skip(early, code)[:, :, 0]
        return unflat(self.lower(h))

    def forward(self, z: Tensor, code: Tensor) -> Tensor:
        """``z [B, 7, T, N]``, T a multiple of 4, in the style of ``code [B, S]``."""
        return self.decode(self.encode(z), code)


class Summary(nn.Module):
    """Trunk of E and D: ``[B, 4 C]`` of z-scores ``[B, 7, T, N]``, the mean over the frames."""

    def __init__(self, joints: int, sizes: Sizes):
        super().__init__()
        self.trunk = Encoder(joints, sizes)
        frames = networks.FRAMES // networks.SHRINK
        self.whole = nn.Conv1d(widths(sizes)[-1], sizes.channels << 2, frames)

    def forward(self, z: Tensor) -> Tensor:
        """Features of motions of at least 64 frames."""
        h = self.whole(functional.leaky_relu(self.trunk(z), SLOPE))
        return functional.leaky_relu(h, SLOPE).mean(2)


def build(graph: SkeletonGraph, domains: tuple[str, ...], sizes: Sizes | None = None,
          statistics: Statistics | None = None) -> tuple[Stylizer, Discriminator]:
    """New networks, initialised like those of `toolkit.stylization.networks.build`."""
    stylizer, discriminator = networks.build(graph, domains, sizes, statistics)
    joints, sizes = graph.sizes[0], stylizer.sizes
    stylizer.generator = Generator(joints, sizes)
    stylizer.encoder.summary = Summary(joints, sizes)
    discriminator.summaries = nn.ModuleList(Summary(joints, sizes)
                                            for _ in discriminator.summaries)
    for network in (stylizer.generator, stylizer.encoder.summary, discriminator.summaries):
        he_init(network)
    nn.init.zeros_(stylizer.generator.lower.weight)
    for module in stylizer.generator.modules():
        if isinstance(module, AdaIN | Skip):
            reader = module.affine if isinstance(module, AdaIN) else module.gain
            reader.weight.data.mul_(networks.CODE_GAIN)
    return stylizer, discriminator
