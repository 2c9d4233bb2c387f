"""One input for one reader, and the result."""

import contextlib
import random
import signal
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from robustness.fuzz.mutations import Mutate

TIMES, ROOM = 10, 200_000_000  # bytes of memory for each byte of a file, and for any file


@dataclass(frozen=True)
class Reader:
    """A target: the path of its file, the function that reads it, valid files as seeds, and their
    mutation.

    ``read`` raises ValueError or OSError to refuse a file, and AssertionError if it accepted a
    wrong file. A refusal that matches ``deep`` (a regular expression) is about content after the
    file's header.
    """

    name: str
    path: Path
    read: Callable[[Path], object]
    seeds: tuple[bytes, ...]
    mutate: Mutate
    deep: str

    def input(self, seed: int, number: int) -> bytes:
        """Input ``number`` of a seed, independent of other inputs."""
        rng = random.Random(f"{self.name} {seed} {number}")
        return self.mutate(rng, rng.choice(self.seeds))

    def warm(self) -> None:
        """Read the first seed, so that no input pays for imports and for compiling functions."""
        self.path.write_bytes(self.seeds[0])
        with contextlib.suppress(ValueError, OSError):
            self.read(self.path)


class _Hang(BaseException):
    """The input exceeded its CPU time."""


def resident() -> int:
    """Bytes of memory that the process has now, from which its peak is counted again; 0 where the
    system cannot say.
    """
    try:
        Path("/proc/self/clear_refs").write_text("5", encoding="ascii")
    except OSError:
        return 0
    return _status("VmRSS")


def peak() -> int:
    """Largest number of bytes that the process has had since `resident`."""
    try:
        return _status("VmHWM")
    except OSError:
        return 0


def _status(key: str) -> int:
    line = next(x for x in Path("/proc/self/status").read_text(encoding="ascii").splitlines()
                if x.startswith(key))
    return 1024 * int(line.split()[1])


def trial(reader: Reader, data: bytes) -> tuple[str, str, float, int]:
    """Read one input: ``accepted``, ``refused`` or ``failed``; the message; CPU seconds per kB;
    bytes of memory.

    Reading may take `TIMES` times the input's bytes and `ROOM` in memory, where the system says how
    much it was.
    """

    def hang(*_) -> None:
        raise _Hang

    reader.path.unlink(missing_ok=True)  # the old file may still be mapped
    reader.path.write_bytes(data)
    size = max(1.0, len(data) / 1000)
    began = time.process_time()
    had, before = resident(), signal.signal(signal.SIGPROF, hang)
    signal.setitimer(signal.ITIMER_PROF, 1 + size)
    try:
        reader.read(reader.path)
        outcome, said = "accepted", ""
    except (ValueError, OSError) as error:
        signal.setitimer(signal.ITIMER_PROF, 0)
        outcome, said = "refused", str(error)
        if not said.isprintable():
            outcome, said = (
                "failed", f"not one printable line: {type(error).__name__} in {_place(error)}"
            )
        elif reader.path.name not in said and str(reader.path.parent) not in said:
            outcome, said = (
                "failed", f"does not name the file: {type(error).__name__} in {_place(error)}"
            )
    except (Exception, _Hang) as error:
        signal.setitimer(signal.ITIMER_PROF, 0)
        outcome, said = "failed", f"{type(error).__name__} in {_place(error)}"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
    taken = peak() - had if had else 0
    if taken > TIMES * len(data) + ROOM:
        outcome, said = "failed", f"takes {taken / 1e6:.0f} MB of memory"
    return outcome, said, (time.process_time() - began) / size, taken


def _place(error: BaseException) -> str:
    frames = [f for f in traceback.extract_tb(error.__traceback__) if "toolkit" in f.filename
              and "fuzz" not in f.filename]
    return f"{Path(frames[-1].filename).name}, {frames[-1].name}" if frames else str(error)[:200]
