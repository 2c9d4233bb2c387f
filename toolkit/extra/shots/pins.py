"""Pins: hands, feet, the look or the whole pose of a walking character at given times.

`stations` moves the path to where a pinned place is within reach; `toolkit.extra.shots.reaching`
then changes the poses. `view/scene/pins.js` computes the same.
"""

import math
from collections.abc import Sequence

import torch
from torch import Tensor

from toolkit.extra.shots.following import EASINGS, FPS, Course, Heading, Pair
from toolkit.extra.shots.keys import HANDS, LIMBS, Pin, Point
from toolkit.motion import Clip, rotations as R

SETTLE = 0.4  # seconds of standing before a foot is lifted, and after
BLEND = 0.8  # seconds to a pin and back: a hand that moves 1 m has a tenth of the recorded jerk
# metres of a pinned hand before the hips and to its side, where the path is moved; of a foot
AHEAD, ASIDE, STEP, BESIDE = 0.5, 0.35, 0.3, 0.1
# metres of a place from the shoulder, and to its side, that need no other path
NEAR, CLOSE, ACROSS = 0.55, 0.3, 0.1
SHOULDER, LEAST = 0.19, 0.1  # metres to the side; between two points of a path
DETOUR = 2.0  # metres of a place beside the path, beyond which it is left out of the plan
PASSED = 0.25  # seconds: the character stops for a longer span
MISSED = 0.02  # metres beside a pin that `check` reports


def weights(pins: Sequence[Pin], part: str, times: Tensor) -> tuple[list[tuple[Pin, Tensor]],
                                                                    Tensor]:
    """The weight ``[F]`` of every pin of a part of the body at times ``[F]``, and of all.

    They are applied in order of time, each to the result of those before.
    """
    found, end, free = [], -math.inf, torch.ones_like(times)
    for pin in sorted((p for p in pins if getattr(p, part) is not None), key=lambda p: p.at):
        begin = max(pin.at - BLEND, end)
        into = (times - begin) / max(pin.at - begin, 1e-6)
        away = (pin.end + BLEND - times) / BLEND
        w = EASINGS["smoother"](torch.minimum(into, away).clamp(0.0, 1.0))
        found, end = [*found, (pin, w)], pin.end
        free = free * (1 - w)
    return found, 1 - free


Plan = tuple[Course, Heading]
Stop = tuple[str, Point, float]  # name, place and seconds of a pause


def stations(pins: Sequence[Pin], path: Sequence[Point], base: Plan, now: Plan) -> list[Stop]:
    """The points of a path, and those that pins need.

    ``base`` is the plan without pins, ``now`` the one whose headings count.
    """
    curve, knots = base[0].curve, {name: distance for name, distance, _ in now[0].arrivals}
    added, low = [], 0.0
    for k in sorted(range(len(pins)), key=lambda k: pins[k].at):
        pin, name = pins[k], f"pins[{k}]"
        limbs = [limb for limb in LIMBS if getattr(pin, limb) is not None]
        if not limbs:
            continue
        # where the path comes nearest to it, after those before, and how far before it to be
        goal = [sum(getattr(pin, limb)[i] for limb in limbs) / len(limbs) for i in (0, 2)]
        side = sum(1 if limb.startswith("left") else -1 for limb in limbs) / len(limbs)
        foot = not set(limbs) & set(HANDS)
        ahead, aside = (STEP, BESIDE * side) if foot else (AHEAD, ASIDE * side)
        distance = min((d for d in curve.at if d >= low),
                       key=lambda d: math.dist(curve.point(d), goal), default=low)
        far = math.dist(curve.point(distance), goal) > DETOUR
        distance = max(distance - ahead, low)
        if far or distance < LEAST:  # out of reach, or it starts there
            continue
        low = distance + LEAST

        # beside the path where the place would be on the wrong side or too far
        x, z = curve.point(distance)
        s, c = _facing(base, distance)
        left, before = (goal[0] - x) * c - (goal[1] - z) * s, (goal[0] - x) * s + (goal[1] - z) * c
        off = math.hypot(before, left - SHOULDER * side)
        if foot or side * left < ACROSS or not CLOSE <= off <= NEAR:
            s, c = _facing(now, knots[name]) if name in knots else (s, c)
            x, z = goal[0] - ahead * s - aside * c, goal[1] - ahead * c + aside * s
        taken = [*path, *(point for _, (_, point, _) in added)]
        while any(math.hypot(p.x - x, p.z - z) < LEAST for p in taken):
            x, z = x + LEAST * s, z + LEAST * c
        spare = BLEND + SETTLE if foot else 0.0
        time, pause = max(pin.at - spare, 1 / FPS), pin.end - pin.at + 2 * spare
        added.append((distance, (name, Point(x, z, time), pause if pause > PASSED else 0.0)))
    made = []
    for i, (point, until) in enumerate(zip(path, [*curve.knots[1:], math.inf], strict=True)):
        made.append((f"path[{i}]", point, 0.0))
        made += [new for d, new in added if curve.knots[i] <= d < until]
    return made


def _facing(plan: Plan, distance: float) -> Pair:
    angle = plan[1].angle(distance, plan[0].curve.point(distance))
    return math.sin(angle), math.cos(angle)


def missed(pins: Sequence[Pin], clip: Clip) -> list[str]:
    """The pins that a clip does not meet and why, a line each."""
    lines = []
    for k, pin in enumerate(pins):
        frames = [f for f in range(round(pin.at * FPS) - 1, round(pin.end * FPS)) if f >= 0]
        if not frames or frames[-1] >= len(clip):
            lines.append(f"pins[{k}] is at {pin.end:g} s, after the end of the motion")
            continue
        p = clip.global_positions[frames]
        for limb in LIMBS:
            if (goal := getattr(pin, limb)) is None:
                continue
            off = (p[:, clip.skeleton.role(limb)] - p.new_tensor(goal)).norm(dim=-1)
            if float(off.max()) > MISSED:
                start = "shoulder" if limb in HANDS else "hip"
                top = p[0, clip.skeleton.role(limb.replace("hand", start).replace("foot", start))]
                side = math.hypot(goal[0] - float(top[0]), goal[2] - float(top[2]))
                lines.append(f"pins[{k}]: the {limb.replace('_', ' ')} is "
                             f"{100 * float(off.max()):.0f} cm from its place, which is "
                             f"{goal[1]:.2f} m high and {side:.2f} m beside the {start} of the "
                             f"character at {pin.at:g} s: it is out of reach")
    return lines


def pose(clip: Clip, seconds: float) -> dict[str, tuple[float, ...]]:
    """The pose of a clip at a time, for a `Pin`: the rotation of every joint by its name.

    That of the hips is relative to where they face.
    """
    frame = min(max(round(seconds * clip.fps), 0), len(clip) - 1)
    turns, skeleton = clip.rotations[frame].double().clone(), clip.skeleton
    facing = R.rotate(turns[0], skeleton.facing_axis.to(turns))
    turns[0] = R.multiply(R.yaw(-torch.atan2(facing[0], facing[2])), turns[0])
    return {name: tuple(round(v, 5) for v in turns[j].tolist())
            for j, name in enumerate(skeleton.names) if not skeleton.is_end(j)}
