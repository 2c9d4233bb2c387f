"""Command line of the experiments: ``python -m experiments NAME``."""

import sys
from pathlib import Path

import experiments
from experiments import speed
from toolkit.cli import verbs

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "notebooks")]  # of robustness/ and of course/

EXPERIMENTS = {
    **experiments.commands("experiments", experiments.__path__),
    **experiments.commands("experiments.speed", speed.__path__),
    "seven-models": ("experiments.seven_models.commands:app",
                     "The seven models of Table 2, trained on the same data, compared one step "
                     "ahead and in closed loop."),
    "stylization": ("experiments.stylization.comparison:run",
                    "The losses of Park et al. 2021 (Table 1), and their stylizer compared with "
                    "two methods (Table 2)."),
    "stylization-rotation": experiments.command("experiments.stylization.rotation"),
    "fuzz": experiments.command("robustness.fuzz"),
}
app = verbs.group(EXPERIMENTS, experiments.__doc__)


def main(arguments: list[str] | None = None) -> int:
    """Run the command line; returns the exit status."""
    return verbs.execute(app, arguments)


if __name__ == "__main__":
    sys.exit(main())
