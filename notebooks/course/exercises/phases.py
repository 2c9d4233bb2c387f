"""Exercises of the notebooks on phases and of the laboratory of their sources."""

import math
from functools import cache, partial

import numpy as np
import pandas as pd
import torch
from course.checks import NOTHING, Exercise, Judge, draws, same_as, shows, traced
from course.laboratory import trial
from torch.nn import functional

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.motion import contacts
from toolkit.phases import sources

SEEDS = (7, 8, 9, 10, 11)  # of the walks on which a source is judged
TURN = 2 * math.pi


def _voted(contact, half):
    ends = functional.pad(contact[None], (half, half), mode="replicate")[0]
    return ends.unfold(0, 2 * half + 1, 1).mean(1).round()


def _contacts() -> list[tuple]:
    return [((x > 0).float(), half) for x, half in zip(draws(2, (60,), (31,)), (2, 5), strict=True)]


def _wrapped(angle):
    return (angle + math.pi) % TURN - math.pi


def _rate(phase, fps):
    return _wrapped(phase.diff()).mean() * fps / TURN


def _angles() -> list[tuple]:
    time = torch.arange(300) / 60
    (noise,) = draws(3, (300,))
    return [(_wrapped(TURN * f * time + 0.1 * noise + 1), 60.0) for f in (0.8, 1.9)] + [
        (torch.tensor([3.0, -3.0, -2.5]), 30.0)]


def _amplitude(s):
    return 2 * math.sin(math.pi * s) / (math.pi * math.sqrt(s * (1 - s)))


def _error(found, true):
    return _wrapped(found - true - torch.exp(1j * (found - true)).mean().angle()).abs().mean()


def _used(code) -> str:
    """The source or the rule of the library that some code is, or ""."""
    source = code.co_filename == sources.__file__ and code.co_name == "__call__"
    return code.co_qualname.removesuffix(".__call__") if (
        source or code is contacts.detect.__code__) else ""


def _beats_contact_free(part: str, cases: list[tuple[str, str]], share: float, **options) -> Judge:
    """A judge of a source: its mean error over hands or feet, over `SEEDS`, must be less than a
    share of contact-free's; and the limbs must alternate in Neutral, hands swing together in
    PendulumHands.

    A lag is subtracted from each limb's error, so the error does not see a wrong sign.
    """

    def judge(answer) -> str:
        if not callable(answer):
            return f"a function is needed, not {type(answer).__name__}."
        limbs, styles = slice(2, 4), {"Neutral": "alternate"}
        if part == "hands":
            limbs, styles = slice(0, 2), {"PendulumHands": "swing together"} | styles
        for style, do in styles.items():
            clip, truth = procedural.truth(style, "FW", 10.0)
            for limb in tk.phases.LIMBS[limbs]:
                curve, used = traced(answer, clip, limb, note=_used)
                if curve is ...:
                    return NOTHING
                if used:
                    return f"it uses {used[0]} of the library: write one of your own."
            mine = tk.phases.extract(clip, answer).phase[60:-60, limbs] - truth.phase[60:-60, limbs]
            lags = torch.exp(1j * mine.double()).mean(0).angle()
            if abs(_wrapped(lags[0] - lags[1])) > 1:
                return f"in {style} both {part} should {do}; yours do not."
        if part == "feet" and lags[0].sin() < 0:
            return "the curve is upside down: it should be high while the foot stands."
        if not curve.std() > 0:
            return "the curve is constant."
        yours, limit = mean_error(answer, SEEDS), share * contact_free(SEEDS)
        return "" if yours < limit else (
            f"your mean error is {yours:.0f}°; less than {limit:.0f}° is needed.")

    def mean_error(source, seeds) -> float:
        return pd.concat([trial({"it": source}, cases, seed=seed, **options)
                          for seed in seeds])[part].mean()

    contact_free = cache(partial(mean_error, "contact-free"))
    return judge


EXERCISES = {
    "02a.1": Exercise(
        same_as(_voted, _contacts, {
            "the window has 2 · half + 1 frames.":
                lambda contact, half: _voted(contact, max(1, half // 2)),
            "this is the mean of the votes: round it.": lambda contact, half: functional.pad(
                contact[None], (half, half), mode="replicate")[0].unfold(
                    0, 2 * half + 1, 1).mean(1),
            "at the ends, the first and the last frame are repeated.": lambda contact, half:
                functional.pad(contact, (half, half)).unfold(0, 2 * half + 1, 1).mean(1).round(),
        }),
        "how many of the frames around a frame must be 1 so that it becomes 1?",
        "pad by repeating the ends, take windows of 2 · half + 1 frames, and round their means.",
    ),
    "02a.2": Exercise(
        same_as(_rate, _angles, {
            "the phase jumps by 2π once a cycle: wrap its steps.":
                lambda phase, fps: phase.diff().mean() * fps / TURN,
            "this is in radians per second.": lambda phase, fps: TURN * _rate(phase, fps),
            "multiply by the frames per second.": lambda phase, fps: _rate(phase, 1.0),
        }),
        "what is the step of the phase between the two frames where it jumps?",
        "wrap each step to −π … π, take the mean, times fps, divided by 2π.",
    ),
    "02a.3": Exercise(
        same_as(_amplitude, lambda: [(0.5,), (0.6,), (0.1,)], {
            "normalise: divide by the deviation of the curve.":
                lambda s: 2 * math.sin(math.pi * s) / math.pi,
            "this is from the lowest to the highest value of the sinusoid.":
                lambda s: 2 * _amplitude(s),
        }),
        "take the middle of the stance as time zero: what is the mean of the curve times a cosine?",
        "twice the mean of curve times cosine is 2 sin(πs) / π; the deviation is √(s(1 − s)).",
    ),
    "02b.1": Exercise(
        shows(
            ("give two tensors or lists of as many angles, ten or more",
             lambda found, true: len(found) == len(true) > 9),
            ("this phase is wrong: its error is not zero",
             lambda found, true: _error(*map(torch.as_tensor, (found, true))) < 0.01),
            ("the faulty function is right about this one",
             lambda found, true: np.abs((d := np.subtract(found, true)) - d.mean()).mean() > 1),
            parts=2,
        ),
        "which differences between two phases are no error, apart from a constant one?",
        "take a true phase, and add a whole turn to half of its frames.",
    ),
    "02b.2": Exercise(
        _beats_contact_free("feet", [("Neutral", "SW"), ("Old", "SW")], 0.25, seconds=10.0),
        "what does a toe that stands not do, whatever the direction of walking is?",
        "measure how fast the toe moves in the world (clip.global_positions), and turn it round.",
    ),
    "02b.3": Exercise(
        _beats_contact_free(
            "hands", [("Drunk", "FW"), ("Zombie", "FW")], 0.8, seconds=12.0, stagger=1.2
        ),
        "which other limbs swing at the same frequency, and are disturbed in another way?",
        "add the scores of the other limbs, those that swing against this hand with a minus; their "
        "product with this hand's tells which.",
    ),
}
