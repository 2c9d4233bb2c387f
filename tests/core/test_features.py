"""Features: widths, meaning against slow loops, invariance, errors."""

import itertools
import math

import numpy as np
import pytest
import torch
import unchanged
from refusal import refusal
from torch.testing import assert_close

import toolkit as tk
from toolkit import features, phases
from toolkit.features import Layout, Normaliser, Rows, frames, moments, split_joints
from toolkit.motion import root_frames


def test_widths_are_the_papers(walk_clip):
    layout = Layout(walk_clip.skeleton)
    assert (layout.n_joints, layout.n_inputs, layout.n_outputs) == (25, 348, 342)
    assert (layout.n_phases, layout.n_clip) == (8, 300)
    assert layout.behind == tuple(range(-60, 0, 10))
    assert layout.ahead == tuple(range(0, 60, 10))
    assert Layout(walk_clip.skeleton, samples=(-60, 0, 10)).n_inputs == 12 + 300
    with refusal(r"^samples .* got \[0, 10\]$"):
        Layout(walk_clip.skeleton, samples=(0, 10))
    assert layout.bone_lengths(torch.zeros(7, 25, 3)).shape == (7, 24)
    legs = (0, 17, 18, 19, 0, 21, 22, 23)
    spine_and_arms = (-1, 0, 1, 2, 3, 4, 5, 4, 7, 8, 9, 10, 4, 12, 13, 14, 15)
    assert layout.parents == spine_and_arms + legs


def test_rows_are_positions_and_velocities_in_the_root_frame(walk_clip):
    walk_clip = walk_clip.moved(turn=-1.2, shift=(4.0, 0.0, 2.0))
    rows = frames(walk_clip)
    layout, roots = Layout(walk_clip.skeleton), root_frames(walk_clip)
    position = walk_clip.global_positions[:, list(walk_clip.skeleton.feature_joints)]
    for row in (0, len(rows.index) // 2, len(rows.index) - 1):
        t = int(rows.index[row])
        angle = 2 * math.atan2(float(roots.rotations[t, 2]), float(roots.rotations[t, 0]))
        c, s = math.cos(angle), math.sin(angle)
        turn = torch.tensor([[c, 0, s], [0, 1, 0], [-s, 0, c]])  # of rows, into the root frame
        x, z = (split_joints(part) for part in (rows.inputs[row, layout.inputs["joints"]],
                                                rows.outputs[row, layout.outputs["joints"]]))
        # the outputs are those of the next frame, seen from this one
        for found, at in ((x, t), (z, t + 1)):
            wanted = (position[at] - roots.positions[t]) @ turn
            assert_close(found["position"], wanted, atol=1e-4, rtol=0)
            wanted = (position[at] - position[at - 1]) * 60 @ turn
            assert_close(found["velocity"], wanted, atol=1e-3, rtol=0)
        path = ((roots.positions - roots.positions[t]) @ turn)[:, ::2]
        x, z = (part.view(-1, 4) for part in (rows.inputs[row, layout.inputs["trajectory"]],
                                              rows.outputs[row, layout.outputs["trajectory"]]))
        for found, first in ((x, t - 60), (z, t + 1)):
            wanted = path[first : t + 60 : 10]
            assert_close(found[:, :2], wanted, atol=1e-4, rtol=0)
        assert x[6].tolist() == pytest.approx([0, 0, 0, 1], abs=1e-5)
    there, updates = (rows.outputs[:, layout.outputs[kind]] for kind in ("phases", "phase_updates"))
    assert_close(rows.phases[1:], there[:-1])
    assert_close(updates, there - rows.phases)


def test_packing_refuses_what_does_not_fit(walk_clip):
    layout = Layout(walk_clip.skeleton)
    window, joints = torch.zeros(5, 48), torch.zeros(5, 300)
    assert layout.pack_input(trajectory=window, joints=joints).shape == (5, 348)
    with refusal("expected the blocks trajectory, joints; got joints"):
        layout.pack_input(joints=joints)


@pytest.mark.parametrize("sizes", [(3, 5), (0, 1), (1, 0), (400, 2, 30)])
def test_a_normaliser_of_parts_is_that_of_their_union(sizes):
    generator = torch.Generator().manual_seed(1)
    parts = [10 * i + (i + 1) * torch.randn(n, 2, generator=generator) for i, n in enumerate(sizes)]
    union = torch.cat(parts).double()
    std = union.std(0, correction=0)
    expected = union.mean(0), torch.where(std > 1e-5, std, 1.0)  # constant: only centred
    for found in (Normaliser.of(*parts), Normaliser.merged(moments(p) for p in parts)):
        for value, right in zip((found.mean, found.std), expected, strict=True):
            assert_close(value.double(), right, rtol=1e-6, atol=0)


def test_rows_are_read_as_those_of_a_tensor():
    table = torch.randn(20, 3, generator=torch.Generator().manual_seed(2))
    at = torch.tensor([4, 7, 2, 19, 0, 11])
    rows, expected = Rows(table.__getitem__, at), table[at]
    mask = torch.tensor([True, False, True, True, False, False])
    assert len(rows) == 6
    for key in (0, -1, slice(1, 5), torch.tensor([5, 0]), torch.tensor(2), mask, slice(0, 0)):
        assert torch.equal(rows[key], expected[key])
    chosen = rows.select(mask)
    assert isinstance(chosen, Rows)
    assert chosen.at.tolist() == [4, 2, 19]
    assert torch.equal(chosen[:], expected[mask])


@pytest.fixture(scope="module")
def two_walks(walk_clip):
    return [walk_clip.cut(0, 250).replace(name="one"),
            walk_clip.cut(200, 450).replace(name="two", gait="BW")]


def test_build_against_a_slow_loop(two_walks):
    """Every clip is followed by its mirror image, which shares its phase axes and its number."""
    clips = [*two_walks, two_walks[0].replace(style="Twin", name="three")]
    data = features.build(clips, source="contact", mirror=lambda clip: clip.name != "two")
    expected = {"Neutral": [], "Twin": []}
    for take in (1, 0, 2):  # gaits in alphabetical order: BW, FW
        clip = clips[take]
        both = [clip] if clip.name == "two" else [clip, clip.mirrored()]
        for c, ph in zip(both, phases.extract_group(both, "contact"), strict=True):
            poses = features.joint_features(c, root_frames(c))
            runs = [poses[i : i + 240] for i in range(0, len(c) - 239, 120)]
            expected[clip.style].append((take, frames(c, ph), torch.stack(runs)))
    assert data.layout == Layout(clips[0].skeleton)
    assert data.styles == ["Neutral", "Twin"]
    assert data.n_frames == 139 * 5
    assert f"frames=695, seconds={139 * 5 / 60:.4g}" in repr(data)
    for style, parts in expected.items():
        takes, rows, clips = zip(*parts, strict=True)
        assert clips[0].shape == (1, 240, 300)
        for kind in ("inputs", "phases", "outputs"):
            known = torch.cat([getattr(some, kind) for some in rows])
            assert_close(getattr(data, kind)[style], known)
        assert torch.equal(data.clips[style], torch.cat(clips))
        assert data.takes[style].tolist() == list(np.repeat(takes, 139))
    original, image = data.frames["Twin"].split(139)
    assert torch.equal(original, image)  # a mirror image has the same numbers


def test_clips_of_one_style_and_gait_share_their_phase_axes(two_walks):
    clips = [clip.replace(gait="FW") for clip in two_walks]
    data = features.build((c.resample(30) for c in clips), source="contact-free")
    again = [c.resample(30).resample(60) for c in clips]
    expected = [ph.vector.flatten(1)[60:-51] for ph in phases.extract_group(again, "contact-free")]
    assert_close(data.phases["Neutral"], torch.cat(expected))


def test_short_clips_are_left_out_where_that_is_asked_for(two_walks, walk_clip):
    short = walk_clip.cut(0, 111)
    data = features.build([short, *two_walks, short], source="contact", short="skip")
    assert sorted(set(data.takes["Neutral"].tolist())) == [1, 2]
    others = [two_walks[0], short.replace(gait="SR")]  # a gait with none
    data = features.build(others, source="contact", short="skip")
    assert data.takes["Neutral"].tolist() == [0] * 139
    others.append(short.replace(style="Brief"))
    with pytest.warns(UserWarning, match=r"^style 'Brief' has no clip of 112 frames .* out$"):
        assert features.build(others, source="contact", short="skip").styles == ["Neutral"]
    with refusal(r"^style 'Neutral' has no clip .* style from$"):
        features.build([short], short="skip")


def test_a_style_with_short_clips_only_has_style_clips_that_repeat(two_walks, walk_clip):
    short, three = (walk_clip.cut(0, n).replace(style=f"{n}") for n in (130, 480))
    data = features.build([short, three, *two_walks], source="contact")
    assert len(data.clips["480"]) == 3  # of 240 frames, every 120
    assert data.clips["130"].shape == (1, 240, 300)
    assert torch.equal(data.clips["130"][0, 130:], data.clips["130"][0, :110])
    clips = [short.replace(style="Neutral"), *two_walks]  # long clips are there
    both = features.build(clips, source="contact")
    assert len(both.clips["Neutral"]) == len(data.clips["Neutral"]) == 2


def test_the_ground_is_where_toes_in_contact_are_also_below_zero(two_walks):
    for height in (0.0, -0.3, 2.5):
        clips = [clip.moved(shift=(0.0, height, 0.0)) for clip in two_walks]
        data = features.build(clips, source="contact")
        assert data.ground() == pytest.approx(min(0.021 + height, 2.0), abs=1e-3)
    flying = features.build(two_walks, source="contact")
    for style, rows in flying.outputs.items():
        flying.outputs[style] = rows[:].clone()
        flying.outputs[style][:, flying.layout.outputs["contacts"]] = 0.0
    assert flying.ground() == pytest.approx(0.02)


def test_bad_clips_are_refused_by_name(walk_clip):
    with refusal(r"^no clips to build features from$"):
        tk.features.build([])
    for make, n in itertools.product((frames, tk.features.build), (111, 80)):
        short = walk_clip.cut(0, n).replace(name="short")
        with refusal(rf"^short: {n} frames hold no whole trajectory window; "
                     r"it takes 60 before and 51 after a frame$"):
            make(short)
    with refusal("features need 60 Hz, the clip has 30"):
        frames(walk_clip.resample(30))
    clips = [walk_clip.replace(name="first"), walk_clip,
             walk_clip.without_ends().replace(name="third")]
    with refusal(r"^third: its joints differ, compared with first; on one skeleton: "):
        tk.features.build(clips)


def test_the_same_file_at_two_scales_is_not_mixed(walk_clip):
    skeleton = walk_clip.skeleton

    def scaled(times):
        other = tk.Skeleton(skeleton.names, skeleton.parents, times * skeleton.offsets)
        return walk_clip.replace(skeleton=other, root_positions=times * walk_clip.root_positions)

    with refusal(r"its bones are 2\.54 times as long; unit= decides"):
        tk.features.build([scaled(1.0), scaled(2.54)])
    assert Layout(scaled(1.0).skeleton) == Layout(scaled(1.15).skeleton)  # a tall person
    assert Layout(scaled(1.0).skeleton) != Layout(scaled(1.7).skeleton)  # another unit
    longer = skeleton.offsets.clone()
    longer[1] += 9  # metres: the first bone counts as the others
    other = tk.Skeleton(skeleton.names, skeleton.parents, longer)
    assert Layout(scaled(1.0).skeleton) != Layout(other)


def test_the_mean_velocity_of_a_style_clip_is_that_of_its_root():
    goes = torch.tensor([[0.1, 1.0], [-0.3, 2.0]])
    velocity = torch.full((2, 240, 3, 3), 9.0)
    velocity[:, :, 0, ::2] = goes[:, None] + torch.linspace(-0.5, 0.5, 240)[:, None]
    clips = features.pack_joints(*torch.zeros(3, 2, 240, 3, 3), velocity)
    assert_close(features.mean_velocity(clips), goes)


def test_the_natural_speed_is_the_median_of_walks_ahead():
    """Of 0.3 and 0.5 m/s; others are slow, go aside, or backwards."""
    goes = torch.tensor([[0.0, 0.3], [0.0, 0.15], [0.3, 0.5], [0.2, 0.5], [0.0, -1.0], [2.0, 3.0]])
    velocity = torch.zeros(6, 240, 1, 3)
    velocity[..., ::2] = goes[:, None, None]
    clips = features.pack_joints(*torch.zeros(3, 6, 240, 1, 3), velocity)
    assert features.natural_speed(clips) == pytest.approx(0.3)
    assert math.isnan(features.natural_speed(clips[1:3]))


@pytest.mark.parametrize(("mirror", "short", "samples"), [
    (False, "raise", tuple(range(-60, 60, 10))),
    (True, "skip", (-45, -5, 0, 7, 40)),
])
def test_features_and_splits_are_what_they_were(walk_clip, zombie, mirror, short, samples):
    """Takes of several lengths, a hop in the air, and rows held out of two styles."""
    flying = zombie.moved(shift=(0.0, 0.4, 0.0)).replace(gait="hop", name="flying")
    clips = [walk_clip.cut(0, 300), walk_clip.cut(90, 203), walk_clip.cut(60, 480), zombie, flying,
             zombie.resample(30).replace(name="slow")]
    options = {"source": "hybrid", "mirror": mirror, "short": short, "samples": samples}
    data = features.build(clips if mirror else [*clips[:1], *clips[2:]], **options)
    kinds = ("inputs", "phases", "outputs", "clips", "takes", "frames", "spans")
    held = features.splits.split(data, 0.2, 5, ("Zombie", "Neutral"))
    found = [[{s: rows[:] for s, rows in (getattr(part, kind) or {}).items()} for kind in kinds]
             for part in (data, *held)]
    for number, part in enumerate(found):
        unchanged.check(f"features, mirror {mirror}: {number}", part)
    unchanged.check(f"ground, mirror {mirror}", data.ground(), near=1e-6)
    unchanged.check(f"normalisers, mirror {mirror}", [*map(vars, data.normalisers().values())])
