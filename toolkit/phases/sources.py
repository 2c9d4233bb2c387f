"""Source functions: one curve per limb whose cycles are the limb's phase (Mason et al. 2022, section 4.1).

A source is any function ``source(clip, limb) -> Tensor [F]``, limb one of `LIMBS`. One that learns from several clips also
has ``fitted(clips) -> source``; `toolkit.phases.extract` calls it with the clips of a style and gait.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import torch
from torch import Tensor

from toolkit import contacts
from toolkit import rotations as R
from toolkit.motion import Clip

#: The published order of the phases.
LIMBS = ("left_hand", "right_hand", "left_foot", "right_foot")

Source = Callable[[Clip, str], Tensor]


def local_positions(clip: Clip, limb: str) -> Tensor:
    """Position ``[F, 3]`` of a limb's end in the hips' frame, metres: the tip of the hand, the toe (which meets the floor).

    Of the ends and frames tried, these agree best with the phases that the published network predicts.
    """
    skeleton = clip.skeleton
    hips = skeleton.index("hips")
    end = skeleton.tip(limb) if limb.endswith("hand") else skeleton.index(limb.replace("foot", "toe"))
    reach = clip.global_positions[:, end] - clip.global_positions[:, hips]
    return R.rotate(R.inverse(clip.global_rotations[:, hips]), reach)


@dataclass(frozen=True)
class Contact:
    """The 0/1 foot contact (section 4.1.2). Hands touch nothing: theirs is 0 throughout, and so is their phase feature."""

    height: float = 0.01
    speed: float = 0.15

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Contact signal ``[F]`` of a limb."""
        if not limb.endswith("foot"):
            return torch.zeros(len(clip))
        found = contacts.detect(clip, height=self.height, speed=self.speed)
        return found[:, contacts.FEET.index(limb.removesuffix("_foot"))]


@dataclass(frozen=True)
class ContactFree:
    """Position along its first principal component, which points forward (section 4.1.3).

    ``axes`` and ``means`` [3] by limb, in the hips' frame; taken from the clip itself until `fitted` on a style and gait.
    """

    axes: dict[str, Tensor] = field(default_factory=dict)
    means: dict[str, Tensor] = field(default_factory=dict)

    def fitted(self, clips: Sequence[Clip]) -> "ContactFree":
        """The same source with the centre and axis of all frames of `clips`."""
        axes, means = {}, {}
        for limb in LIMBS:
            points = torch.cat([local_positions(c, limb) for c in clips]).double()
            means[limb] = points.mean(0)
            centred = points - means[limb]
            axis = torch.linalg.eigh(centred.T @ centred).eigenvectors[:, -1]
            forward = clips[0].skeleton.facing_axis.double()
            axes[limb] = axis * (-1.0 if axis @ forward < 0 else 1.0)
        return ContactFree(axes, means)

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Signed distance ``[F]`` from the mean along the axis, metres."""
        source = self if self.axes else self.fitted([clip])
        return (local_positions(clip, limb).double() - source.means[limb]) @ source.axes[limb]


@dataclass(frozen=True)
class Hybrid:
    """Contacts for feet that touch the floor, contact-free for hands and for feet that never do (section 4.1.3).

    ``least`` is the share of frames in contact below which a foot counts as never touching.
    """

    contact: Source = field(default_factory=Contact)
    contact_free: ContactFree = field(default_factory=ContactFree)
    least: float = 0.02

    def fitted(self, clips: Sequence[Clip]) -> "Hybrid":
        """The same source with contact-free axes of all frames of `clips`."""
        return Hybrid(self.contact, self.contact_free.fitted(clips), self.least)

    def choice(self, clip: Clip, limb: str) -> str:
        """ "contact" or "contact-free"."""
        if not limb.endswith("foot"):
            return "contact-free"
        return "contact" if float(self.contact(clip, limb).mean()) >= self.least else "contact-free"

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Source curve ``[F]``."""
        return (self.contact if self.choice(clip, limb) == "contact" else self.contact_free)(clip, limb)


SOURCES: dict[str, Source] = {"hybrid": Hybrid(), "contact": Contact(), "contact-free": ContactFree()}
