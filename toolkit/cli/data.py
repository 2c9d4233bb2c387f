"""The verb `data`: download, list and split datasets, write the procedural one."""

import re
import sys
from pathlib import Path
from typing import Annotated, Any

import typer
from tqdm import tqdm
from typer import Argument, Option

from toolkit import datasets
from toolkit.cli.verbs import ClipSeconds, Root, Seed, Selection, names, say
from toolkit.datasets import blocks, home, procedural
from toolkit.datasets.fetch import ORIGINS, RECORD, fetch, find, has, record
from toolkit.io import save as saving

app = typer.Typer(no_args_is_help=True, add_completion=False)


@app.command("fetch")
def data_fetch(
    name: Annotated[str, Argument(help=f"One of {', '.join(ORIGINS)}.")],
    root: Annotated[Path | None, Option(
        help="Folder for the dataset; by default where verbs look for it.")] = None,
    source: Annotated[str | None, Option(
        "--from", help="Another copy: a file or an address.")] = None,
    sha256: Annotated[str | None, Option(
        help="Checksum of the archive, where it is not the published one.")] = None,
    styles: Annotated[Any, Option(
        parser=names, metavar="A,B,…",
        help="Fetch only these styles of 100style, about 15 MB each; others can be added later."
    )] = None,
    yes: Annotated[bool, Option("--yes", "-y", help="Do not ask; the terms are accepted.")] = False,
) -> None:
    """Download a dataset, after showing its size and terms; it goes on where it was interrupted."""
    if sha256 and not re.fullmatch("[0-9a-fA-F]{64}", sha256):
        raise ValueError(f"--sha256 expects 64 hexadecimal digits, got {sha256!r}")
    origin, folder = find(name), root or home.folder(name)
    known = record(folder)
    if known and has(known, styles):
        say(f"{name} is there already, of {known['date'][:10]}: {known['found']} in {folder}")
        return
    size = tqdm.format_sizeof(origin.size, "B") if origin.size else "not known before"
    if styles:
        size = f"about {15 * len(styles)} MB of {size}"
    say(f"{origin.title}\n  from   {source or origin.url}")
    unpacked = origin.unpacked * (len(styles) / 100 if styles else 1)
    say(f"  size   {size}; unpacked about {tqdm.format_sizeof(unpacked, 'B')}")
    say(f"  terms  {origin.terms}\n  into   {folder}")
    if not yes:
        if not sys.stdin.isatty():
            raise ValueError("nothing was fetched: without a terminal to ask on, --yes accepts "
                             "size and terms")
        if not typer.confirm("Fetch it?"):
            raise typer.Exit(1)
    known = fetch(name, folder, source, sha256, styles=styles, progress=True)
    say(f"{known['found']}, {known['files']} files in {folder}")
    if known["sha256"]:
        same = " (as published)" if known["sha256"] == origin.sha256 else ""
        say(f"sha256 of the archive: {known['sha256']}{same}; kept in {RECORD}")
    if root is not None and folder.absolute() != home.folder(name).absolute():
        say(f"give --root {folder} to the commands that should use it, or set TOOLKIT_DATA")


@app.command("list")
def data_list(
    name: Annotated[str, Argument(help=f"Dataset: {', '.join(datasets.DATASETS)}.")],
    root: Root = None,
) -> None:
    """List the styles of a dataset, and how many takes of each gait the folder holds."""
    for style, gaits in datasets.contents(name, root).items():
        counts = ", ".join(f"{gait} {n}" for gait, n in gaits.items())
        say(f"{style:<20} {counts or 'no file here'}")


@app.command("split")
def data_split(
    name: Annotated[str, Argument(help="Dataset: 100style, bandai.")],
    out: Annotated[Path, Option(help="JSON file to write.")],
    root: Root = None,
) -> None:
    """Write training, validation and test parts without leaks, as lists of takes and frames."""
    saving.check(out, (".json",))
    made = datasets.split(name, root)
    made.save(out)
    for part in blocks.PARTS:
        of_part = getattr(made, part)
        frames = sum(block.stop - block.start for block in of_part)
        say(f"{part:<11}{len(of_part):>6} blocks{frames:>11,} frames")
    unseen = ", ".join(made.unseen) or "none"
    say(f"unseen styles, in the test alone: {unseen}; wrote {out}")


@app.command("write")
def data_write(
    name: Annotated[str, Argument(help="Dataset: procedural.")],
    out: Annotated[Path, Option(help="Folder to write.")],
    styles: Selection = None,
    gaits: Selection = None,
    clip_seconds: ClipSeconds = 8.0,
    seed: Seed = 0,
) -> None:
    """Write the procedural dataset in 100STYLE's layout, with its true contacts and phases."""
    if name != "procedural":
        raise ValueError(f"only the procedural dataset can be written, not {name!r}")
    procedural.write(out, styles, gaits, clip_seconds, seed)
    count = len(list(out.glob("*.bvh")))
    say(f"wrote {count} clips; read them by toolkit.datasets.load('100style', root={str(out)!r})")
