"""The experiment one step ahead: the rank of a style."""

import pytest

import toolkit as tk
from experiments import one_step


def test_styles_are_ranked_by_the_error_of_one_step(small_run, walk_clip, monkeypatch):
    monkeypatch.setattr(one_step, "EVERY", 1)
    model, bank = small_run
    errors, floors = one_step.ranked(model, bank, walk_clip, (100, 200))
    assert list(errors.values()) == sorted(errors.values())
    for name in bank.names:
        own = tk.published.one_step(model, bank, walk_clip, name, (100, 200))
        assert errors[name] == pytest.approx(own["joint_mse"], rel=1e-4)
    assert 0 < floors["repeat"] < floors["mean"]
