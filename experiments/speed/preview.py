"""How long a changed shot of ten seconds takes until its whole motion is there again, in the kernel and in the page."""

import dataclasses
import os
import shutil
import statistics
import tempfile
import time
from pathlib import Path
from typing import Annotated

import typer

from experiments.speed.page import BROWSERS
from experiments.tables import Result
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.shots import Point, Preview, Shot
from toolkit.view import director

SHOT = Shot([(0, 0), (1, 4), (0, 9)], "Neutral", duration=10.0)
COLUMNS = {"model": ["model"], "where": ["where"], "best": ["elapsed, best, ms", 0], "median": ["median", 0],
           "processor": ["processor time, best, ms", 0], "middle": ["median", 0], "load": ["load of the machine", 1]}
CHANGE = """async (x) => {
    const start = performance.now();
    view.desk.change((shots) => void (shots[0].path[1].x = x));
    while (view.desk.making.some(Boolean)) await new Promise((done) => setTimeout(done));
    return performance.now() - start;
}"""


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    rounds: Annotated[int, typer.Option(min=2, help="Changes that are timed.")] = 12,
    save: Annotated[Path | None, typer.Option(help="Add the rows to the result preview in this folder.")] = None,
) -> None:
    """Milliseconds from a change to the whole motion of ten seconds: kernel (compiled), and page with its drawing.

    The processor time of the page is that of its main thread, which draws meanwhile.
    """
    net, bank = published.either(model, parameters)
    name = "embedded" if parameters is None else "published"
    rows = []
    for where, measure in (("kernel", _kernel), ("page", _page)):
        if (pairs := measure(net, bank, rounds)) is not None:
            elapsed, processor = zip(*pairs, strict=True)
            rows.append({"model": name, "where": where, "best": min(elapsed), "median": statistics.median(elapsed),
                         "processor": min(processor), "middle": statistics.median(processor), "load": os.getloadavg()[0]})
            cells = (value if isinstance(value, str) else f"{value:.4g}" for value in rows[-1].values())
            print("  ".join(f"{COLUMNS[key][0]}: {cell}" for key, cell in zip(rows[-1], cells, strict=True)))
    if save is not None:
        known = Result.load("preview", save).rows if (save / "preview.json").exists() else []
        Result("preview", "a shot of ten seconds after a move of one point, which changes it from its first frame on",
               "python -m experiments preview", COLUMNS, [*(r for r in known if r["model"] != name), *rows]).save(save)


def _kernel(net, bank, rounds: int) -> list[tuple[float, float]]:
    preview, pairs = Preview(runtime.compile(net), bank), []
    preview.render(SHOT)
    for k in range(rounds):
        shot = dataclasses.replace(SHOT, path=[SHOT.path[0], Point(1.1 + 0.1 * k, 4), SHOT.path[2]])
        began, spent = time.perf_counter(), time.process_time()
        preview.render(shot)
        pairs.append((1e3 * (time.perf_counter() - began), 1e3 * (time.process_time() - spent)))
    return pairs


def _page(net, bank, rounds: int) -> list[tuple[float, float]] | None:
    program = next(filter(None, map(shutil.which, BROWSERS)), None)
    if program is None:
        return None
    from playwright.sync_api import sync_playwright

    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        path, pairs = director.web(net, bank, Path(folder) / "director.html", [SHOT], half=True), []
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page(viewport={"width": 1280, "height": 760})
        page.set_default_timeout(600_000)
        client = page.context.new_cdp_session(page)
        client.send("Performance.enable", {"timeDomain": "threadTicks"})
        page.goto(path.as_uri())
        ready = "() => globalThis.view?.stats.drawn > 0 && !view.desk.making.some(Boolean) && view.desk.takes.every(Boolean)"
        for k in range(rounds):
            page.wait_for_function(ready)
            page.wait_for_timeout(400)
            before = _busy(client)
            pairs.append((page.evaluate(CHANGE, 1.1 + 0.1 * k), 1e3 * (_busy(client) - before)))
        browser.close()
    return pairs


def _busy(client) -> float:
    """Seconds that the page's main thread has worked."""
    return next(row["value"] for row in client.send("Performance.getMetrics")["metrics"] if row["name"] == "TaskDuration")
