"""Bandai-Namco Research motion datasets 1 and 2 (CC BY-NC 4.0), 30 Hz.

The files are ``dataset-N_<content>_<style>_<nnn>.bvh``. Dataset 1 has 15 styles of many everyday
contents, dataset 2 seven styles of walking and running. The gait of a clip is the content:
``walk``, ``walk-turn-left``, ``bow`` … Clips have no End Sites, because only some files give them a
length: all clips have the same 21 joints.
"""

import re

from toolkit.datasets.takes import Names, Root, Source
from toolkit.motion import Clip


def _source(number: str) -> Source:
    return Source(
        name="bandai",
        pattern=re.compile(rf"dataset-{number}_(?P<gait>[^_]+)_(?P<style>[^_]+)_\d+\.bvh"),
        layout="dataset-N_<content>_<style>_<nnn>.bvh files, flat or in sub-folders",
        home="https://github.com/BandaiNamcoResearchInc/Bandai-Namco-Research-Motiondataset",
    )


SOURCE = _source(r"\d+")


def load(root: Root = None, styles: Names = None, gaits: Names = None, *,
         dataset: int | None = None) -> list[Clip]:
    """Clips of the dataset, see `toolkit.datasets.takes.Source.load`.

    ``dataset`` is 1 or 2, or None for both, which name some styles differently (``masculinity`` and
    ``masculine``).
    """
    if dataset not in (None, 1, 2):
        raise ValueError(f"bandai: dataset must be 1, 2 or None for both, got {dataset!r}")
    source = SOURCE if dataset is None else _source(str(dataset))
    return [clip.without_ends() for clip in source.load(root, styles, gaits)]
