"""A pack of looping cycles for games: styles and blends, walking, running and standing."""

import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import torch

import toolkit
from toolkit import registry, runtime
from toolkit.evaluation import metrics
from toolkit.extra.characters.retargeting import retarget
from toolkit.extra.engines import gltf, loops
from toolkit.io import bvh
from toolkit.io.files import write_whole
from toolkit.io.progress import progress_bar
from toolkit.motion import Clip
from toolkit.runtime import FPS, Command

MANIFEST = "manifest.json"
SETTLE, WATCH = 4.0, 8.0  # seconds before a cycle is looked for, and in which it is
FORMATS = ("glb", "bvh")


@dataclass(frozen=True)
class Gait:
    """How a character moves in a cycle while it faces +z."""

    direction: tuple[float, float]  # (x to its left, z forward)
    pace: float  # relative to the style's natural speed
    cycle: tuple[float, float] = (0.6, 2.2)  # seconds, shortest and longest


GAITS = {
    "forward": Gait((0.0, 1.0), 1.0), "back": Gait((0.0, -1.0), 0.7), "left": Gait((1.0, 0.0), 0.7),
    "right": Gait((-1.0, 0.0), 0.7), "run": Gait((0.0, 1.0), 2.2),
    "idle": Gait((0.0, 0.0), 0.0, (1.5, 5.0)),
}


def write(model, bank, folder: str | os.PathLike,
          styles: Mapping[str, Mapping[str, float]] | Sequence[str], *,
          gaits: Sequence[str] = tuple(GAITS), formats: Sequence[str] = FORMATS,
          in_place: bool = False, target: Clip | None = None, character=None,
          progress: bool = False) -> Path:
    """Write the cycles of styles as files, and a manifest of them; returns the manifest's path.

    A cycle is cut from a rollout where it repeats best, and closed (`toolkit.extra.engines.loops`).
    Its last frame repeats the first one, so that a player that loops from the last frame to the
    first shows each pose for the same time.

    Parameters
    ----------
    model, bank : a model and its style bank
    folder : for the files; it is made. ``manifest.json`` is written last
    styles : names of the bank, or blends by the name that their files get
    gaits, formats : of `GAITS` and `FORMATS`
    in_place : take the steady movement out of the root; else it stays in
    target : a clip of the rig to put the cycles on; by default the model's skeleton
    character : a `Character` in place of the mannequin, whose rig is the target
    progress : show a bar

    Raises
    ------
    ValueError
        If a style, gait or format is unknown, or two styles get the same file names.
    """
    folder = Path(folder)
    blends = styles if isinstance(styles, Mapping) else {name: {name: 1.0} for name in styles}
    for what, names, known in (("gait", gaits, GAITS), ("format", formats, FORMATS)):
        if not names or not set(names) <= set(known):
            raise ValueError(f"a {what} of a pack is one of {', '.join(known)}; "
                             f"got {', '.join(names) or 'none'}")
    stems = {style: re.sub(r"[^\w.=+-]+", "_", style).strip("._") or "style" for style in blends}
    if len({stem.lower() for stem in stems.values()}) < len(blends) or not blends:
        raise ValueError("a pack needs one style or more, with different file names; "
                         f"got {', '.join(blends) or 'none'}")
    vectors = {style: bank.blend(blend) for style, blend in blends.items()}
    target = target if character is None else character.rest
    folder.mkdir(parents=True, exist_ok=True)

    rows = []
    for style, blend in progress_bar(blends.items(), desc="pack", unit="style", show=progress):
        for gait, cycle in cycles(model, vectors[style], bank.speed(blend), gaits, target):
            name = f"{stems[style]}_{gait}"
            clip = loops.in_place(cycle) if in_place else cycle
            clip = clip.replace(style=style, gait=gait, name=name)
            files = {kind: f"{name}.{kind}" for kind in formats}
            for kind, file in files.items():
                if kind == "bvh":
                    bvh.save(clip, folder / file)
                elif character is None:
                    gltf.save(clip, folder / file)
                else:
                    registry.find("character.save")(clip, folder / file, character)
            row = {"style": style, "blend": dict(blend), "gait": gait, "files": files}
            rows.append(row | facts(cycle))
    skeleton = model.layout.skeleton if target is None else target.skeleton
    about = {"generator": f"toolkit {toolkit.__version__}", "root_motion": not in_place, "fps": FPS,
             "unit": "metre", "up": "y", "forward": "z", "last_frame_repeats_first": True,
             "joints": list(skeleton.names), "clips": rows}
    text = json.dumps(about, indent=1, ensure_ascii=False) + "\n"
    write_whole(folder / MANIFEST, text.encode())
    return folder / MANIFEST


def cycles(model, vector: torch.Tensor, speed: float, gaits: Sequence[str],
           target: Clip | None) -> list[tuple[str, Clip]]:
    """The closed cycle of each gait, of a style vector ``[S]`` and its natural speed in m/s."""
    moves = torch.tensor([GAITS[gait].direction for gait in gaits])
    moves = moves * speed * torch.tensor([[GAITS[gait].pace] for gait in gaits])
    facing = torch.tensor([[0.0, 1.0]]).expand(len(gaits), 2)
    commands = [Command(moves, facing)] * round((SETTLE + WATCH) * FPS)
    states = list(runtime.states(model, commands, vector[None].expand(len(gaits), -1)))
    states = states[round(SETTLE * FPS) :]
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
        "frames": len(cycle), "duration": round(seconds, 4),
        "speed": round((x * x + z * z) ** 0.5 / seconds, 3),
        "displacement": [round(x, 4), round(z, 4)],
        "loop_error": {"position_cm": round(100 * found.position, 3),
                       "velocity_cm_s": round(100 * found.velocity, 2),
                       "ordinary_velocity_change_cm_s": round(100 * found.ordinary, 2)},
        "foot_skate_cm_s": round(100 * max(metrics.foot_skate(loops.repeated(cycle, 3)).values()),
                                 2),
    }
