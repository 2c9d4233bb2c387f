"""Features of Mason et al. 2022, section 3.2: input frames x, output frames z and style clips y, on any skeleton.

The features of each frame by itself (`OwnFeatures`) are computed once; x, z and y are derived from them.
"""

import difflib
import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import torch
from torch import Tensor

from toolkit import phases
from toolkit.features.layout import CHANNELS, Layout, pack_joints, split_joints
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, RootFrames, contacts, root_frames, trajectory
from toolkit.motion import rotations as R
from toolkit.motion.tensors import few, shown, summary

KINDS = ("inputs", "phases", "outputs", "clips")  # each has a normaliser
FRAME_KINDS = KINDS[:3]  # those with a row per frame
CLIP_FRAMES, CLIP_HOP = 240, 120
SHORTEST = trajectory.SAMPLES[-1] - trajectory.SAMPLES[0] + 2  # frames of a clip with one usable frame
CHUNK = 1 << 18  # numbers in memory at a time in sums over all rows


@dataclass(frozen=True)
class Normaliser:
    """Column-wise z-score; statistics are computed in float64."""

    mean: Tensor  # [D]
    std: Tensor  # [D], 1 for a constant column
    __repr__ = summary

    @classmethod
    def of(cls, *rows: "Tensor | Rows") -> "Normaliser":
        """Statistics over all rows of tensors ``[..., D]``."""
        return cls.merged((moments(r) for r in rows), rows[0][:1].dtype)

    @classmethod
    def merged(cls, parts: Iterable[tuple[int, Tensor, Tensor]], dtype: torch.dtype = torch.float32) -> "Normaliser":
        """Statistics of the union of sets of rows, given the `moments` of each."""
        _, mean, squares = _merge(parts)
        return cls(mean.to(dtype), torch.where(squares.sqrt() < 1e-5, 1.0, squares.sqrt()).to(dtype))

    def apply(self, x: Tensor) -> Tensor:
        """Physical units → normalised, on the device of the statistics and in their dtype."""
        return (x.to(self.mean) - self.mean) / self.std

    def invert(self, x: Tensor) -> Tensor:
        """Normalised → physical units."""
        return x * self.std + self.mean


def moments(rows: "Tensor | Rows") -> tuple[int, Tensor, Tensor]:
    """Number, mean ``[D]`` and variance ``[D]`` of rows ``[..., D]``, float64."""
    step = max(1, CHUNK // max(1, rows[:1].numel()))
    parts = (rows[i : i + step].flatten(0, -2).double() for i in range(0, max(1, len(rows)), step))
    return _merge((len(part), (mean := part.sum(0) / max(1, len(part))),
                   (part - mean).square().sum(0) / max(1, len(part))) for part in parts)


def _merge(parts: Iterable[tuple[int, Tensor, Tensor]]) -> tuple[int, Tensor, Tensor]:
    """Number, mean and variance of a union, from those of its parts (Chan, Golub and LeVeque 1983)."""
    parts = iter(parts)
    n, mean, variance = next(parts)
    for more, mean_there, variance_there in parts:
        n, share, apart = n + more, more / max(1, n + more), mean_there - mean
        mean = mean + share * apart
        variance = variance + share * (variance_there - variance) + share * (1 - share) * apart.square()
    return n, mean, variance


@dataclass(frozen=True, eq=False)
class OwnFeatures:
    """Features of each of F frames by itself, 60 Hz, physical units, of one clip or several in a row.

    x and z of a frame also depend on its neighbours. They are derived, for frames that are `usable`.
    """

    layout: Layout
    roots: RootFrames  # in the world
    joints: Tensor  # [F, 12 J] in the frame's own root frame
    phases: Tensor  # [F, 8]
    contacts: Tensor  # [F, 2]
    __repr__ = summary

    @classmethod
    def joined(cls, parts: Sequence["OwnFeatures"]) -> "OwnFeatures":
        """Those of several recordings of one skeleton, one after the other."""
        rows = ((own.roots.positions, own.roots.rotations, own.joints, own.phases, own.contacts) for own in parts)
        positions, rotations, *others = (torch.cat(column) for column in zip(*rows, strict=True))
        return cls(parts[0].layout, RootFrames(positions, rotations), *others)

    def inputs(self, at: Tensor) -> Tensor:
        """x ``[N, Dx]`` of frames ``at [N]``."""
        window = torch.cat(trajectory.sample(self.roots, at, self.layout.samples), -1)
        return self.layout.pack_input(trajectory=window, joints=self.joints[at])

    def outputs(self, at: Tensor) -> Tensor:
        """z ``[N, Dz]`` of frames ``at [N]``: the next frames, seen from the root frames of these."""
        after, offsets = at + 1, tuple(o + 1 for o in self.layout.ahead)
        positions, directions = trajectory.sample(self.roots, at, offsets)  # the first sample is the next frame's root
        there = self.phases[after]
        return self.layout.pack_output(
            trajectory=torch.cat((positions, directions), -1),
            joints=_seen_from(self.joints[after], positions[:, 0], directions[:, 0]),
            phases=there, phase_updates=there - self.phases[at], contacts=self.contacts[after],
        )

    def style_clips(self, starts: Tensor, lengths: Tensor | None = None) -> Tensor:
        """y ``[M, 240, 12 J]``: joint features of the frames from ``starts [M]`` on.

        With ``lengths [M]`` they are those of that many frames, repeated: a style that is only shown for less than 240.
        """
        frames, width = self.joints.shape
        if lengths is not None:
            return self.joints[starts[:, None] + torch.arange(CLIP_FRAMES, device=starts.device) % lengths[:, None]]
        return self.joints.as_strided((max(0, frames - CLIP_FRAMES + 1), CLIP_FRAMES, width), (width, width, 1))[starts]


def _seen_from(block: Tensor, position: Tensor, direction: Tensor) -> Tensor:
    """Joint block ``[N, 12 J]`` in a frame in which its root has ``position [N, 2]`` and ``direction [N, 2]`` (x, z)."""
    x, y, z = block.unflatten(-1, (-1, len(CHANNELS), 3)).unbind(-1)
    sin, cos = direction[:, :, None, None].unbind(1)
    seen = torch.stack((cos * x + sin * z, y, cos * z - sin * x), -1)
    seen[:, :, CHANNELS.index("position"), ::2] += position[:, None]
    return seen.flatten(1)


def own_features(clip: Clip, ph: phases.Phases, samples: tuple[int, ...] = trajectory.SAMPLES,
                 contact_height: float | None = None) -> OwnFeatures:
    """Features of each frame of a clip by itself, given its phases; ValueError if the clip is not at 60 Hz."""
    if clip.fps != trajectory.FPS:
        raise ValueError(f"{clip.name}: features need {trajectory.FPS} Hz, the clip has {clip.fps:g}; use clip.resample(60)")
    layout, roots = Layout(clip.skeleton, samples=samples), root_frames(clip)
    return OwnFeatures(layout, roots, joint_features(clip, roots), ph.vector.flatten(1),
                       contacts.detect(clip, height=contact_height))


def joint_features(clip: Clip, roots: RootFrames) -> Tensor:
    """Joint block ``[F, 12 J]`` of every frame in its own root frame."""
    joints = list(clip.skeleton.feature_joints)
    positions = clip.global_positions[:, joints]
    turns = R.multiply(R.inverse(roots.rotations)[:, None], clip.global_rotations[:, joints])
    velocity = roots.turn_to_local(contacts.velocities(positions, clip.fps))
    return pack_joints(roots.to_local(positions), *R.to_forward_up(turns), velocity)


def usable(n: int, device: torch.device | None = None, samples: tuple[int, ...] = trajectory.SAMPLES) -> Tensor:
    """Frames of a clip of n frames whose trajectory window, and that of the next frame, lie inside the clip."""
    return torch.arange(-samples[0], max(-samples[0], n - samples[-1] - 1), device=device)


def _too_short(clip: Clip, samples: tuple[int, ...]) -> ValueError:
    return ValueError(f"{clip.name}: {len(clip)} frames hold no whole trajectory window; it takes {-samples[0]} before and "
                      f"{samples[-1] + 1} after a frame")


def clip_starts(n: int, device: torch.device | None = None) -> Tensor:
    """First frames of the style clips of a clip of n frames: every `CLIP_HOP` frames, `CLIP_FRAMES` long."""
    return torch.arange(0, max(0, n - CLIP_FRAMES + 1), CLIP_HOP, device=device)


def mean_velocity(clips: Tensor) -> Tensor:
    """Mean velocity (x, z) ``[M, 2]`` of style clips ``[M, 240, 12 J]`` in the root frame, m/s."""
    return split_joints(clips)["velocity"][:, :, 0, [0, 2]].mean(1)


def natural_speed(clips: Tensor) -> float:
    """Median speed, m/s, of those style clips ``[M, 240, 12 J]`` that walk ahead; NaN if none does."""
    x, z = mean_velocity(clips).T
    ahead = z[(z > 0.2) & (z > 2 * x.abs())]
    return float(ahead.median()) if len(ahead) else math.nan


@dataclass(frozen=True, eq=False)
class Frames:
    """Features of N usable frames of one clip at 60 Hz, physical units."""

    inputs: Tensor  # [N, 48 + 12 J]
    phases: Tensor  # [N, 8]
    outputs: Tensor  # [N, 42 + 12 J]
    index: Tensor  # [N] frame numbers
    __repr__ = summary


def frames(clip: Clip, ph: phases.Phases | None = None, start: int = 0, stop: int | None = None,
           samples: tuple[int, ...] = trajectory.SAMPLES) -> Frames:
    """x, p and z of every frame whose trajectory window lies inside the clip (section 3.2).

    ``ph`` are the clip's phases, by default those of the hybrid source; ``samples`` are the window's offsets, see `Layout`.
    ``start`` and ``stop`` limit the frames, not their past and future. ValueError if the clip is not at 60 Hz or no frame
    has its whole window inside.
    """
    own = own_features(clip, phases.extract(clip) if ph is None else ph, samples)
    at = usable(len(clip), own.joints.device, samples)
    at = at[(at >= start) & (at < (len(clip) if stop is None else stop))]
    if not len(at):
        raise _too_short(clip, samples)
    return Frames(own.inputs(at), own.phases[at], own.outputs(at), at)


@dataclass(frozen=True, eq=False)
class Rows:
    """Rows that are computed on demand: indexing, as on the first axis of a tensor, gives a tensor."""

    derive: Callable[[Tensor], Tensor]  # computes rows from frame numbers
    at: Tensor  # [N] frame numbers of all rows
    __repr__ = summary

    def __len__(self) -> int:
        return len(self.at)

    def __getitem__(self, key: int | slice | Tensor) -> Tensor:
        at = self.at[key]
        return self.derive(at) if at.dim() else self.derive(at[None])[0]

    def select(self, mask: Tensor) -> "Rows":
        """The rows where a mask ``[N]`` is true, also computed on demand."""
        return Rows(self.derive, self.at[mask])


@dataclass(frozen=True, eq=False)
class Split:
    """Held-out rows, of a store or of a list; those of a list have no share and no seed."""

    share: float | None  # of all rows
    seed: int | None
    held_out: dict[str, Tensor]  # [N] bool by style
    statistics: dict[str, Normaliser] | None = None  # of the training rows, by kind
    __repr__ = summary


@dataclass(frozen=True, eq=False)
class Features:
    """Features of a dataset, by style; physical units. Those of a store are `Rows`."""

    layout: Layout
    inputs: dict[str, Tensor | Rows]  # [N, Dx]
    phases: dict[str, Tensor | Rows]  # [N, 8]
    outputs: dict[str, Tensor | Rows]  # [N, Dz]
    clips: dict[str, Tensor | Rows]  # [M, 240, 12 J]
    takes: dict[str, Tensor]  # [N] number of each row's clip; a mirror image has the number of its original
    split: Split | None = None  # of a store or of a list
    statistics: dict[str, Normaliser] | None = None  # of the training rows of a store
    # Which frames of the recordings these are; a style's recordings are numbered through, a mirror image as its original.
    frames: dict[str, Tensor] | None = None  # [N] frame of each row
    spans: dict[str, Tensor] | None = None  # [M, 2] first frame of each style clip, and the number of its different frames

    def __repr__(self) -> str:
        seconds, clips = self.n_frames / trajectory.FPS, sum(map(len, self.clips.values()))
        return summary(self, {"styles": self.styles, "frames": self.n_frames, "seconds": seconds, "style_clips": clips,
                              "inputs": self.layout.n_inputs, "outputs": self.layout.n_outputs})

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
        return self.statistics or {kind: Normaliser.of(*getattr(self, kind).values()) for kind in KINDS}


def build(clips: Clip | Iterable[Clip], *, source: str | phases.Source = "hybrid",
          mirror: bool | Callable[[Clip], bool] = False, short: str = "raise",
          samples: tuple[int, ...] = trajectory.SAMPLES, contact_height: float | None = None,
          progress: bool = False) -> Features:
    """Features of many clips, resampled to 60 Hz.

    Parameters
    ----------
    clips : one or several of one skeleton, labelled with style and gait; clips of the same style and gait share phase axes
    source : phase source, see `toolkit.phases`
    mirror : add mirror images of all clips or of those that a function chooses: symmetric styles, never idling (section 3.2)
    short : ``"raise"``: a clip that holds no whole window is an error; ``"skip"``: it is left out
    samples : offsets of the trajectory window, see `Layout`; they must be those of the model that uses the features
    contact_height : height up to which a toe stands, metres; by default it follows from each clip (`contacts.detect`)
    progress : show a bar

    Raises
    ------
    ValueError
        If there is no clip, skeletons differ, a clip is too short, or a style has no clip with a whole window.
    """
    clips = [clips] if isinstance(clips, Clip) else list(clips)
    if not clips:
        raise ValueError("no clips to build features from")
    layout = Layout(clips[0].skeleton, samples=samples)
    groups: dict[tuple[str, str], list[tuple[int, Clip]]] = defaultdict(list)
    for take, clip in enumerate(clips):
        if why := Layout(clip.skeleton, samples=samples).difference(layout):
            raise ValueError(f"{clip.name}: {why}, compared with {clips[0].name}")
        groups[clip.style, clip.gait].append((take, clip))
    own: dict[str, list[tuple[int, OwnFeatures]]] = defaultdict(list)
    for (style, _), members in progress_bar(sorted(groups.items()), desc="features", unit="group", show=progress):
        own[style] += group_features(members, source, mirror, short, samples, contact_height)
    found: dict[str, dict[str, Tensor]] = {kind: {} for kind in (*KINDS, "takes", "frames", "spans")}
    for style in sorted({clip.style for clip in clips}):
        recordings = own.pop(style, [])
        check_style_clips(style, len(recordings))
        whole = OwnFeatures.joined([part for _, part in recordings])
        for kind, rows in style_rows(whole, [(take, len(part.joints)) for take, part in recordings]).items():
            found[kind][style] = rows[:]
    return Features(layout, **found)


def style_rows(own: OwnFeatures, recordings: Iterable[tuple[int, int]]) -> dict[str, "Tensor | Rows"]:
    """What `Features` holds of one style, by field, from its recordings.

    Parameters
    ----------
    own : features of the recordings, one after the other
    recordings : take and number of frames of each; a mirror image has the take of its original, which comes just before it
    """
    parts, device, last, first, number, after = [], own.joints.device, None, 0, 0, 0
    for take, n in recordings:
        if take != last:  # the numbers of a style's frames have spaces between recordings
            last, number, after = take, after, after + n + CLIP_FRAMES
        at, starts = first + usable(n, device, own.layout.samples), first + clip_starts(n, device)
        spans = torch.stack((starts + number - first, torch.full_like(starts, CLIP_FRAMES)), -1)
        parts.append((at, starts, torch.full_like(at, take), at + number - first, spans,
                      torch.tensor([[first, number, n]], device=device)))
        first += n
    at, starts, takes, frames, spans, whole = (torch.cat(column) for column in zip(*parts, strict=True))
    clips = own.style_clips
    if not len(starts):  # only short recordings: each is repeated
        starts, spans = whole[:, 0].contiguous(), whole[:, 1:]
        clips = partial(_repeated, own, whole)
    derived = (own.inputs, at), (own.phases.__getitem__, at), (own.outputs, at), (clips, starts)
    return {**{kind: Rows(*rows) for kind, rows in zip(KINDS, derived, strict=True)}, "takes": takes, "frames": frames,
            "spans": spans}


def _repeated(own: OwnFeatures, recordings: Tensor, starts: Tensor) -> Tensor:
    """Style clips of whole recordings; ``recordings [R, 3]`` are their first frames, numbers and lengths."""
    return own.style_clips(starts, recordings[torch.searchsorted(recordings[:, 0].contiguous(), starts), 2])


class UnknownStyleError(KeyError, ValueError):
    """A style that a bank or a dataset lacks; the message lists close names."""

    __str__ = Exception.__str__  # KeyError would put its message in quotes


def check_style(name: str, names: Iterable[str]) -> None:
    """Raise an `UnknownStyleError` unless ``name`` is one of ``names``."""
    names = list(names)
    if name not in names:
        by_lower = {n.lower(): n for n in names}
        close = [by_lower[n] for n in difflib.get_close_matches(str(name).lower(), by_lower, cutoff=0.5)]
        there = f"close to it: {', '.join(close)}" if close else f"known: {few(names)}"
        raise UnknownStyleError(f"unknown style {shown(name)}; {there}")


def check_style_clips(style: str, n: int) -> None:
    """Raise a ValueError if a style has no style clips."""
    if not n:
        raise ValueError(f"style {style!r} has no clip of {SHORTEST} frames (1.9 s at 60 Hz) to learn the style from")


def group_features(members: Iterable[tuple[int, Clip]], source: str | phases.Source, mirror: bool | Callable[[Clip], bool],
                   short: str, samples: tuple[int, ...] = trajectory.SAMPLES,
                   contact_height: float | None = None) -> Iterator[tuple[int, OwnFeatures]]:
    """Pairs (take number, `OwnFeatures`) of every clip of one style and gait and of its mirror image; see `build`."""
    chosen: list[tuple[int, Clip]] = []
    for take, clip in members:
        clip = clip.resample(trajectory.FPS)
        if not len(usable(len(clip), clip.rotations.device, samples)):
            if short == "skip":
                continue
            raise _too_short(clip, samples)
        chosen.append((take, clip))
        if mirror(clip) if callable(mirror) else mirror:
            chosen.append((take, clip.mirrored()))
    found = phases.extract_group([clip for _, clip in chosen], source) if chosen else []
    for (take, clip), ph in zip(chosen, found, strict=True):
        yield take, own_features(clip, ph, samples, contact_height)
