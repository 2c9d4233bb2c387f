"""What the joints with roles show about a file: where its head is, and which roles cannot be."""

from collections.abc import Mapping, Sequence
from itertools import pairwise

from toolkit.motion import role_words
from toolkit.motion.roles import CHAINS, SIDES, Tree

NOTHING = 1e-3  # of the longest bone: a bone between two roles that is shorter is none


def misfits(names: Sequence[str], tree: Tree,
            roles: Mapping[str, str]) -> list[tuple[str, list[str]]]:
    """Limbs out of order or without length, in words, each with the roles of the limb."""
    longest, problems = max(tree.lengths[1:], default=0.0), []
    for side in SIDES:
        for chain in CHAINS.values():
            have = [f"{side}_{part}" for part in chain if f"{side}_{part}" in roles]
            for a, b in pairwise(have):
                upper, lower = names.index(roles[a]), names.index(roles[b])
                if upper not in tree.up(lower)[1:]:
                    problems.append((f"{b} ({roles[b]}) is not below {a} ({roles[a]})", have))
                elif tree.distance(upper, lower) < NOTHING * longest:
                    said = f"{a} ({roles[a]}) and {b} ({roles[b]}) are at the same place"
                    problems.append((said, have))
    return problems


def head(names: Sequence[str], tree: Tree, roles: Mapping[str, str]) -> list[int]:
    """Path from the root to the head, and to the top of the head if there is such a point.

    The head is the joint called so, else the end of the longest path between the arms. The path is
    empty if there are no arms.
    """
    said = role_words.read_all(names)
    arms = [tree.up(names.index(roles[f"{side}_shoulder"]))[::-1]
            for side in SIDES if f"{side}_shoulder" in roles]
    if len(arms) < 2:
        return []

    # The joints above the chest that belong to no limb.
    trunk = [a for a, b in zip(*arms, strict=False) if a == b]
    limbs = {names.index(joint) for role, joint in roles.items() if role != "hips"}
    limbs |= {j for j in tree.below(trunk[0]) if said[j].side}
    between = [j for j in tree.below(trunk[-1])[1:] if limbs.isdisjoint(tree.up(j))]
    called = [j for j in between if "head" in said[j].parts]
    if not called:
        far = max(between, key=lambda j: tree.distance(trunk[-1], j), default=trunk[-1])
        return tree.up(far)[::-1]

    # Its top is the farthest point that only tips and helpers lead to.
    tops = [j for j in tree.below(called[0])
            if all(said[k].helper for k in tree.up(j)[: tree.up(j).index(called[0])])]
    return tree.up(max(tops, key=lambda j: tree.distance(called[0], j)))[::-1]
