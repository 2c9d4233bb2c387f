"""The pages of the notebooks that answer without a kernel."""

import html
import re

import course
import pytest
import torch
from course import laboratory, network_figures

import toolkit as tk


@pytest.fixture
def opened(visit, tmp_path):
    """Opens what is in the frame of a `course.Page`."""

    def open_(page):
        text = html.unescape(re.search(r'srcdoc="(.*?)" sandbox', page.html, re.DOTALL)[1])
        (tmp_path / "page.html").write_text(text, encoding="utf-8")
        return visit(tmp_path / "page.html")

    return open_


def drag(page, slider: str, value: float) -> None:
    page.evaluate("([id, value]) => { const x = document.getElementById(id); x.value = value; "
                  "x.dispatchEvent(new Event('input')); }", [slider, value])


def test_both_sliders_of_a_hidden_layer_act_together(opened):
    page = opened(network_figures.modulation(torch.linspace(-2, 2, 32)))
    drawn = []
    for slider, value in (("g", 2), ("b", 1), ("g", 1), ("b", 0)):
        drag(page, slider, value)
        drawn.append(page.evaluate("() => document.querySelector('canvas').toDataURL()"))
    assert len(set(drawn)) == 4


def test_sliders_of_the_laboratory_change_the_errors(opened):
    page = opened(laboratory.sliders(6.0))

    def errors():
        return [int(x) for x in re.findall(r"(\d+)°", page.inner_text("#table"))]

    good = errors()
    assert max(good[:-2]) < 25
    drag(page, "hand0", 0)
    drag(page, "hand2", 1)  # how far to the left a hand is
    assert errors()[-2] > good[-2]
    assert errors()[-1] == good[-1]  # the feet have sliders of their own


def test_the_blind_page_counts_answers_of_each_pair_once(opened):
    clips = tk.datasets.load("procedural", styles=["Neutral", "Zombie"], gaits="FW", seconds=3.0)
    page = opened(course.blind({"one": tuple(clips), "two": tuple(clips)}, "which is Neutral?"))
    for _ in range(2):
        page.locator("button").first.click()
    assert page.inner_text("#ask") == "Done."
    assert re.match(r"[012] of 2 right: between \d+ % and \d+ %", page.inner_text("#told"))
    assert page.locator("button").first.is_disabled()
