"""Fuzzing of all readers: mutated files and command lines, each of which must be read or refused with one clear line."""

import contextlib
import re
import tempfile
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
from tqdm import tqdm

SHARES = {"bvh": 0.3, "csv": 0.15, "gltf": 0.12, "fbx": 0.12, "amc": 0.12, "npz": 0.08, "model": 0.06, "store": 0.02,
          "cli": 0.03, "shot": 0.02}  # share of the inputs by target
ROOM = 1 << 30  # bytes of additional address space for reading; an input may take 10 times its size and 200 MB of memory


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


def run(
    inputs: Annotated[int, typer.Option(min=1, help="Number of all inputs; each target has its share.")] = 1_000_000,
    target: Annotated[str, typer.Option(help="bvh, csv, gltf, fbx, amc, npz, model, store, cli, shot, or all.")] = "all",
    seed: Annotated[int, typer.Option(help="The same seed gives the same inputs.")] = 0,
    out: Annotated[Path, typer.Option(help="Folder for inputs with failures.")] = Path("out/fuzz"),
) -> None:
    """Mutated files and command lines for all readers: each must be read or refused with one line, else exit status 1."""
    torch.set_num_threads(1)
    with tempfile.TemporaryDirectory() as folder:
        readers = targets.make(Path(folder), target)
        shares = {name: SHARES[name] / sum(SHARES[n] for n in readers) for name in readers}
        tallies = {name: fuzz(of, round(inputs * shares[name]), seed, name) for name, of in readers.items()}
    _print(tallies)
    if any(tally.failures for tally in tallies.values()):
        _keep(tallies, out)
        raise typer.Exit(1)


def fuzz(readers: list[Reader], inputs: int, seed: int, title: str = "") -> Tally:
    """Try ``inputs`` inputs, the same number for every reader."""
    tally, last = Tally(), readers[0]
    with warnings.catch_warnings(), _limited():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", UserWarning)
        for number in tqdm(range(inputs), desc=title, unit="input", disable=None):
            reader = readers[number * len(readers) // inputs]  # in turn: some need valid files of others
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
    return tally


def _kind(said: str) -> str:
    """A message without names and numbers of the input."""
    said = said.split(": ", 1)[-1] if ": " in said else said
    return re.sub(r"'[^']*'|\"[^\"]*\"|\([^)]*\)|[-+]?\d[\d.e+-]*", "…", said)[:60]


@contextlib.contextmanager
def _limited() -> Iterator[None]:
    """Limit the additional memory of the process to `ROOM` within the context, if the system can."""
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


def _print(tallies: dict[str, Tally]) -> None:
    print(f"{'target':<8}{'inputs':>10}{'accepted':>10}{'refused':>10}{'kinds':>7}{'deep':>10}{'s/kB':>8}{'MB':>9}"
          f"{'failed':>8}")
    for name, t in tallies.items():
        refused, failed = sum(t.refused.values()), sum(count for count, _ in t.failures.values())
        print(f"{name:<8}{t.inputs:>10,}{t.accepted:>10,}{refused:>10,}{len(+t.refused):>7}{t.deep:>10,}{t.slowest:>8.3f}"
              f"{t.memory:>9.0f}{failed:>8,}")
    print("deep: read, or refused because of content after the header; s/kB: CPU time of the slowest; MB: most memory")
    for name, t in tallies.items():
        for kind, count in t.refused.most_common(8):
            print(f"  {name:<6}{count:>9,}  {kind}")


def _keep(tallies: dict[str, Tally], out: Path) -> None:
    out.mkdir(parents=True, exist_ok=True)
    for name, tally in tallies.items():
        for i, (said, (count, data)) in enumerate(tally.failures.items()):
            path = out / f"{name}-{i}.input"
            path.write_bytes(data)
            print(f"FAILED {count:,} times, input in {path}: {said}")
