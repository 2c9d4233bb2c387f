"""Characters do what they are told, and the measures of that see what is wrong."""

import math

import pytest
import torch

import toolkit as tk
from experiments import closed_loop
from toolkit.runtime.life import PERIOD, alive, uniform


@pytest.mark.parametrize(("track", "most"), [
    ("1 m/s", {"direction": 2.0, "toes": 0.5, "raw": 4.0}),
    ("circle", {"toes": 0.5, "raw": 4.0}),
    ("stop", {"still": 0.05, "way": 1.0}), ("stand", {"still": 0.05, "way": 1.0}),
    ("turns", {"toes": 1.0, "knee": 35.0, "wrist": 8.0}),
])  # fmt: skip
def test_characters_do_what_they_are_told(fast, track, most):
    model, bank = fast
    for row in closed_loop.measured(model, bank.select(["Neutral", "Zombie"]), track):
        assert {key: row[key] for key in most if row[key] > most[key]} == {}
        if track == "1 m/s":
            assert row["speed"] == pytest.approx(1.0, abs=0.1)


def test_measures_see_a_slide_a_pop_and_slow_motion(walk_clip):
    good = closed_loop.of_clip(walk_clip)
    frames = torch.arange(len(walk_clip)) / walk_clip.fps
    ahead = torch.stack((0.3 * frames, 0 * frames, 0 * frames), -1)
    contact = tk.contacts.detect(walk_clip)
    slid = tk.Clip(walk_clip.skeleton, walk_clip.rotations, walk_clip.root_positions + ahead, 60)
    assert closed_loop.of_clip(slid, contact)["toes"] - good["toes"] > 20.0
    turned = walk_clip.rotations.clone()
    knee = walk_clip.skeleton.role("left_knee")
    turned[200, knee] = tk.motion.rotations.multiply(
        turned[200, knee], tk.motion.rotations.from_axis_angle(torch.tensor([1.0, 0, 0]),
                                                               torch.tensor(0.3)))
    popped = tk.Clip(walk_clip.skeleton, turned, walk_clip.root_positions, 60)
    assert closed_loop.of_clip(popped)["knee"] > 2 * good["knee"]
    # one joint of the spine leans slowly: 0.2 rad at 8 s a period
    leans = walk_clip.rotations.clone()
    lean = tk.motion.rotations.from_axis_angle(
        torch.tensor([0.0, 0.0, 1.0]), 0.2 * (math.tau * frames / 8).sin())
    leans[:, 1] = tk.motion.rotations.multiply(leans[:, 1], lean)
    leans = tk.Clip(walk_clip.skeleton, leans, walk_clip.root_positions, 60)
    assert closed_loop.slow_motion(leans) > closed_loop.slow_motion(walk_clip) + 0.5


def test_a_style_that_wanders_is_smooth_and_repeatable():
    style = torch.ones(2, 500, dtype=torch.float64)
    assert alive(style, 0.0) is style
    seen = torch.stack([alive(style, 0.2, seed=3)(frame) for frame in range(4 * PERIOD)])
    assert torch.equal(alive(style, 0.2, seed=3)(77), seen[77])
    assert float((seen - 1).mean()) == pytest.approx(0.0, abs=0.01)
    assert float((seen - 1).std()) == pytest.approx(0.2, abs=0.01)
    assert float((seen[1:] - seen[:-1]).abs().max()) < 0.03
    assert abs(float(torch.corrcoef(seen[0] - 1)[0, 1])) < 0.15  # each row has its own seed
    assert uniform(3, 1, 2).tolist() != uniform(3, 2, 1).tolist()
    with pytest.raises(ValueError, match="life must be in"):
        alive(style, 1.0)
