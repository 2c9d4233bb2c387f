"""Motion matching (Clavet 2016; Holden et al. 2020): a search in the data, without a network.

Every frame, the row of the data is found whose pose and future trajectory are nearest to the
character's, and its next frame is the prediction. Data, runtime, steering and foot IK are those of
the networks, so only the prediction differs.
"""

import torch
from torch import Tensor

from toolkit.features import CHANNELS, Features, Layout
from toolkit.motion.skeleton import FEET
from toolkit.networks import Predictor, Sizes, phase
from toolkit.training import Run, make_bank

AHEAD = (20, 40, 60)  # frames in the future at which trajectories are compared, as in the papers
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

    Departures from the papers. They search a few times a second, and play the data in between;
    here every frame is a search. They damp the jump of a pose (inertialisation); here the runtime
    does it, which takes the mean of predicted and integrated positions.

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
        self.columns, scale = compared(self.layout, self.inputs_std)
        inputs, outputs = self.normaliser("inputs"), self.normaliser("outputs")
        rows, frames, numbers = [], [], []
        for number, style in enumerate(data.styles):
            x = inputs.apply(data.inputs[style][:])[:, self.columns]
            z = self.observe(data.phases[style][:], data.outputs[style][:])[1]
            rows.append(x * scale)
            frames.append(outputs.apply(z))
            numbers.append(torch.full((len(x),), number))
        self.register_buffer("scale", scale)
        self.register_buffer("rows", torch.cat(rows))
        self.register_buffer("frames", torch.cat(frames))
        self.register_buffer("numbers", torch.cat(numbers))
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

    def parts(self, *, generator: bool = True) -> tuple[dict[str, Tensor], dict]:
        """A matching is as large as its data: store these (`toolkit.extra.store`), a ValueError."""
        raise ValueError("motion matching is not stored in a model file: it is as large as its "
                         "data; keep them in a store, and call toolkit.extra.matching.match again")


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


__all__ = ["Matching", "compared", "match"]
