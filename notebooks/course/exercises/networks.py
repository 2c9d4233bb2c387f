"""Exercises of the notebooks on the network, its training, and the seven models."""

import torch
from course.checks import Exercise, draws, equals, same_as, shows
from torch.nn import functional


def _film(f, gamma, beta):
    normal = (f - f.mean(-1, keepdim=True)) / (f.std(-1, keepdim=True) + 1e-6)
    return functional.elu(gamma * normal + beta)


def _told_apart(one, other) -> bool:
    gamma, beta = draws(4, (len(one),), (len(one),))
    both = (_film(torch.as_tensor(row).double(), gamma, beta) for row in (one, other))
    return float(torch.sub(*both).abs().max()) > 1e-4


def _count(n_in, hidden, n_out, experts):
    return experts * ((n_in + 1) * hidden + (hidden + 1) * hidden + (hidden + 1) * n_out)


def _lengths(poses, parents):
    pairs = [(parent, j) for j, parent in enumerate(parents) if parent >= 0]
    return torch.stack([(poses[:, a] - poses[:, b]).norm(dim=-1) for a, b in pairs], 1)


def _bone_error(predicted, true, parents):
    return (_lengths(predicted, parents) - _lengths(true, parents)).abs().mean()


def _squared(predicted, true, parents):
    return (_lengths(predicted, parents) - _lengths(true, parents)).square().mean()


def _as_vectors(predicted, true, parents):
    off = predicted - true
    return torch.stack([off[:, j] - off[:, parent]
                        for j, parent in enumerate(parents) if parent >= 0]).norm(dim=-1).mean()


def _skeletons() -> list[tuple]:
    return [
        (*draws(8, *[(4, len(parents), 3)] * 2), parents)
        for parents in ([-1, 0, 1, 1], [-1, 0], [-1, 0, 1, 2, 0])
    ]


#: Of exercise 03b.3: a hip, a knee and an ankle, metres.
LEG = torch.tensor([[0.0, 1.0, 0.0], [0.0, 0.55, 0.1], [0.0, 0.1, 0.0]])


def _off(pose) -> torch.Tensor:
    return torch.as_tensor(pose).float() - LEG


def _leg_error(pose) -> float:
    return float(_bone_error((LEG + _off(pose))[None], LEG[None], [-1, 0, 1]))


def _grown(a, b, n):
    return b * (1 - a ** torch.arange(1, n + 1)) / (1 - a)


def _clear(errors) -> bool:
    mean, spread = errors.mean(1), errors.std(1)
    first, second = mean.argsort()[:2]
    return bool(mean[second] - mean[first] > max(spread[first], spread[second]))


def _tables() -> list[tuple]:
    rows = (
        [[0.10, 0.12], [0.11, 0.15], [0.30, 0.31]],
        [[0.50, 0.51], [0.20, 0.21]],
        [[0.10, 0.14], [0.13, 0.131]],
        [[0.20, 0.40], [0.10, 0.14], [0.11, 0.131]],
        [[0.10, 0.12, 0.11], [0.12, 0.13, 0.14], [0.50, 0.90, 0.10]],
        [[0.10, 0.13], [0.14, 0.15]],  # torch's deviation: 0.021, the population's: 0.015
        [[0.30, 0.303, 0.31], [0.31, 0.318, 0.314], [0.9, 0.2, 0.8]],
        [[0.100, 0.104], [0.104, 0.124], [0.5, 0.6]],  # the mean of both deviations is smaller
    )
    return [(torch.tensor(row),) for row in rows]


EXERCISES = {
    "03a.1": Exercise(
        same_as(lambda first, second: first / (first - second),
                lambda: [(1.2, -0.4), (-3.0, 0.5), (2.0, -2.0)], {
            "this is the share of the first expert.":
                lambda first, second: second / (second - first),
            "this is a ratio of slopes, not a share.": lambda first, second: first / -second,
        }),
        "what is the slope of the blend if the second expert has the share α?",
        "(1 − α) · first + α · second = 0, solved for α.",
    ),
    "03a.2": Exercise(
        shows(
            ("give two rows of as many units, two or more",
             lambda one, other: len(one) == len(other) > 1),
            ("the two rows are the same", lambda one, other: not torch.allclose(
                *(torch.as_tensor(x).double() for x in (one, other)), rtol=1e-3, atol=0)),
            ("a style tells them apart", lambda one, other: not _told_apart(one, other)),
            parts=2,
        ),
        "what does the layer normalisation remove from a row?",
        "take any row, and the same row times a positive number, plus a number.",
    ),
    "03a.3": Exercise(
        same_as(
            _count, lambda: [(348, 512, 342, 8), (3, 4, 5, 2), (10, 1, 1, 1)],
            {
                "the biases are missing.": lambda n_in, hidden, n_out, experts: (
                    experts * (n_in * hidden + hidden * hidden + hidden * n_out)
                ),
                "this is the number for one expert.":
                    lambda n_in, hidden, n_out, experts: _count(n_in, hidden, n_out, 1),
            },
            tolerance=1e-9,
        ),
        "how many numbers has one layer of one expert, with its bias?",
        "(inputs + 1) · outputs for each of three layers, added up, times the experts.",
    ),
    "03b.1": Exercise(
        same_as(
            _bone_error, _skeletons,
            {
                "this compares the bones as vectors; only their lengths should count.": _as_vectors,
                "take the absolute value, not the square.": _squared
            },
        ),
        "which two joints are the ends of bone j, and which joints have no bone?",
        "the length is the distance of joint j from its parent; leave out parents below zero.",
    ),
    "03b.2": Exercise(
        same_as(
            _grown,
            lambda: [(0.5, 1.0, 4), (0.9, 0.3, 30), (0.2, 2.0, 1)],
            {
                "the input of the first prediction has no error, its output has.":
                    lambda a, b, n: a * _grown(a, b, n),
                "the share `a` of the last error comes in again: the errors add up.":
                    lambda a, b, n: b * a ** torch.arange(n),
            },
        ),
        "what is the error of the second prediction, if the first one's is b?",
        "b, then a · b + b, then a · (a · b + b) + b: a loop, or the sum of powers of a.",
    ),
    "03b.3": Exercise(
        shows(
            ("give a pose of three joints [3, 3]", lambda pose: _off(pose).shape == (3, 3)),
            ("the hip has moved", lambda pose: float(_off(pose)[0].norm()) < 1e-3),
            ("a bone has another length", lambda pose: _leg_error(pose) < 1e-3),
            ("the squared error (mean of nine numbers) is small",
             lambda pose: _off(pose).square().mean() > 0.05),
        ),
        "what can a leg do that leaves its hip and its bones as they are?",
        "turn the leg about the hip, or the ankle about the knee.",
    ),
    "07.1": Exercise(
        equals(60.0, {
            "at this delay the hand is where it should be": 360.0,
            "this is in radians": torch.pi / 3,
        }, tolerance=0.01),
        "the hand is sin(t), the late one sin(t − d). What is the mean of the squared difference?",
        "1 − cos d for the late hand, and 1/2 for the statue: where are both equal?",
    ),
    "07.2": Exercise(
        equals(8 * (349 + 513) / 4, {
            "there are eight sets of weights": (349 + 513) / 4,
            "this is the count: divide it by that of γ and β": 8 * (349 + 513) * 512,
            "layers have biases, too": 8 * (348 + 512) / 4,
        }),
        "how many weights and biases has one expert, and how many γ and β has a style?",
        "8 × (349 × 512 + 513 × 512), divided by γ and β of two layers of 512 units.",
    ),
    "07.3": Exercise(
        same_as(_clear, _tables),
        "which two models have the smallest means, and how far do the seeds of each scatter?",
        "sort the means, take the first two, compare their difference with the larger errors.std.",
    ),
}
