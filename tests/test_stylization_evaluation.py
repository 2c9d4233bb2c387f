"""What judges restyled motion: Fréchet distance, classifiers, measures, the baselines of Table 2, the comparison."""

import dataclasses
import math

import pytest
import torch
from scipy.linalg import sqrtm

import toolkit as tk
from experiments.stylization import (
    aberman,
    codes,
    comparison,
    convolutional,
    evaluation,
    floors,
    holden,
    leads,
    looks,
    lost_content,
    mirror,
    posture,
    sets,
)
from experiments.stylization.judges import Judge, Judges
from toolkit.stylization import Config, data, networks, training
from toolkit.stylization.medley import medley
from toolkit.stylization.networks import Sizes

TINY = Config.quick(iterations=1, warm_up=0, sizes=Sizes(channels=4, hidden=8, detailed=True))


@pytest.fixture(scope="module")
def motions() -> data.Motions:
    """Two styles walking and standing, five takes of each, a window of each take."""
    clips = [clip for seed in range(5) for clip in tk.datasets.load("procedural", styles=["Neutral", "Zombie"],
             gaits=["FW", "ID"], seconds=2.3, seed=seed)]
    return data.build(clips)


@pytest.fixture(scope="module")
def judges(motions) -> Judges:
    """Trained on everything there is: what is tested here is what they are asked."""
    return Judges.train({"content": motions, "style": motions}, motions)


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


def test_a_judge_names_contents_and_styles_of_takes_it_never_saw(motions):
    train, test = data.split(motions, 0.4, 0)
    for label in ("content", "domain"):
        judge = Judge.train(train, label)
        assert judge.right(test.x, getattr(test, label)).float().mean() > 0.9
        assert judge.features(test.x).shape[0] == len(test)


def test_a_judge_of_movement_does_not_see_the_mean_pose(motions):
    judge = Judge.train(motions, "domain", posture=False)
    bent = motions.x + torch.randn(7, 1, motions.x.shape[-1], generator=torch.Generator().manual_seed(0)) * 0.05
    bent[:, 3:] = motions.x[:, 3:]
    assert judge.described(bent) == pytest.approx(judge.described(motions.x), abs=1e-4)
    whole = Judge.train(motions, "domain")
    assert abs(whole.described(bent) - whole.described(motions.x)).max() > 0.1


def test_distances_are_of_equally_many_motions(motions, judges):
    """A few real motions are as near to the real ones as their number allows, and fewer come out farther."""
    found = judges.judge(motions.x, motions.content, motions.domain)
    assert found["fmd"] == pytest.approx(0, abs=1e-4)
    assert found["domain_fmd"] == pytest.approx(0, abs=1e-4)
    assert found["both"] == found["content"] == found["style"] == 1.0
    wrong = judges.judge(motions.x, motions.content, 1 - motions.domain)
    assert wrong["style"] == wrong["both"] == 0
    assert wrong["domain_fmd"] > 1


def test_pairs_are_every_source_with_every_other_domain(motions):
    rows, target = evaluation.pairs(motions)
    slow = [(i, d) for i in range(len(motions)) for d in range(2) if d != int(motions.domain[i])]
    assert list(zip(rows.tolist(), target.tolist(), strict=True)) == slow


def test_doing_nothing_keeps_all_content_and_moves_no_style(motions, judges):
    found = evaluation.evaluate(Unchanged(), motions, motions, judges, by="reference")
    assert found["content"] == 1.0
    assert found["style"] == 0.0
    assert found["diversity"] == pytest.approx(0, abs=0.1)  # arccos near 1
    assert found["contact_f1"] == found["acceleration"] == 1.0
    assert found["bone"] < 1e-5
    assert found["both"] == 0.0
    assert found["movement"] < 0.1


def test_pasting_the_reference_moves_all_style_and_loses_the_content(motions, judges):
    found = evaluation.evaluate(Paste(), motions, motions, judges, by="reference")
    assert found["style"] == 1.0
    assert found["content"] < 0.8  # half of the references stand, half of the sources do
    assert found["diversity"] > 1
    assert found["contact_f1"] < 0.8
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


class MeanPose(torch.nn.Module):
    """Its codes are mean positions, which it adds; a domain's codes are 0 for references where it is ``deaf``."""

    def __init__(self, motions, deaf):
        super().__init__()
        self.domains, self.deaf = motions.domains, deaf
        self.sizes = Sizes(latent=3 * motions.graph.sizes[0])

    def code_of(self, x, domain):
        return x[:, :3].mean(2).flatten(1) * (0 if self.deaf else 1)

    def code_from(self, z, domain):
        return z

    def translate(self, x, code):
        return torch.cat((x[:, :3] + code.view(len(x), 3, 1, -1), x[:, 3:]), 1)


def test_codes_that_hold_the_reference_spread_and_are_followed(motions):
    deaf, faithful = (codes.spreads(MeanPose(motions, deaf), motions, motions) for deaf in (True, False))
    assert deaf["within"] == deaf["between"] == deaf["follows"] == 0
    assert deaf["noise"] == pytest.approx(1, abs=0.1)
    assert faithful["within"] > 0
    chance = 1 / len(motions.domains) / len(motions.x)  # two equal references have no direction
    assert 1 - 20 * chance < faithful["follows"] <= 1.0001


def test_no_loss_pulls_codes_that_are_equal_and_diversity_widens_the_others(motions):
    run = tk.stylization.fit(motions, TINY)
    torch.nn.init.normal_(run.stylizer.generator.lower.weight, std=0.1)
    found = codes.pulls(run, motions)
    assert all(len(values) == codes.BATCHES for values in found.values())
    assert max(found["ds"]) < 0
    torch.nn.init.zeros_(run.stylizer.encoder.branches.weight)
    assert all(value == pytest.approx(0, abs=1e-6) for values in codes.pulls(run, motions).values() for value in values)


def test_a_window_as_a_clip_is_the_motion_seen_from_its_first_frame(motions):
    clip = data.prepare(tk.datasets.load("procedural", styles="Neutral", gaits="FW", seconds=2.3)[0]).cut(0, 64)
    walk = data.build([clip])
    made = evaluation.clip_of(walk.x[0], walk.root_velocity[0], walk.skeleton)
    local = [tk.motion.root_frames(c).to_local(c.global_positions) for c in (made, clip)]
    assert torch.allclose(*local, atol=1e-4)
    assert torch.equal(tk.contacts.detect(made), tk.contacts.detect(clip))


def test_sliding_feet_agree_less(motions):
    walks = motions.select(motions.content == motions.contents.index("FW"))
    sliding = walks.x.clone()
    sliding[:, 2] += 0.15 * torch.sin(torch.arange(64.0))[:, None]  # the body rocks to and fro over its root
    same, slid = (evaluation.contact_agreement(walks, x) for x in (walks.x, sliding))
    assert same == 1.0
    assert slid < 0.9


def test_references_of_another_content_are_never_of_the_sources(motions, judges):
    seen = []

    class Watch(Unchanged):
        def code_of(self, x, domain):
            seen.append(x)
            return x

    walks = motions.select(motions.content == motions.contents.index("FW"))
    evaluation.evaluate(Watch(), walks, motions, judges, by="dissimilar")
    standing = motions.x[motions.content == motions.contents.index("ID")]
    assert all((standing == x).flatten(1).all(1).any() for part in seen for x in part)


def test_floors_do_what_they_say(motions):
    rows, target = evaluation.pairs(motions)
    sources = motions.select(rows)
    assert torch.equal(floors.unchanged(motions)(sources, target), sources.x)
    shifted = floors.mean_pose_shift(motions)(sources, target)
    for d in range(2):
        means = [x[:, :3].mean((0, 2)) for x in (shifted[target == d], motions.x[motions.domain == d])]
        torch.testing.assert_close(*means, atol=1e-5, rtol=0)
    found = floors.nearest(motions)(sources, target)
    k = 3
    own = motions.x[motions.domain == target[k]]
    slow = min(range(len(own)), key=lambda i: float((own[i, :3] - sources.x[k, :3]).square().sum()))
    assert torch.equal(found[k], own[slow])


def test_contact_f1_counts_agreement_of_those_who_step():
    step = torch.tensor([1.0, 1, 0, 0]).repeat(16)  # lands every four frames
    walker, late = torch.stack((step, 1 - step), 1), torch.stack((step.roll(1), 1 - step.roll(1)), 1)
    stander = torch.ones(64, 2)
    assert evaluation.contact_f1(walker[None], walker[None]) == 1.0
    assert evaluation.contact_f1(walker[None], late[None]) == 0.5
    both = torch.stack((walker, stander)), torch.stack((late, torch.zeros(64, 2)))
    assert evaluation.contact_f1(*both) == 0.5  # who only stands does not count
    assert math.isnan(evaluation.contact_f1(stander[None], stander[None]))


def test_an_angle_is_that_of_the_joints_and_ignores_being_out_of_step(motions):
    turn = torch.tensor([math.cos(0.1), math.sin(0.1), 0.0, 0.0])
    q = motions.x[:, 3:].permute(0, 2, 3, 1)
    turned = torch.cat((motions.x[:, :3], tk.motion.rotations.multiply(turn, q).permute(0, 3, 1, 2)), 1)
    still = motions.x[:, :, :1].expand_as(motions.x), turned[:, :, :1].expand_as(turned)
    torch.testing.assert_close(evaluation.angles(*still), torch.full((len(q),), math.degrees(0.2)), atol=0.02, rtol=0)
    assert (evaluation.angles(motions.x, motions.x.roll(6, 2)) < 0.2).all()
    longer = motions.x.clone()
    longer[:, :3] *= 1.1
    bones = motions.skeleton.offsets[1:].norm(dim=-1).mean()
    assert evaluation.bone_error(longer, motions.skeleton) == pytest.approx(0.1 * float(bones), rel=1e-3)
    torch.testing.assert_close(evaluation.acceleration(longer), 1.1 * evaluation.acceleration(motions.x))


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


def test_aberman_takes_content_from_rotations_and_style_from_positions(motions):
    model, same = (aberman.fit(motions, Config(iterations=2, batch=4, seed=1)) for _ in range(2))
    x, others = motions.x[:3], motions.x[3:6]
    code = model.code_of(others)
    assert code.shape == (3, 64)
    made = model.translate(x, code)
    assert torch.equal(made, same.translate(x, same.code_of(others)))
    assert not torch.allclose(made, model.translate(x, model.code_of(motions.x[6:9])), atol=1e-4)
    turned = torch.cat((others[:, :3], others[:, 3:].roll(1, 3)), 1)
    assert torch.equal(model.code_of(turned), code)
    moved = torch.cat((x[:, :3] + 0.1 * torch.arange(x.shape[-1]).clamp(max=1), x[:, 3:]), 1)  # all joints but the root
    torch.testing.assert_close(model.translate(moved, code), made)
    assert evaluation.bone_error(made, motions.skeleton) < 1e-5
    long = torch.cat((x, x, x[:, :, :4]), 2)
    assert model.translate(long, code).shape == long.shape


def test_aberman_learns_to_give_back_its_source(motions):
    error = []
    for iterations in (1, 80):
        model = aberman.fit(motions, Config.quick(iterations=iterations, batch=4))
        with torch.no_grad():
            made = model.translate(motions.x, model.code_of(motions.x))
            error.append(float((made - motions.x)[:, :3].abs().mean()))
    assert error[1] < 0.9 * error[0]


@pytest.mark.parametrize("sizes", [Sizes.small(), Sizes(detailed=True)])
def test_the_convolutional_baseline_is_as_large_and_trains_in_the_same_way(motions, sizes):
    counts = []
    for make in (networks.build, convolutional.build):
        stylizer, _ = make(motions.graph, motions.domains, sizes, motions.statistics())
        counts.append(sum(p.numel() for p in stylizer.generator.parameters()))
    assert 0.8 < counts[1] / counts[0] < 1.25
    run = tk.stylization.fit(motions, TINY, networks=convolutional.build)
    made = run.stylizer.translate(motions.x[:2], run.stylizer.code_of(motions.x[2:4], 1))
    assert made.shape == motions.x[:2].shape


@pytest.fixture(scope="module")
def task(motions) -> sets.Task:
    parts = {"test": motions, "validation": motions}
    return sets.Task(motions, parts, parts, {part: {"content": motions, "style": motions} for part in sets.PARTS})


@pytest.fixture(scope="module")
def compared(task, tmp_path_factory):
    """A comparison of two iterations, in its folder."""
    folder = tmp_path_factory.mktemp("comparison")
    plan = comparison.Plan(seconds=60, sources=2, iterations=2)
    for method in comparison.METHODS:
        comparison.measure(method, task, plan, 0, folder, "dataset-1")
    return folder, plan


def test_a_comparison_has_rows_for_every_method_and_floor(compared, task):
    folder, plan = compared
    result = comparison.summary("dataset-1", task, plan, folder)
    named = {(row["method"], row.get("codes")) for row in result.rows}
    assert {("real motion", None), *((floor, None) for floor in floors.FLOORS)} <= named
    assert {(name, by) for name in comparison.OURS for by in evaluation.WAYS} <= named
    assert ("Holden et al. 2016", "dissimilar") in named
    text = result.markdown()
    for number in ("9.1", "8.6", "14.1", "6.8", "15.9", "73", "78", "58", "61", "43", "38"):
        assert f"| {number} |" in text
    assert comparison.OURS["ours"] == {}


def test_a_comparison_does_nothing_twice_and_refuses_other_settings(compared, task, monkeypatch):
    folder, plan = compared
    comparison._settle(folder, plan)
    monkeypatch.setattr(comparison, "trained", lambda *a, **k: pytest.fail("was done again"))
    assert comparison.measure("ours", task, plan, 0, folder, "dataset-1")["seed"] == 0
    with pytest.raises(ValueError, match=r"other settings \(sources: expected 2, got 3\)"):
        comparison._settle(folder, comparison.Plan(seconds=60, sources=3, iterations=2))
    with pytest.raises(ValueError, match="unknown: ours2; known: ours"):
        comparison._words("ours2", comparison.METHODS)


def test_the_recipe_and_its_curve_are_measured_beside_floors(task, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(comparison.sets, "load", lambda name: task)
    monkeypatch.setattr(comparison.Plan, "config", lambda plan, seed, **changes: Config.quick(
        **{"seed": seed, "seconds": plan.seconds, "iterations": 4, "sizes": TINY.sizes, "warm_up": 1, **changes}))
    comparison.curve(seconds=1e-3, points=2, sources=2, out=tmp_path / "run.safetensors")
    first = [line.split("|")[1].strip() for line in capsys.readouterr().out.splitlines() if line.startswith("| ")]
    assert first[2:] == ["noise", "reference"] * 2 + ["unchanged source", "mean-pose shift"]
    assert tk.stylization.load(tmp_path / "run.safetensors").stylizer.domains == task.train.domains
    comparison.recipe(out=tmp_path, seconds=1e-3, sources=2, seeds="0,1", rows="the recipe,R1 in every iteration")
    assert "| instead: R1 in every iteration | reference |" in capsys.readouterr().out


def test_no_take_is_in_two_parts():
    clips = [tk.datasets.load("procedural", styles=style, gaits=gait, seconds=2.3, seed=seed)[0]
             for style in ("Neutral", "Zombie", "Old") for gait in ("FW", "SW", "FR", "ID") for seed in range(2)]
    motions = data.build(clips, mirror=True)
    task = sets.few_takes(motions, ("Neutral", "Zombie"), {"FW": "walk", "SW": "walk", "FR": "run"})
    assert task.sources["test"].contents == ("run", "walk")
    takes = {"train": set(task.train.take.tolist()),
             **{part: set(task.references[part].take.tolist()) for part in sets.PARTS}}
    assert not takes["train"] & takes["test"]
    assert not takes["train"] & takes["validation"]
    assert not takes["test"] & takes["validation"]
    for part in sets.PARTS:
        for judged in task.judged[part].values():
            assert not takes[part] & set(judged.take.tolist())
        assert set(task.sources[part].take.tolist()) <= takes[part]
    assert task.judged["test"]["content"].domains == motions.domains
    many = sets.many_takes(motions)
    parts = [many.train, *many.sources.values(), many.judged["test"]["style"]]
    assert sum(len(part.take.unique()) for part in parts) == len(torch.cat([part.take for part in parts]).unique())
    with pytest.raises(ValueError, match="knows dataset-1, dataset-2, not 'dataset-3'"):
        sets.load("dataset-3")


def test_the_strip_has_a_source_and_rows_for_every_domain(motions, tmp_path, capsys):
    stylizer = tk.stylization.fit(motions, TINY).stylizer
    clips = {s: tk.datasets.load("procedural", styles=s, gaits="FW", seconds=3.0)[0] for s in ("Neutral", "Zombie")}
    rows = looks.restyled(stylizer, clips["Neutral"], {"Zombie": [clips["Zombie"]]}, (1, 2))
    assert list(rows) == ["Neutral FW: source", "Zombie, noise 1", "Zombie, noise 2", "Zombie, reference FW"]
    assert rows["Neutral FW: source"] is clips["Neutral"]
    assert all(abs(len(clip) - len(clips["Neutral"])) < 2 for clip in rows.values())
    stylizer.save(tmp_path / "model.safetensors")
    looks.strip(tmp_path / "model.safetensors", "Zombie", "Neutral", "FW,FR", tmp_path, data="procedural", seconds=1.0)
    assert (tmp_path / "FW.png").stat().st_size > 10_000
    assert (tmp_path / "FR.webp").stat().st_size > 10_000
    assert "| Neutral, 1,000 frames: source |" in capsys.readouterr().out


def test_what_is_measured_of_a_look_is_seen_in_styles_that_have_it():
    plain, old = (looks.measured(tk.datasets.load("procedural", styles=s, gaits="FW", seconds=4.0)[0])
                  for s in ("Neutral", "Old"))
    assert old["stoop"] > plain["stoop"] + 5
    assert plain["upright"] == old["upright"] == "yes"
    assert 1 < plain["steps"] < 3
    assert plain["lift"] > 0.03
    assert plain["hands"] > 0.2


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


def test_a_mirrored_motion_is_that_of_the_mirrored_clip(motions):
    """Also with the reflections chosen by the mean pose of all motions and not by that of the clip."""
    clip = data.prepare(tk.datasets.load("procedural", styles=["Zombie"], gaits=["FW"], seconds=2.3)[0])
    statistics = motions.statistics()
    x, other = (data.describe(one)[0] for one in (clip, clip.mirrored()))
    flipped = mirror.mirrored(x, clip.skeleton, statistics.mean)
    assert (x - other)[:3].abs().max() > 0.05
    assert torch.allclose(flipped[:3], other[:3], atol=1e-4)
    assert torch.allclose(evaluation.angles(flipped[None], other[None]), torch.zeros(1), atol=0.1)


def test_the_mean_with_the_mirror_image_treats_both_sides_alike(motions):
    stylizer = tk.stylization.fit(motions, TINY).stylizer
    torch.nn.init.normal_(stylizer.generator.lower.weight, std=0.1)
    both, skeleton, mean = mirror.Symmetric(stylizer), stylizer.skeleton, stylizer.statistics.mean
    x, code = motions.x[:3], both.code_from(torch.zeros(3, stylizer.sizes.latent), torch.tensor([1, 0, 1]))

    def gap(model):
        flipped = mirror.mirrored(model.translate(mirror.mirrored(x, skeleton, mean), code), skeleton, mean)
        return float((flipped - model.translate(x, code))[:, :3].abs().max())

    assert gap(stylizer) > 0.01
    assert gap(both) < 1e-5


def test_what_content_is_missing(motions, judges):
    rows, target = evaluation.pairs(motions)
    sources = motions.select(rows)
    recorded = lost_content.of_style_and_content(motions, sources, target)
    found = lost_content.line(judges, [recorded], sources, target, recorded)
    assert found["content"] == found["gait"] == found["both"] == found["movement_of_recorded"] == 1.0
    swapped = sources.x.roll(len(sources) // 4, 0)
    wrong = lost_content.line(judges, [swapped], sources, target, recorded)
    judged = judges.judge(swapped, sources.content, target)
    assert wrong["content"] == judged["content"] < 1
    assert wrong["both"] == judged["both"]
    assert wrong["movement_of_recorded"] > wrong["content"]


@pytest.mark.parametrize("name", ["the recipe", "the turn rate is an input", "turn rate, own window for id",
                                  "turn rate, own window for id, content features kept",
                                  "own window for id, ds of references"])
def test_a_lead_is_trained_and_measured_and_leaves_the_training_as_it_was(motions, judges, name, tmp_path):
    lead = leads.LEADS[name]
    few = motions.select(torch.tensor([0, 1]))
    task = sets.Task(motions, {"validation": motions}, {"validation": few}, {})
    settings = {**lead.settings, "iterations": 3, "warm_up": 1, "log_every": 1, "sizes": TINY.sizes}
    before = training.translations, training.terms_of
    path = tmp_path / "runs" / "lead.safetensors"
    numbers, models = leads.fit(lead, task, Config.quick(**settings), path)
    assert (training.translations, training.terms_of) == before
    assert numbers["iterations"] == 3
    assert numbers["gap"] != 0
    found = leads.measured(lead, models, few, motions, judges, 0)
    assert set(found) == set(lead.kinds)
    assert all(math.isfinite(found[kind][by]["fmd"]) for kind in lead.kinds for by in ("noise", "reference"))
    assert len({found[kind]["reference"]["fmd"] for kind in lead.kinds}) == len(lead.kinds)
    if path.exists():
        assert leads.measured(lead, leads.fit(lead, task, Config.quick(), path)[1], few, motions, judges, 0) == found


def test_a_run_of_other_styles_is_refused(motions, tmp_path):
    made = tk.stylization.fit(motions, TINY)
    made.save(tmp_path / "run.safetensors")
    task = sets.Task(motions, {}, {}, {})
    assert comparison.runs_of([tmp_path / "run.safetensors"], task)[0].stylizer.domains == motions.domains
    other = dataclasses.replace(task, train=dataclasses.replace(motions, domains=("a", *motions.domains[1:])))
    with pytest.raises(ValueError, match=r"run\.safetensors: was trained on .*; the data have a, "):
        comparison.runs_of([tmp_path / "run.safetensors"], other)


def test_the_posture_of_references_makes_results_differ_and_none_comes_from_noise(motions):
    model = networks.build(motions.graph, motions.domains, TINY.sizes, motions.statistics())[0].eval()
    own = {share: evaluation.results(posture.Postured(model, share), motions, motions, "reference", 0) for share in (0, 1)}
    plain = evaluation.results(model, motions, motions, "reference", 0)
    assert all(torch.allclose(a, b, atol=1e-6) for a, b in zip(own[0], plain, strict=True))
    assert evaluation.angles(*own[1]).mean() > evaluation.angles(*plain).mean() + 1
    noise = [evaluation.results(made, motions, motions, "noise", 0) for made in (model, posture.Postured(model, 1.0))]
    assert all(torch.allclose(a, b, atol=1e-6) for a, b in zip(*noise, strict=True))


def test_the_turn_rate_takes_the_place_of_a_number_that_is_always_zero(motions):
    assert motions.x[:, 0, :, 0].abs().max() < 1e-4
    seen = leads.turning(motions)
    assert torch.equal(seen.x[:, 0, :, 0], leads.TURN * motions.root_velocity[..., 2])
    assert torch.equal(seen.x[:, 1:], motions.x[:, 1:])
    assert torch.equal(seen.x[..., 1:], motions.x[..., 1:])
