"""Style as feature-wise linear modulation (FiLM; Mason et al. 2022, section 4.2)."""

import functools
import math

import torch
import torch.nn.functional as F
from torch import Tensor, nn

EPSILON = 1e-6  # added to the deviation, as in the published network
LARGEST = 60.0  # largest exponent; its exponential is finite, also times a tail of zero
TILE = 40  # frames convolved at once; divides a style clip's 240 and, after pooling, 120
MANY, WIDE = 4, 16  # tiles are faster from this number of clips and this kernel width (frames) on


def layer_norm(f: Tensor) -> Tensor:
    """``f`` with mean 0 and (unbiased) deviation 1 over its last axis (equation 3)."""
    centred = f - f.mean(-1, keepdim=True)
    return centred / (f.std(-1, keepdim=True) + EPSILON)


class Film(nn.Module):
    """Modulation of hidden layers by a style vector (γ1, β1, γ2, β2), each as wide as a layer.

    The ``generator`` is the network Ψ that makes style vectors of clips (equation 2); None for a
    model that only takes style vectors.
    """

    def __init__(self, hidden: int, generator: "FilmGenerator | None"):
        super().__init__()
        self.hidden, self.generator = hidden, generator

    @property
    def size(self) -> int:
        """Length of a style vector: the numbers a style costs at run time (Table 2, P.S.R.)."""
        return 4 * self.hidden

    def forward(self, layer: int, f: Tensor, style: Tensor, x: Tensor | None = None,
                gates: Tensor | None = None) -> Tensor:
        """h = ELU(γ ∘ LN(F) + β) (equation 3) of hidden layer 0 or 1.

        ``f [B, hidden]``; ``style [B, 4 hidden]``, or ``[1, 4 hidden]`` or ``[4 hidden]`` for one
        style in the whole batch. The layer's inputs x and the gates are not used.
        """
        gamma, beta = self._part(layer, style)
        return F.elu(gamma * layer_norm(f) + beta)

    def expected(self, layer: int, f: Tensor, style: Tensor, variance: Tensor) -> Tensor:
        """Mean of `forward` if each F is normal with mean ``f`` and ``variance [B, hidden]``.

        Dropout before a layer keeps the mean of F and adds to its variance. Without dropout, layer
        normalisation divides by a smaller deviation, so the next layer's inputs have another scale
        than in training. Therefore we use s² = var(f) + mean variance, u = γ (f − mean f) / s + β,
        and h = E[ELU(u + γ √variance / s · ε)], ε normal.
        """
        gamma, beta = self._part(layer, style)
        deviation = (f.var(-1, keepdim=True) + variance.mean(-1, keepdim=True)).sqrt() + EPSILON
        u = gamma * (f - f.mean(-1, keepdim=True)) / deviation + beta
        return expected_elu(u, gamma.abs() * variance.sqrt() / deviation)

    def _part(self, layer: int, style: Tensor) -> tuple[Tensor, Tensor]:
        """γ and β of a layer."""
        return style[..., 2 * layer * self.hidden : 2 * (layer + 1) * self.hidden].chunk(2, -1)


def expected_elu(mean: Tensor, deviation: Tensor) -> Tensor:
    """E[ELU(X)] of normal variables with the given means and deviations (any shape).

    The positive side gives m Φ(m/s) + s φ(m/s), the negative side exp(m + s²/2) Φ(−m/s − s) −
    Φ(−m/s).
    """
    s = deviation.clamp_min(1e-6)
    z = mean / s
    density = torch.exp(-0.5 * z * z) / math.sqrt(2 * math.pi)
    tail = torch.exp((mean + 0.5 * s * s).clamp_max(LARGEST)) * torch.special.ndtr(-z - s)
    return mean * torch.special.ndtr(z) + s * density + tail - torch.special.ndtr(-z)


class FilmGenerator(nn.Module):
    """The FiLM generator Ψ (equation 2): two convolutions with max-pooling, two dense layers.

    The paper does not say how γ is initialised. We start the last layer's bias with γ = 1, β = 0,
    which is plain layer normalisation. Otherwise hidden layers would be almost zero.

    Style clips have ``frames`` frames of ``n_in`` columns (12 J); the other numbers are those of
    `Sizes`. (The paper says that dropout is everywhere; in the generator of the published run only
    units of the first dense layer are dropped.)
    """

    def __init__(self, n_in: int, frames: int, hidden: int, channels: int, kernel: int, dense: int,
                 dropout: float):
        super().__init__()
        self.first = Convolution(n_in, channels, kernel)
        self.second = Convolution(channels, channels, kernel)
        self.dense = nn.Linear(frames // 2 // 2 * channels, dense)
        self.out = nn.Linear(dense, 4 * hidden)
        self.dropout = nn.Dropout(dropout)
        with torch.no_grad():
            self.out.bias.copy_(torch.tensor([1.0, 0.0, 1.0, 0.0]).repeat_interleave(hidden))

    def forward(self, clips: Tensor) -> Tensor:
        """Normalised ``clips [M, frames, n_in]`` to style vectors ``[M, 4 hidden]``."""
        h = F.max_pool1d(F.relu(self.first(clips.transpose(1, 2))), 2)
        h = F.max_pool1d(F.relu(self.second(h)), 2)
        h = h.transpose(1, 2).flatten(1)  # time-major, as in the published network
        return self.out(self.dropout(F.relu(self.dense(h))))


class Convolution(nn.Conv1d):
    """A convolution over time that keeps the length; beyond both ends there are zeros.

    On the CPU, many clips with a wide kernel are convolved in the frequency domain, tile by tile
    (overlap-save). A kernel of 25 frames then needs a sixth of the multiplications. The result is
    the same up to rounding (with bfloat16, rounding errors are 1.5 times as large).
    """

    def __init__(self, n_in: int, n_out: int, kernel: int):
        super().__init__(n_in, n_out, kernel, padding="same")

    def forward(self, x: Tensor) -> Tensor:
        """``x [M, n_in, T]`` to ``[M, n_out, T]``."""
        width = self.kernel_size[0]
        if len(x) < MANY or width < WIDE or x.device.type != "cpu":
            return super().forward(x)
        # tiles of `TILE` frames, each with the frames around it that the kernel reaches: n frames
        frames, n = x.shape[2], TILE + width - 1
        before = (width - 1) // 2
        padded = F.pad(x.transpose(1, 2), (0, 0, before, width - 1 - before + -frames % TILE))
        tiles = padded.unfold(1, n, TILE).permute(3, 0, 1, 2)  # [n, M, tiles, n_in]

        # spectra of tiles and kernels, real part and imaginary part, [frequencies, M tiles, n_in]
        # and [frequencies, n_in, n_out]; matrix products, because torch.fft takes 1.4 times as long
        waves, back = _waves(n)
        re, im = (waves @ tiles.flatten(1)).view(2, n // 2 + 1, -1, self.in_channels)
        kernel = waves[:, :width] @ self.weight.permute(2, 1, 0).flatten(1)
        a, b = kernel.view(2, n // 2 + 1, self.in_channels, -1)

        # their products (re + i im) (a - i b), real above imaginary; the conjugate, because torch's
        # convolution does not turn the kernel round
        both = torch.cat((torch.cat((re, im), 2), torch.cat((im, -re), 2)), 1)
        products = both @ torch.cat((a, b), 1)
        y = (back @ products.view(len(waves), -1)).view(TILE, len(x), -1, self.out_channels)
        return y.permute(1, 3, 2, 0).flatten(2)[..., :frames] + self.bias[:, None]


@functools.cache
@torch.inference_mode(False)  # training may need them later
def _waves(n: int) -> tuple[Tensor, Tensor]:
    """Matrices of the real Fourier transform of n samples and of its inverse.

    The transform is ``[2 (n/2 + 1), n]``, real above imaginary. The inverse,
    ``[TILE, 2 (n/2 + 1)]``, gives the first samples from a spectrum with interleaved real and
    imaginary parts.
    """
    samples, waves = torch.eye(n).double(), torch.eye(n // 2 + 1).double()
    spectra = torch.fft.rfft(samples, dim=0)
    parts = torch.stack((waves + 0j, 1j * waves), -1).flatten(1)
    back = torch.fft.irfft(parts, n, dim=0)[:TILE]
    return torch.cat((spectra.real, spectra.imag)).float(), back.float().contiguous()
