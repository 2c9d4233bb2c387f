"""One input for one reader, and how it went."""

import random
import signal
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from robustness.fuzz.mutations import Mutate


@dataclass(frozen=True)
class Reader:
    """What is fuzzed: the file's path, how to read it, whole files to start from, and how to spoil them.

    ``read`` raises ValueError or OSError for what it refuses, and AssertionError where it accepted what it should not.
    A refusal that matches ``deep`` (a regular expression) came from behind the file's header.
    """

    name: str
    path: Path
    read: Callable[[Path], object]
    seeds: tuple[bytes, ...]
    mutate: Mutate
    deep: str

    def input(self, seed: int, number: int) -> bytes:
        """Input ``number`` of a seed, the same whatever came before."""
        rng = random.Random(f"{self.name} {seed} {number}")
        return self.mutate(rng, rng.choice(self.seeds))


class _Hang(BaseException):
    """More processor time than an input may take."""


def trial(reader: Reader, data: bytes) -> tuple[str, str, float]:
    """Read one input: ``accepted``, ``refused`` or ``failed``; what was said; CPU seconds per kB (from 1 kB on)."""

    def hang(*_) -> None:
        raise _Hang

    reader.path.unlink(missing_ok=True)  # never write into what may still be mapped
    reader.path.write_bytes(data)
    size = max(1.0, len(data) / 1000)
    began = time.process_time()
    before = signal.signal(signal.SIGPROF, hang)
    signal.setitimer(signal.ITIMER_PROF, size)
    try:
        reader.read(reader.path)
        outcome, said = "accepted", ""
    except (ValueError, OSError) as error:
        signal.setitimer(signal.ITIMER_PROF, 0)
        outcome, said = "refused", str(error)
        if not said.isprintable():
            outcome, said = "failed", f"not one printable line: {type(error).__name__} in {_place(error)}"
        elif reader.path.name not in said and str(reader.path.parent) not in said:
            outcome, said = "failed", f"does not name the file: {type(error).__name__} in {_place(error)}"
    except (Exception, _Hang) as error:
        signal.setitimer(signal.ITIMER_PROF, 0)
        outcome, said = "failed", f"{type(error).__name__} in {_place(error)}"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
    return outcome, said, (time.process_time() - began) / size


def _place(error: BaseException) -> str:
    frames = [f for f in traceback.extract_tb(error.__traceback__) if "toolkit" in f.filename and "fuzz" not in f.filename]
    return f"{Path(frames[-1].filename).name}, {frames[-1].name}" if frames else str(error)[:200]
