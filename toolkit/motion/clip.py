"""Clip: a motion of a skeleton. Metres, seconds, Y up; every operation returns a new object."""

import dataclasses
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.skeleton import Skeleton, forward_kinematics, local_rotations
from toolkit.motion.tensors import as_tensor, at_rate, summary
from toolkit.motion.text import checked, printable

ASKEW = 0.35  # distance of unit vectors: a reflection of axes that maps bones worse does not fit
FASTEST = 10_000  # frames per second: a window of a tenth of a second then has a thousand frames
UNIT = 1e-3  # tolerance of a quaternion's length: files with four decimals, products in float32


@dataclass(frozen=True, eq=False)
class Clip:
    """A motion of F frames.

    Tensors keep their device and floating dtype; arrays and lists become float32. ValueError if
    shapes do not agree, there is no frame, a number is not finite, or a quaternion's length is not
    1.
    """

    skeleton: Skeleton  # of J joints
    rotations: Tensor  # [F, J, 4] unit quaternions relative to the parent, the root's to the world
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
        rotations = as_tensor(self.rotations, "rotations")
        roots = as_tensor(self.root_positions, "root positions", rotations)
        object.__setattr__(self, "rotations", rotations)
        object.__setattr__(self, "root_positions", roots)
        frames, joints = len(rotations) if rotations.dim() else 0, len(self.skeleton)
        if rotations.shape != (frames, joints, 4) or roots.shape != (frames, 3) or not frames:
            raise ValueError(f"{self.name}: expected rotations [F, {joints}, 4] and root positions "
                             f"[F, 3], F >= 1; got {list(rotations.shape)} and {list(roots.shape)}")
        if not 0 < self.fps <= FASTEST:
            raise ValueError(f"{self.name}: frames per second must be more than 0 and at most "
                             f"{FASTEST}, got {self.fps:g}")
        if rotations.is_meta:  # this device keeps shapes and no numbers
            return
        squares = rotations.square() @ rotations.new_ones(4)
        right = (squares - 1).abs() < 2 * UNIT  # false with NaN
        if not bool(right.all()):
            frame, joint = (~right).nonzero()[0].tolist()
            q = rotations[frame, joint]
            if not bool(q.isfinite().all()):
                raise ValueError(f"{self.name}: rotations of frame {frame} are not finite")
            raise ValueError(f"{self.name}: rotations must be quaternions of length 1; in frame "
                             f"{frame} that of {self.skeleton.names[joint]} has length "
                             f"{float(q.norm()):.4g}")
        right = roots.isfinite().all(1)
        if not bool(right.all()):
            frame = int((~right).nonzero()[0])
            raise ValueError(f"{self.name}: root positions of frame {frame} are not finite")

    def __len__(self) -> int:
        return len(self.rotations)

    def __repr__(self) -> str:
        return (f"Clip({self.label}: {len(self)} frames at {self.fps:g} Hz, {self.seconds:.1f} s, "
                f"{len(self.skeleton)} joints)")

    @property
    def label(self) -> str:
        """Style and gait, or else the name."""
        return f"{self.style} {self.gait}".strip() or self.name

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
        """Frames ``start`` to ``stop`` (not included); ValueError if there are none."""
        stop = len(self) if stop is None else min(stop, len(self))
        if not 0 <= start < stop:
            raise ValueError(f"{self.name}: cannot cut frames {start} to {stop} from {len(self)}")
        return self.replace(rotations=self.rotations[start:stop],
                            root_positions=self.root_positions[start:stop])

    def to(self, *device_or_dtype: torch.device | torch.dtype | str) -> "Clip":
        """The same motion on another device or in another floating dtype."""
        q = self.rotations.to(*device_or_dtype)
        if q is self.rotations:
            return self
        return self.replace(rotations=q, root_positions=self.root_positions.to(q))

    def resample(self, fps: float) -> "Clip":
        """The same motion at another rate, see `toolkit.motion.tensors.at_rate`."""
        if not 0 < fps <= FASTEST:
            raise ValueError(f"{self.name}: cannot resample to {fps} frames per second")
        if fps == self.fps or len(self) < 2:
            return self.replace(fps=fps)
        rotations = R.normalize(at_rate(R.unroll(self.rotations), self.fps, fps))
        return self.replace(rotations=rotations, fps=fps,
                            root_positions=at_rate(self.root_positions, self.fps, fps))

    def without_ends(self) -> "Clip":
        """The same motion without End Sites; a role that an End Site had goes to its parent."""
        old = self.skeleton
        kept = [j for j in range(len(old)) if not old.is_end(j)]
        place = {j: i for i, j in enumerate(kept)} | {-1: -1}
        parents, names = [place[old.parents[j]] for j in kept], [old.names[j] for j in kept]
        roles = dict(old.roles)
        for role, name in old.roles.items():
            if name not in names:
                roles[role] = old.names[old.parents[old.names.index(name)]]
        skeleton = Skeleton(names, parents, old.offsets[kept], roles, ())
        return self.replace(skeleton=skeleton, rotations=self.rotations[:, kept])

    def moved(self, turn: float = 0.0, shift: Sequence[float] = (0.0, 0.0, 0.0)) -> "Clip":
        """The motion turned by ``turn`` radians about the vertical axis, then shifted (metres)."""
        q = R.yaw(as_tensor(turn, "turn", self.rotations))
        rotations = self.rotations.clone()
        rotations[:, 0] = R.multiply(q, rotations[:, 0])
        positions = R.rotate(q, self.root_positions) + as_tensor(shift, "shift", self.rotations)
        return self.replace(rotations=rotations, root_positions=positions)

    def mirrored(self) -> "Clip":
        """Left and right exchanged: the motion reflected in the plane x = 0.

        The reflection makes each joint's frame left-handed, so the frame is reflected, too, see
        `frame_reflections`. A joint without a counterpart is mirrored onto itself.
        """
        pairs = list(self.skeleton.mirror_pairs)
        root = R.multiply(R.inverse(root_frames(self).rotations), self.rotations[:, 0])
        mean = R.to_matrix(torch.cat((root[:, None], self.rotations[:, 1:]), 1)).mean(0)
        frames = frame_reflections(self.skeleton, mean)
        world = self.rotations.new_tensor([-1.0, 1.0, 1.0])
        turned = world[:, None] * R.to_matrix(self.global_rotations)[:, pairs] @ frames
        local = local_rotations(self.skeleton, R.from_matrix(turned))
        return self.replace(rotations=R.unroll(local), root_positions=self.root_positions * world)


def frame_reflections(skeleton: Skeleton, mean: Tensor) -> Tensor:
    """Reflections ``[J, 3, 3]`` of joints' frames onto their counterparts', for one in x = 0.

    Rigs differ in which of a joint's axes points sideways. The reflection S of a joint should map
    each bone b below it to the counterpart's b', and its mean local rotation R (``mean [J, 3, 3]``)
    to the counterpart's: S_parent R Sᵀ = R'. Of the reflections of one axis or of all three, we
    take that with the least

        Σ ‖S b − b'‖² / (1 cm)² − tr(Sᵀ M),   M = R'ᵀ S_parent R.

    If it does not map the bones (`ASKEW`), S is the best orthogonal matrix (Procrustes), for which
    bones weigh about 500 times as much.
    """
    if mean.is_meta:
        return torch.empty_like(mean)
    signs = mean.new_tensor([[-1, 1, 1], [1, -1, 1], [1, 1, -1], [-1, -1, -1]])
    choices = torch.diag_embed(signs)
    pairs, offsets = list(skeleton.mirror_pairs), skeleton.offsets.to(mean)
    own = mean.new_zeros(len(pairs), 3, 3)
    for j, p in enumerate(skeleton.parents):
        if pairs[j] < j:  # the counterpart is done: its inverse
            own[j] = own[pairs[j]].T
            continue
        below = [k for k in skeleton.tree.children[j] if skeleton.parents[pairs[k]] == pairs[j]]
        here, there = offsets[below], offsets[[pairs[k] for k in below]]
        of_parent = choices[0] if p < 0 else own[p]
        rotation = mean[pairs[j]].T @ of_parent @ mean[j]  # M

        # A reflection of axes, if it maps the bones.
        misfit = (here @ choices.mT - there).square().sum((-2, -1)) / 0.01**2
        best = int(((choices * rotation).sum((-2, -1)) - misfit).argmax())
        long = here.norm(dim=-1) > 0.01
        apart = R.normalize(here[long]) @ choices[best].mT - R.normalize(there[long])
        if float(apart.norm(dim=-1).amax() if len(apart) else 0.0) < ASKEW:
            own[j] = choices[best]
            continue

        # Else the nearest orthogonal matrix. That of a joint without a counterpart is its own
        # inverse: a reflection in a plane.
        target = rotation + there.T @ here / 0.0003**2
        if pairs[j] == j:
            normal = torch.linalg.eigh(target + target.T).eigenvectors[:, 0]
            own[j] = torch.eye(3).to(target) - 2 * torch.outer(normal, normal)
        else:
            u, _, v = torch.linalg.svd(target)
            flips = torch.stack((*u.new_ones(2), -torch.linalg.det(u @ v).sign()))
            own[j] = (u * flips) @ v
    return own


def on_cpu(clips: Clip | Iterable[Clip]) -> list[Clip]:
    """One or more clips as a list, float32 on the CPU."""
    clips = [clips] if isinstance(clips, Clip) else clips
    return [clip.to("cpu", torch.float32) for clip in clips]


@dataclass(frozen=True, eq=False)
class RootFrames:
    """The root's frame in each of F frames: origin below the hips, z axis in facing direction."""

    positions: Tensor  # [F, 3] metres, y = 0
    rotations: Tensor  # [F, 4] about the vertical
    __repr__ = summary

    def to_local(self, points: Tensor) -> Tensor:
        """World points ``[F, ..., 3]`` in this frame."""
        origin = self.positions.view(len(points), *[1] * (points.dim() - 2), 3)
        return self.turn_to_local(points - origin)

    def turn_to_local(self, vectors: Tensor) -> Tensor:
        """World directions or velocities ``[F, ..., 3]`` in this frame."""
        back = R.inverse(self.rotations).view(len(vectors), *[1] * (vectors.dim() - 2), 4)
        return R.rotate(back, vectors)


def root_frames(clip: Clip) -> RootFrames:
    """Root frame of every frame (section 3.2), which faces where the hips' forward axis points."""
    hips, axis = clip.skeleton.role("hips"), clip.skeleton.facing_axis
    forward = R.rotate(clip.global_rotations[:, hips], axis.to(clip.rotations))
    positions = clip.global_positions[:, hips].clone()
    positions[:, 1] = 0.0
    return RootFrames(positions, R.yaw(torch.atan2(forward[:, 0], forward[:, 2])))
