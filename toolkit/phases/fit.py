"""Least-squares sinusoids: a·sin(2π(f·t − s)) + b in a window around every frame (Starke et al. 2020, section 5.2).

For a fixed frequency the sinusoid is linear in (a·cos, a·sin, b), so only the frequency is searched: first on a grid, where
the sine and cosine are the same for every window, then by golden-section search around the two best grid points (variable
projection, Golub and Pereyra 1973). Deterministic, all windows at once, float64.
"""

from dataclasses import dataclass

import torch
from torch import Tensor

MIN_FREQUENCY, MAX_FREQUENCY = 0.25, 4.0


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


def fit(source: Tensor, fps: float, half_window: float = 0.5, grid: int = 48, steps: int = 8) -> Sinusoids:
    """Fit a sinusoid around every frame.

    Parameters
    ----------
    source : Tensor [F, L]
        One curve per limb.
    fps
        Frames per second.
    half_window
        Seconds on either side of the frame.
    grid, steps
        Frequencies tried, and golden-section steps around the best two of them.

    Notes
    -----
    Bounds as published: a in [0, max − min], f in [0.25, 4] Hz, b in [min, max] of the window.
    """
    half = max(2, round(half_window * fps))
    padded = torch.nn.functional.pad(source.double().T[:, None], (half, half), mode="reflect")[:, 0]
    windows = padded.unfold(-1, 2 * half + 1, 1).transpose(0, 1)  # [F, L, W]
    time = torch.arange(-half, half + 1, dtype=torch.float64) / fps
    low, high = windows.amin(-1), windows.amax(-1)

    frequencies = torch.logspace(*torch.tensor([MIN_FREQUENCY, MAX_FREQUENCY]).log2(), grid, 2.0, dtype=torch.float64)
    coarse = torch.stack([_solve(windows, time, f, low, high)[1] for f in frequencies], -1)
    best = _local_minima(coarse)
    candidates = []
    for rank in range(best.shape[-1]):
        frequency = frequencies[best[..., rank]]
        ratio = frequencies[1] / frequencies[0]
        bounds = (frequency / ratio).clamp(MIN_FREQUENCY), (frequency * ratio).clamp(max=MAX_FREQUENCY)
        candidates.append(_refine(windows, time, *bounds, low, high, steps))
    errors = torch.stack([_solve(windows, time, f, low, high)[1] for f in candidates])
    frequency = torch.stack(candidates).gather(0, errors.argmin(0)[None])[0]
    (sine, cosine, offset), error = _solve(windows, time, frequency, low, high)
    amplitude = torch.hypot(sine, cosine)
    phase = torch.atan2(cosine, sine) % (2 * torch.pi)
    return Sinusoids(phase, frequency, amplitude, offset, (error / len(time)).clamp_min(0).sqrt())


def _solve(windows: Tensor, time: Tensor, frequency: Tensor, low: Tensor, high: Tensor) -> tuple[tuple, Tensor]:
    """Best (a·cos s', a·sin s', b) at given frequencies ``[F, L]`` within the bounds, and the squared error."""
    angle = 2 * torch.pi * frequency[..., None] * time
    s, c = angle.sin(), angle.cos()  # the window is symmetric: s is odd, so it is orthogonal to c and to 1
    ss, cc, c1, n = (s * s).sum(-1), (c * c).sum(-1), c.sum(-1), float(len(time))
    gs, gc, g1 = (windows * s).sum(-1), (windows * c).sum(-1), windows.sum(-1)
    sine = gs / ss
    determinant = (cc * n - c1 * c1).clamp_min(1e-9)
    cosine = (gc * n - g1 * c1) / determinant
    offset = ((g1 - cosine * c1) / n).clamp(low, high)
    cosine = (gc - offset * c1) / cc
    scale = ((high - low) / torch.hypot(sine, cosine).clamp_min(1e-12)).clamp(max=1.0)
    sine, cosine = sine * scale, cosine * scale
    offset = ((g1 - cosine * c1) / n).clamp(low, high)
    gg = (windows * windows).sum(-1)
    error = (gg - 2 * (sine * gs + cosine * gc + offset * g1) + sine**2 * ss + cosine**2 * cc + offset**2 * n
             + 2 * cosine * offset * c1)  # fmt: skip
    return (sine, cosine, offset), error


def _local_minima(errors: Tensor, count: int = 2) -> Tensor:
    """Indices ``[..., count]`` of the deepest local minima along the last axis."""
    padded = torch.nn.functional.pad(errors, (1, 1), value=torch.inf)
    minimum = (errors <= padded[..., :-2]) & (errors <= padded[..., 2:])
    return torch.where(minimum, errors, torch.inf).topk(count, largest=False).indices


def _refine(windows: Tensor, time: Tensor, lower: Tensor, upper: Tensor, low: Tensor, high: Tensor, steps: int) -> Tensor:
    """Golden-section search of the projected error between frequencies ``lower`` and ``upper``."""
    golden = (5**0.5 - 1) / 2
    a, b = upper - golden * (upper - lower), lower + golden * (upper - lower)
    error_a, error_b = (_solve(windows, time, f, low, high)[1] for f in (a, b))
    for _ in range(steps):
        left = error_a < error_b
        lower, upper = torch.where(left, lower, a), torch.where(left, b, upper)
        a, b = (torch.where(left, upper - golden * (upper - lower), b),
                torch.where(left, a, lower + golden * (upper - lower)))  # fmt: skip
        new = _solve(windows, time, torch.where(left, a, b), low, high)[1]
        error_a, error_b = torch.where(left, new, error_b), torch.where(left, error_a, new)
    return (lower + upper) / 2
