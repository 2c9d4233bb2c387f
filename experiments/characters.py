"""Walks on rigs of other proportions: how far feet slide, and what the check of defects finds."""

import tempfile
from pathlib import Path

import torch
from posed_rigs import rig, with_twists

from experiments.tables import Result, Store
from toolkit import datasets, runtime, training
from toolkit.evaluation import defects
from toolkit.extra.characters.character import Character
from toolkit.extra.characters.retargeting import report, retarget
from toolkit.extra.engines import gltf
from toolkit.motion import Clip

RIGS = {"child": rig("T-pose", arms=0.55, legs=0.5, hips=0.6),
        "stocky": rig("A-pose", arms=0.9, legs=0.75, hips=1.6),
        "long legs": rig("along y", legs=1.3), "long arms": rig("along x", arms=1.3),
        "narrow": rig("hanging", arms=0.85, legs=1.1, hips=0.7),
        "twist bones": rig("T-pose", joints=with_twists)}
TAKES = ("walk_feminine_001", "walk-turn-left_normal_005", "walk-turn-right_masculine_009",
         "walk-turn-left_active_001", "run_active_001", "run_feminine_001")
COLUMNS: dict[str, list] = {
    "rig": ["rig"], "joints": ["joints", 0], "slide": ["slide, cm/s", 1],
    "slides": ["on the rig", 1], "plain": ["defects a minute", 1],
    "defects": ["with arms out", 1]}


def run(file: list[Path] = [], store: Store = False) -> None:  # noqa: B006
    """Recorded and generated walks on six rigs, and on the characters of files."""
    torch.set_num_threads(1)
    model, bank = training.pretrained()
    course = runtime.follow([(0, 0), (3, 0), (3, 3)], speed=1.0)
    walks = [clip for clip in datasets.load("bandai", dataset=2)
             if clip.name.removeprefix("dataset-2_").removesuffix(".bvh") in TAKES]
    model = runtime.compile(model)
    walks += [runtime.rollout(model, course, style=bank[name]) for name in ("Neutral", "Old")]
    with tempfile.TemporaryDirectory() as folder:
        for name, pose in RIGS.items():
            gltf.save(pose, Path(folder, f"{name}.glb"))
        files = [*(Path(folder, f"{name}.glb") for name in RIGS), *file]
        rows = [row(Character.load(path), path.stem, walks) for path in files]
    Result("characters", "Recorded walks, turns and runs and two walks of the embedded model on "
           "characters of other proportions", "python -m experiments characters --store",
           COLUMNS, rows).show(store)


def row(character: Character, name: str, walks: list[Clip]) -> dict:
    """What happens to the walks on a character."""
    made = [character.fitted(walk) for walk in walks]
    slides = torch.tensor([report(*pair).skate for pair in zip(walks, made, strict=True)])
    plain = [retarget(walk, character.rest) for walk in walks]
    found = [sum(len(defects(clip)) for clip in clips) / sum(clip.seconds for clip in clips) * 60
             for clips in (plain, made)]
    take, rigged = slides.mean(0).tolist()
    return {"rig": name, "joints": len(character.skeleton), "slide": take, "slides": rigged,
            "plain": found[0], "defects": found[1]}
