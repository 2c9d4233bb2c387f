"""Figures of the notebooks on styles say what their numbers say."""

import torch
from course import postures

import toolkit as tk


def test_posture_of_a_pose_whose_numbers_are_known():
    skeleton = tk.pretrained().model.layout.skeleton
    layout = tk.features.Layout(skeleton)
    standing = skeleton.rest_positions + torch.tensor([0.0, 1.0, 0.0])  # the T-pose
    stepping = standing.clone()
    stepping[skeleton.index("left_foot"), 2] += 0.4
    joints = list(skeleton.feature_joints)
    found = postures.posture(layout, torch.stack((standing, stepping))[None, :, joints])
    hand = standing[skeleton.index("left_hand")]
    assert torch.allclose(found["hips_height"], torch.tensor([1.0, 1.0]))
    assert torch.allclose(found["hand_height"], hand[1].expand(2))
    assert torch.allclose(found["arm_spread"], (2 * hand[0]).expand(2), atol=1e-5)
    assert torch.allclose(found["step_length"], torch.tensor([0.0, 0.4]), atol=1e-5)
    assert float(found["bone_stretch"][0]) < 1e-6 < 0.005 < float(found["bone_stretch"][1])
