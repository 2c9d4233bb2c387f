"""The skeleton as a graph: adjacency and body-part pooling (Park et al. 2021, sections 4, 5)."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import torch
from torch import Tensor

from toolkit.motion import Skeleton
from toolkit.motion.roles import Tree
from toolkit.motion.tensors import summary

POOLINGS = 2  # the paper's: joints, then halves of body parts, then body parts
SUBSETS = 3  # the joint itself, the neighbour towards the root, the neighbours away from it


@dataclass(frozen=True, eq=False)
class SkeletonGraph:
    """A skeleton at three resolutions, for example 21, 10 and 5 nodes; made by `SkeletonGraph.of`.

    ``parents[level]`` are the parents of a level's nodes, -1 for the root, which is first.
    ``clusters[level]`` has for each node the node of the next level into which it is pooled.
    """

    skeleton: Skeleton
    parents: tuple[tuple[int, ...], ...]
    clusters: tuple[tuple[int, ...], ...]
    __repr__ = summary

    @classmethod
    def of(cls, skeleton: Skeleton) -> "SkeletonGraph":
        """The graph of any skeleton (section 5.2): pairs of joints of `body_parts` are pooled.

        In a chain of odd length the first node gets three joints; a chain of one node is not
        pooled.
        """
        chains, parents, clusters = body_parts(skeleton.parents), [tuple(skeleton.parents)], []
        for _ in range(POOLINGS):
            groups = []
            for chain in chains:
                parts = torch.tensor(chain).tensor_split(max(1, len(chain) // 2))
                groups += [part.tolist() for part in parts]
            groups.sort()
            home = {node: i for i, group in enumerate(groups) for node in group}
            clusters.append(tuple(home[node] for node in sorted(home)))
            # a group hangs on the group of its first node's parent; that of the root has none
            parents.append(tuple(home.get(parents[-1][group[0]], -1) for group in groups))
            chains = [sorted({home[node] for node in chain}) for chain in chains]
        return cls(skeleton, tuple(parents), tuple(clusters))

    @cached_property
    def sizes(self) -> tuple[int, ...]:
        """Nodes of each level, finest first."""
        return tuple(map(len, self.parents))

    def adjacency(self, level: int) -> Tensor:
        """``[3, N, N]``: self, towards the root, away from it (equation 1).

        ``x @ adjacency[k]`` is the mean over subset k. Entry (v, w) is the weight of node v in the
        mean of node w. A column sums to 1, or to 0 if the subset is empty.
        """
        parents = torch.tensor(self.parents[level])
        child = torch.arange(1, len(parents))
        subsets = torch.zeros(SUBSETS, len(parents), len(parents))
        subsets[0].fill_diagonal_(1.0)
        subsets[1, parents[1:], child] = 1.0
        subsets[2, child, parents[1:]] = 1.0
        return subsets / subsets.sum(1, keepdim=True).clamp_min(1.0)

    def pool(self, level: int) -> Tensor:
        """``[N, N']``: ``x @ pool`` is the mean over each cluster, a node of the next level."""
        copies = self.unpool(level).T
        return copies / copies.sum(0)

    def unpool(self, level: int) -> Tensor:
        """``[N', N]``: ``x @ unpool`` copies each node of the next level to its cluster."""
        clusters = torch.tensor(self.clusters[level])
        return torch.nn.functional.one_hot(clusters, self.sizes[level + 1]).float().T


def body_parts(parents: Sequence[int]) -> list[list[int]]:
    """Chains of joints: the trunk and the limbs of a body, found from the shape of the tree alone.

    A chain continues with the largest subtree that has no sibling of the same shape. Limbs come in
    pairs, so each starts a new chain; the spine continues between the legs and between the arms up
    to the head.
    """
    tree = Tree(parents, [1.0] * len(parents))
    sizes = [len(tree.below(joint)) for joint in range(len(parents))]
    chains, heads = [], [0]
    while heads:
        chain = [heads.pop(0)]
        while below := tree.children[chain[-1]]:
            seen = Counter(tree.shapes[c] for c in below)
            single = [c for c in below if seen[tree.shapes[c]] == 1]
            heir = max(single, key=sizes.__getitem__, default=None)
            heads += [c for c in below if c != heir]
            if heir is None:
                break
            chain.append(heir)
        chains.append(chain)
    return sorted(chains)
