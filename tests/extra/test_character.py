"""A character of one's own: read, drawn and written with a motion on it."""

import contextlib
import dataclasses
import io
import math

import motion_files
import numpy as np
import pytest
import torch
from PIL import Image
from refusal import refusal
from test_export import seen_by_vtk

import toolkit as tk
from toolkit.extra.characters import gltf_mesh
from toolkit.extra.characters.character import Character
from toolkit.extra.characters.retargeting import retarget
from toolkit.extra.engines import character_gltf
from toolkit.motion.clearance import limbs, trunk
from toolkit.view.render import stage


@pytest.fixture(scope="module")
def fbx(hero, tmp_path_factory):
    """The same character as FBX, half painted red above and blue below."""
    picture, path = io.BytesIO(), tmp_path_factory.mktemp("fbx") / "hero.fbx"
    Image.fromarray(np.uint8([[[255, 0, 0]], [[0, 0, 255]]])).save(picture, "PNG")
    path.write_bytes(motion_files.fbx_figure(Character.load(hero), picture.getvalue()))
    return path


def test_the_mesh_of_a_file_is_read_whole(hero):
    found = Character.load(hero)
    assert len(found.skeleton) == 35
    assert found.mesh.weights.sum(1) == pytest.approx(1.0)
    assert 1.2 < np.ptp(found.points[:, 1]) < 1.8
    # those of the vertices: blue on the left, orange on the right
    seen = found.mesh.colors.astype(int)
    assert (seen[:, 2] - seen[:, 0] > 40).mean() > 0.1
    assert (seen[:, 0] - seen[:, 2] > 60).mean() > 0.1
    points, normals = found.skin.pose(found.rest.global_rotations[0],
                                      found.rest.global_positions[0])
    np.testing.assert_allclose(points, found.points, atol=1e-5)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1.0, abs=1e-4)


def test_scale_and_axes_of_other_programs_change_nothing(hero, fbx, zombie):
    plain, other = Character.load(hero), Character.load(fbx)
    near, far = ({tuple(row) for row in found.points.round(3)} for found in (plain, other))
    assert len(near ^ far) < 0.1 * len(near)  # where a thousandth is rounded in another way
    sizes = [np.ptp(found.points, axis=0) for found in (other, plain)]
    np.testing.assert_allclose(*sizes, atol=1e-4)
    clips = plain.fitted(zombie), other.fitted(zombie)
    np.testing.assert_allclose(clips[0].global_positions, clips[1].global_positions, atol=1e-3)


def test_an_fbx_figure_has_its_colours_and_pictures(fbx):
    found = Character.load(fbx)
    assert found.mesh.weights.sum(1) == pytest.approx(1.0)
    colors, counts = np.unique(found.mesh.colors, axis=0, return_counts=True)
    assert colors.tolist() == [[0, 0, 255], [0, 255, 0], [255, 0, 0]]
    assert counts.min() > 500
    assert not (found.mesh.colors[found.points[:, 1] > 1.0] == (0, 0, 255)).all(1).any()
    assert not (found.mesh.colors[found.points[:, 1] < 0.5] == (255, 0, 0)).all(1).any()


@pytest.mark.parametrize(("name", "change", "problem"), [
    ("PolygonVertexIndex", lambda x: x * 2, "a corner that does not exist"),
    ("Indexes", lambda x: x + 99_999, "do not fit its vertices"),
    ("Weights", lambda x: x[:-1], "do not fit its vertices"),
    ("Vertices", lambda x: x * np.nan, "not finite"),
    ("Transform", lambda x: x * np.nan, "not finite")])
def test_damaged_fbx_figures_are_refused_in_a_line(fbx, hero, tmp_path, monkeypatch, name, change,
                                                   problem):
    whole = motion_files.fbx

    def damaged(records):
        def walk(record):
            called, values, children = record
            if called == name and len(values[0]):
                values = [change(values[0])]
            return called, values, [walk(child) for child in children]
        return whole([walk(record) for record in records])

    monkeypatch.setattr(motion_files, "fbx", damaged)
    (tmp_path / "bad.fbx").write_bytes(motion_files.fbx_figure(Character.load(hero), b""))
    with refusal(rf"bad\.fbx: .*{problem}"):
        Character.load(tmp_path / "bad.fbx")


@pytest.mark.parametrize("kind", ["hero", "fbx"])
def test_other_programs_see_the_motion_on_it(request, tmp_path, kind, zombie):
    """VTK skins the file as the character is drawn here; our reader reads the joints."""
    character = Character.load(request.getfixturevalue(kind))
    character_gltf.save(zombie, tmp_path / "walk.glb", character)
    made = character.fitted(zombie)
    read = tk.load(tmp_path / "walk.glb")
    for name in set(read.skeleton.names) & set(made.skeleton.names):
        joints = (read.global_positions[:, read.skeleton.index(name)],
                  made.global_positions[:, made.skeleton.index(name)])
        assert (joints[0] - joints[1]).abs().max() < 1e-4, name
    points = character.skin.pose(made.global_rotations[100], made.global_positions[100])[0]
    seen = seen_by_vtk(tmp_path / "walk.glb", 100 / 60)
    assert seen.shape == points.shape
    assert abs(seen - points).max() < 1e-3
    poses = zip(made.global_rotations[::10], made.global_positions[::10], strict=True)
    soles = [character.skin.pose(*pose)[0][:, 1].min() for pose in poses]
    assert -0.03 < min(soles) < 0.03  # on the floor
    about, _ = motion_files.glb_parts(tmp_path / "walk.glb")
    assert len(about["animations"]) == 1
    if kind != "fbx":
        assert about["materials"] == motion_files.glb_parts(character.path)[0]["materials"]


def test_arms_stay_outside_of_a_stout_body(hero, walk_clip):
    thin, clip = Character.load(hero), walk_clip.cut(0, 120)
    wide = thin.mesh.points * np.float32([1.5, 1.0, 1.5])
    stout = dataclasses.replace(thin, mesh=dataclasses.replace(thin.mesh, points=wide))
    assert min(stout.gaps) > 1.3 * min(thin.gaps)
    least = []
    for made in (retarget(clip, stout.rest), stout.fitted(clip)):
        points = limbs(made)
        body = trunk(made), torch.cat((points["left_knee"], points["right_knee"]), 1)
        arms = torch.cat((points["left_hand"], points["right_hand"]), 1)
        least.append([float(torch.cdist(arms, axis).min()) for axis in body])
    assert all(gap > stout.gaps[k] - 0.005 for k, gap in enumerate(least[1]))
    assert least[0][1] < stout.gaps[1] - 0.02


def test_a_stage_draws_it_in_place_of_the_mannequin(hero, zombie):
    character = Character.load(hero)
    made = character.fitted(zombie)
    tones = np.tile(np.uint8([[0, 200, 0]]), (len(character.points), 1))
    green = dataclasses.replace(character.mesh, colors=tones)
    body = stage.Body(made, figure=dataclasses.replace(character, mesh=green))
    shown = stage.Stage([body], (200, 200), np.array([0.0, 1.0, 0.5]))
    middle = made.root_positions[40].double().numpy()
    camera = stage.Camera(middle, 0.5, 0.2, 2.4)
    picture = shown.draw([stage.Pose(body, 40)], camera).astype(int)
    seen = (picture[..., 1] > 2 * picture[..., 0]) & (picture[..., 1] > 2 * picture[..., 2])
    assert 0.01 < seen.mean() < 0.3
    shown.close()


def test_a_texture_colours_the_vertices(tmp_path):
    """Multiplied by the material's colour; the first row of pixels is at v = 0."""
    doc = motion_files.Document([{"name": "hips", "mesh": 0, "skin": 0}], skins=[{"joints": [0]}])
    primitive = {"attributes": doc.skinned(np.zeros((4, 3)))}
    doc.json["meshes"] = [{"primitives": [primitive]}]
    picture = io.BytesIO()
    Image.fromarray(np.uint8([[[255, 0, 0], [0, 0, 255]],
                              [[200, 100, 50], [0, 255, 0]]])).save(picture, "PNG")
    # the last repeats the picture
    places = np.float32([[0.1, 0.1], [0.9, 0.1], [0.1, 0.9], [1.1, 1.9]])
    motion_files.textured(doc, primitive, places, picture.getvalue())
    (tmp_path / "painted.glb").write_bytes(doc.glb())
    factor = np.array([1, 0.5, 0]) ** (1 / 2.2)
    expected = np.array([[255, 0, 0], [0, 0, 255], [200, 100, 50], [200, 100, 50]]) * factor
    np.testing.assert_allclose(gltf_mesh.read(tmp_path / "painted.glb").colors, expected, atol=1)


def test_each_skin_has_a_space_of_its_own(tmp_path):
    """Two equal meshes, the second with another space and one more joint, lie at one place."""
    nodes = [{"name": "hips", "children": [1], "translation": [0, 1, 0]},
             {"name": "head", "translation": [0, 0.5, 0]}, {"mesh": 0, "skin": 0},
             {"mesh": 1, "skin": 1}]
    doc, points = motion_files.Document(nodes), np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0]])
    doc.json |= {"meshes": [], "skins": []}
    for joints, shift in (([0], 0), ([1, 0], 3)):
        inverse = np.float32([np.eye(4)] * len(joints))
        inverse[:, 3, 1] = [-1 - 0.5 * j - shift for j in joints]  # columns first
        doc.json["skins"].append({"joints": joints, "inverseBindMatrices": doc.add(
            inverse.reshape(-1, 16))})
        attributes = doc.skinned(points + np.float32([0, shift, 0]))
        doc.json["meshes"].append({"primitives": [{"attributes": attributes}]})
    (tmp_path / "two.glb").write_bytes(doc.glb())
    made = gltf_mesh.read(tmp_path / "two.glb")
    np.testing.assert_allclose(made.points[:3], made.points[3:], atol=1e-6)
    np.testing.assert_allclose(made.bind[:, 1, 3], [1, 1.5], atol=1e-6)


def test_the_controller_gets_it(hero, fast):
    widget = tk.view.Controller(*fast, character=hero)
    mesh = widget.skeleton["mesh"]
    assert len(mesh["follow"]["rules"]) > 20
    assert mesh["follow"]["scale"] == pytest.approx(0.85, abs=0.01)
    assert len(widget.skeleton["parents"]) == len(fast[0].layout.skeleton)
    widget.close()


def test_the_command_line_walks_it(hero, tmp_path, command):
    out = tmp_path / "old.glb"
    command(f"rollout --style Old --seconds 0.5 --character {hero} --out {out}")
    walk = tk.load(out, animation="Old FW")
    assert len(walk) == 30
    assert {*Character.load(hero).skeleton.names} <= {*walk.skeleton.names}


def changed(hero, path, change):
    """The character with another JSON text."""
    document, data = motion_files.glb_parts(hero)
    change(document)
    path.write_bytes(motion_files.glb(document, data))
    return path


def test_a_text_that_json_cannot_hold_is_replaced_and_a_number_said_with_the_file(
        hero, tmp_path, zombie):
    for planted in ("\ud800 half", math.nan):
        odd = changed(hero, tmp_path / "odd.glb", lambda d, x=planted: d.update(extras={"a": x}))
        saves = contextlib.nullcontext() if isinstance(planted, str) else refusal(
            r"odd\.glb: its JSON text has NaN or Infinity")
        with saves:
            character_gltf.save(zombie, tmp_path / "walk.glb", Character.load(odd))
    about, _ = motion_files.glb_parts(tmp_path / "walk.glb")
    assert about["extras"] == {"a": "? half"}


@pytest.mark.parametrize(("change", "problem"), [
    (lambda d: d["nodes"][-1].pop("mesh"), "no skinned mesh"),
    (lambda d: d.update(extensionsRequired=["KHR_draco_mesh_compression"]),
     "mesh Mannequin is compressed by KHR_draco_mesh_compression; `npx"),
    (lambda d: d["accessors"][d["skins"][0]["inverseBindMatrices"]].update(count=3),
     "fewer inverse bind"),
    (lambda d: d["skins"][0].update(joints=[99]), "does not exist"),
    (lambda d: [node.update(name="") for node in d["nodes"]], "cannot find its left_shoulder"),
])
def test_files_without_a_character_are_refused_in_a_line(hero, tmp_path, change, problem):
    with refusal(rf"bad\.glb: .*{problem}"):
        Character.load(changed(hero, tmp_path / "bad.glb", change))
