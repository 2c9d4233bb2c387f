"""Long use of a notebook: cells that make widgets run again and again, tabs are closed; what is left over in the kernel."""

import json
import math
import queue
import statistics
import time
from itertools import combinations
from typing import Annotated

import typer

from experiments.tables import Result
from toolkit.io.progress import progress_bar

SETUP = """
import asyncio, ctypes, gc, json, os, sys, threading
import toolkit as tk
from ipywidgets import Widget
from ipywidgets.widgets import widget as registry
model, bank = tk.pretrained()
clip = tk.runtime.rollout(model, tk.runtime.straight(speed=1.2, seconds=4), style=bank["Zombie"])
class Allocated(ctypes.Structure):  # what glibc's malloc says of itself
    _fields_ = [(name, ctypes.c_size_t) for name in ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks",
                                                     "uordblks", "fordblks", "keepcost")]
mallinfo2 = getattr(ctypes.CDLL(None), "mallinfo2", Allocated)
mallinfo2.restype = Allocated
def probe():
    gc.collect()
    pages, held = int(open("/proc/self/statm").read().split()[1]), mallinfo2()
    return json.dumps({"memory": pages * os.sysconf("SC_PAGE_SIZE") / 2**20, "held": (held.uordblks + held.hblkhd) / 2**20,
                       "blocks": sys.getallocatedblocks() / 1000, "tasks": len(asyncio.all_tasks()),
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
#: Forgets what IPython keeps of each cell without a limit: its result by its number, and its output.
FORGET = """
shell = get_ipython()
shell.displayhook.flush()
shell.history_manager.outputs.clear()
for name in [name for name in shell.user_ns_hidden if name.strip("_").isdigit() or not name.strip("_")]:
    del shell.user_ns_hidden[name]
"""
STEERED = {"kind": "input", "id": 1, "move": [0, 1], "turn": 0.2, "run": False, "heading": None}
PATIENCE = 600.0  # seconds for a cell, or for the kernel's start
GROWTH = 0.1  # MB a cycle, the limit after the warm-up
COLUMNS = {"cycle": ["cycle", 0], "minutes": ["minutes", 0], "memory": ["memory of the process, MB", 0],
           "held": ["of it held by C code and arrays, MB", 1], "blocks": ["Python's blocks, thousands", 0],
           "tasks": ["asyncio tasks", 0], "threads": ["threads", 0], "files": ["open files", 0], "widgets": ["widgets", 0]}


def run(
    cycles: Annotated[int, typer.Option(help="How often all cells run at most.", min=4)] = 500,
    warm_up: Annotated[int, typer.Option(help="Cycles before memory is compared.", min=1)] = 50,
    minutes: Annotated[float, typer.Option(help="Time after which it stops.")] = math.inf,
    forget: Annotated[bool, typer.Option("--forget", help="Empty what IPython keeps of each cell.")] = False,
    store: Annotated[bool, typer.Option("--store", help="Write the result that the documentation shows.")] = False,
) -> None:
    """Memory, tasks, threads, files and widgets of a kernel in which cells with widgets run again; status 1 if any grow."""
    rows = session(cycles, warm_up, minutes=minutes, forget=forget)
    for row in rows:
        print("  ".join(f"{name} {value:>6.1f}" for name, value in row.items()), flush=True)
    grown, rates = leaks(rows), {f"MB a cycle, {name}": slope(rows, name) for name in ("memory", "held")}
    print("\n".join(grown) or "nothing grows", rates)
    if store:
        name, emptied = ("long-use-forget", ", and what IPython keeps of them is emptied") if forget else ("long-use", "")
        Result(name, f"A notebook kernel whose cells with a controller, a player and a Director run again{emptied}.",
               "python -m experiments long-use [--forget] --store", COLUMNS, rows, {"limit": GROWTH}, rates).save()
    if grown:
        raise typer.Exit(1)


def session(cycles: int, warm_up: int, every: int = 50, minutes: float = math.inf,
            forget: bool = False) -> list[dict[str, float]]:
    """What `probe` says after ``warm_up`` cycles, each ``every`` cycles from then on, and at the end of ``minutes``."""
    from jupyter_client.manager import start_new_kernel

    manager, client = start_new_kernel(kernel_name="python3", startup_timeout=PATIENCE)
    try:
        page = Page(client)
        page.execute(SETUP, "setup")
        rows, start = [], time.monotonic()
        for cycle in progress_bar(range(1, cycles + 1), desc="long use", unit="cycle"):
            for name, code in CELLS.items():
                page.execute(code, name)
                page.steer(name)
            page.close(cycle % 3 == 0)
            if forget:
                page.execute(FORGET, "forget")
            passed = (time.monotonic() - start) / 60
            if (cycle >= warm_up and (cycle - warm_up) % every == 0) or passed > minutes:
                rows.append({"cycle": cycle, "minutes": passed, **json.loads(page.execute("print(probe())", "probe"))})
            if passed > minutes:
                break
        return rows
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)


def slope(rows: list[dict[str, float]], name: str) -> float:
    """How much a column grows in each cycle: the median of the slopes between all pairs of rows (Theil and Sen)."""
    return statistics.median((b[name] - a[name]) / (b["cycle"] - a["cycle"]) for a, b in combinations(rows, 2))


def leaks(rows: list[dict[str, float]]) -> list[str]:
    """What grows: a count that is higher at the end, or memory by more than `GROWTH` MB a cycle."""
    first, last = rows[0], rows[-1]
    found = [f"{name}: {first[name]:.0f} → {last[name]:.0f}" for name in ("tasks", "threads", "files", "widgets")
             if name in first and last[name] > first[name]]
    return found + [f"{name}: {slope(rows, name):.2f} MB a cycle" for name in ("memory", "held")
                    if name in first and slope(rows, name) > GROWTH]


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
