"""Crowds whose characters keep apart, through a gate and in two streams that cross: how near their
bodies come.
"""

import math
import random
import time
from typing import Annotated

import numpy as np
import torch
import typer

from experiments.tables import line
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.extra.shots import Scene, Shot, apart, crowd
from toolkit.runtime import FPS, CharacterState, world_joints

#: All blends of two of them stand still and walk at `SPEED` in both models.
STYLES = ("Akimbo", "BigSteps", "HighKnees", "LeanBack", "LimpLeft", "Old", "Penguin", "Tiptoe")
ROW, ROOM = 10, 2.0  # characters of a row; metres between them
WIDTH, SPEED = 3.0, 0.9  # of the gate, metres; m/s
COLUMNS = {
    "scene": ["scene"], "characters": ["characters", 0], "seed": ["seed", 0],
    "asked": ["asked, cm", 0, 100], "least": ["least distance less the asked one, cm", 1, 100],
    "wall": ["least distance of a wall, cm", 0, 100],
    "joints": ["of joints, cm", 0, 100],
    "close": ["frames with joints below 30 cm, %", 1, 100], "arrived": ["arrived", 0],
    "seconds": ["seconds until then", 1], "frame": ["CPU ms a frame", 1],
    "stands": ["check: cannot stand", 0], "says": ["check: gate"],
}  # fmt: skip


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    scenes: Annotated[str, typer.Option(help="Comma-separated: gate, streams, circle, swarm.")] =
    "gate,streams,circle,swarm",
    characters: Annotated[str, typer.Option(help="Comma-separated numbers.")] = "10,30,100",
    seeds: Annotated[str,
                     typer.Option(help="Comma-separated seeds of places and blends.")] = "0,2,3",
    keep: Annotated[float, typer.Option(min=0.1, help="Metres between roots.")] = 0.7,
    bodies: Annotated[float, typer.Option(
        help="Metres between bodies, each with the reach of its styles; 0: between roots.")] = 0.0,
) -> None:
    """Crowds that keep apart: least distances, arrivals, milliseconds per frame.

    In a gate and in two streams, on a circle that all cross, and from random places to others.
    """
    net, bank = published.either(model, parameters)
    net, rows = runtime.compile(net), []
    made = {"gate": gate, "circle": circle, "swarm": swarm,
            "streams": lambda many, seed, apart: crowd.streams(bank, many, seed, styles=STYLES,
                                                               apart=apart)}
    for name in scenes.split(","):
        for many in map(int, characters.split(",")):
            for seed in map(int, seeds.split(",")):
                scene = made[name](many, seed, keep)
                scene = scene.spaced(net, bank, bodies) if bodies else scene
                rows.append({"scene": name, "characters": many, "seed": seed, "asked": scene.apart,
                             **said(scene.check(net, bank)), **measured(net, bank, scene)})
                print(line(COLUMNS, rows[-1]), flush=True)
    kept = sum(row["least"] >= 0 or bool(row["says"]) for row in rows)
    print(f"kept, or said before, in {kept} of {len(rows)} scenes; "
          f"kept in {sum(row['least'] >= 0 for row in rows)}")


def shot(path: list[tuple[float, float]], rng: random.Random, seed: int) -> Shot:
    """A walk of a random blend of two styles."""
    first, second = rng.sample(STYLES, 2)
    return Shot(path, [(0, {first: 0.5, second: 0.5})], [(0, SPEED)], seed=seed,
                name=f"walker {seed}")


def circle(characters: int, seed: int, apart: float) -> Scene:
    """Characters on a circle, who all walk to the opposite side of it."""
    rng, shots = random.Random(seed), []
    radius = max(4.0, 1.5 * apart * characters / math.tau)
    for k in range(characters):
        angle = math.tau * (k + rng.uniform(-0.2, 0.2)) / characters
        x, z = round(radius * math.sin(angle), 2), round(radius * math.cos(angle), 2)
        shots.append(shot([(x, z), (-x, -z)], rng, k))
    return Scene(shots, apart)


def swarm(characters: int, seed: int, apart: float) -> Scene:
    """Characters who walk from random places of a square to others of it."""
    rng, side = random.Random(seed), 2.5 * apart * math.sqrt(characters)

    def places() -> list[tuple[float, float]]:
        found = []
        while len(found) < characters:
            place = round(rng.uniform(0, side), 2), round(rng.uniform(0, side), 2)
            if all(math.dist(place, other) > 1.1 * apart for other in found):
                found.append(place)
        return found

    return Scene([shot([a, b], rng, k) for k, (a, b) in enumerate(zip(places(), places(),
                                                                      strict=True))
                  if math.dist(a, b) > 0.1], apart)


def gate(characters: int, seed: int, apart: float) -> Scene:
    """Rows of characters before a gate, whose places behind it are farther apart."""
    rng, shots = random.Random(seed), []

    def near(x: float, z: float) -> tuple[float, float]:
        return round(x + rng.uniform(-0.1, 0.1), 2), round(z + rng.uniform(-0.1, 0.1), 2)

    for k in range(characters):
        row, column = divmod(k, ROW)
        side = 2 * column / (ROW - 1) - 1
        middle = round(side * (WIDTH / 2 - 0.7), 2)
        last = 10 + 1.8 * ((characters - 1) // ROW - row)
        shots.append(shot([near(side * ROOM * (ROW - 1) / 2, -2 - ROOM * row), (middle, 0),
                           (middle, 0.6), near(side * 9, last)], rng, k))
    return Scene(shots, apart, [((-12, 0.3), (-WIDTH / 2, 0.3)), ((WIDTH / 2, 0.3), (12, 0.3))])


def said(lines: list[str]) -> dict[str, int | str]:
    """How many characters cannot stand, as `Scene.check` says, and what it says of the gate."""
    gate = [line.partition(": ")[2] for line in lines if line.startswith("between")]
    return {"stands": sum(line.endswith("cannot wait") for line in lines), "says": "; ".join(gate)}


def measured(net, bank, scene: Scene) -> dict[str, float | None]:
    """The numbers of `COLUMNS`: metres, seconds, milliseconds."""
    roots, nearest, spent, began = [], [], 0.0, time.process_time()
    for frame, state in enumerate(scene.states(net, bank)):
        spent += time.process_time() - began
        roots.append(state.root[:, :2])
        if frame % (FPS // 4) == 0:
            nearest.append(_joints(net, state))
        began = time.process_time()
    places, joints = torch.stack(roots), torch.tensor(nearest)  # [F, N, 2]
    radii = torch.tensor(scene.radii)
    spare = 1e3 * torch.eye(places.shape[1]) - radii[:, None] - radii
    ends = torch.tensor([(shot.path[-1].x, shot.path[-1].z) for shot in scene.shots])
    there = ((places - ends).norm(dim=-1) < 1.0).int().cummax(0).values.bool()
    last = there.all(1).nonzero()
    walls = [apart.to_wall(places.flatten(0, 1).double().numpy(), *map(np.array, wall))
             for wall in [(wall.start, wall.end) for wall in scene.walls]]
    return {"least": min(float((torch.cdist(p, p) + spare).min()) for p in places),
            "wall": min((float(np.linalg.norm(to, axis=-1).min()) for to in walls), default=None),
            "joints": float(joints.min()),
            "close": float((joints < 0.3).float().mean()), "arrived": int(there[-1].sum()),
            "seconds": float(last[0, 0] + 1) / FPS if len(last) else None,
            "frame": 1e3 * spent / len(places)}


def _joints(net, state: CharacterState) -> float:
    """The least distance of two joints of different characters, metres."""
    joints = world_joints(net.layout, state)["position"]
    apart = torch.cdist(joints.flatten(0, 1), joints.flatten(0, 1))
    apart = apart.view(len(joints), joints.shape[1], len(joints), -1).amin((1, 3))
    return float((apart + 1e3 * torch.eye(len(joints))).min())
