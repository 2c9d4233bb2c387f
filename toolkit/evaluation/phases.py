"""Phase sources, compared with the true phases, frequencies and contacts of procedural clips."""

import math
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit import phases as ph
from toolkit.datasets import procedural
from toolkit.evaluation import metrics
from toolkit.motion import Clip, contacts

STILL = 0.02  # metres, root mean square distance from its mean position below which a hand has no phase


@dataclass(frozen=True)
class Row:
    """Errors of one clip: ``phase`` (degrees) and ``frequency`` (relative) ``[4]`` by source; NaN where undefined."""

    name: str
    phase: dict[str, Tensor]
    frequency: dict[str, Tensor]
    f1: list[float]


def measure(name: str, clip: Clip, truth: procedural.Truth, sources: dict[str, ph.Source]) -> Row:
    """Errors of all sources on one clip while it steps, without the first and the last second."""
    pace = ph.windows.mean(truth.frequency.double(), ph.windows.SECOND, clip.fps)
    inner = torch.arange(len(clip))
    inner = (inner >= clip.fps) & (inner < len(clip) - clip.fps)
    away = [ph.local_positions(clip, limb) for limb in ph.LIMBS]
    moved = [float((x - x.mean(0)).square().sum(-1).mean().sqrt()) for x in away]
    still = [limb.endswith("hand") and m < STILL for limb, m in zip(ph.LIMBS, moved, strict=True)]
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
    return Row(name, phase, frequency, f1)
