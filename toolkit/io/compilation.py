"""Functions compiled by numba, whose machine code is kept on disk where a folder can be written."""

import contextlib
import functools
import hashlib
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path

from numba import njit
from numba.core.caching import FunctionCache


class Cache(FunctionCache):
    """numba's cache; a file of it that cannot be read or written counts as missing.

    Its key includes the modules beside that of the function, whose functions are compiled into it.
    """

    def _index_key(self, sig, codegen) -> tuple:
        folder = Path(self._py_func.__code__.co_filename).parent
        beside = b"".join(path.read_bytes() for path in sorted(folder.glob("*.py")))
        return *super()._index_key(sig, codegen), hashlib.sha256(beside).hexdigest()

    @contextlib.contextmanager
    def _guard_against_spurious_io_errors(self) -> Iterator[None]:
        try:
            yield
        except Exception:  # of any kind, if a pickle is damaged
            with contextlib.suppress(OSError):
                self.flush()  # or the damaged index would stay


def compiled(**options) -> Callable:
    """Decorator: `numba.njit` that releases the GIL, with numba's cache on disk.

    The cache lies beside the module or in the user's cache folder. Where neither can be written
    (a read-only install, a user without home), each process warns once and compiles again.
    """

    def decorate(function: Callable) -> Callable:
        made = njit(nogil=True, **options)(function)
        try:
            made._cache = Cache(function)  # as `enable_caching` does
        except (OSError, RuntimeError):
            _without_cache()
        return made

    return decorate


@functools.cache
def _without_cache() -> None:
    warnings.warn("no folder for compiled code can be written, so each process compiles it again, "
                  "which takes seconds; set NUMBA_CACHE_DIR to a folder that you may write",
                  stacklevel=3)
