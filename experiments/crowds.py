"""Crowds whose characters keep apart, through a gate and in two streams that cross: how near their
bodies come.
"""

import random
import time
from pathlib import Path
from typing import Annotated

import numpy as np
import torch
import typer

from experiments.tables import Result, line
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.extra.shots import Hold, Scene, Shot, apart, crowd
from toolkit.extra.shots.scene import MARGIN
from toolkit.runtime import FPS, CharacterState, world_joints

#: All blends of two of them stand still and walk at `SPEED` in both models.
STYLES = ("Akimbo", "BigSteps", "HighKnees", "LeanBack", "LimpLeft", "Old", "Penguin", "Tiptoe")
# characters of a row; metres between them; metres that roots keep without radii
ROW, ROOM, APART = 10, 2.0, 1.2
WIDTH, SPEED = 3.0, 0.9  # of the gate, metres; m/s
COLUMNS = {
    "model": ["model"], "scene": ["scene"], "width": ["of the gate, m", 1],
    "later": ["seconds between starts", 1],
    "characters": ["characters", 0], "bodies": ["asked between bodies, cm", 0, 100],
    "seed": ["seed", 0], "roots": ["of roots, cm", 0, 100],
    "joints": ["least distance of joints, cm", 0, 100],
    "close": ["frames with joints below 30 cm, %", 1, 100], "arrived": ["arrived", 0],
    "seconds": ["seconds until then", 1], "frame": ["CPU ms a frame", 1],
    "avoiding": ["of these, avoidance", 2],
    "stands": ["check: cannot stand", 0], "says": ["check: gate"],
}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    scene: Annotated[str, typer.Option(help="gate or streams.")] = "gate",
    characters: Annotated[int, typer.Option(min=2, help="Number of characters.")] = 50,
    seeds: Annotated[str,
                     typer.Option(help="Comma-separated seeds of places and blends.")] = "0,2,3",
    width: Annotated[float, typer.Option(min=1.5, help="Of the gate, metres.")] = WIDTH,
    later: Annotated[float,
                     typer.Option(min=0.0,
                                  help="Seconds between two starts; 0: all at once.")] = 0.0,
    bodies: Annotated[float,
                      typer.Option(help="Metres between two bodies; 0: roots keep 1.2 m, "
                                        "whatever the style.")] = 0.4,
    file: Annotated[Path | None,
                    typer.Option(help="Write the first scene here and stop.")] = None,
    save: Annotated[Path | None,
                    typer.Option(help="Add the rows to the result crowds in this folder.")] = None,
) -> None:
    """Crowds that keep apart: least distances, arrivals, milliseconds per frame."""
    net, bank = published.either(model, parameters)
    net, rows = runtime.compile(net), []
    for seed in map(int, seeds.split(",")):
        made = (gate(characters, seed, width, later) if scene == "gate" else
                crowd.streams(bank, characters, seed, styles=STYLES))
        made = made.spaced(net, bank, bodies) if bodies else made
        if file is not None:
            return made.save(file)
        name = "embedded" if parameters is None else "published"
        rows.append({"model": name, "scene": scene,
                     **({"width": width, "later": later} if scene == "gate" else {}),
                     "characters": characters, "bodies": bodies or None, "seed": seed,
                     **said(made.check(net, bank)), **measured(net, bank, made)})
        print(line(COLUMNS, rows[-1]), flush=True)
    if save is not None:
        path, same = save / "crowds.json", ("model", "scene", "width", "later", "characters",
                                            "bodies", "seed")
        known = Result.load("crowds", save).rows if path.exists() else []
        known = [old for old in known
                 if all(any(old.get(key) != row.get(key) for key in same) for row in rows)]
        Result("crowds", "crowds that keep apart; gains were chosen on the gate with seed 1",
               "python -m experiments crowds", COLUMNS, [*known, *rows]).save(save)
    return None


def gate(characters: int, seed: int, width: float = WIDTH, later: float = 0.0) -> Scene:
    """Rows of characters before a gate, whose places behind it are farther apart.

    Each starts so many seconds ``later`` than the one before it: row by row, in each from the
    middle outwards.
    """
    rng, shots = random.Random(seed), []

    def near(x: float, z: float) -> tuple[float, float]:
        return round(x + rng.uniform(-0.1, 0.1), 2), round(z + rng.uniform(-0.1, 0.1), 2)

    for k in range(characters):
        row, column = divmod(k, ROW)
        side = 2 * column / (ROW - 1) - 1
        middle = round(side * (width / 2 - 0.7), 2)
        last = 10 + 1.8 * ((characters - 1) // ROW - row)
        path = [near(side * ROOM * (ROW - 1) / 2, -2 - ROOM * row), (middle, 0), (middle, 0.6),
                near(side * 9, last)]
        first, second = rng.sample(STYLES, 2)
        turn = ROW * row + sorted(range(ROW), key=lambda c: abs(2 * c - ROW + 1)).index(column)
        holds = [Hold(later * turn, time=0)] if later * turn else []
        shots.append(Shot(path, [(0, {first: 0.5, second: 0.5})], [(0, SPEED)], holds, seed=k,
                          name=f"walker {k}"))
    return Scene(shots, APART, [((-12, 0.3), (-width / 2, 0.3)), ((width / 2, 0.3), (12, 0.3))])


def said(lines: list[str]) -> dict[str, int | str]:
    """How many characters cannot stand, as `Scene.check` says, and what it says of the gate."""
    gate = [line.partition(": ")[2] for line in lines if line.startswith("between")]
    return {"stands": len(lines) - len(gate), "says": "; ".join(gate)}


def measured(net, bank, scene: Scene) -> dict[str, float | None]:
    """The numbers of `COLUMNS`: metres, seconds, milliseconds."""
    roots, some, nearest, spent, began = [], [], [], 0.0, time.process_time()
    for frame, state in enumerate(scene.states(net, bank)):
        spent += time.process_time() - began
        roots.append(state.root[:, :2])
        if frame % 10 == 0:
            some.append([values.double().numpy() for values in (state.root[:, :2], state.velocity)])
        if frame % (FPS // 4) == 0:
            nearest.append(_joints(net, state))
        began = time.process_time()
    places, joints = torch.stack(roots), torch.tensor(nearest)  # [F, N, 2]
    away = 1e3 * torch.eye(places.shape[1])
    ends = torch.tensor([(shot.path[-1].x, shot.path[-1].z) for shot in scene.shots])
    there = ((places - ends).norm(dim=-1) < 1.0).int().cummax(0).values.bool()
    last = there.all(1).nonzero()
    walls = np.array([(wall.start, wall.end) for wall in scene.walls])
    began = time.process_time()
    for now, moving in some:
        apart.velocities(now, moving, moving, np.array(scene.radii), walls, MARGIN)
    return {"roots": min(float((torch.cdist(p, p) + away).min()) for p in places),
            "joints": float(joints.min()),
            "close": float((joints < 0.3).float().mean()), "arrived": int(there[-1].sum()),
            "seconds": float(last[0, 0] + 1) / FPS if len(last) else None,
            "frame": 1e3 * spent / len(places),
            "avoiding": 1e3 * (time.process_time() - began) / len(some)}


def _joints(net, state: CharacterState) -> float:
    """The least distance of two joints of different characters, metres."""
    joints = world_joints(net.layout, state)["position"]
    apart = torch.cdist(joints.flatten(0, 1), joints.flatten(0, 1))
    apart = apart.view(len(joints), joints.shape[1], len(joints), -1).amin((1, 3))
    return float((apart + 1e3 * torch.eye(len(joints))).min())
