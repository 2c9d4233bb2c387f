"""Roles from the shape of a tree alone, for rigs whose joint names say nothing.

A body has two pairs of equal limbs on its trunk. The pair nearer the root are the legs. In a limb,
upper and lower part are the two longest neighbouring bones. Which side is left follows from where
the toes point, or else from how the knees bend.
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
def find(names: Sequence[str], parents: Sequence[int], lengths: Sequence[float],
         ends: Sequence[str], points: np.ndarray) -> Found:
    """All roles with their rule, from positions ``points [S, J, 3]`` in some frames.

    Empty if the tree has no such shape.
    """
    leaves = frozenset(ends)
    tree = Tree(parents, lengths, frozenset(j for j, name in enumerate(names) if name in leaves))
    reach = [0.0] * len(names)  # longest path of bones below a joint
    for j in reversed(range(1, len(names))):
        reach[parents[j]] = max(reach[parents[j]], reach[j] + lengths[j])

    # Pairs of limbs of the same length on one joint
    pairs, longest = [], max(reach)
    for joint, below in sorted(tree.children.items()):
        if joint < 0 or len(below) > MOST:
            continue
        for a, b in combinations(below, 2):
            shorter, longer = sorted((reach[a] + lengths[a], reach[b] + lengths[b]))
            if longer - shorter < ALIKE * longer and shorter > LONG * longest:
                pairs.append((joint, a, b))
    if len(pairs) > MANY:
        return {}

    for (hips, *legs), (chest, *arms) in combinations(pairs, 2):
        trunk = tree.up(chest)
        if hips == chest or hips not in trunk or not set(legs).isdisjoint(trunk):
            continue
        legs, arms = ([_limb(tree, reach, points, j) for j in pair] for pair in (legs, arms))
        if not all((*legs, *arms)):
            continue
        found, left = {"hips": hips}, _left(points, hips, chest, legs)
        for limb, chains in (("leg", legs), ("arm", arms)):
            parts = (*LIMBS[limb], "toe") if limb == "leg" else LIMBS[limb]
            for side, chain in zip(_sides(points, chains, left), chains, strict=True):
                found |= {f"{side}_{part}": j for part, j in zip(parts, chain, strict=False)}
        return {role: (names[j], RULE) for role, j in found.items()}
    return {}


def _limb(tree: Tree, reach: list[float], points: np.ndarray, joint: int) -> list[int]:
    """Start, middle and end of a limb and the point beyond, or the end again if there is none.

    Empty if the limb has less than two bones.
    """
    chain = [joint]
    while below := tree.children[chain[-1]]:
        chain.append(max(below, key=lambda j: reach[j] + tree.lengths[j]))
    whole = sum(tree.lengths[j] for j in chain[1:])

    # Tiny bones, and joints that never bend, are left out. A still pose does not show the latter.
    moves = float(np.ptp(points[:, chain] - points[:, :1], axis=0).max()) > TINY * whole
    kept = [joint]
    for j, after in zip(chain[1:], [*chain[2:], chain[-1]], strict=True):
        here, onwards = points[:, j] - points[:, kept[-1]], points[:, after] - points[:, j]
        if np.linalg.norm(here[0]) < TINY * whole:
            continue
        if moves and tree.children[after] and np.linalg.norm(onwards[0]) > TINY * whole:
            size = np.linalg.norm(here, axis=1) * np.linalg.norm(onwards, axis=1)
            if ((here * onwards).sum(-1) / size).min() > STRAIGHT:
                continue
        kept.append(j)

    # The longest two neighbouring bones; of several, the outer ones, since collars may be as long
    bones = [float(np.linalg.norm(points[0, b] - points[0, a])) for a, b in pairwise(kept)]
    if len(bones) < 2:
        return []
    pairs = [min(pair) for pair in pairwise(bones)]
    at = max(k for k, short in enumerate(pairs) if short > NEAR * max(pairs))
    end = far = kept[at + 2]
    if len(kept) > at + 3 and bones[at + 2] > SHORT * bones[at + 1]:
        far = kept[at + 3]
    return [] if end in tree.ends else [*kept[at : at + 3], far]


def _left(points: np.ndarray, hips: int, chest: int, legs: list[list[int]]) -> np.ndarray:
    """Direction to the left in each frame ``[S, 3]``."""
    toes = sum(points[:, toe] - points[:, foot] for _, _, foot, toe in legs)
    knees = sum(points[:, knee] - (points[:, hip] + points[:, foot]) / 2
                for hip, knee, foot, _ in legs)
    ahead = toes if legs[0][3] != legs[0][2] else knees
    return np.cross(points[:, chest] - points[:, hips], ahead)


def _sides(points: np.ndarray, pair: list[list[int]], left: np.ndarray) -> tuple[str, str]:
    """Sides of the two limbs of a pair."""
    apart = (points[:, pair[0][:2]] - points[:, pair[1][:2]]).sum(1)
    return ("left", "right") if (apart * left).sum(-1).mean() > 0 else ("right", "left")
