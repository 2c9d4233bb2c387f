"""The files of a store: written whole or not at all, checksummed, memory-mapped."""

import hashlib
import json
import re
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from safetensors import SafetensorError, safe_open
from safetensors.torch import save
from torch import Tensor

from toolkit.features.layout import Layout
from toolkit.io.files import opened, parsed, write_whole
from toolkit.io.files import read as read_bytes
from toolkit.io.model_files import intact, plain
from toolkit.motion.names import checked

FORMAT = "toolkit store 1"
SPLIT = "split.safetensors"
RESERVED = re.compile("split|con|prn|aux|nul|com[0-9]|lpt[0-9]", re.IGNORECASE)  # the file above, and devices of Windows
MANIFEST = "manifest.json"


def names(styles: Iterable[str]) -> dict[str, str]:
    """The name of each style's file, which every file system takes and keeps apart from the others."""
    styles = tuple(styles)
    alike = Counter(style.casefold() for style in styles)
    found = {}
    for style in styles:
        word = re.sub(r"[^A-Za-z0-9_-]+", "-", style)[:60]
        if word != style or alike[style.casefold()] > 1 or RESERVED.fullmatch(style):
            word += "." + hashlib.sha256(style.encode()).hexdigest()[:16]
        found[style] = f"{word}.safetensors"
    return found


def write(path: Path, tensors: dict[str, Tensor]) -> dict[str, Any]:
    """Write a file, whole or not at all; returns its size and checksum."""
    packed = save(tensors)
    write_whole(path, packed)
    return {"bytes": len(packed), "sha256": hashlib.sha256(packed).hexdigest()}


def read(path: Path, entry: dict[str, Any]) -> dict[str, Tensor]:
    """Memory-mapped tensors of a file that the manifest lists."""
    if not path.is_file() or path.stat().st_size != entry["bytes"]:
        raise ValueError(f"{path}: missing or not whole; run the command that makes the store again")
    try:
        with safe_open(path, framework="pt") as file:
            return {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118 (not a dict)
    except SafetensorError as error:
        raise ValueError(f"{path}: damaged ({plain(error)}); remove it and make the store again") from error


def write_manifest(out: Path, manifest: dict[str, Any]) -> None:
    """Write a store's manifest, styles in alphabetical order."""
    manifest = manifest | {"partitions": dict(sorted(manifest["partitions"].items()))}
    write_whole(out / MANIFEST, json.dumps(manifest, indent=1).encode())


def read_manifest(path: Path) -> dict[str, Any]:
    """The manifest of a store; ValueError if there is none or it is damaged."""
    try:
        manifest = parsed(read_bytes(path / MANIFEST))
    except FileNotFoundError:
        raise ValueError(f"{path}: holds no store (no {MANIFEST})") from None
    except ValueError as error:
        raise ValueError(f"{path / MANIFEST}: damaged ({plain(error)})") from error
    found = manifest.get("format") if isinstance(manifest, dict) else None
    if found != FORMAT:
        raise ValueError(f"{path / MANIFEST}: expected the format {FORMAT!r}, got {found!r}")
    with intact(path / MANIFEST, "the manifest"):
        entries = manifest["partitions"]
        if manifest["finished"] and not entries:
            raise ValueError("finished without a style")
        for entry in (*entries.values(), *([manifest["split"]] if manifest["finished"] else [])):
            file, size = entry["file"], entry["bytes"]
            if not file.isprintable() or Path(file).name != file or not isinstance(size, int) or not entry["sha256"]:
                raise ValueError(f"a file called {file!r} of {size!r} bytes")
        checked(entries, "a style")
        for entry in entries.values():
            checked((clip["gait"] for clip in entry["clips"] if clip["gait"]), "a gait")
            Layout.from_json(entry["layout"])
            frames, takes = ([clip[key] for clip in entry["clips"]] for key in ("frames", "take"))
            if not all(isinstance(n, int) and 0 <= n < 2**31 for n in (*frames, *takes)) or sum(frames) != entry["frames"]:
                raise ValueError(f"{entry['file']}: clips of {frames} frames are not {entry['frames']!r}")
        if missing := {"held_out", "seed"} - manifest["settings"].keys():
            raise ValueError(f"settings without {', '.join(missing)}")
    return manifest


def is_whole(out: Path, entry: dict[str, Any]) -> bool:
    """Whether a file in the manifest exists and has its checksum."""
    path = out / entry["file"]
    return path.is_file() and sha256(path) == entry["sha256"]


def sha256(path: Path) -> str:
    """SHA-256 of a file, hexadecimal."""
    with opened(path) as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
