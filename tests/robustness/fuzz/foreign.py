"""Targets of the fuzzing: the readers of glTF, FBX and NumPy files."""

import io
import json
import random
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from motion_files import Document, axis_angles, fbx_scene, glb, packed, smpl_walk, textured
from PIL import Image
from robustness.fuzz import Reader, mutations

from toolkit.extra.characters import gltf_mesh
from toolkit.extra.formats import fbx, gltf, npz
from toolkit.extra.formats.key_times import MOST
from toolkit.io.recording import Recording

ANIMATIONS = (None,) * 9 + (0, "0", 1, -1, "Walk", "", "9" * 5000, "\ud800", "a\nb", "²", True)


def _tree(names: Sequence[str], parents: Sequence[int]) -> None:
    """Checks the joints that were read."""
    assert len(set(names)) == len(names), "names that repeat"
    assert parents[0] == -1, "no root"
    assert all(0 <= p < j for j, p in enumerate(parents[1:], 1)), "a parent after its child"


def _checked(read: Callable[[Path], Recording]) -> Callable[[Path], None]:
    """A reader that compares what was read with what a recording must be."""

    def check(path: Path) -> None:
        made = read(path)
        frames, joints = made.rotations.shape[:2]
        assert made.offsets.shape == (joints, 3), "another number of offsets"
        assert made.root_positions.shape == (frames, 3), "another number of root positions"
        assert frames, "no frame"
        assert frames * joints <= max(path.stat().st_size, 2 * MOST), "more than the file can hold"
        assert len(made.names) == joints, "another number of names"
        _tree(made.names, made.parents)
        assert all(name and name.isprintable()
                   for name in (*made.names, *made.doubts)), "a name that cannot be printed"
        assert all(x.isfinite().all()
                   for x in (made.rotations, made.offsets, made.root_positions)), "not finite"
        assert float((made.rotations.norm(dim=-1) - 1).abs().max()) < 1e-3, "no unit quaternion"
        assert 0 < made.fps < float("inf"), "no frame rate"
        named = {*(made.roles or {}).values(), *made.ends}
        assert named <= set(made.names), "a joint that does not exist"

    return check


def _animated(read: Callable) -> Callable[[Path], None]:
    """`_checked`, of the first animation or of one that the file's bytes decide."""
    return _checked(lambda path: read(path, random.Random(path.read_bytes()).choice(ANIMATIONS)))


def _gltf(folder: Path) -> list[Reader]:
    nodes = [{"name": "Armature", "scale": [0.01] * 3, "children": [1]},
             {"name": "hips", "children": [2, 4]},
             {"name": "spine", "translation": [0, 1, 0], "children": [3]},
             {"name": "headEnd", "translation": [0, 0.5, 0]},
             {"matrix": np.eye(4).ravel().tolist(), "name": "leg"}]
    turns = np.float32(np.random.default_rng(0).normal(size=(4, 4)))
    times = np.arange(4) / 30
    places, ones = np.float32(np.arange(12).reshape(4, 3)), np.ones((4, 3), np.float32)
    doc = Document(nodes, skins=[{"joints": [1, 2, 3, 4]}]).animate(
        (1, "translation", times, places, "LINEAR"), (1, "rotation", times, turns, "LINEAR"),
        (2, "rotation", times, np.repeat(turns, 3, 0), "CUBICSPLINE"),
        (3, "scale", times, ones, "STEP"),
        (4, "rotation", times, np.int16(turns * 9000), "STEP", {"normalized": True}))
    rows = doc.json["accessors"][doc.add(np.array([1], "<u2"))]
    doc.json["accessors"][1]["sparse"] = {"count": 1, "values": {"bufferView": 1}, "indices": {
        "bufferView": rows["bufferView"], "componentType": rows["componentType"]}}
    bones = [{"bone": "hips", "node": 1}, {"bone": "leftUpperLeg", "node": 4}]
    vrm = Document([dict(node) for node in nodes],
                   extensions={"VRM": {"humanoid": {"humanBones": bones}}})
    vrm.animate((1, "rotation", times, turns, "LINEAR"))
    seeds = doc.glb(), vrm.glb()

    def mutate(rng: random.Random, data: bytes) -> bytes:
        if rng.random() < 0.2:
            return mutations.flipped(rng, data)
        size = int.from_bytes(data[12:16], "little")
        document, body = json.loads(data[20 : 20 + size]), data[28 + size :]
        if rng.random() < 0.3:
            body = mutations.number(rng, body)
        for _ in range(rng.choice((0, 1, 1, 1, 2, 4))):
            document = mutations.tree(rng, document)
        return glb(document, body)

    return [Reader("gltf", folder / "a.glb", _animated(gltf.read), seeds, mutate),
            Reader("mesh", folder / "b.glb", _whole_mesh, (_skinned(),), mutate)]


def _skinned() -> bytes:
    """A file with a mesh over two joints and one that hangs on a joint."""
    nodes = [{"name": "Armature", "scale": [0.01] * 3, "children": [1, 3]},
             {"name": "hips", "children": [2, 4]},
             {"name": "spine", "translation": [0, 100, 0]}, {"name": "body", "mesh": 0, "skin": 0},
             {"name": "hat", "mesh": 1}]
    doc, rng = Document(nodes), np.random.default_rng(0)
    points = doc.add(rng.normal(size=(6, 3)).astype(np.float32))
    inverse = doc.add(np.eye(4, dtype=np.float32)[None].repeat(2, 0).reshape(8, 4))
    doc.json["accessors"][inverse] |= {"type": "MAT4", "count": 2}
    shares, joints = rng.random((6, 4)).astype(np.float32), rng.integers(0, 2, (6, 4))
    skin = {"JOINTS_0": doc.add(joints.astype("u1")), "WEIGHTS_0": doc.add(shares),
            "POSITION": points}
    triangles = doc.add(np.arange(6, dtype="<u2"))
    primitive, picture = {"attributes": skin, "indices": triangles}, io.BytesIO()
    Image.fromarray(rng.integers(0, 255, (4, 5, 3), "u1")).save(picture, "PNG")
    textured(doc, primitive, rng.random((6, 2)).astype(np.float32), picture.getvalue())
    doc.json |= {
        "skins": [{"joints": [1, 2], "inverseBindMatrices": inverse}],
        "meshes": [{"primitives": [primitive]},
                   {"primitives": [{"attributes": {"POSITION": points}}]}]}
    return doc.glb()


def _whole_mesh(path: Path) -> None:
    """Compares a mesh that was read with what one must be."""
    made = gltf_mesh.read(path)
    count, joints = len(made.points), len(made.names)
    assert ((made.triangles >= 0) & (made.triangles < count)).all(), "no such vertex"
    assert ((made.joints >= 0) & (made.joints < joints)).all(), "no such joint"
    assert all(np.isfinite(x).all()
               for x in (made.points, made.weights, made.rest, made.bind)), "not finite"
    assert np.abs(made.weights.sum(1) - 1).max(initial=0.0) < 1e-4, "weights that do not sum to 1"
    _tree(made.names, made.parents)
    assert count <= path.stat().st_size, "more than the file can hold"


def _fbx(folder: Path) -> list[Reader]:
    rng = np.random.default_rng(0)
    up = {"Lcl_Translation": [0.0, 10.0, 0.0]}
    models = {"hips": ("", {}), "spine": ("hips", up | {"PreRotation": [0.0, 90.0, 0.0]}),
              "head": ("spine", up | {"RotationOrder": [3], "InheritType": [2]})}
    curves = {(name, what, axis): (np.arange(4) / 30, rng.normal(0, 9, 4), [8 | 0x400] * 2 + [4, 8],
                                   rng.normal(size=(4, 4)))
              for name, what in (("hips", "Lcl Translation"), ("spine", "Lcl Rotation"))
              for axis in "XYZ"}
    seeds = fbx_scene(models, curves), fbx_scene(models, curves, version=7500, pack_arrays=False)

    def mutate(rng: random.Random, data: bytes) -> bytes:
        return mutations.flipped(rng, data, in_place=rng.random() < 0.9)

    return [Reader("fbx", folder / "a.fbx", _animated(fbx.read), seeds, mutate)]


def _npz(folder: Path) -> list[Reader]:
    walk = smpl_walk(0.1)
    poses = axis_angles(walk.rotations).flatten(1).numpy()
    seeds = tuple(packed(**arrays) for arrays in (
        {"poses": np.pad(poses, ((0, 0), (0, 6))), "trans": walk.root_positions,
         "mocap_framerate": 60.0},
        {"poses": poses, "trans": walk.root_positions, "joints": walk.global_positions, "fps": 60},
        {"joints": walk.global_positions},
        {"root_orient": poses[:, :3], "pose_body": poses[:, 3:], "trans": walk.root_positions}))
    plain = io.BytesIO()
    np.save(plain, np.random.default_rng(0).normal(0, 0.1, (4, 263)))

    def arrays(rng: random.Random, data: bytes) -> bytes:
        """Another array, shape, type or number in an archive."""
        if rng.random() < 0.3:
            return mutations.flipped(rng, data)
        parts = dict(np.load(io.BytesIO(data)))
        name = rng.choice([*parts])
        values = parts[name]
        match rng.randrange(4):
            case 0:
                del parts[name]
            case 1:
                parts[rng.choice(("poses", "trans", "joints", "fps", "x", "posed_joints"))] = values
            case 2 if values.size:
                values = values.astype(np.float64).ravel()
                values[rng.randrange(values.size)] = rng.choice((np.nan, np.inf, 1e308, -1e7, 0.0,
                                                                 3.0))
                parts[name] = values.reshape(parts[name].shape)
            case _:
                parts[name] = values[tuple(slice(0, rng.choice((0, 1, 2, None)))
                                           for _ in range(values.ndim))]
        return packed(**parts)

    return [Reader("npz", folder / "a.npz", _checked(npz.read), seeds, arrays),
            Reader("npy", folder / "a.npy", _checked(npz.read), (plain.getvalue(),),
                   mutations.flipped)]


MAKERS = {"gltf": _gltf, "fbx": _fbx, "npz": _npz}
