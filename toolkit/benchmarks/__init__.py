"""Measurements anyone can run again: ``python -m toolkit bench NAME``, one module each, whose ``run`` is the command."""

import importlib
import pkgutil

import typer

app = typer.Typer(no_args_is_help=True, help="Measure, and print what it is compared with.")

for _module in pkgutil.iter_modules(__path__):
    app.command(_module.name.replace("_", "-"))(importlib.import_module(f"{__name__}.{_module.name}").run)
