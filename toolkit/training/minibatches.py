"""Minibatches of one style each (Mason et al. 2022, section 4.3)."""

import torch
from torch import Tensor

from toolkit.features import Features, splits

#: Uses of random numbers, each with its own streams; 1 is `splits.SPLIT`.
INIT, FRAMES, CLIPS, MIXUP, DROPOUT = 0, 2, 3, 4, 5


class Minibatches:
    """Frames and style clips of any step, as a pure function of the seed and the step.

    A minibatch holds frames of one style; the styles take turns in a fixed order. Frames are drawn
    without replacement in one pass of a style, style clips independently of them. An epoch is one
    pass of the shortest style (section 4.3).

    Departure from the paper, off by default: pose mix-up. The input pose of some frames is blended,
    by a random share, with the pose of a random frame of any style; the target stays the same. A
    real input pose shows its style. Therefore a short training hardly uses the style vector, and a
    character keeps the style in which it starts. A mixed pose does not show its style, so the
    network learns to return to the style of the vector.

    ``batch`` and ``clips`` are the numbers of frames and style clips of a minibatch, ``pose_mixup``
    is the share of frames with a mixed input pose, ``memory`` the number of past frames of a model
    that needs them. The same ``seed`` gives the same minibatches. In a loop of your own, several
    processes load them by ``DataLoader(minibatches, batch_size=None, sampler=range(steps))``.

    ValueError if a style has no frames or no style clips.
    """

    def __init__(self, data: Features, batch: int, clips: int, seed: int, pose_mixup: float = 0.0,
                 memory: int = 0):
        self.data, self.batch, self.clips, self.seed = data, batch, clips, seed
        self.pose_mixup, self.memory, self.styles = pose_mixup, memory, data.styles
        for style in self.styles:
            if not len(data.inputs[style]) or not len(data.clips[style]):
                raise ValueError(f"style {style!r} has {len(data.inputs[style])} frames and "
                                 f"{len(data.clips[style])} style clips to train on; it needs both")
        shortest = min(len(x) for x in data.inputs.values())
        self.steps_per_epoch = max(1, shortest // batch) * len(self.styles)
        self.fewest = min(batch, shortest)  # frames of a minibatch
        self._orders: dict[str, tuple[int, Tensor]] = {}

    def __getitem__(self, step: int) -> tuple[Tensor, Tensor, Tensor, Tensor]:
        """x ``[B, Dx]``, p ``[B, 8]``, z ``[B, Dz]`` and y ``[M, 240, 12 J]`` in physical units.

        With a memory of K frames x is ``[B, K + 1, Dx]``.
        """
        turn, which = divmod(step, len(self.styles))
        style, batch, data = self.styles[which], self.batch, self.data
        n = len(data.inputs[style])
        sweep, place = divmod(turn, max(1, n // batch))
        if self._orders.get(style, (None,))[0] != sweep:
            draw = splits.generator(self.seed, FRAMES, which, sweep)
            self._orders[style] = sweep, torch.randperm(n, generator=draw)
        rows = self._orders[style][1][place * batch : (place + 1) * batch]
        draw = splits.generator(self.seed, CLIPS, step)
        clips = torch.randint(len(data.clips[style]), (self.clips,), generator=draw)
        x = remembered(data, style, rows, self.memory)
        if self.pose_mixup:
            x = self._mixed_up(x, step)
        return x, data.phases[style][rows], data.outputs[style][rows], data.clips[style][clips]

    def _mixed_up(self, x: Tensor, step: int) -> Tensor:
        """``x`` with some poses moved a random part of the way to those of any style."""
        draw, joints = splits.generator(self.seed, MIXUP, step), self.data.layout.inputs["joints"]
        others = torch.randint(len(self.styles), (len(x),), generator=draw).tolist()
        places = torch.rand(len(x), generator=draw).tolist()
        how_far, which = torch.rand(2, len(x), 1, generator=draw)
        x = x.clone()
        for i in (which[:, 0] < self.pose_mixup).nonzero()[:, 0].tolist():
            rows = self.data.inputs[self.styles[others[i]]]
            other, pose = rows[int(places[i] * len(rows))][joints], x[i, ..., joints]
            pose += how_far[i] * (other - pose)
        return x


def remembered(data: Features, style: str, rows: Tensor, memory: int) -> Tensor:
    """Input frames ``[B, Dx]`` of rows of a style, or ``[B, memory + 1, Dx]`` with those before.

    The present frame is the last. Where a take, or what is left of it, begins less than ``memory``
    frames before, its first frame repeats.
    """
    if not memory:
        return data.inputs[style][rows]
    steps = torch.arange(memory, -1, -1)
    before = (rows[:, None] - steps).clamp_min(0)
    number, frame = data.takes[style], data.frames[style]
    same = (number[before] == number[rows, None]) & (frame[before] == frame[rows, None] - steps)
    # same is False, …, False, True, …, True: of m True the first frame is row + 1 - m
    before = torch.where(same, before, rows[:, None] + 1 - same.sum(1, keepdim=True))
    return data.inputs[style][before.flatten()].unflatten(0, before.shape)
