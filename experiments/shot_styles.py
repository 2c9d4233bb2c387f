"""Whether the styles that shots ask for are recognised at their keys, in the example shots and in shots drawn at random."""

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import torch
import typer
from torch import Tensor

from experiments.drawn_shots import draw
from experiments.shots import FOLDER
from experiments.tables import Result
from toolkit import datasets, features, published, runtime
from toolkit.cli import verbs
from toolkit.evaluation import recognition
from toolkit.evaluation.recognition import WINDOW, Recogniser
from toolkit.runtime import FPS
from toolkit.shots import Scene, Shot, StyleKey

GAITS, SECONDS = ("FW",), 12.0  # of the procedural clips that train a recogniser
LEAST = 0.3  # share of a blend from which a style counts as asked for
COLUMNS = {
    "model": ["model"], "shots": ["shots"], "keys": ["keys of one style", 0], "right": ["recognised", 0],
    "changes": ["of these, other than the key before", 0], "changed": ["recognised", 0],
    "before": ["recognised without the key", 0], "blends": ["keys of two styles", 0],
    "either": ["one of the two recognised", 0],
    "styles": ["styles of the recogniser", 0],
}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    judge: Annotated[Path | None, typer.Option(help="Recogniser; by default trained on procedural clips.")] = None,
    count: Annotated[int, typer.Option(help="Number of shots drawn at random.")] = 16,
    save: Annotated[Path | None, typer.Option(help="Write the rows to docs/results in this folder.")] = None,
) -> None:
    """Styles recognised in the second after each key of shots; floors: chance, and the same shot without the key."""
    net, bank = published.either(model, parameters)
    net, seen = runtime.compile(net), Recogniser.load(judge) if judge else trained()
    name = "embedded" if parameters is None else "published"
    examples = (Scene.load(file) for file in sorted(FOLDER.glob("*.json")))
    scenes = {"examples": [scene for scene in examples if scene.apart is None],
              "drawn": [Scene([draw(2 * k + 1, bank) for k in range(count)])]}
    rows = [{"model": name, "shots": kind, **counted(net, bank, seen, made), "styles": len(seen.styles)}
            for kind, made in scenes.items()]
    for row in rows:
        print("  ".join(f"{COLUMNS[key][0]}: {value}" for key, value in row.items()))
    if save is not None:
        known = Result.load("shot-styles", save).rows if (save / "shot-styles.json").exists() else []
        Result("shot-styles", "styles at the keys of the examples and of shots drawn at random, in the second after each",
               "python -m experiments shot-styles", COLUMNS, [*(r for r in known if r["model"] != name), *rows]).save(save)


def trained() -> Recogniser:
    """A recogniser of the procedural styles."""
    return recognition.train(features.build(datasets.load("procedural", gaits=GAITS, seconds=SECONDS)))


def counted(net, bank, seen: Recogniser, scenes: Sequence[Scene]) -> dict[str, int]:
    """How many keys there are and are recognised, see `COLUMNS`."""
    found = dict.fromkeys(("keys", "right", "changes", "changed", "before", "blends", "either"), 0)
    held: list[tuple[Shot, StyleKey]] = []
    for scene in scenes:
        joints = _joints(net, bank, scene)
        for k, shot in enumerate(scene.shots):
            for i, key in enumerate(shot.styles):
                asked = _asked(key)
                if i and round(key.time * FPS) > len(joints[k]) - WINDOW // 2:
                    continue  # after the end of the shot
                right = _guess(seen, joints[k], key) in asked
                if len(asked) > 1:
                    found["blends"] += 1
                    found["either"] += right
                    continue
                found["keys"] += 1
                found["right"] += right
                if i and _asked(shot.styles[i - 1]) != asked:
                    found["changes"] += 1
                    found["changed"] += right
                    held.append((dataclasses.replace(shot, styles=shot.styles[:i]), key))
    if held:
        joints = _joints(net, bank, Scene([shot for shot, _ in held]))
        found["before"] = sum(_guess(seen, joints[k], key) in _asked(key) for k, (_, key) in enumerate(held))
    return found


def _asked(key: StyleKey) -> set[str]:
    return {name for layer in key.layers for name, share in layer.items() if share >= LEAST}


def _joints(net, bank, scene: Scene) -> list[Tensor]:
    """Joint features ``[F, 12 J]`` of each character while its shot lasts."""
    plans = [shot.plan(bank) for shot in scene.shots]
    joints = torch.stack([state.joints for state in scene.states(net, bank, plans)], 1)
    return [own[: len(course.distance) - 1] for own, (course, _) in zip(joints, plans, strict=True)]


def _guess(seen: Recogniser, joints: Tensor, key: StyleKey) -> str:
    """The most probable style in the second after a key; after a start from standing, in the second thereafter."""
    first = min(round(key.time * FPS) or WINDOW, len(joints) - WINDOW)
    return seen.styles[int(seen.probabilities(joints[max(first, 0) :][:WINDOW]).argmax())]
