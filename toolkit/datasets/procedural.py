"""The embedded default: stylised locomotion made from footstep planning, with the true contacts and phases known.

No recorded motion is used. A path is planned first, then the footsteps along it; feet are planted in the world, swing in
arcs from print to print, and the legs follow by inverse kinematics to a pelvis that keeps within their reach. Trunk and
arms ride on the clock that the steps give. See `toolkit.datasets.procedural_styles` for what makes a style.
"""

import math
import zlib
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from scipy.interpolate import PchipInterpolator
from torch import Tensor

from toolkit import rotations as R
from toolkit.datasets.procedural_styles import STYLES, Arm, Leg, Style
from toolkit.ik import two_bone
from toolkit.motion import Clip, Skeleton, forward_kinematics

FPS = 60
#: Forwards, backwards and sidestep walk and run, idle, and a transition through all of them.
GAITS = ("FW", "BW", "FR", "BR", "SW", "SR", "ID", "TR1")
LEAD = 60  # frames planned before and after the clip, so that it starts and ends in full motion
TOE = 0.021  # height of a standing toe joint
REACH = (0.5, 0.66)  # how far the foot may be from under the hips when it strikes and when it lifts off, metres
SIDES = ("left", "right")

_SPINE = (("Hips", -1, 0, 0, 0), ("Chest", 0, 0, 0.130, 0), ("Chest2", 1, 0, 0.103, 0), ("Chest3", 2, 0, 0.093, 0),
          ("Chest4", 3, 0, 0.093, 0), ("Neck", 4, 0, 0.133, 0), ("Head", 5, 0, 0.090, 0), ("HeadEnd", 6, 0, 0.171, 0))  # fmt: skip
_ARM = (("Collar", 4, 0.032, 0.075, 0), ("Shoulder", 8, 0.158, 0, 0), ("Elbow", 9, 0.312, 0, 0),
        ("Wrist", 10, 0.255, 0, 0), ("WristEnd", 11, 0.191, 0, 0))  # fmt: skip
_LEG = (("Hip", 0, 0.107, 0.001, 0), ("Knee", 18, 0, -0.437, 0), ("Ankle", 19, 0, -0.432, 0),
        ("Toe", 20, 0, -0.097, 0.192), ("ToeEnd", 21, 0, -0.013, 0.049))  # fmt: skip


def _skeleton() -> Skeleton:
    rows = list(_SPINE)
    for limb in (_ARM, _LEG):
        for side, sign, shift in (("Right", -1, 0), ("Left", 1, 5)):
            rows += [(side + n, p + shift * (i > 0), sign * x, y, z) for i, (n, p, x, y, z) in enumerate(limb)]
    return Skeleton([r[0] for r in rows], [r[1] for r in rows], torch.tensor([r[2:] for r in rows]))


#: 100STYLE's 28 points: same names, order and axes, lengths to the millimetre; zero rotation is a T-pose facing +Z.
SKELETON = _skeleton()
_J = {name: j for j, name in enumerate(SKELETON.names)}
_FOOT = SKELETON.offsets[_J["LeftToe"]].double() * torch.tensor([0.0, 1.0, 1.0])  # ankle → toe joint
_HEEL = torch.tensor([0.0, _FOOT[1], -0.05], dtype=torch.float64)  # ankle → where the heel touches


@dataclass(frozen=True, eq=False)
class Truth:
    """What is known about a clip because it was planned.

    ``contacts [F, 2]`` (right, left): 1 while the toe joint is planted in the world. ``phase [F, 4]`` (left hand, right
    hand, left foot, right foot), radians, growing: a foot is in the middle of its contact at multiples of 2π, a hand's
    arm is furthest forward there. ``frequency [F, 4]``, Hz, is 0 while standing.
    """

    contacts: Tensor
    phase: Tensor
    frequency: Tensor


def load(
    styles: Sequence[str] | None = None, gaits: Sequence[str] | None = None, seconds: float = 8.0, seed: int = 0
) -> list[Clip]:
    """One clip of every style in every gait.

    Parameters
    ----------
    styles, gaits
        Names in `STYLES` and `GAITS`; all by default.
    seconds
        Length of each clip.
    seed
        The same seed gives the same clips, to the byte; another one other paths.

    Raises
    ------
    ValueError
        If a style or a gait is unknown; the message lists the names.
    """
    return [generate(s, g, seconds, seed) for s in styles or STYLES for g in gaits or GAITS]


def generate(style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0, path: Tensor | None = None) -> Clip:
    """A clip in a style, at 60 Hz.

    Parameters
    ----------
    style
        A name in `STYLES`, or a `Style` of your own.
    gait
        One of `GAITS`; decides the path, and so whether this is a walk or a run, forwards or not.
    seconds
        Length.
    seed
        Of the path and of the style's noise.
    path : Tensor [F, 3], optional
        Walk along this instead: x, z in metres and facing in radians (0 is +Z, positive turns left) at 60 Hz.

    Raises
    ------
    ValueError
        If style or gait is unknown, or the length is not positive.
    """
    return truth(style, gait, seconds, seed, path)[0]


def truth(
    style: str | Style, gait: str = "FW", seconds: float = 8.0, seed: int = 0, path: Tensor | None = None
) -> tuple[Clip, Truth]:
    """As `generate`, and what is known about the clip beside it."""
    label = style if isinstance(style, str) else "custom"
    if isinstance(style, str):
        if style not in STYLES:
            raise ValueError(f"unknown procedural style {style!r}; known are {', '.join(STYLES)}")
        style = STYLES[style]
    if gait not in GAITS:
        raise ValueError(f"unknown gait {gait!r}; known are {', '.join(GAITS)}")
    frames = round(seconds * FPS) if path is None else len(path)
    if frames < 2:
        raise ValueError(f"a clip needs at least two frames, got {seconds} seconds")
    rng = np.random.default_rng([seed, zlib.crc32(f"{label} {gait}".encode())])
    root = _path(style, gait, frames, rng) if path is None else np.asarray(path, dtype=np.float64)
    edges = np.pad(root, ((LEAD, LEAD), (0, 0)), mode="reflect", reflect_type="odd") if frames > LEAD else np.concatenate(
        (root[0] + np.arange(-LEAD, 0)[:, None] * (root[1] - root[0]), root,
         root[-1] + np.arange(1, LEAD + 1)[:, None] * (root[-1] - root[-2])))  # fmt: skip
    plan = _Plan(style, edges, rng)
    feet = {side: plan.foot(side) for side in plan.stepping}
    rotations, positions = _pose(plan, feet)
    known = _truth(plan, feet)
    keep = slice(LEAD, LEAD + frames)
    name = f"procedural {label} {gait} seed {seed}"
    clip = Clip(SKELETON, R.unroll(rotations[keep]), positions[keep], FPS, label, gait, name)
    return clip, Truth(known.contacts[keep], known.phase[keep], known.frequency[keep])


def _smooth(x: np.ndarray, sigma: float) -> np.ndarray:
    """Gaussian over the first axis, `sigma` in frames; the ends are continued by odd reflection."""
    half = math.ceil(3 * sigma)
    kernel = np.exp(-0.5 * (np.arange(-half, half + 1) / sigma) ** 2)
    flat = np.pad(x.reshape(len(x), -1), ((half, half), (0, 0)), mode="edge")
    out = np.stack([np.convolve(c, kernel / kernel.sum(), mode="valid") for c in flat.T], 1)
    return out.reshape(x.shape)


def _wander(rng: np.random.Generator, frames: int, sigma: float, channels: int) -> np.ndarray:
    """Smooth noise of unit deviation ``[frames, channels]`` with a time constant of `sigma` frames."""
    half = math.ceil(3 * sigma)
    white = rng.standard_normal((frames + 2 * half, channels))
    return _smooth(white, sigma)[half : half + frames] * math.sqrt(2 * math.sqrt(math.pi) * sigma)


# ---- where to go


def _usual(style: Style, forward: np.ndarray, sideways: np.ndarray) -> np.ndarray:
    """Usual walking speed in a direction: slower backwards, slower still sideways."""
    norm = np.hypot(forward, sideways)
    along = np.divide(forward, norm, out=np.ones_like(norm), where=norm > 1e-6)
    back = np.where(along < 0, 0.65, 1.0)
    return style.speed * np.hypot(along * back, (1 - along**2) ** 0.5 * 0.5)


def _path(style: Style, gait: str, frames: int, rng: np.random.Generator) -> np.ndarray:
    """Root path ``[frames, 3]`` (x, z, facing) of a gait: random changes of speed and heading."""
    walk, run = np.array([0.0, 1.0]), np.array([0.0, style.run])
    back, side = np.array([0.0, -0.65]), np.array([0.5, 0.0])
    stand = np.zeros(2)
    legs: list[tuple[float, np.ndarray, float]] = []  # seconds, (left, forward) in usual speeds, turn in radians
    sign = rng.choice([-1.0, 1.0])
    total = 0.0
    while total < frames / FPS:
        if gait == "TR1":
            share = min(1.4, max(0.6, frames / FPS / 7)) * rng.uniform(0.85, 1.15, 7)
            turn = sign * rng.uniform(1.0, 2.6)
            other = [side, -side, back][rng.integers(3)]
            row = [(stand, 0.0), (walk, 0.0), (walk, turn), (run, rng.normal(0, 0.4)), (walk, -0.6 * turn), (other, 0.0),
                   (stand, 0.0)]  # fmt: skip
            new = [(s, v, t) for s, (v, t) in zip(share, row, strict=True)]
        elif gait == "ID":
            new = [(rng.uniform(4, 9), stand, 0.0)]
        else:
            kind = {"F": walk, "B": back, "S": sign * side}[gait[0]] * (style.run if gait[1] == "R" else 1.0)
            if gait in ("BR", "SR"):
                kind = kind * 0.8
            length = rng.uniform(1.2, 3.0)
            rate = sign * rng.choice([0.0, 0.5, 1.1], p=[0.3, 0.45, 0.25]) * rng.uniform(0.7, 1.3)
            rate *= 0.35 if gait[0] == "S" else 0.8 if gait[1] == "R" else 1.0
            new = [(length, kind * rng.choice([0.65, 0.85, 1.0, 1.0, 1.1]), rate * length)]
        sign = -sign
        legs += new
        total += sum(n[0] for n in new)
    edges = np.concatenate(([0.0], np.cumsum([n[0] for n in legs]))) * FPS
    if gait == "TR1":  # the last round ends where the clip ends
        edges *= frames / edges[-1]
    at = np.searchsorted(edges, np.arange(frames), side="right") - 1
    velocity = np.array([n[1] for n in legs])[at] * style.speed
    rate = np.array([n[2] / n[0] for n in legs])[at]
    pace = np.abs(velocity).sum(1) / style.speed
    rate = rate + style.noise * 0.35 * np.minimum(pace, 1) * _wander(rng, frames, 35, 1)[:, 0]
    velocity = velocity + style.noise * 0.12 * np.minimum(pace, 1)[:, None] * _wander(rng, frames, 30, 2)
    velocity, rate = _smooth(velocity, 13), _smooth(rate, 11)
    facing = rng.uniform(-math.pi, math.pi) + np.cumsum(rate) / FPS
    c, s = np.cos(facing), np.sin(facing)
    world = np.stack((velocity[:, 0] * c + velocity[:, 1] * s, -velocity[:, 0] * s + velocity[:, 1] * c), 1) / FPS
    return np.concatenate((np.cumsum(world, 0), facing[:, None]), 1)


# ---- where to step


class _Plan:
    """Pace, clock and footsteps along a path of F frames."""

    def __init__(self, style: Style, root: np.ndarray, rng: np.random.Generator):
        self.style, self.rng = style, rng
        self.root = root = _smooth(root, 4)
        self.t = np.arange(len(root), dtype=np.float64)
        c, s = np.cos(root[:, 2]), np.sin(root[:, 2])
        step = np.gradient(root, axis=0) * FPS
        self.sideways, self.ahead = step[:, 0] * c - step[:, 1] * s, step[:, 0] * s + step[:, 1] * c
        self.turning = step[:, 2]
        self.speed = np.hypot(self.sideways, self.ahead)
        self.pace = self.speed / _usual(style, self.ahead, self.sideways)
        x = np.clip((self.pace - 1.3) / 0.6, 0, 1)
        self.running = _smooth(x * x * (3 - 2 * x), 4)
        self.stepping = [side for side in SIDES if not style.leg(side).raised]
        self._schedule()

    def _frequency(self, t: int) -> float:
        """Strides (hops) per second that suit the pace at frame `t`."""
        pace, run = max(self.pace[t], 0.5), self.running[t]
        walk, fast = min(pace, 1.7) ** 0.5, 1.5 * (pace / 2.2) ** 0.35
        return self.style.cadence * (pace**0.25 if len(self.stepping) == 1 else walk + run * (fast - walk))

    def _schedule(self) -> None:
        """Which foot lifts off when: step after step while the path moves, two more to come to rest, then none.

        The clock of the body is 0 where the left foot lifts off and π where the right one does.
        """
        sides, n = self.stepping, len(self.stepping)
        turn = int(self.rng.integers(n))
        t, clock, settled = 0.0, math.pi * turn, 0 if self.speed[0] > 0.05 else 2
        self.swings, knots = [], [(0.0, clock)]
        while t < len(self.t):
            look = min(int(t) + 12, len(self.t) - 1)
            moving = self.pace[look] > 0.12 or abs(self.turning[look]) > 0.25
            if not moving and settled >= 2:
                t += 1.0
                continue
            settled = 0 if moving else settled + 1
            side = sides[turn % n]
            beat = FPS / self._frequency(look) / n
            if n == 2:
                beat *= 1 + self.style.asymmetry * (1 if side == "left" else -1)
            if knots[-1][0] < t - 1e-6:
                knots.append((t, clock))
            self.swings.append((side, t, FPS / self._frequency(look), self.running[look]))
            clock += 2 * math.pi / n
            t += beat
            knots.append((t, clock))
            turn += 1
        knots.append((t + len(self.t), clock))
        self.clock = _smooth(PchipInterpolator(*np.array(knots).T)(self.t), 3)

    def foot(self, side: str) -> "_Foot":
        """Footsteps of one side, and the tracks that follow from them."""
        style, leg, sign = self.style, self.style.leg(side), 1 if side == "left" else -1
        mine = np.array([s[1:] for s in self.swings if s[0] == side] or [(2.0 * len(self.t), FPS / style.cadence, 0.0)])
        off, stride, run = mine.T
        duty = leg.stance - run * max(0.0, leg.stance - 0.38)
        on = off + stride * (1 - duty)
        on[:-1] = np.minimum(on[:-1], off[1:] - 0.2 * stride[:-1])
        usual = np.concatenate((stride[:1] * duty[:1], stride * duty))  # durations of the N + 1 stances
        begin, end = np.concatenate((off[:1] - usual[:1], on)), np.concatenate((off, on[-1:] + usual[-1:]))
        if off[0] > len(self.t):
            begin[0] = -end[0]

        def at(track: np.ndarray) -> np.ndarray:
            return np.interp((begin + end) / 2, self.t, track)

        # planted under the hips in the middle of each stance; walking sideways the feet stay apart
        x, z, facing = (at(c) for c in self.root.T)
        stride = np.concatenate((stride[:1], stride)) / FPS
        apart = np.maximum(style.width / 2, 0.06 + np.abs(at(self.sideways)) * stride / 4)
        scatter = style.noise * 0.03 * self.rng.standard_normal((3, len(x)))
        speed = at(self.speed)
        along = at(self.ahead) / np.maximum(speed, 0.1)
        size = np.minimum(speed / 2 * stride / style.step, 1.2)
        # a foot comes to stand less far ahead than it is left behind, where the raised heel lengthens the leg
        front = leg.ahead - 0.12 * style.step * size * along + scatter[1]
        left = (sign * apart if len(self.stepping) == 2 else sign * 0.02) + scatter[0]
        yaw = facing + sign * math.radians(leg.turned_out) + 2 * scatter[2]
        c, s, reach = np.cos(facing), np.sin(facing), float(_FOOT[2])
        prints = np.stack((x + left * c + front * s + reach * np.sin(yaw), z - left * s + front * c + reach * np.cos(yaw),
                           yaw), 1)  # fmt: skip
        from_hips = self.root[:, None, :2] - (prints[:, :2] - reach * np.stack((np.sin(yaw), np.cos(yaw)), 1))
        for k, far in enumerate(np.hypot(*np.moveaxis(from_hips, 2, 0)).T):
            half = int(np.clip((begin[k] + end[k]) / 2, 0, len(self.t)))
            early = np.flatnonzero(far[max(int(begin[k]), 0) : half] > REACH[0])
            late = np.flatnonzero(far[half : max(int(end[k]), 0)] > REACH[1])
            begin[k] += early[-1] if len(early) else 0
            end[k] = half + late[0] if len(late) else end[k]
        return _Foot(self, leg, sign, begin, end, usual, prints, along, size, np.concatenate((run[:1], run)))


class _Foot:
    """Tracks of a foot over F frames: toe position, yaw and pitch, how flat the toes are kept, contact and phase.

    The foot has N + 1 stances, from `begin` to `end` (frames), and a swing between each two.
    """

    def __init__(self, plan: _Plan, leg: Leg, sign: int, begin: np.ndarray, end: np.ndarray, usual: np.ndarray,
                 prints: np.ndarray, along: np.ndarray, size: np.ndarray, run: np.ndarray):  # fmt: skip
        t = plan.t
        here = np.searchsorted(end[:-1], t, side="right")  # the stance before the swing, or the one stood in
        before = np.maximum(here - 1, 0)
        stance = np.minimum(usual, end - begin)
        settled = begin + 0.1 * stance  # the toes come down while the foot rolls over the heel
        u = np.clip((t - end[before]) / (settled[np.minimum(before + 1, len(begin) - 1)] - end[before]), 0, 1)
        u = np.where(here == 0, 1.0, u)

        ease = u**3 * (10 - 15 * u + 6 * u * u)
        place = prints[before] + (prints[here] - prints[before]) * ease[:, None]
        place[here == 0] = prints[0]
        # pitch, toes up, from strike over flat to push-off; walking backwards toes first and heel last
        forwards, backwards = np.maximum(along, 0), np.maximum(-along, 0)
        strike = size * (leg.heel_strike * forwards * (1 - 0.6 * run) - 14 * backwards)
        push = leg.toe_off * size**0.7 * (0.35 + 0.65 * forwards - 0.2 * backwards) * (1 + 0.25 * run)
        lift_off = -0.7 * push * (1 - backwards)
        flat = np.full_like(size, -leg.tiptoe)
        swing = np.append(begin[1:] - end[:-1], usual[-1])
        nexts = np.append(strike[1:], 0.0)
        knots = np.stack((begin, begin + 0.16 * stance, end - 0.45 * stance, end, end + 0.15 * swing, end + 0.5 * swing,
                          end + 0.86 * swing), 1)  # fmt: skip
        angles = np.stack((strike + flat, flat, flat, np.minimum(flat, 0) * 0.5 + lift_off, flat * 0.2 - push,
                           flat * 0.7 - 0.4 * push, flat + nexts), 1)  # fmt: skip
        pitch = PchipInterpolator(knots.ravel(), angles.ravel())(np.clip(t, knots[0, 0], knots[-1, -1]))
        self.pitch = np.radians(_smooth(pitch, 2.0))
        self.flatness = PchipInterpolator(
            np.stack((begin, end, end + 0.45 * swing, end + 0.9 * swing), 1).ravel(), np.tile([1.0, 1.0, 0.1, 1.0], len(begin))
        )(np.clip(t, begin[0], end[-1]))

        w = u ** (math.log(0.5) / math.log(leg.lift_at))
        bump = 16 * w**2 * (1 - w) ** 2
        height = (leg.lift + 0.1 * run) * (0.7 + 0.3 * size)
        rise, kick = height[here] * bump, leg.kick * size[here] * bump
        out = sign * leg.circle * size[here] * bump
        c, s = np.cos(plan.root[:, 2]), np.sin(plan.root[:, 2])
        # over the heel while the toes are up: the toe joint circles round it
        up = np.maximum(self.pitch, 0)
        wide = 0.1
        self.air = np.sin(math.pi * u) ** 2
        up = np.where(up < wide, up * up / (2 * wide), up - wide / 2)
        up += self.air * ((self.pitch + np.sqrt(self.pitch**2 + 0.06)) / 2 - up)
        lever = float(_FOOT[2] - _HEEL[2])
        back = lever * (np.cos(up) - 1)
        yaw = place[:, 2]
        self.toe = np.stack((place[:, 0] + out * c + kick * s + back * np.sin(yaw),
                             TOE + rise + 1.2 * kick + lever * np.sin(up),
                             place[:, 1] - out * s + kick * c + back * np.cos(yaw)), 1)  # fmt: skip
        self.yaw = yaw
        moved = np.linalg.norm(np.diff(self.toe, axis=0), axis=1)
        moved = np.maximum(np.append(moved, moved[-1]), np.append(moved[0], moved))
        self.contact = ((u < 0.1) | (u > 0.9)) & (moved < 9e-4)
        planted = begin + 0.12 * stance
        hold = np.maximum((end - planted) / 2 - usual * 0.44, 0.0)
        middle = (planted + end) / 2
        cycle = 2 * math.pi * np.arange(len(begin))
        knots = np.stack((middle - hold - 1e-3, middle + hold + 1e-3, end + swing / 2 + 2e-3), 1).ravel()
        values = np.stack((cycle, cycle, cycle + math.pi), 1).ravel()
        self.phase = PchipInterpolator(knots, values)(np.clip(t, knots[0], knots[-2]))


# ---- how the body rides on it


def _pose(plan: _Plan, feet: dict[str, "_Foot"]) -> tuple[Tensor, Tensor]:
    """Local rotations ``[F, J, 4]`` and root positions ``[F, 3]``."""
    style, frames, run = plan.style, len(plan.t), plan.running
    amount = _smooth(np.minimum(plan.pace, 1.5) ** 0.6 * (plan.pace > 0.02), 8)
    still = np.clip(1 - amount, 0, 1)
    legs = [style.leg(s) for s in plan.stepping]
    stance = np.mean([leg.stance for leg in legs])
    middle = math.pi * (1 - (stance - run * max(0.0, stance - 0.38)))
    beat = plan.clock - middle  # 0 where the left foot is in the middle of its swing
    sin, cos, cos2 = amount * np.sin(beat), amount * np.cos(beat), amount * np.cos(2 * beat)
    unrest = style.noise * _wander(plan.rng, frames, 22, 8).T
    breath = 0.6 * np.sin(2 * math.pi * 0.25 / FPS * plan.t)
    bank = np.degrees(np.arctan(plan.ahead * plan.turning / 9.81))
    bank = _smooth(np.clip(bank, -20, 20), 8)
    hopping = len(plan.stepping) == 1

    euler = np.zeros((frames, len(SKELETON), 3))  # degrees; turn to the left, bow, roll to the right

    def turn(joints: Sequence[str], y=0.0, x=0.0, z=0.0) -> None:
        for name in joints:
            euler[:, _J[name]] += np.stack(np.broadcast_arrays(y, x, z, np.zeros(frames))[:3], 1) / len(joints)

    speedup = 1 + 0.4 * run
    even = 0.0 if hopping else 1.0
    turn(["Hips"], -style.yaw * speedup * sin * even, style.tilt + 3 * run, -style.drop * cos * even - 0.5 * bank)
    spine = ["Chest", "Chest2", "Chest3", "Chest4"]
    lean = style.lean + 5 * run + style.lean_swing * cos2 + breath + 3 * unrest[0]
    turn(spine, style.twist + (style.yaw + style.twist_swing) * speedup * sin * even + 2.5 * unrest[1], lean,
         -style.bend + (style.bend_swing + style.drop) * cos * even - 0.3 * bank + 3 * unrest[2])  # fmt: skip
    undo = -style.steady * (euler[:, _J["Hips"]] + euler[:, [_J[s] for s in spine]].sum(1))
    undo += style.steady * np.array([style.twist, style.tilt + style.lean, -style.bend])
    turn(["Neck", "Head"], undo[:, 0] + style.head_turn + np.degrees(0.25 * _smooth(plan.turning, 10)) + 4 * unrest[3],
         undo[:, 1] - 6 * run, undo[:, 2] - style.head_roll + style.head_swing * cos + 3 * unrest[4])  # fmt: skip
    turn(["Neck"], 0, style.neck)
    turn(["Head"], 0, style.head)

    twist = np.zeros((frames, 2))
    for i, side in enumerate(SIDES):
        arm, sign, name = style.arm(side), 1 if side == "left" else -1, side.capitalize()
        swing = -amount * np.sin(arm.ratio * plan.clock - middle - math.radians(arm.phase) + math.pi * i)
        loose = (arm.swing > 0) * run
        flex = arm.forward + arm.swing * (1 + 0.3 * run) * swing + 4 * unrest[5 + i] - 4 * loose
        out = arm.out + arm.out_swing * cos + 3 * unrest[7] + 4 * loose
        elbow = arm.elbow + arm.elbow_swing * swing + loose * max(0.0, 75 - arm.elbow) + 2 * unrest[5 + i]
        turn([name + "Collar"], 0, 0, sign * style.shrug)
        turn([name + "Shoulder"], 0, -flex, sign * (out - 90 - style.shrug))
        turn([name + "Elbow"], -sign * np.clip(elbow, 0, 140))
        turn([name + "Wrist"], -sign * arm.wrist)
        twist[:, i] = arm.twist * (1 - 0.6 * loose)

    local = R.from_euler(torch.from_numpy(np.radians(euler)), "YXZ")
    facing = torch.from_numpy(plan.root[:, 2])
    local[:, 0] = R.multiply(R.yaw(facing), local[:, 0])
    shoulders = [_J["LeftShoulder"], _J["RightShoulder"]]
    along = torch.tensor([1.0, 0.0, 0.0], dtype=torch.float64)
    local[:, shoulders] = R.multiply(local[:, shoulders], R.from_axis_angle(along, torch.from_numpy(np.radians(twist))))

    # hips over the path: swaying over the standing foot, as high as style and legs allow
    side = -style.sway * cos * even + 0.012 * still * even * _wander(plan.rng, frames, 50, 1)[:, 0]
    if hopping:
        side = side + (0.02 if plan.stepping[0] == "left" else -0.02)
    front = style.forward + 0.04 * style.noise * unrest[3] * amount
    c, s = np.cos(plan.root[:, 2]), np.sin(plan.root[:, 2])
    hips = np.stack((plan.root[:, 0] + side * c + front * s, np.zeros(frames), plan.root[:, 1] - side * s + front * c), 1)
    up = style.bob * amount * np.cos(beat) if hopping else (style.bob * (1 - run) - 0.035 * run) * cos2
    wanted = style.height + 0.01 * still - 0.02 * run + up
    joints = [_J["LeftHip"], _J["RightHip"]]
    offsets = R.rotate(local[:, :1], SKELETON.offsets[joints].double())  # [F, 2, 3] hips → hip joint
    length = float(-SKELETON.offsets[_J["LeftKnee"], 1] - SKELETON.offsets[_J["LeftAnkle"], 1])

    ankles = torch.zeros(frames, 2, 3, dtype=torch.float64)
    yaws, pitches, toes, airs = (np.zeros((frames, 2)) for _ in range(4))
    ceiling = np.full(frames, 9.0)
    for i, name in enumerate(SIDES):
        if name in feet:
            foot = feet[name]
            yaws[:, i], pitches[:, i], airs[:, i] = foot.yaw, foot.pitch, foot.air
            toes[:, i] = foot.pitch - np.minimum(foot.pitch, 0) * foot.flatness
            turned = _foot_rotation(yaws[:, i], pitches[:, i])
            ankles[:, i] = torch.from_numpy(foot.toe) - R.rotate(turned, _FOOT)
            gap = (ankles[:, i] - offsets[:, i]).numpy() - hips
            flat = np.minimum(np.hypot(gap[:, 0], gap[:, 2]), 0.9 * length)
            ceiling = np.minimum(ceiling, gap[:, 1] + np.sqrt((0.997 * length) ** 2 - flat**2))
    half = 10
    low = np.lib.stride_tricks.sliding_window_view(np.pad(ceiling, half, mode="edge"), 2 * half + 1).min(1)
    hann = np.hanning(2 * half + 3)[1:-1]
    low = np.convolve(np.pad(low, half, mode="edge"), hann / hann.sum(), mode="valid") - 0.001  # never above the ceiling
    hips[:, 1] = (wanted + low - np.sqrt((wanted - low) ** 2 + 0.012**2)) / 2
    hips = torch.from_numpy(hips)

    for i, name in enumerate(SIDES):
        if name not in feet:  # held up behind
            bent = torch.tensor([0.0, -0.47, -0.27], dtype=torch.float64)
            ankles[:, i] = hips + offsets[:, i] + R.rotate(R.yaw(facing), bent)
            ankles[:, i, 1] += torch.from_numpy(0.03 * sin)
            yaws[:, i], pitches[:, i], toes[:, i] = plan.root[:, 2], -1.1, -1.1
    a = hips[:, None] + offsets
    line = R.normalize(ankles - a)
    left = R.rotate(local[:, :1], along) + R.rotate(R.yaw(torch.from_numpy(yaws)), along)
    pole = torch.linalg.cross(line, left)
    rest = SKELETON.rest_positions.double()
    knee = [_J["LeftKnee"], _J["RightKnee"]]
    ankle = [_J["LeftAnkle"], _J["RightAnkle"]]
    b, e = two_bone(a, a + (rest[knee] - rest[joints]), a + (rest[ankle] - rest[joints]), ankles, pole, soft=0.002)
    hinge = R.normalize(torch.linalg.cross(pole, line))
    thigh, shin = (R.from_matrix(torch.stack((hinge, y, torch.linalg.cross(hinge, y)), -1))
                   for y in (R.normalize(a - b), R.normalize(b - e)))  # fmt: skip
    # in the air the foot follows the shin: no more than 35° of dorsiflexion
    front = R.rotate(R.yaw(torch.from_numpy(yaws)), torch.tensor([0.0, 0.0, 1.0], dtype=torch.float64))
    limit = 0.6 - torch.atan2(((b - e) * front).sum(-1), (b - e)[..., 1]).numpy()
    excess = pitches - limit
    excess = airs * (excess + np.sqrt(excess**2 + 0.01)) / 2
    pitches, toes = pitches - excess, toes - excess
    feet_q, toes_q = (torch.stack([_foot_rotation(yaws[:, i], x[:, i]) for i in (0, 1)], 1) for x in (pitches, toes))
    chain = torch.stack((local[:, :1].expand(-1, 2, 4), thigh, shin, feet_q, toes_q), 2)
    relative = R.multiply(R.inverse(chain[:, :, :-1]), chain[:, :, 1:])
    for i, name in enumerate(("Left", "Right")):
        local[:, [_J[name + part] for part in ("Hip", "Knee", "Ankle", "Toe")]] = relative[:, i]
    for side in SIDES:
        if style.arm(side).hand_at is not None:
            _pin_hand(local, hips, side, style.arm(side))
    return local.float(), hips.float()


def _foot_rotation(yaw: np.ndarray, pitch: np.ndarray) -> Tensor:
    return R.from_euler(torch.from_numpy(np.stack((yaw, -pitch, np.zeros_like(yaw)), -1)), "YXZ")


def _pin_hand(local: Tensor, hips: Tensor, side: str, arm: Arm) -> None:
    """Turn shoulder and elbow in place so that the wrist stays where `Arm.hand_at` says, in the hips' frame."""
    sign, name = (1.0 if side == "left" else -1.0), side.capitalize()
    turned, positions = forward_kinematics(SKELETON, local, hips)
    shoulder, elbow, wrist = (_J[name + part] for part in ("Shoulder", "Elbow", "Wrist"))
    outwards, up, front = arm.hand_at
    target = hips + R.rotate(local[:, 0], torch.tensor([sign * outwards, up, front], dtype=local.dtype))
    pole = R.rotate(local[:, 0], torch.tensor([sign * 0.7, 0.0, -1.0], dtype=local.dtype))
    b, c = two_bone(*(positions[:, j] for j in (shoulder, elbow, wrist)), target, pole)
    upper, lower = R.normalize(b - positions[:, shoulder]), R.normalize(c - b)
    x = sign * upper
    z = R.normalize(lower - (lower * upper).sum(-1, keepdim=True) * upper)
    world = R.from_matrix(torch.stack((x, torch.linalg.cross(z, x), z), -1))
    local[:, shoulder] = R.multiply(R.inverse(turned[:, _J[name + "Collar"]]), world)
    bend = torch.atan2((lower * z).sum(-1), (lower * upper).sum(-1))
    local[:, elbow] = R.yaw(-sign * bend)


def _truth(plan: _Plan, feet: dict[str, "_Foot"]) -> Truth:
    contacts, phase = np.zeros((len(plan.t), 2)), np.zeros((len(plan.t), 4))
    for i, side in enumerate(SIDES):
        arm = plan.style.arm(side)
        phase[:, i] = arm.ratio * plan.clock - math.radians(arm.phase) + math.pi * i
        phase[:, 2 + i] = feet[side].phase if side in feet else plan.clock
        if side in feet:
            contacts[:, 1 - i] = feet[side].contact
    frequency = np.gradient(phase, axis=0) * FPS / (2 * math.pi)
    return Truth(*(torch.from_numpy(x).float() for x in (contacts, phase, frequency)))
