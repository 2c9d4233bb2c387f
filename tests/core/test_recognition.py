"""The recogniser tells styles apart in unseen motion, and is written and read whole."""

import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit.evaluation import recognition

STYLES = ("ArmsAboveHead", "Neutral", "Zombie")


def clips(seed):
    return tk.datasets.procedural.load(STYLES, "FW", 5.0, seed)


@pytest.fixture(scope="module")
def known():
    return tk.features.build(clips(0))


@pytest.fixture(scope="module")
def unseen():
    return clips(1)


@pytest.fixture(scope="module")
def recogniser(known):
    return recognition.train(known, steps=20)


def test_it_recognises_motion_that_it_has_not_seen(recogniser, unseen):
    data = tk.features.build(unseen)
    assert recogniser.styles == STYLES
    assert recogniser.accuracy(data) == 1.0
    noise = torch.Generator().manual_seed(0)
    for i, style in enumerate(STYLES):
        p = recogniser.probabilities(data.clips[style])
        torch.testing.assert_close(p.sum(-1), torch.ones(len(p)))
        assert p[:, i].mean() > 0.8
        noisy = data.clips[style] + 0.02 * torch.randn(
            data.clips[style].shape, generator=noise
        )  # 2 cm, 2 cm/s
        assert (recogniser.probabilities(noisy).argmax(-1) == i).all()
    both = torch.cat([data.clips[style][0] for style in STYLES[1:]])  # half of each of two styles
    p = recogniser.probabilities(both)
    assert 0.25 < float(p[1]) < 0.75
    assert p[1:].sum() > 0.8


def test_the_same_seed_gives_the_same_recogniser(known):
    a, b, c = (recognition.train(known, seed, steps=2) for seed in (0, 0, 1))
    y = known.clips["Zombie"]
    assert torch.equal(a.probabilities(y), b.probabilities(y))
    assert not torch.equal(a.probabilities(y), c.probabilities(y))


def test_round_trip(recogniser, tmp_path):
    path = tmp_path / "recogniser.safetensors"
    recogniser.save(path)
    again, y = recognition.Recogniser.load(path), torch.randn(2, 75, len(recogniser.mean))
    assert again.styles == recogniser.styles
    assert torch.equal(again.probabilities(y), recogniser.probabilities(y))
    tk.styles.StyleBank(("a",), torch.zeros(1, 3)).save(path)
    with refusal("expected 'recogniser' in it, got bank"):
        recognition.Recogniser.load(path)
