"""Exercises that check an answer with cases which the notebook does not show, and sentences that
are shown only if true.
"""

import copy
import importlib
import sys
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from types import CodeType
from typing import Any

import course
import numpy as np
import torch
from course import floors
from course.sequence import LESSONS
from IPython import get_ipython

Judge = Callable[[Any], str]
NOTHING = "no answer yet."  # then no hint is given
WRONG: Counter[str] = Counter()  # wrong answers to each exercise so far

#: Module of `course.exercises` -> numbers of its notebooks.
MODULES = {"features": ("00", "01"), "phases": ("02a", "02b"), "networks": ("03a", "03b", "07"),
           "styles": ("04", "05", "06", "08a", "08b"), "measures": ("09", "10", "11", "12")}


@dataclass(frozen=True)
class Exercise:
    """How an answer is judged, and two hints."""

    judge: Judge  # takes an answer, returns what is wrong with it, or "" where it is right
    question: str  # the hint after the first wrong answer
    recipe: str  # the hint after the others


@dataclass(frozen=True)
class Verdict:
    """What `check` found; true if the answer is right."""

    name: str
    right: bool
    text: str

    def __bool__(self) -> bool:
        return self.right

    def __repr__(self) -> str:
        return f"{'✓' if self.right else '○'} {self.name}: {self.text}"

    def _repr_html_(self) -> str:
        return (
            f'<div style="border-left: 5px solid {"#2fa596" if self.right else "#e3a13a"}; '
            f'padding: 4px 12px">'
            f"<b>{escape(self.name)}</b> {escape(self.text)}</div>"
        )


def check(name: str, answer: Any) -> Verdict:
    """Judge an answer with hidden cases; if it is wrong, give a hint: a question, then a recipe.

    Parameters
    ----------
    name
        Number of the notebook and of the exercise, such as "02a.1".
    answer
        A function or a value, as the exercise asks for; ``...`` if there is no answer yet.

    Raises
    ------
    ValueError
        If there is no such exercise.
    """
    number = name.partition(".")[0]
    known = exercises_of(number) if number in LESSONS else {}
    if name not in known:
        raise ValueError(
            f"no exercise {name!r}; there are {', '.join(known) or ', '.join(LESSONS)}"
        )
    exercise = known[name]
    try:
        wrong = NOTHING if unanswered(answer) else exercise.judge(answer)
    except Exception as error:  # of the reader's function
        wrong = f"your answer raised {type(error).__name__}: {error}."
    if not wrong or wrong == NOTHING:
        return Verdict(name, not wrong, wrong.capitalize() or "Right.")
    WRONG[name] += 1
    hint = exercise.question if WRONG[name] == 1 else exercise.recipe
    return Verdict(name, False, f"{wrong[:1].upper()}{wrong[1:]} Hint: {hint}")


def unanswered(answer: Any) -> bool:
    """Whether an answer, or a value in it, is still the ``...`` of the exercise."""
    return any(x is ... for x in (answer.values() if isinstance(answer, dict) else [answer]))


def exercises_of(number: str) -> dict[str, Exercise]:
    """Exercises of a notebook, by name."""
    module = next(name for name, numbers in MODULES.items() if number in numbers)
    known = importlib.import_module(f"course.exercises.{module}").EXERCISES
    return {name: exercise for name, exercise in known.items() if name.partition(".")[0] == number}


def same_as(
    right: Callable, cases: Callable[[], Sequence[tuple]],
    wrong: Mapping[str, Callable] | None = None, tolerance: float = 1e-3
) -> Judge:
    """A judge that compares a function with the right one.

    Parameters
    ----------
    right, cases
        The right function, and a function that returns the arguments of each call. Each call gets
        a copy, so an answer may change its arguments.
    wrong
        What to say to known wrong answers: text -> the function that gives such an answer. It is
        said only if the answer agrees with that function in all cases.
    tolerance
        Largest difference, relative to the largest number of the right result.
    """

    def judge(answer) -> str:
        if not callable(answer):
            return f"a function is needed, not {type(answer).__name__}."
        every = list(cases())
        got = [answer(*copy.deepcopy(case)) for case in every]
        if any(x is None or unanswered(x) for x in got):
            return NOTHING

        def off(function: Callable) -> list[str]:
            wanted = (function(*copy.deepcopy(case)) for case in every)
            return [differs(x, want, tolerance) for x, want in zip(got, wanted, strict=True)]

        found = off(right)
        if not any(found):
            return ""
        known = (text for text, other in (wrong or {}).items() if not any(off(other)))
        first = next(i for i, text in enumerate(found) if text)
        return next(known, f"hidden case {first + 1} of {len(every)}: {found[first]}.")

    return judge


def equals(right: Any, wrong: Mapping[str, Any] | None = None, tolerance: float = 1e-3) -> Judge:
    """A judge that compares a value with the right one.

    ``wrong`` has values in place of functions, as in `same_as`.
    """

    def judge(answer) -> str:
        if not (difference := differs(answer, right, tolerance)):
            return ""
        known = (text for text, x in (wrong or {}).items() if not differs(answer, x, tolerance))
        return f"{next(known, difference)}."

    return judge


def traced(function: Callable, *arguments: Any, note: Callable[[CodeType], str]) -> tuple:
    """What a function returns, and what ``note`` said of the code that ran in it, without ""."""
    seen: list[str] = []

    def entered(frame, event, _) -> None:
        if event == "call" and (said := note(frame.f_code)):
            seen.append(said)

    before = sys.getprofile()
    sys.setprofile(entered)
    try:
        return function(*arguments), seen
    finally:
        sys.setprofile(before)


def shows(*conditions: tuple[str, Callable[..., bool]], parts: int = 1) -> Judge:
    """A judge of an open exercise: what is wrong with an answer -> the condition that is missing.

    The first condition that does not hold is told. An answer of several ``parts`` is a tuple or a
    list, and the conditions take its parts.
    """

    def judge(answer) -> str:
        values = answer if parts > 1 else (answer,)
        if not isinstance(values, tuple | list) or len(values) != parts:
            return f"a tuple of {parts} is needed."
        return next((f"{text}." for text, holds in conditions if not holds(*values)), "")

    return judge


def draws(seed: int, *shapes: tuple[int, ...]) -> tuple[torch.Tensor, ...]:
    """Normal numbers of these shapes, the same in every call: arguments of a hidden case."""
    make = torch.Generator().manual_seed(seed)
    return tuple(torch.randn(shape, generator=make) for shape in shapes)


def differs(got: Any, want: Any, tolerance: float) -> str:
    """How two results differ, without the right one; "" where they agree."""
    if isinstance(want, bool):
        got = truth(got)
    if isinstance(want, set) and isinstance(got, list | tuple | frozenset):
        got = set(got)
    if isinstance(want, dict) and isinstance(got, dict) and set(got) == set(want):
        return next(filter(None, (differs(got[k], want[k], tolerance) for k in want)), "")
    if isinstance(want, str | set | dict | bool):
        return "" if type(got) is type(want) and got == want else f"{got!r} is not right"
    got, want = (torch.as_tensor(x).detach().to("cpu", torch.float64) for x in (got, want))
    if got.shape != want.shape:
        return f"the result has the shape {list(got.shape)}, and {list(want.shape)} is right"
    off = (got - want).abs().max() if want.numel() else torch.zeros(())
    if off <= tolerance * max(1e-9, float(want.abs().max())):
        return ""
    return (
        "the shape is right, but the numbers are not"
        if want.ndim
        else f"{float(got):.4g} is not right"
    )


def truth(value: Any) -> Any:
    """True or False for one of numpy, of torch, and for 1 or 0; other values as they are."""
    one = isinstance(value, np.generic | int) or (
        isinstance(value, torch.Tensor) and value.numel() == 1)
    return bool(value) if one and float(value) in (0, 1) else value


class Sentences:
    """Markdown of one or several true sentences."""

    def __init__(self, *lines: str):
        self.lines = lines

    def __repr__(self) -> str:
        return "\n".join(self.lines)

    _repr_markdown_ = __repr__


def claim(sentence: str, *conditions: bool) -> Sentences:
    """Show a sentence about a result, if all conditions hold.

    Numbers in the sentence come from the run (an f-string). What the sentence says of them is a
    condition.

    Raises
    ------
    ValueError
        If there is no condition.
    AssertionError
        If one does not hold: then the sentence and the run disagree. In a small run also if all
        hold for the floor of the cell, see `course.floors`.
    """
    if not conditions:
        raise ValueError(f"give the conditions under which this is true: {sentence}")
    for i, condition in enumerate(conditions):
        if not bool(condition):
            raise AssertionError(
                f"condition {i + 1} of {len(conditions)} does not hold, so this is not true: "
                f"{sentence}"
            )
    if course.FAST and (shell := get_ipython()):
        floors.refuse(shell.user_ns["In"][-1], shell.user_ns)
    return Sentences(sentence)


def learnt(sentences: Mapping[str, bool | None]) -> Sentences:
    """The list *What you learnt*: sentence -> the condition under which it is true, or None for a
    sentence that this run cannot test: it is left out.

    Raises
    ------
    AssertionError
        If one is not true.
    """
    return Sentences(
        *(f"* {claim(sentence, condition)}" for sentence, condition in sentences.items()
          if condition is not None)
    )
