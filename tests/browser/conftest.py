"""Headless Chromium, one for a session; every test here is skipped where it is missing."""

import contextlib
import json
import os
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))),
                None)
FLAGS = ["--no-sandbox"]  # the default software path: the GPU path on software halves the rate
SIZES = {"desk": {"width": 1280, "height": 760}, "phone": {"width": 390, "height": 844}}
ROOT = Path(__file__).resolve().parents[2]
IMAGE, SCRIPT, COMMENT = PLANTED = (
    "<img src=x onerror=hacked=1>", "</script><script>hacked=1</script>", "<!--<script>")


@pytest.fixture(scope="package")  # while it is open, no other test can run an event loop
def browser():
    if CHROMIUM is None:
        pytest.skip("no Chromium found (make chromium)")
    sync_api = pytest.importorskip("playwright.sync_api", reason="needs Playwright")
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield browser
        browser.close()


@contextlib.contextmanager
def visits(browser) -> Iterator[Callable]:
    """``visit(path, size)``: a page of a file, on a desk or on a phone that is touched.

    What it logged as an error or asked of a server fails the test at its end.
    """
    contexts, wrong = [], []

    def open_(path: Path, size: str = "desk"):
        phone = size == "phone"
        context = browser.new_context(viewport=SIZES[size], has_touch=phone, is_mobile=phone)
        contexts.append(context)
        page = context.new_page()
        page.on("console", lambda m: wrong.append(m.text) if m.type == "error" else None)
        page.on("pageerror", lambda error: wrong.append(str(error)))
        page.on("request", lambda r: wrong.append(r.url) if r.url.startswith("http") else None)
        page.goto(path.as_uri())
        return page

    yield open_
    for context in contexts:
        context.close()
    assert wrong == []


@pytest.fixture
def visit(browser):
    with visits(browser) as open_:
        yield open_


def shows_as_text(page) -> None:
    """What is named like HTML did not run and became no element."""
    for frame in page.frames:
        assert frame.evaluate("() => typeof hacked") == "undefined"
        assert frame.locator('img[src="x"]').count() == 0
    assert COMMENT in page.evaluate("() => document.body.textContent")


def drag(page, *points: tuple[float, float]) -> None:
    """The mouse goes along these points with its button down."""
    page.mouse.move(*points[0])
    page.mouse.down()
    for point in points[1:]:
        page.mouse.move(*point, steps=4)
    page.mouse.up()


def middle(element, dx: float = 0.0, dy: float = 0.0) -> tuple[float, float]:
    """A place of the screen, so far from the middle of an element."""
    box = element.bounding_box()
    return box["x"] + box["width"] / 2 + dx, box["y"] + box["height"] / 2 + dy


def touches(page):
    """``send(kind, *points)``: what a finger does."""
    session = page.context.new_cdp_session(page)

    def send(kind: str, *points: tuple[float, float]) -> None:
        points = [{"x": x, "y": y} for x, y in points]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    return send


@pytest.fixture(scope="session")
def pages(tmp_path_factory) -> Path:
    """A folder for pages that several tests open."""
    return tmp_path_factory.mktemp("pages")


@pytest.fixture(scope="session")
def environment(tmp_path_factory) -> dict[str, str]:
    """Variables of a Jupyter server in a home of its own."""
    home = tmp_path_factory.mktemp("home")
    settings = {  # all cells are attached, seen or not: a busy machine attaches others late
        "apputils-extension/notification": {"fetchNews": "false", "checkForUpdates": False},
        "notebook-extension/tracker": {"windowingMode": "none"},
    }
    for name, values in settings.items():
        file = home / f".jupyter/lab/user-settings/@jupyterlab/{name}.jupyterlab-settings"
        file.parent.mkdir(parents=True)
        file.write_text(json.dumps(values))
    paths = f"{ROOT}{os.pathsep}{ROOT / 'notebooks'}"
    return os.environ | {
        "HOME": str(home),
        "OMP_NUM_THREADS": "1",
        "PYVISTA_OFF_SCREEN": "true",
        "TOOLKIT_FAST": "1",
        "PYTHONPATH": paths,
    }
