"""The comparison of the seven models: what it measures against answers that are known, and one small run of all of it."""

import logging
import math
import os
import signal
import sys
import threading
import time
from pathlib import Path

import pytest
import torch

import toolkit as tk
from experiments.__main__ import main
from experiments.seven_models import failures, hundred, interpolation, load, models, results
from experiments.seven_models.posture import posture_error
from toolkit.features import pack_joints

STYLES = "Neutral,PendulumHands,Zombie"
PLAN = models.Plan("tiny", 4, walk=4.0, radius=0.2, recogniser_steps=30)
SOURCE = {"data": "procedural", "root": None, "styles": STYLES, "gaits": "FW", "clip_seconds": 8.0, "listed": False}


@pytest.fixture(scope="module")
def data():
    return load(**SOURCE)


@pytest.fixture(scope="module")
def folder(data, tmp_path_factory):
    """A whole comparison, of models that have hardly learnt anything."""
    out = tmp_path_factory.mktemp("comparison")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(models, "frame_time", lambda *_: (1.0, 0.1))
        models.compare(data, SOURCE, PLAN, tuple(tk.networks.MODELS), 1, out)
    return out


def call(*arguments):
    """The command line, which must end well."""
    with pytest.raises(SystemExit) as done:
        main(["seven-models", *map(str, arguments)])
    assert not done.value.code


def joints_of(hands, layout):
    """Positions ``[F, J, 3]`` of a body that stands, but for its hands' fore and aft ``[F, 2]``, left and right."""
    rest = layout.skeleton.rest_positions[list(layout.skeleton.feature_joints)].repeat(len(hands), 1, 1)
    for i, side in enumerate(("left", "right")):
        rest[:, layout.names.index(layout.skeleton.roles[f"{side}_hand"]), 2] += hands[:, i]
    return rest


def test_table_2_is_printed_as_counted_and_as_in_the_paper(capsys):
    call("table2")
    said = capsys.readouterr().out
    for number in ("2,436,380", "4,935,928", "4,870,392", "24,952,320", "262,656", "39,214,592", "35,668,530"):
        assert number in said
    assert sum(line.startswith(("pfnn", "lpn", "mann")) for line in said.splitlines()) == 7


def test_hands_that_swing_together_or_in_turn_or_not_at_all(data):
    t = torch.arange(240) * (2 * math.pi / 60)
    swings = torch.stack((torch.stack((t.sin(), t.sin()), 1), torch.stack((t.sin(), -t.sin()), 1), torch.zeros(240, 2)), 1)
    seen = tk.metrics.hand_swing(data.layout, torch.stack([joints_of(0.2 * swings[:, i], data.layout) for i in range(3)], 1))
    assert seen["together"][:2].tolist() == pytest.approx([1.0, -1.0], abs=1e-5)
    assert math.isnan(seen["together"][2])
    assert seen["range"][:, 0].tolist() == pytest.approx([0.2 / math.sqrt(2), 0.2 / math.sqrt(2), 0.0], abs=1e-5)


def test_the_shared_error_against_a_slow_loop_and_of_the_mean(data):
    train, test = tk.training.split(data, 0.1, 0, tuple(data.styles))
    scale = train.normalisers()["outputs"]
    for name in ("lpn-film", "pfnn-resad", "mann-film"):
        model = tk.networks.build(name, data.layout, 3, models.SIZES["tiny"], tk.networks.normalisers(name, train))
        bank = tk.training.make_bank(model, train)
        found = tk.evaluation.models.shared_error(model, bank, test, scale)["Zombie"]
        p, z = model.observe(test.phases["Zombie"], test.outputs["Zombie"])
        made, total, count = model.predict(test.inputs["Zombie"], p, bank["Zombie"]), 0.0, 0
        for block in tk.evaluation.models.SHARED:
            own, std = model.layout.outputs[block], scale.std[data.layout.outputs[block]]
            total += float((((made - z)[:, own] / std) ** 2).sum())
            count += len(z) * len(std)
        assert found == pytest.approx(total / count, rel=1e-4)
        torch.nn.init.zeros_(model.experts.layers[-1].weight)  # now it predicts the mean
        error = models.average(list(tk.evaluation.models.shared_error(model, bank, test, scale).values()))
        assert error == pytest.approx(tk.evaluation.models.shared_baselines(data, 0.1, 0)["mean"], rel=1e-4)


def test_natural_speed_and_the_clips_nearest_to_it(data):
    n, still = data.layout.n_joints, torch.zeros(240, data.layout.n_joints, 3)
    ways = ((0.0, 1.2), (0.0, 0.8), (0.0, -1.0), (1.0, 0.1), (0.0, 1.3))
    clips = torch.stack([pack_joints(still, still, still, torch.tensor([x, 0.0, z]).expand(240, n, 3)) for x, z in ways])
    assert tk.features.natural_speed(clips) == pytest.approx(1.2)
    assert math.isnan(tk.features.natural_speed(clips[2:4]))  # nobody walks ahead
    chosen = tk.evaluation.models.nearest(clips, 1.25)
    assert not any(torch.equal(clip, clips[2]) for clip in chosen)
    assert torch.equal(chosen[-1], clips[3])


def test_everything_is_measured_and_stored(data, folder):
    table = models.read_json(folder / models.TABLE)
    assert list(table["models"]) == list(tk.networks.MODELS)
    assert table["settings"]["source"] == SOURCE
    assert table["machine"]["torch"] == torch.__version__
    assert table["baselines"]["repeat"] < table["baselines"]["mean"] < 2
    film = table["models"]["lpn-film"]
    assert film["counts"]["per_style"] == 4 * models.SIZES["tiny"].hidden
    assert film["frame"] == [1.0, 0.1]
    row = film["runs"][0]["styles"]["PendulumHands"]
    assert row["hands_data"] > models.MOVING
    assert row["swing_data"] > 0.8  # there both hands swing together
    assert all(math.isfinite(v) for v in row.values())
    assert film["mean"]["shared"] == pytest.approx(sum(s["shared"] for s in film["runs"][0]["styles"].values()) / 3)


def test_a_frame_takes_time():
    model, bank = tk.pretrained()
    mean, spread = models.frame_time(model, bank["Zombie"], runs=2, frames=3)
    assert mean > 0
    assert spread >= 0


def test_hands_that_are_still_in_the_data_do_not_count():
    swimming, monk = ({"hands": 0.4, "hands_data": 0.3, "path": 1.0}, {"hands": 9.0, "hands_data": 0.01, "path": 3.0})
    expected = {"hands": 0.4, "hands_data": 0.3, "path": 2.0}
    assert models.over_styles({"Swimming": swimming, "Monk": monk}) == pytest.approx(expected)


def test_what_is_there_is_not_done_again(data, folder, monkeypatch):
    for module, name in ((tk.training, "fit"), (models, "closed_loop"), (tk.evaluation.recognition, "train")):
        monkeypatch.setattr(module, name, None)
    monkeypatch.setattr(models, "frame_time", lambda *_: (1.0, 0.1))
    before = models.read_json(folder / models.TABLE)
    again = models.compare(data, SOURCE, PLAN, tuple(tk.networks.MODELS), 1, folder)
    assert again["models"]["mann-film"]["mean"] == before["models"]["mann-film"]["mean"]


def test_a_stopped_run_goes_on_from_its_checkpoint(data, tmp_path):
    config = models.Plan("tiny", 8).config("pfnn-film", 0)

    def stop(step, loss):
        if step == 5:
            raise KeyboardInterrupt

    (tmp_path / "runs").mkdir()
    checkpoint = tmp_path / "runs" / "pfnn-film-0.checkpoint"
    with pytest.raises(KeyboardInterrupt):
        tk.training.fit(data, config, checkpoint, on_step=stop)
    run, whole = models.trained(data, config, tmp_path), tk.training.fit(data, config)
    assert not checkpoint.exists()
    for a, b in zip(run.model.parameters(), whole.model.parameters(), strict=True):
        assert torch.equal(a, b)


def test_other_settings_and_bad_names_are_refused_in_one_line(data, folder, capsys):
    with pytest.raises(ValueError, match=r"other settings .*steps: expected 4, got 5"):
        models.settle(folder, models.Plan("tiny", 5), data, SOURCE)
    with pytest.raises(ValueError, match=r"lpn-film-0.* was trained with other settings \(steps: expected 5, got 4\)"):
        models.trained(data, models.Plan("tiny", 5).config("lpn-film", 0), folder)
    for arguments, said in (
        ([], "--data is missing"),
        (["--data", "procedural", "--size", "huge"], "unknown size 'huge'; known: tiny, small"),
        (["--data", "procedural", "--models", "lpn-film,gan"], "unknown model 'gan'; known: pfnn-onehot"),
        (["failures", "--out", "nowhere"], "nowhere"),
    ):
        assert main(["seven-models", *arguments]) == 2
        error = capsys.readouterr().err.strip()
        assert said in error
        assert "\n" not in error


def test_the_command_prints_the_comparison(folder, monkeypatch, capsys):
    monkeypatch.setattr(models, "Plan", lambda *_: PLAN)
    monkeypatch.setattr(models, "frame_time", lambda *_: (1.0, 0.1))
    call("--data", "procedural", "--styles", STYLES, "--gaits", "FW", "--clip-seconds", 8, "--size", "tiny", "--steps", 4,
         "--seeds", 1, "--out", folder)
    said = capsys.readouterr().out
    assert all(said.count(f"\n{name}") == 3 for name in tk.networks.MODELS)
    assert "3 styles; tiny sizes, 4 steps of 64 frames" in said


def test_failure_cases_are_written_and_drawn(folder, monkeypatch, capsys):
    monkeypatch.setattr(failures, "COUNTS", (2,))
    monkeypatch.setattr(failures, "COMMON", 2)
    monkeypatch.setattr(failures, "WARM_UP", 0.2)
    for name, value in {"PAIRS": 1, "BLENDS": 4, "SECONDS": 1.5, "WARM_UP": 0.2}.items():
        monkeypatch.setattr(interpolation, name, value)
    call("failures", "--out", folder)
    said = capsys.readouterr().out
    sections = [line.split()[0] for line in said.splitlines() if line.startswith("5.1")]
    assert sections == ["5.1.1", "5.1.2", "5.1.2", "5.1.2", "5.1.3"]
    assert "2 styles" in said
    pictures = {path.name for path in (folder / "failures").glob("*.png")}
    assert {"errors.png", "closed_loop.png", "interpolation.png", "large_numbers_of_styles.png"} <= pictures
    assert {"no_global_phase.png", "no_global_phase_strip.png", "no_phase_features.png"} <= pictures


def test_artifacts_are_distances_from_the_data_beside_their_floor():
    def runs(clavicle):
        rows = {"a": {"clavicle": clavicle, "hand": 0.1, "clavicle_data": 0.004, "hand_data": 0.01},
                "b": {"clavicle": 3 * clavicle, "hand": math.nan, "clavicle_data": 0.002, "hand_data": 0.01}}
        return {"runs": [{"styles": rows}]}

    case = failures.artifacts({"models": {"lpn-onehot": runs(0.02), "lpn-resad": runs(0.03), "lpn-film": runs(0.01)}})
    assert case.rows["lpn-film"]["clavicle, cm"] == pytest.approx([2.0])
    assert case.rows["lpn-film"]["worst clavicle, cm"] == pytest.approx([3.0])
    assert case.rows["data, other clips"]["clavicle, cm"] == pytest.approx([0.3])
    assert case.verdict.startswith("shows (by +2.00 to +2.00 in 1 seed) that one-hot and adapters are farther")
    assert case.verdict.count("does not show (by +0.00 to +0.00 in 1 seed)") == 1


def test_verdicts_need_every_seed():
    for worse, said in ((0.5, "shows (by +0.50"), (-0.1, "does not show (by -0.10"), (math.nan, "cannot say")):
        assert failures._shown([0.7, worse]).startswith(said)


def test_stuck_hands_are_told_from_moving_ones():
    def runs(hands):
        style = {"hands": hands, "hands_data": 0.2, "together": 1 - hands}
        still = {"hands": 0.1, "hands_data": 0.01, "together": 0.0}  # moves in neither, and does not count
        return {"runs": [{"styles": {"Swimming": style, "Monk": still}, "recognised": 1.0}] * 2}

    table = {"models": {"pfnn-film": runs(0.3), "lpn-film": runs(0.9)}}
    case = failures.stuck_hands(table, "pfnn-film", "lpn-film", "5.1.1", "No global phase", "claim")
    assert case.rows["pfnn-film"] == {
        "range / data": pytest.approx([0.3, 0.3]), "|corr. - data's|": pytest.approx([0.7, 0.7]),
        "styles below 0.5": [1, 1], "of styles": 1, "recognised": [1.0, 1.0],
    }
    assert case.drawn["style"] == "Swimming"
    assert case.verdict.count("shows (") == 2
    other = failures.stuck_hands(table, "lpn-film", "pfnn-film", "5.1.1", "No global phase", "claim")
    assert other.verdict.count("does not show (") == 2


def test_numbers_of_an_even_blend_and_of_a_jump():
    even = torch.linspace(0, 1, 11)[None]
    jump, reluctant = (even > 0.95).float(), 0.45 * even
    smooth = interpolation.Curves(even, even).numbers()
    assert (smooth["widest step"], smooth["crosses at"]) == (pytest.approx(0.1), pytest.approx(0.6))
    assert smooth["rank corr."] == pytest.approx(1.0)
    sudden = interpolation.Curves(jump, even).numbers()
    assert (sudden["widest step"], sudden["crosses at"]) == (1.0, pytest.approx(1.0))
    never = interpolation.Curves(reluctant, even).numbers()  # the second style is never recognised: nothing to say
    assert never["of 1 pairs"] == 0
    assert math.isnan(never["widest step"])


def test_pairs_are_different_and_begin_with_the_papers():
    assert interpolation.style_pairs(["a", "b"]) in ([("a", "b")], [("b", "a")])
    pairs = interpolation.style_pairs(["LeanBack", "Old", "BentForward", "Neutral", "Zombie"])
    assert pairs[0] == ("BentForward", "LeanBack")
    assert len({frozenset(pair) for pair in pairs}) == len(pairs) == 10  # all that there are
    assert all(a != b for a, b in pairs)
    assert len({frozenset(pair) for pair in interpolation.style_pairs(list("abcdefghijklmnop"))}) == interpolation.PAIRS


def test_every_seed_is_tested_on_the_same_frames_and_the_recogniser_has_not_seen_them(data, monkeypatch):
    first, other = (tk.training.split(data, models.HELD_OUT, seed, tuple(data.styles)) for seed in (0, 7))
    for style in data.styles:
        assert torch.equal(first[1].frames[style], other[1].frames[style])
    seen = []
    monkeypatch.setattr(tk.evaluation.recognition, "train", lambda train, steps: seen.append((train, steps)) or 1 / 0)
    with pytest.raises(ZeroDivisionError):
        models.judge(data, Path("nowhere"))
    (train, steps), = seen
    assert steps == 200
    assert {s: len(x) for s, x in train.clips.items()} == {s: len(x) for s, x in first[0].clips.items()}


def test_measures_of_other_runs_in_the_folder_stay_in_the_table(data, folder, monkeypatch):
    monkeypatch.setattr(models, "frame_time", lambda *_: (1.0, 0.1))
    before = models.read_json(folder / models.TABLE)
    again = models.compare(data, SOURCE, PLAN, ("lpn-film",), 1, folder)
    assert again["models"].keys() == before["models"].keys()
    held = models.read_json(folder / "measures" / "lpn-film-0.json")
    models.write_json(folder / "measures" / "lpn-film-3.json", held | {"seed": 3, "processor": held["processor"] + 2})
    try:
        film = models.compare(data, SOURCE, PLAN, ("lpn-film",), 1, folder)["models"]["lpn-film"]
    finally:
        (folder / "measures" / "lpn-film-3.json").unlink()
    assert [run["seed"] for run in film["runs"]] == [0, 3]
    assert film["mean"]["processor"] == pytest.approx(held["processor"] + 1)
    assert film["spread"]["shared"] == 0
    assert film["mean"]["trained"] == PLAN.steps
    assert film["mean"]["steps"] < 10  # of the feet, per second


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no SIGKILL")
def test_runs_are_spread_over_the_processes_of_a_cluster_and_one_of_these_may_be_killed(data, folder, tmp_path):
    distributed = pytest.importorskip("distributed", reason='Dask is not installed: pip install ".[scale]"')
    killed = []
    quiet = {"dashboard_address": ":0", "silence_logs": logging.ERROR}
    with distributed.LocalCluster(n_workers=2, threads_per_worker=2, **quiet) as cluster:

        def kill():
            while not (busy := [worker.address for worker in cluster.scheduler.workers.values() if worker.processing]):
                time.sleep(0.02)
            nanny = next(nanny for nanny in cluster.workers.values() if nanny.worker_address == busy[0])
            killed.append(nanny.pid)
            os.kill(nanny.pid, signal.SIGKILL)

        killer = threading.Thread(target=kill, daemon=True)
        killer.start()
        table = models.compare(data, SOURCE, PLAN, ("pfnn-onehot", "pfnn-film"), 2, tmp_path,
                               scheduler=cluster.scheduler_address)
        killer.join(30)
    assert len(killed) == 1
    alone = models.read_json(folder / models.TABLE)["models"]
    for name in ("pfnn-onehot", "pfnn-film"):
        runs = table["models"][name]["runs"]
        assert [run["seed"] for run in runs] == [0, 1]
        assert runs[0]["shared"] == pytest.approx(alone[name]["mean"]["shared"], rel=1e-4)
        assert runs[1]["shared"] != pytest.approx(alone[name]["mean"]["shared"], rel=1e-4)


def test_the_mean_pose_of_arms_and_its_floor(data):
    """A raised shoulder and a moved hand, known to the millimetre."""
    layout, still = data.layout, torch.zeros(240, 2)
    rest = joints_of(still, layout)
    other, lifted = rest.clone(), rest.clone()
    side = layout.names.index(layout.skeleton.roles["left_hand"])
    arm = [layout.names.index(layout.skeleton.roles[f"left_{part}"]) for part in ("shoulder", "elbow", "hand")]
    other[:, side, 2] += 0.1
    lifted[:, arm, 1] += 0.04  # the whole arm, so the clavicle alone is wrong

    def packed(positions):
        nothing = torch.zeros_like(positions)
        return pack_joints(positions, nothing, nothing, nothing)

    clips = torch.stack([packed(rest), packed(other)])
    found = posture_error(layout, packed(lifted), clips[:1], 0.0)
    assert found == pytest.approx({"clavicle": 0.02, "hand": 0.0, "clavicle_data": 0.0, "hand_data": 0.0}, abs=1e-6)
    found = posture_error(layout, packed(rest), clips, 0.0)
    assert found == pytest.approx({"clavicle": 0.0, "hand": 0.025, "clavicle_data": 0.0, "hand_data": 0.05}, abs=1e-6)


def test_the_network_that_made_the_data_is_the_ceiling(data, folder, monkeypatch):
    run = tk.training.load(folder / "runs" / "lpn-film-0.safetensors")
    bank = tk.styles.StyleBank(("Old", *run.bank.names), torch.cat((run.bank.vectors[:1], run.bank.vectors)))
    monkeypatch.setattr(models.published, "load", lambda path: (run.model, bank))
    monkeypatch.setattr(models, "Plan", lambda *_: PLAN)
    try:
        call("ceiling", "--published", "x", "--out", folder)
        table = models.read_json(folder / models.TABLE)
    finally:
        (folder / models.CEILING).unlink(missing_ok=True)
    assert table["ceiling"]["shared"] == pytest.approx(table["models"]["lpn-film"]["mean"]["shared"], rel=1e-5)
    assert table["ceiling"]["styles"].keys() == set(data.styles)


def test_the_stored_result_of_a_comparison_has_floors_ceiling_and_every_model(folder):
    table = models.read_json(folder / models.TABLE)
    table["ceiling"] = table["models"]["lpn-film"]["runs"][0]
    found = results.comparison("x", "about", "command", table)
    assert [row["model"] for row in found.rows] == [
        "floor: predicting the mean", "floor: repeating the frame", *tk.networks.MODELS, "the published network"]
    film = next(row for row in found.rows if row["model"] == "lpn-film")
    assert film["shared"] == [found.rows[-1]["shared"]]
    assert film["step_ms"][0] == pytest.approx(1000 * 60 * film["minutes"][0] / PLAN.steps)
    assert found.settings["styles"] == 3
    assert "nan" not in found.markdown()


def test_a_style_clip_on_a_treadmill_is_the_data_again(data):
    clip = failures._treadmill(data.layout, data.clips["Zombie"][0], 1.0)
    wanted = tk.features.split_joints(data.clips["Zombie"][0])["position"]
    joints = list(data.layout.skeleton.feature_joints)
    shown = clip.global_positions[:, joints] - torch.tensor([0.0, 0.0, 1 / 60]) * torch.arange(240)[:, None, None]
    assert (shown - wanted).norm(dim=-1).max() < 0.005


@pytest.mark.parametrize("gait", hundred.GAITS)
def test_commands_of_a_gait_go_where_the_gait_says(gait):
    orders = hundred.commands(gait, 5, 600, tk.features.splits.generator(1))
    velocity, facing = (torch.stack([getattr(c, name) for c in orders]) for name in ("velocity", "facing"))
    torch.testing.assert_close(facing.norm(dim=-1), torch.ones(600, 5))
    speed = velocity.norm(dim=-1)
    along, across = (velocity * facing).sum(-1), velocity[..., 0] * facing[..., 1] - velocity[..., 1] * facing[..., 0]
    ahead = {"BW": -speed, "BR": -speed, "SW": 0 * speed, "SR": 0 * speed}.get(gait, speed)
    aim = ahead, across if gait in ("SW", "SR") else 0 * speed
    torch.testing.assert_close(along, aim[0], atol=1e-5, rtol=0)
    torch.testing.assert_close(across, aim[1], atol=1e-5, rtol=0)
    low, high = hundred.GAITS[gait][1]
    assert max(0.0, low) - 1e-5 <= speed.min()
    assert speed.max() <= high + 1e-5
    assert (gait in ("TR1", "ID")) == bool((speed == 0).any())
    assert (gait == "ID") == bool((speed == 0).all())
    turning = torch.linalg.cross(*(torch.nn.functional.pad(f, (0, 1)) for f in (facing[:-1], facing[1:])))[..., 2].abs()
    assert turning.max() * 60 <= hundred.TURNING + 1e-3


def test_a_rolled_out_set_reads_back_as_100style(shared, tmp_path):
    parameters = shared / "lpn_film_100style"
    if not parameters.is_dir():
        pytest.skip(f"no published parameters: {parameters} does not exist")
    out = tmp_path / "hundred"
    call("hundred", "--published", parameters, "--out", out, "--styles", "Neutral,Zombie", "--seconds", 1.5)
    clips = tk.datasets.load("100style", out)
    assert {(c.style, c.gait, len(c)) for c in clips} == {(s, g, 90) for s in ("Neutral", "Zombie") for g in hundred.GAITS}
    assert not any(info.symmetric for info in tk.datasets.style100.styles(out).values())


def test_models_of_few_and_of_many_styles_are_compared_on_the_same_frames(data, tmp_path, monkeypatch):
    seen = {}
    monkeypatch.setattr(tk.features.splits, "SPLIT_FRAMES", 20)  # many windows to choose held-out frames from
    monkeypatch.setattr(failures, "COUNTS", (1,))
    monkeypatch.setattr(failures, "COMMON", 1)
    monkeypatch.setattr(failures, "trained", lambda *_: tk.training.Run(None, None, None, [], {}, {}))

    def shared_error(model, bank, test, scale):
        seen.setdefault(len(test.styles), test)
        return dict.fromkeys(test.styles, 1.0)

    monkeypatch.setattr(failures, "shared_error", shared_error)
    failures.capacity(data, PLAN, tmp_path)
    for style in seen[1].styles:
        assert torch.equal(seen[1].inputs[style], seen[3].inputs[style])
