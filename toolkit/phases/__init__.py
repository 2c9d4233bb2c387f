"""Local motion phases (Mason et al. 2022, section 4.1): source function → normalise and smooth → sinusoid fit → feature.

>>> ph = extract(clip, source="hybrid")
>>> ph.vector.shape          # frames, limbs (left hand, right hand, left foot, right foot), (sin, cos)
"""

from collections.abc import Sequence
from dataclasses import dataclass

import torch
from scipy.signal import butter, sosfiltfilt
from torch import Tensor

from toolkit.motion import Clip
from toolkit.phases.fit import Sinusoids, fit
from toolkit.phases.sources import LIMBS, SOURCES, Contact, ContactFree, Hybrid, Source, local_positions

__all__ = ["LIMBS", "SOURCES", "Contact", "ContactFree", "Hybrid", "Phases", "Sinusoids", "Source", "extract",
           "extract_group", "fit", "local_positions", "normalise", "smooth"]  # fmt: skip

CUTOFF = 4.0  # Hz, of the Butterworth filter
WINDOW = 0.5  # seconds on either side of a frame: normalisation and speed


@dataclass(frozen=True, eq=False)
class Phases:
    """Local phases of F frames and four limbs, in the order of `LIMBS`.

    Parameters
    ----------
    vector : Tensor [F, 4, 2]
        Phase features, equation (1): speed · amplitude · (sin, cos), metres per second.
    phase, frequency, amplitude, residual : Tensor [F, 4]
        The fitted sinusoid at the frame: radians in [0, 2π), Hz, and two in units of the normalised source.
    source, fit : Tensor [F, 4]
        The normalised, smoothed source and the fitted sinusoid's value at the frame.
    """

    vector: Tensor
    phase: Tensor
    frequency: Tensor
    amplitude: Tensor
    residual: Tensor
    source: Tensor
    fit: Tensor


def extract(clip: Clip, source: str | Source = "hybrid", half_window: float = 0.5) -> Phases:
    """Local phases of one clip; see `extract_group` for several of the same style and gait."""
    return extract_group([clip], source, half_window)[0]


def extract_group(clips: Sequence[Clip], source: str | Source = "hybrid", half_window: float = 0.5) -> list[Phases]:
    """Local phases of clips of one style and gait, which share the source's principal axes (section 4.1.3).

    Parameters
    ----------
    clips
        Motions, any rate.
    source
        A name of `SOURCES` or a function ``(clip, limb) -> Tensor [F]``.
    half_window
        Seconds on either side of a frame that the sinusoid is fitted to. The published run used 15 frames at 60 Hz; 30
        agree better with what its network predicts.

    Raises
    ------
    ValueError
        If the source's name is unknown, or a clip is shorter than the normalisation window.
    """
    if isinstance(source, str):
        if source not in SOURCES:
            raise ValueError(f"unknown phase source {source!r}; there are {', '.join(SOURCES)}")
        source = SOURCES[source]
    for clip in clips:
        shortest = 2 * round(WINDOW * clip.fps) + 1
        if len(clip) < shortest:
            raise ValueError(f"{clip.name}: {len(clip)} frames are too few for phases, which need {shortest} "
                             f"(one second) at {clip.fps:g} Hz")  # fmt: skip
    if hasattr(source, "fitted"):
        source = source.fitted(clips)
    return [_extract(clip, source, half_window) for clip in clips]


def _extract(clip: Clip, source: Source, half_window: float) -> Phases:
    raw = torch.stack([torch.as_tensor(source(clip, limb)).double() for limb in LIMBS], 1)
    if raw.shape != (len(clip), len(LIMBS)) or not bool(torch.isfinite(raw).all()):
        raise ValueError(f"{clip.name}: a source must give one finite number per frame ({len(clip)}) for every limb")
    curve = smooth(normalise(raw, clip.fps), clip.fps)
    found = fit(curve, clip.fps, half_window)
    speed = torch.stack([local_speed(clip, limb) for limb in LIMBS], 1)
    direction = torch.stack((found.phase.sin(), found.phase.cos()), -1)
    direction = torch.nn.functional.normalize(smooth(direction, clip.fps), dim=-1)
    magnitude = smooth(speed * found.amplitude, clip.fps).clamp_min(0.0)
    value = found.amplitude * found.phase.sin() + found.offset
    return Phases(
        (magnitude[..., None] * direction).float(),
        *(t.float() for t in (torch.atan2(direction[..., 0], direction[..., 1]) % (2 * torch.pi), found.frequency,
                              found.amplitude, found.residual, curve, value)),
    )  # fmt: skip


def normalise(curves: Tensor, fps: float) -> Tensor:
    """Z-score of ``curves [F, ...]`` in a one-second window around each frame; a constant window gives 0."""
    mean = _window_mean(curves, fps)
    variance = (_window_mean(curves**2, fps) - mean**2).clamp_min(0.0)
    scale = curves.abs().amax(0).clamp_min(1e-9)
    return torch.where(variance.sqrt() > 1e-4 * scale, (curves - mean) / variance.sqrt().clamp_min(1e-12), 0.0)


def smooth(curves: Tensor, fps: float) -> Tensor:
    """Second-order zero-phase Butterworth low-pass at `CUTOFF` along the first axis, float64."""
    filtered = sosfiltfilt(butter(2, CUTOFF, fs=fps, output="sos"), curves.double().numpy(), axis=0)
    return torch.from_numpy(filtered.copy())


def local_speed(clip: Clip, limb: str) -> Tensor:
    """‖v_w‖ of equation (1), ``[F]`` m/s: mean speed over one second of the limb's position relative to the hips."""
    points = local_positions(clip, limb).double()
    speed = torch.gradient(points, spacing=1 / clip.fps, dim=0)[0].norm(dim=-1)
    return _window_mean(speed, clip.fps)


def _window_mean(values: Tensor, fps: float) -> Tensor:
    half = round(WINDOW * fps)
    flat = values.reshape(len(values), -1).T[:, None]
    padded = torch.nn.functional.pad(flat, (half, half), mode="replicate")
    return torch.nn.functional.avg_pool1d(padded, 2 * half + 1, stride=1)[:, 0].T.reshape(values.shape)
