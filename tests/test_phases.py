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
from experiments import phases as bench
from toolkit.datasets import procedural
from toolkit.evaluation.phases import measure
from toolkit.phases import LIMBS, Sinusoids, coherent, fit, learned, normalise, smooth, steps, windows

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
        )
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
    contact, free, both = (tk.phases.extract(walk_clip, source=source) for source in ("contact", "contact-free", "hybrid"))
    assert float(contact.vector[:, :2].abs().max()) == 0
    assert torch.equal(free.vector[:, :2], both.vector[:, :2])
    error, lag = tk.metrics.phase_error(contact.phase[60:-60, 2:], both.phase[60:-60, 2:])
    assert float(error.max()) < math.radians(4)  # a fitted sinusoid and the steps themselves agree in a regular walk
    assert float(lag.abs().max()) < math.radians(6)


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
             for half in (None, 0.5)}
    assert error[None] < math.radians(10) < math.radians(30) < error[0.5]


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
    assert torch.allclose(ph.vector.norm(dim=-1)[60:-60], 2 * smooth(speed, FPS)[60:-60], rtol=0.02)


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


def test_coherent_limbs_are_denoised_and_independent_ones_keep_their_signal():
    noise = torch.randn(4, 2000, 4, generator=torch.Generator().manual_seed(3), dtype=torch.float64)
    shared = torch.exp(0.1j * torch.arange(2000, dtype=torch.float64))[:, None]
    noisy = torch.complex(noise[0], noise[1]) * 0.5 + shared * torch.exp(1j * torch.arange(4))
    apart = [(z / shared[:, 0]).angle().std() for z in (noisy[:, 0], coherent.denoised(noisy, 0))]
    assert float(apart[1]) < 0.8 * float(apart[0])
    lonely = torch.complex(noise[2], noise[3])
    assert float((coherent.denoised(lonely, 0) - lonely[:, 0]).abs().max()) < 0.05


def test_regression_is_that_of_least_squares_in_each_window():
    curve, wave = torch.randn(2, 200, generator=torch.Generator().manual_seed(4), dtype=torch.float64)
    curve = curve + wave
    found = torch.stack(windows.regression(curve, wave, 0.5, FPS), 1)
    for frame in range(30, 170, 20):
        window = slice(frame - 30, frame + 31)
        basis = torch.stack((wave[window], torch.ones(61, dtype=torch.float64)), 1)
        a, b = torch.linalg.lstsq(basis, curve[window]).solution
        rms = (basis @ torch.stack((a, b)) - curve[window]).square().mean().sqrt()
        assert torch.allclose(found[frame], torch.stack((a, b, rms)))


def test_coherent_is_nearer_to_the_truth_than_contact_free_when_staggering():
    clip, truth = procedural.truth(procedural.STYLES["Drunk"], "FW", 20.0, seed=1)
    inner = slice(60, -60)
    error = {source: tk.metrics.phase_error(tk.phases.extract(clip, source).phase[inner], truth.phase[inner])[0].mean()
             for source in ("coherent", "contact-free")}
    assert float(error["coherent"]) < 0.8 * float(error["contact-free"])


@pytest.mark.parametrize("style", ["Neutral", "Zombie", "Penguin"])
def test_cyclic_styles_keep_the_limits_against_the_truth(style):
    sources = {name: tk.phases.SOURCES[name] for name in ("contact", "contact-free")}
    row = measure(style, *procedural.truth(style, "FW", 20.0, 3), sources)
    assert bench.failures(row) == []
    assert row.phase["contact"][:2].isnan().all()  # a hand has no contact, and no error either


def test_failures_name_the_exceeded_limits():
    nan = math.nan
    phase = {"contact": torch.tensor([nan, nan, 25.0, 3.0]), "contact-free": torch.tensor([1.0, nan, 9.0, 9.0])}
    frequency = {"contact": torch.full((4,), 0.01), "contact-free": torch.tensor([0.05, nan, 0.0, 0.0])}
    row = bench.Row("Odd", phase, frequency, [0.99, 0.9])
    assert bench.failures(row) == ["contact feet 25.0°", "frequency of the hands 5.0%", "F1 0.900"]


def test_phases_agree_with_what_the_published_network_predicts(shared):
    folder, file = shared / "lpn_film_100style", shared / "100style" / "Neutral_FW.bvh"
    if not folder.is_dir() or not file.is_file():
        pytest.skip(f"needs {folder} and {file}")
    model, bank = tk.published.load(folder)
    assert tk.published.one_step(model, bank, tk.bvh.load(file), "Neutral", (327, None))["phase_error"] < 0.15


@pytest.mark.parametrize(("source", "message"), [
    ("hybird", "unknown phase source 'hybird'; known: hybrid"),
    (lambda clip, limb: torch.zeros(3), "one finite number per frame"),
    (lambda clip, limb: torch.full((len(clip),), math.nan), "one finite number per frame"),
])
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


# Sources


class Curves:
    """A source of four given curves [F, 4], in the order of `LIMBS`."""

    def __init__(self, values):
        self.values = torch.as_tensor(values, dtype=torch.float64)

    def __call__(self, clip, limb):
        return self.values[:, LIMBS.index(limb)]


def still(frames, fps=FPS):
    """A clip of so many frames, for sources that do not look at it."""
    skeleton = procedural.generate("Neutral", "ID", 1.0).skeleton
    rotations = tk.motion.rotations.identity(len(skeleton)).expand(frames, -1, -1)
    return tk.Clip(skeleton, rotations, torch.zeros(frames, 3), fps, name="still")


def test_a_contact_is_sought_by_the_thresholds_given(walk_clip):
    detected = tk.contacts.detect(walk_clip, height=0.03, speed=0.6)
    for limb, column in (("right_foot", 0), ("left_foot", 1)):
        found = tk.phases.Contact(height=0.03, speed=0.6)(walk_clip, limb)
        assert torch.equal(found, detected[:, column])
        for other in (tk.phases.Contact(height=0.03), tk.phases.Contact(speed=0.6), tk.phases.Contact()):
            assert not torch.equal(found, other(walk_clip, limb))


def test_contact_free_is_the_longest_axis_of_all_clips_and_points_forward(walk_clip):
    clips = [walk_clip.cut(0, 200), procedural.generate("Zombie", "FW", 4.0).moved(turn=1.0)]
    source = tk.phases.ContactFree()
    fitted = source.fitted(clips)
    for limb in LIMBS:
        points = np.concatenate([tk.phases.local_positions(clip, limb).double().numpy() for clip in clips])
        axis = np.linalg.svd(points - points.mean(0))[2][0]
        axis = axis * np.sign(axis[2])  # the skeleton faces +z
        for clip in clips:
            expected = (tk.phases.local_positions(clip, limb).double().numpy() - points.mean(0)) @ axis
            assert fitted(clip, limb).numpy() == pytest.approx(expected, abs=1e-6)
        alone = source(clips[0], limb)
        assert torch.equal(alone, source.fitted(clips[:1])(clips[0], limb))
        assert float((alone - fitted(clips[0], limb)).abs().max()) > 1e-3  # another centre, another axis
    assert source.axes == source.means == {}


def test_a_limb_that_moves_along_one_line_is_measured_in_metres_along_it():
    clip = still(120)

    class Line(tk.phases.ContactFree):
        def points(self, clip, limb):
            sway = torch.sin(torch.arange(120, dtype=torch.float64) / 9)[:, None]
            return sway * torch.tensor([0.3, 0.0, -0.4 if limb.startswith("left") else 0.4], dtype=torch.float64) + 7.0

    sway = torch.sin(torch.arange(120, dtype=torch.float64) / 9)
    for limb in LIMBS:
        forward = -0.5 if limb.startswith("left") else 0.5
        assert torch.allclose(Line()(clip, limb), forward * (sway - sway.mean()))


def test_velocity_points_are_differences_per_second(walk_clip):
    clip = walk_clip.cut(0, 80).resample(30.0)
    where = tk.phases.local_positions(clip, "left_hand").double()
    found = tk.phases.Velocity().points(clip, "left_hand")
    assert found.shape == (len(clip), 3)
    for frame in range(len(clip)):
        before, after = max(frame - 1, 0), min(frame + 1, len(clip) - 1)
        assert torch.allclose(found[frame], (where[after] - where[before]) / (after - before) * 30.0)


def test_a_foot_counts_as_touching_from_exactly_the_least_share_on(walk_clip):
    quarter = torch.arange(len(walk_clip)) % 4 == 0
    assert len(walk_clip) % 4 == 0

    def touching(clip, limb):
        return quarter.float()

    at, above = (tk.phases.Hybrid(touching, tk.phases.ContactFree(), least=least) for least in (0.25, 0.3))
    assert at.choice(walk_clip, "left_foot") == "contact"
    assert at.reason(walk_clip, "left_foot") == "contact: the foot touches the floor in 25% of the frames, at least 25%"
    assert torch.equal(at(walk_clip, "left_foot"), quarter.float())
    assert above.choice(walk_clip, "left_foot") == "contact-free"
    assert above.reason(walk_clip, "left_foot") == "contact-free: the foot touches the floor in 25% of the frames, under 30%"
    assert torch.equal(above(walk_clip, "left_foot"), tk.phases.ContactFree()(walk_clip, "left_foot"))


def test_a_fitted_hybrid_keeps_contacts_and_least_and_shares_the_axes(walk_clip):
    clips = [walk_clip, procedural.generate("Zombie", "FW", 2.0)]
    hybrid = tk.phases.Hybrid(tk.phases.Contact(0.02, 0.3), tk.phases.ContactFree(), least=0.4)
    fitted = hybrid.fitted(clips)
    assert (fitted.contact, fitted.least) == (hybrid.contact, 0.4)
    assert torch.equal(fitted(walk_clip, "left_hand"), tk.phases.ContactFree().fitted(clips)(walk_clip, "left_hand"))


def test_a_source_of_the_wrong_length_is_refused_in_full(walk_clip):
    message = f"{walk_clip.name}: a source must give one finite number per frame ({len(walk_clip)}) for every limb"
    for bad in (torch.zeros(len(walk_clip) - 1), torch.zeros(len(walk_clip), 1), torch.full((len(walk_clip),), math.inf)):
        with pytest.raises(ValueError) as error:  # noqa: PT011
            tk.phases.curves(walk_clip, lambda clip, limb, bad=bad: bad if limb == "right_foot" else torch.zeros(len(clip)))
        assert str(error.value) == message


# Extraction


def test_clips_of_a_group_share_their_axes_and_keep_their_order(walk_clip):
    clips = [walk_clip.cut(0, 150), procedural.generate("Zombie", "FW", 3.0)]
    group = tk.phases.extract_group(clips, "contact-free")
    fitted = tk.phases.ContactFree().fitted(clips)
    for clip, ph in zip(clips, group, strict=True):
        again = tk.phases.extract(clip, lambda c, limb: fitted(c, limb))
        assert all(torch.equal(a, b) for a, b in zip(vars(ph).values(), vars(again).values(), strict=True))
    assert not torch.equal(group[0].source, tk.phases.extract(clips[0], "contact-free").source)


@pytest.mark.parametrize("fps", [30.0, 60.0])
def test_a_second_is_the_shortest_clip(fps):
    half = round(fps / 2)
    clip = procedural.generate("Neutral", "FW", 4.0).resample(fps).replace(name="brief")
    assert len(tk.phases.extract(clip.cut(0, 2 * half + 1), "contact-free", half_window=0.25).phase) == 2 * half + 1
    with pytest.raises(ValueError) as error:  # noqa: PT011
        tk.phases.extract(clip.cut(0, 2 * half), "contact-free", half_window=0.25)
    assert str(error.value) == (f"brief: {2 * half} frames are too few for phases, which need {2 * half + 1} "
                                f"(one second) at {fps:g} Hz")


def test_sources_go_by_their_names():
    assert list(tk.phases.SOURCES) == ["hybrid", "contact", "contact-free", "velocity", "coherent"]
    for name, source in tk.phases.SOURCES.items():
        assert tk.phases.named(name) is source
    assert isinstance(tk.phases.named("learned"), learned.Learned)
    with pytest.raises(ValueError) as error:  # noqa: PT011
        tk.phases.named("Hybrid")
    assert str(error.value) == ("unknown phase source 'Hybrid'; "
                                "known: hybrid, contact, contact-free, velocity, coherent, learned")


def test_fields_are_what_they_say(walk_clip):
    """Each field against the fit of each limb's own curve, frame by frame; the vector against equation (1)."""
    source, half = tk.phases.ContactFree().fitted([walk_clip]), 0.4
    ph = tk.phases.extract(walk_clip, lambda clip, limb: source(clip, limb), half)
    assert all(column.dtype == torch.float32 for column in vars(ph).values())
    for i, limb in enumerate(LIMBS):
        curve = smooth(normalise(source(walk_clip, limb)[:, None], FPS, 0.5), FPS)  # never less than a second
        found = fit(curve, FPS, half)
        for column, expected in ((ph.source, curve), (ph.frequency, found.frequency), (ph.amplitude, found.amplitude),
                                 (ph.residual, found.residual),
                                 (ph.fit, found.amplitude * found.phase.sin() + found.offset)):
            assert torch.allclose(column[:, i].double(), expected[:, 0], atol=1e-5)
        sine, cosine = smooth(torch.cat((found.phase.sin(), found.phase.cos()), 1), FPS).unbind(1)
        speed = windows.speed(tk.phases.local_positions(walk_clip, limb), FPS)
        size = smooth(speed[:, None] * found.amplitude, FPS)[:, 0].clamp_min(0)
        for frame in range(len(walk_clip)):
            length = math.hypot(sine[frame], cosine[frame])
            expected = [float(size[frame] * part[frame] / length) for part in (sine, cosine)]
            assert ph.vector[frame, i].tolist() == pytest.approx(expected, abs=1e-5)
            angle = math.atan2(sine[frame], cosine[frame])
            assert abs(math.remainder(float(ph.phase[frame, i]) - angle, 2 * math.pi)) < 1e-5
    assert float(ph.phase.min()) >= 0
    assert float(ph.phase.max()) <= 2 * math.pi


def test_without_a_window_each_limb_is_fitted_in_its_own():
    t = torch.arange(480, dtype=torch.float64)[:, None] / FPS
    rates = torch.tensor([0.6, 0.8, 1.0, 1.5], dtype=torch.float64)
    ph = tk.phases.extract(still(480), Curves(torch.sin(2 * math.pi * rates * t) + 3.0))
    assert ph.frequency[120:-120].mean(0).tolist() == pytest.approx(rates.tolist(), rel=0.01)
    for i, rate in enumerate(rates.tolist()):
        curve = torch.sin(2 * math.pi * rate * t)
        half = windows.half_window(curve[:, 0], FPS)
        assert half == pytest.approx(max(0.5, windows.CYCLES / 2 / rate), abs=0.02)
        assert torch.allclose(ph.source[:, i].double(), smooth(normalise(curve, FPS, half), FPS)[:, 0], atol=1e-4)


# Windows


def test_means_are_over_what_is_there_with_the_ends_repeated():
    values = torch.randn(25, 2, 3, generator=torch.Generator().manual_seed(1), dtype=torch.float64)
    for half, frames in ((0.5, 5), (0.26, 3), (0.0, 0), (4.0, 40)):
        got = windows.mean(values, half, 10.0)
        assert got.shape == values.shape
        for frame in range(25):
            at = [min(max(frame + k, 0), 24) for k in range(-frames, frames + 1)]
            assert torch.allclose(got[frame], values[at].mean(0))


@pytest.mark.parametrize("half", [0.3, 0.5, 0.9])
def test_a_z_score_is_that_of_each_column_alone_at_the_ends_too(half):
    curves = torch.randn(90, 3, generator=torch.Generator().manual_seed(2), dtype=torch.float64).cumsum(0)
    curves = curves * torch.tensor([1e-4, 1.0, 1e3]) + torch.tensor([0.0, -2.0, 5.0])
    got = normalise(curves, 30.0, half)
    frames = round(half * 30)
    for frame in range(90):
        window = curves[[min(max(frame + k, 0), 89) for k in range(-frames, frames + 1)]]
        expected = (curves[frame] - window.mean(0)) / window.std(0, correction=0)
        assert got[frame].tolist() == pytest.approx(expected.tolist(), abs=1e-6)
    assert torch.equal(normalise(curves, 30.0), normalise(curves, 30.0, 0.5))


def test_a_window_is_constant_below_a_ten_thousandth_of_the_curve():
    wave = torch.sin(2 * math.pi * torch.arange(120, dtype=torch.float64) / 20)[:, None]  # three whole cycles in 60
    for level in (1.0, 100.0):
        for deviation, alive in ((0.95e-4, False), (1.05e-4, True)):
            got = normalise(level * (1 + deviation * math.sqrt(2) * wave), FPS)[35:-35]
            assert bool(got.abs().max() > 1) == alive
            assert alive or float(got.abs().max()) == 0
    assert float(normalise(1e-14 * wave, FPS).abs().max()) == 0
    assert float(normalise(1e-6 * wave, FPS).abs().max()) > 1


@pytest.mark.parametrize("fps", [30.0, 60.0, 120.0])
def test_smoothing_halves_four_hertz_and_shifts_nothing(fps):
    """Gain of a second-order Butterworth filter passed twice: 1 / (1 + r⁴), r the ratio of the warped frequencies."""
    t = torch.arange(round(8 * fps), dtype=torch.float64)[:, None] / fps
    rates = torch.tensor([0.5, 2.0, 4.0, 8.0], dtype=torch.float64)
    gain = 1 / (1 + (torch.tan(math.pi * rates / fps) / math.tan(math.pi * 4 / fps)) ** 4)
    wave = torch.sin(2 * math.pi * rates * t + 0.3)
    inner = slice(round(2 * fps), -round(2 * fps))
    assert float((smooth(wave, fps) - gain * wave)[inner].abs().max()) < 1e-4
    assert float(gain[2]) == pytest.approx(0.5)


def slow_half_window(curve, fps):
    """The definition in plain loops."""
    n = len(curve)
    slow = [sum(curve[min(max(f + k, 0), n - 1)] for k in range(-round(fps), round(fps) + 1)) / (2 * round(fps) + 1)
            for f in range(n)]
    fast = np.asarray(curve) - slow
    like = [float(fast[: n - lag] @ fast[lag:]) for lag in range(n)]
    peaks = [lag for lag in range(round(fps / 4), min(round(2 * fps), n - 2))
             if like[lag - 1] < like[lag] >= like[lag + 1] and like[lag] > 0.2 * like[0]]
    return max([0.5, *(1.05 / 2 * lag / fps for lag in sorted(peaks, key=lambda lag: like[lag])[-1:])])


def test_the_window_is_that_of_the_highest_peak_of_the_autocorrelation():
    rng = np.random.default_rng(5)
    seen = set()
    for trial in range(40):
        fps, n = (10.0, 16.0)[trial % 2], int(rng.integers(24, 120))
        t = np.arange(n) / fps
        noise, drift = rng.uniform(0, 1.5) * rng.normal(size=n), rng.uniform(0, 2) * t
        curve = (np.sin(2 * np.pi * t / rng.uniform(0.5, 2.6)) + noise + drift) * 10.0 ** rng.integers(-4, 3)
        expected = slow_half_window(curve, fps)
        assert windows.half_window(torch.from_numpy(curve), fps) == pytest.approx(expected)
        seen.add(round(expected, 3))
    assert 0.5 in seen
    assert len(seen) > 8


def test_a_curve_without_a_rhythm_has_the_shortest_window():
    t = torch.arange(200, dtype=torch.float64) / FPS
    assert windows.half_window(torch.sin(2 * math.pi * 0.4 * t), FPS) == 0.5  # a period over two seconds is not sought
    assert windows.half_window(1e-8 * torch.sin(2 * math.pi * t), FPS) == 0.5
    assert windows.half_window(torch.randn(300, generator=torch.Generator().manual_seed(6)), FPS) == 0.5
    assert windows.half_window(t[:61], FPS) == 0.5


def test_speed_is_the_root_mean_square_over_a_second():
    where = torch.randn(40, 3, generator=torch.Generator().manual_seed(7)).cumsum(0)
    got = windows.speed(where, 12.0)
    lengths = []
    for frame in range(40):
        before, after = max(frame - 1, 0), min(frame + 1, 39)
        lengths.append(float(((where[after] - where[before]).double() / (after - before) * 12).norm()))
    for frame in range(40):
        at = [min(max(frame + k, 0), 39) for k in range(-6, 7)]
        assert float(got[frame]) == pytest.approx(math.sqrt(sum(lengths[k] ** 2 for k in at) / 13))



# Coherent


def slow_wavelets(values, fps, cycles):
    """One column: the sum over positive frequencies of the spectrum of the mirrored curve under each band's bell."""
    pad = min(len(values) - 1, round(cycles / 0.35 * fps))
    mirrored = np.pad(values, pad, mode="reflect")
    n = len(mirrored)
    rates = np.arange(1, (n + 1) // 2) * fps / n
    turns = np.exp(2j * np.pi * np.outer(np.arange(n), rates) / fps)
    spectrum = turns.conj().T @ mirrored / n
    bands = 0.35 * (2.5 / 0.35) ** (np.arange(64) / 63)
    bells = 2 * np.exp(-0.5 * ((rates / bands[:, None] - 1) * cycles) ** 2)
    return ((bells * spectrum) @ turns.T)[:, pad : pad + len(values)]


@pytest.mark.parametrize(("frames", "fps"), [(40, 12.0), (150, 12.0), (70, 8.0)])
def test_wavelets_are_those_of_the_mirrored_curve(frames, fps):
    values = np.random.default_rng(9).normal(size=(frames, 2)).cumsum(0)
    got = coherent.wavelets(torch.from_numpy(values), fps, 2.5).numpy()
    for column in range(2):
        slow = slow_wavelets(values[:, column], fps, 2.5)
        assert np.abs(got[..., column] - slow).max() < 1e-10 * np.abs(slow).max()


def test_wavelets_of_a_constant_are_nothing():
    assert float(coherent.wavelets(torch.full((80, 1), 9.0, dtype=torch.float64), FPS, 2.5).abs().max()) < 1e-12


def best_path(power, penalty):
    cost = -(power / power.sum(0)).log()
    return min(itertools.product(range(power.shape[0]), repeat=power.shape[1]),
               key=lambda path: sum(float(cost[b, i]) for i, b in enumerate(path))
               + penalty * sum((a - b) ** 2 for a, b in itertools.pairwise(path)))


def test_the_ridge_does_not_care_how_loud_a_frame_is():
    generator = torch.Generator().manual_seed(10)
    for penalty in (0.0, 0.1, 0.5) * 2:
        power = torch.rand(4, 5, generator=generator, dtype=torch.float64) ** 3 + 1e-4
        best = list(best_path(power, penalty))
        assert coherent.ridge(power, 1, penalty).tolist() == best
        loudness = 10.0 ** torch.tensor([15.0, -15.0, 0.0, -10.0, 7.0], dtype=torch.float64)
        assert coherent.ridge(power * loudness, 1, penalty).tolist() == best
        assert coherent.ridge(power.flip(0), 1, penalty).tolist() == [3 - b for b in best]
        assert coherent.ridge(power.flip(1), 1, penalty).tolist() == best[::-1]


def test_between_its_knots_the_ridge_is_straight_and_after_the_last_level():
    power = torch.rand(5, 14, generator=torch.Generator().manual_seed(11), dtype=torch.float64) ** 4 + 1e-4
    knots = best_path(power[:, ::4], 0.02)
    assert len(set(knots)) > 2
    expected = np.interp(np.arange(14) / 4, np.arange(4), knots)
    assert coherent.ridge(power, 4, 0.02).numpy() == pytest.approx(expected)
    assert float(coherent.ridge(torch.zeros(5, 14, dtype=torch.float64), 4, 0.02).std()) == 0  # silence has a path too


def test_what_the_others_say_is_least_squares_damped_by_a_thousandth():
    """Ridge regression as plain least squares with one more row for each of the others."""
    generator = torch.Generator().manual_seed(12)
    z = torch.complex(*torch.randn(2, 300, 4, generator=generator, dtype=torch.float64))
    z = z + 1.5 * torch.exp(0.2j * torch.arange(300, dtype=torch.float64))[:, None] * torch.exp(1j * torch.arange(4))
    z = z * torch.tensor([0.1, 1.0, 3.0, 20.0])
    for scale in (1.0, 1e-3):  # in proportion, however small
        for limb in range(4):
            own, others = (scale * z)[:, limb].numpy(), np.delete((scale * z).numpy(), limb, 1)
            rows = np.diag(np.sqrt(1e-3 * (np.abs(others) ** 2).sum(0)))
            weights = np.linalg.lstsq(np.concatenate((others, rows)), np.concatenate((own, np.zeros(3))), rcond=None)[0]
            told = others @ weights
            share = (np.abs(told) ** 2).sum() / (np.abs(own) ** 2).sum()
            expected = (1 - share) * own + share * told
            assert np.abs(coherent.denoised(scale * z, limb).numpy() - expected).max() < 1e-6 * np.abs(own).max()
            assert 0.1 < share < 1


def test_limbs_that_do_nothing_say_nothing():
    z = torch.exp(0.1j * torch.arange(100, dtype=torch.float64))[:, None] * torch.tensor([1.0, 0.0, 0.0, 0.0])
    assert torch.allclose(coherent.denoised(z, 0), z[:, 0])
    assert float(coherent.denoised(z, 1).abs().max()) == 0


def test_amplitude_and_residual_of_a_curve_against_its_wave_do_not_go_below_zero():
    wave = torch.sin(torch.arange(200, dtype=torch.float64) / 5)
    amplitude, offset, residual = windows.regression(2 - wave, wave, 0.5, FPS)  # only a negative multiple would fit
    assert float(amplitude.abs().max()) == 0
    assert torch.allclose(offset, windows.mean(2 - wave, 0.5, FPS))
    assert torch.allclose(residual, (windows.mean((2 - wave) ** 2, 0.5, FPS) - offset**2).sqrt())
    amplitude, offset, residual = windows.regression(3 * wave + 1, wave, 0.5, FPS)
    assert torch.allclose(amplitude, torch.full_like(wave, 3.0))
    assert torch.allclose(offset, torch.ones_like(wave))
    assert float(residual.max()) < 1e-6
    still_wave = windows.regression(wave, torch.zeros_like(wave), 0.5, FPS)
    assert all(bool(column.isfinite().all()) for column in still_wave)


def test_coherent_takes_its_bases_axes_and_curves(walk_clip):
    clips = [walk_clip, procedural.generate("Zombie", "FW", 2.0)]
    base = tk.phases.ContactFree()
    source = tk.phases.Coherent(base, cycles=3.0, penalty=0.2)
    fitted = source.fitted(clips)
    assert (fitted.cycles, fitted.penalty) == (3.0, 0.2)
    shared = base.fitted(clips)
    for limb in LIMBS:
        assert torch.equal(source(walk_clip, limb), base(walk_clip, limb))
        assert torch.equal(fitted(walk_clip, limb), shared(walk_clip, limb))
    plain = tk.phases.Coherent(Curves(torch.zeros(len(walk_clip), 4)))
    assert plain.fitted(clips) is plain


def test_pure_waves_are_told_apart_and_followed():
    """Each limb at its own frequency, one above the tracked bands; far from the ends nothing disturbs them."""
    t = torch.arange(1800, dtype=torch.float64)[:, None] / FPS
    rates = torch.tensor([0.55, 0.83, 1.3, 2.8], dtype=torch.float64)
    size, level, lag = (torch.tensor(v, dtype=torch.float64) for v in ([1.0, 2.0, 0.5, 3.0], [0, 5, -3, 1], [0, 1, 2, 3]))
    angle = 2 * math.pi * rates * t + lag
    curve, found = tk.phases.Coherent(Curves(level + size * torch.sin(angle))).sinusoids(still(1800))
    inner = slice(180, -180)
    assert float(torch.sin((found.phase - angle) / 2)[inner].abs().max()) < 0.01
    assert float(found.phase.min()) >= 0
    assert float(found.phase.max()) < 2 * math.pi
    assert float((found.frequency / rates - 1)[inner].abs().max()) < 0.01
    for i, rate in enumerate(rates.tolist()):
        half = max(0.5, windows.CYCLES / 2 / rate)
        expected = smooth(normalise(torch.sin(angle[:, [i]]), FPS, half), FPS)[:, 0]
        assert float((curve[:, i] - expected)[inner].abs().max()) < 0.1
    assert float((found.amplitude * found.phase.sin() + found.offset - curve)[inner].abs().max()) < 0.1
    assert float(found.residual[inner].max()) < 0.1


def test_a_chirp_is_followed_from_band_to_band():
    t = torch.arange(1800, dtype=torch.float64) / FPS
    angle = 2 * math.pi * (0.6 * t + 0.03 * t**2 / 2)  # 0.6 to 1.5 Hz
    noise = 1e-3 * torch.randn(1800, 3, generator=torch.Generator().manual_seed(13), dtype=torch.float64)
    _, found = tk.phases.Coherent(Curves(torch.cat((torch.cos(angle)[:, None], noise), 1))).sinusoids(still(1800))
    inner = slice(180, -180)
    assert float(torch.sin((found.phase[:, 0] - angle - math.pi / 2) / 2)[inner].abs().max()) < 0.05
    assert float((found.frequency[:, 0] / (0.6 + 0.03 * t) - 1)[inner].abs().max()) < 0.03


@pytest.mark.parametrize("fps", [60.0, 24.0, 12.0])
def test_coherent_is_its_description_step_by_step(fps):
    """Wavelets, their ridge ten times a second, the signal on it between two bands, what the others say of it."""
    frames, generator = round(12 * fps), torch.Generator().manual_seed(14)
    t = torch.arange(frames, dtype=torch.float64)[:, None] / fps
    noise = torch.randn(frames, 4, generator=generator, dtype=torch.float64).cumsum(0) / math.sqrt(fps)
    raw = noise - noise.mean(0) + torch.sin(2 * math.pi * 0.9 * t + torch.arange(4)) + torch.arange(4)
    raw[:, 3] += 30 * torch.sin(2 * math.pi * 2.7 * t[:, 0])  # on the highest band
    _, found = tk.phases.Coherent(Curves(raw), cycles=2.0, penalty=0.05).sinusoids(still(frames, fps))
    waves = coherent.wavelets(raw - raw.mean(0), fps, 2.0)
    for i in range(4):
        power = waves[..., i].abs() ** 2 * coherent.BANDS[:, None] ** 2
        path = coherent.ridge(power, max(1, round(fps / 10)), 0.05)
        z = torch.empty(frames, 4, dtype=torch.complex128)
        for f, place in enumerate(path.tolist()):
            below = min(int(place), 62)
            z[f] = (below + 1 - place) * waves[below, f] + (place - below) * waves[below + 1, f]
        signal = coherent.denoised(z, i)
        assert float((torch.exp(1j * (found.phase[:, i] - math.pi / 2)) - signal / signal.abs()).abs().max()) < 1e-9
        turns = torch.tensor([0.0, *(float((signal[f] / signal[f - 1]).angle()) for f in range(1, frames))]) / (2 * math.pi)
        turns[0] = turns[1]
        growth = windows.mean(turns.double(), windows.half_window(raw[:, i], fps), fps) * fps
        assert torch.allclose(found.frequency[:, i], growth.clamp(0.25, 4.0), atol=1e-4)


def test_contacts_are_counted_from_three_changes_on_beside_limbs_that_have_none():
    frames = 300
    t = torch.arange(frames, dtype=torch.float64) / FPS
    raw = torch.zeros(frames, 4, dtype=torch.float64)
    raw[:, 0] = torch.sin(2 * math.pi * t)  # no contact
    raw[60:120, 2] = 1  # two changes
    raw[50:110, 3] = raw[190:, 3] = 1  # three
    _, found = tk.phases.Coherent(Curves(raw)).sinusoids(still(frames))
    signal = steps.signal(raw[:, 3])
    assert float((torch.exp(1j * (found.phase[:, 3] - math.pi / 2)) - signal).abs().max()) < 1e-9
    share = 60 / (60 + 80)
    amid = math.pi / 2 + steps.EARLY * math.pi * (share - steps.WALK)  # its sine is near its highest
    assert float(found.phase[80, 3]) == pytest.approx(amid, abs=0.05)
    assert all(bool(column.isfinite().all()) for column in vars(found).values())


def test_the_cadence_of_contacts_keeps_the_fits_bounds():
    at = torch.arange(1500)
    raw = torch.stack((at % 12 < 6, at % 360 < 180, at % 60 < 30, at % 45 < 30), 1)  # 5, 1/6, 1 and 4/3 Hz
    _, found = tk.phases.Coherent(Curves(raw)).sinusoids(still(1500))
    assert found.frequency[300:-300].mean(0).tolist() == pytest.approx([4.0, 0.25, 1.0, 4 / 3], rel=0.01)
