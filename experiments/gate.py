"""A crowd through a gate: characters who keep apart, each with its own blend, and how near they come to each other."""

import random
import time
from pathlib import Path
from typing import Annotated

import torch
import typer

from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.runtime import FPS, CharacterState, world_joints
from toolkit.shots import Scene, Shot

STYLES = ("Akimbo", "ArmsAboveHead", "BentForward", "BigSteps", "Drunk", "HighKnees", "LeanBack", "LimpLeft", "Neutral",
          "Old", "PendulumHands", "Penguin", "Tiptoe", "WideLegs", "Zombie")  # known to both models
COLUMNS, ROOM, APART = 10, 1.5, 1.2  # characters of a row; metres between them; metres that they try to keep
WIDTH, SPEED = 3.0, 0.9  # of the gate, metres; m/s


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    characters: Annotated[int, typer.Option(min=2, help="Number of characters.")] = 50,
    seed: Annotated[int, typer.Option(help="Seed of places and blends.")] = 0,
    save: Annotated[Path | None, typer.Option(help="Write the scene to this file and stop.")] = None,
) -> None:
    """A crowd through a gate: least distances, whether all pass, milliseconds per frame."""
    scene = gate(characters, seed)
    if save is not None:
        scene.save(save)
        return
    net, bank = published.either(model, parameters)
    for name, value in measured(runtime.compile(net), bank, scene).items():
        print(f"{name:<40}{value:>10.3f}")


def gate(characters: int = 50, seed: int = 0) -> Scene:
    """The scene: rows of characters before a gate, whose places behind it are farther apart."""
    rng, shots = random.Random(seed), []
    for k in range(characters):
        row, column = divmod(k, COLUMNS)
        side = 2 * column / (COLUMNS - 1) - 1
        near = lambda x, z: (round(x + rng.uniform(-0.1, 0.1), 2), round(z + rng.uniform(-0.1, 0.1), 2))  # noqa: E731
        middle = round(side * (WIDTH / 2 - 0.7), 2)
        last = 10 + 1.8 * ((characters - 1) // COLUMNS - row)
        path = [near(side * ROOM * (COLUMNS - 1) / 2, -2 - ROOM * row), (middle, 0), (middle, 0.6), near(side * 9, last)]
        first, second = rng.sample(STYLES, 2)
        shots.append(Shot(path, [(0, {first: 0.5, second: 0.5})], [(0, SPEED)], seed=k, name=f"walker {k}"))
    return Scene(shots, APART, [((-12, 0.3), (-WIDTH / 2, 0.3)), ((WIDTH / 2, 0.3), (12, 0.3))])


def measured(net, bank, scene: Scene) -> dict[str, float]:
    """Distances in metres, times in seconds and milliseconds."""
    began = time.process_time()
    states = list(scene.states(net, bank))
    spent = time.process_time() - began
    places = torch.stack([s.root[:, :2] for s in states])  # [F, N, 2]
    away = 1e3 * torch.eye(places.shape[1])
    apart = torch.stack([(torch.cdist(p, p) + away).min() for p in places])
    line = scene.walls[0].start[1]
    passed = (places[:-1, :, 1] < line) & (places[1:, :, 1] >= line)
    at = places[1:, :, 0][passed].abs()
    return {"least distance of two roots": float(apart.min()),
            "share of frames below 0.5 m": float((apart < 0.5).float().mean()),
            "least distance of two joints": min(_joints(net, state) for state in states[:: FPS // 2]),
            "characters": places.shape[1], "passed": float(passed.any(0).sum()), "farthest from the middle": float(at.max()),
            "seconds until the last has passed": float((passed.any(1).nonzero()[-1, 0] + 1) / FPS),
            "CPU ms per frame": 1e3 * spent / len(states)}


def _joints(net, state: CharacterState) -> float:
    """The least distance of two joints of different characters, metres."""
    joints = world_joints(net.layout, state)["position"]
    apart = torch.cdist(joints.flatten(0, 1), joints.flatten(0, 1))
    apart = apart.view(len(joints), joints.shape[1], len(joints), -1).amin((1, 3))
    return float((apart + 1e3 * torch.eye(len(joints))).min())
