"""Results averaged with those of the mirror image: the network does not know that the two sides of a body are alike."""

from dataclasses import dataclass

import torch
from torch import Tensor
from torch.nn import functional

from toolkit.motion import Skeleton, local_rotations
from toolkit.motion import rotations as R
from toolkit.motion.clip import frame_reflections
from toolkit.stylization.data import Statistics
from toolkit.stylization.networks import Sizes, Stylizer

HALF_TURN = (0.0, 1.0, 0.0, 0.0)  # about x: minus the reflection in the plane x = 0


def mirrored(x: Tensor, skeleton: Skeleton, mean: Tensor) -> Tensor:
    """Motions ``[..., 7, T, N]`` with left and right exchanged, as `Clip.mirrored` does it.

    ``mean [7, 1, N]`` is a pose about which the motions are. The reflections of the joints' frames are chosen by it.
    """
    pose = R.normalize(mean[3:, 0].T)[None]
    frames = R.from_matrix(-frame_reflections(skeleton, R.to_matrix(local_rotations(skeleton, pose))[0]))
    x = x[..., list(skeleton.mirror_pairs)]
    q = x[..., 3:, :, :].movedim(-3, -1)
    q = R.multiply(R.multiply(q.new_tensor(HALF_TURN).expand_as(q), q), frames.expand_as(q))
    return torch.cat((x[..., :3, :, :] * x.new_tensor([-1, 1, 1])[:, None, None], q.movedim(-1, -3)), -3)


@dataclass(frozen=True)
class Symmetric:
    """A stylizer whose result is the mean of G's and of the mirror image of what G makes of the mirrored source."""

    model: Stylizer

    @property
    def sizes(self) -> Sizes:
        """Sizes of the networks."""
        return self.model.sizes

    @property
    def statistics(self) -> Statistics:
        """Statistics of the motions."""
        return self.model.statistics

    def code_of(self, x: Tensor, domain: Tensor) -> Tensor:
        """`Stylizer.code_of`."""
        return self.model.code_of(x, domain)

    def code_from(self, z: Tensor, domain: Tensor) -> Tensor:
        """`Stylizer.code_from`."""
        return self.model.code_from(z, domain)

    def posture_of(self, x: Tensor, domain: Tensor) -> Tensor:
        """`Stylizer.posture_of`."""
        return self.model.posture_of(x, domain)

    def translate(self, x: Tensor, code: Tensor, posture: Tensor | float = 0.0) -> Tensor:
        """`Stylizer.translate`, of the motions and of their mirror images."""
        skeleton, mean = self.model.skeleton, self.statistics.mean
        one = self.model.translate(x, code)
        other = mirrored(self.model.translate(mirrored(x, skeleton, mean), code), skeleton, mean)
        sign = torch.where((one[:, 3:] * other[:, 3:]).sum(1, keepdim=True) < 0, -1.0, 1.0)
        made = torch.cat(((one[:, :3] + other[:, :3]) / 2, functional.normalize(one[:, 3:] + sign * other[:, 3:], dim=1)), 1)
        return self.statistics.invert(self.statistics.apply(made) + posture)
