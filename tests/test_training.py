import ctypes
import dataclasses
import json
import math
import os
import random
import re
import signal
import subprocess
import sys
from pathlib import Path

import pytest
import torch
from test_networks import TINY, tiny_model, tree

import toolkit as tk
from toolkit import networks, training
from toolkit.features import Features, splits
from toolkit.styles import StyleBank
from toolkit.training import Config, loss, minibatches


def waves(joints: int = 4, styles: int = 2, frames: int = 700) -> Features:
    """Something to learn: every column a wave of time, whose shape the style changes."""
    layout = tree(joints)
    generator = torch.Generator().manual_seed(0)
    parts: dict[str, dict[str, torch.Tensor]] = {kind: {} for kind in ("inputs", "phases", "outputs", "clips", "takes")}
    rates = 0.1 * torch.randint(1, 4, (1, layout.n_inputs), generator=generator)
    starts = 6 * torch.rand(1, layout.n_inputs, generator=generator)
    mixing = torch.randn(layout.n_inputs, layout.n_outputs, generator=generator) / 10
    for i in range(styles):
        n = frames + 50 * i
        t = torch.arange(n)[:, None]
        x = torch.sin(rates * t + starts + i)
        p = torch.cat([torch.sin(t * 0.1 + k) for k in range(8)], 1)
        z = x @ mixing * (1 + i) + torch.sin(t * 0.1)
        columns = z[:, layout.outputs["joints"]]
        values = (x, p, z, columns.unfold(0, 240, 120).transpose(1, 2).contiguous(), (torch.arange(n) >= 400).long())
        for kind, value in zip(parts, values, strict=True):
            parts[kind][f"style{i}"] = value
    return Features(layout, **parts)


WIDER = dataclasses.replace(TINY, hidden=64, dropout=0.05)
QUICK = Config(sizes=TINY, steps=12, batch=16, clips_per_batch=4, evaluate_every=5,
               rate=1e-3, final_rate=0.1, max_gradient=1.0, pose_mixup=0.2, refit=0)


SCRIPT = """
import dataclasses, json, os, sys
import torch
from test_training import QUICK, waves
from toolkit import training
from toolkit.training import distributed

if __name__ == "__main__":
    torch.set_num_threads(1)
    losses = []
    done = lambda step, loss: losses.append(loss) or print(step, flush=True)
    config = training.Config.from_json(json.loads(sys.argv[1]))
    run = training.fit(waves(), config, sys.argv[2], on_step=done)
    if distributed.first():
        run.save(sys.argv[3])
        with open(sys.argv[3] + ".json", "w") as file:
            json.dump(losses, file)
"""


def script(folder: Path, config: Config, *launcher: str) -> subprocess.Popen:
    """Starts a training of `waves` in a process of its own, with its checkpoint and run in the folder."""
    (folder / "train.py").write_text(SCRIPT)
    paths = os.pathsep.join(str(Path(__file__).parents[i]) for i in (0, 1))
    call = [sys.executable, *launcher, str(folder / "train.py"), json.dumps(dataclasses.asdict(config)),
            str(folder / "checkpoint"), str(folder / "run.safetensors")]
    settings = {"PYTHONPATH": paths, "PYTHONWARNINGS": "error", "OMP_NUM_THREADS": "1"}
    return subprocess.Popen(call, env=os.environ | settings, stdout=subprocess.PIPE, text=True)


def same_weights(a: networks.Model, b: networks.Model) -> bool:
    return all(torch.equal(x, y) for x, y in zip(a.state_dict().values(), b.state_dict().values(), strict=True))


def test_minibatches_cycle_through_styles_and_frames():
    data = waves(styles=3)
    batches = minibatches.Minibatches(data, 32, 2, seed=4)
    assert batches.steps_per_epoch == 3 * (700 // 32)
    seen = []
    for turn in range(700 // 32):
        for which, style in enumerate(data.styles):
            x, p, z, y = batches[3 * turn + which]
            rows = [int((data.inputs[style] == row).all(1).nonzero()) for row in x]
            assert torch.equal(data.outputs[style][rows], z)
            assert torch.equal(data.phases[style][rows], p)
            assert y.shape == (2, 240, data.layout.n_clip)
            seen += rows if which == 0 else []
    assert len(set(seen)) == len(seen) == 32 * (700 // 32)
    again = minibatches.Minibatches(data, 32, 2, seed=4)
    assert all(torch.equal(a, b) for step in (50, 3, 64) for a, b in zip(again[step], batches[step], strict=True))
    assert not torch.equal(minibatches.Minibatches(data, 32, 2, seed=5)[3][0], batches[3][0])


def test_only_poses_stray_and_only_towards_others():
    data = waves(styles=3)
    plain, strayed = minibatches.Minibatches(data, 64, 1, 4), minibatches.Minibatches(data, 64, 1, 4, pose_mixup=0.5)
    joints = data.layout.inputs["joints"]
    (x, *rest), (moved, *same) = plain[7], strayed[7]
    assert all(torch.equal(a, b) for a, b in zip(rest, same, strict=True))
    assert torch.equal(x[:, : joints.start], moved[:, : joints.start])
    changed = (x != moved).any(1)
    assert 0.3 < float(changed.float().mean()) < 0.7
    poses = torch.cat([data.inputs[s][:, joints] for s in data.styles])
    pose, way = x[changed][0, joints], (moved - x)[changed][0, joints]
    others = poses - pose
    share = (others @ way) / others.square().sum(1)  # along the way to some frame, by less than all of it
    assert bool((((share[:, None] * others - way).abs().amax(1) < 1e-5) & (share > 0) & (share < 1)).any())
    assert torch.equal(strayed[7][0], moved)


def test_held_out_frames_are_windows_apart_from_the_training_frames():
    data = waves()
    train, test = splits.split(data, 0.2, 0, ("style1", "style0"))
    assert train.styles == ["style1", "style0"]
    for style in data.styles:
        n = len(data.inputs[style])
        assert len(test.inputs[style]) == round(0.2 * n)
        assert len(train.inputs[style]) + len(test.inputs[style]) == n
        where = torch.tensor([int((data.inputs[style] == row).all(1).nonzero()) for row in test.inputs[style]])
        assert int((where.diff() > 1).sum()) <= 2
        assert not (where[:, None] == torch.tensor([0])).all()


def test_a_style_holds_out_the_same_frames_whichever_others_there_are():
    data = waves(frames=3000, styles=4)
    whole = splits.held_out(data, 0.1, 0, tuple(data.styles))
    for some in (("style2",), ("style3", "style1", "style2")):
        for style, rows in splits.held_out(data, 0.1, 0, some).items():
            assert torch.equal(rows, whole[style])
    assert len({tuple(rows[:3000].tolist()) for rows in whole.values()}) == 4  # a stream for each
    assert splits.mix(3, "Zombie") == 691408046533145781  # on every machine


def poses(rows):
    """The joints' heights in frames of joint features ``[..., 12 J]``: the same in a motion and in its mirror image."""
    heights = rows.unflatten(-1, (-1, 12))[..., 1].flatten(0, -2)
    return {tuple(row) for row in (1e5 * heights.sort(-1).values).round().long().tolist()}


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("clips", [
    {"seconds": 30.0, "gaits": ["FW"], "mirror": True}, {"seconds": 9.0, "gaits": ["FW", "FR", "TR1"], "mirror": False},
    {"seconds": 8.0, "gaits": ["FW"], "mirror": False},  # no whole style clip is free: its longest stretch is repeated
])
def test_style_clips_of_a_training_share_no_frame_with_what_is_held_out(clips, seed):
    made = tk.datasets.load("procedural", styles=["Zombie"], gaits=clips["gaits"], seconds=clips["seconds"])
    data = tk.features.build(made, mirror=clips["mirror"])
    train, test = splits.split(data, 0.1, seed, ("Zombie",))
    joints = data.layout.inputs["joints"]
    shown = poses(train.clips["Zombie"])
    windows = test.frames["Zombie"][:, None] + torch.arange(-60, 52)
    near = poses(data.inputs["Zombie"][torch.isin(data.frames["Zombie"], windows)][:, joints])
    assert len(near) > 60
    assert poses(data.clips["Zombie"]) & near  # some clips of the data do
    assert not shown & near
    assert train.clips["Zombie"].shape[1:] == data.clips["Zombie"].shape[1:]
    learnt = poses(train.inputs["Zombie"][:, joints])
    assert not learnt & poses(test.inputs["Zombie"][:, joints])  # nor is a mirror image of a held-out frame learnt
    frames = train.frames["Zombie"], test.frames["Zombie"]
    assert (frames[0][:, None] - frames[1]).abs().min() == 112  # the windows share no frame, and none is left out needlessly
    assert len(frames[1]) == round(0.1 * len(data.inputs["Zombie"]))
    neither = len(data.inputs["Zombie"]) - sum(map(len, frames))
    assert 0 < neither <= 2 * 111 * (1 + clips["mirror"]) * len(made) * math.ceil(len(frames[1]) / 240)
    assert torch.equal(splits.split(data, 0.1, seed, ("Zombie",))[0].clips["Zombie"], train.clips["Zombie"])


def test_a_style_too_short_for_clips_of_its_own_is_doubted():
    data = tk.features.build(tk.datasets.load("procedural", styles=["Zombie"], gaits=["FW"], seconds=2.5))
    with pytest.warns(UserWarning, match="style 'Zombie' is too short to hold out frames") as doubts:
        train, test = splits.split(data, 0.1, 0, ("Zombie",))
    assert len(doubts) == 2  # its frames, and its style clips
    assert torch.equal(train.clips["Zombie"], data.clips["Zombie"])
    assert len(train.inputs["Zombie"]) + len(test.inputs["Zombie"]) == len(data.inputs["Zombie"])


def test_features_of_a_list_have_its_parts():
    clips = tk.datasets.load("procedural", styles=["Zombie", "Neutral", "Old"], gaits=["FW", "FR"], seconds=12.0)
    block = tk.datasets.blocks.Block
    parts = tk.datasets.blocks.Split("made", [block("Zombie", "FW", 100, 400), block("Zombie", "FR", 10, 700),
                                              block("Neutral", "FW", 0, 720), block("Neutral", "FR", 0, 720)],
                                     [block("Zombie", "FR", 800, 820)], [block("Zombie", "FW", 520, 9999),
                                     block("Old", "FW", 0, 720)], unseen=("Old",))
    data = splits.listed(clips, parts)
    assert data.styles == ["Neutral", "Zombie"]
    for share, seed in ((0.1, 0), (0.3, 5)):  # which do not matter
        train, test = splits.split(data, share, seed, ("Zombie", "Neutral"))
        assert {s: len(x) for s, x in test.inputs.items()} == {"Zombie": 720 - 420 - 112 + 1, "Neutral": 0}
        assert len(train.inputs["Zombie"]) == 300 + 690 - 2 * 111
    joints, walk = data.layout.inputs["joints"], next(c for c in clips if (c.style, c.gait) == ("Zombie", "FW"))
    last = tk.features.build(walk.cut(420, 720))  # block 520: the clip begins where the first block of its take begins
    torch.testing.assert_close(test.inputs["Zombie"][:, joints], last.inputs["Zombie"][:, joints])
    assert not poses(train.inputs["Zombie"][:, joints]) & poses(test.inputs["Zombie"][:, joints])
    assert not poses(train.clips["Zombie"]) & poses(test.inputs["Zombie"][:, joints])
    run = training.fit(data, dataclasses.replace(QUICK, steps=2, clips_per_batch=1))
    assert run.held_out.keys() == {"Zombie"}
    with pytest.raises(ValueError, match=r"Neutral.*: the split of made has no block of this take"):
        splits.listed(clips, dataclasses.replace(parts, train=parts.train[:2]))
    with pytest.raises(ValueError, match="none of these clips is in the training part"):
        splits.listed([c for c in clips if c.style == "Old"], parts)


def test_takes_of_bandai_are_found_in_their_list(shared):
    root = shared / "bandai" / "dataset-2"
    if not root.is_dir():
        pytest.skip(f"no recordings: {root} does not exist")
    parts = tk.datasets.split("bandai", root)
    clips = tk.datasets.load("bandai", root, styles=["active"], gaits=["run"])
    data = splits.listed(clips, parts)
    train, test = splits.split(data, 0.1, 0, ("active",))
    wanted = {part: {block.gait for block in getattr(parts, part)} for part in ("train", "test")}
    names = [c.name.removesuffix(".bvh") for c in clips if c.name.removesuffix(".bvh") in wanted["train"] | wanted["test"]]
    assert {names[i] for i in train.takes["active"].tolist()} <= wanted["train"]
    assert {names[i] for i in test.takes["active"].tolist()} <= wanted["test"]


@pytest.mark.skipif(not hasattr(ctypes.CDLL(None) if sys.platform == "linux" else None, "mallopt"), reason="not glibc")
def test_a_step_gets_the_memory_of_the_step_before():
    """In a process of its own: a failed allocation in an earlier test can give the main thread another arena of glibc."""
    code = """
import resource, torch
from toolkit.training import loop
def faults():
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    for _ in range(4):
        torch.full((1 << 24,), 1.0)  # 64 MB
    return resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before
with loop.reused_memory():
    kept = min(faults() for _ in range(4))
print(kept, max(faults() for _ in range(2)))
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    kept, fresh = map(int, done.stdout.split())
    assert 4 * kept < fresh


def test_loss_is_mse_and_bone_length_of_equation_5():
    model = tiny_model()
    predicted, target = torch.randn(3, 2, model.layout.n_outputs).unbind(1)
    mse, bone = loss.loss_terms(model, predicted, target)
    torch.testing.assert_close(mse, ((predicted - target) ** 2).mean())
    total = 0.0
    for n in range(3):
        a, b = (model.normaliser("outputs").invert(z[n]) for z in (predicted, target))
        a, b = (z[24 : 24 + 48].reshape(4, 12)[:, :3] for z in (a, b))
        total += sum(abs(float((a[j] - a[j - 1]).norm() - (b[j] - b[j - 1]).norm())) for j in (1, 2, 3)) / 3
    assert float(bone) == pytest.approx(total / 3, rel=1e-5)


def test_it_overfits_one_minibatch():
    data = waves(styles=1)
    one = dataclasses.replace(data, **{kind: {"style0": getattr(data, kind)["style0"][:16]}
                                       for kind in ("inputs", "phases", "outputs", "takes")})
    config = Config(sizes=dataclasses.replace(WIDER, dropout=0.0), steps=300, batch=16, clips_per_batch=1,
                    rate=3e-3, final_rate=0.01, max_gradient=1.0, held_out=0.0, bone_weight=0.1)
    run = training.fit(one, config)
    assert run.history[-1]["mse"] < 1e-3
    assert run.held_out == run.baselines == {}
    assert run.history[-1]["held_out"] is None


def test_it_learns_more_than_both_baselines():
    run = training.fit(waves(), dataclasses.replace(QUICK, steps=600, sizes=WIDER, evaluate_every=100))
    *styles, overall = run.table()
    assert [row["style"] for row in styles] == ["style0", "style1"]
    for row in (*styles, overall):
        assert row["error"] < 0.5 * min(row["mean"], row["repeat"], row["other"])
    assert run.bank.names == ("style0", "style1")
    assert run.bank.vectors.shape == (2, 256)
    assert [row["step"] for row in run.history] == list(range(100, 601, 100))


def test_repeating_the_frame_keeps_pose_trajectory_and_phases():
    layout = tree(4)
    x, p = torch.randn(2, layout.n_inputs), torch.randn(2, 8)
    z = layout.unpack_output(loss.repeat_frame(layout, x, p, torch.full((layout.n_outputs,), 0.25)))
    assert torch.equal(z["joints"], x[:, 48:])
    assert torch.equal(z["trajectory"], x[:, 24:48])  # the current and the five future of twelve samples
    assert torch.equal(z["phases"], p)
    assert float(z["phase_updates"].abs().max()) == 0
    assert bool((z["contacts"] == 0.25).all())


@pytest.mark.parametrize(("stop_at", "held_out"), [(1, 0.1), (5, 0.1), (7, 0.1), (12, 0.1), (11, 0.0)])
def test_stopped_and_resumed_equals_not_stopped(tmp_path, stop_at, held_out):
    data, path, config = waves(), tmp_path / "run.checkpoint", dataclasses.replace(QUICK, held_out=held_out)
    straight = training.fit(data, config)

    def stop(step: int, _: float) -> None:
        if step == stop_at:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        training.fit(data, config, path, on_step=stop)
    torch.rand(7)  # what else happens to the global generator does not matter
    resumed = training.fit(data, config, path)
    assert same_weights(straight.model, resumed.model)
    assert torch.equal(straight.bank.vectors, resumed.bank.vectors)
    assert [(r["step"], r["loss"], r["held_out"]) for r in resumed.history] == \
           [(r["step"], r["loss"], r["held_out"]) for r in straight.history]
    assert [p.name for p in tmp_path.iterdir()] == ["run.checkpoint"]


def test_training_leaves_the_global_generator_alone():
    torch.manual_seed(3)
    expected = torch.rand(4)
    torch.manual_seed(3)
    training.fit(waves(), dataclasses.replace(QUICK, steps=2))
    assert torch.equal(torch.rand(4), expected)


def test_ctrl_c_ends_the_step_and_leaves_a_checkpoint(tmp_path):
    path = tmp_path / "run.checkpoint"
    before = signal.getsignal(signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        training.fit(
            waves(), QUICK, path, on_step=lambda step, _: os.kill(os.getpid(), signal.SIGINT) if step == 3 else None
        )
    assert signal.getsignal(signal.SIGINT) is before
    steps = []
    training.fit(waves(), QUICK, path, on_step=lambda step, _: steps.append(step))
    assert steps in (list(range(4, 13)), list(range(5, 13)))


def test_ctrl_c_after_the_last_step_is_not_forgotten(tmp_path, monkeypatch):
    monkeypatch.setattr(training.loop, "_held_out", lambda *_: os.kill(os.getpid(), signal.SIGINT) or 0.5)
    with pytest.raises(KeyboardInterrupt):
        training.fit(waves(), dataclasses.replace(QUICK, evaluate_every=100), tmp_path / "checkpoint")
    monkeypatch.undo()
    steps = []
    training.fit(waves(), QUICK, tmp_path / "checkpoint", on_step=lambda step, _: steps.append(step))
    assert not steps


def test_killed_at_any_step_and_resumed_equals_not_killed(tmp_path):
    config = dataclasses.replace(QUICK, steps=40, save_every=0.0, patience=3)
    straight = training.fit(waves(), config)
    at = random.Random(5).randrange(2, 30)
    with script(tmp_path, config) as process:
        for line in process.stdout:
            if int(line) == at:
                process.kill()
    assert process.returncode == -signal.SIGKILL
    steps = []
    resumed = training.fit(waves(), config, tmp_path / "checkpoint", on_step=lambda step, _: steps.append(step))
    assert at <= steps[0] <= at + 10
    assert same_weights(straight.model, resumed.model)
    assert [(r["step"], r["loss"]) for r in resumed.history] == [(r["step"], r["loss"]) for r in straight.history]


TORCHRUN = ("-m", "torch.distributed.run", "--nproc-per-node", "2", "--rdzv-backend", "c10d", "--rdzv-endpoint",
            "127.0.0.1:0", "--local-addr", "127.0.0.1")


@pytest.mark.parametrize("launcher", [(), TORCHRUN], ids=["launched", "torchrun"])
def test_two_processes_equal_one(tmp_path, launcher):
    """Dropout, straying poses, clipped gradients, and shares of 8 and 7 frames with 5 clips included."""
    config = dataclasses.replace(QUICK, steps=50, sizes=dataclasses.replace(WIDER, dropout=0.3), batch=15, clips_per_batch=5)
    losses = []
    alone = training.fit(waves(), config, on_step=lambda _, loss: losses.append(loss))
    with script(tmp_path, dataclasses.replace(config, processes=1 if launcher else 2), *launcher) as process:
        process.communicate(timeout=600)
    assert process.returncode == 0
    shared = json.loads((tmp_path / "run.safetensors.json").read_text())
    assert shared != losses  # or it was one process after all
    assert shared == pytest.approx(losses, abs=1e-4)
    together = training.load(tmp_path / "run.safetensors")
    for a, b in zip(alone.model.parameters(), together.model.parameters(), strict=True):
        torch.testing.assert_close(a, b, atol=1e-4, rtol=0)


def test_only_several_processes_need_lightning_fabric(monkeypatch):
    monkeypatch.setitem(sys.modules, "lightning_fabric", None)
    training.distributed._start.cache_clear()
    with pytest.raises(ImportError, match=r'^several processes need the extra "scale": pip install "\.\[scale\]"$'):
        training.fit(waves(), dataclasses.replace(QUICK, processes=2))
    assert len(training.fit(waves(), dataclasses.replace(QUICK, steps=2, precision="bf16")).history) == 1
    with pytest.raises(ValueError, match=r"^1 × 'cuda:99': .+$"):
        training.fit(waves(), dataclasses.replace(QUICK, device="cuda:99"))


def test_it_stops_early_with_the_best_weights_also_after_a_resume(tmp_path):
    config = dataclasses.replace(QUICK, steps=400, sizes=WIDER, rate=3e-2, final_rate=1.0, evaluate_every=5, patience=3)
    straight = training.fit(waves(), config)
    errors = [row["held_out"] for row in straight.history]
    assert len(errors) < 80
    assert min(errors) == errors[-4] < min(errors[-3:])
    best = training.fit(waves(), dataclasses.replace(config, patience=None, steps=straight.history[-4]["step"]))
    assert same_weights(straight.model, best.model)

    def stop(step: int, _: float) -> None:
        if step == straight.history[-1]["step"] - 7:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        training.fit(waves(), config, tmp_path / "checkpoint", on_step=stop)
    for _ in range(2):  # the second time it is finished already
        resumed = training.fit(waves(), config, tmp_path / "checkpoint")
        assert same_weights(straight.model, resumed.model)
        assert [row["held_out"] for row in resumed.history] == errors
    with pytest.raises(ValueError, match="the run to resume differs in patience: expected 4, got 3"):
        training.fit(waves(), dataclasses.replace(config, patience=4), tmp_path / "checkpoint")


def test_patience_with_nothing_held_out_is_refused():
    with pytest.raises(ValueError, match=r"patience needs held-out frames; held_out=0\.0001 leaves none of these data"):
        training.fit(waves(), dataclasses.replace(QUICK, patience=3, held_out=1e-4))


def test_tensorboard_shows_what_was_computed(tmp_path):
    from tensorboard.backend.event_processing.event_accumulator import EventAccumulator

    losses = {}
    config = dataclasses.replace(QUICK, steps=25)
    run = training.fit(waves(), config, log=tmp_path, on_step=lambda step, loss: losses.update({step: loss}))
    events = EventAccumulator(str(tmp_path)).Reload()
    drawn = {name: {e.step: e.value for e in events.Scalars(name)} for name in events.Tags()["scalars"]}
    assert drawn.keys() == {"loss", "mse", "bone", "rate", "held_out"}
    assert drawn["loss"] == pytest.approx({10: losses[10], 20: losses[20]})
    assert drawn["held_out"] == pytest.approx({row["step"]: row["held_out"] for row in run.history})
    assert drawn["rate"][10] > drawn["rate"][20] > 0


def test_bfloat16_trains_nearly_as_well():
    config = dataclasses.replace(QUICK, steps=200, sizes=WIDER)
    exact, coarse = (training.fit(waves(), dataclasses.replace(config, precision=p)) for p in ("32", "bf16"))
    assert all(p.dtype == torch.float32 for p in coarse.model.parameters())
    assert not same_weights(exact.model, coarse.model)
    assert coarse.table()[-1]["error"] == pytest.approx(exact.table()[-1]["error"], rel=0.2)
    assert coarse.table()[-1]["error"] < 0.7 * coarse.table()[-1]["repeat"]


def test_the_bar_shows_loss_and_time_left(capsys, monkeypatch):
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    for budget in ({"steps": 12}, {"steps": None, "seconds": 0.3}):
        training.fit(waves(), dataclasses.replace(QUICK, **budget), progress=True)
        assert re.search(r"loss=\d+\.\d+", said := capsys.readouterr().err)
        assert re.search(r"00:00 left" if "seconds" in budget else r"\[\d\d:\d\d<\d\d:\d\d", said)


def test_what_cannot_be_resumed_is_named(tmp_path):
    data, path = waves(), tmp_path / "run.checkpoint"
    training.fit(data, QUICK, path)
    with pytest.raises(ValueError, match=r"run.checkpoint: the run to resume differs in seed: expected 1, got 0"):
        training.fit(data, dataclasses.replace(QUICK, seed=1), path)
    with pytest.raises(ValueError, match=r"run.checkpoint: the layout differs in joints: expected 5, got 4"):
        training.fit(waves(joints=5), QUICK, path)
    with pytest.raises(ValueError, match=r"run.checkpoint: the run to resume had other data"):
        training.fit(waves(frames=800), QUICK, path)
    with pytest.raises(ValueError, match=r"run.checkpoint: expected a run in it, got checkpoint, model"):
        training.load(path)
    training.fit(waves(joints=5), QUICK, path, resume=False)


def test_a_saved_run_is_whole(tmp_path):
    run = training.fit(waves(), QUICK)
    run.save(tmp_path / "run.safetensors")
    again = training.load(tmp_path / "run.safetensors")
    assert same_weights(run.model, again.model)
    assert (again.config, again.history, again.table()) == (run.config, run.history, run.table())
    assert torch.equal(StyleBank.load(tmp_path / "run.safetensors")["style1"], run.bank["style1"])
    assert same_weights(networks.Model.load(tmp_path / "run.safetensors"), run.model)


def test_time_as_the_budget():
    run = training.fit(waves(), dataclasses.replace(QUICK, steps=None, seconds=0.5))
    assert run.history[-1]["step"] > 1


@pytest.mark.parametrize(("changes", "match"), [
    ({"epochs": 1, "steps": 1}, "one of epochs, steps and seconds, got epochs and steps"),
    ({"seconds": 0}, "seconds must be positive"),
    ({"batch": 8, "clips_per_batch": 9}, "clips_per_batch must be from 1 to batch, got 9 and 8"),
    ({"rate": 0.0}, "rate must be positive"),
    ({"pose_mixup": 2.0}, r"pose_mixup must be in \[0, 1\]"),
    ({"held_out": 1.0}, r"held_out must be in \[0, 1\)"),
    ({"seed": -1}, "seed must not be negative"),
    ({"model": "lpn"}, "unknown model 'lpn'; known: pfnn-onehot, lpn-onehot"),
    ({"evaluate_every": 0}, "evaluate_every must be a whole number from 1, got 0"),
    ({"patience": 0}, "patience must be a whole number from 1"),
    ({"patience": 1, "held_out": 0.0}, "needs held-out frames; got 1 and held_out 0.0"),
    ({"precision": "8"}, "precision must be one of 32, bf16, got '8'"),
    ({"device": "abacus"}, "device must be cpu, cuda, .* got 'abacus'"),
    ({"processes": 33}, "processes must be from 1 to the 32 frames of a minibatch, got 33"),
])
def test_impossible_configs(changes, match):
    with pytest.raises(ValueError, match=match):
        Config(**changes)


def test_unknown_style_and_divergence_are_named():
    with pytest.raises(ValueError, match="unknown style 'style9'; close to it"):
        training.fit(waves(), dataclasses.replace(QUICK, styles=("style9",)))
    with pytest.raises(ValueError, match="2 × 'cuda:99': "):
        training.fit(waves(), dataclasses.replace(QUICK, device="cuda:99", processes=2))
    with pytest.raises(ValueError, match="training diverged at step"):
        training.fit(waves(), dataclasses.replace(QUICK, rate=1e30, max_gradient=None))
