"""The exported page in a real browser: it plays from a file without a network, and bends bodies as Python does."""

import numpy as np
import pytest

import toolkit as tk
from toolkit.view import body

from .conftest import ARTEFACTS


@pytest.fixture
def page(browser):
    page = browser.new_page(viewport={"width": 1100, "height": 620})
    yield page
    page.close()


def test_the_page_plays_and_bends_as_python_does(page, tmp_path):
    clip = tk.datasets.load("procedural", styles=["Old"], gaits=["FW"], seconds=2.0)[0]
    path = tk.view.html([clip, clip.mirrored()], tmp_path / "walk.html", title="Walk")
    errors, asked = [], []
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))
    page.goto(path.as_uri())
    page.wait_for_function("() => view.state.drawn > 3")
    page.evaluate("frame => { view.play(false); view.seek(frame / 60); }", 40)
    position, normal = (np.array(page.evaluate(f"() => [...view.scenes[0].body.{kind}.array]")).reshape(-1, 3)
                        for kind in ("position", "normal"))
    points, normals = body.build(clip).skin.pose(clip.global_rotations[40], clip.global_positions[40])
    np.testing.assert_allclose(position, points, atol=1e-3)
    np.testing.assert_allclose(normal, normals, atol=0.02)

    page.wait_for_function("() => view.scenes[0].canvas.width > 1.5 * view.scenes[0].canvas.clientWidth")  # a finer still
    drawn = page.evaluate("() => view.state.drawn")
    page.wait_for_timeout(300)
    assert page.evaluate("() => view.state.drawn") == drawn  # at rest, nothing is drawn
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    page.screenshot(path=ARTEFACTS / "page.png")
    page.mouse.move(300, 300)
    page.mouse.down()
    page.mouse.move(380, 300, steps=4)
    page.mouse.up()
    page.wait_for_function(f"() => view.state.drawn > {drawn}")  # the camera goes round
    assert errors == []
    assert [url for url in asked if not url.startswith(("file:", "data:", "blob:"))] == []
