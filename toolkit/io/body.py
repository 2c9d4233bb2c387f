"""The body in a recording, in the file's unit and axes: some frames of its head, hips, hands and feet, and its measures.

In numpy, whose functions cost less than torch's on arrays as small as these: every file that is read is looked at.
"""

import math
from collections.abc import Mapping
from functools import cached_property
from itertools import takewhile

import numpy as np
import torch

from toolkit.io.recording import Recording
from toolkit.motion import joint_names
from toolkit.motion import rotations as R
from toolkit.motion.contacts import line
from toolkit.motion.roles import ROLES, SIDES, Tree, head

SAMPLES, PART = 48, 6  # frames that are looked at; at least, in a part of the clip, whose lowest toe is the floor there
SOLE, CROWN = 0.08, 0.24  # of a leg's length: height of an ankle, and from the head joint to the top of the head
UPRIGHT = 0.5  # of the height: how far the head of an upright body is above its feet


class Body:
    """Points of the joints with roles and of the head over at most `SAMPLES` frames, in the unit of the file."""

    def __init__(self, recording: Recording, roles: Mapping[str, str], whole: bool = False):
        self.names, self.parents, self.ends = recording.names, recording.parents, recording.ends
        self.recording, self.roles = recording, roles
        self.lengths = recording.offsets.norm(dim=-1).tolist()
        self.tree = Tree(recording.parents, self.lengths)
        self.head = head(recording.names, recording.parents, self.lengths, roles)  # path from the root, maybe empty
        self.needed = range(len(self.names)) if whole else ()  # joints besides those with roles
        self.joint = {role: self.names.index(name) for role, name in roles.items() if role in ROLES}

    def has(self, *parts: str) -> bool:
        """Whether both sides have these parts."""
        return all(f"{side}_{part}" in self.joint for side in SIDES for part in parts)

    @cached_property
    def points(self) -> dict[int, np.ndarray]:
        """Positions ``[S, 3]`` by joint of all with roles, of the head and of those above them, float64."""
        recording = self.recording
        frames = np.linspace(0, len(recording.rotations) - 1, min(len(recording.rotations), SAMPLES)).astype(int)
        order = sorted({0, *self.head, *self.needed, *(j for joint in self.joint.values() for j in self.tree.up(joint))})
        local = R.to_matrix(torch.from_numpy(recording.rotations.numpy()[frames][:, order]).double()).numpy()
        offsets, roots = recording.offsets.numpy(), recording.root_positions.numpy()[frames]
        turned, points = {}, {}
        for n, j in enumerate(order):
            above = self.parents[j]
            turned[j] = local[:, n] if above < 0 else turned[above] @ local[:, n]
            points[j] = roots if above < 0 else points[above] + turned[above] @ offsets[j]
        return points

    @cached_property
    def together(self) -> np.ndarray:
        """All points ``[S, N, 3]``."""
        return np.stack(list(self.points.values()), 1)

    def middle(self, part: str) -> np.ndarray:
        """Mean position of a part of both sides ``[S, 3]``."""
        return sum(self.points[self.joint[f"{side}_{part}"]] for side in SIDES) / 2

    def along(self, up: str) -> np.ndarray:
        """Heights ``[S, N]`` of all points along an axis."""
        points = self.together[..., "xyz".index(up[-1])]
        return -points if up[0] == "-" else points

    @cached_property
    def standing(self) -> np.ndarray:
        """From the feet to the head ``[S, 3]``; no rows without them."""
        return self.points[self.head[-1]] - self.middle("foot") if self.head and self.has("foot") else np.zeros((0, 3))

    @cached_property
    def leg(self) -> float:
        """Hip to ankle along the bones, mean of both legs; NaN without legs."""
        if not self.has("hip", "foot"):
            return math.nan
        legs = ((self.joint[f"{side}_hip"], self.tree.up(self.joint[f"{side}_foot"])) for side in SIDES)
        return sum(self.lengths[j] / 2 for hip, path in legs for j in takewhile(hip.__ne__, path))

    @cached_property
    def height(self) -> float:
        """Height of the standing body along its bones: legs, trunk, neck and head; NaN without legs or head."""
        if not (self.head and self.has("hip", "foot")):
            return math.nan
        hips, top = self.joint["hips"], self.head[-1]
        trunk = sum(self.lengths[j] for j in self.head[self.head.index(hips) + 1 if hips in self.head else 1 :])
        topped = self.names[top] in self.ends or joint_names.read(self.names[top]).helper
        trunk += 0.0 if topped and self.lengths[top] > 0.1 * self.leg else CROWN * self.leg
        left, right = (self.points[self.joint[f"{side}_hip"]][0] for side in SIDES)
        from_hips = float(np.linalg.norm(left - self.points[hips][0])) if hips in self.points else 0.0
        below = math.sqrt(max(0.0, from_hips**2 - float(np.square(left - right).sum()) / 4))
        return (1 + SOLE) * self.leg + trunk + below

    def upright(self, up: str) -> bool:
        """Whether the head is above the feet in most frames, by `UPRIGHT` of the height."""
        above = self.standing[:, "xyz".index(up[-1])] * (-1.0 if up[0] == "-" else 1.0)
        return bool(len(above)) and float((above > UPRIGHT * self.height).mean()) > 0.5

    @cached_property
    def resting(self) -> str:
        """The axis along which the body stands where all rotations are zero; empty where it does not."""
        offsets = self.recording.offsets.numpy()
        feet = sum(offsets[self.tree.up(self.joint[f"{side}_foot"])].sum(0) / 2 for side in SIDES)
        above = offsets[self.head].sum(0) - feet
        axis = int(np.abs(above).argmax())
        return ("-" if above[axis] < 0 else "") + "xyz"[axis] if abs(above[axis]) > UPRIGHT * self.height else ""

    @property
    def swapped(self) -> bool:
        """Whether the joints called left are on the right of a body that goes where its toes point, or its knees bend."""
        if not (len(self.standing) and self.has("hip", "knee", "toe")):
            return False
        toes = self.middle("toe") - self.middle("foot")
        knees = self.middle("knee") - (self.middle("hip") + self.middle("foot")) / 2
        ahead = toes if np.linalg.norm(toes, axis=1).mean() > 0.1 * self.leg else knees
        left = np.cross(self.standing, ahead)
        apart = self.points[self.joint["left_hip"]] - self.points[self.joint["right_hip"]]
        size = np.linalg.norm(left, axis=1) * np.linalg.norm(apart, axis=1)
        return float(((left * apart).sum(1) / size.clip(1e-12)).mean()) < -0.5

    def floor(self, up: str) -> tuple[float, float]:
        """Height of a toe that stands, in the middle of the clip, and its change over the clip; NaN without toes."""
        if not self.has("toe"):
            return math.nan, math.nan
        sign, axis = -1.0 if up[0] == "-" else 1.0, "xyz".index(up[-1])
        toes = np.minimum(*(sign * self.points[self.joint[f"{side}_toe"]][:, axis] for side in SIDES))
        part = max(PART, round(len(toes) * self.recording.fps / len(self.recording.rotations)))  # a second or more
        lowest = toes[: len(toes) // part * part].reshape(-1, part).min(1)
        if len(lowest) < 4 or np.ptp(lowest) < 0.02 * self.leg:
            return float(np.sort(toes)[len(toes) // 20]), 0.0
        floor = line(torch.from_numpy(toes), part, 0.02 * self.leg)
        return float(floor[len(floor) // 2]), float(floor[-1] - floor[0])
