"""What a training step sees: held-out windows, and minibatches of one style each (Mason et al. 2022, section 4.3)."""

import dataclasses

import numpy as np
import torch
from torch import Tensor

from toolkit.features import Features, Normaliser, Rows

SPLIT_FRAMES = 240  # held-out frames come in contiguous windows of this length: neighbours are almost the same frame
SPLIT_TAKES = 20  # from so many takes on, whole takes are held out: no frame near a held-out one is trained on
INIT, SPLIT, FRAMES, CLIPS, STRAY, DROPOUT = range(6)  # what draws random numbers; each from streams of its own


class Minibatches:
    """Frames and style clips of any step, as a pure function of the seed and the step.

    A minibatch holds frames of one style; styles come round-robin in a fixed order, frames without replacement within one
    pass of a style, style clips independently of the frames. An epoch is one pass of the shortest style (section 4.3).

    Departure from the paper, off unless asked for: some frames' input poses stray, blended with a random frame's of any
    style by a random share, while their targets stay. One step ahead a real input pose gives its style away, so that a
    short training hardly listens to the style vector and a character stays in whatever style it starts in; a strayed pose
    does not, and the network learns to lead it back to the style that the vector says.

    Parameters
    ----------
    data
        Features to train on.
    batch, clips
        Frames and style clips of a minibatch.
    seed
        The same seed, the same minibatches.
    stray
        Share of frames whose input pose strays.

    Raises
    ------
    ValueError
        If a style has no frames or no style clips.
    """

    def __init__(self, data: Features, batch: int, clips: int, seed: int, stray: float = 0.0):
        self.data, self.batch, self.clips, self.seed, self.stray, self.styles = data, batch, clips, seed, stray, data.styles
        for style in self.styles:
            if not len(data.inputs[style]) or not len(data.clips[style]):
                raise ValueError(f"style {style!r} has {len(data.inputs[style])} frames and {len(data.clips[style])} style "
                                 "clips to train on; it needs some of both")  # fmt: skip
        shortest = min(len(x) for x in data.inputs.values())
        self.steps_per_epoch = max(1, shortest // batch) * len(self.styles)
        self.fewest = min(batch, shortest)  # frames of a minibatch
        self._orders: dict[str, tuple[int, Tensor]] = {}

    def __getitem__(self, step: int) -> tuple[Tensor, Tensor, Tensor, Tensor]:
        """x ``[B, Dx]``, p ``[B, 8]``, z ``[B, Dz]`` and y ``[M, 240, 12 J]`` in physical units."""
        turn, which = divmod(step, len(self.styles))
        style, batch, data = self.styles[which], self.batch, self.data
        n = len(data.inputs[style])
        sweep, place = divmod(turn, max(1, n // batch))
        if self._orders.get(style, (None,))[0] != sweep:
            self._orders[style] = sweep, torch.randperm(n, generator=generator(self.seed, FRAMES, which, sweep))
        rows = self._orders[style][1][place * batch : (place + 1) * batch]
        draw = generator(self.seed, CLIPS, step)
        clips = torch.randint(len(data.clips[style]), (self.clips,), generator=draw)
        x = data.inputs[style][rows]
        if self.stray:
            x = self._strayed(x, step)
        return x, data.phases[style][rows], data.outputs[style][rows], data.clips[style][clips]

    def _strayed(self, x: Tensor, step: int) -> Tensor:
        """``x`` with the poses of some frames moved a random part of the way to those of frames of any style."""
        draw, joints = generator(self.seed, STRAY, step), self.data.layout.inputs["joints"]
        others = torch.randint(len(self.styles), (len(x),), generator=draw).tolist()
        places = torch.rand(len(x), generator=draw).tolist()
        how_far, which = torch.rand(2, len(x), 1, generator=draw)
        x = x.clone()
        for i in (which[:, 0] < self.stray).nonzero()[:, 0].tolist():
            rows = self.data.inputs[self.styles[others[i]]]
            x[i, joints] += how_far[i] * (rows[int(places[i] * len(rows))][joints] - x[i, joints])
        return x


def split(data: Features, share: float, seed: int, styles: tuple[str, ...]) -> tuple[Features, Features]:
    """Training and held-out frames of ``styles``, in that order; style clips stay with the training frames."""
    known = data.split if styles == tuple(data.styles) else None
    known = known if known and (known.share, known.seed) == (share, seed) else None
    masks = known.held_out if known else held_out(data, share, seed, styles)

    def take(masks: dict[str, Tensor], statistics: dict[str, Normaliser] | None) -> Features:
        pick = {kind: {s: _select(getattr(data, kind)[s], mask) for s, mask in masks.items()}
                for kind in ("inputs", "phases", "outputs", "takes")}  # fmt: skip
        clips = {s: data.clips[s] for s in styles}
        return dataclasses.replace(data, clips=clips, split=None, statistics=statistics, **pick)

    kept = take({s: ~masks[s] for s in styles}, known.statistics if known else None)
    return kept, take({s: masks[s] for s in styles}, None)


def _select(rows: Tensor | Rows, mask: Tensor) -> Tensor | Rows:
    return rows.select(mask) if isinstance(rows, Rows) else rows[mask]


def held_out(data: Features, share: float, seed: int, styles: tuple[str, ...]) -> dict[str, Tensor]:
    """Which rows of each style are held out, ``[N]`` bool.

    About ``share`` of every style: whole takes where a style has `SPLIT_TAKES` of them, otherwise random windows of 4 s,
    contiguous in a take; a style shorter than that gives the share at its end. A take and its mirror image count as one.
    """
    masks = {}
    for i, style in enumerate(styles):
        n, takes = len(data.takes[style]), data.takes[style].unique()
        windows = [(data.takes[style] == take).nonzero()[:, 0] for take in takes]
        if len(windows) < SPLIT_TAKES:
            windows = [w for take in windows for w in take.split(SPLIT_FRAMES)]
        target, chosen = round(share * n), torch.zeros(n, dtype=torch.bool)
        for w in torch.randperm(len(windows), generator=generator(seed, SPLIT, i)).tolist():
            if (need := target - int(chosen.sum())) <= 0:
                break
            chosen[windows[w] if len(takes) >= SPLIT_TAKES else windows[w][-need:]] = True
        masks[style] = chosen
    return masks


def generator(*numbers: int) -> torch.Generator:
    """A generator of random numbers for one stream: the same numbers, the same stream."""
    return torch.Generator().manual_seed(mix(*numbers))


def mix(*numbers: int) -> int:
    """One seed of several numbers."""
    return int(np.random.SeedSequence(numbers).generate_state(1, np.uint64)[0] >> np.uint64(1))
