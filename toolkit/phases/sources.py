"""Source functions: one curve per limb, whose cycles define the limb's phase (Mason et al. 2022, section 4.1).

A source is any function ``source(clip, limb) -> Tensor [F]``, limb one of `LIMBS`; curves are float64 on the clip's device,
whatever its dtype. One that learns from several clips also has ``fitted(clips) -> source``; `toolkit.phases.extract` calls
it with the clips of a style and gait.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import torch
from torch import Tensor

from toolkit.motion import Clip, contacts
from toolkit.motion import rotations as R
from toolkit.motion.clip import LIMBS
from toolkit.motion.tensors import as_tensor, summary
from toolkit.phases import steps
from toolkit.phases.steps import Steps

Source = Callable[[Clip, str], Tensor]


def local_positions(clip: Clip, limb: str) -> Tensor:
    """Position ``[F, 3]`` of a limb's end in the hips' frame, metres: the end site of the hand, or the toe.

    Among the tested joints and frames, these agree best with the phases that the published network predicts.
    """
    skeleton = clip.skeleton
    hips = skeleton.role("hips")
    end = skeleton.end_site(limb) if limb.endswith("hand") else skeleton.role(limb.replace("foot", "toe"))
    reach = clip.global_positions[:, end] - clip.global_positions[:, hips]
    return R.rotate(R.inverse(clip.global_rotations[:, hips]), reach)


def curves(clip: Clip, source: Source) -> Tensor:
    """The source's curves of the four limbs ``[F, 4]``, float64.

    Raises
    ------
    ValueError
        If it does not give one finite number per frame for every limb.
    """
    raw = [as_tensor(source(clip, limb), "a source's curve", torch.float64).to(clip.rotations.device) for limb in LIMBS]
    if any(r.shape != (len(clip),) or not bool(torch.isfinite(r).all()) for r in raw):
        raise ValueError(f"{clip.name}: a source must give one finite number per frame ({len(clip)}) for every limb")
    return torch.stack(raw, 1)


@dataclass(frozen=True)
class Contact:
    """The 0/1 foot contact (section 4.1.2). Hands have no contact: their curve and their phase feature are 0.

    ``height`` and ``speed`` are the limits of `toolkit.motion.contacts.detect`.
    """

    height: float | None = None
    speed: float = 0.15

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Contact signal ``[F]`` of a limb."""
        if not limb.endswith("foot"):
            return clip.root_positions.new_zeros(len(clip))
        found = contacts.detect(clip, height=self.height, speed=self.speed)
        return found[:, contacts.FEET.index(limb.removesuffix("_foot"))]


@dataclass(frozen=True)
class ContactFree:
    """Position along its first principal component, which points forward (section 4.1.3).

    ``axes`` and ``means`` [3] by limb, in the hips' frame, are those of `fitted`, or else of the clip itself.
    """

    axes: dict[str, Tensor] = field(default_factory=dict)
    means: dict[str, Tensor] = field(default_factory=dict)
    __repr__ = summary

    def fitted(self, clips: Sequence[Clip]) -> "ContactFree":
        """The same source with the centre and axis of all frames of `clips`."""
        axes, means = {}, {}
        for limb in LIMBS:
            points = torch.cat([self.points(c, limb) for c in clips])
            means[limb] = points.mean(0)
            centred = points - means[limb]
            axis = torch.linalg.eigh(centred.T @ centred).eigenvectors[:, -1]
            forward = clips[0].skeleton.facing_axis.to(axis)
            axes[limb] = torch.where(axis @ forward < 0, -axis, axis)
        return replace(self, axes=axes, means=means)

    def points(self, clip: Clip, limb: str) -> Tensor:
        """The points ``[F, 3]`` that are projected on the axis, in the hips' frame: positions, metres."""
        return local_positions(clip, limb).double()

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Signed distance ``[F]`` from the mean along the axis."""
        source = self if self.axes else self.fitted([clip])
        points = self.points(clip, limb)
        return (points - source.means[limb].to(points)) @ source.axes[limb].to(points)


@dataclass(frozen=True)
class Velocity(ContactFree):
    """Velocity along its first principal component: a quarter of a cycle ahead of the position, less affected by drift."""

    def points(self, clip: Clip, limb: str) -> Tensor:
        """Velocities, metres per second."""
        return torch.gradient(super().points(clip, limb), spacing=1 / clip.fps, dim=0)[0]


@dataclass(frozen=True)
class Hybrid:
    """Contacts for feet that touch the floor, contact-free for hands and for feet that never do (section 4.1.3).

    ``least`` is the share of frames in contact below which a foot counts as never touching.

    Departure from the paper: the contacts are those of `Steps`, and a foot's phase follows from the middles of its stances
    and swings (`toolkit.phases.steps.signal`) instead of a sinusoid fitted to them. In a regular walk both are the same.
    `Contact` is the paper's source.
    """

    contact: Source = field(default_factory=Steps)
    contact_free: ContactFree = field(default_factory=ContactFree)
    least: float = 0.02

    def fitted(self, clips: Sequence[Clip]) -> "Hybrid":
        """The same source with contact-free axes of all frames of `clips`."""
        return Hybrid(self.contact, self.contact_free.fitted(clips), self.least)

    def choice(self, clip: Clip, limb: str) -> str:
        """ "contact" or "contact-free"."""
        return "contact" if limb.endswith("foot") and self._share(clip, limb) >= self.least else "contact-free"

    def reason(self, clip: Clip, limb: str) -> str:
        """Why this choice, in words."""
        if not limb.endswith("foot"):
            return "contact-free: a hand touches nothing"
        compared = "at least" if self.choice(clip, limb) == "contact" else "under"
        return (f"{self.choice(clip, limb)}: the foot touches the floor in {self._share(clip, limb):.0%} of the frames, "
                f"{compared} {self.least:.0%}")

    def _share(self, clip: Clip, limb: str) -> float:
        return float(self.contact(clip, limb).mean())

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Source curve ``[F]``."""
        return (self.contact if self.choice(clip, limb) == "contact" else self.contact_free)(clip, limb)

    def signal(self, curve: Tensor) -> Tensor | None:
        """The complex signal ``[F]`` of the steps in a contact curve; None for other curves, which need a fit."""
        return steps.signal(curve)
