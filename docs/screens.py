"""Screenshots of the Controller and the Director, in pages without a kernel."""

import contextlib
import functools
import shutil
import tempfile
from pathlib import Path

from PIL import Image

import toolkit as tk

OUT = Path(__file__).parent
STATIC = OUT.parent / "toolkit" / "view" / "static"


@contextlib.contextmanager
def opened(write, ready: str, **size):
    """A tab of Chromium (with Playwright) that shows the page of ``write(path)``, once ready."""
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium"), args=["--no-sandbox"]
        )
        tab = browser.new_page(viewport=size)
        tab.set_default_timeout(300_000)
        tab.goto(write(Path(folder) / "page.html").as_uri())
        tab.wait_for_function(ready)
        yield tab
        browser.close()


def kept(part, name: str) -> None:
    """Write a screenshot of a page, with few colours; a small one for where no kernel runs."""
    part.screenshot(path=OUT / name)
    picture = Image.open(OUT / name).convert("RGB")
    picture.quantize(192).save(OUT / name, optimize=True)
    small = picture.resize((480, 480 * picture.height // picture.width), Image.Resampling.LANCZOS)
    small.quantize(64).save(STATIC / name, optimize=True)


def controller(model, bank) -> None:
    """Write a picture of a character that is steered in a page, between two styles."""
    made = functools.partial(tk.view.web, model, bank, half=True)
    with opened(made, "() => globalThis.view?.kernel.frame > 10", width=960, height=600) as tab:
        tab.keyboard.down("w")
        box = tab.locator(".tk-triangle svg").bounding_box()
        tab.mouse.move(box["x"] + 110, box["y"] + 123)
        tab.mouse.down()
        tab.mouse.move(box["x"] + 165, box["y"] + 155, steps=8)
        tab.mouse.up()
        tab.wait_for_function("() => view.kernel.character.root[2] > 3")
        # whole pixels
        tab.evaluate("() => (view.scene.setQuality(2), view.scene.setQuality = () => {})")
        tab.wait_for_timeout(1500)
        kept(tab, "controller.png")


def director(model, bank) -> None:
    """Write a picture of the Director with three shots."""
    shot, hold = tk.shots.Shot, tk.shots.Hold
    path = [(0, 0), (1, 2), (-1, 4), (0, 6, 8.0), (-3, 7.5)]
    anna = shot(
        path,
        [(0, "Neutral"), (3, "Zombie"), (6, {"Strut": 0.5, "Old": 0.5})],
        [(0, 1.0), (4, 0.8)],
        [hold(1.5, time=8.6)],
        name="Anna",
    )
    others = [shot([(2.2, 5), (1.7, 3), (2.5, -1)], "Crouch", name="Ben"),
              shot([(-2.5, 0), (-2.2, 2.5), (-4, 5.5)], "Aeroplane", name="Cleo")]
    made = functools.partial(tk.view.director.web, model, bank, shots=[anna, *others], half=True)
    ready = "() => globalThis.view?.stats.drawn > 0 && view.desk.takes.every(Boolean)"
    with opened(made, ready, width=1280, height=760) as tab:
        tab.evaluate("() => (view.ghosts.push(2, 3), view.seek(4), view.desk.changed('look'))")
        tab.wait_for_timeout(5000)
        kept(tab, "director.png")
