"""Speed of a page's network and frame, for one character and many, beside the limit of the
processor.
"""

import copy
import json
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.speed.runtime import FRAMES, WAYS, farthest, some, walks
from experiments.tables import Result, Store
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.motion import Clip
from toolkit.view.pages import live_page

SCENE = Path(live_page.__file__).parents[1] / "scene"
SCRIPT = Path(__file__).with_suffix(".js")
COUNTS = [1, 2, 4, 8, 16, 32, 64]  # characters
ROUNDS = 60  # of which the shortest counts
COLUMNS = {"model": ["model"], "where": ["where"], "characters": ["characters", 0],
           "network": ["network, ms each", 3],
           "floor": ["its floor", 3], "frame": ["network and frame", 3],
           "pose": ["pose with IK", 3]}
EQUALITY = {"compared": ["compared"], **{str(f): [f"frame {f}, mm", 3, 1000] for f in FRAMES},
            "size": ["the page's file, MB", 1, 1e-6]}
#: JavaScript: poses ``[frame][root 3, rotations 4 J']`` of a character through commands in a style.
WALK = """(character, commands, style) => {
    character.restart();
    return commands.map((command) => {
        character.step(command, style);
        character.pose();
        return [...character.root, ...character.rotations];
    });
}"""


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    equality: Annotated[bool, typer.Option(
        "--equality", help="Compare rollouts in Node with Python's instead.")] = False,
    store: Store = False,
) -> None:
    """Milliseconds of a page's network and whole frame (without picture), JavaScript and
    WebAssembly SIMD.

    The floor is the longer of two times: all weights are read once, as fast as a plain SIMD loop
    sums them; and all multiply-adds, as fast as eight sums in registers make them. Both are
    measured in doubles, on one core.
    """
    net, bank = published.either(model, parameters)
    kind = "published" if parameters else "embedded" if model is None else "trained"
    if equality:
        rows = [{"compared": f"{kind}: {what}", **row}
                for what, row in _equal(net, bank).items()]
        made = Result("page-equality",
                      "Rollouts of 20 styles with 600 frames in Node and in Python: largest "
                      "distance of any joint in any style",
                      "python -m experiments page --equality [--published "
                      "DATA/lpn_film_100style] --store", EQUALITY, rows)
        made.show(store=False)
        if store:
            made.add()
        return
    data = live_page.pack(net, bank)
    found = _in_node({"data": data, "counts": COUNTS, "rounds": ROUNDS}, f"""
        const {{ measure }} = await import({json.dumps(SCRIPT.as_uri())});
        result = await measure(load, given.data, given.counts, given.rounds);""")
    rate, speed = found["floor"]["sums"], found["floor"]["bytes"]
    rows = []
    for row in found["rows"]:
        count = row["count"]
        floor = 1e3 * max(4 * found["weights"] / speed, count * found["weights"] / rate)
        rows.append({"model": kind, "where": f"Node, {row['kind']}", "characters": count,
                     "network": row["network"] / count, "floor": floor / count,
                     "frame": row["frame"] / count, "pose": found["pose"]})
    made = Result("page-speed",
                  f"milliseconds of processor time a character and frame, shortest of {ROUNDS}, "
                  "one thread", "python -m experiments page", COLUMNS, rows,
                  {"million weights": found["weights"] / 1e6, "G multiply-adds/s": rate / 1e9,
                   "GB/s": speed / 1e9})
    made.show(store)


def _equal(net, bank) -> dict[str, dict[str, float]]:
    """Largest distances, metres, of a joint in walks of `WAYS`, at `FRAMES`; bytes of the page."""
    vectors, found = some(bank), {}
    orders = [command for way in WAYS for command in runtime.straight(*way)]
    commands = [{"velocity": list(c.velocity), "facing": list(c.facing)} for c in orders]
    walked = walks({"plain": net, "double precision": copy.deepcopy(net).double()}, vectors, orders)
    for half in (False, True):
        with tempfile.TemporaryDirectory() as folder:
            size = live_page.web(net, bank, Path(folder) / "page.html", half=half).stat().st_size
        given = {"data": live_page.pack(net, bank, half), "commands": commands,
                 "styles": vectors.tolist()}
        poses = _in_node(given, f"""
            const {{ Character }} = await load("character");
            const walk = {WALK};
            const walked = (style) => walk(new Character(given.data), given.commands, style);
            result = given.styles.map(walked);""")
        page = [Clip(net.layout.skeleton, numbers[:, 3:].unflatten(-1, (-1, 4)), numbers[:, :3],
                     runtime.FPS) for numbers in torch.tensor(poses, dtype=torch.float64)]
        for name, clips in walked.items():
            found[f"page{' with float16' * half} and {name}"] = farthest(page, clips) | {
                "size": size}
    return found


def _in_node(given: dict, script: str):
    """What JavaScript assigns to ``result``; it has ``given``, and ``load(name)`` for a module of
    the scene.
    """
    program = shutil.which("node")
    if program is None:
        raise ValueError("node: not found; Debian: apt-get install nodejs")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "given.json"
        path.write_text(json.dumps(given), encoding="utf-8")
        (Path(folder) / "run.mjs").write_text(f"""
            import {{ readFileSync }} from "node:fs";
            const given = JSON.parse(readFileSync({json.dumps(str(path))}));
            const load = (name) => import({json.dumps(SCENE.as_uri())} + `/${{name}}.js`);
            let result;
            {script}
            process.stdout.write(JSON.stringify(result));
        """, encoding="utf-8")
        done = subprocess.run([program, Path(folder) / "run.mjs"], capture_output=True, text=True,
                              check=True)
    return json.loads(done.stdout)
