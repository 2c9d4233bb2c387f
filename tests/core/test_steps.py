"""The steps of a foot and the phase that they give; phases that a person labelled."""

import math
from dataclasses import replace

import numpy as np
import pytest
import torch
from course import labels
from refusal import refusal

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.phases import Steps, steps

FPS = 60.0


def curve(*lengths, first=1.0):
    """A 0/1 curve of runs of the given lengths."""
    values = [first if i % 2 == 0 else 1 - first for i in range(len(lengths))]
    return torch.tensor(values, dtype=torch.float64).repeat_interleave(torch.tensor(lengths))


def degrees(signal):
    return np.degrees(np.unwrap(signal.angle().numpy()))


def test_in_a_regular_walk_the_angle_is_a_clock_from_one_stance_to_the_next():
    signal = steps.signal(curve(5, 8, 12, 8, 12, 8, 12, 8, 4))  # stances are 0.6 of the cycle
    assert torch.allclose(signal.abs(), torch.ones(77, dtype=torch.float64))
    at = torch.arange(77, dtype=torch.float64) - 18.5  # from the middle of the first stance
    clock = torch.exp(2j * math.pi * at / 20)
    assert (signal - clock).abs().max() < 1e-9


@pytest.mark.parametrize("first", [0.0, 1.0])
def test_every_step_is_counted_however_irregular(first):
    lengths = (6, 7, 9, 11, 13, 7, 13, 5)
    angle = degrees(steps.signal(curve(*lengths, first=first)))
    edges = np.cumsum((0, *lengths))
    inner = range(1, len(lengths) - 1)
    middle = {i: (edges[i] + edges[i + 1] - 1) / 2 for i in inner}
    for i in inner:
        beside = np.mean([lengths[j] for j in (i - 1, i + 1) if j in inner])
        stands = (i % 2 == 0) == (first == 1)
        share = (lengths[i] if stands else beside) / (lengths[i] + beside)
        expected = (0 if stands else 180) + 60 * (share - 0.6)
        found = np.interp(middle[i], range(len(angle)), angle)
        assert math.remainder(found - expected, 360) == pytest.approx(0, abs=1e-6)
    assert (np.diff(angle) > 0).all()
    grown = np.ptp(np.interp([middle[1], middle[6]], range(len(angle)), angle))
    assert grown == pytest.approx(5 * 180, abs=30)


def test_a_foot_that_stands_on_holds_its_phase_and_goes_on_as_before():
    angle = degrees(steps.signal(curve(6, 8, 12, 8, 112, 8, 12, 8, 6)))
    waiting = np.diff(angle)[34 + 10 : 34 + 100]
    assert np.abs(waiting).max() < 1e-9
    before, after = angle[:40], angle[-40:]
    assert np.diff(before).min() > 10  # 360° in about 20 frames, all the way to the ends
    assert np.diff(after).min() > 10
    assert angle[-1] - angle[0] == pytest.approx(360 + 18 * (179 - 96 - 24), abs=40)


@pytest.mark.parametrize("values", [curve(10, 10, 10), 0.5 * curve(5, 5, 5, 5, 5), torch.zeros(20)])
def test_other_curves_and_fewer_than_three_changes_give_no_signal(values):
    assert steps.signal(values) is None


def disturbed(clip):
    """The clip with what recordings have, by name."""
    frames = len(clip)
    noise = 1e-3 * torch.randn(frames, 3, generator=torch.Generator().manual_seed(0))
    spikes = torch.zeros(frames, 3)
    spikes[100::250] = 0.4
    seconds = torch.arange(frames)[:, None] / clip.fps
    drift = 3 + 0.03 * seconds * torch.tensor([0.0, 1.0, 0.0])
    slide = 0.1 * seconds * torch.tensor([1.0, 0.0, 0.0])
    moves = {"noise": noise, "spikes": spikes, "drift of the floor": drift, "sliding": slide}
    roots = clip.root_positions
    return {name: clip.replace(root_positions=roots + move) for name, move in moves.items()}


@pytest.mark.parametrize("style", ["Neutral", "HighKnees", "Tiptoe"])
def test_stances_are_the_true_ones_on_any_floor_in_noise_and_while_sliding(style):
    clip, known = procedural.truth(style, "FW", 8.0, 4)
    for what, other in {"itself": clip, **disturbed(clip)}.items():
        found = torch.stack([Steps()(other, f"{side}_foot") for side in ("right", "left")], 1)
        assert found.dtype == clip.rotations.dtype
        found, true = found[30:-30], known.contacts[30:-30]
        f1 = 2 * (found * true).sum(0) / (found + true).sum(0)
        assert f1.min() > 0.91, what
        starts = (x.diff(dim=0).gt(0).sum(0) for x in (found, true))
        assert torch.equal(*starts), what


def test_stances_do_not_depend_on_the_unit_the_place_or_the_side(walk_clip):
    right = Steps()(walk_clip, "right_foot")
    skeleton = walk_clip.skeleton
    large = walk_clip.replace(skeleton=replace(skeleton, offsets=100 * skeleton.offsets),
                              root_positions=100 * walk_clip.root_positions)
    assert torch.equal(Steps()(large, "right_foot"), right)
    moved = walk_clip.moved(turn=2.0, shift=(3.0, 5.0, -1.0))
    assert torch.equal(Steps()(moved, "right_foot"), right)
    assert torch.equal(Steps()(walk_clip.mirrored(), "left_foot"), right)
    assert float(Steps()(walk_clip, "left_hand").abs().max()) == 0
    assert Steps()(walk_clip.cut(0, 1), "left_foot").abs().max() <= 1
    slow = Steps()(walk_clip.resample(12), "right_foot")  # no filter is shorter than a frame
    assert (slow - right[::5][: len(slow)]).abs().mean() < 0.1


def test_a_leg_without_bones_is_refused(walk_clip):
    skeleton = walk_clip.skeleton
    roles = {**skeleton.roles, "left_hip": skeleton.roles["right_hip"]}
    mixed = replace(skeleton, roles=roles)
    with refusal(r"left_foot: 0 m of bones from .*; check the roles"):
        steps.leg_length(mixed, "left")


@pytest.mark.parametrize("gait", ["FW", "ID"])
def test_a_raised_foot_never_stands(gait):
    clip = procedural.generate("HopLeft", gait, 6.0, 2)
    assert float(Steps()(clip, "right_foot").max()) == 0
    assert Steps()(clip, "left_foot").mean() > 0.3
    assert tk.phases.Hybrid().choice(clip, "right_foot") == "contact-free"


def test_labelled_recordings_are_followed(shared):
    """Holden et al. 2017: every take in the folder, as it is and at another rate."""
    folder = shared / labels.NAME
    if not folder.is_dir():
        pytest.skip(f"needs {folder}")
    for take in labels.read(folder):
        error, floor = labels.errors(take, "hybrid"), labels.floor(take)
        assert error.max() < 20
        assert (error - floor).max() < 10
        assert error.mean() < float(labels.errors(take, "contact").mean()) - 3
        clip, every = take.clip.resample(30.0), round(take.clip.fps / 30.0)
        moving = take.moving[::every][: len(clip)]
        slow = labels.Take(clip, take.right / every, take.left / every, moving)
        assert labels.errors(slow, "hybrid").max() < 20
