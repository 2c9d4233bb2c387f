"""Retargeting between humanoids of other rest poses, local axes, proportions and joints."""

import pytest
import torch
from posed_rigs import POSES, rig, with_soles, with_twists, without_toes
from refusal import refusal

import toolkit as tk
from toolkit.datasets.procedural import SKELETON
from toolkit.extra.characters import retargeting
from toolkit.extra.characters.anatomy import measure
from toolkit.motion import rotations as R


@pytest.fixture(scope="module")
def walk() -> tk.Clip:
    clip = tk.datasets.procedural.generate("BentForward", seconds=3.0)
    return clip.moved(turn=0.7, shift=(2.0, 0.0, -1.0))


@pytest.mark.parametrize("pose", POSES[1:])
def test_there_and_back_keeps_the_directions_of_limbs(walk, pose):
    """Onto a rig with shorter legs, longer arms and wider hips; then back to the first one."""
    target = rig(pose, arms=1.2, legs=0.8, hips=1.15)
    made = retargeting.retarget(walk, target)
    assert made.skeleton == target.skeleton
    there, back = retargeting.report(walk, made), retargeting.retarget(made, SKELETON)
    for found in (there, retargeting.report(walk, back)):
        assert found.direction < 2.0, found
        assert found.above < 0.3, found
        assert found.below < 0.5, found
        assert found.skate[1] < 1.5 * found.skate[0] + 0.5, found
    assert there.scale == pytest.approx(0.8, abs=1e-4)
    assert (back.global_positions - walk.global_positions).norm(dim=-1).mean() < 0.02


@pytest.mark.parametrize(("pose", "turned"), [
    ("T-pose", (0.0, 1.0, 0.0)), ("A-pose", (1.0, 0.0, 0.0)), ("hanging", (0.0, 0.0, 1.0))])
def test_zero_rotations_may_face_any_way(walk, pose, turned):
    """A skeleton alone, without a frame of it: Z up, facing sideways, lying on its side."""
    target = rig(pose, turned=R.from_axis_angle(torch.tensor(turned), torch.tensor(torch.pi / 2)))
    made = retargeting.retarget(walk, target.skeleton)
    assert retargeting.report(walk, made).direction < 0.1
    assert (made.global_positions - walk.global_positions).norm(dim=-1).max() < 0.002


def test_feet_stay_where_they_stand(walk):
    target = rig("A-pose", legs=0.75, hips=1.6)
    slid, kept = (retargeting.report(walk, retargeting.retarget(walk, target, feet=feet))
                  for feet in (False, True))
    assert slid.direction < 0.01  # without foot IK the directions are exact
    assert kept.direction < 3.0
    assert kept.skate[1] <= slid.skate[1] + 1e-3
    assert kept.skate[1] < kept.skate[0] + 0.5


def test_twist_bones_fingers_and_a_root_follow(walk):
    target = rig("A-pose", joints=with_twists)
    made = retargeting.retarget(walk, target)
    assert len(made.skeleton) == len(SKELETON) + 7
    assert retargeting.report(walk, made).direction < 0.5
    for name in SKELETON.names:
        ours = made.global_positions[:, made.skeleton.index(f"rig:{name}")]
        apart = ours - walk.global_positions[:, SKELETON.index(name)]
        assert apart.norm(dim=-1).max() < 0.01, name
    extra = made.skeleton.index("rig:LeftWristThumb")
    assert torch.allclose(made.rotations[:, extra].abs(), target.rotations[:, extra].abs(),
                          atol=1e-5)
    back = retargeting.retarget(made, SKELETON)
    assert (back.global_positions - walk.global_positions).norm(dim=-1).max() < 0.02


def test_missing_toes_and_collars_are_tolerated(walk):
    target = rig("A-pose", joints=without_toes)
    made = retargeting.retarget(walk, target)
    assert retargeting.report(walk, made).direction < 1.0
    assert 0.04 < made.global_positions[..., 1].min() < 0.12  # of an ankle
    back = retargeting.retarget(made, SKELETON)
    assert retargeting.report(walk, back).direction < 1.0
    assert -0.03 < back.global_positions[..., 1].min() < 0.05
    assert back.global_positions[..., SKELETON.index("HeadEnd"), 1].median() > 1.2


def test_a_toe_straight_below_the_ankle_shows_no_direction(walk):
    """An End Site under the ankle has the role of a toe."""
    target = rig("hanging", joints=with_soles)
    made = retargeting.retarget(walk, target)
    assert retargeting.report(walk, made).direction < 3.0
    for side in ("Left", "Right"):
        foot = made.global_rotations[:, made.skeleton.index(f"rig:{side}Ankle")]
        ahead = R.rotate(foot, torch.tensor([0.0, 0.0, 1.0]))
        assert ahead[:, 1].abs().median() < 0.4  # flat on the floor most of the time
    assert retargeting.report(walk, retargeting.retarget(made, SKELETON)).direction < 6.0


def test_the_floor_is_found(walk):
    made = retargeting.retarget(walk.moved(shift=(0.0, -3.0, 0.0)), rig("A-pose"))
    assert 0.0 < float(tk.contacts.standing_height(made)) < 0.05


def test_a_rig_whose_zero_rotations_show_nothing_needs_a_clip(walk):
    target = rig("along y")
    with refusal("no standing figure"):
        retargeting.retarget(walk, target.skeleton)
    assert measure(target).leg == pytest.approx(0.869, abs=1e-3)
