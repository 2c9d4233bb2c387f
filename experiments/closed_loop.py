"""What characters do in closed loop, which the one-step error does not show: every style on the
same tracks, beside recorded takes that the same code measures.
"""

import math
from collections.abc import Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Annotated

import pandas as pd
import torch
import typer
from torch import Tensor
from tqdm import tqdm

from experiments.tables import Result, Store
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import defects, metrics
from toolkit.io import bvh
from toolkit.motion import Clip, contacts, root_frames, rotations as R
from toolkit.motion.skeleton import FEET
from toolkit.networks.bank import StyleBank
from toolkit.runtime import FPS, CharacterState
from toolkit.runtime.frame import predicted_toes
from toolkit.runtime.life import alive

MISBEHAVES = "Drunk"  # of the published styles, as its authors know
WARM_UP, MEASURED = 3.0, 8.0  # seconds
TURN = 45.0  # degrees per second, on the circle
SLOW = 1.5  # seconds: what moves more slowly than this is slow motion
UPPER = "chest", "spine", "neck", "right_elbow", "left_elbow", "right_hand", "left_hand"
SEEDS = (0, 1, 2)  # of the life of styles
STORED = "closed-loop"

#: Measures: title with unit, the largest value that is asked for.
MEASURES = {
    "direction": ("direction, degrees", 2.0),
    "speed": ("speed / command", None),
    "toes": ("toes in contact, cm/s", 5.0),
    "raw": ("the same before IK, on the floor", 4.0),
    "slow": ("slow motion of the upper body, cm", None),
    "steps": ("steps/s", None),
    "clearance": ("clearance of toes, cm", None),
    "still": ("speed after 1 s, m/s", 0.05),
    "way": ("way in the 7 s after it, cm", None),
    "air": ("time with a foot in the air, %", None),
    "began": ("seconds to 0.8 m/s", None),
    "knee": ("knee, 1000 degrees/s²", 15.0),
    "wrist": ("wrist, 1000 m/s³", 1.7),
    "ankle": ("ankle over a toe in contact, cm/s", None),
    "found": ("seconds with a finding, mean, %", None),
}  # fmt: skip
WALK = "direction", "speed", "toes", "raw", "slow", "steps", "clearance", "found"
FAST = "direction", "speed", "toes", "found"
POPS = "toes", "knee", "wrist", "ankle", "found"
#: What is measured on each track.
TRACKS = {
    "natural": WALK, "alive": WALK, "1 m/s": WALK, "2 m/s": FAST, "sideways": FAST,
    "backward": FAST, "circle": ("toes", "raw"), "stop": ("still", "way", "air"),
    "start": ("began",), "run": POPS, "strafe": POPS, "turns": POPS, "stand": ("still", "way"),
}  # fmt: skip


def order(track: str, seconds: float) -> tuple[float, float, float]:
    """Speed (m/s), its direction and the facing (degrees from +z to +x) that are asked at a time.

    ``natural`` and ``alive`` ask for so many times the natural speed.
    """
    later = seconds - WARM_UP
    if track == "circle":
        return 1.0, TURN * seconds, TURN * seconds
    if track == "strafe":  # ahead, then to both sides in turn
        return 1.0, 0.0 if later < 0 else -90.0 if later % 4 < 2 else 90.0, 0.0
    if track == "turns":  # a quarter turn, then half turns
        angle = 0.0 if later < 0 else 90.0 if later % 4 < 2 else -90.0
        return 1.0, angle, angle
    if track == "run":  # from standing, and back to it
        return 2.5 * (0 <= later < 5), 0.0, 0.0
    if track == "stand":  # stops and turns at once
        return 1.0 * (later < 0), 0.0, 0.0 if later < 0 else 90.0
    speeds = {"2 m/s": 2.0, "sideways": 0.7, "backward": 0.7, "stop": 1.0 * (later < 0),
              "start": 1.0 * (later >= 0)}
    return speeds.get(track, 1.0), {"sideways": 90.0, "backward": 180.0}.get(track, 0.0), 0.0


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    tracks: Annotated[str, typer.Option(help="Comma-separated.")] = ",".join(TRACKS),
    styles: Annotated[str | None, typer.Option(help="Comma-separated; default: all.")] = None,
    takes: Annotated[list[Path] | None, typer.Option(
        help="BVH files of straight walks, measured in the same way.")] = None,
    start: Annotated[int, typer.Option(help="First frame of the takes, at 60 Hz.")] = 0,
    store: Store = False,
) -> None:
    """Direction, stop, feet, pops and slow motion of every style on the same tracks, beside
    recorded takes.
    """
    net, bank = published.either(model, parameters)
    kind = "published" if parameters else "embedded" if model is None else model.stem
    fast = runtime.compile(net) if net.name == "lpn-film" else net
    for take in takes or ():
        _print({f"take {take.stem}": of_clip(bvh.load(take).resample(FPS).cut(start))})
    names = list(bank.names) if styles is None else styles.split(",")
    bank = bank.select([name for name in names if not parameters or name != MISBEHAVES])
    found = {}
    for track in tracks.split(","):
        if track == "alive" and not net.life:
            continue
        runs = [measured(fast, bank, track, seed) for seed in (SEEDS if track == "alive" else [0])]
        rows = [{key: sum(row[key] for row in same) / len(same) for key in TRACKS[track]}
                for same in zip(*runs, strict=True)]
        print(f"\n{track}")
        _print(dict(zip(bank.names, rows, strict=True)))
        for key in TRACKS[track]:
            found[f"{track}: {MEASURES[key][0]}"] = _summary(key, bank.names,
                                                             [row[key] for row in rows])
        if store:
            _store(kind, found)
    print(f"\nsummary, {len(bank)} styles\n{pd.DataFrame(found).T.to_string()}")


def measured(net, bank: StyleBank, track: str, seed: int = 0) -> list[dict[str, float]]:
    """The measures of a track for each style of a bank, side by side."""
    pace = torch.ones(len(bank), 1)
    if track in ("natural", "alive"):
        pace = torch.tensor([[bank.speed(name)] for name in bank.names])
    style = alive(bank.vectors, net.life if track == "alive" else 0.0, seed)
    walks = walked(net, style, track, pace)
    return [measures_of(net, walk, track, float(p)) for walk, p in zip(walks, pace, strict=True)]


def walked(net, style, track: str, pace: Tensor) -> list[dict[str, Tensor]]:
    """For each of B characters, with the factors ``pace [B, 1]`` on the speed of a track, the parts
    of its states ``[F, ...]`` by name, its roots ``[F, 4]``, and `unlocked` as ``raw``.
    """
    commands = []
    for frame in range(round((WARM_UP + MEASURED) * FPS)):
        speed, way, look = order(track, frame / FPS)
        way, look = ((math.sin(math.radians(a)), math.cos(math.radians(a))) for a in (way, look))
        commands.append(runtime.Command(speed * pace * torch.tensor(way), look))
    seen, old = [], None
    for state in tqdm(runtime.states(net, commands, style), track, len(commands), disable=None):
        raw = state.toes if old is None else unlocked(net, old, state)
        names = "root", "joints", "toes", "drop", "swivel", "contacts"
        seen.append({name: getattr(state, name) for name in names} | {"raw": raw})
        old = state
    stacked = {name: torch.stack([parts[name] for parts in seen], 1) for name in seen[0]}
    return [{name: part[i] for name, part in stacked.items()} for i in range(len(pace))]


def unlocked(net, old: CharacterState, new: CharacterState) -> Tensor:
    """Positions ``[B, 2, 3]`` of toes in contact before foot IK; others are undefined.

    `toolkit.motion.ik.foot_lock` keeps the velocity of a locked toe's offset from the prediction.
    """
    return new.toes - (old.toes - predicted_toes(net.layout, old)) - new.drift / FPS


def measures_of(net, walk: dict[str, Tensor], track: str, pace: float) -> dict[str, float]:
    """The measures of a track for one character."""
    first, half = round(WARM_UP * FPS), FPS // 4
    contact, roots, raw = walk["contacts"], walk["root"][:, :2], walk["raw"]
    seen = {}
    if "toes" in TRACKS[track]:
        clip = Clip(net.layout.skeleton, *runtime.pose(net.layout, SimpleNamespace(**walk)), FPS)
        seen = of_clip(clip.cut(first), contact[first:])
    speeds = (roots[half:] - roots[:-half]).norm(dim=-1) * FPS / half  # over a quarter second
    on = (contact[first + 1 :] > 0.5) & (contact[first:-1] > 0.5)
    steps = (raw[first + 1 :] - raw[first:-1])[..., [0, 2]].norm(dim=-1) * FPS

    # The way along and across the asked direction.
    speed, angle, _ = order(track, 0.0 if track == "stop" else WARM_UP)
    angle = math.radians(angle)
    # Means of a second at both ends leave the sway of a stride out.
    x, z = (roots[-FPS:].mean(0) - roots[first : first + FPS].mean(0)).tolist()
    along = x * math.sin(angle) + z * math.cos(angle)
    across = x * math.cos(angle) - z * math.sin(angle)
    began = (speeds[first:] > 0.8).nonzero()[:1]
    return seen | {
        "direction": abs(math.degrees(math.atan2(across, along))),
        "speed": along / (MEASURED - 1) / max(speed * pace, 1e-6),
        "raw": 100 * float(steps[on].mean()),
        "still": float(speeds[first + FPS :].max()),
        "way": 100 * float((roots[-1] - roots[first + FPS]).norm()),
        "air": 100 * float((contact[first + FPS :] < 0.5).any(1).float().mean()),
        "began": (float(began) + half) / FPS if len(began) else math.inf,
    }


def of_clip(clip: Clip, contact: Tensor | None = None) -> dict[str, float]:
    """Measures that a recorded take has too, by default with the contacts of
    `toolkit.motion.contacts.detect`.
    """
    contact = contacts.detect(clip) if contact is None else contact
    on = (contact[1:] > 0.5) & (contact[:-1] > 0.5)
    places = clip.global_positions
    at = {part: places[:, [clip.skeleton.role(f"{side}_{part}") for side in FEET]]
          for part in ("hip", "knee", "foot", "toe", "hand")}
    toes, ankles = (at[part].diff(dim=0).norm(dim=-1) * clip.fps * 100
                    for part in ("toe", "foot"))
    thigh, shank = at["knee"] - at["hip"], at["foot"] - at["knee"]
    bend = R.angle(thigh, shank)
    feet = metrics.feet(clip, contact)
    found = {s for it in defects(clip) for s in range(int(it.start), math.ceil(it.end))}
    return {
        "toes": float(toes[on].mean()), "ankle": float(ankles[on].max()) if on.any() else 0.0,
        "knee": float(bend.rad2deg().diff(n=2, dim=0).abs().max()) * clip.fps**2 / 1000,
        "wrist": float(at["hand"].diff(n=3, dim=0).norm(dim=-1).max()) * clip.fps**3 / 1000,
        "slow": slow_motion(clip), "steps": feet["steps"], "clearance": 100 * feet["clearance"],
        "found": 100 * len(found) / math.ceil(clip.seconds),
    }  # fmt: skip


def slow_motion(clip: Clip) -> float:
    """Deviation, cm, of the mean positions over `SLOW` seconds of the upper body, seen from the
    root.
    """
    roots = root_frames(clip)
    joints = [clip.skeleton.role(role) for role in UPPER if role in clip.skeleton.roles]
    points = clip.global_positions[:, joints] - clip.root_positions[:, None] * torch.tensor(
        [1.0, 0.0, 1.0])
    points = R.rotate(R.inverse(roots.rotations)[:, None], points)
    means = points.unfold(0, min(round(SLOW * clip.fps), len(clip)), 1).mean(-1)
    return 100 * float((means - means.mean(0)).square().sum(-1).mean(0).sqrt().mean())


def _print(rows: dict[str, dict[str, float]]) -> None:
    """Rows under titles of measures."""
    titles = {key: title for key, (title, _) in MEASURES.items()}
    print(pd.DataFrame(rows).T.rename(columns=titles).round(3).to_string())


def _summary(key: str, names: Sequence[str], values: list[float]) -> dict[str, float | str]:
    """Median or mean, worst and its style, how many keep the aim."""
    held = torch.tensor(values).nan_to_num(math.inf)
    off = (held - 1).abs() if key == "speed" else -held if key in ("slow", "clearance") else held
    worst, most = int(off.argmax()), MEASURES[key][1]
    middle = held.mean() if key == "found" else held.median()
    return {"median": float(middle), "worst": float(held[worst]), "which": names[worst],
            "kept": len(names) if most is None else int((held <= most).sum())}


def _store(kind: str, found: dict[str, dict[str, float | str]]) -> None:
    """Put the columns of a model into the stored result."""
    columns = {"what": ["eight seconds after three, median and worst of the styles"],
               "most": ["asked", 2]}
    for name in ("published", "embedded", "recorded"):
        columns |= {f"{name}_median": [name, 2], f"{name}_worst": ["worst", 2],
                    f"{name}_which": ["of"], f"{name}_kept": ["kept by", 0]}
    known = {row["what"]: row for row in Result.load(STORED).rows}
    asked = {f"{track}: {MEASURES[key][0]}": MEASURES[key][1]
             for track, keys in TRACKS.items() for key in keys}
    rows = []
    for what, most in asked.items():
        new = {f"{kind}_{key}": value for key, value in found.get(what, {}).items()}
        if what in known or new:
            rows.append({"what": what, "most": most, **known.get(what, {}), **new})
    Result(STORED, "Every style on the same tracks: 99 published styles without Drunk, 25 "
                   "embedded ones, 14 of recorded people; alive is the mean of three seeds",
           "python -m experiments closed-loop [--published FOLDER | --model recorded] --store",
           columns, rows).save()
