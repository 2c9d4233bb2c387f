"""Playback in a real browser: pictures arrive at a steady rate, and sliders and switches change them."""

import json

from .conftest import ARTEFACTS

START = """
import toolkit as tk
clip = tk.datasets.load("procedural", styles=["Neutral"], gaits=["FW"], seconds=4.0)[0]
player = tk.view.play([clip, clip.mirrored()], labels=["data", "mirrored"], contacts=[tk.contacts.detect(clip), None],
                      playing=True)
player
"""
COUNT = """async (seconds) => {
    const screen = document.querySelector('.tk-screen');
    let count = 0;
    const watch = () => count++;
    screen.addEventListener('load', watch);
    await new Promise((done) => setTimeout(done, 1000 * seconds));
    screen.removeEventListener('load', watch);
    return count / seconds;
}"""
WAIT = """async ([selector, times]) => {
    const screen = document.querySelector('.tk-screen'), handles = document.querySelectorAll(selector), waits = [];
    for (let k = 0; k < times; k++) {
        await new Promise((done) => setTimeout(done, 60));
        const start = performance.now();
        const drawn = new Promise((done) => screen.addEventListener('load', done, { once: true }));
        handles[1].dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowRight', bubbles: true }));
        await drawn;
        waits.push(performance.now() - start);
    }
    return waits.sort((a, b) => a - b);
}"""


def test_pictures_arrive_and_follow_the_slider(open_notebook):
    notebook = open_notebook("play.ipynb", [START])
    page = notebook.page
    notebook.run_all()
    page.locator(".tk-screen").scroll_into_view_if_needed()
    rate = page.evaluate(COUNT, 3)
    assert rate > 1
    page.locator("button[title='Play or pause']").click()
    page.wait_for_timeout(1500)  # the last picture is drawn once more, finely
    assert page.evaluate(COUNT, 0.5) == 0
    waits = page.evaluate(WAIT, [".noUi-handle", 20])
    assert waits[10] > 0
    before = page.locator(".tk-screen").screenshot()
    page.get_by_role("button", name="Trajectory").click()
    page.wait_for_timeout(500)
    assert page.locator(".tk-screen").screenshot() != before
    measured = {"pictures_per_second": rate, "slider_to_picture_ms": {"median": waits[10], "95 %": waits[18]}}
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    (ARTEFACTS / "player.json").write_text(json.dumps(measured, indent=1))
    assert not [error for error in notebook.errors if "favicon" not in error]
