"""Phase sources and contacts against the known truth of procedural clips."""

import math
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit import phases as ph
from toolkit.datasets import procedural
from toolkit.evaluation import metrics
from toolkit.motion import Clip, contacts

FREQUENCY_LIMIT, F1_LIMIT = 0.03, 0.95
STILL = 0.02  # metres from its mean place, root mean square: a hand that moves less has no phase to be found
KINDS = ("cyclic", "asymmetric", "no global phase", "one leg never touches", "stochastic")


@dataclass(frozen=True)
class Row:
    """Errors of one clip. ``phase`` degrees and ``frequency`` relative, ``[4]`` by source; NaN where nothing can be said."""

    name: str
    kind: str
    phase: dict[str, Tensor]
    frequency: dict[str, Tensor]
    f1: list[float]


@dataclass(frozen=True)
class Part:
    """Limbs by their columns in `toolkit.phases.LIMBS`, and the source that is held to a limit on them, in degrees."""

    columns: slice
    source: str
    limit: float

    def slip(self, row: Row) -> Tensor:
        """Worse relative error of the two limbs' mean frequency, by that source."""
        found = row.frequency.get(self.source, torch.full((4,), math.nan))[self.columns]
        return found.nan_to_num().max() if not found.isnan().all() else found.max()


PARTS = {"feet": Part(slice(2, 4), "contact", 20.0), "hands": Part(slice(0, 2), "contact-free", 15.0)}


def measure(name: str, clip: Clip, truth: procedural.Truth, kind: str, sources: dict[str, ph.Source]) -> Row:
    """Errors of all sources on one clip, on its stepping stretches and where no window reaches beyond its ends."""
    pace = ph.windows.mean(truth.frequency.double(), ph.windows.SECOND, clip.fps)
    inner = torch.arange(len(clip))
    inner = (inner >= clip.fps) & (inner < len(clip) - clip.fps)
    still = [_still(clip, limb) for limb in ph.LIMBS]
    phase, frequency = {}, {}
    for label, source in sources.items():
        found = ph.extract(clip, source)
        silent = found.vector.abs().amax((0, 2)) == 0
        phase[label], frequency[label] = torch.full((2, 4), math.nan).unbind()
        for limb in range(4):
            stepping = inner & (pace[:, limb] > 0.2)
            if still[limb] or silent[limb] or stepping.sum() < clip.fps:
                continue
            error, _ = metrics.phase_error(found.phase[stepping, limb], truth.phase[stepping, limb])
            phase[label][limb] = math.degrees(error)
            true = truth.frequency[stepping, limb].mean()
            frequency[label][limb] = (found.frequency[stepping, limb].mean() / true - 1).abs()
    found, true = contacts.detect(clip), truth.contacts
    f1 = [float(2 * (found * true)[:, i].sum() / (found + true)[:, i].sum()) for i in range(2) if true[:, i].any()]
    return Row(name, kind, phase, frequency, f1)


def kind(style: procedural.Style) -> str:
    """Which of `KINDS`: the paper's hard cases, and the rest."""
    if style.stagger > 0:
        return "stochastic"
    legs, arms = ([part("left"), part("right")] for part in (style.leg, style.arm))
    if any(leg.raised for leg in legs):
        return "one leg never touches"
    if style.asymmetry or legs[0] != legs[1]:
        return "asymmetric"
    return "no global phase" if any(arm.ratio != 1 or arm.phase for arm in arms) else "cyclic"


def _still(clip: Clip, limb: str) -> bool:
    """Whether a hand hardly moves in the hips' frame."""
    away = ph.local_positions(clip, limb)
    return limb.endswith("hand") and float((away - away.mean(0)).square().sum(-1).mean().sqrt()) < STILL


def failures(row: Row) -> list[str]:
    """The limits that a row does not keep, in words."""
    found = []
    for limbs, part in PARTS.items():
        worst = row.phase[part.source][part.columns].nan_to_num().max() if part.source in row.phase else 0.0
        if worst > part.limit:
            found.append(f"{part.source} {limbs} {worst:.1f}°")
        if part.slip(row) > FREQUENCY_LIMIT:
            found.append(f"frequency of the {limbs} {float(part.slip(row)):.1%}")
    if min(row.f1) < F1_LIMIT:
        found.append(f"F1 {min(row.f1):.3f}")
    return found
