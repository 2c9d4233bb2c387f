"""Environment of the notebooks' kernels in tests: no window, one thread, small runs.

After the cells of a notebook, its folded solutions run in the same kernel.
"""

import itertools
import os
import re
import socket

import nbformat
import nbval.kernel
from jupyter_client.connect import LocalPortCache

for name, value in {
    "PYVISTA_OFF_SCREEN": "true",
    "PYVISTA_JUPYTER_BACKEND": "static",
    "PYVISTA_MULTI_SAMPLES": "0",
    "OMP_NUM_THREADS": "1",
    "TOOLKIT_FAST": "1",
}.items():
    os.environ.setdefault(name, value)

#: nbval formats each message for a log that nobody reads, and some have megabytes of pictures.
nbval.kernel.pformat = len

#: Ports of a test process's kernels. The system gives a free port of its own range to others again
#: before the kernel has it, and then the kernel dies.
PORTS = itertools.count(20_000 + 1_000 * int(os.environ.get("PYTEST_XDIST_WORKER", "gw0")[2:]))


def free_port(_, ip: str) -> int:
    """The next of `PORTS` where nobody answers."""
    while True:
        port = next(PORTS)
        with socket.socket() as tried:
            if tried.connect_ex((ip, port)):
                return port


LocalPortCache.find_available_port = free_port

FENCED = r"<summary>Solution</summary>\s*```python\n(.*?)\n```\s*</details>"
SOLUTION = re.compile(FENCED, re.DOTALL)


def solutions(notebook) -> list[str]:
    """Code of the folded solutions; the last line of each, which checks it, must be true."""
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "markdown"]
    texts = ["".join(cell["source"]) for cell in cells]
    found = [code for text in texts for code in SOLUTION.findall(text)]
    return [re.sub(r"(.*\Z)", r"assert \1", code, count=1) for code in found]


def pytest_collection_modifyitems(items):
    """Add the solutions of a notebook after its last cell."""
    files = {item.parent: item for item in items if item.nodeid.split("::")[0].endswith(".ipynb")}
    for file, last in files.items():
        for number, code in enumerate(solutions(file.nb), 1):
            cell = nbformat.v4.new_code_cell(code)
            place = {"cell_num": last.cell_num + number, "options": last.options.copy()}
            name = f"Solution {number}"
            made = type(last).from_parent(file, name=name, cell=cell, **place)
            items.insert(items.index(last) + number, made)
