"""Memory of a kernel in which somebody runs the cells of a notebook again and again."""

import tempfile
import time
from typing import Annotated

import numpy as np
import scipy.stats
import typer
from jupyter_client.manager import KernelManager
from tqdm import tqdm

from experiments.tables import Result, Store

BEGIN = """
import psutil
import toolkit as tk
trained, clip = tk.pretrained(), tk.datasets.procedural.generate("Zombie", seconds=5.0)
"""
CELLS = {  # each makes a widget, and closes the one of its last run
    "play": "tk.view.play(clip)",
    "steer": """
controller = tk.view.Controller(*trained)
controller.recording = True
controller.steer(1.0)
controller.advance(120)
controller""",
    "plan": "tk.view.Director(*trained)",
}
RESIDENT = "psutil.Process().memory_info().rss / 1e6"
COLUMNS = {"cycles": ["cycles of three cells", 0], "minutes": ["minutes", 0],
           "first": ["MB after a tenth", 0], "last": ["MB at the end", 0],
           "growth": ["MB a cycle, last half", 3], "least": ["least (95 %)", 3],
           "most": ["most (95 %)", 3]}


def run(
    hours: Annotated[float, typer.Option(min=0.0, help="Duration.")] = 2.0, store: Store = False
) -> None:
    """Memory that a notebook's kernel takes while cells with a Player, a Controller and a Director
    run again for hours.
    """
    folder = tempfile.TemporaryDirectory()
    manager = KernelManager(transport="ipc", ip=f"{folder.name}/kernel")
    manager.start_kernel()
    client = manager.blocking_client()
    client.start_channels()
    try:
        client.wait_for_ready()
        _execute(client, "begin", BEGIN)
        began, megabytes = time.monotonic(), []
        with tqdm(desc="cycles", disable=None) as bar:
            while time.monotonic() < began + 3600 * hours:
                for cell, code in CELLS.items():
                    found = _execute(client, cell, code)
                megabytes.append(found)
                bar.update()
    finally:
        client.stop_channels()
        manager.shutdown_kernel(now=True)
        folder.cleanup()
    if len(megabytes) < 4:
        raise ValueError(f"{hours:g} hours are too short for four cycles: got {len(megabytes)}")
    half = megabytes[len(megabytes) // 2:]
    slope, _, least, most = scipy.stats.theilslopes(half)
    row = {"cycles": len(megabytes), "minutes": (time.monotonic() - began) / 60,
           "first": megabytes[len(megabytes) // 10], "last": float(np.median(half[-20:])),
           "growth": slope, "least": least, "most": most}
    Result("memory", "Resident memory of a kernel without a page; Theil-Sen slope.",
           "python -m experiments memory --store", COLUMNS, [row],
           numbers={"megabytes": np.round(megabytes[::20]).tolist()}).show(store)


def _execute(client, cell: str, code: str) -> float:
    """Run a cell as JupyterLab does; returns the kernel's resident memory in megabytes."""
    content = {"code": code, "silent": False, "store_history": True, "allow_stdin": False,
               "stop_on_error": True, "user_expressions": {"resident": RESIDENT}}
    message = client.session.msg("execute_request", content, metadata={"cellId": cell})
    client.shell_channel.send(message)
    while (reply := client.get_shell_msg(timeout=300))["parent_header"].get("msg_id") != \
            message["header"]["msg_id"]:
        pass
    while client.iopub_channel.msg_ready():
        client.get_iopub_msg()
    if reply["content"]["status"] != "ok":
        raise ValueError(f"cell {cell!r}: {reply['content']['evalue']}")
    return float(reply["content"]["user_expressions"]["resident"]["data"]["text/plain"])
