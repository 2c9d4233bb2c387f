"""Files that are read only if they have an end, and written whole or not at all."""

import contextlib
import csv
import errno
import io
import json
import os
import stat
import uuid
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, BinaryIO

VALUES = 2_000_000  # of a JSON text
LARGEST = 4_000_000_000  # bytes of a file that is read at once
LARGEST_TABLE = 4_000_000  # bytes; its rows take fifty times as much
NO_FILE = errno.EINVAL, "a device, pipe or socket is no file"


@contextlib.contextmanager
def opened(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a regular file for reading; OSError for a folder, device, pipe or socket."""
    # without waiting for another program to write into a pipe
    flag = getattr(os, "O_NONBLOCK", 0)
    with open(path, "rb", opener=lambda name, flags: os.open(name, flags | flag)) as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise OSError(*NO_FILE, os.fspath(path))
        yield file


def read(path: str | os.PathLike, most: int = LARGEST) -> bytes:
    """The bytes of a regular file, at most the first ``most``; OSError if it is too large."""
    with opened(path) as file:
        size = os.fstat(file.fileno()).st_size
        if size > LARGEST:
            raise OSError(errno.EFBIG, f"more than {LARGEST} bytes", os.fspath(path))
        return file.read(min(size, most))


def below(folder: str | os.PathLike) -> list[Path]:
    """All that is in a folder and its sub-folders, sorted."""
    return sorted(Path(folder).rglob("*"))


@contextlib.contextmanager
def named(path: str | os.PathLike) -> Iterator[None]:
    """What goes wrong inside becomes a ValueError in one line that begins with the path."""
    try:
        yield
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror or 'damaged'})") from error
    except ValueError as error:
        said = str(error)
        raise ValueError(said if said.startswith(f"{path}: ") else f"{path}: {said}") from error


def parsed(text: str | bytes) -> Any:
    """The value of a JSON text; ValueError if it is none, or has more than `VALUES` values.

    One byte of the text may be a value, and a value takes up to 70 bytes of memory.
    """
    signs = ",[{" if isinstance(text, str) else (b",", b"[", b"{")
    if sum(text.count(sign) for sign in signs) > VALUES:
        raise ValueError(f"its JSON text has more than {VALUES} values")
    try:
        return json.loads(text)
    except RecursionError:
        raise ValueError("its JSON text is nested too deeply") from None
    except ValueError as error:
        long = "digits" in str(error)
        raise ValueError("it has a number of thousands of digits" if long else error) from None


def table(path: str | os.PathLike, columns: Iterable[str]) -> list[tuple[int, dict[str, str]]]:
    """Line number and row of a CSV file with these columns and perhaps more.

    ValueError if the file is no UTF-8 text, is very large or lacks a column.
    """
    data = read(path)
    if len(data) > LARGEST_TABLE:
        raise ValueError(f"{path}: {len(data)} bytes, a table has at most {LARGEST_TABLE}")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"{path}: not UTF-8 text, from byte {error.start} on") from None
    rows = csv.DictReader(io.StringIO(text, newline=""), restval="", skipinitialspace=True)
    try:
        if missing := [c for c in columns if c not in (rows.fieldnames or ())]:
            raise ValueError(f"{path}, line 1: expected the columns {', '.join(columns)}; "
                             f"missing: {', '.join(missing)}")
        return [(rows.line_num, row) for row in rows]
    except csv.Error as error:
        raise ValueError(f"{path}, line {rows.line_num + 1}: {error}") from error


@contextlib.contextmanager
def naming(path: Path, *others: Path) -> Iterator[None]:
    """An OSError of ``path``, of ``others`` or of no file becomes one of writing ``path``."""
    try:
        yield
    except OSError as error:
        if error.errno and error.filename in (None, *map(str, (path, *others))):
            why = f"cannot be written ({error.strerror})"
            raise OSError(error.errno, why, str(path)) from error
        raise


@contextlib.contextmanager
def atomic_write(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a binary file under a hidden name, and rename it when it is complete and on the disk.

    Missing folders are created. A link is followed, and an older file's permissions are kept.
    OSError if the file cannot be written, or the path is a folder, device or pipe: an older file
    then stays as it was. A process that is killed leaves a ``.NAME.….partial`` behind.
    """
    path = Path(os.path.realpath(path)) if os.path.islink(path) else Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{uuid.uuid4().hex[:8]}.partial")
    try:
        with naming(path, partial):
            older = path.stat() if path.exists() else None
            if older and not stat.S_ISREG(older.st_mode):
                raise OSError(*NO_FILE, str(path))
            with partial.open("xb") as file:
                if older:
                    partial.chmod(stat.S_IMODE(older.st_mode))
                yield file
                file.flush()
                os.fsync(file.fileno())
            os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


def write_whole(path: str | os.PathLike, data: bytes) -> None:
    """Write a file at once by `atomic_write`."""
    with atomic_write(path) as file:
        file.write(data)
