"""Roles, mirror pairs, units and axes on rigs with the names of common exporters."""

import dataclasses
import re
from pathlib import Path

import pytest
import rigs
import torch

import toolkit as tk
from toolkit.io import interpretation
from toolkit.io.recording import Recording
from toolkit.motion import joint_names, roles, root_frames
from toolkit.motion import rotations as R


def facing(clip: tk.Clip) -> float:
    """Mean cosine between where the hips face and where they go."""
    forward = R.rotate(root_frames(clip).rotations, torch.tensor([0.0, 0.0, 1.0]))[1:, ::2]
    travel = clip.global_positions[:, clip.skeleton.role("hips")].diff(dim=0)[:, ::2]
    return float(torch.nn.functional.cosine_similarity(forward, travel, dim=1).mean())


def written(clip: tk.Clip, path, convention: rigs.Convention) -> tk.Clip:
    """The clip as a file in the unit and with the up axis of a convention."""
    turn = R.from_euler(torch.tensor([torch.pi / 2 if convention.up == "z" else 0.0, 0.0, 0.0]), "XYZ")
    rotations = torch.cat((R.multiply(turn, clip.rotations[:, :1]), clip.rotations[:, 1:]), 1)
    turned = clip.replace(rotations=rotations, root_positions=R.rotate(turn, clip.root_positions))
    tk.bvh.save(turned, path, unit=convention.unit)
    return clip


@pytest.mark.parametrize("turned", [False, True], ids=["same axes", "axes along the bones"])
@pytest.mark.parametrize("name", rigs.TABLE)
def test_a_walk_of_each_convention_is_understood(tmp_path, name, turned):
    convention = rigs.TABLE[name]
    made = written(rigs.walk(name, turned), tmp_path / "walk.bvh", convention)
    found = tk.inspect(tmp_path / "walk.bvh")
    assert found.doubts == []
    assert found.roles == rigs.roles(convention)
    assert (found.unit, found.up) == (convention.unit, convention.up)
    assert found.height == pytest.approx(1.77, abs=0.04)
    assert found.upright
    clip = found.clip
    for joint in ("left_hand", "right_toe", "hips"):
        there = made.global_positions[:, made.skeleton.names.index(found.roles[joint])]
        torch.testing.assert_close(clip.global_positions[:, clip.skeleton.role(joint)], there, atol=1e-4, rtol=0)
    mirrored = clip.mirrored()
    assert facing(clip) > 0.95
    assert facing(mirrored) > 0.95
    image = clip.global_positions[:, list(clip.skeleton.mirror_pairs)] * torch.tensor([-1.0, 1.0, 1.0])
    torch.testing.assert_close(mirrored.global_positions, image, atol=2e-3, rtol=0)
    torch.testing.assert_close(mirrored.mirrored().global_positions, clip.global_positions, atol=2e-5, rtol=0)


@pytest.mark.parametrize("name", rigs.TABLE)
def test_every_sided_joint_has_its_counterpart(name):
    convention = rigs.TABLE[name]
    skeleton = rigs.walk(name, seconds=0.5).skeleton
    skeleton = tk.Skeleton(skeleton.names, skeleton.parents, skeleton.offsets, None, skeleton.ends)
    said = [joint_names.read(joint) for joint in skeleton.names]
    for j, other in enumerate(skeleton.mirror_pairs):
        assert skeleton.mirror_pairs[other] == j
        assert (said[j].side == "") == (j == other), skeleton.names[j]
        if said[j].side:
            swapped = {"left": convention.sides[1], "right": convention.sides[0]}[said[j].side]
            assert said[other].plain == said[j].plain
            assert swapped in skeleton.names[other]


@pytest.mark.parametrize(
    ("name", "side", "part"),
    [("mixamorig:LeftUpLeg", "left", "hip"), ("Bip01 R Calf", "right", "knee"), ("lfemur", "left", "hip"),
     ("lowerback", "", None), ("rShldr", "right", "shoulder"), ("hand_l", "left", "hand"), ("L5", "", None),
     ("lefthand", "left", "hand"), ("Character1_LeftForeArm", "left", "elbow"), ("upperarm_twist_01_r", "right", None),
     ("RThumb", "right", "finger"), ("ik_foot_l", "left", None), ("rig|b_l_ball_jnt", "left", "toe"), ("Hips", "", "hips"),
     ("J_Bip_R_LowerArm", "right", "elbow"), ("LHipJoint", "left", "hip"), ("radius", "", "elbow"), ("", "", None),
     ("LeftForeArmRoll", "left", None), ("LeftArmJoint", "left", "shoulder")])
def test_names_state_side_and_part(name, side, part):
    found = joint_names.read(name)
    assert found.side == side
    assert (part in found.parts) if part else not found.parts


def test_the_unit_follows_from_the_height(tmp_path):
    clip, path = rigs.walk("LaFAN1", seconds=1.0), tmp_path / "walk.bvh"
    for unit in interpretation.UNITS.values():
        tk.bvh.save(clip, path, unit=unit)
        found = tk.inspect(path)
        assert (found.unit, found.doubts) == (unit, [])
    tk.bvh.save(clip, path, unit=0.04)  # 44 units tall
    with pytest.warns(UserWarning, match=r"walk\.bvh: in no known unit the body of 43\.\d+ units .* unit= decides"):
        guessed = tk.load(path)
    assert tk.inspect(path).height == pytest.approx(1.7)
    assert tk.load(path, unit=0.04, up="y").global_positions.allclose(clip.global_positions, atol=1e-4)
    assert guessed.global_positions.std() < clip.global_positions.std()
    tk.bvh.save(clip, path, unit=1.757 / 240)  # 2.4 m in cm: too tall for people, not for figures
    with pytest.warns(UserWarning, match=r"with a unit of 0\.01 m \(cm\) the body is 2\.39 m tall; unit= decides"):
        tk.load(path)


@pytest.mark.parametrize("up", interpretation.AXES)
def test_the_up_axis_follows_from_the_body(tmp_path, up):
    clip, path = rigs.walk("LaFAN1", seconds=1.0), tmp_path / "walk.bvh"
    turn = {"y": (0, 0, 0), "-y": (180, 0, 0), "z": (90, 0, 0), "-z": (-90, 0, 0), "x": (0, 0, -90), "-x": (0, 0, 90)}[up]
    turn = R.from_euler(torch.deg2rad(torch.tensor(turn, dtype=torch.float32)), "XYZ")
    rotations = torch.cat((R.multiply(turn, clip.rotations[:, :1]), clip.rotations[:, 1:]), 1)
    tk.bvh.save(clip.replace(rotations=rotations, root_positions=R.rotate(turn, clip.root_positions)), path)
    found = tk.inspect(path)
    assert (found.up, found.doubts) == (up, [])
    torch.testing.assert_close(found.clip.global_positions, clip.global_positions, atol=1e-4, rtol=0)
    torch.testing.assert_close(tk.load(path, up=up).rotations, found.clip.rotations)


def test_what_is_not_safe_is_said(tmp_path):
    clip, path = rigs.walk("LaFAN1", seconds=2.0), tmp_path / "walk.bvh"
    lying = R.identity(*clip.rotations.shape[:2])
    lying[:, 0] = R.from_euler(torch.tensor([-torch.pi / 2, 0.0, 0.0]), "XYZ")
    deep = clip.root_positions - torch.tensor([0.0, 3.0, 0.0])
    long = rigs.walk("LaFAN1", seconds=8.0)
    rising = long.root_positions + torch.linspace(-0.15, 0.15, len(long))[:, None] * torch.tensor([0.0, 1.0, 0.0])
    low = torch.tensor([0.0, 0.15, 0.0]).expand(len(clip), 3)
    for changed, doubt in ((clip.replace(rotations=lying, root_positions=low), "stands along -?z or lies with y up"),
                           (clip.replace(root_positions=deep), r"the feet stand at -2\.98 m instead of 0"),
                           (clip.resample(1.0), "1 frames per second is no usual rate"),
                           (long.replace(root_positions=rising), r"the floor moves by \+0\.30 m over the clip")):
        tk.bvh.save(changed, path)
        with pytest.warns(UserWarning, match=doubt):
            tk.load(path)
        assert any(re.search(doubt, said) for said in tk.inspect(path).doubts)
    tk.bvh.save(clip, path)
    path.write_text(path.read_text().replace("Frame Time: 0.01666667", "Frame Time: 16.6667"))
    with pytest.warns(UserWarning, match="16.6667 s was taken for milliseconds: 60 Hz"):
        assert tk.load(path).fps == 60.0


def test_roles_unit_and_up_that_do_not_fit_are_refused(tmp_path):
    path = tmp_path / "walk.bvh"
    tk.bvh.save(rigs.walk("LaFAN1", seconds=0.5), path)
    for options, problem in (
        ({"roles": {"left_wing": "LeftArm"}}, "'left_wing' is no role; the roles are hips"),
        ({"roles": {"left_hand": "LeftPaw"}}, "no joint 'LeftPaw' for the role left_hand"),
        ({"roles": {"left_knee": "LeftFoot"}}, r"left_foot \(LeftFoot\) is not below left_knee \(LeftFoot\)"),
        ({"unit": 0.0}, "unit is metres of one unit"), ({"unit": "parsec"}, "auto, m, cm"), ({"up": "w"}, "one of auto, x"),
    ):
        with pytest.raises(ValueError, match=problem) as caught:
            tk.load(path, **options)
        assert "\n" not in str(caught.value)
    given = tk.load(path, roles={"left_toe": "LeftFoot"})
    assert given.skeleton.roles["left_toe"] == "LeftFoot"
    assert tk.inspect(path, roles={"left_toe": "LeftFoot"}).rules["left_toe"] == "given"


def test_a_leg_without_length_is_no_leg(tmp_path):
    clip = rigs.walk("LaFAN1", seconds=0.5)
    offsets = clip.skeleton.offsets.clone()
    offsets[[clip.skeleton.names.index(name) for name in ("LeftLeg", "LeftFoot")]] = 2e-7
    path = tmp_path / "walk.bvh"
    tk.bvh.save(clip.replace(skeleton=tk.Skeleton(clip.skeleton.names, clip.skeleton.parents, offsets)), path)
    with pytest.warns(UserWarning, match="are at the same place"):
        clip = tk.load(path)
    assert "left_knee" not in clip.skeleton.roles
    assert "right_knee" in clip.skeleton.roles


def test_files_of_other_kinds_are_refused_in_a_line(tmp_path):
    for name in ("walk.c3d", "walk", "walk.zip"):
        with pytest.raises(ValueError, match=r"no reader for this kind of file; there are readers for \.bvh"):
            tk.load(tmp_path / name)


@pytest.mark.parametrize("turned", [False, True], ids=["same axes", "axes along the bones"])
@pytest.mark.parametrize("name", ["LaFAN1", "CMU", "Unreal", "Daz Genesis 8", "MakeHuman", "Second Life"])
def test_names_that_say_nothing_leave_the_shape_of_the_tree(tmp_path, name, turned):
    clip = rigs.walk(name, turned)
    old = clip.skeleton
    names = [f"{'tip' if joint in old.ends else 'node'}{j}" for j, joint in enumerate(old.names)]
    ends = [names[old.names.index(end)] for end in old.ends]
    clip = clip.replace(skeleton=tk.Skeleton(names, old.parents, old.offsets, {}, ends))
    written(clip, tmp_path / "walk.bvh", rigs.TABLE[name])
    found = tk.inspect(tmp_path / "walk.bvh")
    assert found.doubts == ["the joints' names say too little, so that roles are from the shape of the tree; roles= decides"]
    assert (found.unit, found.up) == (rigs.TABLE[name].unit, rigs.TABLE[name].up)
    called = {role: f"node{old.names.index(joint)}" for role, joint in rigs.roles(rigs.TABLE[name]).items()
              if joint not in old.ends}
    assert called.items() <= found.roles.items()
    assert facing(found.clip) > 0.95
    assert facing(found.clip.mirrored()) > 0.95


def test_sides_that_are_exchanged_are_noticed(tmp_path):
    """As by a program whose axes are left-handed."""
    clip = rigs.walk("LaFAN1", seconds=1.0)
    names = [joint.replace("Left", "?").replace("Right", "Left").replace("?", "Right") for joint in clip.skeleton.names]
    exchanged = tk.Skeleton(names, clip.skeleton.parents, clip.skeleton.offsets)
    tk.bvh.save(clip.replace(skeleton=exchanged), tmp_path / "walk.bvh")
    with pytest.warns(UserWarning, match="joints called left are on the right of the body"):
        tk.load(tmp_path / "walk.bvh")


def test_names_that_say_too_little_leave_the_shape_of_the_tree(tmp_path):
    """German words: arms and hands are called as in English, legs are not."""
    german = {"UpLeg": "Oberschenkel", "ForeArm": "Unterarm", "Leg": "Unterschenkel", "Foot": "Fuss", "Toe": "Zehen"}
    clip = rigs.walk("LaFAN1", seconds=1.0)
    old, names = clip.skeleton, list(clip.skeleton.names)
    for side in ("Left", "Right"):
        names = [f"{side}{german[name.removeprefix(side)]}" if name.removeprefix(side) in german else name for name in names]
    clip = clip.replace(skeleton=tk.Skeleton(names, old.parents, old.offsets, {}, old.ends))
    written(clip, tmp_path / "walk.bvh", rigs.TABLE["LaFAN1"])
    with pytest.warns(UserWarning, match="roles are from the shape of the tree"):
        found = tk.load(tmp_path / "walk.bvh")
    known = rigs.roles(rigs.TABLE["LaFAN1"])
    assert found.skeleton.roles == {role: names[old.names.index(joint)] for role, joint in known.items()}
    assert facing(found) > 0.95


@pytest.mark.parametrize(("degrees", "place"), [(-90, (0, 0.12, -0.9)), (90, (0.9, 0.12, 0.9)), (90, (0, 0.6, 0.9))])
def test_a_body_that_lies_beside_the_origin_is_doubted(tmp_path, degrees, place):
    """Its feet are near zero along the axis of the body, as those of a standing body are."""
    clip = rigs.walk("LaFAN1", seconds=1.0)
    turn = R.from_euler(torch.deg2rad(torch.tensor([float(degrees), 0, 0])), "XYZ")
    rotations = torch.cat((turn.expand(len(clip), 1, 4), R.identity(len(clip), len(clip.skeleton) - 1)), 1)
    lying = clip.replace(rotations=rotations, root_positions=torch.tensor(place).float().expand(len(clip), 3))
    tk.bvh.save(lying, tmp_path / "sleep.bvh")
    with pytest.warns(UserWarning, match="or lies with y up: .* is taken; up= decides"):
        tk.load(tmp_path / "sleep.bvh")
    assert tk.load(tmp_path / "sleep.bvh", unit="cm", up="y").global_positions[..., 1].amax() < 1.2


@pytest.mark.parametrize(("between", "role"), [("Thigh", "hip"), ("Thigh2", "hip"), ("Knee1", "knee")])
def test_a_joint_more_in_the_thigh_takes_no_role_and_is_said(tmp_path, walk_clip, between, role):
    """Its name fits better than the right joint's; both parts of a person's leg are about equally long."""
    old = walk_clip.skeleton
    names, parents, offsets, of = [], [], [], []  # of: the old joint
    for j, name in enumerate(old.names):
        above = names.index(old.names[old.parents[j]]) if j else -1
        if name.endswith("Knee"):
            names.append(name.replace("Knee", between))
            parents.append(above)
            offsets.append(old.offsets[j] / 2)
            of.append(-1)
            above = len(names) - 1
        names.append(name)
        parents.append(above)
        offsets.append(old.offsets[j] / (2 if name.endswith("Knee") else 1))
        of.append(j)
    rotations = torch.cat((walk_clip.rotations, R.identity(len(walk_clip), 1)), 1)[:, of]
    skeleton = tk.Skeleton(names, parents, torch.stack(offsets), old.roles)
    tk.bvh.save(walk_clip.replace(skeleton=skeleton, rotations=rotations), tmp_path / "more.bvh")
    right = "Left" + role.capitalize()
    with pytest.warns(UserWarning, match=f"{right} is taken for the left {role}, because both parts of the limb are then"):
        found = tk.load(tmp_path / "more.bvh").skeleton.roles
    assert (found["left_hip"], found["right_knee"]) == ("LeftHip", "RightKnee")


def test_a_path_that_jumps_or_is_in_another_unit_is_doubted(tmp_path, walk_clip):
    roots = walk_clip.root_positions
    tk.bvh.save(walk_clip.replace(root_positions=roots * torch.tensor([100.0, 1.0, 100.0])), tmp_path / "far.bvh")
    with pytest.warns(UserWarning, match=r"the body goes 1\d\d m/s: its path may be in another unit than its bones"):
        tk.load(tmp_path / "far.bvh")
    jump = roots.clone()
    jump[0] += torch.tensor([5.0, 0.0, 0.0])  # as of a T-pose before the recording
    tk.bvh.save(walk_clip.replace(root_positions=jump), tmp_path / "jump.bvh")
    with pytest.warns(UserWarning, match="the body jumps by [45].* m from frame 0 to 1"):
        tk.load(tmp_path / "jump.bvh")


def test_legs_without_a_head_are_read_and_doubted(tmp_path, walk_clip):
    whole = walk_clip.skeleton
    parts = ("hip", "knee", "foot", "toe")
    legs = sorted({0, *(whole.role(f"{side}_{part}") for side in ("left", "right") for part in parts)})
    skeleton = tk.Skeleton([whole.names[j] for j in legs], [legs.index(whole.parents[j]) if j else -1 for j in legs],
                           whole.offsets[legs])
    tk.bvh.save(tk.Clip(skeleton, walk_clip.rotations[:, legs], walk_clip.root_positions, 60), tmp_path / "legs.bvh")
    with pytest.warns(UserWarning, match="unit"):
        read = tk.load(tmp_path / "legs.bvh")
    assert read.skeleton.roles["left_toe"] == whole.roles["left_toe"]


def limbs(*chains: tuple[str, ...]) -> tuple[list[str], list[int]]:
    """Names and parents of hips with chains of joints on both sides; a name that stands twice is one joint."""
    names, parents = ["Hips"], [-1]
    for side in ("Left", "Right"):
        for chain in chains:
            above = 0
            for name in chain:
                if side + name not in names:
                    names.append(side + name)
                    parents.append(above)
                above = names.index(side + name)
    return names, parents


@pytest.mark.parametrize(("chains", "role", "joint"), [
    ([("Alpha", "AlphaTwist", "ForeArm", "Hand")], "left_shoulder", "LeftAlpha"),  # above the elbow, and no helper
    ([("Alpha", "ForeArm", "Hand"), ("Alpha", "Wing")], "left_shoulder", None),  # more than a part of the arm
    ([("Knee", "Thigh", "Foot")], "left_foot", "LeftFoot"),  # two parts that count the same, in an order that no leg has
])
def test_a_joint_without_a_fitting_name_is_found_beside_its_neighbour(chains, role, joint):
    assert roles.find_roles(*limbs(*chains)).get(role) == joint


@pytest.mark.parametrize(("length", "toe"), [(0.01, "LeftFoot"), (0.1, "LeftTip")])
def test_a_bone_below_the_ankle_that_is_short_shows_no_toe(length, toe):
    names, parents = limbs(("Thigh", "Shin", "Foot", "Tip"))
    lengths = [length if name.endswith("Tip") else 0.4 for name in names]
    assert roles.find_roles(names, parents, lengths)["left_toe"] == toe


def test_the_hips_are_called_so_even_if_the_legs_meet_below_them():
    legs = ("LeftThigh", "LeftShin", "LeftFoot", "RightThigh", "RightShin", "RightFoot")
    assert roles.find_roles(["Root", "Hips", "Extra", *legs], [-1, 0, 1, 2, 3, 4, 2, 6, 7])["hips"] == "Hips"


def test_a_head_that_no_name_shows_is_the_farthest_point_between_the_arms():
    names, parents = ["root", "LeftArm", "RightArm", "near", "far", "farther"], [-1, 0, 0, 0, 0, 4]
    shoulders = {"left_shoulder": "LeftArm", "right_shoulder": "RightArm"}
    assert roles.head(names, parents, [1.0] * 6, shoulders) == [0, 4, 5]
    assert roles.head(names[:3], parents[:3], [1.0] * 3, shoulders) == [0]


def test_counterparts_without_roles_follow_from_names_or_else_from_the_tree():
    assert roles.mirror_pairs(["root", "LeftWing", "RightWing"], [-1, 0, 0], {}) == (0, 2, 1)
    assert roles.mirror_pairs(["root", "x", "y"], [-1, 0, 0], {}) == (0, 1, 2)
    names = ["root", "one", "two", "a:Tail", "a:Wing", "b:Wing", "b:Tail", "x", "below x", "y", "below y"]
    parents = [-1, 0, 0, 1, 1, 2, 2, 1, 7, 2, 9]
    pairs = roles.mirror_pairs(names, parents, {"left_hand": "one", "right_hand": "two"})
    assert pairs == (0, 2, 1, 6, 5, 4, 3, 9, 10, 7, 8)


def test_a_joint_and_its_parent_are_no_counterparts():
    for left, right in (("upper", "lower"), ("lower", "upper")):
        hands = {"left_hand": left, "right_hand": right}
        assert roles.mirror_pairs(["root", "upper", "lower"], [-1, 0, 1], hands) == (0, 1, 2)


def recorded(clip: tk.Clip, **changes) -> Recording:
    skeleton = clip.skeleton
    made = Recording("glTF", skeleton.names, skeleton.parents, skeleton.offsets.double(), clip.rotations,
                     clip.root_positions.double(), 60.0, tuple(skeleton.ends), unit=1.0, up="y")
    return dataclasses.replace(made, **changes)


def centimetres(clip: tk.Clip, **changes) -> Recording:
    changes = {"offsets": clip.skeleton.offsets.double(), "root_positions": clip.root_positions.double()} | changes
    return recorded(clip, unit=0.01, **changes | {name: 100 * changes[name] for name in ("offsets", "root_positions")})


def test_a_bone_above_the_head_that_is_short_is_not_the_top_of_the_head():
    """Five centimetres, in metres and centimetres: the crown still comes on top."""
    clip = rigs.walk("LaFAN1", seconds=0.5)
    offsets = clip.skeleton.offsets.double()
    top = clip.skeleton.names.index("HeadEnd")
    heights = []
    for length in (0.0, 0.05):
        offsets[top] *= length / offsets[top].norm().clamp_min(1e-12)
        heights += [interpretation.interpret(made(clip, offsets=offsets), Path("a.glb"))[1].height
                    for made in (recorded, centimetres)]
        offsets[top] = torch.tensor([0.0, 1.0, 0.0])
    assert heights[0] == pytest.approx(heights[1]) == pytest.approx(heights[2] - 0.05) == pytest.approx(heights[3] - 0.05)


def test_roles_that_a_file_states_count_more_than_names():
    """The forearm stated as the elbow; a role that there is not is left out."""
    clip = rigs.walk("LaFAN1", seconds=0.5)
    stated = {"left_hand": "LeftForeArm", "left_elbow": "LeftArm", "left_shoulder": "LeftShoulder", "tail": "Spine"}
    made, found = interpretation.interpret(recorded(clip, roles=stated), Path("a.vrm"))
    assert made.skeleton.roles["left_hand"] == "LeftForeArm"
    assert (found.rules["left_hand"], found.rules["right_hand"]) == ("the file", "name")
    assert "tail" not in made.skeleton.roles


@pytest.mark.parametrize(("degrees", "upright"), [(0.0, True), (40.0, True), (75.0, False)])
def test_a_body_that_bends_far_is_not_upright_in_any_unit(degrees, upright):
    clip = rigs.walk("LaFAN1", seconds=0.5)
    turn = R.from_euler(torch.deg2rad(torch.tensor([degrees, 0.0, 0.0])), "XYZ")
    rotations = torch.cat((R.multiply(turn, clip.rotations[:, :1]), clip.rotations[:, 1:]), 1)
    assert interpretation.interpret(centimetres(clip, rotations=rotations), Path("a.glb"), up="y")[1].upright is upright


def test_a_unit_that_the_file_states_is_taken_where_it_fits_people():
    clip = rigs.walk("LaFAN1", seconds=0.5)
    right, wrong = (interpretation.interpret(recorded(clip, unit=unit), Path("a.glb"))[1] for unit in (1.0, 0.1))
    assert (right.unit, right.doubts) == (1.0, [])
    assert wrong.unit == 1.0
    assert re.fullmatch(r"in the file's unit, 0\.1 m \(dm\), the body is 0\.17\d m tall: 1 m \(m\) is assumed; .*",
                        *wrong.doubts)


def test_the_rest_pose_shows_the_axis_where_the_motion_does_not():
    """A body that turns heels over head in one second; at rest it stands along z."""
    clip = rigs.walk("LaFAN1", seconds=1.0)
    angles = torch.linspace(0, 2 * torch.pi, len(clip))[:, None] * torch.tensor([1.0, 0.0, 0.0])
    rotations = torch.cat((R.from_euler(angles, "XYZ")[:, None], R.identity(len(clip), len(clip.skeleton) - 1)), 1)
    rest = R.rotate(R.from_euler(torch.tensor([torch.pi / 2, 0.0, 0.0]), "XYZ"), clip.skeleton.offsets).double()
    found = interpretation.interpret(recorded(clip, rotations=rotations, offsets=rest, up=None), Path("a.fbx"))[1]
    assert found.up == "z"
    assert "the body is not upright in most frames: z is assumed to point up; up= decides" in found.doubts
