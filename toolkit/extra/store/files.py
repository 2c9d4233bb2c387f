"""The files of a store: written whole or not at all, memory-mapped when they are read."""

import json
from pathlib import Path
from typing import Any

from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor

from toolkit.io.files import parsed, read as read_bytes, write_whole
from toolkit.io.model_files import intact, plain
from toolkit.motion.text import checked

FORMAT = "toolkit store 3"
MANIFEST = "manifest.json"


def of_style(out: Path, number: int) -> Path:
    """The file of a style, by its place in the manifest: its name may not do as a file's name."""
    return out / f"{number:03d}.safetensors"


def write(path: Path, tensors: dict[str, Tensor], about: dict[str, Any]) -> None:
    """Write tensors and their description; the same content gives the same bytes."""
    write_whole(path, save(tensors, {"about": json.dumps(about)}))


def read(path: Path) -> tuple[dict[str, Tensor], dict[str, Any]]:
    """Memory-mapped tensors and description of a file; ValueError if it is missing or not whole."""
    try:
        with safe_open(path, framework="pt") as file:
            tensors = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118
            return tensors, parsed(file.metadata()["about"])
    except (OSError, SafetensorError, KeyError, TypeError, ValueError) as error:
        raise ValueError(f"{path}: missing or damaged ({plain(error)}); run the command that makes "
                         "the store again") from error


def is_current(path: Path, sources: list[Path]) -> bool:
    """Whether a file is whole, and not older than the files that it is made from."""
    try:
        read(path)
    except ValueError:
        return False
    return path.stat().st_mtime >= max(source.stat().st_mtime for source in sources)


def write_manifest(out: Path, settings: dict[str, Any], styles: list[str]) -> None:
    """Write the settings of a store, and the names of its styles in the order of their files."""
    manifest = {"format": FORMAT, "settings": settings, "styles": styles}
    write_whole(out / MANIFEST, json.dumps(manifest, indent=1).encode())


def read_manifest(path: Path) -> tuple[dict[str, Any], list[str]]:
    """Settings and styles of a store; ValueError if there is none or its manifest is damaged."""
    if not (path / MANIFEST).exists():
        raise ValueError(f"{path}: holds no store (no {MANIFEST})")
    with intact(path / MANIFEST, "the manifest"):
        manifest = parsed(read_bytes(path / MANIFEST))
        if manifest["format"] != FORMAT:
            raise ValueError(f"expected the format {FORMAT!r}, got {manifest['format']!r}")
        settings, styles = manifest["settings"], checked(manifest["styles"], "a style")
        if missing := {"held_out", "seed"} - settings.keys() or not styles:
            raise ValueError(f"no styles, or no {missing}")
        return settings, list(styles)
