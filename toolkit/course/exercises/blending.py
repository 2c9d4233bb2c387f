"""Exercises of the notebook on blends."""

import torch

from toolkit.course.checks import Exercise, same_as


def _ease(t):
    t = torch.as_tensor(t, dtype=torch.float64).clamp(0, 1)
    return t * t * (3 - 2 * t)


def _knee(a, b, d):
    return torch.acos(torch.as_tensor((a * a + b * b - d * d) / (2 * a * b)))


def _barycentric(style, corners):
    weights = torch.tensor([style[name] for name in corners], dtype=torch.float64)
    return weights / weights.sum()


EXERCISES = {
    "04.1": Exercise(
        same_as(_barycentric, lambda: [({"Old": 2.0, "Strut": 1.0, "Zombie": 1.0}, ["Old", "Strut", "Zombie"]),
                                       ({"A": 0.0, "B": 5.0}, ["B", "A"]), ({"A": 1.0}, ["A"])],
                {"the weights should sum to one.": lambda style, corners: torch.tensor([style[name] for name in corners]),
                 "the order should be that of `corners`.": lambda style, corners:
                 torch.tensor(list(style.values())) / sum(style.values())}),
        "take the numbers in the order of corners, and divide them by their sum."),
    "04.2": Exercise(
        same_as(_ease, lambda: [(torch.linspace(-0.5, 1.5, 21),), (torch.tensor([0.25, 0.75]),)],
                {"this is the straight line: it starts and stops with a jerk.": lambda t: t.clamp(0, 1),
                 "clamp t to 0 … 1 first.": lambda t: t * t * (3 - 2 * t)}),
        "t²(3 − 2t) has the slope zero at 0 and at 1."),
    "04.3": Exercise(
        same_as(_knee, lambda: [(0.43, 0.42, 0.7), (0.5, 0.3, 0.3), (1.0, 1.0, 2.0)],
                {"this is the cosine, not the angle.": lambda a, b, d: torch.cos(_knee(a, b, d)),
                 "this is the angle by which the knee bends: take π minus it.": lambda a, b, d: torch.pi - _knee(a, b, d)},
                tolerance=1e-4),
        "the law of cosines: cos φ = (a² + b² − d²) / 2ab; then math.acos."),
}
