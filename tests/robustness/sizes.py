"""Memory and time of all readers of files at two sizes: files that are dense, deep, wide, packed or untrue about themselves.

A reader may take ten times the file and 200 MB, and its time grows with the file, not with its square.
"""

import io
import itertools
import json
import math
import os
import re
import resource
import struct
import tempfile
import time
import warnings
import zipfile
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, NamedTuple

import numpy as np
import torch
import typer
from motion_files import Document, fbx, fbx_scene, packed, textured
from robustness.fuzz.trials import ROOM, TIMES

import toolkit as tk
from experiments.tables import Result
from toolkit.datasets import download, folder, leaks, style100
from toolkit.evaluation.recognition import Recogniser
from toolkit.features import store
from toolkit.io import amc, bvh, gltf, gltf_mesh, npz
from toolkit.io import fbx as fbx_file
from toolkit.networks import Model
from toolkit.networks.bank import StyleBank
from toolkit.phases.learned import Learned
from toolkit.stylization.networks import Stylizer

PARTS = "model", "bank", "run", "stylizer", "recogniser", "learned"  # of model files
SLOWER = 2.0  # allowed growth of the time for each byte from the smaller to the larger file
LEAST = 0.3  # seconds: shorter times say nothing about their growth
ASF = (":version 1.10\n:units\nmass 1.0\nlength 1.0\nangle deg\n:root\norder TX TY TZ RX RY RZ\naxis XYZ\nposition 0 0 0\n"
       "orientation 0 0 0\n:bonedata\n")


class Case(NamedTuple):
    """A kind of file: ``write`` makes one of about a number of bytes in a folder, ``read`` gives the path to a reader."""

    write: Callable[[Path, int], Path]
    read: Callable[[Path], object]


class Cost(NamedTuple):
    """What reading one file took."""

    size: int  # bytes
    memory: int  # bytes beyond those before
    seconds: float  # of the processor
    said: str  # why it was refused; empty if it was read


COLUMNS = {"kind": ["kind of file"], "size": ["MB", 1], "memory": ["memory, MB", 0], "small": ["s/MB, smaller file", 2],
           "large": ["s/MB, larger file", 2], "said": ["larger file"]}


def run(
    megabytes: Annotated[float, typer.Option(min=0.1, help="Size of the smaller files.")] = 3.0,
    times: Annotated[int, typer.Option(min=2, help="How much larger the larger files are.")] = 4,
    only: Annotated[str, typer.Option(help="Names of cases that contain this.")] = "",
    store: Annotated[bool, typer.Option("--store", help="Write the result that the documentation shows.")] = False,
) -> None:
    """Memory and time of all readers at two sizes of hostile files: exit status 1 beyond 10 × the file + 200 MB."""
    failed, rows = [], []
    print(f"{'case':<26}{'MB':>7}{'× file':>8}{'MB more':>9}{'s':>8}{'s/MB':>8}{'growth':>8}  result")
    for name, case in CASES.items():
        if only not in name:
            continue
        small, large = (measured(case, int(1e6 * megabytes * k)) for k in (1, times))
        growth = (large.seconds / large.size) / max(small.seconds / small.size, LEAST / large.size)
        for one in (small, large):
            print(f"{name:<26}{one.size / 1e6:>7.1f}{one.memory / one.size:>8.1f}{one.memory / 1e6:>9.0f}{one.seconds:>8.2f}"
                  f"{one.seconds / one.size * 1e6:>8.2f}{growth if one is large else 1.0:>8.2f}  {one.said[:70] or 'read'}",
                  flush=True)
            if one.memory > TIMES * one.size + ROOM:
                failed.append(f"{name}: {one.memory / 1e6:.0f} MB for a file of {one.size / 1e6:.1f} MB")
        if growth > SLOWER:
            failed.append(f"{name}: {growth:.1f} times as long for each byte at {times} times the size")
        said = re.sub(r"^a file: |^[^ :]+(, line \d+)?: ", "", large.said)
        speeds = {key: 1e6 * one.seconds / one.size for key, one in (("small", small), ("large", large))}
        rows.append({"kind": name, "size": large.size / 1e6, "memory": large.memory / 1e6, **speeds,
                     "said": f"refused: {said[:80]}" if said else "read"})
    for line in failed:
        print(f"FAILED {line}")
    if store:
        about = "processor time and memory of reading a file, beyond a small file of the same kind; one thread"
        command = f"python -m experiments sizes --megabytes {megabytes:g} --times {times}"
        numbers = {"kinds": len(rows), "failed": len(failed), "refused": sum(row["said"] != "read" for row in rows)}
        made = Result("sizes", about, command, COLUMNS, rows, {"megabytes": megabytes, "times": times}, numbers)
        print(f"wrote {made.save()}")
    if failed:
        raise typer.Exit(1)


def measured(case: Case, size: int) -> Cost:
    """Read a file of about this size in a child process, which has read a small one before."""
    with tempfile.TemporaryDirectory() as place:
        (Path(place) / "first").mkdir()
        small, path = case.write(Path(place) / "first", 20_000), case.write(Path(place), size)
        read_end, write_end = os.pipe()
        if not (child := os.fork()):
            os.close(read_end)
            try:
                _try(case.read, small)
                before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
                began = time.process_time()
                said = _try(case.read, path)
                took = time.process_time() - began
                more = 1024 * (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
                os.write(write_end, json.dumps([more, took, said]).encode())
            finally:
                os._exit(0)
        os.close(write_end)
        with open(read_end, "rb") as answer:
            text = answer.read()
        os.waitpid(child, 0)
        if not text:
            raise ValueError(f"{path.name}: the reader's process died")
        return Cost(path.stat().st_size, *json.loads(text))


def _try(read: Callable[[Path], object], path: Path) -> str:
    try:
        with warnings.catch_warnings(action="ignore"):
            read(path)
    except (ValueError, OSError) as error:
        return str(error).replace(str(path), path.name)
    except BaseException as error:  # a child process must not go on
        return f"{type(error).__name__}: {error}"
    return ""


def _written(path: Path, data: str | bytes) -> Path:
    path.write_bytes(data.encode() if isinstance(data, str) else data)
    return path


def _tree(joints: int, ends: int = 1, *, channels: int = 1, deep: bool = False) -> tuple[list[str], int]:
    """Lines of a BVH hierarchy of joints below a root, and its number of channels."""
    names = " ".join(("Xrotation", "Yrotation", "Zrotation")[:channels])
    lines, opened = ["HIERARCHY", "ROOT j0", "{", "OFFSET 0 0 0", f"CHANNELS {channels} {names}"], 1
    for j in range(1, joints):
        lines += [f"JOINT j{j}", "{", "OFFSET 0 1 0", f"CHANNELS {channels} {names}", *([] if deep else ["}"])]
        opened += deep
    return lines + ["End Site", "{", "OFFSET 0 1 0", "}"] * ends + ["}"] * opened, joints * channels


def _bvh_rows(place: Path, size: int) -> Path:
    lines, width = _tree(30, channels=3)
    row = " ".join("0" * width)
    frames = size // (len(row) + 1)
    return _written(place / "a.bvh", "\n".join([*lines, "MOTION", f"Frames: {frames}", "Frame Time: 0.01", *[row] * frames]))


def _bvh_tree(joints: int, ends: int, each: int, deep: bool = False) -> Callable[[Path, int], Path]:
    def write(place: Path, size: int) -> Path:
        many = max(2, size // each)
        lines, width = _tree(many if joints else 1, many if ends else 1, deep=deep)
        motion = ["MOTION", "Frames: 1", "Frame Time: 0.01", " ".join("0" * width)]
        return _written(place / "a.bvh", "\n".join(lines + motion))

    return write


def _bvh_line(place: Path, size: int) -> Path:
    return _written(place / "a.bvh", "HIERARCHY\nROOT " + "a" * size)


def _gltf(document: Callable[[int], Document]) -> Callable[[Path, int], Path]:
    return lambda place, size: _written(place / "a.glb", document(size).glb())


def _keys(size: int) -> Document:
    made = Document([{"name": "a", "children": [1], "translation": [0, 1, 0]}, {"name": "b", "translation": [0, 1, 0]}])
    count = size // 32
    angles = np.arange(count, dtype=np.float32) / 100
    turns = np.stack((np.sin(angles), 0 * angles, 0 * angles, np.cos(angles)), 1)
    return made.animate((0, "rotation", np.arange(count) / 30, turns, "LINEAR"))


def _nodes(size: int) -> Document:
    count = size // 60
    nodes = [{"name": f"n{j}", "translation": [0, 1, 0], "children": [j + 1]} for j in range(count)] + [{"name": "end"}]
    return Document(nodes).animate((0, "rotation", [0.0, 1.0], np.eye(4, dtype=np.float32)[[3, 3]], "LINEAR"))


def _values(size: int) -> Document:
    return Document([{"name": "a", "extras": [[]] * (size // 4)}])


def _untrue(size: int) -> Document:
    """Accessors without data, each of as many values as a file may have."""
    made = Document([{"name": "a", "children": [1]}, {"name": "b"}])
    made.animate((0, "rotation", [0.0, 1.0], np.eye(4, dtype=np.float32)[[3, 3]], "LINEAR"))
    count = max(10, size // 100)
    for sampler in range(count):
        made.json["accessors"].append({"count": 250_000, "type": "VEC4", "componentType": 5126})
        made.json["animations"][0]["samplers"].append({"input": 0, "output": sampler + 2})
        made.json["animations"][0]["channels"].append({"sampler": sampler + 1, "target": {"node": sampler % 2,
                                                                                           "path": "rotation"}})
    return made


def _skinned(nodes: list[dict], vertices: int) -> Document:
    """A mesh on the first of these nodes; the others are joints of its skin."""
    doc = Document([{"mesh": 0, "skin": 0} | nodes[0], *nodes[1:]])
    shares = doc.add(np.full((vertices, 4), 255, "u1"), normalized=True)
    places, joints = (doc.add(np.zeros((vertices, width), "u1")) for width in (3, 4))
    attributes = {"POSITION": places, "JOINTS_0": joints, "WEIGHTS_0": shares}
    doc.json |= {"skins": [{"joints": [*range(1, len(nodes))]}], "meshes": [{"primitives": [{"attributes": attributes}]}]}
    return doc


def _vertices(size: int) -> Document:
    return _skinned([{"children": [1]}, {"children": [2]}, {}], size // 12)


def _joints(size: int) -> Document:
    """A chain of joints of one name."""
    return _skinned([{"name": "a" * 200, "children": [j + 1]} for j in range(size // 250)] + [{}], 3)


def _shared(size: int) -> Document:
    """A mesh of a third of the file, on each of many nodes."""
    count = size // 400
    doc = _skinned([{"children": [1]}, {"children": [*range(2, count)]}, *[{"mesh": 0}] * (count - 2)], size // 36)
    doc.json["skins"][0]["joints"] = [1]
    return doc


def _texture(size: int) -> Document:
    """A picture of as many pixels as three times this size, packed."""
    side = math.isqrt(3 * size)
    data = zlib.compress(bytes((side + 1) * side))
    chunks = [(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 0, 0, 0, 0)), (b"IDAT", data), (b"IEND", b"")]
    picture = b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in chunks)
    doc = _skinned([{"children": [1]}, {}], 3)
    textured(doc, doc.json["meshes"][0]["primitives"][0], np.zeros((3, 2), "f4"), picture)
    return doc


def _fbx(place: Path, size: int, packed_: bool = False) -> Path:
    """Curves of three joints; packed ones hold only zeros, and unpack to a thousand times their size."""
    count, curves = size // (30 if packed_ else 9 * 16), {}
    for j, axis in itertools.product(range(3), "XYZ"):
        times = np.zeros(count) if packed_ else np.arange(count) / 30
        curves[f"b{j}", "Lcl Rotation", axis] = times, np.zeros(count), [0], [0, 0, 0, 0]
    models = {f"b{j}": (f"b{j - 1}" if j else "", {"Lcl_Translation": [0.0, 10.0, 0.0]}) for j in range(3)}
    return _written(place / "a.fbx", fbx_scene(models, curves, pack_arrays=packed_))


def _fbx_packed(place: Path, size: int) -> Path:
    return _fbx(place, size, packed_=True)


def _fbx_records(place: Path, size: int) -> Path:
    models = [("Model", [j + 1, f"m{j}\0\x01Model", "LimbNode"], []) for j in range(size // 60)]
    return _written(place / "a.fbx", fbx([("Objects", [], models), ("Connections", [], [])]))


def _npz(place: Path, size: int) -> Path:
    return _written(place / "a.npz", packed(poses=np.zeros((size // 10, 72), np.float16), trans=np.zeros((size // 10, 3))))


def _npz_dense(place: Path, size: int) -> Path:
    joints = np.random.default_rng(0).normal(size=(size // 132, 22, 3)).astype(np.float16)
    np.savez(place / "a.npz", joints=joints)
    return place / "a.npz"


def _npz_members(place: Path, size: int) -> Path:
    with zipfile.ZipFile(place / "a.npz", "w") as out:
        for number in range(size // 110):
            out.writestr(f"{number}.npy", b"")
    return place / "a.npz"


def _amc(place: Path, size: int) -> Path:
    bone = "begin\n id 1\n name b\n direction 0 1 0\n length 1\n axis 0 0 0 XYZ\n dof rx ry rz\nend\n"
    _written(place / "a.asf", f"{ASF}{bone}:hierarchy\nbegin\n root b\nend\n")
    frames = size // 30
    rows = "".join(f"{number}\nroot 0 0 0 0 0 0\nb 0 0 0\n" for number in range(1, frames + 1))
    return _written(place / "a.amc", f":FULLY-SPECIFIED\n:DEGREES\n{rows}")


def _asf(place: Path, size: int) -> Path:
    count = size // 110
    bones = "".join(f"begin\n id {j}\n name b{j}\n direction 0 1 0\n length 1\n axis 0 0 0 XYZ\n dof rx ry rz\nend\n"
                    for j in range(1, count + 1))
    below = "".join(f" b{j} b{j + 1}\n" for j in range(1, count))
    return _written(place / "a.asf", f"{ASF}{bones}:hierarchy\nbegin\n root b1\n{below}end\n")


def _table(place: Path, size: int) -> Path:
    row = "Neutral,0,9" + ",0,9" * 9
    header = "STYLE_NAME," + ",".join(f"{g}_{k}" for g in ("BR", "BW", "FR", "FW", "ID", "SR", "SW", "TR1", "TR2", "TR3")
                                      for k in ("START", "STOP"))
    return _written(place / "Frame_Cuts.csv", "\n".join([header, *[row] * (size // len(row))]))


def _commas(place: Path, size: int) -> Path:
    return _written(place / "Frame_Cuts.csv", "STYLE_NAME" + "," * (size // 2) + "\nNeutral" + "," * (size // 2))


def _labels(place: Path, size: int) -> Path:
    _written(place / "a.bvh", "")
    return _written(place / "labels.csv", "file,style\n" + "a.bvh,b\n" * (size // 8))


def _split(apart: int) -> Callable[[Path, int], Path]:
    """A split of blocks of 9 frames of one take, with as many frames between the starts of a part's blocks."""
    def write(place: Path, size: int) -> Path:
        train, test = ([["a", "FW", first + apart * j, first + apart * j + 9] for j in range(size // 60)]
                       for first in (0, apart // 2))
        return _written(place / "split.json", json.dumps({"train": train, "test": test}))

    return write


def _brackets(name: str) -> Callable[[Path, int], Path]:
    return lambda place, size: _written(place / name, "[" + "[]," * (size // 3) + "0]")


def _tensors(place: Path, size: int) -> Path:
    header = {f"t{j}": {"dtype": "F32", "shape": [0], "data_offsets": [0, 0]} for j in range(size // 62)}
    return _header(place, header | {"__metadata__": {"format": "toolkit 1", "model": "{}", "bank": "[]", "run": "{}"}})


def _metadata(place: Path, size: int) -> Path:
    text = "[" + "[]," * (size // 3 // len(PARTS)) + "0]"
    return _header(place, {"__metadata__": {"format": "toolkit 1"} | dict.fromkeys(PARTS, text)})


def _numbers(place: Path, size: int) -> Path:
    header = {"model.x": {"dtype": "U8", "shape": [size], "data_offsets": [0, size]},
              "__metadata__": {"format": "toolkit 1", "model": "{}", "bank": "[]", "run": "{}"}}
    return _header(place, header, bytes(size))


def _header(place: Path, header: dict, data: bytes = b"") -> Path:
    text = json.dumps(header, separators=(",", ":")).encode()
    return _written(place / "a.safetensors", struct.pack("<Q", len(text)) + text + data)


def _names(place: Path, size: int) -> Path:
    names = [f"style{j}" for j in range(max(1, size // 24))]
    StyleBank(tuple(names), torch.zeros(len(names), 2)).save(place / "a.safetensors")
    return place / "a.safetensors"


def _members(place: Path, size: int) -> Path:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as out:
        for number in range(size // 96):
            out.writestr(f"{number}.txt", b"")
    return _written(place / "a.zip", file.getvalue())


def _unpack(path: Path) -> object:
    return download.unpack(path, path.parent / "unpacked", lambda name: None, 10**9)


CASES = {
    "bvh, rows": Case(_bvh_rows, bvh.load),
    "bvh, joints": Case(_bvh_tree(1, 0, 52), bvh.load),
    "bvh, nested joints": Case(_bvh_tree(1, 0, 52, deep=True), bvh.load),
    "bvh, end sites": Case(_bvh_tree(0, 1, 24), bvh.load),
    "bvh, one line": Case(_bvh_line, bvh.load),
    "bvh, rows, tk.load": Case(_bvh_rows, tk.load),
    "gltf, keys": Case(_gltf(_keys), gltf.read),
    "gltf, nodes": Case(_gltf(_nodes), gltf.read),
    "gltf, JSON values": Case(_gltf(_values), gltf.read),
    "gltf, untrue accessors": Case(_gltf(_untrue), gltf.read),
    "mesh, vertices": Case(_gltf(_vertices), gltf_mesh.read),
    "mesh, chain of joints": Case(_gltf(_joints), gltf_mesh.read),
    "mesh, on many nodes": Case(_gltf(_shared), gltf_mesh.read),
    "mesh, packed texture": Case(_gltf(_texture), gltf_mesh.read),
    "fbx, curves": Case(_fbx, fbx_file.read),
    "fbx, packed curves": Case(_fbx_packed, fbx_file.read),
    "fbx, records": Case(_fbx_records, fbx_file.read),
    "npz, packed poses": Case(_npz, npz.read),
    "npz, joints": Case(_npz_dense, npz.read),
    "npz, members": Case(_npz_members, npz.read),
    "amc, rows": Case(_amc, amc.read),
    "asf, bones": Case(_asf, amc.read),
    "100STYLE table": Case(_table, lambda path: style100.frame_cuts(path.parent)),
    "100STYLE table, commas": Case(_commas, lambda path: style100.frame_cuts(path.parent)),
    "labels.csv": Case(_labels, lambda path: folder.labelled(path.parent)),
    "split, no leak": Case(_split(1000), leaks.find),
    "split, leaks": Case(_split(0), leaks.find),
    "split, JSON values": Case(_brackets("split.json"), leaks.find),
    "shots, JSON values": Case(_brackets("shots.json"), tk.shots.load),
    "manifest, JSON values": Case(_brackets("manifest.json"), lambda path: store.load(path.parent)),
    "model, tensors": Case(_tensors, Model.load),
    "model, metadata": Case(_metadata, Model.load),
    "model, numbers": Case(_numbers, Model.load),
    "run, metadata": Case(_metadata, tk.training.load),
    "stylizer, metadata": Case(_metadata, Stylizer.load),
    "recogniser, metadata": Case(_metadata, Recogniser.load),
    "phases, metadata": Case(_metadata, Learned.load),
    "bank, names": Case(_names, StyleBank.load),
    "archive, members": Case(_members, _unpack),
}
