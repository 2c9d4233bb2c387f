"""Workers that compute a store: processes of this machine or of a Dask cluster."""

import contextlib
import signal
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from typing import Any

import torch


@contextlib.contextmanager
def executor(workers: int | None, scheduler: str | None) -> Iterator[Executor]:
    """An executor of a Dask scheduler's workers or of ``workers`` processes here (1: this one)."""
    if scheduler:
        try:
            from dask.distributed import Client
        except ImportError:
            raise ValueError('a scheduler needs Dask: pip install ".[scale]"') from None
        with Client(scheduler) as client:
            yield client.get_executor(pure=False)
    elif workers == 1:
        with ThreadPoolExecutor(1) as pool:
            yield pool
    else:
        # Ctrl-C reaches every process: this one handles it, the others finish what they began
        ignore = signal.SIGINT, signal.SIG_IGN
        with ProcessPoolExecutor(workers, get_context("spawn"), signal.signal, ignore) as pool:
            yield pool


def completed(pool: Executor, function: Callable, jobs: list[tuple]) -> Iterator[tuple[tuple, Any]]:
    """Jobs and their results in the order of completion; a ValueError is a result.

    If the caller stops or is interrupted, no further job begins.
    """
    futures = {pool.submit(function, *job): job for job in jobs}
    try:
        for future in as_completed(futures):
            error = future.exception()
            if isinstance(error, BrokenProcessPool):
                raise OSError("a worker process died, perhaps out of memory; run the same command "
                              "again with fewer workers") from error
            yield futures[future], error if isinstance(error, ValueError) else future.result()
    finally:
        for future in futures:
            future.cancel()


@contextlib.contextmanager
def one_thread() -> Iterator[None]:
    """Inside, torch uses one thread: processes share the processors, and sums stay the same."""
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(before)
