"""The verb `preprocess`: a whole dataset into a store."""

from pathlib import Path
from typing import Annotated

import typer

from toolkit import datasets
from toolkit.cli.verbs import Root
from toolkit.features import store


def preprocess(
    data: Annotated[str, typer.Option(help="Dataset of files: 100style, bandai, xia.")],
    out: Annotated[Path, typer.Option(help="Folder of the store; where a run was stopped, the same command goes on.")],
    root: Root = None,
    styles: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    gaits: Annotated[str | None, typer.Option(help="Comma-separated names; all where not given.")] = None,
    source: Annotated[str, typer.Option(help="Phase source.")] = "hybrid",
    mirror: Annotated[bool, typer.Option("--mirror", help="Add mirror images (100STYLE: of symmetric styles).")] = False,
    workers: Annotated[int | None, typer.Option(min=1, help="Processes; one per processor where not given.")] = None,
    scheduler: Annotated[str | None, typer.Option(help="Address of a Dask scheduler to do the work.")] = None,
) -> None:
    """Compute features, phases and contacts of all files into a store, which `train --data OUT` reads from the disk."""
    chosen = {kind: None if names is None else names.split(",") for kind, names in (("styles", styles), ("gaits", gaits))}
    mirrored = datasets.may_mirror(data, root) if mirror else None
    made = store.preprocess(data, root, out, **chosen, source=source, mirror=mirrored, workers=workers,
                            scheduler=scheduler, progress=True)
    found = store.load(out)
    print(f"{found.n_frames:,} frames of {len(found.styles)} styles in {out}"
          + ("" if made else ": finished before, all checksums are right, nothing to do"))
