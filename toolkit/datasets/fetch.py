"""Getting the public datasets from their homes: whole and checked, or not at all.

Archive and unpacked files lie in a hidden folder beside the dataset's. When they are checked, the
unpacked folder takes the dataset's name in one step, with `RECORD` in it. Killed at any time, the
same call goes on with the download of an archive. Single styles of 100STYLE are read out of the
archive on the server, from the beginning.
"""

import contextlib
import hashlib
import io
import json
import os
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path, PurePosixPath
from typing import BinaryIO

import filelock

from toolkit.datasets import bandai, home, published_files as parameters, style100
from toolkit.datasets.download import RemoteFile, archive, download, members, unpack
from toolkit.datasets.takes import Names, check_names
from toolkit.io.files import parsed, read, write_whole

RECORD = "toolkit-data.json"  # in a fetched folder: what it is, whence and when, checksum, terms
ZENODO = "https://zenodo.org/records/8127870"
GITHUB = "https://codeload.github.com"


@dataclass(frozen=True)
class Origin:
    """The public home of a dataset."""

    title: str
    terms: str  # conditions of use
    url: str  # of the zip archive
    keep: re.Pattern  # matches the members that are unpacked; its group ``path`` is where to
    unpacked: int  # about how many bytes they have
    check: Callable[[Path], str]  # reads the folder as the package will, and says what it holds
    size: int | None = None  # of the archive, bytes
    sha256: str | None = None  # of the archive

    def place(self, member: str) -> str | None:
        """Where a member of the archive goes in the dataset's folder; None: it is left out."""
        match = self.keep.fullmatch(member)
        return match and match["path"]


def _check_100style(folder: Path) -> str:
    takes, cuts = style100.SOURCE.find(folder), style100.frame_cuts(folder)
    styles = style100.styles(folder)
    named = sum((take.style, take.gait) in cuts for take in takes)
    list(style100.SOURCE.read(takes[:1]))
    return f"{named} of the {len(cuts)} takes of {len(styles)} styles that its tables name"


def _check_bandai(folder: Path) -> str:
    takes = bandai.SOURCE.find(folder)
    list(bandai.SOURCE.read(takes[:1]))
    return f"{len(takes)} takes of {len({take.style for take in takes})} styles"


def _check_parameters(folder: Path) -> str:
    parameters.read(folder)
    return f"parameters of {parameters.N_STYLES} styles"


ORIGINS = {
    "100style": Origin(
        title="100STYLE: a hundred styles of locomotion, 4 million frames "
              "(Mason, Starke, Komura 2022)",
        terms=f'CC BY 4.0, credit "The 100STYLE Dataset - Ian Mason"; {ZENODO}',
        url=f"{ZENODO}/files/100STYLE.zip",
        keep=re.compile(r"(?:100STYLE/)?(?P<path>(?!__MACOSX/).+\.(?:bvh|csv|txt))"),
        unpacked=3_500_000_000,
        check=_check_100style,
        size=1_468_515_354,
        sha256="2c3b4017f8e2397ee6904c9b9f43551d8b426d39ddc3558d121fee9e55cb2d58",
    ),
    "lpn-film-100style": Origin(
        title="LPN-FiLM as trained by its authors, 100 styles (Mason, Starke, Komura 2022)",
        terms="research and education only, no commercial use, no redistribution; "
              "https://github.com/ianxmason/local-phases",
        url=f"{GITHUB}/ianxmason/local-phases/zip/f779488480182ba756db691c607893a8db558605",
        keep=re.compile(r"(?:.*/Parameters/(?:LPN|Multiclip_All_Velocity_100_FC)/)?"
                        r"(?P<path>[^/]+\.bin)"),
        unpacked=21_000_000,
        check=_check_parameters,
    ),
    "bandai": Origin(
        title="Bandai-Namco Research motion datasets 1 and 2: 22 styles of everyday motion "
              "(Bandai Namco Research 2022)",
        terms=f"CC BY-NC 4.0: no commercial use; {bandai.SOURCE.home}",
        url=f"{GITHUB}/BandaiNamcoResearchInc/Bandai-Namco-Research-Motiondataset/zip/"
            "74ead3ba1ae4696404e6086233779f60de8bf9ef",
        keep=re.compile(r"(?:[^/]+/dataset/)?"
                        r"(?P<path>(?!__MACOSX/|[^/]+/utils/).+(?:\.bvh|/LICENSE))"),
        unpacked=560_000_000,
        check=_check_bandai,
    ),
}


def find(name: str) -> Origin:
    """The origin of a dataset; ValueError if it has none."""
    if name not in ORIGINS:
        raise ValueError(f"{name!r} cannot be fetched; known: {', '.join(ORIGINS)}")
    return ORIGINS[name]


def record(folder: Path) -> dict | None:
    """What is known of a folder that was fetched, None for any other; ValueError if it is damaged.

    ``styles`` are those that were fetched one by one; empty if all were.
    """
    if not (folder / RECORD).is_file():
        return None
    try:
        return {"date": "", "found": "", "styles": []} | parsed(read(folder / RECORD))
    except (ValueError, TypeError) as error:
        raise ValueError(f"{folder / RECORD}: damaged; move the folder away to fetch it again"
                         ) from error


def has(known: dict, styles: list[str] | None) -> bool:
    """Whether a folder with this `record` has these styles; None: all."""
    some = known["styles"]
    return not some or (styles is not None and set(styles) <= set(some))


def fetch(name: str, root: str | os.PathLike | None = None,
          source: str | os.PathLike | None = None, sha256: str | None = None, *,
          styles: Names = None, progress: bool = False) -> dict:
    """Fetch a dataset, or go on where that was cut, unless it is there; returns its record.

    The record has name, title, source, date, sha256, terms, styles, files and found.

    Parameters
    ----------
    name
        A key of `ORIGINS`.
    root
        The dataset's folder; by default where everything looks for it.
    source
        A file, or the address of another copy, in place of the public home.
    sha256
        What the archive must have, in place of the published checksum.
    styles
        Of 100STYLE: only these are fetched, and added to those that are there. The server must send
        parts of files. Then nothing checks the whole archive: the address is secure, and the
        archive states the checksum (CRC-32) of each file.

    Raises
    ------
    ValueError
        If the folder is in use or holds something else, or what came is not what it should be:
        then it was removed (a file of the user's stays). See also `toolkit.datasets.download`.
    OSError
        If the server cannot be reached, or the disk has no room: then what came stays, and the
        same call goes on from there.
    """
    origin, folder = find(name), Path(root or home.folder(name)).absolute()
    source = str(source or origin.url)
    if styles is not None:
        styles = [styles] if isinstance(styles, str) else list(styles)
        if name != "100style":
            raise ValueError(f"single styles are fetched of 100style, not of {name}")
        if not styles:
            raise ValueError("styles names no style; None fetches all")
    folder.parent.mkdir(parents=True, exist_ok=True)
    work, lock = (folder.with_name(f".{folder.name}.{kind}") for kind in ("fetch", "lock"))
    try:
        with filelock.FileLock(lock, timeout=0):
            known = record(folder)
            if known is None or not has(known, styles):
                if not known and folder.is_dir() and any(folder.iterdir()):
                    raise ValueError(f"{folder}: holds something else; move it away, or give "
                                     "another folder (--root)")
                digest = _into(work, origin, source, sha256, styles, name, progress)
                if styles and known:
                    styles += known["styles"]
                about = {"name": name, "title": origin.title, "terms": origin.terms,
                         "source": source, "sha256": digest, "styles": sorted(set(styles or ()))}
                known = _place(work / "unpacked", folder, bool(known), origin, about)
            shutil.rmtree(work, ignore_errors=True)
            return known
    except filelock.Timeout as error:
        raise ValueError(f"{folder}: another process is fetching it (lock {lock}); wait for it"
                         ) from error


def _into(work: Path, origin: Origin, source: str, sha256: str | None, styles: list[str] | None,
          name: str, progress: bool) -> str:
    """Make a checked dataset in ``work / "unpacked"``.

    Returns the SHA-256 of the archive; empty if single styles were read on a server.
    """
    remote = source.startswith(("https://", "http://"))
    if not remote and not Path(source).is_file():
        raise ValueError(f"{source}: no such file; an address starts with https:// or http://")
    work.mkdir(mode=0o700, exist_ok=True)
    unpacked = work / "unpacked"
    try:
        # the archive, and its checksum
        file: BinaryIO
        digest, expected = "", (sha256 or origin.sha256 or "").lower()
        if remote and styles:  # of which only what is read is sent
            parts = RemoteFile(source)
            if not parts.ranges:
                raise ValueError(f"{source}: the server sends the whole file only; leave --styles "
                                 "out, or give another copy")
            if source == origin.url and parts.size != origin.size:
                raise ValueError(f"{source}: expected {origin.size} bytes, got {parts.size}")
            file = io.BufferedReader(parts, 1 << 16)
        else:
            path = Path(source)
            if remote:
                key = hashlib.sha256(f"{source} {expected}".encode()).hexdigest()
                path = work / f"{key[:16]}.zip"
                if not path.exists():
                    download(source, path, bool(expected), progress)
            with path.open("rb") as whole:
                digest = hashlib.file_digest(whole, "sha256").hexdigest()
            if expected and digest != expected:
                raise ValueError(f"{source}: expected the sha256 {expected}, got {digest} "
                                 f"({path.stat().st_size:,} bytes)")
            file = path.open("rb")
        with file, archive(file, source) as opened:
            # its files, which the package's own readers must understand
            inside = members(opened, origin.place)
            if styles:
                of = {path: match["style"] for path in inside
                      if (match := style100.SOURCE.pattern.fullmatch(PurePosixPath(path).name))}
                wanted = check_names(styles, set(of.values()), "style", name)
                inside = {path: info for path, info in inside.items()
                          if path not in of or of[path] in wanted}
            unpack(opened, inside, unpacked, progress)
        origin.check(unpacked)
    except ValueError as error:
        shutil.rmtree(work if remote and not styles else unpacked, ignore_errors=True)
        with contextlib.suppress(OSError):  # not empty: it holds what came of a download
            work.rmdir()
        fate = "nothing was changed"
        if remote:
            fate = "removed; the same command tries again, --from takes another copy"
        raise ValueError(f"{error}: refused ({fate})") from error
    return digest


def _place(unpacked: Path, folder: Path, added: bool, origin: Origin, about: dict) -> dict:
    """Give a new dataset its name, or add its files to those of a folder; returns its record."""
    place = folder if added else unpacked
    if added:
        shutil.copytree(unpacked, folder, dirs_exist_ok=True, copy_function=os.replace)
    files = sum(path.is_file() and path.name != RECORD for path in place.rglob("*"))
    known = about | {"date": datetime.now(UTC).isoformat(timespec="seconds"), "files": files,
                     "found": origin.check(place)}
    write_whole(place / RECORD, json.dumps(known, indent=2).encode())
    if not added:
        if folder.is_dir():  # an empty one, which Windows would not replace
            folder.rmdir()
        unpacked.replace(folder)
    return known
