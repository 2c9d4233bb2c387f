"""No damage of a motion is invisible: each moves a row of the table, the more the larger it is."""

import damages
import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit.evaluation import recognition, report, table

STYLES = ("Neutral", "Zombie", "Strut")


def walks(seed):
    return tk.datasets.procedural.load(STYLES, "FW", 5.0, seed)


@pytest.fixture(scope="module")
def real():
    return [*walks(0), *walks(1)]


@pytest.fixture(scope="module")
def other():
    return walks(3)


@pytest.fixture(scope="module")
def judge():
    return recognition.train(tk.features.build(walks(2)), steps=10)


# damage, sizes, the row that sees it
SEEN = [
    (damages.noise, (0.3, 1.0, 3.0), "jerk"),
    (damages.shaken, (0.002, 0.005, 0.02), "shake"),
    (damages.carried, (0.1, 0.3, 1.0), "skate"),
    (damages.leg, (0.01, 0.02, 0.04), "floor"),
    (damages.leg, (-0.01, -0.02, -0.04), "floor"),
    (damages.frozen, (0.2, 0.5, 1.0), "motion"),
    (damages.through, (0.8, 0.9, 1.0), "through"),
    (damages.slowed, (0.9, 0.7, 0.5), "speed"),
    (damages.shortened, (0.9, 0.7, 0.5), "seconds"),
]


@pytest.mark.parametrize(("damage", "sizes", "row"), SEEN)
def test_each_damage_moves_a_row_the_more_the_larger_it_is(other, damage, sizes, row):
    walk = other[0]
    rows = report({str(size): damage(walk, size) for size in sizes}, walk).rows
    *damaged, whole = (one[row] for one in rows)
    moved = [abs(value - whole) for value in damaged]
    assert moved == sorted(moved)
    assert moved[0] > 0.05 * abs(whole)


def test_other_real_clips_are_like_real_ones_and_copies_are_not(real, other, judge):
    made = {
        "other": other,
        "copies": [damages.noise(clip, 0.3) for clip in real[:3]],
        "wrong": [clip.replace(style="Zombie") for clip in other if clip.style != "Zombie"],
    }
    found = report(made, real, judge)
    other, copies, wrong, truth = found.rows
    for row in ("skate", "jerk", "motion", "speed"):
        assert other[row] == pytest.approx(truth[row], rel=0.2)
        low, high = found.intervals["real"][row]
        assert low <= truth[row] <= high
    assert copies["nearest"] < 0.8 * min(other["nearest"], truth["nearest"])
    assert wrong["recognition-top1"] < 0.5 < other["recognition-top1"]
    assert "needs more windows" in " ".join(found.notes)


def test_arrays_are_measured_beside_clips_and_their_bones_may_stretch(real, judge):
    clips = real[:3]
    arrays = [clip.global_positions for clip in clips]
    stretched = [positions * torch.linspace(1, 1.2, len(positions))[:, None, None]
                 for positions in arrays]
    found = report({"same": arrays, "numpy": arrays[0].numpy(), "stretched": stretched}, clips)
    same, one, longer, truth = found.rows
    for row in table.CLIP:
        assert same[row] == pytest.approx(truth[row], rel=1e-4, abs=1e-6)
    assert one["n"] == 1
    assert longer["stretch"] > 0.005 > same["stretch"]
    paired = report(arrays, clips, judge).rows[0]
    assert paired["global-position"] == pytest.approx(0.0, abs=1e-6)
    assert paired["geodesic"] != paired["geodesic"] != paired["fmd"]
    with refusal("need real clips"):
        report(arrays)
    with refusal(r"expected joints \[F, 28, 3\], got \[300, 2, 3\]"):
        report(arrays[0][:, :2], clips)


def test_hips_that_go_on_where_the_real_ones_stand():
    stand = tk.datasets.procedural.generate("Neutral", "ID", 3.0)
    assert tk.metrics.stop(damages.carried(stand, 0.4), stand) == pytest.approx(0.4, abs=0.02)
    assert tk.metrics.stop(stand, stand) < 0.05
    walk = walks(0)[0].cut(0, 180)
    assert tk.metrics.stop(walk, walk) != tk.metrics.stop(walk, walk)  # nobody stands
