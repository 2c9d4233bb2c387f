"""Readers of other tools' files: slow oracles, round trips, hostile input refused in one line."""

import base64
import contextlib
import dataclasses
import json
import tracemalloc
from random import Random

import numpy as np
import pytest
import torch
import unchanged
from motion_files import Document, axis_angles, fbx, fbx_scene, packed, smpl_walk
from refusal import refusal
from robustness import fuzz
from robustness.fuzz import targets
from scipy.spatial.transform import Rotation

import toolkit as tk
from toolkit.extra.formats import (
    fbx as fbx_reader,
    fbx_curves,
    fbx_records,
    gltf,
    gltf_file,
    humanml3d,
    interpretation,
    key_times,
    nodes,
    npz,
    recorded_body,
)
from toolkit.io import bvh, bvh_text
from toolkit.io.recording import Recording
from toolkit.motion import forward_kinematics


def world(recording):
    """Positions ``[F, J, 3]`` in the file's unit."""
    skeleton = tk.Skeleton(recording.names, recording.parents, recording.offsets, roles={},
                           ends=recording.ends)
    return forward_kinematics(skeleton, recording.rotations.double(), recording.root_positions)[1]


READERS = {".glb": gltf.read, ".gltf": gltf.read, ".vrm": gltf.read, ".fbx": fbx_reader.read,
           ".npz": npz.read, ".npy": npz.read, ".bvh": tk.io.load.read}


@pytest.fixture
def read(tmp_path):
    """``read(name, data, animation)``: a file with these data, read."""
    def read(name, data, *animation):
        path = tmp_path / name
        if data is not None:
            path.write_bytes(data.glb() if isinstance(data, Document) else data)
        return READERS[path.suffix](path, *animation)

    return read


@pytest.fixture
def refused(read):
    """As ``read``, of a file that is refused in a line with its name."""
    def refused(name, data, match, *animation):
        with refusal(match) as caught:
            read(name, data, *animation)
        assert name.rpartition("/")[2] in str(caught.value)
        assert type(caught.value) is ValueError

    return refused


@contextlib.contextmanager
def memory(most):
    tracemalloc.start()
    yield
    assert tracemalloc.get_traced_memory()[1] < most
    tracemalloc.stop()


# glTF

def tree(*rows):
    """Nodes of a name, the number of the parent and a translation each; the first has no parent."""
    nodes = [{"name": name, "translation": place or [0, 0, 0]} for name, _, *place in rows]
    for child, (_, parent, *_) in enumerate(rows[1:], 1):
        nodes[parent].setdefault("children", []).append(child)
    return nodes


CHAIN = tree(("hips", None), ("spine", 0, 0, 1, 0), ("headEnd", 1, 0, 0.5, 0))


def quaternions(angles):
    """About x, in glTF's order."""
    angles = np.asarray(angles, float)
    zero = np.zeros_like(angles)
    return np.float32(np.stack((np.sin(angles / 2), zero, zero, np.cos(angles / 2)), -1))


TURN = "rotation", [0, 0.1], quaternions([0, 1]), "LINEAR"


def moving(node, places, fps=30):
    return (node, "translation", np.arange(len(places)) / fps, np.float32(places), "LINEAR")


@pytest.mark.parametrize("kind", ["LINEAR", "STEP", "CUBICSPLINE"])
def test_samplers_at_and_between_the_keys(read, kind):
    times, angles = [0.0, 0.1, 0.2, 0.5], [0.0, 0.4, 0.6, 1.2]
    places = np.float32([[0, 0, 0], [0, 1, 0], [2, 1, 0], [3, 0, 0]])
    values, turns = places, quaternions(angles)
    if kind == "CUBICSPLINE":
        slopes = np.float32([[1, 0, 0], [0, 2, 0], [3, 0, 0], [0, 0, 1]])
        values = np.stack((2 * slopes, places, slopes), 1).reshape(-1, 3)
        turns = np.stack((0 * turns, turns, 0 * turns), 1).reshape(-1, 4)
    doc = Document(CHAIN).animate(
        (0, "translation", times, values, kind), (1, "rotation", times, turns, kind),
        (2, "translation", [0.1], np.float32([[0, 2, 0]]), "STEP"),
        (2, "weights", times, np.float32(times), "LINEAR"))  # of a blend shape
    made = read("a.glb", doc)
    assert made.fps == 30
    assert made.offsets[2].tolist() == [0, 2, 0]
    assert len(made.rotations) == 16
    for f in range(16):
        t = f / 30
        k = max(i for i in range(4) if times[i] <= t + 1e-6)
        k, span = (2, 0.3) if k == 3 else (k, times[k + 1] - times[k])
        s = (t - times[k]) / span
        if kind == "STEP":
            place, angle = places[3 if f == 15 else k], angles[3 if f == 15 else k]
        elif kind == "LINEAR":
            place, angle = (x[k] + s * (x[k + 1] - x[k]) for x in (places, np.array(angles)))
        else:
            h = 2 * s**3 - 3 * s**2 + 1, s**3 - 2 * s**2 + s, 3 * s**2 - 2 * s**3, s**3 - s**2
            place = h[0] * places[k] + h[1] * span * slopes[k]
            place = place + h[2] * places[k + 1] + h[3] * span * 2 * slopes[k + 1]
            q = h[0] * quaternions(angles)[k] + h[2] * quaternions(angles)[k + 1]
            angle = 2 * np.arctan2(q[0], q[3])
        assert made.root_positions[f].numpy() == pytest.approx(place, abs=1e-5)
        assert 2 * torch.atan2(made.rotations[f, 1, 1],
                               made.rotations[f, 1, 0]) == pytest.approx(angle, abs=1e-5)


def test_quantised_accessors_are_read_and_sparse_ones_refused(read, refused):
    times, angles = np.arange(8) / 30, np.linspace(-0.5, 1, 8)
    shorts = np.round(quaternions(angles) * 32767).astype("<i2")
    doc = Document(CHAIN).animate((1, "rotation", times, shorts, "LINEAR", {"normalized": True}),
                                  moving(0, np.zeros((8, 3))))
    made = read("a.glb", doc)
    spine = made.rotations[:, made.names.index("spine")]
    turned = 2 * torch.atan2(spine[:, 1], spine[:, 0])
    assert turned.numpy() == pytest.approx(angles, abs=1e-4)
    doc.json["accessors"][3]["sparse"] = {"count": 1}
    refused("a.glb", doc, "sparse ones")


def test_buffers_in_the_text_and_beside_it(read, refused, tmp_path):
    doc = Document(CHAIN).animate((1, *TURN))
    inside = doc.json | {"buffers": [{"uri": "data:;base64," + base64.b64encode(doc.data).decode(),
                                      "byteLength": 1}]}
    beside = doc.json | {"buffers": [{"uri": "a%20b.bin", "byteLength": 1}]}
    (tmp_path / "a b.bin").write_bytes(doc.data)
    right = read("a.glb", doc).rotations
    assert doc.json["bufferViews"][0].pop("byteOffset") == 0  # as it is where no file says it
    for document in (inside, beside):
        made = read("a.gltf", json.dumps(document).encode())
        assert torch.equal(made.rotations, right)
    (tmp_path / "in").mkdir()
    (tmp_path / "secret.bin").write_bytes(doc.data)
    for uri in ("../secret.bin", str(tmp_path / "secret.bin"), "file:///secret.bin", "none.bin",
                "a\0b"):
        document = doc.json | {"buffers": [{"uri": uri, "byteLength": 1}]}
        refused("in/a.gltf", json.dumps(document).encode(), "beside it|cannot be read|null")


@pytest.mark.parametrize("pose", [
    {"scale": [0.01] * 3, "rotation": [0.5**0.5, 0, 0, 0.5**0.5]},
    {"matrix": [0.01, 0, 0, 0, 0, 0, 0.01, 0, 0, -0.01, 0, 0, 0, 0, 0, 1]}])  # by columns
def test_an_armature_scaled_to_centimetres(read, pose):
    """Mixamo-like: the armature is 0.01 of its size and lies down, the hips go in centimetres."""
    nodes = tree(("Armature", None), ("mixamorig:Hips", 0), ("mixamorig:Spine", 1, 0, 0, -20),
                 ("mixamorig:Head", 2, 0, 0, -50), ("Body", 0))
    nodes[0] |= pose
    nodes[4]["mesh"] = 0
    places = np.float32([[0, 10 * f, -90] for f in range(4)])
    doc = Document(nodes, skins=[{"joints": [1, 2, 3]}]).animate(moving(1, places), (2, *TURN))
    made = read("a.glb", doc)
    assert made.names == ("mixamorig:Hips", "mixamorig:Spine", "mixamorig:Head")
    assert not made.doubts
    matrix = np.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
    assert made.root_positions.numpy() == pytest.approx(places @ matrix.T * 0.01, abs=1e-6)
    assert world(made)[0, 2].numpy() == pytest.approx([0, 1.6, 0], abs=1e-6)


def test_a_root_that_stays_while_the_hips_travel(read):
    nodes = tree(("root", None), ("pelvis", 0), ("spine", 1, 0, 0.5, 0), ("thigh_l", 1, 1, 0, 0),
                 ("calf_l", 3, 0, -4, 0), ("thigh_r", 1, -1, 0, 0), ("calf_r", 5, 0, -4, 0),
                 ("ik_foot_root", 0), ("ik_foot_l", 7))
    nodes[0]["rotation"] = [0, 1, 0, 0]
    places = np.float32([[0, 10, 2 * f] for f in range(5)])
    doc = Document(nodes, skins=[{"joints": list(range(9))}]).animate(
        moving(1, places, 24), moving(8, places, 24))
    made = read("a.glb", doc)
    assert made.names[0] == "pelvis"
    assert not any("ik" in name for name in made.names)
    assert "left out: ik_foot_root" in made.doubts[0]
    assert made.root_positions.numpy() == pytest.approx(places * [-1, 1, -1], abs=1e-6)
    assert made.fps == 24


@pytest.mark.parametrize("above", [0, -1])
def test_controls_outside_the_skin_are_left_out(read, above):
    """More animated controls than joints, below the hips (mirrored) or at the scene's top."""
    nodes = [dict(node) for node in CHAIN]
    nodes += [{"name": "controls", "children": list(range(4, 24)), "scale": [-1, 1, 1]},
              *[{"name": f"control{i}"} for i in range(20)]]
    if above == 0:
        nodes[0]["children"] = [1, 3]
    places = [[0, f, 0] for f in range(3)]
    doc = Document(nodes, skins=[{"joints": [0, 1, 2]}]).animate(
        (1, *TURN), *[moving(j, places) for j in range(4, 24)])
    made = read("a.glb", doc)
    assert made.names == ("hips", "spine", "headEnd")
    assert len(made.doubts) == 1


def test_several_animations_and_names_that_repeat(read, refused, tmp_path):
    nodes = [{"name": "a", "children": [1, 2]}, {"name": "a"}, {}]
    doc = Document(nodes)
    for name, end in (("idle", 0.1), ("walk", 0.2)):
        doc.animate((0, "rotation", [0, end], quaternions([0, 1]), "LINEAR"), name=name)
    made, path = read("a.glb", doc), tmp_path / "a.glb"
    assert made.names == ("a", "a_2", "node2")
    assert "2 animations (idle, walk); the first was read; animation= decides" in made.doubts[0]
    assert len(made.rotations) == 4
    for chosen in ("walk", 1, "1"):
        assert len(tk.load(path, "m", "y", animation=chosen)) == 7
        assert len(tk.inspect(path, animation=chosen).clip) == 7
    refused("a.glb", None, "no animation 'run'; there are idle, walk", "run")
    refused("a.bvh", b"", "has one motion", 0)


@pytest.mark.parametrize("extension", ["VRM", "VRMC_vrm", "VRMC_vrm_animation"])
def test_roles_of_vrm_files(read, extension):
    bones = {"hips": 0, "leftUpperLeg": 1, "leftLowerLeg": 2}
    listed = {bone: {"node": node} for bone, node in bones.items()}
    if extension == "VRM":
        listed = [{"bone": bone, "node": node} for bone, node in bones.items()]
    doc = Document(CHAIN, extensions={extension: {"humanoid": {"humanBones": listed}}})
    made = read("a.vrm", doc)
    assert made.roles == {"hips": "hips", "left_hip": "spine", "left_knee": "headEnd"}


def hostile(change):
    doc = Document([dict(node) for node in CHAIN]).animate((1, *TURN))
    change(doc.json)
    return doc


@pytest.mark.parametrize(("change", "problem"), [
    (lambda d: d["accessors"][0].update(count=10**12), "reaches beyond its buffer"),
    (lambda d: d["bufferViews"][1].update(byteStride=1), "reaches beyond its buffer"),
    (lambda d: d["bufferViews"][1].update(byteOffset=-4), "byteOffset should be a whole number"),
    (lambda d: d["bufferViews"][1].update(extensions={"EXT_meshopt_compression": {}}),
     r"`npx @gltf-transform/cli cp a\.glb plain\.glb` unpacks it"),
    (lambda d: d["nodes"][2].update(children=[1]), "two parents"),
    (lambda d: d["nodes"].append({"children": [len(d["nodes"])]}), "their own ancestors"),
    (lambda d: d["nodes"][1].update(translation=[0, float("nan"), 0]), "should be 3 numbers"),
    (lambda d: d["nodes"][0].update(scale=[-1, 1, 1]), "mirrored by a negative scale"),
    (lambda d: d["nodes"][0].update(matrix=np.diag([-1.0, 1, 1, 1]).ravel().tolist()),
     "mirrored by a negative scale"),
    (lambda d: d.update(nodes={}), "nodes should be a list of objects"),
    (lambda d: d.update(animations=[]), "there are no joints"),
])
def test_hostile_gltf_files(refused, change, problem):
    refused("a.glb", hostile(change), problem)


def test_accessors_are_decoded_once_and_hold_a_limited_number_of_values(read, refused, monkeypatch):
    """Two channels with one sampler, of two times and two quaternions: ten values."""
    data = hostile(lambda d: d["animations"][0]["channels"].append(
        {"sampler": 0, "target": {"node": 2, "path": "rotation"}})).glb()
    monkeypatch.setattr(gltf_file, "MOST", 10 - len(data))
    assert len(read("a.glb", data).rotations) == 4
    monkeypatch.setattr(gltf_file, "MOST", 9 - len(data))
    refused("a.glb", data, "its accessors have 10 values, more than a file of")


def test_forged_times_take_no_memory(refused):
    times = np.float32([0, 0.001, 0.002, 1e7])
    doc = Document(CHAIN).animate((1, "rotation", times, quaternions([0, 1, 2, 3]), "LINEAR"))
    with memory(1e7):
        refused("a.glb", doc, "frames of 1 joints are more than")
    refused("none.glb", None, "cannot be read")


# FBX

TURNS = ("xyz", "xzy", "yzx", "yxz", "zxy", "zyx")  # by RotationOrder, the first axis turns first
TWO = {"a": ("", {}), "b": ("a", {})}


def euler(angles, order="xyz"):
    made, each = np.eye(4), [angles["xyz".index(axis)] for axis in order]
    made[:3, :3] = Rotation.from_euler(order, each, degrees=True).as_matrix()
    return made


def shift(v):
    made = np.eye(4)
    made[:3, 3] = v
    return made


def keys(times, values, flag=4):
    """A curve of keys that are all of one kind: 4 linear, 8 cubic with automatic slopes."""
    return times, values, [flag] * len(times), np.zeros((len(times), 4))


def local(values, move, angles):
    """The FBX SDK's product of a node's transforms, one matrix at a time."""
    get = lambda name, default=(0, 0, 0): np.array(values.get(name, default), float)  # noqa: E731
    inverse = np.linalg.inv
    turn = euler(angles)
    scale = np.diag([*get("Lcl_Scaling", (1, 1, 1)), 1])
    if values.get("RotationActive", [1])[0]:
        own = euler(angles, TURNS[values.get("RotationOrder", [0])[0]])
        turn = euler(get("PreRotation")) @ own @ inverse(euler(get("PostRotation")))
    pivot, scale_pivot = shift(get("RotationPivot")), shift(get("ScalingPivot"))
    turn = pivot @ turn @ inverse(pivot)
    return (shift(move) @ shift(get("RotationOffset")) @ turn @ shift(get("ScalingOffset"))
            @ scale_pivot @ scale @ inverse(scale_pivot))


@pytest.mark.parametrize("order", [0, 2, 4])  # and the next one, of other joints
def test_fbx_transforms_by_a_slow_product_of_matrices(read, order):
    rng = np.random.default_rng(order)
    models = {"hips": ("", {"Lcl_Translation": [1.0, 2.0, 3.0], "RotationOrder": [order]})}
    for i, (name, parent) in enumerate((("spine", "hips"), ("arm", "spine"), ("hand", "arm"),
                                        ("leg", "hips"))):
        sizes = {"Lcl_Translation": 10, "Lcl_Rotation": 50, "PreRotation": 50, "PostRotation": 50,
                 "RotationOffset": 2}
        # pivots of a joint that turns would move it against its parent
        if name in ("hand", "leg"):
            sizes |= {"RotationPivot": 2, "ScalingPivot": 2, "ScalingOffset": 2}
        models[name] = (parent, {
            "RotationOrder": [(order + i) % 6], "RotationActive": [0 if name == "hand" else 1],
            "Lcl_Scaling": [1.5 if name in ("arm", "leg") else 1.0] * 3,
            **{what: rng.normal(0, size, 3).tolist() for what, size in sizes.items()}})
    times = np.arange(6) / 30
    animated = ("hips", "Lcl Translation"), ("spine", "Lcl Rotation"), ("arm", "Lcl Rotation")
    tracks = {(*track, axis): rng.normal(0, 40, 6) for track in animated for axis in "XYZ"}
    del tracks["arm", "Lcl Rotation", "Y"]
    curves = {key: keys(times, values, 8 | 0x400) for key, values in tracks.items()}
    scene = fbx_scene(models, curves, version=7400 + 50 * order,
                      settings={"UnitScaleFactor": [2.54]})
    made = read("a.fbx", scene)
    assert made.unit == pytest.approx(0.0254)
    assert made.up == "y"
    assert made.fps == 30
    places = world(made)
    for f in range(6):
        done = {}
        for name, (parent, values) in models.items():
            now = []
            for what in ("Lcl Translation", "Lcl Rotation"):
                still = values.get(what.replace(" ", "_"), [0.0] * 3)
                now.append(np.array([tracks.get((name, what, axis), [value] * 6)[f]
                                     for axis, value in zip("XYZ", still, strict=True)]))
            done[name] = done.get(parent, np.eye(4)) @ local(values, *now)
            place = places[f, made.names.index(name)].numpy()
            assert place == pytest.approx(done[name][:3, 3], abs=1e-3)


def test_fbx_curves_between_keys(read):
    """Constant, linear and cubic keys with the user's slopes, two frames apart at 30 Hz."""
    times, values = np.array([0.0, 2, 4, 6, 8]) / 30, [0.0, 10.0, 0.0, 20.0, 5.0]
    flags, data = [2, 4, 8 | 0x400, 8 | 0x400, 4], np.zeros((5, 4))
    data[2] = 300, -60, 0, 0  # to the right of key 2, to the left of key 3
    data[3] = 90, 30, 0, 0
    every = np.delete(np.arange(9.0), 4)  # each key has the value of the next one before it
    models = {"root": ("", {}), "prop": ("root", {}), "hips": ("root", {})}
    models |= {name: ("hips", {"Lcl_Translation": [0.0, 1.0, 0.0]}) for name in ("spine", "l", "r")}
    curves = {("hips", "Lcl Translation", "X"): (times, values, flags, data),
              ("hips", "Lcl Translation", "Y"): keys(every / 30, every, 2 | 0x100),
              # automatic: at the middle key 0.5 · -2 / (8 / 30) + 0.5 · (0.75 · 150 - 0.25 · 60)
              ("hips", "Lcl Translation", "Z"): keys(times[[0, 1, 4]], [0.0, 10.0, -2.0], 8)}
    scene = fbx_scene(models, curves)
    boneless = read("a.fbx", scene.replace(b"LimbNode", b"MeshNode"))
    assert boneless.names == ("hips",)  # no bone, but it moves
    made = read("a.fbx", scene)
    assert made.names == ("hips", "spine", "l", "r")  # the prop is no limb
    span = 2 / 30
    third = 0.5 * values[2] + 0.125 * span * 300 + 0.5 * values[3] - 0.125 * span * -60
    fourth = 0.5 * values[3] + 0.125 * span * 90 + 0.5 * values[4] - 0.125 * span * 30
    expected = [0, 0, 10, 5, 0, third, 20, fourth, 5]
    assert made.root_positions[:, 0].numpy() == pytest.approx(expected, abs=1e-4)
    assert made.root_positions[:, 1].tolist() == pytest.approx([0, 1, 2, 3, 5, 5, 6, 7, 8])
    between = (0.125 * span * (150 - 45) + 5, 4 + 0.125 * 3 * span * (45 + 60))
    assert made.root_positions[[1, 5], 2].numpy() == pytest.approx(between, abs=1e-4)


def test_a_joint_may_have_no_size_and_a_file_one_frame_a_second(read):
    """A joint that is scaled to a point has no place for the scale of its child to leave out."""
    models = {"a": ("", {}), "b": ("a", {"Lcl_Scaling": [0.0] * 3}),
              "c": ("b", {"InheritType": [2], "Lcl_Scaling": [2.0] * 3})}
    turns = {("a", "Lcl Rotation", "X"): keys(np.arange(3.0), np.arange(3.0))}
    rate = {"TimeMode": [14], "CustomFrameRate": [1.0]}
    scene = fbx_reader.Scene(fbx_scene(models, turns, settings=rate))
    assert [node.scale[0].tolist() for node in scene.nodes({})] == [[1.0] * 3, [0.0] * 3, [2.0] * 3]
    assert scene.recording(None).fps == 1
    nothing = dict.fromkeys(("UpAxis", "UpAxisSign", "UnitScaleFactor", "TimeMode"))
    scene = fbx_reader.Scene(fbx_scene(models, turns, settings=nothing))
    assert (scene.up, scene.unit, scene.recording(None).fps) == ("y", 0.01, 30.0)
    slow = {"poses": np.zeros((4, 72)), "trans": np.zeros((4, 3)), "fps": 0.5}
    assert read("a.npz", packed(**slow)).fps == 0.5


@pytest.mark.parametrize(("at", "doubts"), [((0.2, 1.0), 0), ((0.0, 1.0), 1), ((0.2, 1.3), 1)])
def test_a_curve_that_goes_on_by_a_rule_is_doubted_beyond_its_keys(at, doubts):
    places = np.array([0.2, 1.0])
    curve = fbx_curves.Curve(places, places, np.array([4, 4]), np.zeros((2, 4)), repeated=True)
    values, said = curve(np.array(at))
    assert values.tolist() == pytest.approx(np.clip(at, 0.2, 1.0).tolist())
    assert len(said) == doubts


@pytest.mark.parametrize(("flag", "second"), [(0, fbx_reader.NEW_SECOND),
                                              (127, fbx_reader.SECOND)])
def test_a_flag_says_how_long_the_second_of_an_fbx_file_is(read, flag, second):
    times = np.arange(5) / 30 * second / fbx_reader.SECOND
    curve = {("b", "Lcl Rotation", "X"): keys(times, np.arange(5.0))}
    scene = fbx_scene(TWO, curve, other={"TCDefinition": flag})
    made = read("a.fbx", scene)
    assert (len(made.rotations), made.fps) == (5, 30)


def test_fbx_files_that_cannot_be_read(read, refused):
    whole = fbx_scene(TWO, {})
    assert "no joint is animated" in read("a.fbx", whole).doubts[0]
    odd = fbx_scene(TWO, {}, settings={"UpAxis": [2.0]})
    assert read("a.fbx", odd).up == "z"  # a number with a fraction
    for data, problem in (
            (b"; FBX 7.3.0\nFBXHeaderExtension:  {", "a text FBX; save it as binary FBX 2011"),
            (b"BVH", "it is no FBX file"), (fbx([]), "no joints"),
            (whole.replace(b"LimbNode", b"MeshNode"), "no joints in it: no skin, no animated node"),
            (fbx([], 6100), "only binary FBX version 7 can be read; save"),
            (whole[:200], "damaged at byte"), (whole[:24], "only binary FBX version 7")):
        refused("a.fbx", data, problem)
    bomb = fbx_scene(TWO, {("a", "Lcl Rotation", "X"): (
        np.zeros(6_000_000), np.zeros(6_000_000), [4], np.zeros((1, 4)))})
    with memory(2e8):
        refused("a.fbx", bomb, "unpack to more than a file of this size")


# NumPy


@pytest.fixture(scope="module")
def smpl():
    return smpl_walk()


@pytest.mark.parametrize("width", [66, 72, 165])  # 156: test_export.py
def test_our_motion_through_smpl_poses_and_back(read, smpl, width):
    poses = np.zeros((len(smpl), width))
    poses[:, :66] = axis_angles(smpl.rotations).flatten(1)
    joints = smpl.global_positions if width < 72 else np.zeros(3)
    arrays = {"poses": poses, "trans": smpl.root_positions, "mocap_framerate": 60.0,
              "betas": np.zeros(16), "joints": joints}
    made = read("a.npz", packed(**arrays))
    assert made.fps == 60
    assert made.roles["left_hand"] == "left_wrist"
    if width == 66:
        assert not made.doubts
        assert (world(made) - smpl.global_positions).abs().max() < 1e-4
    else:
        (doubt,) = made.doubts
        assert "bone lengths are those of an average person" in doubt
        assert (made.rotations[:, :22] - smpl.rotations).abs().max() < 1e-5
        origin = npz.ORIGIN_X if width == 165 else npz.ORIGIN  # SMPL-X's is lower
        places = made.root_positions - torch.tensor(origin)
        assert (places - smpl.root_positions).abs().max() < 1e-6
        assert made.names[:22] == npz.BODY
        assert len(made.names) == (24 if width == 72 else 22)


def test_smpl_poses_in_two_arrays_are_those_in_one(read, refused, smpl):
    poses = axis_angles(smpl.rotations).flatten(1)
    for root, body in (("root_orient", "pose_body"), ("global_orient", "body_pose")):
        arrays = {root: poses[:, :3], body: poses[:, 3:], "trans": smpl.root_positions}
        made = read("a.npz", packed(**arrays, mocap_framerate=60.0))
        assert (made.rotations - smpl.rotations).abs().max() < 1e-5
        assert torch.equal(made.offsets, npz.rest_pose(22))
        places = made.root_positions - torch.tensor(npz.ORIGIN_X)  # SMPL-X's, of 22 joints alone
        assert (places - smpl.root_positions).abs().max() < 1e-6
        placeless = packed(**{root: poses[:, :3], body: 50 * poses[:, 3:]})
        twice, still, *_ = read("a.npz", placeless).doubts
        assert "if the file has degrees, convert them" in twice
        assert "no positions of the root; it was kept in its place" in still
        arrays[body] = arrays[body][1:]
        refused("a.npz", packed(**arrays), "differ in their frames")


def test_our_motion_through_joint_positions_and_back(read, smpl, tmp_path):
    made = read("a.npz", packed(joints=smpl.global_positions, fps=60))
    assert made.fps == 60
    assert not made.doubts
    assert (world(made) - smpl.global_positions).abs().max() < 1e-4
    # SMPL-H with fingers, which are left out
    more = torch.cat((smpl.global_positions, torch.randn(len(smpl), 30, 3)), 1)
    assert read("a.npz", packed(joints=more, fps=60)).names == npz.BODY
    # in centimetres, ten metres from the origin
    more = 100 * smpl.global_positions + torch.randn(len(smpl), 22, 3) + 1000
    (doubt,) = read("a.npz", packed(positions=more, fps=30)).doubts
    assert "its bones change their lengths" in doubt
    np.save(tmp_path / "b.npy", smpl.global_positions.numpy())
    assert "20 Hz was assumed" in npz.read(tmp_path / "b.npy").doubts[0]


def test_humanml3d_numbers_by_a_slow_loop():
    rows = np.random.default_rng(0).normal(size=(5, 263))
    turn, place = 1 + 0j, 0j  # of the body on the floor, as complex numbers z + ix
    for row, joints in zip(rows, humanml3d.to_joints(torch.from_numpy(rows)), strict=True):
        x, y, z = row[4:67].reshape(21, 3).T
        floor = place + turn * (z + 1j * x)
        expected = [[place.imag, row[3], place.real], *np.stack((floor.imag, y, floor.real), 1)]
        assert joints.numpy() == pytest.approx(np.array(expected), abs=1e-9)
        turn *= np.exp(-2j * row[0])
        place += turn * (row[2] + 1j * row[1])


def test_numpy_files_that_cannot_be_read(refused):
    good = {"poses": np.zeros((4, 72)), "trans": np.zeros((4, 3))}
    for arrays, problem in (
        (good | {"poses": np.zeros((4, 70))}, "poses should be"),
        (good | {"poses": np.full((4, 72), np.nan)}, "poses has numbers that are not finite"),
        ({"x": np.zeros(3)}, "no motion in it"),
        (good | {"fps": -1.0}, "fps should be frames per second"),
        (good | {"trans": np.zeros((3, 3))}, "root's positions should be"),
        (good | {"joints": np.random.default_rng(0).normal(size=(4, 24, 3))}, "disagree by up to"),
        ({"joints": np.zeros((0, 22, 3))}, "no frame in it"),
        ({"posed_joints": np.zeros((4, 77, 3))}, "kimodo_convert makes BVH"),
        ({"positions": np.zeros((4, 22, 3)), "parent_indices": np.arange(22) - 1},
         "names of their own, as AI4AnimationPy writes them"),
        (good | {"poses": np.array([{"a": 1}])}, "Python objects, which could run code"),
    ):
        refused("a.npz", packed(**arrays), problem)
    for data in (b"", b"PK\3\4" + b"\0" * 40, b"\x93NUMPY\1\0\x10\0{'shape': (1,)",
                 packed(**good)[:300]):
        refused("a.npz", data, "not a whole NumPy file")
    refused("none.npz", None, "cannot be read")


def test_numpy_files_that_unpack_to_much_more(refused):
    # 115 MB of zeros in 0.1 MB
    bomb = packed(poses=np.zeros((200_000, 72)))
    with memory(1e7):
        refused("a.npz", bomb, "poses unpack to 115200128 bytes")
    head = (b"\x93NUMPY\1\0v\0{'descr': '<f8', 'fortran_order': False, "
            b"'shape': (1000000000000, 263), }")
    refused("a.npy", head.ljust(127) + b"\n" + b"\0" * 64,
            "not a whole NumPy file .*Unable to allocate")


def test_a_long_file_may_have_many_frames():
    """Of 50 joints at 30 Hz: an eighth of the bytes, above a million, are frames of joints."""
    assert key_times.frame_rate([np.array([0.0, 0.05])], 30.0) == 20.0
    assert key_times.frame_rate([np.array([0.0])], 30.0) == 30.0
    beside = [np.array([0.0, 1 / 30 + 0.0022, 2 / 30, 5 / 30])]  # by 0.066 frames at 30 Hz
    assert key_times.frame_rate(beside, 24.0) == 24.0
    times = [np.array([0.0, 1000.0])]
    at, rate = key_times.sampled(times, 30.0, 50, 8 * 1_600_000)
    assert (len(at), rate) == (30_001, 30.0)
    with refusal("30000 frames of 50 joints are more than 11200000 bytes can hold"):
        key_times.sampled(times, 30.0, 50, 8 * 1_400_000)


def test_properties_of_a_record_follow_each_other():
    given = [np.arange(5.0), 3, "a", np.arange(7), b"bc", 1.5, np.arange(2.0), True]
    for packed_ in (True, False):
        read = fbx_records.Records(fbx([("X", given, [])], pack_arrays=packed_))
        (record,) = read.records(27, len(read.data))
        found = read.values(record)
        assert [np.asarray(x).tolist() for x in found] == [
            x.encode() if isinstance(x, str) else np.asarray(x).tolist() for x in given]


def test_constants_of_the_formats_are_what_they_were():
    unchanged.check("rest pose", npz.rest_pose(24))
    for of in (fbx_reader, fbx_records, fbx_curves, gltf, gltf_file, humanml3d, interpretation,
               key_times, nodes, npz, recorded_body, bvh, bvh_text):
        unchanged.constants(of)


def scene_of(random):
    """Nodes of a scene: several joints, helpers or props, some of which move or are scaled."""
    count, frames, made = random.randint(2, 26), 4, []
    joint, skin = random.random(), random.choice((0.0, 0.0, 0.5, 1.0))
    still = random.random()
    for j in range(count):
        name = random.choice(("bone", f"bone{j}", f"bone{j}", "ik_foot", "tipEnd", "IKhand", " "))
        spread = 0.0 if random.random() < still else random.choice((1e-4, 3e-3, 0.03, 0.3, 3.0))
        place = np.array([[random.choice((0.0, 1.0, -2.0)) for _ in "xyz"]])
        if spread:
            place = place + spread * np.linspace(0, 1, frames)[:, None] * [0.3, 1.0, 0.1]
        angles = np.linspace(0, random.choice((0.0, 0.0, 1.0)), frames)[:, None] * [0.2, 1.0, 0.4]
        turns = Rotation.from_rotvec(angles if angles.any() else angles[:1]).as_quat()
        size = np.full((1, 3), random.choice((1.0, 1.0, 1.0, 1.0, 0.01, 2.0)))
        if random.random() < 0.05:
            size = size * random.choice(([1, 1.5, 1], [-1, 1, 1], [[1, 1, 1]] * 3 + [[2, 2, 2]]))
        parent = random.choice((j - 1, j - 1, random.randint(-1, j - 1), 0)) if j else -1
        made.append(nodes.Node(
            name, min(parent, j - 1), place, torch.from_numpy(turns[:, [3, 0, 1, 2]].copy()), size,
            random.random() < joint, random.random() < skin, random.random() < 0.7))
    return made


def test_scenes_are_read_as_they_were():
    random, found = Random(0), []
    for _ in range(300):
        scene, doubts = scene_of(random), []
        try:
            found.append(nodes.record(scene, 4, 30.0, format_="glTF", unit=None, up="y",
                                      doubts=doubts))
        except ValueError as error:
            found += [str(error), *doubts]
    unchanged.check("scenes", found)


def test_models_have_the_properties_of_their_template_unless_they_say_others(read):
    usual = {"PreRotation": [30.0, 0.0, 50.0], "RotationOrder": [4]}
    models = {"a": ("", {"Lcl_Rotation": [10.0, 20.0, 30.0], "RotationOrder": [2]}),
              "b": ("a", {"Lcl_Translation": [0.0, 1.0, 0.0], "Lcl_Rotation": [5.0, 60.0, 7.0]}),
              "c": ("b", {"Lcl_Translation": [0.0, 1.0, 2.0], "PreRotation": [0.0, 0.0, 9.0]})}
    said = {name: (parent, usual | values) for name, (parent, values) in models.items()}
    templates = [("Model", usual), ("Material", {"PreRotation": [0.0, 80.0, 0.0]})]
    files = (fbx_scene(models, {}, templates=templates), fbx_scene(said, {}))
    one, same = (world(read("a.fbx", data)) for data in files)
    torch.testing.assert_close(one, same)


def test_fbx_scenes_are_read_as_they_were(read, tmp_path):
    random, found = Random(0), []
    angles = ("PreRotation", "PostRotation", "Lcl_Rotation")
    pivots = ("RotationPivot", "ScalingPivot", "RotationOffset", "ScalingOffset", "Lcl_Translation",
              "GeometricTranslation")
    for _ in range(60):
        models, curves, names = {}, {}, [f"b{i}" for i in range(random.randint(2, 5))]
        for i, name in enumerate(names):
            values = {key: [random.choice((0.0, 20.0, -75.0, 190.0)) for _ in "xyz"]
                      for key in angles if random.random() < 0.4}
            values |= {key: [random.choice((0.0, 1.0, -3.0)) for _ in "xyz"]
                       for key in pivots if random.random() < 0.3}
            values |= {key: [random.choice(options)] for key, options in (
                ("InheritType", (0, 1, 2)), ("RotationOrder", range(7)), ("RotationActive", (0, 1)))
                if random.random() < 0.4}
            if random.random() < 0.4:
                values["Lcl_Scaling"] = [random.choice((1.0, 0.5, 100.0))] * 3
            models[name] = (names[random.randrange(i)] if i else "", values)
            for axis in "XYZ":
                what = random.choice(("Lcl Rotation", "Lcl Rotation", "Lcl Translation"))
                count = random.choice((0, 1, 2, 3, 6))
                times = np.cumsum([random.choice((1, 1, 2, 5)) for _ in range(count)]) / 30
                if not count or (what == "Lcl Translation" and i):
                    continue
                flags = [random.choice((2, 2 | 0x100, 4, 8, 8 | 0x400, 8 | 0x800, 8 | 0x100,
                                        8 | 0x1000, 8 | 0x2000)) for _ in range(count)]
                slopes = np.array([[random.uniform(-60, 60), random.uniform(-60, 60),
                                    0.3, 0.3] for _ in range(count)])
                places = [random.choice((-20.0, 0.0, 0.0, 0.0, 30.0)) for _ in range(count)]
                if random.random() < 0.3:  # still
                    places, slopes = [5.0] * count, 0 * slopes
                curves[name, what, axis] = times, places, flags, slopes
        settings = {"TimeMode": [random.choice((0, 3, 5, 6, 7, 9, 10, 11, 13, 14))],
                    "CustomFrameRate": [random.choice((0.5, 12.0, 29.97, 2000.0))],
                    "UpAxis": [random.choice((0, 1, 2, 3))], "UpAxisSign": [random.choice((1, -1))],
                    "UnitScaleFactor": [random.choice((1.0, 100.0, 2.54, 0.0))]}
        try:
            made = read("a.fbx", fbx_scene(models, curves, settings=settings))
            found += [made, world(made)]
        except ValueError as error:
            found.append(str(error).replace(str(tmp_path / "a.fbx"), ""))
    unchanged.check("FBX scenes", found)


@pytest.mark.parametrize("target", ["bvh", "gltf", "fbx"])
def test_damaged_files_are_read_or_refused_as_they_were(tmp_path, monkeypatch, target):
    found, make = [], Recording.__init__

    def kept(self, *args, **options):
        make(self, *args, **options)
        found.append(self)

    readers = targets.make(tmp_path, target)[target]
    monkeypatch.setattr(Recording, "__init__", kept)
    for reader in readers:  # other seeds than the first may have other bytes on another machine
        same = dataclasses.replace(reader, seeds=reader.seeds[:1])
        found += [fuzz.trial(same, same.input(2, n))[0] for n in range(200)]
    unchanged.check(f"damaged {target}", found)
