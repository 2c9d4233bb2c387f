"""The sinusoid fit: known sinusoids, the best that slow means find, bounds, degenerate windows."""

import itertools
import math

import numpy as np
import pytest
import torch
from hypothesis import given
from hypothesis import strategies as st

import toolkit as tk
from experiments.speed.fit import best_known
from toolkit.phases.sinusoids import Sinusoids, fit, frequencies

FPS = 60.0


def sinusoid(frequency, amplitude=1.3, shift=0.4, offset=0.2, frames=300):
    t = torch.arange(frames, dtype=torch.float64) / FPS
    return (amplitude * torch.sin(2 * math.pi * (frequency * t - shift)) + offset)[:, None]


def one(window, fps=FPS):
    """The fit of a single window, as numbers."""
    found = fit(torch.as_tensor(window)[:, None], fps, (len(window) - 1) / 2 / fps)
    return Sinusoids(*(float(column[len(window) // 2, 0]) for column in vars(found).values()))


def kinds(walk_clip):
    """Windows of 61 frames: normalised sources, noise, random walks, ramps, steps, a spike, frequencies out of bounds."""
    rng = np.random.default_rng(4)
    curve = tk.phases.extract(walk_clip).source.double().numpy()
    t = np.arange(-30, 31) / FPS
    yield from (curve[f - 30 : f + 31, limb] for limb in range(4) for f in (80, 211))
    yield from rng.normal(size=(4, 61))
    yield from rng.normal(size=(12, 61)).cumsum(1)
    yield from rng.normal(size=(6, 61)).cumsum(1).cumsum(1)
    yield from (1e3 + t, 1e-6 * t**2, np.sign(t), (t > 0.2) * 1.0, (t == 0) * 1.0, np.exp(4 * t))
    yield from (np.sin(2 * np.pi * f * t + 1) for f in (0.1, 0.25, 4.0, 4.4, 7.0))


@given(st.floats(0.3, 3.95), st.floats(0.1, 3.0), st.floats(-0.5, 0.5), st.floats(-10, 10))
def test_a_sinusoid_is_found_again(frequency, amplitude, shift, offset):
    curve = sinusoid(frequency, amplitude, shift, offset)
    found = fit(curve, FPS, half_window=2.0)  # long enough that no bound holds
    middle = slice(120, -120)
    t = torch.arange(len(curve)) / FPS
    angle = found.phase[:, 0] - 2 * math.pi * (frequency * t - shift)
    assert float(torch.sin(angle / 2)[middle].abs().amax()) < 1e-5
    for column, truth in ((found.frequency, frequency), (found.amplitude, amplitude), (found.offset, offset)):
        torch.testing.assert_close(column[middle], torch.full_like(column[middle], truth), rtol=1e-5, atol=1e-5)


def test_no_window_is_fitted_better_by_slow_means(walk_clip):
    excess = []
    for window in kinds(walk_clip):
        best, floor = best_known(window), 1e-7 * np.ptp(window)
        excess.append((one(window).residual - best) / max(best, floor))
    assert max(excess) < 1e-6


def test_the_sinusoid_is_what_it_says_and_within_its_bounds(walk_clip):
    t = np.arange(-30, 31) / FPS
    held = {"amplitude": 0, "offset": 0, "frequency": 0}
    for window in kinds(walk_clip):
        found = one(window)
        values = found.amplitude * np.sin(2 * np.pi * found.frequency * t + found.phase) + found.offset
        scale = np.ptp(window)
        assert found.residual == pytest.approx(np.sqrt(np.mean((values - window) ** 2)), rel=1e-6, abs=1e-7 * scale)
        assert 0 <= found.amplitude <= scale
        assert 0.25 <= found.frequency <= 4
        assert window.min() <= found.offset <= window.max()
        held["amplitude"] += found.amplitude == pytest.approx(scale, rel=1e-12)
        held["offset"] += min(found.offset - window.min(), window.max() - found.offset) < 1e-12 * scale
        held["frequency"] += found.frequency in (0.25, 4.0)
    assert min(held.values()) >= 3  # every bound is put to the test


def test_a_frame_is_fitted_from_its_own_window_alone():
    curve = torch.randn(400, 2, generator=torch.Generator().manual_seed(3), dtype=torch.float64).cumsum(0)
    whole = fit(curve, FPS)
    for frame in (30, 200, 369):
        alone = fit(curve[frame - 30 : frame + 31], FPS)
        for a, b in zip(vars(whole).values(), vars(alone).values(), strict=True):
            torch.testing.assert_close(a[frame], b[30], rtol=1e-6, atol=1e-6)


@given(st.floats(1e-6, 1e6), st.floats(-1e3, 1e3))
def test_scale_and_offset_of_the_source_pass_through(scale, shift):
    curve = torch.randn(80, 1, generator=torch.Generator().manual_seed(5), dtype=torch.float64).cumsum(0)
    here, there = fit(curve, FPS), fit(scale * (curve + shift), FPS)
    torch.testing.assert_close(there.frequency, here.frequency, rtol=1e-4, atol=0)
    torch.testing.assert_close(there.residual, scale * here.residual, rtol=1e-6, atol=0)
    torch.testing.assert_close(there.amplitude, scale * here.amplitude, rtol=1e-3, atol=0)


@pytest.mark.parametrize("level", [0.0, 0.1, -1e300, 1e-300])
def test_a_constant_source_has_no_amplitude_and_a_steady_phase(level):
    found = fit(torch.full((100, 1), level, dtype=torch.float64), FPS)
    assert all(bool(torch.isfinite(column).all()) for column in vars(found).values())
    assert float(found.amplitude.abs().max()) == float(found.residual.abs().max()) == 0
    assert found.phase.unique().numel() == found.frequency.unique().numel() == 1
    assert bool((found.offset == level).all())


@pytest.mark.parametrize(("fps", "seconds"), [(30.0, 0.5), (120.0, 0.25), (24.0, 1.5), (10.0, 0.2)])
def test_other_rates_and_windows_are_as_good(fps, seconds):
    half = max(2, round(seconds * fps))
    rng = np.random.default_rng(7)
    for _ in range(4):
        window = rng.normal(size=2 * half + 1).cumsum()
        assert one(window, fps).residual <= best_known(window, fps) * (1 + 1e-6) + 1e-7 * np.ptp(window)


def test_the_smoothest_path_is_the_best_of_all():
    from toolkit.phases.variable_projection import smoothest

    rng = np.random.default_rng(2)
    for _ in range(5):
        cost, jump = rng.random((6, 3)), rng.random((3, 3))

        def along(path, cost=cost, jump=jump):
            return sum(cost[f, k] for f, k in enumerate(path)) + sum(jump[a, b] for a, b in itertools.pairwise(path))

        assert tuple(smoothest(cost, jump)) == min(itertools.product(range(3), repeat=6), key=along)


@pytest.mark.parametrize("seconds", [0.2, 1.0, 61 / 60, 4.0])
def test_the_grid_is_even_in_cycles_and_their_logarithm(seconds):
    grid = frequencies(seconds)
    assert (grid[0], grid[-1]) == (0.25, 4.0)
    steps = np.diff(6 * (grid * seconds + np.log(grid)))
    total = 6 * (3.75 * seconds + np.log(16))
    assert len(steps) == math.ceil(total)
    assert steps == pytest.approx(np.full(len(steps), total / len(steps)), rel=2e-3)


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


def test_time_reversed_and_negated_curves_have_the_same_sinusoids_turned_round():
    curve = sinusoid(1.1) + 0.5 * sinusoid(1.9, shift=0.1)
    here, back, down = fit(curve, FPS), fit(curve.flip(0), FPS), fit(-curve, FPS)
    for name in ("frequency", "amplitude", "residual"):
        torch.testing.assert_close(getattr(back, name).flip(0), getattr(here, name), rtol=1e-4, atol=1e-6)
        torch.testing.assert_close(getattr(down, name), getattr(here, name), rtol=1e-4, atol=1e-6)
    assert float(torch.sin((math.pi - back.phase.flip(0) - here.phase) / 2).abs().max()) < 1e-3
    assert float(torch.cos((down.phase - here.phase) / 2).abs().max()) < 1e-3
    torch.testing.assert_close(down.offset, -here.offset, rtol=1e-4, atol=1e-6)
    assert 0 <= float(here.phase.min()) < float(here.phase.max()) < 2 * math.pi


def test_the_shortest_source_the_lowest_rate_and_the_shortest_window():
    curve = sinusoid(1.0, frames=31)
    assert len(fit(curve, FPS).phase) == 31
    with pytest.raises(ValueError, match=r"^a source must be \[frames, limbs\] with more than 30 frames, not \[30, 1\]$"):
        fit(curve[:30], FPS)
    low = fit(sinusoid(1.0, frames=40), 8.01)
    assert bool(low.residual.isfinite().all())
    window = np.random.default_rng(12).normal(size=5)  # never less than five frames
    shortest = fit(torch.from_numpy(window)[:, None], 10.0, 0.01)
    assert one(window, 10.0).residual == pytest.approx(float(shortest.residual[2, 0]))
    with pytest.raises(ValueError, match=r"with more than 2 frames, not \[2, 1\]$"):
        fit(curve[:2], 10.0, 0.01)


@pytest.mark.parametrize(("source", "fps", "message"), [
    (torch.zeros(100), 60.0, "a source must be [frames, limbs] with more than 30 frames, not [100]"),
    (torch.zeros(30, 4), 60.0, "a source must be [frames, limbs] with more than 30 frames, not [30, 4]"),
    (torch.zeros(100, 4, 1), 60.0, "a source must be [frames, limbs] with more than 30 frames, not [100, 4, 1]"),
    (torch.zeros(100, 4), 8.0, "fits up to 4 Hz need over 8 frames per second, not 8"),
    (torch.zeros(100, 4), 7.5, "fits up to 4 Hz need over 8 frames per second, not 7.5"),
])
def test_refusals_say_what_was_expected_and_what_came(source, fps, message):
    with pytest.raises(ValueError) as error:  # noqa: PT011
        fit(source, fps)
    assert str(error.value) == message


def test_at_its_ends_a_curve_is_continued_by_its_mirror_image():
    """The fit at an end equals that in the middle of the curve with its mirror images, of which the end is not repeated."""
    curve = torch.from_numpy(np.random.default_rng(3).normal(size=(90, 2)).cumsum(0))
    half = 15
    longer = torch.cat((curve[1 : half + 1].flip(0), curve, curve[-half - 1 : -1].flip(0)))
    found, expected = (vars(fit(c, 30.0, half / 30)) for c in (curve, longer))
    for name in ("frequency", "amplitude", "offset", "residual"):
        assert torch.allclose(found[name], expected[name][half:-half], atol=1e-9), name
