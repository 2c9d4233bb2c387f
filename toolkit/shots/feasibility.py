"""What a shot asks for and a character cannot do, before and after it is tried."""

import math
from collections.abc import Callable

from toolkit.shots.course import FPS, Course, nearest

FASTER = 1.5  # times its natural speed that a style is asked for at most
TURN, SIDEWAYS = math.radians(150), 3.0  # largest turn of the path, rad/s, and acceleration across it, m/s²
REACH, SLOW = 0.1, 0.05  # metres to both sides, to measure a turn; m/s that are as good as standing
SECONDS, NEAR, BESIDE = 0.2, 0.15, 0.10  # limits of arrivals, s and m, and of the mean distance from the path, m


def planned(course: Course, natural: Callable[[float], float]) -> list[str]:
    """Where the plan asks most beyond the style, in speed and in turning; ``natural`` is the natural speed at a time."""
    fast, tight = (FASTER, ""), (1.0, "")
    for frame in range(1, len(course.distance)):
        now, at, speed = frame / FPS, course.distance[frame], course.speed[frame]
        if speed < SLOW:
            continue
        if (over := speed / max(natural(now), SLOW)) > fast[0]:
            fast = over, (f"at {now:.1f} s the speed is {speed:.2f} m/s, {over:.1f} times the natural speed of the style: "
                          "slow down, leave more time, or choose a faster style")
        (ax, az), (bx, bz) = course.curve.tangent(at - REACH), course.curve.tangent(at + REACH)
        bend = abs(math.atan2(ax * bz - az * bx, ax * bx + az * bz)) / (2 * REACH)
        if (over := max(bend * speed / TURN, bend * speed * speed / SIDEWAYS)) > tight[0]:
            tight = over, (f"at {now:.1f} s, after {at:.1f} m, the turn is too tight: radius {1 / bend:.2f} m at "
                           f"{speed:.2f} m/s; widen the path or slow down there")
    return [line for _, line in (fast, tight) if line]


def walked(course: Course, arrivals: list[tuple[int, float, float]], places: list[tuple[float, float]]) -> list[str]:
    """What a character missed: ``arrivals`` are (point, distance along the curve, time), ``places`` its roots by frame."""
    found = []
    apart = beside(course, places)
    if (mean := sum(apart) / len(apart)) > BESIDE:
        found.append(f"the character is {100 * mean:.0f} cm from the path on average, {100 * max(apart):.0f} cm at most")
    for point, distance, time in arrivals:
        if round(time * FPS) > len(places) + 1:
            continue
        seconds, metres = arrival(course.curve.point(distance), time, places)
        if abs(seconds) > SECONDS or metres > NEAR:
            late = f"{abs(seconds):.2f} s {'late' if seconds > 0 else 'early'}, " if abs(seconds) > SECONDS else ""
            found.append(f"path[{point}], asked for at {time:g} s, is met {late}{100 * metres:.0f} cm away")
    return found


def beside(course: Course, places: list[tuple[float, float]]) -> list[float]:
    """Distance from the curve of each place, metres; ``places[0]`` is that of frame 1."""
    apart = []
    for frame, (x, z) in enumerate(places, 1):
        px, pz = course.curve.point(nearest(course.curve, (x, z), course.distance[min(frame, len(course.distance) - 1)]))
        apart.append(math.hypot(px - x, pz - z))
    return apart


def arrival(goal: tuple[float, float], time: float, places: list[tuple[float, float]]) -> tuple[float, float]:
    """When a character is within `NEAR` of a place, seconds after ``time``, and how near it comes within `SECONDS` of it.

    Only places within two seconds of the time count. The first number is 0 if the character is `NEAR` within `SECONDS`, and
    infinite if it never is.
    """
    apart = [math.hypot(x - goal[0], z - goal[1]) for x, z in places]
    first, last = (max(round((time + s) * FPS) - 1, 0) for s in (-SECONDS, SECONDS))
    nearby = min(apart[first : last + 1], default=math.inf)
    if nearby <= NEAR:
        return 0.0, nearby
    first, last = max(round((time - 2) * FPS), 0), min(round((time + 2) * FPS), len(apart))
    around = [k for k in range(first, last) if apart[k] <= NEAR]
    return (min(((k + 1) / FPS - time for k in around), key=abs) if around else math.inf), nearby
