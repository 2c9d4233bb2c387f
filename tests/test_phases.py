"""Local phases: the fit against known sinusoids and against scipy, sources, post-processing."""

import itertools
import math

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares

import toolkit as tk
from toolkit.benchmarks import phases as bench
from toolkit.datasets import procedural
from toolkit.phases import LIMBS, Sinusoids, coherent, fit, normalise, smooth, windows

FPS = 60.0


def sinusoid(frequency, amplitude=1.3, shift=0.4, offset=0.2, frames=240):
    t = torch.arange(frames, dtype=torch.float64) / FPS
    return (amplitude * torch.sin(2 * math.pi * (frequency * t - shift)) + offset)[:, None]


@settings(max_examples=25, deadline=None)
@given(st.floats(0.6, 3.9), st.floats(0.1, 3.0), st.floats(-0.5, 0.5), st.floats(-1, 1))
def test_a_sinusoid_is_found_again(frequency, amplitude, shift, offset):
    curve = sinusoid(frequency, amplitude, shift, offset)
    found = fit(curve, FPS)
    inner = slice(40, -40)
    t = torch.arange(len(curve), dtype=torch.float64) / FPS
    angle = (found.phase[:, 0] - 2 * math.pi * (frequency * t - shift))[inner]
    assert float(torch.atan2(angle.sin(), angle.cos()).abs().max()) < 0.05
    assert float((found.frequency[inner] - frequency).abs().max()) < 0.05
    assert float(found.residual[inner].max()) < 0.02 * amplitude


def test_residual_is_no_worse_than_a_well_started_optimiser(walk_clip):
    """On a real-looking source, against scipy started from eight frequencies on every 20th window."""
    curve = tk.phases.extract(walk_clip).source[:, 2].double()
    found = fit(curve[:, None], FPS)
    t = torch.arange(-30, 31, dtype=torch.float64).numpy() / FPS
    for frame in range(40, len(curve) - 40, 20):
        window = curve[frame - 30 : frame + 31].numpy()
        low, high = window.min(), window.max()
        best = min(
            least_squares(lambda p, w=window: p[0] * np.sin(2 * math.pi * (p[1] * t - p[2])) + p[3] - w,
                          [(high - low) / 2, f, s, window.mean()],
                          bounds=([0, 0.25, -0.5, low - 1e-9], [high - low + 1e-9, 4.0, 0.5, high + 1e-9])).cost
            for f in (0.5, 1.0, 2.0, 3.0) for s in (-0.25, 0.25)
        )  # fmt: skip
        assert float(found.residual[frame, 0]) <= math.sqrt(2 * best / len(t)) * 1.05 + 1e-3


def test_fit_keeps_its_bounds():
    noise = torch.randn(300, 4, generator=torch.Generator().manual_seed(1), dtype=torch.float64)
    found = fit(noise, FPS)
    assert float(found.frequency.min()) >= 0.25
    assert float(found.frequency.max()) <= 4.0
    assert float(found.amplitude.min()) >= 0
    assert float(found.amplitude.max()) <= float(noise.max() - noise.min())


def test_normalising_is_a_windowed_z_score():
    curve = torch.randn(200, 1, generator=torch.Generator().manual_seed(0), dtype=torch.float64).cumsum(0)
    got = normalise(curve, FPS)
    for frame in (40, 100, 150):
        window = curve[frame - 30 : frame + 31, 0]
        expected = (curve[frame, 0] - window.mean()) / window.std(correction=0)
        assert float(got[frame, 0]) == pytest.approx(float(expected), abs=1e-6)
    assert float(normalise(torch.full((100, 1), 3.0, dtype=torch.float64), FPS).abs().max()) == 0


def test_smoothing_keeps_slow_and_removes_fast_motion():
    slow, fast = sinusoid(0.5, 1, 0, 0), sinusoid(15.0, 1, 0, 0)
    assert float((smooth(slow, FPS) - slow)[60:-60].abs().max()) < 0.02
    assert float(smooth(fast, FPS)[60:-60].abs().max()) < 0.02


def test_feet_take_contacts_and_hands_do_not(walk_clip):
    hybrid = tk.phases.Hybrid()
    assert [hybrid.choice(walk_clip, limb) for limb in LIMBS] == ["contact-free", "contact-free", "contact", "contact"]
    contact, both = (tk.phases.extract(walk_clip, source=source).vector for source in ("contact", "hybrid"))
    assert float(contact[:, :2].abs().max()) == 0
    assert torch.equal(contact[:, 2:], both[:, 2:])


def test_a_raised_foot_takes_the_contact_free_source():
    (hop,) = tk.datasets.load("procedural", styles=["HopLeft"], gaits=["FW"], seconds=4.0)
    hybrid = tk.phases.Hybrid()
    chosen = {limb: hybrid.choice(hop, limb) for limb in LIMBS}
    assert sorted(chosen[limb] for limb in ("left_foot", "right_foot")) == ["contact", "contact-free"]


def test_phases_do_not_change_when_the_character_is_moved_or_turned(walk_clip):
    here, there = tk.phases.extract(walk_clip), tk.phases.extract(walk_clip.moved(turn=2.0, shift=(3.0, 0.0, -5.0)))
    assert float((here.vector - there.vector).abs().max()) < 2e-3


def test_feet_are_half_a_cycle_apart_in_a_walk(walk_clip):
    ph = tk.phases.extract(walk_clip)
    apart = ph.phase[60:-60, 2] - ph.phase[60:-60, 3]
    mean = math.atan2(float(apart.sin().mean()), float(apart.cos().mean()))
    assert abs(abs(mean) - math.pi) < 0.5


def test_own_source_function(walk_clip):
    ph = tk.phases.extract(walk_clip, source=lambda clip, limb: clip.global_positions[:, clip.skeleton.index(limb), 1])
    assert ph.vector.shape == (len(walk_clip), 4, 2)


@pytest.mark.parametrize("frequency", [0.6, 0.8, 1.6])
def test_a_window_holds_a_whole_cycle_and_a_second_at_least(frequency):
    wave = sinusoid(frequency, frames=600)[:, 0]
    drift = torch.linspace(0, 5, 600, dtype=torch.float64)
    for curve in (wave, (wave > 0.4).double(), wave + drift):
        assert windows.half_window(curve, FPS) == pytest.approx(max(0.5, windows.CYCLES / 2 / frequency), abs=0.02)
    assert windows.half_window(torch.ones(600), FPS) == 0.5
    assert windows.half_window(drift, FPS) == 0.5


def test_a_slow_foot_that_stands_longer_than_a_second_is_followed():
    stance = torch.arange(900) % 100 < 66  # 0.6 Hz, 1.1 s on the floor: a one-second window sees no change in the middle
    truth = 2 * math.pi * torch.arange(900, dtype=torch.float64)[:, None] / 100

    def source(clip, limb):
        return stance.double()

    clip = procedural.generate("Neutral", "ID", 15.0)
    error = {half: float(tk.metrics.phase_error(tk.phases.extract(clip, source, half).phase[90:-90], truth[90:-90])[0].max())
             for half in (None, 0.5)}  # fmt: skip
    assert error[None] < math.radians(10) < math.radians(30) < error[0.5]


def test_amplitude_is_that_of_the_least_squares_sinusoid():
    noise = torch.randn(120, 2, generator=torch.Generator().manual_seed(2), dtype=torch.float64)
    curve = smooth(noise, FPS) + sinusoid(1.3, frames=120)
    frequency = torch.full_like(curve, 1.3)
    got = windows.amplitude(curve, frequency, FPS)
    t = np.arange(-15, 16) / FPS
    basis = np.stack((np.sin(2 * np.pi * 1.3 * t), np.cos(2 * np.pi * 1.3 * t), np.ones_like(t)), 1)
    for frame in range(15, 105, 10):
        for limb in range(2):
            window = curve[frame - 15 : frame + 16, limb].numpy()
            a, b, _ = np.linalg.lstsq(basis, window, rcond=None)[0]
            assert float(got[frame, limb]) == pytest.approx(min(math.hypot(a, b), window.max() - window.min()), rel=1e-9)


def test_a_source_may_bring_its_own_sinusoids(walk_clip):
    angle = (torch.arange(len(walk_clip), dtype=torch.float64)[:, None] / 8 + torch.arange(4)) % (2 * math.pi)
    one = torch.ones_like(angle)

    class Own:
        def sinusoids(self, clip):
            return 2 * angle.sin(), Sinusoids(angle, one * FPS / (16 * math.pi), 2 * one, 0 * one, 0 * one)

    ph = tk.phases.extract(walk_clip, Own())
    error, lag = tk.metrics.phase_error(ph.phase[30:-30], angle[30:-30])
    assert float(error.max()) < 0.02
    assert float(lag.abs().max()) < 0.02
    assert torch.allclose(ph.fit, ph.source)
    speed = torch.stack([windows.speed(tk.phases.local_positions(walk_clip, limb), FPS) for limb in LIMBS], 1)
    assert torch.allclose(ph.vector.norm(dim=-1)[60:-60].double(), 2 * smooth(speed, FPS)[60:-60], rtol=0.02)


def test_velocity_is_a_quarter_of_a_cycle_ahead_of_position(walk_clip):
    here, ahead = (tk.phases.extract(walk_clip, source).phase[60:-60, :2] for source in ("contact-free", "velocity"))
    error, lag = tk.metrics.phase_error(ahead, here)
    assert float(error.max()) < 0.1
    assert torch.allclose(lag, torch.full((2,), math.pi / 2, dtype=lag.dtype), atol=0.1)


def test_the_reason_for_a_choice_can_be_read(walk_clip):
    hybrid = tk.phases.Hybrid()
    assert hybrid.reason(walk_clip, "left_hand") == "contact-free: a hand touches nothing"
    assert hybrid.reason(walk_clip, "left_foot").startswith("contact: the foot touches the floor in")
    assert "under 101%" in tk.phases.Hybrid(least=1.01).reason(walk_clip, "left_foot")


def test_wavelets_turn_a_cosine_into_a_turning_number():
    t = torch.arange(600, dtype=torch.float64) / FPS
    band = 40
    f = float(coherent.BANDS[band])
    got = coherent.wavelets(torch.cos(2 * math.pi * f * t)[:, None], FPS, 2.5)[band, 200:400, 0]
    assert float((got - torch.exp(2j * math.pi * f * t[200:400])).abs().max()) < 0.02


def test_the_ridge_is_the_best_of_all_paths():
    power = torch.rand(4, 6, generator=torch.Generator().manual_seed(0), dtype=torch.float64) ** 3
    cost = -(power / power.sum(0)).log()

    def total(path):
        jumps = sum((a - b) ** 2 for a, b in itertools.pairwise(path))
        return sum(float(cost[b, i]) for i, b in enumerate(path)) + 0.3 * jumps

    best = min(itertools.product(range(4), repeat=6), key=total)
    assert coherent.ridge(power, 1, 0.3).tolist() == list(best)


def test_limbs_that_agree_lend_each_other_their_rhythm_and_others_keep_theirs():
    noise = torch.randn(4, 2000, 4, generator=torch.Generator().manual_seed(3), dtype=torch.float64)
    shared = torch.exp(0.1j * torch.arange(2000, dtype=torch.float64))[:, None]
    noisy = torch.complex(noise[0], noise[1]) * 0.5 + shared * torch.exp(1j * torch.arange(4))
    apart = [(z / shared[:, 0]).angle().std() for z in (noisy[:, 0], coherent.agreed(noisy, 0))]
    assert float(apart[1]) < 0.8 * float(apart[0])
    lonely = torch.complex(noise[2], noise[3])
    assert float((coherent.agreed(lonely, 0) - lonely[:, 0]).abs().max()) < 0.05


def test_regression_is_that_of_least_squares_in_each_window():
    curve, wave = torch.randn(2, 200, generator=torch.Generator().manual_seed(4), dtype=torch.float64)
    curve = curve + wave
    found = torch.stack(coherent.regression(curve, wave, 0.5, FPS), 1)
    for frame in range(30, 170, 20):
        window = slice(frame - 30, frame + 31)
        basis = torch.stack((wave[window], torch.ones(61, dtype=torch.float64)), 1)
        a, b = torch.linalg.lstsq(basis, curve[window]).solution
        rms = (basis @ torch.stack((a, b)) - curve[window]).square().mean().sqrt()
        assert torch.allclose(found[frame], torch.stack((a, b, rms)))


def test_steps_count_the_cycles_of_a_foot_however_irregular():
    contact = torch.zeros(60, dtype=torch.float64)
    for start, stop in ((5, 12), (21, 32), (45, 52)):
        contact[start:stop] = 1
    signal = coherent.stepped(contact)
    assert torch.allclose(signal[[8, 26, 48]].real, torch.ones(3, dtype=torch.float64))  # amid the contacts
    assert torch.allclose(signal[[16, 38]].real, -torch.ones(2, dtype=torch.float64))  # amid the swings
    assert torch.allclose(signal[12], 1j ** torch.tensor(1.0, dtype=torch.complex128))  # half-way


def test_coherent_is_nearer_to_the_truth_than_contact_free_when_staggering():
    clip, truth = procedural.truth(procedural.STYLES["Drunk"], "FW", 20.0, seed=1)
    inner = slice(60, -60)
    error = {source: tk.metrics.phase_error(tk.phases.extract(clip, source).phase[inner], truth.phase[inner])[0].mean()
             for source in ("coherent", "contact-free")}  # fmt: skip
    assert float(error["coherent"]) < 0.8 * float(error["contact-free"])


@pytest.mark.parametrize("style", ["Neutral", "Zombie", "Penguin"])
def test_cyclic_styles_keep_the_limits_against_the_truth(style):
    sources = {name: tk.phases.SOURCES[name] for name in ("contact", "contact-free")}
    row = bench.measure(style, *procedural.truth(style, "FW", 20.0, 3), "cyclic", sources)
    assert bench.failures(row) == []
    assert row.phase["contact"][:2].isnan().all()  # a hand has no contact, and no error either


def test_the_bench_names_what_fails():
    nan = math.nan
    phase = {"contact": torch.tensor([nan, nan, 25.0, 3.0]), "contact-free": torch.tensor([1.0, nan, 9.0, 9.0])}
    frequency = {"contact": torch.full((4,), 0.01), "contact-free": torch.tensor([0.05, nan, 0.0, 0.0])}
    row = bench.Row("Odd", "cyclic", phase, frequency, [0.99, 0.9])
    assert bench.failures(row) == ["contact feet 25.0°", "frequency of the hands 5.0%", "F1 0.900"]


def test_phases_agree_with_what_the_published_network_predicts(shared):
    folder, file = shared / "lpn_film_100style", shared / "100style" / "Neutral_FW.bvh"
    if not folder.is_dir() or not file.is_file():
        pytest.skip(f"needs {folder} and {file}")
    model, bank = tk.published.load(folder)
    assert tk.published.one_step(model, bank, tk.bvh.load(file), "Neutral", (327, None))["phase_error"] < 0.15


@pytest.mark.parametrize(("source", "message"), [
    ("hybird", "unknown phase source 'hybird'; there are hybrid"),
    (lambda clip, limb: torch.zeros(3), "one finite number per frame"),
    (lambda clip, limb: torch.full((len(clip),), math.nan), "one finite number per frame"),
])  # fmt: skip
def test_bad_sources_are_refused(walk_clip, source, message):
    with pytest.raises(ValueError, match=message):
        tk.phases.extract(walk_clip, source=source)


def test_a_clip_shorter_than_the_window_is_refused(walk_clip):
    with pytest.raises(ValueError, match="30 frames are too few for phases, which need 61"):
        tk.phases.extract(walk_clip.cut(0, 30))


def test_phase_error_forgives_a_constant_lag_and_nothing_else():
    truth = torch.arange(600, dtype=torch.float64)[:, None] / 60 * torch.tensor([5.0, 6.0, 7.0])
    found = truth + torch.tensor([0.0, 3.0, 0.0])
    found[:, 2] = 7.0  # stuck
    error, lag = tk.metrics.phase_error(found % (2 * math.pi), truth)
    assert float(error[:2].max()) < 1e-9
    assert float(lag[1]) == pytest.approx(3.0)
    assert float(error[2]) == pytest.approx(math.pi / 2, rel=0.05)
