"""Exercises of the notebook on a new style."""

import torch

from toolkit.course.checks import Exercise, same_as


def _banks() -> list[tuple]:
    draw = torch.Generator().manual_seed(6)
    return [(torch.randn(8, generator=draw), torch.randn(n, 8, generator=draw)) for n in (4, 9)]


EXERCISES = {
    "06.1": Exercise(
        same_as(lambda v, vectors: ((v - vectors.mean(0)) / vectors.std(0)).square().mean(), _banks,
                {"divide by the standard deviation, not by the variance.":
                 lambda v, vectors: ((v - vectors.mean(0)) / vectors.var(0)).square().mean(),
                 "this is the sum; take the mean over the numbers.":
                 lambda v, vectors: ((v - vectors.mean(0)) / vectors.std(0)).square().sum()}),
        "subtract vectors.mean(0), divide by vectors.std(0), square, take the mean."),
    "06.2": Exercise(
        same_as(lambda t: t * t * (3 - 2 * t), lambda: [(torch.linspace(0, 1, 5),), (torch.tensor(0.25),)],
                {"this is linear: its slope at both ends is 1.": lambda t: t,
                 "the slope at the end is not zero.": lambda t: t * t}),
        "write e(t) = a t² + b t³: which a and b give e(1) = 1 and e'(1) = 0?"),
    "06.3": Exercise(
        same_as(lambda before, after, floor: (before - after) / (before - floor),
                lambda: [(0.4, 0.1, 0.2), (0.9, 0.9, 0.3), (0.5, 0.4, 0.0)],
                {"this is the share of the error that is left.": lambda before, after, floor: after / before,
                 "this is the share that remains to go.": lambda before, after, floor: (after - floor) / (before - floor)}),
        "what was gained, divided by what could be gained."),
}
