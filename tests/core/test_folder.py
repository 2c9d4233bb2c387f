"""Training on a folder of one's own."""

import dataclasses
import shutil

import pytest
import rigs
import torch
from posed_rigs import rig, with_twists
from refusal import refusal

import toolkit as tk
from toolkit.cli.motion_files import dataset
from toolkit.datasets import folder
from toolkit.datasets.procedural import SKELETON
from toolkit.extra.characters import retargeting
from toolkit.extra.characters.retargeting import body_joints, pruned

GAITS = {"walk": "FW", "run": "FR"}


@pytest.fixture(scope="module")
def walk() -> tk.Clip:
    return tk.datasets.procedural.generate("Neutral", seconds=5.0)


@pytest.fixture(scope="module")
def motions(tmp_path_factory) -> "dict[tuple[str, str], object]":
    """BVH files of two styles and two gaits."""
    place, found = tmp_path_factory.mktemp("motions"), {}
    for style in ("Neutral", "Zombie"):
        for word, gait in GAITS.items():
            clip = tk.datasets.procedural.generate(style, gait, 5.0)
            found[style, word] = place / f"{style}_{word}_01.bvh"
            tk.bvh.save(clip, found[style, word])
    return found


@pytest.fixture
def copied(tmp_path, motions):
    """A folder with the files, named after style and gait."""
    for (style, gait), source in motions.items():
        shutil.copy(source, tmp_path / f"{style}_{gait}.bvh")
    return tmp_path


@pytest.mark.parametrize(("name", "joints"), [("Reallusion", 22), ("MakeHuman", 34)])
def test_body_joints_of_known_rigs(name, joints):
    rich = rigs.walk(name)
    rich = rich.replace(skeleton=dataclasses.replace(rich.skeleton, roles=None))
    small = pruned(rich)
    assert len(small.skeleton) == joints
    for role, joint in small.skeleton.roles.items():
        before = rich.global_positions[:, rich.skeleton.index(joint)]
        after = small.global_positions[:, small.skeleton.role(role)]
        assert (before - after).abs().max() < 1e-3, role
    assert pruned(small) is small


def test_a_twist_bone_that_moves_the_limb_is_kept():
    rich = rigs.walk("MotionBuilder", seconds=2.0)
    rich = rich.replace(skeleton=dataclasses.replace(rich.skeleton, roles=None))
    turned, twist = rich.rotations.clone(), rich.skeleton.index("LeftForeArmRoll")
    swing = torch.linspace(0, 1, len(rich))
    up = torch.tensor([0.0, 1.0, 0.0]).expand(len(rich), 3)
    turned[:, twist] = tk.motion.rotations.from_axis_angle(up, swing)
    names = pruned(rich.replace(rotations=turned)).skeleton.names
    assert "LeftForeArmRoll" in names
    assert "RightForeArmRoll" not in names


def test_rigs_without_the_roles_are_refused(walk):
    bare = dataclasses.replace(walk.skeleton, roles={"hips": "Hips"})
    with refusal("cannot find its left_shoulder, "):
        body_joints(bare)


@pytest.mark.parametrize("layout", ["names", "folders", "style folders", "table"])
def test_style_and_gait_come_from_names_folders_or_a_table(tmp_path, motions, layout):
    rows = ["file, style, gait"]
    for number, ((style, gait), source) in enumerate(motions.items()):
        name = {"names": f"actor_{style}_{gait}_0{number}.bvh",
                "folders": f"{style}/{gait}/{number}.bvh",
                "style folders": f"{style}/take {gait} {number}.bvh",
                "table": f"deep/{number}.bvh"}[layout]
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(source, tmp_path / name)
        rows.append(f"{name}, {style}, {gait}")
    if layout == "table":
        (tmp_path / "labels.csv").write_text("\n".join(rows[:-1]))
    found = folder.survey(tmp_path)
    expected = set(motions) if layout != "table" else set(list(motions)[:-1])
    assert {(take.style, take.gait) for take in found.takes} == expected
    assert not found.left_out
    clips = tk.datasets.load("folder", tmp_path, styles=["Zombie"])
    assert {clip.gait for clip in clips} == {gait for style, gait in expected if style == "Zombie"}


def test_what_is_left_out_is_said(copied, walk):
    tk.bvh.save(walk.cut(0, 60), copied / "Short_walk.bvh")
    tk.bvh.save(walk, copied / "Inches_walk.bvh", unit=0.0254)
    small = dataclasses.replace(walk.skeleton, offsets=0.6 * walk.skeleton.offsets)
    child = walk.replace(skeleton=small, root_positions=0.6 * walk.root_positions)
    tk.bvh.save(child, copied / "Child_walk.bvh")
    (copied / "Broken_walk.bvh").write_text("HIERARCHY\nROOT Hips\n{\n OFFSET 0 0 0\n")
    found = folder.survey(copied)
    assert {take.style for take in found.takes} == {"Neutral", "Zombie", "Inches"}
    why = {path.name: reason for path, reason in found.left_out.items()}
    assert set(why) == {"Short_walk.bvh", "Child_walk.bvh", "Broken_walk.bvh"}
    assert "1.0 s; a clip of 1.9 s is needed" in why["Short_walk.bvh"]
    assert "line 4" in why["Broken_walk.bvh"]
    assert "another size" in why["Child_walk.bvh"]
    with pytest.warns(UserWarning, match=r"3 files left out: Broken_walk.bvh: .*; Child_walk.bvh: "
                                         r"a body of .*; Short_walk.bvh: 1.0 s; a clip"):
        assert len(tk.datasets.load("folder", copied)) == 5


def test_files_of_other_rigs_can_be_retargeted(copied, walk):
    other = retargeting.retarget(walk, rig("A-pose", joints=with_twists))
    tk.bvh.save(other, copied / "Other_walk.bvh")
    with pytest.warns(UserWarning, match="1 file left out: Other_walk.bvh: other joints than most"):
        tk.datasets.load("folder", copied)
    pose = tk.motion.rotations.identity(1, len(SKELETON))
    target = tk.Clip(SKELETON, pose, torch.zeros(1, 3), 60.0)
    clips = tk.datasets.load("folder", copied, target=target)
    assert {clip.style for clip in clips} == {"Neutral", "Zombie", "Other"}
    assert {clip.skeleton.names for clip in clips} == {SKELETON.names}


@pytest.mark.parametrize(("table", "said"), [
    ("name,style\na.bvh,Old\n", "expected the columns file, style; missing: file"),
    ("file,style\na.bvh,\n", "line 2: no style"),
])
def test_bad_tables_are_refused_in_a_line(tmp_path, motions, table, said):
    shutil.copy(next(iter(motions.values())), tmp_path / "a.bvh")
    (tmp_path / "labels.csv").write_text(table)
    with refusal("labels") as error:
        folder.survey(tmp_path)
    assert said in str(error.value)


def test_a_folder_of_nothing_is_refused(tmp_path):
    (tmp_path / "a.bvh").write_text("nothing")
    with refusal(r"no file can be used \(a.bvh: .*expected HIERARCHY"):
        folder.survey(tmp_path)


def test_a_folder_is_surveyed_and_read_by_the_verbs(copied, caplog):
    assert dataset(str(copied), None) == ("folder", copied)
    with caplog.at_level("INFO", "toolkit.datasets"):
        tk.datasets.load("folder", copied)
    assert "4 files, 1,200 frames, 0.3 minutes; 28 body joints of 28" in caplog.messages
    with refusal("is the folder to read; --root is for datasets with a na"):
        dataset(str(copied), copied)
