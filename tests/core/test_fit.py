"""The sinusoid fit: known sinusoids, the best that slow means find, bounds, degenerate windows."""

import itertools
import math

import numpy as np
import pytest
import torch
from hypothesis import given, settings, strategies as st
from refusal import refusal
from scipy.optimize import least_squares

import toolkit as tk
from toolkit.phases.sinusoids import Sinusoids, fit
from toolkit.phases.variable_projection import _in_ball, _level, minima
from toolkit.phases.viterbi import smoothest

FPS = 60.0


def sinusoid(frequency, amplitude=1.3, shift=0.4, offset=0.2, frames=300):
    t = torch.arange(frames, dtype=torch.float64) / FPS
    return (amplitude * torch.sin(2 * math.pi * (frequency * t - shift)) + offset)[:, None]


def one(window, fps=FPS):
    """The fit of a single window, as numbers."""
    found = fit(torch.as_tensor(window)[:, None], fps, (len(window) - 1) / 2 / fps)
    return Sinusoids(*(float(column[len(window) // 2, 0]) for column in vars(found).values()))


def kinds(walk_clip):
    """Windows of 61 frames: sources, noise, random walks, steps, frequencies out of bounds."""
    rng = np.random.default_rng(4)
    curve = tk.phases.extract(walk_clip).source.double().numpy()
    t = np.arange(-30, 31) / FPS
    yield from (curve[50:111, limb] for limb in range(4))
    yield from rng.normal(size=(2, 61))
    yield from rng.normal(size=(6, 61)).cumsum(1)
    yield from rng.normal(size=(4, 61)).cumsum(1).cumsum(1)
    yield from (1e3 + t, 1e-6 * t**2, np.sign(t), (t == 0) * 1.0, np.exp(4 * t))
    yield from (np.sin(2 * np.pi * f * t + 1) for f in (0.1, 0.25, 4.0, 4.4, 7.0))


@settings(max_examples=25)
@given(st.floats(0.3, 3.95), st.floats(0.1, 3.0), st.floats(-0.5, 0.5), st.floats(-10, 10))
def test_a_sinusoid_is_found_again(frequency, amplitude, shift, offset):
    curve = sinusoid(frequency, amplitude, shift, offset)
    found = fit(curve, FPS, half_window=2.0)  # long enough that no bound holds
    middle = slice(120, -120)
    t = torch.arange(len(curve)) / FPS
    angle = found.phase[:, 0] - 2 * math.pi * (frequency * t - shift)
    assert torch.sin(angle / 2)[middle].abs().amax() < 1e-5
    for name, truth in (("frequency", frequency), ("amplitude", amplitude), ("offset", offset)):
        column = getattr(found, name)[middle]
        torch.testing.assert_close(column, torch.full_like(column, truth), rtol=1e-5, atol=1e-5)


def best_known(window, fps=FPS):
    """Least residual within the bounds: what scipy finds from each of eight frequencies."""
    low, high = window.min(), window.max()
    t, spread = (np.arange(len(window)) - len(window) // 2) / fps, high - low

    def apart(p):
        return p[0] * np.sin(2 * np.pi * p[1] * t + p[2]) + p[3] - window

    edge, found = 1e-12 * spread, []
    for hertz in np.linspace(0.3, 3.95, 8):
        places = itertools.product((0.2 * spread, 0.8 * spread), [hertz], range(-3, 3),
                                   [window.mean()])
        best = least_squares(
            apart, min(places, key=lambda p: np.square(apart(p)).sum()),
            x_scale=[spread, 1, 1, spread], ftol=1e-14, xtol=1e-12, gtol=1e-14, max_nfev=300,
            bounds=([-edge, 0.25 - 1e-12, -10, low - edge],
                    [spread + edge, 4 + 1e-12, 10, high + edge]))
        found.append(best.cost)
    return np.sqrt(2 * min(found) / len(window))


def test_no_window_at_any_rate_is_fitted_better_by_slow_means(walk_clip):
    windows = [(window, FPS) for window in itertools.islice(kinds(walk_clip), 0, None, 3)]
    for fps, frames in ((30.0, 31), (120.0, 61), (24.0, 73), (10.0, 5)):
        windows.append((np.random.default_rng(7).normal(size=frames).cumsum(), fps))
    for window, fps in windows:
        limit = best_known(window, fps) * (1 + 1e-6) + 1e-8 * np.ptp(window)
        assert one(window, fps).residual <= limit


def test_the_sinusoid_is_what_it_says_and_within_its_bounds(walk_clip):
    t = np.arange(-30, 31) / FPS
    held = {"amplitude": 0, "offset": 0, "frequency": 0}
    for window in kinds(walk_clip):
        found = one(window)
        wave = found.amplitude * np.sin(2 * np.pi * found.frequency * t + found.phase)
        scale = np.ptp(window)
        error = np.sqrt(np.mean((wave + found.offset - window) ** 2))
        assert found.residual == pytest.approx(error, rel=1e-6, abs=1e-7 * scale)
        assert 0 <= found.amplitude <= scale
        assert 0.25 <= found.frequency <= 4
        assert window.min() <= found.offset <= window.max()
        held["amplitude"] += found.amplitude == pytest.approx(scale, rel=1e-12)
        away = min(found.offset - window.min(), window.max() - found.offset)
        held["offset"] += away < 1e-12 * scale
        held["frequency"] += found.frequency in (0.25, 4.0)
    assert min(held.values()) >= 2  # every bound is put to the test


def test_both_numbers_in_a_ball_have_the_same_multiplier():
    u, v = _in_ball(3.0, 1.0, 2.0, 0.5, 0.7)
    assert math.hypot(u, v) == pytest.approx(0.7)
    assert 3.0 / u - 2.0 == pytest.approx(1.0 / v - 0.5)


def test_compiled_loops_stay_within_their_arrays():
    """Python, which looks at each index, computes the same."""
    curve, found = np.random.default_rng(3).normal(size=11).cumsum(), np.zeros((2, 5, 3))
    of = curve, np.full(3, np.ptp(curve)), np.full(3, curve.mean()), np.linspace(0.1, 0.5, 6)
    minima(*of, found[0])
    minima.py_func(*of, found[1])
    assert found[1] == pytest.approx(found[0], rel=1e-9)
    gains = np.array([1.0, 3.0, 2.0, 5.0, 4.0, 3.0, 3.5])
    _level(gains, 3)  # a peak down to the valleys beside it
    assert gains.tolist() == [1.0, 3.0, *[-math.inf] * 4, 3.5]


@pytest.mark.parametrize("level", [0.0, 0.1, -1e300])
def test_a_constant_source_has_no_amplitude_and_a_steady_phase(level):
    found = fit(torch.full((100, 1), level, dtype=torch.float64), FPS)
    assert all(bool(torch.isfinite(column).all()) for column in vars(found).values())
    assert float(found.amplitude.abs().max()) == float(found.residual.abs().max()) == 0
    assert found.phase.unique().numel() == found.frequency.unique().numel() == 1
    assert (found.offset == level).all()


def test_the_smoothest_path_is_the_best_of_all():
    rng = np.random.default_rng(2)
    for _ in range(5):
        cost, jump = rng.random((6, 3)), rng.random((3, 3))

        def total(path, cost=cost, jump=jump):
            jumps = sum(jump[a, b] for a, b in itertools.pairwise(path))
            return sum(cost[f, k] for f, k in enumerate(path)) + jumps

        best = min(itertools.product(range(3), repeat=6), key=total)
        assert tuple(smoothest(cost, jump)) == best


@pytest.mark.parametrize("fps", [9.0, 30.0])
def test_ends_are_mirrored(fps):
    """The fit at the ends is that of the middle of a curve which is mirrored by hand."""
    curve = np.random.default_rng(11).normal(size=(40, 3)).cumsum(0)
    half = max(2, round(0.5 * fps))
    longer = np.pad(curve, ((half, half), (0, 0)), "reflect")
    found, whole = fit(torch.from_numpy(curve), fps), fit(torch.from_numpy(longer), fps)
    for column, expected in zip(vars(found).values(), vars(whole).values(), strict=True):
        assert column.shape == (40, 3)
        assert column.dtype == torch.float64
        torch.testing.assert_close(column, expected[half:-half], rtol=1e-5, atol=1e-5)


def test_the_shortest_source_the_lowest_rate_and_the_shortest_window():
    curve = sinusoid(1.0, frames=31)
    assert len(fit(curve, FPS).phase) == 31
    assert fit(sinusoid(1.0, frames=40), 8.01).residual.isfinite().all()
    window = np.random.default_rng(12).normal(size=5)  # never less than five frames
    shortest = fit(torch.from_numpy(window)[:, None], 10.0, 0.01)
    assert one(window, 10.0).residual == pytest.approx(float(shortest.residual[2, 0]))
    for few, fps, half, said in (
            (curve[:30], FPS, 0.5, r"\[frames, limbs\] with more than 30 frames, not \[30, 1\]"),
            (curve[:, 0], FPS, 0.5, r"\[frames, limbs\] with more than 30 frames, not \[31\]"),
            (curve[:2], 10.0, 0.01, r"with more than 2 frames, not \[2, 1\]"),
            (curve, 8.0, 0.5, "fits up to 4 Hz need over 8 frames per second, not 8")):
        with refusal(said):
            fit(few, fps, half)
