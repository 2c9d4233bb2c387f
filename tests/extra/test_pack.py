"""Looping cycles: where a motion repeats, how it is closed, and packs of them."""

import json
import math

import pytest
import torch

import toolkit as tk
from toolkit.__main__ import main
from toolkit.datasets.procedural import SKELETON
from toolkit.extra.characters import retargeting
from toolkit.extra.engines import loops, pack
from toolkit.motion import rotations as R


@pytest.fixture(scope="module")
def walk() -> tk.Clip:
    clip = tk.datasets.load("procedural", styles=["Neutral"], gaits=["FW"], seconds=10.0)[0]
    return clip.moved(turn=2.0, shift=(5.0, 0.0, 1.0)).cut(150)


@pytest.fixture(scope="module")
def cycle(walk) -> tk.Clip:
    return loops.close(walk, *loops.find(walk, 0.6, 2.0))


@pytest.fixture
def short(monkeypatch) -> None:
    """Half as many seconds of walking before a cycle is cut."""
    monkeypatch.setattr(pack, "SETTLE", 1.5)
    monkeypatch.setattr(pack, "WATCH", 4.0)


def jump(clip: tk.Clip, start: int, frames: int) -> float:
    """Largest distance of a joint from its place a cycle later, before the cycle is closed."""
    local = tk.motion.root_frames(clip).to_local(clip.global_positions)
    return float((local[start + frames] - local[start]).norm(dim=-1).amax())


def test_a_motion_of_known_period_is_cut_there():
    frames, period = 300, 66
    t = 2 * math.pi * torch.arange(frames) / period
    turns = R.identity(frames, len(SKELETON))
    for side, sign in (("Left", 1.0), ("Right", -1.0)):
        turns[:, SKELETON.index(f"{side}Hip")] = R.from_axis_angle(torch.tensor([1.0, 0.0, 0.0]),
                                                                   sign * 0.5 * torch.sin(t))
    root = torch.stack((0.0 * t, torch.full_like(t, 0.95), 1.1 * torch.arange(frames) / 60), 1)
    clip = tk.Clip(SKELETON, turns, root, 60.0)
    start, found = loops.find(clip, 0.6, 2.0)
    assert found == period
    closed = loops.close(clip, start, found)
    torch.testing.assert_close(closed.rotations, clip.rotations[start : start + period + 1],
                               atol=1e-4, rtol=0)
    moved = closed.root_positions[-1] - closed.root_positions[0]
    assert moved[2] == pytest.approx(1.1 * period / 60, abs=1e-3)


def test_a_closed_cycle_has_no_jump_at_its_seam(walk, cycle):
    found = loops.seam(cycle)
    assert found.position < 1e-4
    assert jump(walk, *loops.find(walk, 0.6, 2.0)) > 1e-3
    assert found.velocity <= found.ordinary
    twice = loops.repeated(cycle, 3)
    steps = twice.global_positions.diff(dim=0).norm(dim=-1).amax(-1)
    n = len(cycle) - 1
    assert steps[n - 2 : n + 2].max() < 1.2 * steps.max()
    assert len(twice) == 3 * n
    cut = walk.rotations[loops.find(walk, 0.6, 2.0)[0] :][: len(cycle)]
    moved = (cycle.rotations * cut).sum(-1).abs()
    # it is still that walk
    assert torch.rad2deg(2 * torch.acos(moved[:, 1:].clamp(max=1.0))).max() < 15


def test_cycles_start_at_the_origin_and_go_straight(cycle):
    assert cycle.root_positions[0, [0, 2]].abs().max() < 1e-6
    headings = tk.motion.root_frames(cycle).rotations
    forward = R.rotate(headings, torch.tensor([0.0, 0.0, 1.0])).mean(0)
    assert forward[2] > 0.99
    assert torch.allclose(headings[0], headings[-1], atol=1e-4)
    end = cycle.root_positions[-1]
    assert end[2] > 0.5
    assert abs(float(end[0])) < 0.1 * float(end[2])


def test_in_place_keeps_the_sway_and_comes_back(cycle):
    still = loops.in_place(cycle)
    assert (still.root_positions[-1] - still.root_positions[0]).abs().max() < 1e-5
    assert still.root_positions[:, 0].max() - still.root_positions[:, 0].min() > 0.005
    assert torch.equal(still.rotations, cycle.rotations)


def test_cuts_that_are_not_there_are_refused(walk):
    with pytest.raises(ValueError, match="hold no cycle of 20 to 30 s"):
        loops.find(walk, 20.0, 30.0)
    with pytest.raises(ValueError, match="needs a frame on each side"):
        loops.close(walk, 0, 60)


def test_the_embedded_models_cycles_close(short, tmp_path):
    model, bank = tk.pretrained()
    gaits = ["forward", "left", "idle"]
    made = pack.write(model, bank, tmp_path, {"Mixed": {"Zombie": 0.5, "Old": 0.5}}, gaits=gaits,
                      in_place=True)
    about = json.loads(made.read_text())
    assert about["root_motion"] is False
    assert about["joints"] == list(model.layout.skeleton.names)
    rows = {row["gait"]: row for row in about["clips"]}
    assert rows["forward"]["displacement"][1] > 0
    assert rows["left"]["displacement"][0] > 0
    assert rows["idle"]["speed"] == 0
    assert rows["forward"]["speed"] == pytest.approx(bank.speed({"Zombie": 0.5, "Old": 0.5}),
                                                     rel=0.15)
    for row in about["clips"]:
        error = row["loop_error"]
        assert error["position_cm"] < 0.05
        assert error["velocity_cm_s"] <= 1.1 * error["ordinary_velocity_change_cm_s"] + 1
        clip = tk.bvh.load(tmp_path / row["files"]["bvh"])
        assert len(clip) == row["frames"]
        assert clip.seconds - 1 / 60 == pytest.approx(row["duration"], abs=1e-3)
        assert (clip.root_positions[-1] - clip.root_positions[0]).abs().max() < 1e-3
        assert (tmp_path / row["files"]["glb"]).stat().st_size > 100_000


def test_a_pack_on_another_rig_by_the_command_line(short, tmp_path, capsys):
    """A rig with shorter legs; with root motion."""
    offsets = SKELETON.offsets * torch.tensor([1.0, 0.8, 1.0])
    stands = torch.tensor([[0.0, 0.75, 0.0]]).expand(2, 3)
    other = tk.Clip(tk.Skeleton(SKELETON.names, SKELETON.parents, offsets),
                    R.identity(2, len(SKELETON)), stands, 30.0)
    tk.bvh.save(other, tmp_path / "rig.bvh")
    with pytest.raises(SystemExit) as done:
        main(["export", "pack", "--out", str(tmp_path / "pack"), "--style", "Neutral", "--gaits",
              "forward", "--formats",
              "bvh", "--skeleton", str(tmp_path / "rig.bvh")])
    assert done.value.code == 0
    assert "wrote 1 cycles" in capsys.readouterr().out
    (row,) = json.loads((tmp_path / "pack" / "manifest.json").read_text())["clips"]
    clip = tk.bvh.load(tmp_path / "pack" / row["files"]["bvh"])
    own = tk.bvh.load(tmp_path / "rig.bvh").skeleton
    assert (clip.skeleton.offsets - own.offsets)[1:].abs().max() < 1e-4
    moved = clip.root_positions[-1] - clip.root_positions[0]
    assert moved[2] == pytest.approx(row["displacement"][1], abs=1e-3)
    error = row["loop_error"]
    assert error["velocity_cm_s"] <= 1.1 * error["ordinary_velocity_change_cm_s"]
    assert retargeting.measure(clip).leg < 0.75


@pytest.mark.parametrize(("options", "said"), [
    ({"gaits": ["fly"]}, "one of forward, back, left, right, run, idle; got fly"),
    ({"formats": ["fbx"]}, "a format of a pack is one of glb, bvh; got fbx"),
    ({"styles": ["Old", "old"]}, "different file names; got Old, old"),
    ({"styles": []}, "one style or more"),
    ({"styles": ["Nobody"]}, "unknown style 'Nobody'"),
])
def test_what_cannot_be_packed_is_refused_in_a_line(tmp_path, options, said):
    model, bank = tk.pretrained()
    with pytest.raises(ValueError, match=r"pack|unknown") as error:
        pack.write(model, bank, tmp_path / "pack", **{"styles": ["Old"]} | options)
    assert said in str(error.value)
    assert not (tmp_path / "pack").exists()
