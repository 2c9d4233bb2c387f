"""Soak test: every style for ten minutes with random commands and blends, compared with limits for
falls and stops.
"""

import math
from dataclasses import dataclass, fields
from typing import Annotated, NamedTuple

import torch
import typer
from torch import Tensor
from tqdm import tqdm

from experiments.tables import Result, Store
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import metrics
from toolkit.motion import Skeleton, forward_kinematics
from toolkit.runtime import FPS, CharacterState, Command

CHUNK = 300  # frames whose poses are in memory at a time
MISBEHAVES = "Drunk"  # style 23 of the published parameters, which is known to fall
#: Kinds of commands: share of the segments, lowest and highest speed in m/s, and facing.
WAYS = {
    "stand": (0.15, 0.0, 0.0, "ahead"), "walk": (0.3, 0.5, 1.5, "ahead"),
    "run": (0.1, 2.0, 3.5, "ahead"), "wander": (0.15, 0.5, 1.5, "ahead"),
    "strafe": (0.15, 0.5, 1.3, "elsewhere"), "keep": (0.15, 0.5, 1.5, "zero"),
}
SEGMENT = (0.5, 8.0)  # seconds of a segment with one kind of command
WOBBLE = 1.0  # radians per square root of a second, random walk of the heading in "wander"
KEYS = (0.1, 4.0)  # seconds between two key blends
# limits of the hips' height / height at rest; outside of them a character is down
LOW, HIGH = 0.35, 1.6
# seconds of a window of steady walking; seconds of it for a turn, which are not measured
WINDOW, TURN = 5.0, 2.0
WALK, STEADY = (0.5, 1.5), 0.9  # limits of steady walking: m/s; least |mean velocity| / mean speed
STUCK = 0.2  # share of the commanded distance, below which a character is stuck
COLUMNS = {"model": ["model"], "styles": ["styles", 0], "frames": ["frames", 0],
           "bad": ["frames that are not finite", 0], "falls": ["falls", 0],
           "stuck": ["times stuck", 0], "glides": ["glides", 0]}
# the pose includes the root
CARRIED = tuple(f.name for f in fields(CharacterState) if f.name not in ("history", "style"))


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    skip: Annotated[str | None,
                    typer.Option(help=f"Styles to exclude; else {MISBEHAVES}.")] = None,
    seconds: Annotated[float, typer.Option(min=1.0, help="Duration for each style.")] = 600.0,
    seed: Annotated[int, typer.Option(help="Seed of commands and blends.")] = 0,
    store: Store = False,
) -> None:
    """Falls and stops of every style with random commands and blends, compared with limits;
    status 1 if exceeded.
    """
    net, bank = published.either(model, parameters)
    without = (MISBEHAVES if parameters and skip is None else skip or "").split(",")
    bank = bank.select(name for name in bank if name not in without)
    course = Course.random(len(bank), round(seconds * FPS), seed)
    seen = watch(runtime.compile(net), bank.vectors, course)
    found = judge(seen, course, net.layout.skeleton)
    kind = "published" if parameters else "embedded" if model is None else "trained"
    total = {"model": kind, "styles": len(bank), "frames": seen.finite.numel()}
    for what, happens in found.items():
        total[what] = int((happens if what == "bad" else begins(happens)).sum())
        for i in happens.any(0).nonzero()[:, 0].tolist():
            frame = int(happens[:, i].int().argmax())
            blend = " + ".join(
                f"{share:.0%} {bank.names[style]}" for style, share
                in zip(course.styles[frame, i], course.shares[frame, i], strict=True)
                if share > 0.005)
            print(f"{bank.names[i]}: {what} from {frame / FPS:.1f} s on, {blend}")
    result = Result("soak", f"Every style for {seconds:g} s under random commands and blends, "
                    f"seed {seed}",
                    "python -m experiments soak [--published DATA/lpn_film_100style] --store",
                    COLUMNS, [total])
    print(f"{result.about}\n\n{result.markdown()}")
    if store:
        result.add()
    if any(total[what] for what in found):
        raise typer.Exit(1)


@dataclass(frozen=True, eq=False)
class Course:
    """Commands and blends for N characters in F frames; the main style of character i is style i.

    Parameters
    ----------
    velocity, facing : Tensor [F, N, 2]
        Commands, world; a facing of zero keeps the current one.
    styles : Tensor [F, N, 3]
        Indices of the main style and two others.
    shares : Tensor [F, N, 3]
        Their weights, which sum to one.
    """

    velocity: Tensor
    facing: Tensor
    styles: Tensor
    shares: Tensor

    @classmethod
    def random(cls, characters: int, frames: int, seed: int) -> "Course":
        """Stops, walks, runs and sidesteps with sudden turns; blends from the main style to two
        others and back.
        """
        draw = torch.Generator().manual_seed(seed)
        columns = [(*_steering(frames, draw), *_blending(i, characters, frames, draw))
                   for i in range(characters)]
        return cls(*(torch.stack(column, 1) for column in zip(*columns, strict=True)))

    def blend(self, frame: int, vectors: Tensor) -> Tensor:
        """Style vectors ``[N, D]`` of a frame, from those of all styles ``[N, D]``."""
        return torch.einsum("nk,nkd->nd", self.shares[frame], vectors[self.styles[frame]])


class Watched(NamedTuple):
    """Observations of N characters over F frames; metres and seconds."""

    finite: Tensor  # [F, N] bool
    upright: Tensor  # [F, N] bool
    hips: Tensor  # [F, N], their height
    root: Tensor  # [F, N, 2]
    contact: Tensor  # [F, N, 2] bool, right and left


def watch(model, vectors: Tensor, course: Course) -> Watched:
    """Run a compiled or plain model with a course; ``vectors [N, D]`` are those of the styles."""
    state, parts = runtime.start(model, course.blend(0, vectors)), []
    frames = range(len(course.velocity))
    with torch.no_grad():
        for chunk in tqdm([frames[i : i + CHUNK] for i in frames[::CHUNK]], desc="soak",
                          disable=None):
            states = []
            for frame in chunk:
                command = Command(course.velocity[frame], course.facing[frame])
                state = runtime.step(model, state.with_style(course.blend(frame, vectors)), command)
                states.append(state)
            parts.append(_look(model, states))
    return Watched(*(torch.cat(part) for part in zip(*parts, strict=True)))


def _look(model, states: list[CharacterState]) -> Watched:
    """What is seen of some frames."""
    skeleton = model.layout.skeleton
    rotations, roots = (torch.stack(side)
                        for side in zip(*(runtime.pose(model, s) for s in states), strict=True))
    positions = forward_kinematics(skeleton, rotations, roots)[1]
    numbers = torch.stack([torch.cat([getattr(s, name).flatten(1) for name in CARRIED], 1)
                           for s in states])
    return Watched(
        finite=numbers.isfinite().all(-1) & positions.isfinite().flatten(2).all(-1),
        upright=metrics.on_feet(skeleton, positions[..., 1]),
        hips=positions[..., skeleton.role("hips"), 1],
        root=torch.stack([s.root[:, :2] for s in states]),
        contact=torch.stack([s.contacts > 0.5 for s in states]),
    )


def judge(seen: Watched, course: Course, skeleton: Skeleton) -> dict[str, Tensor]:
    """In which frames ``[F, N]`` or windows ``[W, N]`` something is wrong, by what it is.

    A character is down if it is not upright or the height of its hips is outside of `LOW` to `HIGH`
    times that at rest. In a window with commands for steady walking it is stuck if, after the
    time for a turn, it moves less than `STUCK` of the commanded distance, and glides if it makes no
    step. Slides are found by `toolkit.evaluation.defects`.
    """
    height = skeleton.rest_positions[:, 1]
    share = seen.hips / (height[skeleton.role("hips")] - height.min())
    up = seen.upright & (share > LOW) & (share < HIGH)

    length = min(round(WINDOW * FPS), len(seen.root) - 1)

    def total(series: Tensor) -> Tensor:
        sums = series.double().cumsum(0)
        return sums[length:] - sums[:-length]

    speed, asked = course.velocity.norm(dim=-1), total(course.velocity) / length
    slow, fast = WALK
    walking = total((speed >= slow) & (speed <= fast)) > length - 0.5
    walking &= asked.norm(dim=-1) >= STEADY / length * total(speed)
    turned = min(round(TURN * FPS), length - 1)
    moved = (seen.root[length:] - seen.root[turned : turned - length]) * (FPS / (length - turned))
    got = (moved * asked).sum(-1) / asked.square().sum(-1).clamp_min(1e-9)
    landings = total(begins(seen.contact).sum(-1)).round()
    return {"bad": ~seen.finite, "falls": seen.finite & ~up, "stuck": walking & (got < STUCK),
            "glides": walking & (landings == 0)}


def begins(happens: Tensor) -> Tensor:
    """Where something begins that happens in frames ``[F, ...]``; also in the first."""
    return happens & ~torch.cat((torch.zeros_like(happens[:1]), happens[:-1]))


def _steering(frames: int, draw: torch.Generator) -> tuple[Tensor, Tensor]:
    """Velocity and facing ``[F, 2]`` for one character: random segments of the kinds of `WAYS`,
    each with a new heading.
    """
    velocity, facing, start = torch.zeros(frames, 2), torch.zeros(frames, 2), 0
    shares = torch.tensor([way[0] for way in WAYS.values()])
    while start < frames:
        name = list(WAYS)[int(torch.multinomial(shares, 1, generator=draw))]
        _, slow, fast, look = WAYS[name]
        length, speed, heading, elsewhere = torch.rand(4, generator=draw).tolist()
        stop = min(frames, start + round(FPS * (SEGMENT[0] + length * (SEGMENT[1] - SEGMENT[0]))))
        wobble = torch.randn(stop - start, generator=draw).cumsum(0) * (WOBBLE / FPS**0.5)
        ahead = _direction(math.tau * heading + wobble * (name == "wander"))
        velocity[start:stop] = (slow + speed * (fast - slow)) * ahead
        facing[start:stop] = {"ahead": ahead, "zero": torch.zeros(2),
                              "elsewhere": _direction(torch.tensor(math.tau * elsewhere))}[look]
        start = stop
    return velocity, facing


def _blending(home: int, styles: int, frames: int, draw: torch.Generator) -> tuple[Tensor, Tensor]:
    """Styles and shares ``[F, 3]`` of one character: from its main style by two random blends back
    to it, and again.
    """
    others, shares = torch.empty(frames, 3, dtype=torch.long), torch.empty(frames, 3)
    start, alone = 0, torch.tensor([1.0, 0.0, 0.0])
    while start < frames:
        corners = torch.stack((alone, *(_barycentric(draw) for _ in range(2)), alone))
        others[start:] = torch.tensor([home, *torch.randint(styles, (2,), generator=draw).tolist()])
        lengths = torch.rand(3, generator=draw).tolist()
        for here, there, length in zip(corners[:-1], corners[1:], lengths, strict=True):
            count = round(FPS * (KEYS[0] + length * (KEYS[1] - KEYS[0])))
            path = torch.lerp(here, there, torch.linspace(0.0, 1.0, count)[:, None])
            shares[start : start + count] = path[: max(0, frames - start)]
            start += count
    return others, shares


def _barycentric(draw: torch.Generator) -> Tensor:
    """Weights of a uniformly distributed point in a triangle."""
    shares = -torch.rand(3, generator=draw).clamp_min(1e-6).log()
    return shares / shares.sum()


def _direction(angle: Tensor) -> Tensor:
    return torch.stack((angle.sin(), angle.cos()), -1)
