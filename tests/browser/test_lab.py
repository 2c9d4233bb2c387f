"""Widgets in JupyterLab: one notebook with all of them, whose styles are named like HTML."""

import json
import re
import subprocess
import sys
import time
import urllib.request

import nbformat
import pytest

from .conftest import COMMENT, IMAGE, drag, middle

playwright = pytest.importorskip("playwright.sync_api", reason="needs Playwright")

CELLS = [
    f"""
import asyncio, json, pathlib, torch
import course
from course import style_map
import toolkit as tk
from toolkit.networks.bank import StyleBank
model, bank = tk.pretrained()
bank = bank.select(["Neutral", "Zombie", "Crouch", "Aeroplane"])
planted = StyleBank(("Neutral", "Zombie", {IMAGE!r}, {COMMENT!r}), bank.vectors)
clip = tk.datasets.procedural.generate("Old", seconds=2.0)
clip = clip.replace(style={IMAGE!r})
""",
    """
points = torch.tensor([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0], [4.0, 4.5]])
cuts = {"Neutral": clip.replace(style="Neutral"), "Zombie": clip.replace(style="Zombie")}
def make(blend):
    name = max(blend, key=blend.get)
    if name not in cuts:
        raise ValueError(name + ".bvh: cannot be read")
    return cuts[name].cut(0, 2) if blend[name] > 0.9 else clip.cut(0, 2).replace(style="between")
explorer = style_map.explore(model, planted, points=points, groups=["a", "a", "b", "b"],
                           make_clip=make, size=(160, 120))
explorer
""",
    """
player = tk.view.play([clip, clip.mirrored()], contacts=[tk.contacts.detect(clip), None],
                      labels=["<b>data</b>", "mirrored"])
player
""",
    f"""
shot = tk.shots.Shot([(0, 0), (0, 1)], "Zombie", duration=1, name={COMMENT!r})
desk = tk.view.Director(model, planted, [shot])
desk.height = 600
desk
""",
    "course.here('01')",
    """
control = None
async def probe():
    while True:
        now = {"playing": player.playing, "scene": desk.scene}
        if control:
            now |= {"root": control.state.root[0].tolist(), "weights": control.weights,
                    "frames": control.frames, "recording": control.recording}
        pathlib.Path("probe.tmp").write_text(json.dumps(now))
        pathlib.Path("probe.tmp").rename("probe.json")
        await asyncio.sleep(0.1)
probing = asyncio.create_task(probe())
""",
    """
control = tk.view.Controller(tk.runtime.compile(model), planted)
control.size = [240, 180]
control
""",
]
CONTROL = 6  # the cell of the controller
RUN = """async ([index, which]) => {
    const { content, sessionContext } = jupyterapp.shell.currentWidget;
    await sessionContext.ready;
    await sessionContext.session.kernel.info;
    content.activeCellIndex = index;
    const done = await jupyterapp.commands.execute(`notebook:run-all-${which}`);
    const outputs = content.widgets.flatMap((cell) => cell.model.outputs?.toJSON() ?? []);
    const error = outputs.find((output) => output.output_type === "error");
    return error ? `${error.ename}: ${error.evalue}` : done ? "" : "not all ran";
}"""
# The centres of elements, as soon as these have not moved for 30 frames.
AT_REST = """async (elements) => {
    for (let places, now, frames = 0; ; places = now) {
        now = elements.map((element) => {
            const { x, y, width, height } = element.getBoundingClientRect();
            return [x + width / 2, y + height / 2];
        });
        frames = String(now) === String(places) ? frames + 1 : 0;
        if (frames === 30) return now;
        await new Promise(requestAnimationFrame);
    }
}"""
# As on a busy machine: every second widget's code comes later than anywidget waits (2 s).
LATE = """const timeout = AbortSignal.timeout.bind(AbortSignal);
let widgets = 0;
AbortSignal.timeout = (ms) => timeout(ms === 2000 && widgets++ % 2 ? 0 : ms);"""


@pytest.fixture
def lab(environment, tmp_path):
    """Address of a JupyterLab server on a folder, with the extension that sends at once."""
    command = [
        sys.executable, "-m", "jupyter", "lab", "--no-browser", "--allow-root", "--port=0",
        "--ServerApp.port_retries=0", "--IdentityProvider.token=",
        "--ServerApp.disable_check_xsrf=True", "--expose-app-in-browser",
        "--ServerApp.jpserver_extensions={'course.server': True}",
        f"--ServerApp.root_dir={tmp_path}",
    ]
    log = tmp_path / "server.log"
    with log.open("w") as file:
        server = subprocess.Popen(command, env=environment, stdout=file, stderr=subprocess.STDOUT)
    try:
        for _ in range(600):
            found = re.search(r"http://(?:localhost|127\.0\.0\.1):\d+", log.read_text())
            if found:
                break
            assert server.poll() is None, log.read_text()
            time.sleep(0.1)
        yield found[0]
    finally:
        server.terminate()
        server.wait(20)


def test_widgets_in_jupyterlab(browser, lab, tmp_path):
    cells = [nbformat.v4.new_code_cell(source.strip()) for source in CELLS]
    kernel = {"name": "python3", "display_name": "Python 3", "language": "python"}
    notebook = nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": kernel})
    nbformat.write(notebook, tmp_path / "widgets.ipynb")
    errors = []
    page = browser.new_page(viewport={"width": 1200, "height": 760})
    page.add_init_script(LATE)
    page.set_default_timeout(150_000)
    page.on("console", lambda m: errors.append(m.text) if m.type == "error" else None)
    page.on("pageerror", lambda error: errors.append(str(error)))
    page.goto(f"{lab}/lab/tree/widgets.ipynb?reset")
    page.wait_for_selector('.jp-Notebook-ExecutionIndicator[data-status="idle"]')
    assert page.evaluate(RUN, [CONTROL, "above"]) == ""

    def kernel(test):
        """What the kernel says about its widgets, as soon as it passes a test."""
        deadline, path = time.monotonic() + 120, tmp_path / "probe.json"
        while not path.exists() or not test(value := json.loads(path.read_text())):
            assert time.monotonic() < deadline, value
            time.sleep(0.05)
        return value

    try:
        styles_are_picked(page)
        clips_play(page, kernel)
        shots_reach_the_kernel(page, kernel)
        # A controller takes the kernel's time, and the page's.
        assert page.evaluate(RUN, [CONTROL, "below"]) == ""
        kernel(lambda now: "root" in now)
        steered(page, kernel)
        assert page.locator(".jp-OutputArea svg[role=img]").count() > 0  # the map of the course
        # Nothing that looks like HTML ran or became an element.
        assert page.evaluate("() => typeof hacked") == "undefined"
        assert page.locator('img[src="x"]').count() == 0
        assert page.locator(".jp-OutputArea b b").count() == 0
        shown = page.locator(".jp-OutputArea-output").all_text_contents()
        assert any(IMAGE in text for text in shown)
        errors = [text for text in errors if "favicon" not in text]
        assert {"Failed to initialize" in text for text in errors} == {True}, errors
        with urllib.request.urlopen(f"{lab}/api/kernels") as listed:
            (running,) = json.load(listed)
        address = f"{lab}/api/kernels/{running['id']}/restart"
        urllib.request.urlopen(urllib.request.Request(address, method="POST")).close()
        page.wait_for_function(
            "() => document.querySelector('.tkc-alert').textContent.includes('kernel')"
        )
    finally:
        print(*errors, *page.locator(".jp-OutputArea").all_inner_texts(), sep="\n")
        page.close()


def steered(page, kernel) -> None:
    """Keys, the marker and the button that records reach the kernel; more is in test_web.py."""
    stage = page.locator(".tkc-stage")
    stage.scroll_into_view_if_needed()
    before = kernel(lambda p: p["frames"] > 10)["root"]
    page.locator(".tkc-record").click()
    kernel(lambda p: p["recording"])
    stage.focus()
    page.keyboard.down("w")
    kernel(lambda p: p["root"][1] - before[1] > 0.5)
    page.keyboard.up("w")
    triangle = page.locator(".tkc .tk-triangle svg")
    triangle.scroll_into_view_if_needed()
    drag(page, middle(triangle, 0, 17), middle(triangle, 70, 59))
    kernel(lambda p: p["weights"][1] > 0.7)
    page.locator(".tkc-record").click()
    kernel(lambda p: not p["recording"])


def styles_are_picked(page) -> None:
    """A click plays a style, a drag of the ring a blend; what a motion's maker raises is shown."""
    points = page.locator(".tk-style-map .scatterlayer .points path")
    points.first.wait_for()
    assert points.count() == 4
    page.locator(".tk-style-map").scroll_into_view_if_needed()
    where = page.evaluate(AT_REST, points.element_handles())
    hover = "document.querySelector('.tk-style-map .hoverlayer').textContent"
    page.mouse.move(where[1][0] - 9, where[1][1])
    page.mouse.move(*where[1])
    page.wait_for_function(f"() => {hover}.includes('Zombie')")
    page.mouse.click(*where[1])
    page.locator(".tkv-label", has_text="Zombie").first.wait_for()
    ring, *where = page.evaluate(AT_REST, [
        page.query_selector(".tk-style-map > div:nth-child(2)"), *points.element_handles()])
    assert ring == pytest.approx(where[1], abs=2)
    drag(page, where[1], ((where[0][0] + where[1][0]) / 2, where[0][1]))
    page.locator(".tkv-label", has_text="between").first.wait_for()
    page.mouse.click(*where[2])
    page.get_by_text("cannot be read").first.wait_for()


def clips_play(page, kernel) -> None:
    """The player plays and stops, and the kernel knows; its picture takes the still's place."""
    cell = page.locator(".jp-Cell").nth(2)
    cell.locator(".tkv-view").first.scroll_into_view_if_needed()
    assert cell.locator(".tkv-label").all_text_contents() == ["<b>data</b>", "mirrored"]
    button, clock = cell.locator(".tkv-play"), cell.locator(".tkv-clock")
    before = clock.text_content()
    button.click()
    kernel(lambda p: p["playing"])
    page.wait_for_function("([it, before]) => it.textContent !== before",
                           arg=[clock.element_handle(), before])
    button.click()
    kernel(lambda p: not p["playing"])
    assert page.locator(".tk-still").count() > 0
    assert page.locator(".tk-still:visible").count() == 0


def shots_reach_the_kernel(page, kernel) -> None:
    """A point is dragged on the Director's map; undo reaches the Director, not the notebook."""
    page.wait_for_selector(".tkd-map circle")
    page.locator(".tkd").scroll_into_view_if_needed()
    point = page.locator(".tkd-map circle").nth(1)
    drag(page, middle(point), middle(point, -50))
    kernel(lambda p: p["scene"]["shots"][0]["path"][1] not in ([0, 1], {"x": 0, "z": 1}))
    page.keyboard.press("Control+z")
    view = "document.querySelector('.tkd').parentElement.toolkit"
    assert page.evaluate(f"() => {view}.desk.shot.path[1].x") == 0
