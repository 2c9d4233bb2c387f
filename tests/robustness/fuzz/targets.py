"""Targets of the fuzzing: all readers of files and the command line, with valid inputs as seeds."""

import contextlib
import copy
import hashlib
import io
import json
import random
import shutil
import warnings
import zipfile
from collections.abc import Iterator
from pathlib import Path
from unittest import mock

import numpy as np
import torch
from robustness.fuzz import Reader, foreign, mutations
from typer.core import TyperCommand

from toolkit import features, networks, runtime, training
from toolkit.datasets import fetch, folder as own, procedural, published_files, style100
from toolkit.evaluation.recognition import Recogniser
from toolkit.extra import shots, store
from toolkit.io import bvh
from toolkit.io.files import named
from toolkit.networks.bank import StyleBank
from toolkit.stylization import networks as stylizers
from toolkit.stylization.graph import SkeletonGraph
from toolkit.training import loop

CARRIER = b"""HIERARCHY
ROOT joint_Root
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Hips
  {
    OFFSET 7 7 7
    CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
    End Site
    {
      OFFSET 0 5 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.033333
0 0 0 0 0 0 1 90 2 0 0 0
0 0 0 0 0 0 1.5 90 9 0 1e1 -3
"""
TINY = networks.Sizes(hidden=4, experts=2, gating=4, film_channels=2, film_kernel=5, film_dense=4)
#: Functions that a command calls after its checks; they are replaced here.
WORK = [f"toolkit.{name}" for name in (
    "training.distributed.start", "training.fit", "features.build", "runtime.states",
    "datasets.procedural.load", "datasets.procedural.write", "extra.store.preprocess",
    "cli.demo.embedded", "cli.demo.make", "cli.style.learn", "cli.stylize.stylize",
    "cli.train_stylizer.build", "cli.data.fetch")]
VALUES = ("", "x", "-", "--", "0", "1", "-1", "3", "0.05", "nan", "inf", "-inf", "1e308", "1e-320",
          "9" * 30, "9" * 400, "\x1b[31m", "é", "a\nb", "\ud800", "a" * 300, "Neutral", "Zombie",
          "Neutral=0.5,Zombie=0.5", "Neutral=nan", "Neutral=1e308", "a=b=c", ",", "=", "FW",
          "procedural", "100style", "bandai", "xia", "lpn-film", "cpu", "cuda", "cuda:99", "bf16",
          "hybrid", "contact", "a.bvh", "a.html", "a.png", "a.nothing", "none/a.bvh", "folder",
          "good.bvh", "bad.bvh", "good.safetensors", "bad.safetensors", "/dev/null/a.bvh", "./..",
          "adv", "sty,ds")


def make(folder: Path, target: str = "all") -> dict[str, list[Reader]]:
    """Readers by target; their files are made in ``folder``, which must not be deleted during
    use.
    """
    makers = {"bvh": _bvh, "csv": _csv, "model": _model, "store": _store, "cli": _cli,
              "shot": _shot, **foreign.MAKERS}
    if target not in (*makers, "all"):
        raise ValueError(f"unknown target {target!r}; known: {', '.join(makers)}, all")
    folder = folder.resolve()
    for name in makers:
        (folder / name).mkdir(parents=True, exist_ok=True)
    made = {name: maker(folder / name) for name, maker in makers.items() if target in (name, "all")}
    for reader in [reader for readers in made.values() for reader in readers]:
        reader.path.write_bytes(reader.seeds[0])
        with contextlib.suppress(ValueError, OSError):
            reader.read(reader.path)  # no input pays for imports and for compiling functions
    return made


def _bvh(folder: Path) -> list[Reader]:
    seeds = [CARRIER] * 3  # short, so that a mutation probably has an effect
    bvh.save(procedural.generate("Neutral", seconds=0.2).cut(0, 3), folder / "seed.bvh")
    seeds.append((folder / "seed.bvh").read_bytes())

    def read(path: Path) -> None:
        with warnings.catch_warnings(action="ignore"):
            clip = bvh.load(path)
        assert clip.skeleton.offsets.isfinite().all(), "offsets that are not finite"
        most = max(path.stat().st_size, bvh.SMALL)
        assert len(clip) * len(clip.skeleton) <= most, "more than the file can hold"

    return [Reader("bvh", folder / "walk.bvh", read, tuple(seeds), mutations.text)]


def _csv(folder: Path) -> list[Reader]:
    procedural.write(folder, ["Neutral", "Zombie", "Old"], ["FW"], 0.2)
    rows = "ProceduralNeutral_FW.bvh,Neutral,walk,0.01,y", "ProceduralOld_FW.bvh,Old,,cm,"
    (folder / "labels.csv").write_text("\n".join(("file,style,gait,unit,up", *rows)))
    tables = {"Frame_Cuts.csv": style100.frame_cuts, "Dataset_List.csv": style100.styles,
              "labels.csv": own.labelled}
    archive, whole = folder / "100STYLE.zip", io.BytesIO()
    with zipfile.ZipFile(whole, "w", zipfile.ZIP_DEFLATED) as packed:
        for path in sorted(folder.iterdir()):
            packed.write(path, f"100STYLE/{path.name}")

    def one_style(path: Path) -> None:
        """One style out of an archive; its file must be the one that was packed."""
        into, known = folder / "unpacked", hashlib.sha256(path.read_bytes()).hexdigest()
        shutil.rmtree(into, ignore_errors=True)
        with named(str(path)):
            fetch.fetch("100style", into, path, known, styles=["ProceduralOld"])
        for found in into.rglob("*Old_FW.bvh"):
            assert found.read_bytes() == (folder / found.name).read_bytes(), "another file"

    return [*(Reader(name, folder / name, lambda path, table=table: table(path.parent),
                     ((folder / name).read_bytes(),), mutations.text)
              for name, table in tables.items()),
            Reader("archive", archive, one_style, (whole.getvalue(),), mutations.flipped)]


def _model(folder: Path) -> list[Reader]:
    """Runs, models, banks, checkpoints, stylizers, recognisers; published parameters, without a
    header.
    """
    data = features.build(procedural.load(["Neutral", "Zombie"], ["FW"], 7.0))
    config = training.Config.quick(steps=1, sizes=TINY, batch=4)
    training.fit(data, config, folder / "run.checkpoint").save(folder / "run.safetensors")
    new = training.load(folder / "run.safetensors").model

    def finite(path: Path) -> None:
        run = training.load(path)
        run.table()
        run.bank[run.bank.names[0]]

    def resume(path: Path) -> None:
        model = copy.deepcopy(new)
        loop.restore(path, model, loop.optimiser(model, config), config)

    sizes = stylizers.Sizes(channels=1, code=1, latent=1, hidden=2)
    stylizer, _ = stylizers.build(SkeletonGraph.of(data.layout.skeleton), ("old",), sizes)
    stylizer.save(folder / "stylizer.safetensors")
    recogniser = Recogniser(("a", "b"), features.Normaliser(torch.zeros(12), torch.ones(12)))
    recogniser.save(folder / "recogniser.safetensors")
    readers = {"run.safetensors": (finite, training.load, StyleBank.load),
               "run.checkpoint": (resume,),
               "stylizer.safetensors": (stylizers.Stylizer.load,),
               "recogniser.safetensors": (Recogniser.load,)}
    found = [Reader(name, folder / name, read, ((folder / name).read_bytes(),), mutations.tensors)
             for name, reads in readers.items() for read in reads]
    means = np.linspace(-1, 1, new.layout.n_inputs, dtype="<f4").tobytes()

    def numbers(path: Path) -> None:
        with mock.patch.object(published_files, "SHAPES", {"Xmean": (new.layout.n_inputs,)}):
            published_files.read(path.parent)

    return [*found, Reader("Xmean.bin", folder / "Xmean.bin", numbers, (means,), mutations.text)]


def _store(folder: Path) -> list[Reader]:
    """The manifest of a store, and a partition, whose size is in the manifest."""
    root, out = folder / "data", folder / "store"
    procedural.write(root, ["Neutral", "Zombie"], ["FW"], 4.5)
    store.preprocess("100style", root, out, workers=1)

    def read(path: Path) -> None:
        found = store.load(out)
        for rows in (found.inputs, found.outputs, found.phases, found.clips):
            for style in found.styles:
                rows[style][:2]

    names = [path.name for path in out.iterdir() if path.suffix != ".json"]

    def same_size(rng: random.Random, data: bytes) -> bytes:
        return (mutations.tensors(rng, data) + bytes(len(data)))[: len(data)]

    spoilt = dict.fromkeys(names, same_size) | {"manifest.json": mutations.json_text}
    return [Reader(name, out / name, read, ((out / name).read_bytes(),), mutate)
            for name, mutate in spoilt.items()]


def _shot(folder: Path) -> list[Reader]:
    """A file of shots; one that is read must give finite plans."""
    bank = training.pretrained().bank
    ways = [{"path": [[0, 0], [1, 2, 2.5], {"x": -1, "z": 4, "facing": [1, 0]}],
             "styles": [[0, "Neutral"]], "seed": 3},
            {"path": [[2, 0], [2, 5]],
             "styles": [[0, {"Old": 0.5, "Zombie": 0.5}, "linear"], [2, "Tiptoe", "jump"]],
             "speeds": [[0, 0.8], [3, 1.2]], "holds": [{"seconds": 1, "distance": 2}],
             "look_at": [0, 0], "duration": 9}]
    scene = json.dumps({"version": 1, "shots": ways, "apart": 1.0,
                        "walls": [[[5, 5], [6, 6]]]}).encode()

    def read(path: Path) -> None:
        with named(path):  # the bank, which may lack a style, does not know the file
            for asked in shots.Scene.load(path).shots[:4]:
                course, heading = asked.plan(bank)
                angle = heading.angle(course.distance[-1], (1.0, 1.0))
                assert np.isfinite([*course.distance, *course.speed, angle]).all(), "not finite"

    return [Reader("shot", folder / "shots.json", read, (scene,), mutations.json_text)]


def _cli(folder: Path) -> list[Reader]:
    """Any verb with any options; long work is replaced, and files are written only to the working
    folder.
    """
    from toolkit import __main__ as command_line

    # `shot` compiles too, for longer than an input may take
    runtime.compile(training.pretrained().model)
    stylizers.pretrained()  # `stylize` loads it, too
    (folder / "folder").mkdir(exist_ok=True)
    for name, data in (("bad.bvh", CARRIER[:-40]), ("good.bvh", CARRIER),
                       ("bad.safetensors", b"\0" * 64)):
        (folder / name).write_bytes(data)

    def leaves(command: TyperCommand, words: tuple[str, ...] = ()) -> Iterator[tuple]:
        command = getattr(command, "imported", command)
        yield words, command
        for name, sub in getattr(command, "commands", {}).items():
            yield from leaves(sub, (*words, name))

    commands = list(leaves(command_line.app))
    def passed(*_, **__):  # a new error each time: one that is raised again keeps all its frames
        raise ValueError("all checks passed")

    idle = [mock.patch(name, passed) for name in WORK]
    options = sorted({name for _, command in commands for p in command.params
                      for name in (*p.opts, *p.secondary_opts)
                      if name.startswith("-")})

    def line(rng: random.Random, _: bytes) -> bytes:
        words, command = rng.choice(commands)
        words = list(words)
        for parameter in command.params:
            if rng.random() < (0.9 if parameter.required else 0.3):
                named = parameter.param_type_name == "option"
                words += [rng.choice((*parameter.opts, *parameter.secondary_opts))] if named else []
                words += [] if getattr(parameter, "is_flag", False) else [rng.choice(VALUES)]
        for _ in range(rng.choice((0, 0, 0, 1, 2))):
            at = rng.randrange(len(words) + 1)
            words[at : at + rng.randrange(2)] = [rng.choice((*VALUES, *options))]
        return json.dumps(words).encode()

    def read(path: Path) -> None:
        out, err = io.StringIO(), io.StringIO()
        with (contextlib.chdir(folder), contextlib.redirect_stdout(out),
              contextlib.redirect_stderr(err), contextlib.ExitStack() as around,
              mock.patch.dict("os.environ", TOOLKIT_DATA=str(folder / "none"))):
            for function in idle:
                around.enter_context(function)
            status = command_line.main(json.loads(path.read_bytes()))
        said = err.getvalue()
        assert status in (0, 2), f"exit status {status}: {said[-200:]}"
        if status and any(sign in said + out.getvalue() for sign in ("Usage:", "╭─ Error")):
            raise ValueError(f"{path.name}: usage")
        if status:
            lines = said.splitlines()
            assert lines[-1].startswith("error: "), f"not an error: {said[-200:]!r}"
            assert all(map(str.isprintable, lines)), f"not printable: {said[-200:]!r}"
            raise ValueError(f"{path.name}: {lines[-1][7:]}")

    return [Reader("cli", folder / "arguments.json", read, (b"[]",), line)]
