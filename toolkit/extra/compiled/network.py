"""LPN-FiLM's network for many characters at once (Mason et al. 2022, sections 4.1, 4.2).

The parts are those of `toolkit.networks.Model.predict`: normalisers, gating, experts and FiLM.

A layer blends K experts: y = Σ αₖ (x Wₖ + bₖ). Blending the weights of each character would read
all of them for each. Instead the inputs are written K times in a row, each time multiplied by the
gate αₖ, with αₖ itself behind them for the bias. Then the layer of all characters is one product
with the weights of all experts, K (in + 1) long. torch computes it: `torch.mm` is as fast as memory
for one character; for many, oneDNN uses the widest vectors of any processor, where `torch.mm` (MKL)
does so on Intel's only. What lies between the products, numba compiles.
"""

import math
from typing import NamedTuple

import numpy as np
import torch
from numba import njit
from torch.nn import functional

from toolkit.features import FRAME_KINDS
from toolkit.io.compilation import compiled
from toolkit.networks.film import EPSILON

BATCH = 128  # number of characters whose inputs fit in the cache
MANY = 8  # least number of characters for which oneDNN is faster
FAST = {"reassoc", "nsz", "contract"}  # sums in any order, so that they can be vectors
_ZERO, _ONE, _EPSILON = np.float32(0.0), np.float32(1.0), np.float32(EPSILON)


class Gating(NamedTuple):
    """What the kernel of gates reads, float32."""

    means: tuple  # of inputs and phases
    deviations: tuple  # of inputs and phases
    weights: tuple  # of three layers [in, out]
    biases: tuple  # of three layers [out]


class Weights(NamedTuple):
    """The weights of the network, float32."""

    gating: Gating
    experts: tuple  # of three layers [out, K (in + 1)]; the last one's are times the deviation
    many: tuple  # the same for oneDNN, where torch has it
    mean: torch.Tensor  # of outputs

    @classmethod
    def of(cls, model) -> "Weights":
        """The weights of a model."""
        *inputs, outputs = (model.normaliser(kind) for kind in FRAME_KINDS)
        linear, experts = model.gating.layers, [_joined(layer) for layer in model.experts.layers]
        experts[-1] *= outputs.std.detach()[:, None]
        gating = Gating(
            means=tuple(_array(normaliser.mean) for normaliser in inputs),
            deviations=tuple(_array(normaliser.std) for normaliser in inputs),
            weights=tuple(_array(layer.weight.T) for layer in linear),
            biases=tuple(_array(layer.bias) for layer in linear),
        )
        known = torch.backends.mkldnn.is_available()
        many = tuple(map(torch.Tensor.to_mkldnn, experts)) if known else ()
        return cls(gating, tuple(experts), many, outputs.mean.detach().clone())


def _array(tensor: torch.Tensor) -> np.ndarray:
    return np.array(tensor.detach().numpy(), np.float32, order="C")


def _joined(layer) -> torch.Tensor:
    """Weights and biases of all experts in one matrix ``[out, K (in + 1)]``.

    An output's weights lie one after another: so those of one character are read fastest.
    """
    rows = torch.cat((layer.weight, layer.bias[:, None]), 1).detach().float()
    return rows.flatten(0, 1).T.contiguous()


@njit
def _scale(h, gates, scaled):
    """Inputs ``[in]`` of a layer and a 1, times the gate of each expert: ``[K (in + 1)]``."""
    size = len(h)
    for k in range(len(gates)):
        part = scaled[k * (size + 1) :]
        for i in range(size):
            part[i] = gates[k] * h[i]
        part[size] = gates[k]


@compiled()
def gate(x, phases, gating, gates, scaled):
    """Fill ``gates [B, K]`` from phases ``[B, 8]``, and the first layer's inputs from ``x``."""
    hidden = len(gating.biases[0])
    widest = max(hidden, phases.shape[1], gates.shape[1])
    h, y = np.empty(widest, np.float32), np.empty(widest, np.float32)
    inputs = np.empty(x.shape[1], np.float32)
    for b in range(len(phases)):
        mean, deviation = gating.means[1], gating.deviations[1]
        for i in range(len(mean)):
            h[i] = (phases[b, i] - mean[i]) / deviation[i]
        for layer in range(3):
            weight, bias = gating.weights[layer], gating.biases[layer]
            n, m = weight.shape
            y[:m] = bias
            for i in range(n):
                for j in range(m):
                    y[j] += h[i] * weight[i, j]
            for j in range(m):
                h[j] = y[j] if y[j] > _ZERO or layer == 2 else math.exp(y[j]) - _ONE
        # softmax; the largest is subtracted so that no exponential overflows
        high = h[:m].max()
        for j in range(m):
            gates[b, j] = math.exp(h[j] - high)
        gates[b] /= gates[b].sum()

        mean, deviation = gating.means[0], gating.deviations[0]
        for i in range(len(inputs)):
            inputs[i] = (x[b, i] - mean[i]) / deviation[i]
        _scale(inputs, gates[b], scaled[b])


@compiled(fastmath=FAST)
def modulate(y, style, layer, epsilon):
    """γ ∘ LN(y) + β, in place of ``y [B, hidden]``.

    ``style [B or 1, 4 hidden]`` holds γ and β of layers 0 and 1: `toolkit.networks.film.Film`.
    """
    count, size = y.shape
    for b in range(count):
        h, vector = y[b], style[b if len(style) > 1 else 0, 2 * layer * size :]
        mean = square = _ZERO
        for i in range(size):
            mean += h[i]
        mean /= np.float32(size)
        for i in range(size):
            square += (h[i] - mean) * (h[i] - mean)
        scale = _ONE / (np.sqrt(square / np.float32(size - 1)) + epsilon)
        for i in range(size):
            h[i] = vector[i] * ((h[i] - mean) * scale) + vector[size + i]


@compiled()
def scale(h, gates, scaled):
    """Fill a layer's inputs ``scaled [B, K (in + 1)]`` from ``h [B, in]``."""
    for b in range(len(h)):
        _scale(h[b], gates[b], scaled[b])


def _product(inputs, layer, weights):
    """A layer of all characters: ``[B, K (in + 1)]`` to ``[B, out]``."""
    if len(inputs) < MANY or not weights.many:
        return torch.mm(inputs, weights.experts[layer].T)
    return functional.linear(inputs.to_mkldnn(), weights.many[layer]).to_dense()


def predict(x, phases, style, weights, z):
    """Fill ``z [N, Dz]`` with next frames, in physical units.

    ``x [N, Dx]``, ``phases [N, 8]``, ``style [N or 1, 4 hidden]``.
    """
    for begin in range(0, len(x), BATCH):
        some = slice(begin, begin + BATCH)
        count, vectors = len(x[some]), style[some] if len(style) > 1 else style
        # torch's memory starts at a cache line; elsewhere the products might round in another order
        gates = torch.empty(count, len(weights.gating.biases[2])).numpy()
        # the inputs of all layers lie in the same memory, which stays in the cache
        widths = [weight.shape[1] for weight in weights.experts]
        room = torch.empty(count * max(widths))
        scaled = [room[: count * width].view(count, width) for width in widths]
        gate(x[some], phases[some], weights.gating, gates, scaled[0].numpy())
        for layer in range(2):
            y = _product(scaled[layer], layer, weights)
            modulate(y.numpy(), vectors, layer, _EPSILON)
            functional.elu(y, inplace=True)  # exponentials as vectors, which numba has not
            scale(y.numpy(), gates, scaled[layer + 1].numpy())
        y = _product(scaled[2], 2, weights)
        torch.add(y, weights.mean, out=torch.from_numpy(z[some]))
