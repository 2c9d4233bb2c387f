"""Roles of joints (hips, knees, hands …) from their names and from the tree, and left and right counterparts."""

from collections import defaultdict
from collections.abc import Mapping, Sequence
from functools import cached_property, lru_cache
from itertools import combinations, pairwise

from toolkit.motion import joint_names
from toolkit.motion.joint_names import JointName

SIDES = ("left", "right")
LIMBS = {"arm": ("shoulder", "elbow", "hand"), "leg": ("hip", "knee", "foot")}  # from the trunk outwards
ROLES = ("hips", *(f"{side}_{part}" for side in SIDES for part in (*LIMBS["arm"], *LIMBS["leg"], "toe")))
_OTHER = {"left": "right", "right": "left"}
NOTHING = 1e-3  # of the longest bone: a bone between two roles that is shorter is none
LENGTHS = "equal lengths"
UNEQUAL, EQUAL = 0.7, 0.85  # shorter over longer of the two parts of a limb: no person's, and people's
SHORT = 0.05  # of a shin's length: a bone below the ankle that is shorter shows no toe

Found = dict[str, tuple[str, str]]  # role: joint, and the rule that found it


def find_roles(names: Sequence[str], parents: Sequence[int], lengths: Sequence[float] | None = None,
               ends: Sequence[str] = ()) -> dict[str, str]:
    """Those roles of `ROLES` that names and tree show, as a joint's name by role; see `find`."""
    return {role: joint for role, (joint, _) in find(names, parents, lengths, ends).items()}


def find(names: Sequence[str], parents: Sequence[int], lengths: Sequence[float] | None = None,
         ends: Sequence[str] = ()) -> Found:
    """Roles with the rule that found each.

    On the path from the trunk to a hand or a toe, the names decide which joint is which. Joints between, such as twist
    bones, have no role. A joint without a fitting name is found as the neighbour of one that has. A leg without a toe joint
    has as its toe the farthest point below the foot, which may be an End Site, or else the foot itself.

    Parameters
    ----------
    names, parents : J joints and End Sites, parents first
    lengths : J lengths of the bones to the parents, in any unit; by default all are equal
    ends : names of the End Sites
    """
    return dict(_find(tuple(names), tuple(parents), tuple(lengths or ()), tuple(ends)))


@lru_cache(64)
def _find(names: tuple[str, ...], parents: tuple[int, ...], lengths: tuple[float, ...], ends: tuple[str, ...]) -> Found:
    said, ending = joint_names.read_all(names), set(ends)
    tree = Tree(parents, lengths or [1.0] * len(names),
                frozenset(j for j, name in enumerate(names) if name in ending))
    found: dict[str, tuple[int, str]] = {}
    for side in SIDES:
        for limb in LIMBS:
            found |= {f"{side}_{part}": place for part, place in _limb(said, tree, side, limb).items()}
    return {role: (names[j], rule) for role, (j, rule) in ({"hips": _hips(said, tree, found)} | found).items()}


class Tree:
    """A tree of J joints and End Sites, with the lengths of their bones ``[J]``."""

    def __init__(self, parents: Sequence[int], lengths: Sequence[float], ends: frozenset[int] = frozenset()):
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
            shapes[j] = kinds.setdefault(tuple(sorted(shapes[k] for k in self.children[j])), len(kinds))
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


def _limb(said: list[JointName], tree: Tree, side: str, limb: str) -> dict[str, tuple[int, str]]:
    """Joint and rule for each part of a limb, none if its names do not show it."""
    chain = LIMBS[limb] + (("toe",) if limb == "leg" else ())
    best, score = {}, (1, 0)  # one joint alone is no limb
    for end, name in enumerate(said):
        if name.side == side and end not in tree.ends and not name.parts.keys().isdisjoint(chain):
            places = _along(said, [j for j in reversed(tree.up(end)) if said[j].side == side], chain)
            ranks = sum(said[j].parts[part] for part, j in places.items())
            if (len(places), -ranks) > score:
                best, score = places, (len(places), -ranks)
    found = {part: (j, "name") for part, j in best.items()}
    if not found:
        return {}
    inward, outward = list(LIMBS[limb]), list(LIMBS[limb])[::-1]
    for part, beyond in zip(outward[1:], outward, strict=False):  # the parent of the next part outwards
        if part not in found and beyond in found:
            above = next((j for j in tree.up(found[beyond][0])[1:] if not said[j].helper), -1)
            if above >= 0 and said[above].side in (side, "") and len(tree.children[above]) == 1:
                found[part] = above, f"parent of the {beyond}"
    for part, before in zip(inward[1:], inward, strict=False):
        if part not in found and before in found:
            below = [j for j in tree.children[found[before][0]] if not said[j].helper or j in tree.ends]
            if below:
                found[part] = max(below, key=lambda j: tree.lengths[j]), f"below the {before}"
    if set(inward) <= found.keys():
        found |= _halved(said, tree, side, limb, found)
    if "foot" in found and "toe" not in found:
        found["toe"] = _toe(said, tree, found)
    return found


def _halved(said: list[JointName], tree: Tree, side: str, limb: str,
            found: Mapping[str, tuple[int, str]]) -> dict[str, tuple[int, str]]:
    """Upper and middle joint of a limb whose named parts are unequal, if other joints of it make them equal; else none.

    A rig may have one more joint in the thigh, whose name fits the hip or the knee better than the right one's.
    """
    upper, middle, lower = (found[part][0] for part in LIMBS[limb])
    path = [j for j in tree.up(lower) if said[j].side == side and not said[j].helper]

    def likeness(a: int, b: int) -> float:
        parts = tree.distance(a, b), tree.distance(b, lower)
        return min(parts) / max(*parts, 1e-12)

    best = max(((a, b) for b, a in combinations(path[1:], 2)), key=lambda pair: likeness(*pair), default=(upper, middle))
    if likeness(upper, middle) > UNEQUAL or likeness(*best) < EQUAL:
        return {}
    return {part: (j, LENGTHS) for part, j, old in zip(LIMBS[limb], best, (upper, middle), strict=False) if j != old}


def _along(said: list[JointName], path: list[int], chain: tuple[str, ...]) -> dict[str, int]:
    """The parts of a chain on a path: as many as possible, in their order, by the most certain words."""
    best: dict[int, tuple[int, int, dict[str, int]]] = {-1: (0, 0, {})}  # by the last part: count, - ranks, joints
    for j in path:
        new = {}
        for at, part in enumerate(chain):
            if part in said[j].parts:
                count, ranks, places = max((best[k] for k in best if k < at), key=lambda b: b[:2])
                new[at] = count + 1, ranks - said[j].parts[part], places | {part: j}
        for at, state in new.items():
            if at not in best or state[:2] > best[at][:2]:
                best[at] = state
    return max(best.values(), key=lambda b: b[:2])[2]


def _toe(said: list[JointName], tree: Tree, found: Mapping[str, tuple[int, str]]) -> tuple[int, str]:
    """The toe of a leg whose names show none."""
    foot = found["foot"][0]
    shin = tree.distance(found["knee"][0], foot) if "knee" in found else 0.0
    below = max(tree.children[foot], key=lambda j: tree.lengths[j], default=foot)
    if below == foot or tree.lengths[below] <= SHORT * shin:
        return foot, "no toe: the foot"
    return below, "End Site of the foot" if below in tree.ends else "below the foot"


def _hips(said: list[JointName], tree: Tree, found: Mapping[str, tuple[int, str]]) -> tuple[int, str]:
    """The topmost joint above both legs (and both arms, if there is one) that is called hips; else where they meet."""
    def above(*parts: str) -> list[int]:
        roles = [f"{side}_{part}" for side in SIDES for part in parts]
        limbs = [set(tree.up(found[role][0])[1:]) for role in roles if role in found]
        return sorted(set.intersection(*limbs)) if limbs else []

    called = [j for j, name in enumerate(said) if "hips" in name.parts and not name.side and j not in tree.ends]
    for parts in (("hip", "shoulder"), ("hip",)):
        if inner := [j for j in above(*parts) if j in called]:
            return inner[0], "name"
    if called and not above("hip"):
        return called[0], "name"
    return (above("hip")[-1], "where the legs meet") if above("hip") else (0, "the root")


def misfits(names: Sequence[str], parents: Sequence[int], lengths: Sequence[float],
            roles: Mapping[str, str]) -> list[tuple[str, list[str]]]:
    """What is impossible about roles, in words, with the roles that are: a limb out of order or without length."""
    up, size, problems = Tree(parents, lengths).up, max(lengths[1:], default=0.0), []
    for side in SIDES:
        for chain in LIMBS.values():
            have = [f"{side}_{part}" for part in chain if f"{side}_{part}" in roles]
            for a, b in pairwise(have):
                path = up(names.index(roles[b]))
                upper = names.index(roles[a])
                if upper not in path[1:]:
                    problems.append((f"{b} ({roles[b]}) is not below {a} ({roles[a]})", have))
                elif sum(lengths[j] for j in path[: path.index(upper)]) < NOTHING * size:
                    problems.append((f"{a} ({roles[a]}) and {b} ({roles[b]}) are at the same place", have))
    return problems


def mirror_pairs(names: Sequence[str], parents: Sequence[int], roles: Mapping[str, str]) -> tuple[int, ...]:
    """For each joint the index of its left or right counterpart, itself where it has none.

    Joints with the same role on both sides are counterparts, and so are the joints between them and the trunk. Of their
    children, those are counterparts whose names differ only in the side, or else those with equal trees below them. Other
    joints are counterparts if their names differ only in the side.
    """
    said, tree, pairs = joint_names.read_all(names), Tree(parents, [1.0] * len(names)), {}

    def join(a: int, b: int) -> None:
        if a != b and a not in pairs and b not in pairs:
            pairs[a], pairs[b] = b, a

    for role in ROLES:
        part = role.removeprefix("left_")
        if part != role and {role, f"right_{part}"} <= roles.keys():
            a, b = (names.index(roles[r]) if roles[r] in names else -1 for r in (role, f"right_{part}"))
            while a >= 0 <= b and a != b and a not in tree.up(b)[1:] and b not in tree.up(a)[1:]:
                join(a, b)
                a, b = parents[a], parents[b]
    by_name = {(name.side, name.plain): j for j, name in reversed(list(enumerate(said)))}
    for a, name in enumerate(said):  # parents first
        if a not in pairs and name.side:
            join(a, by_name.get((_OTHER[name.side], name.plain), a))
        if (b := pairs.get(a, a)) > a:
            for named in (True, False):
                for child in tree.children[a]:
                    wanted = (_OTHER.get(said[child].side, ""), said[child].plain) if named else tree.shapes[child]
                    join(child, next((j for j in tree.children[b] if j not in pairs and wanted == (
                        (said[j].side, said[j].plain) if named else tree.shapes[j])), child))
    return tuple(pairs.get(j, j) for j in range(len(names)))


def head(names: Sequence[str], parents: Sequence[int], lengths: Sequence[float], roles: Mapping[str, str]) -> list[int]:
    """Path from the root to the head, and to the top of the head if there is such a point; empty if there are no arms.

    The head is the joint called so. Without one it is the end of the longest path between the arms.
    """
    return list(_head(tuple(names), tuple(parents), tuple(lengths), tuple(roles.items())))


@lru_cache(64)
def _head(names: tuple[str, ...], parents: tuple[int, ...], lengths: tuple[float, ...],
          items: tuple[tuple[str, str], ...]) -> list[int]:
    roles = dict(items)
    said, tree = joint_names.read_all(names), Tree(parents, lengths)
    arms = [tree.up(names.index(roles[f"{side}_shoulder"]))[::-1] for side in SIDES if f"{side}_shoulder" in roles]
    if len(arms) < 2:
        return []
    trunk = [a for a, b in zip(*arms, strict=False) if a == b]
    limbs = {names.index(joint) for role, joint in roles.items() if role != "hips"}
    limbs |= {j for j in tree.below(trunk[0]) if said[j].side}
    between = [j for j in tree.below(trunk[-1])[1:] if limbs.isdisjoint(tree.up(j))]
    called = [j for j in between if "head" in said[j].parts]
    if not called:
        return tree.up(max(between, key=lambda j: tree.distance(trunk[-1], j), default=trunk[-1]))[::-1]
    tops = [j for j in tree.below(called[0]) if all(said[k].helper for k in tree.up(j)[: tree.up(j).index(called[0])])]
    return tree.up(max(tops, key=lambda j: tree.distance(called[0], j)))[::-1]
