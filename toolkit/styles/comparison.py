"""Does a style walk as the clip does that it was learnt from? (ours)

The error one step ahead cannot say: a statue that glides has a small one. So the style walks in
closed loop, at the clip's own speed and on its path, and the walk is compared with the clip by
what a viewer sees.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import torch
from torch import Tensor
from torch.nn.functional import cosine_similarity

from toolkit import runtime
from toolkit.motion import Clip, contacts, rotations as R
from toolkit.motion.clip import root_frames
from toolkit.motion.roles import SIDES
from toolkit.motion.skeleton import FEET
from toolkit.motion.trajectory import FPS, heading
from toolkit.networks import Predictor
from toolkit.networks.bank import StyleBank
from toolkit.runtime.recording import record_all

SECONDS, LONGEST = 6.0, 12.0  # of a walk that is compared: at least, and of a clip at most
WARM_UP = 2.0  # seconds before it
SMOOTH = 0.5  # seconds over which a clip's velocity and facing are averaged into commands
CYCLE = 0.4, 2.0  # seconds that two steps may last
WINDOW = 3.0  # seconds in which a cycle is compared with the next one
#: What a walk has at least: seconds, m/s, and how regular it is (`periodicity`).
SHORTEST, SLOWEST, PERIODIC = 1.9, 0.3, 0.4
#: Ends of a clip that are slower than `STANDS` times the mean speed, for over `LONG` s, are cut.
STANDS, LONG = 0.5, 3.0
#: Largest differences from the clip of a good walk, relative for speed and steps; twice as much
#: is a failure. Posture: `POSTURE` times the distance of the nearest floor, but between `CLOSE` and
#: `FAR` cm. Range: the clip's, times `RANGE` or divided by it. Reach: `REACH` cm from the clip's;
#: the halves of 19 of 21 recorded walks are nearer.
LIMITS = {"speed": 0.25, "direction": 15.0, "steps": 0.2, "slower foot": 8.0, "hips": 6.0,
          "knees": 20.0, "head": 15.0}
POSTURE, CLOSE, FAR, RANGE, REACH = 0.8, 2.0, 7.0, 2.2, 8.0
VERDICTS = "good", "weak", "failed"
UNITS = {"speed": "m/s", "direction": "°", "steps": "1/s", "slower foot": "cm/s", "hips": "cm",
         "knees": "°", "head": "°", "posture": "cm", "range": "cm", "reach": "cm"}


@dataclass(frozen=True, eq=False)
class Comparison:
    """Result of `compare`; print it for a table.

    ``rows`` has a dict for the ``clip``, the ``style``, and each style of the bank that is a floor:
    ``speed``, m/s; ``direction`` of travel, degrees from the facing; ``steps`` per second, without
    pauses; ``slower foot``, mean speed of the slower toe, cm/s; ``hips``, mean height, cm;
    ``knees``, mean bend, degrees; ``head``, how far it nods or leans from where the clip holds it,
    degrees; ``posture``, mean distance of hands and spine from their mean places in the clip, cm;
    ``range``, deviation of hands and spine from their mean, cm; ``reach``, mean distance of the
    `extremes` of the hands, in each direction, from the clip's, cm. For the clip, head, posture and
    reach are those of its second half from its first.
    """

    verdict: str  # one of `VERDICTS`
    reasons: tuple[str, ...]  # why it is not good
    excess: float  # the largest difference, as a share of what a good walk may have
    rows: dict[str, dict[str, float]]
    clips: dict[str, Clip]  # the motion of each row

    def __repr__(self) -> str:
        lines = [" " * 18 + "".join(f"{name[:14]:>15}" for name in self.rows)]
        for what, unit in UNITS.items():
            values = "".join(f"{row[what]:>15.2f}" for row in self.rows.values())
            lines.append(f"{f'{what}, {unit}':<18}{values}")
        reasons = "; ".join(self.reasons)
        return "\n".join([*lines, f"{self.verdict}: {reasons}" if reasons else self.verdict])

    def rank(self) -> tuple[int, float]:
        """Sorts comparisons, the best first."""
        return VERDICTS.index(self.verdict), self.excess


def compare(clip: Clip, model: Predictor, style: Tensor | str, bank: StyleBank) -> Comparison:
    """Let a style walk at a clip's speed and on its path, and compare the walk with the clip.

    The floors are walks of other styles (`floors_of`): a style that is not nearer to the clip than
    these has not been learnt.

    Parameters
    ----------
    clip
        A walk or a run on the model's skeleton, at any rate. Long standing ends are cut
        (`walking`), and of a long one `LONGEST` seconds in the middle are compared. ValueError if
        it is no walk (`not_a_walk`).
    style, bank
        The vector ``[D]``, or a name in the bank of the model.
    """
    clip = clip.resample(FPS)
    if why := not_a_walk(clip):
        raise ValueError(f"{clip.name}: {why}")
    vector = bank[style] if isinstance(style, str) else style
    known = style if isinstance(style, str) else None
    floors = floors_of(bank, vector, known)
    return compared(clip, model, walks(clip, model, vector[None], bank, floors), floors)[0]


def floors_of(bank: StyleBank, vector: Tensor, name: str | None) -> list[str]:
    """Neutral and the style nearest to a vector, whose own name in the bank is ``name``."""
    near = [other for other, _ in bank.nearest(vector, len(bank)) if other != name]
    return [other for other in dict.fromkeys(("Neutral", *near[:1])) if other in near]


class Walk(NamedTuple):
    """Commands, and the states of B characters after each of them."""

    commands: list[runtime.Command]
    states: list[runtime.CharacterState]


def walks(clip: Clip, model: Predictor, vectors: Tensor, bank: StyleBank, floors: Sequence[str],
          times: int = 1) -> list[Walk]:
    """K ``vectors [K, D]`` and then ``floors``, styles of the bank, walk side by side on the path
    of a clip: from its start on, and from its middle on. Compiling pays for many ``times``.
    """
    clip = middle(clip)
    together = torch.cat([vectors, *(bank[other][None] for other in floors)])
    # compiling saves in a frame of n characters what it saves in n / 4 frames of one
    quick = runtime.quick(model, times * round(SECONDS * FPS) * len(together) // 4)
    both = [commands(clip, begin) for begin in (0, len(clip) // 2)]
    return [Walk(ordered, list(runtime.states(quick, ordered, together))) for ordered in both]


def compared(clip: Clip, model: Predictor, walked: Sequence[Walk],
             floors: Sequence[str]) -> list[Comparison]:
    """A comparison of each vector of `walks`. The worse walk counts: a vector that walks well from
    one start only is of no use.
    """
    clip = middle(clip)
    own, twice = measures(clip, clip), []
    for walk in walked:
        made = record_all(model, walk.states[round(WARM_UP * FPS):])
        count = len(made) - len(floors)
        beside = dict(zip(floors, made[count:], strict=True))
        floor_rows = {name: measures(one, clip) for name, one in beside.items()}
        judged = []
        for one in made[:count]:
            rows = {"clip": own, "style": measures(one, clip)} | floor_rows
            judged.append(_judged(rows, {"clip": clip, "style": one} | beside))
        twice.append(judged)
    return [max(pair, key=Comparison.rank) for pair in zip(*twice, strict=True)]


def middle(clip: Clip) -> Clip:
    """`LONGEST` seconds in the middle of what walks, at the model's rate, or all if it is less."""
    clip = walking(clip.resample(FPS))
    more = max(0, len(clip) - round(LONGEST * FPS))
    return clip.cut(more // 2, len(clip) - (more - more // 2))


def walking(clip: Clip) -> Clip:
    """A clip without long standing ends, see `LONG`."""
    if clip.seconds < 2 * LONG:
        return clip
    speeds = travel(clip)[0].norm(dim=-1)
    fast = torch.nonzero(speeds >= STANDS * speeds.mean())[:, 0]
    begin, rest = int(fast[0]), len(speeds) - 1 - int(fast[-1])
    long = LONG * clip.fps
    return clip.cut(begin if begin > long else 0, len(clip) - (rest if rest > long else 0))


def _judged(rows: dict[str, dict[str, float]], clips: dict[str, Clip]) -> Comparison:
    shares = {what: difference(rows, what) for what in UNITS}
    found = tuple(f"{what} {rows['style'][what]:.1f} {UNITS[what]}, {against(rows, what)}"
                  for what, share in shares.items() if share > 1)
    failed = any(shares[what] > 2 for what in LIMITS)
    verdict = "failed" if failed else "weak" if found else "good"
    return Comparison(verdict, found, max(shares.values()), rows, clips)


def difference(rows: Mapping[str, Mapping[str, float]], what: str) -> float:
    """How far the style's walk is from the clip's, as a share of what a good one may be."""
    clip, style = rows["clip"][what], rows["style"][what]
    match what:
        case "posture":
            _, _, *floors = [row[what] for row in rows.values()]
            return style / min(max(POSTURE * min(floors, default=math.inf), CLOSE), FAR)
        case "range":
            return abs(math.log(max(style, 1e-3) / max(clip, 1e-3))) / math.log(RANGE)
        case "head":  # an angle from the clip's already
            return style / LIMITS[what]
        case "reach":
            return style / REACH
        case "direction":
            return abs(math.remainder(style - clip, 360)) / LIMITS[what]
        case "slower foot":
            return (style - clip) / LIMITS[what]
        case "speed" | "steps":
            return abs(style - clip) / (LIMITS[what] * max(clip, 1e-3))
    return abs(style - clip) / LIMITS[what]


def against(rows: Mapping[str, Mapping[str, float]], what: str) -> str:
    """What a value of the style is compared with, in words."""
    if what != "posture":
        return f"the clip's {rows['clip'][what]:.1f}"
    most = f"at most {rows['style'][what] / difference(rows, what):.2g}"
    _, _, *floors = rows
    near = min(floors, key=lambda name: rows[name][what], default="")
    return f"{most} ({near}'s is {rows[near][what]:.1f})" if near else most


def not_a_walk(clip: Clip) -> str:
    """Why no style can be learnt from a clip on its own; empty for a walk or a run."""
    clip = walking(clip)
    if clip.seconds < SHORTEST:
        return f"lasts {clip.seconds:.1f} s; a style needs {SHORTEST:g} s or more"
    if (speed := pace(clip)) < SLOWEST:
        return f"covers {speed:.2f} m/s; a walk has {SLOWEST:g} m/s or more"
    contact = contacts.detect(clip)
    for side, share in zip(FEET, contact.mean(0).tolist(), strict=True):
        if share > 0.97:
            return f"the {side} foot never leaves the floor"
    if not (likeness := periodicity(clip)[0]) >= PERIODIC:
        return (f"the feet do not pass each other in turn: regular by {likeness:.2f}, a walk by "
                f"{PERIODIC:g} or more")
    return ""


def periodicity(clip: Clip) -> tuple[float, int]:
    """How regularly the feet pass each other, up to 1, and the length of a cycle in frames.

    In a walk, the toes' distance along the facing is the same a cycle later, and the opposite half
    a cycle later, where the other foot leads. The result is half the difference of the correlation
    at a cycle and the cosine similarity at half a cycle: the largest over lags of `CYCLE`, and the
    median over windows of `WINDOW`, because the tempo of a long take changes.
    """
    apart = toes_apart(clip)
    window = min(round(WINDOW * clip.fps), len(apart))
    windows = apart.unfold(0, window, max(1, window // 2))
    shortest, longest = (round(seconds * clip.fps) for seconds in CYCLE)
    lags = range(shortest, min(longest, 2 * window // 3) + 1)
    if not lags:
        return math.nan, 0

    same = torch.stack([correlation(windows[:, lag:], windows[:, :-lag]) for lag in lags])
    opposite = [cosine_similarity(windows[:, lag // 2 :], windows[:, : -(lag // 2)], dim=-1)
                for lag in lags]
    regular = (same - torch.stack(opposite)).amax(0) / 2
    # of nearly equal peaks the first one counts: the second one is two cycles
    first = (same > same.amax(0) - 0.05).int().argmax(0)
    return float(regular.median()), lags[int(first.median())]


def toes_apart(clip: Clip) -> Tensor:
    """How far ``[F]`` the right toe is ahead of the left one, along the facing."""
    toes = root_frames(clip).to_local(contacts.toes_of(clip))[..., 2].double()
    return toes[:, 0] - toes[:, 1]


def steps_per_second(walk: Clip, clip: Clip) -> float:
    """Two divided by the median time of a stride. A step is counted when the other toe is ahead by
    a third of the deviation that the clip's toes have. A limp has a long and a short step, a path
    may have a pause: so the stride, and the median.
    """
    apart = toes_apart(walk) - toes_apart(walk).mean()
    far = torch.nonzero(apart.abs() > toes_apart(clip).std() / 3)[:, 0]
    passes = far[1:][apart[far[1:]] * apart[far[:-1]] < 0]
    strides = (passes[2:] - passes[:-2]).double()
    if len(strides):
        return 2 * walk.fps / float(strides.median())
    # a clip may be too short for a stride; a walk that has none makes no steps
    return 2 * clip.fps / max(1, periodicity(clip)[1]) if walk is clip else 0.0


def correlation(a: Tensor, b: Tensor) -> Tensor:
    """Pearson's correlation ``[...]`` of the last dimension of ``[..., F]``."""
    return cosine_similarity(*(x - x.mean(-1, keepdim=True) for x in (a, b)), dim=-1)


def commands(clip: Clip, begin: int = 0) -> list[runtime.Command]:
    """Commands for a walk as the clip's: its velocity and facing, smoothed, repeated at the end.

    After `WARM_UP` of its mean velocity, they follow the clip from frame ``begin`` on. The path
    goes on turning in each repetition.
    """
    velocity, half = travel(clip)
    sin, cos = heading(root_frames(clip).rotations)
    facing = torch.stack((sin, cos), -1).unfold(0, 2 * half + 1, 1).mean(-1)
    angle = torch.atan2(facing[:, 0], facing[:, 1])
    # relative to the facing, so that a repetition starts where the last one ended
    along = turned(velocity, -angle)
    turns = torch.diff(angle, append=angle[-1:])
    turns = torch.atan2(turns.sin(), turns.cos())
    # the clip as often as `SECONDS` need
    warm_up, repeats = round(WARM_UP * clip.fps), math.ceil(SECONDS * clip.fps / len(along))
    at = (begin + torch.arange(repeats * len(along))) % len(along)
    at = at[: round(max(SECONDS, clip.seconds) * clip.fps)]
    now = torch.cat((turns.new_zeros(warm_up), turns[at])).cumsum(0)
    wanted = turned(torch.cat((along.mean(0).expand(warm_up, 2), along[at])), now)
    facing = torch.stack((now.sin(), now.cos()), -1)
    return [runtime.Command(tuple(v), tuple(f))
            for v, f in zip(wanted.tolist(), facing.tolist(), strict=True)]


def travel(clip: Clip) -> tuple[Tensor, int]:
    """Velocity ``[F - 2h, 2]`` (x, z) of the hips, averaged over h frames before and after; h."""
    half = min(round(SMOOTH * clip.fps / 2), (len(clip) - 1) // 2)
    hips = root_frames(clip).positions[:, [0, 2]]
    return (hips[2 * half :] - hips[: -2 * half]) * clip.fps / (2 * half), half


def pace(clip: Clip) -> float:
    """Mean horizontal speed, m/s, without the sway of single steps."""
    return float(travel(clip)[0].norm(dim=-1).mean())


def turned(vectors: Tensor, angle: Tensor) -> Tensor:
    """Vectors (x, z) ``[F, 2]`` turned about the vertical by angles ``[F]``."""
    solid = torch.stack((vectors[:, 0], torch.zeros_like(angle), vectors[:, 1]), -1)
    return R.rotate(R.yaw(angle), solid)[:, [0, 2]]


def measures(walk: Clip, clip: Clip) -> dict[str, float]:
    """A row of `Comparison`."""
    roots = root_frames(walk)
    way = roots.turn_to_local(contacts.velocities(roots.positions, walk.fps)).mean(0)
    toes = contacts.velocities(contacts.toes_of(walk), walk.fps).norm(dim=-1).amin(1)
    body = upper_body(walk)

    def beside(of: Callable[[Clip], Tensor]) -> Sequence[Tensor]:
        own = of(clip)
        return own.split((len(own) + 1) // 2) if walk is clip else (own, of(walk))

    (own, seen), (own_head, head) = beside(upper_body), beside(up_of_head)
    return {
        "speed": pace(walk),
        "direction": math.degrees(math.atan2(float(way[0]), float(way[2]))),
        "steps": steps_per_second(walk, clip),
        "slower foot": 100 * float(toes.mean()),
        "hips": 100 * float(walk.global_positions[:, walk.skeleton.role("hips"), 1].mean()),
        "knees": math.degrees(bend(walk).mean()),
        "head": math.degrees(R.angle(head.mean(0), own_head.mean(0))),
        "posture": 100 * float((seen.mean(0) - own.mean(0)).norm(dim=-1).mean()),
        "range": 100 * float(body.var(0).sum(-1).sqrt().mean()),
        "reach": 100 * float((extremes(seen) - extremes(own))[:, :2].abs().mean()),
    }


def upper_body(clip: Clip) -> Tensor:
    """Positions ``[F, 2 + T, 3]`` of the hands and the trunk's T joints in the root's frame."""
    skeleton = clip.skeleton
    joints = [*(skeleton.role(f"{side}_hand") for side in SIDES), *skeleton.trunk]
    return root_frames(clip).to_local(clip.global_positions[:, joints])


def extremes(places: Tensor) -> Tensor:
    """The values ``[2, ...]`` that 5 and 95 % of the frames ``[F, ...]`` are below."""
    return places.quantile(places.new_tensor([0.05, 0.95]), 0)


def bend(clip: Clip) -> Tensor:
    """Angles ``[F, 2]`` of the knees, radians: 0 if straight."""
    joints = [[clip.skeleton.role(f"{side}_{part}") for side in SIDES]
              for part in ("hip", "knee", "foot")]
    hips, knees, feet = (clip.global_positions[:, pair] for pair in joints)
    return R.angle(knees - hips, feet - knees)


def up_of_head(clip: Clip) -> Tensor:
    """The vertical ``[F, 3]`` as the head sees it: how it nods and leans, not where it looks."""
    back = R.inverse(clip.global_rotations[:, clip.skeleton.neck[-1]])
    return R.rotate(back, torch.tensor([0.0, 1.0, 0.0]).to(back))
