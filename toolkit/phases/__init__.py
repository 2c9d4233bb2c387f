"""Local motion phases (Mason et al. 2022, section 4.1): source function → normalise and smooth → sinusoid fit → feature.

>>> ph = extract(clip, source="hybrid")
>>> ph.vector.shape          # frames, limbs (left hand, right hand, left foot, right foot), (sin, cos)
"""

import pkgutil
from collections.abc import Sequence
from dataclasses import dataclass

import lazy_loader
import torch
from torch import Tensor

from toolkit.motion import Clip
from toolkit.motion.tensors import summary
from toolkit.phases import windows
from toolkit.phases.coherent import Coherent
from toolkit.phases.sinusoids import Sinusoids, along, fit
from toolkit.phases.sources import LIMBS, Contact, ContactFree, Hybrid, Source, Velocity, curves, local_positions
from toolkit.phases.steps import Steps
from toolkit.phases.windows import normalise, smooth

__all__ = ["LIMBS", "SOURCES", "Coherent", "Contact", "ContactFree", "Hybrid", "Phases", "Sinusoids", "Source", "Steps",
           "Velocity", "curves", "extract", "extract_group", "fit", "local_positions", "named", "normalise", "smooth",
           "windows"]
__getattr__ = lazy_loader.attach(__name__, [module.name for module in pkgutil.iter_modules(__path__)])[0]

#: Sources by name; `named` also knows "learned", which is read from its file.
SOURCES: dict[str, Source | Coherent] = {"hybrid": Hybrid(), "contact": Contact(), "contact-free": ContactFree(),
                                         "velocity": Velocity(), "coherent": Coherent()}


@dataclass(frozen=True, eq=False)
class Phases:
    """Local phases of F frames and four limbs, in the order of `LIMBS`; all but ``vector`` are ``[F, 4]``."""

    vector: Tensor  # [F, 4, 2] phase features, equation (1): speed · amplitude · (sin, cos), metres per second
    phase: Tensor  # of the fitted sinusoid at the frame, radians in [0, 2π)
    frequency: Tensor  # of the sinusoid, Hz
    amplitude: Tensor  # of the sinusoid, in units of the normalised source
    residual: Tensor  # of the fit, in units of the normalised source
    source: Tensor  # normalised and smoothed
    fit: Tensor  # value of the sinusoid
    __repr__ = summary


def extract(clip: Clip, source: str | Source = "hybrid", half_window: float | None = None) -> Phases:
    """Local phases of one clip; see `extract_group` for several of the same style and gait."""
    return extract_group([clip], source, half_window)[0]


def extract_group(clips: Sequence[Clip], source: str | Source = "hybrid",
                  half_window: float | None = None) -> list[Phases]:
    """Local phases of clips of one style and gait, which share the source's principal axes (section 4.1.3).

    Parameters
    ----------
    clips
        Motions, any rate.
    source
        A name of `SOURCES`, "learned" or a function ``(clip, limb) -> Tensor [F]``. If the source has a method
        ``fitted(clips)``, the source that it returns is used. If the source has a method ``sinusoids(clip) -> (curve
        [F, 4], Sinusoids)``, no sinusoid is fitted. If it has a method ``signal(curve) -> complex Tensor [F]`` that does not
        return None, the phase is the angle of that signal, and only amplitude and offset are fitted.
    half_window
        Half the length of the fit's window, seconds; by default the duration of about half a cycle of each limb, at least
        half a second (`windows.half_window`).

    Raises
    ------
    ValueError
        If the source's name is unknown, or a clip is shorter than one second.

    Notes
    -----
    The feature is p = ‖v‖ a (sin φ, cos φ). ``a`` is the amplitude of the fitted sinusoid (equation 1). The paper leaves
    open which speed ‖v‖ is: here the root-mean-square over one second, in the hips' frame.
    """
    if isinstance(source, str):
        source = named(source)
    for clip in clips:
        shortest = 2 * round(windows.SECOND * clip.fps) + 1
        if len(clip) < shortest:
            raise ValueError(f"{clip.name}: {len(clip)} frames are too few for phases, which need {shortest} "
                             f"(one second) at {clip.fps:g} Hz")
    if hasattr(source, "fitted"):
        source = source.fitted(clips)
    return [_extract(clip, source, half_window) for clip in clips]


def named(source: str) -> Source:
    """The source with a name; "learned" is read from its file."""
    if source == "learned":
        from toolkit.phases.learned import pretrained

        return pretrained()
    if source not in SOURCES:
        raise ValueError(f"unknown phase source {source!r}; known: {', '.join((*SOURCES, 'learned'))}")
    return SOURCES[source]


def _extract(clip: Clip, source: Source, half_window: float | None) -> Phases:
    curve, found = source.sinusoids(clip) if hasattr(source, "sinusoids") else _fitted(clip, source, half_window)
    speed = torch.stack([windows.speed(local_positions(clip, limb).double(), clip.fps) for limb in LIMBS], 1)
    direction = torch.stack((found.phase.sin(), found.phase.cos()), -1)
    direction = torch.nn.functional.normalize(smooth(direction, clip.fps), dim=-1)
    magnitude = smooth(speed * found.amplitude.double(), clip.fps).clamp_min(0.0)
    value = found.amplitude * found.phase.sin() + found.offset
    phase = torch.atan2(direction[..., 0], direction[..., 1]) % (2 * torch.pi)
    columns = (magnitude[..., None] * direction, phase, found.frequency, found.amplitude, found.residual, curve, value)
    return Phases(*(column.to(clip.rotations) for column in columns))


def _fitted(clip: Clip, source: Source, half_window: float | None) -> tuple[Tensor, Sinusoids]:
    columns = []
    stepped = getattr(source, "signal", lambda raw: None)
    for raw in curves(clip, source).split(1, dim=1):
        half = windows.half_window(raw[:, 0], clip.fps) if half_window is None else half_window
        curve = smooth(normalise(raw, clip.fps, max(half, windows.SECOND)), clip.fps)
        signal = stepped(raw[:, 0])
        found = fit(curve, clip.fps, half) if signal is None else along(signal[:, None], curve, clip.fps, half)
        columns.append((curve, found.phase, found.frequency, found.amplitude, found.offset, found.residual))
    curve, *found = (torch.cat(column, 1) for column in zip(*columns, strict=True))
    return curve, Sinusoids(*found)
