"""Training: minibatches, splits, the loop, checkpoints, several processes."""

import contextlib
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
from dataclasses import asdict, replace
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import pytest
import torch
from refusal import refusal
from test_networks import TINY, tiny_model, tree
from torch.nn import functional
from torch.testing import assert_close

import toolkit as tk
from toolkit import networks, training
from toolkit.features import Features, splits
from toolkit.io import model_files
from toolkit.styles import StyleBank
from toolkit.training import Config, distributed, loop, loss, minibatches


def waves(joints: int = 4, styles: int = 2, frames: int = 700) -> Features:
    """Something to learn: every column a wave of time, whose shape the style changes."""
    layout = tree(joints)
    generator = torch.Generator().manual_seed(0)
    kinds = ("inputs", "phases", "outputs", "clips", "takes", "frames")
    parts: dict[str, dict[str, torch.Tensor]] = {kind: {} for kind in kinds}
    rates = 0.1 * torch.randint(1, 4, (1, layout.n_inputs), generator=generator)
    starts = 6 * torch.rand(1, layout.n_inputs, generator=generator)
    mixing = torch.randn(layout.n_inputs, layout.n_outputs, generator=generator) / 10
    for i in range(styles):
        n = frames + 50 * i
        t = torch.arange(n)[:, None]
        x = torch.sin(rates * t + starts + i)
        p = torch.cat([torch.sin(t * 0.1 + k) for k in range(8)], 1)
        z = x @ mixing * (1 + i) + torch.sin(t * 0.1)
        clips = z[:, layout.outputs["joints"]].unfold(0, 240, 120).transpose(1, 2).contiguous()
        # the frames are so far apart that no two windows overlap
        at = torch.arange(n)
        for kind, value in zip(kinds, (x, p, z, clips, (at >= 400).long(), 240 * at), strict=True):
            parts[kind][f"style{i}"] = value
    return Features(layout, **parts)


WIDER = replace(TINY, hidden=64, dropout=0.0)
QUICK = Config(sizes=TINY, steps=12, batch=16, clips_per_batch=4, evaluate_every=5,
               rate=1e-3, final_rate=0.1, max_gradient=1.0, pose_mixup=0.2, refit=0)


def quick(**changes) -> Config:
    return replace(QUICK, **changes)


def fit(path=None, **changes) -> training.Run:
    """A run on the waves; ``path`` is that of its checkpoint."""
    return training.fit(waves(), quick(**changes), path)


@contextlib.contextmanager
def after_steps(call):
    """Inside, ``call`` gets the number of every step of a training."""
    step = loop.step

    def stepped(*arguments):
        values = step(*arguments)
        call(arguments[5] + 1)
        return values

    with mock.patch.object(loop, "step", stepped):
        yield


def interrupt(*_) -> None:
    os.kill(os.getpid(), signal.SIGINT)


def same_weights(a: networks.Model, b: networks.Model) -> bool:
    pairs = zip(a.state_dict().values(), b.state_dict().values(), strict=True)
    return all(torch.equal(x, y) for x, y in pairs)


def course(run: training.Run) -> list[tuple]:
    """What a history says apart from times."""
    return [(row["step"], row["loss"], row["held_out"]) for row in run.history]


@pytest.fixture(scope="module")
def straight():
    """A run without a stop."""
    return fit()


def test_minibatches_cycle_through_styles_and_frames():
    data = waves(styles=3, frames=240)
    batches = minibatches.Minibatches(data, 32, 2, seed=4)
    assert batches.steps_per_epoch == 3 * (240 // 32)
    seen = []
    for turn in range(240 // 32):
        for which, style in enumerate(data.styles):
            x, p, z, y = batches[3 * turn + which]
            rows = [int((data.inputs[style] == row).all(1).nonzero()) for row in x]
            assert torch.equal(data.outputs[style][rows], z)
            assert torch.equal(data.phases[style][rows], p)
            assert y.shape == (2, 240, data.layout.n_clip)
            seen += rows if which == 0 else []
    assert len(set(seen)) == len(seen) == 32 * (240 // 32)
    assert not torch.equal(minibatches.Minibatches(data, 32, 2, seed=5)[3][0], batches[3][0])
    no_frames = replace(data, inputs=data.inputs | {"style1": torch.zeros(0, 96)})
    with refusal("style 'style1' has 0 frames and "):
        minibatches.Minibatches(no_frames, 32, 2, seed=4)


def test_past_frames_are_those_before_in_the_same_take():
    data = waves()  # its first take has 400 frames
    data = replace(data, frames={"style0": torch.arange(700)})
    x = data.inputs["style0"]
    rows = torch.tensor([0, 2, 300, 400, 401, 650])
    found = minibatches.remembered(data, "style0", rows, 3)
    for row, window in zip(rows.tolist(), found, strict=True):
        first = 400 if row >= 400 else 0
        assert torch.equal(window, x[[max(first, row - k) for k in (3, 2, 1, 0)]])


def test_only_poses_are_mixed_up_and_only_towards_others():
    data = waves(styles=3)
    plain = minibatches.Minibatches(data, 64, 1, 4)
    mixed = minibatches.Minibatches(data, 64, 1, 4, pose_mixup=0.5)
    joints = data.layout.inputs["joints"]
    (x, *rest), (moved, *same) = plain[7], mixed[7]
    assert all(torch.equal(a, b) for a, b in zip(rest, same, strict=True))
    assert torch.equal(x[:, : joints.start], moved[:, : joints.start])
    changed = (x != moved).any(1)
    assert 0.3 < changed.float().mean() < 0.7
    poses = torch.cat([data.inputs[s][:, joints] for s in data.styles])
    pose, way = x[changed][0, joints], (moved - x)[changed][0, joints]
    others = poses - pose
    share = (others @ way) / others.square().sum(1)  # along the way to some frame, not all of it
    near = (share[:, None] * others - way).abs().amax(1) < 1e-5
    assert (near & (share > 0) & (share < 1)).any()


def test_held_out_frames_are_in_windows_and_the_same_whichever_styles_there_are():
    data = waves(styles=3, frames=1500)
    train, test = splits.split(data, 0.2, 0, ("style1", "style0"))
    assert train.styles == ["style1", "style0"]
    whole = splits.held_out(data, 0.2, 0, tuple(data.styles))
    for style in train.styles:
        n = len(data.inputs[style])
        assert len(test.inputs[style]) == round(0.2 * n)
        assert len(train.inputs[style]) + len(test.inputs[style]) == n
        rows = splits.held_out(data, 0.2, 0, (style,))[style]
        assert torch.equal(rows, whole[style])
        assert int((rows.diff() > 1).sum()) <= 2
        assert torch.equal(test.inputs[style], data.inputs[style][rows])
    assert len({tuple(rows[:1500].tolist()) for rows in whole.values()}) == 3
    assert splits.mix(3, "Zombie") == 691408046533145781  # on every machine


def poses(rows):
    """The joints' heights in frames ``[..., 12 J]``: those of a motion and of its mirror image."""
    heights = rows.unflatten(-1, (-1, 12))[..., 1].flatten(0, -2)
    return {tuple(row) for row in (1e5 * heights.sort(-1).values).round().long().tolist()}


@pytest.mark.parametrize(("seconds", "mirror"), [
    (22.0, True),
    (8.0, False),  # a stretch is repeated for a style clip
])
def test_style_clips_of_a_training_share_no_frame_with_what_is_held_out(seconds, mirror):
    made = [tk.datasets.procedural.generate("Zombie", seconds=seconds)]
    data = tk.features.build(made, mirror=mirror, source="contact")
    train, test = splits.split(data, 0.1, 1, ("Zombie",))
    windows = test.frames["Zombie"][:, None] + torch.arange(-60, 52)
    near = torch.isin(data.frames["Zombie"], windows)
    near = poses(data.inputs["Zombie"][near][:, data.layout.inputs["joints"]])
    assert len(near) > 60
    assert poses(data.clips["Zombie"]) & near  # some clips of the data do
    assert not poses(train.clips["Zombie"]) & near
    frames = train.frames["Zombie"], test.frames["Zombie"]
    # the windows share no frame (a mirror image has the numbers of its original), and none is
    # left out needlessly
    assert (frames[0][:, None] - frames[1]).abs().min() == 112
    assert len(frames[1]) == round(0.1 * len(data.inputs["Zombie"]))
    neither = len(data.inputs["Zombie"]) - sum(map(len, frames))
    windows = math.ceil(len(frames[1]) / 240)
    assert 0 < neither <= 2 * 111 * (1 + mirror) * len(made) * windows


def test_a_style_too_short_for_clips_of_its_own_is_doubted():
    clip = tk.datasets.procedural.generate("Zombie", seconds=2.5)
    data = tk.features.build(clip, source="contact")
    doubt = "style 'Zombie' is too short to hold out frames"
    with pytest.warns(UserWarning, match=doubt) as doubts:
        train, test = splits.split(data, 0.1, 0, ("Zombie",))
    assert len(doubts) == 2  # its frames, and its style clips
    assert torch.equal(train.clips["Zombie"], data.clips["Zombie"])
    parts = len(train.inputs["Zombie"]) + len(test.inputs["Zombie"])
    assert parts == len(data.inputs["Zombie"])


def test_features_of_a_list_have_its_parts():
    clips = tk.datasets.procedural.load(["Zombie", "Neutral", "Old"], ["FW", "FR"], 9.0)
    block = tk.datasets.blocks.Block
    trained = [block("Zombie", "FW", 100, 400), block("Zombie", "FR", 10, 520),
               block("Neutral", "FW", 0, 540), block("Neutral", "FR", 0, 540)]
    tested = [block("Zombie", "FW", 520, 9999), block("Old", "FW", 0, 540)]
    parts = tk.datasets.blocks.Split("made", trained, [block("Zombie", "FR", 620, 640)], tested,
                                     unseen=("Old",))
    data = splits.listed(clips, parts, source="contact")
    assert data.styles == ["Neutral", "Zombie"]
    train, test = splits.split(data, 0.3, 5, ("Zombie", "Neutral"))  # share and seed do not matter
    sizes = {style: len(x) for style, x in test.inputs.items()}
    assert sizes == {"Zombie": 540 - 420 - 112 + 1, "Neutral": 0}
    assert len(train.inputs["Zombie"]) == 300 + 510 - 2 * 111
    joints = data.layout.inputs["joints"]
    walk = next(c for c in clips if (c.style, c.gait) == ("Zombie", "FW"))
    last = tk.features.build(walk.cut(420, 540), source="contact")  # it begins at frame 520
    assert_close(test.inputs["Zombie"][:, joints], last.inputs["Zombie"][:, joints])
    assert not poses(train.clips["Zombie"]) & poses(test.inputs["Zombie"][:, joints])
    run = training.fit(data, quick(steps=2, clips_per_batch=1))
    assert run.held_out.keys() == {"Zombie"}
    with refusal(r"Neutral.*: the split of made has no block of this take"):
        splits.listed(clips, replace(parts, train=parts.train[:2]))
    with refusal("none of these clips is in the training part"):
        splits.listed([c for c in clips if c.style == "Old"], parts)


def test_loss_is_mse_and_bone_length_of_equation_5():
    model = tiny_model()
    predicted, target = torch.randn(3, 2, model.layout.n_outputs).unbind(1)
    mse, bone = loss.loss_terms(model, predicted, target)
    assert_close(mse, functional.mse_loss(predicted, target))
    rows = (model.normaliser("outputs").invert(z)[:, 24:72].view(3, 4, 12)
            for z in (predicted, target))
    lengths = [z[..., :3].diff(dim=1).norm(dim=-1) for z in rows]  # of a chain of joints
    assert_close(bone, functional.l1_loss(*lengths))


def test_bfloat16_is_for_products_only_and_learns_as_much(straight):
    run = fit(precision="bf16")
    assert all(p.dtype == torch.float32 for p in run.model.parameters())
    assert not same_weights(run.model, straight.model)
    assert run.table()[-1]["error"] == pytest.approx(straight.table()[-1]["error"], rel=0.05)


def test_stopped_or_killed_and_resumed_equals_not_stopped(tmp_path, straight):
    """A kill leaves the checkpoint as it lay in a step, since a file is replaced whole."""
    stopped, killed = tmp_path / "stopped", tmp_path / "killed"
    torch.manual_seed(3)
    expected, before = torch.rand(4), signal.getsignal(signal.SIGINT)
    torch.manual_seed(3)

    def during(step):
        if step == 8:
            shutil.copy(stopped, killed)
        elif step == 9:
            interrupt()

    with (pytest.raises(KeyboardInterrupt), after_steps(during),
          mock.patch.object(training.checkpoint, "SAVE_EVERY", 0.0)):
        training.fit(waves(), straight.config, stopped)
    assert torch.equal(torch.rand(4), expected)  # the global generator is left alone
    straight.save(tmp_path / "straight")
    for path, done in ((stopped, 9), (killed, 7)):
        steps = []
        with after_steps(steps.append):
            resumed = training.fit(waves(), straight.config, path)
        assert steps == list(range(done + 1, 13))
        resumed.save(path)  # weights, vectors, history and errors, without measured times
        assert path.read_bytes() == (tmp_path / "straight").read_bytes()
    assert {p.name for p in tmp_path.iterdir()} == {"stopped", "killed", "straight"}
    assert signal.getsignal(signal.SIGINT) is before


def test_ctrl_c_after_the_last_step_leaves_a_checkpoint(tmp_path):
    call = waves(), quick(evaluate_every=100), tmp_path / "checkpoint"
    with mock.patch.object(loop, "evaluate", interrupt), pytest.raises(KeyboardInterrupt):
        training.fit(*call)
    with after_steps(lambda _: pytest.fail("a step was repeated")):
        training.fit(*call)


SCRIPT = """
import json, sys
import torch
from toolkit import training

if __name__ == "__main__":
    torch.set_num_threads(1)
    data = torch.load(sys.argv[3], weights_only=False)
    run = training.fit(data, training.Config.from_json(json.loads(sys.argv[1])))
    if training.distributed.first():
        run.save(sys.argv[2])
"""


def test_two_processes_equal_one_without_dropout(tmp_path):
    """Pose mix-up, clipped gradients, and shares of 8 and 7 frames with 5 clips included."""
    config = quick(steps=6, sizes=WIDER, batch=15, clips_per_batch=5, evaluate_every=1)
    alone = training.fit(waves(), config)
    two = replace(config, processes=2)
    program, path, data = tmp_path / "train.py", tmp_path / "run", tmp_path / "data"
    program.write_text(SCRIPT)
    torch.save(waves(), data)
    call = [sys.executable, program, json.dumps(asdict(two)), path, data]
    settings = {"PYTHONPATH": str(Path(__file__).parents[2]), "PYTHONWARNINGS": "error",
                "OMP_NUM_THREADS": "1"}
    subprocess.run(call, env=os.environ | settings, check=True, timeout=600)
    together = training.load(path)
    losses, same = ([row["loss"] for row in run.history] for run in (alone, together))
    assert same != losses  # or it was one process after all
    assert same == pytest.approx(losses, abs=1e-4)
    for a, b in zip(alone.model.parameters(), together.model.parameters(), strict=True):
        assert_close(a, b, atol=1e-4, rtol=0)


def test_under_torchrun_its_processes_and_nodes_count_and_not_the_config(monkeypatch):
    """It starts the processes; Fabric joins them."""
    asked = []
    made = SimpleNamespace(launch=lambda: asked.append("launched"))
    monkeypatch.setattr("lightning_fabric.Fabric", lambda **given: asked.append(given) or made)
    monkeypatch.setenv("TORCHELASTIC_RUN_ID", "none")
    monkeypatch.setenv("LOCAL_WORLD_SIZE", "3")
    monkeypatch.setenv("GROUP_WORLD_SIZE", "2")
    distributed.start.cache_clear()
    assert distributed.start("cpu", 1) is made
    distributed.start.cache_clear()
    given, launched = asked
    assert (given["devices"], given["num_nodes"], launched) == (3, 2, "launched")


def test_processes_draw_their_own_dropout():
    seeds = {}
    for rank in range(3):
        with (mock.patch.object(distributed.Alone, "global_rank", rank),
              mock.patch.object(splits, "seeded", wraps=splits.seeded) as seeded):
            training.fit(waves(), quick(steps=3))
        drawn = [call.args[1:] for call in seeded.call_args_list]
        seeds[rank] = [given for given in drawn if given[1] == loop.DROPOUT]
    assert [given[2:] for given in seeds[0]] == [(0,), (1,), (2,)]  # as one process does
    assert len({given for drawn in seeds.values() for given in drawn}) == 9


def test_the_environment_alone_makes_no_second_process(monkeypatch):
    """RANK=1 is left in an environment by other launchers; training wrote nothing then."""
    monkeypatch.setenv("RANK", "1")
    assert distributed.first()


def test_only_several_processes_need_lightning_fabric(monkeypatch):
    monkeypatch.setitem(sys.modules, "lightning_fabric", None)
    training.distributed.start.cache_clear()
    needed = r'^several processes need the extra "scale": pip install "\.\[scale\]"$'
    with pytest.raises(ImportError, match=needed):
        fit(processes=2)
    run = fit(steps=2, held_out=0.0)
    assert (run.held_out, run.baselines, run.history[-1]["held_out"]) == ({}, {}, None)
    with refusal(r"^1 × 'cuda:99': .+$"):
        fit(device="cuda:99")
    with refusal("1 × 'abacus': Expected one of cpu, cuda, "):
        fit(device="abacus")


def test_it_stops_early_with_the_best_weights_also_after_a_resume(tmp_path):
    config = quick(steps=400, rate=0.2, final_rate=1.0, evaluate_every=5, patience=3)
    data = waves()
    whole = training.fit(data, config)
    errors = [row["held_out"] for row in whole.history]
    assert len(errors) < 80
    assert min(errors) == errors[-4] < min(errors[-3:])
    best = replace(config, patience=None, steps=whole.history[-4]["step"])
    assert same_weights(whole.model, training.fit(data, best).model)
    path, late = tmp_path / "checkpoint", whole.history[-1]["step"] - 7
    with pytest.raises(KeyboardInterrupt), after_steps(lambda step: step == late and interrupt()):
        training.fit(data, config, path)
    for _ in range(2):  # the second time it is finished already
        resumed = training.fit(data, config, path)
        assert same_weights(whole.model, resumed.model)
        assert [row["held_out"] for row in resumed.history] == errors
    with refusal("to resume differs in patience: expected 4, got 3"):
        training.fit(data, replace(config, patience=4), path)
    with refusal(r"held_out=0\.0001 leaves none of these data"):
        fit(patience=3, held_out=1e-4)


def test_the_rate_decays_on_a_cosine(monkeypatch):
    rates, step = [], loop.step
    monkeypatch.setattr(loop, "step", lambda *all_: rates.append(all_[-1]) or step(*all_))
    fit(steps=25)
    expected = [1e-3 * (0.1 + 0.9 * (1 + math.cos(math.pi * n / 25)) / 2) for n in range(25)]
    assert rates == pytest.approx(expected)


def test_what_cannot_be_resumed_is_named(tmp_path):
    data, path = waves(), tmp_path / "run.checkpoint"
    training.fit(data, QUICK, path)
    for other, config, why in (
        (data, quick(seed=1), "the run to resume differs in seed: expected 1, got 0"),
        (waves(joints=5), QUICK, "the layout is not the expected one: its joints differ"),
        (waves(frames=800), QUICK, "the run to resume had other data"),
    ):
        with refusal(f"run.checkpoint: {why}"):
            training.fit(other, config, path)
    with refusal(r"expected 'run' in it, got checkpoint, model"):
        training.load(path)
    training.fit(waves(joints=5), QUICK, path, resume=False)


@pytest.fixture(scope="module")
def parts(tmp_path_factory):
    """Tensors and numbers of a checkpoint of a run with patience."""
    path = tmp_path_factory.mktemp("whole") / "checkpoint"
    fit(path, steps=6, patience=9, evaluate_every=3)
    return model_files.read(path, "checkpoint")


FIRST, BEST = "adam.model.0.exp_avg", "best.experts.layers.0.weight"


@pytest.mark.parametrize(("name", "value", "why"), [  # of a tensor, or of the run's numbers
    (FIRST, lambda t: t[:1], "differs in tensor 0.exp_avg"),
    (FIRST, lambda t: t * math.nan, f"{FIRST} has numbers that are not finite"),
    ("adam.model.3.step", lambda t: t * 0, "parameter 3 has a step below 1 or a negative"),
    (BEST, lambda t: t[:, 1:], "differs in tensor experts.layers.0.weight"),
    ("step", lambda _: 10**18, "its step is 1000000000000000000 after"),
    ("losses", lambda _: {"loss": None}, "its losses is {'loss': None}"),
    ("step", lambda _: 7, "the moments of Adam are those of step 6"),
])
def test_a_checkpoint_that_does_not_fit_the_run_is_refused(tmp_path, parts, name, value, why):
    """The fused Adam reads and writes outside of moments that are too small."""
    tensors, numbers = dict(parts[0]), dict(parts[1]["checkpoint"])
    path, config = tmp_path / "checkpoint", quick(steps=6, patience=9, evaluate_every=3)
    part = numbers if name in numbers else tensors
    part[name] = value(part[name])
    model_files.write(path, tensors, {"model": parts[1]["model"],
                                      "checkpoint": {"config": config.fixed()} | numbers})
    with refusal(re.escape(why)) as error:
        training.fit(waves(), config, path)
    assert str(error.value).startswith(str(path))


def test_a_saved_run_is_whole(tmp_path, straight, monkeypatch):
    path = tmp_path / "run.safetensors"
    monkeypatch.setattr(straight.model, "lift", 1.14)
    monkeypatch.setattr(straight.model, "ground", -0.3)  # of data whose floor is below zero
    straight.save(path)
    again = training.load(path)
    assert same_weights(straight.model, again.model)
    assert (again.model.lift, again.model.life, again.model.ground) == (1.14, 0.0, -0.3)
    assert (again.config, course(again)) == (straight.config, course(straight))
    *rows, overall = again.table()
    assert [*rows, overall] == straight.table()
    assert overall["mean"] == pytest.approx(sum(row["mean"] for row in rows) / 2)
    assert torch.equal(StyleBank.load(path)["style1"], straight.bank["style1"])
    whole = path.stat().st_size
    straight.save(path, slim=True)
    slim = training.load(path)
    assert path.stat().st_size < whole
    assert slim.model.modulation.generator is None
    apart = slim.model.experts.layers[0].weight - straight.model.experts.layers[0].weight
    assert 0 < apart.detach().abs().max() < 1e-3


@pytest.mark.parametrize(("changes", "match"), [
    ({"epochs": 1, "steps": 1}, "one of epochs, steps and seconds, got epochs and steps"),
    ({"held_out": 1.0}, r"held_out must be a number from 0 to 0\.99, got 1\.0"),
    ({"patience": 0}, r"patience must be a whole number from 1 to 1e\+30, got 0"),
    ({"seconds": math.nan}, r"seconds must be a number from 1e-30 to 1e\+30, got nan"),
    ({"batch": None}, "batch must be a whole number from 1"),
    ({"batch": 4, "clips_per_batch": 5}, "clips_per_batch must be at most the 4 frames of a mini"),
    ({"steps": 2.5}, r"steps must be a whole number from 1 to 1e\+30, got 2\.5"),
])
def test_impossible_configs(changes, match):
    with refusal(match):
        Config(**changes)


def test_unknown_style_patience_and_divergence_are_named():
    with refusal("unknown style 'style9'; close to it"):
        fit(styles=("style9",))
    with refusal(r"patience needs held-out frames; held_out=0\.0"):
        fit(patience=1, held_out=0.0)
    with refusal("training diverged at step"):
        fit(rate=1e30, max_gradient=None)


def test_the_recorded_model_lies_beside_the_package(tmp_path, monkeypatch):
    assert {"proud", "tired", "normal"} <= set(tk.pretrained("recorded").bank)
    with refusal("no model 'real': procedural or recorded"):
        tk.pretrained("real")
    monkeypatch.setattr("toolkit.training.run.RECORDED", tmp_path / "recorded.safetensors")
    with pytest.raises(FileNotFoundError, match=r"it is in the repository.*has the command"):
        tk.pretrained("recorded")
