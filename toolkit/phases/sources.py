"""Source functions: one curve per limb, whose cycles define its phase (Mason et al. 2022, 4.1).

`toolkit.phases.extract_group` says what a source is.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import torch
from torch import Tensor

from toolkit.motion import Clip, contacts, rotations as R
from toolkit.motion.skeleton import LIMBS
from toolkit.motion.tensors import as_tensor, summary
from toolkit.phases import steps, windows
from toolkit.phases.steps import Steps

Source = Callable[[Clip, str], Tensor]

LEAST = 0.02  # share of frames in contact below which a foot counts as never touching


def limbs_of(source: Source) -> tuple[str, ...]:
    """The limbs that a source has curves of."""
    return tuple(getattr(source, "limbs", LIMBS))


def local_positions(clip: Clip, limb: str) -> Tensor:
    """Position ``[F, 3]`` of a limb's end in the hips' frame, metres: end site of the hand, or toe.

    Among the tested joints and frames, these agree best with the phases that the published network
    predicts. Any other joint, by its name or role, has its own position.
    """
    skeleton = clip.skeleton
    hips = skeleton.role("hips")
    if limb in LIMBS[:2]:
        end = skeleton.end_site(limb)
    elif limb in LIMBS:
        end = skeleton.role(limb.replace("_foot", "_toe"))
    else:
        end = skeleton.role(limb) if limb in skeleton.roles else skeleton.index(limb)
    reach = clip.global_positions[:, end] - clip.global_positions[:, hips]
    return R.rotate(R.inverse(clip.global_rotations[:, hips]), reach)


def curves(clip: Clip, source: Source) -> Tensor:
    """The source's curves of its K limbs ``[F, K]``, float64.

    ValueError if it does not give one finite number per frame for every limb.
    """
    columns = []
    for limb in limbs_of(source):
        curve = as_tensor(source(clip, limb), "a source's curve", torch.float64)
        if curve.shape != (len(clip),) or not bool(curve.isfinite().all()):
            raise ValueError(f"{clip.name}: a source must give one finite number per frame "
                             f"({len(clip)}) for every limb")
        columns.append(curve.to(clip.rotations.device))
    return torch.stack(columns, 1)


@dataclass(frozen=True)
class Contact:
    """The 0/1 foot contact (section 4.1.2). Hands have none: their curve and feature are 0.

    ``height`` and ``speed`` are the limits of `toolkit.motion.contacts.detect`; with the height 0
    a toe stands up to 1 cm above the floor, as in the paper. Departure: by default the limit of the
    height follows from the clip, and contacts always pass a majority vote.
    """

    height: float | None = None
    speed: float = 0.15

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Contact signal ``[F]`` of a limb."""
        if limb not in LIMBS[2:]:
            return clip.root_positions.new_zeros(len(clip))
        found = contacts.detect(clip, height=self.height, speed=self.speed)
        return found[:, contacts.FEET.index(limb.removesuffix("_foot"))]


@dataclass(frozen=True)
class ContactFree:
    """Position along its first principal component, which points forward (section 4.1.3).

    ``axes`` and ``means`` [3] by limb are those of `fitted`, or else of the clip itself.

    Departure from the paper: the component is that of the `swing`, positions less their mean over
    one second. Slow drift of the posture can be larger than the swing, and turn the axis sideways.
    """

    axes: dict[str, Tensor] = field(default_factory=dict)
    means: dict[str, Tensor] = field(default_factory=dict)
    __repr__ = summary

    def fitted(self, clips: Sequence[Clip]) -> "ContactFree":
        """The same source with the centre and axis of all frames of clips."""
        axes, means = {}, {}
        for limb in limbs_of(self):
            points = [self.points(clip, limb) for clip in clips]
            means[limb] = torch.cat(points).mean(0)
            pairs = zip(points, clips, strict=True)
            swing = torch.cat([self.swing(part, clip.fps) for part, clip in pairs])
            axis = torch.linalg.eigh(swing.T.cov()).eigenvectors[:, -1]
            forward = clips[0].skeleton.facing_axis.to(axis)
            axes[limb] = torch.where(axis @ forward < 0, -axis, axis)
        return replace(self, axes=axes, means=means)

    def points(self, clip: Clip, limb: str) -> Tensor:
        """What is projected on the axis ``[F, 3]``: positions in the hips' frame, metres."""
        return local_positions(clip, limb).double()

    def swing(self, points: Tensor, fps: float) -> Tensor:
        """What the axis is fitted to ``[F, 3]``: the points without their slow drift, metres."""
        return points - windows.mean(points, windows.SECOND, fps)

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Signed distance ``[F]`` from the mean along the axis."""
        source = self if self.axes else self.fitted([clip])
        points = self.points(clip, limb)
        return (points - source.means[limb].to(points)) @ source.axes[limb].to(points)


@dataclass(frozen=True)
class Velocity(ContactFree):
    """Velocity along its first principal component: less affected by drift than the position.

    It is a quarter of a cycle ahead of the position.
    """

    def points(self, clip: Clip, limb: str) -> Tensor:
        """Velocities ``[F, 3]``, metres per second."""
        return torch.gradient(super().points(clip, limb), spacing=1 / clip.fps, dim=0)[0]

    def swing(self, points: Tensor, fps: float) -> Tensor:
        """The velocities themselves: drift is slow."""
        return points


@dataclass(frozen=True)
class Hybrid:
    """Contacts for feet that touch the floor, contact-free for the other limbs (sections 4.1.1,
    4.1.4).

    Departure from the paper: the contacts are those of `Steps`, and a foot's phase follows from the
    middles of its stances and swings (`toolkit.phases.steps.signal`) instead of a sinusoid fitted
    to them. In a regular walk both are the same. `Contact(height=0.0)` has the paper's limits.
    """

    contact_free: ContactFree = field(default_factory=ContactFree)
    signal = staticmethod(steps.signal)  # of a contact curve

    def fitted(self, clips: Sequence[Clip]) -> "Hybrid":
        """The same source with contact-free axes of all frames of `clips`."""
        return replace(self, contact_free=self.contact_free.fitted(clips))

    def choice(self, clip: Clip, limb: str) -> str:
        """ "contact" or "contact-free"."""
        return "contact-free" if _touches(clip, limb) is None else "contact"

    def __call__(self, clip: Clip, limb: str) -> Tensor:
        """Source curve ``[F]``."""
        stances = _touches(clip, limb)
        return self.contact_free(clip, limb) if stances is None else stances


def _touches(clip: Clip, limb: str) -> Tensor | None:
    """The stances ``[F]`` of a foot that touches the floor; None for other limbs."""
    if limb in LIMBS[2:]:
        stances = Steps()(clip, limb)
        if float(stances.mean()) >= LEAST:
            return stances
    return None
