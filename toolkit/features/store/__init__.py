"""Features of a dataset on disk: computed once, in parallel, and memory-mapped in training.

A store is a folder with one safetensors file per style, ``split.safetensors`` and ``manifest.json``. The file of a style
holds its `toolkit.features.OwnFeatures` (float32, 1,268 bytes per frame of the 100STYLE skeleton); x and z are derived when
they are read. The split holds the held-out rows and the statistics of the others, the manifest settings and checksums.

A file gets its name when it is complete, and the manifest is written after it. Every file in the manifest is therefore
complete, and an interrupted run continues with the other styles. The same settings on the same kind of processor give the
same bytes, whatever the order and the number of processes or machines.
"""

import contextlib
import dataclasses
import json
import os
import shutil
from collections import defaultdict
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

import filelock
import torch

import toolkit
from toolkit import datasets, features, phases
from toolkit.datasets import Take
from toolkit.features import Features, Layout, Normaliser, Split, check_style, splits
from toolkit.features.store import files, partition
from toolkit.features.store.partition import Partition
from toolkit.features.store.workers import completed, executor
from toolkit.io.files import below
from toolkit.io.model_files import difference, intact
from toolkit.io.progress import progress_bar
from toolkit.motion import contacts, trajectory

__all__ = ["is_store", "load", "preprocess"]

GROWTH = 2  # upper limit of bytes of a store per byte of BVH; 1.8 for 100STYLE and for Bandai-Namco at 60 Hz


def preprocess(data: str, root: str | os.PathLike | None, out: str | os.PathLike, *, styles: list[str] | None = None,
               gaits: list[str] | None = None, source: str = "hybrid", mirror: Callable[[Take], bool] | None = None,
               workers: int | None = None, scheduler: str | None = None, held_out: float = 0.1, seed: int = 0,
               contact_height: float | None = None, listed: bool = False, progress: bool = False) -> bool:
    """Compute the features, phases, contacts and split of a dataset's files into a store, or continue an interrupted run.

    Takes that hold no whole trajectory window are left out. False if the store was finished already, with right checksums.

    Parameters
    ----------
    data, root, styles, gaits : as in `toolkit.datasets.load`; a dataset of files
    out : the store's folder; one run at a time may write to it
    source : name of a phase source
    mirror : true for takes whose mirror images are added
    workers : number of processes, by default that of the processors; 1 starts no other process
    scheduler : address of a Dask scheduler whose workers are used instead; they need the folders under the same paths
    held_out, seed : share of every style's rows that is held out, and the seed (see `toolkit.features.splits.held_out`)
    contact_height : as in `toolkit.features.build`
    listed : store only the training and test blocks of the dataset's list (`toolkit.datasets.split`), and hold out the test
    progress : show a bar with the time left

    Raises
    ------
    ValueError
        If files cannot be read or hold no style clip (all other styles are stored; the message names each file), or the
        store was made with other settings or from other files.
    OSError
        If the folder cannot be written to, there is too little space or another process writes to it.
    KeyboardInterrupt
        After an interrupt, when the styles that were begun are stored.
    """
    if data == "procedural":
        raise ValueError("the procedural dataset is computed, not read from files; there is nothing to preprocess")
    phases.named(source)
    contacts.check_height(contact_height)
    recorded, out = datasets._module(data, root).SOURCE, Path(out).resolve()
    root = recorded.folder(root).resolve()
    tables = {"100style": ("Frame_Cuts.csv", "Dataset_List.csv"), "folder": (datasets.folder.TABLE,)}.get(data, ())
    settings = json.loads(json.dumps({
        "version": toolkit.__version__, "data": data, "styles": styles, "gaits": gaits, "source": source,
        "mirror": mirror is not None, "fps": trajectory.FPS, "window": trajectory.SAMPLES,
        "clip": [features.CLIP_FRAMES, features.CLIP_HOP], "held_out": held_out, "seed": seed,
        "tables": {path.name: files.sha256(path) for path in below(root) if path.name in tables},
    } | ({} if contact_height is None else {"contact_height": contact_height})
        | ({"listed": True, "held_out": None, "seed": None} if listed else {})))
    parts = datasets.split(data, root) if listed else None
    by_style: dict[str, list[tuple[int, Take]]] = defaultdict(list)
    for number, take in enumerate(recorded.choose(root, styles, gaits)):
        if not (parts and take.style in parts.unseen):
            by_style[take.style].append((number, take))
    named = files.names(by_style)
    jobs = [Partition(data, root, out, source, style, named[style], tuple(takes),
                      frozenset(t.gait for _, t in takes if mirror and mirror(t)), contact_height, parts)
            for style, takes in sorted(by_style.items())]
    with _alone(out):
        return _make(out, settings, jobs, workers, scheduler, progress)


def _make(out: Path, settings: dict[str, Any], jobs: list[Partition], workers: int | None, scheduler: str | None,
          progress: bool) -> bool:
    """Compute the missing parts of a store; False if there are none."""
    manifest = _begin(out, settings)
    todo = _remaining(out, manifest, jobs, progress)
    if manifest["finished"]:
        return False
    need = GROWTH * sum(job.size * (2 if job.mirrored else 1) for job in todo)
    if need > (free := shutil.disk_usage(out).free):
        raise OSError(f"{out}: the store needs about {need / 1e9:.1f} GB more, {free / 1e9:.1f} GB are free")
    entries, broken = manifest["partitions"], []
    bar = progress_bar(desc="preprocess", total=sum(job.size for job in todo), unit="B", unit_scale=True,
                       show=progress)
    with executor(workers, scheduler) as pool, bar:
        for (job,), entry in completed(pool, partition.make, [(job,) for job in sorted(todo, key=lambda job: -job.size)]):
            bar.update(job.size)
            if isinstance(entry, ValueError):
                broken.append(str(entry))
                continue
            other = next(iter(entries.values()), entry)
            if Layout.from_json(entry["layout"]) != Layout.from_json(other["layout"]):
                raise ValueError(f"{job.takes[0][1].path}: its joints differ from those of {other['file']}")
            entries[job.style] = entry
            files.write_manifest(out, manifest)
        if broken:
            raise ValueError(f"{len(broken)} of {len(jobs)} styles could not be stored; repair or remove these files and "
                             f"run the same command again: {'; '.join(sorted(broken))}")
        bar.set_description("statistics")
        _finish(out, manifest, pool)
    return True


@contextlib.contextmanager
def _alone(out: Path) -> Iterator[None]:
    """Inside, no other process writes to the store. The lock of a killed process is free."""
    out.parent.mkdir(parents=True, exist_ok=True)
    lock = out.with_name(f".{out.name}.lock")
    try:
        with filelock.FileLock(lock, timeout=0):
            yield
    except filelock.Timeout as error:
        raise OSError(f"{out}: another process is writing this store (lock {lock}); wait for it") from error


def is_store(path: str | os.PathLike) -> bool:
    """Whether a folder holds a store, finished or not."""
    return (Path(path) / files.MANIFEST).is_file()


def load(path: str | os.PathLike, styles: list[str] | None = None, *, check: bool = False,
         progress: bool = False) -> Features:
    """Features of a finished store, or of some of its styles, read from the files when they are indexed.

    The size of each file is compared with the manifest, and with ``check`` its checksum, for which the files are read once.

    ValueError if there is no finished store, a file is damaged or a style is not in it.
    """
    path = Path(path)
    manifest = files.read_manifest(path)
    if not manifest["finished"]:
        raise ValueError(f"{path}: the store is not finished; run the command that makes it again to continue")
    entries, settings = manifest["partitions"], manifest["settings"]
    for style in styles or ():
        check_style(style, tuple(entries))
    chosen = {style: entries[style] for style in styles or entries}
    if check:
        stored = [*chosen.values(), manifest["split"]]
        for entry in progress_bar(stored, desc="checking", unit="file", show=progress):
            if not files.is_whole(path, entry):
                raise ValueError(f"{path / entry['file']}: is not the file that was stored; run the command that makes the "
                                 "store again")
    found = partition.read(path, chosen)
    whole = tuple(found.styles) == tuple(entries)
    if not whole and not settings.get("listed"):
        return found
    tensors = files.read(path / files.SPLIT, manifest["split"])
    with intact(path / files.SPLIT, "the split"):
        statistics = {kind: Normaliser(tensors[f"{kind}.mean"], tensors[f"{kind}.std"]) for kind in features.KINDS}
        held_out = {style: tensors[f"held_out.{style}"] for style in chosen}
    return dataclasses.replace(found, split=Split(settings["held_out"], settings["seed"], held_out,
                                                  statistics if whole else None))


def _begin(out: Path, settings: dict[str, Any]) -> dict[str, Any]:
    """The manifest of the store in a folder, or of a new store if the folder is empty or missing."""
    if is_store(out):
        manifest = files.read_manifest(out)
        if why := difference(manifest["settings"], settings):
            raise ValueError(f"{out}: the store there was made with other settings ({why}); use another folder")
    else:
        if out.exists() and not (out.is_dir() and all(path.name.startswith(".") for path in out.iterdir())):
            raise ValueError(f"{out}: expected a store or an empty folder, and it is neither")
        out.mkdir(parents=True, exist_ok=True)
        manifest = {"format": files.FORMAT, "settings": settings, "finished": False, "partitions": {}}
        files.write_manifest(out, manifest)
    for leftover in out.glob(".*.partial"):
        leftover.unlink()
    return manifest


def _remaining(out: Path, manifest: dict[str, Any], jobs: list[Partition], progress: bool) -> list[Partition]:
    """Partitions to be made; ValueError if sources have changed, while damaged partitions are made again."""
    entries, by_style = manifest["partitions"], {job.style: job for job in jobs}
    changed = list(by_style.keys() ^ entries.keys() if manifest["finished"] else entries.keys() - by_style.keys())
    done = [job for job in jobs if job.style in entries]
    for job in progress_bar(done, desc="checking", unit="style", show=bool(progress and done)):
        if job.checksums() != entries[job.style]["sources"]:
            changed.append(job.style)
        elif not files.is_whole(out, entries[job.style]):
            del entries[job.style]
    if changed:
        raise ValueError(f"{out}: the files of style {min(changed)} are not those of the store; use another folder")
    todo = [job for job in jobs if job.style not in entries]
    manifest["finished"] = manifest["finished"] and not todo and files.is_whole(out, manifest["split"])
    return todo


def _finish(out: Path, manifest: dict[str, Any], pool: Executor) -> None:
    """Write the split, and the manifest of a finished store."""
    entries, settings = dict(sorted(manifest["partitions"].items())), manifest["settings"]
    found = partition.read(out, entries)
    if settings.get("listed"):
        aside = {s: torch.tensor([c["take"] for c in entry["clips"] if c["held_out"]],
                                 dtype=torch.long) for s, entry in entries.items()}
        held_out = {style: torch.isin(found.takes[style], takes) for style, takes in aside.items()}
    else:
        held_out = splits.held_out(found, settings["held_out"], settings["seed"], tuple(entries))
    jobs = [(out, style, entry, held_out[style].numpy()) for style, entry in entries.items()]
    by_style = {job[1]: result for job, result in completed(pool, partition.moments, jobs)}
    tensors = {f"held_out.{style}": mask for style, mask in held_out.items()}
    for kind in features.KINDS:
        parts = (by_style[style][kind] for style in entries)
        normaliser = Normaliser.merged((int(n), torch.from_numpy(m), torch.from_numpy(v)) for n, m, v in parts)
        tensors |= {f"{kind}.mean": normaliser.mean, f"{kind}.std": normaliser.std}
    split = {"file": files.SPLIT, **files.write(out / files.SPLIT, tensors)}
    manifest |= {"finished": True, "rows": found.n_frames, "split": split}
    files.write_manifest(out, manifest)
