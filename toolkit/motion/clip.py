"""Clip: a motion of a skeleton. Metres, seconds, Y up; every operation returns a new object."""

import dataclasses
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.names import checked, printable
from toolkit.motion.roles import SIDES as SIDES
from toolkit.motion.skeleton import FEET as FEET
from toolkit.motion.skeleton import LIMBS as LIMBS
from toolkit.motion.skeleton import Skeleton, forward_kinematics, local_rotations
from toolkit.motion.tensors import as_tensor, summary, through_numpy

ASKEW = 0.35  # distance of unit vectors: bones that a reflection of axes maps worse need another reflection
FASTEST = 10_000  # frames per second: a window of a tenth of a second then has a thousand frames
SLOWEST, MANY = 10, 1_000_000  # new frames per old one, joints times frames: where both are passed, no resampling
UNIT = 1e-3  # tolerance of a quaternion's length: accepts files with four decimals, and long products in float32


@dataclass(frozen=True, eq=False)
class Clip:
    """A motion of F frames. Tensors keep their device and floating dtype; arrays and lists become float32.

    ValueError if shapes do not agree, there is no frame, a number is not finite, or a quaternion's length is not 1.
    """

    skeleton: Skeleton  # of J joints
    rotations: Tensor  # [F, J, 4] unit quaternions (to within `UNIT`) relative to the parent, the root's to the world
    root_positions: Tensor  # [F, 3] metres, on the device and in the dtype of the rotations
    fps: float  # frames per second
    style: str = ""
    gait: str = ""
    name: str = "clip"  # where the motion came from; error messages begin with it

    def __post_init__(self):
        object.__setattr__(self, "name", printable(self.name))
        for what, label in (("style", self.style), ("gait", self.gait)):
            if label:
                checked((label,), f"a {what} of {self.name}")
        object.__setattr__(self, "rotations", as_tensor(self.rotations, "rotations"))
        object.__setattr__(self, "root_positions", as_tensor(self.root_positions, "root positions", self.rotations))
        frames, joints = self.rotations.shape[0], len(self.skeleton)
        if self.rotations.shape != (frames, joints, 4) or self.root_positions.shape != (frames, 3) or not frames:
            raise ValueError(f"{self.name}: expected rotations [F, {joints}, 4] and root positions [F, 3], F >= 1; got "
                             f"{list(self.rotations.shape)} and {list(self.root_positions.shape)}")
        if not 0 < self.fps <= FASTEST:
            raise ValueError(f"{self.name}: frames per second must be more than 0 and at most {FASTEST}, got {self.fps:g}")
        if self.rotations.is_meta:  # the meta device keeps shapes and no numbers
            return
        squares = self.rotations.square() @ self.rotations.new_ones(4)
        low, high = (float(x) for x in squares.aminmax())
        if not 1 - 2 * UNIT < low <= high < 1 + 2 * UNIT:  # false with NaN
            frame, joint = (~((squares - 1).abs() < 2 * UNIT)).nonzero()[0].tolist()
            q = self.rotations[frame, joint]
            if not bool(q.isfinite().all()):
                raise ValueError(f"{self.name}: rotations of frame {frame} are not finite")
            raise ValueError(f"{self.name}: rotations must be quaternions of length 1; in frame {frame} that of "
                             f"{self.skeleton.names[joint]} has length {float(q.norm()):.4g}")
        if not math.isfinite(self.root_positions.detach().sum(dtype=torch.float64)):  # float64 cannot overflow here
            frame = int((~torch.isfinite(self.root_positions)).any(1).nonzero()[0])
            raise ValueError(f"{self.name}: root positions of frame {frame} are not finite")

    def __len__(self) -> int:
        return len(self.rotations)

    def __repr__(self) -> str:
        label = " ".join(x for x in (self.style, self.gait) if x) or self.name
        return f"Clip({label}: {len(self)} frames at {self.fps:g} Hz, {self.seconds:.1f} s, {len(self.skeleton)} joints)"

    @property
    def seconds(self) -> float:
        """Duration, seconds."""
        return len(self) / self.fps

    @cached_property
    def _globals(self) -> tuple[Tensor, Tensor]:
        return forward_kinematics(self.skeleton, self.rotations, self.root_positions)

    @property
    def global_rotations(self) -> Tensor:
        """World rotations ``[F, J, 4]``."""
        return self._globals[0]

    @property
    def global_positions(self) -> Tensor:
        """World positions ``[F, J, 3]``, metres."""
        return self._globals[1]

    def replace(self, **changes) -> "Clip":
        """A copy with some fields changed."""
        return dataclasses.replace(self, **changes)

    def cut(self, start: int = 0, stop: int | None = None) -> "Clip":
        """Frames ``start`` to ``stop`` (not included, at most the number of frames); ValueError if there are none."""
        stop = len(self) if stop is None else min(stop, len(self))
        if not 0 <= start < stop:
            raise ValueError(f"{self.name}: cannot cut frames {start} to {stop} from {len(self)}")
        return self.replace(rotations=self.rotations[start:stop], root_positions=self.root_positions[start:stop])

    def __getitem__(self, frames: slice) -> "Clip":
        if not isinstance(frames, slice):
            raise TypeError(f"a clip is cut by a slice of its frames, clip[a:b]; got clip[{frames!r}]")
        start, stop, step = frames.indices(len(self))
        if step != 1:
            raise ValueError(f"{self.name}: clip[a:b] takes every frame, got a step of {step}; resample changes the rate")
        return self.cut(start, stop)

    def to(self, *device_or_dtype: torch.device | torch.dtype | str) -> "Clip":
        """The same motion on another device or in another floating dtype; the clip itself where nothing changes."""
        q = self.rotations.to(*device_or_dtype)
        return self if q is self.rotations else self.replace(rotations=q, root_positions=self.root_positions.to(q))

    def resample(self, fps: float) -> "Clip":
        """The same motion at another rate, by cubic splines (so that velocities stay continuous).

        ValueError if the rate is not positive, or the motion is slow and long: more than `SLOWEST` times its frames, and
        `MANY` joints times frames.
        """
        if not (fps > 0 and math.isfinite(fps)):
            raise ValueError(f"{self.name}: cannot resample to {fps} frames per second")
        if fps == self.fps or len(self) < 2:
            return self.replace(fps=fps)
        frames = (len(self) - 1) / self.fps * fps + 1
        if frames > SLOWEST * len(self) and frames * len(self.skeleton) > MANY:
            raise ValueError(f"{self.name}: {len(self)} frames at {self.fps:g} Hz are {frames:.3g} frames at {fps:g} Hz; if "
                             "its rate is wrong, correct it by replace(fps=…)")
        old = np.arange(len(self)) / self.fps
        new = np.arange(math.floor(old[-1] * fps + 1e-6) + 1) / fps
        quaternions, positions = (through_numpy(lambda v: scipy.interpolate.CubicSpline(old, v)(new), values)
                                  for values in (R.unroll(self.rotations), self.root_positions))
        return self.replace(rotations=R.normalize(quaternions), root_positions=positions, fps=fps)

    def without_ends(self) -> "Clip":
        """The same motion on the skeleton without End Sites; a role that an End Site had goes to its parent."""
        old = self.skeleton
        kept = [j for j in range(len(old)) if not old.is_end(j)]
        place = {j: i for i, j in enumerate(kept)} | {-1: -1}
        parents, names = [place[old.parents[j]] for j in kept], [old.names[j] for j in kept]
        roles = {role: name if name in names else old.names[old.parents[old.names.index(name)]]
                 for role, name in old.roles.items()}
        skeleton = Skeleton(names, parents, old.offsets[kept], roles, ())
        return self.replace(skeleton=skeleton, rotations=self.rotations[:, kept])

    def moved(self, turn: float = 0.0, shift: Sequence[float] = (0.0, 0.0, 0.0)) -> "Clip":
        """The whole motion turned by ``turn`` radians about the vertical through the origin, then shifted (metres)."""
        q = R.yaw(as_tensor(turn, "turn", self.rotations))
        rotations_ = self.rotations.clone()
        rotations_[:, 0] = R.multiply(q, rotations_[:, 0])
        positions = R.rotate(q, self.root_positions) + as_tensor(shift, "shift", self.rotations)
        return self.replace(rotations=rotations_, root_positions=positions)

    def mirrored(self) -> "Clip":
        """Left and right exchanged: the motion reflected in the plane x = 0.

        The reflection makes each joint's frame left-handed, so the frame is reflected, too, see `frame_reflections`. A joint
        without a counterpart is mirrored onto itself.
        """
        pairs = list(self.skeleton.mirror_pairs)
        root = R.multiply(R.inverse(root_frames(self).rotations), self.rotations[:, 0])
        mean = R.to_matrix(torch.cat((root[:, None], self.rotations[:, 1:]), 1)).mean(0)
        world = as_tensor([-1, 1, 1], "signs", self.rotations)
        mirrored = world[:, None] * R.to_matrix(self.global_rotations)[:, pairs] @ frame_reflections(self.skeleton, mean)
        return self.replace(rotations=R.unroll(local_rotations(self.skeleton, R.from_matrix(mirrored))),
                            root_positions=self.root_positions * world)


def frame_reflections(skeleton: Skeleton, mean: Tensor) -> Tensor:
    """Reflections ``[J, 3, 3]`` of the joints' frames onto those of their counterparts, for a motion reflected in x = 0.

    Rigs differ in which of a joint's axes points sideways. We choose the reflection of one or all three axes that maps the
    bones below a joint to those below its counterpart. If several do, we choose the one that maps the mean local rotations
    ``mean [J, 3, 3]`` best. If none does, it is the orthogonal matrix that fits bones and means best (Procrustes).
    """
    if mean.is_meta:
        return torch.empty_like(mean)
    choices = torch.diag_embed(as_tensor([[-1, 1, 1], [1, -1, 1], [1, 1, -1], [-1, -1, -1]], "signs", mean))
    pairs, offsets = list(skeleton.mirror_pairs), skeleton.offsets.to(mean)
    bones = [[] for _ in pairs]
    for j, p in enumerate(skeleton.parents[1:], 1):
        if skeleton.parents[pairs[j]] == pairs[p]:
            bones[p].append(j)
    own = mean.new_zeros(len(pairs), 3, 3)
    for j, p in enumerate(skeleton.parents):
        if pairs[j] < j:
            own[j] = own[pairs[j]].T
            continue
        here, there = offsets[bones[j]], offsets[[pairs[k] for k in bones[j]]]
        above = choices[0] if p < 0 else own[p]
        rotation = mean[pairs[j]].T @ above @ mean[j]  # that which a reflection of j's frame should be
        misfit = (here @ choices.mT - there).square().sum((-2, -1)) / 0.01**2
        best = int(((choices * rotation).sum((-2, -1)) - misfit).argmax())
        long = here.norm(dim=-1) > 0.01
        apart = R.normalize(here[long]) @ choices[best].mT - R.normalize(there[long])
        if float(apart.norm(dim=-1).amax() if len(apart) else 0.0) < ASKEW:
            own[j] = choices[best]
            continue
        target = rotation + there.T @ here / 0.0003**2  # a bone of 3 cm weighs 10,000 times as much as the mean
        if pairs[j] == j:  # a reflection that is its own inverse
            normal = torch.linalg.eigh(target + target.T).eigenvectors[:, 0]
            own[j] = torch.eye(3, dtype=mean.dtype, device=mean.device) - 2 * torch.outer(normal, normal)
        else:
            u, _, v = torch.linalg.svd(target)
            own[j] = u @ torch.diag(torch.stack((*u.new_ones(2), -torch.linalg.det(u @ v).sign()))) @ v
    return own


def on_cpu(clips: Clip | Iterable[Clip]) -> list[Clip]:
    """One or more clips as a list, float32 on the CPU."""
    return [clip.to("cpu", torch.float32) for clip in ([clips] if isinstance(clips, Clip) else clips)]


@dataclass(frozen=True, eq=False)
class RootFrames:
    """The root's coordinate frame in each of F frames: origin below the hips on the floor, z axis in facing direction."""

    positions: Tensor  # [F, 3] metres, y = 0
    rotations: Tensor  # [F, 4] about the vertical
    __repr__ = summary

    def to_local(self, points: Tensor) -> Tensor:
        """World points ``[F, ..., 3]`` in this frame."""
        return self.turn_to_local(points - self.positions.view(len(points), *[1] * (points.dim() - 2), 3))

    def turn_to_local(self, vectors: Tensor) -> Tensor:
        """World directions or velocities ``[F, ..., 3]`` in this frame."""
        return R.rotate(R.inverse(self.rotations).view(len(vectors), *[1] * (vectors.dim() - 2), 4), vectors)


def root_frames(clip: Clip) -> RootFrames:
    """Root frame of every frame (section 3.2): the hips on the floor, facing where the hips' forward axis points."""
    hips = clip.skeleton.role("hips")
    forward = R.rotate(clip.global_rotations[:, hips], clip.skeleton.facing_axis.to(clip.rotations))
    positions = clip.global_positions[:, hips].clone()
    positions[:, 1] = 0.0
    return RootFrames(positions, R.yaw(torch.atan2(forward[:, 0], forward[:, 2])))
