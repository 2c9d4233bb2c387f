"""Fuzzing of all readers: mutated files and command lines, each of which must be read or refused
with one clear line.
"""

import contextlib
import re
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import torch
import typer
from robustness.fuzz import targets
from robustness.fuzz.trials import Reader, trial

from experiments import tables

TARGETS = {
    "bvh": "BVH files, and the numbers in them", "csv": "tables of 100STYLE, `labels.csv`",
    "gltf": "glTF, VRM, meshes",
    "fbx": "FBX", "npz": "NumPy motion files",
    "model": "models, checkpoints, stylizers, recognisers, published parameters", "store": "stores",
    "shot": "files of shots, splits", "cli": "command lines"}
COLUMNS = {"target": ["target"], "readers": ["readers", 0], "inputs": ["inputs", 0],
           "read": ["read", 0],
           "refused": ["refused", 0], "deep": ["past the header", 0],
           "slowest": ["slowest, s/kB", 3],
           "memory": ["memory, MB", 0], "failed": ["failed", 0]}
# inputs of a reader before the next one has its turn, so that a run that is stopped tried all of
# them
ROUND = 250
# bytes of additional address space for reading; an input may take 10 times its size and 200 MB of
# memory
ROOM = 1 << 30


@dataclass
class Tally:
    """Results of a target; ``failures`` maps a failure to its count and its shortest input."""

    inputs: int = 0
    accepted: int = 0
    deep: int = 0
    refused: Counter = field(default_factory=Counter)
    slowest: float = 0.0
    memory: float = 0.0
    failures: dict[str, tuple[int, bytes]] = field(default_factory=dict)

    def row(self) -> dict[str, float]:
        """The counts by their columns."""
        return {"inputs": self.inputs, "read": self.accepted, "refused": self.refused.total(),
                "deep": self.deep,
                "slowest": self.slowest, "memory": self.memory,
                "failed": sum(count for count, _ in self.failures.values())}


def run(
    inputs: Annotated[int, typer.Option(min=1, help="Number of inputs of each reader.")] = 50_000,
    target: Annotated[str, typer.Option(help=f"{', '.join(TARGETS)}, or all.")] = "all",
    seed: Annotated[int, typer.Option(help="The same seed gives the same inputs.")] = 0,
    out: Annotated[Path, typer.Option(help="Folder for inputs with failures.")] = Path("out/fuzz"),
    store: Annotated[bool,
                     typer.Option("--store",
                                  help="Write the result that the documentation shows.")] = False,
) -> None:
    """Mutated files and command lines for all readers: each must be read or refused with one line,
    else exit status 1.
    """
    torch.set_num_threads(1)
    began = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        readers = targets.make(Path(folder), target)
        tallies = {name: Tally() for name in readers}
        for done in range(0, inputs, ROUND):
            for name, of in readers.items():
                fuzz(of, min(ROUND, inputs - done) * len(of), seed + done // ROUND, tallies[name])
                _keep(name, tallies[name], out)
            rows = [{"target": name, "readers": len(readers[name]), **tally.row()}
                    for name, tally in tallies.items()]
            minutes = (time.process_time() - began) / 60
            made, failed = (sum(row[key] for row in rows) for key in ("inputs", "failed"))
            print(f"{made:,} inputs, {failed} failed, {minutes:.1f} minutes of processor time",
                  flush=True)
            if store:
                _result(rows, inputs, seed,
                        {"inputs": made, "failed": failed, "minutes": minutes}).save()
    print("".join(f"{title:>16}" for title, *_ in COLUMNS.values()))
    for row in rows:
        print("".join(f"{tables.cell(value, *COLUMNS[key][1:]):>16}" for key, value in row.items()))
    for name, tally in tallies.items():
        for kind, count in tally.refused.most_common(8):
            print(f"  {name:<6}{count:>9,}  {kind}")
    if failed:
        raise typer.Exit(1)


def fuzz(readers: list[Reader], inputs: int, seed: int, tally: Tally | None = None) -> Tally:
    """Try ``inputs`` inputs, the same number for every reader; their counts are added to
    ``tally``.
    """
    tally, last = tally or Tally(), readers[0]
    with warnings.catch_warnings(), limited():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", UserWarning)
        for number in range(inputs):
            # in turn: some need valid files of others
            reader = readers[number * len(readers) // inputs]
            if reader is not last:
                last.path.write_bytes(last.seeds[0])
                last = reader
            data = reader.input(seed, number)
            outcome, said, cost, taken = trial(reader, data)
            tally.inputs += 1
            tally.slowest = max(tally.slowest, cost)
            tally.memory = max(tally.memory, taken / 1e6)
            if outcome == "failed":
                said = f"{reader.name}: {said}"
                count, shortest = tally.failures.get(said, (0, data))
                tally.failures[said] = count + 1, min(shortest, data, key=len)
                continue
            tally.accepted += outcome == "accepted"
            tally.deep += outcome == "accepted" or bool(re.search(reader.deep, said))
            tally.refused[_kind(said)] += outcome == "refused"
    last.path.write_bytes(last.seeds[0])
    return tally


def _kind(said: str) -> str:
    """A message without names and numbers of the input."""
    said = said.split(": ", 1)[-1] if ": " in said else said
    return re.sub(r"'[^']*'|\"[^\"]*\"|\([^)]*\)|[-+]?\d[\d.e+-]*", "…", said)[:60]


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


def _result(rows: list[dict], inputs: int, seed: int, numbers: dict[str, float]) -> tables.Result:
    """What the documentation shows."""
    about = (f"Mutated files and command lines; seeds {seed} to {seed + (inputs - 1) // ROUND}, "
             f"one for each {ROUND} inputs "
             "of a reader; one thread.")
    rows = [row | {"target": TARGETS[row["target"]]} for row in rows]
    return tables.Result("fuzz", about,
                         f"python -m experiments fuzz --inputs {inputs} --seed {seed}", COLUMNS,
                         rows,
                         {"inputs": inputs, "seed": seed}, numbers)


def _keep(name: str, tally: Tally, out: Path) -> None:
    """Write the shortest input of each failure."""
    for i, (said, (count, data)) in enumerate(tally.failures.items()):
        path = out / f"{name}-{i}.input"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        print(f"FAILED {count:,} times, shortest input in {path}: {said}", flush=True)
