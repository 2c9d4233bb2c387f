"""Styles of Xia et al. 2015 on the CMU skeleton: 120 Hz, files ``<style>_<content>_<nnn>.bvh``.

The gait of a clip is the word for its content code (`CONTENTS`); a code without a word is its own label.
"""

import re

from toolkit.datasets.takes import Source

CONTENTS = {"01": "walk", "13": "run", "16": "jump", "18": "punch", "22": "kick"}
UNIT = 0.05644  # metres of one unit of length of the CMU skeleton

SOURCE = Source(
    name="xia",
    pattern=re.compile(r"(?P<style>[A-Za-z]+)_(?P<gait>\d\d)_\d+\.bvh"),
    layout="<style>_<content>_<nnn>.bvh files, flat or in sub-folders",
    home="https://github.com/DeepMotionEditing/deep-motion-editing (its Xia style data)",
    gaits=CONTENTS,
    unit=UNIT,
)
load = SOURCE.load
