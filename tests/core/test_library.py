"""What one meets who imports the package: inputs of any kind, texts, mappings, runs."""

import collections.abc

import numpy as np
import pytest
import torch
from refusal import refusal

import toolkit as tk
from toolkit import runtime
from toolkit.motion.tensors import as_tensor
from toolkit.networks.bank import StyleBank


def test_a_bank_is_a_mapping(small_run):
    bank = small_run.bank
    assert isinstance(bank, collections.abc.Mapping)
    assert list(bank) == ["Neutral", "Zombie"]
    with pytest.raises(KeyError, match=r"^unknown style 'Zombi'; close to it: Zombie$"):
        bank["Zombi"]
    assert {bank: 1}[bank] == 1  # a bank equals itself alone
    assert bank != StyleBank(bank.names, bank.vectors)
    other = bank.merge(StyleBank(["Mine"], [bank["Zombie"].tolist()]))
    assert torch.equal(other["Mine"], bank["Zombie"])
    assert other.nearest(bank["Zombie"].numpy(), 1)[0][1] == 0


def test_arrays_and_lists_make_a_clip_of_float32(walk_clip):
    q, root = walk_clip.rotations.double().numpy(), walk_clip.root_positions.tolist()
    frames = list(walk_clip.rotations), list(walk_clip.root_positions)
    for rotations, positions in ((q, root), (q[::-1].copy()[::-1], np.array(root)), frames):
        clip = tk.Clip(walk_clip.skeleton, rotations, positions, 60)
        assert torch.equal(clip.rotations, walk_clip.rotations)
        assert torch.equal(clip.root_positions, walk_clip.root_positions)
    exact = tk.Clip(walk_clip.skeleton, walk_clip.rotations.double(), root, 60)
    assert exact.root_positions.dtype == torch.float64
    with refusal(r"^rotations must be numbers in a tensor, array or list"):
        tk.Clip(walk_clip.skeleton, None, root, 60)
    s = walk_clip.skeleton
    assert torch.equal(tk.Skeleton(list(s.names), np.array(s.parents), s.offsets.tolist()).offsets,
                       s.offsets)


def test_a_character_starts_from_what_is_at_hand(small_run):
    model, bank = small_run
    place = torch.tensor([[1.0, 2.0], [3.0, 4.0]])
    facing = torch.tensor([[0.0, 2.0], [1.0, 0.0]])
    known, vectors = runtime.start(model, bank.vectors, place, facing), bank.vectors
    for style in (vectors.double().numpy(), vectors.tolist(), list(vectors)):
        state = runtime.start(model, style, [(1, 2), (3, 4)], np.array([[0, 2], [1, 0]]))
        assert all(torch.equal(getattr(state, name), value) for name, value in vars(known).items())
    assert torch.equal(state.with_style(bank["Neutral"].tolist()).style[0], bank["Neutral"])
    moved = runtime.step(model, state, runtime.Command(np.array([0.0, 1.0]), [0, 1]))
    assert moved.velocity.dtype == torch.float32
    commands = iter(runtime.straight(np.float64(1.0), 0.05))
    clip = runtime.record(model, runtime.states(model, commands, bank["Zombie"].numpy()))
    assert len(clip) == 3
    x, p = np.zeros((2, model.layout.n_inputs)), [[0.0] * 8] * 2
    same = model.predict(torch.zeros(2, x.shape[1]), torch.zeros(2, 8), bank["Zombie"])
    assert torch.equal(model.predict(x, p, bank["Zombie"].numpy()), same)


ONE_PAIR = r"one pair \(x, z\), or \[1, 2\] of all characters"


@pytest.mark.parametrize(("given", "match"), [
    ({"model": "lpn-film"}, r"expected a model \(of a run: run.model\), got 'lpn-film'"),
    ({"style": torch.zeros(7)}, r"style needs 128 columns, got shape \[1, 7\]"),
    ({"style": torch.zeros(1, 1, 9)}, r"a style is one vector \[S\], .*; got shape \[1, 1, 9\]"),
    ({"facing": [[0, 1], [1, 0]]}, rf"facing must be {ONE_PAIR}; got \[2, 2\]"),
    ({"position": (np.nan, 0)}, r"position and facing must be finite, .*; got \(nan, 0\), .*"),
])
def test_what_is_no_start_is_refused_in_one_line(small_run, given, match):
    with refusal(f"^{match}$"):
        runtime.start(**{"model": small_run.model, "style": small_run.bank["Zombie"]} | given)


RAGGED = [torch.zeros(2), torch.zeros(3)]


@pytest.mark.parametrize("values", [None, ["a"], {"a": 1}, [[1, 2], [3]], RAGGED])
def test_what_is_no_number_is_refused(values):
    said = r"^these must be numbers in a tensor, array or list; got [^\n]{1,70}$"
    with refusal(said):
        as_tensor(values, "these")


def test_numbers_become_tensors():
    exact = as_tensor([0.1], "it", torch.float64)
    assert exact.tolist() == [0.1]  # not by way of float32
    frozen = np.arange(3.0)
    frozen.flags.writeable = False
    assert as_tensor(frozen, "it").tolist() == [0, 1, 2]
