"""Experiments one step ahead: the rank of a style, the forms of calibration, and where swing clearance is lost."""

import math

import pytest
import torch

import toolkit as tk
from experiments import calibration, one_step, swing
from toolkit.networks.experts import BlendedLinear
from toolkit.networks.film import Film


def test_styles_are_ranked_by_the_error_of_one_step(small_run, walk_clip, monkeypatch):
    monkeypatch.setattr(one_step, "EVERY", 1)
    model, bank = small_run
    errors, floors = one_step.ranked(model, bank, walk_clip, (100, 200))
    assert list(errors.values()) == sorted(errors.values())
    for name in bank.names:
        own = tk.published.one_step(model, bank, walk_clip, name, (100, 200))
        assert errors[name] == pytest.approx(own["joint_mse"], rel=1e-4)
    assert 0 < floors["repeat"] < floors["mean"]


def test_cheap_calibration_equals_the_network_where_nothing_is_left_to_calibrate():
    """Without variance the deviation alone changes nothing; of one expert, the square of the blend is that of the expert."""
    film, f, style = Film(6, None), torch.randn(5, 6), torch.randn(24)
    still = calibration.deviation_only(film, 1, f, style, torch.zeros(5, 6))
    torch.testing.assert_close(still, film(1, f, style))
    moved = calibration.deviation_only(film, 1, f, style, torch.ones(5, 6))
    assert float((moved - still).abs().max()) > 0.01
    linear, x, gates = BlendedLinear(3, 4, 6).requires_grad_(False), torch.randn(5, 4), torch.eye(3)[[0, 1, 2, 0, 1]]
    torch.testing.assert_close(calibration.squares_of_experts(linear, x, gates), linear.scatter(x, gates))
    half = torch.full((5, 3), 1 / 3)
    assert float((calibration.squares_of_experts(linear, x, half) - linear.scatter(x, half)).min()) > 0


def test_swing_of_toes_whose_heights_are_known():
    """Two swings of 6 and 10 cm of each toe, which stands at 2 cm: 8 cm on average."""
    t = torch.arange(30) / 30
    bump = (math.pi * t).sin()
    stand = torch.zeros(20)
    toe = 0.02 + torch.cat((stand, 0.06 * bump, stand, 0.10 * bump, stand))
    contacts = torch.cat((stand + 1, 0 * bump, stand + 1, 0 * bump, stand + 1))
    found = swing.swing(toe[:, None].repeat(1, 2), contacts[:, None].repeat(1, 2))
    assert found["clearance"] == pytest.approx(0.08, abs=1e-4)
    assert found["swings"] == 4
    assert found["speed"] == pytest.approx(0.10 * math.pi * 2, rel=0.15)


def test_the_embedded_model_keeps_the_swing_of_a_procedural_walk():
    """One step ahead, and with the phases, the embedded model predicts a procedural walk's clearance to a fifth."""
    model, bank = tk.pretrained()
    walk = tk.datasets.load("procedural", styles=["Neutral"], gaits=["FW"], seconds=4.0)[0]
    real, found = swing.feedback(model, bank["Neutral"], walk, 0)
    assert list(found) == list(swing.FED)
    assert real["clearance"] > 0.05
    for name in ("nothing: one step ahead", "phases"):
        assert found[name]["clearance"] == pytest.approx(real["clearance"], rel=0.2)
