"""Characters do what they are told, and a style that wanders does so as it says."""

import pytest
import torch

import toolkit as tk
from experiments import obedience
from toolkit.runtime.life import PERIOD, alive, uniform


@pytest.fixture(scope="module")
def embedded():
    model, bank = tk.pretrained()
    return model, bank.select(["Neutral", "Zombie"])


def test_styles_walk_where_they_are_told_and_stop(embedded):
    walked = obedience.measured(*embedded, "1 m/s", 0.0, 0)
    assert float(walked["direction"][0].max()) < 2.0
    assert float(walked["toes in contact, three dimensions"][0].max()) < 0.5
    assert float((walked["speed / command"][0] - 1).abs().max()) < 0.1
    stopped = obedience.measured(*embedded, "stop", 0.0, 0)
    assert float(stopped["speed after 1 s"][0].max()) < 0.05


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
