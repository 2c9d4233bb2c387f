"""Roles of joints (hips, knees, hands …) and left and right counterparts, from names and tree."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from functools import cached_property
from itertools import combinations

from toolkit.motion.role_words import JointName, read_all

SIDES = ("left", "right")
CHAINS = {"arm": ("shoulder", "elbow", "hand"), "leg": ("hip", "knee", "foot")}  # from the trunk
ROLES = ("hips", *(f"{side}_{part}" for side in SIDES
                   for part in (*CHAINS["arm"], *CHAINS["leg"], "toe")))
_OTHER = {"left": "right", "right": "left"}
LENGTHS = "equal lengths"
UNEQUAL, EQUAL = 0.7, 0.85  # shorter over longer of a limb's two parts: no person's, and people's
SHORT = 0.05  # of a shin's length: a bone below the ankle that is shorter shows no toe

Found = dict[str, tuple[str, str]]  # role: joint, and the rule that found it
Places = dict[str, tuple[int, str]]  # part or role: index of its joint, and the rule


def find(names: Sequence[str], parents: Sequence[int], lengths: Sequence[float],
         ends: Sequence[str] = ()) -> Found:
    """Roles with the rule that found each.

    On the path from the trunk to a hand or a toe, the names decide which joint is which. Joints
    between, such as twist bones, have no role. A joint without a fitting name is found as the
    neighbour of one that has. A leg without a toe joint has as its toe the farthest point below the
    foot, which may be an End Site, or else the foot itself.

    Parameters
    ----------
    names, parents : J joints and End Sites, parents first
    lengths : J lengths of the bones to the parents, in any unit
    ends : names of the End Sites
    """
    words, ending = read_all(names), set(ends)
    tree = Tree(parents, lengths, frozenset(j for j, name in enumerate(names) if name in ending))
    found: Places = {}
    for side in SIDES:
        for limb in CHAINS:
            places = _limb(words, tree, side, limb)
            found |= {f"{side}_{part}": place for part, place in places.items()}
    found = {"hips": _hips(words, tree, found)} | found
    return {role: (names[j], rule) for role, (j, rule) in found.items()}


class Tree:
    """A tree of J joints and End Sites, with the lengths of their bones ``[J]``."""

    def __init__(self, parents: Sequence[int], lengths: Sequence[float] = (),
                 ends: frozenset[int] = frozenset()):
        self.parents, self.lengths, self.ends = parents, lengths, ends
        self.children: dict[int, list[int]] = defaultdict(list)
        for j, p in enumerate(parents):
            self.children[p].append(j)

    @cached_property
    def shapes(self) -> list[int]:
        """A number for each joint, equal for equal trees below."""
        kinds: dict[tuple, int] = {}
        shapes = [0] * len(self.parents)
        for j in reversed(range(len(shapes))):
            shape = tuple(sorted(shapes[k] for k in self.children[j]))
            shapes[j] = kinds.setdefault(shape, len(kinds))
        return shapes

    def up(self, joint: int) -> list[int]:
        """A joint and its ancestors, up to the root."""
        path = []
        while joint >= 0:
            path.append(joint)
            joint = self.parents[joint]
        return path

    def below(self, joint: int) -> list[int]:
        """A joint and all points below it, parents first."""
        path = [joint]
        for j in path:
            path.extend(self.children[j])
        return path

    def distance(self, upper: int, lower: int) -> float:
        """Length of the bones from a joint down to another one below it."""
        path = self.up(lower)
        return sum(self.lengths[j] for j in path[: path.index(upper)])


def _limb(words: list[JointName], tree: Tree, side: str, limb: str) -> Places:
    """Joint and rule for each part of a limb; empty if the names do not show it.

    Of a leg Thigh, ThighTwist, Knee, Ankle, Ball the names give hip, knee, foot and toe; ThighTwist
    has no role. Were the knee called "Joint3", it would be the parent of the foot, and were the
    ankle called so, it would be the longest bone below the knee.
    """
    places = _named(words, tree, side, CHAINS[limb] + (("toe",) if limb == "leg" else ()))
    if not places:
        return {}

    # A part without a fitting name is the parent of the next part outwards …
    parts = CHAINS[limb]
    for part, outer in zip(parts[-2::-1], parts[::-1], strict=False):
        if part not in places and outer in places:
            joint = places[outer][0]
            above = next((j for j in tree.up(joint)[1:] if not words[j].helper), -1)
            alone = above >= 0 and len(tree.children[above]) == 1
            if alone and words[above].side in (side, ""):
                places[part] = above, f"parent of the {outer}"

    # … or the longest bone below the part before it.
    for part, inner in zip(parts[1:], parts, strict=False):
        if part not in places and inner in places:
            children = tree.children[places[inner][0]]
            below = [j for j in children if not words[j].helper or j in tree.ends]
            if below:
                places[part] = max(below, key=lambda j: tree.lengths[j]), f"below the {inner}"

    if set(parts) <= places.keys():
        places |= _halved(words, tree, side, parts, places)
    if "foot" in places and "toe" not in places:
        places["toe"] = _toe(tree, places)
    return places


def _named(words: list[JointName], tree: Tree, side: str, chain: tuple[str, ...]) -> Places:
    """The parts of a limb that names state: those on the path to its end that shows most of them.

    Of equally many the most certain words count. One joint alone is no limb.
    """
    best: dict[str, int] = {}
    score = (1, 0)
    for end, name in enumerate(words):
        if name.side != side or end in tree.ends or name.parts.keys().isdisjoint(chain):
            continue
        path = [j for j in reversed(tree.up(end)) if words[j].side == side]
        *count, places = _in_order(words, path, chain)
        if tuple(count) > score:
            best, score = places, tuple(count)
    return {part: (j, "name") for part, j in best.items()}


def _in_order(words: list[JointName], path: list[int],
              chain: tuple[str, ...]) -> tuple[int, int, dict[str, int]]:
    """As many parts of a chain as a path states in their order, by the most certain words.

    Returns how many, minus the sum of the words' ranks, and the joints by part.
    """
    # Dynamic programming: best[n] is the best choice among the first n parts. A joint takes one
    # part, so the last part comes first: its choice must not see the joint in an earlier part.
    best: list[tuple[int, int, dict[str, int]]] = [(0, 0, {})] * (len(chain) + 1)
    for j in path:
        for n, part in reversed(list(enumerate(chain))):
            if part in words[j].parts:
                count, ranks, places = best[n]
                new = count + 1, ranks - words[j].parts[part], places | {part: j}
                best[n + 1 :] = [new if new[:2] > old[:2] else old for old in best[n + 1 :]]
    return best[-1]


def _halved(words: list[JointName], tree: Tree, side: str, parts: tuple[str, ...],
            found: Places) -> Places:
    """Other upper and middle joints of a limb, if the named ones divide it less equally.

    A rig may have one more joint in the thigh, whose name fits the hip or the knee better than the
    right one's.
    """
    upper, middle, lower = (found[part][0] for part in parts)

    def likeness(a: int, b: int) -> float:
        lengths = tree.distance(a, b), tree.distance(b, lower)
        return min(lengths) / max(*lengths, 1e-12)

    path = [j for j in tree.up(lower) if words[j].side == side and not words[j].helper]
    pairs = [(a, b) for b, a in combinations(path[1:], 2)]
    best = max(pairs, key=lambda pair: likeness(*pair), default=(upper, middle))
    if likeness(upper, middle) > UNEQUAL or likeness(*best) < EQUAL:
        return {}
    return {part: (new, LENGTHS)
            for part, new, old in zip(parts, best, (upper, middle), strict=False) if new != old}


def _toe(tree: Tree, found: Places) -> tuple[int, str]:
    """The toe of a leg whose names show none."""
    foot = found["foot"][0]
    shin = tree.distance(found["knee"][0], foot) if "knee" in found else 0.0
    below = max(tree.children[foot], key=lambda j: tree.lengths[j], default=foot)
    if below == foot or tree.lengths[below] <= SHORT * shin:
        return foot, "no toe: the foot"
    return below, "End Site of the foot" if below in tree.ends else "below the foot"


def _hips(words: list[JointName], tree: Tree, found: Places) -> tuple[int, str]:
    """The topmost joint called hips above legs and arms or above the legs, else where they meet."""

    def above(*parts: str) -> list[int]:
        roles = [f"{side}_{part}" for side in SIDES for part in parts]
        limbs = [set(tree.up(found[role][0])[1:]) for role in roles if role in found]
        return sorted(set.intersection(*limbs)) if limbs else []

    called = [j for j, name in enumerate(words)
              if "hips" in name.parts and not name.side and j not in tree.ends]
    for common in (above("hip", "shoulder"), above("hip")):
        if inner := [j for j in common if j in called]:
            return inner[0], "name"
    if above("hip"):
        return above("hip")[-1], "where the legs meet"
    return (called[0], "name") if called else (0, "the root")


def mirror_pairs(names: Sequence[str], parents: Sequence[int],
                 roles: Mapping[str, str]) -> tuple[int, ...]:
    """For each joint the index of its left or right counterpart, itself where it has none.

    Joints with the same role on both sides are counterparts, and so are the joints between them and
    the trunk. Of their children, those are counterparts whose names differ only in the side, or
    else those with equal trees below them. Other joints are counterparts if their names differ only
    in the side.
    """
    words, tree = read_all(names), Tree(parents)
    pairs: dict[int, int] = {}

    def join(a: int, b: int) -> None:
        if a != b and a not in pairs and b not in pairs:
            pairs[a], pairs[b] = b, a

    # From both joints of a role up to the trunk.
    for part in (role.removeprefix("left_") for role in ROLES if role.startswith("left_")):
        both = [roles.get(f"{side}_{part}") for side in SIDES]
        a, b = (names.index(joint) if joint in names else -1 for joint in both)
        while a >= 0 <= b and a not in tree.up(b) and b not in tree.up(a):
            join(a, b)
            a, b = parents[a], parents[b]

    # From the root down: names that differ in the side, and children of counterparts, by their
    # names or else by the trees below them.
    own = [(name.side, name.plain) for name in words]
    other = [(_OTHER.get(side, ""), plain) for side, plain in own]
    first: dict[tuple[str, str], int] = {}
    for j, name in enumerate(own):
        first.setdefault(name, j)
    for a in range(len(names)):
        if words[a].side:
            join(a, first.get(other[a], a))
        if (b := pairs.get(a, a)) > a:
            for mine, theirs in ((other, own), (tree.shapes, tree.shapes)):
                for j in tree.children[a]:
                    alike = (k for k in tree.children[b] if k not in pairs and mine[j] == theirs[k])
                    join(j, next(alike, j))
    return tuple(pairs.get(j, j) for j in range(len(names)))
