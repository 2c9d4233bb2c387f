"""A scene: the shots of several characters, who can keep apart, in one JSON file."""

import functools
import heapq
import itertools
import math
import os
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
import torch
from torch import Tensor

from toolkit.evaluation.findings import OTHERS
from toolkit.extra.shots import apart as avoidance, following
from toolkit.extra.shots.following import FPS, LEAD, LONGEST, Course, Heading, Pair, nearest
from toolkit.extra.shots.keys import StyleKey, entries, number, pair
from toolkit.extra.shots.shot import Shot, parse, read
from toolkit.extra.shots.walking import first
from toolkit.motion import Clip
from toolkit.networks.bank import StyleBank
from toolkit.runtime import CharacterState, Command, pose, start, step, world_joints

WAIT = 0.4  # metres behind its plan at which the plan of a character who keeps apart waits
FASTER, SLOWEST = 1.3, 0.3  # times the planned speed, and m/s: such a character's largest speed
WAITS = 4  # times the longest plan after which all end
AHEAD = 2.0  # metres of the path ahead at which a character who has left it aims
MARGIN = 0.5  # metres between a root and a wall
TRIED = 3 * FPS  # frames of the walk that shows the reach of a style
STANDS, QUEUE = 0.1, 2.0  # m/s and seconds: a style that does not stand, characters that jam


@dataclass(frozen=True)
class Wall:
    """A straight wall between two different points (x, z), metres."""

    start: tuple[float, float]
    end: tuple[float, float]

    def __post_init__(self):
        for name in ("start", "end"):
            object.__setattr__(self, name, pair(getattr(self, name), name))
        if math.dist(self.start, self.end) < 0.01:
            raise ValueError("start and end are less than 1 cm apart")


@dataclass(frozen=True)
class Scene:
    """The shots of several characters.

    ValueError if a field is not as described, or two characters who keep apart start closer.

    Parameters
    ----------
    shots : one `Shot` per character
    apart
        Least distance of two characters' roots, metres: they leave their paths to keep it, and wait
        where they cannot. A shot's ``radius`` takes the place of half of it. By default they do not
        see each other.
    walls : `Wall`, or pairs of its ends, that are avoided; only with ``apart``
    """

    shots: Sequence[Shot]
    apart: float | None = None
    walls: Sequence[Wall] = ()

    def __post_init__(self):
        put = functools.partial(object.__setattr__, self)
        put("shots", entries(self.shots, Shot, "shots"))
        put("walls", entries(self.walls, Wall, "walls"))
        if not self.shots:
            raise ValueError("shots: one or more are needed")
        if self.apart is None:
            if self.walls:
                raise ValueError("walls are only avoided by characters who keep apart: give "
                                 "apart, metres")
            return
        put("apart", number(self.apart, "apart", 0.1, 5.0))
        firsts, radii = [(shot.path[0].x, shot.path[0].z) for shot in self.shots], self.radii
        for b in range(len(firsts)):
            for a in range(b):
                room, least = math.dist(firsts[a], firsts[b]), radii[a] + radii[b]
                if room < least:
                    raise ValueError(f"shots[{a}] and shots[{b}] start {room:.2f} m from each "
                                     f"other, closer than the {least:.2f} m that they keep")

    def _called(self, k: int) -> str:
        """A shot in a message: its number, and its name if it has one."""
        name = self.shots[k].name
        return f"shots[{k}]" + f" ({name})" * (name != "shot")

    @property
    def radii(self) -> list[float]:
        """The share of each character in the distance of two who keep apart."""
        return [shot.radius or self.apart / 2 for shot in self.shots]

    def spaced(self, model, bank: StyleBank, bodies: float = 0.3) -> "Scene":
        """The scene with a radius for each character, so that bodies are so many metres apart.

        The radius is the reach of the joints of the styles, tried in a short walk, and half of
        ``bodies``.
        """
        tried = self._tried(model, bank)
        radii = [max(reach for j, _, reach, _ in tried if j == k) + bodies / 2
                 for k in range(len(self.shots))]
        shots = [replace(shot, radius=round(r, 2))
                 for shot, r in zip(self.shots, radii, strict=True)]
        return replace(self, shots=shots)

    def _tried(self, model, bank: StyleBank) -> list[tuple[int, StyleKey, float, float]]:
        """For each style key: the character, the key, the reach of its joints in a short walk,
        metres, and the speed at which it goes on after it is told to stand, m/s."""
        keys = [(k, key) for k, shot in enumerate(self.shots) for key in shot.styles]
        state = start(model, torch.stack([bank.blend(*key.layers) for _, key in keys]))
        ahead = state.root.new_tensor([[0.0, bank.speed(key.layers[0])] for _, key in keys])
        places, far = [], 0 * ahead[:, 0]
        for frame in range(3 * TRIED):
            places.append(state.root[:, :2])
            with torch.no_grad():
                state = step(model, state, Command(ahead * (frame < TRIED)))
            if TRIED // 3 < frame < TRIED:
                joints = world_joints(state.joints, state.root)["position"][..., [0, 2]]
                away = joints - state.root[:, None, :2]
                far = far.maximum(away.norm(dim=-1).amax(1))
        drift = (places[-1] - places[2 * TRIED]).norm(dim=-1) * FPS / TRIED
        return [(*key, *measured)
                for key, *measured in zip(keys, far.tolist(), drift.tolist(), strict=True)]

    def check(self, model, bank: StyleBank) -> list[str]:
        """What cannot be met and why, a line each.

        `Shot.check` of each; of those who keep apart, styles that cannot stand or that reach into
        others, ends that are too close, and gaps between walls that are too narrow or to which too
        many come at once.
        """
        lines = []
        for k, shot in enumerate(self.shots):
            try:
                shot.style(bank)
                if self.apart is None:
                    lines += [f"{self._called(k)}: {line}" for line in shot.check(model, bank)]
            except ValueError as error:
                raise ValueError(f"shots[{k}]: {error}") from None
        if self.apart is None:
            return lines

        # styles that cannot wait, or reach into others, and ends that two cannot both reach
        goals, radii = [(shot.path[-1].x, shot.path[-1].z) for shot in self.shots], self.radii
        for k, key, reach, speed in self._tried(model, bank):
            who = f"{self._called(k)}: {' + '.join(key.layers[0])}"
            if speed > STANDS:
                lines.append(f"{who} goes on at {speed:.2f} m/s when it is told to stand: it "
                             "cannot wait")
            room = radii[k] + min(radii[:k] + radii[k + 1:], default=math.inf)
            if reach + OTHERS["limb", "trunk"] > room:
                lines.append(f"{who} reaches {reach:.2f} m and keeps {room:.2f} m: its limbs may "
                             "go through others; `shot --bodies 0.1` gives it room")
        for j, k in itertools.combinations(range(len(goals)), 2):
            if (room := math.dist(goals[j], goals[k])) < radii[j] + radii[k]:
                lines.append(f"{self._called(j)} and {self._called(k)} end {room:.2f} m apart and "
                             f"keep {radii[j] + radii[k]:.2f} m: they do not both arrive")
        return lines + self._gaps(bank)

    def _gaps(self, bank: StyleBank) -> list[str]:
        """Gaps between walls that are too narrow, or to which too many come at once."""
        lines, radii = [], self.radii
        courses, widest = [shot.plan(bank)[0] for shot in self.shots], sum(sorted(radii)[-2:])
        for (a, one), (b, other) in itertools.combinations(enumerate(self.walls), 2):
            ends = min(itertools.product((one.start, one.end), (other.start, other.end)),
                       key=lambda pair: math.dist(*pair))
            room = math.dist(*ends)
            between = f"between walls[{a}] and walls[{b}] are {room:.2f} m"
            if room < 2 * MARGIN:
                if room > 0.01:  # walls that do not meet
                    lines.append(f"{between}: too narrow, characters keep {MARGIN:g} m from a wall")
                continue
            if room < 2 * MARGIN + widest and len(self.shots) > 1:
                lines.append(f"{between}: too narrow for two of the widest at once, who need "
                             f"{2 * MARGIN + widest:.2f} m")
            wait = self._queue(courses, ends, 1 + int((room - 2 * MARGIN) / widest))
            if wait > QUEUE:
                lines.append(f"{between}: those who come at once would wait for up to {wait:.0f} "
                             "s, and may touch; let them start one after another, with holds")
        return lines

    def _queue(self, courses: list[Course], ends: tuple[Pair, Pair], lanes: int) -> float:
        """Longest wait for those who cross the line between two places before, seconds."""
        # when each one crosses the line, and for how long
        (x, z), (to_x, to_z) = ends
        way_x, way_z, crossed = to_x - x, to_z - z, []
        for course, share in zip(courses, self.radii, strict=True):
            off_x, off_z = np.array(course.curve.x) - x, np.array(course.curve.z) - z
            side = way_x * off_z - way_z * off_x
            along = (way_x * off_x + way_z * off_z) / (way_x**2 + way_z**2)
            through = (side[1:] * side[:-1] <= 0) & (along[1:] > 0) & (along[1:] < 1)
            for k in np.flatnonzero(through)[:1]:
                if course.distance[-1] >= course.curve.at[k]:
                    frame = bisect_left(course.distance, course.curve.at[k])
                    crossed.append((frame / FPS, 2 * share / max(course.speed[frame], SLOWEST)))

        # each takes the lane that is free first
        waits, free = [0.0], [0.0] * lanes
        for time, takes in sorted(crossed):
            now = max(time, heapq.heappop(free))
            waits.append(now - time)
            heapq.heappush(free, now + takes)
        return max(waits)

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Scene":
        """The scene of a JSON file; a ValueError of one line if it is not valid."""
        return read(path, cls.parse)

    @classmethod
    def parse(cls, scene) -> "Scene":
        """A scene from a dictionary as a JSON file holds it."""
        shots = parse(scene)
        return cls(shots, scene.get("apart"), scene.get("walls", ()))

    def states(self, model, bank: StyleBank, plans: Sequence[tuple[Course, Heading]] | None = None
               ) -> Iterator[CharacterState]:
        """Yield the state of all characters together at every frame, until all plans have ended.

        Where they keep apart, the plan of a character waits while others hold the character up for
        more than `WAIT`.
        """
        plans = [shot.plan(bank) for shot in self.shots] if plans is None else plans
        styles = [shot.style(bank, model.life) for shot in self.shots]
        state, clocks = first(model, self.shots, styles, plans), [0] * len(plans)
        lasts = [len(course.distance) - 1 for course, _ in plans]
        most = max(lasts) if self.apart is None else min(WAITS * max(lasts), round(LONGEST * FPS))
        for _ in range(most):
            if all(clock >= last for clock, last in zip(clocks, lasts, strict=True)):
                return
            places = [tuple(place) for place in state.root[:, :2].tolist()]
            asked = [following.command(*plan, clock, place)
                     for plan, clock, place in zip(plans, clocks, places, strict=True)]
            velocities, facings = (np.array(pairs) for pairs in zip(*asked, strict=True))
            held = [False] * len(plans)
            if self.apart is not None:
                aims = [_aimed(course, *at) for (course, _), *at in zip(
                    plans, clocks, places, velocities, strict=True)]
                wanted, held = zip(*aims, strict=True)
                velocities = self._kept(state, plans, clocks, np.array(wanted))
            vectors = torch.stack([style(clock)
                                   for style, clock in zip(styles, clocks, strict=True)])
            clocks = [clock + (not waits) for clock, waits in zip(clocks, held, strict=True)]
            with torch.no_grad():
                state = step(model, state.with_style(vectors),
                             Command(*map(torch.from_numpy, (velocities, facings))))
            if self.apart is not None:
                state = self._parted(state)
            yield state

    @property
    def _walls(self) -> np.ndarray:
        return np.array([(wall.start, wall.end) for wall in self.walls]).reshape(-1, 2, 2)

    def _parted(self, state: CharacterState) -> CharacterState:
        """The state with roots moved apart where they are too close; toes in contact stay."""
        places = state.root[:, :2].double().numpy()
        moved = avoidance.parted(places, np.array(self.radii), self._walls, MARGIN)
        shift = torch.from_numpy(moved - places).to(state.root)
        history, future = state.history.clone(), state.future.clone()
        history[:, -1, :2] += shift
        future[..., :2] += shift[:, None]
        return replace(state, history=history, future=future)

    def _kept(self, state: CharacterState, plans, clocks: list[int],
              wanted: np.ndarray) -> np.ndarray:
        """Velocities ``[N, 2]`` that keep the characters apart and off the walls."""
        speeds = [max(course.speed[min(clock, len(course.speed) - 1)], SLOWEST)
                  for (course, _), clock in zip(plans, clocks, strict=True)]
        most = FASTER * np.array(speeds)[:, None]
        places, moving = (values.double().numpy() for values in (state.root[:, :2], state.velocity))
        safe = avoidance.velocities(places, moving, _limited(wanted, most), np.array(self.radii),
                                    self._walls, MARGIN)
        return _limited(safe, most)

    def render(self, model, bank: StyleBank) -> list[Clip]:
        """The motion of each character, see `Shot.render`; those who keep apart are rendered
        together, at one length.
        """
        if self.apart is None:
            return [shot.render(model, bank) for shot in self.shots]
        plans = [shot.plan(bank) for shot in self.shots]
        # drawn at once, as a state is five times as large as a pose
        drawn = [self._pose(model, state) for state in self.states(model, bank, plans)]
        rotations, roots = (torch.stack(parts, 1) for parts in zip(*drawn, strict=True))
        return [shot.pinned(model, turns, path, course) for turns, path, shot, (course, _) in zip(
            rotations, roots, self.shots, plans, strict=True)]

    @torch.no_grad()
    def _pose(self, model, state: CharacterState) -> tuple[Tensor, Tensor]:
        """The pose of every character, each with its own IK."""
        wanted = [(shot.feet, shot.arms) for shot in self.shots]
        made = {kind: pose(model, state, feet=kind[0], arms=kind[1]) for kind in set(wanted)}
        return tuple(torch.stack([made[kind][part][k] for k, kind in enumerate(wanted)])
                     for part in (0, 1))


def _aimed(course: Course, clock: int, place: Pair, asked: np.ndarray) -> tuple[Pair, bool]:
    """The velocity that a character wants who may have left the path; whether others hold it up.

    It goes to a place on the path `AHEAD`. If it went back to the nearest one, it would push those
    for whom it made room, and all would stop.
    """
    clock = min(clock, len(course.distance) - 1)
    here = nearest(course.curve, place, course.distance[clock])
    held = course.distance[clock] - here > WAIT
    if course.speed[min(clock + round(LEAD * FPS), len(course.speed) - 1)] == 0:
        return tuple(asked), held
    x, z = course.curve.point(here + AHEAD)
    x, z = x - place[0], z - place[1]
    share = max(x * asked[0] + z * asked[1], 0.0) / max(x * x + z * z, 1e-12)
    return (share * x, share * z), held


def _limited(velocities: np.ndarray, most: np.ndarray) -> np.ndarray:
    speeds = np.linalg.norm(velocities, axis=-1, keepdims=True)
    return velocities * np.minimum(most / np.maximum(speeds, 1e-9), 1.0)
