"""Held-out frames (Mason et al. 2022, section 5.2.2), and the random streams that choose them.

For the reason that `toolkit.datasets.blocks` gives, frames whose window overlaps that of a held-out
frame are in neither part.

| rule | what it decides |
| --- | --- |
| `held_out` | which rows of a style are for the test |
| `apart` | which other rows are for the training; the rest is dropped |
| `style_clips` | which style clips the training sees |

Departure from the published run: nothing is for validation, and rows near the test are dropped.
"""

import contextlib
import math
import warnings
from collections import defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import groupby

import numpy as np
import torch
from torch import Tensor

from toolkit import datasets
from toolkit.features.features import CLIP_FRAMES, FRAME_KINDS, Features, Split, build
from toolkit.features.statistics import Rows
from toolkit.motion import Clip

SPLIT_FRAMES = 240  # length of held-out windows
SPLIT_TAKES = 20  # if a style has at least this many takes, whole takes are held out
STRETCH = 60  # frames that show a style where no whole style clip is free of held-out frames
SPLIT = 1  # number of the random stream; `toolkit.training.minibatches` has others


def split(data: Features, share: float, seed: int,
          styles: tuple[str, ...]) -> tuple[Features, Features]:
    """Training and held-out frames of ``styles``, in that order.

    Their windows share no frame (`apart`). The style clips of the training frames are those of
    `style_clips`; the held-out frames come with all. Features of a list (`listed`) have its parts,
    whatever ``share`` and ``seed``.
    """
    known, statistics = data.split, None
    if known and (known.share is None or (known.share, known.seed) == (share, seed)):
        masks = {style: known.held_out[style] for style in styles}
        if styles == tuple(data.styles):
            statistics = known.statistics
    else:
        masks = held_out(data, share, seed, styles)

    learnt = {s: apart(data, s, masks[s]) for s in styles}
    shown = {s: style_clips(data, s, ~learnt[s]) for s in styles}
    training = replace(select(data, learnt), clips=shown, statistics=statistics)
    return training, select(data, masks)


def select(data: Features, masks: dict[str, Tensor]) -> Features:
    """The rows ``[N]`` bool of each style, with all its style clips."""
    chosen = {}
    for kind in (*FRAME_KINDS, "takes", "frames"):
        rows = getattr(data, kind)
        chosen[kind] = {style: _picked(rows[style], mask) for style, mask in masks.items()}
    clips = {style: data.clips[style] for style in masks}
    return replace(data, clips=clips, split=None, statistics=None, spans=None, **chosen)


def _picked(rows: Tensor | Rows, mask: Tensor) -> Tensor | Rows:
    return rows.select(mask) if isinstance(rows, Rows) else rows[mask]


def apart(data: Features, style: str, held_out: Tensor) -> Tensor:
    """Rows ``[N]`` bool of a style whose windows share no frame with those of ``held_out [N]``.

    A window is that of the trajectory and the next frame; the filters of the phases reach farther.
    In a style that is too short for any, those that are not held out, with a warning.
    """
    rest = ~held_out
    if not held_out.any() or not rest.any():
        return rest
    at = data.frames[style]
    aside = at[held_out.to(at.device)].unique()
    reach = data.layout.samples[-1] + 1 - data.layout.samples[0]  # frames of a window, less one
    # distance to the nearest held-out frame
    after = torch.searchsorted(aside, at)
    behind, ahead = aside[(after - 1).clamp_min(0)], aside[after.clamp_max(len(aside) - 1)]
    free = torch.minimum((at - behind).abs(), (ahead - at).abs()).to(rest.device) > reach
    if not free.any():
        warnings.warn(f"style {style!r} is too short to hold out frames: it is trained on frames "
                      "that overlap their windows", stacklevel=3)
        return rest
    return free


def listed(clips: Iterable[Clip], parts: datasets.blocks.Split, **options) -> Features:
    """Features of the training and test blocks of a list (`toolkit.datasets.split`).

    ``options`` are those of `features.build`. ValueError as of `pieces`, or if no clip has a
    training block.
    """
    found = list(pieces(clips, parts))
    aside = torch.tensor([held for _, _, held in found], dtype=torch.bool)
    if aside.all():
        raise ValueError("none of these clips is in the training part of the split of "
                         f"{parts.dataset}")
    data = build([piece for _, piece, _ in found], **{"short": "skip"} | options)
    masks = {style: aside[takes] for style, takes in data.takes.items()}
    return replace(data, split=Split(None, None, masks))


def pieces(clips: Iterable[Clip], parts: datasets.blocks.Split) -> Iterator[tuple[int, Clip, bool]]:
    """The training and test blocks of a list, cut out of clips.

    Each comes with the number of its clip and whether it is of the test. They are cut before
    anything is computed, so no window reaches from one part into another. The blocks of the
    validation and the styles that only the test has are left out. ValueError if the list has no
    block of a clip.
    """
    blocks: dict[tuple[str, str], list] = defaultdict(list)
    for part, held in (("train", False), ("validation", None), ("test", True)):
        for block in getattr(parts, part):
            blocks[block.style, block.gait].append((block, held))
    for number, clip in enumerate(clips):
        if clip.style in parts.unseen:
            continue
        names = clip.gait, clip.name.removesuffix(".bvh")
        found = next((blocks[clip.style, n] for n in names if (clip.style, n) in blocks), None)
        if not found:
            raise ValueError(f"{clip.name}: the split of {parts.dataset} has no block of this take")
        first = min(block.start for block, _ in found)  # the clip begins there
        for block, held in found:
            start, stop = block.start - first, min(block.stop - first, len(clip))
            if held is not None and start < stop:
                yield number, clip.cut(start, stop), held


def style_clips(data: Features, style: str, held_out: Tensor) -> Tensor | Rows:
    """Style clips without a frame of the windows of rows ``held_out [N]`` of a style.

    Frames of their mirror images count, too. If every clip has one, the longest remaining stretch
    of each is repeated, if it lasts `STRETCH` frames or more. All clips, with a warning, if there
    is none.
    """
    clips = data.clips[style]
    if data.spans is None or not held_out.any():
        return clips
    samples, (starts, lengths) = data.layout.samples, data.spans[style].T
    window = torch.arange(samples[0], samples[-1] + 2, device=starts.device)
    aside = data.frames[style][held_out.to(starts.device)]
    taken = (aside[:, None] + window).unique()
    column = torch.arange(CLIP_FRAMES, device=starts.device)
    free = ~torch.isin(starts[:, None] + column % lengths[:, None], taken)
    if (whole := free.all(1)).any():
        return _picked(clips, whole)
    kept = []
    for i, length in enumerate(lengths):
        # runs of frames that are all free or all taken
        runs = groupby(range(length), key=free[i].tolist().__getitem__)
        longest = max((list(run) for is_free, run in runs if is_free), key=len, default=[])
        if len(longest) >= STRETCH:
            kept.append(clips[i][longest[0] + column % len(longest)])
    if kept:
        return torch.stack(kept)
    warnings.warn(f"style {style!r} is too short to hold out frames: its style clips share frames "
                  "with their windows", stacklevel=3)
    return clips


def held_out(data: Features, share: float, seed: int, styles: tuple[str, ...]) -> dict[str, Tensor]:
    """Which rows of each style are held out, ``[N]`` bool: about ``share`` of every style.

    They are whole takes if a style has at least `SPLIT_TAKES` of them, else random windows of 4 s,
    each inside a take. In a style shorter than 4 s they are its last frames. A frame and its mirror
    image count as one. The held-out frames of a style do not depend on the other styles.
    """
    masks = {}
    for style in styles:
        takes, frames = data.takes[style], data.frames[style]
        windows = [frames[takes == take].unique() for take in takes.unique()]
        whole = len(windows) >= SPLIT_TAKES
        if not whole:
            windows = [w for take in windows for w in take.split(SPLIT_FRAMES)]
        chosen = torch.zeros_like(frames, dtype=torch.bool)
        for w in torch.randperm(len(windows), generator=generator(seed, SPLIT, style)).tolist():
            missing = round(share * len(frames)) - int(chosen.sum())
            if missing <= 0:
                break
            rows = torch.isin(frames, windows[w])
            if not whole:  # of the last window only as many frames as are missing
                images = int(rows.sum()) // len(windows[w])  # 2 with mirror images
                rows = torch.isin(frames, windows[w][-math.ceil(missing / images) :])
            chosen |= rows
        masks[style] = chosen
    return masks


def generator(*keys: int | str) -> torch.Generator:
    """A random generator whose stream depends on the numbers and names."""
    return torch.Generator().manual_seed(mix(*keys))


def mix(*keys: int | str) -> int:
    """One seed from several numbers and names, the same on every machine."""
    numbers = [datasets.blocks.draw(key) if isinstance(key, str) else key for key in keys]
    return int(np.random.SeedSequence(numbers).generate_state(1, np.uint64)[0] >> np.uint64(1))


@contextlib.contextmanager
def seeded(device: torch.device | str, *numbers: int) -> Iterator[None]:
    """Seeds torch's global generators inside; restores those of CPU and CUDA on exit."""
    device = torch.device(device)
    gpus = [device.index or 0] if device.type == "cuda" else []
    with torch.random.fork_rng(devices=gpus):
        # torch.manual_seed seeds all devices, but takes half a millisecond where there is no GPU
        (torch.default_generator if device.type == "cpu" else torch).manual_seed(mix(*numbers))
        yield
