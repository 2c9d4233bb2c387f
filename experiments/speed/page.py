"""Speed of a page's network and frame, for one character and many, beside the limit of the
processor, and of the kernel.
"""

import copy
import json
import math
import shutil
import subprocess
import tempfile
import time
from pathlib import Path
from typing import Annotated

import torch
import typer

from experiments.tables import Result
from toolkit import published, runtime
from toolkit.cli import verbs
from toolkit.motion import Clip
from toolkit.view.pages import live_page

SCENE = Path(live_page.__file__).parents[1] / "scene"
SCRIPT = Path(__file__).with_suffix(".js")
COLUMNS = {"model": ["model"], "where": ["where"], "characters": ["characters", 0],
           "network": ["network, ms each", 3],
           "floor": ["its floor", 3], "frame": ["network and frame", 3],
           "pose": ["pose with IK", 3]}
FRAMES = (60, 300, 600)
EQUALITY = {"compared": ["compared"], **{str(f): [f"frame {f}, mm", 3, 1000] for f in FRAMES},
            "size": ["the page's file, MB", 1, 1e-6]}


def run(
    model: verbs.TrainedRun = None,
    parameters: verbs.Published = None,
    characters: Annotated[str,
                          typer.Option(help="Numbers of characters.")] = "1,2,4,8,16,32,64",
    rounds: Annotated[int, typer.Option(min=1, help="Rounds; the shortest time is printed.")] = 60,
    equality: Annotated[bool, typer.Option(
        "--equality", help="Compare rollouts in Node with Python's instead.")] = False,
    styles: Annotated[int, typer.Option(min=1, help="Number of styles to compare.")] = 20,
    save: Annotated[Path
                    | None, typer.Option(help="Folder for the result page-speed or "
                                              "page-equality.")] = None,
) -> None:
    """Milliseconds of a page's network and whole frame (without picture), JavaScript and
    WebAssembly SIMD; of the kernel.

    The floor is the longer of two times: all weights are read once, as fast as a plain SIMD loop
    sums them; and all multiply-adds, as fast as eight sums in registers make them. Both are
    measured in doubles, on one core.
    """
    net, bank = published.either(model, parameters)
    kind = "published" if parameters else "embedded" if model is None else "trained"
    if equality:
        rows = [{"compared": f"{kind}: {what}", **row}
                for what, row in _equal(net, bank, styles).items()]
        for row in rows:
            print(row["compared"], *(f"{1e3 * row[str(f)]:.4f} mm at {f}" for f in FRAMES),
                  f"{row['size']:,} B", sep=", ")
        if save is not None:
            Result("page-equality",
                   "Rollouts of 20 styles with 600 frames in Node and in Python: largest "
                   "distance of any "
                   "joint in any style",
                   "python -m experiments page --equality [--published DATA/lpn_film_100style] "
                   "--save "
                   "docs/results", EQUALITY, rows).add(save)
        return
    data, counts, kept = live_page.pack(net, bank), [int(n) for n in characters.split(",")], []
    found = _node(data, counts, rounds)
    rate, speed = found["floor"]["sums"], found["floor"]["bytes"]
    print(f"Node: {found['weights'] / 1e6:.1f} million weights, {rate / 1e9:.1f} G "
          f"multiply-adds/s, "
          f"{speed / 1e9:.1f} GB/s, pose with IK {found['pose']:.3f} ms a character")
    print(f"{'':20}{'characters':>10}{'network':>9}{'each':>8}{'× floor':>9}{'frame':>9}"
          f"{'each':>8}")
    for row in found["rows"]:
        count, network, frame = row["count"], row["network"], row["frame"]
        floor = 1e3 * max(4 * found["weights"] / speed, count * found["weights"] / rate)
        print(f"{row['kind']:20}{count:10}{network:9.2f}{network / count:8.3f}"
              f"{network / floor:9.2f}"
              f"{frame:9.2f}{frame / count:8.3f}")
        kept.append({"where": f"Node, {row['kind']}", "characters": count,
                     "network": network / count,
                     "floor": floor / count, "frame": frame / count, "pose": found["pose"]})
    for count in counts:
        frame, posed = _kernel(net, bank, count, rounds)
        print(f"kernel, compiled: {count} characters, frame {frame:.3f} ms each, pose "
              f"{posed:.3f} ms each")
        kept.append({"where": "kernel, compiled", "characters": count, "frame": frame,
                     "pose": posed})
    if save is not None:
        Result("page-speed",
               f"milliseconds of processor time a character and frame, shortest of {rounds}, one "
               f"thread",
               "python -m experiments page", COLUMNS,
               [{"model": kind} | row for row in kept]).save(save)


def _kernel(net, bank, count: int, rounds: int) -> tuple[float, float]:
    """Shortest processor time of a frame and of a pose, milliseconds a character."""
    compiled, best = runtime.compile(net), [math.inf, math.inf]
    state = runtime.start(compiled,
                          torch.stack([bank[bank.names[k % len(bank.names)]]
                                       for k in range(count)]))
    command = runtime.Command(torch.tensor([[math.sin(k), math.cos(k)] for k in range(count)]))
    with torch.no_grad():
        for _ in range(30 + rounds):
            times = [time.process_time()]
            state = runtime.step(compiled, state, command)
            times.append(time.process_time())
            runtime.pose(compiled, state)
            times.append(time.process_time())
            best = [min(old, 1e3 * (b - a) / count)
                    for old, a, b in zip(best, times, times[1:], strict=False)]
    return best[0], best[1]


def _equal(net, bank, count: int) -> dict[str, dict[str, float]]:
    """Largest distances, metres, of a joint in the walks of the page's tests, at `FRAMES`; bytes of
    the page.
    """
    # in tests/, which the command line of the experiments puts on the path
    from walks import COMMANDS, WALK, commands

    names = list(bank)[:: max(1, len(bank) // count)][:count]
    vectors, found = torch.stack([bank[name] for name in names]), {}
    walks = {}
    for name, model in (("plain", net), ("double precision", copy.deepcopy(net).double())):
        run = list(runtime.states(model, COMMANDS, vectors.to(next(model.parameters()).dtype),
                                  progress=True))
        walks[name] = [runtime.record(model, run, character=i) for i in range(len(names))]
    for half in (False, True):
        with tempfile.TemporaryDirectory() as folder:
            size = live_page.web(net, bank, Path(folder) / "page.html", half=half).stat().st_size
        given = {"data": live_page.pack(net, bank, half), "commands": commands(),
                 "styles": vectors.tolist()}
        poses = _in_node(given, f"""
            const {{ Character }} = await load("character");
            const walk = {WALK};
            const walked = (style) => walk(new Character(given.data), given.commands, style);
            result = given.styles.map(walked);""")
        skeleton, fps = walks["plain"][0].skeleton, walks["plain"][0].fps
        page = [Clip(skeleton, numbers[:, 3:].unflatten(-1, (-1, 4)), numbers[:, :3], fps)
                for numbers in torch.tensor(poses, dtype=torch.float64)]
        for name, clips in walks.items():
            apart = torch.stack([(a.global_positions - b.global_positions).norm(dim=-1).amax(-1)
                                 for a, b in zip(page, clips, strict=True)]).amax(0)
            far = {str(f): float(apart[f - 1]) for f in FRAMES}
            found[f"page{' with float16' * half} and {name}"] = far | {"size": size}
    return found


def _node(data: dict, counts: list[int], rounds: int) -> dict:
    return _in_node({"data": data, "counts": counts, "rounds": rounds}, f"""
        const {{ measure }} = await import({json.dumps(SCRIPT.as_uri())});
        result = await measure(load, given.data, given.counts, given.rounds);""")


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
