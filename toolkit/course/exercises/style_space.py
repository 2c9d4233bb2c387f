"""Exercises of the notebook on the space of styles."""

import math

import torch

from toolkit.course.checks import Exercise, same_as


def _points() -> list[tuple]:
    draw = torch.Generator().manual_seed(5)
    return [(torch.randn(6, 4, generator=draw), query) for query in (0, 3, 5)]


def _nearest(vectors, query):
    distance = (vectors - vectors[query]).norm(dim=1)
    distance[query] = math.inf
    return int(distance.argmin())


EXERCISES = {
    "05.1": Exercise(
        same_as(lambda a, b, t: (1 - t) * a + t * b,
                lambda: [(torch.tensor([1.0, 2.0]), torch.tensor([3.0, -4.0]), t) for t in (0.0, 0.25, 1.5)],
                {"at t = 0 the blend must be the first vector.": lambda a, b, t: t * a + (1 - t) * b,
                 "the weights must sum to one.": lambda a, b, t: a + t * b}),
        "the weights are 1 − t and t."),
    "05.2": Exercise(
        same_as(_nearest, _points,
                {"this is the query itself: its distance is 0.": lambda vectors, query: query,
                 "this is the farthest vector.":
                 lambda vectors, query: int((vectors - vectors[query]).norm(dim=1).argmax())}),
        "compute the distance of each row from the query's, replace the query's own by infinity, take argmin."),
    "05.3": Exercise(
        same_as(lambda length, angle: length * math.cos(angle / 2), lambda: [(0.6, 0.0), (0.6, 2.0), (0.3, 2.6)],
                {"this is half of the distance between the two positions of the hand.":
                 lambda length, angle: length * math.sin(angle / 2),
                 "use half of the angle: the middle is on the line that halves it.":
                 lambda length, angle: length * math.cos(angle)}),
        "draw the shoulder and both positions of the hand: an isosceles triangle. Its height is the answer."),
}
