"""Local phases: sources, windows, extraction."""

import math

import numpy as np
import pytest
import torch
from course.labels import measure
from refusal import refusal

import toolkit as tk
from experiments import phases as bench
from toolkit.datasets import procedural
from toolkit.phases import LIMBS, Sinusoids, fit, normalise, smooth, windows

FPS = 60.0
TURN = 2 * math.pi


def random(seed, *shape):
    return torch.randn(*shape, generator=torch.Generator().manual_seed(seed), dtype=torch.float64)


def apart(a, b):
    """Largest difference of angles, radians."""
    return float(torch.atan2((a - b).sin(), (a - b).cos()).abs().max())


# Sources


def test_feet_take_contacts_and_hands_do_not(walk_clip):
    hybrid = tk.phases.Hybrid()
    chosen = [hybrid.choice(walk_clip, limb) for limb in LIMBS]
    assert chosen == ["contact-free", "contact-free", "contact", "contact"]
    contact, free, both = (tk.phases.extract(walk_clip, source=source)
                           for source in ("contact", "contact-free", "hybrid"))
    assert float(contact.vector[:, :2].abs().max()) == 0
    assert torch.equal(free.vector[:, :2], both.vector[:, :2])
    # a fitted sinusoid and the steps themselves agree in a regular walk
    error, lag = tk.metrics.phase_error(contact.phase[60:-60, 2:], both.phase[60:-60, 2:])
    assert error.max() < math.radians(4)
    assert lag.abs().max() < math.radians(6)
    feet = both.phase[60:-60, 2] - both.phase[60:-60, 3]
    assert (feet - math.pi).cos().mean() > 0.9  # half a cycle apart


def test_contact_free_is_the_longest_axis_of_all_clips_and_points_forward(walk_clip):
    clips = [walk_clip.cut(0, 200), procedural.generate("Zombie", "FW", 4.0).moved(turn=1.0)]
    source = tk.phases.ContactFree()
    fitted, hybrid = source.fitted(clips), tk.phases.Hybrid().fitted(clips)
    for limb in LIMBS:
        where = [tk.phases.local_positions(clip, limb).double().numpy() for clip in clips]
        points = np.concatenate(where)
        swing = [own[f] - around(own, f, 30).mean(0) for own in where for f in range(len(own))]
        axis = np.linalg.svd(swing - np.mean(swing, 0))[2][0]
        axis = axis * np.sign(axis[2])  # the skeleton faces +z
        for clip, own in zip(clips, where, strict=True):
            expected = (own - points.mean(0)) @ axis
            assert fitted(clip, limb).numpy() == pytest.approx(expected, abs=1e-6)
            if limb.endswith("hand"):
                assert torch.equal(hybrid(clip, limb), fitted(clip, limb))
        alone = source(clips[0], limb)
        assert torch.equal(alone, source.fitted(clips[:1])(clips[0], limb))
        assert (alone - fitted(clips[0], limb)).abs().max() > 1e-3
    assert source.axes == source.means == {}


@pytest.mark.parametrize("bad", [torch.zeros(3), torch.full((480,), math.nan)])
def test_bad_sources_are_refused(walk_clip, bad):
    with refusal(r"must give one finite number per frame \(480\) for every"):
        tk.phases.extract(walk_clip, source=lambda clip, limb: bad)


# Extraction


@pytest.mark.parametrize("fps", [30.0, 60.0])
def test_a_second_is_the_shortest_clip(fps):
    half = round(fps / 2)
    clip = procedural.generate("Neutral", "FW", 2.0).resample(fps).replace(name="brief")
    least = clip.cut(0, 2 * half + 1)
    assert len(tk.phases.extract(least, "contact-free").phase) == 2 * half + 1
    said = rf"^brief: {2 * half} frames are too few .* need {2 * half + 1} .* at {fps:g} Hz"
    with refusal(said):
        tk.phases.extract(clip.cut(0, 2 * half), "contact-free")


def test_fields_are_what_they_say(walk_clip):
    """Each field against the fit of each limb's own curve; the vector against equation (1)."""
    source = tk.phases.ContactFree().fitted([walk_clip])
    ph = tk.phases.extract(walk_clip, lambda clip, limb: source(clip, limb))
    assert {x.dtype for name, x in vars(ph).items() if name != "limbs"} == {torch.float32}
    for i, limb in enumerate(LIMBS):
        raw = source(walk_clip, limb)[:, None]
        half = windows.half_window(raw[:, 0], FPS)
        curve = smooth(normalise(raw, FPS, half), FPS)
        found = fit(curve, FPS, half)
        wave = found.amplitude * found.phase.sin() + found.offset
        for name, expected in (("source", curve), ("frequency", found.frequency), ("fit", wave),
                               ("amplitude", found.amplitude), ("residual", found.residual)):
            column = getattr(ph, name)[:, i].double()
            assert torch.allclose(column, expected[:, 0], atol=1e-5)
        sine, cosine = (smooth(way, FPS)[:, 0] for way in (found.phase.sin(), found.phase.cos()))
        speed = windows.speed(tk.phases.local_positions(walk_clip, limb), FPS)
        size = smooth(speed[:, None] * found.amplitude, FPS)[:, 0].clamp_min(0)
        expected = torch.stack((sine, cosine), 1) * (size / torch.hypot(sine, cosine))[:, None]
        assert torch.allclose(ph.vector[:, i].double(), expected, atol=1e-5)
        assert apart(ph.phase[:, i].double(), torch.atan2(sine, cosine)) < 1e-5
    assert 0 <= ph.phase.min() < ph.phase.max() <= TURN


class Some:
    """The position forwards of some joints."""

    def __init__(self, *limbs):
        self.limbs = limbs

    def __call__(self, clip, limb):
        return tk.phases.local_positions(clip, limb)[:, 2]


@pytest.mark.parametrize("limbs", [("right_foot",), (*LIMBS, "Head", "left_knee")])
def test_a_source_may_have_any_number_of_limbs(walk_clip, limbs):
    clips = [walk_clip, procedural.generate("Zombie", "FW", 8.0)]
    ph, four = (tk.phases.extract(walk_clip, Some(*names)) for names in (limbs, LIMBS))
    assert ph.limbs == limbs
    assert torch.equal(ph.vector[:, limbs.index("right_foot")], four.vector[:, 3])
    data = tk.features.build(clips, source=Some(*limbs))
    assert data.phases["Neutral"].shape[1] == data.layout.n_phases == 2 * len(limbs)
    again = tk.features.Layout.from_json(data.layout.to_json())
    assert again == data.layout != tk.features.Layout(walk_clip.skeleton)
    run = tk.training.fit(data, tk.training.Config.quick(steps=2, refit=1))
    walked = tk.runtime.rollout(run.model, tk.runtime.straight(1.0, 0.1), style=run.bank["Zombie"])
    assert len(walked) == 6


def test_a_source_that_is_constant_says_so(walk_clip):
    with pytest.warns(UserWarning, match="source is constant in all clips of a style and gait"):
        ph = tk.phases.extract(walk_clip, lambda clip, limb: torch.ones(len(clip)))
    assert not ph.vector.any()


def test_a_source_may_bring_its_own_sinusoids(walk_clip):
    angle = torch.arange(len(walk_clip), dtype=torch.float64)[:, None] / 8 + torch.arange(4)
    one = torch.ones_like(angle)

    class Own:
        def sinusoids(self, clip):
            rate = one * FPS / (8 * TURN)
            return 2 * angle.sin(), Sinusoids(angle % TURN, rate, 2 * one, 0 * one, 0 * one)

    ph = tk.phases.extract(walk_clip, Own())
    assert apart(ph.phase[30:-30], angle[30:-30]) < 0.05
    assert torch.allclose(ph.fit, ph.source)
    where = (tk.phases.local_positions(walk_clip, limb) for limb in LIMBS)
    speed = torch.stack([windows.speed(points, FPS) for points in where], 1)
    size = 2 * smooth(speed, FPS)[60:-60]
    assert torch.allclose(ph.vector.norm(dim=-1)[60:-60], size, rtol=0.02)


@pytest.mark.parametrize("style", ["Neutral", "Zombie"])
def test_cyclic_styles_keep_the_limits_against_the_truth(style):
    chosen = {name: tk.phases.named(name) for name in ("contact", "contact-free")}
    row = measure(style, *procedural.truth(style, "FW", 12.0, 3), chosen)
    for part, degrees in ((bench.PARTS["feet"], 20.0), (bench.PARTS["hands"], 15.0)):
        assert row.phase[part.source][part.columns].amax() <= degrees
        assert part.frequency_error(row) <= 0.03
    assert min(row.f1) >= 0.95
    assert row.phase["contact"][:2].isnan().all()  # a hand has no contact, and no error either


def test_phase_error_forgives_a_constant_lag_and_nothing_else():
    truth = torch.arange(600, dtype=torch.float64)[:, None] / 60 * torch.tensor([5.0, 6.0, 7.0])
    found = truth + torch.tensor([0.0, 3.0, 0.0])
    found[:, 2] = 7.0  # stuck
    error, lag = tk.metrics.phase_error(found % TURN, truth)
    assert error[:2].max() < 1e-9
    assert float(lag[1]) == pytest.approx(3.0)
    assert float(error[2]) == pytest.approx(math.pi / 2, rel=0.05)


# Windows


def around(values, frame, half):
    """The values in a window, with the ends repeated."""
    return values[[min(max(frame + k, 0), len(values) - 1) for k in range(-half, half + 1)]]


def test_means_are_over_what_is_there_with_the_ends_repeated():
    values = random(1, 25, 2, 3)
    for half, frames in ((0.5, 5), (0.26, 3), (0.0, 0), (4.0, 40)):
        got = windows.mean(values, half, 10.0)
        assert got.shape == values.shape
        for frame in range(25):
            assert torch.allclose(got[frame], around(values, frame, frames).mean(0))


@pytest.mark.parametrize("half", [0.3, 0.5])
def test_a_z_score_is_that_of_each_column_alone_at_the_ends_too(half):
    scale, shift = torch.tensor([1e-4, 1.0, 1e3]), torch.tensor([0.0, -2.0, 5.0])
    curves = random(2, 60, 3).cumsum(0) * scale + shift
    got = normalise(curves, 30.0, half)
    for frame in range(60):
        window = around(curves, frame, round(half * 30))
        expected = (curves[frame] - window.mean(0)) / window.std(0, correction=0)
        torch.testing.assert_close(got[frame], expected, rtol=0, atol=1e-6)


@pytest.mark.parametrize("fps", [30.0, 120.0])
def test_smoothing_halves_four_hertz_and_shifts_nothing(fps):
    """Gain of a second-order Butterworth filter passed twice: 1 / (1 + r⁴), r of warped rates."""
    t = torch.arange(round(8 * fps), dtype=torch.float64)[:, None] / fps
    rates = torch.tensor([0.5, 2.0, 4.0, 8.0], dtype=torch.float64)
    gain = 1 / (1 + (torch.tan(math.pi * rates / fps) / math.tan(math.pi * 4 / fps)) ** 4)
    wave = torch.sin(TURN * rates * t + 0.3)
    inner = slice(round(2 * fps), -round(2 * fps))
    assert (smooth(wave, fps) - gain * wave)[inner].abs().max() < 1e-4
    assert float(gain[2]) == pytest.approx(0.5)


def slow_half_window(curve, fps):
    """The definition in plain loops."""
    n = len(curve)
    fast = np.array([curve[f] - around(curve, f, round(fps)).mean() for f in range(n)])
    like = [float(fast[: n - lag] @ fast[lag:]) for lag in range(n)]
    peaks = [lag for lag in range(round(fps / 4), min(round(2 * fps), n - 2))
             if like[lag - 1] < like[lag] >= like[lag + 1] and like[lag] > 0.2 * like[0]]
    highest = sorted(peaks, key=lambda lag: like[lag])[-1:]
    return max([0.5, *(1.05 / 2 * lag / fps for lag in highest)])


def test_the_window_is_that_of_the_highest_peak_of_the_autocorrelation():
    rng = np.random.default_rng(5)
    seen = set()
    for trial in range(40):
        fps, n = (10.0, 16.0)[trial % 2], int(rng.integers(24, 120))
        t = np.arange(n) / fps
        noise, drift = rng.uniform(0, 1.5) * rng.normal(size=n), rng.uniform(0, 2) * t
        wave = np.sin(TURN * t / rng.uniform(0.5, 2.6))
        curve = (wave + noise + drift) * 10.0 ** rng.integers(-4, 3)
        expected = slow_half_window(curve, fps)
        assert windows.half_window(torch.from_numpy(curve), fps) == pytest.approx(expected)
        seen.add(round(expected, 3))
    assert 0.5 in seen
    assert len(seen) > 8
    opposite = torch.tensor([1.0, -1.0, *[0.0] * 13]).repeat(8)  # neighbours, every 1.5 seconds
    assert windows.half_window(opposite, 10.0) == pytest.approx(1.05 / 2 * 1.5)


def test_speed_is_the_root_mean_square_over_a_second():
    where = random(7, 40, 3).cumsum(0)
    got = windows.speed(where, 12.0)
    squares = torch.gradient(12 * where, dim=0)[0].square().sum(-1)
    expected = torch.stack([around(squares, frame, 6).mean().sqrt() for frame in range(40)])
    torch.testing.assert_close(got, expected, rtol=1e-5, atol=0)


def test_regression_is_that_of_least_squares_in_each_window():
    wave = random(4, 200)
    curve = random(5, 200) + wave
    found = torch.stack(windows.regression(curve, wave, 0.5, FPS), 1)
    for frame in range(30, 170, 20):
        window = slice(frame - 30, frame + 31)
        basis = torch.stack((wave[window], torch.ones(61, dtype=torch.float64)), 1)
        a, b = torch.linalg.lstsq(basis, curve[window]).solution
        rms = (basis @ torch.stack((a, b)) - curve[window]).square().mean().sqrt()
        assert torch.allclose(found[frame], torch.stack((a, b, rms)))
    # only a negative multiple would fit
    amplitude, offset, residual = windows.regression(2 - wave.sin(), wave.sin(), 0.5, FPS)
    assert float(amplitude.abs().max()) == 0
    assert torch.allclose(offset, windows.mean(2 - wave.sin(), 0.5, FPS))
    assert residual.min() > 0
    still_wave = windows.regression(wave, torch.zeros_like(wave), 0.5, FPS)
    assert all(bool(column.isfinite().all()) for column in still_wave)
