"""A source for stochastic styles: it tracks the cadence, and removes noise by the limbs' coherence.

Not in the paper, which says that its sources do "not handle stochasticity well": a sinusoid fitted
in a window also fits the noise. Two properties separate the swing of a limb from its noise. The
frequency of the swing changes slowly, and the other limbs swing with the same frequency and
constant phase differences, while their noise is independent.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import torch
from torch import Tensor

from toolkit.motion import Clip
from toolkit.phases import steps, windows
from toolkit.phases.sinusoids import Sinusoids, along
from toolkit.phases.sources import Hybrid, Source, curves

#: Frequencies that are tried as cadence, Hz.
BANDS = torch.logspace(math.log2(0.35), math.log2(2.5), 64, base=2, dtype=torch.float64)
HOP = 0.1  # seconds between frames of the cadence track
CYCLES = 2.5  # of the Morlet wavelets
PENALTY = 0.5  # weight of a squared jump in bands


@dataclass(frozen=True)
class Coherent:
    """Analytic signal of each limb's curve at its cadence, combined with what the others predict.

    The curves of `base` are filtered by Morlet wavelets. The cadence of a limb is the `ridge`
    through the bands of its velocity's power. On that path the complex signal z of the limb is
    predicted from the other three by least squares, ẑ; R² = ‖ẑ‖² / ‖z‖² is their coherence. The
    phase is the angle of (1 − R²) z + R² ẑ. A limb with an independent rhythm has R² near 0 and
    keeps its own phase, so the phase stays local.

    The steps of a foot give its phase directly (`toolkit.phases.steps`), as in `Hybrid`.
    """

    base: Source = field(default_factory=Hybrid)

    def fitted(self, clips: Sequence[Clip]) -> "Coherent":
        """The same source with its base fitted to `clips`."""
        if not hasattr(self.base, "fitted"):
            return self
        return replace(self, base=self.base.fitted(clips))

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """The curve ``[F]`` of the base, with its noise."""
        return self.base(clip, limb)

    def sinusoids(self, clip: Clip) -> tuple[Tensor, Sinusoids]:
        """Normalised and smoothed curves ``[F, 4]`` of the base, and each limb's sinusoids."""
        raw = curves(clip, self.base)
        waves = wavelets(raw - raw.mean(0), clip.fps)
        hop = max(1, round(HOP * clip.fps))
        at = torch.arange(len(raw), device=raw.device)
        columns = []
        for i in range(raw.shape[1]):
            half = windows.half_window(raw[:, i], clip.fps)
            curve = windows.normalise(raw[:, [i]], clip.fps, half)
            curve = windows.smooth(curve, clip.fps)[:, 0]
            signal = steps.signal(raw[:, i])
            if signal is None:
                # all limbs at the cadence of this one, between the two nearest bands
                power = waves[..., i].abs().square() * BANDS[:, None].to(raw).square()
                path = ridge(power, hop)
                below = path.long().clamp(max=len(BANDS) - 2)
                share = (path - below)[:, None]
                z = waves[below, at] * (1 - share) + waves[below + 1, at] * share
                signal = denoised(z, i)
            found = along(signal, curve, clip.fps, half)
            columns.append((curve, *vars(found).values()))
        curve, *found = (torch.stack(column, 1) for column in zip(*columns, strict=True))
        return curve, Sinusoids(*found)


def wavelets(values: Tensor, fps: float) -> Tensor:
    """Complex Morlet transform ``[bands, F, C]`` of real ``values [F, C]``, mirrored at their ends.

    A cosine gives e^iωt.
    """
    pad = min(len(values) - 1, round(CYCLES / float(BANDS[0]) * fps))
    padded = torch.cat((values[1 : pad + 1].flip(0), values, values[-pad - 1 : -1].flip(0)))
    step = {"dtype": values.dtype, "device": values.device}
    frequency = torch.fft.fftfreq(len(padded), 1 / fps, **step)
    away = (frequency / BANDS[:, None].to(values) - 1) * CYCLES
    bell = 2 * torch.exp(-0.5 * away**2) * (frequency > 0)
    filtered = torch.fft.ifft(bell[..., None] * torch.fft.fft(padded, dim=0), dim=1)
    return filtered[:, pad : pad + len(values)]


def ridge(power: Tensor, hop: int) -> Tensor:
    """Path ``[F]`` through ``power [bands, F]``, as fractional band indices.

    Found on every `hop`-th frame, it minimises the sum of −ln(share of the frame's power in the
    band) + `PENALTY` · (jump in bands)².
    """
    from toolkit.phases.variable_projection import smoothest

    share = power / power.sum(0).clamp_min(1e-30)
    cost = -share.clamp_min(1e-12).log()[:, ::hop].T
    band = np.arange(len(power))
    jump = PENALTY * np.subtract.outer(band, band) ** 2.0
    path = smoothest(cost.double().cpu().contiguous().numpy(), jump)
    knots = torch.from_numpy(path[[*range(len(path)), -1]]).to(power)
    at = torch.arange(power.shape[1], dtype=power.dtype, device=power.device) / hop
    return torch.lerp(knots[at.long()], knots[at.long() + 1], at - at.long())


def denoised(z: Tensor, limb: int) -> Tensor:
    """One column ``[F]`` of complex ``z [F, C]``, moved to its prediction with the weight R²."""
    own, others = z[:, limb], torch.cat((z[:, :limb], z[:, limb + 1 :]), 1)
    gram = others.mH @ others
    gram = gram + torch.diag(1e-3 * gram.diagonal() + 1e-12)
    told = others @ torch.linalg.solve(gram, others.mH @ own)
    coherence = float(told.abs().square().sum() / own.abs().square().sum().clamp_min(1e-12))
    return torch.lerp(own, told, min(coherence, 1.0))
