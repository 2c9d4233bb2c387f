"""Skeleton and Clip. Metres, seconds, Y up; every operation returns a new object."""

import dataclasses
import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy
import torch
from torch import Tensor

from toolkit.motion import rotations as R
from toolkit.motion.tensors import as_tensor, summary, through_numpy

SIDES = ("left", "right")
FEET = SIDES[::-1]  # the order of contacts in the published network, and of all pairs of legs or arms
LIMBS = tuple(f"{side}_{part}" for part in ("hand", "foot") for side in SIDES)  # the order of local phases
ROLES = ("hips", *(f"{side}_{part}" for side in SIDES
                   for part in ("shoulder", "elbow", "hand", "hip", "knee", "foot", "toe")))
UNIT = 1e-3  # tolerance of a quaternion's length: accepts files with four decimals, and long products in float32
_SIDE = re.compile(r"Left|Right|left|right|[_.][LR](?=$|End$)|^[LR](?=[A-Z])")  # LeftHand, Hand_L, LThumb


@dataclass(frozen=True, eq=False)
class Skeleton:
    """A tree of J joints and End Sites.

    ValueError if lengths differ, a name repeats, a parent does not come before its child or an End Site is no leaf.
    """

    names: tuple[str, ...]  # J unique ones
    parents: tuple[int, ...]  # the root comes first with -1, every parent before its children
    offsets: Tensor  # [J, 3] from the parent, in its frame, metres, float32 on the CPU; the root's offset is not used
    roles: dict[str, str] | None = None  # from a role of `ROLES` to a joint name; by default found from names and tree
    ends: tuple[str, ...] | None = None  # leaves that are End Sites (no rotation); by default those with names in ...End

    def __post_init__(self):
        set_ = object.__setattr__
        set_(self, "names", tuple(self.names))
        set_(self, "parents", tuple(int(p) for p in self.parents))
        offsets = as_tensor(self.offsets, "offsets", torch.float32)
        set_(self, "offsets", offsets if offsets.is_meta else offsets.cpu())
        n = len(self.names)
        if len(self.parents) != n or self.offsets.shape != (n, 3):
            raise ValueError(f"{n} joint names need {n} parents and offsets [{n}, 3]; got {len(self.parents)} parents "
                             f"and offsets {list(self.offsets.shape)}")
        if len(set(self.names)) != n:
            raise ValueError(f"joint names repeat: {sorted({x for x in self.names if self.names.count(x) > 1})}")
        if self.parents[0] != -1 or any(not 0 <= p < j for j, p in enumerate(self.parents[1:], 1)):
            raise ValueError("the root must come first with parent -1, and every parent before its children")
        set_(self, "roles", find_roles(self.names, self.parents) if self.roles is None else dict(self.roles))
        leaves = [name for j, name in enumerate(self.names) if j and j not in self.parents]
        set_(self, "ends", tuple(self.ends if self.ends is not None else (x for x in leaves if x.endswith("End"))))
        if wrong := [name for name in self.ends if name not in leaves]:
            raise ValueError(f"End Sites must be leaves of the tree; these are not: {', '.join(map(str, wrong))}")

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return summary(self, {"joints": len(self), "end_sites": len(self.ends), "names": self.names, "roles": self.roles})

    def to_dict(self) -> dict:
        """The fields as values for JSON; ``Skeleton(**fields)`` makes the skeleton again."""
        return {f.name: getattr(self, f.name) for f in dataclasses.fields(self)} | {"offsets": self.offsets.tolist()}

    def index(self, name: str) -> int:
        """Index of a joint by its name or, where no joint has this name, by its role."""
        joint = name if name in self.names else self.roles.get(name)
        if joint not in self.names:
            raise ValueError(f"unknown joint {name!r}; the skeleton has {', '.join(self.names)}")
        return self.names.index(joint)

    def role(self, role: str) -> int:
        """Index of the joint with a role, which may differ from its name: SMPL's left_wrist has the role left_hand."""
        if self.roles.get(role) not in self.names:
            raise ValueError(f"no joint has the role {role!r}; the skeleton has {', '.join(self.names)}")
        return self.names.index(self.roles[role])

    def is_end(self, joint: int) -> bool:
        """Whether a point is an End Site."""
        return self.names[joint] in self.ends

    def end_site(self, role: str) -> int:
        """Index of the End Site below the joint with a role; the joint itself if it has no End Site beyond 0.1 mm."""
        joint = self.role(role)
        ends = (j for j, p in enumerate(self.parents) if p == joint and self.is_end(j))
        return next((j for j in ends if float(self.offsets[j].norm()) > 1e-4), joint)

    @cached_property
    def feature_joints(self) -> tuple[int, ...]:
        """Joints that the features describe (section 3.2): all but End Sites, and the End Sites of the hands."""
        hands = {self.end_site(f"{side}_hand") for side in SIDES}
        return tuple(j for j in range(len(self)) if not self.is_end(j) or j in hands)

    @cached_property
    def feature_parents(self) -> tuple[int, ...]:
        """Parents of `feature_joints`, as indices into them."""
        position = {j: i for i, j in enumerate(self.feature_joints)}
        return tuple(position.get(self.parents[j], -1) for j in self.feature_joints)

    def levels(self, device: torch.device) -> list[tuple[Tensor, Tensor]]:
        """Indices of the joints and of their parents, one pair for each depth below the root; cached by device."""
        kept = self.__dict__.setdefault("_levels", {})
        if device not in kept:
            depth = [0] * len(self)
            for j, p in enumerate(self.parents[1:], 1):
                depth[j] = depth[p] + 1
            groups = [[j for j, d in enumerate(depth) if d == level] for level in range(1, max(depth) + 1)]
            with torch.inference_mode(False):  # the next call may need gradients
                kept[device] = [(torch.tensor(g, device=device), torch.tensor([self.parents[j] for j in g], device=device))
                                for g in groups]
        return kept[device]

    @cached_property
    @torch.inference_mode(False)
    def rest_positions(self) -> Tensor:
        """Positions ``[J, 3]`` with every rotation zero, the root at the origin."""
        return forward_kinematics(self, R.identity(len(self), dtype=torch.float32), torch.zeros(3))[1]

    @cached_property
    @torch.inference_mode(False)
    def facing_axis(self) -> Tensor:
        """The signed axis ``[3]`` of the hips' frame nearest to (right hip → left hip) × (hips → chest)."""
        rest = self.rest_positions
        left = rest[self.role("left_hip")] - rest[self.role("right_hip")]
        forward = torch.linalg.cross(left, rest[self.trunk[0]] - rest[self.role("hips")])
        largest = forward.abs().argmax()
        return torch.eye(3)[largest] * forward[largest].sign()

    def ancestors(self, joint: int | str) -> list[int]:
        """Indices from the parent of a joint (its index, name or role) up to the root."""
        above, j = [], self.parents[self.index(joint) if isinstance(joint, str) else joint]
        while j >= 0:
            above.append(j)
            j = self.parents[j]
        return above

    @cached_property
    def trunk(self) -> list[int]:
        """Joints above both shoulders, from the chest up to the root."""
        left, right = (self.ancestors(self.role(f"{side}_shoulder")) for side in SIDES)
        return [j for j in left if j in right]

    @cached_property
    def mirror_pairs(self) -> tuple[int, ...]:
        """For each joint the index of its left/right counterpart, itself where it has none."""
        swap = {"Left": "Right", "left": "right", "L": "R"}
        swap |= {b: a for a, b in swap.items()}
        other = [_SIDE.sub(lambda m: m[0].replace(w := m[0].strip("_."), swap[w]), n, count=1) for n in self.names]
        return tuple(self.names.index(n) if n in self.names else j for j, n in enumerate(other))


def find_roles(names: Sequence[str], parents: Sequence[int]) -> dict[str, str]:
    """Those roles of `ROLES` that can be found from the names of hands and toes and the chains of their parents."""
    roles = {"hips": next((n for n in names if n.lower().endswith(("hips", "pelvis"))), names[0])}
    chains = {("hand", "wrist"): ("hand", "elbow", "shoulder"), ("toe",): ("toe", "foot", "knee", "hip")}
    found = [_SIDE.search(name) for name in names]
    initials = [match[0].strip("_.")[0].lower() if match else "" for match in found]
    for side in SIDES:
        for words, parts in chains.items():
            named = (j for j, n in enumerate(names) if initials[j] == side[0] and any(w in n.lower() for w in words))
            joint = next(named, -1)
            for part in parts:
                if joint > 0:
                    roles[f"{side}_{part}"] = names[joint]
                    joint = parents[joint]
    return roles


def forward_kinematics(skeleton: Skeleton, rotations: Tensor, root_positions: Tensor) -> tuple[Tensor, Tensor]:
    """Global rotations ``[..., J, 4]`` and positions ``[..., J, 3]`` of local rotations and the root's position."""
    local = rotations.movedim((-1, -2), (0, 1)).contiguous()  # the frames of one component are contiguous
    turned, positions = torch.empty_like(local), torch.empty_like(local[:3])
    turned[:, 0], positions[:, 0] = local[:, 0], root_positions.movedim(-1, 0)
    offsets = skeleton.offsets.to(rotations).T.reshape(3, -1, *[1] * (rotations.dim() - 2))
    for joints, parents in skeleton.levels(rotations.device):
        above = turned[:, parents]
        turned[:, joints] = torch.stack(R.multiply_parts(above, local[:, joints]))
        positions[:, joints] = positions[:, parents] + torch.stack(R.rotate_parts(above, offsets[:, joints]))
    return tuple(x.movedim((0, 1), (-1, -2)).contiguous() for x in (turned, positions))


def local_rotations(skeleton: Skeleton, global_rotations: Tensor) -> Tensor:
    """Rotations ``[..., J, 4]`` relative to the parents, from global rotations: the inverse of `forward_kinematics`."""
    above = R.inverse(global_rotations[..., list(skeleton.parents[1:]), :])
    return torch.cat((global_rotations[..., :1, :], R.multiply(above, global_rotations[..., 1:, :])), -2)


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
        object.__setattr__(self, "rotations", as_tensor(self.rotations, "rotations"))
        object.__setattr__(self, "root_positions", as_tensor(self.root_positions, "root positions", self.rotations))
        frames, joints = self.rotations.shape[0], len(self.skeleton)
        if self.rotations.shape != (frames, joints, 4) or self.root_positions.shape != (frames, 3) or not frames:
            raise ValueError(f"{self.name}: expected rotations [F, {joints}, 4] and root positions [F, 3], F >= 1; got "
                             f"{list(self.rotations.shape)} and {list(self.root_positions.shape)}")
        if not (self.fps > 0 and math.isfinite(self.fps)):
            raise ValueError(f"{self.name}: frames per second must be positive, got {self.fps}")
        if self.rotations.is_meta:  # the meta device keeps shapes and no numbers
            return
        squares = torch.einsum("fjc,fjc->fj", self.rotations, self.rotations)
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
        """The same motion at another rate, by cubic splines (so that velocities stay continuous)."""
        if not (fps > 0 and math.isfinite(fps)):
            raise ValueError(f"{self.name}: cannot resample to {fps} frames per second")
        if fps == self.fps or len(self) < 2:
            return self.replace(fps=fps)
        old = np.arange(len(self)) / self.fps
        new = np.arange(math.floor(old[-1] * fps + 1e-6) + 1) / fps
        quaternions, positions = (through_numpy(lambda v: scipy.interpolate.CubicSpline(old, v)(new), values)
                                  for values in (R.unroll(self.rotations), self.root_positions))
        return self.replace(rotations=R.normalize(quaternions), root_positions=positions, fps=fps)

    def without_ends(self) -> "Clip":
        """The same motion on the skeleton without End Sites."""
        old = self.skeleton
        kept = [j for j in range(len(old)) if not old.is_end(j)]
        parents = [kept.index(old.parents[j]) if j else -1 for j in kept]
        skeleton = Skeleton([old.names[j] for j in kept], parents, old.offsets[kept], old.roles, ())
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

        The reflection makes each joint's frame left-handed, so one or all three of its own axes are reflected too. Rigs
        differ in which axis points sideways. We choose the reflection that maps the bones below a joint to those below its
        counterpart. If several do, we choose the one whose mean rotation is nearest to the mirror image. A joint without a
        counterpart is mirrored onto itself.
        """
        world, *choices = as_tensor([[-1, 1, 1], [-1, 1, 1], [1, -1, 1], [1, 1, -1], [-1, -1, -1]], "signs", self.rotations)
        choices, offsets = torch.stack(choices), self.skeleton.offsets.to(self.rotations)
        pairs = list(self.skeleton.mirror_pairs)
        parents = torch.tensor(self.skeleton.parents[1:], dtype=torch.long, device=world.device)
        misfit = (choices[:, None] * offsets[1:] - offsets[pairs[1:]]).square().sum(-1)
        misfits = misfit.new_zeros(4, len(pairs)).index_add(1, parents, misfit)  # square metres, of each joint's bones
        root = R.multiply(R.inverse(root_frames(self).rotations), self.rotations[:, 0])
        mean = R.to_matrix(torch.cat((root[:, None], self.rotations[:, 1:]), 1)).mean(0)
        own = world.expand(len(pairs), 3).clone()
        for j, p in enumerate(self.skeleton.parents):
            images = (world if p < 0 else own[p])[:, None] * mean[pairs[j]] * choices[:, None]
            own[j] = choices[((images * mean[j]).sum((-2, -1)) - misfits[:, j] / 0.01**2).argmax(keepdim=True)]
        matrices = R.to_matrix(self.global_rotations)
        mirrored = R.from_matrix(world[:, None] * matrices[:, pairs] * own[:, None, :])
        return self.replace(rotations=R.unroll(local_rotations(self.skeleton, mirrored)),
                            root_positions=self.root_positions * world)


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
