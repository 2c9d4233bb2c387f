"""The source for stochastic styles: it tracks the cadence, and asks the other limbs."""

import itertools

import numpy as np
import pytest
import torch
from course import coherent

import toolkit as tk
from toolkit.datasets import procedural

FPS = 60.0


def random(seed, *shape):
    return torch.randn(*shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64)


def slow_wavelets(values, fps):
    """One column: the spectrum of the mirrored curve under each band's bell, summed."""
    pad = min(len(values) - 1, round(2.5 / 0.35 * fps))
    mirrored = np.pad(values, pad, mode="reflect")
    n = len(mirrored)
    rates = np.arange(1, (n + 1) // 2) * fps / n
    turns = np.exp(2j * np.pi * np.outer(np.arange(n), rates) / fps)
    spectrum = turns.conj().T @ mirrored / n
    bands = 0.35 * (2.5 / 0.35) ** (np.arange(64) / 63)
    bells = 2 * np.exp(-0.5 * ((rates / bands[:, None] - 1) * 2.5) ** 2)
    return ((bells * spectrum) @ turns.T)[:, pad : pad + len(values)]


@pytest.mark.parametrize(("frames", "fps"), [(40, 12.0), (150, 12.0)])
def test_wavelets_are_those_of_the_mirrored_curve(frames, fps):
    values = random(9, frames, 2).cumsum(0)
    got = coherent.wavelets(values, fps).numpy()
    for column in range(2):
        slow = slow_wavelets(values[:, column].numpy(), fps)
        assert np.abs(got[..., column] - slow).max() < 1e-10 * np.abs(slow).max()
    constant = torch.full((80, 1), 9.0, dtype=torch.float64)
    assert float(coherent.wavelets(constant, FPS).abs().max()) < 1e-12


def best_path(power, penalty):
    cost = -(power / power.sum(0)).log()

    def total(path):
        jumps = sum((a - b) ** 2 for a, b in itertools.pairwise(path))
        return sum(float(cost[b, i]) for i, b in enumerate(path)) + penalty * jumps

    return min(itertools.product(range(power.shape[0]), repeat=power.shape[1]), key=total)


def test_the_ridge_is_the_best_of_all_paths_however_loud_a_frame_is():
    loudness = 10.0 ** torch.tensor([15.0, -15.0, 0.0, -10.0, 7.0], dtype=torch.float64)
    for seed in range(4):
        power = random(seed, 4, 5).abs() ** 3 + 1e-4
        best = list(best_path(power, coherent.PENALTY))
        assert coherent.ridge(power, 1).tolist() == best
        assert coherent.ridge(power * loudness, 1).tolist() == best
        assert coherent.ridge(power.flip(1), 1).tolist() == best[::-1]


def test_what_the_others_say_is_least_squares_damped_by_a_thousandth():
    """Ridge regression as plain least squares with one more row for each of the others."""
    shared = torch.exp(0.2j * torch.arange(300, dtype=torch.float64))[:, None]
    z = torch.complex(random(12, 300, 4), random(13, 300, 4))
    z = (z + 1.5 * shared * torch.exp(1j * torch.arange(4))) * torch.tensor([0.1, 1.0, 3.0, 20.0])
    for limb in range(4):
        own, others = z[:, limb].numpy(), np.delete(z.numpy(), limb, 1)
        rows = np.concatenate((others, np.diag(np.sqrt(1e-3 * (np.abs(others) ** 2).sum(0)))))
        weights = np.linalg.lstsq(rows, np.concatenate((own, np.zeros(3))), rcond=None)[0]
        told = others @ weights
        share = (np.abs(told) ** 2).sum() / (np.abs(own) ** 2).sum()
        expected = (1 - share) * own + share * told
        difference = np.abs(coherent.denoised(z, limb).numpy() - expected)
        assert difference.max() < 1e-6 * np.abs(own).max()
        assert 0.1 < share < 1
    alone = shared * torch.tensor([1.0, 0.0, 0.0, 0.0])  # limbs that do nothing say nothing
    assert torch.allclose(coherent.denoised(alone, 0), alone[:, 0])
    assert float(coherent.denoised(alone, 1).abs().max()) == 0


def test_coherent_is_nearer_to_the_truth_than_contact_free_when_staggering():
    clip, truth = procedural.truth(procedural.STYLES["Drunk"], "FW", 20.0, seed=1)
    error = {}
    sources = {"coherent": coherent.Coherent(), "contact-free": "contact-free"}
    for name, source in sources.items():
        phase = tk.phases.extract(clip, source).phase
        error[name] = float(tk.metrics.phase_error(phase[60:-60], truth.phase[60:-60])[0].mean())
    assert error["coherent"] < 0.8 * error["contact-free"]
