"""Kernels of the notebooks' tests, forked from one process that is `preloaded`."""

import multiprocessing
import os
import signal
import sys

from jupyter_client.launcher import launch_kernel

FORKS = multiprocessing.get_context("forkserver")
FORKS.set_forkserver_preload(["tests.preloaded"])


def launch(command: list[str], **settings):
    """As `launch_kernel`, which starts kernels of other environments and languages."""
    own = command[:3] == [sys.executable, "-m", "ipykernel_launcher"]
    return (Process if own else launch_kernel)(command, **settings)


class Process:
    """A new kernel, with what `jupyter_client` uses of a `subprocess.Popen`."""

    stdin = stdout = stderr = None

    def __init__(self, command: list[str], env: dict[str, str], cwd: str, **_) -> None:
        here, there = FORKS.Pipe(duplex=False)
        self.child = FORKS.Process(target=run, args=(command, env, cwd, there), daemon=True)
        self.child.start()
        there.close()
        here.recv()  # an EOFError says that the child has failed
        self.pid = self.child.pid

    def poll(self) -> int | None:
        return self.child.exitcode

    def wait(self) -> int | None:
        self.child.join()
        return self.child.exitcode

    def send_signal(self, number: int) -> None:
        os.kill(self.pid, number)

    def terminate(self) -> None:
        self.send_signal(signal.SIGTERM)

    def kill(self) -> None:
        self.send_signal(signal.SIGKILL)


def run(command: list[str], env: dict[str, str], folder: str, ready) -> None:
    """``python -m ipykernel_launcher …`` in this process."""
    from ipykernel.kernelapp import IPKernelApp

    os.setsid()  # a signal to its group reaches no test
    os.environ.update(env)
    os.chdir(folder)
    sys.path.insert(0, "")
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    ready.send(None)
    IPKernelApp.launch_instance(argv=command[3:])
