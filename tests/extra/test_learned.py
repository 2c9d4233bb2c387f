"""The periodic autoencoder as a phase source: its layers against slow ones, what it learns."""

import cmath
import math

import numpy as np
import pytest
import torch

import toolkit as tk
from toolkit.extra.sources import learned
from toolkit.extra.sources.learned import Convolution, Learned, PeriodicAutoencoder

TURN = 2 * math.pi
SWINGS = {"left_shoulder": (1.3, 0.0), "right_shoulder": (1.3, 0.5),
          "left_hip": (0.8, 0.0), "right_hip": (0.8, 0.5)}  # Hz, cycles


@pytest.fixture(scope="module")
def swinging() -> tk.Clip:
    """Eight seconds: arms swing at 1.3 Hz and thighs at 0.8 Hz, left and right in turn."""
    skeleton = tk.datasets.procedural.generate("Neutral", "ID", 1.0).skeleton
    time = torch.arange(480) / 60
    rotations = tk.motion.rotations.identity(len(skeleton)).expand(480, -1, -1).clone()
    for role, (frequency, lag) in SWINGS.items():
        half = 0.25 * torch.sin(TURN * (frequency * time - lag))
        if role == "right_shoulder":  # of a T-pose: the same turn would swing it the other way
            half = -half
        axis = torch.eye(3)[1 if role.endswith("shoulder") else 0]
        turn = torch.cat((half.cos()[:, None], half.sin()[:, None] * axis), 1)
        rotations[:, skeleton.index(role)] = turn
    return tk.Clip(skeleton, rotations, torch.tensor([0.0, 1.0, 0.0]).expand(480, 3), 60.0)


@pytest.fixture(scope="module")
def small(swinging) -> Learned:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(learned, "BATCH", 64)
        patch.setattr(learned, "LEARNING_RATE", 1e-2)
        return Learned.train([swinging], steps=80, seed=3)


def random(seed, *shape):
    return torch.randn(*shape, generator=torch.Generator().manual_seed(seed))


def test_banded_product_is_a_padded_convolution():
    layer, x = Convolution(3, 2).requires_grad_(False), random(0, 4, 3, learned.SAMPLES)
    bound = 1 / math.sqrt(3 * learned.SAMPLES)
    assert 0.9 * bound < float(layer.weight.max()) < bound
    assert -bound < float(layer.weight.min()) < -0.9 * bound
    kernels = layer.weight.transpose(0, 1)
    slow = torch.nn.functional.conv1d(x, kernels, padding=learned.HALF) + layer.bias
    assert torch.allclose(layer(x), slow, atol=1e-5)


def test_spectrum_is_that_of_a_slow_fourier_transform():
    time = torch.arange(41, dtype=torch.float64) / 20
    waves = ((1.0, 0.7), (2.5, 20 / 41 * 2), (0.4, 3.3))
    curves = torch.stack([a * torch.sin(TURN * f * time + 0.7) + 0.3 for a, f in waves])
    frequency, amplitude, offset = learned.spectrum(curves)
    for i, curve in enumerate(curves.tolist()):
        weighted = total = 0.0
        for k in range(1, 21):
            bin_ = sum(v * cmath.exp(-1j * TURN * k * n / 41) for n, v in enumerate(curve))
            weighted, total = weighted + k * 20 / 41 * abs(bin_) ** 2, total + abs(bin_) ** 2
        assert float(frequency[i]) == pytest.approx(weighted / total)
        assert float(amplitude[i]) == pytest.approx(2 / 41 * math.sqrt(total))
        assert float(offset[i]) == pytest.approx(sum(curve) / 41)
    # two whole cycles: nothing leaks
    assert (float(frequency[1]), float(amplitude[1])) == pytest.approx((40 / 41, 2.5))


def test_the_network_reconstructs_from_the_sinusoid_of_one_latent_curve():
    torch.manual_seed(1)
    network, x = PeriodicAutoencoder().requires_grad_(False), random(2, 64, 6, learned.SAMPLES)
    latent, phase, frequency, amplitude, offset = network.sinusoid(x)
    assert latent.shape == (64, learned.SAMPLES)
    vectors = network.shift(latent)
    angles = torch.tensor([math.atan2(y, x) for y, x in vectors.tolist()])
    assert torch.allclose(phase, angles, atol=1e-5)
    # while it learns, a batch's angles are all round
    assert torch.allclose(vectors.mean(0), torch.zeros(2), atol=1e-5)
    assert torch.allclose(vectors.std(0, correction=0), torch.ones(2), atol=1e-2)
    wave = network.wave(phase, frequency, amplitude, offset)
    p, f, a, b = (float(column[7]) for column in (phase, frequency, amplitude, offset))
    expected = [a * math.sin(TURN * f * k / 20 + p) + b for k in range(-20, 21)]
    assert wave[7].tolist() == pytest.approx(expected, abs=1e-5)
    assert torch.allclose(network(x), network.decoder(wave[:, None]), atol=1e-4)
    # between its convolutions each curve is normalised and bounded
    first, *_, last = network.encoder
    hidden = torch.nn.functional.layer_norm(first(x), (learned.SAMPLES,))
    assert torch.allclose(latent, last(hidden.tanh())[:, 0], atol=1e-4)


def test_windows_are_centred_of_unit_power_and_mirrored_at_the_ends():
    curves = random(0, 90, 2).cumsum(0)
    windows = learned.cut(curves, learned.RATE)
    for frame in (0, 45, 89):
        at = [min(abs(t), 178 - abs(t)) for t in range(frame - 20, frame + 21)]
        expected = curves[at].T - curves[at].T.mean(1, keepdim=True)
        expected = expected / expected.square().mean().sqrt()
        assert torch.allclose(windows[frame], expected, atol=1e-4)
    assert torch.equal(learned.cut(curves, learned.RATE, every=7), windows[::7])
    assert torch.allclose(learned.cut(1e-2 * curves, learned.RATE), windows, atol=1e-5)
    faint = learned.cut(1e-7 * curves, learned.RATE)  # what rests is not blown up
    assert float(faint.square().mean((1, 2)).sqrt().max()) < 0.1


def test_limb_curves_are_velocities_in_limb_lengths_outwards_up_and_forward():
    clip = tk.datasets.procedural.generate("Drunk", "FW", 3.0, seed=2).moved(turn=0.7)
    clip = clip.resample(30.0)
    index, roots = clip.skeleton.index, tk.motion.root_frames(clip)
    for limb in tk.phases.LIMBS:
        side, part = limb.split("_")
        names = ("elbow", "hand") if part == "hand" else ("knee", "toe")
        joints = [index(f"{side}_{name}") for name in names]
        reach = clip.global_positions[:, joints] - clip.global_positions[:, [0]]
        local = tk.motion.rotations.rotate(
            tk.motion.rotations.inverse(roots.rotations)[:, None], reach)
        speed = (local[2:] - local[:-2]) * 15 / tk.phases.steps.limb_length(clip.skeleton, limb)
        if side == "right":
            speed[..., 0] *= -1
        found = learned.limb_curves(clip, limb)
        assert found.shape == (len(clip), 6)
        assert torch.allclose(found[1:-1], speed.flatten(1), atol=2e-4)
        other = limb.replace(side, "left" if side == "right" else "right")
        assert torch.allclose(learned.limb_curves(clip.mirrored(), other), found, atol=2e-3)


def test_a_small_one_finds_frequencies_and_which_limb_is_half_a_cycle_behind(small, swinging):
    ph = tk.phases.extract(swinging, source=small)
    inner, rates = slice(90, -90), torch.tensor([1.3, 1.3, 0.8, 0.8])
    assert ph.frequency[inner].mean(0).tolist() == pytest.approx(rates.tolist(), rel=0.03)
    truth = TURN * torch.arange(480)[:, None] / 60 * rates
    error, lag = tk.metrics.phase_error(ph.phase[inner], truth[inner])
    assert float(error.max()) < math.radians(10)
    for right in (1, 3):
        behind = math.remainder(float(lag[right] - lag[right - 1]) - math.pi, TURN)
        assert abs(behind) < math.radians(15)


def test_sinusoids_are_the_networks_own_scaled_by_the_factor(small, swinging):
    """A negative factor turns the phase by half a cycle."""
    curve, found = Learned(small.networks, {"hand": 2.0, "foot": -3.0}).sinusoids(swinging)
    assert all(column.dtype == torch.float64 for column in (curve, *vars(found).values()))
    for i, limb in enumerate(tk.phases.LIMBS):
        network, factor = small.networks[limb.split("_")[1]], (2.0, 2.0, -3.0, -3.0)[i]
        windows = learned.cut(learned.limb_curves(swinging, limb), 60.0)[::48]
        with torch.no_grad():
            latent, phase, *others = network.sinusoid(windows)
            residual = (latent - network.wave(phase, *others)).square().mean(1).sqrt()
        _, amplitude, offset = others
        for column, expected in ((curve, latent[:, 20] * factor), (found.offset, offset * factor),
                                 (found.amplitude, amplitude * abs(factor)),
                                 (found.residual, residual * abs(factor))):
            assert column[::48, i].tolist() == pytest.approx(expected.tolist(), abs=1e-4)
        turned = phase + (math.pi if factor < 0 else 0)
        assert float(torch.sin((found.phase[::48, i] - turned) / 2).abs().max()) < 1e-4
    assert 0 <= float(found.phase.min()) < float(found.phase.max()) <= TURN


def test_frequency_is_the_mean_growth_over_a_second_within_the_fits_bounds():
    grown = random(3, 70).abs().double().cumsum(0) + 0.1
    found = learned._growth(torch.atan2(grown.sin(), grown.cos()), 10.0)
    rates = np.gradient(grown.numpy()) * 10 / TURN
    for frame in range(5, 65):
        assert float(found[frame]) == pytest.approx(rates[frame - 5 : frame + 6].mean())
    for step, limit in ((0.0, 0.25), (-0.2, 0.25), (2.9, 4.0)):
        steady = learned._growth(step * torch.arange(60) % TURN, 10.0)
        assert steady.tolist() == pytest.approx([limit] * 60)


def test_training_brings_the_error_down_and_is_repeatable(swinging, monkeypatch):
    monkeypatch.setattr(learned, "BATCH", 16)
    monkeypatch.setattr(learned, "LEARNING_RATE", 1e-2)
    windows = learned.cut(learned.limb_curves(swinging, "left_hand"), 60.0, 3)
    torch.manual_seed(4)
    network = PeriodicAutoencoder()
    with torch.no_grad():
        before = float((network(windows) - windows).square().mean())
    learned._descend(network, windows, 40, None)
    assert not network.training
    with torch.no_grad():
        assert float((network(windows) - windows).square().mean()) < 0.8 * before
    expected = torch.rand(3, generator=torch.Generator().manual_seed(5))
    torch.manual_seed(5)
    first, same, other = (Learned.train([swinging.cut(0, 120)], steps=3, seed=seed)
                          for seed in (1, 1, 2))
    assert torch.equal(torch.rand(3), expected)  # the random numbers outside are left alone
    assert first.factors == same.factors != other.factors
    with pytest.raises(ValueError, match="a learned source needs at least one clip"):
        Learned.train([])


def test_the_packaged_one_keeps_in_step_with_the_truth():
    style = "PendulumHands"
    assert style in learned.HELD_OUT
    clip, truth = tk.datasets.procedural.truth(style, "FW", seconds=10.0, seed=5)
    ph, slow = (tk.phases.extract(c, source="learned") for c in (clip, clip.resample(30.0)))
    inner = slice(60, -60)
    error = tk.metrics.phase_error(ph.phase[inner], truth.phase[inner])[0].rad2deg()
    assert float(error[:2].max()) < 10
    # a foot's true phase stands still in the middle of its stance, a sinusoid's does not
    assert float(error[2:].max()) < 25
    grown = (truth.phase[-61] - truth.phase[60]) / TURN / (len(clip) - 121) * 60
    assert ph.frequency[inner].mean(0).tolist() == pytest.approx(grown.tolist(), rel=0.05)
    error, lag = tk.metrics.phase_error(slow.phase, ph.phase[::2][: len(slow.phase)])
    assert float(max(error.max(), lag.abs().max())) < math.radians(3)


def test_packaged_one_reads_other_skeletons(shared):
    clips = tk.datasets.load("bandai", shared / "bandai", ["normal"], ["walk"], dataset=2)
    ph = tk.phases.extract(max(clips, key=len), source="learned")
    left, right = (float(ph.frequency[30:-30, i].mean()) for i in (2, 3))
    assert left == pytest.approx(right, rel=0.1)
    assert 0.5 < left < 1.5


def test_it_reads_back_what_it_wrote_and_refuses_other_files(small, swinging, tmp_path):
    small.save(tmp_path / "own")
    loaded = Learned.load(tmp_path / "own")
    assert loaded.factors == small.factors
    (curve, found), (same, stored) = small.sinusoids(swinging), loaded.sinusoids(swinging)
    assert torch.equal(curve, same)
    for a, b in zip(vars(found).values(), vars(stored).values(), strict=True):
        assert torch.equal(a, b)
    tensors, parts = tk.io.model_files.read(tmp_path / "own", "learned")
    tk.io.model_files.write(tmp_path / "other", tensors, {"model": {}})
    with pytest.raises(ValueError, match="expected a learned in it, got model"):
        Learned.load(tmp_path / "other")
    fewer = {name: value for name, value in tensors.items() if "foot.shift.0.weight" not in name}
    for content, about in ((fewer, parts["learned"]), (tensors, {"factors": {"hand": 1.0}}),
                           (tensors, {"factors": {"hand": 1.0, "foot": "x"}}), (tensors, 3)):
        tk.io.model_files.write(tmp_path / "broken", content, {"learned": about})
        with pytest.raises(ValueError, match=r"broken: the learned source in it is damaged \(.+"):
            Learned.load(tmp_path / "broken")
