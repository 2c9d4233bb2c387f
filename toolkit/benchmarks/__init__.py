"""Measurements anyone can run again: ``python -m toolkit bench NAME``, one module each, whose ``run`` is the command."""

import ast
import pkgutil
from importlib.util import find_spec
from pathlib import Path

from toolkit import verbs


def _help(module: str) -> str:
    """First paragraph of the docstring of a module's ``run``, which is not imported for it."""
    tree = ast.parse(Path(find_spec(module).origin).read_text(encoding="utf-8"))
    (run,) = (node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "run")
    return ast.get_docstring(run).split("\n\n")[0]


_HOMES = {
    found.name.replace("_", "-"): (f"{__name__}.{found.name}:run", _help(f"{__name__}.{found.name}"))
    for found in pkgutil.iter_modules(__path__)
}
app = verbs.group(_HOMES, help="Measure, and print what it is compared with.")
