"""Exercises of the notebook on the five losses."""

import torch

from toolkit.course.checks import Exercise, equals, same_as


def _cycle(x, code, restyle, encode):
    return (restyle(restyle(x, code), encode(x)) - x).square().sum(-1).mean()


def _cases() -> list[tuple]:
    draw = torch.Generator().manual_seed(8)
    x, code = torch.randn(6, 2, generator=draw), torch.randn(6, 1, generator=draw)
    return [(x, code, lambda p, c: 0.8 * p + c, lambda p: p[:, 1:] / 3), (x, code, lambda p, c: p * c, lambda p: p[:, :1])]


def _pairs() -> list[tuple]:
    draw = torch.Generator().manual_seed(9)
    return [(torch.randn(9, 2, generator=draw), torch.randn(9, 2, generator=draw), bound) for bound in (0.3, 1.0, 9.0)]


EXERCISES = {
    "08a.1": Exercise(
        same_as(_cycle, _cases,
                {"this is the identity loss: there is no way there and back.":
                 lambda x, code, restyle, encode: (restyle(x, encode(x)) - x).square().sum(-1).mean(),
                 "the way back needs the source's own code.":
                 lambda x, code, restyle, encode: (restyle(restyle(x, code), code) - x).square().sum(-1).mean(),
                 "the squared distance of a point is a sum over its coordinates.":
                 lambda x, code, restyle, encode: (restyle(restyle(x, code), encode(x)) - x).square().mean()}),
        "restyle with the code, restyle the result with encode(x), compare with x."),
    "08a.2": Exercise(
        same_as(lambda a, b, bound: (a - b).abs().mean(-1).clamp(max=bound).mean(), _pairs,
                {"the bound is for each point, before the mean over the points.":
                 lambda a, b, bound: (a - b).abs().mean().clamp(max=bound),
                 "there is no bound.": lambda a, b, bound: (a - b).abs().mean()}),
        "abs, mean over the last axis, clamp(max=bound), mean."),
    "08a.3": Exercise(
        equals({"A": "ds", "B": "adv", "C": "cyc"}),
        "do three noises lie on each other? Are results outside the box? Are large dots not on the right?"),
}
