"""A source for stochastic styles (not in the paper): it tracks the cadence, and removes noise by the coherence of the limbs.

The paper says that its sources do "not handle stochasticity well": a sinusoid fitted in a window also fits the noise. Two
properties separate the swing of a limb from its noise. The frequency of the swing changes slowly, and the other limbs swing
with the same frequency and constant phase differences, while their noise is independent.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.motion import Clip
from toolkit.phases import windows
from toolkit.phases.sinusoids import MAX_FREQUENCY, MIN_FREQUENCY, Sinusoids
from toolkit.phases.sources import Hybrid, Source, curves

BANDS = torch.logspace(math.log2(0.35), math.log2(2.5), 64, base=2, dtype=torch.float64)  # Hz, tried as cadence
HOP = 0.1  # seconds between frames of the cadence track


@dataclass(frozen=True)
class Coherent:
    """Analytic signal of each limb's curve at its cadence, combined with its prediction from the other limbs.

    The curves of `base` are filtered by Morlet wavelets of `cycles` cycles. The cadence of a limb is a path through the
    bands with large power of the limb's velocity and small jumps (weight `penalty`), found by dynamic programming. On that
    path the complex signal z of the limb is predicted from the other three by least squares, ẑ; R² = ‖ẑ‖² / ‖z‖² is their
    coherence. The phase is the angle of (1 − R²) z + R² ẑ. A limb with an independent rhythm has R² near 0 and keeps its own
    phase, so the phase stays local.

    Contacts give the phase of a foot directly, also for irregular steps: a curve of 0 and 1 has the angle 0 in the middle of
    each contact and π in the middle of each swing, and is linear in time between them (as in Holden et al. 2017).
    """

    base: Source = field(default_factory=Hybrid)
    cycles: float = 2.5
    penalty: float = 0.5

    def fitted(self, clips: Sequence[Clip]) -> "Coherent":
        """The same source with its base fitted to `clips`."""
        return replace(self, base=self.base.fitted(clips)) if hasattr(self.base, "fitted") else self

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """The curve ``[F]`` of the base, with its noise."""
        return self.base(clip, limb)

    def sinusoids(self, clip: Clip) -> tuple[Tensor, Sinusoids]:
        """The base's curves, normalised and smoothed ``[F, 4]``, and the sinusoid of each limb at each frame."""
        raw = curves(clip, self.base)
        waves = wavelets(raw - raw.mean(0), clip.fps, self.cycles)
        contact = ((raw == 0) | (raw == 1)).all(0) & (raw.diff(dim=0).count_nonzero(0) > 2)
        hop = max(1, round(HOP * clip.fps))
        columns = []
        for i in range(raw.shape[1]):
            path = ridge(waves[..., i].abs().square() * BANDS[:, None].to(raw).square(), hop, self.penalty)
            below = path.long().clamp(max=len(BANDS) - 2)
            at, share = torch.arange(len(raw), device=raw.device), (path - below)[:, None]
            z = waves[below, at] * (1 - share) + waves[below + 1, at] * share
            half = windows.half_window(raw[:, i], clip.fps)
            curve = windows.smooth(windows.normalise(raw[:, [i]], clip.fps, half), clip.fps)[:, 0]
            signal = contact_signal(raw[:, i]) if contact[i] else denoised(z, i)
            phase = (signal.angle() + math.pi / 2) % (2 * math.pi)  # so that its sine is the real part
            turns = (signal[1:] * signal[:-1].conj()).angle() / (2 * math.pi)
            frequency = windows.mean(torch.cat((turns[:1], turns)), half, clip.fps) * clip.fps
            frequency = frequency.clamp(MIN_FREQUENCY, MAX_FREQUENCY)
            columns.append((curve, phase, frequency, *regression(curve, phase.sin(), half, clip.fps)))
        curve, *found = (torch.stack(column, 1) for column in zip(*columns, strict=True))
        return curve, Sinusoids(*found)


def wavelets(values: Tensor, fps: float, cycles: float) -> Tensor:
    """Complex Morlet transform ``[bands, F, C]`` of real ``values [F, C]``, mirrored at their ends; a cosine gives e^iωt."""
    pad = min(len(values) - 1, round(cycles / float(BANDS[0]) * fps))
    padded = torch.cat((values[1 : pad + 1].flip(0), values, values[-pad - 1 : -1].flip(0)))
    frequency = torch.fft.fftfreq(len(padded), 1 / fps, dtype=values.dtype, device=values.device)
    bell = 2 * torch.exp(-0.5 * ((frequency / BANDS[:, None].to(values) - 1) * cycles) ** 2) * (frequency > 0)
    return torch.fft.ifft(bell[..., None] * torch.fft.fft(padded, dim=0), dim=1)[:, pad : pad + len(values)]


def ridge(power: Tensor, hop: int, penalty: float) -> Tensor:
    """Path ``[F]`` through ``power [bands, F]``, as fractional band indices, found on every `hop`-th frame.

    It minimises the sum of −ln(share of the frame's power in the band) + penalty · (jump in bands)².
    """
    cost = -(power / power.sum(0).clamp_min(1e-30)).clamp_min(1e-12).log()[:, ::hop].T
    band = torch.arange(len(power), dtype=power.dtype, device=power.device)
    jump = penalty * (band[:, None] - band).square()
    total, origins = cost[0], []
    for step in cost[1:]:
        least, origin = (total + jump).min(1)
        origins.append(origin)
        total = least + step
    path = [int(total.argmin())]
    for origin in reversed(origins):
        path.append(int(origin[path[-1]]))
    knots = torch.tensor([*reversed(path), path[0]], dtype=power.dtype, device=power.device)
    at = torch.arange(power.shape[1], dtype=power.dtype, device=power.device) / hop
    return torch.lerp(knots[at.long()], knots[at.long() + 1], at - at.long())


def regression(curve: Tensor, wave: Tensor, half: float, fps: float) -> tuple[Tensor, Tensor, Tensor]:
    """Amplitude, offset and residual ``[F]`` of the curve as a multiple of a wave, by least squares in each window."""
    c, w = (windows.mean(x, half, fps) for x in (curve, wave))
    cc, ww, cw = (windows.mean(x, half, fps) for x in (curve.square(), wave.square(), curve * wave))
    amplitude = ((cw - c * w) / (ww - w * w).clamp_min(1e-9)).clamp_min(0.0)
    offset = c - amplitude * w
    residual = cc - 2 * (amplitude * cw + offset * c) + amplitude**2 * ww + 2 * amplitude * offset * w + offset**2
    return amplitude, offset, residual.clamp_min(0.0).sqrt()


def contact_signal(contact: Tensor) -> Tensor:
    """Complex signal ``[F]`` of a 0/1 curve with at least three changes: angle 0 in the middle of ones, π of zeros."""
    value = contact.cpu().numpy()
    change = np.flatnonzero(np.diff(value)) + 0.5
    middle = (change[1:] + change[:-1]) / 2
    angle = np.pi * (np.arange(len(middle)) + (value[int(middle[0])] == 0))
    grow = scipy.interpolate.interp1d(middle, angle, fill_value="extrapolate", assume_sorted=True)
    return torch.exp(1j * torch.from_numpy(grow(np.arange(len(value)))).to(contact))


def denoised(z: Tensor, limb: int) -> Tensor:
    """One column ``[F]`` of complex ``z [F, C]``, interpolated to its prediction from the others with weight R²."""
    own, others = z[:, limb], torch.cat((z[:, :limb], z[:, limb + 1 :]), 1)
    gram = others.mH @ others
    gram = gram + torch.diag(1e-3 * gram.diagonal() + 1e-12)
    told = others @ torch.linalg.solve(gram, others.mH @ own)
    coherence = float(told.abs().square().sum() / own.abs().square().sum().clamp_min(1e-12))
    return torch.lerp(own, told, min(coherence, 1.0))
