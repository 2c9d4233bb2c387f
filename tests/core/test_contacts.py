"""Contacts of procedural walks, whose truth is known, on floors that drift and under odd toes."""

import pytest
import torch

import toolkit as tk
from toolkit.datasets import procedural
from toolkit.motion import contacts


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


def test_a_raised_foot_does_not_stand():
    clip, truth = procedural.truth("HopLeft", "ID", 6.0, 0)
    raised = int(truth.contacts.mean(0).argmin())
    assert truth.contacts[:, raised].mean() < 0.02
    assert contacts.detect(clip)[:, raised].mean() < 0.02


def test_real_walks_stand_for_as_long_as_people_do(shared):
    """Of a step, a toe is at rest for 0.3 to 0.5 of the frames, whatever the rig."""
    for name in (
        "pymo__AV_8Walk_Meredith_HVHA_Rep1.bvh",
        "pybvh__cmu_12_01_walk.bvh",
        "bvh-toolbox__walk01.bvh",
    ):
        clip = tk.load(shared / "foreign" / name)
        new, old = (
            float(contacts.detect(clip, **limits).mean()) for limits in ({}, {"height": 0.01})
        )
        assert 0.3 <= new <= 0.5, name
        assert old < new
