"""Exercises of the notebook on the seven models."""

import torch

from toolkit.course.checks import Exercise, same_as


def _layers() -> list[tuple]:
    draw = torch.Generator().manual_seed(7)
    return [tuple(torch.randn(*shape, generator=draw) for shape in ((n, 5), (5,), (5,), (5,))) for n in (3, 8)]


def _clear(errors) -> bool:
    mean, spread = errors.mean(1), errors.std(1)
    first, second = mean.argsort()[:2]
    return bool(mean[second] - mean[first] > max(spread[first], spread[second]))


def _tables() -> list[tuple]:
    return [(torch.tensor(rows),) for rows in ([[0.10, 0.12], [0.11, 0.15], [0.30, 0.31]], [[0.50, 0.51], [0.20, 0.21]],
                                               [[0.20, 0.40], [0.10, 0.14], [0.11, 0.131]])]


EXERCISES = {
    "07.1": Exercise(
        same_as(lambda hidden: 4 * hidden, lambda: [(128,), (512,)],
                {"FiLM has a scale and a shift.": lambda hidden: 2 * hidden,
                 "this is a whole layer, as in an adapter.": lambda hidden: hidden * hidden}),
        "count: two layers, and in each a scale and a shift per unit."),
    "07.2": Exercise(
        same_as(lambda w, b, gamma, beta: torch.cat((w * gamma, (gamma * b + beta)[None])), _layers,
                {"the bias is scaled by γ, too.": lambda w, b, gamma, beta: torch.cat((w * gamma, (b + beta)[None])),
                 "β is not scaled.": lambda w, b, gamma, beta: torch.cat((w * gamma, (gamma * (b + beta))[None]))}),
        "multiply each column of the weights by its γ; the new bias is γ b + β."),
    "07.3": Exercise(
        same_as(_clear, _tables, {"compare the difference with the spread of the seeds.": lambda errors: True}),
        "sort the means, take the first two, compare their difference with errors.std(1) of both."),
}
