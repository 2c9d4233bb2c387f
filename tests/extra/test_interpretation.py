"""Roles, unit and up axis that are guessed about files, on rigs with common names."""

import dataclasses
import re
import time
from pathlib import Path
from random import Random

import pytest
import rigs
import torch
import unchanged
from refusal import refusal
from torch.testing import assert_close

import toolkit as tk
from experiments.foreign import facing
from toolkit.extra.formats import interpretation
from toolkit.io.recording import Recording
from toolkit.motion import rotations as R


def turned(clip: tk.Clip, *degrees: float) -> tk.Clip:
    """The clip, turned about the world's x, y and z."""
    turn = R.from_euler(torch.deg2rad(torch.tensor(degrees, dtype=torch.float32)), "XYZ")
    rotations = torch.cat((R.multiply(turn, clip.rotations[:, :1]), clip.rotations[:, 1:]), 1)
    return clip.replace(rotations=rotations, root_positions=R.rotate(turn, clip.root_positions))


def written(clip: tk.Clip, path, convention: rigs.Convention) -> tk.Clip:
    """The clip as a file in the unit and with the up axis of a convention."""
    made = turned(clip, 90, 0, 0) if convention.up == "z" else clip
    tk.bvh.save(made, path, unit=convention.unit)
    return clip


# One of each kind: name spaces, helpers, no toes, no End Sites, z up, other units.
@pytest.mark.parametrize(("name", "bent"), [
    ("Mixamo", True), ("CMU", False), ("Second Life", False), ("VRM", False), ("MakeHuman", True)])
def test_a_walk_of_each_convention_is_understood(tmp_path, name, bent):
    convention = rigs.TABLE[name]
    made = written(rigs.walk(name, bent), tmp_path / "walk.bvh", convention)
    found = tk.inspect(tmp_path / "walk.bvh")
    assert found.doubts == []
    assert found.roles == rigs.roles(convention)
    assert (found.unit, found.up) == (convention.unit, convention.up)
    assert found.height == pytest.approx(1.77, abs=0.04)
    assert found.upright
    clip = found.clip
    for joint in ("left_hand", "right_toe", "hips"):
        there = made.global_positions[:, made.skeleton.names.index(found.roles[joint])]
        here = clip.global_positions[:, clip.skeleton.role(joint)]
        assert_close(here, there, atol=1e-4, rtol=0)
    assert facing(clip) > 0.95
    across = torch.tensor([-1.0, 1.0, 1.0])
    image = clip.global_positions[:, list(clip.skeleton.mirror_pairs)] * across
    assert_close(clip.mirrored().global_positions, image, atol=2e-3, rtol=0)


def test_the_unit_follows_from_the_height(tmp_path):
    clip, path = rigs.walk("LaFAN1", seconds=1.0), tmp_path / "walk.bvh"
    for unit in interpretation.UNITS.values():
        tk.bvh.save(clip, path, unit=unit)
        found = tk.inspect(path)
        assert (found.unit, found.doubts) == (unit, [])
    tk.bvh.save(clip, path, unit=0.04)  # 44 units tall
    doubt = r"walk\.bvh: in no known unit the body of 43\.\d+ units .* unit= decides"
    with pytest.warns(UserWarning, match=doubt):
        tk.load(path)
    assert tk.inspect(path).height == pytest.approx(1.7)
    given = tk.load(path, unit=0.04, up="y")
    assert given.global_positions.allclose(clip.global_positions, atol=1e-4)
    tk.bvh.save(clip, path, unit=1.757 / 240)  # 2.4 m in cm: too tall for people, not for figures
    doubt = r"with a unit of 0\.01 m \(cm\) the body is 2\.39 m tall; unit= decides"
    with pytest.warns(UserWarning, match=doubt):
        tk.load(path)


@pytest.mark.parametrize("up", interpretation.AXES)
def test_the_up_axis_follows_from_the_body(tmp_path, up):
    clip, path = rigs.walk("LaFAN1", seconds=1.0), tmp_path / "walk.bvh"
    angles = {"y": (0, 0, 0), "-y": (180, 0, 0), "z": (90, 0, 0), "-z": (-90, 0, 0),
              "x": (0, 0, -90), "-x": (0, 0, 90)}
    tk.bvh.save(turned(clip, *angles[up]), path)
    found = tk.inspect(path)
    assert (found.up, len(found.doubts)) == (up, len(up) - 1)
    assert all(f"stands along {up}, or is upside down" in said for said in found.doubts)
    positions = found.clip.global_positions
    assert_close(positions, clip.global_positions, atol=1e-4, rtol=0)
    assert_close(tk.load(path, up=up).rotations, found.clip.rotations)


def test_roles_unit_and_up_that_do_not_fit_are_refused(tmp_path):
    path = tmp_path / "walk.bvh"
    tk.bvh.save(rigs.walk("LaFAN1", seconds=0.5), path)
    for options, problem in (
        ({"roles": {"left_wing": "LeftArm"}}, "'left_wing' is no role; the roles are hips"),
        ({"roles": {"left_hand": "LeftPaw"}}, "no joint 'LeftPaw' for the role left_hand"),
        ({"roles": {"left_knee": "LeftFoot"}},
         r"left_foot \(LeftFoot\) is not below left_knee \(LeftFoot\)"),
        ({"unit": 0.0}, "unit is metres of one unit"),
        ({"unit": "parsec"}, "auto, m, cm"),
        ({"up": "w"}, "one of auto, x"),
    ):
        with refusal(problem):
            tk.load(path, **options)
    given = tk.load(path, roles={"left_toe": "LeftFoot"})
    assert given.skeleton.roles["left_toe"] == "LeftFoot"
    assert tk.inspect(path, roles={"left_toe": "LeftFoot"}).rules["left_toe"] == "given"


def odd(random, walks) -> Recording:
    """A walk of some rig in another size, unit, place or direction, or with something wrong."""
    name = random.choice([*walks])
    clip, pick = walks[name], random.choice
    size, unit = pick((1.0, random.lognormvariate(0, 0.6))), pick([*interpretation.UNITS.values()])
    seconds = torch.arange(len(clip))[:, None] / clip.fps
    path = clip.root_positions * pick((1.0, 1.0, 1.0, 0.0, random.lognormvariate(0, 2.5)))
    path = path + torch.tensor([0.0, pick((0.0, 0.0, random.gauss(0, 0.6))), 0.0])
    path = path + pick((0.0, 0.0, 0.2 * random.random())) * seconds * torch.eye(3)[1]
    path = path + pick((0.0, 0.0, 4 * random.random())) * seconds * torch.eye(3)[2]
    rotations, names, swap = clip.rotations, [*clip.skeleton.names], {"left": "right"}
    if random.random() < 0.1:  # jumps
        path = path + 3.0 * (seconds > 0.5)
    if random.random() < 0.1:  # a statue
        rotations = rotations[:1].expand(rotations.shape)
    if random.random() < 0.2:  # roles by the shape of the tree alone
        names = [f"j{j}" for j in range(len(names))]
    elif random.random() < 0.1:
        swap |= {right: left for left, right in swap.items()}
        names = [re.sub("left|right", lambda m: swap[m[0]], text) for text in names]
    turned_ = turned(clip.replace(rotations=rotations, root_positions=path * size / unit), *pick(
        ((0, 0, 0), (0, 0, 0), (0, 0, 0), (90, 0, 0), (0, 0, 90), (180, 0, 0),
         (180 * random.random(), 0, 0))))
    parents, offsets = [*clip.skeleton.parents], clip.skeleton.offsets * size / unit
    rotations, more = turned_.rotations, pick((0, 0, 0, 5, 12))
    if random.random() < 0.2:  # bones that rest along z
        up = R.from_euler(torch.deg2rad(torch.tensor([90.0, 0.0, 0.0])), "XYZ")
        rotations, offsets = R.multiply(rotations, R.inverse(up)), R.rotate(up, offsets)
        rotations = torch.cat((rotations[:, :1], R.multiply(up, rotations[:, 1:])), 1)
    names += [f"prop{i}" for i in range(more)]
    parents += [0] * more
    offsets = torch.cat((offsets, torch.ones(more, 3) * size / unit))
    rotations = torch.cat((rotations, R.identity(len(clip)).expand(more, -1, 4).transpose(0, 1)), 1)
    rate = pick((60.0, 60.0, 60.0, 30.0, random.lognormvariate(3, 4)))
    return Recording(
        "BVH", tuple(names), tuple(parents), offsets.double(), rotations,
        turned_.root_positions.double(), rate,
        unit=pick((None, None, unit, 0.01, 1.0)), up=pick((None, None, None, "y", "z")),
        ends=clip.skeleton.ends if names[0] == clip.skeleton.names[0] else ())


def test_odd_recordings_are_understood_as_they_were():
    random, understood, places = Random(0), [], []
    walks = {name: rigs.walk(name, bent, 1.0) for name, bent in (
        ("Mixamo", True), ("MotionBuilder", False), ("Unreal", True), ("MakeHuman", False))}
    for _ in range(180):
        recording = odd(random, walks)
        try:
            clip, found = interpretation.interpret(recording, Path("odd.bvh"))
        except ValueError as error:
            places.append(str(error))
            continue
        understood.append([found, clip.skeleton.roles, clip.fps])
        places.append(clip.global_positions[::9])
    unchanged.check("findings in odd recordings", understood)
    unchanged.check("odd recordings", places)


def test_sides_that_are_exchanged_are_noticed(tmp_path):
    """As by a program whose axes are left-handed."""
    exchanged = rigs.walk("LaFAN1", seconds=1.0, sides=("Right", "Left"))
    tk.bvh.save(exchanged, tmp_path / "walk.bvh")
    with pytest.warns(UserWarning, match="called left are on the right of the body") as caught:
        tk.load(tmp_path / "walk.bvh")
    assert caught[0].filename == __file__  # the user's line


@pytest.mark.parametrize(("between", "role", "right"), [("{}Thigh", "hip", "LeftUpLeg"),
                                                     ("{}Knee1", "knee", "LeftLeg")])
def test_a_joint_more_in_the_thigh_takes_no_role_and_is_said(tmp_path, between, role, right):
    """Its name fits better than that of the right joint.

    Both parts of a person's leg are about equally long.
    """
    made = rigs.walk("LaFAN1", seconds=1.0, within=f"Knee {between}")
    tk.bvh.save(made, tmp_path / "more.bvh")
    doubt = f"{right} is taken for the left {role}, because both parts of the limb are then"
    with pytest.warns(UserWarning, match=doubt):
        found = tk.load(tmp_path / "more.bvh").skeleton.roles
    assert (found["left_hip"], found["right_knee"]) == ("LeftUpLeg", "RightLeg")


def wider(factor):
    """The path alone is so many times as long."""
    across = torch.tensor([factor, 1.0, factor])
    return lambda clip: clip.replace(root_positions=clip.root_positions * across)


def leaning(clip):
    return turned(clip, 45, 0, 0).moved(shift=(0, 1, 0))


def lying(height):
    """Turned by a quarter, on the path of one who walks two and a half lengths of a leg."""
    return lambda clip: turned(clip.cut(0, 180), 90, 0, 0).replace(
        root_positions=clip.cut(0, 180).moved(shift=(0, height, 0)).root_positions)


def rising(clip):
    heights = torch.linspace(-0.15, 0.15, len(clip))[:, None] * torch.tensor([0.0, 1.0, 0.0])
    return clip.replace(root_positions=clip.root_positions + heights)


def jumping(clip):
    """As from a T-pose before the recording."""
    places = clip.root_positions.clone()
    places[0] += torch.tensor([5.0, 0.0, 0.0])
    return clip.replace(root_positions=places)


def standing(clip):
    return clip.replace(rotations=clip.rotations[:1].expand_as(clip.rotations))


@pytest.mark.parametrize(("change", "said"), [
    (lambda clip: clip.moved(shift=(0, -3, 0)), r"the feet stand at -2\.98 m instead of 0"),
    (lambda clip: clip.resample(1.0), "1 frames per second is no usual rate"),
    (rising, r"the floor moves by \+0\.30 m over the clip"),
    (wider(100.0), r"the body goes 1\d\d m/s: its path may be in another unit than its bones"),
    (wider(2.54), "the path is in another unit than the bones: .* if it is 0.3937 times as long"),
    (jumping, "the body jumps by [45].* m from frame 0 to 1"),
    (lambda clip: clip.replace(fps=8.0), r"the body goes \d+ m, and its feet hardly move"),
    (standing, r"the body goes \d+ m, and no foot ever stands"),
    (leaning, "not upright in most frames: y is"),
    (lying(0.0), "stands along z or lies with y up"),
    (lying(1.0), "goes along z, .* lie"),
])
def test_what_cannot_be_true_is_doubted(tmp_path, walk_clip, change, said):
    tk.bvh.save(change(walk_clip), tmp_path / "walk.bvh")
    assert re.search(said, "; ".join(tk.inspect(tmp_path / "walk.bvh").doubts))


def recorded(clip: tk.Clip, **changes) -> Recording:
    skeleton = clip.skeleton
    made = Recording("glTF", skeleton.names, skeleton.parents, skeleton.offsets.double(),
                     clip.rotations, clip.root_positions.double(), 60.0, tuple(skeleton.ends),
                     unit=1.0, up="y")
    return dataclasses.replace(made, **changes)


def test_roles_that_a_file_states_count_more_than_names():
    """The forearm stated as the elbow; a role that there is not is left out."""
    clip = rigs.walk("LaFAN1", seconds=0.5)
    stated = {"left_hand": "LeftForeArm", "left_elbow": "LeftArm", "left_shoulder": "LeftShoulder",
              "tail": "Spine"}
    made, found = interpretation.interpret(recorded(clip, roles=stated), Path("a.vrm"))
    assert made.skeleton.roles["left_hand"] == "LeftForeArm"
    assert (found.rules["left_hand"], found.rules["right_hand"]) == ("the file", "name")
    assert "tail" not in made.skeleton.roles


def test_a_long_chain_of_joints_takes_no_longer_than_its_length(walk_clip):
    """Paths that are walked for each joint took ten minutes for 40,000 joints."""
    skeleton, many = walk_clip.skeleton, 10_000
    clip, count, began = walk_clip.cut(0, 2), len(skeleton), time.process_time()
    chest = skeleton.trunk[0]
    made = interpretation.interpret(recorded(
        clip, names=(*skeleton.names, *(f"x{i}" for i in range(many))),
        parents=(*skeleton.parents, chest, *range(count, count + many - 1)),
        offsets=torch.cat((skeleton.offsets.double(), torch.full((many, 3), 1e-6).double())),
        rotations=torch.cat((clip.rotations, R.identity(2, many)), 1)), Path("a.glb"))[0]
    assert made.skeleton.roles == skeleton.roles
    assert time.process_time() - began < 10


def test_the_rest_pose_shows_the_axis_where_the_motion_does_not():
    """A body that turns heels over head in one second; at rest it stands along z."""
    clip = rigs.walk("LaFAN1", seconds=1.0)
    angles = torch.linspace(0, 2 * torch.pi, len(clip))[:, None] * torch.tensor([1.0, 0.0, 0.0])
    others = R.identity(len(clip), len(clip.skeleton) - 1)
    rotations = torch.cat((R.from_euler(angles, "XYZ")[:, None], others), 1)
    lying = R.from_euler(torch.tensor([torch.pi / 2, 0.0, 0.0]), "XYZ")
    rest = R.rotate(lying, clip.skeleton.offsets).double()
    recording = recorded(clip, rotations=rotations, offsets=rest, up=None)
    found = interpretation.interpret(recording, Path("a.fbx"))[1]
    assert found.up == "z"
    doubt = "the body is not upright in most frames: z is assumed to point up; up= decides"
    assert doubt in found.doubts
