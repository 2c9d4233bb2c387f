"""Kills, full disks and read-only folders: afterwards a file is the old one, the new one or absent.

Each job is a small run of a command that writes files, in a process of its own.
"""

import ctypes
import dataclasses
import functools
import hashlib
import importlib
import multiprocessing
import os
import random
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Annotated
from unittest import mock

import typer

from experiments.tables import Result, Store

JOBS = {"fetch": "`data fetch` (from a local server)", "preprocess": "`preprocess`",
        "train": "`train --resume --refit`",
        "export": "export: `.bvh`, `.html`, `.glb`, `.onnx`, page"}
FORK = multiprocessing.get_context("fork")  # Linux and macOS have it
SMALL = 50_000  # bytes, largest file on the "full" disk


@dataclass(frozen=True, eq=False)
class Job:
    """A job that is disturbed.

    ``work`` writes into a folder, and continues from the files in it. ``stage`` checks a file that
    is not in the reference or that grows, and raises ValueError for a damaged one. ``content`` is
    the part of a file that is equal in all runs.
    """

    name: str
    work: Callable[[Path], object]
    old: dict[str, bytes] = field(default_factory=dict)
    stage: Callable[[Path], object] | None = None
    staged: str = r"(?!)"  # names of files for ``stage``
    content: Callable[[bytes], object] = bytes

    def contents(self, folder: Path) -> dict[str, object]:
        """Contents of the files that are equal in all runs."""
        return {name: self.content(path.read_bytes()) for name, path in _files_of(folder)}

    def place(self, folder: Path) -> None:
        """Make a folder with only the old files."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name, data in self.old.items():
            (folder / name).write_bytes(data)

    def undisturbed(self, folder: Path) -> tuple[dict[str, object], float]:
        """Contents of the files of an undisturbed run, and its seconds."""
        for _ in range(2):  # the first run compiles and fills caches
            self.place(folder)
            began = time.perf_counter()
            finish(self.work, folder)
        return self.contents(folder), time.perf_counter() - began


@dataclass
class Score:
    """Counts over the kills of a job."""

    kills: int = 0
    lost: int = 0  # old files
    half: int = 0  # half-written files
    equal: int = 0  # results after another run


def run(
    kills: Annotated[int, typer.Option(min=1, help="Kills of each job, at random times.")] = 50,
    seed: Annotated[int, typer.Option(help="Seed of the times.")] = 0,
    only: Annotated[str | None,
                    typer.Option(help=f"Jobs: {', '.join(JOBS)}; default: all.")] = None,
    store: Store = False,
) -> None:
    """Files of jobs after kills and other faults, compared with those of undisturbed runs; exit
    status 1 if they differ.
    """
    chosen = [*JOBS] if only is None else only.split(",")
    if unknown := [name for name in chosen if name not in JOBS]:
        raise ValueError(f"unknown job {unknown[0]!r}; known: {', '.join(JOBS)}")
    failed = False
    with tempfile.TemporaryDirectory() as made:
        base = Path(made)
        base.chmod(0o755)
        for job in prepare(base):
            if job.name not in chosen:
                continue
            score = killed(job, base, kills, seed)
            print(f"{job.name}: {score}", flush=True)
            wrong = ", ".join(filter(None, (refused(job, base, full_disk),
                                            refused(job, base, read_only)))) or "ok"
            print(f"{job.name}: full disk, read-only folder: {wrong}", flush=True)
            failed |= bool(score.lost or score.half or score.equal < kills or wrong != "ok")
            if store:
                row = {"job": JOBS[job.name], **vars(score), "faults": wrong}
                dataclasses.replace(Result.load("faults"), rows=[row]).add()
    if failed:
        raise typer.Exit(1)


def killed(job: Job, base: Path, kills: int, seed: int = 0) -> Score:
    """Kill a job at random times, every second time while it writes; check the files; run the job
    to its end.
    """
    folder, score, rng = base / "disturbed", Score(), random.Random(f"{seed} {job.name}")
    reference, lasts = job.undisturbed(folder)
    patient = True  # waits for a temporary file, until a job ended before one was seen
    while score.kills < kills:
        job.place(folder)
        child = start(job.work, folder)
        time.sleep(rng.uniform(0, lasts))
        while patient and score.kills % 2 and not _writes(folder) and child.is_alive():
            time.sleep(0.0002)
        child.kill()
        child.join()
        if child.exitcode != -signal.SIGKILL:
            lasts, patient = 0.97 * lasts, False  # the job was finished
            continue
        score.kills, patient = score.kills + 1, True
        lost, half = _bad(job, folder, reference)
        score.lost, score.half = score.lost + len(lost), score.half + len(half)
        status, said = ended(start(job.work, folder), folder)
        equal = status == 0 and job.contents(folder) == reference
        score.equal += equal
        for problem in (*lost, *half, *([] if equal else [f"status {status}: {said[-300:]}"])):
            print(f"  {job.name}, kill {score.kills}: {problem}", file=sys.stderr)
    return score


def refused(job: Job, base: Path, fault: Callable[[Path], None]) -> str:
    """What is wrong about a job in a folder with a fault: nothing if it refuses in a line that
    names a file, and gives the same result when the fault is over.
    """
    folder = base / "disturbed"
    reference = job.undisturbed(folder)[0]
    job.place(folder)

    def work(folder: Path) -> None:
        fault(folder)
        job.work(folder)

    status, said = ended(start(work, folder), folder)
    folder.chmod(0o755)
    last = said.splitlines()[-1] if said else ""
    lost, half = _bad(job, folder, reference)
    wrong = [*lost, *half]
    if status != 2 or not last.startswith("error: ") or "/" not in last or "Traceback" in said:
        wrong.append(f"status {status}: {last}")
    if ended(start(job.work, folder), folder)[0] or job.contents(folder) != reference:
        wrong.append("differs from an undisturbed run afterwards")
    return ", ".join(wrong)


def full_disk(_: Path) -> None:
    """Files are limited to `SMALL` bytes; one that grows beyond is an error, and no signal."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (SMALL, SMALL))


def read_only(folder: Path) -> None:
    """Nothing can be written into the folder, not even by root, who gives up all capabilities."""
    folder.chmod(0o555)
    libc = ctypes.CDLL(None)
    if hasattr(libc, "capset"):
        libc.capset((ctypes.c_uint32 * 2)(0x20080522, 0), (ctypes.c_uint32 * 6)())


def _bad(job: Job, folder: Path, reference: dict[str, object]) -> tuple[list[str], list[str]]:
    """Missing old files, and files that are neither old nor new nor a valid intermediate state."""
    found = {name: path.read_bytes() for name, path in _files_of(folder)}
    lost, half = [f"{name} is lost" for name in job.old if name not in found], []
    for name, data in found.items():
        try:
            if re.fullmatch(job.staged, Path(name).name):
                job.stage(folder / name)
            elif data != job.old.get(name) and job.content(data) != reference.get(name):
                half.append(f"{name} is half-written")
        except ValueError as error:
            half.append(f"{name}: {error}")
    return lost, half


def _files_of(folder: Path) -> Iterator[tuple[str, Path]]:
    """Names and paths of all files that are not temporary."""
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder)
        if path.is_file() and not any(part.startswith(".") for part in name.parts):
            yield name.as_posix(), path


def _writes(folder: Path) -> bool:
    """Whether there is a temporary file."""
    return any(path.suffix != ".lock" for path in folder.rglob(".*"))


def start(work: Callable[[Path], object], folder: Path) -> BaseProcess:
    """Fork a process that does the work; its messages go to a file beside the folder."""

    def child() -> None:
        with folder.with_suffix(".log").open("w") as said, open(os.devnull, "w") as nothing:
            os.dup2(said.fileno(), 2)
            os.dup2(nothing.fileno(), 1)
        try:
            work(folder)
        except (ValueError, OSError) as error:
            print(f"error: {error}", file=sys.stderr)
            sys.exit(2)

    process = FORK.Process(target=child)
    process.start()
    return process


def ended(process: BaseProcess, folder: Path) -> tuple[int, str]:
    """Exit status and messages of a process."""
    process.join()
    said = folder.with_suffix(".log").read_text(encoding="utf-8", errors="replace")
    return process.exitcode, said


def finish(work: Callable[[Path], object], folder: Path) -> None:
    """Do the work without disturbance; ValueError if it fails."""
    status, said = ended(start(work, folder), folder)
    if status:
        raise ValueError(f"an undisturbed run failed: {said[-500:]}")


# The jobs --------------------------------------------------------------------------------------


def prepare(base: Path) -> list[Job]:
    """The jobs, and the files that they read."""
    import torch
    from archive_server import Server

    from toolkit import networks, training, view
    from toolkit.__main__ import VERBS
    from toolkit.datasets import procedural
    from toolkit.extra import store
    from toolkit.extra.engines import onnx
    from toolkit.extra.store import partition
    from toolkit.io import model_files, save as export

    torch.set_num_threads(1)
    root, stored, archive = base / "data", base / "store", base / "data.zip"
    for verb in ("data", "preprocess", "train"):
        importlib.import_module(VERBS[verb][0].split(":")[0])  # here, and not in the time of a job
    finish(lambda _: procedural.write(root, ["Neutral", "Zombie"], ["FW", "SW"], 5.0), root)
    finish(lambda _: store.preprocess("100style", root, stored, workers=1), stored)
    with zipfile.ZipFile(archive, "w") as packed:
        for path in sorted(root.iterdir()):
            packed.write(path, path.name)
    server = Server(archive.read_bytes(), pause=0.01)
    FORK.Process(target=server.serve_forever, daemon=True).start()
    digest = hashlib.sha256(archive.read_bytes()).hexdigest()
    sizes = networks.Sizes(hidden=64, film_channels=8, film_kernel=5, film_dense=64)
    quick = functools.partial(training.Config.quick, sizes=sizes)
    clips = procedural.load(["Neutral", "Zombie"], ["FW"], 20.0)
    model, bank = training.pretrained()

    def fetch(folder: Path) -> None:
        _command("data", "fetch", "100style", "--root", folder / "100style", "--from", server.url,
                 "--sha256", digest, "--yes")

    def preprocess(folder: Path) -> None:
        _command("preprocess", "--data", "100style", "--root", root, "--out", folder / "store",
                 "--workers", 1)

    def train(folder: Path) -> None:
        with (mock.patch.object(training.Config, "quick", quick),
              mock.patch("toolkit.training.checkpoint.SAVE_EVERY", 0.1)):
            _command("train", "--data", stored, "--out", folder / "run.safetensors", "--small",
                     "--epochs", 4, "--refit", 5, "--resume")

    def write(clip, folder: Path) -> None:
        for suffix in (".bvh", ".html", ".glb"):
            export.save(clip, folder / f"walk{suffix}", title=clip.style)
        onnx.save(model, folder / "network.onnx", bank)
        view.web(model, bank, folder / "page.html", title=clip.style)

    def manifest(path: Path) -> None:
        store._manifest(path.parent)
        for part in path.parent.glob("*.safetensors"):
            partition.read(part)

    old = base / "old"
    finish(lambda _: write(clips[1], old), old)
    old_files = {path.name: path.read_bytes() for path in old.iterdir()}
    return [
        Job("fetch", fetch, content=lambda data: re.sub(rb'"date": "[^"]*"', b"", data)),
        Job("preprocess", preprocess, stage=manifest, staged="manifest.json"),
        Job("train", train, {"run.safetensors": b"an older run"},
            lambda path: model_files.read(path, "checkpoint"), r".*\.checkpoint"),
        Job("export", functools.partial(write, clips[0]), old_files),
    ]


def _command(*words: object) -> None:
    from toolkit.__main__ import main

    sys.exit(main([str(word) for word in words]))
