"""Environment of the notebooks' kernels in tests: no window, one thread, small runs.

After the cells of a notebook, its folded solutions run in the same kernel. Each notebook has a
kernel of its own. On Linux this is the fork of a process that has imported `LARGE`, which every
kernel would import again for seconds. Started as a script, this file is that process.
"""

import importlib
import json
import os
import re
import signal
import subprocess
import sys
from functools import cache

import nbformat

for name, value in {
    "PYVISTA_OFF_SCREEN": "true",
    "PYVISTA_JUPYTER_BACKEND": "static",
    "PYVISTA_MULTI_SAMPLES": "0",
    "OMP_NUM_THREADS": "1",
    "TOOLKIT_FAST": "1",
}.items():
    os.environ.setdefault(name, value)
#: Packages that most notebooks import, directly or through the toolkit.
LARGE = ("ipykernel.kernelapp", "numba", "pandas", "plotly.graph_objects", "scipy.signal",
         "scipy.stats", "torch._dynamo")

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


class Kernel:
    """A kernel's process, with the methods of `subprocess.Popen` that Jupyter calls."""

    stdin = stdout = stderr = None

    def __init__(self, command, cwd, env, **_):
        server = forks()
        order = {"arguments": command[command.index("-f"):], "folder": cwd, "environment": env}
        server.stdin.write(json.dumps(order) + "\n")
        server.stdin.flush()
        self.pid = int(server.stdout.readline())

    def poll(self):
        try:
            os.kill(self.pid, 0)
        except ProcessLookupError:
            return 0
        return None

    wait = poll

    def send_signal(self, number):
        os.kill(self.pid, number)


@cache
def forks() -> subprocess.Popen:
    """The process that forks kernels; it ends with this one, when its input is closed."""
    return subprocess.Popen([sys.executable, "-P", __file__], stdin=subprocess.PIPE,
                            stdout=subprocess.PIPE, text=True)


def pytest_unconfigure():
    if forks.cache_info().currsize:
        forks().communicate()


def serve():
    """Fork a kernel for each line of the input, and print its process id."""
    for name in LARGE:
        importlib.import_module(name)
    signal.signal(signal.SIGCHLD, lambda *_: os.waitpid(-1, os.WNOHANG))
    for line in sys.stdin:
        pid = os.fork()
        if pid == 0:
            signal.signal(signal.SIGCHLD, signal.SIG_DFL)
            kernel(**json.loads(line))
        os.setpgid(pid, pid)  # Jupyter sends signals to the group
        print(pid, flush=True)


def kernel(arguments, folder, environment):
    """Become a kernel, without the server's input and output."""
    os.chdir(folder)
    os.environ.update(environment, JPY_PARENT_PID=str(os.getppid()))
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in range(3):
        os.dup2(nowhere, stream)
    from ipykernel import kernelapp

    kernelapp.launch_new_instance(arguments)
    sys.exit()


if __name__ == "__main__":
    serve()
elif sys.platform == "linux":
    from jupyter_client.provisioning import local_provisioner

    local_provisioner.launch_kernel = Kernel
