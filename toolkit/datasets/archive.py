"""Unpacking an archive from elsewhere: all that it should give and nothing that it should not, or nothing at all."""

import lzma
import shutil
import stat
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path, PurePosixPath

from tqdm import tqdm

DAMAGED = (  # what `zipfile` raises for files that are no whole archive, depending on where they are spoilt
    zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, NotImplementedError, UnicodeDecodeError,
)

def unpack(
    archive: Path, folder: Path, place: Callable[[str], str | None], limit: int, progress: bool = False
) -> str:
    """Unpack some members of a zip archive.

    Parameters
    ----------
    archive
        The file.
    folder
        Where to; made if it is not there.
    place
        Where a member goes inside the folder, by its name in the archive; None for those that are left out.
    limit
        How many bytes all that is unpacked may have.
    progress
        Show a bar on a terminal.

    Returns
    -------
    str
        The archive's comment (GitHub's archives name their commit there).

    Raises
    ------
    ValueError
        If the file is not a whole zip archive, is locked by a password, holds more than the limit, two members of one
        name, a link, a device, or a path that leads out of the folder: then nothing was unpacked. Or if a member is damaged.
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
            with tqdm(total=size, unit="B", unit_scale=True, desc="unpack", disable=None if progress else True) as bar:
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
    """Refuse what the disk has no room for.

    Raises
    ------
    OSError
        If fewer than ``size`` bytes are free where the folder is.
    """
    free = shutil.disk_usage(folder).free
    if free < size:
        raise OSError(f"{folder}: {size:,} bytes are needed to {purpose}, the disk has {free:,} free")


def _members(
    archive: Path, file: zipfile.ZipFile, place: Callable[[str], str | None]
) -> dict[PurePosixPath, zipfile.ZipInfo]:
    """The members to unpack by their path in the folder. One that means harm spoils the archive, wanted or not."""
    members: dict[PurePosixPath, zipfile.ZipInfo] = {}
    seen = set()
    for info in file.infolist():
        name, path = info.orig_filename, PurePosixPath(info.orig_filename)
        if path.is_absolute() or ".." in path.parts or any(c in name for c in "\\:\0") or not path.parts:
            raise ValueError(f"{archive}: refused, its member {name!r} leads out of the folder")
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
    return members
