"""The toy of the five losses: points, judge, switches, and what each loss is for."""

import pytest
import torch
from course import plane

from toolkit.stylization.losses import LOSSES


def test_the_judge_accepts_points_of_the_domain_and_no_other():
    places = torch.rand(50, 2)
    for domain in (0, 1):
        assert plane.outside(plane.points(domain, places), domain).max() < 1e-9
        assert plane.outside(plane.points(1 - domain, places), domain).min() > 0.5


def test_switches_are_all_sets_of_losses_and_unknown_ones_are_refused():
    assert len(set(plane.SWITCHES)) == 2 ** len(LOSSES)
    assert plane.SWITCHES[0] == LOSSES
    assert plane.SWITCHES[-1] == ()
    with pytest.raises(ValueError, match="unknown losses xyz"):
        plane.Toy([("adv", "xyz")])


def test_without_adv_nothing_is_accepted_and_without_ds_noises_are_alike():
    sets = [LOSSES, tuple(x for x in LOSSES if x != "adv"), tuple(x for x in LOSSES if x != "ds")]
    found = {
        name: value.view(3, 3).mean(0)
        for name, value in plane.Toy(sets * 3, seed=4).train(500).measures().items()
    }
    assert found["inside"][0] > 0.7 > 0.3 > found["inside"][1]
    assert found["spread"][0] > 5 * found["spread"][2]
    assert found["content"][0] > 0.9


def test_the_same_seed_gives_the_same_toy():
    one, two = (plane.Toy([LOSSES], seed=3).train(20).results()[1] for _ in range(2))
    assert torch.equal(one, two)
