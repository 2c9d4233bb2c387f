"""Local motion phases (Mason et al. 2022, section 4.1): source → z-score → sinusoid fit → feature.

>>> ph = extract(clip, source="hybrid")
>>> ph.vector.shape          # frames, limbs (`LIMBS`), (sin, cos)
"""

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit import registry
from toolkit.motion import Clip
from toolkit.motion.tensors import summary
from toolkit.phases import sources, windows
from toolkit.phases.sinusoids import Sinusoids, along, fit

from toolkit.phases.sources import (  # isort: skip
    LIMBS, Contact, ContactFree, Hybrid, Source, Velocity, curves, local_positions,
)
from toolkit.phases.steps import Steps
from toolkit.phases.windows import normalise, smooth

__all__ = [
    "LIMBS", "SOURCES", "Contact", "ContactFree", "Hybrid", "Phases", "Sinusoids", "Source",
    "Steps", "Velocity", "curves", "extract", "extract_group", "fit", "local_positions", "named",
    "normalise", "smooth", "windows",
]

#: The paper's sources and ours: functions that make them. Add-ons register more as ``source.NAME``
#: (`toolkit.registry`).
SOURCES: dict[str, Callable[[], Source]] = {
    "hybrid": Hybrid, "contact": Contact, "contact-free": ContactFree, "velocity": Velocity}


@dataclass(frozen=True, eq=False)
class Phases:
    """Local phases of F frames and K limbs, usually `LIMBS`; all but ``vector`` are ``[F, K]``."""

    vector: Tensor  # [F, K, 2] equation (1): speed · amplitude · (sin, cos), metres per second
    phase: Tensor  # of the fitted sinusoids, smoothed over frames, radians in [0, 2π)
    frequency: Tensor  # of the sinusoid, Hz
    amplitude: Tensor  # of the sinusoid, in units of the normalised source
    residual: Tensor  # of the fit, in units of the normalised source
    source: Tensor  # normalised and smoothed
    fit: Tensor  # value of the sinusoid
    limbs: tuple[str, ...] = LIMBS
    __repr__ = summary


def extract(clip: Clip, source: str | Source = "hybrid") -> Phases:
    """Local phases of one clip; see `extract_group` for several of the same style and gait."""
    return extract_group([clip], source)[0]


def extract_group(clips: Sequence[Clip], source: str | Source = "hybrid") -> list[Phases]:
    """Local phases of clips of one style and gait, which share principal axes (section 4.1.3).

    The ``source`` is a name of `SOURCES` or a function ``(clip, limb) -> Tensor [F]``. It may have
    ``limbs``: names of any number of limbs, joints or roles, in place of `LIMBS`. It may have three
    methods: ``fitted(clips)`` returns the source that is used instead; ``sinusoids(clip) -> (curve
    [F, K], Sinusoids)`` replaces the fit; ``signal(curve) -> complex Tensor [F]`` gives the phase
    by its angle where it does not return None, so that only amplitude and offset are fitted.

    ValueError if the source's name is unknown, or a clip is shorter than one second. A source that
    is constant for all limbs in all clips has no phase, and a warning says so.

    Notes
    -----
    Departure: curves are z-scored and fitted in windows of about a cycle of each limb, one second
    or more (`windows.half_window`); in the published run, in one second and half a second. The
    feature is p = ‖v‖ a (sin φ, cos φ). ``a`` is the amplitude of the fitted sinusoid (equation 1).
    The paper leaves open which speed ‖v‖ is: here the root-mean-square over one second, in the
    hips' frame.
    """
    if isinstance(source, str):
        source = named(source)
    for clip in clips:
        shortest = 2 * round(windows.SECOND * clip.fps) + 1
        if len(clip) < shortest:
            raise ValueError(f"{clip.name}: {len(clip)} frames are too few for phases, which need "
                             f"{shortest} (one second) at {clip.fps:g} Hz")
    if hasattr(source, "fitted"):
        source = source.fitted(clips)
    found = [_extract(clip, source) for clip in clips]
    if found and not any(bool(ph.amplitude.any()) for ph in found):
        warnings.warn("the phase source is constant in all clips of a style and gait, so that "
                      "their phases are 0", stacklevel=3)
    return found


def named(source: str) -> Source:
    """The source with a name: one of `SOURCES`, or one that is registered."""
    known = (*SOURCES, *registry.names("source"))
    if source not in known:
        raise ValueError(f"unknown phase source {source!r}; known: {', '.join(known)}")
    return (SOURCES.get(source) or registry.find(f"source.{source}"))()


def _extract(clip: Clip, source: Source) -> Phases:
    if hasattr(source, "sinusoids"):
        curve, found = source.sinusoids(clip)
    else:
        curve, found = _fitted(clip, source)
    # size: large where the limb moves fast
    limbs = sources.limbs_of(source)
    positions = torch.stack([local_positions(clip, limb) for limb in limbs], 1).double()
    size = windows.speed(positions, clip.fps) * found.amplitude.double()
    # phase: the direction is smoothed, because angles cannot be averaged
    direction = torch.stack((found.phase.sin(), found.phase.cos()), -1)
    smoothed = smooth(torch.cat((direction, size[..., None]), -1), clip.fps)
    direction, size = smoothed[..., :2], smoothed[..., 2].clamp_min(0.0)
    direction = torch.nn.functional.normalize(direction, dim=-1)
    phase = torch.atan2(direction[..., 0], direction[..., 1]) % (2 * torch.pi)
    value = found.amplitude * found.phase.sin() + found.offset
    columns = (size[..., None] * direction, phase, found.frequency, found.amplitude, found.residual,
               curve, value)
    return Phases(*(column.to(clip.rotations) for column in columns), limbs=limbs)


def _fitted(clip: Clip, source: Source) -> tuple[Tensor, Sinusoids]:
    """Normalised and smoothed curves ``[F, K]`` of a source, and their sinusoids."""
    raws = curves(clip, source).split(1, dim=1)
    halves = [windows.half_window(raw[:, 0], clip.fps) for raw in raws]
    scored = [normalise(raw, clip.fps, half) for raw, half in zip(raws, halves, strict=True)]
    curve = smooth(torch.cat(scored, 1), clip.fps)
    found = []
    for raw, half, column in zip(raws, halves, curve.split(1, dim=1), strict=True):
        signal = source.signal(raw[:, 0]) if hasattr(source, "signal") else None
        one = (fit(column, clip.fps, half) if signal is None
               else along(signal[:, None], column, clip.fps, half))
        found.append(vars(one).values())
    return curve, Sinusoids(*(torch.cat(part, 1) for part in zip(*found, strict=True)))
