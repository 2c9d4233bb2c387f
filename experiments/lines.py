"""Lines of the package by room, and what they grew by."""

import ast
import subprocess
from collections import Counter
from pathlib import Path
from typing import Annotated

import typer

from experiments.tables import Result

PACKAGE = Path(__file__).parents[1] / "toolkit"
SINCE = "4e4d4ec"  # the commit after which the features below came
AIM = 15_600  # lines that were asked for, before them
CAME = {  # by room
    "view": "a body for any skeleton, characters of one's own, crowds, the Director, figures of the notebooks",
    "io": "readers of glTF, VRM, FBX, AMC and NumPy files; unit, axes and roles from the body; limits for hostile files",
    "motion": "anatomy and roles of any humanoid, foot lock and sinking hips, loops, springs",
    "datasets": "folders of one's own, fixed splits and a search for leaks, safe downloads",
    "runtime": "", "course": "the notebooks' exercises, charts and map",
    "stylization": "training that keeps content, a toy for the losses",
    "shots": "planned paths, keys, pilots, crowds that keep apart",
    "features": "held-out windows without overlap, stores of fixed splits",
    "phases": "", "networks": "", "cli": "the commands of all these", "training": "style vectors fitted to frames",
    "evaluation": "the field's measures, recognition, labelled phases", "styles": "",
    "export": "packs of cycles, characters",
}


def kinds(text: str) -> Counter:
    """Lines of a module by kind: docstring, blank, import and code."""
    tree, kind = ast.parse(text), dict.fromkeys(range(1, len(text.splitlines()) + 1), "code")
    kind |= {i: "blank" for i, line in enumerate(text.splitlines(), 1) if not line.strip()}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import | ast.ImportFrom):
            kind |= dict.fromkeys(range(node.lineno, node.end_lineno + 1), "import")
        elif isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node) is not None:
            kind |= dict.fromkeys(range(node.body[0].lineno, node.body[0].end_lineno + 1), "docstring")
    return Counter(kind.values())


def before(commit: str) -> Counter:
    """Lines of each room at a commit."""
    listed = subprocess.run(["git", "grep", "-c", "", commit, "--", "toolkit/*.py"], cwd=PACKAGE.parent, text=True,
                            capture_output=True, check=True).stdout
    counted = Counter()
    for _, path, count in (line.split(":") for line in listed.splitlines()):
        counted[_room(Path(path).relative_to("toolkit"))] += int(count)
    return counted


def _room(path: Path) -> str:
    return path.parts[0] if len(path.parts) > 1 else "the root"


def run(store: Annotated[bool, typer.Option("--store", help="Write docs/results/lines.json.")] = False) -> None:
    """Lines of the package by room: docstrings, code, and growth since the features of the present rooms came."""
    found: dict[str, Counter] = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        found.setdefault(_room(path.relative_to(PACKAGE)), Counter()).update(kinds(path.read_text(encoding="utf-8")))
    old = before(SINCE)
    found["all"], old["all"] = sum(found.values(), Counter()), old.total()
    rows = [{"room": room, "lines": of.total(), "code": of["code"], "docstring": of["docstring"],
             "other": of["blank"] + of["import"], "before": old[room], "grown": of.total() - old[room],
             "came": CAME.get(room, "")}
            for room, of in sorted(found.items(), key=lambda item: (item[0] == "all", -item[1].total()))]
    for row in rows:
        print(f"{row['room']:<12}" + "".join(f"{row[key]:>9,}" for key in list(row)[1:-1]) + f"  {row['came']}")
    if store:
        columns = {"room": ["room"], "lines": ["lines", 0], "code": ["code", 0], "docstring": ["docstrings", 0],
                   "other": ["blank lines and imports", 0], "before": ["before", 0], "grown": ["grown by", 0],
                   "came": ["since then"]}
        Result("lines", f"Python lines under toolkit/, now and at commit {SINCE}.", "python -m experiments lines --store",
               columns, rows, {"aim": AIM}).save()
