"""The four networks of Park et al. 2021 (section 6.1, Table 3): stylizer G, style encoder E, mapping F, discriminator D."""

import dataclasses
import os
from dataclasses import dataclass

import torch
from torch import Tensor, nn
from torch.nn import functional

from toolkit.io import model_files
from toolkit.motion import Skeleton
from toolkit.motion.tensors import summary
from toolkit.stylization.data import CHANNELS, FRAMES, Statistics
from toolkit.stylization.graph import POOLINGS, SkeletonGraph
from toolkit.stylization.layers import SLOPE, AdaIN, Block, Lift, Trunk, encoder_blocks, he_init

SHRINK = 2**POOLINGS  # frames per frame of the coarsest level
CALM = 0.3


@dataclass(frozen=True)
class Sizes:
    """How large the networks are; the defaults are the paper's (Table 3)."""

    channels: int = 64  # of the finest level; each pooling doubles them
    code: int = 64  # length of a style code
    latent: int = 16  # length of z
    hidden: int = 512  # of the mapping network; its third layer has twice as many

    def __post_init__(self):
        for name, value in dataclasses.asdict(self).items():
            if not isinstance(value, int) or value < 1:
                raise ValueError(f"sizes: {name} must be a whole number from 1, got {value!r}")

    @classmethod
    def small(cls) -> "Sizes":
        """A fifteenth of the parameters, for a processor."""
        return cls(channels=16, hidden=128)


class Generator(nn.Module):
    """Motion stylizer G (Table 3a): content encoder with IN, decoder with AdaIN; z-scores in and out.

    The skip connections that the paper speaks of are the blocks' shortcuts, which no normalisation touches.
    """

    def __init__(self, graph: SkeletonGraph, sizes: Sizes):
        super().__init__()
        c = sizes.channels
        self.encoder = nn.Sequential(Lift(c), *encoder_blocks(graph, c, "in"))
        self.decoder = nn.ModuleList(Block(c << level + 1, c << level, graph, level, "up", "adain", sizes.code)
                                     for level in reversed(range(POOLINGS)))
        self.lower = nn.Conv2d(c, CHANNELS, 1)

    def encode(self, x: Tensor) -> Tensor:
        """Content ``[B, 4 C, N/4, T/4]`` of ``x [B, 7, T, N]`` (equation 2)."""
        return self.encoder(x)

    def decode(self, content: Tensor, code: Tensor) -> Tensor:
        """Motion ``[B, 7, T, N]`` of content in the style of ``code [B, S]`` (equation 3)."""
        for block in self.decoder:
            content = block(content, code)
        return self.lower(content).transpose(2, 3)

    def forward(self, x: Tensor, code: Tensor) -> Tensor:
        """``x [B, 7, T, N]``, T a multiple of 4, in the style of ``code [B, S]``."""
        return self.decode(self.encode(x), code)


class Summary(nn.Module):
    """Trunk of E and D and the convolution over all that is left of the graph: ``[B, 4 C]`` of z-scores ``[B, 7, T, N]``.

    At T = 64 that convolution has one place, as in Table 3; of a longer motion the mean over its places is taken.
    """

    def __init__(self, graph: SkeletonGraph, sizes: Sizes):
        super().__init__()
        width = sizes.channels << POOLINGS
        self.trunk = Trunk(graph, sizes.channels)
        self.whole = nn.Conv2d(width, width, (graph.sizes[-1], FRAMES // SHRINK))

    def forward(self, x: Tensor) -> Tensor:
        """Features of motions of at least 64 frames."""
        return functional.leaky_relu(self.whole(self.trunk(x)), SLOPE).mean((2, 3))


class StyleEncoder(nn.Module):
    """Style encoder E (Table 3b, equation 5): the style code of a motion, for the domain that it belongs to."""

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
    """Mapping network F (Table 3c, equation 6): a style code of random noise, for the domain asked for."""

    def __init__(self, sizes: Sizes, domains: int):
        super().__init__()
        half = max(1, sizes.hidden // 2)
        self.noise, self.label = nn.Linear(sizes.latent, half), nn.Linear(domains, half)
        self.shared = nn.Sequential(nn.Linear(2 * half, sizes.hidden), nn.ReLU(), nn.Linear(sizes.hidden, 2 * sizes.hidden),
                                    nn.ReLU(), nn.Linear(2 * sizes.hidden, sizes.code), nn.Tanh())

    def forward(self, z: Tensor, domain: Tensor) -> Tensor:
        """``[B, S]`` of noise ``[B, 16]`` and domains ``[B]``."""
        label = functional.one_hot(domain, self.label.in_features).to(z)
        return self.shared(functional.relu(torch.cat((self.noise(z), self.label(label)), -1)))


class Discriminator(nn.Module):
    """Discriminator D (Table 3d): the logit that a motion is a real one of a domain.

    Table 3d lists a last layer from D domains to D domains, which the published code does not have; nor does ours.
    """

    def __init__(self, graph: SkeletonGraph, sizes: Sizes, domains: int):
        super().__init__()
        self.summary = Summary(graph, sizes)
        self.branches = nn.Linear(sizes.channels << POOLINGS, domains)

    def forward(self, x: Tensor, domain: Tensor) -> Tensor:
        """``[B]`` of z-scores ``[B, 7, T, N]`` and domains ``[B]``."""
        return self.branches(self.summary(x)).gather(1, domain[:, None])[:, 0]


class Stylizer(nn.Module):
    """G, E and F with the graph, the statistics and the names of the domains: all that restyling needs.

    `translate`, `code_of` and `code_from` speak physical units; ``generator``, ``encoder`` and ``mapping``, for training,
    z-scores. Make one with `build`.
    """

    def __init__(self, graph: SkeletonGraph, domains: tuple[str, ...], sizes: Sizes, statistics: Statistics):
        super().__init__()
        if len(set(domains)) != len(domains) or not domains:
            raise ValueError(f"domains need one or more different names, got {', '.join(domains) or 'none'}")
        self.graph, self.domains, self.sizes, self.statistics = graph, tuple(domains), sizes, statistics
        self.generator = Generator(graph, sizes)
        self.encoder = StyleEncoder(graph, sizes, len(domains))
        self.mapping = MappingNetwork(sizes, len(domains))

    def __repr__(self) -> str:
        return summary(self, {"domains": self.domains, "joints": len(self.skeleton), "sizes": self.sizes})

    @property
    def skeleton(self) -> Skeleton:
        """The body it moves, without End Sites."""
        return self.graph.skeleton

    def domain(self, name: str | int | Tensor) -> Tensor:
        """Numbers ``[B]`` or ``[1]`` of domains: of a name, of a number, or as they are.

        Raises
        ------
        ValueError
            If the name is unknown.
        """
        if isinstance(name, str):
            if name not in self.domains:
                raise ValueError(f"unknown domain {name!r}; the model has {', '.join(self.domains)}")
            name = self.domains.index(name)
        return torch.as_tensor(name).reshape(-1)

    @torch.no_grad()
    def translate(self, x: Tensor, code: Tensor) -> Tensor:
        """Motions ``[B, 7, T, N]`` in the style of codes ``[B, S]``; T a multiple of 4."""
        if x.dim() != 4 or x.shape[1] != CHANNELS or x.shape[3] != self.graph.sizes[0] or x.shape[2] % SHRINK:
            raise ValueError(f"motions are [B, {CHANNELS}, T, {self.graph.sizes[0]}], T a multiple of {SHRINK}; "
                             f"got {list(x.shape)}")
        return self.statistics.invert(self.generator(self.statistics.apply(x), code.expand(len(x), -1)))

    @torch.no_grad()
    def code_of(self, x: Tensor, domain: str | int | Tensor) -> Tensor:
        """Style codes ``[B, S]`` of motions ``[B, 7, T, N]`` of the domain; at least 64 frames."""
        if x.dim() != 4 or x.shape[2] < FRAMES:
            raise ValueError(f"a style code needs motions [B, 7, T, N] of T >= {FRAMES} frames, got {list(x.shape)}")
        return self.encoder(self.statistics.apply(x), self.domain(domain).expand(len(x)))

    @torch.no_grad()
    def code_from(self, z: Tensor, domain: str | int | Tensor) -> Tensor:
        """Style codes ``[B, S]`` of noise ``[B, 16]`` for the domain."""
        return self.mapping(z, self.domain(domain).expand(len(z)))

    def parts(self) -> tuple[dict[str, Tensor], dict]:
        """Its tensors and its description, as `toolkit.io.model_files` stores them."""
        s = self.skeleton
        body = {"names": s.names, "parents": s.parents, "offsets": s.offsets.tolist(), "roles": s.roles}
        description = {"domains": self.domains, "sizes": dataclasses.asdict(self.sizes), "skeleton": body}
        return {f"stylizer.{k}": v for k, v in self.state_dict().items()}, description

    def save(self, path: str | os.PathLike) -> None:
        """Write weights, statistics, skeleton and names to one safetensors file."""
        tensors, description = self.parts()
        model_files.write(path, tensors, {"stylizer": description})

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Stylizer":
        """Read a stylizer, of `save` or of a training run; a file that holds none is a one-line ValueError."""
        return cls.from_parts(path, *model_files.read(path, "stylizer"))

    @classmethod
    def from_parts(cls, path: str | os.PathLike, tensors: dict[str, Tensor], parts: dict) -> "Stylizer":
        """The stylizer among what `toolkit.io.model_files.read` returned for ``path``."""
        with model_files.intact(path, "the stylizer in it"):
            described = parts["stylizer"]
            graph = SkeletonGraph.of(Skeleton(**described["skeleton"]))
            model = build(graph, tuple(described["domains"]), Sizes(**described["sizes"]))[0]
            own = {k.removeprefix("stylizer."): v for k, v in tensors.items() if k.startswith("stylizer.")}
            model.load_state_dict(own)
        return model.eval()


def build(graph: SkeletonGraph, domains: tuple[str, ...], sizes: Sizes | None = None,
          statistics: Statistics | None = None) -> tuple[Stylizer, Discriminator]:
    """New networks; without statistics z-scores are physical units.

    He-initialised from torch's global generator, with two departures that save iterations. G's last layer starts at zero, so
    that G begins with the mean pose and not with noise, which D would spot before G has learnt anything. Layers that write
    E's codes or read codes start at `CALM` of He's deviation: E's would spread over ±3, F's (by tanh) over less than ±1.
    """
    sizes = sizes or Sizes()
    shape = (CHANNELS, 1, graph.sizes[0])
    stylizer = Stylizer(graph, domains, sizes, statistics or Statistics(torch.zeros(shape), torch.ones(shape)))
    discriminator = Discriminator(graph, sizes, len(domains))
    for network in (stylizer, discriminator):
        he_init(network)
    nn.init.zeros_(stylizer.generator.lower.weight)
    with torch.no_grad():
        for layer in (stylizer.encoder.branches, *(m.affine for m in stylizer.modules() if isinstance(m, AdaIN))):
            layer.weight.mul_(CALM)
    return stylizer, discriminator
