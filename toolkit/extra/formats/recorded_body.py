"""The body in a recording, in the file's unit and axes: its joints in some frames, its measures.

Also what joints with roles show before that: where the head is, and which roles cannot be.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from functools import cached_property
from itertools import pairwise, takewhile

import numpy as np
import torch

from toolkit.io.recording import Recording
from toolkit.motion import Skeleton, forward_kinematics, role_words
from toolkit.motion.contacts import floor_line
from toolkit.motion.roles import CHAINS, ROLES, SIDES, Tree

SAMPLES = 48  # frames that are looked at
PART = 6  # of them at least in a part of the clip, whose lowest toe is the floor there
SOLE, CROWN = 0.08, 0.24  # shares of a leg: height of an ankle, and of the head above its joint
NOTHING = 1e-3  # of the longest bone: a bone between two roles that is shorter is none
UPRIGHT = 0.5  # of the height: how far the head of an upright body is above its feet


def heights(points: np.ndarray, up: str) -> np.ndarray:
    """Heights ``[...]`` of points ``[..., 3]`` along an axis such as "z" or "-y"."""
    found = points[..., "xyz".index(up[-1])]
    return -found if up[0] == "-" else found


class RecordedBody:
    """Points of the joints with roles and of the head over at most `SAMPLES` frames."""

    def __init__(self, recording: Recording, roles: Mapping[str, str]):
        self.recording, self.names = recording, recording.names
        self.tree = Tree(recording.parents, recording.offsets.norm(dim=-1).tolist())
        self.lengths = self.tree.lengths
        self.head = head(self.names, self.tree, roles)  # path from the root
        self.joint = {role: self.names.index(name) for role, name in roles.items() if role in ROLES}

    def has(self, *parts: str) -> bool:
        """Whether both sides have these parts."""
        return all(f"{side}_{part}" in self.joint for side in SIDES for part in parts)

    @cached_property
    def _positions(self) -> list[dict[int, np.ndarray]]:
        """`points` in the frames that are looked at, and in the frames after them."""
        recording = self.recording
        above = (j for joint in self.joint.values() for j in self.tree.up(joint))
        order = sorted({0, *self.head, *above})
        place = {-1: -1} | {j: i for i, j in enumerate(order)}
        part = Skeleton([self.names[j] for j in order],
                        [place[recording.parents[j]] for j in order],
                        recording.offsets[order], {}, ())
        last = len(recording.rotations) - 1
        frames = torch.linspace(0, last, min(last + 1, SAMPLES)).long()
        at = torch.cat((frames, (frames + 1).clamp_max(last)))
        turns = recording.rotations[at][:, order].double()
        places = forward_kinematics(part, turns, recording.root_positions[at])[1].numpy()
        return [{j: half[:, place[j]] for j in order} for half in np.split(places, 2)]

    @property
    def points(self) -> dict[int, np.ndarray]:
        """Positions ``[S, 3]`` by joint of all with roles, of the head and of those above them."""
        return self._positions[0]

    @cached_property
    def together(self) -> np.ndarray:
        """All points ``[S, N, 3]``."""
        return np.stack(list(self.points.values()), 1)

    def middle(self, part: str) -> np.ndarray:
        """Mean position of a part of both sides ``[S, 3]``."""
        return sum(self.points[self.joint[f"{side}_{part}"]] for side in SIDES) / 2

    def along(self, up: str) -> np.ndarray:
        """Heights ``[S, N]`` of all points along an axis."""
        return heights(self.together, up)

    @cached_property
    def standing(self) -> np.ndarray:
        """From the feet to the head ``[S, 3]``; no rows without them."""
        if not (self.head and self.has("foot")):
            return np.zeros((0, 3))
        return self.points[self.head[-1]] - self.middle("foot")

    @cached_property
    def leg(self) -> float:
        """Hip to ankle along the bones, mean of both legs; NaN without legs."""
        if not self.has("hip", "foot"):
            return math.nan
        length = 0.0
        for side in SIDES:
            hip, path = self.joint[f"{side}_hip"], self.tree.up(self.joint[f"{side}_foot"])
            length += sum(self.lengths[j] / 2 for j in takewhile(hip.__ne__, path))
        return length

    @cached_property
    def height(self) -> float:
        """Height of the standing body along its bones; NaN without legs or head."""
        if not (self.head and self.has("hip", "foot")):
            return math.nan
        hips, top = self.joint["hips"], self.head[-1]
        first = self.head.index(hips) + 1 if hips in self.head else 1
        trunk = sum(self.lengths[j] for j in self.head[first:])
        # Above the head's joint there may be a point at the top of the head
        point = self.names[top] in self.recording.ends or role_words.read(self.names[top]).helper
        if not (point and self.lengths[top] > 0.1 * self.leg):
            trunk += CROWN * self.leg
        # From the hips down to the middle between the hip joints
        left, right = (self.points[self.joint[f"{side}_hip"]][0] for side in SIDES)
        aside = float(np.linalg.norm(left - self.points[hips][0])) if hips in self.points else 0.0
        below = math.sqrt(max(0.0, aside**2 - float(np.square(left - right).sum()) / 4))
        return (1 + SOLE) * self.leg + trunk + below

    def upright(self, up: str) -> bool:
        """Whether the head is above the feet in most frames, by `UPRIGHT` of the height."""
        above = heights(self.standing, up)
        return bool(len(above)) and float((above > UPRIGHT * self.height).mean()) > 0.5

    @cached_property
    def resting(self) -> str:
        """The axis along which the body stands at zero rotations; empty where it does not."""
        offsets = self.recording.offsets.numpy()
        feet = sum(offsets[self.tree.up(self.joint[f"{side}_foot"])].sum(0) / 2 for side in SIDES)
        above = offsets[self.head].sum(0) - feet
        axis = int(np.abs(above).argmax())
        if not abs(above[axis]) > UPRIGHT * self.height:
            return ""
        return ("-" if above[axis] < 0 else "") + "xyz"[axis]

    @property
    def swapped(self) -> bool:
        """Whether joints called left are on the right of where the toes point, or knees bend."""
        if not (len(self.standing) and self.has("hip", "knee", "toe")):
            return False
        toes = self.middle("toe") - self.middle("foot")
        knees = self.middle("knee") - (self.middle("hip") + self.middle("foot")) / 2
        ahead = toes if np.linalg.norm(toes, axis=1).mean() > 0.1 * self.leg else knees
        left = np.cross(self.standing, ahead)
        apart = self.points[self.joint["left_hip"]] - self.points[self.joint["right_hip"]]
        size = np.linalg.norm(left, axis=1) * np.linalg.norm(apart, axis=1)
        return float(((left * apart).sum(1) / size.clip(1e-12)).mean()) < -0.5

    def toe_steps(self, up: str, factor: float = 1.0) -> np.ndarray:
        """Level distances ``[2, S]`` from frame to frame of the toes.

        The root's path is made ``factor`` times as long: if it has another unit than the bones, the
        toes slide in all frames.
        """
        path, toes = (np.delete(moves, "xyz".index(up[-1]), -1) for moves in self._moves)
        return np.linalg.norm(toes + factor * path, axis=-1)

    @cached_property
    def _moves(self) -> tuple[np.ndarray, np.ndarray]:
        """Moves from frame to frame of the root ``[S, 3]``, and of the toes against it."""
        before, after = self._positions
        toes = [self.joint[f"{side}_toe"] for side in SIDES]
        moves = {j: after[j][:-1] - before[j][:-1] for j in (0, *toes)}  # none after the last
        return moves[0], np.stack([moves[j] - moves[0] for j in toes])

    def floor(self, up: str) -> tuple[float, float]:
        """Height of a toe that stands, in the middle of the clip, and its change over the clip."""
        if not self.has("toe"):
            return math.nan, math.nan
        toes = np.minimum(*(heights(self.points[self.joint[f"{side}_toe"]], up) for side in SIDES))
        recording = self.recording
        part = max(PART, round(len(toes) * recording.fps / len(recording.rotations)))
        floor = floor_line(torch.from_numpy(toes), part, 0.02 * self.leg)
        return float(floor[len(floor) // 2]), float(floor[-1] - floor[0])


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
    between = {}
    if limbs.isdisjoint(trunk):
        between = _reached(tree, trunk[-1], lambda j: j not in limbs)
        del between[trunk[-1]]
    called = [j for j in between if "head" in said[j].parts]
    if not called:
        return tree.up(max(between, key=between.get, default=trunk[-1]))[::-1]

    # Its top is the farthest point that only tips and helpers lead to.
    tops = _reached(tree, called[0], lambda j: said[j].helper)
    return tree.up(max(tops, key=tops.get))[::-1]


def _reached(tree: Tree, start: int, through: Callable[[int], bool]) -> dict[int, float]:
    """Joints to which only joints of a kind lead down from a first one, with their distances."""
    found, waiting = {start: 0.0}, [start]
    for j in waiting:
        below = [k for k in tree.children[j] if through(k)]
        found |= {k: found[j] + tree.lengths[k] for k in below}
        waiting += below
    return found
