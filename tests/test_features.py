"""Features: widths, meaning against slow loops, invariance, errors."""

import math

import pytest
import torch

import toolkit as tk
from toolkit.features import Layout, Normaliser, frames, split_joints, style_clips
from toolkit.motion import root_frames


def test_widths_are_the_papers(walk_clip):
    layout = Layout(walk_clip.skeleton)
    assert (layout.n_joints, layout.n_inputs, layout.n_outputs, layout.n_phases, layout.n_clip) == (25, 348, 342, 8, 300)
    assert layout.parents == (-1, 0, 1, 2, 3, 4, 5, 4, 7, 8, 9, 10, 4, 12, 13, 14, 15, 0, 17, 18, 19, 0, 21, 22, 23)
    assert style_clips(walk_clip).shape[1:] == (240, 300)


def test_rows_against_a_slow_loop(walk_clip):
    rows = frames(walk_clip)
    layout, roots = Layout(walk_clip.skeleton), root_frames(walk_clip)
    position = walk_clip.global_positions[:, list(walk_clip.skeleton.feature_joints)]
    for row in (0, len(rows.index) // 2, len(rows.index) - 1):
        t = int(rows.index[row])
        angle = 2 * math.atan2(float(roots.rotations[t, 2]), float(roots.rotations[t, 0]))

        def local(v, angle=angle):
            x, y, z = (float(c) for c in v)
            return [x * math.cos(angle) - z * math.sin(angle), y, x * math.sin(angle) + z * math.cos(angle)]

        x_joints = split_joints(rows.inputs[row, layout.inputs["joints"]])
        z_joints = split_joints(rows.outputs[row, layout.outputs["joints"]])
        x_window = rows.inputs[row, layout.inputs["trajectory"]].view(12, 4)
        z_window = rows.outputs[row, layout.outputs["trajectory"]].view(6, 4)
        for j in (0, 6, 11, 20):
            assert x_joints["position"][j].tolist() == pytest.approx(local(position[t, j] - roots.positions[t]), abs=1e-4)
            velocity = (position[t, j] - position[t - 1, j]) * 60
            assert x_joints["velocity"][j].tolist() == pytest.approx(local(velocity), abs=1e-3)
            ahead = local(position[t + 1, j] - roots.positions[t])  # the next frame, seen from this one
            assert z_joints["position"][j].tolist() == pytest.approx(ahead, abs=1e-4)
        for i, offset in enumerate(range(-60, 60, 10)):
            ax, _, az = local(roots.positions[t + offset] - roots.positions[t])
            assert x_window[i, :2].tolist() == pytest.approx([ax, az], abs=1e-4)
        for i, offset in enumerate(range(1, 61, 10)):
            ax, _, az = local(roots.positions[t + offset] - roots.positions[t])
            assert z_window[i, :2].tolist() == pytest.approx([ax, az], abs=1e-4)
        assert x_window[6].tolist() == pytest.approx([0, 0, 0, 1], abs=1e-5)


def test_phase_update_leads_to_the_next_phase(walk_clip):
    rows = frames(walk_clip)
    out = Layout(walk_clip.skeleton).unpack_output(rows.outputs)
    assert float((rows.phases + out["phase_updates"] - out["phases"]).abs().max()) < 1e-6
    assert torch.equal(rows.phases[1:], out["phases"][:-1])


def test_features_do_not_change_when_the_character_is_moved_or_turned(walk_clip):
    here, there = frames(walk_clip), frames(walk_clip.moved(turn=-1.2, shift=(4.0, 0.0, 2.0)))
    assert float((here.inputs - there.inputs).abs().max()) < 2e-3
    assert float((here.outputs - there.outputs).abs().max()) < 2e-3


def test_mirroring_twice_gives_the_same_rows(walk_clip):
    here, there = frames(walk_clip), frames(walk_clip.mirrored().mirrored())
    assert float((here.inputs - there.inputs).abs().max()) < 5e-3


def test_mirroring_swaps_sides_and_negates_x(walk_clip):
    layout = Layout(walk_clip.skeleton)
    here, there = frames(walk_clip), frames(walk_clip.mirrored())
    positions = [split_joints(r.inputs[:, layout.inputs["joints"]])["position"] for r in (here, there)]
    skeleton = walk_clip.skeleton
    twins = [layout.names.index(skeleton.names[skeleton.twins[j]]) for j in skeleton.feature_joints]
    assert float((positions[0][:, twins] * torch.tensor([-1.0, 1, 1]) - positions[1]).abs().max()) < 0.01


def test_packing_refuses_what_does_not_fit(walk_clip):
    layout = Layout(walk_clip.skeleton)
    window, joints = torch.zeros(5, 12, 4), torch.zeros(5, 25, 12)
    assert layout.pack_input(trajectory=window, joints=joints).shape == (5, 348)
    with pytest.raises(ValueError, match="expected the blocks trajectory, joints; got joints"):
        layout.pack_input(joints=joints)
    with pytest.raises(ValueError, match="expected the blocks"):
        layout.pack_input(trajectory=window, joints=joints, more=joints)
    with pytest.raises(ValueError, match="block 'joints' needs 300 columns"):
        layout.pack_input(trajectory=window, joints=joints[..., :11])


def test_layout_survives_json(walk_clip):
    layout = Layout(walk_clip.skeleton)
    again = Layout.from_json(layout.to_json())
    assert again == layout
    assert torch.allclose(again.skeleton.offsets, walk_clip.skeleton.offsets)


def test_normaliser_is_exact_where_float32_sums_are_not():
    column = torch.full((200_000, 1), 0.1) + torch.tensor([[1e4]])
    column[::2] += 1.0
    found = Normaliser.of(column[:100_000], column[100_000:])
    assert float(found.mean) == pytest.approx(10000.6, abs=2e-3)
    assert float(found.std) == pytest.approx(0.5, rel=1e-3)
    assert torch.allclose(found.invert(found.apply(column)), column)


def test_a_skeleton_of_another_rig_has_the_same_layout(shared):
    clip = tk.bvh.load(shared / "bandai" / "dataset-1" / "dataset-1_walk_normal_001.bvh").resample(60)
    rows = frames(clip)
    assert rows.inputs.shape[1] == 48 + 12 * 21
    assert rows.outputs.shape[1] == 24 + 12 * 21 + 18
    step = rows.outputs[:, 1].mean() * 60  # the root moves forward, whatever axes the rig uses
    assert 0.5 < float(step) < 2.5


def test_build_labels_rows_by_style(walk_clip):
    clips = [walk_clip, walk_clip.replace(style="Twin", name="twin").mirrored()]
    data = tk.features.build(clip for clip in clips)
    assert data.styles == ["Neutral", "Twin"]
    assert len(data.inputs["Neutral"]) == len(walk_clip) - 111
    assert data.clips["Twin"].shape[1:] == (240, 300)
    assert {len(t) for t in data.takes.values()} == {len(walk_clip) - 111}


def test_bad_clips_are_refused_by_name(walk_clip):
    with pytest.raises(ValueError, match="no clips"):
        tk.features.build([])
    with pytest.raises(ValueError, match="80 frames hold no whole trajectory window"):
        tk.features.build([walk_clip.cut(0, 80)])
    with pytest.raises(ValueError, match="'Neutral' has no clip of 240 frames"):
        tk.features.build([walk_clip.cut(0, 200)])
    with pytest.raises(ValueError, match="features need 60 Hz, the clip has 30"):
        frames(walk_clip.resample(30))
