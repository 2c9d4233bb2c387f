"""The rules of a shot: its curve, its timing and the feedback that keeps a character on both.

Plain double-precision arithmetic of numbers and lists; `view/scene/course.js` computes the same,
function by function. Metres, seconds, (x, z) on the floor; a table has one row per frame at 60 Hz.
"""

import math
from bisect import bisect_right
from collections.abc import Sequence
from itertools import pairwise

from toolkit.styles.transitions import EASINGS

FPS = 60
SPACING = 0.05  # metres between the points of a sampled curve
ACCELERATION = 1.5  # m/s², of the planned speed
SETTLE = 1.0  # seconds of standing at the end of a shot without a duration
LONGEST = 600.0  # seconds of a shot
# seconds that the commanded velocity and facing are ahead of the plan: the delay of the runtime
LEAD = 0.35
ALONG, ACROSS = 4.0, 8.0  # 1/s: gains of the distances behind the plan and beside the curve
# metres of the curve, around the planned place, on which a character is searched
BEHIND, BEFORE = 1.5, 0.5
FASTEST = 64.0  # largest scale of the speeds, for an arrival time
LARGEST, GENTLE = 2.0, 0.25  # m/s, of the correction; of one where the plan stands
# share of the gains that is left where the plan stands: with all, a character went to and fro
STANDING = 0.5
NEAR = 0.06  # metres: a standing character that is as close to its place is left alone

Pair = tuple[float, float]
Keys = tuple[Sequence[float], Sequence[float], Sequence[str]]  # times, values and easings


def keyed(keys: Keys, now: float) -> float:
    """The value of keys at a time, see `between`."""
    times, values, easings = keys
    a, b, weight = between(times, easings, now)
    return values[a] + weight * (values[b] - values[a])


def between(times: Sequence[float], easings: Sequence[str], now: float) -> tuple[int, int, float]:
    """Two keys and the weight of the second at a time; constant beyond the first and the last key.

    The easing of a key is that of the way to the next one.
    """
    key = bisect_right(times, now) - 1
    if key < 0 or key == len(times) - 1:
        return max(key, 0), max(key, 0), 0.0
    return key, key + 1, EASINGS[easings[key]]((now - times[key]) / (times[key + 1] - times[key]))


class Curve:
    """A curve through points, sampled every `SPACING`: ``x``, ``z`` and arc length ``at`` of each.

    Smooth: cubic Hermite segments over the chord lengths, with the tangent of the parabola through
    three neighbouring points (Overhauser 1968; a non-uniform Catmull-Rom spline). Otherwise
    straight lines. ``knots``: arc lengths of the points.
    """

    def __init__(self, points: Sequence[Pair], smooth: bool):
        chords = [math.dist(a, b) for a, b in pairwise(points)]
        slopes = [[(b[i] - a[i]) / d for i in (0, 1)]
                  for (a, b), d in zip(pairwise(points), chords, strict=True)]
        tangents = [slopes[0]]
        for k in range(1, len(chords)):
            before, after = chords[k - 1], chords[k]
            tangents.append([(slopes[k - 1][i] * after + slopes[k][i] * before) / (before + after)
                             for i in (0, 1)])
        tangents.append(slopes[-1])
        if len(chords) > 1:
            tangents[0] = [2 * slopes[0][i] - tangents[1][i] for i in (0, 1)]
            tangents[-1] = [2 * slopes[-1][i] - tangents[-2][i] for i in (0, 1)]
        self.x, self.z, self.at, self.knots = [points[0][0]], [points[0][1]], [0.0], [0.0]
        for k, chord in enumerate(chords):
            steps = math.ceil(chord / SPACING - 1e-9)
            for step in range(1, steps + 1):
                t = step / steps
                u = 1 - t
                x, z = (self._blend(points[k][i], points[k + 1][i], tangents[k][i] * chord,
                                    tangents[k + 1][i] * chord, t, u)
                        if smooth else u * points[k][i] + t * points[k + 1][i] for i in (0, 1))
                self.at.append(self.at[-1] + math.hypot(x - self.x[-1], z - self.z[-1]))
                self.x.append(x)
                self.z.append(z)
            self.knots.append(self.at[-1])
        self.length = self.at[-1]

    @staticmethod
    def _blend(a: float, b: float, at_a: float, at_b: float, t: float, u: float) -> float:
        return u * u * (1 + 2 * t) * a + t * t * (1 + 2 * u) * b + u * t * (u * at_a - t * at_b)

    def point(self, distance: float) -> Pair:
        """The place at an arc length; the ends beyond them."""
        if distance >= self.length:
            return self.x[-1], self.z[-1]
        k = max(bisect_right(self.at, distance), 1)
        share = max(distance - self.at[k - 1], 0.0) / (self.at[k] - self.at[k - 1])
        return (self.x[k - 1] + share * (self.x[k] - self.x[k - 1]),
                self.z[k - 1] + share * (self.z[k] - self.z[k - 1]))

    def tangent(self, distance: float) -> Pair:
        """The unit direction at an arc length."""
        distance = min(max(distance, 0.0), self.length)
        ax, az = self.point(max(distance - SPACING, 0.0))
        bx, bz = self.point(distance + SPACING)
        size = max(math.hypot(bx - ax, bz - az), 1e-12)
        return (bx - ax) / size, (bz - az) / size


class Course:
    """Where a character should be: ``distance`` along the curve and ``speed`` of every frame.

    Parameters
    ----------
    curve : the curve to walk
    speeds : the speed keys, see `keyed`
    arrivals
        (name, distance, time) of the points that have a time, in order. The speed on the way there
        is scaled so that they are met.
    holds : (time or None, distance or None, seconds) of the pauses
    duration : seconds, or None: until the end of the curve is reached, and `SETTLE` more
    """

    def __init__(self, curve: Curve, speeds: Keys, arrivals: Sequence[tuple[str, float, float]],
                 holds: Sequence[tuple[float | None, float | None, float]],
                 duration: float | None):
        self.curve, self.speeds, self.arrivals = curve, speeds, arrivals
        pauses = sorted((time, seconds) for time, _, seconds in holds if time is not None)
        self.pauses = [*pauses, (math.inf, 0.0)]
        stops = [(min(at, curve.length), seconds) for _, at, seconds in holds if at is not None]
        self.stops = [*sorted(stops), (curve.length, math.inf)]
        self.distance, self.speed = [0.0], [0.0]
        # index of the next stop; time until which the character stands
        self._stop, self._until = 0, 0.0
        self.late: list[int] = []  # the arrivals that the acceleration does not allow
        for k, (_, distance, time) in enumerate(arrivals):
            slow, fast = 0.0, FASTEST
            if self._reaches(distance, fast, time):
                for _ in range(30):
                    middle = (slow + fast) / 2
                    if self._reaches(distance, middle, time):
                        fast = middle
                    else:
                        slow = middle
            else:
                self.late.append(k)
            self._walk(distance, fast, LONGEST)
        self._walk(curve.length, 1.0, LONGEST if duration is None else duration)
        arrived = self.distance[-1] >= curve.length - 1e-9
        self.end = (len(self.distance) - 1) / FPS if arrived else None
        if duration is None:
            duration = min(self.end + SETTLE, LONGEST) if arrived else LONGEST
        frames = round(duration * FPS) + 1
        rest = frames - len(self.distance)
        self.distance = [*self.distance, *[self.distance[-1]] * rest][:frames]
        self.speed = [*self.speed, *[0.0] * rest][:frames]

    def _reaches(self, goal: float, scale: float, latest: float) -> bool:
        """What `_walk` says; the plan stays as it is."""
        frames, stop, until = len(self.distance), self._stop, self._until
        reached = self._walk(goal, scale, latest)
        del self.distance[frames:], self.speed[frames:]
        self._stop, self._until = stop, until
        return reached

    def _walk(self, goal: float, scale: float, latest: float) -> bool:
        """Extend the plan to a distance, or to a time; whether the distance is reached."""
        distances, speeds = self.distance, self.speed
        at, speed, pause = distances[-1], speeds[-1], 0
        while at < goal - 1e-9:
            now = len(distances) / FPS
            if now > latest + 1e-9:
                return False
            limit, ends = self.stops[self._stop]
            speed = max(min(speed + ACCELERATION / FPS, scale * keyed(self.speeds, now)),
                        speed - 2 * ACCELERATION / FPS, 0.0)
            speed = min(speed, math.sqrt(2 * ACCELERATION * max(limit - at, 0.0)))
            while now >= sum(self.pauses[pause]):  # it has ended
                pause += 1
            speed = min(speed, ACCELERATION * max(self.pauses[pause][0] - now, 0.0))
            if now < self._until:
                speed = 0.0
            at = min(at + speed / FPS, limit)
            if at >= limit - 1e-9 and now >= self._until and self._stop < len(self.stops) - 1:
                self._until, self._stop = now + ends, self._stop + 1
            distances.append(at)
            speeds.append(speed)
        return True


def nearest(curve: Curve, place: Pair, distance: float) -> float:
    """Arc length of the curve's point nearest to a place, from `BEHIND` a distance to `BEFORE`."""
    first = max(bisect_right(curve.at, distance - BEHIND) - 1, 0)
    last = min(bisect_right(curve.at, distance + BEFORE), len(curve.at) - 1)
    best, least = distance, math.inf
    for k in range(first, last):
        ax, az, size = curve.x[k], curve.z[k], curve.at[k + 1] - curve.at[k]
        ux, uz = (curve.x[k + 1] - ax) / size, (curve.z[k + 1] - az) / size
        along = min(max((place[0] - ax) * ux + (place[1] - az) * uz, 0.0), size)
        apart = math.hypot(ax + along * ux - place[0], az + along * uz - place[1])
        if apart < least:
            best, least = curve.at[k] + along, apart
    return best


class Heading:
    """Where a character faces: along the curve, in a fixed ``direction``, or to a point ``look``.

    Angles are from +z to +x. ``turns`` are those of the curve's points, None for those without.
    Between two points, the difference from the rule changes linearly with the distance; it is zero
    at points without an angle.
    """

    def __init__(self, curve: Curve, direction: Pair | None, look: Pair | None,
                 turns: Sequence[float | None]):
        self.curve, self.direction, self.look = curve, direction, look
        self.offsets = [0.0 if angle is None
                        else math.remainder(angle - self._rule(at, curve.point(at)), math.tau)
                        for at, angle in zip(curve.knots, turns, strict=True)]

    def _rule(self, distance: float, place: Pair) -> float:
        if self.look is not None:
            return math.atan2(self.look[0] - place[0], self.look[1] - place[1])
        return math.atan2(*(self.direction or self.curve.tangent(distance)))

    def angle(self, distance: float, place: Pair) -> float:
        """The angle at an arc length, for a character at a place."""
        knots = self.curve.knots
        offset = keyed((knots, self.offsets, ["linear"] * len(knots)), distance)
        return self._rule(distance, place) + offset


def command(course: Course, heading: Heading, frame: int, place: Pair) -> tuple[Pair, Pair]:
    """Velocity and facing that keep a character to a course: the plan ahead, and feedback."""
    curve, last = course.curve, len(course.distance) - 1
    planned, ahead = course.distance[min(frame, last)], min(frame + round(LEAD * FPS), last)
    here = nearest(curve, place, planned)
    lead = here + course.distance[ahead] - planned
    angle = heading.angle(lead, place)
    facing = math.sin(angle), math.cos(angle)
    (x, z), (tx, tz) = curve.point(here), curve.tangent(lead)
    behind, across_x, across_z = planned - here, x - place[0], z - place[1]
    vx, vz = ALONG * behind * tx + ACROSS * across_x, ALONG * behind * tz + ACROSS * across_z
    stands = course.speed[ahead] == 0
    most, largest = (STANDING, GENTLE) if stands else (1.0, LARGEST)
    share = min(most, largest / max(math.hypot(vx, vz), 1e-12))
    if stands:
        share *= max(1 - NEAR / max(math.hypot(behind, across_x, across_z), 1e-12), 0.0)
    return (course.speed[ahead] * tx + share * vx, course.speed[ahead] * tz + share * vz), facing
