"""Spatial-temporal graph convolutions and residual blocks (Park et al. 2021, section 5, Table 3).

The networks store a motion as ``[B, C, N, T]``: the frames of a node are contiguous, and one matrix
product mixes nodes.
"""

import math
from functools import partial

import torch
from torch import Tensor, nn
from torch.nn import functional

from toolkit.stylization.graph import POOLINGS, SUBSETS, SkeletonGraph

SLOPE = 0.2  # of the leaky ReLU


class PerJoint(nn.Module):
    """Linear layer with weights of its own for every joint."""

    def __init__(self, inputs: int, outputs: int, joints: int):
        super().__init__()
        self.weight = nn.Parameter(torch.zeros(joints, outputs, inputs))
        self.bias = nn.Parameter(torch.zeros(outputs, joints, 1))

    def forward(self, x: Tensor) -> Tensor:
        """``[B, outputs, N, T]`` of ``[B, inputs, N, T]``: one matrix product per joint."""
        batch, _, joints, frames = x.shape
        made = self.weight @ x.permute(2, 1, 0, 3).reshape(joints, -1, batch * frames)
        return made.view(joints, -1, batch, frames).permute(2, 1, 0, 3) + self.bias


class Skip(nn.Module):
    """Early features for a decoder, without their mean over time; a style code scales each channel.

    It keeps the details of a movement. The mean pose, which holds much of the style, is left out.
    """

    def __init__(self, code: int, channels: int):
        super().__init__()
        self.gain = nn.Linear(code, channels)

    def forward(self, early: Tensor, code: Tensor) -> Tensor:
        """``[B, C, N, T]`` of ``early [B, C, N, T]`` and codes ``[B, S]``."""
        moved = early - early.mean(-1, keepdim=True)
        return (1 + self.gain(code)[:, :, None, None]) * moved


class GraphConv(nn.Module):
    """Spatial graph convolution (equation 1): the mean over each of three subsets, with weights.

    With ``pool`` the same product pools the nodes.
    """

    def __init__(self, inputs: int, outputs: int, graph: SkeletonGraph, level: int,
                 pool: bool = False):
        super().__init__()
        mix = graph.adjacency(level) @ graph.pool(level) if pool else graph.adjacency(level)
        mix = mix.transpose(1, 2).flatten(0, 1).contiguous()  # [3 N', N]
        self.register_buffer("mix", mix, persistent=False)
        self.channels = nn.Conv2d(SUBSETS * inputs, outputs, 1)

    def forward(self, x: Tensor) -> Tensor:
        """``[B, outputs, N', T]`` of ``[B, inputs, N, T]``."""
        gathered = (self.mix @ x).view(len(x), self.channels.in_channels, -1, x.shape[-1])
        return self.channels(gathered)


class AdaIN(nn.Module):
    """Adaptive instance normalisation (equation 4): (1 + γ) IN(x) + β, linear in the style code.

    In equation 4, σ is the mean and μ the variance. We divide by the deviation, as is usual. With
    several ``nodes`` each node is normalised over time alone and has its own γ and β (departure):
    so a style sets how each body part is held, and how far it moves.
    """

    def __init__(self, code: int, channels: int, nodes: int = 1):
        super().__init__()
        self.nodes = nodes
        self.affine = nn.Linear(code, 2 * channels * nodes)

    def forward(self, x: Tensor, code: Tensor) -> Tensor:
        """``x [B, C, N, T]`` in the style of ``code [B, S]``."""
        gamma, beta = self.affine(code).view(len(code), 2, -1, self.nodes, 1).unbind(1)
        together = x.shape[3:] if self.nodes > 1 else x.shape[2:]
        return (1 + gamma) * functional.layer_norm(x, together) + beta


class Resample(nn.Module):
    """Graph pooling ("down") and unpooling ("up") between ``level`` and the next (section 5.2).

    Down, nodes and pairs of frames are averaged. Up, nodes are copied and frames interpolated
    linearly, a coarse one at the time of its two. The published code stretches them to the ends;
    here contacts keep their times and a long clip is restyled like its parts.
    """

    def __init__(self, graph: SkeletonGraph, level: int, direction: str):
        super().__init__()
        self.down = direction == "down"
        matrix = graph.pool(level) if self.down else graph.unpool(level)
        self.register_buffer("matrix", matrix.T.contiguous(), persistent=False)

    def forward(self, x: Tensor) -> Tensor:
        """``[B, C, N', T']`` of ``[B, C, N, T]``."""
        if self.down:
            return self.matrix @ functional.avg_pool2d(x, (1, 2))
        # a coarse frame stands for two fine ones, a quarter of its length before and after it
        return functional.interpolate(self.matrix @ x, scale_factor=(1.0, 2.0), mode="bilinear")


class SpatialTemporal(nn.Module):
    """ST-GCN unit: graph convolution, resampling, leaky ReLU, temporal convolution of width 3."""

    def __init__(self, inputs: int, outputs: int, graph: SkeletonGraph, level: int,
                 direction: str = ""):
        super().__init__()
        self.down, up = direction == "down", direction == "up"
        # at the coarser level; unpooling comes after it
        self.spatial = GraphConv(inputs, outputs, graph, level + up, pool=self.down)
        self.after = Resample(graph, level, "up") if up else nn.Identity()
        self.temporal = nn.Conv2d(outputs, outputs, (1, 3), padding=(0, 1))

    def forward(self, x: Tensor) -> Tensor:
        """``[B, outputs, N', T']`` of ``[B, inputs, N, T]``."""
        if self.down:
            x = functional.avg_pool2d(x, (1, 2))  # the graph convolution pools the nodes
        x = self.spatial(x)
        return self.temporal(functional.leaky_relu(self.after(x), SLOPE))


class Block(nn.Module):
    """Residual block of two ST-GCN units, pre-activation: (shortcut + residual) / √2.

    ``level`` is the finer of the two levels that the block connects. The ``direction`` is "down"
    (ST-Resblk) or "up" (ST-AdaINResblk), the ``norm`` "none" (E and D), "in" (encoder of G),
    "adain" (decoder of G) or "adain per node"; ``code`` is the length of the style code.
    """

    def __init__(self, inputs: int, outputs: int, graph: SkeletonGraph, level: int, direction: str,
                 norm: str = "none", code: int = 0):
        super().__init__()
        middle, to = (inputs, level + 1) if direction == "down" else (outputs, level)
        self.first = SpatialTemporal(inputs, middle, graph, level, direction)
        self.second = SpatialTemporal(middle, outputs, graph, to)
        self.shortcut = nn.Conv2d(inputs, outputs, 1, bias=False)
        self.resample = Resample(graph, level, direction)
        made = {"none": lambda c, n: nn.Identity(),
                "in": lambda c, n: nn.InstanceNorm2d(c, affine=True),
                "adain": lambda c, n: AdaIN(code, c), "adain per node": partial(AdaIN, code)}[norm]
        nodes = graph.sizes[level + (direction == "up")], graph.sizes[to]
        self.norms = nn.ModuleList(map(made, (inputs, middle), nodes))

    def forward(self, x: Tensor, code: Tensor | None = None) -> Tensor:
        """``[B, outputs, N', T']`` of ``[B, inputs, N, T]``."""
        style = () if code is None else (code,)
        residual = self.first(functional.leaky_relu(self.norms[0](x, *style), SLOPE))
        residual = self.second(functional.leaky_relu(self.norms[1](residual, *style), SLOPE))
        # channels are mixed at the coarser level, which costs less
        shortcut = (self.shortcut(self.resample(x)) if self.resample.down
                    else self.resample(self.shortcut(x)))
        return (shortcut + residual) / math.sqrt(2)


def encoder(graph: SkeletonGraph, channels: int, norm: str = "none") -> nn.Sequential:
    """1×1 convolution and two ST-Resblks (Table 3a, b, d).

    The result is ``[B, 4 C, N/4, T/4]`` of z-scores ``[B, 7, N, T]``.
    """
    blocks = (Block(channels << k, channels << k + 1, graph, k, "down", norm)
              for k in range(POOLINGS))
    return nn.Sequential(nn.Conv2d(7, channels, 1), *blocks)


def he_init(network: nn.Module) -> None:
    """He initialisation (appendix A.2); biases start at zero."""
    for layer in network.modules():
        if isinstance(layer, nn.Conv1d | nn.Conv2d | nn.Linear):
            nn.init.kaiming_normal_(layer.weight, nonlinearity="relu")
            if layer.bias is not None:
                nn.init.zeros_(layer.bias)
