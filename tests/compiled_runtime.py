"""The compiled runtime, made by one process while others wait."""

from pathlib import Path

from filelock import FileLock

import toolkit as tk


def read():
    """The embedded model; kernels that the disk lacks take half a minute."""
    folder = Path(__file__).parents[1] / "out"
    folder.mkdir(exist_ok=True)
    with FileLock(folder / "kernels.lock"):
        return tk.runtime.compile(tk.pretrained().model)


if __name__ == "__main__":
    read()
