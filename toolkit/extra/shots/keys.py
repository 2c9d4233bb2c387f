"""The parts of a shot, points and keys over time, and what may stand in them."""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import MISSING, dataclass, fields
from itertools import pairwise

from toolkit.extra.shots.following import EASINGS, LONGEST
from toolkit.motion.tensors import shown

MANY, FAR, FAST = 256, 1000.0, 20.0  # limits: entries of a list, metres from the origin, m/s

Blend = Mapping[str, float]
HANDS = "right_hand", "left_hand"
LIMBS = *HANDS, "right_foot", "left_foot"


def number(value, what: str, low: float, high: float) -> float:
    """A finite number in a range."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
        raise ValueError(f"{what} must be a number from {low:g} to {high:g}, got {shown(value)}")
    return float(value)


def within(entry, **limits: tuple[float, float]) -> None:
    """Keep fields of a dataclass as numbers in ranges; None stays where it is the default."""
    for field in fields(entry):
        value = getattr(entry, field.name)
        if field.name in limits and (value is not None or field.default is not None):
            made = number(value, field.name, *limits[field.name])
            object.__setattr__(entry, field.name, made)


def pair(value, what: str, axes: str = "xz") -> tuple[float, ...]:
    """Finite numbers (x, z), or of other axes, of at most `FAR`."""
    if isinstance(value, str | Mapping) or not isinstance(value, Sequence) or len(
            value) != len(axes):
        kind = "a pair" if len(axes) == 2 else f"{len(axes)} numbers"
        raise ValueError(f"{what} must be {kind} ({', '.join(axes)}), got {shown(value)}")
    return tuple(number(v, f"{axis} of {what}", -FAR, FAR)
                 for v, axis in zip(value, axes, strict=True))


def direction(value, what: str) -> tuple[float, float]:
    """Two numbers (x, z) that are not both zero."""
    x, z = pair(value, what)
    if math.hypot(x, z) < 1e-6:
        raise ValueError(f"{what} must not be zero")
    return x, z


def check_easing(easing) -> None:
    """A ValueError unless it is one of `EASINGS`."""
    if not isinstance(easing, str) or easing not in EASINGS:
        raise ValueError(f"easing must be one of {', '.join(EASINGS)}; got {shown(easing)}")


@dataclass(frozen=True)
class Point:
    """A point of a path."""

    x: float  # metres
    z: float
    time: float | None = None  # of arrival, seconds
    facing: tuple[float, float] | None = None  # (x, z) there

    def __post_init__(self):
        within(self, x=(-FAR, FAR), z=(-FAR, FAR), time=(0, LONGEST))
        if self.facing is not None:
            object.__setattr__(self, "facing", direction(self.facing, "facing"))


@dataclass(frozen=True)
class StyleKey:
    """At a ``time`` the ``blend``, and the ``easing`` to the next key.

    A blend is a style's name, weights by style, or a list of such weights, one for each layer.
    """

    time: float
    blend: str | Blend | Sequence[Blend]
    easing: str = "smooth"

    def __post_init__(self):
        within(self, time=(0, LONGEST))
        check_easing(self.easing)
        given = {self.blend: 1.0} if isinstance(self.blend, str) else self.blend
        layers = [given] if isinstance(given, Mapping) else given
        if not isinstance(layers, Sequence) or not layers or not all(
                isinstance(blend, Mapping) and 0 < len(blend) <= MANY for blend in layers):
            raise ValueError(f"a blend is a style's name or weights of up to {MANY} styles, "
                             f"got {shown(self.blend)}")
        made = [{str(name): number(w, f"the weight of {shown(name)}", -FAR, FAR)
                 for name, w in blend.items()} for blend in layers]
        for blend in made:
            if abs(sum(blend.values()) - 1) > 1e-4:
                raise ValueError("the weights of a blend must sum to 1, got "
                                 f"{sum(blend.values()):g}")
        object.__setattr__(self, "blend", made[0] if isinstance(given, Mapping) else tuple(made))

    @property
    def layers(self) -> tuple[Blend, ...]:
        """The blends of all layers; one for all if there is one."""
        return (self.blend,) if isinstance(self.blend, Mapping) else self.blend


@dataclass(frozen=True)
class SpeedKey:
    """At a ``time`` the ``speed``, m/s, and the ``easing`` to the next."""

    time: float
    speed: float
    easing: str = "smooth"

    def __post_init__(self):
        within(self, time=(0, LONGEST), speed=(0, FAST))
        check_easing(self.easing)


@dataclass(frozen=True)
class Hold:
    """Standing for a while, from a time on or at a distance: one of the two."""

    seconds: float
    time: float | None = None
    distance: float | None = None  # length of the path, metres

    def __post_init__(self):
        within(self, seconds=(0, LONGEST), time=(0, LONGEST), distance=(0, 1e6))
        if (self.time is None) == (self.distance is None):
            raise ValueError("a hold needs either a time or a distance")


@dataclass(frozen=True)
class Pin:
    """Where hands, feet, the look or the pose are ``at`` a time, or until the time ``to``."""

    at: float
    to: float | None = None
    right_hand: tuple[float, float, float] | None = None  # (x, y, z) of the wrist, metres
    left_hand: tuple[float, float, float] | None = None
    right_foot: tuple[float, float, float] | None = None  # of the ankle
    left_foot: tuple[float, float, float] | None = None
    look: tuple[float, float, float] | None = None  # what the head turns to
    pose: Mapping[str, Sequence[float]] | None = None  # see `toolkit.extra.shots.pose`

    def __post_init__(self):
        within(self, at=(0, LONGEST), to=(0, LONGEST))
        if self.to is not None and self.to <= self.at:
            raise ValueError(f"to must be after at, got {self.to:g} and {self.at:g}")
        parts = (*LIMBS, "look", "pose")
        if all(getattr(self, part) is None for part in parts):
            raise ValueError(f"a pin needs one of {', '.join(parts)}")
        for part in parts[:-1]:
            if (place := getattr(self, part)) is not None:
                object.__setattr__(self, part, pair(place, part, "xyz"))
        if self.pose is not None:
            if not isinstance(self.pose, Mapping) or len(self.pose) > MANY:
                raise ValueError("pose must have four numbers by joint, got "
                                 f"{shown(self.pose)}")
            turns = {str(name): pair(turn, f"the rotation of {shown(name)}", "wxyz")
                     for name, turn in self.pose.items()}
            if any(abs(math.hypot(*turn) - 1) > 1e-3 for turn in turns.values()):
                raise ValueError("pose: rotations must be quaternions of length 1")
            object.__setattr__(self, "pose", turns)

    @property
    def end(self) -> float:
        """The last moment, seconds."""
        return self.at if self.to is None else self.to


def entries(values, kind: type, what: str) -> tuple:
    """The entries of a list as objects of a kind, see `build`; messages name list and entry."""
    if isinstance(values, str | Mapping) or not isinstance(values, Iterable):
        raise ValueError(f"{what} must be a list, got {shown(values)}")
    values = list(values)
    if len(values) > MANY:
        raise ValueError(f"{what}: at most {MANY} entries, got {len(values)}")
    made = []
    for k, value in enumerate(values):
        try:
            made.append(value if isinstance(value, kind) else build(kind, value))
        except (TypeError, ValueError) as error:
            raise ValueError(f"{what}[{k}]: {error}") from None
    return tuple(made)


def build(kind: type, value):
    """An object of a kind from a dictionary of its fields, or from a list of the first ones."""
    known = [field.name for field in fields(kind)]
    if isinstance(value, str) or not isinstance(value, Mapping | Sequence):
        raise ValueError(f"expected the fields of a {kind.__name__}, got {shown(value)}")
    if not isinstance(value, Mapping):
        if len(value) > len(known):
            raise ValueError(f"{len(value)} fields, a {kind.__name__} has {', '.join(known)}")
        value = dict(zip(known, value, strict=False))
    if unknown := [key for key in value if key not in known]:
        raise ValueError(f"unknown field {shown(unknown[0])}; known: {', '.join(sorted(known))}")
    for field in fields(kind):
        if field.default is MISSING and field.name not in value:
            raise ValueError(f"the field {field.name} is missing")
    return kind(**value)


def rising(keys: tuple, what: str) -> None:
    """A ValueError if the times of keys do not increase."""
    for k, (a, b) in enumerate(pairwise(keys)):
        if b.time <= a.time:
            raise ValueError(f"{what}[{k + 1}]: times must increase, got {b.time:g} s after "
                             f"{a.time:g} s")
