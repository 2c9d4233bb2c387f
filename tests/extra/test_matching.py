"""Motion matching: it finds what it has seen, selects styles, and walks."""

import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit.extra import matching


@pytest.fixture(scope="module")
def run():
    clips = tk.datasets.procedural.load(["Neutral", "Zombie"], ["FW", "FR"], 12.0)
    data = tk.features.build(clips)
    return data, *matching.match(data)


def test_a_row_of_the_data_finds_itself_in_parts_of_the_data_too(run, monkeypatch):
    data, model, bank = run
    x = model.normaliser("inputs").apply(data.inputs["Zombie"][5:300:7])
    style = bank["Zombie"][None]
    wanted = len(data.inputs["Neutral"]) + torch.arange(5, 300, 7)  # after those of Neutral
    assert torch.equal(model.nearest(x, style), wanted)
    monkeypatch.setattr(matching, "ROWS", 100)
    assert torch.equal(model.nearest(x, style), wanted)
    z = model.predict(data.inputs["Zombie"][5:9], torch.empty(4, 0), bank["Zombie"])
    wanted = model.observe(data.phases["Zombie"][5:9], data.outputs["Zombie"][5:9])[1]
    torch.testing.assert_close(z, wanted, rtol=1e-4, atol=1e-5)


def test_a_style_is_selected_and_a_blend_takes_both(run):
    data, model, bank = run
    x = model.normaliser("inputs").apply(data.inputs["Zombie"][:200])
    assert bank.vectors.tolist() == [[1.0, 0.0], [0.0, 1.0]]
    for number, name in enumerate(bank):
        assert (model.numbers[model.nearest(x, bank[name][None])] == number).all()
    query = torch.lerp(x, model.normaliser("inputs").apply(data.inputs["Neutral"][:200]), 0.5)
    shares = []
    for share in (0.2, 0.5, 0.8):
        style = bank.blend({"Zombie": share, "Neutral": 1 - share})[None]
        shares.append(float(model.numbers[model.nearest(query, style)].float().mean()))
    assert shares == sorted(shares)
    assert shares[0] < 0.5 < shares[-1]


def test_it_walks_as_fast_as_it_is_told(run):
    _, model, bank = run
    speed = bank.speed("Neutral")
    clip = tk.runtime.rollout(model, tk.runtime.straight(speed, 2.5), bank["Neutral"]).cut(60)
    assert tk.metrics.upright(clip)
    assert tk.metrics.speed(clip) == pytest.approx(speed, rel=0.3)
    with refusal("is not stored in a model file"):
        tk.training.Run(model, bank).save("x.safetensors")


def test_it_plays_the_data_between_searches_and_a_jump_changes_no_pose_at_once(run):
    _, model, bank = run
    commands = tk.runtime.straight(0.4, 2.0)
    states = list(tk.runtime.states(model, commands, bank.vectors))
    rows = torch.stack([state.row for state in states])  # [F, 2]
    plays = rows[1:] == rows[:-1] + model.follows[rows[:-1]].long()
    assert 0.8 < plays.double().mean() < 1.0
    assert (~plays).sum() <= 2 * (len(states) // matching.EVERY + 1)
    # the frame after a jump lies near the one that the rows before it would have given
    at, who = (~plays).nonzero()[-1].tolist()
    old, new = states[at], states[at + 1]
    kept = model.frames[rows[at, who] + 1] + old.offset[who]
    gap = (model.frames[rows[at + 1, who]] + new.offset[who] - kept).abs()
    assert gap.mean() < 0.3 * (model.frames[rows[at + 1, who]] - kept).abs().mean()
