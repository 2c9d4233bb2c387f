"""A character of one's own in a real browser: it walks, and its vertices are where Python puts them."""

import numpy as np
import pytest
from posed_rigs import rig, with_twists

import toolkit as tk
from toolkit.motion import retargeting
from toolkit.view import page as pages
from toolkit.view.character import Character

from .conftest import ARTEFACTS


@pytest.fixture(scope="module")
def hero(tmp_path_factory):
    path = tmp_path_factory.mktemp("hero") / "hero.glb"
    tk.export.gltf.save(rig("along y", arms=1.1, legs=0.85, hips=1.1, joints=with_twists), path)
    return Character.load(path)


@pytest.fixture(scope="module")
def walk():
    return tk.datasets.load("procedural", styles=["Zombie"], gaits=["FW"], seconds=3.0)[0]


@pytest.fixture
def page(browser):
    page = browser.new_page(viewport={"width": 900, "height": 600})
    errors = []
    page.on("pageerror", lambda error: errors.append(str(error)))
    yield page
    page.close()
    assert errors == []


def vertices(page, body: str) -> np.ndarray:
    return np.array(page.evaluate(f"() => [...{body}.position.array]")).reshape(-1, 3)


def test_a_page_shows_the_character_walking(page, tmp_path, hero, walk):
    path = tk.view.html([walk], tmp_path / "walk.html", title="Hero", character=hero)
    page.goto(path.as_uri())
    page.wait_for_function("() => view.state.drawn > 3")
    page.evaluate("frame => { view.play(false); view.seek(frame / 60); }", 100)
    made = hero.fitted(walk)
    expected = hero.skin.pose(made.global_rotations[100], made.global_positions[100])[0]
    np.testing.assert_allclose(vertices(page, "view.scenes[0].body"), expected, atol=2e-3)  # 16-bit rotations, 8-bit weights
    page.wait_for_function("() => view.scenes[0].canvas.width > 1.5 * view.scenes[0].canvas.clientWidth")
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    page.screenshot(path=ARTEFACTS / "character.png")


def test_it_follows_another_skeleton_as_retargeting_does(page, tmp_path, hero, walk):
    """The live scene turns the joints itself; compared with Python's retargeting without foot IK."""
    data = {"skeleton": pages.skeleton_data(walk, hero)}
    start = "globalThis.scene = new toolkitScene.Scene(stage, data.skeleton);"
    path = pages.write(tmp_path / "live.html", "Hero", "", data, start)
    page.goto(path.as_uri())
    made = retargeting.retarget(walk, hero.rest, feet=False)
    lift = None
    for frame in (0, 60, 150):
        page.evaluate("([root, rotations]) => scene.body.pose(root, Float32Array.from(rotations))",
                      [walk.root_positions[frame].tolist(), walk.rotations[frame].flatten().tolist()])
        seen = vertices(page, "scene.body")
        expected = hero.skin.pose(made.global_rotations[frame], made.global_positions[frame])[0]
        lift = float((seen - expected)[:, 1].mean()) if lift is None else lift  # the soles' height over the floor
        np.testing.assert_allclose(seen, expected + np.array([0.0, lift, 0.0]), atol=2e-3)
    assert abs(lift) < 0.1


def test_it_walks_under_control(page, tmp_path, hero):
    model, bank = tk.pretrained()
    styles = ["Neutral", "Zombie", "Old"]
    path = tk.view.web(model, bank, tmp_path / "control.html", styles=styles, half=True, character=hero)
    page.goto(path.as_uri())
    page.wait_for_timeout(1000)
    page.keyboard.down("w")
    page.wait_for_timeout(2500)
    root = page.evaluate("() => [...view.kernel.character.root]")
    assert np.hypot(root[0], root[2]) > 0.5
    page.screenshot(path=ARTEFACTS / "character_control.png")
