"""Mutants: one small fault planted in the code, and do the tests see it?"""

import ast
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Annotated

import typer

HERE = Path(__file__).parents[1]
#: Sources, and the tests that should see a fault in them; names that a checkout lacks are passed.
GROUPS = {
    "rotations": ("motion/rotations.py", "rotations motion"),
    "ik": ("motion/ik.py", "ik"),
    "contacts": ("motion/contacts.py", "contacts motion measures"),
    "fit": ("phases/sinusoids.py phases/variable_projection.py phases/viterbi.py phases/windows.py",
            "fit phases"),
    "features": ("features/features.py features/layout.py", "features held_out"),
    "networks": ("networks/experts.py networks/film.py", "networks adapters"),
    "frame": ("runtime/frame.py runtime/recording.py runtime/steering.py runtime/rules.py",
              "runtime compiled"),
    "losses": ("training/loss.py stylization/losses.py", "training stylization"),
    "measures": ("evaluation/metrics/*.py evaluation/findings.py", "metrics report findings"),
    "shots": ("extra/shots/*.py", "shots director"),
    "readers": ("io/bvh.py io/bvh_text.py extra/formats/*.py",
                "bvh bvh_roundtrip readers inspection interpretation"),
}
NOT_COPIED = shutil.ignore_patterns(".git", ".venv", "out", "build", "__pycache__", ".*_cache")
OPPOSITE = {
    ast.Lt: ast.GtE, ast.GtE: ast.Lt, ast.Gt: ast.LtE, ast.LtE: ast.Gt, ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq, ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult,
    ast.And: ast.Or, ast.Or: ast.And,
}
SMALLEST = 1e-3  # a smaller constant is a tolerance, and twice a tolerance is no fault
#: What computes no result: types, decorators such as a compiler's, texts of errors.
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
        found += [node] * any(isinstance(argument, ast.BinOp) for argument in node.args)
    for name, value in ast.iter_fields(node):
        for child in value if isinstance(value, list) else [value]:
            if name not in NO_FIELDS and isinstance(child, ast.AST) and not isinstance(child, NO):
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


def tests_pass(copy: Path, names: str, limit: float) -> bool:
    """Whether the tests of a group pass in a copy of the repository; too slow is a failure."""
    files = [path for name in names.split() for path in (copy / "tests").rglob(f"test_{name}.py")]
    path = os.pathsep.join(str(copy / part) for part in (".", "tests", "notebooks"))
    environment = os.environ | {"PYTHONPATH": path, "OMP_NUM_THREADS": "1"}
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *files]
    try:
        done = subprocess.run(command, cwd=copy, env=environment, capture_output=True,
                              timeout=limit)
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def survivors(copy: Path, group: str, mutants: int, seed: int, limit: float):
    """Number of mutants tried in one group, and a list with a line for each that no test saw."""
    patterns, tests = GROUPS[group]
    sources = [path for p in patterns.split() for path in sorted((copy / "toolkit").glob(p))]
    began = time.monotonic()
    if not tests_pass(copy, tests, 10 * limit):
        raise ValueError(f"{group}: the tests must pass before the code is mutated")
    limit = max(limit, 3 * (time.monotonic() - began))
    # a place is a file and a number, since each mutant starts from a fresh tree
    counts = {path: len(places(ast.parse(path.read_bytes()))) for path in sources}
    everywhere = [(path, i) for path in sources for i in range(counts[path])]
    chosen = random.Random(seed).sample(everywhere, min(mutants, len(everywhere)))
    unseen = []
    for path, i in chosen:
        text = path.read_bytes()
        tree = ast.parse(text)
        node = places(tree)[i]
        change = mutate(node)
        path.write_text(ast.unparse(tree), encoding="utf-8")
        if tests_pass(copy, tests, limit):
            unseen.append(f"{path.relative_to(copy)}:{node.lineno}: {change}")
        path.write_bytes(text)
    return len(chosen), unseen


def run(
    group: Annotated[list[str] | None, typer.Option(help="Groups; all, if none.")] = None,
    mutants: Annotated[int, typer.Option(min=1, help="Mutants in each group.")] = 30,
    seed: Annotated[int, typer.Option(help="Seed of their choice.")] = 0,
    root: Annotated[Path, typer.Option(help="The checkout that is tested.")] = HERE,
    limit: Annotated[float, typer.Option(help="Seconds for the tests of a mutant.")] = 120,
) -> None:
    """Plant faults in a copy of the code, one at a time, and count those that the tests detect."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "checkout"
        shutil.copytree(root, copy, ignore=NOT_COPIED)
        print(f"{'group':<12}{'mutants':>9}{'detected':>10}")
        for name in group or GROUPS:
            if name not in GROUPS:
                raise ValueError(f"group must be one of {', '.join(GROUPS)}, got {name!r}")
            tried, unseen = survivors(copy, name, mutants, seed, limit)
            print(f"{name:<12}{tried:>9}{tried - len(unseen):>10}", flush=True)
            for line in unseen:
                print(f"    {line}", flush=True)
