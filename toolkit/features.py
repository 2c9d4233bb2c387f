"""Features of Mason et al. 2022, section 3.2: input frames x, output frames z and style clips y, on any skeleton.

`Layout` is the only place that knows which column holds what.
"""

import json
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import accumulate

import torch
from torch import Tensor

from toolkit import contacts, phases, trajectory
from toolkit import rotations as R
from toolkit.motion import Clip, RootFrames, Skeleton, root_frames

CLIP_FRAMES, CLIP_HOP = 240, 120
N_PHASES = 2 * len(phases.LIMBS)
CHANNELS = ("position", "forward", "up", "velocity")  # three numbers each, per joint


@dataclass(frozen=True, eq=False)
class Layout:
    """Names of the columns of x, z and y for a skeleton of J feature joints.

    For J = 25 x has 348 columns, z 342 and a frame of y 300. `inputs` and `outputs` map block names to slices; `joints` is
    J × (position 3, forward 3, up 3, velocity 3), `trajectory` is samples × (x, z, direction x, direction z).

    Two layouts are equal if their skeletons have the same joints in the same tree.
    """

    skeleton: Skeleton
    inputs: dict[str, slice] = field(init=False)
    outputs: dict[str, slice] = field(init=False)

    def __post_init__(self):
        future = len(trajectory.SAMPLES) - trajectory.CURRENT
        joints = 12 * len(self.skeleton.feature_joints)
        widths_in = {"trajectory": 4 * len(trajectory.SAMPLES), "joints": joints}
        widths_out = {"trajectory": 4 * future, "joints": joints, "phases": N_PHASES, "phase_updates": N_PHASES,
                      "contacts": len(contacts.FEET)}  # fmt: skip
        object.__setattr__(self, "inputs", _slices(widths_in))
        object.__setattr__(self, "outputs", _slices(widths_out))

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, Layout) and self.skeleton.names == other.skeleton.names
                and self.skeleton.parents == other.skeleton.parents)  # fmt: skip

    def __hash__(self) -> int:
        return hash((self.skeleton.names, self.skeleton.parents))

    @property
    def names(self) -> tuple[str, ...]:
        """The J feature joints."""
        return tuple(self.skeleton.names[j] for j in self.skeleton.feature_joints)

    @property
    def parents(self) -> tuple[int, ...]:
        """Parents of the feature joints among them, -1 for the root."""
        return self.skeleton.feature_parents

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
        """Columns of z: 24 + 12 J + 16 + 2."""
        return self.outputs["contacts"].stop

    @property
    def n_phases(self) -> int:
        """Columns of p."""
        return N_PHASES

    @property
    def n_clip(self) -> int:
        """Columns of one frame of y: 12 J."""
        return 12 * self.n_joints

    def pack_input(self, **blocks: Tensor) -> Tensor:
        """x ``[..., n_inputs]`` of its blocks, each ``[..., width]`` or with its own trailing shape."""
        return _pack(self.inputs, blocks)

    def pack_output(self, **blocks: Tensor) -> Tensor:
        """z ``[..., n_outputs]`` of its blocks."""
        return _pack(self.outputs, blocks)

    def unpack_output(self, z: Tensor) -> dict[str, Tensor]:
        """Blocks of z, each ``[..., width]``."""
        return {name: z[..., s] for name, s in self.outputs.items()}

    def joint_positions(self, z: Tensor) -> Tensor:
        """Joint positions ``[..., J, 3]`` of an output frame, metres, in the current root frame."""
        return split_joints(z[..., self.outputs["joints"]])["position"]

    def to_json(self) -> str:
        """Text for a checkpoint's metadata."""
        s = self.skeleton
        return json.dumps({"names": s.names, "parents": s.parents, "offsets": s.offsets.tolist(), "roles": s.roles})

    @classmethod
    def from_json(cls, text: str) -> "Layout":
        """Inverse of `to_json`."""
        return cls(Skeleton(**json.loads(text)))


def _slices(widths: dict[str, int]) -> dict[str, slice]:
    ends = list(accumulate(widths.values()))
    return {name: slice(end - width, end) for (name, width), end in zip(widths.items(), ends, strict=True)}


def _pack(slices: dict[str, slice], blocks: dict[str, Tensor]) -> Tensor:
    if set(blocks) != set(slices):
        raise ValueError(f"expected the blocks {', '.join(slices)}; got {', '.join(blocks)}")
    parts, lead = [], None
    for name, s in slices.items():
        block, width = blocks[name], s.stop - s.start
        trailing = next((k for k in range(1, block.dim() + 1) if block.shape[-k:].numel() == width), None)
        if trailing is None or (lead is not None and block.shape[: block.dim() - trailing] != lead):
            raise ValueError(f"block {name!r} needs {width} columns per frame; got shape {list(block.shape)}")
        lead = block.shape[: block.dim() - trailing]
        parts.append(block.reshape(*lead, width))
    return torch.cat(parts, -1)


def pack_joints(position: Tensor, forward: Tensor, up: Tensor, velocity: Tensor) -> Tensor:
    """Joint block ``[..., 12 J]`` of four ``[..., J, 3]``."""
    return torch.cat((position, forward, up, velocity), -1).flatten(-2)


def split_joints(block: Tensor) -> dict[str, Tensor]:
    """Inverse of `pack_joints`: `CHANNELS` to ``[..., J, 3]``."""
    return dict(zip(CHANNELS, block.unflatten(-1, (-1, 4, 3)).unbind(-2), strict=True))


@dataclass(frozen=True)
class Normaliser:
    """Column-wise z-score. ``mean`` and ``std`` ``[D]`` float32, computed in float64; a constant column has std 1."""

    mean: Tensor
    std: Tensor

    @classmethod
    def of(cls, *rows: Tensor) -> "Normaliser":
        """Statistics over all rows of tensors ``[..., D]``."""
        flat = [r.reshape(-1, r.shape[-1]).double() for r in rows]
        count = sum(len(r) for r in flat)
        mean = sum(r.sum(0) for r in flat) / count
        std = (sum(((r - mean) ** 2).sum(0) for r in flat) / count).sqrt()
        return cls(mean.float(), torch.where(std < 1e-5, 1.0, std).float())

    def apply(self, x: Tensor) -> Tensor:
        """Physical units → normalised."""
        return (x - self.mean) / self.std

    def invert(self, x: Tensor) -> Tensor:
        """Normalised → physical units."""
        return x * self.std + self.mean


@dataclass(frozen=True, eq=False)
class Frames:
    """Features of N usable frames of one clip at 60 Hz, physical units.

    ``inputs [N, 48 + 12 J]``, ``phases [N, 8]``, ``outputs [N, 42 + 12 J]``; ``index [N]`` are their frame numbers.
    """

    inputs: Tensor
    phases: Tensor
    outputs: Tensor
    index: Tensor


def joint_features(clip: Clip, roots: RootFrames, frames: Tensor) -> Tensor:
    """Joint block ``[N, 12 J]`` of ``frames`` in the root frames given for them (N of them)."""
    joints = list(clip.skeleton.feature_joints)
    positions = clip.global_positions[:, joints]
    velocity = contacts.velocities(positions, clip.fps)[frames]
    forward, up = R.to_forward_up(clip.global_rotations[frames][:, joints])
    return pack_joints(roots.to_local(positions[frames]), *(roots.turn_to_local(v) for v in (forward, up, velocity)))


def frames(clip: Clip, ph: phases.Phases | None = None, start: int = 0, stop: int | None = None) -> Frames:
    """x, p and z of every frame whose trajectory window lies inside the clip (section 3.2).

    Parameters
    ----------
    clip
        Motion at 60 Hz.
    ph
        Its phases; extracted with the hybrid source where not given.
    start, stop
        Only frames in this range; the rest of the clip still serves as their past and future.

    Raises
    ------
    ValueError
        If the clip is not at 60 Hz or no frame has its whole window inside.
    """
    if clip.fps != trajectory.FPS:
        raise ValueError(f"{clip.name}: features need {trajectory.FPS} Hz, the clip has {clip.fps:g}; use clip.resample(60)")
    first, last = max(start, trajectory.PAST), min(len(clip) if stop is None else stop, len(clip) - trajectory.FUTURE - 1)
    if first >= last:
        raise ValueError(f"{clip.name}: {len(clip)} frames hold no whole trajectory window; it takes "
                         f"{trajectory.PAST} before and {trajectory.FUTURE + 1} after a frame")  # fmt: skip
    ph = phases.extract(clip) if ph is None else ph
    at = torch.arange(first, last)
    layout, roots = Layout(clip.skeleton), root_frames(clip)
    here = RootFrames(roots.positions[at], roots.rotations[at])
    positions, directions = trajectory.sample(roots, at)
    inputs = layout.pack_input(trajectory=torch.cat((positions, directions), -1), joints=joint_features(clip, here, at))
    # the next frame's window, seen from the current root frame
    offsets = tuple(o + 1 for o in trajectory.SAMPLES[trajectory.CURRENT :])
    positions, directions = trajectory.sample(roots, at, offsets)
    vector = ph.vector.flatten(1)
    outputs = layout.pack_output(
        trajectory=torch.cat((positions, directions), -1), joints=joint_features(clip, here, at + 1),
        phases=vector[at + 1], phase_updates=vector[at + 1] - vector[at], contacts=contacts.detect(clip)[at + 1],
    )  # fmt: skip
    return Frames(inputs, vector[at], outputs, at)


def style_clips(clip: Clip, start: int = 0, stop: int | None = None) -> Tensor:
    """Style clips y ``[M, 240, 12 J]``: joint features of 240 frames, hop 120; M = 0 where the range is shorter."""
    at = torch.arange(start, len(clip) if stop is None else min(stop, len(clip)))
    roots = root_frames(clip)
    block = joint_features(clip, RootFrames(roots.positions[at], roots.rotations[at]), at)
    if len(block) < CLIP_FRAMES:
        return block.new_zeros(0, CLIP_FRAMES, block.shape[1])
    return block.unfold(0, CLIP_FRAMES, CLIP_HOP).transpose(1, 2).contiguous()


@dataclass(frozen=True, eq=False)
class Features:
    """Features of a dataset, by style; physical units.

    ``inputs[style] [N, Dx]``, ``phases[style] [N, 8]``, ``outputs[style] [N, Dz]``, ``clips[style] [M, 240, 12 J]`` and
    ``takes[style] [N]``, the number of the clip that each row comes from (a mirror image has its original's).
    """

    layout: Layout
    inputs: dict[str, Tensor]
    phases: dict[str, Tensor]
    outputs: dict[str, Tensor]
    clips: dict[str, Tensor]
    takes: dict[str, Tensor]

    @property
    def styles(self) -> list[str]:
        """Names, in the order of the dataset."""
        return list(self.inputs)

    @property
    def n_frames(self) -> int:
        """Rows over all styles."""
        return sum(len(x) for x in self.inputs.values())

    def normalisers(self) -> dict[str, Normaliser]:
        """Statistics of ``inputs``, ``phases``, ``outputs`` and ``clips`` over all styles."""
        return {kind: Normaliser.of(*getattr(self, kind).values()) for kind in ("inputs", "phases", "outputs", "clips")}


def build(clips: Sequence[Clip], *, source: str | phases.Source = "hybrid",
          mirror: bool | Callable[[Clip], bool] = False, short: str = "raise",
          progress: bool = False) -> Features:  # fmt: skip
    """Features of many clips, resampled to 60 Hz.

    Parameters
    ----------
    clips
        Motions of one skeleton, labelled with style and gait. Clips of the same style and gait share phase axes.
    source
        Phase source, see `toolkit.phases`.
    mirror
        Add clips' mirror images: of all, or of those for which a function says so. Only symmetric styles should be, and
        idling never (section 3.2).
    short
        ``"raise"``: a clip that holds no whole window is an error; ``"skip"``: it is left out.
    progress
        Show a bar.

    Raises
    ------
    ValueError
        If there is no clip, skeletons differ, a clip is too short, or a style has no run of 240 frames for a style clip.
    """
    if not clips:
        raise ValueError("no clips to build features from")
    layout = Layout(clips[0].skeleton)
    groups: dict[tuple[str, str], list[tuple[int, Clip]]] = defaultdict(list)
    for take, clip in enumerate(clips):
        if Layout(clip.skeleton) != layout:
            raise ValueError(f"{clip.name}: its joints differ from those of {clips[0].name}")
        clip = clip.resample(trajectory.FPS)
        if short == "skip" and len(clip) < trajectory.PAST + trajectory.FUTURE + 2:
            continue
        groups[clip.style, clip.gait].append((take, clip))
        if mirror(clip) if callable(mirror) else mirror:
            groups[clip.style, clip.gait].append((take, clip.mirrored()))
    rows: dict[str, list[Frames]] = defaultdict(list)
    takes: dict[str, list[Tensor]] = defaultdict(list)
    style_rows: dict[str, list[Tensor]] = defaultdict(list)
    for (style, _), members in _bar(sorted(groups.items()), progress):
        for (take, clip), ph in zip(members, phases.extract_group([c for _, c in members], source), strict=True):
            rows[style].append(frames(clip, ph))
            takes[style].append(torch.full((len(rows[style][-1].index),), take))
            style_rows[style].append(style_clips(clip))
    y = {style: torch.cat(parts) for style, parts in style_rows.items()}
    for style in {c.style: None for c in clips}:
        if style not in y or not len(y[style]):
            raise ValueError(f"style {style!r} has no clip of {CLIP_FRAMES} frames (4 s at 60 Hz) to learn the style from")
    return Features(
        layout,
        *({s: torch.cat([getattr(f, kind) for f in parts]) for s, parts in rows.items()}
          for kind in ("inputs", "phases", "outputs")),
        clips=y,
        takes={s: torch.cat(parts) for s, parts in takes.items()},
    )  # fmt: skip


def _bar(items: list, progress: bool):
    from tqdm import tqdm

    return tqdm(items, desc="features", unit="group", disable=None if progress else True)
