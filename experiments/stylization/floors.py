"""Floors: what restyles without learning. A stylizer is useful only where it is better than all."""

import copy
from collections.abc import Callable

import torch
from torch import Tensor

from toolkit.stylization.data import Motions
from toolkit.stylization.networks import Sizes, Stylizer, build

NEAREST = 256  # sources whose distances to all motions are computed at once


def unchanged(train: Motions) -> Callable[[Motions, Tensor], Tensor]:
    """The source as it is."""
    return lambda sources, target: sources.x


def mean_pose_shift(train: Motions) -> Callable[[Motions, Tensor], Tensor]:
    """The source plus the difference of the mean poses of the two domains' training motions."""
    return shift_of(without_amplitudes(untrained(train)))


def shift_and_scale(train: Motions) -> Callable[[Motions, Tensor], Tensor]:
    """`Stylizer.shift`: the movement gets the amplitude of the target domain, too."""
    return shift_of(untrained(train))


def shift_of(known: Stylizer) -> Callable[[Motions, Tensor], Tensor]:
    """The `Stylizer.shift` of sources to target domains."""
    return lambda sources, target: known.shift(sources.x, sources.domain, target)


def untrained(train: Motions) -> Stylizer:
    """A stylizer that only knows the statistics of motions."""
    return build(train.graph, train.domains, Sizes(1, 1, 1, 1), train.statistics())[0]


def without_amplitudes(stylizer: Stylizer) -> Stylizer:
    """A copy of a stylizer whose `shift` moves the mean pose alone."""
    known = copy.deepcopy(stylizer)
    known.statistics.amplitudes.fill_(1)
    return known


def nearest(train: Motions) -> Callable[[Motions, Tensor], Tensor]:
    """The training motion of the target domain nearest to the source, by the joints' positions."""

    def find(sources: Motions, target: Tensor) -> Tensor:
        made = torch.empty_like(sources.x)
        for d in target.unique():
            own = train.x[train.domain == d]
            for part in (target == d).nonzero()[:, 0].split(NEAREST):
                away = torch.cdist(sources.x[part, :3].flatten(1), own[:, :3].flatten(1))
                made[part] = own[away.argmin(1)]
        return made

    return find


FLOORS = {"unchanged source": unchanged, "mean-pose shift": mean_pose_shift,
          "shift and scale": shift_and_scale, "nearest real clip": nearest}
