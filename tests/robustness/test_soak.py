import dataclasses
import math

import pytest
import torch
import typer
from robustness import soak

import toolkit as tk
from toolkit.runtime import FPS

HARMED = 1  # which character


@pytest.fixture
def pretrained(fast):
    model, bank = fast
    return model, bank.select(bank.names[:4])


class Harmed:
    """A model that goes wrong from frame 120 on."""

    def __init__(self, model, harm):
        self.model, self.harm, self.frame = model, harm, 0

    def __getattr__(self, name):
        return getattr(self.model, name)

    def step(self, state, command):
        state, self.frame = self.model.step(state, command), self.frame + 1
        return self.harm(state, self.frame) if self.frame >= 120 else state


tk.runtime.step.register(Harmed)(Harmed.step)
tk.runtime.pose.register(Harmed)(lambda harmed, state, **options: harmed.model.pose(state,
                                                                                    **options))


def changed(state, **parts):
    """A state with functions applied to some of its parts, of the one character."""
    new = {name: getattr(state, name).clone() for name in parts}
    for name, change in parts.items():
        new[name][HARMED] = change(new[name][HARMED])
    return dataclasses.replace(state, **new)


def walking(bank, seconds):
    """All straight ahead in their own styles."""
    frames, n = round(seconds * FPS), len(bank)
    ahead = torch.tensor([0.0, 1.0]).expand(frames, n, 2)
    own = torch.stack((torch.arange(n), torch.zeros(n), torch.zeros(n)), 1).long()
    return soak.Course(ahead, ahead, own.expand(frames, n, 3),
                       torch.tensor([1.0, 0.0, 0.0]).expand(frames, n, 3))


def poisoned(state, frame):
    return changed(state, phase=lambda phase: phase * math.nan) if frame == 120 else state


def falls(state, frame):
    """On its head for a moment, again and again."""

    def flipped(joints):
        return (joints.view(-1, 4, 3) * torch.tensor([[1.0], [-1.0], [-1.0], [1.0]])).flatten()

    return changed(state, joints=flipped) if frame % 100 < 2 else state


@pytest.mark.parametrize(("harm", "said"), [(poisoned, "bad from 2.0 s"),
                                            (falls, "falls from 3.3")])
def test_a_planted_defect_is_found_and_only_this(pretrained, harm, said):
    model, bank = pretrained
    course = walking(bank, 8.0)
    seen = soak.watch(Harmed(model, harm), bank.vectors, course)
    rows = soak.judge(seen, course, bank, 0.9)
    assert [i for i, row in enumerate(rows) if row["failed"]] == [HARMED]
    assert said in rows[HARMED]["failed"]
    assert soak.table(rows)[-1].startswith(f"{bank.names[HARMED]}: ")


def test_the_embedded_model_passes_and_says_so(capsys):
    soak.run(model=None, parameters=None, skip=None, seconds=5.0, seed=0)
    said = capsys.readouterr().out
    assert "25 of 25 styles pass 5 s each: embedded model, 25 styles, 7500 frames, 0 bad" in said


def test_the_same_seed_gives_the_same_course_of_every_kind():
    one, again, other = (soak.Course.random(4, 1800, seed) for seed in (0, 0, 1))
    assert all(torch.equal(a, b)
               for a, b in zip(vars(one).values(), vars(again).values(), strict=True))
    assert not torch.equal(one.velocity, other.velocity)
    assert torch.allclose(one.shares.sum(-1), torch.ones(1800, 4))
    assert float(one.shares.min()) >= 0
    speed = one.velocity.norm(dim=-1)
    assert bool((speed == 0).any())
    assert bool((speed > 2).any())
    assert bool((one.facing.norm(dim=-1) == 0).any())


def test_what_is_seen_is_what_the_measures_of_clips_say(pretrained):
    model, bank = pretrained
    seen = soak.watch(model, bank.vectors, walking(bank, 3.0))
    states = list(tk.runtime.states(model, tk.runtime.straight(1.0, 3.0), bank.vectors))
    for i in range(len(bank)):
        clip = tk.runtime.record(model, states, character=i)
        hips = float(seen.hips[:, i].min()), float(seen.hips[:, i].max())
        assert hips == pytest.approx(tk.metrics.hips_height(clip))
        assert bool(seen.upright[:, i].all()) == tk.metrics.upright(clip)


def test_a_failure_is_an_exit_status(monkeypatch, capsys):
    monkeypatch.setattr(soak, "STUCK", 5.0)
    with pytest.raises(typer.Exit) as stopped:
        soak.run(model=None, parameters=None, skip=",".join(tk.pretrained().bank.names[4:]),
                 seconds=12.0, seed=0)
    assert stopped.value.exit_code == 1
    assert "stuck from" in capsys.readouterr().out
