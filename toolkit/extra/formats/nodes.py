"""From a scene's nodes with translation, rotation and scale to a rigid skeleton, for glTF and FBX.

Some nodes are joints. Others only hold joints: an armature in other units, a root that stays
where it is, empty nodes. `record` finds the largest skeleton in three steps:

1. `_Tree.top` goes down from the scene's top to the uppermost joint.
2. `_Tree.travelling` goes on to the joint that moves through the world, most often the hips.
3. `_Tree.rigid` collects the joints below it and refuses limbs that change their length.
"""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from toolkit.io.recording import Recording
from toolkit.motion import rotations as R
from toolkit.motion.roles import Tree
from toolkit.motion.tensors import few

# Shares of the skeleton's size (the longest path of bones from its root)
RIGID = 1e-3  # by which a joint may move against its parent and be called rigid
STRETCH = 0.05  # by which a bone may stretch and be read with its median length
# Numbers of joints
MERGED = 0.25  # joints that may become part of the root, as a share of the joints below
FEW = 2  # joints of a branch that may be left out: eyes, props, helpers
SEVERAL = 10  # joints of a branch that may be a skeleton of its own
LIMIT = 50_000  # nodes of a glTF file

_HELPER = re.compile(r"(?:^|[\W_])ik(?:[\W_]|$)|IK", re.ASCII)
END = re.compile(r"(?:end|nub)\d*$", re.IGNORECASE)


@dataclass(eq=False)
class Node:
    """A node of a scene; its tracks have a row for each of F frames, or one if they are still."""

    name: str
    parent: int  # index of a node, -1 at the top
    translation: np.ndarray  # [F or 1, 3] in the file's unit
    rotation: Tensor  # [F or 1, 4] w first, float64
    scale: np.ndarray  # [F or 1, 3]
    joint: bool = False  # animated, in a skin, or a bone by its type
    skinned: bool = False  # a skin follows it
    plain: bool = True  # no mesh, camera or light: may be the tip of a bone


def unique(names: Sequence[str]) -> list[str]:
    """Names with numbers where they repeat."""
    given, made, numbers = set(names), {}, {}
    for name in names:
        new = name
        while new in made or (new != name and new in given):
            numbers[name] = numbers.get(name, 1) + 1
            new = f"{name}_{numbers[name]}"
        made[new] = None
    return list(made)


def descending(parents: Sequence[int]) -> tuple[Tree, list[int]]:
    """The tree of nodes without lengths, and all nodes, parents first.

    ValueError if nodes form a circle: these are below no top.
    """
    tree = Tree(parents)
    order = tree.below(-1)[1:]
    if len(order) != len(parents):
        raise ValueError("some nodes are their own ancestors")
    return tree, order


def chosen(names: Sequence[str], wanted: str | int | None, doubts: list[str]) -> int:
    """Index of the animation to read, by its name or index; by default the first, with a doubt.

    A text that is no name may be an index.
    """
    if wanted is None:
        if len(names) > 1:
            doubts.append(f"the file holds {len(names)} animations ({few(names)}); "
                          "the first was read; animation= decides")
        return 0
    if wanted in names:
        return names.index(wanted)
    if str(wanted).isdecimal() and int(wanted) < len(names):
        return int(wanted)
    raise ValueError(f"no animation {wanted!r}; there are {few(names) or 'none'}")


def record(nodes: Sequence[Node], frames: int, fps: float, *, format_: str, unit: float | None,
           up: str | None, doubts: list[str], roles: dict[str, int] | None = None) -> Recording:
    """The largest skeleton among the nodes.

    Nodes above the skeleton's root become part of the root's rotation and position. Scales become
    part of the offsets. A bone that stretches by less than `STRETCH` has its median length.

    Parameters
    ----------
    nodes, frames, fps : the scene, sampled
    format_, unit, up : as in `Recording`
    doubts : of the reader; more are added
    roles : from a role to the index of a node

    Raises
    ------
    ValueError
        If there is no joint, nodes form a circle, a scale is negative, or a limb is not rigid.
    """
    tree = _Tree(nodes)
    if all(len(node.rotation) == len(node.translation) == 1 for node in nodes):
        doubts.append("no joint is animated; the pose of the nodes is given as it is")
    top = tree.top(doubts)
    root, left_out = tree.travelling(top)
    kept, offsets = tree.rigid(root, left_out, tree.size(top), doubts)
    names = unique([nodes[j].name.strip() or f"node{j}" for j in kept])
    place = {j: i for i, j in enumerate(kept)}

    # The root holds what the nodes above it do; all other joints keep their own rotations
    turned, positions = tree.world(root)
    rotations = torch.empty(frames, len(kept), 4)
    rotations[:, 0] = turned
    for i, j in enumerate(kept[1:], 1):
        rotations[:, i] = nodes[j].rotation
    parents = (-1, *(place[nodes[j].parent] for j in kept[1:]))

    inner = {0, *parents}
    ends = [names[i] for i, j in enumerate(kept) if i not in inner
            and END.search(names[i]) and len(nodes[j].rotation) == 1]
    if roles is not None:
        roles = {role: names[place[j]] for role, j in roles.items() if j in place}
    return Recording(
        format_, tuple(names), parents, torch.from_numpy(offsets), R.unroll(rotations),
        torch.from_numpy(positions).expand(frames, 3).clone(), fps, ends=tuple(ends), unit=unit,
        up=up, roles=roles, doubts=tuple(doubts))


class _Tree:
    """The tree of nodes: children, numbers of joints in each branch, and scales in the world."""

    def __init__(self, nodes: Sequence[Node]):
        self.nodes = nodes
        self.tree, self.order = descending([node.parent for node in nodes])

        # Joints and skinned joints of each branch, with its top
        self.joints = self.counted(node.joint for node in nodes)
        self.skinned = self.counted(node.skinned for node in nodes)
        self.skin = any(self.skinned)

        # Scale of a node in the world. Of the nodes above only the mean over the axes counts:
        # a rigid skeleton cannot shear.
        self.scale = np.empty((len(nodes), 3))
        for j in self.order:
            self.scale[j] = np.abs(_median(nodes[j].scale))
            if nodes[j].parent >= 0:
                self.scale[j] *= np.prod(self.scale[nodes[j].parent]) ** (1 / 3)

    def counted(self, chosen: Iterable[bool]) -> list[int]:
        """For each node how many are chosen in the branch with it at the top."""
        found = [int(of) for of in chosen]
        for j in reversed(self.order):
            if self.nodes[j].parent >= 0:
                found[self.nodes[j].parent] += found[j]
        return found

    def branches(self, nodes: Sequence[int]) -> list[int]:
        """Those of the nodes that have joints below, first that with most joints of the skin.

        Without a skin, that with most joints comes first.
        """
        return sorted((j for j in nodes if self.joints[j]),
                      key=lambda j: (-self.skinned[j], -self.joints[j]))

    def top(self, doubts: list[str]) -> int:
        """The uppermost joint of the largest skeleton: a joint, or a node with several limbs."""
        branches = self.branches([j for j, node in enumerate(self.nodes) if node.parent < 0])
        if not branches:
            raise ValueError("there are no joints in it: no skin, no animated node, no bone")
        while True:
            at, *others = branches
            if others and self.joints[others[0]] >= SEVERAL:
                doubts.append("the file holds several skeletons; "
                              f"that of {self.nodes[at].name} was read")
            branches = self.branches(self.tree.children[at])
            limbs = len(branches) > 1 and self.joints[branches[1]] > FEW
            if self.nodes[at].joint or (limbs and not all(map(self.whole, branches[:2]))):
                return at

    def whole(self, j: int) -> bool:
        """Whether a branch looks like a whole skeleton: no joint at its top, many below."""
        return self.joints[j] >= SEVERAL and not self.nodes[j].joint

    def bone(self, j: int) -> np.ndarray:
        """Translation ``[F or 1, 3]`` of a node in the world's unit and its parent's axes."""
        parent = self.nodes[j].parent
        return self.nodes[j].translation * (self.scale[parent] if parent >= 0 else 1.0)

    def size(self, root: int) -> float:
        """Length of the longest path of bones from the root to a joint."""
        reach = {root: 0.0}
        for j in self.order:
            above = self.nodes[j].parent
            if above in reach and self.joints[j]:
                reach[j] = reach[above] + float(np.linalg.norm(_median(self.bone(j))))
        return max(reach.values())

    def travelling(self, top: int) -> tuple[int, set[int]]:
        """The joint that carries the skeleton through the world, and the branches left out above.

        In many rigs a root joint stays where it is, and a joint below, the hips, moves against it.
        All limbs must be below that joint; beside it there may only be helpers.
        """
        size = self.size(top)

        # Branches in which a joint moves against its parent
        moving = self.counted(_spread(self.bone(j)) > STRETCH * size
                              for j in range(len(self.nodes)))

        def aside(j: int) -> bool:
            """Whether a branch is no limb: a helper, or small or moving and without a skin."""
            apart = self.joints[j] <= FEW or (self.skin and moving[j] > 0)
            return self.helper(j) or (apart and not self.skinned[j])

        root, left_out = top, set()
        passed: set[int] = set()  # branches beside the way down
        at, steps, doubtful = top, 0, False
        while branches := self.branches(self.tree.children[at]):
            at, *others = branches
            steps += 1
            passed |= set(self.tree.children[self.nodes[at].parent]) - {at}
            if steps > MERGED * self.joints[at] or not all(map(aside, others)):
                break
            # If only helpers are lost, any motion shows the root; otherwise only a large one does
            doubtful = doubtful or not all(map(self.helper, others))
            if _spread(self.bone(at)) > (STRETCH if doubtful else RIGID) * size:
                root, left_out = at, set(passed)
        return root, left_out

    def helper(self, j: int) -> bool:
        """Whether a node is a helper of inverse kinematics by its name."""
        return bool(_HELPER.search(self.nodes[j].name))

    def rigid(self, root: int, left_out: set[int], size: float,
              doubts: list[str]) -> tuple[list[int], np.ndarray]:
        """The joints from the root down, parents first, and their offsets ``[J, 3]``.

        Branches that move against the skeleton are left out if no limb can be in them, otherwise
        refused.
        """
        kept, stack, stretched, moving = [], [root], {}, set(left_out)
        while stack:
            j = stack.pop()
            kept.append(j)
            for child in reversed(self.tree.children[j]):
                node = self.nodes[child]
                if child in moving or not (self.joints[child] or node.plain):
                    continue
                spread = _spread(self.bone(child))
                unused = self.skin and not self.skinned[child]
                if spread > STRETCH * size or (unused and (node.scale < 0).any()):
                    if not (unused or self.joints[child] <= FEW or self.helper(child)):
                        raise ValueError(
                            f"joint {node.name} changes its distance to its parent by up to "
                            f"{spread:.4g} units; only rigid skeletons are supported")
                    moving.add(child)
                    continue
                if spread > RIGID * size:
                    stretched[node.name] = spread
                stack.append(child)
        if stretched:
            most = max(stretched.values())
            doubts.append(f"joints that move against their parents by up to {most:.3g} units have "
                          f"their median places: {few(stretched)}")
        if names := [self.nodes[j].name for j in sorted(moving) if self.joints[j]]:
            doubts.append("joints that move against the skeleton, or are mirrored controls, were "
                          f"left out: {few(names)}")
        self._check_scales({*self.tree.up(root), *kept}, doubts)
        offsets = np.stack([_median(self.bone(j)) for j in kept])
        offsets[0] = 0.0
        return kept, offsets

    def _check_scales(self, kept: set[int], doubts: list[str]) -> None:
        """A doubt if a scale changes, or stretches children along one axis.

        ValueError if one is negative.
        """
        odd = []
        for j in sorted(j for j in kept if self.tree.children[j]):
            scale = _median(self.nodes[j].scale)
            if (scale < 0).any():
                raise ValueError(f"node {self.nodes[j].name} is mirrored by a negative scale; "
                                 "apply the scale in Blender first")
            changes = max(_spread(self.nodes[j].scale), float(np.ptp(scale)))
            if changes > RIGID * float(scale.max()):
                odd.append(self.nodes[j].name)
        if odd:
            doubts.append("joints whose scale changes, or differs between its axes, have a mean: "
                          f"{few(odd)}")

    def world(self, j: int) -> tuple[Tensor, np.ndarray]:
        """Rotations ``[F or 1, 4]`` and positions ``[F or 1, 3]`` of a node in the world."""
        turned, place = R.identity(1).double(), np.zeros((1, 3))
        for i in reversed(self.tree.up(j)):
            place = place + R.rotate(turned, torch.from_numpy(self.bone(i))).numpy()
            turned = R.multiply(turned, self.nodes[i].rotation)
        return turned, place


def _spread(values: np.ndarray) -> float:
    """The largest change of values ``[F, 3]`` over the frames, along one axis."""
    return float(np.ptp(values, axis=0).max()) if len(values) > 1 else 0.0


def _median(values: np.ndarray) -> np.ndarray:
    """Median ``[3]`` of values ``[F, 3]`` over the frames."""
    return np.median(values, axis=0) if len(values) > 1 else values[0]
