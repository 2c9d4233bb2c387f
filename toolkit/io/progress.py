"""Progress of long work: a bar in a terminal or a notebook; in a file, a line now and then."""

import io
import sys
from typing import Any

from tqdm import tqdm

FIRST, SHARE, LAST = 10.0, 0.5, 1800.0  # first line, s; pause / time so far; longest pause, s


class _Lines(tqdm):
    """A bar that is drawn ever more seldom, as a line each time: 10 in ten minutes, 60 in a day."""

    last = ""

    def __iter__(self):
        with self:
            for item in self.iterable:
                yield item
                self.update()

    def display(self, *_, **__) -> None:
        self.mininterval = min(max(FIRST, SHARE * self.format_dict["elapsed"]), LAST)
        if (line := str(self)) != self.last:
            self.last = line
            print(line, file=sys.stderr)


def kernel() -> Any:
    """The Jupyter kernel that runs the program; None outside of notebooks."""
    ipython = sys.modules.get("IPython")
    return getattr(ipython and ipython.get_ipython(), "kernel", None)


def progress_bar(iterable: Any = None, *, show: bool = True, **options: Any) -> tqdm:
    """tqdm's bar for a terminal or a notebook; lines for a file, none for work below 10 s."""
    if not show or sys.stderr is None or sys.stderr.isatty():
        return tqdm(iterable, disable=not show or sys.stderr is None, **options)
    if kernel():
        from tqdm.auto import tqdm as notebook

        return notebook(iterable, **options)
    return _Lines(iterable, file=io.StringIO(), delay=FIRST, mininterval=FIRST, maxinterval=0,
                  miniters=1, **options)
