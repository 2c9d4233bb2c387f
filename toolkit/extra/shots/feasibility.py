"""What a shot asks for and a character cannot do, before and after it is tried."""

import math
from collections.abc import Callable

from toolkit.extra.shots.following import FPS, Course, Pair, nearest

FASTER = 2.5  # times its natural speed: beyond it, a style falls behind or becomes a run
OFF, LAG = 0.25, 0.4  # metres beside the path, and behind or ahead of the plan, that are a miss
EASY = 0.2  # m/s² to the side: a turn that needs less is not why a character leaves its path
REACH, SLOW = 0.2, 0.05  # metres to both sides, to measure a turn; m/s that are as good as standing
# limits of arrivals, s and m, and of the mean distance from the path, m
SECONDS, NEAR, BESIDE = 0.2, 0.15, 0.10


def missed(course: Course, natural: Callable[[float], float], style: Callable[[float], str],
           places: list[Pair]) -> list[str]:
    """What a character missed and why, a line each.

    Parameters
    ----------
    course
        What was planned.
    natural
        Natural speed of the style at a time.
    style
        Its name.
    places
        The root at each frame, from frame 1 on.
    """
    apart, found = beside(course, places), []

    def ratio(frame: int) -> float:
        return course.speed[frame] / max(natural(frame / FPS), SLOW)

    fast = max(range(1, len(places) + 1), key=ratio)
    if ratio(fast) > FASTER:
        found.append(f"at {fast / FPS:.1f} s {_speed(course, ratio, fast)}: slow down or choose a "
                     "faster style")

    # too far from the path, in a pause or a turn of the last second or because of the style
    if max(apart) > OFF:
        worst = apart.index(max(apart))
        recent = range(max(worst + 1 - FPS, 1), worst + 2)
        turn = min(recent, key=lambda k: radius(course, course.distance[k]))
        stands = next((k for k in recent if course.speed[k] < SLOW
                       and 0 < course.distance[k] < course.curve.length), 0)
        at, speed = course.distance[turn], course.speed[turn]
        why = f"{style(worst / FPS)} does not keep to it; choose another style there"
        if stands:
            why = (f"it does not stand still in the pause after {course.distance[stands]:.1f} m; "
                   "slow down before it, or pause elsewhere")
        elif speed**2 > EASY * radius(course, at):
            why = (f"the turn after {at:.1f} m, of radius {radius(course, at):.1f} m, is too tight "
                   f"at {speed:.2f} m/s; widen it or slow down there")
        found.append(f"at {(worst + 1) / FPS:.1f} s the character is {100 * apart[worst]:.0f} cm "
                     f"from the path: {why}")
    elif (mean := sum(apart) / len(apart)) > BESIDE:
        found.append(f"the character is {100 * mean:.0f} cm from the path on average")

    # behind or ahead of the plan
    lags = [course.distance[k] - nearest(course.curve, place, course.distance[k])
            for k, place in enumerate(places, 1)]
    if late := next((k for k, lag in enumerate(lags, 1) if abs(lag) > LAG), 0):
        why = f"behind the plan: {_speed(course, ratio, late)}; slow down or leave more time"
        if lags[late - 1] < 0:
            why = (f"ahead of the plan: {style(late / FPS)} does not stand or walk as slowly; "
                   "choose another style there")
        found.append(f"from {late / FPS:.1f} s on the character is {why}")
    for name, distance, time in course.arrivals:
        if name.startswith("path") and round(time * FPS) <= len(places):
            seconds, metres = arrival(course.curve.point(distance), time, places)
            if seconds or metres > NEAR:
                when = f"{abs(seconds):.1f} s {'late' if seconds > 0 else 'early'}"
                when = "never" if seconds == math.inf else when
                found.append(f"{name} is met {when}: at {time:g} s the character is "
                             f"{100 * metres:.0f} cm away")
    return found


def _speed(course: Course, ratio: Callable[[int], float], frame: int) -> str:
    return (f"the speed is {course.speed[frame]:.2f} m/s, {ratio(frame):.1f} times that of the "
            "style")


def radius(course: Course, at: float) -> float:
    """Radius of the curve at an arc length, metres."""
    at = min(max(at, REACH), max(course.curve.length - REACH, REACH))
    (ax, az), (bx, bz) = course.curve.tangent(at - REACH), course.curve.tangent(at + REACH)
    return 2 * REACH / max(abs(math.atan2(ax * bz - az * bx, ax * bx + az * bz)), 1e-3)


def beside(course: Course, places: list[Pair]) -> list[float]:
    """Distance from the curve of each place, metres; ``places[0]`` is that of frame 1."""
    apart = []
    for frame, place in enumerate(places, 1):
        planned = course.distance[min(frame, len(course.distance) - 1)]
        apart.append(math.dist(course.curve.point(nearest(course.curve, place, planned)), place))
    return apart


def arrival(goal: Pair, time: float, places: list[Pair]) -> tuple[float, float]:
    """How late a character is within `NEAR` of a place, seconds after ``time``, and its least
    distance within `SECONDS` of that time.

    Only places within two seconds of the time count. The first number is 0 if the character is
    `NEAR` within `SECONDS`, and infinite if it never is.
    """
    apart = [math.dist(place, goal) for place in places]
    first, last = (max(round((time + s) * FPS) - 1, 0) for s in (-SECONDS, SECONDS))
    nearby = min(apart[first : last + 1], default=math.inf)
    if nearby <= NEAR:
        return 0.0, nearby
    first, last = max(round((time - 2) * FPS), 0), min(round((time + 2) * FPS), len(apart))
    around = [k for k in range(first, last) if apart[k] <= NEAR]
    return (min(((k + 1) / FPS - time for k in around), key=abs) if around else math.inf), nearby
