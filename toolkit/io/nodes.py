"""From a scene's nodes with translation, rotation and scale to a rigid skeleton: what glTF and FBX have in common."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor

from toolkit.io.recording import Recording
from toolkit.motion import rotations as R
from toolkit.motion.tensors import few

RIGID = 1e-3  # part of the skeleton's size by which a joint may move against its parent and be called rigid
STRETCH = 0.05  # part of the skeleton's size by which a bone may stretch and be read with its median length
MERGED = 0.25  # joints that may be merged with the one below them, as a share of the joints below
FEW = 2  # joints of a branch that is left out if it cannot be part of a rigid skeleton: eyes, props, helpers
SEVERAL = 10  # joints of a second tree that is worth a word
RATES = (30.0, 24.0, 25.0, 60.0, 50.0, 48.0, 120.0, 100.0, 240.0)  # tried where key frames are not at equal distances
FRAMES = 500_000  # of an animation, and keys of a curve: more than two hours at 60 Hz
MOST = 1_000_000  # joints times frames that a file of any size may have
LIMIT = 50_000  # nodes of a file
_HELPER = re.compile(r"(?:^|[\W_])ik(?:[\W_]|$)|IK", re.ASCII)
_END = re.compile(r"(?:end|nub)\d*$", re.IGNORECASE)


@dataclass(eq=False)
class Node:
    """A node of a scene; its tracks have one row if they are constant, otherwise one for each of F frames."""

    name: str
    parent: int  # index of a node, -1 at the top
    translation: np.ndarray  # [F or 1, 3] in the file's unit
    rotation: Tensor  # [F or 1, 4] w first, float64
    scale: np.ndarray  # [F or 1, 3]
    joint: bool = False  # animated, in a skin, or a bone by its type
    skinned: bool = False  # a skin follows it
    plain: bool = True  # no mesh, camera or light: may be the tip of a bone


def printable(name: object) -> str:
    """A node's name without characters that cannot be printed."""
    return "".join(c if c.isprintable() else "\ufffd" for c in str(name)).strip()


def frame_rate(times: Sequence[np.ndarray], usual: float) -> float:
    """Frames per second at which all key times (seconds, one array for each curve) lie on frames.

    It is the keys' own rate if they are at equal distances and at least 12 a second, otherwise ``usual`` or the first of
    `RATES` that meets them, otherwise ``usual``.
    """
    if (most := max(map(len, times))) > FRAMES:
        raise ValueError(f"a curve of {most} keys, more than {FRAMES}")
    keys = max(times, key=len) if len(times) > 64 else np.concatenate(times)
    keys = np.unique(np.round(keys, 5))
    if len(keys) < 2:
        return usual
    own = (len(keys) - 1) / float(keys[-1] - keys[0])
    own = float(round(own)) if abs(own - round(own)) < 0.02 else own
    for rate in ([own] if own >= 12 else []) + [usual, *RATES]:
        places = (keys - keys[0]) * rate
        if np.abs(places - np.round(places)).max() < 0.05:
            return rate
    return usual


def sample_times(times: Sequence[np.ndarray], rate: float, joints: int, size: int) -> np.ndarray:
    """Times ``[F]`` of the frames from the first key to the last; one frame if there is no key.

    ValueError if a file of ``size`` bytes cannot hold so many frames of so many joints.
    """
    if not times:
        return np.zeros(1)
    begin, end = min(t[0] for t in times), max(t[-1] for t in times)
    length = (end - begin) * rate
    if not length < max(MOST, size / 8) / max(joints, 1):
        raise ValueError(f"{length:.0f} frames of {joints} joints are more than {size} bytes can hold")
    if length > FRAMES:
        raise ValueError(f"{length:.0f} frames, more than {FRAMES}")
    return begin + np.arange(round(length) + 1) / rate


def record(nodes: Sequence[Node], frames: int, fps: float, *, format_: str, unit: float | None, up: str | None,
           roles: dict[str, int] | None = None, doubts: Sequence[str] = ()) -> Recording:
    """The largest skeleton among the nodes.

    The skeleton begins at the uppermost joint. Nodes above it, and a root that its only large branch moves against
    (an armature that stays while the hips travel), become part of the root's rotation and position. Scales become part of
    the offsets. A bone that stretches by less than `STRETCH` has its median length.

    Parameters
    ----------
    nodes, frames, fps : the scene, sampled
    format_, unit, up : as in `Recording`
    roles : from a role to the index of a node
    doubts : of the reader

    Raises
    ------
    ValueError
        If there is no joint, nodes form a circle, a scale is negative, or the skeleton is not rigid.
    """
    doubts, tree = list(doubts), _Tree(nodes)
    root = tree.top(doubts)
    sizes = tree.lengths(root)
    root, dropped = tree.merged(root, sizes)
    kept, stretched, offsets = [], {}, np.zeros((len(nodes), 3))
    size, scales = max(sizes.values()), {root: tree.world_scale(root)}
    for j in tree.chain(root):
        _scale(nodes[j], tree.children[j], doubts)
    stack = [root]
    while stack:
        j = stack.pop()
        kept.append(j)
        for child in reversed(tree.children[j]):
            if child in dropped or not (tree.count[child] or nodes[child].plain):
                continue
            moves = nodes[child].translation * scales[j]
            offsets[child] = np.median(moves, axis=0)
            spread = float(np.ptp(moves, axis=0).max()) if len(moves) > 1 else 0.0
            if spread > STRETCH * size:
                if tree.droppable(child):
                    dropped.add(child)
                    continue
                raise ValueError(f"joint {nodes[child].name} changes its distance to its parent by up to {spread:.4g} "
                                 "units; only rigid skeletons are supported")
            if spread > RIGID * size:
                stretched[nodes[child].name] = spread
            scales[child] = _scale(nodes[child], tree.children[child], doubts) * float(np.prod(scales[j]) ** (1 / 3))
            stack.append(child)
    if stretched:
        doubts.append(f"joints that move against their parents by up to {max(stretched.values()):.3g} units have their "
                      f"median places: {few(stretched)}")
    if left := [nodes[j].name for j in sorted(dropped) if tree.count[j]]:
        doubts.append(f"joints that move against the skeleton were left out: {few(left)}")
    names, place = unique([nodes[j].name or f"node{j}" for j in kept]), {j: i for i, j in enumerate(kept)}
    turned, positions = tree.world(root)
    rotations = torch.empty(frames, len(kept), 4)
    for i, j in enumerate(kept):
        rotations[:, i] = turned if j == root else nodes[j].rotation
    leaves = [i for i, j in enumerate(kept) if i and not any(child in place for child in tree.children[j])]
    return Recording(
        format_, tuple(names), tuple(place.get(nodes[j].parent, -1) if j != root else -1 for j in kept),
        torch.from_numpy(offsets[kept]), R.unroll(rotations), torch.from_numpy(positions).expand(frames, 3).clone(), fps,
        ends=tuple(names[i] for i in leaves if _END.search(names[i]) and len(nodes[kept[i]].rotation) == 1),
        unit=unit, up=up, doubts=tuple(doubts),
        roles=None if roles is None else {role: names[place[j]] for role, j in roles.items() if j in place})


class _Tree:
    """Children, number of joints and world transforms of nodes."""

    def __init__(self, nodes: Sequence[Node]):
        self.nodes, self.children, self.order = nodes, [[] for _ in nodes], []
        for j, node in enumerate(nodes):
            if node.parent >= 0:
                self.children[node.parent].append(j)
        stack = [j for j, node in enumerate(nodes) if node.parent < 0]
        while stack:
            self.order.append(stack.pop())
            stack.extend(self.children[self.order[-1]])
        if len(self.order) != len(nodes):
            raise ValueError("some nodes are their own ancestors")
        self.count, self.skinned = [int(node.joint) for node in nodes], [int(node.skinned) for node in nodes]
        for j in reversed(self.order):
            if nodes[j].parent >= 0:
                self.count[nodes[j].parent] += self.count[j]
                self.skinned[nodes[j].parent] += self.skinned[j]
        self.skin = any(self.skinned)

    def top(self, doubts: list[str]) -> int:
        """The uppermost joint of the largest skeleton: a joint, or a node with several large branches."""
        branches, at = [j for j, node in enumerate(self.nodes) if node.parent < 0 and self.count[j]], -1
        if not branches:
            raise ValueError("there are no joints in it: no skin, no animated node, no bone")
        while at < 0 or not self.nodes[at].joint:
            branches.sort(key=lambda j: -self.count[j])
            if at >= 0 and len(branches) > 1 and self.count[branches[1]] > FEW:
                if not all(self._several(j) for j in branches[:2]):
                    return at
                doubts.append(f"the file holds several skeletons; that of {self.nodes[branches[0]].name} was read")
            elif len(branches) > 1 and self.count[branches[1]] >= SEVERAL:
                doubts.append(f"the file holds several skeletons; that of {self.nodes[branches[0]].name} was read")
            at = branches[0]
            branches = [j for j in self.children[at] if self.count[j]]
        return at

    def _several(self, j: int) -> bool:
        """Whether a branch looks like a whole skeleton: a chain without joints, then many."""
        return self.count[j] >= SEVERAL and not self.nodes[j].joint

    def droppable(self, j: int) -> bool:
        """Whether a branch is a helper of the rig, which no skin follows, or too small to be a limb."""
        unused = self.skin and not self.skinned[j]
        return self.count[j] <= FEW or unused or bool(_HELPER.search(self.nodes[j].name))

    def _helper(self, j: int, moving: list[bool]) -> bool:
        """Whether a branch beside the main one is no limb: without skin, and small or moving against its parents."""
        unused = not self.skinned[j] and (self.count[j] <= FEW or (self.skin and moving[j]))
        return unused or bool(_HELPER.search(self.nodes[j].name))

    def lengths(self, root: int) -> dict[int, float]:
        """For each node below a joint the length of the bones between them, in the first frame."""
        below, scale, stack = {root: 0.0}, {root: self.world_scale(root)}, [root]
        self.scales = scale
        while stack:
            j = stack.pop()
            for child in self.children[j]:
                if self.count[child]:
                    move = np.median(self.nodes[child].translation, axis=0) * scale[j]
                    below[child] = below[j] + float(np.linalg.norm(move))
                    scale[child] = np.abs(self.nodes[child].scale[0]) * float(np.prod(np.abs(scale[j])) ** (1 / 3))
                    stack.append(child)
        return below

    def merged(self, root: int, sizes: dict[int, float]) -> tuple[int, set[int]]:
        """The lowest joint that carries the whole skeleton and moves against its parent, and the branches left out."""
        at, best, above, dropped, aside = root, root, 0, set(), set()
        most, large, few_lost = RIGID * max(sizes.values()), STRETCH * max(sizes.values()), False
        moving = [len(node.translation) > 1 and float(np.ptp(node.translation, axis=0).max()) * float(np.max(
            self.scales.get(node.parent, 1.0))) > large for node in self.nodes]
        for j in reversed(self.order):
            if self.nodes[j].parent >= 0:
                moving[self.nodes[j].parent] |= moving[j]
        while branches := [j for j in self.children[at] if self.count[j]]:
            main = max(branches, key=lambda j: self.count[j])
            aside |= set(self.children[at]) - {main}
            above += 1
            if above > MERGED * self.count[main] or not all(self._helper(j, moving) for j in branches if j != main):
                break
            few_lost = few_lost or any(j != main and not _HELPER.search(self.nodes[j].name) for j in branches)
            at, moves = main, self.nodes[main].translation * self.scales[at]
            if len(moves) > 1 and float(np.ptp(moves, axis=0).max()) > (large if few_lost else most):
                best, dropped = main, set(aside)
        return best, dropped

    def world_scale(self, j: int) -> np.ndarray:
        """Scale ``[3]`` of a node in the world: its own by axis, its ancestors' as a mean."""
        scale = np.median(self.nodes[j].scale, axis=0)
        while (j := self.nodes[j].parent) >= 0:
            scale = scale * np.prod(np.abs(np.median(self.nodes[j].scale, axis=0))) ** (1 / 3)
        return np.abs(scale)

    def chain(self, j: int) -> list[int]:
        """A node after its ancestors, from the top."""
        above = [j]
        while self.nodes[above[-1]].parent >= 0:
            above.append(self.nodes[above[-1]].parent)
        return above[::-1]

    def world(self, j: int) -> tuple[Tensor, np.ndarray]:
        """Rotations ``[F or 1, 4]`` and positions ``[F or 1, 3]`` of a node in the world."""
        turned, place, scale = R.identity(1).double(), np.zeros((1, 3)), np.ones(3)
        for node in (self.nodes[i] for i in self.chain(j)):
            place = place + R.rotate(turned, torch.from_numpy(node.translation * scale)).numpy()
            turned = R.multiply(*torch.broadcast_tensors(turned, node.rotation))
            scale = np.median(node.scale, axis=0) * float(np.prod(scale) ** (1 / 3))
        return turned, place


def _scale(node: Node, children: Sequence[int], doubts: list[str]) -> np.ndarray:
    """Median scale ``[3]`` of a joint; a doubt if its children are stretched or sheared by it."""
    scale = np.median(node.scale, axis=0)
    if children:
        if (scale < 0).any():
            raise ValueError(f"node {node.name} is mirrored by a negative scale; apply the scale in Blender first")
        largest = float(scale.max())
        if largest and float(np.ptp(node.scale, axis=0).max()) > RIGID * largest:
            doubts.append(f"the scale of joint {node.name} changes; its median {largest:.6g} is used")
        elif float(np.ptp(scale)) > RIGID * largest:
            doubts.append(f"joint {node.name} is scaled by different factors along its axes")
    return scale


def unique(names: Sequence[str]) -> list[str]:
    """Names with numbers where they repeat."""
    taken, made, last = set(names), [], {}
    seen = set()
    for name in names:
        new = name
        while new in seen or (new != name and new in taken):
            last[name] = last.get(name, 1) + 1
            new = f"{name}_{last[name]}"
        seen.add(new)
        made.append(new)
    return made
