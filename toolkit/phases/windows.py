"""Measures in a window around every frame: its length, z-score, smoothing, speed.

Curves are ``[F, ...]``, best in float64. The length of a window is given by half of it, in seconds.
"""

import functools

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.motion.tensors import through_numpy

SECOND = 0.5  # half of the one-second window
CUTOFF = 4.0  # Hz, of the Butterworth filter
CYCLES = 1.05  # periods in a window; exactly one gives frequency errors up to 3 %
SHORTEST, LONGEST = 0.25, 2.0  # seconds, of a period
LEAST = 0.2  # least autocorrelation of a periodic curve


def half_window(curve: Tensor, fps: float) -> float:
    """Half of `CYCLES` periods of a curve ``[F]``, but no less than half a second.

    A window must hold a whole cycle: the feet of the style Zombie have 0.66 Hz and stances of a
    second. The period is the lag, under two seconds, of the highest peak of the autocorrelation of
    the whole curve without its slower changes.
    """
    n, longest = len(curve), min(round(LONGEST * fps), len(curve) - 2)
    fast = curve.double() - mean(curve.double(), LONGEST / 2, fps)
    correlation = torch.fft.irfft(torch.fft.rfft(fast, 2 * n).abs() ** 2)[:n]
    lags = torch.arange(round(SHORTEST * fps), longest, device=curve.device)
    here, before, after = correlation[lags], correlation[lags - 1], correlation[lags + 1]
    peaks = lags[(here > before) & (here >= after) & (here > LEAST * correlation[0])]
    if not len(peaks) or correlation[0] < 1e-12:
        return SECOND
    return max(SECOND, CYCLES / 2 * float(peaks[correlation[peaks].argmax()]) / fps)


def normalise(curves: Tensor, fps: float, half: float = SECOND) -> Tensor:
    """Z-score of ``curves [F, ...]`` in the window around each frame; a constant window gives 0."""
    middle = mean(curves, half, fps)
    deviation = (mean(curves**2, half, fps) - middle**2).clamp_min(0.0).sqrt()
    scale = curves.abs().amax(0).clamp_min(1e-9)
    scored = (curves - middle) / deviation.clamp_min(1e-12)
    return torch.where(deviation > 1e-4 * scale, scored, 0.0)


def smooth(curves: Tensor, fps: float) -> Tensor:
    """Second-order zero-phase Butterworth low-pass at `CUTOFF` along the first axis."""
    return through_numpy(lambda c: scipy.signal.sosfiltfilt(_low_pass(fps), c, axis=0), curves)


@functools.cache
def _low_pass(fps: float) -> np.ndarray:
    """Coefficients of the filter."""
    return scipy.signal.butter(2, CUTOFF, fs=fps, output="sos")


def speed(positions: Tensor, fps: float) -> Tensor:
    """Root-mean-square speed ``[F, ...]`` over one second of positions ``[F, ..., 3]``."""
    velocity = torch.gradient(positions, spacing=1 / fps, dim=0)[0]
    return mean(velocity.square().sum(-1), SECOND, fps).sqrt()


def regression(curve: Tensor, wave: Tensor, half: float,
               fps: float) -> tuple[Tensor, Tensor, Tensor]:
    """Least squares of a curve ``[F]`` by a wave: amplitude (≥ 0), offset and residual ``[F]``."""
    c, w = (mean(x, half, fps) for x in (curve, wave))
    ww, cw = (mean(x, half, fps) for x in (wave.square(), curve * wave))
    amplitude = ((cw - c * w) / (ww - w * w).clamp_min(1e-9)).clamp_min(0.0)
    offset = c - amplitude * w
    # mean square of curve − (amplitude · wave + offset), multiplied out
    cc = mean(curve.square(), half, fps)
    square = cc - 2 * (amplitude * cw + offset * c)
    square = square + amplitude**2 * ww + 2 * amplitude * offset * w + offset**2
    return amplitude, offset, square.clamp_min(0.0).sqrt()


def mean(values: Tensor, half: float, fps: float) -> Tensor:
    """Mean of ``values [F, ...]`` over the window around each frame; the ends are repeated."""
    frames = round(half * fps)
    flat = values.reshape(len(values), -1).T[:, None]
    padded = torch.nn.functional.pad(flat, (frames, frames), mode="replicate")
    means = torch.nn.functional.avg_pool1d(padded, 2 * frames + 1, stride=1)
    return means[:, 0].T.reshape(values.shape)
