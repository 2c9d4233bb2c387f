"""Figures of the notebooks on styles and feet say what their numbers say."""


import torch
from course import folding, postures

import toolkit as tk


def test_film_folds_into_a_layers_weights():
    """Equation 6, exact for all inputs; with layer normalisation up to the sample's deviation."""
    torch.manual_seed(7)
    x, weight, bias = (torch.randn(*n).double() for n in ((5, 7), (7, 6), (6,)))
    gamma, beta = torch.randn(2, 6).double()
    folded, shift = folding.fold(weight, bias, gamma, beta)
    right = gamma * (x @ weight + bias) + beta
    torch.testing.assert_close(x @ folded + shift, right, rtol=1e-12, atol=1e-12)
    f = x @ weight + bias
    each = weight.expand(5, 7, 6), bias.expand(5, 6)
    folded, shift = folding.fold(*each, gamma, beta, f.std(-1))
    got = torch.einsum("bi,bio->bo", x, folded) + shift
    normed = gamma * tk.networks.layer_norm(f) + beta
    torch.testing.assert_close(got, normed, rtol=1e-10, atol=1e-12)


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
