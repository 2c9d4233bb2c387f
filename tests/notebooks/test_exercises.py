"""Answers to each exercise (`answers.txt`): right ones in other forms, and wrong ones.

Wrong functions are made from the right ones: an operator, a number or a method is exchanged.
"""

import ast
import copy
import math
import random
from pathlib import Path

import course
import numpy as np
import pytest
import torch
from torch.nn import functional as F

import toolkit as tk

LEG = torch.tensor([[0.0, 1.0, 0.0], [0.0, 0.55, 0.1], [0.0, 0.1, 0.0]])  # of exercise 03b.3
SPACE = {"torch": torch, "math": math, "np": np, "F": F, "random": random, "PI": math.pi,
         "LEG": LEG}
ANSWERS = Path(__file__).with_name("answers.txt")


def answers() -> dict[str, tuple[str, list[str], list[str]]]:
    """Exercise -> arguments ("" where the answer is a value), right answers, wrong ones."""
    found = {}
    for block in ANSWERS.read_text(encoding="utf-8").strip().split("\n\n")[1:]:
        heading, *lines = block.splitlines()
        name, _, arguments = heading.partition(" ")
        right, wrong = ([x[2:] for x in lines if x.startswith(sign)] for sign in "=-")
        found[name] = arguments, right, wrong
    return found


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


def mutants(body: str) -> list[str]:
    """The expression with one operator, name or number exchanged, each in turn."""
    made, tree = [], ast.parse(body, mode="eval")
    for k, node in enumerate(ast.walk(tree)):
        changed = copy.deepcopy(tree)
        other = list(ast.walk(changed))[k]
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


@pytest.mark.parametrize(("name", "tried"), answers().items())
@pytest.mark.filterwarnings("ignore")  # of wrong answers: division by zero, shapes
def test_right_answers_in_any_form_are_accepted_and_wrong_ones_refused(name, tried):
    arguments, right, wrong = tried

    def verdict(text: str) -> course.Verdict:
        code = f"lambda {arguments}: {text}" if arguments else text
        return course.check(name, eval(code, dict(SPACE)))

    refused = {text: verdict(text) for text in right if not verdict(text)}
    assert len(right) >= 5
    assert not refused
    every = set(wrong)
    if arguments:
        every |= {mutant for text in right for mutant in mutants(text)}
    passed = [text for text in every if verdict(text)]
    assert len(every) - len(passed) >= 10
    # a mutant may compute the same: it divides by ±1, or sorts by sums instead of means
    assert len(passed) <= (6 if arguments else 0), passed
    assert not set(passed) & set(wrong)


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
    assert known == set(answers()) | {"02b.2", "02b.3"}
