"""Jobs for the fault tests: small runs of commands that write files, each in its own process."""

import contextlib
import functools
import hashlib
import http.server
import importlib
import os
import re
import shutil
import signal
import sys
import time
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from unittest import mock

import safetensors.torch

from toolkit import networks, training, view
from toolkit.__main__ import VERBS
from toolkit.datasets import procedural
from toolkit.extra import store
from toolkit.extra.engines import onnx
from toolkit.extra.store import files
from toolkit.io import model_files, save as export
from toolkit.motion import Clip


@dataclass(frozen=True, eq=False)
class Job:
    """A job that is disturbed.

    ``work`` writes into a folder, and continues from the files in it. ``stage`` checks files that
    are not in the reference or that grow, and raises ValueError for a damaged one. ``content``
    extracts the part of a file that is equal in all runs.
    """

    name: str
    work: Callable[[Path], object]
    old: dict[str, bytes] = field(default_factory=dict)
    stage: Callable[[Path], object] | None = None
    staged: str = r"(?!)"  # names of files for ``stage``
    content: Callable[[bytes], object] = bytes

    def undisturbed(self, base: Path) -> tuple[dict[str, object], float]:
        """Contents of the files of an undisturbed run, and its seconds."""
        if self not in _UNDISTURBED:
            folder = base / "undisturbed"
            self.place(folder)
            finish(self.work, folder)  # compiles and fills caches
            self.place(folder)
            began = time.perf_counter()
            finish(self.work, folder)
            _UNDISTURBED[self] = self.contents(folder), time.perf_counter() - began
        return _UNDISTURBED[self]

    def contents(self, folder: Path) -> dict[str, object]:
        """Contents of the files that are equal in all runs."""
        return {name: self.content(path.read_bytes()) for name, path in files_of(folder)}

    def place(self, folder: Path) -> None:
        """Make a folder with only the old files."""
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        for name, data in self.old.items():
            (folder / name).write_bytes(data)


_UNDISTURBED: dict[Job, tuple[dict[str, object], float]] = {}


def prepare(base: Path, ends: contextlib.ExitStack) -> list[Job]:
    """The jobs, and the files that they read."""
    root, stored = base / "data", base / "store"
    for verb in ("data", "preprocess", "train"):
        importlib.import_module(VERBS[verb][0].split(":")[0])  # here, and not in the time of a job
    finish(lambda _: procedural.write(root, ["Neutral", "Zombie"], ["FW", "SW"], 5.0), base)
    finish(lambda _: store.preprocess("100style", root, stored, workers=1), base)
    with zipfile.ZipFile(base / "data.zip", "w") as archive:
        for path in sorted(root.iterdir()):
            archive.write(path, path.name)
    address = ends.enter_context(_serving((base / "data.zip").read_bytes()))
    digest = hashlib.sha256((base / "data.zip").read_bytes()).hexdigest()
    sizes = networks.Sizes(hidden=64, film_channels=8, film_kernel=5, film_dense=64)
    quick = functools.partial(training.Config.quick, save_every=0.1, sizes=sizes)
    clips, (model, bank) = procedural.load(["Neutral", "Zombie"], ["FW"],
                                           20.0), training.pretrained()

    def fetch(folder: Path) -> None:
        _command("data", "fetch", "100style", "--root", folder / "100style", "--from", address,
                 "--sha256", digest, "--yes")

    def preprocess(folder: Path) -> None:
        _command("preprocess", "--data", "100style", "--root", root, "--out", folder / "store",
                 "--workers", 1)

    def train(folder: Path) -> None:
        with mock.patch.object(training.Config, "quick", quick):
            _command("train", "--data", stored, "--out", folder / "run.safetensors", "--small",
                     "--epochs", 4, "--refit", 5,
                     "--resume")

    def write(clip: Clip, folder: Path) -> None:
        for suffix in (".bvh", ".html", ".glb"):
            export.save(clip, folder / f"walk{suffix}", title=clip.style)
        onnx.save(model, folder / "network.onnx", bank)
        view.web(model, bank, folder / "page.html", title=clip.style)

    def checkpoint(path: Path) -> None:
        model_files.read(path, "checkpoint")

    def manifest(path: Path) -> None:
        files.read_manifest(path.parent)
        for stored in path.parent.glob("*.safetensors"):
            files.read(stored)

    old = base / "old"
    finish(lambda _: write(clips[1], old), base)
    old_files = {path.name: path.read_bytes() for path in old.iterdir()}
    return [
        Job("fetch", fetch, content=lambda data: re.sub(rb'"date": "[^"]*"', b"", data)),
        Job("preprocess", preprocess, stage=manifest, staged="manifest.json"),
        Job("train", train, {"run.safetensors": b"an older run"}, checkpoint, r".*\.checkpoint",
            _weights),
        Job("export", functools.partial(write, clips[0]), old_files),
    ]


def files_of(folder: Path) -> Iterator[tuple[str, Path]]:
    """Names and paths of all files that are not temporary."""
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder)
        if path.is_file() and not any(part.startswith(".") for part in name.parts):
            yield name.as_posix(), path


def _weights(data: bytes) -> object:
    """The tensors of a file, without its times, which differ in every run."""
    try:
        return {name: tensor.numpy().tobytes()
                for name, tensor in safetensors.torch.load(data).items()}
    except safetensors.SafetensorError as error:
        raise ValueError(str(error)) from error


def _command(*words: object) -> None:
    from toolkit.__main__ import main

    if status := main([str(word) for word in words]):
        raise SystemExit(status)


def start(work: Callable[[Path], object], folder: Path, log: str = "one") -> int:
    """Fork a process that does the work; returns its id."""
    sys.stdout.flush()
    if child := os.fork():
        return child
    status = 1
    try:
        said = os.open(folder.parent / f"{log}.log", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(said, 2)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        try:
            work(folder)
            status = 0
        except SystemExit as ended:
            status = ended.code or 0
        except (ValueError, OSError) as error:
            print(f"error: {error}", file=sys.stderr)
            status = 2
        sys.stderr.flush()
    finally:
        os._exit(status)


def ended(child: int, folder: Path, log: str = "one") -> tuple[int, str]:
    """Exit status and messages of a process."""
    status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    return status, (folder.parent / f"{log}.log").read_text(encoding="utf-8", errors="replace")


def finish(work: Callable[[Path], object], folder: Path) -> None:
    """Do the work without disturbance; ValueError if it fails."""
    status, said = ended(start(work, folder), folder)
    if status:
        raise ValueError(f"an undisturbed run failed: {said[-500:]}")


@contextlib.contextmanager
def _serving(content: bytes) -> Iterator[str]:
    """Address of a slow server of one file in its own process, which supports ranges."""

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            first = int(re.sub(r"\D", "", self.headers.get("Range", "")) or 0)
            self.send_response(206 if first else 200)
            self.send_header("ETag", '"one"')
            self.send_header("Content-Length", str(len(content) - first))
            if first:
                self.send_header("Content-Range",
                                 f"bytes {first}-{len(content) - 1}/{len(content)}")
            self.end_headers()
            with contextlib.suppress(OSError):
                for at in range(first, len(content), 1 << 16):
                    self.wfile.write(content[at : at + (1 << 16)])
                    time.sleep(0.01)

        def log_message(self, *_) -> None:
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    child = os.fork()
    if not child:
        server.serve_forever()
    try:
        yield f"http://127.0.0.1:{server.server_port}/data.zip"
    finally:
        server.server_close()
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
