"""What a recording's numbers mean: roles, the unit of length, the axis that points up, and what is doubtful about them.

A file states joint names, a tree and numbers. The body shows the rest: people are 1.3 to 2.1 m tall, and their heads are
above their feet most of the time. Each guess that these facts do not make safe is a doubt, a sentence that names the option
that decides.
"""

import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from pathlib import Path

import torch
from torch import Tensor

from toolkit.io.recording import Recording
from toolkit.motion import Clip, Skeleton, contacts, forward_kinematics, joint_names
from toolkit.motion import rotations as R
from toolkit.motion.roles import LIMBS, ROLES, SIDES, Tree, find, head

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254, "dm": 0.1, "CMU": 0.05644}  # metres; CMU: 1 / 0.45 inch
PEOPLE = (1.3, 2.1)  # metres: height of people
FIGURES = (0.8, 2.6)  # metres: height of children and of most made-up characters
USUAL = 1.7  # metres: the height that a body of unknown unit gets
SAMPLES = 48  # frames that are looked at
UPRIGHT = 0.75  # cosine between an axis and the mean direction from feet to head that is safe
NOTHING = 1e-3  # of the longest bone: a limb that is shorter is none
DRIFT = 0.05  # metres over a clip: a floor that moves by more is doubtful
FAR = 0.25  # metres: a floor farther from zero is doubtful
AXES = ("x", "y", "z", "-x", "-y", "-z")
_TURNS = {"x": (0, 0, 90), "-x": (0, 0, -90), "-y": (180, 0, 0), "z": (-90, 0, 0), "-z": (90, 0, 0)}  # to y, degrees


@dataclass
class Findings:
    """What was found in a recording."""

    unit: float = 1.0  # metres of one unit of the file
    up: str = "y"  # axis of the file
    height: float = math.nan  # metres, of the body along its bones when it stands
    floor: float = math.nan  # metres: height of a toe that stands, in the middle of the clip
    drift: float = math.nan  # metres: change of that height over the clip
    upright: bool = False  # whether the head is above the feet, by half of the height or more, in most frames
    rules: dict[str, str] = field(default_factory=dict)  # by role: what showed it
    doubts: list[str] = field(default_factory=list)


def load(recording: Recording, path: Path, unit: float | str = "auto", up: str = "auto",
         roles: Mapping[str, str] | None = None, style: str = "", gait: str = "") -> Clip:
    """The clip of a recording; what is doubtful is one UserWarning. With unit and up given, neither is guessed."""
    clip, found = interpret(recording, path, unit, up, roles, look="auto" in (unit, up))
    if found.doubts:
        warnings.warn(f"{path.name}: {'; '.join(found.doubts)}", UserWarning, stacklevel=3)
    return clip.replace(style=style, gait=gait) if style or gait else clip


def interpret(recording: Recording, path: Path, unit: float | str = "auto", up: str = "auto",
              roles: Mapping[str, str] | None = None, look: bool = True) -> tuple[Clip, Findings]:
    """The clip of a recording, and what was found; without ``look`` only the roles are.

    Raises
    ------
    ValueError
        If unit, up or roles do not fit the recording, or it holds numbers that are not finite.
    """
    if up not in ("auto", *AXES):
        raise ValueError(f"{path.name}: up is the axis that points up, one of auto, {', '.join(AXES)}; got {up!r}")
    metres = UNITS.get(unit) if isinstance(unit, str) else unit
    if unit != "auto" and not (isinstance(metres, int | float) and metres > 0 and math.isfinite(metres)):
        raise ValueError(f"{path.name}: unit is metres of one unit, or one of auto, {', '.join(UNITS)}; got {unit!r}")
    found = Findings(metres or 1.0, up)
    known = _roles(recording, path, roles or {}, found)
    if not look:
        found.doubts.clear()
    found.doubts.extend(recording.doubts)
    fps = _rate(recording, found)
    if look:
        body = Body(recording, known)
        if not bool(body.points.isfinite().all()):
            raise ValueError(f"{path.name}: holds rotations or positions that are not finite")
        if up == "auto":
            found.up = _up(body, recording, found)
        if unit == "auto":
            found.unit = _unit(body, recording, found)
        found.height = body.height * found.unit
        found.upright = body.stands(found.up)
    rotations, positions = recording.rotations, recording.root_positions * found.unit
    if found.up in _TURNS:
        turn = R.from_euler(torch.deg2rad(torch.tensor(_TURNS[found.up], dtype=torch.float64)), "XYZ")
        positions = R.rotate(turn, positions)
        rotations = torch.cat((R.multiply(turn.to(rotations), rotations[:, :1]), rotations[:, 1:]), 1)
    skeleton = Skeleton(recording.names, recording.parents, recording.offsets * found.unit, known, recording.ends)
    clip = Clip(skeleton, rotations, positions, fps, name=path.name)
    if look and "left_toe" in known and "right_toe" in known:
        floor = contacts.floor_height(clip)
        found.floor, found.drift = float(floor[len(floor) // 2]), float(floor[-1] - floor[0])
        if abs(found.drift) > DRIFT:
            found.doubts.append(f"the floor moves by {found.drift:+.2f} m over the clip; contacts follow it, heights do not")
        if abs(found.floor) > FAR:
            found.doubts.append(f"the feet stand at {found.floor:.2f} m instead of 0; "
                                f"clip.moved(shift=(0, {-found.floor:.2f}, 0)) moves the floor")
    return clip, found


class Body:
    """Some frames of a recording, in its own unit and axes."""

    def __init__(self, recording: Recording, roles: Mapping[str, str]):
        self.recording, self.roles = recording, roles
        self.lengths = recording.offsets.norm(dim=-1).tolist()
        self.head = head(recording.names, recording.parents, self.lengths, roles)

    def index(self, role: str) -> int:
        """Joint of a role."""
        return self.recording.names.index(self.roles[role])

    def has(self, *parts: str) -> bool:
        """Whether both sides have these parts."""
        return all(f"{side}_{part}" in self.roles for side in SIDES for part in parts)

    @cached_property
    def points(self) -> Tensor:
        """Positions ``[S, J, 3]``, float64."""
        r = self.recording
        at = torch.linspace(0, len(r.rotations) - 1, min(len(r.rotations), SAMPLES)).long()
        skeleton = Skeleton(r.names, r.parents, r.offsets / self.scale, {}, ())
        root = r.root_positions[at].double() / self.scale
        return forward_kinematics(skeleton, r.rotations[at].double(), root)[1] * self.scale

    @cached_property
    def scale(self) -> float:
        """Length of the longest bone."""
        return max(self.lengths[1:], default=0.0) or 1.0

    def middle(self, part: str) -> Tensor:
        """Mean position of a part of both sides ``[S, 3]``."""
        return self.points[:, [self.index(f"{side}_{part}") for side in SIDES]].mean(1)

    def bones(self, path: list[int]) -> float:
        """Sum of the bones along a path, without its first point."""
        return sum(self.lengths[j] for j in path[1:])

    @cached_property
    def leg(self) -> float:
        """Hip to ankle along the bones, mean of both legs."""
        if not self.has("hip", "foot"):
            return math.nan
        parents, total = self.recording.parents, 0.0
        for side in SIDES:
            j, hip = self.index(f"{side}_foot"), self.index(f"{side}_hip")
            while j != hip and j >= 0:
                total += self.lengths[j] / 2
                j = parents[j]
        return total

    @property
    def topped(self) -> bool:
        """Whether the path to the head ends at its top."""
        name = self.recording.names[self.head[-1]]
        return name in self.recording.ends or joint_names.read(name).helper

    @cached_property
    def height(self) -> float:
        """Height of the standing body along its bones; 8 % of a leg are below the ankles, and 24 % from head to top."""
        if not (self.has("hip", "foot") and self.head):
            return math.nan
        hips = self.index("hips")
        trunk = self.bones(self.head[self.head.index(hips):] if hips in self.head else self.head)
        trunk += 0.24 * self.leg if self.lengths[self.head[-1]] < 0.1 * self.leg or not self.topped else 0.0
        left, right = (self.index(f"{side}_hip") for side in SIDES)
        aside = float((self.points[0, left] - self.points[0, right]).norm()) / 2
        down = math.sqrt(max(0.0, float((self.points[0, left] - self.points[0, hips]).norm()) ** 2 - aside**2))
        return 1.08 * self.leg + trunk + down

    def stands(self, up: str) -> bool:
        """Whether the head is above the feet, by half of the height or more, in most frames."""
        if not self.height > 0:
            return False
        axis = "xyz".index(up[-1])
        above = (self.points[:, self.head[-1]] - self.middle("foot"))[:, axis] * (-1.0 if up[0] == "-" else 1.0)
        return float((above > 0.5 * self.height).double().mean()) > 0.5


def _roles(recording: Recording, path: Path, given: Mapping[str, str], found: Findings) -> dict[str, str]:
    """Roles by names and tree, those that the file states, and those of the call, with the rule that found each."""
    lengths = recording.offsets.norm(dim=-1).tolist()
    known = find(recording.names, recording.parents, lengths, recording.ends)
    known |= {role: (joint, "the file") for role, joint in (recording.roles or {}).items() if role in ROLES}
    for role, joint in given.items():
        if role not in ROLES:
            raise ValueError(f"{path.name}: {role!r} is no role; the roles are {', '.join(ROLES)}")
        if joint not in recording.names:
            raise ValueError(f"{path.name}: no joint {joint!r} for the role {role}; there is {', '.join(recording.names)}")
        known[role] = joint, "given"
    for problem, roles in misfits(recording, lengths, {role: joint for role, (joint, _) in known.items()}):
        if any(role in given for role in roles):
            raise ValueError(f"{path.name}: {problem}")
        found.doubts.append(problem)
        for role in roles:
            known.pop(role, None)
    if lacking := [role for role in ROLES if role not in known]:
        found.doubts.append(f"no joint was found for {', '.join(lacking)}: not taken for a person; roles= names them")
    found.rules = {role: rule for role, (_, rule) in known.items()}
    return {role: joint for role, (joint, _) in known.items()}


def misfits(recording: Recording, lengths: list[float], roles: Mapping[str, str]) -> list[tuple[str, list[str]]]:
    """What is impossible about roles, in words, with the roles that are: a limb out of order or without length."""
    tree, problems = Tree(recording.parents, lengths), []
    size = max(lengths[1:], default=0.0)
    for side in SIDES:
        for chain in LIMBS.values():
            have = [f"{side}_{part}" for part in chain if f"{side}_{part}" in roles]
            joints = [recording.names.index(roles[role]) for role in have]
            for (a, upper), (b, lower) in pairwise(zip(have, joints, strict=True)):
                if upper == lower or upper not in tree.up(lower):
                    problems.append((f"{b} ({roles[b]}) is not below {a} ({roles[a]})", have))
                elif tree.distance(upper, lower) < NOTHING * size:
                    problems.append((f"{a} ({roles[a]}) and {b} ({roles[b]}) are at the same place", have))
    return problems


def _rate(recording: Recording, found: Findings) -> float:
    """Frames per second; a frame time of seconds is one in milliseconds."""
    if len(recording.rotations) < 2:
        return recording.fps
    if 5e-4 < recording.fps <= 0.25:
        rate = float(f"{1000 * recording.fps:.4g}")
        found.doubts.append(f"a frame time of {1 / recording.fps:.6g} s was taken for milliseconds: {rate:g} Hz; "
                            "clip.replace(fps=…) decides")
        return rate
    if recording.fps < 5 or recording.fps > 1000:
        found.doubts.append(f"{recording.fps:.4g} frames per second is no usual rate of motion; clip.replace(fps=…) decides")
    return recording.fps


def _up(body: Body, recording: Recording, found: Findings) -> str:
    """The axis from feet to head, in the mean over the clip."""
    usual = recording.up or "y"
    if not (body.has("foot") and body.head):
        found.doubts.append(f"no head and feet show which axis points up: {usual} is assumed; up= decides")
        return usual
    along = body.points[:, body.head[-1]] - body.middle("foot")
    mean = R.normalize(along).mean(0)
    axis = int(mean.abs().argmax())
    seen = ("-" if mean[axis] < 0 else "") + "xyz"[axis]
    if float(mean.abs()[axis]) < UPRIGHT:
        found.doubts.append(f"the body is not upright in most frames: {usual} is assumed to point up; up= decides")
        return usual
    if recording.up and seen != recording.up:
        found.doubts.append(f"the file says that {recording.up} points up, the body stands along {seen}; up= decides")
        return seen
    heights = body.points[..., axis] * float(mean[axis].sign())
    lying = [other for other in range(3) if other != axis and _on_floor(body, body.points[..., other])]
    if lying and not _on_floor(body, heights, standing=True) and bool((body.points[:, 0].abs() > 0).any()):
        found.doubts.append(f"the body stands along {seen} or lies with {'xyz'[lying[0]]} up: {seen} is taken; up= decides")
    return seen


def _on_floor(body: Body, heights: Tensor, standing: bool = False) -> bool:
    """Whether heights ``[S, J]`` begin near zero, as if there were the floor, with the hips near it or, standing, above."""
    low, hips = float(heights.amin()), float(heights[:, body.index("hips")].median())
    return abs(low) < 0.15 * body.leg if standing else abs(low) < 0.3 * body.leg and hips < 0.4 * body.leg


def _unit(body: Body, recording: Recording, found: Findings) -> float:
    """Metres of one unit: the one of `UNITS` with which the body is as tall as people are."""
    tall, said = body.height, recording.unit
    if not tall > 0:
        unit = said or UNITS["cm"]
        found.doubts.append(f"no head and legs show the unit of length: {named(unit)} is assumed; unit= decides")
        return unit
    fits = [u for u in (*filter(None, (said,)), *UNITS.values()) if PEOPLE[0] <= u * tall <= PEOPLE[1]]
    if fits:
        if said and abs(fits[0] / said - 1) > 0.02:
            found.doubts.append(f"in the file's unit, {named(said)}, the body is {said * tall:.3g} m tall: "
                                f"{named(fits[0])} is assumed; unit= decides")
        return fits[0]
    for unit in filter(None, (said, UNITS["cm"], UNITS["m"])):
        if FIGURES[0] <= unit * tall <= FIGURES[1]:
            found.doubts.append(f"with a unit of {named(unit)} the body is {unit * tall:.2f} m tall; unit= decides")
            return unit
    unit = USUAL / tall
    found.doubts.append(f"in no known unit the body of {tall:.4g} units is as tall as people: it is scaled to {USUAL} m; "
                        "unit= decides")
    return unit


def named(unit: float) -> str:
    """A unit of length in words."""
    name = next((n for n, metres in UNITS.items() if abs(unit / metres - 1) < 0.005), None)
    return f"{unit:g} m ({name})" if name else f"{unit:g} m"
