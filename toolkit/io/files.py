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

VALUES, DEEPEST = 2_000_000, 100  # of a JSON text: values, and levels of lists and objects
LARGEST = 4_000_000_000  # bytes of a file that is read at once
LARGEST_TABLE = 4_000_000  # bytes; its rows take fifty times as much


def status(path: str | os.PathLike, file: BinaryIO | None = None) -> os.stat_result | None:
    """The status of a regular file (``file``: open), None of a missing one; OSError for folders, devices, pipes, sockets."""
    try:
        found = os.stat(path if file is None else file.fileno())
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(found.st_mode):
        raise OSError(errno.EISDIR, os.strerror(errno.EISDIR), os.fspath(path))
    if not stat.S_ISREG(found.st_mode):
        raise OSError(errno.EINVAL, "a device, pipe or socket is no file", os.fspath(path))
    return found


@contextlib.contextmanager
def opened(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a regular file for reading; OSError for anything else, also where the name leads there once it was looked at."""
    status(path)
    with os.fdopen(os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)), "rb") as file:
        status(path, file)
        yield file


def read(path: str | os.PathLike, most: int = LARGEST) -> bytes:
    """The bytes, or the first so many, that a file has when it is `opened`: a pipe or a file of the kernel may never end."""
    with opened(path) as file:
        if (size := os.fstat(file.fileno()).st_size) > LARGEST:
            raise OSError(errno.EFBIG, f"more than {LARGEST} bytes", os.fspath(path))
        return file.read(min(size, most))


def below(folder: str | os.PathLike) -> list[Path]:
    """All that is in a folder and its sub-folders, sorted, however deep (`Path.rglob` recurs); links are not followed."""
    found, folders = [], [os.fspath(folder)]
    while folders:
        with contextlib.suppress(PermissionError), os.scandir(folders.pop()) as entries:
            for entry in entries:
                found.append(Path(entry.path))
                if entry.is_dir(follow_symlinks=False):
                    folders.append(entry.path)
    return sorted(found)


@contextlib.contextmanager
def named(path: str | os.PathLike) -> Iterator[None]:
    """What goes wrong while a file is read becomes a ValueError in one line that begins with the path."""
    try:
        yield
    except OSError as error:
        raise ValueError(f"{path}: cannot be read ({error.strerror or 'damaged'})") from error
    except ValueError as error:
        said = str(error)
        raise ValueError(said if said.startswith(f"{path}: ") else f"{path}: {said}") from error


def parsed(text: str | bytes) -> Any:
    """The value of a JSON text; ValueError if it is none, or has so many or so deeply nested values that it takes too much.

    A value takes up to 70 bytes, and one byte of the text may be enough for it.
    """
    if sum(text.count(sign) for sign in (",[{" if isinstance(text, str) else (b",", b"[", b"{"))) > VALUES:
        raise ValueError(f"its JSON text has more than {VALUES} values")
    try:
        value = json.loads(text)
    except RecursionError:
        raise ValueError("its JSON text is nested too deeply") from None
    except ValueError as error:
        raise ValueError("it has a number of thousands of digits" if "digits" in str(error) else str(error)) from None
    level = [value]
    for _ in range(DEEPEST):
        level = [inner for outer in level if isinstance(outer, dict | list)
                 for inner in (outer.values() if isinstance(outer, dict) else outer)]
        if not level:
            return value
    raise ValueError("its JSON text is nested too deeply")


def table(path: str | os.PathLike, columns: Iterable[str]) -> list[tuple[int, dict[str, str]]]:
    """Line number and row of a CSV file with these columns and perhaps more; ValueError if it is none or very large."""
    data = read(path)
    if len(data) > LARGEST_TABLE:
        raise ValueError(f"{path}: {len(data)} bytes, a table has at most {LARGEST_TABLE}")
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"{path}: not UTF-8 text, from byte {error.start} on") from None
    reader = csv.DictReader(io.StringIO(text, newline=""), restval="", skipinitialspace=True)
    try:
        if missing := [c for c in columns if c not in (reader.fieldnames or ())]:
            raise ValueError(f"{path}, line 1: expected the columns {', '.join(columns)}; missing: {', '.join(missing)}")
        return [(reader.line_num, row) for row in reader]
    except csv.Error as error:
        raise ValueError(f"{path}, line {reader.line_num + 1}: {error}") from error


@contextlib.contextmanager
def atomic_write(path: str | os.PathLike) -> Iterator[BinaryIO]:
    """Open a binary file under the name ``.NAME.….partial``, and rename it when it is complete and on the disk.

    Missing folders are created. A link is followed, and an older file keeps its permissions and its owner. OSError if the
    file cannot be written, or the path is a device, pipe or socket: the partial file is removed, and an older file stays as
    it was. A process that is killed while it writes leaves the partial file behind.
    """
    path = Path(os.path.realpath(path)) if os.path.islink(path) else Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{uuid.uuid4().hex[:8]}.partial")
    try:
        older = status(path)
        with partial.open("xb") as file:
            if older:
                _keep(file.fileno(), partial, older)
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(partial, path)
    except OSError as error:
        if error.errno and error.filename in (None, os.fspath(partial), os.fspath(path)):
            raise OSError(error.errno, f"cannot be written ({error.strerror})", os.fspath(path)) from error
        raise
    finally:
        partial.unlink(missing_ok=True)


def write_whole(path: str | os.PathLike, data: bytes) -> None:
    """Write a file at once by `atomic_write`."""
    with atomic_write(path) as file:
        file.write(data)


def _keep(number: int, path: Path, older: os.stat_result) -> None:
    """Give an open file the owner of an older one, if this user may, and its permissions."""
    made = os.fstat(number)
    if (made.st_uid, made.st_gid) != (older.st_uid, older.st_gid) and hasattr(os, "fchown"):
        with contextlib.suppress(PermissionError):
            os.fchown(number, older.st_uid, older.st_gid)
    path.chmod(stat.S_IMODE(older.st_mode))
