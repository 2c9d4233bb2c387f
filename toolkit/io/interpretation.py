"""What a recording's numbers mean: roles, the unit of length, the axis that points up, and what is doubtful about them.

A file states joint names, a tree and numbers. The body shows the rest: people are 1.3 to 2.1 m tall, and their heads are
above their feet most of the time. Each guess that these facts do not make safe is a doubt, a sentence that names the option
that decides.
"""

import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import torch

from toolkit.io.body import Body
from toolkit.io.recording import Recording
from toolkit.motion import Clip, Skeleton, shape
from toolkit.motion import rotations as R
from toolkit.motion.roles import LENGTHS, ROLES, find, misfits

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254, "dm": 0.1, "CMU": 0.05644}  # metres; CMU: 1 / 0.45 inch
PEOPLE = (1.3, 2.1)  # metres: height of people
FIGURES = (0.8, 2.6)  # metres: height of children and of most made-up characters
USUAL = 1.7  # metres: the height that a body of unknown unit gets
UPRIGHT = 0.75  # cosine between an axis and the mean direction from feet to head that is safe
FASTEST = 15.0  # metres per second: a body that goes faster is doubtful
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
    clip, found = interpret(recording, path, unit, up, roles, style, gait, look="auto" in (unit, up))
    if found.doubts:
        warnings.warn(f"{path.name}: {'; '.join(found.doubts)}", UserWarning, stacklevel=3)
    return clip


def interpret(recording: Recording, path: Path, unit: float | str = "auto", up: str = "auto",
              roles: Mapping[str, str] | None = None, style: str = "", gait: str = "", *,
              look: bool = True) -> tuple[Clip, Findings]:
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
    if shape.RULE in found.rules.values():
        found.doubts.append("the joints' names say too little, so that roles are from the shape of the tree; roles= decides")
    found.doubts.extend(f"{known[role]} is taken for the {role.replace('_', ' ')}, because both parts of the limb are then "
                        "about equally long; roles= decides" for role, rule in found.rules.items() if rule == LENGTHS)
    found.doubts.extend(recording.doubts)
    fps = _rate(recording, found)
    if look:
        body = Body(recording, known)
        if not np.isfinite(body.together).all():
            raise ValueError(f"{path.name}: holds rotations or positions that are not finite")
        if up == "auto":
            found.up = _up(body, recording, found)
        if unit == "auto":
            found.unit = _unit(body, recording, found)
        if body.swapped:
            found.doubts.append("the joints called left are on the right of the body, or it bends backwards; roles= decides")
        found.height = body.height * found.unit
        found.upright = body.upright(found.up)
        found.floor, found.drift = (found.unit * value for value in body.floor(found.up))
        _travel(recording, fps, found)
        if abs(found.drift) > DRIFT:
            found.doubts.append(f"the floor moves by {found.drift:+.2f} m over the clip; contacts follow it, heights do not")
        if abs(found.floor) > FAR:
            found.doubts.append(f"the feet stand at {found.floor:.2f} m instead of 0; "
                                f"clip.moved(shift=(0, {-found.floor:.2f}, 0)) moves the floor")
    rotations, positions = recording.rotations, recording.root_positions * found.unit
    if found.up in _TURNS:
        turn = R.from_euler(torch.deg2rad(torch.tensor(_TURNS[found.up], dtype=torch.float64)), "XYZ")
        positions = R.rotate(turn, positions)
        rotations = torch.cat((R.multiply(turn.to(rotations), rotations[:, :1]), rotations[:, 1:]), 1)
    skeleton = Skeleton(recording.names, recording.parents, recording.offsets * found.unit, known, recording.ends)
    return Clip(skeleton, rotations, positions, fps, style, gait, path.name), found


def _roles(recording: Recording, path: Path, given: Mapping[str, str], found: Findings) -> dict[str, str]:
    """Roles by names and tree, those that the file states, and those of the call, with the rule that found each."""
    lengths = recording.offsets.norm(dim=-1).tolist()
    known = find(recording.names, recording.parents, lengths, recording.ends)
    stated = {role: (joint, "the file") for role, joint in (recording.roles or {}).items() if role in ROLES}
    if not {role for role in ROLES if "toe" not in role} <= known.keys() | stated.keys():
        known = shape.find(recording.names, recording.parents, lengths, recording.ends,
                           Body(recording, {}, whole=True).together) or known
    known |= stated
    for role, joint in given.items():
        if role not in ROLES:
            raise ValueError(f"{path.name}: {role!r} is no role; the roles are {', '.join(ROLES)}")
        if joint not in recording.names:
            raise ValueError(f"{path.name}: no joint {joint!r} for the role {role}; there is {', '.join(recording.names)}")
        known[role] = joint, "given"
    joints = {role: joint for role, (joint, _) in known.items()}
    for problem, roles in misfits(recording.names, recording.parents, lengths, joints):
        if any(role in given for role in roles):
            raise ValueError(f"{path.name}: {problem}")
        found.doubts.append(problem)
        for role in roles:
            known.pop(role, None)
    if lacking := [role for role in ROLES if role not in known]:
        either = [role.removeprefix("left_") for role in lacking if role.replace("left", "right") in lacking
                  and role.startswith("left")]
        one = [role.replace("_", " ") for role in lacking if role.split("_")[1] not in either]
        found.doubts.append(f"no joint was found for {', '.join((*either, *one))}: not taken for a person; roles= decides")
    found.rules = {role: rule for role, (_, rule) in known.items()}
    return {role: joint for role, (joint, _) in known.items()}


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


def _travel(recording: Recording, fps: float, found: Findings) -> None:
    """Doubts where the root goes faster than people do: all the time, or in a jump."""
    steps = np.linalg.norm(np.diff(recording.root_positions.numpy(), axis=0), axis=1)
    with np.errstate(over="ignore"):  # `Clip` refuses such positions
        speeds = steps * found.unit * fps
        usual = float(np.median(speeds)) if len(speeds) else 0.0
    fast = speeds > FASTEST
    if fast.sum() > len(fast) / 2:
        found.doubts.append(f"the body goes {usual:.3g} m/s: its path may be in another unit than its bones, or "
                            "the frame rate wrong; clip.replace(root_positions=…) or (fps=…) decides")
    elif fast.any():
        at = int(steps.argmax())
        found.doubts.append(f"the body jumps by {speeds[at] / fps:.2f} m from frame {at} to {at + 1}; "
                            "clip.cut(…) keeps one part")


def _up(body: Body, recording: Recording, found: Findings) -> str:
    """The axis from feet to head, in the mean over the clip."""
    usual = recording.up or "y"
    if not len(body.standing):
        found.doubts.append(f"no head and feet show which axis points up: {usual} is assumed; up= decides")
        return usual
    if recording.up is None and body.resting == "z":  # other axes are those of bones, not of the world
        usual = "z"
    mean = (body.standing / np.linalg.norm(body.standing, axis=1, keepdims=True).clip(1e-9)).mean(0)
    axis = int(np.abs(mean).argmax())
    seen = ("-" if mean[axis] < 0 else "") + "xyz"[axis]
    if abs(mean[axis]) < UPRIGHT:
        found.doubts.append(f"the body is not upright in most frames: {usual} is assumed to point up; up= decides")
        return usual
    if recording.up and seen != recording.up:
        found.doubts.append(f"the file says that {recording.up} points up, the body stands along {seen}; up= decides")
        return seen
    stands = _on_floor(body, seen, standing=True) or not body.points[0].any()
    lying = [other for other in "xyz" if other not in seen and (
        _low(body, other) if other == usual else not stands and _on_floor(body, other))]
    if lying:
        found.doubts.append(f"the body stands along {seen} or lies with {lying[0]} up: {seen} is taken; up= decides")
    return seen


def _on_floor(body: Body, up: str, standing: bool = False) -> bool:
    """Whether the body begins near zero along an axis, as on a floor, with its hips low unless it stands."""
    low, hips = body.along(up).min(), np.median(body.points[body.joint["hips"]][:, "xyz".index(up[-1])])
    return abs(low) < 0.15 * body.leg if standing else abs(low) < 0.3 * body.leg and hips < 0.4 * body.leg


def _low(body: Body, up: str) -> bool:
    """Whether no joint is below zero along an axis, and the hips are at most as high as on all fours or in a bed."""
    low, hips = body.along(up).min(), np.median(body.points[body.joint["hips"]][:, "xyz".index(up)])
    return low > -0.1 * body.leg and hips < 1.2 * body.leg


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
