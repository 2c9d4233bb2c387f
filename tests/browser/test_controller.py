"""The live controller in a real browser: keys move the character, the marker changes the style, nothing is left running."""

import json
import time
from pathlib import Path

import pytest

from .conftest import ARTEFACTS

NOTEBOOK = Path(__file__).resolve().parents[2] / "notebooks" / "04_blending.ipynb"
DRAWN = "() => document.querySelector('.tkc').parentElement.toolkit.stats.drawn"

START = """
import json, toolkit as tk
model, bank = tk.pretrained()
control = tk.view.Controller(model, bank, styles=("Neutral", "Zombie", "Aeroplane"))
control
"""
PROBE = """
import asyncio, pathlib
async def probe():
    while True:
        now = {"root": control.state.root[0].tolist(), "weights": control.weights, "frames": control.frames,
               "recording": control.recording, "status": control.status}
        pathlib.Path("probe.tmp").write_text(json.dumps(now)); pathlib.Path("probe.tmp").rename("probe.json")
        await asyncio.sleep(0.1)
probing = asyncio.create_task(probe())
"""


@pytest.fixture
def probe(lab):
    """What the kernel says about the character, ten times a second."""
    path = lab[1] / "probe.json"
    path.unlink(missing_ok=True)
    return lambda: json.loads(path.read_text()) if path.exists() else {}


def wait_for(get, test, seconds=30):
    deadline = time.monotonic() + seconds
    while not (value := get()) or not test(value):
        assert time.monotonic() < deadline, f"still {value}"
        time.sleep(0.05)
    return value


def test_keys_move_and_the_marker_blends(open_notebook, probe):
    notebook = open_notebook("steer.ipynb", [START, PROBE])
    page = notebook.page
    notebook.run_all()
    stage = page.locator(".tkc-stage")
    stage.scroll_into_view_if_needed()
    before = wait_for(probe, lambda p: p["frames"] > 30)["root"]
    page.locator(".tkc-record").click()
    wait_for(probe, lambda p: p["recording"])
    stage.focus()
    page.keyboard.down("w")
    walked = wait_for(probe, lambda p: p["root"][1] - before[1] > 1.0)["root"]
    page.keyboard.down("q")
    turned = wait_for(probe, lambda p: p["root"][2] > 0.5)["root"]
    page.keyboard.up("q")
    page.keyboard.up("w")
    assert turned[0] > walked[0]  # Q turns left, which is +x

    box = page.locator(".tk-triangle svg").bounding_box()
    page.mouse.move(box["x"] + 110, box["y"] + 123)
    page.mouse.down()
    page.mouse.move(box["x"] + 180, box["y"] + 165, steps=8)
    page.mouse.up()
    blended = wait_for(probe, lambda p: p["weights"][1] > 0.7)
    assert sum(blended["weights"]) == pytest.approx(1)

    here = probe()["root"]
    stick = page.locator(".tkc-stick").bounding_box()
    page.mouse.move(stick["x"] + 48, stick["y"] + 48)
    page.mouse.down()
    page.mouse.move(stick["x"] + 48, stick["y"] + 4, steps=4)
    wait_for(probe, lambda p: (p["root"][0] - here[0]) ** 2 + (p["root"][1] - here[1]) ** 2 > 0.25)
    page.mouse.up()

    page.locator(".tkc-record").click()
    wait_for(probe, lambda p: not p["recording"])
    wait_for(lambda: page.evaluate(DRAWN), lambda drawn: drawn > 60)
    page.evaluate("() => document.querySelector('.tkc').parentElement.toolkit.scene.setQuality(2)")  # whole pixels
    page.wait_for_timeout(200)
    page.locator(".tkc").screenshot(path=ARTEFACTS / "controller.png")
    assert notebook.errors == []


def test_the_playback_notebook_is_steered(open_notebook, probe):
    notebook = open_notebook("showpiece.ipynb", ["import json\n" + PROBE.replace('("probe', '("../probe')], start=NOTEBOOK)
    page = notebook.page
    notebook.run_all(400)
    stage = page.locator(".tkc-stage")
    stage.scroll_into_view_if_needed()
    before = wait_for(probe, lambda p: p["frames"] > 30)
    stage.focus()
    page.keyboard.down("w")
    wait_for(probe, lambda p: (p["root"][0] - before["root"][0]) ** 2 + (p["root"][1] - before["root"][1]) ** 2 > 1)
    page.keyboard.up("w")
    box = page.locator(".tkc .tk-triangle svg").bounding_box()
    page.mouse.click(box["x"] + 190, box["y"] + 168)
    wait_for(probe, lambda p: p["weights"] != before["weights"])
    assert notebook.errors == []


def test_it_waits_when_nobody_looks_and_comes_back(open_notebook, probe):
    notebook = open_notebook("away.ipynb", [START, PROBE])
    notebook.run_all()
    wait_for(probe, lambda p: p["frames"] > 30)
    notebook.page.get_by_role("menuitem", name="Edit", exact=True).click()
    notebook.page.get_by_text("Clear Outputs of All Cells", exact=True).click()
    wait_for(probe, still(probe))
    notebook.run_all()  # a re-run cell
    wait_for(probe, lambda p: p["frames"] < 300)
    wait_for(probe, lambda p: p["frames"] > 30)
    notebook.page.goto("about:blank")  # a closed tab
    wait_for(probe, still(probe))
    assert not probe()["status"]
    assert notebook.errors == []


def still(probe, seconds=1.0):
    """Whether the kernel computes no frame for a while."""

    def test(first):
        time.sleep(seconds)
        return probe()["frames"] == first["frames"]

    return test


def test_a_restarted_kernel_and_two_controllers(open_notebook, probe):
    notebook = open_notebook("restart.ipynb", [START, PROBE, "other = tk.view.Controller(model, bank)\nother"])
    page = notebook.page
    notebook.run_all()
    wait_for(probe, lambda p: p["frames"] > 30)
    assert page.locator(".tkc").count() == 2
    page.get_by_role("menuitem", name="Kernel", exact=True).click()
    page.get_by_text("Restart Kernel…", exact=True).click()
    page.get_by_role("button", name="Confirm Kernel Restart").click()
    alerts = "[...document.querySelectorAll('.tkc-alert')]"
    page.wait_for_function(f"() => {alerts}.every((alert) => alert.textContent.includes('kernel'))")
    notebook.run_all()
    wait_for(probe, lambda p: 30 < p["frames"] < 10_000)
    assert not [error for error in notebook.errors if "Disposed" not in error and "Canceled" not in error]


def test_a_model_without_local_phases_has_no_dials(open_notebook):
    notebook = open_notebook("dials.ipynb", [START.replace("control = ", """
pack = tk.view.Controller.send  # as of a model with one phase for the whole body
tk.view.Controller.send = lambda self, content, buffers=None: pack(self, content, buffers and [buffers[0][:-28]])
control = """), "control._task"])
    page = notebook.page
    notebook.run_all()
    wait_for(lambda: page.evaluate(DRAWN), lambda drawn: drawn > 20)
    assert page.locator(".tkc-dials").is_hidden()
    assert page.get_by_role("button", name="Phases").is_hidden()
    assert page.get_by_role("button", name="Contacts").is_visible()
    assert notebook.errors == []


def test_rates_in_the_page_are_measured(open_notebook, probe):
    """Prints what the page receives, draws and how soon a key shows (``-s`` shows it): rates are facts, not conditions."""
    notebook = open_notebook("rates.ipynb", [START, PROBE.replace("0.1)", "0.5)")])
    page = notebook.page
    notebook.run_all()
    wait_for(probe, lambda p: p["frames"] > 60)
    page.locator(".tkc-stage").focus()
    stats = "document.querySelector('.tkc').parentElement.toolkit.stats"
    read = f"() => ({{...{stats}, at: performance.now()}})"
    canvas = page.locator(".tkc-stage canvas").bounding_box()
    assert (canvas["width"], canvas["height"]) == (640, 480)
    quiet = [page.evaluate(read)]
    page.wait_for_timeout(5000)
    quiet.append(page.evaluate(read))
    for i in range(24):
        (page.keyboard.up if i % 2 else page.keyboard.down)("w")
        page.wait_for_timeout(310)
    busy = page.evaluate(read)
    rates = {}
    for name, (a, b) in {"quiet": quiet, "keys": (quiet[1], busy)}.items():
        rates[name] = {kind: 1000 * (b[kind] - a[kind]) / (b["at"] - a["at"]) for kind in ("received", "drawn")}
    delays = sorted(busy["delays"])
    rates["key to picture, ms"] = {"median": delays[len(delays) // 2], "worst": delays[-1], "n": len(delays)}
    print("\n", json.dumps(rates, indent=1))
    (ARTEFACTS / "rates.json").write_text(json.dumps(rates, indent=1))
    assert rates["keys"]["received"] > 5
    assert rates["keys"]["drawn"] > 5
    assert len(delays) >= 20
