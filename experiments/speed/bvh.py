"""Speed of reading BVH, from the file to the world positions of every joint, compared with other
Python packages.
"""

import contextlib
import importlib.metadata
import io
import tempfile
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import torch

from toolkit import datasets
from toolkit.io import bvh
from toolkit.motion import forward_kinematics

Reader = Callable[[str], np.ndarray]


def _pybvh() -> Reader:
    import pybvh

    return lambda path: pybvh.read_bvh_file(path).node_positions()


def _pymotion() -> Reader:
    from pymotion.io.bvh import BVH
    from pymotion.ops.skeleton import fk

    def read(path: str) -> np.ndarray:
        file = BVH()
        file.load(path)
        rotations, positions, parents, offsets, _, _ = file.get_data()
        return fk(rotations, positions[:, 0], offsets, parents)[0]

    return read


def _bvhsdk() -> Reader:
    import bvhsdk

    return lambda path: bvhsdk.ReadFile(path).getJointPositions()


def _bvhio() -> Reader:
    import bvhio

    def read(path: str) -> np.ndarray:
        root = bvhio.readAsHierarchy(path)
        first, last = root.getKeyframeRange()
        joints = [joint for joint, _, _ in root.layout()]
        poses = (root.loadPose(frame) for frame in range(first, last + 1))
        return np.array([[tuple(joint.PositionWorld) for joint in joints] for _ in poses])

    return read


PEERS = {"pybvh": _pybvh, "upc-pymotion": _pymotion, "bvhsdk": _bvhsdk, "bvhio": _bvhio}


def run() -> None:
    """Time from a BVH file to world positions on one core, compared with the Python packages of the
    extra `bench`.

    The file has 3,000 frames.
    """
    torch.set_num_threads(1)
    (walk,) = datasets.load("procedural", styles=["Neutral"], gaits=["FW"], seconds=55.0)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "walk.bvh"
        bvh.save(walk.cut(0, 3000), file)
        _compare(file)


def _compare(file: Path) -> None:
    clip, size = bvh.load(file), file.stat().st_size / 1e6
    ours = clip.global_positions.numpy() / bvh.CENTIMETRE
    joints = [j for j in range(len(clip.skeleton)) if not clip.skeleton.is_end(j)]

    works = {"toolkit": lambda: bvh.load(file).global_positions}
    notes, missing = {}, []
    for package, make in PEERS.items():
        try:
            read, name = make(), f"{package} {importlib.metadata.version(package)}"
        except ImportError:
            missing.append(package)
            continue
        try:
            with _quiet():
                theirs = read(str(file))
        except Exception as error:  # whatever the other package raises
            notes[package] = f"{name}: cannot read this file ({type(error).__name__}: {error})"
            continue
        works[name] = lambda read=read: read(str(file))
        same = ours if theirs.shape == ours.shape else ours[:, joints]
        notes[name] = (
            f"{abs(theirs - same).max():.5f} units"
            if theirs.shape == same.shape else "other joints"
        )
    works["  forward kinematics"] = lambda: forward_kinematics(clip.skeleton, clip.rotations,
                                                               clip.root_positions)
    works["  floor: count the lines"] = lambda: file.read_bytes().count(b"\n")
    costs = _costs(works)

    print(f"{file.name}: {len(clip):,} frames, {len(joints)} joints, {size:.1f} MB; CPU time of "
          f"one core, best of several")
    print(f"{'file to world positions':<26}{'ms':>9}{'MB/s':>8}{'frames/s':>11}{'relative':>9}"
          f"{'largest difference':>21}")
    for name, seconds in costs.items():
        print(f"{name:<26}{seconds * 1000:>9.2f}{size / seconds:>8.1f}{len(clip) / seconds:>11,.0f}"
              f"{seconds / costs['toolkit']:>8.2f}x{notes.pop(name, ''):>21}")
    print("\n".join(notes.values()), end="\n" if notes else "")
    if missing:
        print(f"not installed: {', '.join(missing)}; pip install {' '.join(missing)}")


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings(action="ignore"):
        yield


def _costs(works: dict[str, Callable[[], object]], budget: float = 2.0) -> dict[str, float]:
    """Least CPU time of each; they run in turn, each for about ``budget`` seconds, at least
    once.
    """
    costs: dict[str, list[float]] = {name: [] for name in works}
    while waiting := [name for name, spent in costs.items() if sum(spent) < budget
                      and len(spent) < 50]:
        for name in waiting:
            start = time.process_time()
            with _quiet():
                works[name]()
            costs[name].append(time.process_time() - start)
    return {name: min(spent) for name, spent in costs.items()}
