"""Characters do what they are told, and the measures of that see what is wrong."""

import pytest
import torch
from refusal import refusal

from experiments import closed_loop
from toolkit.runtime.life import PERIOD, alive, uniform


@pytest.mark.parametrize(("track", "most"), [
    ("1 m/s", {"direction": 2.0, "toes": 0.5, "raw": 4.0}), ("stop", {"still": 0.05, "way": 1.0}),
    ("turns", {"toes": 1.5, "knee": 35.0, "wrist": 8.0})])
def test_characters_do_what_they_are_told(fast, track, most):
    model, bank = fast
    for row in closed_loop.measured(model, bank.select(["Neutral", "Zombie"]), track):
        assert {key: row[key] for key in most if row[key] > most[key]} == {}
        if track == "1 m/s":
            assert row["speed"] == pytest.approx(1.0, abs=0.1)


def test_a_style_that_wanders_is_smooth_and_repeatable():
    style = torch.ones(2, 500, dtype=torch.float64)
    assert alive(style, 0.0) is style
    seen = torch.stack([alive(style, 0.2, seed=3)(frame) for frame in range(4 * PERIOD)])
    assert torch.equal(alive(style, 0.2, seed=3)(77), seen[77])
    assert torch.equal(seen[..., :125], style[None, :, :125].expand(len(seen), 2, 125))  # γ
    seen = torch.cat((seen[..., 125:250], seen[..., 375:]), -1)  # β of two layers
    assert float((seen - 1).mean()) == pytest.approx(0.0, abs=0.01)
    assert float((seen - 1).std()) == pytest.approx(0.2, abs=0.01)
    assert (seen[1:] - seen[:-1]).abs().max() < 0.03
    assert abs(float(torch.corrcoef(seen[0] - 1)[0, 1])) < 0.15  # each row has its own seed
    assert uniform(3, 1, 2).tolist() != uniform(3, 2, 1).tolist()
    with refusal("life must be in"):
        alive(style, 1.0)
