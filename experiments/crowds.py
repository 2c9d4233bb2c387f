"""Crowds whose characters keep apart, through gates, in streams that cross, over a circle and from
random places to others: how near they come, beside the same crowds who do not see each other.
"""

import dataclasses
import math
import random
import time
from typing import Annotated

import numpy as np
import torch
import typer

from experiments.tables import Result, Store, line
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.extra.shots import Scene, Shot
from toolkit.runtime import FPS, CharacterState, world_joints

#: All blends of two of them stand still and walk at `SPEED` in both models.
STYLES = ("Akimbo", "BigSteps", "HighKnees", "LeanBack", "LimpLeft", "Old", "Penguin", "Tiptoe")
ROW, ROOM = 10, 2.0  # characters of a row; metres between them
SPEED = 0.9  # m/s
PARTS = 10, 50, 90  # percentiles of the distribution
COLUMNS = {
    "scene": ["crowd"], "scenes": ["scenes", 0],
    "kept": ["kept", 0], "said": ["broken, but said before", 0],
    "least": ["least distance, cm", 1, 100], "floor": ["without avoidance, cm", 1, 100],
    "spread": ["nearest neighbour, cm, 10, 50 and 90 %"], "joints": ["of joints, cm", 0, 100],
    "arrived": ["arrived, %", 0, 100], "frame": ["CPU ms a frame", 1],
}  # fmt: skip

SEEDS, APART = range(21, 26), 0.7  # of random scenes; metres between roots


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    scenes: Annotated[str, typer.Option(help="Comma-separated.")] =
    "gate,streams,circle,swarm",
    characters: Annotated[str, typer.Option(help="Comma-separated numbers.")] = "10,30,100",
    store: Store = False,
) -> None:
    """Crowds that keep apart: least distances, arrivals, milliseconds per frame."""
    net, bank = published.either(model, parameters)
    net, rows = runtime.compile(net), []
    made = {"gate": gate, "streams": streams, "circle": circle, "swarm": swarm}
    for name in scenes.split(","):
        for many in map(int, characters.split(",")):
            found = []
            for seed in SEEDS:
                scene = made[name](many, seed, APART)
                blind = dataclasses.replace(scene, apart=None, walls=())
                found.append(measured(net, bank, scene, scene.radii) | {
                    "said": bool(scene.check(net, bank)),
                    "floor": measured(net, bank, blind, scene.radii)["least"]})
            kept = [one["least"] >= 0 for one in found]
            parts = np.percentile(np.concatenate([one["near"] for one in found]), PARTS)
            rows.append({
                "scene": f"{name} of {many}", "scenes": len(found), "kept": sum(kept),
                "said": sum(one["said"] and not k for one, k in zip(found, kept, strict=True)),
                "least": APART + min(one["least"] for one in found),
                "floor": APART + min(one["floor"] for one in found),
                "spread": ", ".join(f"{100 * (APART + part):.0f}" for part in parts),
                **{key: float(np.mean([one[key] for one in found]))
                   for key in ("joints", "arrived", "frame")}})
            print(line(COLUMNS, rows[-1]), flush=True)
    if store:
        Result("crowds", f"Random scenes whose roots keep {APART} m, of the embedded model; the "
               "gains of the avoidance were set on other seeds.",
               "python -m experiments crowds --store", COLUMNS, rows).add()


def shot(path: list[tuple[float, float]], rng: random.Random, seed: int) -> Shot:
    """A walk of a random blend of two styles."""
    first, second = rng.sample(STYLES, 2)
    return Shot(path, [(0, {first: 0.5, second: 0.5})], [(0, SPEED)], seed=seed,
                name=f"walker {seed}")


def circle(characters: int, seed: int, apart: float) -> Scene:
    """Characters on a circle, who all walk to the opposite side of it."""
    rng, shots = random.Random(seed), []
    radius = max(4.0, 2.0 * apart * characters / math.tau)
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


def streams(characters: int, seed: int, apart: float) -> Scene:
    """Two streams of rows that cross at a random angle."""
    rng, shots = random.Random(seed), []
    turn, deep = rng.uniform(0.5, math.pi), math.ceil(characters / 10)
    for k in range(characters):
        row, column = divmod(k // 2, 5)
        aside, back, ahead = (value + rng.uniform(-0.2, 0.2) for value in (
            1.6 * (column - 2), -7 - 1.6 * row, 9 + 1.6 * (deep - row)))
        angle = turn * (k % 2)
        ends = [(round(aside * math.cos(angle) + along * math.sin(angle), 2),
                 round(along * math.cos(angle) - aside * math.sin(angle), 2))
                for along in (back, ahead)]
        shots.append(shot(ends, rng, k))
    return Scene(shots, apart)


def gate(characters: int, seed: int, apart: float) -> Scene:
    """Rows of characters before a gate, whose places behind it are farther apart."""
    rng, shots = random.Random(seed), []
    half = rng.uniform(1.2, 2.0)  # of the gate's width, metres

    def near(x: float, z: float) -> tuple[float, float]:
        return round(x + rng.uniform(-0.1, 0.1), 2), round(z + rng.uniform(-0.1, 0.1), 2)

    for k in range(characters):
        row, column = divmod(k, ROW)
        side = 2 * column / (ROW - 1) - 1
        middle = round(side * (half - 0.7), 2)
        last = 10 + 1.8 * ((characters - 1) // ROW - row)
        shots.append(shot([near(side * ROOM * (ROW - 1) / 2, -2 - ROOM * row), (middle, 0),
                           (middle, 0.6), near(side * 9, last)], rng, k))
    return Scene(shots, apart, [((-12, 0.3), (-half, 0.3)), ((half, 0.3), (12, 0.3))])


def measured(net, bank, scene: Scene, radii: list[float]) -> dict:
    """The numbers of `COLUMNS`, metres beyond the distances that ``radii`` ask for."""
    near, nearest, spent, began = [], [], 0.0, time.process_time()
    ends = torch.tensor([(shot.path[-1].x, shot.path[-1].z) for shot in scene.shots])
    spare = torch.tensor(radii)
    spare = 1e3 * torch.eye(len(ends)) - spare[:, None] - spare
    there = torch.zeros(len(ends), dtype=torch.bool)
    for frame, state in enumerate(scene.states(net, bank)):
        spent += time.process_time() - began
        places = state.root[:, :2]
        near.append((torch.cdist(places, places) + spare).amin(1))
        there |= (places - ends).norm(dim=-1) < 1.0
        if frame % FPS == 0:
            nearest.append(_joints(state))
        began = time.process_time()
    return {"near": torch.cat(near[::6]).numpy(), "least": float(torch.stack(near).min()),
            "joints": min(nearest), "arrived": float(there.float().mean()),
            "frame": 1e3 * spent / len(near)}


def _joints(state: CharacterState) -> float:
    """The least distance of two joints of different characters, metres."""
    joints = world_joints(state.joints, state.root)["position"]
    apart = torch.cdist(joints.flatten(0, 1), joints.flatten(0, 1))
    apart = apart.view(len(joints), joints.shape[1], len(joints), -1).amin((1, 3))
    return float((apart + 1e3 * torch.eye(len(joints))).min())
