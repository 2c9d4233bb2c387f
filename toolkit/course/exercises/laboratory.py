"""Exercises of the laboratory of phase sources."""

import math

import torch

from toolkit.course.checks import Exercise, Judge, same_as
from toolkit.course.laboratory import trial


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
    return [((time + shift + 0.3 * torch.randn(300, generator=make)) % (2 * math.pi), time % (2 * math.pi))
            for shift in (3.1, 0.5, -1.5)]


def _beats_contact_free(part: str, cases: list[tuple[str, str]], share: float, **options) -> Judge:
    """A judge of a source: its mean error over hands or feet must be less than a share of contact-free's."""

    def judge(answer) -> str:
        if not callable(answer):
            return f"a function is needed, not {type(answer).__name__}."
        found = trial({"yours": answer, "contact-free": "contact-free"}, cases, **options)
        errors = found.groupby("source")[part].mean()
        if errors["yours"] < share * errors["contact-free"]:
            return ""
        if math.isnan(errors["yours"]):
            return f"your source is constant for {part}."
        return f"your mean error is {errors['yours']:.0f}°, that of contact-free is {errors['contact-free']:.0f}°."

    return judge


EXERCISES = {
    "02b.1": Exercise(
        same_as(_error, _phases, {"a constant lag must be subtracted first.": _with_lag,
                                  "the lag is a mean direction: angles cannot be averaged like numbers.": _mean_of_angles}),
        "the mean direction of angles d is torch.exp(1j * d).mean().angle()."),
    "02b.2": Exercise(
        _beats_contact_free("feet", [("Neutral", "SW"), ("Old", "SW")], 0.5, seconds=10.0, seed=7),
        "a toe that stands does not move in the world (clip.global_positions), whatever the direction of walking is."),
    "02b.3": Exercise(
        _beats_contact_free("hands", [("Drunk", "FW"), ("Zombie", "FW")], 0.8, seconds=12.0, seed=7, stagger=1.2),
        "the other three limbs swing at the same frequency: add their scores, with the right signs, to that of the hand."),
}
