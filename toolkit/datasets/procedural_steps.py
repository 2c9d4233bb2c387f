"""Procedural footsteps along a path: times and places of the stances, and motion of the feet.

Arrays are NumPy's, over F frames. Times are in frames at 60 Hz, headings and yaw in radians.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
import torch
from numpy.typing import ArrayLike
from torch import Tensor

from toolkit.datasets.procedural_styles import Leg, Style
from toolkit.motion.roles import SIDES
from toolkit.motion.tensors import summary

FPS = 60
FOOT = (0.0, -0.097, 0.192)  # from the ankle to the toe joint
HEEL = -0.05  # from the ankle back to where the heel touches
TOE = 0.021  # height of a standing toe joint
# largest horizontal distance of ankle and hips: at strike, at lift-off, extra with heel raised
REACH = (0.45, 0.48, 0.14)
SWING = 0.55  # seconds, longest swing: slower walking has longer stances
RUN_STANCE = 0.38  # share of the stride that a foot stands when running
BACKWARDS, SIDEWAYS = 0.65, 0.5  # usual speeds, divided by that of walking forwards


def smooth(x: np.ndarray, sigma: float) -> np.ndarray:
    """Gaussian filter over the first axis, `sigma` in frames.

    The first and last values are repeated beyond the ends.
    """
    half = math.ceil(3 * sigma)
    kernel = np.exp(-0.5 * (np.arange(-half, half + 1) / sigma) ** 2)
    kernel = kernel / kernel.sum()
    flat = np.pad(x.reshape(len(x), -1), ((half, half), (0, 0)), mode="edge")
    out = np.stack([np.convolve(column, kernel, mode="valid") for column in flat.T], 1)
    return out.reshape(x.shape)


def smooth_noise(rng: np.random.Generator, frames: int, sigma: float, channels: int) -> np.ndarray:
    """Smoothed Gaussian noise ``[frames, channels]`` of unit deviation; `sigma` in frames."""
    half = math.ceil(3 * sigma)
    white = rng.standard_normal((frames + 2 * half, channels))
    scale = math.sqrt(2 * math.sqrt(math.pi) * sigma)
    return smooth(white, sigma)[half : half + frames] * scale


def _curve(t: np.ndarray, times: Sequence[np.ndarray], values: ArrayLike,
           stop: float | None = None) -> np.ndarray:
    """Monotone cubic interpolation at ``t``, constant before the first and after the last time.

    ``values`` [N, K] or [K] are those at K times [N] each. With ``stop`` the curve is constant from
    that time on.
    """
    times = np.stack(times, 1)
    values = np.broadcast_to(values, times.shape)
    spline = scipy.interpolate.PchipInterpolator(times.ravel(), values.ravel())
    return spline(np.clip(t, times[0, 0], times[-1, -1] if stop is None else stop))


class Plan:
    """Pace, stride phase (``clock``) and footsteps along a path of F frames."""

    def __init__(self, style: Style, root: np.ndarray, rng: np.random.Generator):
        self.style, self.rng = style, rng
        self.root = root = smooth(root, 4)
        self.t = np.arange(len(root), dtype=np.float64)

        # velocity in the character's frame, m/s
        c, s = np.cos(root[:, 2]), np.sin(root[:, 2])
        step = np.gradient(root, axis=0) * FPS
        self.sideways = step[:, 0] * c - step[:, 1] * s
        self.ahead = step[:, 0] * s + step[:, 1] * c
        self.turning = step[:, 2]
        self.speed = np.hypot(self.sideways, self.ahead)

        # pace: speed divided by what is usual in this direction; from 1.3 to 1.9 it becomes a run
        along = np.ones_like(self.speed)
        np.divide(self.ahead, self.speed, out=along, where=self.speed > 1e-6)
        slower = np.where(along < 0, BACKWARDS, 1.0)
        usual = np.hypot(along * slower, (1 - along**2) ** 0.5 * SIDEWAYS)
        self.pace = self.speed / (style.speed * usual)
        x = np.clip((self.pace - 1.3) / 0.6, 0, 1)
        self.running = smooth(x * x * (3 - 2 * x), 4)

        # the steps
        self.stepping = [side for side in SIDES if not style.leg(side).raised]
        duty = np.mean([style.leg(side).stance for side in self.stepping])
        airborne = 1 - duty + self.running * max(0.0, duty - RUN_STANCE)
        self.middle = math.pi * airborne  # clock at the middle of a left swing
        tempo = np.exp(0.2 * style.stagger * smooth_noise(rng, len(root), 30, 1)[:, 0])

        # lift-off times: regular steps while the path moves, two more before standing; the clock is
        # 0 where the left foot lifts off and π where the right foot does
        sides, n = self.stepping, len(self.stepping)
        turn = int(rng.integers(n))
        t, clock, settled = 0.0, math.pi * turn, 0 if self.speed[0] > 0.05 else 2
        self.swings, knots = [], [(0.0, clock)]
        while t < len(root):
            look = min(int(t) + 12, len(root) - 1)
            moving = self.pace[look] > 0.12 or abs(self.turning[look]) > 0.25
            if not moving and settled >= 2:
                t += 1.0
                continue
            settled = 0 if moving else settled + 1

            # duration of a stride (hop) for the pace, and of its part for this foot
            pace, run, side = max(self.pace[look], 0.5), self.running[look], sides[turn % n]
            walk, fast = min(pace, 1.7) ** 0.55, 1.5 * (pace / 2.2) ** 0.35
            quicker = pace**0.25 if n == 1 else walk + run * (fast - walk)
            stride = FPS / (style.cadence * tempo[look] * quicker)
            beat = stride / n
            if n == 2:
                beat *= 1 + style.asymmetry * (1 if side == "left" else -1)
            if knots[-1][0] < t - 1e-6:  # the clock stood
                knots.append((t, clock))
            self.swings.append((side, t, stride, run))
            clock += 2 * math.pi / n
            t += beat
            knots.append((t, clock))
            turn += 1
        knots.append((t + len(root), clock))
        self.clock = smooth(scipy.interpolate.PchipInterpolator(*np.array(knots).T)(self.t), 3)

    def foot(self, side: str) -> "Foot":
        """Footsteps of one side, and the motion of the foot."""
        style, leg, sign = self.style, self.style.leg(side), 1 if side == "left" else -1
        never = (2.0 * len(self.t), FPS / style.cadence, 0.0)
        mine = np.array([swing[1:] for swing in self.swings if swing[0] == side] or [never])

        # lift-off and strike of N swings; begin, end and usual durations of the N + 1 stances
        off, stride, run = mine.T
        duty = leg.stance - run * max(0.0, leg.stance - RUN_STANCE)
        on = off + np.minimum(stride * (1 - duty), SWING * FPS)
        on[:-1] = np.minimum(on[:-1], off[1:] - 0.2 * stride[:-1])
        usual = np.concatenate((stride[:1] * duty[:1], stride * duty))
        begin = np.concatenate((off[:1] - usual[:1], on))
        end = np.concatenate((off, on[-1:] + usual[-1:]))
        if off[0] > len(self.t):
            begin[0] = -end[0]

        def at(track: np.ndarray) -> np.ndarray:
            return np.interp((begin + end) / 2, self.t, track)

        # the foot is under the hips in the middle of its stance; in a sidestep the feet stay apart
        x, z, facing = (at(column) for column in self.root.T)
        stride = np.concatenate((stride[:1], stride)) / FPS
        apart = np.maximum(style.width / 2, 0.06 + np.abs(at(self.sideways)) * stride / 3)
        unrest = 0.03 * style.noise + 0.06 * style.stagger
        scatter = unrest * self.rng.standard_normal((3, len(x)))
        speed = at(self.speed)
        along = at(self.ahead) / np.maximum(speed, 0.1)
        size = np.minimum(speed / 2 * stride / style.step, 1.2)
        # the raised heel lengthens the leg, so a foot is farther behind at lift-off than it is
        # ahead at strike
        front = leg.ahead - 0.045 * style.step * size * along + scatter[1]
        left = (sign * apart if len(self.stepping) == 2 else sign * 0.02) + scatter[0]
        yaw = facing + sign * math.radians(leg.turned_out) + 2 * scatter[2]
        c, s = np.cos(facing), np.sin(facing)
        ankles = np.stack((x + left * c + front * s, z - left * s + front * c), 1)

        # in sharp turns this may be out of the leg's reach: shorten the step …
        limits = REACH[0], REACH[1] + REACH[2] * np.maximum(along, 0)
        for _ in range(2):
            for when, limit in zip((begin, end), limits, strict=True):
                hips = np.stack([np.interp(when, self.t, v) for v in self.root.T[:2]], 1)
                away = ankles - hips
                far = np.hypot(*away.T)
                ankles -= away * (np.maximum(far - limit, 0) / np.maximum(far, 1e-6))[:, None]
        # … then land later and lift off earlier
        reached = np.linalg.norm(self.root[:, None, :2] - ankles, axis=2)
        for k, far in enumerate(reached.T):
            half = int(np.clip((begin[k] + end[k]) / 2, 0, len(self.t)))
            early = np.flatnonzero(far[max(int(begin[k]), 0) : half] > limits[0] + 0.03)
            late = np.flatnonzero(far[half : max(int(end[k]), 0)] > limits[1][k] + 0.03)
            begin[k] += early[-1] if len(early) else 0
            end[k] = half + late[0] if len(late) else end[k]

        toes = ankles + FOOT[2] * np.stack((np.sin(yaw), np.cos(yaw)), 1)
        prints = np.concatenate((toes, yaw[:, None]), 1)
        run = np.concatenate((run[:1], run))
        return Foot(self, leg, sign, _Stances(begin, end, usual, prints, along, size, run))


@dataclass(frozen=True)
class _Stances:
    """The N + 1 stances of a foot, with a swing between each two."""

    begin: np.ndarray  # frames
    end: np.ndarray
    usual: np.ndarray  # duration in an even walk, frames
    prints: np.ndarray  # [N + 1, 3] x and z of the toe joint, yaw
    along: np.ndarray  # 1: forwards, -1: backwards
    size: np.ndarray  # of the step, divided by the usual one
    run: np.ndarray  # 1: running


class Foot:
    """Motion of a foot: ``toe`` position [F, 3], ``yaw``, ``pitch``, ``contact`` and ``phase`` [F].

    Also [F], from 0 to 1: ``flatness`` of the toes, and in a swing ``air``, ``kick`` and ``slack``
    (how much the leg may miss this position).
    """

    def __init__(self, plan: Plan, leg: Leg, sign: int, stances: _Stances):
        t, begin, end, usual = plan.t, stances.begin, stances.end, stances.usual
        prints, along, size, run = stances.prints, stances.along, stances.size, stances.run

        # the stance before the swing, or the one stood in; time in the swing from 0 to 1
        here = np.searchsorted(end[:-1], t, side="right")
        before = np.maximum(here - 1, 0)
        stance = np.minimum(usual, end - begin)
        settled = begin + 0.1 * stance  # the toes reach the floor after the heel
        landing = settled[np.minimum(before + 1, len(begin) - 1)]
        u = np.clip((t - end[before]) / (landing - end[before]), 0, 1)
        u = np.where(here == 0, 1.0, u)
        ease = u**3 * (10 - 15 * u + 6 * u * u)
        place = prints[before] + (prints[here] - prints[before]) * ease[:, None]
        place[here == 0] = prints[0]

        # pitch, positive with toes up: heel strike, flat, push-off; backwards the toes land first
        # and the heel last
        forwards, backwards = np.maximum(along, 0), np.maximum(-along, 0)
        toes_first = max(14 - leg.tiptoe / 3, 0)
        strike = size * (leg.heel_strike * forwards * (1 - 0.9 * run) - toes_first * backwards)
        share = 0.35 + 0.65 * forwards - 0.2 * backwards
        push = leg.toe_off * size**0.7 * share * (1 + 0.25 * run)
        lift_off = -0.5 * push * (1 - backwards)
        flat = np.full_like(size, -leg.tiptoe)
        swing = np.append(begin[1:] - end[:-1], usual[-1])
        nexts = np.append(strike[1:], 0.0)
        # share of the stance until the foot is flat
        roll = 0.1 + 0.18 * np.minimum(np.abs(strike) / 18, 1)
        knots = (begin, begin + roll * stance, end - 0.22 * stance, end, end + 0.25 * swing,
                 end + 0.52 * swing, end + 0.92 * swing)
        angles = (strike + flat, flat, flat, np.minimum(flat * 0.5 + lift_off, flat),
                  flat * 0.2 - push, flat * 0.7 - 0.65 * push, flat + nexts)
        self.pitch = np.radians(smooth(_curve(t, knots, np.stack(angles, 1)), 2.0))

        # toes straighten in the swing, when the leg may also miss the planned place
        knots = begin, end, end + 0.45 * swing, end + 0.9 * swing
        self.flatness = _curve(t, knots, [1.0, 1.0, 0.1, 1.0], stop=end[-1])
        knots = end + 0.12 * swing, end + 0.35 * swing, end + 0.6 * swing, end + 0.85 * swing
        self.slack = _curve(t, knots, [0.0, 1.0, 1.0, 0.0])

        def bump(peak: float) -> np.ndarray:
            """From 0 at both ends of the swing to 1 at time ``peak``."""
            w = u ** (math.log(0.5) / math.log(peak))
            return 16 * w**2 * (1 - w) ** 2

        height = (leg.lift * (1 - 0.6 * run) + 0.1 * run) * (0.7 + 0.3 * size)
        rise = height[here] * bump(0.5)
        out = sign * leg.circle * size[here] * bump(0.5)
        self.kick = (size * (1 - 0.55 * run))[here] * bump(0.72)

        # with the toes up the foot stands on its heel, and the toe joint rotates about the heel
        up = np.maximum(self.pitch, 0)
        wide = 0.1
        self.air = np.sin(math.pi * np.clip((u - 0.1) / 0.8, 0, 1)) ** 2
        up = np.where(up < wide, up * up / (2 * wide), up - wide / 2)
        up += self.air * ((self.pitch + np.sqrt(self.pitch**2 + 0.06)) / 2 - up)
        lever = FOOT[2] - HEEL
        back = lever * (np.cos(up) - 1)
        self.yaw = yaw = place[:, 2]
        c, s = np.cos(plan.root[:, 2]), np.sin(plan.root[:, 2])
        x = place[:, 0] + out * c + back * np.sin(yaw)
        z = place[:, 1] - out * s + back * np.cos(yaw)
        self.toe = np.stack((x, TOE + rise + lever * np.sin(up), z), 1)

        # contact: the toe is at an end of its swing, and stands still until the next frame
        still = np.linalg.norm(np.diff(self.toe, axis=0), axis=1) < 9e-4
        still = np.append(still[0], still)
        self.contact = ((u < 0.1) | (u > 0.9)) & still & (leg.kick * self.kick < 0.05)

        # phase: a multiple of 2π in the middle of each stance; a long stance holds its phase
        planted = begin + 0.9 * roll * stance
        pause = np.maximum((end - planted) / 2 - usual * 0.44, 0.0)
        middle = (planted + end) / 2
        cycle = 2 * math.pi * np.arange(len(begin))
        knots = np.stack((middle - pause, middle + pause, end + swing / 2), 1).ravel()
        values = np.stack((cycle, cycle, cycle + math.pi), 1).ravel()
        phase = smooth(np.interp(t, knots[:-1], values[:-1]), 3)
        self.phase = np.maximum.accumulate(phase)


@dataclass(frozen=True, eq=False)
class Truth:
    """True contacts and phases of a clip, known from its plan.

    ``contacts [F, 2]`` (right, left): 1 while the toe joint is planted, that is, moves less than a
    millimetre per frame. ``phase [F, 4]`` (left hand, right hand, left foot, right foot), radians,
    increasing: at multiples of 2π a foot is in the middle of its contact, and an arm is at its
    foremost. ``frequency [F, 4]``, Hz, is 0 while standing.
    """

    contacts: Tensor
    phase: Tensor
    frequency: Tensor
    __repr__ = summary


def record(plan: Plan, feet: dict[str, Foot]) -> Truth:
    """The truth about a clip, from its plan and its stepping feet."""
    contacts, phase = np.zeros((len(plan.t), 2)), np.zeros((len(plan.t), 4))
    for i, side in enumerate(SIDES):
        arm = plan.style.arm(side)
        lag = math.radians(arm.phase)
        phase[:, i] = arm.ratio * plan.clock - plan.middle - lag + math.pi * (i + 0.5)
        phase[:, 2 + i] = feet[side].phase if side in feet else plan.clock
        if side in feet:
            contacts[:, 1 - i] = feet[side].contact
    phase = np.maximum.accumulate(phase)
    frequency = np.gradient(phase, axis=0) * FPS / (2 * math.pi)
    return Truth(*(torch.from_numpy(x).float() for x in (contacts, phase, frequency)))
