"""Local phases: the fit against known sinusoids and against scipy, sources, post-processing."""

import math

import numpy as np
import pytest
import torch
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import least_squares

import toolkit as tk
from toolkit.phases import LIMBS, fit, normalise, smooth

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
