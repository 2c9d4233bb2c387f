"""Postures and medleys."""

import torch
from course import postures
from course.medley import medley

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


def test_a_medley_goes_on_where_the_last_clip_ended():
    clips = tk.datasets.procedural.load("Neutral", ["FW", "SW", "FR"], 3.0)
    whole = medley(clips, overlap=0.5)
    assert len(whole) == sum(map(len, clips)) - 2 * 30
    assert torch.equal(whole.rotations[:150], tk.motion.rotations.unroll(clips[0].rotations)[:150])
    # the second clip alone: relative to its root it is what it was
    middle = (tk.motion.root_frames(clip).to_local(clip.global_positions)
              for clip in (whole.cut(180, 300), clips[1].cut(30, 150)))
    assert torch.allclose(*middle, atol=1e-4)
    speed, *fastest = (tk.contacts.velocities(clip.global_positions, clip.fps).norm(dim=-1).max()
                       for clip in (whole, *clips))
    assert speed < 1.3 * max(fastest)  # nothing jumps
