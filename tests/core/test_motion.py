import dataclasses
import math

import numpy as np
import pytest
import torch
from hypothesis import given, strategies as st
from refusal import refusal
from strategies import clips, human, human_clip, quaternions, seeds
from torch.testing import assert_close

import toolkit as tk
from toolkit.motion import (
    ROLES,
    Clip,
    Skeleton,
    forward_kinematics,
    local_rotations,
    root_frames,
    rotations as R,
)

MIRROR = torch.tensor([-1.0, 1.0, 1.0])


@given(clips())
def test_forward_kinematics_against_plain_matrices_and_back(clip):
    skeleton = clip.skeleton
    local, offsets = R.to_matrix(clip.rotations.double()).numpy(), skeleton.offsets.numpy()
    for f in range(len(clip)):
        worlds = []
        for j, parent in enumerate(skeleton.parents):
            own = np.eye(4)
            own[:3, :3] = local[f, j]
            own[:3, 3] = clip.root_positions[f] if parent < 0 else offsets[j]
            worlds.append(own if parent < 0 else worlds[parent] @ own)
        found = torch.cat((R.to_matrix(clip.global_rotations[f]),
                           clip.global_positions[f, ..., None]), -1)
        np.testing.assert_allclose(found, np.stack(worlds)[:, :3], atol=1e-4)
    rotations, _ = forward_kinematics(skeleton, clip.rotations, clip.root_positions)
    back = local_rotations(skeleton, rotations)
    assert_close(back, clip.rotations, atol=1e-5, rtol=0)


def test_a_skeleton_that_inference_mode_used_first_can_be_differentiated():
    skeleton = human()
    with torch.inference_mode():
        forward_kinematics(skeleton, R.identity(2, 20), torch.zeros(2, 3))
        _ = skeleton.rest_positions, skeleton.facing_axis
    q = R.identity(2, 20).requires_grad_()
    turned, positions = forward_kinematics(skeleton, q, torch.zeros(2, 3))
    across = R.rotate(turned, skeleton.facing_axis) * (positions - skeleton.rest_positions)
    across.sum().backward()
    assert q.grad.isfinite().all()


@given(seeds)
def test_mirror_reflects_every_point(seed):
    clip = human_clip(seed)
    reflected = (clip.global_positions * MIRROR)[:, list(clip.skeleton.mirror_pairs)]
    assert_close(clip.mirrored().global_positions, reflected, atol=1e-5, rtol=0)


def test_resample_follows_the_motion_between_frames():
    skeleton = Skeleton(("a", "b"), (-1, 0), torch.tensor([[0.0, 0, 0], [0, 0, 1]]))

    def swing(fps):
        t = torch.arange(0, 2, 1 / fps, dtype=torch.float64)
        rotations = R.identity(len(t), 2)
        rotations[:, 0] = R.yaw(torch.sin(2 * math.pi * t)).float()
        return Clip(skeleton, rotations, torch.stack((torch.cos(t), t, t**2), -1), fps)

    slow, fast = swing(30.0).resample(60.0), swing(60.0)
    n = len(slow)
    assert n == 119
    assert_close(slow.global_positions, fast.global_positions[:n], atol=1e-3, rtol=0)
    assert slow.seconds == pytest.approx(2.0, abs=0.05)


@given(seeds, st.floats(-4, 4), st.tuples(*[st.floats(-5, 5)] * 3))
def test_moving_the_clip_moves_the_points(seed, turn, shift):
    clip = human_clip(seed)
    expected = R.rotate(R.yaw(torch.tensor(turn)), clip.global_positions) + torch.tensor(shift)
    moved = clip.moved(turn, shift)
    assert_close(moved.global_positions, expected, atol=1e-4, rtol=0)
    local, same = (root_frames(c).to_local(c.global_positions)[..., [0, 2]] for c in (clip, moved))
    assert_close(local, same, atol=1e-4, rtol=0)


def test_root_frames_face_where_the_body_faces():
    clip = human_clip(1, bend=0.0).moved(turn=0.8)
    frames = root_frames(clip)
    assert_close(frames.rotations, R.yaw(torch.tensor(0.8)).expand(len(clip), 4))
    left = frames.to_local(clip.global_positions)[:, clip.skeleton.index("left_hand"), 0]
    assert (left > 0.5).all()
    assert (frames.positions[:, 1] == 0).all()


def test_cut_keeps_the_frames_and_clamps_the_end():
    clip = human_clip(2, frames=10)
    assert_close(clip.cut(3, 99).root_positions, clip.root_positions[3:])
    assert len(clip.cut(3, 7)) == 4
    for start, stop in ((7, 7), (10, 12), (-1, 4)):
        with refusal(f"cannot cut frames {start}"):
            clip.cut(start, stop)


def test_roles_and_names():
    skeleton = human()
    assert skeleton.index("left_elbow") == skeleton.index("LeftElbow")
    assert skeleton.roles["right_knee"] == "RightKnee"
    assert skeleton.names[skeleton.mirror_pairs[skeleton.index("LeftToe")]] == "RightToe"
    assert {*range(len(skeleton))} - {*skeleton.feature_joints} == {skeleton.index("HeadEnd")}
    with refusal(r"no joint has the role 'Hips'.*Hips, Chest"):
        skeleton.role("Hips")


def test_a_joints_own_name_wins_over_a_role():
    """SMPL has a hand beyond the wrist, and calls the ankle's child a foot."""
    names = ("pelvis", *(f"left_{part}" for part in (
        "hip", "knee", "ankle", "foot", "collar", "shoulder", "elbow", "wrist", "hand")))
    roles = {"left_hip": "left_hip", "left_knee": "left_knee", "left_foot": "left_ankle",
             "left_toe": "left_foot", "left_hand": "left_wrist"}
    skeleton = Skeleton(names, (-1, 0, 1, 2, 3, 0, 5, 6, 7, 8), torch.ones(10, 3), roles)
    for name, role in (("left_hand", "left_wrist"), ("left_foot", "left_ankle")):
        assert skeleton.names[skeleton.index(name)] == name
        assert skeleton.names[skeleton.role(name)] == role
    assert skeleton.names[skeleton.index("left_toe")] == "left_foot"


def test_end_sites_are_leaves_that_are_named_or_called_so():
    tree = ("a", "b", "bEnd", "c_End"), (-1, 0, 1, 0), torch.ones(4, 3)
    assert Skeleton(*tree).ends == ("bEnd", "c_End")
    skeleton = Skeleton(*tree, ends=("bEnd",))
    assert [skeleton.is_end(j) for j in range(4)] == [False, False, True, False]
    assert Skeleton(**skeleton.to_dict()).ends == ("bEnd",)
    assert tk.features.Layout(human()) != tk.features.Layout(dataclasses.replace(human(), ends=()))
    with refusal("must be leaves of the tree; these are not: b, d"):
        Skeleton(*tree, ends=("b", "bEnd", "d"))
    with refusal("not there: f$"):
        Skeleton(*tree, {"hips": "f"})


def test_names_that_are_roles_of_other_joints_change_nothing(walk_clip):
    """Each joint with a role is called like the next role."""
    walk_clip = walk_clip.cut(0, 200)
    old = walk_clip.skeleton
    called = {old.roles[role]: other
              for role, other in zip(ROLES, ROLES[1:] + ROLES[:1], strict=True)}
    roles = {role: called[name] for role, name in old.roles.items()}
    names = [called.get(name, name) for name in old.names]
    renamed = walk_clip.replace(skeleton=Skeleton(names, old.parents, old.offsets, roles))

    def seen(clip: Clip) -> list:
        skeleton, frames = clip.skeleton, tk.features.frames(clip)
        targets = clip.global_positions[:5] + 0.03
        toes = targets[:, [skeleton.role("right_toe"), skeleton.role("left_toe")]]
        first = clip.rotations[:5], clip.root_positions[:5]
        return [
            frames.inputs, frames.outputs, frames.phases, skeleton.facing_axis,
            tk.motion.ik.turn_arms(skeleton, *first, targets),
            tk.motion.ik.plant_feet(skeleton, *first, toes), tk.contacts.detect(clip),
            tk.metrics.hips_height(clip), tk.metrics.speed(clip), tk.metrics.upright(clip),
            list(tk.metrics.foot_skate(clip).values()), tk.features.Layout(skeleton).limbs,
        ]

    for expected, got in zip(seen(walk_clip), seen(renamed), strict=True):
        np.testing.assert_array_equal(got, expected)


@pytest.mark.parametrize(("names", "parents", "match"), [
    ("ab", (-1,), "2 joint names need 2 parents"),
    ("aa", (-1, 0), "a joint is named twice: a"),
    ("abc", (-1, 2, 0), "every parent before its children"),
    ("", (), "root must come first"),
])
def test_bad_skeleton(names, parents, match):
    with refusal(match):
        Skeleton(tuple(names), parents, torch.zeros(len(names), 3))


def test_quaternions_of_three_decimals_are_near_enough_to_unit_length():
    rounded = (1e3 * quaternions(0, 50, 20).float()).round() / 1e3
    assert len(Clip(human(), rounded, torch.zeros(50, 3), 30)) == 50


def test_bad_clip():
    skeleton, q, p = human(), R.identity(4, 20), torch.zeros(4, 3)
    bad = q.clone()
    bad[2, 5, 1] = math.nan
    long, nothing = q.clone(), q.clone()
    long[1, 3], nothing[3, 0] = 1.01 * long[1, 3], 0.0
    for rotations, positions, fps, match in (
        (q[:0], p[:0], 30, "F >= 1"),
        (bad, p, 30, "rotations of frame 2 are not finite"),
        (long, p, 30, r"length 1; in frame 1 that of HeadEnd has length 1\.01"),
        (nothing, p, 30, "length 1; in frame 3 that of Hips has length 0"),
        (q, p, math.inf, "frames per second"),
    ):
        with refusal(match):
            Clip(skeleton, rotations, positions, fps)
    for fps in (0.0, math.nan):
        with refusal("cannot resample"):
            Clip(skeleton, q, p, 30).resample(fps)
