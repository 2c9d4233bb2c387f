"""Exercises of the notebooks on the network, its training, and the seven models."""

import torch
from course.checks import Exercise, draws, same_as


def _blended(x, gates, weight, bias):
    matrix = torch.einsum("bk,kio->bio", gates, weight)
    return torch.einsum("bi,bio->bo", x, matrix) + gates @ bias


def _layers() -> list[tuple]:
    cases = draws(6, (5, 4), (5, 3), (3, 4, 6), (3, 6)), draws(7, (1, 2), (1, 8), (8, 2, 2), (8, 2))
    return [(x, gates.softmax(-1), weight, bias) for x, gates, weight, bias in cases]


def _film(f, gamma, beta):
    normal = (f - f.mean(-1, keepdim=True)) / (f.std(-1, keepdim=True) + 1e-6)
    return torch.nn.functional.elu(gamma * normal + beta)


def _over_the_batch(f, gamma, beta):
    return torch.nn.functional.elu(gamma * (f - f.mean(0)) / (f.std(0) + 1e-6) + beta)


def _count(n_in, hidden, n_out, experts):
    return experts * ((n_in + 1) * hidden + (hidden + 1) * hidden + (hidden + 1) * n_out)


def _lengths(predicted, true, parents):
    pairs = [(parent, j) for j, parent in enumerate(parents) if parent >= 0]
    return tuple(
        torch.stack([(p[:, a] - p[:, b]).norm(dim=-1) for a, b in pairs], 1)
        for p in (predicted, true)
    )


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
    return [
        (*draws(8, *[(4, len(parents), 3)] * 2), parents)
        for parents in ([-1, 0, 1, 1], [-1, 0], [-1, 0, 1, 2, 0])
    ]


def _repeat(frames, deviation):
    return (((frames[1:] - frames[:-1]) / deviation) ** 2).mean()


def _share(rolled, data):
    rolled, data = rolled - rolled.mean(0), data - data.mean(0)
    return (rolled * data).sum() / (data * data).sum()


def _poses() -> list[tuple]:
    data, noise, other = draws(10, *[(4, 12)] * 3)
    return [(0.4 * (data + 3) + 0.2 * noise, data + 3), (other, data + 3)]


def _clear(errors) -> bool:
    mean, spread = errors.mean(1), errors.std(1)
    first, second = mean.argsort()[:2]
    return bool(mean[second] - mean[first] > max(spread[first], spread[second]))


def _tables() -> list[tuple]:
    return [
        (torch.tensor(rows),)
        for rows in (
            [[0.10, 0.12], [0.11, 0.15], [0.30, 0.31]], [[0.50, 0.51], [0.20, 0.21]],
            [[0.20, 0.40], [0.10, 0.14], [0.11, 0.131]]
        )
    ]


EXERCISES = {
    "03a.1": Exercise(
        same_as(
            _blended,
            _layers,
            {
                "the biases must be blended, too.": lambda x, gates, weight, bias: _blended(
                    x, gates, weight, 0 * bias
                ),
                "you take the mean of the experts: use the gates.": lambda x, gates, weight, bias: (
                    _blended(x, torch.full_like(gates, 1 / gates.shape[1]), weight, bias)
                ),
                "you take only the expert with the largest gate.": lambda x, gates, *expert: (
                    _blended(x, (gates == gates.amax(1, keepdim=True)).to(gates), *expert)
                ),
            },
        ),
        "torch.einsum('bk,kio->bio', gates, weight) is one matrix for each row of x; the bias is "
        "blended, too.",
    ),
    "03a.2": Exercise(
        same_as(
            _film,
            lambda: [draws(7, (4, 16), (16,), (16,)), draws(8, (2, 5), (5,), (5,))],
            {
                "normalise over the units of a row, not over the rows.": _over_the_batch,
                "ELU is missing.": lambda f, gamma, beta: (
                    gamma * (f - f.mean(-1, keepdim=True)) / f.std(-1, keepdim=True) + beta
                ),
                "scale and shift come after the normalisation.": lambda f, gamma, beta: _film(
                    gamma * f + beta, torch.ones_like(gamma), torch.zeros_like(beta)
                ),
            },
        ),
        "subtract the mean of the last axis, divide by std (torch's: n - 1), scale, shift, then "
        "ELU.",
    ),
    "03a.3": Exercise(
        same_as(
            lambda *sizes: torch.tensor(_count(*sizes)),
            lambda: [(348, 512, 342, 8), (3, 4, 5, 2), (10, 1, 1, 1)],
            {
                "the biases are missing.": lambda n_in, hidden, n_out, experts: torch.tensor(
                    experts * (n_in * hidden + hidden * hidden + hidden * n_out)
                ),
                "this is the number for one expert.": lambda n_in, hidden, n_out, experts: (
                    torch.tensor(_count(n_in, hidden, n_out, 1))
                ),
            },
            tolerance=1e-9,
        ),
        "three layers; each has a matrix and a bias, and there is one of each for every expert.",
    ),
    "03b.1": Exercise(
        same_as(
            _bone_error,
            _skeletons,
            {
                "this compares the bones as vectors; only their lengths should count.": _as_vectors,
                "take the absolute value, not the square.": _squared
            },
        ),
        "the length of bone j is the distance of joint j from its parent; joints with a parent "
        "below zero have no bone.",
    ),
    "03b.2": Exercise(
        same_as(
            _repeat,
            lambda: [
                (x.cumsum(0), s.abs() + 0.5) for x, s in (draws(9, (n, 6), (6,)) for n in (30, 4))
            ],
            {
                "divide by the deviation, so that all columns count "
                "alike.": lambda frames, deviation: (
                    _repeat(frames, 1.0)
                ),
                "take the mean over all numbers, not the sum.": lambda frames, deviation: (
                    _repeat(frames, deviation) * frames[1:].numel()
                ),
            },
        ),
        "the prediction of frame i + 1 is frame i.",
    ),
    "03b.3": Exercise(
        same_as(
            _share,
            _poses,
            {
                "subtract the mean over the styles from both first.": lambda rolled, data: (
                    (rolled * data).sum() / (data * data).sum()
                ),
                "divide by the sum over the data, not over the closed loop.": lambda rolled, data: (
                    1 / _share(data, rolled)
                ),
            },
        ),
        "sum over styles and columns of r · m, divided by the sum of m · m.",
    ),
    "07.1": Exercise(
        same_as(
            lambda hidden: 4 * hidden,
            lambda: [(128,), (512,)],
            {
                "FiLM has a scale and a shift.": lambda hidden: 2 * hidden,
                "this is a whole layer, as in an adapter.": lambda hidden: hidden * hidden
            },
        ),
        "count: two layers, and in each a scale and a shift per unit.",
    ),
    "07.2": Exercise(
        same_as(
            lambda w, b, gamma, beta: torch.cat((w * gamma, (gamma * b + beta)[None])),
            lambda: [draws(7, (n, 5), (5,), (5,), (5,)) for n in (3, 8)],
            {
                "the bias is scaled by γ, too.": lambda w, b, gamma, beta: torch.cat(
                    (w * gamma, (b + beta)[None])
                ),
                "β is not scaled.": lambda w, b, gamma, beta: torch.cat(
                    (w * gamma, (gamma * (b + beta))[None])
                ),
            },
        ),
        "multiply each column of the weights by its γ; the new bias is γ b + β.",
    ),
    "07.3": Exercise(
        same_as(
            _clear, _tables,
            {"compare the difference with the spread of the seeds.": lambda errors: True}
        ),
        "sort the means, take the first two, compare their difference with errors.std(1) of both.",
    ),
}
