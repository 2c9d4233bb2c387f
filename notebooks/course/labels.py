"""Phase sources, compared with true phases of procedural clips, and with phases a person labelled.

The labelled phase (Holden et al. 2017, section 3) belongs to the whole body: 0 where the right foot
touches down, ½ where the left foot does, straight lines in between. A foot's own phase is another
one: where the left step comes early or late, the right foot's label bends, but the right foot does
not. `floor` measures this difference, which no local phase can be free of.
"""

import io
import math
import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit import phases as ph
from toolkit.datasets import procedural
from toolkit.evaluation import metrics
from toolkit.io import bvh, files
from toolkit.motion import Clip, contacts
from toolkit.motion.contacts import FEET
from toolkit.motion.tensors import summary

UNIT = 0.05644  # metres, of the files' unit of length
STANDING = 0  # column of a ``.gait`` file
NAME = "pfnn"  # folder of the takes in the folder of datasets
STILL = 0.02  # metres from its mean position, root mean square, below which a hand has no phase
SLOW = 0.2  # Hz, of a limb that does not step


@dataclass(frozen=True, eq=False)
class Take:
    """A clip with the frames ``[N]`` in which its right and its left foot touch down."""

    clip: Clip
    right: Tensor  # increasing
    left: Tensor  # increasing
    moving: Tensor  # [F] bool, not standing
    __repr__ = summary

    @property
    def label(self) -> Tensor:
        """Phase ``[F]`` in radians; constant before the first and after the last touch-down."""
        frames, order = torch.cat((self.right, self.left)).sort()
        foot = (order >= len(self.right)).double()  # 0 right, 1 left
        # two steps of one foot in turn are a whole cycle apart
        turns = (1 + (foot.diff() == 0).double()).cumsum(0)
        halves = foot[0] + torch.cat((turns[:1] * 0, turns))
        return _straight(len(self.clip), frames.double(), math.pi * halves)

    @property
    def labelled(self) -> Tensor:
        """Frames ``[F]`` that are measured, bool: moving, and the label grows."""
        step = self.label.diff()
        return self.moving & (torch.cat((step, step[-1:] * 0)) > 0)


def read(folder: str | os.PathLike) -> list[Take]:
    """The labelled takes of a folder: ``NAME.bvh``, ``NAME_footsteps.txt`` and ``NAME.gait``.

    Raises
    ------
    ValueError
        If there is none, or its files do not belong together.
    """
    found = sorted(Path(folder).glob("*_footsteps.txt"))
    if not found:
        raise ValueError(f"{folder}: no NAME_footsteps.txt; it must hold labelled takes of Holden "
                         "et al. 2017")
    return [_read(file) for file in found]


def _read(file: Path) -> Take:
    name = file.name.removesuffix("_footsteps.txt")
    clip = bvh.load(file.with_name(f"{name}.bvh"), unit=UNIT, up="y")
    try:
        lines = files.read(file).decode().splitlines()
        rows = [[int(word) - 1 for word in line.split()] for line in lines if line.strip()]
        gait = np.loadtxt(io.BytesIO(files.read(file.with_name(f"{name}.gait"))), ndmin=2)
    except (OSError, ValueError) as error:
        said = str(error).splitlines()[0]
        raise ValueError(f"{file}: unreadable, or {name}.gait is ({said})") from error
    right, left = (torch.tensor([row[i] for row in rows if len(row) > i]) for i in range(2))
    if len(gait) != len(clip) or min(len(right), len(left)) < 2 or max(map(len, rows)) > 2:
        raise ValueError(f"{file}: it must have pairs of frames, and {name}.gait {len(clip)} rows "
                         f"as {name}.bvh has frames")
    return Take(clip, right, left, torch.from_numpy(gait[:, STANDING] < 0.5))


def planned(style: str, gait: str = "TR1", seconds: float = 30.0, seed: int = 0) -> Take:
    """A procedural clip, labelled in the same way by its true contacts."""
    clip, known = procedural.truth(style, gait, seconds, seed)
    right, left = (known.contacts[:, i].diff().gt(0).nonzero()[:, 0] + 1 for i in range(2))
    pace = ph.windows.mean(known.frequency[:, 2:].double(), ph.windows.SECOND, clip.fps)
    return Take(clip, right, left, pace.amin(1) > SLOW)


def errors(take: Take, source: str | ph.Source) -> Tensor:
    """Mean errors of the phases of the right and the left foot ``[2]``, degrees.

    A constant lag of each foot is no error.
    """
    found = ph.extract(take.clip, source).phase
    columns = [ph.LIMBS.index(f"{side}_foot") for side in FEET]
    return _errors(take, found[:, columns].double().cpu(), take.labelled)


def floor(take: Take) -> Tensor:
    """Errors ``[2]`` of straight lines between the labelled touch-downs of each foot, degrees."""
    return _errors(take, clocks(take, take.right, take.left), between(take))


def clocks(take: Take, right: Tensor, left: Tensor) -> Tensor:
    """Phases ``[F, 2]`` of both feet: straight lines from each touch-down of a foot to its next."""
    columns = []
    for foot in (right, left):
        angle = 2 * math.pi * torch.arange(len(foot)).double()
        columns.append(_straight(len(take.clip), foot.double(), angle))
    return torch.stack(columns, 1)


def between(take: Take) -> Tensor:
    """Measured frames ``[F]`` between the first and last touch-downs of both feet, bool."""
    frames = take.labelled.clone()
    frames[: max(take.right[0], take.left[0])] = False
    frames[min(take.right[-1], take.left[-1]) :] = False
    return frames


def _errors(take: Take, phases: Tensor, frames: Tensor) -> Tensor:
    truth = take.label[frames, None].expand(-1, 2)
    return metrics.phase_error(phases[frames], truth)[0].rad2deg()


def _straight(frames: int, at: Tensor, angle: Tensor) -> Tensor:
    return torch.from_numpy(np.interp(np.arange(frames), at.numpy(), angle.numpy()))


@dataclass(frozen=True)
class Row:
    """Errors of one clip by source, each ``[4]``; NaN where undefined."""

    name: str
    phase: dict[str, Tensor]  # degrees
    frequency: dict[str, Tensor]  # relative
    f1: list[float]  # of the contacts


def measure(name: str, clip: Clip, truth: procedural.Truth, sources: dict[str, ph.Source]) -> Row:
    """Errors of all sources on one clip while it steps, without the first and the last second."""
    pace = ph.windows.mean(truth.frequency.double(), ph.windows.SECOND, clip.fps)
    frames = torch.arange(len(clip))
    inner = (frames >= clip.fps) & (frames < len(clip) - clip.fps)
    still = []
    for limb in ph.LIMBS:
        where = ph.local_positions(clip, limb)
        moved = float((where - where.mean(0)).square().sum(-1).mean().sqrt())
        still.append(limb.endswith("hand") and moved < STILL)
    phase, frequency = {}, {}
    for label, source in sources.items():
        found = ph.extract(clip, source)
        silent = found.vector.abs().amax((0, 2)) == 0
        phase[label], frequency[label] = torch.full((2, 4), math.nan).unbind()
        for limb in range(4):
            stepping = inner & (pace[:, limb] > SLOW)
            if still[limb] or silent[limb] or stepping.sum() < clip.fps:
                continue
            error, _ = metrics.phase_error(found.phase[stepping, limb], truth.phase[stepping, limb])
            phase[label][limb] = math.degrees(error)
            true = truth.frequency[stepping, limb].mean()
            frequency[label][limb] = (found.frequency[stepping, limb].mean() / true - 1).abs()
    found, true = contacts.detect(clip), truth.contacts
    f1 = []
    for foot in range(2):
        if true[:, foot].any():
            both, either = (found * true)[:, foot].sum(), (found + true)[:, foot].sum()
            f1.append(float(2 * both / either))
    return Row(name, phase, frequency, f1)
