"""Exercises of the notebook on the network by hand."""

import torch

from toolkit.course.checks import Exercise, same_as


def _blended(x, gates, weight, bias):
    matrix = torch.einsum("bk,kio->bio", gates, weight)
    return torch.einsum("bi,bio->bo", x, matrix) + gates @ bias


def _layers() -> list[tuple]:
    make = torch.Generator().manual_seed(6)

    def draw(*shape: int) -> torch.Tensor:
        return torch.randn(shape, generator=make)

    return [(draw(5, 4), draw(5, 3).softmax(-1), draw(3, 4, 6), draw(3, 6)), (draw(1, 2), draw(1, 8).softmax(-1),
            draw(8, 2, 2), draw(8, 2))]


def _film(f, gamma, beta):
    normal = (f - f.mean(-1, keepdim=True)) / (f.std(-1, keepdim=True) + 1e-6)
    return torch.nn.functional.elu(gamma * normal + beta)


def _over_the_batch(f, gamma, beta):
    return torch.nn.functional.elu(gamma * (f - f.mean(0)) / (f.std(0) + 1e-6) + beta)


def _hidden() -> list[tuple]:
    make = torch.Generator().manual_seed(7)
    return [(3 * torch.randn(b, n, generator=make) + 1, *torch.randn(2, n, generator=make)) for b, n in ((4, 16), (2, 5))]


def _count(n_in, hidden, n_out, experts):
    return experts * ((n_in + 1) * hidden + (hidden + 1) * hidden + (hidden + 1) * n_out)


EXERCISES = {
    "03a.1": Exercise(
        same_as(_blended, _layers,
                {"the biases must be blended, too.": lambda x, gates, weight, bias: _blended(x, gates, weight, 0 * bias),
                 "you take the mean of the experts: use the gates.":
                 lambda x, gates, weight, bias: _blended(x, torch.full_like(gates, 1 / gates.shape[1]), weight, bias),
                 "you take only the expert with the largest gate.":
                 lambda x, gates, *expert: _blended(x, (gates == gates.amax(1, keepdim=True)).to(gates), *expert)}),
        "torch.einsum('bk,kio->bio', gates, weight) is one matrix for each row of x."),
    "03a.2": Exercise(
        same_as(_film, _hidden,
                {"normalise over the units of a row, not over the rows.": _over_the_batch,
                 "ELU is missing.": lambda f, gamma, beta:
                 gamma * (f - f.mean(-1, keepdim=True)) / f.std(-1, keepdim=True) + beta,
                 "scale and shift come after the normalisation.": lambda f, gamma, beta:
                 _film(gamma * f + beta, torch.ones_like(gamma), torch.zeros_like(beta))}),
        "subtract the mean of the last axis, divide by its standard deviation, scale, shift, then ELU."),
    "03a.3": Exercise(
        same_as(lambda *sizes: torch.tensor(_count(*sizes)), lambda: [(348, 512, 342, 8), (3, 4, 5, 2), (10, 1, 1, 1)],
                {"the biases are missing.": lambda n_in, hidden, n_out, experts:
                 torch.tensor(experts * (n_in * hidden + hidden * hidden + hidden * n_out)),
                 "this is the number for one expert.": lambda n_in, hidden, n_out, experts:
                 torch.tensor(_count(n_in, hidden, n_out, 1))}, tolerance=1e-9),
        "three layers; each has a matrix and a bias, and there is one of each for every expert."),
}
