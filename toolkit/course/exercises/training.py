"""Exercises of the notebook on training."""

import torch

from toolkit.course.checks import Exercise, same_as


def _lengths(predicted, true, parents):
    pairs = [(parent, j) for j, parent in enumerate(parents) if parent >= 0]
    return tuple(torch.stack([(p[:, a] - p[:, b]).norm(dim=-1) for a, b in pairs], 1) for p in (predicted, true))


def _bone_error(predicted, true, parents):
    lengths, right = _lengths(predicted, true, parents)
    return (lengths - right).abs().mean()


def _squared(predicted, true, parents):
    lengths, right = _lengths(predicted, true, parents)
    return (lengths - right).square().mean()


def _as_vectors(predicted, true, parents):
    return torch.stack([(predicted - true)[:, j] - (predicted - true)[:, parent]
                        for j, parent in enumerate(parents) if parent >= 0]).norm(dim=-1).mean()


def _skeletons() -> list[tuple]:
    make = torch.Generator().manual_seed(8)
    return [(torch.randn(4, len(parents), 3, generator=make), torch.randn(4, len(parents), 3, generator=make), parents)
            for parents in ([-1, 0, 1, 1], [-1, 0], [-1, 0, 1, 2, 0])]


def _repeat(frames, deviation):
    return (((frames[1:] - frames[:-1]) / deviation) ** 2).mean()


def _curves() -> list[tuple]:
    make = torch.Generator().manual_seed(9)
    return [(torch.randn(n, 6, generator=make).cumsum(0), torch.rand(6, generator=make) + 0.5) for n in (30, 4)]


def _share(rolled, data):
    rolled, data = rolled - rolled.mean(0), data - data.mean(0)
    return (rolled * data).sum() / (data * data).sum()


def _poses() -> list[tuple]:
    make = torch.Generator().manual_seed(10)
    data = torch.randn(4, 12, generator=make) + 3
    return [(0.4 * data + 0.2 * torch.randn(4, 12, generator=make), data), (torch.randn(4, 12, generator=make), data)]


EXERCISES = {
    "03b.1": Exercise(
        same_as(_bone_error, _skeletons,
                {"this compares the bones as vectors; only their lengths should count.": _as_vectors,
                 "take the absolute value, not the square.": _squared}),
        "the length of bone j is the distance of joint j from its parent; joints with a parent below zero have no bone."),
    "03b.2": Exercise(
        same_as(_repeat, _curves,
                {"divide by the deviation, so that all columns count alike.": lambda frames, deviation: _repeat(frames, 1.0),
                 "take the mean over all numbers, not the sum.":
                 lambda frames, deviation: _repeat(frames, deviation) * frames[1:].numel()}),
        "the prediction of frame i + 1 is frame i."),
    "03b.3": Exercise(
        same_as(_share, _poses,
                {"subtract the mean over the styles from both first.":
                 lambda rolled, data: (rolled * data).sum() / (data * data).sum(),
                 "divide by the sum over the data, not over the closed loop.":
                 lambda rolled, data: 1 / _share(data, rolled)}),
        "sum over styles and columns of r · m, divided by the sum of m · m."),
}
