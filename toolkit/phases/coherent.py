"""A source for stochastic styles (not in the paper): it tracks the cadence, and removes noise by the coherence of the limbs.

The paper says that its sources do "not handle stochasticity well": a sinusoid fitted in a window also fits the noise. Two
properties separate the swing of a limb from its noise. The frequency of the swing changes slowly, and the other limbs swing
with the same frequency and constant phase differences, while their noise is independent.
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

    The steps of a foot give its phase directly (`toolkit.phases.steps`), as in `Hybrid`.
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
        hop = max(1, round(HOP * clip.fps))
        columns = []
        for i in range(raw.shape[1]):
            path = ridge(waves[..., i].abs().square() * BANDS[:, None].to(raw).square(), hop, self.penalty)
            below = path.long().clamp(max=len(BANDS) - 2)
            at, share = torch.arange(len(raw), device=raw.device), (path - below)[:, None]
            z = waves[below, at] * (1 - share) + waves[below + 1, at] * share
            half = windows.half_window(raw[:, i], clip.fps)
            curve = windows.smooth(windows.normalise(raw[:, [i]], clip.fps, half), clip.fps)[:, 0]
            stepped = steps.signal(raw[:, i])
            found = along(denoised(z, i) if stepped is None else stepped, curve, clip.fps, half)
            columns.append((curve, *vars(found).values()))
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
    from toolkit.phases.variable_projection import smoothest

    cost = -(power / power.sum(0).clamp_min(1e-30)).clamp_min(1e-12).log()[:, ::hop].T
    jump = penalty * np.subtract.outer(np.arange(len(power)), np.arange(len(power))) ** 2.0
    path = smoothest(cost.double().cpu().contiguous().numpy(), jump)
    knots = torch.from_numpy(path[[*range(len(path)), -1]]).to(power)
    at = torch.arange(power.shape[1], dtype=power.dtype, device=power.device) / hop
    return torch.lerp(knots[at.long()], knots[at.long() + 1], at - at.long())


def denoised(z: Tensor, limb: int) -> Tensor:
    """One column ``[F]`` of complex ``z [F, C]``, interpolated to its prediction from the others with weight R²."""
    own, others = z[:, limb], torch.cat((z[:, :limb], z[:, limb + 1 :]), 1)
    gram = others.mH @ others
    gram = gram + torch.diag(1e-3 * gram.diagonal() + 1e-12)
    told = others @ torch.linalg.solve(gram, others.mH @ own)
    coherence = float(told.abs().square().sum() / own.abs().square().sum().clamp_min(1e-12))
    return torch.lerp(own, told, min(coherence, 1.0))
