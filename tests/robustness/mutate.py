"""Mutation: do tests fail if a module is changed in one place? ``python tests/robustness/mutate.py MODULES TESTS…``

MODULES have commas between them. mutmut leaves out decorated functions and the constants of modules; cosmic-ray runs every
test for every change. Here the tests that run the changed line come first, and the first failure ends a run.
"""

import ast
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import typer
from coverage import Coverage

COMPARED = {ast.Lt: (ast.LtE, ast.Gt), ast.LtE: (ast.Lt, ast.GtE), ast.Gt: (ast.GtE, ast.Lt), ast.GtE: (ast.Gt, ast.LtE),
            ast.Eq: [ast.NotEq], ast.NotEq: [ast.Eq], ast.In: [ast.NotIn], ast.NotIn: [ast.In], ast.Is: [ast.IsNot],
            ast.IsNot: [ast.Is]}
OPERATORS = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Pow: ast.Mult, ast.Mod: ast.Mult,
             ast.FloorDiv: ast.Div, ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.And: ast.Or, ast.Or: ast.And,
             ast.USub: ast.UAdd, ast.Invert: ast.UAdd}
LIMIT = 1800.0  # seconds


def changes(tree: ast.AST, line: int = 0):
    """Every change of a tree: first and last line, a node, the field to set and its new value."""
    line = tree.lineno if isinstance(tree, ast.stmt) else line
    found, value = [], getattr(tree, "value", None)
    if isinstance(tree, ast.Compare):
        found = [("ops", [*tree.ops[:k], new(), *tree.ops[k + 1 :]]) for k, op in enumerate(tree.ops)
                 for new in COMPARED[type(op)]]
    elif type(getattr(tree, "op", None)) in OPERATORS and not isinstance(tree, ast.AugAssign):
        found = [("op", OPERATORS[type(tree.op)]())]
    elif isinstance(tree, ast.IfExp):
        found = [("test", ast.UnaryOp(ast.Not(), tree.test))]
    elif isinstance(tree, ast.UnaryOp):  # not
        found = [("operand", ast.UnaryOp(ast.Not(), tree.operand))]
    elif isinstance(tree, ast.Constant) and isinstance(value, bool | int | float):
        other = not value if isinstance(value, bool) else value + 1 if isinstance(value, int) else value * 1.5 or 1.0
        found = [("value", other)]
    elif isinstance(tree, ast.If):
        found = [("test", ast.Constant(False))]
    yield from ((line, tree.end_lineno if isinstance(tree, ast.expr) else line, tree, *change) for change in found)
    for name, value in ast.iter_fields(tree):
        for k, part in enumerate(value if isinstance(value, list) else [value]):
            if isinstance(part, ast.AugAssign) or (isinstance(part, ast.Expr) and isinstance(part.value, ast.Call)):
                yield part.lineno, part.lineno, tree, name, [*value[:k], ast.Pass(), *value[k + 1 :]]
            message = isinstance(part, ast.Raise | ast.JoinedStr) or getattr(part, "arg", "") == "strict"
            if isinstance(part, ast.AST) and name not in ("annotation", "returns", "decorator_list") and not message:
                yield from changes(part, line)


def status(folder: Path, module: Path, tests: list[str], *before: str) -> int:
    """What pytest ends with, 124 if it takes longer than `LIMIT`."""
    for path in module.parent.glob("*.py"):  # numba does not see that a function of another module has changed
        if re.search(rf"\b{module.stem}\b", path.read_text()):
            for old in path.parent.glob(f"__pycache__/{path.stem}.*.nb?"):
                old.unlink()
    command = [sys.executable, "-m", *before, "pytest", "-xq", "-p", "no:cacheprovider", *tests]
    try:
        return subprocess.run(command, cwd=folder, env=os.environ | {"PYTHONPATH": str(folder)}, timeout=LIMIT,
                              stdout=subprocess.DEVNULL).returncode
    except subprocess.TimeoutExpired:
        return 124


def main(modules: str, tests: list[str], mutants: int = 30, seed: int = 0) -> None:
    """Change modules in one place at a time, and run the tests that are meant to hold them."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for part in ("toolkit", "tests", "experiments", "docs/results", "pyproject.toml"):
            (shutil.copytree if Path(part).is_dir() else shutil.copy)(part, folder / part)
        paths = [folder / module for module in modules.split(",")]
        (folder / ".coveragerc").write_text("[run]\ndynamic_context = test_function\nsource = toolkit\n")
        if failed := status(folder, paths[0], tests, "coverage", "run", "-m"):
            sys.exit(f"without a change, the tests end with status {failed}")
        (covered := Coverage(folder / ".coverage", config_file=False)).load()
        runs = {path: covered.get_data().contexts_by_lineno(str(path)) for path in paths}
        every = [(path, k) for path in paths for k in range(len([*changes(ast.parse(path.read_text()))]))]
        for path, k in random.Random(seed).sample(every, min(mutants, len(every))):
            tree = ast.parse(text := path.read_text())
            low, high, node, field, value = [*changes(tree)][k]
            before = ast.unparse(node)
            setattr(node, field, value)
            path.write_text(ast.unparse(ast.fix_missing_locations(tree)))
            first = sorted({"tests/{}.py::{}".format(*test.split(".")[:2]) for line in range(low, high + 1)
                            for test in runs[path].get(line, []) if test.startswith("test_")})
            ended = (first and status(folder, path, first)) or status(folder, path, tests)
            path.write_text(text)
            if ended in (4, 5):  # pytest found no test
                sys.exit(f"{first or tests}: pytest ends with status {ended}")
            print(f"{path.name}:{low}", f"detected ({ended})" if ended else "SURVIVED",
                  *(" ".join(code.split())[:90] for code in (before, "->", ast.unparse(node))), flush=True)
        print(f"{len(every)} changes are possible")


if __name__ == "__main__":
    typer.run(main)
