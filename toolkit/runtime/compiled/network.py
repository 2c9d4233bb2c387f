"""LPN-FiLM's network for many characters at once: normalisers, gating, experts, FiLM (Mason et al. 2022, sections 4.1, 4.2).

A blended layer is Σ αₖ (x Wₖ). Weights are stored once, in the order in which they are read: for each expert and each panel
of `COLUMNS` outputs, the rows one after another. For one character, memory limits the speed; this order reads it once from
start to end. For many, arithmetic limits it: a tile of up to `ROWS` characters by one panel is summed in registers. Gates
scale finished tiles. So no scaled inputs are stored, and an expert with a zero gate takes no time.
"""

import math
from typing import NamedTuple

import numpy as np
import torch
from numba import njit

from toolkit.features import FRAME_KINDS
from toolkit.io.compilation import compiled
from toolkit.networks.film import EPSILON, LARGEST
from toolkit.runtime.compiled.layer import CHAINS, COLUMNS, VECTORS, blended_layer

BATCH = 128  # number of characters whose inputs fit in the cache
LINES = 32  # rows of weights of all experts that fit in the first cache
PRECISIONS = {"float32": np.float32, "bfloat16": np.uint16}

_LOG2E, _LN2_HIGH, _LN2_LOW = np.float32(1.44269504), np.float32(0.693359375), np.float32(-2.12194440e-4)
_F7, _F6, _F5, _F4, _F3 = (np.float32(1 / f) for f in (5040, 720, 120, 24, 6))
_ZERO, _ONE, _HALF, _LOWEST, _EPSILON = (np.float32(v) for v in (0.0, 1.0, 0.5, -80.0, EPSILON))


class Weights(NamedTuple):
    """The weights that the kernel reads; float32, except for ``experts``."""

    means: tuple  # of inputs, phases and outputs
    deviations: tuple  # of inputs, phases and outputs
    gating: tuple  # weight [in, out] of three layers
    gating_biases: tuple  # [out]
    experts: tuple  # of three layers, one row of K × panels × inputs × COLUMNS, padded with zeros; see `_packed`
    biases: tuple  # of three layers [K, panels × COLUMNS]

    @classmethod
    def of(cls, model, precision: str) -> "Weights":
        """The weights of a model."""
        linear, blended = model.gating.layers, model.experts.layers
        packed = [_packed(_array(layer.weight), precision) for layer in blended]
        numbers = _aligned(sum(values.size for values in packed), PRECISIONS[precision])
        experts, at = [], 0
        for values in packed:
            experts.append(numbers[at : at + values.size])
            experts[-1][:] = values.ravel()
            at += values.size
        return cls(
            means=tuple(_array(model.normaliser(kind).mean) for kind in FRAME_KINDS),
            deviations=tuple(_array(model.normaliser(kind).std) for kind in FRAME_KINDS),
            gating=tuple(np.ascontiguousarray(_array(layer.weight).T) for layer in linear),
            gating_biases=tuple(_array(layer.bias) for layer in linear), experts=tuple(experts),
            biases=tuple(_columns(_array(layer.bias)) for layer in blended),
        )

    @property
    def bytes(self) -> int:
        """Number of bytes that a step of one character reads."""
        return sum(array.nbytes for part in self for array in part)


def _array(tensor: torch.Tensor) -> np.ndarray:
    return np.ascontiguousarray(tensor.detach().numpy(), np.float32)


def _columns(values: np.ndarray) -> np.ndarray:
    """Values with zeros after the last column, so that panels are full."""
    return np.pad(values, [(0, 0)] * (values.ndim - 1) + [(0, -values.shape[-1] % COLUMNS)])


def _packed(weight: np.ndarray, precision: str) -> np.ndarray:
    """Weights ``[K, in, out]`` in the kernel's order, float32 or the upper halves of float32 (bfloat16, as uint16)."""
    weight = np.pad(_columns(weight), ((0, 0), (0, -weight.shape[1] % (CHAINS // VECTORS)), (0, 0)))
    if precision == "bfloat16":
        bits = weight.view(np.uint32)
        weight = ((bits + 0x7FFF + (bits >> 16 & 1)) >> 16).astype(np.uint16)  # to the nearest, ties to even
    return weight.reshape(*weight.shape[:2], -1, COLUMNS).transpose(0, 2, 1, 3)


def _aligned(size: int, dtype: type) -> np.ndarray:
    """An array aligned to a cache line; otherwise every vector would lie in two cache lines."""
    line, width = 64, np.dtype(dtype).itemsize
    room = np.empty(size * width + line, np.uint8)
    first = -room.ctypes.data % line
    return room[first : first + size * width].view(dtype)


@njit(nogil=True, fastmath={"reassoc", "nsz", "contract"})
def _modulate(y, gamma, beta, bits):
    """ELU(γ ∘ LN(y) + β) in place; ``bits`` is room for as many int32. The exponential by its series, in vectors."""
    size, mean, square = len(gamma), _ZERO, _ZERO
    for i in range(size):
        mean += y[i]
    mean /= np.float32(size)
    for i in range(size):
        square += (y[i] - mean) * (y[i] - mean)
    scale = _ONE / (np.sqrt(square / np.float32(size - 1)) + _EPSILON)
    powers = bits.view(np.float32)
    for i in range(size):
        value = gamma[i] * ((y[i] - mean) * scale) + beta[i]
        below = max(min(value, _ZERO), _LOWEST)
        whole = np.floor(below * _LOG2E + _HALF)
        rest = below - whole * _LN2_HIGH - whole * _LN2_LOW
        series = ((((_F7 * rest + _F6) * rest + _F5) * rest + _F4) * rest + _F3) * rest + _HALF
        series = (series * rest + _ONE) * rest + _ONE
        bits[i] = (np.int32(whole) + np.int32(127)) << np.int32(23)
        y[i] = max(value, _ZERO) + (series * powers[i] - _ONE)


@njit(nogil=True)
def _gates(phases, weights, skip, gates):
    """Gating coefficients; those below ``skip`` become zero, and the others are scaled to sum to one."""
    mean, deviation = weights.means[1], weights.deviations[1]
    widest = max(len(weights.gating_biases[0]), len(weights.gating_biases[1]), len(mean), gates.shape[1])
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
                h[j] = y[j] if y[j] > _ZERO or layer == 2 else np.exp(y[j]) - _ONE
        high = h[:m].max()
        for j in range(m):
            gates[b, j] = np.exp(h[j] - high)
        gates[b] /= gates[b].sum()
        if skip > 0:
            for j in range(m):
                if gates[b, j] < skip:
                    gates[b, j] = _ZERO
            gates[b] /= gates[b].sum()


@njit(nogil=True, fastmath={"reassoc", "nsz", "contract"})
def _scatter(x, gates, weight, bias, dropped, variance):
    """dropped · Σᵢ xᵢ² (Σₖ αₖ Wₖᵢⱼ)² ``[B, columns]``: `toolkit.networks.BlendedLinear.scatter`.

    The weights must be blended for each character. `LINES` rows of a panel of all experts stay in the cache meanwhile. Four
    experts at a time are summed in registers.
    """
    experts, columns = bias.shape
    n = weight.size // (experts * columns)
    line, at, share = np.empty(COLUMNS, np.float32), np.zeros(4, np.int64), np.zeros(4, np.float32)
    variance[:] = _ZERO
    for first in range(0, columns, COLUMNS):
        for top in range(0, n, LINES):
            for b in range(len(x)):
                for i in range(top, min(top + LINES, n)):
                    line[:] = _ZERO
                    for group in range(0, experts, 4):
                        for k in range(4):
                            there = group + k < experts
                            at[k] = ((group + k if there else 0) * columns + first) * n + i * COLUMNS
                            share[k] = gates[b, group + k] * x[b, i] if there else _ZERO
                        w0, w1 = weight[at[0] : at[0] + COLUMNS], weight[at[1] : at[1] + COLUMNS]
                        w2, w3 = weight[at[2] : at[2] + COLUMNS], weight[at[3] : at[3] + COLUMNS]
                        s0, s1, s2, s3 = share[0], share[1], share[2], share[3]
                        for c in range(COLUMNS):
                            line[c] += s0 * w0[c] + s1 * w1[c] + s2 * w2[c] + s3 * w3[c]
                    total = variance[b, first : first + COLUMNS]
                    for c in range(COLUMNS):
                        total[c] += dropped * line[c] * line[c]


@njit(nogil=True)
def _expected(y, variance, gamma, beta):
    """`toolkit.networks.film.Film.expected` in place."""
    size, mean, square, spread = len(gamma), 0.0, 0.0, 0.0
    for i in range(size):
        mean += y[i] / size
        spread += variance[i] / size
    for i in range(size):
        square += (y[i] - mean) ** 2
    scale = 1 / (math.sqrt(square / (size - 1) + spread) + EPSILON)
    half = math.sqrt(0.5)
    for i in range(size):
        m = gamma[i] * (y[i] - mean) * scale + beta[i]
        s = max(abs(gamma[i]) * math.sqrt(variance[i]) * scale, 1e-6)
        at = m / s
        below = 0.5 * math.erfc(at * half)
        tail = math.exp(min(m + 0.5 * s * s, LARGEST)) * 0.5 * math.erfc((at + s) * half)
        y[i] = m * (1 - below) + s * math.exp(-0.5 * at * at) / math.sqrt(2 * math.pi) + tail - below


@compiled()
def predict(x, phases, style, weights, skip, dropped, z, start, stop):
    """Fill rows ``start`` to ``stop`` of ``z [N, Dz]`` with next frames, physical units: `toolkit.networks.Model.predict`.

    ``x [N, Dx]``, ``phases [N, 8]``, ``style [N or 1, 4 hidden]``; ``dropped`` is `toolkit.networks.Model.dropped` of a
    calibrated model, 0 of others.
    """
    hidden, room = style.shape[1] // 4, min(stop - start, BATCH)
    widths = weights.biases[0].shape[1], weights.biases[1].shape[1], weights.biases[2].shape[1]
    n = weights.experts[0].size // weights.biases[0].size
    scaled, gates = np.zeros((room, n), np.float32), np.empty((room, len(weights.biases[0])), np.float32)
    first, second = np.empty((room, widths[0]), np.float32), np.empty((room, widths[1]), np.float32)
    last, bits = np.empty((room, widths[2]), np.float32), np.empty(hidden, np.int32)
    variance = np.empty((room, max(widths[0], widths[1])) if dropped > 0 else (1, 1), np.float32)
    for begin in range(start, stop, BATCH):
        end = min(begin + BATCH, stop)
        count = end - begin
        mean, deviation = weights.means[0], weights.deviations[0]
        for b in range(count):
            for i in range(x.shape[1]):
                scaled[b, i] = (x[begin + b, i] - mean[i]) / deviation[i]
        _gates(phases[begin:end], weights, skip, gates)
        inputs, outputs = scaled[:count], first[:count]
        for layer in range(2):
            blended_layer(inputs, gates, weights.experts[layer], weights.biases[layer], outputs)
            if dropped > 0:
                _scatter(inputs, gates, weights.experts[layer], weights.biases[layer], dropped, variance)
            for b in range(count):
                vector = style[begin + b if len(style) > 1 else 0, 2 * layer * hidden : 2 * (layer + 1) * hidden]
                if dropped > 0:
                    _expected(outputs[b], variance[b], vector[:hidden], vector[hidden:])
                else:
                    _modulate(outputs[b], vector[:hidden], vector[hidden:], bits)
            inputs, outputs = outputs, second[:count]
        blended_layer(inputs, gates, weights.experts[2], weights.biases[2], last[:count])
        mean, deviation = weights.means[2], weights.deviations[2]
        for b in range(count):
            for i in range(z.shape[1]):
                z[begin + b, i] = last[b, i] * deviation[i] + mean[i]
