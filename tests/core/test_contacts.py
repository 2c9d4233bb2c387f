"""Contacts of procedural walks, whose truth is known, on floors that drift and under odd toes."""

import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.motion import contacts
from toolkit.motion.rotations import identity


def f1(found, true):
    return float(2 * (found * true).sum() / (found + true).sum())


def lifted(clip, heights):
    positions = clip.root_positions.clone()
    positions[:, 1] += heights
    return clip.replace(root_positions=positions)


@pytest.mark.parametrize("style", ["Neutral", "Zombie", "Tiptoe", "HopLeft"])
@pytest.mark.parametrize("drift", [0.0, 0.03, -0.1, 0.4])
def test_a_floor_that_drifts(style, drift):
    clip, truth = procedural.truth(style, "FW", 12.0, 1)
    moved = lifted(clip, torch.linspace(0, drift, len(clip)) - 3.0)
    feet = [i for i in range(2) if truth.contacts[:, i].mean() > 0.1]
    assert f1(contacts.detect(moved)[:, feet], truth.contacts[:, feet]) > 0.96
    floor = contacts.floor_height(moved)
    assert float(floor[-1] - floor[0]) == pytest.approx(drift, abs=0.01)


def test_a_toe_whose_height_varies_from_step_to_step():
    """As with a marker on the toe; d_max of the paper leaves out most of such a step."""
    clip, truth = procedural.truth("Neutral", "FW", 12.0, 2)
    seconds = torch.arange(len(clip)) / clip.fps
    moved = lifted(clip, 0.022 * torch.sin(2 * torch.pi * 0.31 * seconds))
    assert f1(contacts.detect(moved), truth.contacts) > 0.9
    assert f1(contacts.detect(moved, height=contacts.HEIGHT), truth.contacts) < 0.75


def walked(heights, speeds, fps=60.0):
    """A right toe at these heights, metres, with these speeds along z; the left toe is high."""
    skeleton = tk.Skeleton(("root", "right", "left"), (-1, 0, 0),
                           torch.tensor([[0.0, 0, 0], [0, 0, 0], [0, 1, 0]]),
                           {"right_toe": "right", "left_toe": "left"}, ())
    places = torch.zeros(len(heights), 3)
    places[:, 1], places[:, 2] = heights, (speeds / fps).cumsum(0)
    return tk.Clip(skeleton, identity(len(heights), 3), places, fps)


def stands(clip, frame, **limits):
    return bool(contacts.detect(clip, **limits)[frame, 0])


@pytest.mark.parametrize(("fps", "fewest"), [(60.0, 6), (66.0, 7), (30.0, 3), (12.0, 2)])
def test_the_majority_of_a_sixth_of_a_second_decides(fps, fewest):
    for frames in (fewest - 1, fewest):
        speeds = torch.ones(60)
        speeds[30 : 30 + frames] = 0.0
        assert stands(walked(torch.zeros(60), speeds, fps), 30 + frames // 2) == (frames == fewest)


@pytest.mark.parametrize(("frames", "rises", "speeds", "limits"), [
    (30, (0.059, 0.061), (0, 0), {"height": 0.05}),  # d_max and the thickness of the floor
    (30, (0, 0), (0.14, 0.16), {}),
    (50, (0.055, 0.065), (0, 0), {}),  # higher toes are lifted ones
    (10, (0.019, 0.021), (0, 0), {}),  # the height follows from the clip: 1 cm, and the floor
])
def test_a_standing_toe_is_low_and_slow(frames, rises, speeds, limits):
    """In less than four seconds the floor is level: the 5th percentile of the toe's heights."""
    for rise, speed, found in zip(rises, speeds, (True, False), strict=True):
        series = torch.zeros(2, 230)
        series[:, 100 : 100 + frames] = torch.tensor([[rise], [speed]])
        assert stands(walked(*series), 100 + frames // 2, **limits) == found


@pytest.mark.parametrize("height", [1.01, -1.01, torch.nan])
def test_a_height_that_no_toe_has_is_refused(height):
    with refusal("must be from -1 to 1 metres, got"):
        contacts.detect(walked(torch.zeros(9), torch.zeros(9)), height=height)


@pytest.mark.parametrize(("rise", "level"), [(0.017, True), (0.024, False), (0.4, False)])
def test_a_floor_that_rises_by_less_than_two_centimetres_is_level(rise, level):
    frames = 270 if rise == 0.4 else 720
    clip = walked(torch.linspace(0, rise, frames) - 3.0, torch.ones(frames))
    floor = contacts.floor_height(clip)
    assert float(floor[-1] - floor[0]) == pytest.approx(0.0 if level else rise, abs=1e-4)
    assert float(floor[0]) == pytest.approx(-3.0, abs=2e-3)
    assert float(contacts.standing_height(clip)) == pytest.approx(0.05 * rise - 3.0, abs=1e-4)


def test_a_floor_of_stairs_is_level_and_goes_through_the_lowest_step():
    """A line through these steps would rise by more than 2 cm, but fit hardly better."""
    steps = torch.tensor([0.31, 0.12, 0.35, 0.0, 0.2, 0.14, 0.38, 0.16, 0.4, 0.11, 0.36, 0.3])
    clip = walked(steps.repeat_interleave(60), torch.ones(720))
    assert contacts.floor_height(clip).tolist() == pytest.approx([0.0] * 720, abs=1e-6)


def test_the_floor_is_the_twentieth_lowest_of_a_hundred_above_its_slope():
    """Heights of 0 to 99 mm over a slope; the lowest of each part rises by another millimetre."""
    up = torch.arange(100).view(20, 5).T.flatten() / 1000
    found = contacts.floor_line(up + torch.arange(100) / 1000, 20, 0.02)
    slope = torch.arange(100) * float(found[1] - found[0])
    assert float(found[1] - found[0]) == pytest.approx(0.001 + 0.001 / 20, abs=1e-6)
    above = up + torch.arange(100) / 1000 - slope
    assert float(found[0]) == pytest.approx(float(above.quantile(0.05)), abs=1e-6)


def test_two_frames_have_a_velocity_and_one_has_none():
    places = torch.tensor([[1.0, 2.0], [1.5, 2.0]])
    assert contacts.velocities(places, 60.0).tolist() == [[30.0, 0.0]] * 2
    assert contacts.velocities(places[:1], 60.0).tolist() == [[0.0, 0.0]]
