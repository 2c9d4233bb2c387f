"""Download of one file by pooch, which goes on after a cut, and unpacking of a zip archive.

pooch checks the SHA-256 and gives a file its name when it is whole. It starts a file again after a
cut; `_Receiver`, a downloader for pooch, asks for the rest instead.
"""

import shutil
import time
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path, PurePosixPath
from urllib.parse import urljoin

import pooch
import requests
from tqdm.utils import CallbackIOWrapper

from toolkit.io.progress import progress_bar

STALL = 30.0  # seconds without a connection or a byte after which a try has failed
TRIES = 5  # in a row that brought nothing new
WAIT = 1.0  # seconds before the second try; twice as long before each further one
CHUNK = 1 << 14  # bytes; those of a chunk that is cut are lost
SECURE = "https://"
BUSY = (408, 425, 429)  # answers that may change, as those from 500 on
CUT = (requests.ConnectionError, requests.Timeout, requests.exceptions.ChunkedEncodingError)
# what `zipfile` raises for a file that is not a whole archive without a password
DAMAGED = (zipfile.BadZipFile, zlib.error, EOFError, RuntimeError, UnicodeDecodeError)


def download(url: str, folder: Path, sha256: str | None, limit: int,
             progress: bool = False) -> Path:
    """Download a file of at most ``limit`` bytes into a folder, unless it is there; its path.

    If ``sha256`` is known, what came before a cut is kept as ``SHA256.part``, and the next call
    asks for the rest. Otherwise nobody could say whether the two parts belong together.

    Raises
    ------
    ValueError
        If the server refuses, or the file has another checksum (then it is removed) or more bytes;
        if there is no checksum, and the address or one that the server leads to is not https.
    OSError
        If `TRIES` tries in a row brought nothing new.
    """
    if not (sha256 or url.lower().startswith(SECURE)):
        raise ValueError(f"{url}: is not encrypted; give an https address, or the file's checksum "
                         "(--sha256)")
    pooch.get_logger().setLevel("WARNING")
    known = f"sha256:{sha256}" if sha256 else None
    receiver = _Receiver(sha256, limit, progress)
    return Path(pooch.retrieve(url, known, path=folder, downloader=receiver))


class _Receiver:
    """A downloader for pooch: called with an address and a file, it fills the file."""

    def __init__(self, sha256: str | None, limit: int, progress: bool):
        self.sha256, self.limit, self.progress = sha256, limit, progress

    def __call__(self, url: str, target: str, _pooch: object) -> None:
        """Fill the file ``target``, in several tries if need be."""
        part = Path(target).with_name(f"{self.sha256}.part") if self.sha256 else Path(target)
        most = failures = 0
        while True:
            try:
                self._receive(url, part)
                break
            except requests.HTTPError as error:
                reply = error.response
                problem = f"the server answers {reply.status_code} {reply.reason}"
                if reply.status_code not in BUSY and reply.status_code < 500:
                    raise ValueError(f"{url}: {problem}") from error
            except CUT as error:
                problem = f"no connection, or it was cut ({type(error).__name__})"
            except requests.RequestException as error:  # an address that leads nowhere
                raise ValueError(f"{url}: {error}") from error
            have = part.stat().st_size
            failures, most = (1, have) if have > most else (failures + 1, most)
            if failures >= TRIES:
                kept = "nothing came; is there a network?"
                if self.sha256 and have:
                    kept = f"{have:,} bytes are kept, the same command goes on from there"
                raise OSError(f"{url}: {problem}; {kept}")
            time.sleep(min(WAIT * 2 ** (failures - 1), STALL))
        part.replace(target)

    def _receive(self, url: str, part: Path) -> None:
        """One try: the rest of the file, or all of it where the server cannot go on."""
        with part.open("ab" if self.sha256 else "wb") as file:
            have = file.tell()
            # a file that is compressed once more would not go on where it was cut
            headers = {"Accept-Encoding": "identity"}
            if have:
                headers["Range"] = f"bytes={have}-"

            def look(reply: requests.Response, **_: object) -> None:
                """Judge an answer before its bytes are read."""
                if reply.is_redirect:
                    address = urljoin(reply.url, reply.headers["location"])
                    if not (self.sha256 or address.lower().startswith(SECURE)):
                        raise ValueError(f"{url}: the server leads to {address}, which is not "
                                         "encrypted")
                elif reply.ok:
                    if have and reply.status_code == 200:  # all of it comes, not the rest
                        file.truncate(0)
                        bar.reset()
                    bar.total = bar.n + int(reply.headers.get("Content-Length", 0)) or None

            def count(written: int) -> None:
                bar.update(written)
                if file.tell() > self.limit:
                    file.truncate(0)
                    raise ValueError(f"{url}: more came than the {self.limit:,} bytes that it may "
                                     "have")

            get = pooch.HTTPDownloader(chunk_size=CHUNK, timeout=STALL, headers=headers,
                                       hooks={"response": look})
            with progress_bar(initial=have, unit="B", unit_scale=True, desc="download",
                              show=self.progress) as bar:
                try:
                    get(url, CallbackIOWrapper(count, file, "write"), None)
                except requests.HTTPError as error:
                    if not (have and error.response.status_code == 416):  # the file ends here
                        raise


def unpack(archive: Path, folder: Path, place: Callable[[str], str | None], limit: int,
           progress: bool = False) -> str:
    """Unpack some members of a zip archive into a new folder; returns the archive's comment.

    ``place`` gives the path of a member in the folder from its name in the archive, or None to
    leave it out. ``limit`` is the largest number of bytes that may be unpacked.

    Raises
    ------
    ValueError
        If the file is not a whole zip archive, has a password, holds more than the limit, two files
        of one name, or a path that leads out of the folder.
    OSError
        If the disk has no room, which is asked first.
    """
    try:
        with zipfile.ZipFile(archive) as file:
            members = _members(archive, file, place)
            # zipfile never unpacks more bytes of a member than its header says
            size = sum(info.file_size for info in members.values())
            if size > limit:
                raise ValueError(f"{archive}: would unpack to {size:,} bytes, more than the "
                                 f"{limit:,} that it may have")
            folder.mkdir(parents=True, exist_ok=True)
            room(folder, size, f"unpack {archive.name}")
            with progress_bar(total=size, unit="B", unit_scale=True, desc="unpack",
                              show=progress) as bar:
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
        raise ValueError(f"{archive}: not a whole zip archive ({error}); it starts with {start!r}"
                         ) from error


def _members(archive: Path, file: zipfile.ZipFile,
             place: Callable[[str], str | None]) -> dict[str, zipfile.ZipInfo]:
    """The members to unpack, by their path in the folder."""
    members: dict[str, zipfile.ZipInfo] = {}
    names = set()
    for info in file.infolist():
        path = PurePosixPath(info.filename)
        if path.is_absolute() or ".." in path.parts or any(c in info.filename for c in "\\:"):
            raise ValueError(f"{archive}: refused, its member {info.filename!r} leads out of the "
                             "folder")
        if info.is_dir() or (target := place(info.filename)) is None:
            continue
        if target.casefold() in names:
            raise ValueError(f"{archive}: refused, it holds {target!r} twice")
        names.add(target.casefold())
        members[target] = info
    return members


def room(folder: Path, size: int, purpose: str) -> None:
    """OSError if fewer than ``size`` bytes are free on the disk of the folder."""
    free = shutil.disk_usage(folder).free
    if free < size:
        raise OSError(f"{folder}: {size:,} bytes are needed to {purpose}, the disk has {free:,} "
                      "free")
