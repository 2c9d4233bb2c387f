"""One style of a store: computed, read back, and its statistics."""

from collections import defaultdict
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch

from toolkit import datasets, features
from toolkit.datasets import Take
from toolkit.features import Features, Layout, OwnFeatures, splits
from toolkit.features.features import style_rows
from toolkit.features.store import files
from toolkit.features.store.workers import one_thread
from toolkit.io.model_files import difference, intact
from toolkit.motion import RootFrames
from toolkit.motion.clip import FEET


@dataclass(frozen=True)
class Partition:
    """The files of one style. Partitions are independent, because phase axes are shared only within a style and gait."""

    data: str
    root: Path
    out: Path
    source: str
    style: str
    file: str  # name of the file to write
    takes: tuple[tuple[int, Take], ...]  # with their numbers in the dataset
    mirrored: frozenset[str]  # gaits
    contact_height: float | None = None  # metres
    parts: datasets.blocks.Split | None = None  # a list whose blocks are stored, instead of whole takes

    @property
    def size(self) -> int:
        """Bytes of the BVH files."""
        return sum(take.path.stat().st_size for _, take in self.takes)

    def checksums(self) -> dict[str, str]:
        """SHA-256 of the BVH files, by path in the dataset's folder."""
        return {take.path.relative_to(self.root).as_posix(): files.sha256(take.path) for _, take in self.takes}


def make(job: Partition) -> dict[str, Any]:
    """Compute and write one partition; returns its entry in the manifest."""
    with one_thread():
        sources = job.checksums()
        groups: dict[str, list] = defaultdict(list)
        held_out = {}  # pieces of a list
        if job.data == "folder":  # without reading the rest of the folder
            loaded = datasets.folder.SOURCE.read([take for _, take in job.takes])
        else:
            loaded = datasets.load(job.data, job.root, job.style, sorted({take.gait for _, take in job.takes}))
        if job.parts is None:
            for (number, _), clip in zip(job.takes, loaded, strict=True):
                groups[clip.gait].append((number, clip))
        else:
            for number, (_, clip, held_out[number]) in enumerate(splits.pieces(loaded, job.parts)):
                groups[clip.gait].append((number, clip))
        del loaded, clip
        parts, clips = [], []
        for gait in sorted(groups):
            for number, own in features.group_features(groups.pop(gait), job.source, gait in job.mirrored, "skip",
                                                       contact_height=job.contact_height):
                parts.append(own)
                clips.append({"take": number, "gait": gait, "frames": len(own.joints)}
                             | ({"held_out": held_out[number]} if held_out else {}))
        try:
            features.check_style_clips(job.style, len(clips))
        except ValueError as error:
            raise ValueError(f"{job.takes[0][1].path}: {error}") from None
        layout = parts[0].layout
        if why := next(filter(None, (own.layout.difference(layout) for own in parts)), ""):
            raise ValueError(f"{job.takes[0][1].path}: the skeletons of style {job.style} differ: {why}")
        own = OwnFeatures.joined(parts)
        tensors = {"positions": own.roots.positions, "rotations": own.roots.rotations, "joints": own.joints,
                   "phases": own.phases, "contacts": own.contacts}
        return {"file": job.file, **files.write(job.out / job.file, tensors), "frames": len(tensors["joints"]),
                "layout": layout.to_json(), "clips": clips, "sources": sources}


def read(path: Path, entries: dict[str, dict[str, Any]]) -> Features:
    """Features of the styles of manifest entries, as `Rows`."""
    kinds: dict[str, dict[str, Any]] = {kind: {} for kind in (*features.KINDS, "takes", "frames", "spans")}
    layout = Layout.from_json(next(iter(entries.values()))["layout"])
    for style, entry in entries.items():
        t = files.read(path / entry["file"], entry)
        with intact(path / entry["file"], "this part of the store"):
            if {len(x) for x in t.values()} != {entry["frames"]}:
                raise ValueError(f"expected {entry['frames']} frames")
            widths = {"joints": layout.n_clip, "phases": layout.n_phases, "contacts": len(FEET)}
            if why := difference(widths, {name: t[name].shape[-1] for name in widths}):
                raise ValueError(f"columns of {why}")
            own = OwnFeatures(layout, RootFrames(t["positions"], t["rotations"]), t["joints"], t["phases"], t["contacts"])
        for kind, rows in style_rows(own, [(clip["take"], clip["frames"]) for clip in entry["clips"]]).items():
            kinds[kind][style] = rows
    return Features(layout, **kinds)


def moments(path: Path, style: str, entry: dict[str, Any], held_out: np.ndarray) -> dict[str, tuple]:
    """`toolkit.features.moments` of a style's training rows, and of their style clips (`toolkit.features.splits.split`)."""
    with one_thread():
        found, held_out = read(path, {style: entry}), torch.from_numpy(held_out)
        kept = splits.apart(found, style, held_out)
        rows = {kind: getattr(found, kind)[style].select(kept) for kind in features.FRAME_KINDS}
        rows["clips"] = splits.style_clips(found, style, held_out)
        return {kind: tuple(np.asarray(x) for x in features.moments(r)) for kind, r in rows.items()}
