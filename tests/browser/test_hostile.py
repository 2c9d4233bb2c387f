"""Names, labels, titles and errors with HTML in them: a browser shows them as text, runs nothing and shows everything."""

import pytest

import toolkit as tk
from toolkit.course import pages
from toolkit.motion import Skeleton
from toolkit.networks.bank import StyleBank
from toolkit.view import director, figures

IMAGE, SCRIPT, COMMENT = "<img src=x onerror=hacked=1>", "</script><script>hacked=1</script>", "<!--<script>"
PLANTED = (IMAGE, SCRIPT, COMMENT)
HACKED = "() => typeof hacked !== 'undefined'"


@pytest.fixture
def page(browser):
    page = browser.new_page(viewport={"width": 900, "height": 600})
    yield page
    page.close()


@pytest.mark.parametrize("kind", ["player", "character", "director", "chart", "course"])
def test_a_page_with_planted_html_shows_it_as_text(kind, page, tmp_path):
    path = tmp_path / "page.html"
    if kind == "player":
        clip = tk.datasets.load("procedural", styles=["Old"], gaits=["FW"], seconds=1.0)[0]
        old = clip.skeleton
        names = [f"{name}{PLANTED[j % 3]}" for j, name in enumerate(old.names)]
        renamed = {role: names[old.names.index(name)] for role, name in old.roles.items()}
        ends = [names[j] for j in range(len(old)) if old.is_end(j)]
        clip = clip.replace(skeleton=Skeleton(names, old.parents, old.offsets, renamed, ends), style=IMAGE, name=SCRIPT)
        weights = {text: [1.0] * len(clip) for text in PLANTED}
        tk.view.html(clip, path, title=IMAGE, caption=SCRIPT, labels=[COMMENT], styles=weights)
    elif kind == "character":
        model, bank = tk.pretrained()
        tk.view.web(model, StyleBank(PLANTED, bank.vectors[:3]), path, title=COMMENT, characters=3)
    elif kind == "director":
        model, bank = tk.pretrained()
        walks = [tk.shots.Shot([(3 * k, 0), (3 * k, 2)], text, duration=1, name=text) for k, text in enumerate(PLANTED)]
        director.web(model, StyleBank(PLANTED, bank.vectors[:3]), path, walks, title=COMMENT)
    elif kind == "course":  # a film in a frame, a chart, the verdict on an answer, parts of one page
        def answer(*_):
            raise ValueError(COMMENT + IMAGE + SCRIPT)

        clip = tk.datasets.load("procedural", styles=["Old"], gaits=["FW"], seconds=1.0)[0].replace(style=IMAGE)
        chart = figures.style_space([[0, 0], [1, 0], [0, 1]], PLANTED, PLANTED, title=COMMENT)
        parts = [pages.charts(), pages.chart(chart), tk.course.film(clip, title=COMMENT, caption=SCRIPT)._repr_html_()]
        parts += [tk.course.check("01.1", value)._repr_html_() for value in (answer, COMMENT + IMAGE)]
        path.write_text(f"<!doctype html><meta charset=utf-8><body>{''.join(parts)}", encoding="utf-8")
    else:
        figures.style_space([[0, 0], [1, 0], [0, 1]], PLANTED, PLANTED, title=COMMENT).write_html(path)
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(path.as_uri())
    page.wait_for_function("() => document.querySelector('.main-svg text')" if kind in ("chart", "course") else
                           "() => globalThis.view", timeout=60_000)
    if kind == "course":
        page.frames[1].wait_for_function("() => globalThis.view?.state.drawn")
        assert COMMENT in page.frames[1].evaluate("() => document.body.textContent")
    page.wait_for_timeout(500)
    assert not any(frame.evaluate(HACKED) for frame in page.frames)
    assert errors == []
    text = page.evaluate("() => document.body.textContent")
    assert COMMENT in text
    if kind not in ("chart", "course"):
        assert page.locator("canvas").count() > 0
    assert page.locator('img[src="x"]').count() == 0


def test_an_error_with_html_in_a_widget_runs_no_script(open_notebook):
    cells = [f"""
import torch, toolkit as tk
from toolkit.networks.bank import StyleBank
clip = tk.datasets.load("procedural", styles=["Old"], gaits=["FW"], seconds=1.0)[0]
def make(blend):
    if shown is not None:
        raise ValueError({IMAGE!r} + ".bvh: cannot be read")
    return clip.replace(style={IMAGE!r})
shown = None
shown = tk.view.StyleBlender(StyleBank(({IMAGE!r}, {COMMENT!r}, "C"), torch.eye(3)), make, size=(160, 120))
shown
""", "shown.triangle.weights = [0.0, 1.0, 0.0]"]
    notebook = open_notebook("hostile.ipynb", cells)
    notebook.run_all()
    notebook.page.wait_for_selector("text=ValueError", timeout=60_000)
    notebook.page.wait_for_timeout(500)
    assert "cannot be read" in notebook.page.evaluate("() => document.body.textContent")
    assert not notebook.page.evaluate(HACKED)
    assert notebook.page.locator('img[src="x"]').count() == 0


def test_widgets_with_planted_names_show_them_as_text(open_notebook):
    """Explorer, Director, controller and player, and what the course shows of an answer."""
    cells = [f"""
import torch, toolkit as tk
from toolkit.course import check
from toolkit.networks.bank import StyleBank
texts = {PLANTED!r}
model, bank = tk.pretrained()
bank = StyleBank((*texts, "D"), bank.vectors[:4])
clip = tk.datasets.load("procedural", styles=["Old"], gaits=["FW"], seconds=1.0)[0].replace(style=texts[0])
tk.view.explore(model, bank, points=torch.tensor([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.5]]), groups=[*texts, "D"],
                make_clip=lambda blend: clip)
""", "tk.view.Director(model, bank, [tk.shots.Shot([(0, 0), (0, 2)], texts[2], duration=1, name=texts[0])])",
             "tk.view.Controller(model, bank)", "tk.view.play([clip, clip], labels=texts[:2])",
             "check('01.1', ''.join(texts))",
             "tk.evaluation.report(clip), clip, bank, tk.course.film(clip, title=texts[2])"]
    notebook = open_notebook("planted.ipynb", cells)
    notebook.run_all(240)
    page = notebook.page
    for selector in (".tk-style-map .main-svg text", ".tkd-map", ".tk-screen"):
        page.wait_for_selector(selector, timeout=60_000)
    page.wait_for_timeout(1000)
    assert not any(frame.evaluate(HACKED) for frame in page.frames)
    assert page.locator('img[src="x"]').count() == 0
    assert not [error for error in notebook.errors if "favicon" not in error]
    shown = page.locator(".jp-OutputArea-output").all_text_contents()
    assert sum(COMMENT in text or IMAGE in text for text in shown) >= 4
