"""Files that are written whole or not at all."""

import contextlib
import os
import uuid
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO


@contextlib.contextmanager
def atomic_write(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a binary file under the name ``.NAME.….partial``, and rename it when it is complete and on the disk.

    Missing folders are created. OSError if the file cannot be written: the partial file is removed, and an older file stays
    as it was. A process that is killed while it writes leaves the partial file behind.
    """
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{uuid.uuid4().hex[:8]}.partial")
    try:
        with partial.open("xb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(partial, path)
    except OSError as error:
        if error.errno and error.filename in (None, os.fspath(partial)):
            raise OSError(error.errno, f"cannot be written ({error.strerror})", os.fspath(path)) from error
        raise
    finally:
        partial.unlink(missing_ok=True)
