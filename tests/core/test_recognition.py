"""The recogniser follows from its seed, and is written and read whole.

That it tells styles apart in unseen motion is seen in test_report.py.
"""

import pytest
import torch

import toolkit as tk
from toolkit.evaluation import recognition

STYLES = ("ArmsAboveHead", "Neutral", "Zombie")


@pytest.fixture(scope="module")
def known():
    return tk.features.build(tk.datasets.procedural.load(STYLES, "FW", 5.0))


def test_the_same_seed_gives_the_same_recogniser(known):
    a, b, c = (recognition.train(known, seed, steps=2) for seed in (0, 0, 1))
    y = known.clips["Zombie"]
    assert torch.equal(a.probabilities(y), b.probabilities(y))
    assert not torch.equal(a.probabilities(y), c.probabilities(y))


def test_round_trip(known, tmp_path):
    path, made = tmp_path / "recogniser.safetensors", recognition.train(known, steps=2)
    made.save(path)
    again, y = recognition.Recogniser.load(path), torch.randn(2, 75, len(made.mean))
    assert again.styles == made.styles == STYLES
    assert torch.equal(again.probabilities(y), made.probabilities(y))
