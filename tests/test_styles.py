import pytest
import torch

from toolkit.styles import StyleBank

BANK = StyleBank(("Neutral", "Zombie", "Old"), torch.eye(3))


def test_vectors_by_name():
    assert torch.equal(BANK["Zombie"], torch.tensor([0.0, 1.0, 0.0]))
    assert (len(BANK), list(BANK), "Old" in BANK, "Young" in BANK) == (3, ["Neutral", "Zombie", "Old"], True, False)


def test_unknown_style_lists_close_names():
    with pytest.raises(ValueError, match="unknown style 'zombi'; close to it: Zombie"):
        BANK["zombi"]
    with pytest.raises(ValueError, match="unknown style 'xyz'; there is Neutral, Zombie, Old"):
        BANK.blend({"xyz": 1.0})


def test_blend_is_barycentric():
    torch.testing.assert_close(BANK.blend({"Zombie": 0.5, "Old": 0.3, "Neutral": 0.2}), torch.tensor([0.2, 0.5, 0.3]))
    torch.testing.assert_close(BANK.blend({"Zombie": 1.5, "Old": -0.5}), torch.tensor([0.0, 1.5, -0.5]))
    BANK.blend({"Zombie": 0.50005, "Old": 0.5})


@pytest.mark.parametrize("weights", [{}, {"Zombie": 0.5}, {"Zombie": 0.6, "Old": 0.6}, {"Zombie": 1.0002}])
def test_weights_must_sum_to_one(weights):
    with pytest.raises(ValueError, match="must sum to 1, got"):
        BANK.blend(weights)


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_weights_must_be_finite(bad):
    with pytest.raises(ValueError, match="weight of style 'Zombie' must be finite"):
        BANK.blend({"Zombie": bad, "Old": 1.0})


def test_add_makes_a_new_bank():
    more = BANK.add("Star", torch.ones(3)).add("Old", torch.zeros(3))
    assert more.names == ("Neutral", "Zombie", "Old", "Star")
    assert torch.equal(more["Star"], torch.ones(3))
    assert torch.equal(more["Old"], torch.zeros(3))
    assert len(BANK) == 3
    with pytest.raises(ValueError, match=r"style 'Bad' needs a vector \[3\], got \[4\]"):
        BANK.add("Bad", torch.ones(4))


def test_construction_is_checked():
    with pytest.raises(ValueError, match="2 styles need vectors"):
        StyleBank(("a", "b"), torch.zeros(3, 4))
    with pytest.raises(ValueError, match="repeat: a"):
        StyleBank(("a", "a"), torch.zeros(2, 4))
    with pytest.raises(ValueError, match="vector of b is not finite"):
        StyleBank(("a", "b"), torch.tensor([[0.0], [float("nan")]]))


def test_round_trip(tmp_path):
    BANK.save(tmp_path / "bank.safetensors")
    again = StyleBank.load(tmp_path / "bank.safetensors")
    assert again.names == BANK.names
    assert torch.equal(again.vectors, BANK.vectors)
    with pytest.raises(ValueError, match=r"nothing.safetensors: cannot be read"):
        StyleBank.load(tmp_path / "nothing.safetensors")
