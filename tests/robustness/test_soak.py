import dataclasses
import math

import pytest
import torch
import typer
from robustness import soak

import toolkit as tk
from toolkit.runtime import FPS

HARMED = 1  # which character


@pytest.fixture(scope="module")
def pretrained():
    model, bank = tk.pretrained()
    return tk.runtime.compile(model), bank.select(bank.names[:4])


class Harmed:
    """A model that goes wrong from a frame on, until another."""

    def __init__(self, model, harm, start=120, stop=math.inf):
        self.model, self.harm, self.start, self.stop, self.frame = model, harm, start, stop, 0

    def __getattr__(self, name):
        return getattr(self.model, name)

    def step(self, state, command):
        state, self.frame = self.model.step(state, command), self.frame + 1
        return self.harm(state, self.frame) if self.start <= self.frame < self.stop else state


tk.runtime.step.register(Harmed)(Harmed.step)
tk.runtime.pose.register(Harmed)(lambda harmed, state, **options: harmed.model.pose(state,
                                                                                    **options))


def changed(state, **parts):
    """A state with functions applied to some of its parts, of the one character."""
    new = {name: getattr(state, name).clone() for name in parts}
    for name, change in parts.items():
        new[name][HARMED] = change(new[name][HARMED])
    return dataclasses.replace(state, **new)


def judged(model, bank, seconds=6.0, course=None):
    course = soak.Course.random(len(bank), round(seconds * FPS), 0) if course is None else course
    seen = soak.watch(model, bank.vectors, course)
    return soak.judge(seen, course, list(bank)), seen


def walking(bank, seconds):
    """All straight ahead in their own styles."""
    frames, n = round(seconds * FPS), len(bank)
    ahead = torch.tensor([0.0, 1.0]).expand(frames, n, 2)
    own = torch.stack((torch.arange(n), torch.zeros(n), torch.zeros(n)), 1).long().expand(frames, n,
                                                                                          3)
    return soak.Course(ahead, ahead, own, torch.tensor([1.0, 0.0, 0.0]).expand(frames, n, 3))


def only(rows, word):
    """The harmed character fails for this, and no other fails."""
    assert [i for i, row in enumerate(rows) if row["failed"]] == [HARMED]
    assert word in rows[HARMED]["failed"]
    assert rows[HARMED]["style"] in "\n".join(soak.table(rows)[-1:])


def test_the_embedded_model_passes_and_says_so(capsys):
    soak.run(model=None, parameters=None, skip=None, seconds=5.0, seed=0)
    said = capsys.readouterr().out
    assert "25 of 25 styles pass 5 s each; 7,500 frames, 0 not finite, 0 falls" in said


def test_the_same_seed_gives_the_same_and_blends_are_of_three_at_most(pretrained):
    model, bank = pretrained
    one, again, other = (soak.Course.random(4, 1800, seed) for seed in (0, 0, 1))
    assert all(torch.equal(a, b)
               for a, b in zip(vars(one).values(), vars(again).values(), strict=True))
    assert not torch.equal(one.velocity, other.velocity)
    assert torch.allclose(one.shares.sum(-1), torch.ones(1800, 4))
    assert float(one.shares.min()) >= 0
    assert bool((one.styles[..., 0] == torch.arange(4)).all())
    assert torch.allclose(one.blend(0, bank.vectors), bank.vectors)
    speed = one.velocity.norm(dim=-1)
    assert bool((speed == 0).any())
    assert bool((speed > 2).any())
    assert bool((one.facing.norm(dim=-1) == 0).any())
    first, second = (judged(model, bank, 2.0)[1] for _ in range(2))
    assert all(torch.equal(getattr(first, name), getattr(second, name))
               for name in ("sliding", "hips", "root"))


def test_what_is_seen_is_what_the_measures_of_clips_say(pretrained):
    model, bank = pretrained
    course = walking(bank, 3.0)
    seen = soak.watch(model, bank.vectors, course)
    states = list(tk.runtime.states(model, tk.runtime.straight(1.0, 3.0), bank.vectors))
    for i in range(len(bank)):
        clip = tk.runtime.record(model, states, character=i)
        contact = torch.stack([s.contacts[i] for s in states])
        skate = tk.metrics.foot_skate(clip.cut(1), contact[1:])
        own = seen.sliding[1:, i], seen.contact[1:, i]
        for k, side in enumerate(("right", "left")):
            assert float(own[0][:, k][own[1][:, k]].mean()) == pytest.approx(skate[side], abs=2e-3)
        assert (float(seen.hips[:, i].min()),
                float(seen.hips[:, i].max())) == pytest.approx(tk.metrics.hips_height(clip))
        assert bool(seen.upright[:, i].all()) == tk.metrics.upright(clip)


def test_a_planted_nan_is_found(pretrained):
    model, bank = pretrained
    rows, seen = judged(Harmed(model, lambda s, _: changed(s, phase=lambda p: p * math.nan),
                               stop=121), bank)
    only(rows, "not finite at 2.0 s")
    assert rows[HARMED]["bad"] == int((~seen.finite).sum()) > 0


def test_a_planted_fall_is_found(pretrained):
    """Twice on its head for a moment."""
    model, bank = pretrained

    def over(state, frame):
        return changed(state, joints=lambda j: flipped(j)) if frame % 100 < 2 else state

    def flipped(joints):
        joints = joints.view(-1, 4, 3).clone()
        joints[:, 1:3] *= torch.tensor([1.0, -1.0, -1.0])
        return joints.flatten()

    rows, _ = judged(Harmed(model, over), bank)
    only(rows, "down at 3.3 s")
    assert rows[HARMED]["falls"] >= 2


def test_a_planted_slide_is_found(pretrained):
    """Feet always in contact, and their targets go along with the body."""
    model, bank = pretrained

    def slide(state, frame):
        away = 0.01 * (frame % 20) * torch.tensor([0.0, 0.0, 1.0])
        return changed(state, contacts=lambda c: torch.ones(2), toes=lambda t: t + away)

    rows, _ = judged(Harmed(model, slide), bank, course=walking(bank, 10.0))
    only(rows, "slides")
    assert rows[HARMED]["mean"] > 20 > 4 * max(row["mean"] for i, row in enumerate(rows)
                                               if i != HARMED)


def test_a_failure_is_an_exit_status(monkeypatch, capsys):
    monkeypatch.setattr(soak, "STUCK", 5.0)
    with pytest.raises(typer.Exit) as stopped:
        soak.run(model=None, parameters=None, skip=",".join(tk.pretrained().bank.names[4:]),
                 seconds=12.0, seed=0)
    assert stopped.value.exit_code == 1
    said = capsys.readouterr().out
    assert "stuck at" in said
    assert "of 4 styles" in said
