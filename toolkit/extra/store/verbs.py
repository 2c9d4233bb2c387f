"""The verb `preprocess`: a whole dataset into a store."""

from pathlib import Path
from typing import Annotated

from typer import Option

from toolkit import datasets
from toolkit.cli.motion_files import dataset
from toolkit.cli.verbs import Listed, Mirror, Root, Selection, say
from toolkit.extra import store


def preprocess(
    data: Annotated[str, Option(
        help="Dataset of files: 100style, bandai; or a folder of your own.")],
    out: Annotated[Path, Option(
        help="Folder of the store; the same command continues a stopped run.")],
    root: Root = None,
    styles: Selection = None,
    gaits: Selection = None,
    source: Annotated[str, Option(help="Phase source.")] = "hybrid",
    mirror: Mirror = False,
    listed: Listed = False,
    workers: Annotated[int | None, Option(
        min=1, help="Processes; by default one per processor.")] = None,
) -> None:
    """Compute features of all files into a store, which `train --data OUT` reads from the disk."""
    data, root = dataset(data, root)
    mirrored = datasets.may_mirror(data, root) if mirror else None
    made = store.preprocess(data, root, out, styles=styles, gaits=gaits, source=source,
                            mirror=mirrored, workers=workers, listed=listed, progress=True)
    found = store.load(out)
    say(f"{found.n_frames:,} frames of {len(found.styles)} styles in {out}"
        + ("" if made else ": finished before, nothing to do"))
