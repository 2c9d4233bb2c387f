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
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

import filelock

from toolkit.datasets import archive, bandai, home, style100
from toolkit.datasets.download import download, notes
from toolkit.io import bvh
from toolkit.io.files import atomic_write

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


def _check_published(folder: Path) -> str:
    """All files are there and of the right size; `toolkit.published.load` reads their numbers."""
    widths = {"X": 348, "Y": 342, "GT_X": 8}
    sizes = {f"{name}{part}": n for name, n in widths.items() for part in ("mean", "std")}
    sizes |= {f"Style_{i:03d}_{part}": 512 for i in range(100) for part in ("scale1", "shift1", "scale2", "shift2")}
    for layer, (n_in, n_out) in enumerate(((348, 512), (512, 512), (512, 342))):
        sizes |= {f"cp{layer}_{kind}{k}": n_out * (n_in if kind == "a" else 1) for kind in "ab" for k in range(8)}
    for layer, (n_in, n_out) in enumerate(((8, 32), (32, 32), (32, 8))):
        sizes |= {f"wc{layer}_w": n_out * n_in, f"wc{layer}_b": n_out}
    for name, n in sizes.items():
        path = folder / f"{name}.bin"
        if not path.is_file() or path.stat().st_size != 4 * n:
            raise ValueError(f"{path}: expected {n} float32 numbers")
    return "parameters of 100 styles"


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
        keep=re.compile(r"(?:.*/Parameters/LPN/)?(?P<path>[^/]+\.bin)"),
        unpacked=21_000_000,
        check=_check_published,
    ),
    "bandai": Origin(
        title="Bandai-Namco Research motion datasets 1 and 2: 22 styles of everyday motion (Bandai Namco Research 2022)",
        terms=f"CC BY-NC 4.0: no commercial use; {bandai.SOURCE.home}",
        url="https://codeload.github.com/BandaiNamcoResearchInc/Bandai-Namco-Research-Motiondataset/zip/refs/heads/master",
        keep=re.compile(r"(?:[^/]+/dataset/)?(?P<path>(?!__MACOSX/).+(?:\.bvh|/LICENSE))"),
        unpacked=560_000_000,
        check=_check_bandai,
    ),
}


def record(folder: str | os.PathLike) -> dict | None:
    """What is known of a folder that was fetched, None for any other; ValueError if files were removed from it since."""
    folder = Path(folder)
    if not (folder / RECORD).is_file():
        return None
    known = json.loads((folder / RECORD).read_text(encoding="utf-8"))
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
        What the archive must have, in place of the published checksum.

    Raises
    ------
    ValueError
        If the dataset is unknown, the folder is in use or holds something else, or what came is not what it should be: then
        it was removed (a file of the user's stays).
    OSError
        If the server cannot be reached, or the disk has no room: then what came stays, and the same call goes on from there.
    """
    if name not in ORIGINS:
        raise ValueError(f"{name!r} cannot be fetched; known: {', '.join(ORIGINS)}")
    origin, folder = ORIGINS[name], Path(root or home.folder(name)).absolute()
    source, expected = str(source or origin.url), sha256 or origin.sha256 or ""
    folder.parent.mkdir(parents=True, exist_ok=True)
    work, lock = (folder.with_name(f".{folder.name}.{kind}") for kind in ("fetch", "lock"))
    try:
        with filelock.FileLock(lock, timeout=0):
            if not (known := record(folder)):
                if folder.is_dir() and any(folder.iterdir()):
                    raise ValueError(f"{folder}: holds something else; move it away, or give another folder (--root)")
                known = _into(work, origin, source, expected.lower(), name, progress)
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


def _into(work: Path, origin: Origin, source: str, expected: str, name: str, progress: bool) -> dict:
    """A checked dataset with its record in ``work / "unpacked"``."""
    limit, file = 4 * origin.unpacked, Path(source)
    remote = source.startswith(("https://", "http://"))
    if not remote and not file.is_file():
        raise ValueError(f"{source}: no such file; an address starts with https:// or http://")
    work.mkdir(exist_ok=True)
    if remote:
        file = work / "archive.zip"
        size = origin.size if expected == origin.sha256 else None
        if notes(file).get("url") != source:
            file.unlink(missing_ok=True)
        if not file.exists():
            part = work / "archive.part"
            have = part.stat().st_size if part.exists() else 0
            archive.room(work, max((size or origin.unpacked) - have, 0) + origin.unpacked, f"fetch and unpack {name}")
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
        comment = archive.unpack(file, unpacked, origin.place, limit, progress)
        found = origin.check(unpacked)
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
    with atomic_write(unpacked / RECORD) as out:
        out.write(json.dumps(known, indent=2).encode())
    return known


def _extent(folder: Path) -> list[int]:
    """Number and bytes of a folder's files, its record left out."""
    sizes = [path.stat().st_size for path in folder.rglob("*") if path.is_file() and path.name != RECORD]
    return [len(sizes), sum(sizes)]
