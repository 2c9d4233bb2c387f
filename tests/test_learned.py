"""The periodic autoencoder as a phase source: its layers against slow ones, what it learns, its file."""

import cmath
import math

import pytest
import torch

import toolkit as tk
from toolkit.phases import learned
from toolkit.phases.learned import Convolution, Learned, PeriodicAutoencoder

TURN = 2 * math.pi


@pytest.fixture(scope="module")
def swinging() -> tk.Clip:
    """Eight seconds on the 100STYLE skeleton: arms swing at 1.3 Hz and thighs at 0.8 Hz, left and right in turn."""
    skeleton = tk.datasets.load("procedural", styles=["Neutral"], gaits=["ID"], seconds=1.0)[0].skeleton
    time = torch.arange(480) / 60
    rotations = tk.rotations.identity(len(skeleton)).expand(480, -1, -1).clone()
    for role, frequency, lag in (("left_shoulder", 1.3, 0.0), ("right_shoulder", 1.3, 0.5), ("left_hip", 0.8, 0.0),
                                 ("right_hip", 0.8, 0.5)):  # fmt: skip
        half = 0.25 * torch.sin(TURN * (frequency * time - lag))
        axis = torch.tensor([0.0, 1.0, 0.0]) if role.endswith("shoulder") else torch.tensor([1.0, 0.0, 0.0])
        if role == "right_shoulder":  # a T-pose's arms: turning both the same way would swing one forward and one back
            half = -half
        rotations[:, skeleton.index(role)] = torch.cat((half.cos()[:, None], half.sin()[:, None] * axis), 1)
    return tk.Clip(skeleton, rotations, torch.tensor([0.0, 1.0, 0.0]).expand(480, 3), 60.0)


@pytest.fixture(scope="module")
def small(swinging) -> Learned:
    return Learned.train([swinging], steps=100, batch=64, rate=1e-2, hidden=4, seed=3)


def test_banded_product_is_a_padded_convolution():
    torch.manual_seed(0)
    layer, x = Convolution(3, 2, 7), torch.randn(4, 3, 7)
    slow = layer.bias.detach().expand(4, 2, 7).clone()
    for t in range(7):
        for s in range(7):
            if 0 <= 3 + s - t < 7:
                slow[:, :, t] += x[:, :, s] @ layer.weight.detach()[:, :, 3 + s - t]
    assert torch.allclose(layer(x), slow, atol=1e-6)


def test_spectrum_is_that_of_a_slow_fourier_transform():
    time = torch.arange(41, dtype=torch.float64) / 20
    curves = [a * torch.sin(TURN * f * time + 0.7) + 0.3 for a, f in ((1.0, 0.7), (2.5, 20 / 41 * 2), (0.4, 3.3))]
    frequency, amplitude, offset = learned.spectrum(torch.stack(curves), rate=20.0)
    for i, curve in enumerate(curves):
        weighted = total = 0.0
        for k in range(1, 21):
            power = abs(sum(float(v) * cmath.exp(-1j * TURN * k * n / 41) for n, v in enumerate(curve))) ** 2
            weighted, total = weighted + k * 20 / 41 * power, total + power
        assert float(frequency[i]) == pytest.approx(weighted / total)
        assert float(amplitude[i]) == pytest.approx(2 / 41 * math.sqrt(total))
        assert float(offset[i]) == pytest.approx(float(curve.mean()))
    assert (float(frequency[1]), float(amplitude[1])) == pytest.approx((40 / 41, 2.5))  # two whole cycles: nothing leaks


def test_every_weight_has_a_gradient():
    torch.manual_seed(0)
    network, x = PeriodicAutoencoder(curves=6, hidden=3), torch.randn(5, 6, learned.SAMPLES)
    rebuilt = network(x)
    assert rebuilt.shape == x.shape
    (rebuilt - x).square().mean().backward()
    silent = [name for name, p in network.named_parameters() if p.grad is None or not bool(p.grad.abs().max() > 0)]
    # batch normalisation takes away what is the same for the whole batch
    assert silent in ([], ["shift.0.bias"])


def test_windows_are_centred_of_unit_power_and_mirrored_at_the_ends():
    curves = torch.randn(90, 2, generator=torch.Generator().manual_seed(0)).cumsum(0)
    windows = learned.cut(curves, fps=learned.RATE)
    for frame in (0, 45, 89):
        at = [min(abs(t), 178 - abs(t)) for t in range(frame - learned.HALF, frame + learned.HALF + 1)]
        expected = curves[at].T - curves[at].T.mean(1, keepdim=True)
        assert torch.allclose(windows[frame], expected / expected.square().mean().sqrt(), atol=1e-4)


def test_a_small_one_finds_frequencies_and_which_limb_is_half_a_cycle_behind(small, swinging):
    ph = tk.phases.extract(swinging, source=small)
    inner = slice(90, -90)
    assert ph.frequency[inner].mean(0).tolist() == pytest.approx([1.3, 1.3, 0.8, 0.8], rel=0.03)
    truth = TURN * torch.arange(480)[:, None] / 60 * torch.tensor([1.3, 1.3, 0.8, 0.8])
    error, lag = tk.metrics.phase_error(ph.phase[inner], truth[inner])
    assert float(error.max()) < math.radians(10)
    for right in (1, 3):
        assert abs(math.remainder(float(lag[right] - lag[right - 1]) - math.pi, TURN)) < math.radians(15)


def test_it_reads_back_what_it_wrote_and_refuses_other_files(small, swinging, tmp_path):
    small.save(tmp_path / "own")
    (curve, found), (stored_curve, stored) = small.sinusoids(swinging), Learned.load(tmp_path / "own").sinusoids(swinging)
    assert torch.equal(curve, stored_curve)
    assert all(torch.equal(a, b) for a, b in zip(vars(found).values(), vars(stored).values(), strict=True))
    tensors, parts = tk.networks.weights.read(tmp_path / "own", "learned")
    tk.networks.weights.write(tmp_path / "other", tensors, {"model": {}})
    with pytest.raises(ValueError, match="expected a learned in it, got model"):
        Learned.load(tmp_path / "other")
    del tensors["learned.foot.shift.0.weight"]
    tk.networks.weights.write(tmp_path / "damaged", tensors, parts)
    with pytest.raises(ValueError, match=r"the learned source in it is damaged .*shift\.0\.weight"):
        Learned.load(tmp_path / "damaged")


def test_same_seed_same_networks(swinging):
    first, same, other = (Learned.train([swinging], steps=8, batch=16, hidden=2, seed=s).sinusoids(swinging)[0]
                          for s in (1, 1, 2))  # fmt: skip
    assert torch.equal(first, same)
    assert not torch.equal(first, other)


@pytest.mark.parametrize(("style", "limit"), [("Neutral", 10), ("PendulumHands", 10)])
def test_the_packaged_one_keeps_in_step_with_the_truth(style, limit):
    clip, truth = tk.datasets.procedural.truth(style, "FW", seconds=10.0, seed=5)
    assert (style == "Neutral") != (style in learned.HELD_OUT)
    ph = tk.phases.extract(clip, source="learned")
    inner = slice(60, -60)
    hands, feet = tk.metrics.phase_error(ph.phase[inner], truth.phase[inner])[0].rad2deg().split(2)
    assert float(hands.max()) < limit
    assert float(feet.max()) < 25  # a foot's true phase stands still in the middle of its stance, a sinusoid's does not
    grown = (truth.phase[-61] - truth.phase[60]) / TURN / (len(clip) - 121) * 60
    assert ph.frequency[inner].mean(0).tolist() == pytest.approx(grown.tolist(), rel=0.05)


def test_the_rate_of_the_clip_does_not_matter():
    clip = tk.datasets.load("procedural", styles=["Neutral"], gaits=["FW"], seconds=6.0, seed=5)[0]
    full, half = (tk.phases.extract(c, source="learned") for c in (clip, clip.resample(30.0)))
    error, lag = tk.metrics.phase_error(half.phase, full.phase[::2][: len(half.phase)])
    assert float(error.max()) < math.radians(3)
    assert float(lag.abs().max()) < math.radians(3)


def test_packaged_one_reads_other_skeletons(shared):
    clip = max(tk.datasets.load("bandai", shared / "bandai", ["normal"], ["walk"], dataset=2), key=len)
    ph = tk.phases.extract(clip, source="learned")
    left, right = (float(ph.frequency[30:-30, i].mean()) for i in (2, 3))
    assert left == pytest.approx(right, rel=0.1)
    assert 0.5 < left < 1.5
