"""The recogniser tells styles apart in unseen motion, and is written and read whole."""

import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit.evaluation import recognition

STYLES = ("ArmsAboveHead", "Neutral", "Zombie")


def clips(seed):
    return tk.datasets.procedural.load(STYLES, "FW", 6.0, seed)


@pytest.fixture(scope="module")
def known():
    return clips(0)


@pytest.fixture(scope="module")
def unseen():
    return clips(1)


@pytest.fixture(scope="module")
def recogniser(known):
    return recognition.train(tk.features.build(known), steps=30)


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


def test_it_recognises_what_a_model_makes(recogniser, fast):
    model, bank = fast
    vectors = torch.stack([bank[style] for style in STYLES])
    states = list(tk.runtime.states(model, tk.runtime.straight(1.0, 3.0), vectors))[90:]
    found = recogniser.probabilities(torch.stack([s.joints for s in states], 1))
    assert found.argmax(-1).tolist() == [0, 1, 2]
    assert recogniser.of_clip(tk.runtime.record(model, states, character=1)).argmax() == 1


def test_the_same_seed_gives_the_same_recogniser(known):
    data = tk.features.build(known)
    a, b, c = (recognition.train(data, seed, steps=2) for seed in (0, 0, 1))
    y = data.clips["Zombie"]
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
