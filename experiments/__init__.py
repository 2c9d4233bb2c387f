"""Measurements of the toolkit, compared with known truth, recordings, other methods or limits of
the machine.
"""

import ast
import pkgutil
from importlib.util import find_spec
from pathlib import Path


def commands(package: str, path: list[str]) -> dict[str, tuple[str, str]]:
    """Command name to ``"module:run"`` and help, for the modules of a package that have a function
    ``run``.
    """
    modules = [found.name for found in pkgutil.iter_modules(path) if not found.ispkg
               and not found.name.startswith("_")]
    return {name.replace("_", "-"): command(f"{package}.{name}") for name in modules}


def command(module: str) -> tuple[str, str]:
    """``"module:run"``, and the first paragraph of the docstring of its ``run``, without an import
    of the module.
    """
    tree = ast.parse(Path(find_spec(module).origin).read_text(encoding="utf-8"))
    (run,
     ) = (node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "run")
    return f"{module}:run", ast.get_docstring(run).split("\n\n")[0]
