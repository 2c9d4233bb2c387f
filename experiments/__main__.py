"""Command line of the experiments: ``python -m experiments NAME``; each prints what it is compared with."""

import ast
import pkgutil
import sys
from importlib.util import find_spec
from pathlib import Path

import experiments
from toolkit.cli import verbs

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))  # the home of robustness/


def _help(module: str) -> str:
    """First paragraph of the docstring of a module's ``run``; the module is not imported."""
    tree = ast.parse(Path(find_spec(module).origin).read_text(encoding="utf-8"))
    (run,) = (node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "run")
    return ast.get_docstring(run).split("\n\n")[0]


_MODULES = [f"experiments.{found.name}" for found in pkgutil.iter_modules(experiments.__path__)
            if not found.ispkg and found.name != "__main__"]
_MODULES += [f"robustness.{name}" for name in ("soak", "fuzz", "faults")]
EXPERIMENTS = {name.rpartition(".")[2].replace("_", "-"): (f"{name}:run", _help(name)) for name in _MODULES} | {
    "seven-models": ("experiments.seven_models.commands:app", "Train and measure the seven models of Table 2 side by side."),
    "stylization": ("experiments.stylization.comparison:app", "The ablation and the comparison of Park et al. 2021."),
}
app = verbs.group(EXPERIMENTS, experiments.__doc__)


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status."""
    return verbs.execute(app, arguments)


if __name__ == "__main__":
    sys.exit(main())
