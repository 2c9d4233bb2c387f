"""Spatial-temporal graph convolutions and the residual blocks made of them (Park et al. 2021, section 5 and Table 3).

Inside the networks a motion is ``[B, C, N, T]``, T contiguous: then each node's time line is one stretch of memory, and
mixing nodes is one matrix product.
"""

import math

import torch
from torch import Tensor, nn
from torch.nn import functional

from toolkit.stylization.graph import POOLINGS, SUBSETS, SkeletonGraph

SLOPE = 0.2  # of the leaky ReLU


class GraphConv(nn.Module):
    """Spatial graph convolution (equation 1): the mean over each of the three subsets, times weights of its own.

    With ``pool`` nodes are pooled in the same product; as all of it is linear, channels can be mixed where nodes are few.
    """

    def __init__(self, inputs: int, outputs: int, graph: SkeletonGraph, level: int, pool: bool = False):
        super().__init__()
        mix = graph.adjacency(level) @ graph.pool(level) if pool else graph.adjacency(level)
        self.register_buffer("mix", mix.transpose(1, 2).flatten(0, 1).contiguous(), persistent=False)  # [3 N', N]
        self.channels = nn.Conv2d(SUBSETS * inputs, outputs, 1)

    def forward(self, x: Tensor) -> Tensor:
        """``[B, outputs, N', T]`` of ``[B, inputs, N, T]``."""
        gathered = self.mix @ x
        return self.channels(gathered.view(len(x), self.channels.in_channels, -1, x.shape[-1]))


class AdaIN(nn.Module):
    """Adaptive instance normalisation (equation 4): (1 + γ) IN(x) + β, with γ and β linear in the style code.

    As METHOD says; equation 4 of the paper prints mean and deviation in each other's place.
    """

    def __init__(self, code: int, channels: int):
        super().__init__()
        self.affine = nn.Linear(code, 2 * channels)

    def forward(self, x: Tensor, code: Tensor) -> Tensor:
        """``x [B, C, N, T]`` in the style of ``code [B, S]``."""
        gamma, beta = self.affine(code)[:, :, None, None].chunk(2, 1)
        return (1 + gamma) * functional.instance_norm(x) + beta


class SpatialTemporal(nn.Module):
    """One ST-GCN unit: graph convolution, resampling, leaky ReLU, temporal convolution of width 3."""

    def __init__(self, inputs: int, outputs: int, graph: SkeletonGraph, level: int, resample: str = ""):
        super().__init__()
        self.resample = Resample(graph, level, resample)
        from_level = level + 1 if resample == "up" else level
        self.spatial = GraphConv(inputs, outputs, graph, from_level, pool=resample == "down")
        self.temporal = nn.Conv2d(outputs, outputs, (1, 3), padding=(0, 1))

    def forward(self, x: Tensor) -> Tensor:
        """``[B, outputs, N', T']`` of ``[B, inputs, N, T]``."""
        x = self.resample.nodes(self.spatial(self.resample.frames_down(x)))
        return self.temporal(functional.leaky_relu(self.resample.frames_up(x), SLOPE))


class Resample(nn.Module):
    """Graph pooling and unpooling (section 5.2) between ``level`` and the next: means down, copies up; in time linear up.

    Samples lie where their time is (the mean of frames 0 and 1 between them), while the published code stretches them to the
    ends; so foot contacts stay in place, and a long clip is restyled as its parts would be.
    """

    def __init__(self, graph: SkeletonGraph, level: int, direction: str):
        super().__init__()
        self.direction = direction
        pooled = {"down": graph.pool, "up": graph.unpool}.get(direction)
        self.register_buffer("matrix", pooled(level).T.contiguous() if pooled else None, persistent=False)

    def nodes(self, x: Tensor) -> Tensor:
        """Nodes copied, on the way up; on the way down `GraphConv` pools them."""
        return self.matrix @ x if self.direction == "up" else x

    def frames_down(self, x: Tensor) -> Tensor:
        """Pairs of frames averaged, on the way down."""
        return functional.avg_pool2d(x, (1, 2)) if self.direction == "down" else x

    def frames_up(self, x: Tensor) -> Tensor:
        """Twice the frames, on the way up."""
        if self.direction != "up":
            return x
        before, after = torch.cat((x[..., :1], x[..., :-1]), -1), torch.cat((x[..., 1:], x[..., -1:]), -1)
        return torch.stack((torch.lerp(x, before, 0.25), torch.lerp(x, after, 0.25)), -1).flatten(-2)

    def forward(self, x: Tensor) -> Tensor:
        """Nodes and frames."""
        if self.direction == "down":
            return self.matrix @ self.frames_down(x)
        return self.frames_up(self.nodes(x))


class Block(nn.Module):
    """Residual block of two ST-GCN units, pre-activation: (shortcut + residual) / √2.

    Parameters
    ----------
    inputs, outputs
        Channels.
    graph, level
        The finer of the two levels it stands between.
    direction
        ``"down"`` (ST-Resblk) or ``"up"`` (ST-AdaINResblk).
    norm
        ``"none"`` (E and D), ``"in"`` (encoder of G) or ``"adain"`` (decoder of G).
    code
        Length of the style code, for ``"adain"``.
    """

    def __init__(self, inputs: int, outputs: int, graph: SkeletonGraph, level: int, direction: str, norm: str = "none",
                 code: int = 0):
        super().__init__()
        coarse = level + 1
        middle, to = (inputs, coarse) if direction == "down" else (outputs, level)
        self.first = SpatialTemporal(inputs, middle, graph, level, direction)
        self.second = SpatialTemporal(middle, outputs, graph, to)
        self.shortcut = nn.Conv2d(inputs, outputs, 1, bias=False)
        self.resample = Resample(graph, level, direction)
        self.norms = nn.ModuleList({"none": lambda c: nn.Identity(), "in": lambda c: nn.InstanceNorm2d(c, affine=True),
                                    "adain": lambda c: AdaIN(code, c)}[norm](c) for c in (inputs, middle))

    def forward(self, x: Tensor, code: Tensor | None = None) -> Tensor:
        """``[B, outputs, N', T']`` of ``[B, inputs, N, T]``."""
        style = () if code is None else (code,)
        residual = self.first(functional.leaky_relu(self.norms[0](x, *style), SLOPE))
        residual = self.second(functional.leaky_relu(self.norms[1](residual, *style), SLOPE))
        down = self.resample.direction == "down"
        shortcut = self.shortcut(self.resample(x)) if down else self.resample(self.shortcut(x))
        return (shortcut + residual) / math.sqrt(2)


class Trunk(nn.Sequential):
    """What E and D share in shape (Table 3b, d): 1×1 convolution and two ST-Resblks, then a leaky ReLU.

    ``[B, 4 C, N/4, T/4]`` of z-scores ``[B, 7, T, N]``.
    """

    def __init__(self, graph: SkeletonGraph, channels: int, norm: str = "none"):
        super().__init__(Lift(channels), *encoder_blocks(graph, channels, norm), nn.LeakyReLU(SLOPE))


class Lift(nn.Conv2d):
    """The first 1×1 convolution, ``[B, C, N, T]`` of z-scores ``[B, 7, T, N]``."""

    def __init__(self, channels: int):
        super().__init__(7, channels, 1)

    def forward(self, x: Tensor) -> Tensor:
        """From the outer layout to the inner one."""
        return super().forward(x.transpose(2, 3))


def encoder_blocks(graph: SkeletonGraph, channels: int, norm: str) -> list[Block]:
    """The ST-Resblks on the way down."""
    return [Block(channels << level, channels << level + 1, graph, level, "down", norm) for level in range(POOLINGS)]


def he_init(network: nn.Module) -> None:
    """He initialisation (appendix A.2); biases start at zero."""
    for layer in network.modules():
        if isinstance(layer, (nn.Conv2d, nn.Linear)):
            nn.init.kaiming_normal_(layer.weight, nonlinearity="relu")
            if layer.bias is not None:
                nn.init.zeros_(layer.bias)
