"""Roles from the shape of a tree alone, for rigs whose joint names say nothing.

A body has two pairs of equal limbs on its trunk. The pair nearer the root are the legs. In a limb, upper and lower part are
the two longest neighbouring bones. Which side is left follows from where the toes point, or else from how the knees bend.
"""

from collections.abc import Sequence
from itertools import combinations, pairwise

import numpy as np

from toolkit.motion.roles import LIMBS, SHORT, Found, Tree

RULE = "shape of the tree"
ALIKE = 0.1  # relative difference of two limbs of a pair
LONG = 0.25  # of the longest limb: one that is shorter is no arm or leg
TINY = 0.04  # of a limb: a bone that is shorter is part of the next
NEAR = 0.85  # of the longest: bones that are as long, of which the outer ones count
MOST, MANY = 24, 200  # children of a joint, and pairs of like limbs, of a body; more are no body
STRAIGHT = 0.996  # cosine between bones that are one bone if it is never less: 5 degrees


@np.errstate(all="ignore")  # bones may have no length
def find(names: Sequence[str], parents: Sequence[int], lengths: Sequence[float], ends: Sequence[str],
         points: np.ndarray) -> Found:
    """All roles with their rule, from positions ``points [S, J, 3]`` in some frames; empty if the tree has no such shape."""
    leaves = frozenset(ends)
    tree = Tree(parents, lengths, frozenset(j for j, name in enumerate(names) if name in leaves))
    reach = [0.0] * len(names)
    for j in reversed(range(1, len(names))):
        reach[parents[j]] = max(reach[parents[j]], reach[j] + lengths[j])
    longest = max(reach)
    pairs = [(p, a, b) for p, below in sorted(tree.children.items()) if p >= 0 and len(below) <= MOST
             for a, b in combinations(below, 2)
             if abs((ra := reach[a] + lengths[a]) - (rb := reach[b] + lengths[b])) < ALIKE * max(ra, rb)
             and min(ra, rb) > LONG * longest]
    if len(pairs) > MANY:
        return {}
    for (hips, *legs), (chest, *arms) in combinations(pairs, 2):
        if hips == chest or hips not in tree.up(chest) or any(leg in tree.up(chest) for leg in legs):
            continue
        limbs = {"leg": [_limb(tree, reach, points, j) for j in legs], "arm": [_limb(tree, reach, points, j) for j in arms]}
        if all(all(pair) for pair in limbs.values()):
            sides = _sides(points, hips, chest, limbs["leg"])
            found = {f"{side}_{part}": j for limb, pair in limbs.items()
                     for side, joints in zip(_ordered(points, pair, sides), pair, strict=True)
                     for part, j in zip((*LIMBS[limb], "toe")[: len(joints) if limb == "leg" else 3], joints, strict=False)}
            return {role: (names[j], RULE) for role, j in ({"hips": hips} | found).items()}
    return {}


def _limb(tree: Tree, reach: list[float], points: np.ndarray, joint: int) -> list[int]:
    """Start, middle and end of a limb and the point beyond, which is the end again if there is none; empty if too short."""
    chain = [joint]
    while below := tree.children[chain[-1]]:
        chain.append(max(below, key=lambda j: reach[j] + tree.lengths[j]))
    whole = sum(tree.lengths[j] for j in chain[1:])
    moves = float(np.ptp(points[:, chain] - points[:, :1], axis=0).max()) > TINY * whole  # a still pose shows no joints
    kept = [joint]
    for j, after in zip(chain[1:], [*chain[2:], chain[-1]], strict=True):
        if np.linalg.norm(points[0, j] - points[0, kept[-1]]) < TINY * whole:
            continue
        if tree.children[after] and np.linalg.norm(points[0, after] - points[0, j]) > TINY * whole:
            here, onwards = (points[:, b] - points[:, a] for a, b in ((kept[-1], j), (j, after)))
            cosine = (here * onwards).sum(-1) / (np.linalg.norm(here, axis=1) * np.linalg.norm(onwards, axis=1))
            if cosine.min() > STRAIGHT and moves:
                continue
        kept.append(j)
    bones = [float(np.linalg.norm(points[0, b] - points[0, a])) for a, b in pairwise(kept)]
    if len(bones) < 2:
        return []
    pairs = [min(pair) for pair in pairwise(bones)]
    at = max(k for k, short in enumerate(pairs) if short > NEAR * max(pairs))  # collars may be as long as arms
    end = kept[at + 2]
    far = kept[at + 3] if len(kept) > at + 3 and bones[at + 2] > SHORT * bones[at + 1] else end
    return [] if end in tree.ends else [*kept[at : at + 3], far]


def _sides(points: np.ndarray, hips: int, chest: int, legs: list[list[int]]) -> np.ndarray:
    """Direction to the left in each frame ``[S, 3]``."""
    up = points[:, chest] - points[:, hips]
    toes, knees = (sum(points[:, leg[b]] - (points[:, leg[a]] + points[:, leg[c]]) / 2 for leg in legs)
                   for a, b, c in ((2, 3, 2), (0, 1, 2)))
    ahead = toes if legs[0][3] != legs[0][2] else knees
    return np.cross(up, ahead)


def _ordered(points: np.ndarray, pair: list[list[int]], left: np.ndarray) -> tuple[str, str]:
    """Sides of the two limbs of a pair."""
    apart = ((points[:, pair[0][:2]] - points[:, pair[1][:2]]).sum(1) * left).sum(-1).mean()
    return ("left", "right") if apart > 0 else ("right", "left")
