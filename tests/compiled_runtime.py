"""What numba compiles for all tests, made by one process while others wait."""

import tempfile
from pathlib import Path

from filelock import FileLock

import toolkit as tk

OUT = Path(__file__).parents[1] / "out"


def read():
    """The embedded model; kernels that the disk lacks take half a minute."""
    with _lock("runtime"):
        return tk.runtime.compile(tk.pretrained().model)


def fit() -> None:
    """The phase fit and the reader of BVH; kernels that the disk lacks take seven seconds."""
    with _lock("fit"), tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "walk.bvh"
        tk.io.bvh.save(tk.datasets.procedural.generate("Neutral", seconds=2.0), file)
        tk.phases.extract(tk.load(file))


def _lock(name: str) -> FileLock:
    OUT.mkdir(exist_ok=True)
    return FileLock(OUT / f"{name}.lock")


if __name__ == "__main__":
    read()
