"""Data of a model that knows less of phase, and errors on held-out frames, for all models."""

import math

import numpy as np
import pytest
import torch
from test_networks import TINY

import toolkit as tk
from toolkit import networks
from toolkit.networks import phase
from toolkit.training import loss

SHARED = ("trajectory", "joints", "contacts")


@pytest.fixture(scope="module", params=networks.MODELS)
def model(request, two_styles):
    torch.manual_seed(0)
    made = networks.build(request.param, two_styles.layout, 2, TINY)
    made.normalise(networks.normalisers(made.layout, two_styles))
    return made


@pytest.fixture(scope="module")
def data(two_styles):
    return two_styles


def test_the_global_phase_is_the_right_feet_of_a_walk():
    """It turns once per step cycle, forwards, and is half a cycle away with the feet exchanged."""
    clip, truth = tk.datasets.procedural.truth("Neutral", "FW", seconds=12.0)
    p = tk.phases.extract(clip).vector.flatten(1)
    angle = phase.global_phase(p)[:, 0]
    assert ((angle >= 0) & (angle < math.tau)).all()
    walking = slice(120, -120)
    turned = np.unwrap(angle.numpy())[walking]
    assert np.diff(turned).min() > 0
    assert turned[-1] - turned[0] == pytest.approx(
        float(truth.phase[walking][-1, 3] - truth.phase[walking][0, 3]), abs=0.5
    )
    mirrored = phase.global_phase(p.unflatten(-1, (4, 2))[:, [1, 0, 3, 2]].flatten(1))[:, 0]
    assert ((mirrored - angle) % math.tau - math.pi).abs().max() < 1e-3


def test_observing_keeps_shared_columns_and_makes_the_phase_the_models_own(model, data):
    p, z = data.phases["Zombie"], data.outputs["Zombie"]
    own, target = model.observe(p, z)
    assert (own.shape[1], target.shape[1]) == (model.layout.n_phases, model.layout.n_outputs)
    blocks, seen = data.layout.unpack_output(z), model.layout.unpack_output(target)
    assert all(torch.equal(seen[block], blocks[block]) for block in SHARED)
    if model.name.startswith("lpn"):
        assert own is p
        assert target is z
    ahead = phase.advance(model.layout, own, seen)
    assert torch.allclose(ahead[:-1].cos(), own[1:].cos(), atol=1e-4)
    assert torch.allclose(ahead[:-1].sin(), own[1:].sin(), atol=1e-4)
    if model.name.startswith("pfnn"):
        assert seen["phase_updates"].abs().max() <= math.pi
        assert ((ahead >= 0) & (ahead < math.tau)).all()


def test_errors_equal_a_loop_over_frames(model, data):
    bank = loss.make_bank(model, data, clips=2)
    assert bank.names == ("Neutral", "Zombie") == tuple(data.styles)
    if not model.name.endswith("film"):
        assert torch.equal(bank.vectors, model.modulation.generator.vectors)
    found, base = loss.evaluate(model, bank, data, frames=20), loss.baselines(model, data)
    for style in data.styles:
        rows = torch.linspace(0, len(data.inputs[style]) - 1, 20).long()
        p, z = model.observe(data.phases[style], data.outputs[style])
        x, mean, std = data.inputs[style], model.outputs_mean, model.outputs_std
        made = torch.cat([model.predict(x[[i]], p[[i]], bank[style]) for i in rows.tolist()])
        error = ((made - z[rows]) / std).square().mean()
        assert found[style]["mse"] == pytest.approx(float(error), rel=1e-3)
        lengths = [model.layout.bone_lengths(model.layout.joint_positions(y))
                   for y in (made, z[rows])]
        bone = (lengths[0] - lengths[1]).abs().mean()
        assert found[style]["bone"] == pytest.approx(float(bone), rel=1e-3)
        mean_error = ((z - mean) / std).square().mean()
        assert base[style]["mean"] == pytest.approx(float(mean_error), rel=1e-4)
        # a global phase goes on
        even = mean[-3:-2].expand(len(x), 1) if model.name.startswith("pfnn") else 0 * p
        still = {"trajectory": x[:, 24:48], "joints": x[:, 48:], "phases": p,
                 "contacts": mean[-2:].expand(len(x), 2), "phase_updates": even}
        repeat = torch.cat([still[block] for block in model.layout.outputs], 1)
        repeat_error = ((z - repeat) / std).square().mean()
        assert base[style]["repeat"] == pytest.approx(float(repeat_error), rel=1e-4)
