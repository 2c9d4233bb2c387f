"""Features (Mason et al. 2022, section 3.2): input frames x, output frames z, style clips y.

The features of each frame by itself (`OwnFeatures`) are computed once; x, z and y are derived from
them.
"""

import math
import warnings
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import torch
from torch import Tensor

from toolkit import phases
from toolkit.features.layout import CHANNELS, Layout, pack_joints, split_joints
from toolkit.features.statistics import Normaliser, Rows
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, RootFrames, contacts, root_frames, rotations as R, trajectory
from toolkit.motion.skeleton import FEET
from toolkit.motion.tensors import few, shown, similar, summary

KINDS = ("inputs", "phases", "outputs", "clips")  # each has a normaliser
FRAME_KINDS = KINDS[:3]  # those with a row per frame
CLIP_FRAMES, CLIP_HOP = 240, 120


@dataclass(frozen=True, eq=False)
class OwnFeatures:
    """Features of each of F frames by itself, 60 Hz, physical units, of clips in a row.

    x and z, which also depend on neighbours, are derived from them for frames that are `usable`.
    """

    layout: Layout
    roots: RootFrames  # in the world
    joints: Tensor  # [F, 12 J] in the frame's own root frame
    phases: Tensor  # [F, 2 K] of K limbs
    contacts: Tensor  # [F, 2]
    __repr__ = summary

    @classmethod
    def joined(cls, parts: Sequence["OwnFeatures"]) -> "OwnFeatures":
        """Those of several recordings of one skeleton, one after the other."""
        rows = ((own.roots.positions, own.roots.rotations, own.joints, own.phases, own.contacts)
                for own in parts)
        positions, rotations, *others = (torch.cat(column) for column in zip(*rows, strict=True))
        return cls(parts[0].layout, RootFrames(positions, rotations), *others)

    def inputs(self, at: Tensor) -> Tensor:
        """x ``[N, Dx]`` of frames ``at [N]``."""
        window = torch.cat(trajectory.sample(self.roots, at, self.layout.samples), -1).flatten(1)
        return self.layout.pack_input(trajectory=window, joints=self.joints[at])

    def outputs(self, at: Tensor) -> Tensor:
        """z ``[N, Dz]`` of frames ``at [N]``: the next frames, seen from these root frames."""
        after, offsets = at + 1, tuple(o + 1 for o in self.layout.ahead)
        # the first sample is the root of the next frame
        positions, directions = trajectory.sample(self.roots, at, offsets)
        there = self.phases[after]
        return self.layout.pack_output(
            trajectory=torch.cat((positions, directions), -1).flatten(1),
            joints=seen_from(self.joints[after], positions[:, 0], directions[:, 0]),
            phases=there, phase_updates=there - self.phases[at], contacts=self.contacts[after],
        )

    def style_clips(self, spans: Tensor) -> Tensor:
        """y ``[M, 240, 12 J]``: joint features of the frames of each span.

        ``spans [M, 2]`` are first frames and numbers of frames; fewer than 240 are repeated.
        """
        first, frames = spans[..., None].unbind(1)
        return self.joints[first + torch.arange(CLIP_FRAMES, device=spans.device) % frames]


def seen_from(block: Tensor, position: Tensor, direction: Tensor) -> Tensor:
    """Joint block ``[N, 12 J]`` in a frame in which its root has this place and direction.

    Both are (x, z) ``[N, 2]``.
    """
    x, y, z = block.unflatten(-1, (-1, len(CHANNELS), 3)).unbind(-1)
    sin, cos = direction[:, :, None, None].unbind(1)
    seen = torch.stack((cos * x + sin * z, y, cos * z - sin * x), -1)
    seen[:, :, CHANNELS.index("position"), ::2] += position[:, None]
    return seen.flatten(1)


def own_features(clip: Clip, ph: phases.Phases, samples: tuple[int, ...] = trajectory.SAMPLES
                 ) -> OwnFeatures:
    """Features of each frame of a clip by itself, given its phases.

    ValueError if the clip is not at 60 Hz.
    """
    if clip.fps != trajectory.FPS:
        raise ValueError(f"{clip.name}: features need {trajectory.FPS} Hz, the clip has "
                         f"{clip.fps:g}; use clip.resample(60)")
    layout = Layout(clip.skeleton, samples=samples, phase_limbs=ph.limbs)
    roots = root_frames(clip)
    return OwnFeatures(layout, roots, joint_features(clip, roots), ph.vector.flatten(1),
                       contacts.detect(clip))


def joint_features(clip: Clip, roots: RootFrames) -> Tensor:
    """Joint block ``[F, 12 J]`` of every frame in its own root frame."""
    joints = list(clip.skeleton.feature_joints)
    positions = clip.global_positions[:, joints]
    turns = R.multiply(R.inverse(roots.rotations)[:, None], clip.global_rotations[:, joints])
    velocity = roots.turn_to_local(contacts.velocities(positions, clip.fps))
    return pack_joints(roots.to_local(positions), *R.to_forward_up(turns), velocity)


def usable(n: int, device: torch.device | None = None,
           samples: tuple[int, ...] = trajectory.SAMPLES) -> Tensor:
    """Of n frames those whose trajectory window, and that of the next frame, lie inside."""
    return torch.arange(-samples[0], max(-samples[0], n - samples[-1] - 1), device=device)


def _too_short(clip: Clip, samples: tuple[int, ...]) -> ValueError:
    return ValueError(f"{clip.name}: {len(clip)} frames hold no whole trajectory window; it takes "
                      f"{-samples[0]} before and {samples[-1] + 1} after a frame")


def mean_velocity(clips: Tensor) -> Tensor:
    """Mean velocity (x, z) ``[M, 2]`` of style clips ``[M, 240, 12 J]`` in the root frame, m/s."""
    return split_joints(clips)["velocity"][:, :, 0, [0, 2]].mean(1)


def natural_speed(clips: Tensor) -> float:
    """Median speed, m/s, of the style clips ``[M, 240, 12 J]`` that walk ahead; NaN if none."""
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


def frames(clip: Clip, ph: phases.Phases | None = None,
           samples: tuple[int, ...] = trajectory.SAMPLES) -> Frames:
    """x, p and z of every frame whose trajectory window lies inside the clip (section 3.2).

    ``ph`` are the clip's phases, by default those of the hybrid source; ``samples`` are those of a
    `Layout`. ValueError if the clip is not at 60 Hz or no frame has its whole window inside.
    """
    own = own_features(clip, phases.extract(clip) if ph is None else ph, samples)
    at = usable(len(clip), own.joints.device, samples)
    if not len(at):
        raise _too_short(clip, samples)
    return Frames(own.inputs(at), own.phases[at], own.outputs(at), at)


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
    takes: dict[str, Tensor]  # [N] number of each row's clip; a mirror image has its original's
    # Which frames of the recordings these are: a style's recordings are numbered through, and a
    # mirror image has the numbers of its original.
    frames: dict[str, Tensor]  # [N] frame of each row
    split: Split | None = None  # of a store or of a list
    statistics: dict[str, Normaliser] | None = None  # of the training rows of a store
    spans: dict[str, Tensor] | None = None  # [M, 2] first frame of a style clip, number of frames

    def __repr__(self) -> str:
        return summary(self, {
            "styles": self.styles, "frames": self.n_frames,
            "seconds": self.n_frames / trajectory.FPS,
            "style_clips": sum(map(len, self.clips.values())),
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
        if self.statistics:
            return self.statistics
        return {kind: Normaliser.of(*getattr(self, kind).values()) for kind in KINDS}

    def ground(self) -> float:
        """Median height of a toe in contact, metres, over every tenth row; 2 cm without toes."""
        layout, roles, heights = self.layout, self.layout.skeleton.roles, []
        toes = [layout.names.index(roles[toe]) for side in FEET if (toe := f"{side}_toe") in roles]
        for rows in self.outputs.values():
            out = layout.unpack_output(rows[torch.arange(0, len(rows), 10)])
            height = split_joints(out["joints"])["position"][:, toes, 1]
            heights.append(height[out["contacts"][:, :len(toes)] > 0.5])
        return float(torch.cat(heights).median().nan_to_num(0.02).clamp(-2, 2))


def build(clips: Clip | Iterable[Clip], *, source: str | phases.Source = "hybrid",
          mirror: bool | Callable[[Clip], bool] = False, short: str = "raise",
          samples: tuple[int, ...] = trajectory.SAMPLES, progress: bool = False) -> Features:
    """Features of many clips, resampled to 60 Hz.

    Parameters
    ----------
    clips : one or several of one skeleton, labelled with style and gait
    source : phase source, see `toolkit.phases.extract_group`
    mirror : add mirror images of all clips or of those that a function chooses: symmetric styles
        (section 3.2), never idling (published run)
    short : ``"raise"``: a clip that holds no whole window is an error; ``"skip"``: it is left out,
        and with a warning a style that has no other
    samples : those of the `Layout` of the model that uses the features

    Raises
    ------
    ValueError
        If there is no clip, skeletons differ, a clip is too short, or no clip has a whole window.
    """
    clips = [clips] if isinstance(clips, Clip) else list(clips)
    if not clips:
        raise ValueError("no clips to build features from")
    if short not in ("raise", "skip"):
        raise ValueError(f"short is raise or skip, got {short!r}")
    by_style = recordings(enumerate(clips), source=source, mirror=mirror, short=short,
                          samples=samples, progress=progress)
    found: dict[str, dict[str, Tensor]] = defaultdict(dict)
    for style in sorted(by_style):
        own = by_style.pop(style)  # one style at a time, because joining takes the memory twice
        whole = OwnFeatures.joined([part for _, part in own])
        takes = [(take, len(part.joints)) for take, part in own]
        for kind, rows in style_rows(whole, takes).items():
            found[kind][style] = rows[:]
    return Features(whole.layout, **found)


def recordings(clips: Iterable[tuple[int, Clip]], *, source: str | phases.Source = "hybrid",
               mirror: bool | Callable[[Clip], bool] = False, short: str = "raise",
               samples: tuple[int, ...] = trajectory.SAMPLES, progress: bool = False
               ) -> dict[str, list[tuple[int, OwnFeatures]]]:
    """Take number and features of every clip, and of its mirror image, by style.

    ``clips`` are pairs of take number and clip; for the other parameters and the errors see
    `build`.
    """
    clips = list(clips)
    first = clips[0][1]
    layout = Layout(first.skeleton, samples=samples)
    groups: dict[tuple[str, str], list[tuple[int, Clip]]] = defaultdict(list)
    for take, clip in clips:
        if why := Layout(clip.skeleton, samples=samples).difference(layout):
            raise ValueError(f"{clip.name}: {why}, compared with {first.name}; on one skeleton: "
                             "clips = [toolkit.extra.characters.retargeting.retarget(clip, "
                             "clips[0]) for clip in clips], or train --skeleton FILE")
        groups[clip.style, clip.gait].append((take, clip))

    found: dict[str, list[tuple[int, OwnFeatures]]] = {style: [] for style, _ in groups}
    bar = progress_bar(sorted(groups), desc="features", unit="group", show=progress)
    for style, gait in bar:
        chosen: list[tuple[int, Clip]] = []
        for take, clip in groups.pop((style, gait)):
            clip = clip.resample(trajectory.FPS)
            if not len(usable(len(clip), clip.rotations.device, samples)):
                if short == "skip":
                    continue
                raise _too_short(clip, samples)
            chosen.append((take, clip))
            if mirror(clip) if callable(mirror) else mirror:
                chosen.append((take, clip.mirrored()))
        # the clips of a style and gait share the axes of their phase sources
        all_phases = phases.extract_group([clip for _, clip in chosen], source) if chosen else []
        for (take, clip), ph in zip(chosen, all_phases, strict=True):
            found[style].append((take, own_features(clip, ph, samples)))
    if empty := [style for style, own in found.items() if not own]:
        names = ", ".join(map(repr, empty))
        least = samples[-1] - samples[0] + 2
        why = (f"style {names} has no clip of {least} frames ({least / trajectory.FPS:.1f} s at "
               f"{trajectory.FPS} Hz) to learn the style from")
        if len(empty) == len(found):
            raise ValueError(why)
        warnings.warn(f"{why}, and is left out", stacklevel=3)
    return {style: own for style, own in found.items() if own}


def style_rows(own: OwnFeatures, takes: Iterable[tuple[int, int]]) -> dict[str, Tensor | Rows]:
    """What `Features` holds of one style, by field.

    ``own`` are the features of its recordings, one after the other; ``takes`` the number of the
    take and of frames of each. A mirror image comes just after its original.
    """
    device, parts = own.joints.device, []
    first = 0  # of the recording's frames, in ``own``
    last, free = None, 0  # its take before, and the next number of a frame that is free
    for take, n in takes:
        # Frames of a style are numbered through, with gaps of `CLIP_FRAMES` between recordings, so
        # that no window of held-out frames touches two recordings (`splits.style_clips`).
        if take != last:
            last, number, free = take, free, free + n + CLIP_FRAMES
        rows = usable(n, device, own.layout.samples)
        starts = torch.arange(0, max(0, n - CLIP_FRAMES + 1), CLIP_HOP, device=device)
        # of style clips and of the whole recording: first frame, its number, number of frames
        lengths = torch.full_like(starts, CLIP_FRAMES)
        clips = torch.stack((first + starts, number + starts, lengths), -1)
        whole = torch.tensor([[first, number, n]], device=device)
        parts.append((first + rows, torch.full_like(rows, take), number + rows, clips, whole))
        first += n
    at, numbers, frames, clips, whole = (torch.cat(part) for part in zip(*parts, strict=True))
    if not len(clips):  # only short recordings: each is repeated
        clips = whole
    return {"inputs": Rows(own.inputs, at), "phases": Rows(own.phases.__getitem__, at),
            "outputs": Rows(own.outputs, at), "clips": Rows(own.style_clips, clips[:, ::2]),
            "takes": numbers, "frames": frames, "spans": clips[:, 1:]}


class UnknownStyleError(KeyError, ValueError):
    """A style that a bank or a dataset lacks; the message lists close names."""

    __str__ = Exception.__str__  # KeyError would put its message in quotes


def check_style(name: str, names: Iterable[str]) -> None:
    """Raise an `UnknownStyleError` unless ``name`` is one of ``names``."""
    if name not in (names := list(names)):
        near = ", ".join(similar(name, names))
        there = f"close to it: {near}" if near else f"known: {few(names)}"
        raise UnknownStyleError(f"unknown style {shown(name)}; {there}")
