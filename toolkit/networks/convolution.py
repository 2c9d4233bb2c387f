"""Wide convolutions over time, fast for many clips at once."""

import functools
import math

import torch
import torch.nn.functional as F
from torch import Tensor, nn

TILE = 40  # frames convolved at once; divides a style clip's 240 and, after pooling, 120
MANY, WIDE = 4, 16  # tiles are faster from this number of clips and this kernel width (frames) on


class Convolution(nn.Conv1d):
    """A convolution over time that keeps the length; beyond both ends there are zeros.

    On the CPU, many clips with a wide kernel are convolved in the frequency domain, tile by tile (overlap-save). A kernel of
    25 frames then needs a sixth of the multiplications. The result is the same up to rounding (with bfloat16, rounding
    errors are 1.5 times as large). Few clips, narrow kernels and other devices use torch's convolution. ``n_in``
    and ``n_out`` are channels, ``kernel`` is in frames.
    """

    def __init__(self, n_in: int, n_out: int, kernel: int):
        super().__init__(n_in, n_out, kernel, padding="same")

    def forward(self, x: Tensor) -> Tensor:
        """``x [M, n_in, T]`` to ``[M, n_out, T]``."""
        width = self.kernel_size[0]
        if len(x) < MANY or width < WIDE or x.device.type != "cpu":
            return super().forward(x)
        frames, n = x.shape[2], TILE + width - 1
        waves, back = _waves(n)
        before = (width - 1) // 2
        padded = F.pad(x.transpose(1, 2), (0, 0, before, width - 1 - before + -frames % TILE))
        tiles = padded.unfold(1, n, TILE).permute(3, 0, 1, 2)  # [n, M, tiles, n_in]
        re, im = (waves @ tiles.flatten(1)).view(2, n // 2 + 1, -1, self.in_channels)
        kernel = (waves[:, :width] @ self.weight.permute(2, 1, 0).flatten(1)).view(2, n // 2 + 1, self.in_channels, -1)
        both = torch.cat((torch.cat((re, im), 2), torch.cat((im, -re), 2)), 1)
        products = both @ torch.cat((*kernel,), 1)  # times the conjugate: [frequencies, real above imaginary, n_out]
        y = (back @ products.view(len(waves), -1)).view(TILE, len(x), -1, self.out_channels)
        return y.permute(1, 3, 2, 0).flatten(2)[..., :frames] + self.bias[:, None]


@functools.cache
@torch.inference_mode(False)  # training may need them later
def _waves(n: int) -> tuple[Tensor, Tensor]:
    """Matrices of the real Fourier transform of n samples (``[2 (n/2 + 1), n]``, real above imaginary) and of its inverse.

    The inverse, ``[TILE, 2 (n/2 + 1)]``, gives the first samples from a spectrum with interleaved real and imaginary parts.
    """
    angles = 2 * math.pi / n * torch.outer(torch.arange(n // 2 + 1), torch.arange(n)).double()
    waves = torch.stack((angles.cos(), -angles.sin()))
    twice = torch.full((n // 2 + 1, 1), 2.0)
    twice[0] = 1.0
    if n % 2 == 0:
        twice[-1] = 1.0
    back = (waves * twice / n)[..., :TILE].transpose(0, 1).flatten(0, 1).T
    return waves.flatten(0, 1).float(), back.float().contiguous()
