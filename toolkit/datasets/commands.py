"""Command line: ``python -m toolkit data fetch``."""

import re
import sys
from pathlib import Path
from typing import Annotated

import typer
from tqdm import tqdm

from toolkit.datasets import home
from toolkit.datasets.fetch import ORIGINS, RECORD, fetch, record


def data_fetch(
    name: Annotated[str, typer.Argument(help=f"One of {', '.join(ORIGINS)}.")],
    root: Annotated[Path | None, typer.Option(help="The dataset's folder; by default where every command looks.")] = None,
    source: Annotated[str | None, typer.Option("--from", help="Another copy: a file or an address.")] = None,
    sha256: Annotated[str | None, typer.Option(help="Of the archive, where it is not the published one.")] = None,
    yes: Annotated[bool, typer.Option("--yes", "-y", help="Do not ask; the terms are accepted.")] = False,
) -> None:
    """Fetch a dataset from its public home, after its size and terms; where that was cut, the same command goes on."""
    if name not in ORIGINS:
        raise ValueError(f"{name!r} cannot be fetched; there are {', '.join(ORIGINS)}")
    if sha256 and not re.fullmatch("[0-9a-fA-F]{64}", sha256):
        raise ValueError(f"--sha256 expects 64 hexadecimal digits, got {sha256!r}")
    origin, folder = ORIGINS[name], root or home.folder(name)
    if known := record(folder):
        print(f"{name} is there already, of {known['date'][:10]}: {known['found']} in {folder}")
        return
    archive = tqdm.format_sizeof(origin.size, "B") if origin.size else "made by the server when asked, size not known before"
    print(origin.title)
    print(f"  from   {source or origin.url}")
    print(f"  size   {archive}; unpacked about {tqdm.format_sizeof(origin.unpacked, 'B')}")
    print(f"  terms  {origin.terms}")
    print(f"  into   {folder}")
    if not yes:
        if not sys.stdin.isatty():
            raise ValueError("nothing was fetched: without a terminal to ask on, --yes accepts size and terms")
        if not typer.confirm("Fetch it?"):
            raise typer.Exit(1)
    known = fetch(name, folder, source, sha256, progress=True)
    print(f"{known['found']}, {known['files']} files in {folder}\nsha256 of the archive: {known['sha256']}"
          + (" (as published)" if known["sha256"] == origin.sha256 else "") + f"; kept in {RECORD}")  # fmt: skip
    if root is not None and folder.absolute() != home.folder(name).absolute():
        print(f"give --root {folder} to the commands that should use it, or set TOOLKIT_DATA")
