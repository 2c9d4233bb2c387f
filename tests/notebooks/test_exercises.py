"""Answers to each exercise: the notebook's solution and other right ones, and wrong ones.

Wrong functions are made from the right ones: an operator, a number or a method is exchanged.
"""

import ast
import copy
import math
from pathlib import Path

import answers
import course
import numpy as np
import pytest
import torch
from answers import RIGHT, WRONG
from test_notebooks import NOTEBOOKS, SOLUTION, prose, read

import toolkit as tk

#: Wrong answers to every exercise.
TRIVIAL = (
    ..., 0, 1, "", {}, lambda *_: 0.0, lambda *_: torch.zeros(1), lambda first, *_: first
)
IN_CONTEXT = {"10.1", "12.3"}  # exercises whose solution uses names of its notebook


#: Exchanged names of functions and methods, operators and comparisons.
NAMES = {"cos": "sin", "sin": "cos", "mean": "sum", "sum": "mean", "norm": "sum", "abs": "exp",
         "min": "max", "max": "min", "round": "floor", "diff": "cumsum", "any": "all", "all": "any",
         "square": "abs", "std": "var", "var": "std", "argsort": "sort", "acos": "asin",
         "asin": "acos", "arccos": "arcsin", "median": "max", "angle": "abs", "sqrt": "square",
         "degrees": "radians", "rad2deg": "deg2rad", "vstack": "hstack", "flip": "roll"}
OPERATORS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
             ast.MatMult: ast.Mult, ast.Pow: ast.Mult, ast.Mod: ast.Mult, ast.BitAnd: ast.BitOr,
             ast.Lt: ast.Gt, ast.Gt: ast.Lt, ast.LtE: ast.Gt, ast.GtE: ast.Lt, ast.And: ast.Or,
             ast.Or: ast.And, ast.USub: ast.UAdd, ast.Not: ast.UAdd}


def mutants() -> dict[str, set[str]]:
    """The functions of `RIGHT` with one operator, name or number exchanged, each in turn."""
    made = {}
    for statement in ast.parse(Path(answers.__file__).read_text(encoding="utf-8")).body:
        if isinstance(statement, ast.Assign) and ast.unparse(statement).startswith("RIGHT["):
            name, functions = statement.targets[0].slice.value, statement.value.elts
            made[name] = {text for function in functions if isinstance(function, ast.Lambda)
                          for text in exchanged(function)}
    return made


def exchanged(function: ast.Lambda) -> list[str]:
    made = []
    for k, node in enumerate(ast.walk(function.body)):
        changed = copy.deepcopy(function)
        other = list(ast.walk(changed.body))[k]
        if isinstance(getattr(node, "op", None), tuple(OPERATORS)):
            other.op = OPERATORS[type(node.op)]()
        elif isinstance(node, ast.Compare) and type(node.ops[0]) in OPERATORS:
            other.ops[0] = OPERATORS[type(node.ops[0])]()
        elif isinstance(node, ast.Attribute) and node.attr in NAMES:
            other.attr = NAMES[node.attr]
        elif isinstance(node, ast.Constant) and isinstance(node.value, int | float):
            other.value = node.value + 1
        else:
            continue
        made.append(ast.unparse(changed))
    return made


MUTANTS = mutants() | {"12.1": set()}  # a grade with other limits is right too


@pytest.mark.parametrize("name", RIGHT)
@pytest.mark.filterwarnings("ignore")  # of wrong answers: division by zero, shapes
def test_right_answers_in_any_form_are_accepted_and_wrong_ones_refused(name):
    assert len(RIGHT[name]) + (name not in IN_CONTEXT) >= 5
    assert [answer for answer in RIGHT[name] if not course.check(name, answer)] == []
    wrong = (*TRIVIAL, *WRONG.get(name, ()))
    assert [answer for answer in wrong if course.check(name, answer)] == []
    made = {text: eval(text, dict(vars(answers))) for text in MUTANTS[name]}
    passed = [text for text, mutant in made.items() if course.check(name, mutant)]
    assert len(wrong) + len(made) - len(passed) >= 10
    # a mutant may compute the same: it divides by ±1, or sorts by sums instead of means
    assert len(passed) <= (6 if made else 0), passed


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_the_solutions_of_a_notebook_are_right(path):
    for solution in SOLUTION.findall("\n".join(prose(read(path)))):
        if not any(f'"{name}"' in solution for name in IN_CONTEXT):
            last = solution.rstrip().splitlines()[-1]
            space = {"torch": torch, "math": math, "np": np, "tk": tk, "course": course}
            exec(solution.replace(last, f"verdict = {last}"), space)
            assert space["verdict"], solution


def still(clip, limb):
    """High while the toe stands, low while it moves: nearly the solution of 02b.2."""
    toe = clip.global_positions[:, clip.skeleton.index(limb.replace("foot", "toe"))]
    return -toe.diff(dim=0, append=toe[-1:]).norm(dim=-1).clamp_min(1e-3).log()


def ahead(clip, limb):
    return tk.phases.local_positions(clip, limb)[:, 2]


@pytest.mark.parametrize(("name", "source"), [
    ("02b.2", lambda clip, limb: -still(clip, limb)),
    ("02b.2", lambda clip, limb: still(clip, "left_foot")),
    ("02b.2", lambda clip, limb: tk.contacts.detect(clip)[:, int(limb == "left_foot")]),
    ("02b.2", tk.phases.Contact()),
    ("02b.2", tk.phases.Hybrid()),
    ("02b.2", 1.0),
    ("02b.3", lambda clip, limb: sum(ahead(clip, x) for x in tk.phases.LIMBS)),
    ("02b.3", lambda clip, limb: ahead(clip, "left_hand")),
    ("02b.3", lambda clip, limb: ahead(clip, limb) * (1 if limb[0] == "l" else -1)),
    ("02b.3", tk.phases.ContactFree()),
])
def test_sources_with_one_curve_or_a_wrong_sign_are_refused(name, source):
    verdict = course.check(name, source)
    assert not verdict
    assert "mean error" not in str(verdict)  # refused for the reason, not by chance


def test_every_exercise_is_tried():
    known = {name for number in course.LESSONS for name in course.exercises_of(number)}
    assert known == set(RIGHT) | {"02b.2", "02b.3"}
