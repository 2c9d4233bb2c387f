"""A shot: what one character does, as data that a small JSON file holds."""

import functools
import json
import math
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from itertools import pairwise

import torch
from torch import Tensor

from toolkit.extra.shots import feasibility, following, pins, reaching
from toolkit.extra.shots.following import FPS, LONGEST, Course, Curve, Heading, Keys, Pair
from toolkit.extra.shots.keys import (
    FAST,
    Hold,
    Pin,
    Point,
    SpeedKey,
    StyleKey,
    direction,
    entries,
    pair,
    rising,
    within,
)
from toolkit.extra.shots.walking import Asked, first, rolled
from toolkit.io import files
from toolkit.motion import Clip
from toolkit.motion.tensors import shown
from toolkit.networks.bank import StyleBank
from toolkit.runtime import CharacterState, pose
from toolkit.runtime.life import alive

VERSION = 1


@dataclass(frozen=True)
class Shot:
    """What one character does: a path through points, keys over time, pauses.

    A field that is not as described is a ValueError of one line that names the field and the entry.

    Parameters
    ----------
    path
        Two or more `Point`, or pairs (x, z). The first is where the character starts, at time 0;
        the speed on the way to a point with a time is scaled so that the character is there in
        time.
    styles : one or more `StyleKey`, or pairs (time, style or blend); also the name of one style
    speeds : `SpeedKey`, or pairs (time, m/s); without any, the natural speed of the blend at each
    time
    holds : `Hold`: pauses
    smooth : a smooth curve through the points; otherwise straight lines
    facing
        Direction (x, z) in which it faces all the time; by default along the path.
    look_at : point (x, z) that the character faces all the time; not together with ``facing``
    feet, arms : foot and arm IK
    seed : where in its gait cycle the character starts
    duration : seconds; by default until one second after the end of the path is reached
    name : of the clip
    radius : metres, in a `Scene` whose characters keep apart: its share of the distance of two
    pins : `Pin`: where hands, feet or the look are at a time; the path is moved to reach them
    """

    path: Sequence[Point]
    styles: Sequence[StyleKey]
    speeds: Sequence[SpeedKey] = ()
    holds: Sequence[Hold] = ()
    smooth: bool = True
    facing: tuple[float, float] | None = None
    look_at: tuple[float, float] | None = None
    feet: bool = True
    arms: bool = True
    seed: int = 0
    duration: float | None = None
    name: str = "shot"
    radius: float | None = None
    pins: Sequence[Pin] = ()

    def __post_init__(self):
        put = functools.partial(object.__setattr__, self)
        if isinstance(self.styles, str):
            put("styles", [(0.0, self.styles)])
        for name, kind in (("path", Point), ("styles", StyleKey), ("speeds", SpeedKey),
                           ("holds", Hold), ("pins", Pin)):
            put(name, entries(getattr(self, name), kind, name))
        if len(self.path) < 2:
            raise ValueError(f"path: two or more points are needed, got {len(self.path)}")
        steps = [math.dist((a.x, a.z), (b.x, b.z)) for a, b in pairwise(self.path)]
        for k, step in enumerate(steps, 1):
            if step < 0.01:
                raise ValueError(f"path[{k}]: is less than 1 cm from the point before it")
        if (length := sum(steps)) > (most := LONGEST * FAST):
            raise ValueError(f"path: is {length:.0f} m long, a path has at most {most:.0f} m")
        rising(tuple(p for p in self.path[1:] if p.time is not None), "path, points with a time")
        if self.path[0].time not in (None, 0.0):
            raise ValueError(f"path[0]: the first point has the time 0, got {self.path[0].time:g}")
        if any(p.time == 0 for p in self.path[1:]):
            raise ValueError("path: only the first point can have the time 0")
        if not self.styles:
            raise ValueError("styles: one or more keys are needed")
        rising(self.styles, "styles")
        rising(self.speeds, "speeds")
        if len({len(key.layers) for key in self.styles} - {1}) > 1:
            raise ValueError("styles: all blends by layer need the same number of layers")
        for name in ("smooth", "feet", "arms"):
            if not isinstance(getattr(self, name), bool):
                raise ValueError(f"{name} must be true or false, got {shown(getattr(self, name))}")
        if self.facing is not None and self.look_at is not None:
            raise ValueError("give either facing or look_at, not both")
        if self.facing is not None:
            put("facing", direction(self.facing, "facing"))
        if self.look_at is not None:
            put("look_at", pair(self.look_at, "look_at"))
        if type(self.seed) is not int or not 0 <= self.seed < 2**31:
            raise ValueError(f"seed must be a whole number from 0 to {2**31 - 1}, got "
                             f"{shown(self.seed)}")
        within(self, duration=(1 / FPS, LONGEST), radius=(0.05, 5.0))
        if not isinstance(self.name, str) or not self.name.isprintable() or len(self.name) > 100:
            raise ValueError(f"name must be a line of up to 100 characters, got {shown(self.name)}")

    @classmethod
    def load(cls, path: str | os.PathLike) -> "Shot":
        """The shot of a JSON file with one; a ValueError of one line if it is not valid."""
        shots = read(path, parse)
        if len(shots) != 1:
            raise ValueError(f"{path}: holds {len(shots)} shots; read them with "
                             "toolkit.extra.shots.Scene.load")
        return shots[0]

    def save(self, path: str | os.PathLike) -> None:
        """Write a JSON file."""
        save([self], path)

    def plan(self, bank: StyleBank | None = None) -> tuple[Course, Heading]:
        """Where the character should be and face; ``bank`` is needed without speeds."""
        base = now = self._planned([(f"path[{k}]", p, 0.0) for k, p in enumerate(self.path)], bank)
        for _ in range(2 * bool(self.pins)):  # headings change with the path
            now = self._planned(pins.stations(self.pins, self.path, base, now), bank)
        return now

    def _planned(self, stops: list[tuple[str, Point, float]],
                 bank: StyleBank | None) -> tuple[Course, Heading]:
        """A plan through points, by name and with the seconds of a pause."""
        curve = Curve([(p.x, p.z) for _, p, _ in stops], self.smooth)
        speeds = self._natural(bank) if not self.speeds else (
            [key.time for key in self.speeds], [key.speed for key in self.speeds],
            [key.easing for key in self.speeds])
        placed = list(zip(stops, curve.knots, strict=True))
        holds = [(hold.time, hold.distance, hold.seconds) for hold in self.holds]
        holds += [(None, knot, pause) for (_, _, pause), knot in placed if pause]
        arrivals = [(name, knot, p.time) for (name, p, _), knot in placed[1:] if p.time is not None]
        curve.knots = [knot for (name, _, _), knot in placed if name.startswith("path")]
        turns = [None if p.facing is None else math.atan2(*p.facing) for p in self.path]
        return (Course(curve, speeds, arrivals, holds, self.duration),
                Heading(curve, self.facing, self.look_at, turns))

    def style(self, bank: StyleBank, life: float = 0.0) -> Callable[[int], Tensor]:
        """The style vector ``[S]`` of every frame; it wanders by the model's ``life``."""
        vectors = [bank.blend(*key.layers) for key in self.styles]
        times, easings = [key.time for key in self.styles], [key.easing for key in self.styles]

        def at(frame: int) -> Tensor:
            a, b, weight = following.between(times, easings, frame / FPS)
            return vectors[a] + weight * (vectors[b] - vectors[a]) if weight else vectors[a]

        return alive(at, life, self.seed)

    def render(self, model, bank: StyleBank) -> Clip:
        """The motion, 60 frames a second: the same bits every time.

        A model that is compiled by `toolkit.runtime.compile` is ten times as fast, and its last
        bits differ.
        """
        plan = self.plan(bank)
        return self.drawn(model, self._walked(model, bank, plan), plan[0])

    def drawn(self, model, states: CharacterState, course: Course) -> Clip:
        """The motion of the `joined` states, with the pins of the shot met."""
        with torch.no_grad():
            drawn = pose(model, states, feet=self.feet, arms=self.arms)
        return self.pinned(model, *drawn, course)

    def pinned(self, model, rotations: Tensor, root: Tensor, course: Course) -> Clip:
        """The motion of poses, with the pins of the shot met."""
        skeleton = model.layout.skeleton
        made = reaching.pinned(skeleton, rotations, root, self.pins, course)
        return Clip(skeleton, *made, FPS, name=self.name)

    def _walked(self, model, bank: StyleBank, plan: tuple[Course, Heading]) -> CharacterState:
        """The states of all frames, along the leading axis."""
        style = self.style(bank, model.life)

        def ask(frame: int, place: Pair) -> Asked:
            return *following.command(*plan, frame, place), style(frame)

        state = first(model, [self], [style], [plan])
        return rolled(model, state, len(plan[0].distance) - 1, ask)

    def check(self, model, bank: StyleBank) -> list[str]:
        """What cannot be met and why, a line each; empty if all can. The shot is tried for it."""
        plan = self.plan(bank)
        states = self._walked(model, bank, plan)
        lines = self.unmet(bank, plan, [tuple(place) for place in states.root[:, :2].tolist()])
        if self.pins:
            lines += pins.missed(self.pins, self.drawn(model, states, plan[0]))
        return lines

    def unmet(self, bank: StyleBank, plan: tuple[Course, Heading], places: list[Pair]) -> list[str]:
        """What `check` says of a character that was at these places (x, z), from frame 1 on."""
        course, keys = plan[0], self._natural(bank)

        def natural(now: float) -> float:
            return following.keyed(keys, now)

        def style(now: float) -> str:
            a, b, weight = following.between(keys[0], keys[2], now)
            (layer, *_) = self.styles[b if weight > 0.5 else a].layers
            return max(layer, key=layer.get)

        lines = [f"{name} is too far away to be reached at {time:g} s"
                 for name, _, time in map(course.arrivals.__getitem__, course.late)]
        length, seconds = course.curve.length, (len(course.distance) - 1) / FPS
        if course.end is None or course.end > seconds + 1e-9:
            lines.append(f"the end of the path is not reached in {seconds:g} s: "
                         f"{length - course.distance[-1]:.1f} m are left")
        lines += [f"holds[{k}] is after the end of the path, {length:.2f} m long"
                  for k, hold in enumerate(self.holds) if (hold.distance or 0.0) > length]
        return lines + feasibility.missed(course, natural, style, places)

    def _natural(self, bank: StyleBank) -> Keys:
        """The natural speed at every style key: of blends by layer, the mean of the layers."""
        speeds = [sum(bank.speed(blend) for blend in key.layers) / len(key.layers)
                  for key in self.styles]
        return ([key.time for key in self.styles], [min(max(v, 0.0), FAST) for v in speeds],
                [key.easing for key in self.styles])


def save(shots: Iterable[Shot], path: str | os.PathLike) -> None:
    """Write shots, one per character, or a `Scene`, to a JSON file."""
    text = json.dumps(data(shots), indent=1, ensure_ascii=False, allow_nan=False)
    files.write_whole(path, (text + "\n").encode())


def data(shots: Iterable[Shot]) -> dict:
    """Shots, or a `Scene`, as `parse` reads them and a file holds them."""
    scene = is_dataclass(shots)
    made = _data(shots) if scene else {"shots": [_data(shot) for shot in shots]}
    return {"version": VERSION, **made}


def _data(value):
    """Dataclasses as dictionaries without the fields that have their default."""
    if is_dataclass(value):
        return {f.name: _data(v) for f in fields(value)
                if (v := getattr(value, f.name)) != f.default}
    return [_data(v) for v in value] if isinstance(value, tuple) else value


def read(path: str | os.PathLike, parse: Callable):
    """What ``parse`` makes of a JSON file; its ValueError with the path."""
    data = files.read(path)
    with files.named(path):
        try:
            scene = files.parsed(data)
        except ValueError as error:
            raise ValueError(f"not a JSON file of shots ({error})") from None
        return parse(scene)


def parse(scene) -> list[Shot]:
    """The shots of a dictionary as a file holds it; `Scene.parse` reads its other fields too."""
    needed = {"version", "shots"}
    if not isinstance(scene, Mapping) or not needed <= set(scene) <= needed | {"apart", "walls"}:
        raise ValueError("expected an object with the fields version and shots, and perhaps "
                         "apart and walls")
    if scene["version"] != VERSION or isinstance(scene["version"], bool):
        raise ValueError(f"version {shown(scene['version'])}; this toolkit reads version {VERSION}")
    if not (shots := entries(scene["shots"], Shot, "shots")):
        raise ValueError("shots: one or more are needed")
    return list(shots)
