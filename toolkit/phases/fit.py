"""Least-squares sinusoids: a·sin(2π(f·t − s)) + b in a window around every frame (Starke et al. 2020, section 5.2).

For a fixed frequency the sinusoid is linear in (a·cos, a·sin, b), so only the frequency is searched (variable projection,
Golub and Pereyra 1973): on a grid, where the projections of all windows are one matrix product, then at the bottom of the
parabola through the best grid point and its neighbours. Deterministic, all windows at once, float64.
"""

import math
from dataclasses import dataclass

import torch
from torch import Tensor

MIN_FREQUENCY, MAX_FREQUENCY = 0.25, 4.0
CHUNK = 2048  # windows at a time: what fits a processor's cache


@dataclass(frozen=True)
class Sinusoids:
    """Fitted parameters of every frame, each ``[F, L]``.

    ``phase`` is the angle 2π(f·t − s) at the frame itself, radians in [0, 2π); ``frequency`` in Hz; ``amplitude``,
    ``offset`` and ``residual`` (root mean square over the window) in the source's unit.
    """

    phase: Tensor
    frequency: Tensor
    amplitude: Tensor
    offset: Tensor
    residual: Tensor


def fit(source: Tensor, fps: float, half_window: float = 0.5, grid: int = 128) -> Sinusoids:
    """Fit a sinusoid around every frame.

    Parameters
    ----------
    source : Tensor [F, L]
        One curve per limb.
    fps
        Frames per second.
    half_window
        Seconds on either side of the frame.
    grid
        Frequencies tried, equally spaced in their logarithm.

    Notes
    -----
    Bounds as published: a in [0, max − min], f in [0.25, 4] Hz, b in [min, max] of the window.
    """
    half = max(2, round(half_window * fps))
    padded = torch.nn.functional.pad(source.double().T[:, None], (half, half), mode="reflect")[:, 0]
    windows = padded.unfold(-1, 2 * half + 1, 1).transpose(0, 1).reshape(-1, 2 * half + 1)
    time = torch.arange(-half, half + 1, dtype=torch.float64) / fps
    log2 = torch.linspace(math.log2(MIN_FREQUENCY), math.log2(MAX_FREQUENCY), grid, dtype=torch.float64)
    parts = [_fit_windows(w, time, log2) for w in windows.split(CHUNK)]
    return Sinusoids(*(torch.cat(column).view(source.shape) for column in zip(*parts, strict=True)))


def _fit_windows(windows: Tensor, time: Tensor, log2: Tensor) -> tuple[Tensor, ...]:
    """The five columns of `Sinusoids` for windows ``[N, W]``; ``log2 [G]`` is the grid."""
    angle = 2 * torch.pi * log2.exp2()[:, None] * time
    sine, cosine = angle.sin(), angle.cos()
    low, high = windows.aminmax(dim=1, keepdim=True)
    sums = windows.sum(1, keepdim=True), windows.square().sum(1, keepdim=True)
    gram = sine.square().sum(1), cosine.square().sum(1), cosine.sum(1)
    errors = _solve(windows @ sine.T, windows @ cosine.T, *sums, *gram, len(time), low, high)[3]

    best = errors.argmin(1, keepdim=True)
    middle = best.clamp(1, len(log2) - 2)
    below, here, above = (errors.gather(1, middle + i) for i in (-1, 0, 1))
    curvature = below - 2 * here + above
    shift = torch.where(curvature > 1e-12, 0.5 * (below - above) / curvature.clamp_min(1e-12), 0.0).clamp(-1.0, 1.0)
    refined = log2[middle] + shift * (log2[1] - log2[0])
    candidates = torch.cat((log2[best], refined), 1).exp2()

    angle = 2 * torch.pi * candidates[..., None] * time  # [N, 2, W]
    sine, cosine = angle.sin(), angle.cos()
    gram = sine.square().sum(-1), cosine.square().sum(-1), cosine.sum(-1)
    projections = (sine @ windows[..., None])[..., 0], (cosine @ windows[..., None])[..., 0]
    *solution, errors = _solve(*projections, *sums, *gram, len(time), low, high)
    chosen = errors.argmin(1, keepdim=True)
    a, b, offset, error, frequency = (x.gather(1, chosen)[:, 0] for x in (*solution, errors, candidates))
    residual = (error / len(time)).clamp_min(0.0).sqrt()
    return torch.atan2(b, a) % (2 * torch.pi), frequency, torch.hypot(a, b), offset, residual


def _solve(gs: Tensor, gc: Tensor, g1: Tensor, gg: Tensor, ss: Tensor, cc: Tensor, c1: Tensor, n: int, low: Tensor,
           high: Tensor) -> tuple[Tensor, Tensor, Tensor, Tensor]:  # fmt: skip
    """Best a·sin(ωt) + b·cos(ωt) + c within the bounds, and its squared error, from inner products over a window.

    ``gs gc g1 gg`` are those of the source with sine, cosine, one and itself, ``ss cc c1`` those of sine and cosine. The
    window is symmetric about the frame, so sine is orthogonal to both cosine and one.
    """
    a = gs / ss
    b = (gc * n - g1 * c1) / (cc * n - c1 * c1).clamp_min(1e-9)
    offset = torch.clamp((g1 - b * c1) / n, low, high)
    b = (gc - offset * c1) / cc
    scale = ((high - low) / torch.hypot(a, b).clamp_min(1e-12)).clamp(max=1.0)
    a, b = a * scale, b * scale
    offset = torch.clamp((g1 - b * c1) / n, low, high)
    error = gg - 2 * (a * gs + b * gc + offset * g1) + a**2 * ss + b**2 * cc + offset**2 * n + 2 * b * offset * c1
    return a, b, offset, error
