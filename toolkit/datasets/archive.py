"""Unpacking an archive from elsewhere: all that it should give and nothing that it should not, or nothing at all."""

import lzma
import shutil
import stat
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path, PurePosixPath

from toolkit.io.progress import progress_bar

DAMAGED = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, NotImplementedError,
           UnicodeDecodeError)  # what `zipfile` raises for files that are not a whole archive
LONGEST, DEEPEST = 200, 50  # bytes of a name of a file or folder (file systems take up to 255), and folders in each other


def unpack(archive: Path, folder: Path, place: Callable[[str], str | None], limit: int, progress: bool = False) -> str:
    """Unpack some members of a zip archive into a folder, which is made if it is not there; returns the archive's comment.

    ``place`` gives the path of a member in the folder from its name in the archive, or None to leave it out. ``limit`` is
    the largest number of bytes that may be unpacked. GitHub's archives name their commit in the comment.

    Raises
    ------
    ValueError
        If the file is not a whole zip archive, is locked by a password, holds more than the limit, two members of one
        name, a file where another member needs a folder, a link, a device, a name that no file can have, or a path that
        leads out of the folder: then nothing was unpacked. Or if a member is damaged.
    OSError
        If the disk has no room, which is asked first.
    """
    try:
        with zipfile.ZipFile(archive) as file:
            members = _members(archive, file, place)
            size = sum(info.file_size for info in members.values())
            if size > limit:
                raise ValueError(f"{archive}: would unpack to {size:,} bytes, more than the {limit:,} that it may have")
            folder.mkdir(parents=True, exist_ok=True)
            room(folder, size, f"unpack {archive.name}")
            with progress_bar(total=size, unit="B", unit_scale=True, desc="unpack", show=progress) as bar:
                for path, info in members.items():
                    target = folder / path
                    target.parent.mkdir(parents=True, exist_ok=True)
                    with file.open(info) as packed, target.open("xb") as plain:
                        shutil.copyfileobj(packed, plain, 1 << 20)
                    bar.update(info.file_size)
            return file.comment.decode(errors="replace")
    except DAMAGED as error:
        with archive.open("rb") as file:
            start = file.read(16)
        raise ValueError(f"{archive}: not a whole zip archive ({error}); it starts with {start!r}") from error


def room(folder: Path, size: int, purpose: str) -> None:
    """OSError if fewer than ``size`` bytes are free on the disk of the folder."""
    free = shutil.disk_usage(folder).free
    if free < size:
        raise OSError(f"{folder}: {size:,} bytes are needed to {purpose}, the disk has {free:,} free")


def _members(archive: Path, file: zipfile.ZipFile,
             place: Callable[[str], str | None]) -> dict[PurePosixPath, zipfile.ZipInfo]:
    """The members to unpack by their path in the folder. One that means harm spoils the archive, wanted or not."""
    members: dict[PurePosixPath, zipfile.ZipInfo] = {}
    seen = set()
    for info in file.infolist():
        name, path = info.orig_filename, PurePosixPath(info.orig_filename)
        if path.is_absolute() or ".." in path.parts or any(c in name for c in "\\:\0") or not path.parts:
            raise ValueError(f"{archive}: refused, its member {name!r} leads out of the folder")
        if not name.isprintable() or len(path.parts) > DEEPEST or any(len(part.encode()) > LONGEST for part in path.parts):
            raise ValueError(f"{archive}: refused, its member {name[:LONGEST]!r} has a name that no file should have")
        kind = stat.S_IFMT(info.external_attr >> 16)
        if kind not in (0, stat.S_IFREG, stat.S_IFDIR):
            raise ValueError(f"{archive}: refused, its member {name!r} is a link or a device, not a file")
        if info.flag_bits & 1:
            raise ValueError(f"{archive}: refused, its member {name!r} is locked by a password")
        if info.is_dir() or (target := place(name)) is None:
            continue
        if (key := target.casefold()) in seen:
            raise ValueError(f"{archive}: refused, it holds {target!r} twice")
        seen.add(key)
        members[PurePosixPath(target)] = info
    for path in members:
        if inside := next((above for above in path.parents if above.as_posix().casefold() in seen), None):
            raise ValueError(f"{archive}: refused, {str(inside)!r} is a file in it, and {str(path)!r} needs a folder there")
    return members
