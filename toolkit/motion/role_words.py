"""The side and the body part that a joint's name states, in the conventions of common exporters.

A name is split into words at separators, digits and capitals: ``mixamorig:LeftUpLeg`` into left,
up, leg. A word for the side may stand in any place (``L_Hip``, ``hand_l``, ``lHand``,
``Bip01 L Calf``, ``lfemur``). The other words, written together, state the part when they end in
one of `PARTS`; what comes before, such as the name of a rig, is ignored.
"""

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

#: Words for a part, from the most to the least certain. Some rigs call the thigh "leg", others the
#: shin; where words of several ranks lie on one limb, the lower rank decides.
PARTS = {
    "hips": ("hips", "pelvis", "hip"),
    "head": ("head",),
    "neck": ("neck",),
    "collar": ("clavicle", "collar", "collarbone", "clav", "scapula"),
    "shoulder": ("upperarm", "uparm", "shldr", "humerus", "armupper", "bicep", "uarm", "arm",
                 "shoulder"),
    "elbow": ("elbow", "forearm", "lowerarm", "lowarm", "loarm", "farm", "ulna", "radius",
              "armlower", "lowerelbow"),
    "hand": ("wrist", "hand", "palm"),
    "hip": ("thigh", "upleg", "upperleg", "femur", "legupper", "hip", "leg", "hipjoint"),
    "knee": ("knee", "shin", "calf", "lowerleg", "lowleg", "loleg", "tibia", "leglower", "leg"),
    "foot": ("ankle", "foot", "feet", "tarsus"),
    "toe": ("toebase", "toe", "toes", "ball", "forefoot", "metatarsal", "metatarsals", "foot"),
    "finger": ("thumb", "index", "middle", "mid", "ring", "pinky", "little", "finger", "fingers",
               "fingerbase", "metacarpal", "carpal", "eye", "breast", "pectoral", "jaw", "tongue"),
}
_KNOWN = frozenset(word for words in PARTS.values() for word in words)
_SIDES = (dict.fromkeys(("left", "l", "lt", "lft"), "left")
          | dict.fromkeys(("right", "r", "rt", "rgt"), "right"))
#: Words of joints that help a skin or a rig and are no joint of the body, and of the tips of bones.
_HELPERS = frozenset((
    "twist", "roll", "ik", "fk", "pole", "share", "ctrl", "control", "target", "effector", "helper",
    "goal", "nub", "end", "tip", "top", "site", "weapon", "prop", "attach", "socket", "dummy",
    "corrective", "muscle", "jiggle", "offset", "heel", "adjust", "null"))
#: Words behind the part that say nothing.
_GENERIC = frozenset(("joint", "jnt", "jt", "bone", "bend", "bind", "skin", "node", "def", "jx",
                      "sk", "stretch"))
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[A-Z]")


class JointName(NamedTuple):
    """What a name states."""

    side: str  # "left", "right" or ""
    parts: dict[str, int]  # by part: rank of its word, 0 is the most certain; several if ambiguous
    plain: str  # the name without its side, in lower case with digits: equal for counterparts
    helper: bool  # a twist joint, a control or the tip of a bone


@lru_cache(4096)
def read(name: str) -> JointName:
    """Side and parts of one name."""
    local = re.split(r"[:|]", name)[-1] or name  # behind a name space
    side, rest = "", []
    for word in (word for letters in re.findall("[A-Za-z]+", local) for word in _words(letters)):
        if word in _SIDES and not (side and len(word) == 1):
            side = _SIDES[word]
        else:
            rest.append(word)
    if not rest:  # L5 is a vertebra
        return JointName("", {}, local.lower(), False)
    plain = "".join(rest) + "".join(re.findall(r"\d+", local))
    if local.startswith("__") or not _HELPERS.isdisjoint(rest):  # "__": MakeHuman's bone starts
        return JointName(side, {}, plain, True)
    parts = _parts("".join(rest))
    while not parts and len(rest) > 1 and rest[-1] in _GENERIC:
        rest.pop()
        parts = _parts("".join(rest))
    return JointName(side, parts, plain, False)


def read_all(names: Sequence[str]) -> list[JointName]:
    """What the names of a skeleton state; a side without a counterpart in it is no side."""
    found = [read(name) for name in names]
    both = {"left", "right"} <= {name.side for name in found}
    return found if both else [name._replace(side="") for name in found]


def _words(letters: str) -> list[str]:
    """Words in lower case; a side that is written together with its word is a word: LUArm."""
    side, rest = _split_side(letters)
    words = [side]
    for word in _WORD.findall(rest):
        words += _split_side(word)
    return [word.lower() for word in words if word]


def _split_side(letters: str) -> tuple[str, str]:
    """The side that letters begin with, maybe empty, and what follows: lefthand, rfemur."""
    low = letters.lower()
    for side in ("left", "right"):
        if low.startswith(side) and low != side:
            return side, letters[len(side) :]
    if low[0] in "lr" and low[1:] in _KNOWN and low not in _KNOWN:
        return letters[0], letters[1:]
    return "", letters


def _parts(text: str) -> dict[str, int]:
    """The parts that the longest known word at the end of a text stands for, with its rank."""
    word = max((word for word in _KNOWN if text.endswith(word)), key=len, default="")
    return {part: words.index(word) for part, words in PARTS.items() if word in words}
