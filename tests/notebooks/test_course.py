"""The frame of the notebooks: map, checked exercises, sentences, figures without a kernel."""

import re
import subprocess
import sys
from xml.etree import ElementTree

import course
import plotly.graph_objects as go
import pytest
import torch
from course.checks import Exercise, differs, equals, same_as
from course.sequence import picture

import toolkit as tk

WRITTEN = list(course.LESSONS)


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
    with pytest.raises(ValueError, match="no notebook '10a'"):
        course.here("10a")


def test_figures_ask_no_server_and_use_code_that_the_map_brings():
    page = course.here("00").html
    assert "window.Plotly = Plotly" in page
    bundle = go.Figure().add_scatter(y=[1, 2])._repr_mimebundle_()
    assert set(bundle) == {"application/vnd.plotly.v1+json", "text/html"}
    assert "http" not in re.sub(r"https://plot(ly|\.ly)[^\"]*", "", bundle["text/html"])
    assert "Plotly.newPlot" in bundle["text/html"]


def test_a_film_is_a_page_in_a_frame(hop):
    html = course.film(hop, title='A "hop"').html
    assert html.startswith('<iframe srcdoc="&lt;!doctype html&gt;')
    assert html.count("<") == 2  # nothing of the page ends the frame


@pytest.fixture(scope="module")
def hop() -> tk.Clip:
    return tk.datasets.load("procedural", styles="HopLeft", gaits="FW", seconds=1.0)[0]


def test_claims_stand_only_if_they_are_true():
    assert course.claim("2 < 3", 2 < 3)._repr_markdown_() == "2 < 3"
    assert course.learnt({"a": True, "b": torch.tensor(True)})._repr_markdown_() == "* a\n* b"
    with pytest.raises(AssertionError, match=r"condition 2 of 2 does not hold.*: one"):
        course.claim("one", True, 2 < 1)
    with pytest.raises(AssertionError):
        course.learnt({"a": True, "b": False})
    with pytest.raises(ValueError, match="give the conditions"):
        course.claim("all is well")


def test_differences_do_not_tell_the_answer():
    assert not differs(torch.ones(2) + 1e-5, torch.ones(2), 1e-3)
    assert differs(1, torch.ones(2), 1e-3) == "the result has the shape [], and [2] is right"
    assert differs([1.0, 2.0], torch.ones(2), 1e-3) == "the shape is right, but the numbers are not"
    assert differs(float("nan"), 1.0, 1e-3)
    assert differs(1.5, 2.0, 1e-3) == "1.5 is not right"
    assert not differs({"a"}, {"a"}, 0)
    assert differs(["a"], {"a"}, 0)


def test_judges_know_wrong_answers():
    judge = same_as(lambda x: 2 * x, lambda: [(1.0,), (3.0,)], {"halved": lambda x: x / 2})
    assert judge(lambda x: x + x) == ""
    assert judge(lambda x: x / 2) == "halved"
    assert judge(lambda x: 2.0) == "hidden case 2 of 2: 2 is not right."
    assert judge(lambda x: None) == "no answer yet."
    assert judge(3) == "a function is needed, not int."
    assert equals(4, {"that is its square": 16})(16) == "that is its square"


def test_check_says_what_is_wrong(monkeypatch):
    assert course.check("00.2", lambda speed, fps: speed / fps)
    for answer in (3, lambda speed, fps: speed, lambda: 1):
        verdict = course.check("00.2", answer)
        assert not verdict
        assert "Hint: in one second" in str(verdict)
    for nothing in (..., lambda speed, fps: ...):
        # A hint comes after an attempt.
        assert str(course.check("00.2", nothing)) == "○ 00.2: No answer yet."
    assert "raised TypeError" in str(verdict)
    with pytest.raises(ValueError, match=r"no exercise '00\.9'; there are 00\.1, 00\.2"):
        course.check("00.9", 1)
    with pytest.raises(ValueError, match="no exercise 'x'"):
        course.check("x", 1)


@pytest.mark.parametrize("number", WRITTEN)
def test_exercises_are_numbered_and_refuse_trivial_answers(number):
    known = course.exercises_of(number)
    assert list(known) == [f"{number}.{i + 1}" for i in range(len(known))]
    for name, exercise in known.items():
        assert isinstance(exercise, Exercise)
        for nothing in (
            ..., 0, 1, "", {}, lambda *_: 0.0, lambda *_: torch.zeros(1), lambda first, *_: first
        ):
            assert not course.check(name, nothing), (name, nothing)


def test_importing_the_toolkit_does_not_import_the_course():
    code = "import sys, toolkit; print('course' in sys.modules, 'plotly' in sys.modules)"
    assert subprocess.check_output([sys.executable, "-c", code], text=True).split() == [
        "False", "False"
    ]
