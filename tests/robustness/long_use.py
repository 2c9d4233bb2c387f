"""Long use of a notebook: cells that make widgets run again and again, tabs are closed; what is left over in the kernel."""

import json
import queue
import statistics
import time
from itertools import pairwise
from typing import Annotated

import typer

SETUP = """
import asyncio, gc, json, os, threading
import toolkit as tk
from ipywidgets import Widget
from ipywidgets.widgets import widget as registry
model, bank = tk.pretrained()
clip = tk.runtime.rollout(model, tk.runtime.straight(speed=1.2, seconds=4), style=bank["Zombie"])
def probe():
    gc.collect()
    pages = int(open("/proc/self/statm").read().split()[1])
    return json.dumps({"memory": pages * os.sysconf("SC_PAGE_SIZE") / 2**20, "tasks": len(asyncio.all_tasks()),
                       "threads": threading.active_count(), "files": len(os.listdir("/proc/self/fd")),
                       "widgets": len(registry._instances)})
"""
#: The cells of the notebook, by their identity in JupyterLab; each ends with the widget that it shows.
CELLS = {
    "controller": "control = tk.view.Controller(model, bank)\ncontrol.recording = True\ncontrol",
    "player": "tk.view.play(clip, playing=True)",
    "director": "tk.view.Director(model, bank)",
    "walk": "control.advance(30); len(control.clip)",
}
STEERED = {"kind": "input", "id": 1, "move": [0, 1], "turn": 0.2, "run": False, "heading": None}
PATIENCE = 120.0  # seconds for a cell
GROWTH = 0.1  # MB a cycle, the limit of the median after the warm-up


def run(
    cycles: Annotated[int, typer.Option(help="How often all cells run.", min=4)] = 300,
    warm_up: Annotated[int, typer.Option(help="Cycles before memory is compared.", min=1)] = 50,
) -> None:
    """Memory, tasks, threads, files and widgets of a kernel in which cells with widgets run again; status 1 if any grow."""
    rows = session(cycles, warm_up)
    for cycle, row in rows:
        print(f"{cycle:>6}  " + "  ".join(f"{name} {value:>7.1f}" for name, value in row.items()))
    grown = leaks(rows)
    print("\n".join(grown) or "nothing grows")
    if grown:
        raise typer.Exit(1)


def session(cycles: int, warm_up: int, every: int = 10) -> list[tuple[int, dict[str, float]]]:
    """What `probe` says after ``warm_up`` cycles and each ``every`` cycles from then on."""
    from jupyter_client.manager import start_new_kernel

    manager, client = start_new_kernel(kernel_name="python3")
    try:
        page = Page(client)
        page.execute(SETUP, "setup")
        rows = []
        for cycle in range(1, cycles + 1):
            for name, code in CELLS.items():
                page.execute(code, name)
                page.steer(name)
            page.close(cycle % 3 == 0)
            if cycle >= warm_up and (cycle - warm_up) % every == 0:
                rows.append((cycle, json.loads(page.execute("print(probe())", "probe"))))
        return rows
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def leaks(rows: list[tuple[int, dict[str, float]]]) -> list[str]:
    """What grows: a count that is higher at the end, or memory whose median slope is above `GROWTH` MB a cycle."""
    (_, first), (_, last) = rows[0], rows[-1]
    counts = [name for name in first if name != "memory" and last[name] > first[name]]
    found = [f"{name}: {first[name]:.0f} → {last[name]:.0f}" for name in counts]
    slopes = [(b["memory"] - a["memory"]) / (m - n) for (n, a), (m, b) in pairwise(rows)]
    if (slope := statistics.median(slopes)) > GROWTH:
        found.append(f"memory: {slope:.2f} MB a cycle")
    return found


class Page:
    """The browser's side of the notebook: runs cells, answers widgets, closes tabs."""

    def __init__(self, client):
        self.client, self.opened = client, []

    def execute(self, code: str, cell: str) -> str:
        """Run a cell; its printed text. RuntimeError with its traceback if it fails."""
        message = self.client.session.msg("execute_request", {"code": code, "silent": False, "store_history": True,
                                                              "user_expressions": {}, "allow_stdin": False},
                                          metadata={"cellId": cell})
        self.client.shell_channel.send(message)
        asked, text, until = message["header"]["msg_id"], "", time.monotonic() + PATIENCE
        while time.monotonic() < until:
            try:
                reply = self.client.get_iopub_msg(timeout=1.0)
            except queue.Empty:
                continue
            kind, content = reply["msg_type"], reply["content"]
            if kind == "comm_open":
                self.opened.append((cell, content["comm_id"], content["data"].get("state", {}).get("_anywidget_id", "")))
            elif kind == "error":
                raise RuntimeError("\n".join(content["traceback"]))
            elif kind == "stream":
                text += content["text"]
            elif kind == "status" and content["execution_state"] == "idle" and reply["parent_header"]["msg_id"] == asked:
                return text
        raise RuntimeError(f"the cell {cell} took more than {PATIENCE:g} s")

    def steer(self, cell: str) -> None:
        """Answer the widgets of a cell, as a page does that shows them."""
        for own, comm, _ in self.opened[-20:]:
            if own == cell == "controller":
                self._send("comm_msg", comm, {"method": "custom", "content": STEERED})

    def close(self, tab: bool) -> None:
        """The views go; with the whole tab, the comms are closed as well."""
        for cell, comm, _ in self.opened:
            if cell == "controller":
                self._send("comm_msg", comm, {"method": "custom", "content": {"kind": "closed"}})
            if tab:
                self._send("comm_close", comm, {})
        self.opened = []

    def _send(self, kind: str, comm: str, data: dict) -> None:
        self.client.shell_channel.send(self.client.session.msg(kind, {"comm_id": comm, "data": data}))
