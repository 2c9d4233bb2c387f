"""Exercises of the notebooks on blends, the space of styles, a new style, the five losses, and
restyling.
"""

import math

import torch
from course.checks import Exercise, draws, equals, same_as


def _ease(t):
    t = torch.as_tensor(t, dtype=torch.float64).clamp(0, 1)
    return t * t * (3 - 2 * t)


def _weights_at(point, corners):
    sides = torch.stack((corners[1] - corners[0], corners[2] - corners[0]), 1)
    second, third = torch.linalg.solve(sides, point - corners[0])
    return torch.stack((1 - second - third, second, third))


def _triangles() -> list[tuple]:
    corners = torch.tensor([[0.0, 0.0], [1.0, 0.0], [0.5, 0.87]])
    points = corners.mean(0), corners[1], torch.tensor([0.4, 0.1])
    return [(point, corners) for point in points] + [(points[2], 2 * corners.flip(0) + 1)]


def _barycentric(style, corners):
    weights = torch.tensor([style[name] for name in corners], dtype=torch.float64)
    return weights / weights.sum()


def _nearest(vectors, query):
    distance = (vectors - vectors[query]).norm(dim=1)
    distance[query] = math.inf
    return int(distance.argmin())


def _cycle(x, code, restyle, encode):
    return (restyle(restyle(x, code), encode(x)) - x).square().sum(-1).mean()


def _cases() -> list[tuple]:
    x, code = draws(8, (6, 2), (6, 1))
    return [
        (x, code, lambda p, c: 0.8 * p + c, lambda p: p[:, 1:] / 3),
        (x, code, lambda p, c: p * c, lambda p: p[:, :1])
    ]


def _adain(h, gamma, beta):
    mean, std = h.mean(1, keepdim=True), h.std(1, keepdim=True, correction=0)
    return (1 + gamma[:, None]) * (h - mean) / std + beta[:, None]


EXERCISES = {
    "04.1": Exercise(
        same_as(
            _barycentric,
            lambda: [
                ({"Old": 2.0, "Strut": 1.0, "Zombie": 1.0}, ["Old", "Strut", "Zombie"]),
                ({"A": 0.0, "B": 5.0}, ["B", "A"]), ({"A": 1.0}, ["A"])
            ],
            {
                "the weights should sum to one.": lambda style, corners: torch.tensor(
                    [style[name] for name in corners]
                ),
                "the order should be that of `corners`.": lambda style, corners: (
                    torch.tensor(list(style.values())) / sum(style.values())
                ),
            },
        ),
        "take the numbers in the order of corners, and divide them by their sum.",
    ),
    "04.2": Exercise(
        same_as(
            _ease,
            lambda: [(torch.linspace(-0.5, 1.5, 21),), (torch.tensor([0.25, 0.75]),)],
            {
                "this is the straight line: it starts and stops with a jerk.": lambda t: t.clamp(
                    0, 1
                ),
                "clamp t to 0 … 1 first.": lambda t: t * t * (3 - 2 * t),
            },
        ),
        "t²(3 − 2t) has the slope zero at 0 and at 1.",
    ),
    "04.3": Exercise(
        same_as(
            _weights_at,
            _triangles,
            {
                "these are distances: a weight is one in its own corner.": lambda point, corners: (
                    corners - point
                ).norm(dim=1),
                "weights from distances do not give the point back: weights @ corners should be "
                "the point.": lambda point, corners: (
                    torch.softmax(-(corners - point).norm(dim=1), 0)
                ),
            },
        ),
        "three unknowns, three equations: weights @ corners = point has two, and the sum of the "
        "weights is one.",
    ),
    "05.1": Exercise(
        same_as(
            lambda a, b, t: (1 - t) * a + t * b,
            lambda: [
                (torch.tensor([1.0, 2.0]), torch.tensor([3.0, -4.0]), t) for t in (0.0, 0.25, 1.5)
            ],
            {
                "at t = 0 the blend must be the first vector.": lambda a, b, t: t * a + (1 - t) * b,
                "the weights must sum to one.": lambda a, b, t: a + t * b
            },
        ),
        "the weights are 1 − t and t.",
    ),
    "05.2": Exercise(
        same_as(
            _nearest,
            lambda: [(*draws(5, (6, 4)), query) for query in (0, 3, 5)],
            {
                "this is the query itself: its distance is 0.": lambda vectors, query: query,
                "this is the farthest vector.": lambda vectors, query: int(
                    (vectors - vectors[query]).norm(dim=1).argmax()
                ),
            },
        ),
        "compute the distance of each row from the query's, replace the query's own by infinity, "
        "take argmin.",
    ),
    "05.3": Exercise(
        same_as(
            lambda length, angle: length * math.cos(angle / 2),
            lambda: [(0.6, 0.0), (0.6, 2.0), (0.3, 2.6)],
            {
                "this is half of the distance between the two positions of the "
                "hand.": lambda length, angle: (
                    length * math.sin(angle / 2)
                ),
                "use half of the angle: the middle is on the line that halves "
                "it.": lambda length, angle: (
                    length * math.cos(angle)
                ),
            },
        ),
        "draw the shoulder and both positions of the hand: an isosceles triangle. Its height is "
        "the answer.",
    ),
    "06.1": Exercise(
        same_as(
            lambda v, vectors: ((v - vectors.mean(0)) / vectors.std(0)).square().mean(),
            lambda: [draws(6, (8,), (n, 8)) for n in (4, 9)],
            {
                "divide by the standard deviation, not by the variance.": lambda v, vectors: (
                    ((v - vectors.mean(0)) / vectors.var(0)).square().mean()
                ),
                "this is the sum; take the mean over the numbers.": lambda v, vectors: (
                    ((v - vectors.mean(0)) / vectors.std(0)).square().sum()
                ),
            },
        ),
        "subtract vectors.mean(0), divide by vectors.std(0), square, take the mean.",
    ),
    "06.2": Exercise(
        same_as(
            lambda v, matrix, z, rate: v - 2 * rate * matrix.T @ (matrix @ v - z),
            lambda: [(*draws(12, (2,), (3, 2), (3,)), 0.03), (*draws(13, (4,), (9, 4), (9,)), 0.1)],
            {
                "this goes up the slope.": lambda v, matrix, z, rate: (
                    v + 2 * rate * matrix.T @ (matrix @ v - z)
                ),
                "the derivative of a square has the factor two.": lambda v, matrix, z, rate: (
                    v - rate * matrix.T @ (matrix @ v - z)
                ),
            },
        ),
        "the slope of ‖W v − z‖² is 2 Wᵀ (W v − z).",
    ),
    "06.3": Exercise(
        same_as(
            lambda before, after, floor: (before - after) / (before - floor),
            lambda: [(0.4, 0.1, 0.2), (0.9, 0.9, 0.3), (0.5, 0.4, 0.0)],
            {
                "this is the share of the error that is left.": lambda before, after, floor: (
                    after / before
                ),
                "this is the share that remains to go.": lambda before, after, floor: (
                    (after - floor) / (before - floor)
                ),
            },
        ),
        "what was gained, divided by what could be gained.",
    ),
    "08a.1": Exercise(
        same_as(
            _cycle,
            _cases,
            {
                "this is the identity loss: there is no way there and "
                "back.": lambda x, code, restyle, encode: (
                    (restyle(x, encode(x)) - x).square().sum(-1).mean()
                ),
                "the way back needs the source's own code.": lambda x, code, restyle, encode: (
                    (restyle(restyle(x, code), code) - x).square().sum(-1).mean()
                ),
                "the squared distance of a point is a sum over its "
                "coordinates.": lambda x, code, restyle, encode: (
                    (restyle(restyle(x, code), encode(x)) - x).square().mean()
                ),
            },
        ),
        "restyle with the code, restyle the result with encode(x), compare with x.",
    ),
    "08a.2": Exercise(
        same_as(
            lambda a, b, bound: (a - b).abs().mean(-1).clamp(max=bound).mean(),
            lambda: [(*draws(9, (9, 2), (9, 2)), bound) for bound in (0.3, 1.0, 9.0)],
            {
                "the bound is for each point, before the mean over the "
                "points.": lambda a, b, bound: (
                    (a - b).abs().mean().clamp(max=bound)
                ),
                "there is no bound.": lambda a, b, bound: (a - b).abs().mean(),
            },
        ),
        "abs, mean over the last axis, clamp(max=bound), mean.",
    ),
    "08a.3": Exercise(
        equals({"A": "ds", "B": "adv", "C": "cyc"}),
        "do three noises lie on each other? Are results outside the box? Are large dots not on "
        "the right?",
    ),
    "08b.1": Exercise(
        same_as(
            _adain,
            lambda: [draws(10, (c, 20), (c,), (c,)) for c in (1, 4)],
            {
                "the scale is 1 + γ.": lambda h, gamma, beta: _adain(h, gamma - 1, beta),
                "mean and deviation are over the frames, axis 1.": lambda h, gamma, beta: (
                    (1 + gamma[:, None]) * (h - h.mean()) / h.std(correction=0) + beta[:, None]
                ),
            },
        ),
        "subtract the mean over axis 1, divide by the deviation, multiply by 1 + γ, add β; use "
        "[:, None].",
    ),
    "08b.2": Exercise(
        same_as(
            lambda x, plain, target: x + (target.mean((0, 2)) - plain.mean((0, 2)))[None, :, None],
            lambda: [
                tuple(x + k for k, x in enumerate(draws(11, (2, 5, 8), (6, 5, 8), (9, 5, 8))))
            ],
            {
                "the sign is wrong: go from plain to target.": lambda x, plain, target: (
                    x + (plain.mean((0, 2)) - target.mean((0, 2)))[None, :, None]
                ),
                "take a mean for each number, not one of all.": lambda x, plain, target: (
                    x + target.mean() - plain.mean()
                ),
            },
        ),
        "mean((0, 2)) is the mean over windows and frames.",
    ),
    "08b.3": Exercise(
        same_as(
            lambda m, s, n, r: (m - n) ** 2 + (s - r) ** 2,
            lambda: [(0.0, 1.0, 2.0, 3.0), (1.0, 2.0, 1.0, 0.5)],
            {
                "this leaves the deviations out.": lambda m, s, n, r: (m - n) ** 2,
                "the last term is missing: − 2 s r.": lambda m, s, n, r: (m - n) ** 2 + s**2 + r**2
            },
        ),
        "Σ is the square of the deviation: s² + r² − 2 s r.",
    ),
}
