"""Exercises of the notebook on feet."""

import math

import torch

from toolkit.course.checks import Exercise, same_as


def _knee(a, b, d) -> float:
    return math.degrees(math.acos(min(1.0, max(-1.0, (a * a + b * b - d * d) / (2 * a * b)))))


def _skate(places, contact, fps):
    return (places.diff(dim=0).norm(dim=1) * fps)[contact[1:] & contact[:-1]].mean()


def _toes() -> list[tuple]:
    draw = torch.Generator().manual_seed(12)
    contact = torch.tensor([1, 1, 1, 0, 0, 1, 1, 0], dtype=torch.bool)
    return [(torch.randn(8, 2, generator=draw).cumsum(0), contact, fps) for fps in (60.0, 30.0)]


EXERCISES = {
    "09.1": Exercise(
        same_as(lambda x, v, rate, t: (x + (v + rate * x) * t) * math.exp(-rate * t),
                lambda: [(1.0, 0.0, 10.0, 0.1), (0.0, 2.0, 5.0, 0.3), (-1.0, 1.0, 2.0, 0.0)],
                {"the velocity at the start is missing.":
                 lambda x, v, rate, t: (x + rate * x * t) * math.exp(-rate * t),
                 "this is not critically damped: it leaves the rest with the wrong velocity.":
                 lambda x, v, rate, t: x * math.exp(-rate * t)}),
        "put x, v, λ and t into the formula of section 2."),
    "09.2": Exercise(
        same_as(_knee, lambda: [(0.43, 0.42, 0.6), (0.4, 0.4, 0.4), (0.43, 0.42, 1.2)],
                {"this is in radians.": lambda a, b, d: math.radians(_knee(a, b, d)),
                 "this is the bend: a straight leg has 180 degrees.": lambda a, b, d: 180 - _knee(a, b, d)}),
        "law of cosines, clamp the cosine to [-1, 1], acos, degrees."),
    "09.3": Exercise(
        same_as(_skate, _toes,
                {"multiply by the frames per second.":
                 lambda places, contact, fps: _skate(places, contact, 1.0),
                 "leave out the steps in which only one frame is in contact.":
                 lambda places, contact, fps: (places.diff(dim=0).norm(dim=1) * fps)[contact[1:]].mean()}),
        "diff over the frames, norm, times fps; keep contact[1:] & contact[:-1]; mean."),
}
