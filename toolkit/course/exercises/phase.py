"""Exercises of the notebook on the phase of a limb."""

import math

import torch

from toolkit.course.checks import Exercise, same_as


def _contact(height, speed, d_max, ball, v_max):
    return ((height <= d_max + ball) & (speed <= v_max)).float()


def _toes() -> list[tuple]:
    make = torch.Generator().manual_seed(2)
    height, speed = torch.rand(2, 200, generator=make)
    return [(0.06 * height, 0.5 * speed, 0.01, 0.01, 0.15), (0.06 * height, 0.5 * speed, 0.03, 0.0, 0.3)]


def _phase_of(t, window, f):
    angle = 2 * math.pi * f * t
    basis = torch.stack((angle.sin(), angle.cos(), torch.ones_like(t)), 1)
    weights = torch.linalg.lstsq(basis, window[:, None]).solution[:, 0]
    return (weights[:2] / weights[:2].norm()).flip(0)


def _exchanged(t, window, f):
    return _phase_of(t, window, f).flip(0)


def _without_constant(t, window, f):
    angle = 2 * math.pi * f * t
    weights = torch.linalg.lstsq(torch.stack((angle.sin(), angle.cos()), 1), window[:, None]).solution[:, 0]
    return (weights / weights.norm()).flip(0)


def _windows() -> list[tuple]:
    make = torch.Generator().manual_seed(3)
    t = torch.linspace(-0.6, 0.5, 67).double()
    noise = 0.1 * torch.randn(3, len(t), generator=make).double()
    return [(t, (2 * math.pi * f * t + phi).sin() * a + b + noise[i], f)
            for i, (f, phi, a, b) in enumerate(((1.0, 0.5, 1.0, 0.3), (0.8, -2.0, 2.0, -1.0), (1.7, 3.0, 0.5, 2.0)))]


def _feature(speed, amplitude, phase):
    return (speed * amplitude)[:, None] * torch.stack((phase.sin(), phase.cos()), -1)


def _rows() -> list[tuple]:
    make = torch.Generator().manual_seed(4)
    return [tuple(torch.rand(3, n, generator=make) * torch.tensor([[2.0], [1.0], [6.0]])) for n in (5, 1)]


EXERCISES = {
    "02a.1": Exercise(
        same_as(_contact, _toes,
                {"the radius of the ball is missing: low means up to d_max + ball.":
                 lambda height, speed, d_max, ball, v_max: _contact(height, speed, d_max, 0, v_max),
                 "both conditions must hold, not one of them.":
                 lambda height, speed, d_max, ball, v_max: ((height <= d_max + ball) | (speed <= v_max)).float(),
                 "ones and zeros are exchanged.":
                 lambda *values: 1 - _contact(*values)}),
        "compare both tensors with their limits, combine the results with &, and call .float()."),
    "02a.2": Exercise(
        same_as(_phase_of, _windows, {"sine and cosine are exchanged.": _exchanged,
                                      "the constant b is missing in the least squares.": _without_constant}),
        "fit the columns sin(2πft), cos(2πft) and 1; then a sin(α + φ) = a cos φ sin α + a sin φ cos α."),
    "02a.3": Exercise(
        same_as(_feature, _rows,
                {"sine comes first, then cosine.": lambda *values: _feature(*values).flip(1),
                 "the speed is missing.": lambda speed, amplitude, phase: _feature(1 + 0 * speed, amplitude, phase),
                 "the amplitude is missing.": lambda speed, amplitude, phase: _feature(speed, 1 + 0 * amplitude, phase),
                 "the result should have the shape [F, 2].": lambda *values: _feature(*values).T}),
        "stack sine and cosine along the last axis, and multiply by speed times amplitude."),
}
