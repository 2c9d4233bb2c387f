"""Exercises of the notebooks on phases and of the laboratory of their sources."""

import math

import pandas as pd
import torch
from course.checks import NOTHING, Exercise, Judge, same_as
from course.laboratory import trial

from toolkit.datasets import procedural

SEEDS = range(7, 12)  # of the walks on which a source is judged


def _contact(height, speed, d_max, ball, v_max):
    return ((height <= d_max + ball) & (speed <= v_max)).float()


def _toes() -> list[tuple]:
    make = torch.Generator().manual_seed(2)
    height, speed = torch.rand(2, 200, generator=make)
    return [
        (0.06 * height, 0.5 * speed, 0.01, 0.01, 0.15),
        (0.06 * height, 0.5 * speed, 0.03, 0.0, 0.3)
    ]


def _phase_of(t, window, f):
    angle = 2 * math.pi * f * t
    basis = torch.stack((angle.sin(), angle.cos(), torch.ones_like(t)), 1)
    weights = torch.linalg.lstsq(basis, window[:, None]).solution[:, 0]
    return (weights[:2] / weights[:2].norm()).flip(0)


def _exchanged(t, window, f):
    return _phase_of(t, window, f).flip(0)


def _without_constant(t, window, f):
    angle = 2 * math.pi * f * t
    weights = torch.linalg.lstsq(
        torch.stack((angle.sin(), angle.cos()), 1), window[:, None]
    ).solution[:, 0]
    return (weights / weights.norm()).flip(0)


def _windows() -> list[tuple]:
    make = torch.Generator().manual_seed(3)
    t = torch.linspace(-0.6, 0.5, 67).double()
    noise = 0.1 * torch.randn(3, len(t), generator=make).double()
    return [
        (t, (2 * math.pi * f * t + phi).sin() * a + b + noise[i], f)
        for i, (f, phi, a, b) in enumerate(
            ((1.0, 0.5, 1.0, 0.3), (0.8, -2.0, 2.0, -1.0), (1.7, 3.0, 0.5, 2.0))
        )
    ]


def _feature(speed, amplitude, phase):
    return (speed * amplitude)[:, None] * torch.stack((phase.sin(), phase.cos()), -1)


def _rows() -> list[tuple]:
    make = torch.Generator().manual_seed(4)
    return [
        tuple(torch.rand(3, n, generator=make) * torch.tensor([[2.0], [1.0], [6.0]]))
        for n in (5, 1)
    ]


def _error(found, true):
    lag = torch.exp(1j * (found - true)).mean().angle()
    return ((found - true - lag + math.pi) % (2 * math.pi) - math.pi).abs().mean()


def _with_lag(found, true):
    return ((found - true + math.pi) % (2 * math.pi) - math.pi).abs().mean()


def _mean_of_angles(found, true):
    rest = (found - true + math.pi) % (2 * math.pi) - math.pi
    return (rest - rest.mean()).abs().mean()


def _phases() -> list[tuple]:
    make = torch.Generator().manual_seed(5)
    time = torch.linspace(0, 40, 300)
    return [
        (
            (time + shift + 0.3 * torch.randn(300, generator=make)) % (2 * math.pi),
            time % (2 * math.pi)
        )
        for shift in (3.1, 0.5, -1.5)
    ]


def _beats_contact_free(part: str, cases: list[tuple[str, str]], share: float, **options) -> Judge:
    """A judge of a source: its mean error over hands or feet, over `SEEDS`, must be less than a
    share of contact-free's.
    """

    def judge(answer) -> str:
        if not callable(answer):
            return f"a function is needed, not {type(answer).__name__}."
        if answer(procedural.generate("Neutral", seconds=2.0), "left_hand") is ...:
            return NOTHING
        both = {"yours": answer, "contact-free": "contact-free"}
        found = pd.concat([trial(both, cases, seed=seed, **options) for seed in SEEDS])
        errors = found.groupby("source")[part].mean()
        if errors["yours"] < share * errors["contact-free"]:
            return ""
        if math.isnan(errors["yours"]):
            return f"your source is constant for {part}."
        return (f"your mean error is {errors['yours']:.0f}°; less than "
                f"{share * errors['contact-free']:.0f}° is needed.")

    return judge


EXERCISES = {
    "02a.1": Exercise(
        same_as(
            _contact,
            _toes,
            {
                "the radius of the ball is missing: low means up to d_max + "
                "ball.": lambda height, speed, d_max, ball, v_max: (
                    _contact(height, speed, d_max, 0, v_max)
                ),
                "both conditions must hold, not one of "
                "them.": lambda height, speed, d_max, ball, v_max: (
                    ((height <= d_max + ball) | (speed <= v_max)).float()
                ),
                "ones and zeros are exchanged.": lambda *values: 1 - _contact(*values),
            },
        ),
        "compare both tensors with their limits, combine the results with &, and call .float().",
    ),
    "02a.2": Exercise(
        same_as(
            _phase_of,
            _windows,
            {
                "sine and cosine are exchanged.": _exchanged,
                "the constant b is missing in the least squares.": _without_constant
            },
        ),
        "fit the columns sin(2πft), cos(2πft) and 1; then a sin(α + φ) = a cos φ sin α + a sin φ "
        "cos α.",
    ),
    "02a.3": Exercise(
        same_as(
            _feature,
            _rows,
            {
                "sine comes first, then cosine.": lambda *values: _feature(*values).flip(1),
                "the speed is missing.": lambda speed, amplitude, phase: _feature(
                    1 + 0 * speed, amplitude, phase
                ),
                "the amplitude is missing.": lambda speed, amplitude, phase: _feature(
                    speed, 1 + 0 * amplitude, phase
                ),
                "the result should have the shape [F, 2].": lambda *values: _feature(*values).T,
            },
        ),
        "stack sine and cosine along the last axis, and multiply by speed times amplitude.",
    ),
    "02b.1": Exercise(
        same_as(
            _error,
            _phases,
            {
                "a constant lag must be subtracted first.": _with_lag,
                "the lag is a mean direction: angles cannot be averaged like "
                "numbers.": _mean_of_angles,
            },
        ),
        "the mean direction of angles d is torch.exp(1j * d).mean().angle().",
    ),
    "02b.2": Exercise(
        _beats_contact_free("feet", [("Neutral", "SW"), ("Old", "SW")], 0.25, seconds=10.0),
        "a toe that stands does not move in the world (clip.global_positions), whatever the "
        "direction of walking is.",
    ),
    "02b.3": Exercise(
        _beats_contact_free(
            "hands", [("Drunk", "FW"), ("Zombie", "FW")], 0.8, seconds=12.0, stagger=1.2
        ),
        "the other three limbs swing at the same frequency: add their scores, with the right "
        "signs, to that of the hand.",
    ),
}
