"""Measures against motions whose answer is known."""

import math

import pytest
import torch

import toolkit as tk


def slid(clip, velocity):
    """The clip, carried along at a velocity (x, z)."""
    time = torch.arange(len(clip))[:, None] / clip.fps
    return clip.replace(root_positions=clip.root_positions + time * torch.tensor([velocity[0], 0.0, velocity[1]]))


def test_planted_feet_do_not_skate_and_a_carried_clip_does(walk_clip):
    truth = tk.contacts.detect(walk_clip)
    assert max(tk.metrics.foot_skate(walk_clip, truth).values()) < 0.05
    carried = tk.metrics.foot_skate(slid(walk_clip, (0.3, 0.0)), truth)
    assert min(carried.values()) == pytest.approx(0.3, abs=0.03)


def test_a_foot_without_contact_has_no_skate(walk_clip):
    none = torch.zeros(len(walk_clip), 2)
    assert all(math.isnan(v) for v in tk.metrics.foot_skate(walk_clip, none).values())


def test_contacts_of_another_clip_are_refused(walk_clip):
    with pytest.raises(ValueError, match=r"shape \[480, 2\], got \[3, 2\]"):
        tk.metrics.foot_skate(walk_clip, torch.zeros(3, 2))


def test_steps_are_landings_of_both_feet():
    contact = torch.tensor([[1.0, 0.0], [0.2, 0.9], [0.9, 0.8], [0.9, 0.1], [0.4, 0.7], [0.6, 0.7]])
    assert tk.metrics.step_rate(contact, 60.0) == pytest.approx(4 / (6 / 60))
    assert tk.metrics.step_rate(torch.ones(60, 2), 60.0) == 0.0


def test_speed_height_and_uprightness(walk_clip):
    assert tk.metrics.speed(slid(walk_clip.cut(0, 1).replace(
        rotations=walk_clip.rotations[:1].repeat(120, 1, 1), root_positions=walk_clip.root_positions[:1].repeat(120, 1),
    ), (0.0, 1.5))) == pytest.approx(1.5, abs=1e-3)
    low, high = tk.metrics.hips_height(walk_clip)
    assert 0.85 < low < high < 1.05
    assert tk.metrics.upright(walk_clip)
    lying = tk.motion.rotations.from_axis_angle(torch.tensor([1.0, 0.0, 0.0]), torch.tensor(math.pi / 2))
    fallen = walk_clip.rotations.clone()
    fallen[:, 0] = tk.motion.rotations.multiply(lying, fallen[:, 0])
    assert not tk.metrics.upright(walk_clip.replace(rotations=fallen))


def test_distance_from_a_path(walk_clip):
    hips = walk_clip.root_positions[:, [0, 2]]
    assert tk.metrics.path_error(walk_clip, hips) < 1e-4
    far = torch.tensor([[0.0, 1000.0], [1.0, 1000.0]])
    assert tk.metrics.path_error(walk_clip, far) == pytest.approx(float((hips - far[0]).norm(dim=-1).mean()), rel=0.01)


def test_posture_of_a_pose_whose_numbers_are_known(walk_clip):
    skeleton, layout = walk_clip.skeleton, tk.features.Layout(walk_clip.skeleton)
    standing = skeleton.rest_positions + torch.tensor([0.0, 1.0, 0.0])  # the T-pose
    stepping = standing.clone()
    stepping[skeleton.index("left_foot"), 2] += 0.4
    joints = list(skeleton.feature_joints)
    seen = tk.metrics.posture(layout, torch.stack((standing, stepping))[None, :, joints])
    hand = standing[skeleton.index("left_hand")]
    assert torch.allclose(seen["hips_height"], torch.tensor([1.0, 1.0]))
    assert torch.allclose(seen["hand_height"], hand[1].expand(2))
    assert torch.allclose(seen["arm_spread"], (2 * hand[0]).expand(2), atol=1e-5)
    assert torch.allclose(seen["step_length"], torch.tensor([0.0, 0.4]), atol=1e-5)
    assert float(seen["bone_stretch"][0]) < 1e-6 < 0.005 < float(seen["bone_stretch"][1])
