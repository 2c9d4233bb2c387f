"""Places of many characters: the rings on which a page's crowd walks."""

import math

import torch
from torch import Tensor

# metres: innermost radius, distance of rings, distance on a ring
INNER, RING, ROOM = 2.0, 1.35, 2.0


def places(characters: int) -> tuple[Tensor, Tensor, Tensor]:
    """Radius, angle and direction (1 or -1) of each character, ``[N]``, on rings of one density."""
    radii = INNER + RING * torch.arange(characters)
    rings = 1 + int((math.tau * radii.cumsum(0) < ROOM * characters).sum())
    radii = radii[:rings]
    ends = (characters * radii.cumsum(0) / radii.sum()).round().long()
    ring = torch.bucketize(torch.arange(characters), ends, right=True)
    first = torch.nn.functional.pad(ends, (1, 0))
    angle = math.tau * (torch.arange(characters) - first[ring]) / first.diff()[ring] + ring
    return radii[ring], angle, 1.0 - 2.0 * (ring % 2)
