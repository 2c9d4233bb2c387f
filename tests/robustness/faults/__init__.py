"""Kills, full disks, read-only folders, two processes: afterwards a file is the old one, the new
one or absent.
"""

import contextlib
import dataclasses
import os
import random
import re
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import torch
import typer
from robustness.faults.jobs import Job, ended, files_of, prepare, start

from experiments.tables import Result

JOBS = {"fetch": "`data fetch` (from a local server)", "preprocess": "`preprocess`",
        "train": "`train --resume --refit`",
        "export": "export: `.bvh`, `.html`, `.glb`, `.onnx`, page"}
COLUMNS = {"job": ["job"], "kills": ["kills", 0], "writing": ["while a temporary file existed", 0],
           "lost": ["old files lost", 0], "half": ["files half-written", 0],
           "equal": ["result equal to that of an undisturbed run", 0],
           "faults": ["full disk, read-only folder, two at once"]}
SMALL = 50_000  # bytes, largest file on the "full" disk


@dataclass
class Score:
    """Counts: kills, kills with a temporary file, lost and half-written files, equal results, left
    temporary files.
    """

    kills: int = 0
    writing: int = 0
    lost: int = 0
    half: int = 0
    equal: int = 0

    @property
    def passed(self) -> bool:
        """Nothing was lost, half-written or different."""
        return not self.lost and not self.half and self.equal == self.kills


def run(
    kills: Annotated[int, typer.Option(min=1, help="Kills of each job, at random times.")] = 50,
    seed: Annotated[int, typer.Option(help="Seed of the times.")] = 0,
    only: Annotated[str | None,
                    typer.Option(help=f"Jobs: {', '.join(JOBS)}; default: all.")] = None,
    store: Annotated[bool,
                     typer.Option("--store",
                                  help="Put the rows of these jobs into the result that the "
                                       "documentation "
                                        "shows.")] = False,
) -> None:
    """Files of jobs after kills and other faults, compared with those of undisturbed runs; exit
    status 1 if they differ.
    """
    if not hasattr(os, "fork"):
        raise ValueError("this measurement needs a system that can fork: Linux or macOS")
    chosen = [*JOBS] if only is None else only.split(",")
    if unknown := [name for name in chosen if name not in JOBS]:
        raise ValueError(f"unknown job {unknown[0]!r}; known: {', '.join(JOBS)}")
    torch.set_num_threads(1)
    bad = []
    with tempfile.TemporaryDirectory() as made, contextlib.ExitStack() as ends:
        base = Path(made)
        base.chmod(0o755)
        jobs = [job for job in prepare(base, ends) if job.name in chosen]
        print("writing: kills while a temporary file existed; lost: missing old files; half: "
              "files that are neither the old")
        print("nor the new one; equal: the next run gives the files of an undisturbed run")
        print(f"{'kill -9':<12}{'kills':>7}{'writing':>9}{'lost':>6}{'half':>6}{'equal':>7}"
              f"{'s':>6}")
        for job in jobs:
            began, score = time.perf_counter(), killed(job, base, kills, seed)
            print(f"{job.name:<12}{score.kills:>7}{score.writing:>9}{score.lost:>6}"
                  f"{score.half:>6}{score.equal:>7}"
                  f"{time.perf_counter() - began:>6.0f}", flush=True)
            wrongs = [] if score.passed else [f"{job.name}: killed"]
            for fault in (full_disk, read_only, two_at_once):
                said, wrong = fault(job, base)
                said = (said.splitlines() or [""])[-1].replace(str(base), "…")
                print(f"{job.name:<12}{fault.__name__.replace('_', ' '):<14}{wrong or 'ok':<12}"
                      f"{said[:150]}", flush=True)
                wrongs += [f"{job.name}: {fault.__name__}"] if wrong else []
            if store:
                _store({"job": JOBS[job.name], **vars(score), "faults": ", ".join(wrongs) or "ok"})
            bad += wrongs
    if bad:
        print(f"FAILED: {', '.join(bad)}")
        raise typer.Exit(1)


def _store(row: dict) -> None:
    """Put the row of a job into the stored result."""
    made = Result.load("faults")
    rows = [row if old["job"] == row["job"] else old for old in made.rows]
    dataclasses.replace(made, rows=rows,
                        command="python -m experiments faults --only JOB --kills N --store").save()


def killed(job: Job, base: Path, kills: int, seed: int = 0) -> Score:
    """Kill a job at random times, every second time while it writes; check the files; run the job
    to its end.

    A job that ends before a temporary file was seen is started again; after two such ends the
    moment is random.
    """
    folder, score, rng, missed = base / "disturbed", Score(), random.Random(f"{seed} {job.name}"), 0
    reference, lasts = job.undisturbed(base)
    while score.kills < kills:
        job.place(folder)
        child = start(job.work, folder)
        time.sleep(rng.uniform(0, lasts))
        while score.kills % 2 and missed < 2 and not _temporary(folder) and _runs(child):
            time.sleep(0.0002)
        os.kill(child, signal.SIGKILL)
        if not os.WIFSIGNALED(os.waitpid(child, 0)[1]):
            lasts, missed = 0.97 * lasts, missed + 1  # the job was finished
            continue
        score.kills, missed = score.kills + 1, 0
        score.writing += bool(_temporary(folder))
        lost, half = _bad(job, folder, reference)
        score.lost, score.half = score.lost + len(lost), score.half + len(half)
        status, said = ended(start(job.work, folder), folder)
        equal = status == 0 and job.contents(folder) == reference
        score.equal += equal
        for problem in (*lost, *half,
                        *([] if equal else [f"different result, status {status}: {said[-300:]}"])):
            print(f"  {job.name}, kill {score.kills}: {problem}", file=sys.stderr)
    return score


def full_disk(job: Job, base: Path) -> tuple[str, str]:
    """Files are limited to `SMALL` bytes, then unlimited again."""
    import resource

    def work(folder: Path) -> None:
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (SMALL, SMALL))
        job.work(folder)

    return _refused(job, work, base)


def read_only(job: Job, base: Path) -> tuple[str, str]:
    """The folder is read-only, then writable again."""

    def work(folder: Path) -> None:
        folder.chmod(0o555)
        _no_superuser()
        job.work(folder)

    return _refused(job, work, base)


def _no_superuser() -> None:
    """Give up the capability CAP_DAC_OVERRIDE, which allows root to write read-only files."""
    import ctypes

    libc = ctypes.CDLL(None)
    if hasattr(libc, "capset"):
        header, sets = (ctypes.c_uint32 * 2)(0x20080522, 0), (ctypes.c_uint32 * 6)()
        libc.capget(header, sets)
        sets[0] &= ~(1 << 1)
        libc.capset(header, sets)


def two_at_once(job: Job, base: Path) -> tuple[str, str]:
    """Two equal processes at the same time: both finish, or one refuses, and the files are
    whole.
    """
    folder = base / "disturbed"
    reference = job.undisturbed(base)[0]
    job.place(folder)
    children = [start(job.work, folder, log) for log in ("one", "two")]
    ends = [ended(child, folder, log) for child, log in zip(children, ("one", "two"), strict=True)]
    said = " ".join(said for status, said in ends if status)
    wrong = []
    if all(status for status, _ in ends) or any(status and not _one_line(said)
                                                for status, said in ends):
        wrong.append(f"status {[status for status, _ in ends]}")
    if job.contents(folder) != reference:
        wrong.append("files differ")
    return said.strip() or "both finished", ", ".join(wrong)


def _refused(job: Job, work: Callable[[Path], object], base: Path) -> tuple[str, str]:
    folder, reference = base / "disturbed", job.undisturbed(base)[0]
    job.place(folder)
    status, said = ended(start(work, folder), folder)
    folder.chmod(0o755)
    lost, half = _bad(job, folder, reference)
    wrong = [*lost, *half] + ([] if status == 2 and _one_line(said) else [f"status {status}"])
    status, _ = ended(start(job.work, folder), folder)
    if status or job.contents(folder) != reference:
        wrong.append("differs from an undisturbed run afterwards")
    return said.strip(), ", ".join(wrong)


def _bad(job: Job, folder: Path, reference: dict[str, object]) -> tuple[list[str], list[str]]:
    """Missing old files, and files that are neither old nor new nor a valid intermediate state."""
    found = {name: path.read_bytes() for name, path in files_of(folder)}
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


def _temporary(folder: Path) -> list[Path]:
    return [path for path in folder.rglob(".*") if path.suffix != ".lock"]


def _runs(child: int) -> bool:
    return os.waitid(os.P_PID, child, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None


def _one_line(said: str) -> bool:
    """Whether the last line, after a progress bar, is an error that names a file."""
    last = said.splitlines()[-1] if said else ""
    return last.startswith("error: ") and "/" in last and "Traceback" not in said
