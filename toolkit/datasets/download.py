"""Download of one file that goes on after a cut, never joins parts of two files, and never waits for ever.

No library does all of it; `docs/dependencies.md` says what those that were tried do instead. An archive is unpacked
with all that it should give and nothing that it should not, or not at all.
"""

import http.client
import json
import lzma
import re
import shutil
import stat
import time
import urllib.error
import urllib.request
import zipfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path, PurePosixPath

from tqdm import tqdm

from toolkit.io.files import parsed, read, write_whole
from toolkit.io.progress import progress_bar

STALL = 30.0  # seconds without a connection or a byte after which a try has failed
TRIES = 5  # in a row that brought nothing new
NOTES = 100_000  # bytes of notes about a file
DAMAGED = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, EOFError, NotImplementedError,
           UnicodeDecodeError)  # what `zipfile` raises for files that are not a whole archive
LONGEST, DEEPEST = 200, 50  # bytes of a name of a file or folder (file systems take up to 255), and folders in each other


class _TryError(Exception):
    """A try that failed, and another may not."""


class _Hops(urllib.request.HTTPRedirectHandler):
    """Follows redirects to https, and to http only where the checksum of the file is known."""

    def __init__(self, trusted: bool):
        self.trusted = trusted

    def redirect_request(self, request, reply, code, reason, headers, address):
        """The next request; ValueError if its address is not encrypted."""
        if not _safe(address, self.trusted):
            raise ValueError(f"{request.full_url}: the server leads to {address}, which is not encrypted")
        return super().redirect_request(request, reply, code, reason, headers, address)


def _safe(address: str, trusted: bool) -> bool:
    return address.lower().startswith(("https://", "http://") if trusted else "https://")


def notes(part: Path) -> dict:
    """What the server called the file that lies in ``part``, whole or not: url, validator, total.

    Empty if that is not known, or the notes are damaged.
    """
    file = part.with_suffix(".json")
    if not (part.is_file() and file.is_file() and file.stat().st_size < NOTES):
        return {}
    try:
        known = parsed(read(file))
    except ValueError:
        return {}
    kinds = {"url": str, "validator": str, "total": int | None}
    whole = isinstance(known, dict) and all(isinstance(known.get(key), kind) for key, kind in kinds.items())
    return known if whole else {}


def download(url: str, part: Path, size: int | None, limit: int, *, trusted: bool, progress: bool = False) -> None:
    """Download a file to ``part``, going on with what is there of it if it is still the same on the server.

    A ``.json`` beside ``part`` has what the server called the file. ``size`` is its number of bytes, if known, ``limit`` the
    largest one allowed otherwise. With ``trusted`` (the checksum is known), a download also goes on if the server cannot say
    whether the file has changed.

    Raises
    ------
    ValueError
        If the server refuses, or sends more or fewer bytes than known; if the address, or one that a server leads to, is not
        https and not ``trusted``.
    OSError
        If nothing new came in `TRIES` tries.
    """
    if not _safe(url, trusted):
        raise ValueError(f"{url}: is not encrypted; give an https address, or the file's checksum (--sha256)")
    best = failures = 0
    with progress_bar(total=size, unit="B", unit_scale=True, desc="download", show=progress) as bar:
        while True:
            try:
                return _receive(url, part, size, limit, trusted, bar)
            except _TryError as error:
                have = part.stat().st_size if part.exists() else 0
                failures, best = (1, have) if have > best else (failures + 1, best)
                if failures >= TRIES:
                    kept = f"{have:,} bytes are kept, the same command goes on from there" if have else "nothing came"
                    raise OSError(f"{url}: {error}; {kept}") from error
                time.sleep(min(STALL / 30 * 2 ** (failures - 1), STALL))


def _receive(url: str, part: Path, size: int | None, limit: int, trusted: bool, bar: tqdm) -> None:
    """One try: the rest of the file, or all of it where the server has another one now or cannot go on."""
    known, have, headers = notes(part), 0, {"User-Agent": "toolkit (data fetch)"}
    if known.get("url") == url and (known["validator"] or trusted):
        have = part.stat().st_size
        if have and have == known["total"]:
            return
        headers |= {"Range": f"bytes={have}-"} if have else {}
        headers |= {"If-Range": known["validator"]} if have and known["validator"] else {}
    with _open(urllib.request.Request(url, headers=headers), trusted) as reply:
        code = f"{reply.status} {str(reply.reason).splitlines()[-1]}"  # of redirects without end urllib says more
        if reply.status in (408, 425, 429) or reply.status >= 500:
            raise _TryError(f"the server answers {code}")
        if reply.status not in (200, 206, 416):
            raise ValueError(f"{url}: the server answers {code}")
        span = re.fullmatch(r"bytes (?:([0-9]+)-[0-9]+|\*)/([0-9]+|\*)", reply.headers.get("Content-Range", ""))
        total = span[2] if span else reply.headers.get("Content-Length", "")
        total = int(total) if re.fullmatch("[0-9]{1,18}", total) else None
        validator = reply.headers.get("ETag", "")
        if not validator or validator.startswith("W/"):
            validator = reply.headers.get("Last-Modified", "")
        if size and total and total != size:
            raise ValueError(f"{url}: expected a file of {size:,} bytes, the server announces {total:,}")
        if reply.status == 416 and have and total == have:  # it ends here, whatever was announced
            return
        if reply.status == 200:
            have = 0
        elif not (span and span[1] == str(have) and validator == known.get("validator")
                  and known.get("total") in (None, total)):
            part.unlink(missing_ok=True)
            raise _TryError(f"the server does not go on with the same file ({code})")
        if (size or total or 0) > limit:
            raise ValueError(f"{url}: the server announces {total:,} bytes, more than the {limit:,} that it may have")
        with part.open("ab" if have else "wb") as file:
            write_whole(part.with_suffix(".json"), json.dumps({"url": url, "validator": validator, "total": total}).encode())
            bar.total, bar.n = size or total, have
            for chunk in _chunks(reply):
                file.write(chunk)
                have += len(chunk)
                bar.update(len(chunk))
                if have > (size or limit):
                    file.truncate(0)
                    raise ValueError(f"{url}: more came than the {size or limit:,} bytes that it may have")
    if have != (size or total or have):
        raise _TryError(f"the file should have {size or total:,} bytes and ended after {have:,}")


def _open(request: urllib.request.Request, trusted: bool) -> http.client.HTTPResponse | urllib.error.HTTPError:
    """The server's answer, refusals included."""
    try:
        return urllib.request.build_opener(_Hops(trusted)).open(request, timeout=STALL)
    except urllib.error.HTTPError as refusal:
        return refusal
    except urllib.error.URLError as error:
        raise _TryError(f"cannot be reached ({error.reason}); is there a network?") from error
    except (OSError, http.client.HTTPException) as error:
        raise _TryError(str(error)) from error


def _chunks(reply: http.client.HTTPResponse) -> Iterator[bytes]:
    """The answer's bytes as they come."""
    try:
        while chunk := reply.read1(1 << 16):
            yield chunk
    except (OSError, http.client.HTTPException) as error:
        raise _TryError(str(error)) from error


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
