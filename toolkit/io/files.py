"""Files that are written whole or not at all."""

import contextlib
import glob
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None


@contextlib.contextmanager
def atomic_write(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a binary file that takes its name when it was written whole and is on the disk; folders are made.

    What it is called until then starts with a dot. A killed process leaves such a file; the next one that writes the same
    file removes it, and knows by a lock those of processes that still write.

    Raises
    ------
    OSError
        If it cannot be written; nothing is left of it, and an older file stays as it was.
    """
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    for left in path.parent.glob(f".{glob.escape(path.name)}.*.partial"):
        with contextlib.suppress(OSError):  # another's that lives, or one that is gone already
            _remove(left)
    file = None
    try:
        with (file := _partial(path)):
            yield file
            file.flush()
            os.fsync(file.fileno())
            if not fcntl:
                file.close()  # Windows renames no open file
            mask = os.umask(0)
            os.umask(mask)
            os.chmod(file.name, 0o666 & ~mask)
            os.replace(file.name, path)
    except OSError as error:
        if error.errno and (file is None or error.filename in (None, file.name)):
            raise OSError(error.errno, f"cannot be written ({error.strerror})", os.fspath(path)) from error
        raise
    finally:
        if file is not None:
            Path(file.name).unlink(missing_ok=True)


def _partial(path: Path) -> BinaryIO:
    while True:
        file = tempfile.NamedTemporaryFile(dir=path.parent, prefix=f".{path.name}.", suffix=".partial", delete=False)  # noqa: SIM115
        if fcntl:
            with contextlib.suppress(OSError):  # a file system without locks
                fcntl.flock(file, fcntl.LOCK_EX)
        if os.path.exists(file.name):  # nobody took it for a leftover before it was locked
            return file
        file.close()


def _remove(left: Path) -> None:
    """Remove a file that no living process has locked; an OSError otherwise."""
    if not fcntl:
        left.unlink()  # where nobody can remove an open file
        return
    with left.open("rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        left.unlink()
