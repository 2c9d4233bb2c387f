"""Roles and mirror pairs on rigs with the names of common exporters."""

import dataclasses

import pytest
import rigs
import torch

import toolkit as tk
from toolkit.motion import role_words, roles, rotations


def walk(name: str, seconds: float) -> tk.Clip:
    """A walk on a rig, without the roles that the rig's maker knows."""
    clip = rigs.walk(name, seconds=seconds)
    return clip.replace(skeleton=dataclasses.replace(clip.skeleton, roles=None))


@pytest.fixture(scope="module")
def skeletons() -> dict[str, tk.Skeleton]:
    """The skeleton of each convention."""
    return {name: walk(name, 0.1).skeleton for name in rigs.TABLE}


def test_every_convention_shows_its_roles(skeletons):
    for name, skeleton in skeletons.items():
        assert skeleton.roles == rigs.roles(rigs.TABLE[name]), name


def test_every_sided_joint_has_its_counterpart(skeletons):
    for name, skeleton in skeletons.items():
        left, right = rigs.TABLE[name].sides
        said = [role_words.read(joint) for joint in skeleton.names]
        for j, other in enumerate(skeleton.mirror_pairs):
            assert skeleton.mirror_pairs[other] == j
            assert (said[j].side == "") == (j == other), skeleton.names[j]
            if said[j].side:
                assert said[other].plain == said[j].plain
                swapped = {"left": right, "right": left}[said[j].side]
                assert swapped in skeleton.names[other]


def limbs(*chains: tuple[str, ...]) -> tuple[list[str], list[int]]:
    """Names and parents of hips with chains on both sides; a name that stands twice is one."""
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
    # above the elbow, and no helper
    ([("Alpha", "AlphaTwist", "ForeArm", "Hand")], "left_shoulder", "LeftAlpha"),
    # more than a part of the arm
    ([("Alpha", "ForeArm", "Hand"), ("Alpha", "Wing")], "left_shoulder", None),
    # two parts that count the same, in an order that no leg has
    ([("Knee", "Thigh", "Foot")], "left_foot", "LeftFoot"),
    # the thigh of SOMA's skeleton (Kimodo) has a name that is the shin's elsewhere
    ([("Leg", "Shin", "Foot", "ToeBase")], "left_hip", "LeftLeg"),
])
def test_a_joint_without_a_fitting_name_is_found_beside_its_neighbour(chains, role, joint):
    assert roles.find(*limbs(*chains), [1] * 20).get(role, (None,))[0] == joint


@pytest.mark.parametrize(("length", "toe"), [(0.01, "LeftFoot"), (0.1, "LeftTip")])
def test_a_bone_below_the_ankle_that_is_short_shows_no_toe(length, toe):
    names, parents = limbs(("Thigh", "Shin", "Foot", "Tip"))
    lengths = [length if name.endswith("Tip") else 0.4 for name in names]
    assert roles.find(names, parents, lengths)["left_toe"][0] == toe


def test_the_hips_are_called_so_even_if_the_legs_meet_below_them():
    legs = ("LeftThigh", "LeftShin", "LeftFoot", "RightThigh", "RightShin", "RightFoot")
    found = roles.find(["Root", "Hips", "Extra", *legs], [-1, 0, 1, 2, 3, 4, 2, 6, 7], [1] * 9)
    assert found["hips"][0] == "Hips"


def test_counterparts_without_roles_follow_from_names_or_else_from_the_tree():
    assert roles.mirror_pairs(["root", "LeftWing", "RightWing"], [-1, 0, 0], {}) == (0, 2, 1)
    assert roles.mirror_pairs(["root", "x", "y"], [-1, 0, 0], {}) == (0, 1, 2)
    names = ["root", "one", "two", "a:Tail", "a:Wing", "b:Wing", "b:Tail", "x", "below x", "y",
             "below y"]
    parents = [-1, 0, 0, 1, 1, 2, 2, 1, 7, 2, 9]
    pairs = roles.mirror_pairs(names, parents, {"left_hand": "one", "right_hand": "two"})
    assert pairs == (0, 2, 1, 6, 5, 4, 3, 9, 10, 7, 8)


def test_a_joint_and_its_parent_are_no_counterparts():
    for left, right in (("upper", "lower"), ("lower", "upper")):
        hands = {"left_hand": left, "right_hand": right}
        assert roles.mirror_pairs(["root", "upper", "lower"], [-1, 0, 1], hands) == (0, 1, 2)


@pytest.mark.parametrize("toe", ["LeftFootEnd", "LeftFoot"])
def test_the_end_of_a_foot_or_its_ankle_stands_in_for_a_toe(toe):
    """Feet are planted, and contacts found."""
    clip = walk("Perception Neuron", 4.0)
    if toe == "LeftFoot":
        clip = clip.without_ends()
    skeleton = clip.skeleton
    assert skeleton.roles["left_toe"] == toe
    assert tk.contacts.detect(clip).mean() > 0.2
    toes, first = [skeleton.role(f"{side}_toe") for side in ("right", "left")], clip.cut(0, 20)
    targets = first.global_positions[:, toes] + torch.tensor([0.01, 0.01, 0.02])
    planted = tk.motion.ik.plant_feet(skeleton, first.rotations, first.root_positions, targets)
    reached = first.replace(rotations=planted).global_positions[:, toes]
    assert (reached - targets).norm(dim=-1).mean() < 0.005
    turned = tk.motion.ik.swivelled(skeleton, rotations.identity(len(skeleton)),
                                    torch.tensor([0.3, 0.3]))
    assert torch.allclose(turned[toes], rotations.yaw(torch.tensor([0.3, 0.3])))
