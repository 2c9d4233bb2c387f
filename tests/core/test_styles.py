"""Banks of style vectors, blends and transitions, new styles, the space and what leaves it."""

import dataclasses
import json
import math
import re

import numpy as np
import pytest
import torch
from refusal import refusal
from safetensors import safe_open
from torch.testing import assert_close

import toolkit as tk
from toolkit.cli.style import fitted
from toolkit.motion import contacts, rotations as R
from toolkit.motion.clip import root_frames
from toolkit.styles import StyleBank, closed_loop, comparison, fine_tuning, learning
from toolkit.styles.transitions import EASINGS

BANK = StyleBank(("Neutral", "Zombie", "Old"), torch.eye(3))


def test_vectors_by_name_and_blends():
    assert torch.equal(BANK["Zombie"], torch.tensor([0.0, 1.0, 0.0]))
    blend = BANK.blend({"Zombie": 0.5, "Old": 0.3, "Neutral": 0.2})
    assert_close(blend, torch.tensor([0.2, 0.5, 0.3]))
    BANK.blend({"Zombie": 0.50005, "Old": 0.5})
    with pytest.warns(UserWarning, match=r"extrapolates \(Zombie 1.5, Old -0.5\)"):
        vector = BANK.blend({"Zombie": 1.5, "Old": -0.5})
    assert_close(vector, torch.tensor([0.0, 1.5, -0.5]))


def test_bad_blends_and_banks_are_refused():
    for weights, said in (
        ({"Zombie": 1.0002}, "must sum to 1, got"),
        ({"Zombie": math.nan, "Old": 1.0}, "weight of style 'Zombie' must be finite"),
    ):
        with refusal(said):
            BANK.blend(weights)
    for names, vectors, said in (
        (("a", "b"), torch.zeros(3, 4), "2 styles need vectors"),
        (("a", "a"), torch.zeros(2, 4), "a style is named twice: a"),
        (("a", "b"), torch.tensor([[0.0], [math.nan]]), "vector of b is not finite"),
    ):
        with refusal(said):
            StyleBank(names, vectors)


def test_layers_may_have_blends_of_their_own():
    bank = StyleBank(("a", "b"), torch.tensor([[1.0, 2.0, 3.0, 4.0], [10.0, 20.0, 30.0, 40.0]]))
    assert_close(bank.blend({"a": 1}, {"b": 1}), torch.tensor([1.0, 2.0, 30.0, 40.0]))
    assert_close(bank.blend({"a": 0.5, "b": 0.5}, {"a": 1}), torch.tensor([5.5, 11.0, 3.0, 4.0]))
    with refusal(r"\[4\] cannot be cut into 3"):
        bank.blend({"a": 1}, {"a": 1}, {"a": 1})


def test_banks_merge():
    more = BANK.merge(StyleBank(("Old", "Star"), torch.stack((BANK["Old"], torch.ones(3)))))
    assert more.names == ("Neutral", "Zombie", "Old", "Star")
    assert torch.equal(more.select(BANK.names).vectors, BANK.vectors)
    with refusal("both banks have Old, with different vectors"):
        BANK.merge(StyleBank(("Old",), torch.ones(1, 3)))
    with refusal(r"vectors \[3\] cannot be merged with vectors \[4\]"):
        BANK.merge(StyleBank(("Star",), torch.ones(1, 4)))


def test_styles_that_shake_stay_marked(tmp_path):
    bank = StyleBank(("a", "b"), torch.eye(2), broken=torch.tensor([False, True]))
    bank.select(["b", "a"]).save(tmp_path / "bank.safetensors")
    again = StyleBank(("c",), torch.ones(1, 2)).merge(StyleBank.load(tmp_path / "bank.safetensors"))
    assert again.labels() == {"c": "c", "b": "b (broken)", "a": "a"}
    assert torch.equal(again["b"], bank["b"])
    with refusal(r"2 styles need marks \[2\], got \[1\]"):
        StyleBank(("a", "b"), torch.eye(2), broken=torch.tensor([True]))


def test_nearest_counts_distances():
    places = torch.tensor([[0.0, 0.0], [3.0, 4.0], [1.0, 0.0], [0.0, 2.0]])
    bank = StyleBank(("a", "b", "c", "d"), places)
    assert bank.nearest("a", 2) == [("c", 1.0), ("d", 2.0)]
    assert bank.nearest("a", 9)[-1] == ("b", 5.0)
    assert bank.nearest(torch.tensor([0.0, 0.0]), 1) == [("a", 0.0)]


def test_a_transition_reaches_its_stops_and_holds_outside():
    at = tk.styles.transition(BANK, {1: "Neutral", 2: {"Zombie": 0.5, "Old": 0.5}, 3: "Old"})
    for frame, vector in ((0, [1.0, 0, 0]), (120, [0, 0.5, 0.5]), (999, [0, 0, 1.0])):
        assert_close(at(frame), torch.tensor(vector))
    way = torch.stack([at(frame) for frame in range(60, 121)])
    assert_close(way.sum(1), torch.ones(61))
    assert (way[:, 0].diff() <= 0).all()
    assert way[:, 0].diff().abs().max() < 0.03  # 1.5 / 60
    slowly = tk.styles.transition(BANK, {0: "Neutral", 1: "Zombie"}, "in")
    assert float(slowly(30)[1]) == pytest.approx(1 / 4)
    for stops, easing, said in (
        ({2: "Old", 1: "Zombie"}, "in", "times of a transition must increase"),
        ({0: "Old"}, "bounce", "unknown easing 'bounce'; known: linear"),
    ):
        with refusal(said):
            tk.styles.transition(BANK, stops, easing)


def test_easings_go_from_0_to_1_and_never_back():
    for ease in EASINGS.values():
        values = torch.tensor([ease(t / 50) for t in range(51)])
        assert (float(values[0]), float(values[-1])) == (0.0, 1.0)
        assert (values.diff() >= 0).all()


@pytest.fixture(autouse=True)
def short_walks(monkeypatch):
    """Walks that are compared, those of the pose mix-up and of the closed loop are short."""
    for name, value in (("WARM_UP", 1.0), ("SECONDS", 2.0), ("LONGEST", 2.0)):
        monkeypatch.setattr(comparison, name, value)
    for name, value in (("STARTS", 2), ("FRAMES", 40)):
        monkeypatch.setattr(closed_loop, name, value)
    monkeypatch.setattr(fine_tuning, "WALK", (1.0, 0.5))


@pytest.fixture(scope="module")
def crouch():
    return tk.datasets.procedural.generate("Crouch", seconds=6.0)


@pytest.fixture(scope="module")
def wide():
    """Features of a style that no model here knows."""
    return tk.features.build(tk.datasets.procedural.generate("WideLegs", seconds=6.0))


def frozen(model) -> list[torch.Tensor]:
    return [*model.gating.state_dict().values(), *model.experts.state_dict().values()]


@pytest.mark.parametrize("method", ["generator", "vector", "forward"])
def test_a_new_style_changes_nothing_else(small_run, crouch, method):
    model, bank = small_run.model, small_run.bank
    everything = {k: v.clone() for k, v in model.state_dict().items()}
    draw = torch.Generator().manual_seed(0)
    x, p = (torch.randn(4, n, generator=draw) for n in (model.layout.n_inputs, 8))
    before = [model.predict(x, p, bank[s]) for s in bank]
    made = tk.styles.fine_tune(model, crouch, "Mine", bank, method=method, steps=10)
    assert (made.names, made.method) == (("Mine",), method)
    assert made.bank.names == ("Neutral", "Zombie", "Mine")
    assert torch.equal(made.bank.select(bank.names).vectors, bank.vectors)
    assert all(map(torch.equal, frozen(made.model), frozen(model)))
    weights = [m.experts.layers[0].weight.data_ptr() for m in (made.model, model)]
    assert weights[0] == weights[1]  # no copy
    assert all(torch.equal(v, everything[k]) for k, v in model.state_dict().items())
    after = [made.model.predict(x, p, made.bank[s]) for s in bank]
    assert all(map(torch.equal, after, before))
    out = made.model.modulation.generator.out.weight
    tuned = not torch.equal(out, everything["modulation.generator.out.weight"])
    assert tuned == (method == "generator" and not torch.equal(made.tried[0, 0], made.bank["Mine"]))


def test_the_best_step_is_kept_and_its_held_out_error_reported(small_run, wide, monkeypatch):
    model, bank = small_run.model, small_run.bank
    made, again = (tk.styles.fine_tune(model, wide, None, bank, method="vector", steps=80)
                   for _ in range(2))
    assert torch.equal(again.bank["WideLegs"], made.bank["WideLegs"])
    assert len(made.losses) == 80
    assert sum(made.losses[-10:]) < 0.98 * sum(made.losses[:10])
    found = made.held_out["WideLegs"]
    assert found["after"] < found["before"]
    assert not torch.equal(made.tried[0, 0], made.bank["WideLegs"])
    monkeypatch.setitem(fine_tuning.RATES, "vector", 1e4)  # every step makes it worse
    worse = tk.styles.fine_tune(model, wide, None, bank, method="vector", steps=40)
    assert torch.equal(worse.tried[0, 0], worse.bank["WideLegs"])
    kept = worse.held_out["WideLegs"]
    assert kept["after"] == kept["before"] == found["before"]
    assert any(torch.equal(worse.bank["WideLegs"], bank[style]) for style in bank)


def test_the_frames_of_the_reported_errors_do_not_choose_the_step(small_run, wide, monkeypatch):
    looked, evaluate = [], fine_tuning.evaluate

    def watch(model, bank, data, **options):
        looked.append(set(data.frames["WideLegs"].tolist()))
        return evaluate(model, bank, data, **options)

    monkeypatch.setattr(fine_tuning, "evaluate", watch)
    monkeypatch.setattr(fine_tuning, "EVERY", 3)
    tk.styles.fine_tune(small_run.model, wide, None, small_run.bank, method="generator", steps=6)
    before, start, middle, last, after = looked
    assert before == after != set()
    assert start == middle == last != set()
    assert not before & start


def test_short_clips_several_styles_and_no_bank(small_run, crouch):
    made = tk.styles.fine_tune(
        small_run.model, crouch.cut(0, 113), "Mine", small_run.bank, method="vector", steps=5
    )
    # too short to hold frames out: the last step
    assert torch.equal(made.tried[-1, 0], made.bank["Mine"])
    assert math.isnan(made.held_out["Mine"]["after"])
    clips = [crouch, crouch.mirrored().replace(style="Mirrored")]
    made = tk.styles.fine_tune(small_run.model, clips, method="vector", steps=3)
    assert made.names == made.bank.names == ("Crouch", "Mirrored")
    assert len(made.losses) == 6


def test_the_choice_of_a_vector_leaves_the_others_and_all_marks(crouch):
    """Of a model without its generator; what it learns from one clip is in notebook 06."""
    model, bank = tk.pretrained()
    made = tk.styles.fine_tune(model, crouch, "Mine", bank, steps=5)
    assert made.method == "vector"
    marked = dataclasses.replace(made.bank, broken=torch.ones(len(made.bank)))
    chosen, _ = tk.styles.choose(dataclasses.replace(made, bank=marked), crouch, rounds=1)
    assert chosen.broken.all()
    assert torch.equal(chosen.vectors[:-1], bank.vectors)


def test_what_cannot_be_learnt_is_refused_in_one_line(small_run, crouch):
    slim = tk.pretrained().model
    for model, clip, name, method, said in (
        (small_run.model, crouch, "Zombie", "vector", "the bank has Zombie already"),
        (small_run.model, crouch, "Mine", "magic", "unknown method 'magic'; known: generator, vec"),
        (slim, crouch, "Mine", "generator", "needs a FiLM generator, and this model has none"),
        (small_run.model, crouch.without_ends(), "Mine", None, "its joints differ, compared"),
    ):
        with refusal(said):
            tk.styles.fine_tune(model, clip, name, small_run.bank, method=method)
    with refusal("prior must be a number from 0 on"):
        tk.styles.fine_tune(small_run.model, crouch, "Mine", prior=-1)
    with refusal("steps must be"):
        tk.styles.fine_tune(small_run.model, crouch, steps=0)


def test_style_add_writes_the_same_file_with_one_vector_more(tmp_path, small_run, crouch, command,
                                                             monkeypatch):
    def once(*clips, **options):  # the second command learns the same
        learnt.extend([] if learnt else [learning.learn(*clips, **options)])
        return learnt[0]

    learnt: list = []
    monkeypatch.setattr("toolkit.cli.style.learn", once)
    for name in ("WARM_UP", "SECONDS", "LONGEST"):
        monkeypatch.setattr(comparison, name, 0.5)
    monkeypatch.setattr(learning, "ENOUGH", math.inf)  # no other vector is looked for
    run, out, clips = tmp_path / "run.safetensors", tmp_path / "new.safetensors", tmp_path / "clips"
    small_run.save(run)
    tk.bvh.save(crouch, clips / "a.bvh")
    words = f"style add --model {run} --clips {clips} --name Mine --out {out} --steps 2"
    said = command(words, status=2).err  # after so few steps, nobody walks
    assert "does not walk as the clip does" in said
    assert not out.exists()
    command(words, "--anyway")
    with safe_open(run, "pt") as old, safe_open(out, "pt") as new:
        assert set(old.keys()) == set(new.keys())
        kept = [k for k in old.keys() if not k.startswith("bank.")]  # noqa: SIM118 (not a dict)
        assert all(torch.equal(old.get_tensor(k), new.get_tensor(k)) for k in kept)
        assert torch.equal(new.get_tensor("bank.vectors")[:2], old.get_tensor("bank.vectors"))
        (added,) = json.loads(new.metadata()["added"])
        assert added["clips"] == ["a.bvh"]
        # no time or date: the same command gives the same bytes
        assert added.keys() == {"style", "clips", "method", "mirror", "base", "steps", "seed",
                                "verdict"}
    assert tk.training.load(out).bank.names == ("Neutral", "Zombie", "Mine")
    assert re.search(r"Mine +near it: \w+ \(\d", command("style list --model", out).out)


@pytest.fixture(scope="module")
def zombie():
    return tk.datasets.procedural.generate("Zombie", seconds=6.0)


def _taken(clip, frames):
    return clip.replace(rotations=clip.rotations[frames],
                        root_positions=clip.root_positions[frames])


def test_a_style_walks_as_its_clip_and_another_one_does_not(fast, monkeypatch):
    monkeypatch.undo()  # of the short walks
    model, bank = fast
    clip = tk.datasets.procedural.generate("Old", seconds=6.0)
    own = tk.styles.compare(clip, model, "Old", bank)
    assert own.verdict == "good"
    assert not own.reasons
    assert own.excess <= 1
    assert list(own.rows)[:3] == ["clip", "style", "Neutral"]
    other = tk.styles.compare(clip, model, "Zombie", bank)
    assert other.verdict != "good"
    assert other.rows["style"]["posture"] > 2 * own.rows["style"]["posture"]
    # its posture is nearer to the clip's than that of the nearest floor, and near enough to see it
    for floor, limit in ((8.0, comparison.POSTURE * 8), (20.0, comparison.FAR)):
        near = {"clip": 0.0, "style": 4.0, "a": floor, "b": 30.0}
        near = {name: {"posture": apart} for name, apart in near.items()}
        assert comparison.difference(near, "posture") == pytest.approx(4 / limit)
    alone = {"clip": {"posture": 0.0}, "style": {"posture": 9.0}}  # a bank of this style only
    assert comparison.against(alone, "posture") == "at most 7"
    # the walk from the middle counts if it is the worse one: here it has to stand
    ordered = comparison.commands
    monkeypatch.setattr(comparison, "commands", lambda clip, begin: [
        tk.runtime.Command((0.0, 0.0)) if begin else order for order in ordered(clip)])
    assert tk.styles.compare(clip, model, "Old", bank).verdict == "failed"


def test_reach_is_that_of_the_hands_and_the_second_start_is_in_the_middle(zombie):
    turned = zombie.rotations.clone()
    turned[100:, zombie.skeleton.index("LeftShoulder")] = R.yaw(torch.tensor(1.0))
    walk = zombie.replace(rotations=turned)
    own, seen = (np.percentile(comparison.upper_body(clip)[:, :2].numpy(), [5, 95], axis=0)
                 for clip in (zombie, walk))
    reach = comparison.measures(walk, zombie)["reach"]
    assert reach == pytest.approx(100 * np.abs(seen - own).mean(), rel=1e-4)
    assert reach > comparison.REACH
    rows = {"clip": {"reach": 0.0}, "style": {"reach": reach}}
    assert comparison.difference(rows, "reach") == pytest.approx(reach / comparison.REACH)
    warm_up, speeds = round(comparison.WARM_UP * 60), []
    for begin in (0, 150):
        orders = comparison.commands(zombie, begin)[warm_up:]
        speeds.append([math.hypot(*order.velocity) for order in orders])
    assert speeds[1][:100] == pytest.approx(speeds[0][150:250])


def test_what_a_walk_shows_is_compared_by_sorted_values_and_by_its_tempo(zombie):
    layout = tk.pretrained().model.layout
    # toes that pass each other once a second, a right hand at 1 m, and straight legs of 0.9 m
    at = {name: layout.names.index(name) for name in layout.names}
    roles = {role: at[joint] for role, joint in layout.skeleton.roles.items() if joint in at}
    places = torch.zeros(300, 2, len(layout.names), 3)
    turn = 2 * math.pi * torch.arange(300.0) / 60
    places[..., roles["right_toe"], 2] = 0.2 * turn.sin()[:, None]
    places[..., roles["right_hand"], 1] = 1.0
    for side in ("left", "right"):
        places[..., roles[f"{side}_hip"], 1] = 0.9
    way = torch.tensor([0.0, 1.2]).expand(299, 2, 2)
    seen = closed_loop.distributions(layout, places, way, places[..., 0, 1:])
    assert torch.allclose(seen["legs"], torch.tensor(0.9))
    assert torch.equal(seen["root's speed"][0], torch.tensor([0.0, 1.2]))
    assert sorted(seen["hands"].unique().tolist()) == [0.0, 1.0]
    levels = np.linspace(0, 100, closed_loop.QUANTILES)
    for what, values in (("feet", places), ("feet's speeds", places.diff(dim=0) * 60)):
        ahead = values[..., roles["right_toe"], 2].numpy()
        assert np.allclose(seen[what].numpy().max(1), np.percentile(ahead, levels).clip(0),
                           atol=1e-5)
    assert torch.allclose(closed_loop.tempo(layout, places),
                          torch.tensor([math.cos(math.pi * lag / 30) for lag in closed_loop.LAGS]),
                          atol=0.04)


def test_long_standing_ends_of_a_clip_are_cut():
    walk = tk.datasets.procedural.generate("Neutral", seconds=4.0)

    def stands(before: int, after: int) -> tk.Clip:
        frames = [0] * before + list(range(len(walk))) + [len(walk) - 1] * after
        return _taken(walk, frames)

    clip = stands(300, 240)
    part = tk.styles.comparison.walking(clip)
    assert len(walk) <= len(part) < len(walk) + 60
    assert tk.styles.not_a_walk(clip) == tk.styles.not_a_walk(walk) == ""
    for whole in (walk, stands(120, 120), clip.cut(0, 60)):
        assert len(tk.styles.comparison.walking(whole)) == len(whole)


def test_rounds_in_closed_loop_bring_the_walk_nearer_to_the_clip(fast, zombie):
    (model, bank), (quick, _) = tk.pretrained(), fast
    prior, found = fine_tuning.prior_of(model, bank), []
    for rounds in (0, 1, 1):
        loop = closed_loop.ClosedLoop(model, zombie, bank["Neutral"], prior, 2e-2, 1, seed=0)
        walks = comparison.walks(zombie, quick, bank["Neutral"][None], bank, [])
        assert len(walks) == 2
        for _ in range(rounds):
            vector = loop.round(walks)
        with torch.no_grad():
            found.append((float(loop.distance(*loop.walk_on(walks))), loop.vector.detach()))
    (first, start), (last, learnt), (again, same) = found
    assert torch.equal(start, bank["Neutral"])
    assert torch.equal(learnt, vector)
    assert torch.equal(learnt, same)
    assert last == again < 0.8 * first
    # of the clip itself nothing is left
    roots = root_frames(zombie)
    places = roots.to_local(zombie.global_positions[:, list(model.layout.skeleton.feature_joints)])
    way = roots.turn_to_local(contacts.velocities(roots.positions, 60.0))[:, None, [0, 2]]
    head = comparison.up_of_head(zombie)[:, None, 1:]
    assert float(loop.distance(places[:, None], way, head)) == 0


@pytest.mark.parametrize(("joint", "axis", "seen"), [
    ("Head", (1, 0, 0), {"head": 20.0}), ("Head", (0, 0, 1), {"head": 20.0}),
    ("Head", None, {"head": 0.0}), ("LeftKnee", (1, 0, 0), {"knees": 10.0})])
def test_a_nod_and_bent_knees_are_measured_and_a_look_aside_is_not(joint, axis, seen):
    clip = tk.datasets.procedural.generate("Neutral", seconds=2.0)
    rotations, at = clip.rotations.clone(), clip.skeleton.index(joint)
    axis = torch.tensor([axis]).float() if axis else comparison.up_of_head(clip)
    turn = R.from_axis_angle(axis, torch.full((len(axis),), math.radians(20)))
    rotations[:, at] = R.multiply(rotations[:, at], turn)
    walks = clip.cut(0, len(clip)), clip.replace(rotations=rotations)
    before, after = (comparison.measures(walk, clip) for walk in walks)
    changed = {what: after[what] - before[what] for what in ("head", "knees")}
    assert changed == pytest.approx({"head": 0.0, "knees": 0.0} | seen, abs=2.0)


def test_a_broken_style_fails_and_says_why(zombie, fast):
    model, bank = fast
    noise = torch.randn(bank.vectors.shape[1], generator=torch.Generator().manual_seed(0))
    broken = tk.styles.compare(zombie, model, bank["Zombie"] + 2 * noise, bank)
    assert broken.verdict == "failed"
    assert broken.reasons
    # of a long clip the middle is compared
    begin = round((zombie.seconds - comparison.LONGEST) * 30)
    assert torch.equal(broken.clips["clip"].rotations, zombie.rotations[begin:-begin])
    # a weak style is better, however much is missing
    assert dataclasses.replace(broken, verdict="weak", excess=99.0).rank() < broken.rank()


def test_the_commands_lead_along_the_path_of_the_clip(monkeypatch):
    monkeypatch.undo()  # of the short walks
    clip = tk.datasets.procedural.generate("Neutral", "TR1", 10.0)
    warm_up = round(comparison.WARM_UP * 60)
    orders = comparison.commands(clip)[warm_up:]
    roots = tk.motion.root_frames(clip)
    lag = round(comparison.SMOOTH * 30)  # the first velocity is that of so many frames later
    way = roots.positions[lag:, [0, 2]] - roots.positions[lag, [0, 2]]
    at = torch.tensor([order.velocity for order in orders]).cumsum(0) / 60
    # turned so that the first facing is that of the clip
    towards = torch.atan2(*(tk.motion.trajectory.heading(roots.rotations[lag])))
    frames = len(clip) - 2 * lag
    went = comparison.turned(at[:frames], towards.expand(frames))
    assert way[:frames].norm(dim=-1).max() > 3
    assert (went - way[:frames]).norm(dim=-1).max() < 0.25


def test_a_walk_repeats_itself_where_its_tempo_changes(zombie):
    # from 0.75 to 1.25 times the tempo and back in six seconds
    time = torch.arange(len(zombie) - 1) / zombie.fps
    at = time - torch.sin(time * 2 * torch.pi / 6) * 0.25 * 6 / (2 * torch.pi)
    frames = (at * zombie.fps).round().long().clamp(0, len(zombie) - 1)
    assert not tk.styles.not_a_walk(_taken(zombie, frames))


def test_steps_are_those_of_the_middle_stride(zombie):
    steps = comparison.steps_per_second(zombie, zombie)
    assert steps == pytest.approx(120 / comparison.periodicity(zombie)[1], rel=0.06)
    first, rest = torch.arange(len(zombie)).split(150)[:2]
    for frames, wanted in ((torch.cat((first, first[-1:].expand(90), rest)), steps),  # it pauses
                           (first[-1:].expand(300), 0.0)):
        walk = _taken(zombie, frames)
        assert comparison.steps_per_second(walk, zombie) == pytest.approx(wanted, rel=0.1)


@pytest.mark.parametrize(("change", "why"), [
    (lambda clip: _taken(clip, [0] * 300 + [*range(30)] + [30] * 300), "lasts 1.5 s"),
    (lambda clip: clip.replace(root_positions=clip.root_positions * torch.tensor([0., 1, 0])),
     "covers 0.0"),
    (lambda clip: clip.replace(rotations=clip.rotations[:1].expand_as(clip.rotations)),
     "never leaves the floor|do not pass each other"),
    (lambda _: tk.datasets.procedural.generate("HopLeft"),
     "do not pass each other"),
])
def test_what_is_no_walk_is_refused_with_the_reason(zombie, fast, change, why):
    clip = change(zombie)
    assert re.search(why, tk.styles.not_a_walk(clip))
    with refusal(why):
        tk.styles.compare(clip, fast[0], "Zombie", fast[1])


def test_a_clip_of_another_rig_is_retargeted_to_each_model_that_is_there(zombie):
    model, bank = tk.pretrained("recorded")
    made = fitted(zombie, tk.runtime.compile(model), bank)
    assert made.skeleton.names == model.layout.skeleton.names
    assert not tk.styles.not_a_walk(made)
