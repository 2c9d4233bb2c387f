"""LPN-FiLM's network for many characters at once (Mason et al. 2022, sections 4.1, 4.2).

The parts are those of `toolkit.networks.Model.predict`: normalisers, gating, experts and FiLM.
"""

import math
from typing import NamedTuple

import numpy as np
import torch
from numba import njit

from toolkit.features import FRAME_KINDS
from toolkit.io.compilation import compiled
from toolkit.networks.film import EPSILON

BATCH = 128  # number of characters whose inputs fit in the cache
ROWS = 8  # rows of weights that one pass over the outputs adds
FAST = {"reassoc", "nsz", "contract"}  # sums in any order, so that they can be vectors
_ZERO, _ONE, _EPSILON = np.float32(0.0), np.float32(1.0), np.float32(EPSILON)


class Weights(NamedTuple):
    """The weights that the kernel reads, float32; in and out are numbers of inputs and outputs."""

    means: tuple  # of inputs, phases and outputs
    deviations: tuple  # of inputs, phases and outputs
    gating: tuple  # of three layers [in, out]
    gating_biases: tuple  # of three layers [out]
    experts: tuple  # of three layers [K, in, out]; in is padded with zeros to a multiple of ROWS
    biases: tuple  # of three layers [K, out]

    @classmethod
    def of(cls, model) -> "Weights":
        """The weights of a model."""
        normalisers = [model.normaliser(kind) for kind in FRAME_KINDS]
        linear, blended = model.gating.layers, model.experts.layers
        return cls(
            means=tuple(_array(normaliser.mean) for normaliser in normalisers),
            deviations=tuple(_array(normaliser.std) for normaliser in normalisers),
            gating=tuple(_array(layer.weight.T) for layer in linear),
            gating_biases=tuple(_array(layer.bias) for layer in linear),
            experts=tuple(_padded(_array(layer.weight)) for layer in blended),
            biases=tuple(_array(layer.bias) for layer in blended),
        )

    @property
    def bytes(self) -> int:
        """Number of bytes that a step of one character reads."""
        return sum(array.nbytes for part in self for array in part)


def _array(tensor: torch.Tensor) -> np.ndarray:
    return np.array(tensor.detach().numpy(), np.float32, order="C")


def _padded(weight: np.ndarray) -> np.ndarray:
    """Weights ``[K, in, out]`` with zeros after the last input."""
    return np.pad(weight, ((0, 0), (0, -weight.shape[1] % ROWS), (0, 0)))


@njit
def _gates(phases, weights, gates):
    """Gating coefficients ``[B, K]`` of phases ``[B, 8]``."""
    mean, deviation = weights.means[1], weights.deviations[1]
    hidden = len(weights.gating_biases[0])
    widest = max(hidden, len(mean), gates.shape[1])
    h, y = np.empty(widest, np.float32), np.empty(widest, np.float32)
    for b in range(len(phases)):
        for i in range(len(mean)):
            h[i] = (phases[b, i] - mean[i]) / deviation[i]
        for layer in range(3):
            weight, bias = weights.gating[layer], weights.gating_biases[layer]
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


@njit(fastmath=FAST)
def _add_rows(shares, weight, y):
    """y += Σᵢ sharesᵢ weightᵢ over `ROWS` rows ``weight [ROWS, out]``.

    The number of rows is a constant. So the compiler unrolls the inner loop, keeps the shares in
    registers, and loads and stores y once for eight rows.
    """
    for c in range(len(y)):
        total = y[c]
        for i in range(ROWS):
            total += shares[i] * weight[i, c]
        y[c] = total


@njit
def _blended_layer(x, gates, weight, bias, y):
    """y = Σ αₖ (x Wₖ + bₖ): ``x [B, in]``, ``gates [B, K]``, ``y [B, out]``.

    The speed of one character is limited by reading the weights from memory. They are read once,
    in the order in which they lie there, and rows in the cache serve all characters.
    """
    count, (experts, rows, columns) = len(x), weight.shape
    shares = np.empty(ROWS, np.float32)
    y[:, :columns] = _ZERO
    for k in range(experts):
        for b in range(count):
            for c in range(columns):
                y[b, c] += gates[b, k] * bias[k, c]
        for first in range(0, rows, ROWS):
            part = weight[k, first : first + ROWS]
            for b in range(count):
                for i in range(ROWS):
                    shares[i] = gates[b, k] * x[b, first + i]
                _add_rows(shares, part, y[b, :columns])


@njit(fastmath=FAST)
def _modulate(y, gamma, beta):
    """ELU(γ ∘ LN(y) + β) in place: `toolkit.networks.film.Film`."""
    size, mean, square = len(gamma), _ZERO, _ZERO
    for i in range(size):
        mean += y[i]
    mean /= np.float32(size)
    for i in range(size):
        square += (y[i] - mean) * (y[i] - mean)
    scale = _ONE / (np.sqrt(square / np.float32(size - 1)) + _EPSILON)
    for i in range(size):
        value = gamma[i] * ((y[i] - mean) * scale) + beta[i]
        y[i] = value if value > _ZERO else math.exp(value) - _ONE


@compiled()
def predict(x, phases, style, weights, z):
    """Fill ``z [N, Dz]`` with next frames, in physical units.

    ``x [N, Dx]``, ``phases [N, 8]``, ``style [N or 1, 4 hidden]``.
    """
    hidden, room = style.shape[1] // 4, min(len(x), BATCH)
    gates = np.empty((room, len(weights.biases[0])), np.float32)
    # room for inputs and outputs of the layers; columns of padding stay zero
    scaled = np.zeros((room, weights.experts[0].shape[1]), np.float32)
    first = np.zeros((room, weights.experts[1].shape[1]), np.float32)
    second = np.zeros((room, weights.experts[2].shape[1]), np.float32)
    for begin in range(0, len(x), BATCH):
        end = min(begin + BATCH, len(x))
        count = end - begin
        mean, deviation = weights.means[0], weights.deviations[0]
        for b in range(count):
            for i in range(x.shape[1]):
                scaled[b, i] = (x[begin + b, i] - mean[i]) / deviation[i]
        _gates(phases[begin:end], weights, gates)

        inputs, outputs = scaled[:count], first[:count]
        for layer in range(2):
            weight, bias = weights.experts[layer], weights.biases[layer]
            _blended_layer(inputs, gates, weight, bias, outputs)
            for b in range(count):
                vector = style[begin + b if len(style) > 1 else 0, 2 * layer * hidden :]
                _modulate(outputs[b], vector[:hidden], vector[hidden : 2 * hidden])
            inputs, outputs = outputs, second[:count]
        _blended_layer(inputs, gates, weights.experts[2], weights.biases[2], z[begin:end])

        mean, deviation = weights.means[2], weights.deviations[2]
        for b in range(begin, end):
            for i in range(z.shape[1]):
                z[b, i] = z[b, i] * deviation[i] + mean[i]
