"""Names, labels, titles and errors with HTML in them: a browser shows them as text, runs nothing and shows everything."""

import pytest

import toolkit as tk
from toolkit.motion import Skeleton
from toolkit.networks.bank import StyleBank
from toolkit.view import figures

IMAGE, SCRIPT, COMMENT = "<img src=x onerror=hacked=1>", "</script><script>hacked=1</script>", "<!--<script>"
HACKED = "() => typeof hacked !== 'undefined'"


@pytest.fixture
def page(browser):
    page = browser.new_page(viewport={"width": 900, "height": 600})
    yield page
    page.close()


@pytest.mark.parametrize("kind", ["player", "character", "chart"])
def test_a_page_with_planted_html_shows_it_as_text(kind, page, tmp_path):
    path = tmp_path / "page.html"
    if kind == "player":
        clip = tk.datasets.load("procedural", styles=["Old"], gaits=["FW"], seconds=1.0)[0]
        old = clip.skeleton
        names = [f"{name}{(IMAGE, SCRIPT, COMMENT)[j % 3]}" for j, name in enumerate(old.names)]
        renamed = {role: names[old.names.index(name)] for role, name in old.roles.items()}
        ends = [names[j] for j in range(len(old)) if old.is_end(j)]
        clip = clip.replace(skeleton=Skeleton(names, old.parents, old.offsets, renamed, ends), style=IMAGE, name=SCRIPT)
        weights = {text: [1.0] * len(clip) for text in (IMAGE, SCRIPT, COMMENT)}
        tk.view.html(clip, path, title=IMAGE, caption=SCRIPT, labels=[COMMENT], styles=weights)
    elif kind == "character":
        model, bank = tk.pretrained()
        tk.view.web(model, StyleBank((IMAGE, SCRIPT, COMMENT), bank.vectors[:3]), path, title=COMMENT)
    else:
        figures.style_space([[0, 0], [1, 0], [0, 1]], [IMAGE, SCRIPT, COMMENT], [IMAGE, SCRIPT, COMMENT],
                            title=COMMENT).write_html(path)
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(path.as_uri())
    page.wait_for_function("() => document.querySelector('.main-svg text')" if kind == "chart" else "() => globalThis.view",
                           timeout=60_000)
    page.wait_for_timeout(500)
    assert not page.evaluate(HACKED)
    assert errors == []
    text = page.evaluate("() => document.body.textContent")
    assert COMMENT in text
    if kind != "chart":
        assert page.locator("canvas").count() > 0
        assert page.locator("img").count() == 0


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
