"""One style of a store: computed, written whole or not at all, and read back memory-mapped."""

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import torch
from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor

from toolkit import datasets, features
from toolkit.datasets import Take
from toolkit.features import Features, Layout, OwnFeatures, splits
from toolkit.features.features import style_rows
from toolkit.io.files import parsed, write_whole
from toolkit.io.model_files import plain
from toolkit.motion import RootFrames


@dataclass(frozen=True)
class Partition:
    """A style's takes, which share phase axes with no other style's."""

    root: Path
    out: Path  # the file to write
    style: str
    takes: tuple[tuple[int, Take], ...]  # with their numbers in the dataset
    mirrored: frozenset[str]  # gaits
    parts: datasets.blocks.Split | None  # a list whose blocks are stored, not whole takes
    settings: dict[str, Any]  # of the store

    @property
    def size(self) -> int:
        """Bytes of the BVH files."""
        return sum(take.path.stat().st_size for _, take in self.takes)

    @property
    def done(self) -> bool:
        """Whether its file is whole, and not older than the BVH files."""
        try:
            read(self.out)
        except ValueError:
            return False
        return self.out.stat().st_mtime >= max(take.path.stat().st_mtime for _, take in self.takes)


def make(job: Partition) -> None:
    """Compute and write one partition; ValueError if a file is damaged or all are too short.

    Torch uses one thread: processes share the processors, and sums stay the same.
    """
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        _make(job)
    finally:
        torch.set_num_threads(threads)


def _make(job: Partition) -> None:
    style, settings = job.style, job.settings
    if settings["data"] == "folder":  # without reading the rest of the folder
        clips = datasets.folder.SOURCE.read([take for _, take in job.takes])
    else:
        gaits = sorted({take.gait for _, take in job.takes})
        clips = datasets.load(settings["data"], job.root, style, gaits)
    if job.parts is None:
        numbered = [(number, clip) for (number, _), clip in zip(job.takes, clips, strict=True)]
    else:
        pieces = list(splits.pieces(clips, job.parts))
        numbered = [(number, clip) for number, (_, clip, _) in enumerate(pieces)]
    try:
        recordings = features.recordings(
            numbered, source=settings["source"], short="skip",
            mirror=lambda clip: clip.gait in job.mirrored)[style]
    except ValueError as error:
        raise ValueError(f"{job.takes[0][1].path}: {error}") from None
    own = OwnFeatures.joined([own for _, own in recordings])
    takes = [(number, len(own.joints)) for number, own in recordings]
    found = of_styles({style: (own, takes)})

    # held-out rows, and the statistics of the others
    if job.parts is None:
        aside = splits.held_out(found, settings["held_out"], settings["seed"], (style,))[style]
    else:
        tested = [number for number, (_, _, held) in enumerate(pieces) if held]
        aside = torch.isin(found.takes[style], torch.tensor(tested, dtype=torch.long))
    kept = splits.apart(found, style, aside)
    rows = {kind: getattr(found, kind)[style].select(kept) for kind in features.FRAME_KINDS}
    rows["clips"] = splits.style_clips(found, style, aside)
    tensors = {"positions": own.roots.positions, "rotations": own.roots.rotations,
               "joints": own.joints, "phases": own.phases, "contacts": own.contacts,
               "held_out": aside}
    for kind in features.KINDS:
        tensors[f"{kind}.moments"] = features.moments(rows[kind])
    # the same content gives the same bytes
    about = {"layout": json.dumps(own.layout.to_json()), "takes": takes}
    write_whole(job.out, save(tensors, {"about": json.dumps(about)}))


def read(path: Path) -> tuple[OwnFeatures, list[tuple[int, int]], dict[str, Tensor]]:
    """Features of a style's recordings, take and length of each, and all tensors of the file.

    The tensors are memory-mapped. ValueError if the file is missing or not whole.
    """
    try:
        with safe_open(path, framework="pt") as file:
            tensors = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118
            about = parsed(file.metadata()["about"])
            if sum(n for _, n in about["takes"]) != len(tensors["joints"]):
                raise ValueError("its takes have other lengths")
            roots = RootFrames(tensors["positions"], tensors["rotations"])
            blocks = (tensors[name] for name in ("joints", "phases", "contacts"))
            own = OwnFeatures(Layout.from_json(parsed(about["layout"])), roots, *blocks)
            return own, about["takes"], tensors
    except (OSError, SafetensorError, ArithmeticError, AttributeError, LookupError, RuntimeError,
            TypeError, ValueError) as error:
        raise ValueError(f"{path}: missing or damaged ({plain(error)}); run the command that makes "
                         "the store again") from error


def of_styles(styles: dict[str, tuple[OwnFeatures, list[tuple[int, int]]]]) -> Features:
    """Features of styles, given those of their recordings and take and length of each."""
    first, layout = next((name, own.layout) for name, (own, _) in styles.items())
    kinds: dict[str, dict[str, Any]] = {}
    for style, (own, takes) in styles.items():
        if why := own.layout.difference(layout):
            raise ValueError(f"style {style!r}: {why}, compared with {first!r}")
        for kind, rows in style_rows(own, takes).items():
            kinds.setdefault(kind, {})[style] = rows
    return Features(layout, **kinds)
