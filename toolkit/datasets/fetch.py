"""Getting the public datasets from their homes: whole and checked, or not at all.

Nothing is taken for a dataset before it was checked: archive and unpacked files lie in a hidden folder beside the dataset's,
which takes its name in one step at the end, with `RECORD` in it. Killed at any time, the same call goes on.
"""

import contextlib
import hashlib
import json
import os
import re
import shutil
import stat
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import filelock

from toolkit.datasets import bandai, home, parameters, style100
from toolkit.datasets.download import download, notes, room, unpack
from toolkit.io import bvh
from toolkit.io.files import parsed, read, write_whole

LARGEST = 4_000_000_000  # bytes of an archive whose size is not known: GitHub's hold whole projects
RECORD = "toolkit-data.json"  # in a fetched folder: what it is, from where and when, its checksum and terms


@dataclass(frozen=True)
class Origin:
    """The public home of a dataset."""

    title: str
    terms: str  # conditions of use
    url: str  # of the zip archive
    keep: re.Pattern  # matches the members of the archive that are unpacked; its group ``path`` is where to
    unpacked: int  # about how many bytes they have; four times as many are refused
    check: Callable[[Path], str]  # reads the unpacked folder as the package will, and says what it holds
    size: int | None = None  # of the archive, bytes
    sha256: str | None = None  # of the archive
    contents: str | None = None  # `contents` of what is unpacked, where the archive is packed anew for each request

    def place(self, member: str) -> str | None:
        """Where a member of the archive goes in the dataset's folder; None for what is left out."""
        match = self.keep.fullmatch(member)
        return match and match["path"]


def _check_100style(folder: Path) -> str:
    takes, cuts, styles = style100.SOURCE.find(folder), style100.frame_cuts(folder), style100.styles(folder)
    named = sum((take.style, take.gait) in cuts for take in takes)
    bvh.load(takes[0].path, unit=bvh.CENTIMETRE, up="y")
    return f"{named} of the {len(cuts)} takes of {len(styles)} styles that its tables name"


def _check_bandai(folder: Path) -> str:
    takes = bandai.SOURCE.find(folder)
    bvh.load(takes[0].path, unit=bvh.CENTIMETRE, up="y")
    return f"{len(takes)} takes of {len({take.style for take in takes})} styles"


ORIGINS = {
    "100style": Origin(
        title="100STYLE: a hundred styles of locomotion, 4 million frames (Mason, Starke, Komura 2022)",
        terms='CC BY 4.0, credit "The 100STYLE Dataset - Ian Mason"; https://zenodo.org/records/8127870',
        url="https://zenodo.org/records/8127870/files/100STYLE.zip",
        keep=re.compile(r"(?:100STYLE/)?(?P<path>(?!__MACOSX/).+\.(?:bvh|csv|txt))"),
        unpacked=3_500_000_000,
        check=_check_100style,
        size=1_468_515_354,
        sha256="2c3b4017f8e2397ee6904c9b9f43551d8b426d39ddc3558d121fee9e55cb2d58",
    ),
    "lpn-film-100style": Origin(
        title="LPN-FiLM as trained by its authors, 100 styles (Mason, Starke, Komura 2022)",
        terms="research and education only, no commercial use, no redistribution; https://github.com/ianxmason/local-phases",
        url="https://codeload.github.com/ianxmason/local-phases/zip/f779488480182ba756db691c607893a8db558605",
        keep=re.compile(r"(?:.*/Parameters/(?:LPN|Multiclip_All_Velocity_100_FC)/)?(?P<path>[^/]+\.bin)"),
        unpacked=21_000_000,
        check=parameters.check,
        contents="0025d51a628eabedf58b44c5715dcb94b229ce923904050073bcd64eeea09006",
    ),
    "bandai": Origin(
        title="Bandai-Namco Research motion datasets 1 and 2: 22 styles of everyday motion (Bandai Namco Research 2022)",
        terms=f"CC BY-NC 4.0: no commercial use; {bandai.SOURCE.home}",
        url="https://codeload.github.com/BandaiNamcoResearchInc/Bandai-Namco-Research-Motiondataset/zip/"
            "74ead3ba1ae4696404e6086233779f60de8bf9ef",
        keep=re.compile(r"(?:[^/]+/dataset/)?(?P<path>(?!__MACOSX/|[^/]+/utils/).+(?:\.bvh|/LICENSE))"),
        unpacked=560_000_000,
        check=_check_bandai,
        contents="17d75e8b96a5e8693e179414af8240d4b9eac8ed6b660e170e65e93d6dc8cdc7",
    ),
}


def contents(folder: Path) -> str:
    """SHA-256 of the lines ``ID PATH`` of a folder's files, sorted by path; the ID is the one that git gives to the content.

    For the files of a commit, ``git ls-tree -r`` lists the same identifiers.
    """
    lines = []
    for path in sorted(folder.rglob("*"), key=lambda path: path.relative_to(folder).as_posix()):
        if path.is_file():
            digest = hashlib.sha1(b"blob %d\0" % path.stat().st_size, usedforsecurity=False)
            with path.open("rb") as file:
                while chunk := file.read(1 << 20):
                    digest.update(chunk)
            lines.append(f"{digest.hexdigest()} {path.relative_to(folder).as_posix()}\n")
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def record(folder: str | os.PathLike) -> dict | None:
    """What is known of a folder that was fetched, None for any other.

    ValueError if the record is damaged, or files were removed from the folder since.
    """
    folder = Path(folder)
    if not (folder / RECORD).is_file():
        return None
    try:
        known = parsed(read(folder / RECORD))
        if not all(known[key] >= 0 for key in ("files", "bytes")):
            raise ValueError("numbers below 0")
        if not all(known[key].isprintable() for key in ("date", "found", "source", "sha256")):
            raise ValueError("texts that cannot be shown")
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise ValueError(f"{folder / RECORD}: damaged; move the folder away to fetch it again") from error
    files, size = _extent(folder)
    if files < known["files"] or size < known["bytes"]:
        raise ValueError(f"{folder}: {known['files']} files of {known['bytes']:,} bytes were fetched, {files} of {size:,} "
                         "are left; move the folder away to fetch it again")
    return known


def fetch(name: str, root: str | os.PathLike | None = None, source: str | os.PathLike | None = None,
          sha256: str | None = None, *, progress: bool = False) -> dict:
    """Fetch a dataset, or go on where that was cut; nothing is done if it is there already. Returns the folder's record.

    The record has name, title, source, date, sha256, terms, files, bytes and found, and the comment of the archive.

    Parameters
    ----------
    name
        A key of `ORIGINS`.
    root
        The dataset's folder; by default where everything looks for it (`toolkit.datasets.home.folder`).
    source
        A file, or the address of another copy, in place of the public home.
    sha256
        What the archive must have, in place of the published checksum of the archive or of its contents.

    Raises
    ------
    ValueError
        If the dataset is unknown, the folder is in use or holds something else, an address is not https and the checksum of
        the archive is not known, or what came is not what it should be: then it was removed (a file of the user's stays).
    OSError
        If the server cannot be reached, or the disk has no room: then what came stays, and the same call goes on from there.
    """
    if name not in ORIGINS:
        raise ValueError(f"{name!r} cannot be fetched; known: {', '.join(ORIGINS)}")
    origin, folder = ORIGINS[name], Path(root or home.folder(name)).absolute()
    source = str(source or origin.url)
    folder.parent.mkdir(parents=True, exist_ok=True)
    work, lock = (folder.with_name(f".{folder.name}.{kind}") for kind in ("fetch", "lock"))
    try:
        with filelock.FileLock(lock, timeout=0):
            if not (known := record(folder)):
                if folder.is_dir() and any(folder.iterdir()):
                    raise ValueError(f"{folder}: holds something else; move it away, or give another folder (--root)")
                known = _into(work, origin, source, sha256, name, progress)
                if folder.is_dir():  # an empty one, which Windows would not replace
                    folder.rmdir()
                (work / "unpacked").replace(folder)
            shutil.rmtree(work, ignore_errors=True)
            return known
    except filelock.Timeout as error:
        raise ValueError(f"{folder}: another process is fetching it (lock {lock}); wait for it") from error
    except OSError as error:
        if error.errno and error.filename is None:
            raise OSError(error.errno, f"cannot be written ({error.strerror})", os.fspath(work)) from error
        raise


def _private(work: Path) -> None:
    """Make the folder of a download, or take the one that an earlier try left, so that nobody else can write to it.

    ValueError if somebody else may have put something there: a link, or anything of another user.
    """
    with contextlib.suppress(FileExistsError):
        work.mkdir(mode=0o700)
    _own(work, work, stat.S_ISDIR)
    work.chmod(0o700)
    for path in work.iterdir():
        _own(path, work, stat.S_ISDIR if path.name == "unpacked" else stat.S_ISREG)


def _own(path: Path, work: Path, kind: Callable[[int], bool]) -> None:
    found = path.lstat()
    foreign = hasattr(os, "geteuid") and found.st_uid != os.geteuid()
    if foreign or not kind(found.st_mode) or (stat.S_ISREG(found.st_mode) and found.st_nlink > 1):
        raise ValueError(f"{path}: is a link, or another user's; remove {work} to download in safety")


def _into(work: Path, origin: Origin, source: str, sha256: str | None, name: str, progress: bool) -> dict:
    """A checked dataset with its record in ``work / "unpacked"``."""
    limit, file, expected = 4 * origin.unpacked, Path(source), (sha256 or origin.sha256 or "").lower()
    remote = source.startswith(("https://", "http://"))
    if not remote and not file.is_file():
        raise ValueError(f"{source}: no such file; an address starts with https:// or http://")
    _private(work)
    if remote:
        file = work / "archive.zip"
        size = origin.size if expected == origin.sha256 else None
        if notes(file).get("url") != source:
            file.unlink(missing_ok=True)
        if not file.exists():
            part = work / "archive.part"
            have = part.stat().st_size if part.exists() else 0
            room(work, max((size or origin.unpacked) - have, 0) + origin.unpacked, f"fetch and unpack {name}")
            download(source, part, size, LARGEST, trusted=bool(expected), progress=progress)
            part.replace(file)
    with file.open("rb") as data:
        digest = hashlib.file_digest(data, "sha256").hexdigest()
    unpacked = work / "unpacked"
    shutil.rmtree(unpacked, ignore_errors=True)
    try:
        if expected and digest != expected:
            raise ValueError(f"{source}: expected the sha256 {expected}, got {digest} ({file.stat().st_size:,} bytes); "
                             "--sha256 accepts another archive")
        comment = unpack(file, unpacked, origin.place, limit, progress)
        found = origin.check(unpacked)
        if origin.contents and not sha256 and (inside := contents(unpacked)) != origin.contents:
            raise ValueError(f"{source}: expected files of the checksum {origin.contents}, got {inside}; "
                             "--sha256 accepts another archive")
    except ValueError as error:
        shutil.rmtree(work if remote else unpacked, ignore_errors=True)
        with contextlib.suppress(OSError):  # not empty: it holds what came of a download
            work.rmdir()
        fate = "removed; the same command tries again, --from takes another copy" if remote else "nothing was changed"
        raise ValueError(f"{error}: refused ({fate})") from error
    files, size = _extent(unpacked)
    date = datetime.now(UTC).isoformat(timespec="seconds")
    known = {"name": name, "title": origin.title, "terms": origin.terms, "source": source, "date": date, "sha256": digest,
             "comment": comment, "files": files, "bytes": size, "found": found}
    write_whole(unpacked / RECORD, json.dumps(known, indent=2).encode())
    return known


def _extent(folder: Path) -> list[int]:
    """Number and bytes of a folder's files, its record left out."""
    sizes = [path.stat().st_size for path in folder.rglob("*") if path.is_file() and path.name != RECORD]
    return [len(sizes), sum(sizes)]
