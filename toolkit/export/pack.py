"""A pack of looping cycles for games: styles and blends, each walking forward, back and sideways, running and standing."""

import json
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import torch

import toolkit
from toolkit import runtime
from toolkit.evaluation import metrics
from toolkit.export import gltf
from toolkit.io import bvh
from toolkit.io.files import write_whole
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip, loops
from toolkit.motion.retargeting import retarget
from toolkit.runtime import FPS, Command

MANIFEST = "manifest.json"
SETTLE, WATCH = 4.0, 8.0  # seconds before a cycle is looked for, and in which it is
WRITERS: dict[str, Callable[[Clip, Path], None]] = {"glb": gltf.save, "bvh": bvh.save}


@dataclass(frozen=True)
class Gait:
    """How a character moves in a cycle while it faces +z."""

    direction: tuple[float, float]  # (x to its left, z forward)
    pace: float  # relative to the style's natural speed
    cycle: tuple[float, float] = (0.6, 2.2)  # seconds, shortest and longest


GAITS = {
    "forward": Gait((0.0, 1.0), 1.0), "back": Gait((0.0, -1.0), 0.7), "left": Gait((1.0, 0.0), 0.7),
    "right": Gait((-1.0, 0.0), 0.7), "run": Gait((0.0, 1.0), 2.2), "idle": Gait((0.0, 0.0), 0.0, (1.5, 5.0)),
}


def write(model, bank, folder: str | os.PathLike, styles: Mapping[str, Mapping[str, float]] | Sequence[str], *,
          gaits: Sequence[str] = tuple(GAITS), formats: Sequence[str] = tuple(WRITERS), in_place: bool = False,
          target: Clip | None = None, writers: Mapping[str, Callable[[Clip, Path], None]] = WRITERS,
          progress: bool = False) -> Path:
    """Write the cycles of styles as files, and a manifest of them; returns the manifest's path.

    A cycle is cut from a rollout where it repeats best, and closed (`toolkit.motion.loops`). Its last frame repeats the
    first one, so that a player that loops from the last frame to the first shows each pose for the same time.

    Parameters
    ----------
    model, bank : a model and its style bank
    folder : for the files; it is made. ``manifest.json`` is written last
    styles : names of the bank, or blends by the name that their files get
    gaits : of `GAITS`
    formats : ``"glb"``, ``"bvh"``
    in_place : take the steady movement out of the root; else it stays in
    target : a clip of the rig to put the cycles on (`toolkit.motion.retargeting`); by default the model's skeleton
    writers : by format, function of a clip and the path
    progress : show a bar

    Raises
    ------
    ValueError
        If a style, gait or format is unknown, or two styles get the same file names.
    """
    folder = Path(folder)
    blends = dict(styles) if isinstance(styles, Mapping) else {name: {name: 1.0} for name in styles}
    for what, names, known in (("gait", gaits, GAITS), ("format", formats, writers)):
        if [name for name in names if name not in known] or not names:
            raise ValueError(f"a {what} of a pack is one of {', '.join(known)}; got {', '.join(names) or 'none'}")
    stems = {style: re.sub(r"[^\w.=+-]+", "_", style).strip("._") or "style" for style in blends}
    if len({stem.lower() for stem in stems.values()}) < len(blends) or not blends:
        raise ValueError(f"a pack needs one style or more, with different file names; got {', '.join(blends) or 'none'}")
    vectors = {style: bank.blend(blend) for style, blend in blends.items()}
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for style, blend in progress_bar(blends.items(), desc="pack", unit="style", show=progress):
        pace = bank.speed(blend)
        for gait, cycle in cycles(model, vectors[style], pace, gaits, target):
            closed = loops.in_place(cycle) if in_place else cycle
            named = closed.replace(style=style, gait=gait, name=f"{stems[style]}_{gait}")
            files = {kind: f"{stems[style]}_{gait}.{kind}" for kind in formats}
            for kind, name in files.items():
                writers[kind](named, folder / name)
            rows.append({"style": style, "blend": dict(blend), "gait": gait, "files": files} | facts(cycle))
    skeleton = (model.layout.skeleton if target is None else target.skeleton)
    about = {"generator": f"toolkit {toolkit.__version__}", "root_motion": not in_place, "fps": FPS, "unit": "metre",
             "up": "y", "forward": "z", "last_frame_repeats_first": True, "joints": list(skeleton.names), "clips": rows}
    write_whole(folder / MANIFEST, (json.dumps(about, indent=1, ensure_ascii=False) + "\n").encode())
    return folder / MANIFEST


def cycles(model, vector: torch.Tensor, speed: float, gaits: Sequence[str] = tuple(GAITS),
           target: Clip | None = None) -> list[tuple[str, Clip]]:
    """The closed cycle of each gait, of a style vector ``[S]`` and its natural speed in m/s."""
    moves = torch.tensor([[speed * GAITS[gait].pace * axis for axis in GAITS[gait].direction] for gait in gaits])
    facing = torch.tensor([[0.0, 1.0]]).expand(len(gaits), 2)
    commands = [Command(moves, facing)] * round((SETTLE + WATCH) * FPS)
    states = list(runtime.states(model, commands, vector[None].expand(len(gaits), -1)))[round(SETTLE * FPS) :]
    made = []
    for row, gait in enumerate(gaits):
        clip = runtime.record(model, states, character=row)
        clip = clip if target is None else retarget(clip, target)
        phases = torch.stack([state.phase[row] for state in states])
        cycle = loops.close(clip, *loops.find(clip, *GAITS[gait].cycle, phases))
        made.append((gait, loops.in_place(cycle) if GAITS[gait].pace == 0 else cycle))
    return made


def facts(cycle: Clip) -> dict:
    """Speed, duration, loop error and foot skate of a closed cycle, for the manifest."""
    seconds = (len(cycle) - 1) / cycle.fps
    x, _, z = (cycle.root_positions[-1] - cycle.root_positions[0]).tolist()
    found = loops.seam(cycle)
    return {
        "frames": len(cycle), "duration": round(seconds, 4), "speed": round((x * x + z * z) ** 0.5 / seconds, 3),
        "displacement": [round(x, 4), round(z, 4)],
        "loop_error": {"position_cm": round(100 * found.position, 3), "velocity_cm_s": round(100 * found.velocity, 2),
                       "ordinary_velocity_change_cm_s": round(100 * found.ordinary, 2)},
        "foot_skate_cm_s": round(100 * max(metrics.foot_skate(loops.repeated(cycle, 3)).values()), 2),
    }
