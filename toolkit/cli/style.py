"""Command line: ``python -m toolkit style VERB``."""

import math
from importlib import resources
from pathlib import Path
from typing import Annotated

import typer

from toolkit.cli import verbs
from toolkit.io import bvh, model_files
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.styles.fine_tuning import METHODS, STEPS, fine_tune

app = typer.Typer(no_args_is_help=True, help="Add styles to a trained model, and look at those it has.")



@app.command("add")
def add(
    clips: Annotated[Path, typer.Option(help="A BVH file of the style, or a folder of them; whole files are learnt.")],
    name: Annotated[str, typer.Option(help="What the style is called.")],
    out: Annotated[Path, typer.Option(help="The file to write: as --model, with one style more.")],
    model: verbs.TrainedRun = None,
    method: Annotated[str | None, typer.Option(help=f"{', '.join(METHODS)}; the best it can by default.")] = None,
    steps: Annotated[int, typer.Option(min=1, help="Of gradient descent.")] = STEPS,
    mirror: Annotated[bool, typer.Option("--mirror", help="Learn from mirror images too; for symmetric styles.")] = False,
    seed: Annotated[int, typer.Option(help="The same seed gives the same vector.")] = 0,
) -> None:
    """Learn a style from a few clips or one (4 s or more each); everything else in the file stays the same bits.

    A model that has its FiLM generator fine-tunes it (a copy: the file keeps the old one). One that was stored without, as
    the embedded one, has the style vector itself optimised.
    """
    files = sorted(clips.rglob("*.bvh")) if clips.is_dir() else [clips]
    if not files:
        raise ValueError(f"{clips}: no BVH file in this folder")
    if not name.strip() or any(c in name for c in "=,"):
        raise ValueError(f"a style's name must not be empty nor hold '=' or ',', got {name!r}")
    if out.is_dir() or not out.parent.is_dir():
        raise ValueError(f"{out}: --out needs a file name in a folder that exists")
    tensors, parts, network, bank = _read(model)
    made = fine_tune(network, [bvh.load(file) for file in files], name, bank, method=method, steps=steps, mirror=mirror,
                     seed=seed, progress=True)
    record = {"style": name, "clips": [file.name for file in files], "method": made.method, "steps": steps, "seed": seed,
              "seconds": round(made.seconds, 1)}
    new = {"bank": list(made.bank.names), "added": [*parts.get("added", []), record]}
    model_files.write(out, tensors | {"bank.vectors": made.bank.vectors}, parts | new)
    first, last = (sum(part) / len(part) if part else math.nan for part in (made.losses[:20], made.losses[-20:]))
    print(f"{METHODS[made.method]}: loss {first:.3f} → {last:.3f} in {made.seconds:.0f} s")
    _print_near(made.bank, name)
    print(f"wrote {out}; next: python -m toolkit rollout --model {out} --style {name} --out walk.html")


@app.command("list")
def list_(model: verbs.TrainedRun = None) -> None:
    """List the styles of a model, each with its nearest ones."""
    bank = _read(model)[3]
    for name in bank:
        _print_near(bank, name)


def _print_near(bank: StyleBank, name: str) -> None:
    print(f"{name:<20} near it: " + ", ".join(f"{other} ({apart:.1f})" for other, apart in bank.nearest(name, 3)))


def _read(path: Path | None) -> tuple[dict, dict, Model, StyleBank]:
    """Tensors and parts of a run's file, and the model and bank among them."""
    if path is None:
        with resources.as_file(resources.files("toolkit") / "data" / "pretrained.safetensors") as embedded:
            return _read(embedded)
    tensors, parts = model_files.read(path, "model")
    return tensors, parts, Model.from_parts(path, tensors, parts, None), StyleBank.from_parts(path, tensors, parts)
