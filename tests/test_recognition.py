"""The recogniser tells styles apart in motion that it has not seen, and is written and read whole."""

import pytest
import torch

import toolkit as tk
from toolkit.evaluation import recognition

STYLES, GAITS = ("ArmsAboveHead", "Crouch", "Neutral", "Zombie"), ("FW", "TR1")


@pytest.fixture(scope="module")
def recogniser():
    clips = tk.datasets.load("procedural", styles=STYLES, gaits=GAITS, seconds=12.0, seed=0)
    return recognition.train(tk.features.build(clips), steps=60)


def test_it_recognises_motion_along_other_paths(recogniser):
    unseen = tk.features.build(tk.datasets.load("procedural", styles=STYLES, gaits=GAITS, seconds=8.0, seed=1))
    assert recogniser.styles == STYLES
    assert recogniser.accuracy(unseen) == 1.0
    confusion = recogniser.confusion(unseen)
    torch.testing.assert_close(confusion.sum(1), torch.ones(4))
    assert float(confusion.diagonal().min()) > 0.9


def test_it_recognises_what_a_model_makes(recogniser):
    model, bank = tk.pretrained()
    vectors = torch.stack([bank[style] for style in STYLES])
    states = list(tk.runtime.states(model, tk.runtime.straight(1.0, 3.0), vectors))
    found = recogniser.probabilities(torch.stack([s.joints for s in states[90:]], 1))
    assert found.argmax(-1).tolist() == [0, 1, 2, 3]
    clip = tk.runtime.record(model, states[90:], character=1)
    assert recogniser.of_clip(clip).argmax() == 1


def test_half_the_data_of_two_styles_is_not_one_of_them(recogniser):
    data = tk.features.build(tk.datasets.load("procedural", styles=STYLES[2:], gaits="FW", seconds=8.0, seed=2))
    both = torch.cat([data.clips[style][0] for style in STYLES[2:]])
    p = recogniser.probabilities(both)
    assert 0.3 < float(p[2]) < 0.7
    assert float(p[2:].sum()) > 0.9


def test_small_noise_changes_nothing(recogniser):
    data = tk.features.build(tk.datasets.load("procedural", styles=STYLES, gaits="FW", seconds=8.0, seed=3))
    noise = torch.Generator().manual_seed(0)
    for i, style in enumerate(STYLES):
        clips = data.clips[style]
        p = recogniser.probabilities(clips + 0.02 * torch.randn(clips.shape, generator=noise))  # 2 cm, 2 cm/s
        assert (p.argmax(-1) == i).all()


def test_the_same_seed_gives_the_same_recogniser():
    data = tk.features.build(tk.datasets.load("procedural", styles=STYLES[2:], gaits="FW", seconds=8.0))
    a, b, c = (recognition.train(data, seed, steps=3) for seed in (0, 0, 1))
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
    with pytest.raises(ValueError, match="expected a recogniser in it, got bank"):
        recognition.Recogniser.load(path)


def test_what_it_cannot_judge_is_refused(recogniser):
    columns = len(recogniser.mean)
    with pytest.raises(ValueError, match=rf"with at least 60 frames F, got \[59, {columns}\]"):
        recogniser.probabilities(torch.zeros(59, columns))
    with pytest.raises(ValueError, match=rf"\[\.\.\., F, {columns}\]"):
        recogniser.probabilities(torch.zeros(60, 12))
    one = tk.features.build(tk.datasets.load("procedural", styles="Zombie", gaits="FW", seconds=6.0))
    with pytest.raises(ValueError, match="at least two styles, got Zombie"):
        recognition.train(one)
