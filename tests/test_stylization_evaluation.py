"""What judges restyled motion: Fréchet distance, classifiers, measures, the baselines of Table 2, the comparison."""

import math

import pytest
import torch
from scipy.linalg import sqrtm

import toolkit as tk
from experiments.stylization import aberman, classifier, comparison, evaluation, holden
from toolkit.stylization import Config, data, losses
from toolkit.stylization.medley import medley
from toolkit.stylization.networks import Sizes

TINY = Config.quick(iterations=1, sizes=Sizes(channels=4, hidden=8))


@pytest.fixture(scope="module")
def motions() -> data.Motions:
    """Two styles walking and standing, five takes of each, a window of each take."""
    clips = [clip for seed in range(5) for clip in tk.datasets.load("procedural", styles=["Neutral", "Zombie"],
             gaits=["FW", "ID"], seconds=2.3, seed=seed)]
    return data.build(clips)


@pytest.fixture(scope="module")
def judges(motions) -> evaluation.Judges:
    """Trained on everything there is: what is tested here is what they are asked."""
    made = [classifier.fit(motions, label, epochs=15, batch=5, channels=8, seed=1) for label in ("content", "domain")]
    return evaluation.Judges(*made, classifier.features(made[0], motions.x))


class Paste:
    """Restyles by giving back the reference."""

    def code_of(self, x, domain):
        return x

    def translate(self, x, code):
        return code


class Unchanged(Paste):
    """Restyles by doing nothing."""

    def translate(self, x, code):
        return x


def samples(mean: torch.Tensor, root: torch.Tensor, n: int, seed: int) -> torch.Tensor:
    """``[n, D]`` whose sample mean and covariance are exactly ``mean`` and ``root @ root.T``."""
    x = torch.randn(n, len(root), generator=torch.Generator().manual_seed(seed), dtype=torch.float64)
    x = x - x.mean(0)
    return mean + math.sqrt(n - 1) * torch.linalg.svd(x, full_matrices=False)[0] @ root.T


def test_frechet_distance_of_gaussians_has_its_closed_form():
    draw = torch.Generator().manual_seed(3)
    (a, b), (m, n) = torch.randn(2, 5, 5, generator=draw).double(), torch.randn(2, 5, generator=draw).double()
    p, q = a @ a.T, b @ b.T
    closed = (m - n).square().sum() + torch.trace(p + q - 2 * torch.from_numpy(sqrtm((p @ q).numpy()).real))
    assert tk.metrics.frechet_distance(samples(m, a, 40, 0), samples(n, b, 70, 1)) == pytest.approx(float(closed), rel=1e-6)


def test_frechet_distance_of_spheres_points_and_of_a_set_from_itself():
    narrow, wide = (samples(torch.zeros(4).double(), s * torch.eye(4).double(), 30, 0) for s in (1.0, 3.0))
    assert tk.metrics.frechet_distance(narrow, wide) == pytest.approx(4 * (3 - 1) ** 2)
    few = torch.randn(3, 50, generator=torch.Generator().manual_seed(0))  # fewer rows than columns: singular covariance
    assert tk.metrics.frechet_distance(few, few) == pytest.approx(0.0, abs=1e-6)
    assert tk.metrics.frechet_distance(few, few + 2.0) == pytest.approx(200.0, rel=1e-5)
    still = torch.zeros(4, 50)
    assert tk.metrics.frechet_distance(still, still + 2.0) == pytest.approx(200.0)


@pytest.mark.parametrize("shape", [(1, 4), (5, 3), (5,)])
def test_frechet_distance_refuses_what_is_no_pair_of_sets(shape):
    with pytest.raises(ValueError, match=r"expected features \[M, D\]"):
        tk.metrics.frechet_distance(torch.zeros(5, 4), torch.zeros(shape))


def test_a_classifier_names_contents_and_styles_of_takes_it_never_saw(motions):
    train, test = data.split(motions, 0.4, 0)
    for label in ("content", "domain"):
        model = classifier.fit(train, label, epochs=15, batch=4, channels=8)
        assert evaluation.accuracy(model, test.x, getattr(test, label)) > 0.9
        assert classifier.features(model, test.x).shape == (len(test), 32)
        assert model.classes == getattr(motions, f"{label}s")
    with pytest.raises(ValueError, match="content or domain, not 'gait'"):
        classifier.fit(train, "gait")


def test_the_features_are_256_at_the_size_of_the_paper(motions):
    model = classifier.Classifier(motions.graph, motions.contents, motions.statistics()).eval()
    assert classifier.features(model, motions.x[:2]).shape == (2, 256)


def test_a_classifier_is_the_same_from_the_same_seed_and_after_a_file(motions, tmp_path):
    first, again = (classifier.fit(motions, "domain", epochs=1, channels=4, seed=5) for _ in range(2))
    first.save(tmp_path / "judge.safetensors")
    read = classifier.Classifier.load(tmp_path / "judge.safetensors", motions.graph)
    for other in (again, read):
        assert torch.equal(classifier.features(first, motions.x), classifier.features(other, motions.x))
    assert read.classes == first.classes
    graph = data.SkeletonGraph.of(tk.Skeleton(*zip(*[(f"j{i}", i - 1) for i in range(6)], strict=True), torch.ones(6, 3)))
    with pytest.raises(ValueError, match="of another skeleton, or is damaged"):
        classifier.Classifier.load(tmp_path / "judge.safetensors", graph)


def test_pairs_are_every_source_with_every_other_domain(motions):
    rows, target = evaluation.pairs(motions)
    slow = [(i, d) for i in range(len(motions)) for d in range(2) if d != int(motions.domain[i])]
    assert list(zip(rows.tolist(), target.tolist(), strict=True)) == slow


def test_doing_nothing_keeps_all_content_and_moves_no_style(motions, judges):
    found = evaluation.evaluate(Unchanged(), motions, motions, judges, by="reference")
    assert found["content"] == 1.0
    assert found["style"] == 0.0
    assert found["diversity"] == found["change"] == 0.0
    assert found["contact_raw"] == 1.0
    assert found["contact_f1"] > 0.95  # holding feet that stand already
    assert found["fmd"] < 0.05  # two domains: every motion comes twice, in the real set once


def test_pasting_the_reference_moves_all_style_and_loses_the_content(motions, judges):
    found = evaluation.evaluate(Paste(), motions, motions, judges, by="reference")
    assert found["style"] == 1.0
    assert found["content"] < 0.8  # half of the references stand, half of the sources do
    assert found["diversity"] > 0.03
    assert found["contact_raw"] < 0.8
    again = evaluation.evaluate(Paste(), motions, motions, judges, by="reference")
    assert again == found
    assert evaluation.evaluate(Paste(), motions, motions, judges, by="reference", seed=1) != found


def test_codes_come_by_noise_or_by_reference(motions, judges):
    with pytest.raises(ValueError, match="got 'luck'"):
        evaluation.evaluate(Paste(), motions, motions, judges, by="luck")
    stylizer = tk.stylization.fit(motions, TINY).stylizer
    found = evaluation.evaluate(stylizer, motions.select(torch.tensor([0, 1])), motions, judges)
    assert all(math.isfinite(value) for value in found.values())
    assert found["diversity"] > 0


def test_a_window_as_a_clip_is_the_motion_seen_from_its_first_frame(motions):
    clip = data.prepare(tk.datasets.load("procedural", styles="Neutral", gaits="FW", seconds=2.3)[0]).cut(0, 64)
    walk = data.build([clip])
    made = evaluation.clip_of(walk.x[0], walk.root_velocity[0], walk.skeleton)
    local = [tk.motion.root_frames(c).to_local(c.global_positions) for c in (made, clip)]
    assert torch.allclose(*local, atol=1e-4)
    assert torch.equal(tk.contacts.detect(made), tk.contacts.detect(clip))


def test_held_feet_agree_with_the_source_more_than_sliding_ones(motions):
    walks = motions.select(motions.content == motions.contents.index("FW"))
    sliding = walks.x.clone()
    sliding[:, 2] += 0.15 * torch.sin(torch.arange(64.0))[:, None]  # the body rocks to and fro over its root
    same, slid = (evaluation.contact_agreement(walks, x) for x in (walks.x, sliding))
    assert same["contact_raw"] == 1.0
    assert slid["contact_raw"] < 0.9
    assert slid["contact_f1"] > slid["contact_raw"]


def test_contact_f1_counts_agreement_of_those_who_step():
    step = torch.tensor([1.0, 1, 0, 0]).repeat(16)  # lands every four frames
    walker, late = torch.stack((step, 1 - step), 1), torch.stack((step.roll(1), 1 - step.roll(1)), 1)
    stander = torch.ones(64, 2)
    assert evaluation.contact_f1(walker[None], walker[None]) == 1.0
    assert evaluation.contact_f1(walker[None], late[None]) == 0.5
    both = torch.stack((walker, stander)), torch.stack((late, torch.zeros(64, 2)))
    assert evaluation.contact_f1(*both) == 0.5  # who only stands does not count
    assert math.isnan(evaluation.contact_f1(stander[None], stander[None]))


def test_distance_is_the_joints_way_in_metres(motions):
    moved = motions.x.clone()
    moved[:, :2] += torch.tensor([0.03, 0.04])[:, None, None]
    moved[:, 3:] += 1.0  # rotations do not count
    assert evaluation.distance(motions.x, moved) == pytest.approx(0.05, rel=1e-4)


def test_gram_matrix_against_loops():
    hidden = torch.randn(2, 3, 5, generator=torch.Generator().manual_seed(0))
    slow = torch.zeros(2, 3, 3)
    for b in range(2):
        for i in range(3):
            for j in range(3):
                slow[b, i, j] = sum(hidden[b, i, t] * hidden[b, j, t] for t in range(5)) / 5
    assert torch.allclose(holden.gram(hidden), slow, atol=1e-6)


def test_frames_as_vectors_and_back(motions):
    x = motions.x[:2]
    assert torch.equal(holden.unflat(holden.flat(x)), x)
    assert torch.equal(holden.flat(x)[1, :, 7], x[1, :, 7].flatten())


def test_holden_learns_to_give_back_and_edits_towards_the_reference(motions):
    torch.manual_seed(0)
    untrained = holden.Holden(motions.statistics(), hidden=256).eval()
    model = holden.fit(motions, Config(iterations=25, seed=2))
    z = model.statistics.apply(motions.x)
    with torch.no_grad():
        before, after = ((m.decode(m.encode(z)) - z).square().mean() for m in (untrained, model))
    assert after < 0.85 * before
    source, reference = motions.x[:2], motions.x[motions.domain == 1][:2]
    code = model.code_of(reference)
    content = model.encode(model.statistics.apply(source))
    made = model.translate(source, code)
    assert torch.equal(made, model.translate(source, code))
    plain = holden.Holden(motions.statistics(), steps=0)
    plain.load_state_dict(model.state_dict())
    nearer = [(model.code_of(x) - code).square().mean() for x in (made, plain.translate(source, code))]
    assert nearer[0] < 0.7 * nearer[1]
    with torch.no_grad():
        energy = model.energy(content + 0.1, content, code)
        slow = 0.01 + model.style_weight * (holden.gram(content + 0.1) - code).square().mean((1, 2))
    assert torch.allclose(energy, slow, rtol=1e-4)


def test_aberman_takes_content_and_style_from_where_they_belong(motions):
    model, same = (aberman.fit(motions, Config(iterations=2, batch=4, seed=1)) for _ in range(2))
    x = motions.x[:3]
    with torch.no_grad():
        code = model.code_of(motions.x[3:6])
        assert code.shape == (3, 64)
        made = model.translate(x, code)
        assert torch.equal(made, same.translate(x, same.code_of(motions.x[3:6])))
        assert not torch.allclose(made, model.translate(x, model.code_of(motions.x[6:9])), atol=1e-4)
        h = torch.randn(2, 96, 16, generator=torch.Generator().manual_seed(0))
        normed = model.content.blocks[0]  # its convolutions do not see how large the input is, its shortcut does
        assert torch.allclose(normed(3 * h), normed(h) + 2 * normed.across(h) / 2**0.5, atol=1e-3)
        long = torch.cat((x, x, x[:, :, :4]), 2)
        assert model.translate(long, code).shape == long.shape
    assert torch.allclose(made[:, 3:].norm(dim=1), torch.ones(()), atol=1e-5)


def test_aberman_learns_to_give_back_its_source(motions, monkeypatch):
    monkeypatch.setattr(aberman, "WIDTHS", (16, 24, 32))
    error = []
    for iterations in (1, 80):
        model = aberman.fit(motions, Config.quick(iterations=iterations, batch=4))
        with torch.no_grad():
            z = model.statistics.apply(motions.x)
            error.append(float((model.decode(z, model.encode(z)) - z).abs().mean()))
    assert error[1] < 0.9 * error[0]


@pytest.fixture(scope="module")
def compared(motions, tmp_path_factory):
    """A comparison of two iterations, in its folder."""
    folder = tmp_path_factory.mktemp("comparison")
    plan = comparison.Plan("procedural", iterations=2, small=True, sources=2, epochs=1)
    return folder, plan, comparison.compare(motions, plan, [0], folder)


def test_a_comparison_measures_every_row_of_both_tables(compared):
    _, _, table = compared
    assert list(table["noise"]) == list(comparison.ABLATION)
    assert list(table["reference"]) == [*comparison.ABLATION, *comparison.BASELINES]
    for by in ("noise", "reference"):
        for rows in table[by].values():
            assert [row["seed"] for row in rows] == [0]
            assert set(comparison.MEASURES) <= set(rows[0])
    assert comparison.ABLATION["adv+cyc+id+sty+ds"] == losses.LOSSES
    assert table["unchanged"]["style"] <= 1.0
    windows = table["settings"]["windows"]
    assert windows["sources"] == 2
    assert windows["judges"] + windows["training"] + windows["test"] == 20


def test_a_comparison_does_nothing_twice_and_refuses_other_settings(compared, motions, monkeypatch):
    folder, plan, table = compared
    for module, name in ((comparison.training, "fit"), (comparison.classifier, "fit"), (comparison, "evaluate")):
        monkeypatch.setattr(module, name, lambda *a, **k: pytest.fail("was done again"))
    again = comparison.compare(motions, plan, [0], folder)
    assert all(again[key] == table[key] for key in ("noise", "reference", "real", "unchanged", "judges"))
    with pytest.raises(ValueError, match=r"other settings \(iterations: expected 2, got 3\)"):
        comparison.compare(motions, comparison.Plan("procedural", 3, sources=2, epochs=1, small=True), [0], folder)


def test_a_comparison_prints_the_papers_numbers_beside_its_own(compared, capsys):
    comparison.show(compared[2])
    text = capsys.readouterr().out
    for number in ("14.14", "57.92", "8.58", "77.86", "9.09", "72.64", "6.82", "60.86", "15.86", "42.81", "14.10", "37.99"):
        assert number in text
    assert "2 iterations" in text
    assert "seeds 0" in text


def test_too_few_takes_are_refused(motions, tmp_path):
    few = motions.select(motions.take < 8)
    with pytest.raises(ValueError, match="too few takes to split"):
        comparison.compare(few, comparison.Plan("few", 1), [0], tmp_path)


def test_the_strip_has_a_source_and_rows_for_every_domain(motions, tmp_path):
    stylizer = tk.stylization.fit(motions, TINY).stylizer
    clips = {s: tk.datasets.load("procedural", styles=s, gaits="FW", seconds=3.0)[0] for s in ("Neutral", "Zombie")}
    rows = comparison.restyled(stylizer, clips["Neutral"], {"Zombie": clips["Zombie"]}, (1, 2))
    assert list(rows) == ["Neutral: source", "Zombie, noise 1", "Zombie, noise 2", "Zombie, reference"]
    assert rows["Neutral: source"] is clips["Neutral"]
    assert all(abs(len(clip) - len(clips["Neutral"])) < 2 for clip in rows.values())
    stylizer.save(tmp_path / "model.safetensors")
    comparison.strip(tmp_path / "model.safetensors", "Zombie", "Neutral", "FW", tmp_path / "strip.png", data="procedural")
    assert (tmp_path / "strip.png").stat().st_size > 10_000


def test_a_medley_goes_on_where_the_last_clip_ended():
    clips = tk.datasets.load("procedural", styles="Neutral", gaits=["FW", "SW", "FR"], seconds=3.0)
    whole = medley(clips, overlap=0.5)
    assert len(whole) == sum(map(len, clips)) - 2 * 30
    assert torch.equal(whole.rotations[:150], tk.motion.rotations.unroll(clips[0].rotations)[:150])
    middle = whole.cut(180, 300), clips[1].cut(30, 150)  # the second clip alone: relative to its root it is what it was
    assert torch.allclose(*(tk.motion.root_frames(c).to_local(c.global_positions) for c in middle), atol=1e-4)
    speed = tk.contacts.velocities(whole.global_positions, whole.fps).norm(dim=-1)
    fastest = max(tk.contacts.velocities(c.global_positions, c.fps).norm(dim=-1).max() for c in clips)
    assert speed.max() < 1.3 * fastest  # nothing jumps
    with pytest.raises(ValueError, match="one skeleton and rate, got 2 clips of 30 Hz, 60 Hz"):
        medley([clips[0], clips[1].resample(30.0)])
    with pytest.raises(ValueError, match="need 60 frames, it has 50"):
        medley([clips[0], clips[1].cut(0, 50)])
