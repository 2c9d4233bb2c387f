"""Files on a server that are read as those on the disk, and unpacking of zip archives."""

import contextlib
import io
import re
import shutil
import time
import zipfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path, PurePosixPath
from typing import Any, BinaryIO
from urllib.parse import urljoin

import requests
import urllib3
from tqdm.utils import CallbackIOWrapper

from toolkit.io.files import naming
from toolkit.io.progress import progress_bar

STALL = 30.0  # seconds without a connection or a byte after which a try has failed
TRIES = 5  # in a row that brought nothing new
WAIT = 1.0  # seconds before the second try; twice as long before each further one
CHUNK = 1 << 14  # bytes; those of a chunk that is cut are lost
# addresses whose bytes nobody on the way can change
SECURE = re.compile(r"https://|http://(localhost|127\.0\.0\.1)[:/]", re.IGNORECASE)
BUSY = (408, 425, 429)  # answers that may change, as those from 500 on
CUT = (requests.ConnectionError, requests.Timeout, urllib3.exceptions.HTTPError)
# what `zipfile` raises for a file that is not a whole archive without a password
DAMAGED = (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, UnicodeDecodeError)


class RemoteFile(io.RawIOBase):
    """A file on a server, open for reading.

    Where the connection is cut, another one asks for the rest (HTTP ranges). A server that knows no
    ranges sends all again, and what was read before is skipped.

    Parameters
    ----------
    url
        Address of the file.
    known
        Whether the checksum of the file is known. If not, the address and those that the server
        leads to must be `SECURE`.

    Raises
    ------
    ValueError
        If the server refuses, leads to an address that is not secure, or has another file than
        before.
    OSError
        If `TRIES` tries in a row brought nothing new.
    """

    def __init__(self, url: str, known: bool = False):
        self.url, self.known = url, known
        self._body: urllib3.BaseHTTPResponse | io.BytesIO | None = None  # for `close`, after errors
        if not (known or SECURE.match(url)):
            raise ValueError(f"{url}: is not encrypted; give an https address, or the file's "
                             "checksum (--sha256)")
        self.ranges = False  # whether the server sends parts of the file
        self.size: int | None = None
        self._tag: str | None = None  # the server's name of this version of the file
        self._position = self._failures = 0
        self._receive(0)

    def readable(self) -> bool:
        """Return True."""
        return True

    def seekable(self) -> bool:
        """Return True."""
        return True

    def seek(self, offset: int, whence: int = io.SEEK_SET) -> int:
        """Set the position; the next `read` then asks the server for the bytes from there on."""
        base = {io.SEEK_SET: 0, io.SEEK_CUR: self._position, io.SEEK_END: self.size or 0}[whence]
        if base + offset != self._position:
            self._position = base + offset
            self._hang_up()
        return self._position

    def close(self) -> None:
        """Close the connection."""
        self._hang_up()
        super().close()

    def readinto(self, buffer: Any) -> int:
        """Read the next bytes; 0 at the end of the file."""
        piece = self._receive(len(buffer))
        buffer[: len(piece)] = piece
        self._position += len(piece)
        self._failures = 0
        return len(piece)

    def _receive(self, most: int) -> bytes:
        """Up to ``most`` bytes; tries again, after a wait, what failed but may work later."""
        while True:
            try:
                if self._body is None:
                    self._connect()
                piece = self._body.read(most)
                if piece or not most or self._position >= (self.size or 0):
                    return piece
                problem = "the connection ended before the file"
            except CUT as error:
                problem = f"no connection, or it was cut ({type(error).__name__})"
            except requests.HTTPError as error:
                reply = error.response
                problem = f"the server answers {reply.status_code} {reply.reason}"
                if reply.status_code not in BUSY and reply.status_code < 500:
                    raise ValueError(f"{self.url}: {problem}") from error
            except requests.RequestException as error:  # an address that leads nowhere
                raise ValueError(f"{self.url}: {error}") from error
            self._hang_up()
            self._failures += 1
            if self._failures >= TRIES:
                raise OSError(f"{self.url}: {problem}, {TRIES} times; is there a network? the "
                              "same command tries again")
            time.sleep(min(WAIT * 2 ** (self._failures - 1), STALL))

    def _connect(self) -> None:
        """Ask for the file from the position on."""
        # a file that is compressed once more would not go on where it was cut
        headers = {"Accept-Encoding": "identity", "Range": f"bytes={self._position}-"}
        reply = requests.get(self.url, headers=headers, stream=True, timeout=STALL,
                             hooks={"response": self._judge})
        if reply.status_code == 416:  # the file ends here; the answer's text is none of it
            reply.close()
            self._body = io.BytesIO()
            return
        reply.raise_for_status()
        self.ranges = reply.status_code == 206
        said = reply.headers.get("Content-Length", "")
        if self.ranges:
            part, _, said = reply.headers.get("Content-Range", "").rpartition("/")
            if not part.startswith(f"bytes {self._position}-"):
                raise ValueError(f"{self.url}: the server sends another part than bytes from "
                                 f"{self._position} on: {part!r:.60}")

        # another file than that of the answers before is refused
        size = int(said) if said.isdecimal() and len(said) < 20 else None
        tag = reply.headers.get("ETag")
        for before, now in ((self.size, size), (self._tag, tag)):
            if before is not None and now is not None and before != now:
                raise ValueError(f"{self.url}: the server has another file than before: "
                                 f"expected {before}, got {now}")
        self.size, self._tag, self._body = size, tag, reply.raw

        # without ranges all of it comes, not the rest
        left = 0 if self.ranges else self._position
        while left and (piece := self._body.read(min(left, CHUNK))):
            left -= len(piece)

    def _judge(self, reply: requests.Response, **_: object) -> None:
        """Refuse an address that a server leads to if it is not secure."""
        if reply.is_redirect:
            address = urljoin(reply.url, reply.headers["location"])
            if not (self.known or SECURE.match(address)):
                raise ValueError(f"{self.url}: the server leads to {address}, which is not "
                                 "encrypted")

    def _hang_up(self) -> None:
        if self._body is not None:
            self._body.close()
        self._body = None


def download(url: str, target: Path, known: bool, progress: bool = False) -> None:
    """Download a file, and go on where an earlier call was cut; errors as of `RemoteFile`.

    What came before is kept as ``TARGET.part``.
    """
    part = target.with_name(f"{target.name}.part")
    with RemoteFile(url, known) as remote, naming(part), part.open("ab") as file:
        have = remote.seek(file.tell())
        with progress_bar(initial=have, total=remote.size, unit="B", unit_scale=True,
                          desc="download", show=progress) as bar:
            while piece := remote.read(CHUNK):
                file.write(piece)
                bar.update(len(piece))
    part.replace(target)


@contextlib.contextmanager
def archive(file: BinaryIO, name: str) -> Iterator[zipfile.ZipFile]:
    """Open a zip archive; ValueError if it is none, is damaged or has a password."""
    try:
        with zipfile.ZipFile(file) as opened:
            yield opened
    except DAMAGED as error:
        file.seek(0)
        raise ValueError(f"{name}: not a whole zip archive ({error}); it starts with "
                         f"{file.read(16)!r}") from error


def members(opened: zipfile.ZipFile, place: Callable[[str], str | None]
            ) -> dict[str, zipfile.ZipInfo]:
    """Members of an archive by the path to unpack them to, in the archive's order.

    ``place`` gives that path from the name in the archive, or None to leave it out, as a name that
    cannot be printed is. ValueError if a name leads out of the folder.
    """
    found: dict[str, zipfile.ZipInfo] = {}
    for info in sorted(opened.infolist(), key=lambda info: info.header_offset):
        path = PurePosixPath(info.filename)
        if path.is_absolute() or ".." in path.parts or any(c in info.filename for c in "\\:"):
            raise ValueError(f"the archive's member {info.filename!r} leads out of the folder")
        file = info.filename.isprintable() and not info.filename.endswith("/")
        if file and (target := place(info.filename)) is not None:
            found[target] = info
    return found


def unpack(opened: zipfile.ZipFile, chosen: dict[str, zipfile.ZipInfo], folder: Path,
           progress: bool = False) -> None:
    """Unpack `members` of an archive into a folder, which then holds nothing else."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    # zipfile never unpacks more bytes of a member than its header says, and checks the CRC-32
    size = sum(info.file_size for info in chosen.values())
    with progress_bar(total=size, unit="B", unit_scale=True, desc="unpack", show=progress) as bar:
        for name, info in chosen.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            with naming(path), opened.open(info) as packed, path.open("wb") as plain:
                shutil.copyfileobj(packed, CallbackIOWrapper(bar.update, plain, "write"), 1 << 20)
