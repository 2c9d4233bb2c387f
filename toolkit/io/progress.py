"""Progress of long work: a bar in a terminal or a notebook; in a file, a line now and then."""

import sys
from typing import Any, TextIO

from tqdm import tqdm

FIRST, SHARE, LAST = 10.0, 0.5, 1800.0  # first line, s; pause / time so far; longest pause, s


class _Log:
    """A stream that gets each state of a bar as a line of its own."""

    def __init__(self, stream: TextIO):
        self.stream, self.last = stream, ""

    def write(self, text: str) -> None:
        if text.strip() not in ("", self.last):
            self.last = text.strip()
            self.stream.write(f"{self.last}\n")

    def __getattr__(self, name: str) -> Any:
        return getattr(self.stream, name)


class _Lines(tqdm):
    """A bar that is drawn ever more seldom, as a line each time: 10 in ten minutes, 60 in a day."""

    def __iter__(self):
        with self:
            for item in self.iterable:
                yield item
                self.update()

    def display(self, *arguments, **options) -> None:
        self.mininterval = min(max(FIRST, SHARE * self.format_dict["elapsed"]), LAST)
        super().display(*arguments, **options)


def progress_bar(iterable: Any = None, *, show: bool = True, **options: Any) -> tqdm:
    """Return tqdm's bar, as suits standard error; in a file, work of 10 s leaves no line."""
    ipython = sys.modules.get("IPython")
    if not show or sys.stderr is None or sys.stderr.isatty():
        return tqdm(iterable, disable=not show or sys.stderr is None, **options)
    if ipython and getattr(ipython.get_ipython(), "kernel", None):
        from tqdm.auto import tqdm as notebook

        return notebook(iterable, **options)
    return _Lines(iterable, file=_Log(sys.stderr), delay=FIRST, mininterval=FIRST, maxinterval=0,
                  miniters=1, **options)
