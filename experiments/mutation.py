"""Mutants: one small fault planted in the code, and do the tests see it?"""

import ast
import contextlib
import importlib
import json
import os
import random
import shutil
import signal
import sys
import tempfile
import time
from pathlib import Path
from typing import Annotated

import pytest
import typer
from tqdm import tqdm

from experiments import tables

HERE = Path(__file__).parents[1]
MUTANTS, LIMIT = 30, 120  # of a group; seconds for the tests of a mutant
#: Sources, and the tests that should see a fault in them; names that a checkout lacks are passed.
GROUPS = {
    "rotations": ("motion/rotations.py", "rotations motion"),
    "ik": ("motion/ik.py", "ik runtime compiled"),
    "contacts": ("motion/contacts.py", "contacts motion metrics"),
    "fit": ("phases/sinusoids.py phases/variable_projection.py phases/viterbi.py phases/windows.py",
            "fit phases"),
    "features": ("features/features.py features/layout.py", "features held_out networks"),
    "networks": ("networks/experts.py networks/film.py networks/adapters.py",
                 "networks adapters convolution"),
    "frame": ("runtime/frame.py runtime/recording.py runtime/steering.py runtime/rules.py",
              "runtime compiled"),
    "losses": ("training/loss.py stylization/losses.py",
               "training held_out evaluation stylization"),
    "measures": ("evaluation/metrics/*.py evaluation/findings.py", "metrics report findings"),
    "shots": ("extra/shots/*.py", "shots director"),
    "readers": ("io/bvh.py io/bvh_text.py extra/formats/*.py",
                "bvh readers inspection interpretation character"),
}
#: Packages that the tests import, and the names of ours, which a mutant imports anew.
HEAVY = ("torch", "numba", "scipy.optimize", "scipy.signal", "scipy.interpolate", "scipy.spatial",
         "pandas", "matplotlib", "hypothesis.strategies", "safetensors.torch", "ipywidgets")
OURS = {"toolkit", "experiments", "robustness", "course"}
COLUMNS = {"group": ["group"], "seed": ["seed", 0], "mutants": ["mutants", 0],
           "detected": ["detected", 0], "equivalent": ["equivalent", 0], "survivors": ["survivors"]}
#: Why a mutant that no test sees computes the same, by its line and the change.
EQUIVALENT = {
    ("for part in rows.split(1024):", "1024 -> 1025"): "the sum has the same parts",
    ("adam = torch.optim.Adam([vector], fused=True)", "True -> False"): "the same formula",
    ("batches = Minibatches(data, BATCH, 1, seed, pose_mixup, model.memory)", "1 -> 2"):
        "nothing reads its style clips",
    ("beside = torch.where(square > 0, square, 1.0).sqrt() * (square > 0)  # finite gradient at 0",
     "1.0 -> 2.0"): "it is multiplied by 0",
    ("found, waiting = {start: 0.0}, [start]", "0.0 -> 1.0"): "all distances grow by as much",
    ("given = values.get(name, TRACKS.get(name, (0.0,) * 3))", "3 -> 4"): "three are read",
    ('metres = 1.0 if unit == "auto" else float(UNITS.get(unit, unit))', "1.0 -> 2.0"):
        "it is guessed later",
}
NOT_COPIED = shutil.ignore_patterns(".git", ".venv", "out", "build", "__pycache__", ".*_cache")
OPPOSITE = {
    ast.Lt: ast.GtE, ast.GtE: ast.Lt, ast.Gt: ast.LtE, ast.LtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
    ast.And: ast.Or, ast.Or: ast.And,
}
SMALLEST = 1e-3  # a smaller constant is a tolerance, and twice a tolerance is no fault
#: What computes no result: types, decorators such as a compiler's, texts of errors, ``strict=``.
NO_FIELDS = {"annotation", "returns", "decorator_list"}
NO = ast.Raise | ast.JoinedStr | ast.Assert


def places(node: ast.AST) -> list[ast.AST]:
    """Every node that can be mutated, in the order of the source."""
    found = []
    if isinstance(node, ast.Compare):
        found += [node] * (type(node.ops[0]) in OPPOSITE)
    elif isinstance(node, ast.BinOp | ast.BoolOp | ast.AugAssign):
        found += [node] * (type(node.op) in OPPOSITE)
    elif isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        found += [node] * (node.value == 0 or abs(node.value) >= SMALLEST)
    elif isinstance(node, ast.Call):
        unsigned = ast.unparse(node.func).endswith(("abs", "norm", "cos", "hypot"))
        found += [node] * any(isinstance(a, ast.BinOp) and not unsigned for a in node.args)
    for name, value in ast.iter_fields(node):
        for child in value if isinstance(value, list) else [value]:
            checks = isinstance(child, NO) or getattr(child, "arg", None) == "strict"
            if name not in NO_FIELDS and isinstance(child, ast.AST) and not checks:
                found += places(child)
    return found


def mutate(node: ast.AST) -> str:
    """Change a node of a syntax tree in place; returns the code before and after."""
    before = ast.unparse(node)
    if isinstance(node, ast.Compare):
        node.ops[0] = OPPOSITE[type(node.ops[0])]()
    elif isinstance(node, ast.Call):  # the sign of an argument
        at = next(i for i, argument in enumerate(node.args) if isinstance(argument, ast.BinOp))
        node.args[at] = ast.UnaryOp(ast.USub(), node.args[at])
    elif not isinstance(node, ast.Constant):
        node.op = OPPOSITE[type(node.op)]()
    elif isinstance(node.value, bool):
        node.value = not node.value
    else:
        node.value = node.value + 1 if isinstance(node.value, int) else 2 * node.value or 1.0
    return f"{before} -> {ast.unparse(node)}"


class Quickest:
    """For pytest: the tests run in the order of their seconds in a file, or write that file."""

    def __init__(self, times: Path):
        self.times, self.known = times, json.loads(times.read_bytes()) if times.exists() else {}
        self.seconds: dict[str, float] = {}

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, items: list) -> None:
        items.sort(key=lambda item: self.known.get(item.nodeid, 0.0))

    def pytest_runtest_logreport(self, report) -> None:
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration

    def pytest_sessionfinish(self) -> None:
        if not self.known:
            self.times.write_text(json.dumps(self.seconds))


def tests_pass(copy: Path, group: str, limit: float) -> bool:
    """Whether the tests of a group pass in a copy of the repository; too slow is a failure.

    They run in a fork of this process, which has imported what takes long.
    """
    files = [str(path) for name in GROUPS[group][1].split()
             for path in (copy / "tests").rglob(f"test_{name}.py")]
    child = os.fork()
    if not child:
        status = 1
        try:
            os.setsid()
            os.chdir(copy)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
            os.dup2(1, 2)
            os.environ["OMP_NUM_THREADS"] = "1"
            os.environ.pop("TOOLKIT_DATA", None)
            paths = [str(copy / part) for part in (".", "tests", "notebooks")]
            os.environ["PYTHONPATH"] = os.pathsep.join(paths)
            sys.path[:0] = paths
            for name in [name for name in sys.modules if name.split(".")[0] in OURS]:
                del sys.modules[name]
            options = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:nbval",
                       "-W", "ignore::pytest.PytestAssertRewriteWarning"]
            status = pytest.main([*options, *files], [Quickest(copy.parent / f"{group}.json")])
        finally:
            os._exit(int(status))
    ends = time.monotonic() + limit
    while not (found := os.waitpid(child, os.WNOHANG))[0] and time.monotonic() < ends:
        time.sleep(0.05)
    with contextlib.suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)
    return (found if found[0] else os.waitpid(child, 0))[1] == 0


def survivors(copy: Path, group: str, seed: int):
    """Number of mutants tried in one group, and a list with a line for each that no test saw."""
    sources = [path for pattern in GROUPS[group][0].split()
               for path in sorted((copy / "toolkit").glob(pattern))]
    began = time.monotonic()
    if not tests_pass(copy, group, 30 * LIMIT):
        raise ValueError(f"{group}: the tests must pass before the code is mutated")
    limit = max(LIMIT, 3 * (time.monotonic() - began))
    # a place is a file and a number, since each mutant starts from a fresh tree
    counts = {path: len(places(ast.parse(path.read_bytes()))) for path in sources}
    everywhere = [(path, i) for path in sources for i in range(counts[path])]
    chosen = random.Random(seed).sample(everywhere, min(MUTANTS, len(everywhere)))
    unseen = []
    for path, i in tqdm(chosen, desc=group, disable=None):
        text = path.read_bytes()
        tree = ast.parse(text)
        node = places(tree)[i]
        change = mutate(node)
        path.write_text(ast.unparse(tree), encoding="utf-8")
        if tests_pass(copy, group, limit):
            line = text.decode().splitlines()[node.lineno - 1].strip()
            why = EQUIVALENT.get((line, change), "no test sees it")
            unseen.append(f"{path.relative_to(copy)}:{node.lineno}: {change} ({why})")
            print(f"  {unseen[-1]}\n    {line}", flush=True)
        path.write_bytes(text)
    return len(chosen), unseen


def run(
    group: Annotated[list[str] | None, typer.Option(help="Groups; all, if none.")] = None,
    seed: Annotated[int, typer.Option(help="Seed of their choice.")] = 0,
    store: tables.Store = False,
) -> None:
    """Plant faults in a copy of the code, one at a time, and count those that the tests detect."""
    for name in group or GROUPS:
        if name not in GROUPS:
            raise ValueError(f"group must be one of {', '.join(GROUPS)}, got {name!r}")
    for name in HEAVY:
        importlib.import_module(name)
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "checkout"
        shutil.copytree(HERE, copy, ignore=NOT_COPIED)
        for name in group or GROUPS:
            tried, unseen = survivors(copy, name, seed)
            print(f"{name}: {tried} mutants, {len(unseen)} survive", flush=True)
            equal = sum("(no test sees it)" not in line for line in unseen)
            row = {"group": name, "seed": seed, "mutants": tried, "detected": tried - len(unseen),
                   "equivalent": equal, "survivors": "; ".join(unseen)}
            if store:
                again = f"python -m experiments mutation --group {name} --seed {seed} --store"
                tables.Result("mutation", "Mutants of the code; tests without recordings.", again,
                              COLUMNS, [row]).add()
