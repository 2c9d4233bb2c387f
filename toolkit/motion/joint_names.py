"""The side and the body part that a joint's name states, in the conventions of common exporters.

A name is split into words at separators, digits and capitals, for example ``mixamorig:LeftUpLeg`` into mixamorig, left, up,
leg. A word for the side may stand in any place (``L_Hip``, ``hand_l``, ``lHand``, ``Bip01 L Calf``, ``lfemur``). The other
words state the part when they end in one of `PARTS`; what comes before, such as the name of a rig, is ignored.
"""

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

#: Words for a part, from the most to the least certain. Some rigs call the thigh "leg", others the shin; where words of
#: several ranks lie on one limb, the lower rank decides.
PARTS = {
    "hips": ("hips", "pelvis", "hip"),
    "head": ("head",),
    "neck": ("neck",),
    "collar": ("clavicle", "collar", "collarbone", "clav", "scapula"),
    "shoulder": ("upperarm", "uparm", "shldr", "humerus", "armupper", "bicep", "uarm", "arm", "shoulder"),
    "elbow": ("elbow", "forearm", "lowerarm", "lowarm", "loarm", "farm", "ulna", "radius", "armlower", "lowerelbow"),
    "hand": ("wrist", "hand", "palm"),
    "hip": ("thigh", "upleg", "upperleg", "femur", "legupper", "hip", "leg", "hipjoint"),
    "knee": ("knee", "shin", "calf", "lowerleg", "lowleg", "loleg", "tibia", "leglower", "leg"),
    "foot": ("ankle", "foot", "feet", "tarsus"),
    "toe": ("toebase", "toe", "toes", "ball", "forefoot", "metatarsal", "metatarsals", "foot"),
    "finger": ("thumb", "index", "middle", "mid", "ring", "pinky", "little", "finger", "fingers", "fingerbase", "metacarpal",
               "carpal", "eye", "breast", "pectoral", "jaw", "tongue"),
}
_SIDES = dict.fromkeys(("left", "l", "lt", "lft"), "left") | dict.fromkeys(("right", "r", "rt", "rgt"), "right")
#: Words of joints that help a skin or a rig and are no joint of the body, and of the tips of bones.
_HELPERS = frozenset(("twist", "roll", "ik", "fk", "pole", "share", "ctrl", "control", "target", "effector", "helper",
                      "goal", "nub", "end", "tip", "top", "site", "weapon", "prop", "attach", "socket", "dummy",
                      "corrective", "muscle", "jiggle", "offset", "heel", "adjust", "null"))
_GENERIC = frozenset(("joint", "jnt", "jt", "bone", "bend", "bind", "skin", "node", "def", "jx", "sk", "stretch"))
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[A-Z]")
_KNOWN = frozenset(word for words in PARTS.values() for word in words)


class JointName(NamedTuple):
    """What a name states."""

    side: str  # "left", "right" or ""
    parts: dict[str, int]  # part of `PARTS` to the rank of its word, 0 is the most certain; several where it is ambiguous
    plain: str  # the name without its side, in lower case with digits: equal for counterparts
    helper: bool  # a twist joint, a control or the tip of a bone


@lru_cache(4096)
def read(name: str) -> JointName:
    """Side and parts of one name."""
    local = re.split(r"[:|]", name)[-1] or name
    words, side, rest = [], "", []
    for run in re.findall("[A-Za-z]+", local):
        first = len(run) - len(_split(run.lower())[-1])  # of what follows the side: LUArm, LeftArmTwist
        words += (part for word in (run[:first], *_WORD.findall(run[first:])) for part in _split(word.lower()) if part)
    for word in words:
        if word in _SIDES and not (side and len(word) == 1):
            side = _SIDES[word]
        else:
            rest.append(word)
    if not rest:  # L5 is a vertebra
        return JointName("", {}, local.lower(), False)
    plain = "".join(rest) + "".join(re.findall(r"\d+", local))
    if any(word in _HELPERS for word in rest) or local.startswith("__"):  # MakeHuman's joints at a bone's start
        return JointName(side, {}, plain, True)
    parts = _parts("".join(rest))
    while not parts and len(rest) > 1 and rest[-1] in _GENERIC:
        rest.pop()
        parts = _parts("".join(rest))
    return JointName(side, parts, plain, False)


def _split(word: str) -> list[str]:
    """A word with its side split off: lefthand, rfemur."""
    for start in ("left", "right"):
        if word.startswith(start) and word != start:
            return [start, word.removeprefix(start)]
    return [word[0], word[1:]] if word[:1] in "lr" and word[1:] in _KNOWN and word not in _KNOWN else [word]


def _parts(text: str) -> dict[str, int]:
    found = {part: next(((len(word), rank) for rank, word in sorted(enumerate(words), key=lambda w: -len(w[1]))
                         if text.endswith(word)), None) for part, words in PARTS.items()}
    longest = max((f[0] for f in found.values() if f), default=0)
    return {part: f[1] for part, f in found.items() if f and f[0] == longest}


def read_all(names: Sequence[str]) -> list[JointName]:
    """What the names of one skeleton state; a side without its counterpart in the skeleton is no side."""
    found = [read(name) for name in names]
    sides = {f.side for f in found}
    return found if {"left", "right"} <= sides else [f._replace(side="") for f in found]
