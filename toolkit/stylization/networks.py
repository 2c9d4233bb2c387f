"""The four networks of Park et al. 2021 (section 6.1, Table 3): G, E, F and D."""

import os
from dataclasses import asdict, dataclass
from pathlib import Path

import torch
from torch import Tensor, nn
from torch.nn import functional

from toolkit.io import model_files
from toolkit.motion import Skeleton
from toolkit.motion.tensors import summary
from toolkit.motion.text import checked
from toolkit.stylization.data import CHANNELS, FRAMES, Statistics
from toolkit.stylization.graph import POOLINGS, SkeletonGraph
from toolkit.stylization.layers import SLOPE, AdaIN, Block, PerJoint, Skip, encoder, he_init

SHRINK = 2**POOLINGS  # frames per frame of the coarsest level
GAINS = 0.4, 2.5  # least and largest ratio of amplitudes in `Stylizer.shift`
CODE_GAIN = 0.3  # share of He's deviation for layers that write or read style codes


@dataclass(frozen=True)
class Sizes:
    """Sizes of the networks; the defaults are the paper's (Table 3)."""

    channels: int = 64  # of the finest level; each pooling doubles them
    code: int = 64  # length of a style code
    latent: int = 16  # length of z
    hidden: int = 512  # of the mapping network; its third layer has twice as many
    detailed: bool = False  # departures from Table 3 in G and D

    def __post_init__(self):
        for name in ("channels", "code", "latent", "hidden"):
            value = getattr(self, name)
            if type(value) is not int or value < 1:
                raise ValueError(f"sizes: {name} must be a whole number from 1, got {value!r}")

    @classmethod
    def small(cls) -> "Sizes":
        """A tenth of the parameters, for training on a CPU."""
        return cls(channels=16, hidden=128, detailed=True)


class Generator(nn.Module):
    """Motion stylizer G (Table 3a): content encoder with IN, decoder with AdaIN; z-scores.

    In Table 3, the skip connections of the text are the shortcuts of the blocks, which have no
    normalisation. Unpooling makes the joints of a body part equal, and shared weights can hardly
    part them again. So a `Sizes.detailed` generator departs: `Skip` adds the features of the first
    layer before the last one, which has weights for every joint, and so has each AdaIN.
    """

    def __init__(self, graph: SkeletonGraph, sizes: Sizes):
        super().__init__()
        c = sizes.channels
        self.encoder = encoder(graph, c, "in")
        norm = "adain per node" if sizes.detailed else "adain"
        self.decoder = nn.ModuleList(
            Block(c << level + 1, c << level, graph, level, "up", norm, sizes.code)
            for level in reversed(range(POOLINGS)))
        self.skip = Skip(sizes.code, c) if sizes.detailed else None
        self.lower = (PerJoint(c, CHANNELS, graph.sizes[0]) if sizes.detailed
                      else nn.Conv2d(c, CHANNELS, 1))

    def encode(self, x: Tensor) -> tuple[Tensor, ...]:
        """Content ``[B, 4 C, N/4, T/4]`` of ``x [B, 7, T, N]`` (equation 2).

        Beside it, what a detailed decoder needs: features of the first layer.
        """
        early = self.encoder[0](x.transpose(2, 3))
        return self.encoder[1:](early), early

    def decode(self, content: tuple[Tensor, ...], code: Tensor) -> Tensor:
        """Motion ``[B, 7, T, N]`` of content in the style of ``code [B, S]`` (equation 3)."""
        made, early = content
        for block in self.decoder:
            made = block(made, code)
        if self.skip is not None:
            made = made + self.skip(early, code)
        return self.lower(made).transpose(2, 3)

    def forward(self, x: Tensor, code: Tensor) -> Tensor:
        """``x [B, 7, T, N]``, T a multiple of 4, in the style of ``code [B, S]``."""
        return self.decode(self.encode(x), code)


class Summary(nn.Module):
    """An `encoder` and a convolution over the whole pooled graph, of E and D.

    At T = 64 this convolution has one output frame, as in Table 3; a longer motion gives the mean
    over its output frames.
    """

    def __init__(self, graph: SkeletonGraph, sizes: Sizes):
        super().__init__()
        width = sizes.channels << POOLINGS
        self.trunk = encoder(graph, sizes.channels)
        self.whole = nn.Conv2d(width, width, (graph.sizes[-1], FRAMES // SHRINK))

    def forward(self, x: Tensor) -> Tensor:
        """Features ``[B, 4 C]`` of z-scores ``[B, 7, T, N]`` of at least 64 frames."""
        h = functional.leaky_relu(self.trunk(x.transpose(2, 3)), SLOPE)
        return functional.leaky_relu(self.whole(h), SLOPE).mean((2, 3))


class StyleEncoder(nn.Module):
    """Style encoder E (Table 3b, equation 5): the style code of a motion of a given domain."""

    def __init__(self, graph: SkeletonGraph, sizes: Sizes, domains: int):
        super().__init__()
        self.summary = Summary(graph, sizes)
        self.branches = nn.Linear(sizes.channels << POOLINGS, sizes.code * domains)
        self.domains = domains

    def forward(self, x: Tensor, domain: Tensor) -> Tensor:
        """``[B, S]`` of z-scores ``[B, 7, T, N]`` and domains ``[B]``."""
        codes = self.branches(self.summary(x)).view(len(x), self.domains, -1)
        return codes[torch.arange(len(x), device=x.device), domain]


class MappingNetwork(nn.Module):
    """Mapping network F (Table 3c, equation 6): a style code of a domain from random noise.

    Departure: Table 3c has a ReLU before the tanh, with which no number of a code is negative. The
    published code does not have it.
    """

    def __init__(self, sizes: Sizes, domains: int):
        super().__init__()
        hidden, half = sizes.hidden, max(1, sizes.hidden // 2)
        self.noise, self.label = nn.Linear(sizes.latent, half), nn.Linear(domains, half)
        self.shared = nn.Sequential(
            nn.Linear(2 * half, hidden), nn.ReLU(), nn.Linear(hidden, 2 * hidden), nn.ReLU(),
            nn.Linear(2 * hidden, sizes.code), nn.Tanh())

    def forward(self, z: Tensor, domain: Tensor) -> Tensor:
        """``[B, S]`` of noise ``[B, 16]`` and domains ``[B]``."""
        label = functional.one_hot(domain, self.label.in_features).to(z)
        return self.shared(functional.relu(torch.cat((self.noise(z), self.label(label)), -1)))


class Discriminator(nn.Module):
    """Discriminator D (Table 3d): the logit that a motion is a real motion of a domain.

    Table 3d lists a last layer from D domains to D domains. The published code does not have it,
    and neither does this one. With `Sizes.detailed`, D departs from the table: it also sees the
    motion without its mean over time, so that a posture alone does not satisfy it.
    """

    def __init__(self, graph: SkeletonGraph, sizes: Sizes, domains: int):
        super().__init__()
        self.summaries = nn.ModuleList(Summary(graph, sizes) for _ in range(1 + sizes.detailed))
        self.branches = nn.Linear(len(self.summaries) * (sizes.channels << POOLINGS), domains)

    def forward(self, x: Tensor, domain: Tensor) -> Tensor:
        """``[B]`` of z-scores ``[B, 7, T, N]`` and domains ``[B]``."""
        # without `Sizes.detailed` there is one summary, of x itself
        seen = zip(self.summaries, (x, x - x.mean(2, keepdim=True)), strict=False)
        features = torch.cat([summary(motion) for summary, motion in seen], -1)
        return self.branches(features).gather(1, domain[:, None])[:, 0]


class Stylizer(nn.Module):
    """G, E and F with graph, statistics and names of the domains: a whole model, made by `build`.

    `translate`, `code_of` and `code_from` use physical units; ``generator``, ``encoder`` and
    ``mapping`` use z-scores.
    """

    def __init__(self, graph: SkeletonGraph, domains: tuple[str, ...], sizes: Sizes,
                 statistics: Statistics):
        super().__init__()
        if not domains:
            raise ValueError("a stylizer needs one domain or more, got none")
        self.graph, self.domains = graph, checked(domains, "a domain")
        self.sizes, self.statistics = sizes, statistics
        self.generator = Generator(graph, sizes)
        self.encoder = StyleEncoder(graph, sizes, len(domains))
        self.mapping = MappingNetwork(sizes, len(domains))

    def __repr__(self) -> str:
        about = {"domains": self.domains, "joints": len(self.skeleton)}
        return summary(self, about | asdict(self.sizes))

    @property
    def skeleton(self) -> Skeleton:
        """The skeleton of its motions, without End Sites."""
        return self.graph.skeleton

    def domain(self, name: str | int | Tensor) -> Tensor:
        """Indices ``[B]`` or ``[1]`` of domains, from a name, an index or indices."""
        if isinstance(name, str):
            if name not in self.domains:
                raise ValueError(f"unknown domain {name!r}; "
                                 f"the model has {', '.join(self.domains)}")
            name = self.domains.index(name)
        return torch.as_tensor(name).reshape(-1)

    @torch.no_grad()
    def translate(self, x: Tensor, code: Tensor) -> Tensor:
        """Motions ``[B, 7, T, N]`` in the style of codes ``[B, S]``; T a multiple of 4."""
        joints = self.graph.sizes[0]
        known = x.dim() == 4 and x.shape[1] == CHANNELS and x.shape[3] == joints
        if not known or x.shape[2] % SHRINK:
            raise ValueError(f"motions are [B, {CHANNELS}, T, {joints}], T a multiple of {SHRINK}; "
                             f"got {list(x.shape)}")
        made = self.generator(self.statistics.apply(x), code.expand(len(x), -1))
        return self.statistics.invert(made)

    @torch.no_grad()
    def shift(self, x: Tensor, source: str | int | Tensor, target: str | int | Tensor) -> Tensor:
        """Motions ``[B, 7, T, N]`` with the mean pose and the amplitude of another domain.

        No network: the difference of the mean poses of two domains is added, and the deviation of
        each number from its mean over time is scaled by the ratio of `Statistics.amplitudes`.
        """
        source, target, known = self.domain(source), self.domain(target), self.statistics
        z = known.apply(x)
        pose, amplitudes = z.mean(2, keepdim=True), known.amplitudes.clamp_min(1e-3)
        gain = (amplitudes[target] / amplitudes[source]).clamp(*GAINS)
        moved = pose + known.poses[target] - known.poses[source]
        return known.invert((z - pose) * gain + moved)

    @torch.no_grad()
    def code_of(self, x: Tensor, domain: str | int | Tensor) -> Tensor:
        """Style codes ``[B, S]`` of motions ``[B, 7, T, N]`` of the domain; at least 64 frames."""
        if x.dim() != 4 or x.shape[2] < FRAMES:
            raise ValueError(f"a style code needs motions [B, 7, T, N] of T >= {FRAMES} frames, "
                             f"got {list(x.shape)}")
        return self.encoder(self.statistics.apply(x), self.domain(domain).expand(len(x)))

    @torch.no_grad()
    def code_from(self, z: Tensor, domain: str | int | Tensor) -> Tensor:
        """Style codes ``[B, S]`` of noise ``[B, 16]`` for the domain."""
        return self.mapping(z, self.domain(domain).expand(len(z)))

    def save(self, path: str | os.PathLike, *, slim: bool = False) -> None:
        """Write the whole model to one safetensors file; ``slim`` weights have 16 bits."""
        tensors = {f"stylizer.{k}": v.half() if slim and not k.startswith("statistics.") else v
                   for k, v in self.state_dict().items()}
        description = {"domains": self.domains, "sizes": asdict(self.sizes),
                       "skeleton": self.skeleton.to_dict()}
        model_files.write(path, tensors, {"stylizer": description})

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Stylizer":
        """Read a stylizer from a file of `save`; ValueError for another."""
        tensors, parts = model_files.read(path, "stylizer")
        if "stylizer.statistics.amplitudes" not in tensors:
            raise ValueError(f"{path}: it has no amplitudes, as stylizers of older versions: "
                             "train it again")
        with model_files.intact(path, "the stylizer in it"):
            described = parts["stylizer"]
            graph = SkeletonGraph.of(Skeleton(**described["skeleton"]))
            domains, sizes = described["domains"], Sizes(**described["sizes"])
            return model_files.restore(
                lambda: cls(graph, domains, sizes, _none(graph, domains)), tensors, "stylizer.")


def _none(graph: SkeletonGraph, domains: tuple[str, ...]) -> Statistics:
    """Statistics with which z-scores are physical units."""
    shape = (CHANNELS, 1, graph.sizes[0])
    return Statistics(torch.zeros(shape), torch.ones(shape), len(domains))


def pretrained() -> Stylizer:
    """The small stylizer in the package, of procedural clips (`docs/embedded_model.md`)."""
    return Stylizer.load(Path(__file__).with_name("stylizer.safetensors"))


def build(graph: SkeletonGraph, domains: tuple[str, ...], sizes: Sizes | None = None,
          statistics: Statistics | None = None) -> tuple[Stylizer, Discriminator]:
    """New networks; without statistics z-scores are physical units.

    Weights are drawn from torch's global generator (He initialisation), with two departures. The
    last layer of G starts at zero: the first outputs are the mean pose, not noise that D would
    reject. The last layer of E and the layers that read codes start at `CODE_GAIN` of He's
    deviation: otherwise E's codes would spread over ±3, while F's stay within ±1.
    """
    sizes = sizes or Sizes()
    stylizer = Stylizer(graph, domains, sizes, statistics or _none(graph, domains))
    discriminator = Discriminator(graph, sizes, len(domains))
    he_init(stylizer)
    he_init(discriminator)
    nn.init.zeros_(stylizer.generator.lower.weight)
    weak = [stylizer.encoder.branches]
    for module in stylizer.modules():
        if isinstance(module, AdaIN | Skip):
            weak.append(module.affine if isinstance(module, AdaIN) else module.gain)
    with torch.no_grad():
        for layer in weak:
            layer.weight.mul_(CODE_GAIN)
    return stylizer, discriminator
