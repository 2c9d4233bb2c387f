"""What a recording's numbers mean: roles, the unit of length, the axis that points up.

A file states joint names, a tree and numbers. The body shows the rest: people are 1.3 to 2.1 m
tall, and their heads are above their feet most of the time. Each guess that these facts do not make
safe is a doubt, a sentence that names the option that decides.
"""

import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import torch
from torch import Tensor

from toolkit.extra.formats.recorded_body import RecordedBody, heights, misfits
from toolkit.io import files
from toolkit.io.recording import Recording
from toolkit.motion import Clip, Skeleton, rotations as R
from toolkit.motion.roles import LENGTHS, ROLES, Tree, find

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254, "dm": 0.1, "CMU": 0.05644}  # metres
PEOPLE = (1.3, 2.1)  # metres: height of people
FIGURES = (0.8, 2.6)  # metres: height of children and of most made-up characters
USUAL = 1.7  # metres: the height that a body of unknown unit gets
UPRIGHT = 0.75  # cosine between an axis and the mean direction from feet to head that is safe
FASTEST = 15.0  # metres per second: a body that goes faster is doubtful
DRIFT = 0.05  # metres over a clip: a floor that moves by more is doubtful
FAR = 0.25  # metres: a floor farther from zero is doubtful
# Recorded takes that go farther than 2 m (150 of Bandai-Namco, Xia, PFNN, 100STYLE) have a toe that
# stands in 0.23 of the frames or more, and toes that move with 2.2 m/s or more in some frame
SLOW, QUICK = 0.3, 1.0  # metres per second: of toes that stand, and that move
WAY = 5.0, 2.0  # metres: on a longer way, some foot stands in some frame, and some moves
NEVER, PARTLY, MOSTLY = 0.02, 0.5, 0.8  # shares of the frames in which a toe stands
MANY = 10  # joints beside a body that may be another one
AXES = {"x": (0, 0, 90), "y": (0, 0, 0), "z": (-90, 0, 0), "-x": (0, 0, -90),
        "-y": (180, 0, 0), "-z": (90, 0, 0)}  # degrees about x, y and z that turn an axis to y


@dataclass
class Findings:
    """What was found in a recording."""

    unit: float = 1.0  # metres of one unit of the file
    up: str = "y"  # axis of the file
    height: float = math.nan  # metres, of the standing body along its bones; NaN without legs
    floor: float = math.nan  # metres: height of a toe that stands, in the middle of the clip
    drift: float = math.nan  # metres: change of that height over the clip
    upright: bool = False  # whether the head is above the feet in most frames
    rules: dict[str, str] = field(default_factory=dict)  # by role: what showed it
    doubts: list[str] = field(default_factory=list)  # guesses that are not safe

    def doubt(self, said: str, option: str) -> None:
        """Note a guess that is not safe, and the option that decides."""
        self.doubts.append(f"{said}; {option} decides")


def load(recording: Recording, path: Path, unit: float | str = "auto", up: str = "auto",
         roles: Mapping[str, str] | None = None, style: str = "", gait: str = "") -> Clip:
    """The clip of a recording; what is doubtful is one UserWarning.

    With unit and up given, neither is guessed.
    """
    look = "auto" in (unit, up)
    clip, found = interpret(recording, path, unit, up, roles, style, gait, look=look)
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
        raise ValueError(f"{path.name}: up is the axis that points up, one of auto, "
                         f"{', '.join(AXES)}; got {up!r}")
    try:
        metres = 1.0 if unit == "auto" else float(UNITS.get(unit, unit))
    except (TypeError, ValueError):
        metres = math.nan
    if not 0 < metres < math.inf:
        raise ValueError(f"{path.name}: unit is metres of one unit, or one of auto, "
                         f"{', '.join(UNITS)}; got {unit!r}")

    found = Findings(metres, up)
    known = _roles(recording, path, roles or {}, found)
    if not look:
        found.doubts.clear()
    for role, rule in found.rules.items():
        if rule == LENGTHS:
            found.doubt(f"{known[role]} is taken for the {role.replace('_', ' ')}, because both "
                        "parts of the limb are then about equally long", "roles=")
    found.doubts.extend(recording.doubts)
    fps = _rate(recording, found)
    if look:
        body = RecordedBody(recording, known)
        if not np.isfinite(body.together).all():
            raise ValueError(f"{path.name}: holds rotations or positions that are not finite")
        if up == "auto":
            found.up = _up(body, found)
        if unit == "auto":
            found.unit = _unit(body, found)
        _measure(body, found)
        _travel(body, fps, found)
        _others(body, found)

    # To metres with y up: the root alone is turned
    rotations, positions = recording.rotations, recording.root_positions * found.unit
    if found.up != "y":
        turn = upright(found.up)
        positions = R.rotate(turn, positions)
        root = R.multiply(turn.to(rotations), rotations[:, :1])
        rotations = torch.cat((root, rotations[:, 1:]), 1)
    with files.named(path.name):
        skeleton = Skeleton(recording.names, recording.parents, recording.offsets * found.unit,
                            known, recording.ends)
    return Clip(skeleton, rotations, positions, fps, style, gait, path.name), found


def _roles(recording: Recording, path: Path, given: Mapping[str, str],
           found: Findings) -> dict[str, str]:
    """Joints by role: given in the call, stated by the file, or found by names and tree."""
    names, parents, ends = recording.names, recording.parents, recording.ends
    lengths = recording.offsets.norm(dim=-1).tolist()

    known = find(names, parents, lengths, ends)
    known |= {role: (joint, "the file") for role, joint in (recording.roles or {}).items()
              if role in ROLES}
    for role, joint in given.items():
        if role not in ROLES:
            raise ValueError(f"{path.name}: {role!r} is no role; the roles are {', '.join(ROLES)}")
        if joint not in names:
            raise ValueError(f"{path.name}: no joint {joint!r} for the role {role}; "
                             f"there is {', '.join(names)}")
        known[role] = joint, "given"

    # Roles that cannot be true are an error if they were given, otherwise they are dropped
    joints = {role: joint for role, (joint, _) in known.items()}
    for problem, roles in misfits(names, Tree(parents, lengths), joints):
        if any(role in given for role in roles):
            raise ValueError(f"{path.name}: {problem}")
        found.doubts.append(problem)
        for role in roles:
            known.pop(role, None)

    if lacking := [role for role in ROLES if role not in known]:
        parts = [role.split("_")[-1] for role in lacking]
        said = dict.fromkeys(part if parts.count(part) == 2 else role.replace("_", " ")
                             for role, part in zip(lacking, parts, strict=True))
        found.doubt(f"no joint was found for {', '.join(said)}: not taken for a person", "roles=")
    found.rules = {role: rule for role, (_, rule) in known.items()}
    return {role: joint for role, (joint, _) in known.items()}


def _rate(recording: Recording, found: Findings) -> float:
    """Frames per second; a frame time of seconds is one in milliseconds."""
    fps = recording.fps
    if len(recording.rotations) < 2:
        return fps
    if 5e-4 < fps <= 0.25:
        rate = float(f"{1000 * fps:.4g}")
        found.doubt(f"a frame time of {1 / fps:.6g} s was taken for milliseconds: {rate:g} Hz",
                    "clip.replace(fps=…)")
        return rate
    if fps < 5 or fps > 1000:
        found.doubt(f"{fps:.4g} frames per second is no usual rate of motion",
                    "clip.replace(fps=…)")
    return fps


def _measure(body: RecordedBody, found: Findings) -> None:
    """Height of the body and of its floor, with unit and up axis known."""
    if body.swapped:
        found.doubt("the joints called left are on the right of the body, or it bends backwards",
                    "roles=")
    found.height = body.height * found.unit
    found.upright = body.upright(found.up)
    found.floor, found.drift = (found.unit * value for value in body.floor(found.up))
    if abs(found.drift) > DRIFT:
        found.doubts.append(f"the floor moves by {found.drift:+.2f} m over the clip; "
                            "contacts follow it, heights do not")
    if abs(found.floor) > FAR:
        found.doubts.append(f"the feet stand at {found.floor:.2f} m instead of 0; "
                            f"clip.moved(shift=(0, {-found.floor:.2f}, 0)) moves the floor")


def _travel(body: RecordedBody, fps: float, found: Findings) -> None:
    """Doubts where the root goes faster than people do, or the feet do not go with it."""
    path = body.recording.root_positions.numpy()
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    with np.errstate(over="ignore"):  # `Clip` refuses such positions
        speeds = steps * found.unit * fps
        usual = float(np.median(speeds)) if len(speeds) else 0.0
    fast = speeds > FASTEST
    if fast.sum() > len(fast) / 2:
        found.doubt(f"the body goes {usual:.3g} m/s: its path may be in another unit than its "
                    "bones, or the frame rate wrong",
                    "clip.replace(root_positions=…) or (fps=…)")
    elif fast.any():
        at = int(steps.argmax())
        found.doubts.append(f"the body jumps by {speeds[at] / fps:.2f} m from frame {at} to "
                            f"{at + 1}; clip.cut(…) keeps one part")
    elif body.has("toe") and len(steps) > 2:
        reach = np.linalg.norm(np.ptp(path, axis=0))
        _feet(body, fps, found, steps.sum() * found.unit, reach * found.unit)


def _feet(body: RecordedBody, fps: float, found: Findings, way: float, reach: float) -> None:
    """Doubts about contacts that cannot be true: feet that slide all the time, or never move.

    The body goes a ``way`` of metres, within a box with a diagonal of ``reach`` metres.
    """
    second = fps * found.unit  # from steps in the file's unit to metres per second

    def standing(factor: float) -> float:
        """Share of the frames in which a toe stands, if the path is so many times as long."""
        return float((body.toe_steps(found.up, factor).min(0) * second < SLOW).mean())

    share, option = standing(1.0), "clip.replace(root_positions=…) or (fps=…)"
    if share < PARTLY:
        factors = sorted({a / b for a in UNITS.values() for b in UNITS.values() if a != b})
        best = max(factors, key=standing)
        # feet that stand without any path, too, show nothing
        if standing(best) > MOSTLY > standing(0.0):
            found.doubt("the path is in another unit than the bones: the feet slide, and stand if "
                        f"it is {best:.4g} times as long", option)
            return
    if share < NEVER and way > WAY[0]:
        found.doubt(f"the body goes {way:.0f} m, and no foot ever stands", option)
    elif reach > WAY[1] and body.toe_steps(found.up).max() * second < QUICK:
        found.doubt(f"the body goes {reach:.0f} m, and its feet hardly move", option)


def _others(body: RecordedBody, found: Findings) -> None:
    """A doubt about joints that do not belong to the body: a second person."""
    if "hips" not in body.joint:
        return
    hips, ends = body.joint["hips"], {*body.recording.ends}
    own = {*body.tree.up(hips), *body.tree.below(hips), *body.head}
    others = [name for j, name in enumerate(body.names) if j not in own and name not in ends]
    if len(others) >= MANY and own.issuperset(body.joint.values()):
        found.doubts.append(f"{len(others)} joints are beside the body, such as {others[0]}: "
                            "a second person or a prop moves with it; delete them")


def _up(body: RecordedBody, found: Findings) -> str:
    """The axis from feet to head, in the mean over the clip."""
    stated = body.recording.up
    usual = stated or "y"
    if not len(body.standing):
        found.doubt(f"no head and feet show which axis points up: {usual} is assumed", "up=")
        return usual
    if stated is None and body.resting == "z":  # along other axes only bones lie
        usual = "z"
    length = np.linalg.norm(body.standing, axis=1, keepdims=True).clip(1e-9)
    mean = (body.standing / length).mean(0)
    axis = int(np.abs(mean).argmax())
    seen = ("-" if mean[axis] < 0 else "") + "xyz"[axis]
    if abs(mean[axis]) < UPRIGHT:
        found.doubt(f"the body is not upright in most frames: {usual} is assumed to point up",
                    "up=")
        return usual
    if stated and seen != stated:
        found.doubt(f"the file says that {stated} points up, the body stands along {seen}", "up=")
        return seen

    # The body may lie in a world whose up is another axis: then it is near zero along that one
    stands = abs(body.along(seen).min()) < 0.15 * body.leg or not body.points[0].any()

    def lies(up: str) -> bool:
        """Whether the hips are low if that axis points up."""
        low, hips = body.along(up).min(), heights(body.points[body.joint["hips"]], up)
        if up == usual:  # no joint is below zero: in a bed, crawling
            return low > -0.1 * body.leg and np.median(hips) < 1.2 * body.leg
        return not stands and abs(low) < 0.3 * body.leg and np.median(hips) < 0.4 * body.leg

    if lying := [other for other in "xyz" if other not in seen and lies(other)]:
        found.doubt(f"the body stands along {seen} or lies with {lying[0]} up: {seen} is taken",
                    "up=")
    elif seen[0] == "-":
        found.doubt(f"the body stands along {seen}, or is upside down: {seen} is taken", "up=")
    else:
        # People go across the direction from feet to head, and not along it
        goes = np.ptp(body.recording.root_positions.numpy(), axis=0)
        if goes[axis] > 2 * body.leg and goes[axis] > 2 * np.delete(goes, axis).max():
            found.doubt(f"the body goes along {seen}, from its feet to its head: it may lie, with "
                        f"another axis up; {seen} is taken", "up=")
    return seen


def _unit(body: RecordedBody, found: Findings) -> float:
    """Metres of one unit: the one of `UNITS` with which the body is as tall as people are."""
    tall, stated = body.height, body.recording.unit
    if not tall > 0:
        unit = stated or UNITS["cm"]
        found.doubt(f"no head and legs show the unit of length: {named(unit)} is assumed", "unit=")
        return unit

    # The file's unit, then the others, for people
    first = (stated,) if stated else ()
    for unit in (*first, *UNITS.values()):
        if PEOPLE[0] <= unit * tall <= PEOPLE[1]:
            if stated and abs(unit / stated - 1) > 0.02:
                found.doubt(f"in the file's unit, {named(stated)}, the body is "
                            f"{stated * tall:.3g} m tall: {named(unit)} is assumed", "unit=")
            return unit

    # The same for children and made-up characters
    for unit in (*first, UNITS["cm"], UNITS["m"]):
        if FIGURES[0] <= unit * tall <= FIGURES[1]:
            found.doubt(f"with a unit of {named(unit)} the body is {unit * tall:.2f} m tall",
                        "unit=")
            return unit
    found.doubt(f"in no known unit the body of {tall:.4g} units is as tall as people: "
                f"it is scaled to {USUAL} m", "unit=")
    return USUAL / tall


def upright(up: str) -> Tensor:
    """Rotation ``[4]`` that turns an axis of `AXES` to y."""
    return R.from_euler(torch.deg2rad(torch.tensor(AXES[up], dtype=torch.float64)), "XYZ")


def named(unit: float) -> str:
    """A unit of length in words."""
    name = next((n for n, metres in UNITS.items() if abs(unit / metres - 1) < 0.005), None)
    return f"{unit:g} m ({name})" if name else f"{unit:g} m"
