"""Defects of finished motion: what a viewer sees as broken, with joint, time and size.

Each kind has a limit that recorded people keep: `LIMITS`, made by ``python -m experiments defects``
from the calibration half of recorded walks, runs and turns (Bandai-Namco 1 and 2, 100STYLE, Holden
2017, Xia 2015). The other half, styles and takes that no limit was chosen on, counts the false
alarms. Kicks, punches and dances are faster than walks, and their blows are reported.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import torch
from torch import Tensor

from toolkit.motion import Clip, contacts, rotations as R
from toolkit.motion.clearance import limbs, trunk
from toolkit.motion.roles import ROLES, SIDES

STEP = 1 / 30  # seconds between the positions of an acceleration or a jerk, at every rate
RUNNING = 1.6  # m/s of the hips, over half a second, from which the limits of runs hold
LOW, FLAT = 0.02, 0.02  # metres of toe and ankle above where they stand: the foot is flat
STANCE, TOUCH = 0.2, 0.1  # least seconds that a foot is flat, in a normal and in a short step
# A planted foot goes along with the hips at less than a share of their speed, or of a slow walk's.
BEHIND, STROLL = 0.5, 0.4
STILL, SLOW = 0.1, 0.3  # m/s of a toe that turns on the spot, and of one near its lowest place
REST = 0.5  # seconds over which a standing body drifts
ALIKE = 0.3  # largest speed of the toes from the hips, over that of the hips, of a gliding body
LIFTED = 0.1  # metres above the other: a foot that does not stand at all
JOIN = 0.2  # seconds between two moments of one finding

#: Kind of defect: part of the body: limit of walks, limit of runs. That of drift is ours, because
#: nobody in the recordings glides.
LIMITS: dict[str, dict[str, tuple[float, float]]] = {
    "slide": {"toe": (0.125, 0.125)},
    "short slide": {"toe": (0.215, 0.215)},
    "pivot": {"foot": (0.288, 0.288)},
    "drift": {"hips": (0.1, 0.1)},
    "floor": {"toe": (0.02, 0.02)},
    "pop": {"hips": (1020, 1310), "elbow": (2100, 3230), "hand": (3580, 6670),
            "knee": (2890, 3560), "foot": (3360, 4730), "toe": (3310, 4130)},
    "shake": {"hips": (0.0016, 0.00188), "elbow": (0.00352, 0.00559), "hand": (0.00562, 0.0094),
              "knee": (0.00642, 0.00663), "foot": (0.00593, 0.00621), "toe": (0.00507, 0.00691)},
    "bend": {"knee": (24000, 29900), "elbow": (28500, 47700)},
    "fold": {"knee": (144, 149), "elbow": (148, 154)},
    "body": {"hand and trunk": (0.078, 0.078), "hand and thigh": (0.058, 0.058),
             "shins": (0.022, 0.022)},
    "knee": {"knee": (0.032, 0.032)},
}
UNITS = {"slide": "m/s", "short slide": "m/s", "pivot": "m/s", "pop": "m/s3", "bend": "deg/s2",
         "shake": "m", "body": "m", "knee": "m", "fold": "deg", "drift": "m/s", "floor": "m",
         "apart": "m"}
LEAST = "body", "apart"  # kinds whose values must not be below the limit
#: Least distances of two characters, metres, ours: of their trunks, their limbs, and of a limb of
#: one to the other's trunk.
OTHERS = {("trunk", "trunk"): 0.2, ("limb", "limb"): 0.05, ("limb", "trunk"): 0.12}


@dataclass(frozen=True)
class Finding:
    """A defect: what, where, when, how large, and what recorded people keep."""

    kind: str  # a key of `UNITS`
    joint: str  # a joint's role, or several
    start: float  # seconds
    end: float
    value: float  # the worst
    limit: float
    unit: str
    character: int = 0  # of a scene

    @property
    def excess(self) -> float:
        """How many times the limit, or its inverse where the limit is a least value."""
        if self.kind in LEAST:
            return self.limit / max(self.value, 1e-6)
        return self.value / self.limit

    def __str__(self) -> str:
        who = f"character {self.character}, " if self.character else ""
        sign = "<" if self.kind in LEAST else ">"
        return (f"{self.kind}: {who}{self.joint.replace('_', ' ')}, {self.start:.2f} to "
                f"{self.end:.2f} s, {self.value:.3g} {sign} {self.limit:.3g} {self.unit}")


def defects(clip: Clip | Sequence[Clip] | Any, model: tuple[Any, Any] | None = None, *,
            apart: float | None = None) -> list[Finding]:
    """What is broken in a motion, in order of time; empty if nothing is.

    | kind | what it finds |
    | --- | --- |
    | slide, short slide | a flat foot moves over the floor, in a step or in one of a run |
    | pivot | the heel sweeps about a toe that stands |
    | pop, bend | jerk of a joint; angular acceleration of a knee or an elbow |
    | shake | a joint goes to and fro from frame to frame |
    | body | a limb goes through the own body, or that of another character |
    | knee, fold | a knee bends backwards; a limb is folded farther than flesh allows |
    | drift | hips and both feet glide while the body stands |
    | floor | a toe sinks below the floor on which the other one stands, or hovers over it |
    | apart | two characters are nearer than they should keep |

    Parameters
    ----------
    clip
        A clip; the clips of characters who share a floor; or a shot or scene, which is rendered.
    model
        Model and bank, such as ``tk.pretrained()``, which render a shot or scene; a ValueError if
        they are missing.
    apart
        Least distance of the hips of two characters, metres; by default the scene's.
    """
    if not isinstance(clip, Clip | Sequence):
        if model is None:
            raise ValueError("a shot or a scene is rendered first: give the model and its bank, "
                             "defects(scene, tk.pretrained())")
        apart = getattr(clip, "apart", None) if apart is None else apart
        clip = clip.render(*model)
    clips = [clip] if isinstance(clip, Clip) else list(clip)
    found = []
    for number, one in enumerate(clips):
        for kind, part, values, limit in measured(one):
            found += _findings(kind, part, values, limit, one.fps, number)
    for (a, one), (b, other) in combinations(enumerate(clips), 2):
        found += _between(a, one, b, other, apart)
    return sorted(found, key=lambda finding: finding.start)


def told(clip: Clip | Sequence[Clip], apart: float | None = None) -> str:
    """The result of `defects` in one line: how many of each kind, and the worst one."""
    try:
        found = defects(clip, apart=apart)
    except ValueError as error:  # a rig without knees or toes
        return f"Not looked at for defects: {error}"
    if not found:
        return "No defects found."
    counts = Counter(finding.kind for finding in found)
    listed = ", ".join(f"{count} × {kind}" for kind, count in counts.most_common())
    worst = max(found, key=lambda finding: finding.excess)
    return f"Defects: {listed}; the worst: {worst}"


def measured(clip: Clip) -> Iterator[tuple[str, str, Tensor, Tensor]]:
    """Kind, part, values ``[F]`` (NaN where there is none) and limits ``[F]`` of a clip."""
    at = {role: clip.global_positions[:, clip.skeleton.role(role)].double() for role in ROLES}
    fast = runs(clip)
    parts = (*_feet(clip, at), *_pops(clip, at), *_bodies(clip, at))
    for kind, part, values in parts:
        walking, running = LIMITS[kind][sideless(part)]
        yield kind, part, values, torch.where(fast, running, walking).to(values)


def runs(clip: Clip) -> Tensor:
    """Frames ``[F]`` in which a character runs."""
    hips = clip.global_positions[:, clip.skeleton.role("hips")][:, [0, 2]].double()
    return _speed(hips, clip.fps, 0.5).nan_to_num(0.0) > RUNNING


def sideless(part: str) -> str:
    """A part of the body without its side."""
    return part.removeprefix("left_").removeprefix("right_")


def _feet(clip: Clip, at: dict[str, Tensor]) -> Iterator[tuple[str, str, Tensor]]:
    """Planted feet and the floor, and drift of the standing body."""
    fps, floor = clip.fps, contacts.floor_height(clip).double()
    hips = _moved(at["hips"][:, [0, 2]], fps, TOUCH)
    travel = hips.norm(dim=-1)
    lowest, strides = [], []
    for side in SIDES:
        toe, ankle = at[f"{side}_toe"], at[f"{side}_foot"]
        low, above = toe[:, 1] - floor < LOW, ankle[:, 1] - floor
        stands = above[low].quantile(0.25) if low.any() else above.amin()
        flat = low & (above - stands < FLAT)
        velocity = _moved(toe, fps, TOUCH)
        pace = velocity.norm(dim=-1)
        # A swinging foot overtakes the hips; a planted one stays behind them, even if it slides.
        along = (velocity[:, [0, 2]] * hips).sum(-1) / travel.clamp_min(0.05)
        behind = flat & (along < BEHIND * travel.clamp_min(STROLL))
        # A foot that rolls or turns slides at the slower of both.
        slides = torch.minimum(pace, _speed(ankle, fps, TOUCH))
        for kind, held in (("slide", STANCE), ("short slide", TOUCH)):
            yield kind, f"{side}_toe", slides.where(_throughout(behind, held, fps), torch.nan)
        heel = _speed(ankle[:, [0, 2]], fps, TOUCH)
        still = flat & (pace < STILL)
        yield "pivot", f"{side}_foot", heel.where(_throughout(still, TOUCH, fps), torch.nan)
        slow = pace < SLOW  # for the floor
        lowest.append(toe[slow, 1].quantile(0.05) if slow.any() else toe.new_tensor(torch.nan))
        strides.append((velocity[:, [0, 2]] - hips).norm(dim=-1))
    # A body glides if its feet go along with its hips for a while, as no step does.
    window = 2 * max(1, round(REST * fps / 2)) + 1
    if len(clip) >= window:
        step = torch.stack(strides).amax(0)
        step, way = (x.unfold(0, window, 1).mean(-1) for x in (step, travel))
        yield "drift", "hips", _placed(way.where(step < ALIKE * way, torch.nan), len(clip))
    uneven = (lowest[0] - lowest[1]).abs()
    uneven = uneven.where(uneven < LIFTED, torch.nan).expand(len(clip))
    yield "floor", f"{SIDES[int(lowest[0] > lowest[1])]}_toe", uneven


def _pops(clip: Clip, at: dict[str, Tensor]) -> Iterator[tuple[str, str, Tensor]]:
    """Sudden changes of joints and angles, and trembling."""
    k = max(1, round(STEP * clip.fps))
    whole = max(3, round(0.2 * clip.fps))
    for role, path in at.items():
        if role.endswith(("hip", "shoulder")):
            continue
        yield "pop", role, _placed(jerks(path, clip.fps), len(clip))
        fourth = torch.diff(path, 4, dim=0).norm(dim=-1) / 16  # of ± a, it is a
        if len(fourth) >= whole:
            steady = fourth.unfold(0, whole, 1).median(-1).values
            # Smooth motion is smaller in shorter frames, down to the noise of cameras.
            yield "shake", role, _placed(steady * (min(clip.fps, 60) / 30) ** 2, len(clip))
    for side in SIDES:
        for root, middle, end in (("hip", "knee", "foot"), ("shoulder", "elbow", "hand")):
            above, joint, below = (at[f"{side}_{part}"] for part in (root, middle, end))
            flexion = R.angle(joint - above, below - joint).rad2deg()
            turn = flexion[2 * k:] - 2 * flexion[k:-k] + flexion[:-2 * k]
            turn = turn.abs() * (clip.fps / k) ** 2
            yield "bend", f"{side}_{middle}", _placed(turn, len(clip))
            yield "fold", f"{side}_{middle}", flexion


def jerks(path: Tensor, fps: float) -> Tensor:
    """Jerk ``[F', ...]`` of positions ``[F, ..., 3]`` at moments `STEP` apart, m/s³."""
    k = max(1, round(STEP * fps))
    third = path[3 * k:] - 3 * path[2 * k:-k] + 3 * path[k:-2 * k] - path[:-3 * k]
    return third.norm(dim=-1) * (fps / k) ** 3


def _bodies(clip: Clip, at: dict[str, Tensor]) -> Iterator[tuple[str, str, Tensor]]:
    """Limbs through the own body, and knees that bend backwards."""
    axis, points = trunk(clip), limbs(clip)
    for side in SIDES:
        arm = points[f"{side}_hand"]
        yield "body", f"{side}_hand and trunk", _distance(arm, axis)
        thighs = torch.cat([points[f"{other}_knee"] for other in SIDES], 1)
        yield "body", f"{side}_hand and thigh", _distance(arm, thighs)
    shins = [points[f"{side}_foot"] for side in SIDES]
    yield "body", "shins", _distance(*shins)
    across = R.normalize(at["left_hip"] - at["right_hip"])
    ahead = torch.linalg.cross(across, across.new_tensor([0.0, 1.0, 0.0]).expand_as(across))
    for side in SIDES:
        hip, knee, foot = (at[f"{side}_{part}"] for part in ("hip", "knee", "foot"))
        leg = R.normalize(foot - hip)
        bent = knee - hip - ((knee - hip) * leg).sum(-1, keepdim=True) * leg
        yield "knee", f"{side}_knee", -(bent * ahead).sum(-1)


def _between(a: int, one: Clip, b: int, other: Clip, apart: float | None) -> list[Finding]:
    """Two characters in each other's way."""
    frames, found = min(len(one), len(other)), []
    hips = [clip.global_positions[:frames, clip.skeleton.role("hips")][:, [0, 2]].double()
            for clip in (one, other)]
    gap = (hips[0] - hips[1]).norm(dim=-1)
    if apart is not None:
        found += _findings("apart", f"hips of {a} and {b}", gap, torch.full_like(gap, apart),
                           one.fps, b)
    if float(gap.min()) > 2.0:  # metres: nobody's arms are so long
        return found
    mine, theirs = ({"trunk": trunk(clip)[:frames],
                     "limb": torch.cat([*limbs(clip).values()], 1)[:frames]}
                    for clip in (one, other))
    for part, with_, first, second in (
            ("trunk", "trunk", mine, theirs), ("limb", "trunk", mine, theirs),
            ("limb", "trunk", theirs, mine), ("limb", "limb", mine, theirs)):
        near = _distance(first[part], second[with_])
        limit = torch.full_like(near, OTHERS[part, with_])
        found += _findings("body", f"{part} and {with_} of {a} and {b}", near, limit, one.fps, b)
    return found


def _findings(kind: str, part: str, values: Tensor, limit: Tensor, fps: float,
              character: int) -> list[Finding]:
    """Moments beyond the limit; those that are less than `JOIN` apart are one."""
    worse = limit - values if kind in LEAST else values - limit
    frames = (worse > 0).nonzero()[:, 0]
    gaps = (frames.diff() > JOIN * fps).nonzero()[:, 0] + 1
    found = []
    for some in frames.tensor_split(gaps.tolist()) if len(frames) else ():
        at = some[worse[some].argmax()]
        found.append(Finding(kind, part, int(some[0]) / fps, (int(some[-1]) + 1) / fps,
                             float(values[at]), float(limit[at]), UNITS[kind], character))
    return found


def _distance(a: Tensor, b: Tensor) -> Tensor:
    """Least distance ``[F]`` of points ``[F, N, 3]`` and ``[F, M, 3]``."""
    return torch.cdist(a, b).flatten(1).amin(1)


def _moved(path: Tensor, fps: float, seconds: float) -> Tensor:
    """Velocity ``[F, D]`` over so many seconds, centred; NaN at the ends."""
    k = max(1, round(seconds * fps / 2))
    return _placed((path[2 * k:] - path[:-2 * k]) * fps / (2 * k), len(path))


def _speed(path: Tensor, fps: float, seconds: float) -> Tensor:
    return _moved(path, fps, seconds).norm(dim=-1)


def _placed(values: Tensor, frames: int) -> Tensor:
    """Values of windows at the windows' middles, ``[F, ...]``, and NaN at the ends."""
    made = values.new_full((frames, *values.shape[1:]), torch.nan)
    first = (frames - len(values)) // 2
    made[first:first + len(values)] = values
    return made


def _throughout(true: Tensor, seconds: float, fps: float) -> Tensor:
    """Frames ``[F]`` around which a condition holds for so long."""
    k = max(1, round(seconds * fps / 2))
    held = torch.zeros_like(true)
    if len(true) > 2 * k:
        held[k:-k] = true.unfold(0, 2 * k + 1, 1).all(-1)
    return held
