"""JupyterLab on a free port and headless Chromium; every test here is skipped where either is missing."""

import json
import os
import re
import shutil
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest

CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
FLAGS = ["--no-sandbox"]  # the default software path: forcing the GPU path onto software halves the rate
ARTEFACTS = Path(__file__).resolve().parents[2] / "out" / "browser"


@pytest.fixture(scope="session")
def browser():
    if CHROMIUM is None:
        pytest.skip("no Chromium found (make chromium)")
    sync_api = pytest.importorskip("playwright.sync_api", reason="needs Playwright: pip install playwright")
    with sync_api.sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield browser
        browser.close()


@pytest.fixture(scope="session")
def lab(tmp_path_factory):
    """Address and folder of a JupyterLab server."""
    folder = tmp_path_factory.mktemp("lab")
    (folder / "notebooks").mkdir()
    shutil.copytree(Path(__file__).parents[2] / "docs", folder / "docs")  # pictures of the notebooks
    home = tmp_path_factory.mktemp("home")
    env = os.environ | {"HOME": str(home), "OMP_NUM_THREADS": "1", "PYVISTA_OFF_SCREEN": "true", "TOOLKIT_FAST": "1"}
    log = home / "server.log"
    settings = home / ".jupyter" / "lab" / "user-settings" / "@jupyterlab" / "apputils-extension"
    settings.mkdir(parents=True)
    (settings / "notification.jupyterlab-settings").write_text('{"fetchNews": "false", "checkForUpdates": false}')
    command = [sys.executable, "-m", "jupyter", "lab", "--no-browser", "--allow-root", "--port=0",
               "--ServerApp.port_retries=0", "--IdentityProvider.token=", "--ServerApp.disable_check_xsrf=True",
               "--expose-app-in-browser", "--ServerApp.jpserver_extensions={'toolkit.view.server': True}",
               f"--ServerApp.root_dir={folder}"]
    with log.open("w") as file:
        server = subprocess.Popen(command, env=env, stdout=file, stderr=subprocess.STDOUT, cwd=folder)
    try:
        for _ in range(600):
            found = re.search(r"http://(?:localhost|127\.0\.0\.1):\d+", log.read_text())
            if found:
                break
            assert server.poll() is None, log.read_text()
            time.sleep(0.1)
        yield found[0], folder
    finally:
        server.terminate()
        server.wait(20)


class Notebook:
    """A notebook open in JupyterLab, with what its console said."""

    def __init__(self, page, address: str, folder: Path, name: str):
        self.page, self.errors = page, []
        page.on("console", lambda m: self.errors.append(m.text) if m.type == "error" else None)
        page.on("pageerror", lambda e: self.errors.append(str(e)))
        page.goto(f"{address}/lab/tree/{name}?reset", timeout=60_000)
        page.wait_for_selector(".jp-Notebook .jp-Cell", timeout=60_000)
        page.wait_for_selector('.jp-Notebook-ExecutionIndicator[data-status="idle"]', timeout=90_000)

    def run_all(self, seconds: float = 120) -> None:
        """Run every cell, once the kernel is connected, and wait for the last one; an error in a cell is raised."""
        self.page.set_default_timeout(1000 * seconds)
        failed = self.page.evaluate("""async () => {
            const { content, sessionContext } = jupyterapp.shell.currentWidget;
            await sessionContext.ready;
            await sessionContext.session.kernel.info;
            const done = await jupyterapp.commands.execute("notebook:run-all-cells");
            const outputs = content.widgets.flatMap((cell) => cell.model.outputs?.toJSON() ?? []);
            const error = outputs.find((output) => output.output_type === "error");
            return error ? `${error.ename}: ${error.evalue}\\n${error.traceback.join("\\n")}` : done ? "" : "not all ran";
        }""")
        assert not failed, failed


@pytest.fixture
def open_notebook(browser, lab, request):
    """``open_notebook(name, cells, start)``: open a notebook of code cells, which follow those of a file if one is given."""
    import nbformat

    address, folder = lab
    pages = []

    def open_(name: str, cells: list[str], start: Path | None = None) -> Notebook:
        name = name if start is None else f"notebooks/{name}"
        notebook = nbformat.v4.new_notebook() if start is None else nbformat.read(start, as_version=4)
        notebook.cells += [nbformat.v4.new_code_cell(source) for source in cells]
        notebook.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
        nbformat.write(notebook, folder / name)
        page = browser.new_page(viewport={"width": 1360, "height": 1100})
        pages.append(page)
        return Notebook(page, address, folder, name)

    yield open_
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    for i, page in enumerate(pages):
        page.screenshot(path=ARTEFACTS / f"{request.node.name}-{i}.png")
        page.close()
    with urllib.request.urlopen(f"{address}/api/kernels") as listed:
        running = json.load(listed)
    for kernel in running:
        urllib.request.urlopen(urllib.request.Request(f"{address}/api/kernels/{kernel['id']}", method="DELETE")).close()
