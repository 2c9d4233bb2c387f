"""Floors: what restyles without learning. A stylizer is useful only where it is better than all."""

from collections.abc import Callable

import torch
from torch import Tensor

from toolkit.stylization.data import Motions

NEAREST = 256  # sources whose distances to all motions are computed at once


def unchanged(train: Motions) -> Callable[[Motions, Tensor], Tensor]:
    """The source as it is."""
    return lambda sources, target: sources.x


def mean_pose_shift(train: Motions) -> Callable[[Motions, Tensor], Tensor]:
    """The source plus the difference of the mean poses of the two domains' training motions."""
    domains = range(len(train.domains))
    pose = torch.stack([train.x[train.domain == d].mean((0, 2)) for d in domains])

    def shift(sources: Motions, target: Tensor) -> Tensor:
        x = sources.x + (pose[target] - pose[sources.domain])[:, :, None]
        return torch.cat((x[:, :3], torch.nn.functional.normalize(x[:, 3:], dim=1)), 1)

    return shift


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
          "nearest real clip": nearest}
