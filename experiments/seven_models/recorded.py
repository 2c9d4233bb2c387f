"""Characters that follow the paths of held-out recordings, measured with the field's measures
beside the recordings.

A character starts in a frame of a take, with the take's past second, pose and phases. A pilot keeps
it on the take's path: it knows where the take's root is `LOOKAHEAD` later. So clip i and recording
i have the same start, path and style.
"""

import dataclasses
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit import evaluation, features, phases, runtime
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import OwnFeatures
from toolkit.features.features import usable
from toolkit.motion import Clip, trajectory
from toolkit.networks import Model
from toolkit.runtime import FPS, CharacterState, Pilot
from toolkit.runtime.frame import predicted_toes
from toolkit.runtime.steering import LOOKAHEAD, towards
from toolkit.training import Run

SECONDS = 2.0  # of each walk; most takes of Bandai's dataset 2 last 3 to 9 s
SLOWEST = 0.1  # m/s: a pilot may always make this speed, also where the take stands


@dataclass(frozen=True)
class Moment:
    """A frame of a recording at 60 Hz, from which a character goes on."""

    clip: Clip
    own: OwnFeatures
    world: Tensor  # [F, 4] root (x, z, direction x, direction z)
    at: int

    @property
    def real(self) -> Clip:
        """The recording from there on."""
        return self.clip.cut(self.at + 1, self.at + 1 + round(SECONDS * FPS))

    @property
    def still(self) -> Clip:
        """The frame held still as long: the simplest continuation."""
        frames = torch.full((round(SECONDS * FPS),), self.at)
        return self.clip.replace(rotations=self.clip.rotations[frames],
                                 root_positions=self.clip.root_positions[frames])


def moments(clips: Iterable[Clip]) -> list[Moment]:
    """A moment every `SECONDS` of clips, each with a second before it; ValueError if no clip is
    long enough.
    """
    found = []
    for clip in clips:
        clip = clip.resample(FPS)
        at = usable(len(clip))[:: round(SECONDS * FPS)].tolist()
        at = [t for t in at if t + round(SECONDS * FPS) < len(clip)]
        if not at:
            continue
        own = features.own_features(clip, phases.extract(clip))
        world = torch.cat((own.roots.positions[:, [0, 2]],
                           torch.stack(trajectory.heading(own.roots.rotations), -1)), -1)
        found += [Moment(clip, own, world, t) for t in at]
    if not found:
        raise ValueError(f"no clip has the {1 + SECONDS:g} s that it takes to follow it")
    return found


def beginning(model: Model, some: Sequence[Moment], vectors: Tensor) -> CharacterState:
    """Characters in the poses and on the paths of recorded moments, with style vectors ``[B,
    D]``.
    """
    layout, past = model.layout, torch.arange(-trajectory.PAST, 1)
    x = torch.cat([m.own.inputs(torch.tensor([m.at])) for m in some])
    p = torch.cat([m.own.phases[m.at][None] for m in some])
    z = torch.cat([m.own.outputs(torch.tensor([m.at])) for m in some])
    velocity = torch.stack([(m.world[m.at, :2] - m.world[m.at - FPS // 4, :2]) * 4 for m in some])
    state = dataclasses.replace(
        runtime.start(model, vectors), history=torch.stack([m.world[m.at + past] for m in some]),
        future=torch.stack([m.world[m.at + torch.tensor(layout.ahead)] for m in some]),
        joints=x[:, layout.inputs["joints"]], phase=model.observe(p, z)[0],
        velocity=velocity, asked=velocity, rest=x.new_zeros(len(some), 1),
        facing=torch.stack([m.world[m.at, 2:] for m in some]),
        contacts=torch.stack([m.own.contacts[m.at] for m in some]).to(x))
    return dataclasses.replace(state, toes=predicted_toes(layout, state))


def followed(model: Model, some: Sequence[Moment], vectors: Tensor) -> list[Clip]:
    """The walk of a character from each moment along the recorded path, with style vectors ``[B,
    D]``.
    """
    frames, ahead = round(SECONDS * FPS), round(LOOKAHEAD * FPS)
    index = torch.arange(frames + 1 + ahead)
    # [B, F, 4]
    paths = torch.stack([m.world[(m.at + index).clamp_max(len(m.world) - 1)] for m in some])

    def pilot(frame: int) -> Pilot:
        goal = paths[:, frame + ahead]
        speed = (goal[:, :2] - paths[:, frame, :2]).norm(dim=-1, keepdim=True) / LOOKAHEAD
        return lambda state: towards(state, goal[:, :2], goal[:, 2:], speed.clamp_min(SLOWEST))

    walked = list(runtime.states(model, [pilot(1 + i) for i in range(frames)], vectors,
                                 beginning(model, some, vectors)))
    return [runtime.record(model, walked, character=i).replace(style=m.clip.style, gait=m.clip.gait,
                                                               name=m.clip.name)
            for i, m in enumerate(some)]


def compared(runs: Sequence[Run], clips: Iterable[Clip], recogniser: Recogniser) -> list[dict]:
    """Rows, one for each measure: the runs, two floors (another style's vector, standing still) and
    the recordings.
    """
    some = [m for m in moments(clips) if m.clip.style in runs[0].bank.names]
    real = [m.real for m in some]
    table: dict[str, dict[str, list[float]]] = {}
    for model, bank in runs:
        own = torch.stack([bank[m.clip.style] for m in some])
        names = list(bank.names)
        other = torch.stack([bank[names[(names.index(m.clip.style) + 1) % len(names)]]
                             for m in some])
        for column, vectors in (("model", own), ("other", other)):
            _enter(table, column,
                   evaluation.report(followed(model, some, vectors), real, recogniser).rows[0])
    found = evaluation.report([m.still for m in some], real, recogniser).rows
    for column, row in zip(("still", "real"), found, strict=True):
        _enter(table, column, row)
    units = evaluation.table.UNITS
    return [{"measure": name, "unit": units.get(name, ""),
             **{key: v if key in ("model", "other") else v[0]
                                                             for key, v in row.items()}}
                                                             for name, row in table.items()]


def _enter(table: dict, column: str, row: dict) -> None:
    for name, value in row.items():
        if name not in ("data", "n"):
            table.setdefault(name, {}).setdefault(column, []).append(value)
