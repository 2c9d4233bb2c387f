"""The steps of a foot and the phase that they give; phases that a person labelled, and those labelled in the same way."""

import math
import re

import numpy as np
import pytest
import torch

import toolkit as tk
from experiments import phases as experiment
from toolkit.datasets import procedural
from toolkit.evaluation import phases as labels
from toolkit.phases import Steps, steps

FPS = 60.0


def curve(*lengths, first=1.0):
    """A 0/1 curve of runs of the given lengths."""
    values = [first if i % 2 == 0 else 1 - first for i in range(len(lengths))]
    return torch.tensor(values, dtype=torch.float64).repeat_interleave(torch.tensor(lengths))


def degrees(signal):
    return np.degrees(np.unwrap(signal.angle().numpy()))


def test_in_a_regular_walk_the_angle_is_a_clock_from_one_stance_to_the_next():
    signal = steps.signal(curve(5, 8, 12, 8, 12, 8, 12, 8, 4))  # stances are 0.6 of the cycle
    assert torch.allclose(signal.abs(), torch.ones(77, dtype=torch.float64))
    clock = torch.exp(2j * math.pi * (torch.arange(77, dtype=torch.float64) - 18.5) / 20)  # 18.5: middle of the first stance
    assert float((signal - clock).abs().max()) < 1e-9


@pytest.mark.parametrize("first", [0.0, 1.0])
def test_every_step_is_counted_however_irregular(first):
    lengths = (6, 7, 9, 11, 13, 7, 13, 5)
    angle = degrees(steps.signal(curve(*lengths, first=first)))
    edges = np.cumsum((0, *lengths))
    inner = range(1, len(lengths) - 1)
    middle = {i: (edges[i] + edges[i + 1] - 1) / 2 for i in inner}
    for i in inner:
        beside = np.mean([lengths[j] for j in (i - 1, i + 1) if j in inner])
        stands = (i % 2 == 0) == (first == 1)
        share = (lengths[i] if stands else beside) / (lengths[i] + beside)
        expected = (0 if stands else 180) + 60 * (share - 0.6)
        assert math.remainder(np.interp(middle[i], range(len(angle)), angle) - expected, 360) == pytest.approx(0, abs=1e-6)
    assert (np.diff(angle) > 0).all()
    assert np.ptp(np.interp([middle[1], middle[6]], range(len(angle)), angle)) == pytest.approx(5 * 180, abs=30)


def test_a_foot_that_stands_on_holds_its_phase_and_goes_on_as_before():
    angle = degrees(steps.signal(curve(6, 8, 12, 8, 112, 8, 12, 8, 6)))
    waiting = np.diff(angle)[34 + 10 : 34 + 100]
    assert np.abs(waiting).max() < 1e-9
    before, after = angle[:40], angle[-40:]
    assert np.diff(before).min() > 10  # 360° in about 20 frames, all the way to the ends
    assert np.diff(after).min() > 10
    assert angle[-1] - angle[0] == pytest.approx(360 + 18 * (179 - 96 - 24), abs=40)


@pytest.mark.parametrize("end", [(5,), (8, 5)])
def test_after_a_last_long_stand_the_angle_goes_on_at_the_rate_of_a_step(end):
    rates = np.diff(degrees(steps.signal(curve(6, 8, 12, 8, 12, 8, 112, *end))))
    assert np.abs(rates[-100:-30]).max() < 1e-9
    assert (rates[-12:] > 10).all()
    assert (rates[-12:] < 20).all()


@pytest.mark.parametrize("values", [curve(10, 10, 10), curve(50), 0.5 * curve(5, 5, 5, 5, 5), torch.zeros(20)])
def test_other_curves_and_fewer_than_three_changes_give_no_signal(values):
    assert steps.signal(values) is None


def disturbed(clip):
    """The clip with what recordings have, by name."""
    frames = len(clip)
    noise = 1e-3 * torch.randn(frames, 3, generator=torch.Generator().manual_seed(0))
    spikes = torch.zeros(frames, 3)
    spikes[100::250] = 0.4
    seconds = torch.arange(frames)[:, None] / clip.fps
    drift = 3 + 0.03 * seconds * torch.tensor([0.0, 1.0, 0.0])
    slide = 0.1 * seconds * torch.tensor([1.0, 0.0, 0.0])
    moves = {"noise": noise, "spikes": spikes, "drift of the floor": drift, "sliding": slide}
    return {name: clip.replace(root_positions=clip.root_positions + move) for name, move in moves.items()}


@pytest.mark.parametrize("style", ["Neutral", "Crouch", "HighKnees", "Tiptoe"])
def test_stances_are_the_true_ones_on_any_floor_in_noise_and_while_sliding(style):
    clip, known = procedural.truth(style, "FW", 12.0, 4)
    for what, other in {"itself": clip, **disturbed(clip)}.items():
        found = torch.stack([Steps()(other, f"{side}_foot") for side in ("right", "left")], 1)
        assert found.dtype == clip.rotations.dtype
        found, true = found[30:-30], known.contacts[30:-30]
        assert float((2 * (found * true).sum(0) / (found + true).sum(0)).min()) > 0.91, what
        assert torch.equal(found.diff(dim=0).gt(0).sum(0), true.diff(dim=0).gt(0).sum(0)), what


def test_stances_do_not_depend_on_the_unit_the_place_or_the_side(walk_clip):
    right = Steps()(walk_clip, "right_foot")
    skeleton = walk_clip.skeleton
    large = walk_clip.replace(skeleton=type(skeleton)(skeleton.names, skeleton.parents, 100 * skeleton.offsets,
                                                      roles=skeleton.roles, ends=skeleton.ends),
                              root_positions=100 * walk_clip.root_positions)
    assert torch.equal(Steps()(large, "right_foot"), right)
    assert torch.equal(Steps()(walk_clip.moved(turn=2.0, shift=(3.0, 5.0, -1.0)), "right_foot"), right)
    assert torch.equal(Steps()(walk_clip.mirrored(), "left_foot"), right)
    assert float(Steps()(walk_clip, "left_hand").abs().max()) == 0
    assert float(Steps()(walk_clip.cut(0, 1), "left_foot").abs().max()) <= 1
    slow = Steps()(walk_clip.resample(12), "right_foot")  # no filter is shorter than a frame
    assert float((slow - right[::5][: len(slow)]).abs().mean()) < 0.1


def test_a_limb_is_as_long_as_its_bones(walk_clip):
    skeleton = walk_clip.skeleton
    left, right = (steps.limb_length(skeleton, f"{side}_foot") for side in ("left", "right"))
    assert 0.9 < left < 1.2
    assert right == pytest.approx(left)
    assert 0.4 < steps.limb_length(skeleton, "left_hand") < 0.8
    mixed = type(skeleton)(skeleton.names, skeleton.parents, skeleton.offsets, ends=skeleton.ends,
                           roles={**skeleton.roles, "left_hip": skeleton.roles["right_hip"]})
    with pytest.raises(ValueError, match=r"left_foot: 0 m of bones from .*; check the roles"):
        steps.limb_length(mixed, "left_foot")


@pytest.mark.parametrize("gait", ["FW", "SW", "ID", "TR1"])
def test_a_raised_foot_never_stands(gait):
    clip = procedural.generate("HopLeft", gait, 10.0, 2)
    assert float(Steps()(clip, "right_foot").max()) == 0
    assert float(Steps()(clip, "left_foot").mean()) > 0.3
    assert tk.phases.Hybrid().choice(clip, "right_foot") == "contact-free"


def test_phases_of_the_steps_follow_starts_stops_turns_and_runs():
    """Labels by the rule of a person's, from true contacts; other seeds than those of `python -m experiments phases`."""
    old, new, floors = [], [], []
    for style, seed in (("Neutral", 11), ("Old", 12), ("Zombie", 13), ("BigSteps", 14), ("Drunk", 15)):
        take = labels.planned(style, "TR1", 20.0, seed)
        old.append(labels.errors(take, "contact"))
        new.append(labels.errors(take, "hybrid"))
        floors.append(labels.floor(take))
    old, new, floors = (torch.stack(rows) for rows in (old, new, floors))
    assert float(new.max()) < 20
    assert float((new - floors).max()) < 12
    assert float(new.mean()) < 0.85 * float(old.mean())


def test_drift_noise_and_spikes_do_not_change_the_phase():
    take = labels.planned("Neutral", "TR1", 20.0, 21)
    for clip in disturbed(take.clip).values():
        other = labels.Take(clip, take.right, take.left, take.moving)
        assert float(labels.errors(other, "hybrid").max()) < 18


def test_a_label_is_straight_between_the_touch_downs_of_both_feet():
    clip = procedural.generate("Neutral", "FW", 2.0)
    everything = torch.ones(len(clip), dtype=torch.bool)
    take = labels.Take(clip, torch.tensor([20, 60, 80]), torch.tensor([30, 100]), everything)
    expected = np.interp(np.arange(120), (20, 30, 60, 80, 100), np.pi * np.array([0, 1, 2, 4, 5]))  # two right steps in turn
    assert take.label.numpy() == pytest.approx(expected)
    assert take.labelled.nonzero()[:, 0].tolist() == list(range(20, 100))
    assert labels.Take(clip, take.left, take.right, everything).label[20] == math.pi  # a left step begins
    even = labels.Take(clip, torch.tensor([10, 50, 90]), torch.tensor([30, 70, 110]), everything)
    assert float(labels.floor(even).max()) < 1e-6
    assert float(labels.floor(take).max()) > 5


def test_damaged_labels_are_one_line(tmp_path, walk_clip):
    with pytest.raises(ValueError, match=r"no NAME_footsteps\.txt"):
        labels.read(tmp_path)
    tk.bvh.save(walk_clip, tmp_path / "a.bvh")
    steps_file, gait = tmp_path / "a_footsteps.txt", tmp_path / "a.gait"
    steps_file.write_text("10 30\n50 70\n90\n")
    np.savetxt(gait, np.zeros((len(walk_clip), 8)))
    (take,) = labels.read(tmp_path)
    assert take.right.tolist() == [9, 49, 89]
    assert take.left.tolist() == [29, 69]
    for file, text in ((gait, "1 2\n"), (gait, "x"), (steps_file, "10 x\n"), (steps_file, "1 2 3\n"), (steps_file, "7\n")):
        kept = file.read_text()
        file.write_text(text)
        with pytest.raises(ValueError, match=r"a_footsteps\.txt: ") as error:
            labels.read(tmp_path)
        assert "\n" not in str(error.value)
        file.write_text(kept)


def test_labelled_recordings_are_followed(shared):
    """Holden et al. 2017: every take in the folder, as it is, mirrored, at other rates and in parts of it."""
    folder = shared / labels.NAME
    if not folder.is_dir():
        pytest.skip(f"needs {folder}")
    for take in labels.read(folder):
        error, floor = labels.errors(take, "hybrid"), labels.floor(take)
        assert float(error.max()) < 20
        assert float((error - floor).max()) < 10
        assert float(error.mean()) < float(labels.errors(take, "contact").mean()) - 3
        mirrored = labels.Take(take.clip.mirrored(), take.left, take.right, take.moving)
        assert torch.allclose(labels.errors(mirrored, "hybrid"), error.flip(0), atol=0.5)
        for fps in (30.0, 60.0):
            clip = take.clip.resample(fps)
            every = round(take.clip.fps / fps)
            slow = labels.Take(clip, take.right / every, take.left / every, take.moving[::every][: len(clip)])
            assert float(labels.errors(slow, "hybrid").max()) < 20


def test_the_experiment_prints_the_labelled_takes_there_are(tmp_path, monkeypatch, capsys, walk_clip):
    monkeypatch.setenv("TOOLKIT_DATA", str(tmp_path))
    monkeypatch.setattr(experiment, "PLANNED", ("Neutral",))
    options = {"styles": "Neutral", "gaits": "FW", "seconds": 8.0, "seed": 0, "source": "hybrid,contact"}
    experiment.run(**options, labelled=None)
    printed = capsys.readouterr().out
    assert "no labelled recordings" in printed
    assert re.search(r"Neutral TR1 +right +\d+ +\d+\.\d° +\d+\.\d° +\d+\.\d°\n", printed)
    folder = tmp_path / labels.NAME
    folder.mkdir()
    tk.bvh.save(walk_clip.replace(name="b"), folder / "b.bvh")
    (folder / "b_footsteps.txt").write_text("61 91\n121 151\n181 211\n241\n")
    np.savetxt(folder / "b.gait", np.zeros((len(walk_clip), 8)))
    experiment.run(**options, labelled=None)
    assert re.search(r"b\.bvh +right +180 +0\.0° ", capsys.readouterr().out)


def test_the_feet_of_recorded_runs_and_turns_stay_half_a_cycle_apart(shared):
    """Without labels: feet alternate, so a lost or an invented step shows as feet in the same phase."""
    if not (shared / "bandai").is_dir():
        pytest.skip(f"needs {shared / 'bandai'}")
    together = {"contact": [], "hybrid": []}
    for gait in ("dash", "run", "walk-left", "walk-back"):
        for clip in tk.datasets.load("bandai", shared / "bandai", styles=["active", "masculinity"], gaits=gait)[:4]:
            for source, shares in together.items():
                phase = tk.phases.extract(clip, source).phase
                shares.append(float(((phase[:, 2] - phase[:, 3]).cos() > 0).double().mean()))
    assert max(together["hybrid"]) < 0.05
    assert np.mean(together["contact"]) > 0.02


def test_touch_downs_and_not_the_definition_are_the_error_at_the_end_of_the_recording(shared):
    """docs/phase_sources.md: straight lines between our touch-downs have the label's definition, and as large an error."""
    folder = shared / labels.NAME
    if not folder.is_dir():
        pytest.skip(f"needs {folder}")
    last = {what: errors[2] for what, errors in experiment.thirds(labels.read(folder)[0]).items()}
    own = last["straight between our touch-downs"]
    assert float((own - last["straight between labelled touch-downs"]).min()) > 8
    assert abs(float(own[1] - last["hybrid"][1])) < 4
