"""Pages of clips, of characters of one's own and of the course, and what is named like HTML."""

import re

import course
import numpy as np
import pytest
import torch
from course import (
    charts,
    feature_figures,
    laboratory,
    losses_page,
    network_figures,
    pages as lessons,
    phase_figures,
    plane,
)

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.extra.characters import retargeting
from toolkit.extra.characters.character import Character
from toolkit.motion import Skeleton
from toolkit.stylization import losses
from toolkit.view.pages import page as pages_
from toolkit.view.render import mannequin as body

from .conftest import COMMENT, IMAGE, PLANTED, SCRIPT, drag, middle, shows_as_text, visits


@pytest.fixture(scope="module")
def clip():
    return procedural.generate("Old", seconds=1.0)


def numbers(page, values: str) -> np.ndarray:
    return np.array(page.evaluate(f"() => [...{values}.array]")).reshape(-1, 3)


# clips and characters


def planted(clip):
    """The clip with names like HTML, and the weights of styles with such names."""
    old = clip.skeleton
    names = [f"{name}{PLANTED[j % 3]}" for j, name in enumerate(old.names)]
    roles = {role: names[old.names.index(name)] for role, name in old.roles.items()}
    ends = [names[j] for j in range(len(old)) if old.is_end(j)]
    renamed = Skeleton(names, old.parents, old.offsets, roles, ends)
    weights = {text: [1.0] * len(clip) for text in PLANTED}
    return clip.replace(skeleton=renamed, style=IMAGE, name=SCRIPT), weights


def test_the_page_plays_and_bends_as_python_does(visit, tmp_path, clip):
    shown, weights = planted(clip)
    page = visit(tk.view.html([shown, clip.mirrored()], tmp_path / "walk.html", title=IMAGE,
                              caption=SCRIPT, labels=[COMMENT, "mirrored"], styles=[weights, None]))
    page.wait_for_function("() => globalThis.view?.state.drawn > 3")
    page.evaluate("() => { view.play(false); view.seek(40 / 60); }")
    skin = body.build(shown).skin
    expected = skin.pose(clip.global_rotations[40], clip.global_positions[40])
    for kind, values, atol in zip(("position", "normal"), expected, (1e-3, 0.02), strict=True):
        seen = numbers(page, f"view.scenes[0].body.{kind}")
        np.testing.assert_allclose(seen, values, atol=atol)
    # At rest it is drawn once more, finer, and then no more until the camera goes round.
    canvas = "view.scenes[0].canvas"
    page.wait_for_function(f"() => {canvas}.width > 1.5 * {canvas}.clientWidth")
    drawn = page.evaluate("""async () => {
        const drawn = view.state.drawn;
        for (let k = 0; k < 5; k++) await new Promise(requestAnimationFrame);
        return [drawn, view.state.drawn];
    }""")
    assert drawn[0] == drawn[1]
    drag(page, (300, 300), (380, 300))
    page.wait_for_function(f"() => view.state.drawn > {drawn[1]}")
    shows_as_text(page)


def test_a_page_shows_a_character_of_ones_own_which_follows_as_retargeting_does(
        visit, tmp_path, hero, clip):
    """The live scene turns the joints itself; compared with Python's retargeting without IK."""
    page = visit(tk.view.html([clip], tmp_path / "walk.html", title="Hero", character=hero))
    page.wait_for_function("() => globalThis.view?.state.drawn > 3")
    page.evaluate("() => { view.play(false); view.seek(30 / 60); }")
    hero = Character.load(hero)
    made = hero.fitted(clip)
    expected = hero.skin.pose(made.global_rotations[30], made.global_positions[30])[0]
    seen = numbers(page, "view.scenes[0].body.position")
    np.testing.assert_allclose(seen, expected, atol=2e-3)  # 16-bit rotations, 8-bit weights

    page.evaluate("(data) => { globalThis.scene = new toolkitScene.Scene(stage, data); }",
                  pages_.skeleton_data(clip, hero))
    made, lift = retargeting.retarget(clip, hero.rest, feet=False), None
    for frame in (0, 20, 50):
        page.evaluate(
            "([root, rotations]) => scene.body.pose(root, Float32Array.from(rotations))",
            [clip.root_positions[frame].tolist(), clip.rotations[frame].flatten().tolist()])
        seen = numbers(page, "scene.body.position")
        expected = hero.skin.pose(made.global_rotations[frame], made.global_positions[frame])[0]
        # The height of the soles over the floor is that of the first frame.
        lift = float((seen - expected)[:, 1].mean()) if lift is None else lift
        np.testing.assert_allclose(seen, expected + np.array([0.0, lift, 0.0]), atol=2e-3)
    assert abs(lift) < 0.1


# the course without a kernel


def figures() -> list:
    """The figures of the course with sliders."""
    clip, known = procedural.truth("Neutral", "FW", 3.0)
    t = torch.linspace(-0.5, 0.5, 61).double()
    fits = {f: ((6.28 * f * t).sin(), abs(f - 1.0)) for f in (0.5, 1.0, 1.5)}
    pose = torch.rand(3, 3, generator=torch.Generator().manual_seed(0))
    return [
        feature_figures.carried(clip, 120, 4),
        phase_figures.cycle(clip, known.phase[:, 0], 60, 120),
        phase_figures.frequencies(t, fits[1.0][0], fits, 1.0),
        network_figures.poses([-1, 0, 1], pose, {"0%": pose, "100%": pose + 1}, "poses"),
        network_figures.blend_of_lines((1.0, -1.0), (0.0, 0.5)),
    ]


@pytest.fixture(scope="module")
def toy():
    return plane.Toy(plane.SWITCHES, seed=0).train(4)


@pytest.fixture(scope="module")
def lesson(browser, pages, clip, toy):
    """A page with figures, frames and what is named like HTML, of the tests in turn."""
    def answer(*_):
        raise ValueError(COMMENT + IMAGE + SCRIPT)

    clips = procedural.load(["Neutral", "Zombie"], "FW", 3.0)
    drawn = [*figures(), charts.style_space([[0, 0], [1, 0], [0, 1]], PLANTED, PLANTED,
                                            title=COMMENT)]
    shown = [
        course.film(clip.replace(style=IMAGE), title=COMMENT, caption=SCRIPT), course.two_bone(),
        course.show(losses_page.losses_page(toy), 460),
        network_figures.modulation(torch.linspace(-2, 2, 32)), laboratory.sliders(6.0),
        course.blind({"one": tuple(clips), "two": tuple(clips)}, "which is Neutral?"),
        *[course.check("01.1", value) for value in (answer, COMMENT + IMAGE)],
    ]
    parts = [lessons.charts(), *map(lessons.chart, drawn), *(part._repr_html_() for part in shown)]
    path = pages / "lesson.html"
    path.write_text(f"<!doctype html><meta charset=utf-8><body>{''.join(parts)}", encoding="utf-8")
    with visits(browser) as visit:
        yield visit(path)


@pytest.fixture
def framed(lesson):
    """The content of a frame by its number; frames out of sight rest."""
    def scrolled(number: int):
        frame = lesson.locator("iframe").nth(number)
        frame.scroll_into_view_if_needed()
        return frame.element_handle().content_frame()

    return scrolled


def test_a_lesson_with_planted_html_shows_it_as_text(lesson, framed):
    lesson.wait_for_selector(".main-svg text")
    film = framed(0)
    film.wait_for_function("() => globalThis.view?.state.drawn")
    assert COMMENT in film.evaluate("() => document.body.textContent")
    shows_as_text(lesson)


STATE = """div => [...div.querySelectorAll('.cartesianlayer path, .cartesianlayer .point')]
    .map(p => p.outerHTML).join()"""
#: Texts of a figure that are on another text or outside the figure.
COLLIDE = """div => {
    const box = div.getBoundingClientRect();
    const texts = [...div.querySelectorAll("svg text")].filter(t => t.textContent.trim());
    const at = texts.map(t => [t.textContent.trim(), t.getBoundingClientRect()])
        .filter(([, r]) => r.width > 0);
    const out = at.filter(([, r]) =>
        r.left < box.left - 1 || r.right > box.right + 1 || r.top < box.top - 1);
    const on = at.flatMap(([a, r], i) => at.slice(i + 1).filter(([, q]) =>
        Math.min(r.right, q.right) - Math.max(r.left, q.left) > 2 &&
        Math.min(r.bottom, q.bottom) - Math.max(r.top, q.top) > 3).map(([b]) => `${a} | ${b}`));
    return [...out.map(([a]) => a), ...on];
}"""


def test_each_slider_moves_its_figure_and_no_text_collides(lesson):
    page = lesson
    for i in range(5):
        plot = page.locator(".plotly-graph-div").nth(i)
        plot.scroll_into_view_if_needed()
        for rail in plot.locator(".slider-rail-touch-rect").all():
            before = plot.evaluate(STATE)
            page.mouse.click(*middle(rail, 0.3 * rail.bounding_box()["width"]))
            moved = f"([div, before]) => ({STATE})(div) !== before"
            page.wait_for_function(moved, arg=[plot.element_handle(), before])
        assert plot.evaluate(COLLIDE) == [], i


def test_the_ankle_follows_the_pointer(lesson, framed):
    page, frame = lesson, framed(1)
    frame.wait_for_selector("#leg")
    before = frame.locator("#d").inner_text()
    box = frame.locator("svg").bounding_box()
    drag(page, (box["x"] + 190, box["y"] + 150), (box["x"] + 340, box["y"] + 240))
    assert frame.locator("#d").inner_text() != before
    assert "too far" in frame.locator("#note").inner_text()
    page.mouse.click(box["x"] + 190, box["y"] + 160)
    assert 0 < float(frame.locator("#angle").inner_text()) < 180


def test_a_loss_that_is_switched_off_shows_its_stylizer(framed, toy):
    frame = framed(2)
    frame.wait_for_selector("#table td")

    def table() -> dict:
        cells = frame.locator("#table td").all_inner_texts()
        return {name: float(cells[cells.index(text) + 1])
                for name, text in losses_page.SHOWN.items()}

    every = table()
    measures = {name: values.tolist() for name, values in toy.measures().items()}
    for off in ("cyc", "sty"):
        frame.locator(f"#{off}").click()
        row = plane.SWITCHES.index(tuple(name for name in losses.LOSSES if name != off))
        wanted = {name: values[row] for name, values in measures.items()}
        assert table() == pytest.approx(wanted, abs=0.006), off
        frame.locator(f"#{off}").click()
        assert table() == every


def turn(page, slider: str, value: float) -> None:
    page.evaluate("([id, value]) => { const x = document.getElementById(id); x.value = value; "
                  "x.dispatchEvent(new Event('input')); }", [slider, value])


def test_both_sliders_of_a_hidden_layer_act_together(framed):
    page, drawn = framed(3), []
    page.wait_for_selector("canvas")
    for slider, value in (("g", 2), ("b", 1), ("g", 1), ("b", 0)):
        turn(page, slider, value)
        drawn.append(page.evaluate("() => document.querySelector('canvas').toDataURL()"))
    assert len(set(drawn)) == 4


def test_sliders_of_the_laboratory_change_the_errors(framed):
    page = framed(4)
    page.wait_for_selector("#table")

    def errors():
        return [int(x) for x in re.findall(r"(\d+)°", page.inner_text("#table"))]

    good = errors()
    assert max(good[:-2]) < 25
    turn(page, "hand0", 0)
    turn(page, "hand2", 1)  # how far to the left a hand is
    assert errors()[-2] > good[-2]
    assert errors()[-1] == good[-1]  # the feet have sliders of their own


def test_the_blind_page_counts_answers_of_each_pair_once(framed):
    page = framed(5)
    for _ in range(2):
        page.locator("button").first.click()
    assert page.inner_text("#ask") == "Done."
    assert re.match(r"[012] of 2 right: between \d+ % and \d+ %", page.inner_text("#told"))
    assert page.locator("button").first.is_disabled()
