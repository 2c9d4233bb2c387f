"""Answers to each exercise: the notebook's solution and another right one in several forms, and
wrong ones, which are made from the right ones: an operator or a number is exchanged.
"""

import ast
import copy
import math
import re
from collections.abc import Callable
from pathlib import Path

import answers
import course
import numpy as np
import pytest
import torch
from answers import RIGHT, WRONG
from test_notebooks import NOTEBOOKS, SOLUTION, prose, read

import toolkit as tk
from experiments import mutation

#: Wrong answers to every exercise.
TRIVIAL = (
    ..., 0, 1, "", {}, lambda *_: 0.0, lambda *_: torch.zeros(1), lambda first, *_: first
)
#: Mutants that compute the same: they divide by ±1, or sort by sums instead of means.
SAME = {"01.3": 1, "02a.2": 1, "04.3": 2, "05.3": 1}
IN_CONTEXT = {"00.2", "10.1", "12.3"}  # exercises whose solution uses names of its notebook


def solutions(path: Path) -> dict[str, str]:
    """Code of the solutions in a notebook, by exercise; its last line asks for the verdict."""
    found = SOLUTION.findall("\n".join(prose(read(path))))
    return {re.search(r'check\("(.+?)"', code)[1]: code.rstrip() for code in found}


SOLUTIONS = {name: code for path in NOTEBOOKS for name, code in solutions(path).items()
             if name not in IN_CONTEXT}


def solved(name: str, code: str = "") -> object:
    """What the code of a solution gives as the answer."""
    *above, last = (code or SOLUTIONS[name]).splitlines()
    space = {"torch": torch, "math": math, "tk": tk}
    exec("\n".join(above), space)
    return eval(re.search(r", (\w+)\)$", last)[1], space)


def told(answer: object, form: Callable) -> object:
    """The same answer with numbers in another form; a function gives its result in that form."""
    if callable(answer):
        return lambda *given: told(answer(*given), form)
    if isinstance(answer, dict):
        return {key: told(value, form) for key, value in answer.items()}
    if isinstance(answer, tuple):
        return tuple(told(part, form) for part in answer)
    return answer if isinstance(answer, str | list | set) else form(answer)


#: Forms of a number or a tensor.
FORMS = (lambda x: x, lambda x: np.asarray(x)[()], lambda x: torch.as_tensor(x).tolist(),
         lambda x: torch.as_tensor(x).double())


def mutants(name: str) -> list[str]:
    """Code of the solution and of the function of `RIGHT` with one fault each."""
    if name == "12.1":  # a grade with other limits is right too
        return []
    other = next(n for n in ast.parse(Path(answers.__file__).read_text(encoding="utf-8")).body
                 if ast.unparse(n).startswith(f"RIGHT['{name}']"))
    made = [f"x = {text}\n('{name}', x)" for function in other.value.elts
            if isinstance(function, ast.Lambda) for text in exchanged(function)]
    tree = ast.parse(SOLUTIONS.get(name, ""))
    return made + exchanged(tree) * any(isinstance(node, ast.FunctionDef) for node in tree.body)


def exchanged(code: ast.AST) -> list[str]:
    """The code with each of the faults that `experiments.mutation` plants."""
    made = []
    for k in range(len(mutation.places(code))):
        changed = copy.deepcopy(code)
        mutation.mutate(mutation.places(changed)[k])
        made.append(ast.unparse(changed))
    return made


@pytest.mark.parametrize("name", RIGHT)
@pytest.mark.filterwarnings("ignore")  # of wrong answers: division by zero, shapes
def test_right_answers_in_any_form_are_accepted_and_wrong_ones_refused(name):
    known = [*RIGHT[name], *([solved(name)] if name in SOLUTIONS else [])]
    right = [told(answer, form) for answer in known for form in FORMS]
    assert len(right) >= 5
    assert [k for k, answer in enumerate(right) if not course.check(name, answer)] == []
    wrong = (*TRIVIAL, *WRONG.get(name, ()))
    assert [answer for answer in wrong if course.check(name, answer)] == []
    made = mutants(name)
    passed = [text for text in made if course.check(name, tried(name, text))]
    assert len(wrong) + len(made) - len(passed) >= 10
    assert len(passed) == SAME.get(name, 0), passed


def tried(name: str, code: str) -> object:
    try:
        return solved(name, code)
    except Exception:
        return ...


def still(clip, limb):
    """Minus the speed of the toe, m/s: high while it stands."""
    toe = clip.global_positions[:, clip.skeleton.index(limb.replace("foot", "toe"))]
    return -60 * toe.diff(dim=0, append=toe[-1:]).norm(dim=-1)


def ahead(clip, limb):
    curve = tk.phases.local_positions(clip, limb)[:, 2]
    return (curve - curve.mean()) / curve.std()


def stride(clip, limb):
    """The feet's swing: ahead on the side of the limb."""
    curve = ahead(clip, "left_foot") - ahead(clip, "right_foot")
    return curve if limb[0] == "r" else -curve


def together(clip, limb):
    """The sum of all swings, those against the limb's with a minus."""
    mine = ahead(clip, limb)
    return sum(ahead(clip, x) * (ahead(clip, x) * mine).mean().sign() for x in tk.phases.LIMBS)


SOURCES = {  # right answers and wrong ones
    "02b.2": ([
        still,
        lambda clip, limb: (still(clip, limb) / 0.3).exp(),
        lambda clip, limb: -(-still(clip, limb)).clamp_min(0.02).sqrt(),
        lambda clip, limb: 1 / (0.2 - still(clip, limb)),
        lambda clip, limb: still(clip, limb).tanh(),
    ], [
        lambda clip, limb: -still(clip, limb),
        lambda clip, limb: still(clip, "left_foot"),
        lambda clip, limb: still(clip, "right_foot").exp(),
        lambda clip, limb: tk.contacts.detect(clip)[:, int(limb == "left_foot")],
        lambda clip, limb: torch.zeros(len(clip)),
        lambda clip, limb: ahead(clip, limb),
        lambda clip, limb: tk.phases.local_positions(clip, limb)[:, 0],
        tk.phases.Contact(), tk.phases.Hybrid(), 1.0,
    ]),
    "02b.3": ([
        together,
        lambda clip, limb: together(clip, limb).tanh(),
        lambda clip, limb: together(clip, limb) + ahead(clip, limb),
        lambda clip, limb: 2 * together(clip, limb) - ahead(clip, limb),
        lambda clip, limb: 3 * together(clip, limb) + 1,
    ], [
        lambda clip, limb: stride(clip, limb) + ahead(clip, limb) / 2,
        lambda clip, limb: stride(clip, limb).tanh(),
        lambda clip, limb: sum(
            ahead(clip, x) * (1 if (x[0] == limb[0]) == (x[-4:] == limb[-4:]) else -1)
            for x in tk.phases.LIMBS),
        lambda clip, limb: sum(ahead(clip, x) for x in tk.phases.LIMBS),
        lambda clip, limb: ahead(clip, "left_hand"),
        lambda clip, limb: ahead(clip, limb) * (1 if limb[0] == "l" else -1),
        lambda clip, limb: ahead(clip, "left_foot"),
        lambda clip, limb: stride(clip, "left_hand"),
        lambda clip, limb: torch.zeros(len(clip)),
        lambda clip, limb: [],
        lambda clip: ahead(clip, "left_hand"),
        tk.phases.ContactFree(), "contact-free",
    ]),
}


@pytest.mark.parametrize("name", SOURCES)
def test_sources_in_any_form_are_accepted_and_wrong_ones_refused(name, monkeypatch):
    monkeypatch.setattr(course.exercises.phases, "SEEDS", (7,))
    right, wrong = SOURCES[name]
    assert [k for k, source in enumerate(right) if not course.check(name, source)] == []
    verdicts = [course.check(name, source) for source in wrong]
    assert [k for k, verdict in enumerate(verdicts) if verdict] == []
    # refused for the reason, not by chance
    assert [k for k, verdict in enumerate(verdicts) if "mean error" in str(verdict)] == []


def test_every_exercise_is_tried():
    known = {name for number in course.LESSONS for name in course.exercises_of(number)}
    assert known == set(RIGHT) | set(SOURCES)
