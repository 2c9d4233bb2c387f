"""Crowds whose characters keep apart, through a gate and in two streams that cross: how near their bodies come."""

import random
import time
from pathlib import Path
from typing import Annotated

import numpy as np
import torch
import typer

from experiments.tables import Result
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.runtime import FPS, CharacterState, world_joints
from toolkit.shots import Scene, Shot, apart, crowd
from toolkit.shots.scene import MARGIN

STYLES = ("Akimbo", "ArmsAboveHead", "BentForward", "BigSteps", "Drunk", "HighKnees", "LeanBack", "LimpLeft", "Neutral",
          "Old", "PendulumHands", "Penguin", "Tiptoe", "WideLegs", "Zombie")  # known to both models
ROW, ROOM, APART = 10, 2.0, 1.2  # characters of a row; metres between them; metres that roots keep without radii
WIDTH, SPEED = 3.0, 0.9  # of the gate, metres; m/s
COLUMNS = {
    "model": ["model"], "scene": ["scene"], "width": ["of the gate, m", 1],
    "characters": ["characters", 0], "bodies": ["asked between bodies, cm", 0, 100],
    "seed": ["seed", 0], "roots": ["least distance of roots, cm", 0, 100], "joints": ["of joints, cm", 0, 100],
    "close": ["frames with joints below 30 cm, %", 1, 100], "arrived": ["arrived", 0],
    "seconds": ["seconds until then", 1], "frame": ["CPU ms a frame", 1], "avoiding": ["of these, avoidance", 2],
}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    scene: Annotated[str, typer.Option(help="gate or streams.")] = "gate",
    characters: Annotated[int, typer.Option(min=2, help="Number of characters.")] = 50,
    seeds: Annotated[str, typer.Option(help="Comma-separated seeds of places and blends.")] = "0,2,3",
    width: Annotated[float, typer.Option(min=1.5, help="Of the gate, metres.")] = WIDTH,
    bodies: Annotated[float, typer.Option(help="Metres between two bodies; 0: roots keep 1.2 m, whatever the style.")] = 0.4,
    file: Annotated[Path | None, typer.Option(help="Write the scene of the first seed to this file and stop.")] = None,
    save: Annotated[Path | None, typer.Option(help="Add the rows to the result crowds in this folder.")] = None,
) -> None:
    """Crowds that keep apart: least distances, arrivals, milliseconds per frame."""
    net, bank = published.either(model, parameters)
    net, rows = runtime.compile(net), []
    for seed in map(int, seeds.split(",")):
        made = gate(characters, seed, width) if scene == "gate" else crowd.streams(bank, characters, seed, styles=STYLES)
        made = made.spaced(net, bank, bodies) if bodies else made
        if file is not None:
            return made.save(file)
        name = "embedded" if parameters is None else "published"
        rows.append({"model": name, "scene": scene, "width": width if scene == "gate" else None,
                     "characters": characters, "bodies": bodies or None, "seed": seed,
                     **measured(net, bank, made)})
        print("  ".join(f"{COLUMNS[key][0]}: {value:.4g}" if isinstance(value, float) else f"{COLUMNS[key][0]}: {value}"
                        for key, value in rows[-1].items()), flush=True)
    if save is not None:
        path, same = save / "crowds.json", ("model", "scene", "width", "characters", "bodies", "seed")
        known = Result.load("crowds", save).rows if path.exists() else []
        known = [old for old in known if all(any(old.get(key) != row[key] for key in same) for row in rows)]
        Result("crowds", "crowds that keep apart; gains were chosen on the gate with seed 1",
               "python -m experiments crowds", COLUMNS, [*known, *rows]).save(save)
    return None


def gate(characters: int, seed: int, width: float = WIDTH) -> Scene:
    """Rows of characters before a gate, whose places behind it are farther apart."""
    rng, shots = random.Random(seed), []
    for k in range(characters):
        row, column = divmod(k, ROW)
        side = 2 * column / (ROW - 1) - 1
        near = lambda x, z: (round(x + rng.uniform(-0.1, 0.1), 2), round(z + rng.uniform(-0.1, 0.1), 2))  # noqa: E731
        middle = round(side * (width / 2 - 0.7), 2)
        last = 10 + 1.8 * ((characters - 1) // ROW - row)
        path = [near(side * ROOM * (ROW - 1) / 2, -2 - ROOM * row), (middle, 0), (middle, 0.6), near(side * 9, last)]
        first, second = rng.sample(STYLES, 2)
        shots.append(Shot(path, [(0, {first: 0.5, second: 0.5})], [(0, SPEED)], seed=k, name=f"walker {k}"))
    return Scene(shots, APART, [((-12, 0.3), (-width / 2, 0.3)), ((width / 2, 0.3), (12, 0.3))])


def measured(net, bank, scene: Scene) -> dict[str, float | None]:
    """The numbers of `COLUMNS`: metres, seconds, milliseconds."""
    began = time.process_time()
    states = list(scene.states(net, bank))
    spent = time.process_time() - began
    places = torch.stack([s.root[:, :2] for s in states])  # [F, N, 2]
    away = 1e3 * torch.eye(places.shape[1])
    ends = torch.tensor([(shot.path[-1].x, shot.path[-1].z) for shot in scene.shots])
    there = ((places - ends).norm(dim=-1) < 1.0).int().cummax(0).values.bool()
    last = there.all(1).nonzero()
    joints = torch.tensor([_joints(net, state) for state in states[:: FPS // 4]])
    walls = np.array([(wall.start, wall.end) for wall in scene.walls])
    began, some = time.process_time(), states[::10]
    for state in some:
        now, moving = (values.double().numpy() for values in (state.root[:, :2], state.velocity))
        apart.velocities(now, moving, moving, np.array(scene.radii), walls, MARGIN)
    return {"roots": min(float((torch.cdist(p, p) + away).min()) for p in places), "joints": float(joints.min()),
            "close": float((joints < 0.3).float().mean()), "arrived": int(there[-1].sum()),
            "seconds": float(last[0, 0] + 1) / FPS if len(last) else None, "frame": 1e3 * spent / len(states),
            "avoiding": 1e3 * (time.process_time() - began) / len(some)}


def _joints(net, state: CharacterState) -> float:
    """The least distance of two joints of different characters, metres."""
    joints = world_joints(net.layout, state)["position"]
    apart = torch.cdist(joints.flatten(0, 1), joints.flatten(0, 1))
    apart = apart.view(len(joints), joints.shape[1], len(joints), -1).amin((1, 3))
    return float((apart + 1e3 * torch.eye(len(joints))).min())
