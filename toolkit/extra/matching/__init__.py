"""Motion matching (Clavet 2016; Holden et al. 2020): a search in the data, without a network.

Six times a second, the row of the data is found whose pose and future trajectory are nearest to the
character's. From there on the data are played. The jump of the pose fades (inertialisation). Data,
runtime, steering and foot IK are those of the networks, so only the prediction differs.
"""

from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit.features import CHANNELS, Features, Layout
from toolkit.motion.skeleton import FEET
from toolkit.motion.springs import spring
from toolkit.networks import Predictor, Sizes, phase
from toolkit.runtime import FPS, Command, frame as one_frame
from toolkit.runtime.state import CharacterState
from toolkit.training import Run, make_bank

AHEAD = (20, 40, 60)  # frames in the future at which trajectories are compared, as in the papers
EVERY = 10  # frames from one search to the next
FADE = 25.0  # per second: rate at which the jump of a pose fades; 4 % are left after 0.2 s
ROWS = 1 << 16  # rows of the data that are compared at once
#: Weights of what is compared, as in Holden et al.'s published code; ours for the hips.
WEIGHTS = {"future position": 1.0, "future direction": 1.5, "foot position": 0.75,
           "foot velocity": 1.0, "hips velocity": 1.0}


class Matching(Predictor):
    """A model that searches: the next frame of the nearest row of the data.

    A style vector has a weight for each style. The cost of a row is its distance divided by the
    weight of its style. So a vector with a single one selects a style. A blend takes the rows of
    the style with the larger weight more often; it is a mixture in time, because a row cannot lie
    between two styles.

    ``predict`` searches every frame. The runtime searches every `EVERY` frames, see `Playing`.

    Parameters
    ----------
    data
        All its rows are searched. Each row takes some 400 numbers of memory.
    """

    phase, name = "none", "matching"

    def __init__(self, data: Features):
        super().__init__(data.layout, len(data.styles), Sizes())
        self.style_size = len(data.styles)
        self.normalise(phase.normalisers(self.layout, data))
        self.ground = data.ground()
        self.columns, scale = compared(self.layout, self.inputs_std)
        inputs, outputs = self.normaliser("inputs"), self.normaliser("outputs")
        rows, frames, numbers, follows = [], [], [], []
        for number, style in enumerate(data.styles):
            x = inputs.apply(data.inputs[style][:])[:, self.columns]
            z = self.observe(data.phases[style][:], data.outputs[style][:])[1]
            rows.append(x * scale)
            frames.append(outputs.apply(z))
            numbers.append(torch.full((len(x),), number))
            take, at = data.takes[style], data.frames[style]
            goes_on = (take[1:] == take[:-1]) & (at[1:] == at[:-1] + 1)
            follows.append(torch.nn.functional.pad(goes_on, (0, 1)))
        self.register_buffer("scale", scale)
        self.register_buffer("rows", torch.cat(rows))
        self.register_buffer("frames", torch.cat(frames))
        self.register_buffer("numbers", torch.cat(numbers))
        self.register_buffer("follows", torch.cat(follows))  # whether the next row goes on
        self.eval()

    def encode(self, clips: Tensor | None, style: int | Tensor | None = None) -> Tensor:
        """The vector ``[1, S]`` that selects a style by its number."""
        return torch.eye(self.style_size).to(self.rows)[style][None]

    def forward(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """The next frames ``[B, Dz]`` of the nearest rows; all normalised."""
        return self.frames[self.nearest(x, style)]

    def nearest(self, x: Tensor, style: Tensor) -> Tensor:
        """Numbers ``[B]`` of the rows of least cost for normalised ``x`` and style weights."""
        query = x[:, self.columns] * self.scale
        weights = style.expand(len(x), -1).clamp_min(0.0)  # of 0: the cost is infinite
        costs, found = [], []
        for first in range(0, len(self.rows), ROWS):
            part = slice(first, first + ROWS)
            distance = torch.cdist(query, self.rows[part]).square() + 1e-6
            least = (distance / weights[:, self.numbers[part]]).min(1)
            costs.append(least.values)
            found.append(first + least.indices)
        best = torch.stack(costs).argmin(0, keepdim=True)
        return torch.stack(found).gather(0, best)[0]

    def change(self, row: Tensor) -> Tensor:
        """Change of the frames per second ``[B, Dz]`` from each row to the one that follows."""
        return FPS * (self.frames[row + self.follows[row].long()] - self.frames[row])

    def parts(self, *, generator: bool = True) -> tuple[dict[str, Tensor], dict]:
        """A matching is as large as its data: store these (`toolkit.extra.store`), a ValueError."""
        raise ValueError("motion matching is not stored in a model file: it is as large as its "
                         "data; keep them in a store, and call toolkit.extra.matching.match again")


@dataclass(frozen=True, eq=False)
class Playing(CharacterState):
    """The state under motion matching: what is played, and what is left of the last jump."""

    row: Tensor  # [B] of the data
    due: Tensor  # [B] frames until the next search
    offset: Tensor  # [B, Dz] added to the data, normalised
    speed: Tensor  # [B, Dz] its change per second


@one_frame.step.register
def _(model: Matching, state: CharacterState, command: Command) -> Playing:
    """The next frame of the data that are played."""
    player = _Player(model, state)
    new = one_frame.planted(model, state, one_frame.predicted(player, state, command))
    return Playing(**vars(new) | {"row": player.row, "due": player.due, "offset": player.offset,
                                  "speed": player.speed})


class _Player:
    """Motion matching as the runtime sees it for one frame."""

    def __init__(self, model: Matching, state: CharacterState):
        self.model, self.state, self.layout = model, state, model.layout
        self.ground, self.lift = model.ground, model.lift

    def predict(self, x: Tensor, phases: Tensor, style: Tensor) -> Tensor:
        """The next frames ``[B, Dz]``, physical units; notes row, due, offset and speed."""
        model, old, frames = self.model, self.state, self.model.frames
        query = model.normaliser("inputs").apply(x)
        if isinstance(old, Playing):
            self.row, self.due = old.row + model.follows[old.row].long(), old.due - 1
            self.offset, self.speed = spring(old.offset, old.speed, FADE, 1 / FPS)
        else:
            self.row = model.nearest(query, style)
            self.due = torch.full_like(self.row, EVERY)
            self.offset = self.speed = frames.new_zeros(len(self.row), frames.shape[1])

        # Search. The pose and its velocity stay; what the new row lacks fades.
        search = (self.due <= 0) | ~model.follows[self.row]
        if search.any():
            found = torch.where(search, model.nearest(query, style), self.row)
            self.offset = self.offset + frames[self.row] - frames[found]
            self.speed = self.speed + model.change(self.row) - model.change(found)
            self.offset[:, self.layout.outputs["contacts"]] = 0.0
            self.row = found
            self.due = torch.where(search, EVERY, self.due)
        return model.normaliser("outputs").invert(frames[self.row] + self.offset)


def match(data: Features) -> Run:
    """Motion matching on all rows of the data, with its styles: ``model, bank = match(data)``."""
    model = Matching(data)
    return Run(model, make_bank(model, data))


def compared(layout: Layout, deviations: Tensor) -> tuple[list[int], Tensor]:
    """Columns of x that are compared, and the factor ``[D]`` of each normalised column.

    A group of columns is divided by its mean deviation, so that a direction that hardly changes in
    the data does not dominate.
    """
    groups: dict[str, list[int]] = {name: [] for name in WEIGHTS}
    trajectory, joints = layout.inputs["trajectory"].start, layout.inputs["joints"].start
    for frame in AHEAD:
        sample = min(layout.ahead, key=lambda offset: abs(offset - frame))
        first = trajectory + 4 * layout.samples.index(sample)
        groups["future position"] += [first, first + 1]
        groups["future direction"] += [first + 2, first + 3]
    toes = [layout.names.index(layout.skeleton.roles[f"{side}_toe"]) for side in FEET]
    for name, some in (("foot position", toes), ("foot velocity", toes), ("hips velocity", [0])):
        channel = joints + 3 * CHANNELS.index(name.split()[1])
        groups[name] += [channel + 12 * joint + axis for joint in some for axis in range(3)]
    factors = [WEIGHTS[name] * deviations[at] / deviations[at].mean()
               for name, at in groups.items()]
    return [column for at in groups.values() for column in at], torch.cat(factors)


__all__ = ["Matching", "Playing", "compared", "match"]
