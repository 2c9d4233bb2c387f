"""Styles of Xia et al. 2015 on the CMU skeleton: 120 Hz, files ``<style>_<content>_<nnn>.bvh``.

A clip's gait is the content as a word (`CONTENTS`); a content code without a word stays as it is.
"""

import os
import re
from collections.abc import Iterable

from toolkit.datasets.takes import Source
from toolkit.motion import Clip

CONTENTS = {"01": "walk", "13": "run", "16": "jump", "18": "punch", "22": "kick"}
UNIT = 0.05644  # metres of one unit of length of the CMU skeleton

SOURCE = Source(
    name="xia",
    pattern=re.compile(r"(?P<style>[A-Za-z]+)_(?P<gait>\d\d)_\d+\.bvh"),
    layout="<style>_<content>_<nnn>.bvh files, flat or in sub-folders",
    home="https://github.com/DeepMotionEditing/deep-motion-editing (its Xia style data)",
    gaits=CONTENTS,
)


def load(
    root: str | os.PathLike | None = None,
    styles: str | Iterable[str] | None = None,
    gaits: str | Iterable[str] | None = None,
) -> list[Clip]:
    """Clips of the dataset.

    Parameters
    ----------
    root
        A folder with the files, at any depth.
    styles, gaits
        Which ones; None for all that the folder has.

    Raises
    ------
    ValueError
        If the folder, a style or a gait is not there; BVHError if a file is malformed.
    """
    takes = SOURCE.choose(root, styles, gaits, known_gaits=CONTENTS.values())
    return list(SOURCE.read(takes, UNIT))
