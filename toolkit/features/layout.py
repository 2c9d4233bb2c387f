"""The columns of x, z and y (Mason et al. 2022, section 3.2); no other module defines columns."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Any

import torch
from torch import Tensor

from toolkit import phases
from toolkit.motion import Skeleton, contacts, trajectory
from toolkit.motion.tensors import summary
from toolkit.motion.text import checked

SIZES = 1.4  # largest ratio of the sizes of two skeletons of one layout
PHASES = {  # phase of a model: the blocks of z that are as wide as p
    "local": ("phases", "phase_updates"), "global": ("phase_updates",), "none": ()}
CHANNELS = ("position", "forward", "up", "velocity")  # three numbers each, per joint


@dataclass(frozen=True, eq=False)
class Layout:
    """Names of the columns of x, z and y for a skeleton of J feature joints.

    For J = 25 and 12 samples x has 348 columns, z 342 and a frame of y 300. `inputs` and `outputs`
    map blocks to slices; `joints` is J × (position 3, forward 3, up 3, velocity 3), `trajectory` is
    samples × (x, z, direction x, direction z).

    Data always have the local phases of all limbs. A model may use fewer columns. Its ``phase`` is
    ``"local"``: the phase vectors of the limbs; of four, p has 8 columns, z has 8 of phases and 8
    of phase updates. ``"global"``: one angle, radians, and in z only its update. ``"none"``: p and
    z have no phase columns.

    Two layouts are equal if their skeletons have the same joints and End Sites in the same tree and
    similar size, the same phase, samples and limbs, see `difference`.
    """

    skeleton: Skeleton  # of the data
    phase: str = "local"
    # offsets of the trajectory window in frames at 60 Hz, ascending: past ones, 0, future ones
    samples: tuple[int, ...] = trajectory.SAMPLES
    phase_limbs: tuple[str, ...] = phases.LIMBS  # limbs or joints whose phases the data have

    def __post_init__(self):
        if self.phase not in PHASES:
            raise ValueError(f"the phase of a layout is one of {', '.join(PHASES)}; got "
                             f"{self.phase!r}")
        offsets = tuple(self.samples)
        ascending = offsets == tuple(sorted(set(offsets)))
        if not (all(isinstance(o, int) for o in offsets) and ascending and 0 in offsets
                and -trajectory.PAST <= offsets[0] < 0 < offsets[-1]):
            raise ValueError(f"samples are ascending whole frames from {-trajectory.PAST} on: past "
                             f"ones, 0, future ones; got {list(offsets)}")
        object.__setattr__(self, "samples", offsets)
        object.__setattr__(self, "phase_limbs", checked(self.phase_limbs, "a limb of the phases"))

    def __repr__(self) -> str:
        return summary(self, {"inputs": self.n_inputs, "outputs": self.n_outputs,
                              "phase": self.phase, "joints": self.names})

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Layout) and not self.difference(other)

    def difference(self, other: "Layout") -> str:
        """What differs from another layout, in words; empty if they are equal.

        Bones of people differ in length, so that only a size is compared, the sum of all bones: the
        same file in two units differs by a factor of 1.7 or more.
        """
        a, b = self.skeleton, other.skeleton
        if a.names != b.names or a.parents != b.parents or set(a.ends) != set(b.ends):
            return "its joints differ"
        sizes = [float(s.offsets[1:].norm(dim=-1).sum()) for s in (a, b)]
        if max(sizes) > SIZES * min(sizes):
            times = sizes[0] / max(sizes[1], 1e-9)
            return f"its bones are {times:.3g} times as long; unit= decides"
        if (self.phase, self.samples) != (other.phase, other.samples):
            return "its phase or its samples differ"
        if self.phase_limbs != other.phase_limbs:
            return f"its phases are of {', '.join(self.phase_limbs)}"
        return ""

    @cached_property
    def inputs(self) -> dict[str, slice]:
        """Columns of the blocks of x."""
        return _slices({"trajectory": 4 * len(self.samples), "joints": self.n_clip})

    @cached_property
    def outputs(self) -> dict[str, slice]:
        """Columns of the blocks of z."""
        phase = dict.fromkeys(PHASES[self.phase], self.n_phases)
        return _slices({"trajectory": 4 * len(self.ahead), "joints": self.n_clip, **phase,
                        "contacts": len(contacts.FEET)})

    @property
    def behind(self) -> tuple[int, ...]:
        """Offsets of the past samples, frames."""
        return self.samples[: self.samples.index(0)]

    @property
    def ahead(self) -> tuple[int, ...]:
        """Offsets of the current sample, 0, and of the future ones."""
        return self.samples[self.samples.index(0) :]

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The J feature joints."""
        return tuple(self.skeleton.names[j] for j in self.skeleton.feature_joints)

    @cached_property
    def parents(self) -> tuple[int, ...]:
        """Parents of the feature joints, as indices into them; -1 for the root."""
        skeleton = self.skeleton
        above = (skeleton.parents[j] for j in skeleton.feature_joints[1:])
        return (-1, *(skeleton.feature_of[p] for p in above))

    @property
    def n_joints(self) -> int:
        """J."""
        return len(self.names)

    @property
    def n_inputs(self) -> int:
        """Columns of x: 48 + 12 J."""
        return self.inputs["joints"].stop

    @property
    def n_outputs(self) -> int:
        """Columns of z: 24 + 12 J + 2, and those of the phase: 16, 1 or 0."""
        return self.outputs["contacts"].stop

    @property
    def n_phases(self) -> int:
        """Columns of p."""
        return {"local": 2 * len(self.phase_limbs), "global": 1, "none": 0}[self.phase]

    @property
    def n_clip(self) -> int:
        """Columns of one frame of y: 12 J."""
        return 12 * self.n_joints

    @property
    def limbs(self) -> list[int]:
        """Hands and feet among the feature joints, in the order of `toolkit.phases.LIMBS`."""
        joints = self.skeleton.feature_joints
        return [joints.index(self.skeleton.role(limb)) for limb in phases.LIMBS]

    @property
    def limb_velocities(self) -> list[int]:
        """The 12 columns of x with the velocities of hands and feet, in the order of `limbs`."""
        first = self.inputs["joints"].start + 3 * CHANNELS.index("velocity")
        return [first + 12 * j + axis for j in self.limbs for axis in range(3)]

    def pack_input(self, **blocks: Tensor) -> Tensor:
        """x ``[..., n_inputs]`` of its blocks, each ``[..., width]``."""
        return _pack(self.inputs, blocks)

    def pack_output(self, **blocks: Tensor) -> Tensor:
        """z ``[..., n_outputs]`` of its blocks."""
        return _pack(self.outputs, blocks)

    def unpack_output(self, z: Tensor) -> dict[str, Tensor]:
        """Blocks of z, each ``[..., width]``."""
        return {name: z[..., s] for name, s in self.outputs.items()}

    def bone_lengths(self, positions: Tensor) -> Tensor:
        """Distances ``[..., J - 1]`` of feature joints at ``[..., J, 3]`` from their parents."""
        above = list(self.parents[1:])
        return (positions[..., 1:, :] - positions[..., above, :]).norm(dim=-1)

    def joint_positions(self, z: Tensor) -> Tensor:
        """Joint positions ``[..., J, 3]`` of an output frame, metres, in the current root frame."""
        return split_joints(z[..., self.outputs["joints"]])["position"]

    def to_json(self) -> dict[str, Any]:
        """The fields as JSON values."""
        return self.skeleton.to_dict() | {"phase": self.phase, "samples": list(self.samples),
                                          "phase_limbs": list(self.phase_limbs)}

    @classmethod
    def from_json(cls, values: Mapping[str, Any]) -> "Layout":
        """Inverse of `to_json`; what older files lack has its default."""
        own = {name: values[name] for name in ("phase", "samples", "phase_limbs") if name in values}
        return cls(Skeleton(**{k: v for k, v in values.items() if k not in own}), **own)


def _slices(widths: dict[str, int]) -> dict[str, slice]:
    ends = accumulate(widths.values())
    return {name: slice(end - width, end)
            for (name, width), end in zip(widths.items(), ends, strict=True)}


def _pack(slices: dict[str, slice], blocks: dict[str, Tensor]) -> Tensor:
    if set(blocks) != set(slices):
        raise ValueError(f"expected the blocks {', '.join(slices)}; got {', '.join(blocks)}")
    for name, columns in slices.items():
        shape, width = blocks[name].shape, columns.stop - columns.start
        if shape[-1] != width:
            raise ValueError(f"block {name!r} needs {width} columns per frame; got shape "
                             f"{list(shape)}")
    return torch.cat([blocks[name] for name in slices], -1)


def pack_joints(position: Tensor, forward: Tensor, up: Tensor, velocity: Tensor) -> Tensor:
    """Joint block ``[..., 12 J]`` of four ``[..., J, 3]``."""
    return torch.cat((position, forward, up, velocity), -1).flatten(-2)


def split_joints(block: Tensor) -> dict[str, Tensor]:
    """Inverse of `pack_joints`: `CHANNELS` to ``[..., J, 3]``."""
    return dict(zip(CHANNELS, block.unflatten(-1, (-1, 4, 3)).unbind(-2), strict=True))
