"""Bandai-Namco Research motion dataset 1 and 2 (CC BY-NC 4.0): 30 Hz, files ``dataset-N_<content>_<style>_<nnn>.bvh``.

Dataset 1 has 15 styles of many everyday contents, dataset 2 seven styles of walking and running. A clip's gait is the
content: ``walk``, ``walk-turn-left``, ``bow`` … The rate stays 30 Hz. End Sites, which only a few files give a length, are
left out: all clips have the same 21 joints.
"""

import os
import re
from collections.abc import Iterable
from dataclasses import replace

from toolkit.datasets.takes import Source
from toolkit.motion import Clip

SOURCE = Source(
    name="bandai",
    pattern=re.compile(r"dataset-\d+_(?P<gait>[^_]+)_(?P<style>[^_]+)_\d+\.bvh"),
    layout="dataset-N_<content>_<style>_<nnn>.bvh files, flat or in sub-folders",
    home="https://github.com/BandaiNamcoResearchInc/Bandai-Namco-Research-Motiondataset",
)


def load(
    root: str | os.PathLike | None = None,
    styles: str | Iterable[str] | None = None,
    gaits: str | Iterable[str] | None = None,
    *,
    dataset: int | None = None,
) -> list[Clip]:
    """Clips of the dataset.

    Parameters
    ----------
    root
        A folder with the files of one or both datasets, at any depth.
    styles, gaits
        Which ones; None for all that the folder has.
    dataset
        1 or 2; None for both. The two name some styles differently (``masculinity`` and ``masculine``).

    Raises
    ------
    ValueError
        If the folder, a style, a gait or a dataset is not there; BVHError if a file is malformed.
    """
    if dataset not in (None, 1, 2):
        raise ValueError(f"bandai: dataset must be 1, 2 or None for both, got {dataset!r}")
    source = SOURCE
    if dataset is not None:
        source = replace(SOURCE, pattern=re.compile(SOURCE.pattern.pattern.replace(r"\d+", str(dataset), 1)),
                         layout=SOURCE.layout.replace("-N", f"-{dataset}"))
    return [clip.without_ends() for clip in source.read(source.choose(root, styles, gaits))]
