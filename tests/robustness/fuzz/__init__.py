"""Fuzzing of all readers: mutated files and command lines, each of which must be read or refused
with one clear line.
"""

import contextlib
import random
import signal
import tempfile
import time
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments import tables

TARGETS = {
    "bvh": "BVH files",
    "csv": "archive and tables of 100STYLE, `labels.csv`",
    "gltf": "glTF, VRM, meshes", "fbx": "FBX", "npz": "NumPy motion files",
    "model": "models, checkpoints, stylizers, recognisers, published parameters", "store": "stores",
    "shot": "files of shots, splits", "cli": "command lines"}
COLUMNS = {"target": ["target"], "readers": ["readers", 0], "inputs": ["inputs", 0],
           "read": ["read", 0], "refused": ["refused", 0], "failed": ["failed", 0]}
ROOM = 1 << 30  # bytes of additional address space for reading
SECONDS = 1.0  # of the processor for a kilobyte of input, and twice as much at least


@dataclass(frozen=True)
class Reader:
    """A function that reads a file, with valid files as seeds, and how these are mutated.

    ``read`` raises ValueError or OSError to refuse a file, and AssertionError if it accepted a
    wrong file.
    """

    name: str
    path: Path  # of the file
    read: Callable[[Path], object]
    seeds: tuple[bytes, ...]
    mutate: Callable[[random.Random, bytes], bytes]

    def input(self, seed: int, number: int) -> bytes:
        """Input ``number`` of a seed, independent of other inputs."""
        rng = random.Random(f"{self.name} {seed} {number}")
        return self.mutate(rng, rng.choice(self.seeds))


@dataclass
class Tally:
    """Results of a target: counts of inputs, read, refused and failed; failures in words."""

    counts: Counter = field(default_factory=Counter)
    failures: dict[str, bytes] = field(default_factory=dict)  # what failed: its shortest input


def run(
    inputs: Annotated[int, typer.Option(min=1, help="Number of inputs of each reader.")] = 50_000,
    target: Annotated[str, typer.Option(help=f"{', '.join(TARGETS)}, or all.")] = "all",
    seed: Annotated[int, typer.Option(help="The same seed gives the same inputs.")] = 0,
    out: Annotated[Path, typer.Option(help="Folder for inputs with failures.")] = Path("out/fuzz"),
    store: tables.Store = False,
) -> None:
    """Mutated files and command lines for all readers: each must be read or refused with one line,
    else exit status 1.
    """
    from robustness.fuzz import targets

    torch.set_num_threads(1)
    began, rows = time.process_time(), []
    with tempfile.TemporaryDirectory() as folder:
        for name, readers in targets.make(Path(folder), target).items():
            tally = fuzz(readers, inputs * len(readers), seed)
            counts = {key: tally.counts[key] for key in [*COLUMNS][2:]}
            rows.append({"target": TARGETS[name], "readers": len(readers), **counts})
            print(tables.line(COLUMNS, rows[-1]), flush=True)
            for i, (said, data) in enumerate(tally.failures.items()):
                path = out / f"{name}-{i}.input"
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
                print(f"FAILED, shortest input in {path}: {said}", flush=True)
    made, failed = (sum(row[key] for row in rows) for key in ("inputs", "failed"))
    minutes = (time.process_time() - began) / 60
    print(f"{made:,} inputs, {failed} failed, {minutes:.1f} minutes of processor time")
    if store:
        tables.Result("fuzz", f"Mutated files and command lines, seed {seed}; one thread.",
                      f"python -m experiments fuzz --inputs {inputs} --seed {seed}", COLUMNS, rows,
                      {"inputs": inputs, "seed": seed},
                      {"inputs": made, "failed": failed, "minutes": minutes}).save()
    if failed:
        raise typer.Exit(1)


def fuzz(readers: list[Reader], inputs: int, seed: int) -> Tally:
    """Try ``inputs`` inputs, the same number for every reader."""
    tally = Tally()
    with warnings.catch_warnings(action="error"), limited():
        warnings.simplefilter("ignore", UserWarning)
        for reader in readers:
            for number in range(inputs // len(readers)):
                data = reader.input(seed, number)
                outcome, said = trial(reader, data)
                tally.counts.update({"inputs": 1, outcome: 1})
                if outcome == "failed":
                    shortest = tally.failures.get(f"{reader.name}: {said}", data)
                    tally.failures[f"{reader.name}: {said}"] = min(shortest, data, key=len)
            reader.path.write_bytes(reader.seeds[0])  # some need valid files of others
    return tally


class _Hang(BaseException):
    """The input exceeded its CPU time."""


def trial(reader: Reader, data: bytes) -> tuple[str, str]:
    """Read one input in a second a kilobyte: ``read``, ``refused`` or ``failed``; the message."""

    def hang(*_) -> None:
        raise _Hang

    reader.path.unlink(missing_ok=True)  # the old file may still be mapped
    reader.path.write_bytes(data)
    before = signal.signal(signal.SIGPROF, hang)
    signal.setitimer(signal.ITIMER_PROF, SECONDS * (1 + max(1.0, len(data) / 1000)))
    try:
        reader.read(reader.path)
        return "read", ""
    except (ValueError, OSError) as error:
        said = str(error)
        if not said.isprintable():
            return "failed", f"not one printable line: {_place(error)}"
        if reader.path.name not in said and str(reader.path.parent) not in said:
            return "failed", f"does not name the file: {_place(error)}"
        return "refused", said
    except (Exception, _Hang) as error:
        return "failed", _place(error)
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def _place(error: BaseException) -> str:
    """The kind of an error, and the last function of the toolkit in its traceback."""
    frames = [f for f in traceback.extract_tb(error.__traceback__) if "toolkit" in f.filename
              and "fuzz" not in f.filename]
    place = f"{Path(frames[-1].filename).name}, {frames[-1].name}" if frames else str(error)[:200]
    return f"{type(error).__name__} in {place}"


@contextlib.contextmanager
def limited() -> Iterator[None]:
    """Limit the additional memory of the process to `ROOM` within the context, if the system
    can.
    """
    try:
        import resource

        pages = int(Path("/proc/self/statm").read_text(encoding="utf-8").split()[0])
    except (ImportError, OSError):
        yield
        return
    before = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (pages * resource.getpagesize() + ROOM, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_AS, before)
