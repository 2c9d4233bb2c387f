"""What a training step sees: held-out windows, and minibatches of one style each (Mason et al. 2022, section 4.3)."""

import torch
from torch import Tensor

from toolkit.features import Features, splits

INIT, SPLIT, FRAMES, CLIPS, STRAY, DROPOUT = range(6)  # what draws random numbers; each from streams of its own


class Minibatches:
    """Frames and style clips of any step, as a pure function of the seed and the step.

    A minibatch holds frames of one style; styles come round-robin in a fixed order, frames without replacement within one
    pass of a style, style clips independently of the frames. An epoch is one pass of the shortest style (section 4.3).

    Departure from the paper, off unless asked for: some frames' input poses stray, blended with a random frame's of any
    style by a random share, while their targets stay. One step ahead a real input pose gives its style away, so that a
    short training hardly listens to the style vector and a character stays in whatever style it starts in; a strayed pose
    does not, and the network learns to lead it back to the style that the vector says.

    ``batch`` and ``clips`` are the numbers of frames and style clips of a minibatch, ``stray`` the share of frames whose
    input pose strays. The same ``seed`` gives the same minibatches.

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
                                 "clips to train on; it needs some of both")
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
            self._orders[style] = sweep, torch.randperm(n, generator=splits.generator(self.seed, FRAMES, which, sweep))
        rows = self._orders[style][1][place * batch : (place + 1) * batch]
        draw = splits.generator(self.seed, CLIPS, step)
        clips = torch.randint(len(data.clips[style]), (self.clips,), generator=draw)
        x = data.inputs[style][rows]
        if self.stray:
            x = self._strayed(x, step)
        return x, data.phases[style][rows], data.outputs[style][rows], data.clips[style][clips]

    def _strayed(self, x: Tensor, step: int) -> Tensor:
        """``x`` with the poses of some frames moved a random part of the way to those of frames of any style."""
        draw, joints = splits.generator(self.seed, STRAY, step), self.data.layout.inputs["joints"]
        others = torch.randint(len(self.styles), (len(x),), generator=draw).tolist()
        places = torch.rand(len(x), generator=draw).tolist()
        how_far, which = torch.rand(2, len(x), 1, generator=draw)
        x = x.clone()
        for i in (which[:, 0] < self.stray).nonzero()[:, 0].tolist():
            rows = self.data.inputs[self.styles[others[i]]]
            x[i, joints] += how_far[i] * (rows[int(places[i] * len(rows))][joints] - x[i, joints])
        return x
