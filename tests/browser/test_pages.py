"""Pages of clips, of characters of one's own and of the course, and what is named like HTML."""

import re
from pathlib import Path

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

from .conftest import COMMENT, IMAGE, PLANTED, SCRIPT, shows_as_text


@pytest.fixture(scope="module")
def clip():
    return procedural.generate("Old", seconds=1.0)


def numbers(page, values: str) -> np.ndarray:
    return np.array(page.evaluate(f"() => [...{values}.array]")).reshape(-1, 3)


# clips and characters


def test_the_page_plays_and_bends_as_python_does(visit, tmp_path, clip):
    page = visit(tk.view.html([clip, clip.mirrored()], tmp_path / "walk.html", title="Walk"))
    page.wait_for_function("() => globalThis.view?.state.drawn > 3")
    page.evaluate("() => { view.play(false); view.seek(40 / 60); }")
    position, normal = (
        numbers(page, f"view.scenes[0].body.{kind}") for kind in ("position", "normal")
    )
    skin = body.build(clip).skin
    points, normals = skin.pose(clip.global_rotations[40], clip.global_positions[40])
    np.testing.assert_allclose(position, points, atol=1e-3)
    np.testing.assert_allclose(normal, normals, atol=0.02)
    # At rest it is drawn once more, finer, and then no more until the camera goes round.
    canvas = "view.scenes[0].canvas"
    page.wait_for_function(f"() => {canvas}.width > 1.5 * {canvas}.clientWidth")
    drawn = page.evaluate("""async () => {
        const drawn = view.state.drawn;
        for (let k = 0; k < 5; k++) await new Promise(requestAnimationFrame);
        return [drawn, view.state.drawn];
    }""")
    assert drawn[0] == drawn[1]
    page.mouse.move(300, 300)
    page.mouse.down()
    page.mouse.move(380, 300, steps=4)
    page.mouse.up()
    page.wait_for_function(f"() => view.state.drawn > {drawn[1]}")


def test_a_page_shows_a_character_of_ones_own(visit, tmp_path, hero, clip):
    page = visit(tk.view.html([clip], tmp_path / "walk.html", title="Hero", character=hero))
    page.wait_for_function("() => globalThis.view?.state.drawn > 3")
    page.evaluate("() => { view.play(false); view.seek(30 / 60); }")
    hero = Character.load(hero)
    made = hero.fitted(clip)
    expected = hero.skin.pose(made.global_rotations[30], made.global_positions[30])[0]
    seen = numbers(page, "view.scenes[0].body.position")
    np.testing.assert_allclose(seen, expected, atol=2e-3)  # 16-bit rotations, 8-bit weights


def test_it_follows_another_skeleton_as_retargeting_does(visit, tmp_path, hero, clip):
    """The live scene turns the joints itself; compared with Python's retargeting without IK."""
    start = "globalThis.scene = new toolkitScene.Scene(stage, data.skeleton);"
    hero = Character.load(hero)
    data = {"skeleton": pages_.skeleton_data(clip, hero)}
    page = visit(pages_.write(tmp_path / "live.html", "Hero", "", data, start))
    made, lift = retargeting.retarget(clip, hero.rest, feet=False), None
    for frame in (0, 20, 50):
        page.evaluate(
            "([root, rotations]) => scene.body.pose(root, Float32Array.from(rotations))",
            [clip.root_positions[frame].tolist(), clip.rotations[frame].flatten().tolist()]
        )
        seen = numbers(page, "scene.body.position")
        expected = hero.skin.pose(made.global_rotations[frame], made.global_positions[frame])[0]
        # The height of the soles over the floor is that of the first frame.
        lift = float((seen - expected)[:, 1].mean()) if lift is None else lift
        np.testing.assert_allclose(seen, expected + np.array([0.0, lift, 0.0]), atol=2e-3)
    assert abs(lift) < 0.1


# what is named like HTML


def player(path: Path, clip) -> None:
    old = clip.skeleton
    names = [f"{name}{PLANTED[j % 3]}" for j, name in enumerate(old.names)]
    roles = {role: names[old.names.index(name)] for role, name in old.roles.items()}
    ends = [names[j] for j in range(len(old)) if old.is_end(j)]
    renamed = Skeleton(names, old.parents, old.offsets, roles, ends)
    weights = {text: [1.0] * len(clip) for text in PLANTED}
    clip = clip.replace(skeleton=renamed, style=IMAGE, name=SCRIPT)
    tk.view.html(clip, path, title=IMAGE, caption=SCRIPT, labels=[COMMENT], styles=weights)


def lesson(path: Path, clip) -> None:
    def answer(*_):
        raise ValueError(COMMENT + IMAGE + SCRIPT)

    chart = charts.style_space([[0, 0], [1, 0], [0, 1]], PLANTED, PLANTED, title=COMMENT)
    film = course.film(clip.replace(style=IMAGE), title=COMMENT, caption=SCRIPT)
    parts = [lessons.charts(), lessons.chart(chart), film._repr_html_()]
    parts += [course.check("01.1", value)._repr_html_() for value in (answer, COMMENT + IMAGE)]
    path.write_text(f"<!doctype html><meta charset=utf-8><body>{''.join(parts)}", encoding="utf-8")


@pytest.mark.parametrize("write", [player, lesson])  # others: test_web.py, test_director.py
def test_a_page_with_planted_html_shows_it_as_text(visit, tmp_path, clip, write):
    write(tmp_path / "page.html", clip)
    page = visit(tmp_path / "page.html")
    if write is lesson:
        page.wait_for_selector(".main-svg text")
        page.frames[1].wait_for_function("() => globalThis.view?.state.drawn")
        assert COMMENT in page.frames[1].evaluate("() => document.body.textContent")
    else:
        page.wait_for_function("() => globalThis.view && document.querySelector('canvas')")
    shows_as_text(page)


# the course without a kernel


@pytest.fixture
def shown(visit, tmp_path):
    """``shown(body)``: a page of the course."""

    def open_(html: str):
        path = tmp_path / "page.html"
        path.write_text(f"<!doctype html><meta charset=utf-8><body>{html}", encoding="utf-8")
        return visit(path)

    return open_


@pytest.fixture
def framed(shown):
    """Opens what is in the frame of a `course.Page`."""
    return lambda page: shown(page.html).frames[1]


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


def test_each_slider_moves_its_figure_and_no_text_collides(shown):
    drawn = figures()
    page = shown(lessons.charts() + "".join(map(lessons.chart, drawn)))
    for i in range(len(drawn)):
        plot = page.locator(".plotly-graph-div").nth(i)
        plot.scroll_into_view_if_needed()
        for rail in plot.locator(".slider-rail-touch-rect").all():
            before, box = plot.evaluate(STATE), rail.bounding_box()
            page.mouse.click(box["x"] + 0.8 * box["width"], box["y"] + box["height"] / 2)
            moved = f"([div, before]) => ({STATE})(div) !== before"
            page.wait_for_function(moved, arg=[plot.element_handle(), before])
        assert plot.evaluate(COLLIDE) == [], i


def test_the_ankle_follows_the_pointer(shown):
    page = shown(course.two_bone().html)
    frame = page.frames[1]
    frame.wait_for_selector("#leg")
    before = frame.locator("#d").inner_text()
    box = frame.locator("svg").bounding_box()
    page.mouse.move(box["x"] + 190, box["y"] + 150)
    page.mouse.down()
    page.mouse.move(box["x"] + 340, box["y"] + 240)
    page.mouse.up()
    assert frame.locator("#d").inner_text() != before
    assert "too far" in frame.locator("#note").inner_text()
    page.mouse.click(box["x"] + 190, box["y"] + 160)
    assert 0 < float(frame.locator("#angle").inner_text()) < 180


def test_a_loss_that_is_switched_off_shows_its_stylizer(framed):
    toy = plane.Toy(plane.SWITCHES, seed=0).train(4)
    frame = framed(course.show(losses_page.losses_page(toy), 460))
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
    page = framed(network_figures.modulation(torch.linspace(-2, 2, 32)))
    drawn = []
    for slider, value in (("g", 2), ("b", 1), ("g", 1), ("b", 0)):
        turn(page, slider, value)
        drawn.append(page.evaluate("() => document.querySelector('canvas').toDataURL()"))
    assert len(set(drawn)) == 4


def test_sliders_of_the_laboratory_change_the_errors(framed):
    page = framed(laboratory.sliders(6.0))

    def errors():
        return [int(x) for x in re.findall(r"(\d+)°", page.inner_text("#table"))]

    good = errors()
    assert max(good[:-2]) < 25
    turn(page, "hand0", 0)
    turn(page, "hand2", 1)  # how far to the left a hand is
    assert errors()[-2] > good[-2]
    assert errors()[-1] == good[-1]  # the feet have sliders of their own


def test_the_blind_page_counts_answers_of_each_pair_once(framed):
    clips = procedural.load(["Neutral", "Zombie"], "FW", 3.0)
    page = framed(course.blind({"one": tuple(clips), "two": tuple(clips)}, "which is Neutral?"))
    for _ in range(2):
        page.locator("button").first.click()
    assert page.inner_text("#ask") == "Done."
    assert re.match(r"[012] of 2 right: between \d+ % and \d+ %", page.inner_text("#told"))
    assert page.locator("button").first.is_disabled()
