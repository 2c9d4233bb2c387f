"""How equal the motions of shots are in a page and in Python: distances from plain Python in double precision."""

import copy
import dataclasses
import json
import shutil
import subprocess
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.shots import FOLDER
from experiments.speed.page import SCENE
from experiments.tables import Result, line
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.shots import Scene, Shot, data
from toolkit.view import director

SECONDS = 10.0  # that are compared, at most
COLUMNS = {"shot": ["shot"], "frames": ["frames", 0],
           **{f"{kind} {part}": [f"{title}: {part}, mm", decimals, 1000] for kind, title, decimals in
              (("page", "page", 6), ("single", "float32", 2), ("compiled", "compiled", 2)) for part in ("root", "joint")}}
SCRIPT = """
import { readFileSync, writeFileSync } from "node:fs";
const [given, made] = process.argv.slice(2), { data, shots } = JSON.parse(readFileSync(given));
const { Desk } = await import("SCENE/desk.js");
const motions = shots.map((shot) => new Desk(data, shot, () => {}).motion(0));
writeFileSync(made, JSON.stringify(motions.map((poses) => poses.map(([root, turns]) => [[...root], [...turns]]))));
process.exit();
"""


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    folder: Annotated[Path, typer.Option(help="Folder of shot files.")] = FOLDER,
    save: Annotated[Path | None, typer.Option(help="Write the result shot-equality in this folder.")] = None,
) -> None:
    """Distances from plain Python in double precision in ten seconds: page (Node), plain in float32, compiled."""
    net, bank = published.either(model, parameters)
    scenes = [Scene.load(file) for file in sorted(folder.glob("*.json"))]
    shots = [dataclasses.replace(shot, duration=min(shot.duration or SECONDS, SECONDS))
             for scene in scenes if scene.apart is None for shot in scene.shots]
    exact = copy.deepcopy(net).double(), dataclasses.replace(bank, vectors=bank.vectors.double())
    pages, compiled, rows = _page(director.pack(net, bank), shots), runtime.compile(net), []
    for shot, page in zip(shots, pages, strict=True):
        clip = shot.render(*exact)
        root, rotations = (torch.tensor(part, dtype=torch.float64) for part in zip(*page, strict=True))
        others = {"page": dataclasses.replace(clip, rotations=rotations.unflatten(-1, (-1, 4)), root_positions=root),
                  "single": shot.render(net, bank), "compiled": shot.render(compiled, bank)}
        rows.append({"shot": shot.name, "frames": len(clip)})
        for name, other in others.items():
            far = (other.global_positions - clip.global_positions).norm(dim=-1)
            rows[-1] |= {f"{name} root": float(far[:, 0].max()), f"{name} joint": float(far.max())}
        print(line(COLUMNS, rows[-1]), flush=True)
    if save is not None:
        Result("shot-equality", "example shots, embedded model: largest distances in ten seconds from plain Python in "
               "double precision", "python -m experiments shot-equality --save docs/results", COLUMNS, rows).save(save)


def _page(pack: dict, shots: Iterable[Shot]) -> list[list]:
    """The motion of each shot as the page's code makes it in Node: root and rotations of each frame."""
    with tempfile.TemporaryDirectory() as folder:
        given, script, made = (Path(folder) / name for name in ("given.json", "run.mjs", "made.json"))
        given.write_text(json.dumps({"data": pack, "shots": [data([shot]) for shot in shots]}), encoding="utf-8")
        script.write_text(SCRIPT.replace("SCENE", SCENE.as_uri()), encoding="utf-8")
        subprocess.run([shutil.which("node") or "node", script, given, made], check=True)
        return json.loads(made.read_text(encoding="utf-8"))
