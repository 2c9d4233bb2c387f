"""Held-out frames, and the random streams that choose them (Mason et al. 2022, section 4.3)."""

import contextlib
import dataclasses
import hashlib
from collections.abc import Iterator

import numpy as np
import torch
from torch import Tensor

from toolkit.features.features import FRAME_KINDS, Features, Normaliser, Rows

SPLIT_FRAMES = 240  # held-out frames form contiguous windows of this length, because neighbours are almost equal
SPLIT_TAKES = 20  # if a style has at least this many takes, whole takes are held out
SPLIT = 1  # number of the random stream; those of `toolkit.training.minibatches` have others


def split(data: Features, share: float, seed: int, styles: tuple[str, ...]) -> tuple[Features, Features]:
    """Training and held-out frames of ``styles``, in that order; style clips stay with the training frames."""
    known = data.split if data.split and (data.split.share, data.split.seed) == (share, seed) else None
    masks = {s: known.held_out[s] for s in styles} if known else held_out(data, share, seed, styles)
    statistics = known.statistics if known and styles == tuple(data.styles) else None

    def take(masks: dict[str, Tensor], statistics: dict[str, Normaliser] | None) -> Features:
        found = {kind: getattr(data, kind) for kind in (*FRAME_KINDS, "takes")}
        pick = {kind: {s: rows[s].select(mask) if isinstance(rows[s], Rows) else rows[s][mask] for s, mask in masks.items()}
                for kind, rows in found.items()}
        clips = {s: data.clips[s] for s in styles}
        return dataclasses.replace(data, clips=clips, split=None, statistics=statistics, **pick)

    return take({s: ~masks[s] for s in styles}, statistics), take(masks, None)


def held_out(data: Features, share: float, seed: int, styles: tuple[str, ...]) -> dict[str, Tensor]:
    """Which rows of each style are held out, ``[N]`` bool: about ``share`` of every style.

    They are whole takes if a style has at least `SPLIT_TAKES` of them, else random windows of 4 s, each inside a take. In a
    style shorter than 4 s they are its last frames. A take and its mirror image count as one. The held-out frames of a style
    do not depend on the other styles.
    """
    masks = {}
    for style in styles:
        n, takes = len(data.takes[style]), data.takes[style].unique()
        windows = [(data.takes[style] == take).nonzero()[:, 0] for take in takes]
        if len(windows) < SPLIT_TAKES:
            windows = [w for take in windows for w in take.split(SPLIT_FRAMES)]
        target, chosen = round(share * n), torch.zeros(n, dtype=torch.bool)
        for w in torch.randperm(len(windows), generator=generator(seed, SPLIT, style)).tolist():
            if (need := target - int(chosen.sum())) <= 0:
                break
            chosen[windows[w] if len(takes) >= SPLIT_TAKES else windows[w][-need:]] = True
        masks[style] = chosen
    return masks


def generator(*keys: int | str) -> torch.Generator:
    """A random generator whose stream depends on the numbers and names."""
    return torch.Generator().manual_seed(mix(*keys))


def mix(*keys: int | str) -> int:
    """One seed from several numbers and names, the same on every machine."""
    numbers = [int.from_bytes(hashlib.sha256(key.encode()).digest()[:8], "little") if isinstance(key, str) else key
               for key in keys]
    return int(np.random.SeedSequence(numbers).generate_state(1, np.uint64)[0] >> np.uint64(1))


@contextlib.contextmanager
def seeded(device: torch.device | str, *numbers: int) -> Iterator[None]:
    """Seeds torch's global generators inside; restores the random state on exit."""
    device = torch.device(device)
    with torch.random.fork_rng(devices=[] if device.type == "cpu" else [device.index or 0]):
        torch.manual_seed(mix(*numbers))
        yield
