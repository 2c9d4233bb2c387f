import json
import math
import re

import pytest
import torch
from safetensors import safe_open

import toolkit as tk
from toolkit.__main__ import main
from toolkit.styles import StyleBank, plausibility
from toolkit.styles.transitions import EASINGS

BANK = StyleBank(("Neutral", "Zombie", "Old"), torch.eye(3))


def test_vectors_by_name():
    assert torch.equal(BANK["Zombie"], torch.tensor([0.0, 1.0, 0.0]))
    assert (len(BANK), list(BANK), "Old" in BANK, "Young" in BANK) == (3, ["Neutral", "Zombie", "Old"], True, False)


def test_unknown_style_lists_close_names():
    with pytest.raises(ValueError, match="unknown style 'zombi'; close to it: Zombie"):
        BANK["zombi"]
    with pytest.raises(ValueError, match="unknown style 'xyz'; known: Neutral, Zombie, Old"):
        BANK.blend({"xyz": 1.0})


def test_blend_is_barycentric():
    torch.testing.assert_close(BANK.blend({"Zombie": 0.5, "Old": 0.3, "Neutral": 0.2}), torch.tensor([0.2, 0.5, 0.3]))
    BANK.blend({"Zombie": 0.50005, "Old": 0.5})


@pytest.mark.parametrize("weights", [{}, {"Zombie": 0.5}, {"Zombie": 0.6, "Old": 0.6}, {"Zombie": 1.0002}])
def test_weights_must_sum_to_one(weights):
    with pytest.raises(ValueError, match="must sum to 1, got"):
        BANK.blend(weights)


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_weights_must_be_finite(bad):
    with pytest.raises(ValueError, match="weight of style 'Zombie' must be finite"):
        BANK.blend({"Zombie": bad, "Old": 1.0})


def test_add_makes_a_new_bank():
    more = BANK.add("Star", torch.ones(3)).add("Old", torch.zeros(3))
    assert more.names == ("Neutral", "Zombie", "Old", "Star")
    assert torch.equal(more["Star"], torch.ones(3))
    assert torch.equal(more["Old"], torch.zeros(3))
    assert len(BANK) == 3
    with pytest.raises(ValueError, match=r"style 'Bad' needs a vector \[3\], got \[4\]"):
        BANK.add("Bad", torch.ones(4))


def test_construction_is_checked():
    with pytest.raises(ValueError, match="2 styles need vectors"):
        StyleBank(("a", "b"), torch.zeros(3, 4))
    with pytest.raises(ValueError, match="repeat: a"):
        StyleBank(("a", "a"), torch.zeros(2, 4))
    with pytest.raises(ValueError, match="vector of b is not finite"):
        StyleBank(("a", "b"), torch.tensor([[0.0], [float("nan")]]))


def test_round_trip(tmp_path):
    BANK.save(tmp_path / "bank.safetensors")
    again = StyleBank.load(tmp_path / "bank.safetensors")
    assert again.names == BANK.names
    assert torch.equal(again.vectors, BANK.vectors)
    with pytest.raises(ValueError, match=r"nothing.safetensors: cannot be read"):
        StyleBank.load(tmp_path / "nothing.safetensors")


def test_extrapolation_warns_and_says_of_what():
    with pytest.warns(UserWarning, match=r"extrapolates \(Zombie 1.5, Old -0.5\)"):
        vector = BANK.blend({"Zombie": 1.5, "Old": -0.5})
    torch.testing.assert_close(vector, torch.tensor([0.0, 1.5, -0.5]))


def test_layers_may_have_blends_of_their_own():
    bank = StyleBank(("a", "b"), torch.tensor([[1.0, 2.0, 3.0, 4.0], [10.0, 20.0, 30.0, 40.0]]))
    torch.testing.assert_close(bank.blend({"a": 1}, {"b": 1}), torch.tensor([1.0, 2.0, 30.0, 40.0]))
    torch.testing.assert_close(bank.blend({"a": 0.5, "b": 0.5}, {"a": 1}), torch.tensor([5.5, 11.0, 3.0, 4.0]))
    torch.testing.assert_close(bank.blend({"a": 1}, {"a": 1}), bank["a"])
    with pytest.raises(ValueError, match=r"\[4\] cannot be cut into 3"):
        bank.blend({"a": 1}, {"a": 1}, {"a": 1})


def test_banks_merge():
    more = BANK.merge(StyleBank(("Old", "Star"), torch.stack((BANK["Old"], torch.ones(3)))))
    assert more.names == ("Neutral", "Zombie", "Old", "Star")
    assert torch.equal(more.select(BANK.names).vectors, BANK.vectors)
    with pytest.raises(ValueError, match="both banks have Old, with different vectors"):
        BANK.merge(StyleBank(("Old",), torch.ones(1, 3)))
    with pytest.raises(ValueError, match=r"vectors \[3\] cannot be merged with vectors \[4\]"):
        BANK.merge(StyleBank(("Star",), torch.ones(1, 4)))


def test_nearest_counts_distances():
    bank = StyleBank(("a", "b", "c", "d"), torch.tensor([[0.0, 0.0], [3.0, 4.0], [1.0, 0.0], [0.0, 2.0]]))
    assert bank.nearest("a", 2) == [("c", 1.0), ("d", 2.0)]
    assert bank.nearest("a", 9)[-1] == ("b", 5.0)
    assert bank.nearest(torch.tensor([0.0, 0.0]), 1) == [("a", 0.0)]


# transitions


def test_a_transition_reaches_its_stops_and_holds_outside():
    at = tk.styles.transition(BANK, {1: "Neutral", 2: {"Zombie": 0.5, "Old": 0.5}, 3: "Old"})
    for frame, vector in ((0, [1, 0, 0]), (60, [1, 0, 0]), (120, [0, 0.5, 0.5]), (180, [0, 0, 1]), (999, [0, 0, 1])):
        torch.testing.assert_close(at(frame), torch.tensor(vector, dtype=torch.float32))
    way = torch.stack([at(frame) for frame in range(60, 121)])
    torch.testing.assert_close(way.sum(1), torch.ones(61))
    assert (way[:, 0].diff() <= 0).all()
    assert way[:, 0].diff().abs().max() < 0.03  # 1.5 / 60


@pytest.mark.parametrize("easing", EASINGS)
def test_easings_go_from_0_to_1_and_never_back(easing):
    ease = EASINGS[easing]
    values = torch.tensor([ease(t / 50) for t in range(51)])
    assert (float(values[0]), float(values[-1])) == (0.0, 1.0)
    assert (values.diff() >= 0).all()


def test_an_easing_of_ones_own():
    at = tk.styles.transition(BANK, {0: "Neutral", 1: "Zombie"}, lambda t: t**4)
    assert float(at(30)[1]) == pytest.approx(1 / 16)


def test_transitions_are_checked():
    with pytest.raises(ValueError, match="times of a transition must increase"):
        tk.styles.transition(BANK, {2: "Old", 1: "Zombie"})
    with pytest.raises(ValueError, match="unknown easing 'bounce'; known: linear"):
        tk.styles.transition(BANK, {0: "Old"}, "bounce")
    with pytest.raises(ValueError, match="close to it: Zombie"):
        tk.styles.transition(BANK, {0: "zombi"})


def test_a_character_changes_its_style_while_it_walks():
    model, bank = tk.pretrained()
    style = tk.styles.transition(bank, {1.5: "Neutral", 2.5: "ArmsAboveHead"})
    clip = tk.runtime.rollout(model, tk.runtime.straight(1.0, 4.0), style)
    hands = clip.global_positions[:, clip.skeleton.index("left_hand"), 1]
    assert hands[60:85].mean() < 1.0 < 1.5 < hands[-30:].mean()


# new styles


@pytest.fixture(scope="module")
def crouch():
    return tk.datasets.load("procedural", styles=["Crouch"], gaits=["FW"], seconds=6.0)[0]


def frozen(model) -> list[torch.Tensor]:
    return [t.clone() for t in (*model.gating.state_dict().values(), *model.experts.state_dict().values())]


@pytest.mark.parametrize("method", ["generator", "vector", "forward"])
def test_a_new_style_changes_nothing_else(small_run, crouch, method):
    model, bank = small_run.model, small_run.bank
    everything = {k: v.clone() for k, v in model.state_dict().items()}
    draw = torch.Generator().manual_seed(0)
    x, p = (torch.randn(4, n, generator=draw) for n in (model.layout.n_inputs, model.layout.n_phases))
    before = [model.predict(x, p, bank[s]) for s in bank]
    made = tk.styles.fine_tune(model, crouch, "Mine", bank, method=method, steps=20)
    assert (made.names, made.bank.names, made.method) == (("Mine",), ("Neutral", "Zombie", "Mine"), method)
    assert torch.equal(made.bank.select(bank.names).vectors, bank.vectors)
    assert all(torch.equal(a, b) for a, b in zip(frozen(made.model), frozen(model), strict=True))
    assert made.model.experts.layers[0].weight.data_ptr() == model.experts.layers[0].weight.data_ptr()
    assert all(torch.equal(v, everything[k]) for k, v in model.state_dict().items())
    assert all(torch.equal(made.model.predict(x, p, made.bank[s]), z) for s, z in zip(bank, before, strict=True))
    tuned = not torch.equal(made.model.modulation.generator.out.weight, everything["modulation.generator.out.weight"])
    assert tuned == (method == "generator" and made.best > 0)


@pytest.mark.parametrize("method", ["generator", "vector"])
def test_learning_lowers_the_loss_and_is_repeatable(small_run, method):
    data = tk.features.build(tk.datasets.load("procedural", styles=["WideLegs"], gaits=["FW"], seconds=6.0))
    made, again = (tk.styles.fine_tune(small_run.model, data, None, small_run.bank, method=method, steps=60) for _ in "ab")
    assert torch.equal(again.bank["WideLegs"], made.bank["WideLegs"])
    assert len(made.losses) == 60
    assert sum(made.losses[-10:]) < 0.97 * sum(made.losses[:10])


def test_the_best_step_is_kept_and_its_held_out_error_reported(small_run, monkeypatch):
    from toolkit.styles import fine_tuning

    data = tk.features.build(tk.datasets.load("procedural", styles=["WideLegs"], gaits=["FW"], seconds=6.0))
    model, bank = small_run.model, small_run.bank
    made = tk.styles.fine_tune(model, data, None, bank, method="vector", steps=120)
    found = made.held_out["WideLegs"]
    assert found["after"] < found["before"]
    assert 0 < made.best <= 120
    assert {"mean", "repeat"} <= set(found)
    monkeypatch.setitem(fine_tuning.RATES, "vector", 1e4)  # every step makes it worse
    worse = tk.styles.fine_tune(model, data, None, bank, method="vector", steps=80)
    assert worse.best == 0
    assert worse.held_out["WideLegs"]["after"] == worse.held_out["WideLegs"]["before"] == found["before"]
    assert any(torch.equal(worse.bank["WideLegs"], bank[style]) for style in bank)


def test_the_frames_of_the_reported_errors_do_not_choose_the_step(small_run, monkeypatch):
    from toolkit.styles import fine_tuning

    looked, evaluate = [], fine_tuning.evaluate
    monkeypatch.setattr(fine_tuning, "evaluate", lambda model, bank, data, **options: looked.append(data) or evaluate(
        model, bank, data, **options))
    data = tk.features.build(tk.datasets.load("procedural", styles=["WideLegs"], gaits=["FW"], seconds=6.0))
    tk.styles.fine_tune(small_run.model, data, None, small_run.bank, method="generator", steps=80)
    before, start, middle, last, after = (set(part.frames["WideLegs"].tolist()) for part in looked)
    assert before == after != set()
    assert start == middle == last != set()
    assert not before & start


def test_a_clip_too_short_to_hold_frames_out_keeps_the_last_step(small_run, crouch):
    made = tk.styles.fine_tune(small_run.model, crouch.cut(0, 113), "Mine", small_run.bank, method="vector", steps=5)
    assert made.best == 5
    assert math.isnan(made.held_out["Mine"]["after"])


def test_the_embedded_model_learns_a_style_from_one_clip():
    model, bank = tk.pretrained()
    arms = tk.datasets.procedural.Arm(out=20, forward=45, elbow=95, swing=4, elbow_swing=4)
    sneak = tk.datasets.procedural.Style(height=0.82, lean=28, step=0.5, cadence=0.75, arms=arms)
    clip = tk.datasets.procedural.generate(sneak, "FW", 6.0)
    made = tk.styles.fine_tune(model, clip, "Sneak", bank, steps=100)
    assert made.method == "vector"  # it comes without its generator
    data, off = tk.features.build([clip.replace(style="Sneak")]), {}
    for name in ("Sneak", *bank):
        off[name] = tk.training.evaluate(model, StyleBank(("Sneak",), made.bank[name][None]), data, 200)["Sneak"]["mse"]
    assert off.pop("Sneak") < 0.6 * min(off.values())
    walk = tk.runtime.rollout(model, tk.runtime.straight(0.75, 5.0), made.bank["Sneak"]).cut(180)
    assert tk.metrics.hips_height(walk)[1] < 0.9
    assert tk.metrics.upright(walk)


def test_several_styles_are_learnt_together_and_without_a_bank(small_run, crouch):
    clips = [crouch, crouch.mirrored().replace(style="Mirrored")]
    made = tk.styles.fine_tune(small_run.model, clips, method="vector", steps=3)
    assert made.names == made.bank.names == ("Crouch", "Mirrored")
    assert len(made.losses) == 6


def test_what_cannot_be_learnt_is_refused_in_one_line(small_run, crouch):
    model, bank = small_run.model, small_run.bank
    slim = tk.pretrained().model
    with pytest.raises(ValueError, match="the bank has Zombie already"):
        tk.styles.fine_tune(model, crouch, "Zombie", bank)
    with pytest.raises(ValueError, match="unknown method 'magic'; known: generator, vector, forward"):
        tk.styles.fine_tune(model, crouch, "Mine", bank, method="magic")
    with pytest.raises(ValueError, match="needs a FiLM generator, and this model has none; use method 'vector'"):
        tk.styles.fine_tune(slim, crouch, "Mine", method="generator")
    with pytest.raises(ValueError, match="not the model's skeleton; it differs in joints"):
        tk.styles.fine_tune(model, crouch.without_ends(), "Mine", bank)
    with pytest.raises(ValueError, match="no clip of 112 frames"):
        tk.styles.fine_tune(model, crouch.cut(0, 111), "Mine", bank)


def test_a_foreign_rigs_walk_by_three_commands(tmp_path, small_run, crouch, capsys):
    """A-pose, shorter legs, twist bones, inches: inspect, style add, rollout."""
    from posed_rigs import rig, with_twists

    walk = tk.motion.retargeting.retarget(crouch, rig("A-pose", legs=0.9, joints=with_twists))
    tk.bvh.save(walk, tmp_path / "walk.bvh", unit=0.0254)
    small_run.save(tmp_path / "run.safetensors")
    run, new, file = (tmp_path / name for name in ("run.safetensors", "new.safetensors", "walk.bvh"))
    for command in (
        f"inspect {file}", f"style add --model {run} --clips {file} --name Mine --out {new} --steps 5",
        f"rollout --model {new} --style Mine --seconds 1 --out {tmp_path}/made.bvh",
    ):
        with pytest.raises(SystemExit) as done:
            main(command.split())
        assert done.value.code == 0
    said = capsys.readouterr().out
    assert "inch" in said
    assert "walk.bvh: retargeted; limbs " in said
    assert len(tk.bvh.load(tmp_path / "made.bvh", unit=0.01, up="y")) == 60


def test_style_add_writes_the_same_file_with_one_vector_more(tmp_path, small_run, crouch, capsys):
    run, out, clips = tmp_path / "run.safetensors", tmp_path / "new.safetensors", tmp_path / "clips"
    small_run.save(run)
    tk.bvh.save(crouch, clips / "a.bvh")
    with pytest.raises(SystemExit) as done:
        main([*f"style add --model {run} --clips {clips} --name Mine --out {out} --steps 5".split()])
    assert done.value.code == 0
    said = capsys.readouterr().out
    assert "near it: " in said
    assert "Held-out frames: mean squared error " in said
    assert " by repeating the frame" in said
    with safe_open(run, "pt") as old, safe_open(out, "pt") as new:
        assert set(old.keys()) == set(new.keys())
        kept = [k for k in old.keys() if not k.startswith("bank.")]  # noqa: SIM118 (not a dict)
        assert all(torch.equal(old.get_tensor(k), new.get_tensor(k)) for k in kept)
        assert torch.equal(new.get_tensor("bank.vectors")[:2], old.get_tensor("bank.vectors"))
        assert json.loads(new.metadata()["added"])[0]["clips"] == ["a.bvh"]
    assert tk.training.load(out).bank.names == ("Neutral", "Zombie", "Mine")
    with pytest.raises(SystemExit):
        main(["style", "list", "--model", str(out)])
    assert re.search(r"Mine +near it: \w+ \(\d", capsys.readouterr().out)


def test_style_add_refuses_in_one_line_and_writes_nothing(tmp_path, small_run, crouch, capsys):
    run, clips = tmp_path / "run.safetensors", tmp_path / "clips"
    small_run.save(run)
    tk.bvh.save(crouch, clips / "a.bvh")
    (tmp_path / "empty").mkdir()

    def refused(**changes) -> str:
        words = {"model": run, "clips": clips, "name": "Mine", "out": tmp_path / "out.safetensors"} | changes
        assert main(["style", "add", *(str(w) for k, v in words.items() for w in (f"--{k}", v))]) == 2
        said = capsys.readouterr().err.strip().splitlines()
        return said[-1]

    assert "no motion file" in refused(clips=tmp_path / "empty")
    assert "the bank has Zombie already" in refused(name="Zombie")
    assert "must not be empty nor hold" in refused(name="a=b")
    assert "is a folder" in refused(out=tmp_path / "empty")
    assert "cannot be written" in refused(out=clips / "a.bvh" / "out.safetensors")
    assert "cannot be read" in refused(model=tmp_path / "none.safetensors")
    assert {p.name for p in tmp_path.iterdir()} == {"run.safetensors", "clips", "empty"}


# the space


def clusters(spread: float) -> tuple[torch.Tensor, list[str]]:
    noise = torch.randn(24, 4, generator=torch.Generator().manual_seed(3))
    centres = torch.tensor([[0.0, 0, 0, 0], [4.0, 0, 0, 0], [0.0, 4, 0, 0]])
    return centres.repeat_interleave(8, 0) + spread * noise, [style for style in "abc" for _ in range(8)]


def test_separation_agrees_with_sklearn_and_a_slow_loop():
    from sklearn.metrics import silhouette_samples

    vectors, labels = clusters(1.2)
    found = tk.styles.separation(vectors, labels)
    each = silhouette_samples(vectors.double().numpy(), labels)
    for k, style in enumerate("abc"):
        own = vectors[8 * k : 8 * k + 8].double()
        assert found.silhouette[style] == pytest.approx(each[8 * k : 8 * k + 8].mean(), abs=1e-6)
        others = [vectors[8 * j : 8 * j + 8].double().mean(0) for j in range(3) if j != k]
        spread = math.sqrt(sum(float((v - own.mean(0)).square().sum()) for v in own) / 8)
        nearest = min(float((own.mean(0) - o).norm()) for o in others)
        assert found.ratio[style] == pytest.approx(nearest / spread, rel=1e-6)
        hits = 0
        for i in range(8):
            rest = torch.cat((own[:i], own[i + 1 :])).mean(0)
            hits += float((own[i] - rest).norm()) < min(float((own[i] - o).norm()) for o in others)
        assert found.found[style] == pytest.approx(hits / 8)


def test_tight_clusters_are_separate_and_a_single_clip_is_refused():
    found = tk.styles.separation(*clusters(0.05))
    assert min(found.silhouette.values()) > 0.95
    assert set(found.found.values()) == {1.0}
    with pytest.raises(ValueError, match="two styles or more, of two clips or more each"):
        tk.styles.separation(torch.zeros(3, 2), ["a", "a", "b"])


@pytest.mark.parametrize("method", ["pca", "tsne"])
def test_maps_keep_neighbours_and_repeat(method):
    vectors, labels = clusters(0.2)
    points = tk.styles.embed(vectors, method)
    assert points.shape == (24, 2)
    assert torch.equal(points, tk.styles.embed(vectors, method))
    nearest = torch.cdist(points, points).fill_diagonal_(torch.inf).argmin(1).tolist()
    assert all(labels[i] == labels[j] for i, j in enumerate(nearest))


def test_maps_are_checked(monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "umap", None)
    with pytest.raises(ValueError, match="needs the package umap-learn: pip install umap-learn"):
        tk.styles.embed(torch.randn(5, 3), "umap")
    with pytest.raises(ValueError, match="unknown embedding 'som'; known: tsne, pca, umap"):
        tk.styles.embed(torch.randn(5, 3), "som")
    with pytest.raises(ValueError, match="three or more"):
        tk.styles.embed(torch.randn(2, 3))


def test_vectors_of_single_clips_average_to_the_style(small_run):
    clips = tk.datasets.load("procedural", styles=["Neutral", "Zombie"], gaits=["FW"], seconds=12.0)
    data = tk.features.build(clips)
    vectors, styles = tk.styles.clip_vectors(small_run.model, data)
    assert styles == ["Neutral"] * 5 + ["Zombie"] * 5
    whole = small_run.model.style_vector(data.clips["Neutral"])
    torch.testing.assert_close(vectors[:5].mean(0), whole, atol=1e-5, rtol=1e-4)
    assert len(tk.styles.clip_vectors(small_run.model, data, 2)[1]) == 4


def test_published_styles_that_mirror_each_other_are_neighbours(shared):
    bank = tk.published.load(shared / "lpn_film_100style").bank
    for a, b in (("LimpLeft", "LimpRight"), ("DragLeftLeg", "DragRightLeg"), ("SpinClock", "SpinAntiClock")):
        assert b in [name for name, _ in bank.nearest(a, 2)] or a in [name for name, _ in bank.nearest(b, 2)]


# where blends leave what was seen


def test_segments_are_as_far_apart_as_their_nearest_points():
    draw = torch.Generator().manual_seed(1)
    a, b, c, d = torch.randn(4, 50, 3, generator=draw)
    t = torch.linspace(0, 1, 201)[:, None, None]
    slow = torch.cdist((a + t * (b - a)).transpose(0, 1), (c + t * (d - c)).transpose(0, 1)).amin((1, 2))
    found = plausibility.segment_distance(a, b, c, d)
    assert (found - slow).abs().max() < 0.02
    assert (found <= slow + 1e-5).all()
    assert float(plausibility.segment_distance(*(torch.zeros(1, 3),) * 4)) == 0.0


def test_a_clean_walk_has_no_strain_and_a_broken_one_has(walk_clip):
    layout = tk.features.Layout(walk_clip.skeleton)
    positions = walk_clip.global_positions[:, list(walk_clip.skeleton.feature_joints)]
    assert plausibility.bone_stretch(layout, positions) < 1e-4
    assert plausibility.penetration(layout, positions) < 0.005
    hand = layout.names.index(walk_clip.skeleton.roles["left_hand"])
    tip, longer = hand + 1, positions.clone()
    longer[:, tip] += 0.2 * (positions[:, tip] - positions[:, hand])
    assert plausibility.bone_stretch(layout, longer) == pytest.approx(0.2, abs=0.01)
    inside = positions.clone()
    inside[:, hand] = positions[:, layout.names.index(walk_clip.skeleton.roles["hips"])]
    assert plausibility.penetration(layout, inside) > 0.1


def test_a_blend_of_far_apart_poses_is_warned_of_and_a_style_is_not():
    model, bank = tk.pretrained()
    alone = tk.styles.check(model, bank, {"Neutral": 1.0}, seconds=3.0)
    assert alone["bone_stretch"] == pytest.approx(alone["usual_bone_stretch"], rel=1e-3)
    with pytest.warns(UserWarning, match="unlike the motion that the model was trained on: bones are stretched by"):
        found = tk.styles.check(model, bank, {"Neutral": 0.5, "ArmsAboveHead": 0.5}, seconds=3.0)
    assert found["bone_stretch"] > found["usual_bone_stretch"] + 0.03
    with pytest.raises(ValueError, match="after 2 s of walking"):
        tk.styles.strain(model, bank.vectors[:1], seconds=1.0)
