"""The periodic autoencoder as a phase source: its layers against slow ones, what it learns, its file."""

import cmath
import math
import re
import sys
from dataclasses import replace

import numpy as np
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
    rotations = tk.motion.rotations.identity(len(skeleton)).expand(480, -1, -1).clone()
    for role, frequency, lag in (("left_shoulder", 1.3, 0.0), ("right_shoulder", 1.3, 0.5), ("left_hip", 0.8, 0.0),
                                 ("right_hip", 0.8, 0.5)):
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
    tensors, parts = tk.io.model_files.read(tmp_path / "own", "learned")
    tk.io.model_files.write(tmp_path / "other", tensors, {"model": {}})
    with pytest.raises(ValueError, match="expected a learned in it, got model"):
        Learned.load(tmp_path / "other")
    del tensors["learned.foot.shift.0.weight"]
    tk.io.model_files.write(tmp_path / "damaged", tensors, parts)
    with pytest.raises(ValueError, match=r"the learned source in it is damaged .*shift\.0\.weight"):
        Learned.load(tmp_path / "damaged")
    parts["learned"]["hidden"]["foot"] = 0
    tk.io.model_files.write(tmp_path / "nothing", tensors, parts)
    with pytest.raises(ValueError, match="the learned source in it is damaged"):
        Learned.load(tmp_path / "nothing")


def test_same_seed_same_networks(swinging):
    first, same, other = (Learned.train([swinging], steps=8, batch=16, hidden=2, seed=s).sinusoids(swinging)[0]
                          for s in (1, 1, 2))
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


@pytest.fixture(scope="module")
def striding() -> tk.Clip:
    """Three seconds of a walk on a curve, whose sides and axes all differ."""
    return tk.datasets.procedural.generate("Drunk", "FW", 3.0, seed=2).moved(turn=0.7)


def test_limb_curves_are_velocities_in_limb_lengths_outwards_up_and_forward(striding):
    clip = striding.resample(30.0)
    index, offsets = clip.skeleton.index, clip.skeleton.offsets.double()
    chains = {"hand": ("shoulder", "elbow", "hand"), "foot": ("hip", "knee", "foot", "toe")}
    for limb in tk.phases.LIMBS:
        side, part = limb.split("_")
        joints = [index(f"{side}_{role}") for role in chains[part]]
        assert [clip.skeleton.parents[j] for j in joints[1:]] == joints[:-1]
        length = sum(math.sqrt(float((offsets[j] ** 2).sum())) for j in joints[1:])
        back, where = tk.motion.rotations.inverse(tk.motion.root_frames(clip).rotations), clip.global_positions
        reach = [[tk.motion.rotations.rotate(back[f], where[f, j] - where[f, 0]) for j in (joints[1], joints[-1])]
                 for f in range(len(clip))]
        outwards = -1 if side == "right" else 1
        found = learned.limb_curves(clip, limb)
        assert found.shape == (len(clip), 6)
        for frame in range(len(clip)):
            before, after = max(frame - 1, 0), min(frame + 1, len(clip) - 1)
            seconds = (after - before) / 30
            expected = [float(reach[after][j][k] - reach[before][j][k]) / seconds / length * (outwards if k == 0 else 1)
                        for j in (0, 1) for k in range(3)]
            assert found[frame].tolist() == pytest.approx(expected, abs=2e-4)


def test_limb_curves_are_alike_on_both_sides_and_at_every_size(striding):
    mirrored = striding.mirrored()
    skeleton = replace(striding.skeleton, offsets=2 * striding.skeleton.offsets)
    large = striding.replace(skeleton=skeleton, root_positions=2 * striding.root_positions)
    for part in learned.PARTS:
        left, right = (learned.limb_curves(striding, f"{side}_{part}") for side in ("left", "right"))
        assert float((left - right).abs().max()) > 0.1
        assert torch.allclose(learned.limb_curves(mirrored, f"right_{part}"), left, atol=2e-3)
        assert torch.allclose(learned.limb_curves(mirrored, f"left_{part}"), right, atol=2e-3)
        assert torch.allclose(learned.limb_curves(large, f"left_{part}"), left, atol=2e-3)


def test_windows_can_be_cut_around_some_frames_only_and_do_not_care_for_size():
    curves = torch.randn(100, 2, generator=torch.Generator().manual_seed(1)).cumsum(0)
    windows = learned.cut(curves, 30.0)
    assert windows.shape == (100, 2, learned.SAMPLES)
    assert torch.equal(learned.cut(curves, 30.0, every=7), windows[::7])
    assert torch.allclose(learned.cut(1e-2 * curves, 30.0), windows, atol=1e-5)
    assert float((windows - 5).square().mean()) == pytest.approx(26, rel=1e-4)
    assert float(learned.cut(torch.full((100, 2), 3.0), 30.0).abs().max()) == 0  # what rests is not blown up
    faint = learned.cut(1e-7 * curves, 30.0).square().mean((1, 2)).sqrt()
    assert float(faint.max()) < 0.1


def test_windows_sample_a_wave_of_any_rate_at_their_own():
    time = torch.arange(360, dtype=torch.float64)[:, None] / 90
    windows = learned.cut(torch.sin(TURN * 1.5 * time).float(), 90.0)
    around = torch.arange(-20, 21) / 20
    for frame in (90, 181, 269):  # three whole cycles, but for the last sample
        expected = torch.sin(TURN * 1.5 * (frame / 90 + around))
        expected = expected - expected.mean()
        assert torch.allclose(windows[frame, 0], (expected / expected.square().mean().sqrt()).float(), atol=1e-4)


def test_spectra_of_many_curves_are_those_of_each():
    curves = torch.randn(3, 5, 41, generator=torch.Generator().manual_seed(2))
    many = learned.spectrum(curves, 20.0)
    for i in range(3):
        for j in range(5):
            for column, alone in zip(many, learned.spectrum(curves[i, j], 20.0), strict=True):
                assert float(column[i, j]) == pytest.approx(float(alone), rel=1e-5)
    silent = learned.spectrum(torch.zeros(2, 41), 20.0)
    assert all(bool(column.isfinite().all()) and float(column.abs().max()) < 1e-6 for column in silent)


def test_a_wave_is_the_sinusoid_around_the_middle():
    network = PeriodicAutoencoder(curves=2, hidden=2, samples=9, rate=4.0)
    wave = network.wave(*(torch.tensor(v) for v in ([0.3, -2.0], [0.5, 1.25], [2.0, 0.7], [1.0, -3.0])))
    for row, (p, f, a, b) in enumerate(((0.3, 0.5, 2.0, 1.0), (-2.0, 1.25, 0.7, -3.0))):
        expected = [a * math.sin(TURN * f * (k - 4) / 4 + p) + b for k in range(9)]
        assert wave[row].tolist() == pytest.approx(expected, abs=1e-5)


def test_the_network_has_one_latent_curve_and_phases_spread_over_a_batch():
    torch.manual_seed(1)
    network, x = PeriodicAutoencoder(curves=6, hidden=3), torch.randn(64, 6, learned.SAMPLES)
    assert network.encoder(x).shape == (64, 1, learned.SAMPLES)
    latent, phase, frequency, amplitude, offset = network.sinusoid(x)
    assert latent.shape == (64, learned.SAMPLES)
    assert phase.shape == frequency.shape == amplitude.shape == offset.shape == (64,)
    vectors = network.shift(latent)
    assert torch.allclose(phase, torch.tensor([math.atan2(y, x) for y, x in vectors.tolist()]), atol=1e-5)
    assert torch.allclose(vectors.mean(0), torch.zeros(2), atol=1e-5)  # while it learns, a batch's angles are all round
    assert torch.allclose(vectors.std(0, correction=0), torch.ones(2), atol=1e-2)
    rebuilt = network.decoder(network.wave(phase, frequency, amplitude, offset)[:, None])
    assert torch.allclose(network(x), rebuilt, atol=1e-4)


def test_layers_start_small_and_on_both_sides_of_zero():
    torch.manual_seed(2)
    layer, bound = Convolution(3, 400, 9), 1 / math.sqrt(27)
    assert layer.weight.shape == (3, 400, 9)
    assert layer.bias.shape == (400, 1)
    for values in (layer.weight.detach(), layer.bias.detach()):
        assert -bound <= float(values.min()) < -0.95 * bound
        assert 0.95 * bound < float(values.max()) <= bound
        assert abs(float(values.mean())) < 0.1 * bound


@pytest.fixture(scope="module")
def seen(striding):
    """What `Learned.train` learns from, and what it makes of networks that have learned nothing: a list of its steps."""
    steps = []

    def look(network, windows, count, batch, rate, name):
        steps.append((network.eval(), windows, count, batch, rate, name))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(learned, "_descend", look)
        clips = [striding, striding.cut(0, 120).resample(5.0)]
        sources = [Learned.train(clips, steps=7, batch=9, rate=0.1, hidden=3, seed=seed) for seed in range(6)]
    return steps, sources


def test_five_windows_a_second_are_cut_at_every_speed(seen, striding):
    steps = seen[0]
    slow = striding.cut(0, 120).resample(5.0)
    for i, part in enumerate(("hand", "foot")):
        expected = [learned.cut(learned.limb_curves(clip, f"{side}_{part}"), clip.fps * speed)[::every]
                    for clip, every in ((striding, 12), (slow, 1)) for side in ("left", "right")
                    for speed in (0.75, 1.0, 1.33)]
        network, windows, *given = steps[i]
        assert torch.equal(windows, torch.cat(expected))
        assert given == [7, 9, 0.1, None]
        assert network.hidden == 3


def test_factors_give_unit_power_and_rise_where_the_limb_goes_forward(seen):
    steps, sources = seen
    signs = set()
    for i, source in enumerate(sources):
        for part, (network, windows, *_) in zip(learned.PARTS, steps[2 * i : 2 * i + 2], strict=True):
            with torch.no_grad():
                latent = network.encoder(windows)[:, 0].double().numpy()
            along = 0.0
            for curve, window in zip(latent, windows.double().numpy(), strict=True):
                forward = np.cumsum(window[5])  # of the end joint: where its velocity leads
                along += float(curve @ (forward - forward.mean()))
            assert source.factors[part] == pytest.approx(np.sign(along) / np.sqrt((latent**2).mean()), rel=1e-4)
            signs.add(source.factors[part] > 0)
    assert signs == {True, False}


def test_a_factor_scales_and_its_sign_turns_half_a_cycle(small, swinging):
    curve, found = Learned(small.networks, {"hand": 1.0, "foot": 1.0}).sinusoids(swinging)
    for hand, foot in ((0.5, -3.0), (-0.25, 4.0)):
        scaled, other = Learned(small.networks, {"hand": hand, "foot": foot}).sinusoids(swinging)
        factors = torch.tensor([hand, hand, foot, foot], dtype=torch.float64)
        assert torch.allclose(scaled, curve * factors, atol=1e-5)
        assert torch.allclose(other.offset, found.offset * factors, atol=1e-5)
        for column, plain in ((other.amplitude, found.amplitude), (other.residual, found.residual)):
            assert torch.allclose(column, plain * factors.abs(), atol=1e-5)
        assert torch.equal(other.frequency, found.frequency)
        assert float(torch.sin((other.phase - found.phase - math.pi * (factors < 0)) / 2).abs().max()) < 1e-5
        assert 0 <= float(other.phase.min()) < float(other.phase.max()) <= TURN


def test_sinusoids_are_the_networks_own_window_by_window(small, swinging):
    curve, found = Learned(small.networks, {"hand": 2.0, "foot": 2.0}).sinusoids(swinging)
    assert all(column.dtype == torch.float64 for column in (curve, *vars(found).values()))
    for i, limb in enumerate(tk.phases.LIMBS):
        network = small.networks[limb.split("_")[1]]
        for frame, window in list(enumerate(learned.cut(learned.limb_curves(swinging, limb), 60.0)))[::48]:
            with torch.no_grad():
                latent, phase, frequency, amplitude, offset = (v[0] for v in network.sinusoid(window[None]))
            wave = [float(amplitude) * math.sin(TURN * float(frequency) * k / 20 + float(phase)) + float(offset)
                    for k in range(-20, 21)]
            residual = math.sqrt(sum((a - b) ** 2 for a, b in zip(latent.tolist(), wave, strict=True)) / 41)
            assert float(curve[frame, i]) == pytest.approx(2 * float(latent[20]), abs=1e-4)
            assert float(found.amplitude[frame, i]) == pytest.approx(2 * float(amplitude), abs=1e-4)
            assert float(found.offset[frame, i]) == pytest.approx(2 * float(offset), abs=1e-4)
            assert float(found.residual[frame, i]) == pytest.approx(2 * residual, abs=1e-4)
            assert abs(math.remainder(float(found.phase[frame, i]) - float(phase), TURN)) < 1e-4


def test_frequency_is_the_mean_growth_over_a_second_within_the_fits_bounds():
    grown = torch.rand(70, generator=torch.Generator().manual_seed(3), dtype=torch.float64).cumsum(0) + 0.1
    found = learned._growth(torch.atan2(grown.sin(), grown.cos()), 10.0)
    near = [(max(f - 1, 0), min(f + 1, 69)) for f in range(70)]
    rates = [float(grown[after] - grown[before]) / (after - before) * 10 / TURN for before, after in near]
    for frame in range(70):
        at = [min(max(frame + k, 0), 69) for k in range(-5, 6)]
        assert float(found[frame]) == pytest.approx(sum(rates[k] for k in at) / 11)
    for step, limit in ((0.0, 0.25), (-0.2, 0.25), (2.9, 4.0)):
        assert learned._growth(step * torch.arange(60) % TURN, 10.0).tolist() == pytest.approx([limit] * 60)


def test_training_needs_a_clip_and_leaves_the_random_numbers_alone(swinging):
    with pytest.raises(ValueError) as error:  # noqa: PT011
        Learned.train([])
    assert str(error.value) == "a learned source needs at least one clip to train on, got none"
    torch.manual_seed(5)
    expected = torch.rand(3)
    torch.manual_seed(5)
    source = Learned.train([swinging.cut(0, 120)], steps=4, batch=8, hidden=2, seed=1)
    assert torch.equal(torch.rand(3), expected)
    assert not any(network.training for network in source.networks.values())


def test_progress_is_shown_when_asked_for(swinging, capfd, monkeypatch):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    clip = swinging.cut(0, 120)
    Learned.train([clip], steps=4, batch=8, hidden=2)
    assert capfd.readouterr() == ("", "")
    Learned.train([clip], steps=4, batch=8, hidden=2, progress=True)
    shown = capfd.readouterr().err
    for part in learned.PARTS:
        assert re.search(rf"{part}s: 100%.*4/4.*loss=\d+\.\d{{3}}", shown)


def test_training_takes_as_many_steps_as_asked_and_brings_the_error_down(swinging):
    windows = learned.cut(learned.limb_curves(swinging, "left_hand"), 60.0, 3)
    torch.manual_seed(4)
    network = PeriodicAutoencoder(hidden=4)
    errors = []
    forward = network.forward

    def watched(some):
        rebuilt = forward(some)
        assert some.shape == (16, 6, learned.SAMPLES)
        assert all(bool((windows == row).all((1, 2)).any()) for row in some[:2])
        errors.append(float((rebuilt.detach() - some).square().mean()))
        return rebuilt

    network.forward = watched
    learned._descend(network, windows, 60, 16, 1e-2, None)
    assert len(errors) == 60
    assert sum(errors[-10:]) < 0.8 * sum(errors[:10])
    assert not network.training


def test_the_packaged_one_learned_from_every_style_but_those_held_out(monkeypatch):
    asked = []
    monkeypatch.setattr(learned.procedural, "load", lambda *args, **kwargs: asked.append((args, kwargs)) or ["clips"])
    assert learned.training_clips() == ["clips"]
    ((styles, gaits), rest), = asked
    assert sorted([*styles, *learned.HELD_OUT]) == sorted(learned.procedural.STYLES)
    assert gaits == ("FW", "BW", "FR", "SW", "TR1")
    assert rest == {"seconds": 12.0, "seed": 0}


def test_every_damage_of_a_file_is_one_line(small, tmp_path):
    small.save(tmp_path / "own")
    loaded = Learned.load(tmp_path / "own")
    assert loaded.factors == small.factors
    assert not any(network.training for network in loaded.networks.values())
    tensors, parts = tk.io.model_files.read(tmp_path / "own", "learned")
    assert parts["learned"] == {"hidden": {"hand": 4, "foot": 4}, "factors": small.factors}
    assert all(key.startswith(("learned.hand.", "learned.foot.")) and not key.endswith(".time") for key in tensors)
    for broken in ({"hidden": {"hand": 4}, "factors": small.factors}, {"hidden": {"hand": 4, "foot": 4}},
                   {"hidden": {"hand": 4, "foot": 5}, "factors": small.factors},
                   {"hidden": {"hand": 4, "foot": 4}, "factors": {"hand": 1.0, "foot": "x"}}, 3):
        tk.io.model_files.write(tmp_path / "broken", tensors, {"learned": broken})
        with pytest.raises(ValueError, match=r"broken: the learned source in it is damaged \(.+\)$") as error:
            Learned.load(tmp_path / "broken")
        assert "\n" not in str(error.value)
        assert "  " not in str(error.value)


def test_between_its_convolutions_the_network_normalises_each_curve_and_bounds_it():
    torch.manual_seed(6)
    network, x = PeriodicAutoencoder(curves=2, hidden=3, samples=9), torch.randn(4, 2, 9)
    first, *_, last = network.encoder
    with torch.no_grad():
        hidden = torch.empty(4, 3, 9)
        for b, window in enumerate(first(x)):
            for i, curve in enumerate(window.double().numpy()):
                hidden[b, i] = torch.from_numpy(np.tanh((curve - curve.mean()) / np.sqrt(curve.var() + 1e-5)))
        assert torch.allclose(network.encoder(x), last(hidden), atol=1e-5)
