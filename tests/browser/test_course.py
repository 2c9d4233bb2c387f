"""The course without a kernel, in a real browser: sliders move figures, films play, a leg follows the pointer."""

import pytest
import torch

import toolkit as tk
from toolkit.course import feature_figures, network_figures, pages, phase_figures
from toolkit.datasets import procedural
from toolkit.stylization import losses, plane
from toolkit.view import losses_page


@pytest.fixture
def open_html(browser, tmp_path):
    """``open_html(body)``: a page with plotly's code, and what went wrong in it or was asked of a server."""
    opened = []

    def open_(body: str):
        page = browser.new_page(viewport={"width": 1000, "height": 800})
        opened.append(page)
        wrong = []
        page.on("console", lambda m: wrong.append(m.text) if m.type == "error" else None)
        page.on("pageerror", lambda e: wrong.append(str(e)))
        page.on("request", lambda r: wrong.append(r.url) if r.url.startswith("http") else None)
        path = tmp_path / "page.html"
        path.write_text(f"<!doctype html><meta charset=utf-8><body>{pages.charts()}{body}", encoding="utf-8")
        page.goto(path.as_uri(), timeout=120_000)
        return page, wrong

    yield open_
    for page in opened:
        page.close()


def figures() -> dict:
    """The figures of the course with sliders."""
    clip, known = procedural.truth("Neutral", "FW", 6.0)
    t = torch.linspace(-0.5, 0.5, 61).double()
    fits = {f: ((6.28 * f * t).sin(), abs(f - 1.0)) for f in (0.5, 1.0, 1.5)}
    pose = torch.rand(3, 3)
    sliders = {name: {"0%": pose, "100%": pose + k} for k, name in enumerate("ab", 1)}
    return {
        "carried": feature_figures.carried(clip, 120, 4), "cycle": phase_figures.cycle(clip, known.phase[:, 0], 60, 120),
        "frequencies": phase_figures.frequencies(t, fits[1.0][0], fits, 1.0),
        "poses": network_figures.poses([-1, 0, 1], pose, sliders, "poses"),
        "blend_of_lines": network_figures.blend_of_lines((1.0, -1.0), (0.0, 0.5)),
        "modulation": network_figures.modulation(torch.randn(32)),
    }


STATE = "div => [...div.querySelectorAll('.cartesianlayer path, .cartesianlayer .point')].map(p => p.outerHTML).join()"


#: Texts of a figure that are on another text or outside the figure.
COLLIDE = """div => {
    const box = div.getBoundingClientRect(), texts = [...div.querySelectorAll("svg text")].filter(t => t.textContent.trim());
    const at = texts.map(t => [t.textContent.trim(), t.getBoundingClientRect()]).filter(([, r]) => r.width > 0);
    const out = at.filter(([, r]) => r.left < box.left - 1 || r.right > box.right + 1 || r.top < box.top - 1);
    const on = at.flatMap(([a, r], i) => at.slice(i + 1).filter(([, q]) =>
        Math.min(r.right, q.right) - Math.max(r.left, q.left) > 2 &&
        Math.min(r.bottom, q.bottom) - Math.max(r.top, q.top) > 3).map(([b]) => `${a} | ${b}`));
    return [...out.map(([a]) => a), ...on];
}"""


def test_each_slider_moves_its_figure_and_no_text_collides(open_html):
    drawn = figures()
    page, wrong = open_html("".join(pages.chart(figure) for figure in drawn.values()))
    for i, name in enumerate(drawn):
        plot = page.locator(".plotly-graph-div").nth(i)
        plot.scroll_into_view_if_needed()
        for rail in plot.locator(".slider-rail-touch-rect").all():
            page.wait_for_timeout(300)
            before = plot.evaluate(STATE)
            box = rail.bounding_box()
            page.mouse.click(box["x"] + 0.8 * box["width"], box["y"] + box["height"] / 2)
            page.wait_for_timeout(900)
            assert plot.evaluate(STATE) != before, name
        assert plot.evaluate(COLLIDE) == [], name
    assert wrong == []


def test_a_film_plays_in_its_frame(open_html):
    clip = procedural.generate("Old", seconds=2.0)
    page, wrong = open_html(tk.course.film(clip, title="Old").html)
    frame = page.frames[1]
    frame.wait_for_function("() => view.state.drawn > 3")
    assert wrong == []


def test_the_ankle_follows_the_pointer(open_html):
    page, wrong = open_html(tk.course.two_bone().html)
    frame = page.frames[1]
    frame.wait_for_selector("#leg")
    before = frame.locator("#d").inner_text()
    box = frame.locator("svg").bounding_box()
    page.mouse.move(box["x"] + 190, box["y"] + 150)
    page.mouse.down()
    page.mouse.move(box["x"] + 340, box["y"] + 240)
    page.mouse.up()
    after = frame.locator("#d").inner_text()
    assert after != before
    assert "too far" in frame.locator("#note").inner_text()
    page.mouse.click(box["x"] + 190, box["y"] + 160)
    assert 0 < float(frame.locator("#angle").inner_text()) < 180
    assert wrong == []


def test_a_loss_that_is_switched_off_shows_its_stylizer(open_html):
    toy = plane.Toy(plane.SWITCHES, seed=0).train()
    page, wrong = open_html(tk.course.show(losses_page.losses_page(toy), 460).html)
    frame, measures = page.frames[1], toy.measures()
    frame.wait_for_selector("#table td")

    def shown() -> dict:
        cells = frame.locator("#table td").all_inner_texts()
        return {name: float(cells[cells.index(text) + 1]) for name, text in losses_page.SHOWN.items()}

    def drawn() -> str:
        return frame.evaluate("() => document.getElementById('plane').toDataURL()")

    every, picture = shown(), drawn()
    for off, lost in (("cyc", "content"), ("sty", "version"), ("ds", "spread")):
        frame.locator(f"#{off}").click()
        row = plane.SWITCHES.index(tuple(name for name in losses.LOSSES if name != off))
        assert shown() == pytest.approx({name: values[row].item() for name, values in measures.items()}, abs=0.006), off
        assert shown()[lost] < 0.85 * every[lost], off
        assert drawn() != picture, off
        frame.locator(f"#{off}").click()
        assert (shown(), drawn()) == (every, picture)
    assert wrong == []


def test_jupyterlab_shows_the_map_a_figure_and_a_film(open_notebook):
    notebook = open_notebook("course.ipynb", [
        "import toolkit as tk\ntk.course.here('01')",
        "tk.view.training_curves([{'step': k, 'loss': 1 / k} for k in (1, 2, 3)])",
        "tk.course.film(tk.datasets.load('procedural', styles='Old', gaits='FW', seconds=2.0))",
    ])
    notebook.run_all(200)
    page = notebook.page
    page.wait_for_selector(".jp-OutputArea svg[role=img]")
    page.wait_for_selector(".js-plotly-plot .scatterlayer .trace", timeout=60_000)
    page.wait_for_selector("iframe[srcdoc]")
    assert notebook.errors == []
