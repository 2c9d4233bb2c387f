"""The frame of the notebooks: map, checked exercises, sentences, figures without a kernel."""

import re
from xml.etree import ElementTree

import course
import numpy as np
import plotly.graph_objects as go
import pytest
import torch
from course import floors
from course.checks import WRONG, differs, equals, same_as
from course.sequence import picture
from refusal import refusal

import toolkit as tk


def test_a_lesson_comes_after_those_it_needs():
    order = list(course.LESSONS)
    assert order == sorted(order)
    for number, lesson in course.LESSONS.items():
        assert number == lesson.number
        assert set(lesson.needs) < set(order)
        assert number not in lesson.needs
    assert len({lesson.place for lesson in course.LESSONS.values()}) == len(order)


def test_the_map_has_every_lesson_and_lights_one():
    root = ElementTree.fromstring(picture("02a"))
    texts = [node.text for node in root.iter("{http://www.w3.org/2000/svg}text")]
    assert [text.split()[0] for text in texts[::2]] == list(course.LESSONS)
    assert picture("02a").count('fill="#7b3fb5"') == 1
    with refusal("no notebook '10a'"):
        course.here("10a")


def test_figures_ask_no_server_and_use_code_that_the_map_brings():
    page = course.here("00").html
    assert "window.Plotly = Plotly" in page
    bundle = go.Figure().add_scatter(y=[1, 2])._repr_mimebundle_()
    assert set(bundle) == {"application/vnd.plotly.v1+json", "text/html"}
    assert "http" not in re.sub(r"https://plot(ly|\.ly)[^\"]*", "", bundle["text/html"])
    assert "Plotly.newPlot" in bundle["text/html"]


def test_claims_stand_only_if_they_are_true():
    assert course.claim("2 < 3", 2 < 3)._repr_markdown_() == "2 < 3"
    assert course.learnt({"a": True, "b": torch.tensor(True)})._repr_markdown_() == "* a\n* b"
    with pytest.raises(AssertionError, match=r"condition 2 of 2 does not hold.*: one"):
        course.claim("one", True, 2 < 1)
    with pytest.raises(AssertionError):
        course.learnt({"a": True, "b": False})
    with refusal("give the conditions"):
        course.claim("all is well")


def test_a_claim_is_refused_for_its_floor():
    cell = "# floor: {}\nbest = min(errors)\nif best:\n    course.claim('', {})"
    names = {"errors": [1, 3], "best": 1}
    for floor in ("errors = [2]", "best = 2"):
        floors.refuse(cell.format(floor, "best < 2"), names)
    for condition in ("best < 3", "FAST or best < 3"):
        with pytest.raises(AssertionError, match="holds for its floor, too: errors"):
            floors.refuse(cell.format("errors = [2]", condition), names)
    assert names == {"errors": [1, 3], "best": 1}


def test_differences_do_not_tell_the_answer():
    assert not differs(torch.ones(2) + 1e-5, torch.ones(2), 1e-3)
    assert "[2] is right" in differs(1, torch.ones(2), 1e-3)
    assert "the numbers are not" in differs([1.0, 2.0], torch.ones(2), 1e-3)
    assert "2" not in differs(1.5, 2.0, 1e-3)
    assert differs(float("nan"), 1.0, 1e-3)
    for truth in (torch.tensor(True), torch.ones(1), np.int8(1)):
        assert not differs(truth, True, 0)
        assert differs(truth, False, 0)
    for other in (2, "True", torch.ones(2), [True]):
        assert differs(other, True, 0)


def test_judges_copy_their_cases_and_name_a_fault_only_if_all_cases_agree():
    cases = [(torch.tensor([1.0, 2.0]),), (torch.tensor([0.0, 0.0]),)]
    judge = same_as(lambda x: 2 * x, lambda: cases, {"halved": lambda x: x / 2})
    assert judge(lambda x: x.mul_(2)) == ""  # in place
    assert cases[0][0].tolist() == [1.0, 2.0]
    assert judge(lambda x: x / 2) == "halved"
    # agrees with the known fault in one case alone
    assert judge(lambda x: x / 2 + x.sum()).startswith("hidden case 1 of 2")
    assert judge(lambda x: None) == "no answer yet."
    assert judge(3) == "a function is needed, not int."
    assert equals(4, {"that is its square": 16})(16) == "that is its square."
    assert equals({"a", "b"})(["b", "a"]) == ""
    with pytest.raises(TypeError):
        judge(lambda: 1)


def test_the_first_hint_is_a_question_and_the_next_a_recipe():
    exercise = course.exercises_of("08b")["08b.3"]
    WRONG.clear()
    assert str(course.check("08b.3", ...)) == "○ 08b.3: No answer yet."
    for hint in (exercise.question, exercise.recipe, exercise.recipe):
        verdict = course.check("08b.3", lambda m, s, n, r: m - n)
        assert not verdict
        assert str(verdict).endswith(f"Hint: {hint}")
    assert course.check("08b.3", lambda m, s, n, r: (m - n) ** 2 + (s - r) ** 2)
    assert "raised TypeError" in str(course.check("08b.3", lambda: 1))
    with refusal(r"no exercise '00\.9'; there are 00\.1, 00\.2"):
        course.check("00.9", 1)
    with refusal("no exercise 'x'"):
        course.check("x", 1)


def test_exercises_are_numbered_and_ask_first():
    for number in course.LESSONS:
        known = course.exercises_of(number)
        assert list(known) == [f"{number}.{i + 1}" for i in range(len(known))]
        assert all("?" in exercise.question for exercise in known.values())


def test_the_grades_of_the_capstone_refuse_their_floors(fast):
    model, bank = fast
    clip = tk.datasets.procedural.generate("HighKnees", seconds=6.0, seed=1)
    own, *floors = (tk.styles.compare(clip, model, style, bank)
                    for style in ("HighKnees", "Neutral", bank.vectors.mean(0)))
    assert own.verdict == "good"
    assert all(floor.verdict != "good" and floor.excess > own.excess for floor in floors)
