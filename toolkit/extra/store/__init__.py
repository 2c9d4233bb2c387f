"""Features of a dataset on disk: computed once, in parallel, and memory-mapped in training.

A store is a folder: ``manifest.json`` has the settings and the names of the styles. Each style has
a file, ``000.safetensors`` and so on, with its `toolkit.features.OwnFeatures` (float32, 1,268 bytes
per frame of the 100STYLE skeleton), from which x and z are derived when they are read, a mask of
the rows that are held out, and the moments of the others.

A file gets its name when it is complete. So the same command continues an interrupted run, and
makes again what is damaged or older than its BVH files. The same settings on the same kind of
processor give the same bytes, whatever the number of processes.
"""

import dataclasses
import json
import os
import signal
from collections import defaultdict
from collections.abc import Callable
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor, as_completed
from concurrent.futures.process import BrokenProcessPool
from multiprocessing import get_context
from pathlib import Path
from typing import Any

import toolkit
from toolkit import datasets, features, phases
from toolkit.datasets import Take
from toolkit.extra.store import partition
from toolkit.extra.store.partition import Partition
from toolkit.features import Features, Normaliser, Split, check_style
from toolkit.io.files import parsed, read as read_bytes, write_whole
from toolkit.io.model_files import difference, intact
from toolkit.io.progress import progress_bar
from toolkit.motion.text import checked
from toolkit.training import Config

__all__ = ["is_store", "load", "preprocess"]
FORMAT = "toolkit store 3"
MANIFEST = "manifest.json"
#: Share of every style's rows that is held out, and the seed that chooses them, as in training.
HELD_OUT = {"held_out": Config.held_out, "seed": Config.seed}


def preprocess(data: str, root: str | os.PathLike | None, out: str | os.PathLike, *,
               styles: list[str] | None = None, gaits: list[str] | None = None,
               source: str = "hybrid", mirror: Callable[[Take], bool] | None = None,
               workers: int | None = None, listed: bool = False, progress: bool = False) -> bool:
    """Make or complete the store of a dataset; False if there was nothing to do.

    Takes that hold no whole trajectory window are left out. Training with another share of
    held-out rows or another seed than `HELD_OUT` chooses these rows when it begins.

    Parameters
    ----------
    data, root, styles, gaits : as in `toolkit.datasets.load`; a dataset of files
    out : the store's folder; one run at a time may write to it
    source : name of a phase source
    mirror : true for takes whose mirror images are added
    workers : number of processes, by default that of the processors; 1 starts no other process
    listed : store only the training and test blocks of the dataset's list
        (`toolkit.datasets.split`), and hold out the test
    progress : show a bar with the time left

    Raises
    ------
    ValueError
        If files cannot be read or hold no style clip (all other styles are stored; the message
        names each file), or the store was made with other settings.
    """
    if data == "procedural":
        raise ValueError("the procedural dataset is computed, not read from files; there is "
                         "nothing to preprocess")
    phases.named(source)
    recorded, out = datasets._module(data, root).SOURCE, Path(out).resolve()
    root = recorded.folder(root).resolve()
    parts = datasets.split(data, root) if listed else None
    by_style: dict[str, list[tuple[int, Take]]] = defaultdict(list)
    for number, take in enumerate(recorded.choose(root, styles, gaits)):
        if not (parts and take.style in parts.unseen):
            by_style[take.style].append((number, take))
    settings = {
        "version": toolkit.__version__, "data": data, "styles": styles, "gaits": gaits,
        "source": source, "mirror": mirror is not None, "listed": listed,
        "takes": sum(map(len, by_style.values())),
        **(dict.fromkeys(HELD_OUT) if listed else HELD_OUT),
    }
    _begin(out, settings, sorted(by_style))
    jobs = []
    for number, (style, takes) in enumerate(sorted(by_style.items())):
        mirrored = frozenset(take.gait for _, take in takes if mirror and mirror(take))
        jobs.append(Partition(root, _file(out, number), style, tuple(takes), mirrored, parts,
                              settings))
    todo = [job for job in jobs if not job.done]
    todo.sort(key=lambda job: -job.size)  # the largest first, so that no worker is late at the end

    broken = []
    bar = progress_bar(desc="preprocess", total=sum(job.size for job in todo), unit="B",
                       unit_scale=True, show=progress)
    with _executor(workers) as pool, bar:
        futures = {pool.submit(partition.make, job): job for job in todo}
        try:
            for future in as_completed(futures):
                try:
                    future.result()
                except ValueError as error:
                    broken.append(str(error))
                except BrokenProcessPool as error:
                    raise OSError("a worker process died, perhaps out of memory; run the same "
                                  "command again with fewer workers") from error
                bar.update(futures[future].size)
        finally:  # after an error or an interrupt, no further style begins
            pool.shutdown(cancel_futures=True)
    if broken:
        raise ValueError(f"{len(broken)} of {len(jobs)} styles could not be stored; repair these "
                         f"files and run the same command again: {'; '.join(sorted(broken))}")
    if todo:
        load(out)  # styles of different skeletons are an error
    return bool(todo)


def is_store(path: str | os.PathLike) -> bool:
    """Whether a folder holds a store, finished or not."""
    return (Path(path) / MANIFEST).is_file()


def load(path: str | os.PathLike, styles: list[str] | None = None) -> Features:
    """Features of a finished store, or of some of its styles, read when they are indexed.

    ValueError if there is no finished store, a file is damaged or a style is not in it.
    """
    path = Path(path)
    settings, known = _manifest(path)
    for style in styles or ():
        check_style(style, known)
    paths = {style: _file(path, number) for number, style in enumerate(known)}
    if not all(file.exists() for file in paths.values()):
        raise ValueError(f"{path}: the store is not finished; run the command that makes it again "
                         "to continue")
    stored = {style: partition.read(paths[style]) for style in styles or known}
    found = partition.of_styles({style: (own, takes) for style, (own, takes, _) in stored.items()})
    held_out = {style: tensors["held_out"] for style, (*_, tensors) in stored.items()}
    statistics = {}
    for kind in features.KINDS:
        parts = [tensors[f"{kind}.moments"] for *_, tensors in stored.values()]
        statistics[kind] = Normaliser.merged(parts)
    split = Split(settings["held_out"], settings["seed"], held_out, statistics)
    return dataclasses.replace(found, split=split)


def _file(out: Path, number: int) -> Path:
    """The file of a style, by its place in the manifest: its name may not do as a file's name."""
    return out / f"{number:03d}.safetensors"


def _begin(out: Path, settings: dict[str, Any], styles: list[str]) -> None:
    """Write the manifest of a new store, or compare that of the store which is there."""
    leftovers = set(out.glob(".*.partial"))  # of a killed run
    if is_store(out):
        if why := difference(_manifest(out)[0], settings):
            raise ValueError(f"{out}: the store there was made with other settings ({why}); use "
                             "another folder")
    elif out.exists() and not (out.is_dir() and leftovers.issuperset(out.iterdir())):
        raise ValueError(f"{out}: expected a store or an empty folder, and it is neither")
    else:
        manifest = {"format": FORMAT, "settings": settings, "styles": styles}
        write_whole(out / MANIFEST, json.dumps(manifest, indent=1).encode())
    for leftover in leftovers:
        leftover.unlink(missing_ok=True)


def _manifest(path: Path) -> tuple[dict[str, Any], list[str]]:
    """Settings and styles of a store; ValueError if there is none or its manifest is damaged."""
    if not is_store(path):
        raise ValueError(f"{path}: holds no store (no {MANIFEST})")
    with intact(path / MANIFEST, "the manifest"):
        manifest = parsed(read_bytes(path / MANIFEST))
        if manifest["format"] != FORMAT:
            raise ValueError(f"expected the format {FORMAT!r}, got {manifest['format']!r}")
        settings, styles = manifest["settings"], checked(manifest["styles"], "a style")
        if missing := {"held_out", "seed"} - settings.keys() or not styles:
            raise ValueError(f"no styles, or no {missing}")
        return settings, list(styles)


def _executor(workers: int | None) -> Executor:
    """An executor of so many processes; 1 is this one."""
    if workers == 1:
        return ThreadPoolExecutor(1)
    # Ctrl-C reaches every process: this one handles it, the others finish what they began
    ignore = signal.SIGINT, signal.SIG_IGN
    return ProcessPoolExecutor(workers, get_context("spawn"), signal.signal, ignore)
