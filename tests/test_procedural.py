import dataclasses
import itertools
import math
from functools import cache

import numpy as np
import pytest
import torch

from experiments import realism
from toolkit import datasets
from toolkit.__main__ import main
from toolkit.datasets import procedural, style100
from toolkit.datasets.procedural import GAITS, SKELETON, STYLES
from toolkit.io import bvh
from toolkit.motion import contacts, root_frames
from toolkit.motion import rotations as R

LEFT_TO_RIGHT = ("Right", "Left")
HOPS = ("HopLeft", "HopRight")
WALKERS = [s for s in STYLES if s not in HOPS]


@cache
def take(style, gait, seconds=4.0, seed=0):
    return procedural.truth(style, gait, seconds, seed)


def column(clip, joint):
    return clip.global_positions[:, SKELETON.index(joint)]


def test_there_are_at_least_24_styles_and_eight_gaits():
    assert len(STYLES) >= 24
    assert len(GAITS) == 8
    assert len(SKELETON) == 28


@pytest.mark.parametrize("gait", GAITS)
def test_every_style_has_every_gait_planted_upright_and_bending_forwards(gait):
    for style in STYLES:
        clip, known = take(style, gait)
        assert (clip.style, clip.gait, clip.fps, len(clip)) == (style, gait, 60, 240)
        for i, side in enumerate(LEFT_TO_RIGHT):
            toe = column(clip, f"{side}Toe")
            planted = known.contacts[:, i] > 0
            held = planted[1:] & planted[:-1]
            slide = toe.diff(dim=0).norm(dim=-1)[held]
            assert not len(slide) or float(slide.max()) < 1e-3, f"{style} {gait} {side} slides"
            assert not planted.any() or float((toe[planted, 1] - 0.021).abs().max()) < 0.012, f"{style} {gait}"
            knee = clip.rotations[:, SKELETON.index(f"{side}Knee")]
            knee = knee * knee[:, :1].sign()
            assert float(knee[:, 1].min()) >= 0, f"{style} {gait} {side} knee bends backwards"
            assert float(knee[:, 2:].abs().max()) < 1e-3, f"{style} {gait} {side} knee is no hinge"
        hips = column(clip, "Hips")[:, 1]
        assert 0.5 < float(hips.min()) < float(hips.max()) < 1.1, f"{style} {gait}"
        assert float(clip.global_positions[..., 1].min()) > -0.02, f"{style} {gait} sinks into the floor"
        steps = clip.global_positions.diff(dim=0)
        assert float(steps.norm(dim=-1).max()) < 0.3, f"{style} {gait} jumps"
        assert float(steps[:, 0].diff(dim=0).norm(dim=-1).max()) * 3600 < 60, f"{style} {gait}: the hips jerk"


@pytest.mark.parametrize("style", ["Neutral", "Drunk", "HandsInPockets"])
def test_the_same_seed_gives_the_same_bytes_and_another_one_another_path(style):
    one, two = (procedural.load([style], ["TR1"], 3.0, 7)[0] for _ in range(2))
    assert one.rotations.numpy().tobytes() == two.rotations.numpy().tobytes()
    assert one.root_positions.numpy().tobytes() == two.root_positions.numpy().tobytes()
    other = procedural.load([style], ["TR1"], 3.0, 8)[0]
    assert float((one.root_positions - other.root_positions).abs().max()) > 0.1


def test_load_gives_styles_times_gaits_on_different_paths():
    clips = procedural.load(["Neutral", "Zombie"], ["FW", "ID"], 2.0)
    assert [(c.style, c.gait) for c in clips] == [(s, g) for s in ("Neutral", "Zombie") for g in ("FW", "ID")]
    headings = {round(float(root_frames(c).rotations[0, 2]), 4) for c in clips}
    assert len(headings) == 4
    (one,) = procedural.load("Neutral", "FW", 2.0)
    assert (one.style, one.gait) == ("Neutral", "FW")


@pytest.mark.parametrize("style", WALKERS)
def test_contacts_alternate_and_phases_follow_them(style):
    _, known = take(style, "FW", 6.0)
    both = known.contacts.sum(1)
    assert float((both > 0).float().mean()) > 0.75  # walking: nearly always one toe planted
    strikes = [known.contacts[:, i].diff().gt(0).nonzero()[:, 0] for i in (0, 1)]
    order = sorted([(int(f), side) for side, frames in enumerate(strikes) for f in frames])
    assert all(a[1] != b[1] for a, b in itertools.pairwise(order)), f"{style}: {order}"
    for foot, i in ((3, 0), (2, 1)):  # a foot's phase is within a quarter turn of 0 while it is planted
        planted = known.contacts[:, i] > 0
        assert float(torch.cos(known.phase[planted, foot]).mean()) > 0.35  # an even clock and a stance of 70 % give 0.37
        assert float(torch.cos(known.phase[~planted, foot]).mean()) < -0.25
    assert bool((known.phase.diff(dim=0) > -1e-3).all())
    assert 0.5 < float(known.frequency[:, 2].mean() / STYLES[style].cadence) < 1.3


@pytest.mark.parametrize(("style", "raised"), [("HopLeft", 0), ("HopRight", 1)])
def test_a_hopping_style_never_puts_the_other_foot_down(style, raised):
    for gait in ("FW", "SR", "ID", "TR1"):
        clip, known = take(style, gait)
        assert float(known.contacts[:, raised].sum()) == 0
        assert float(known.contacts[:, 1 - raised].sum()) > 30
        assert float(column(clip, f"{LEFT_TO_RIGHT[raised]}Toe")[:, 1].min()) > 0.08


@pytest.mark.parametrize("gait", [g for g in GAITS if g != "ID"])
def test_the_contact_detector_finds_the_true_contacts(gait):
    for style in STYLES:
        clip, known = take(style, gait)
        found = contacts.detect(clip)
        both = float((found * known.contacts).sum())
        assert 2 * both / float(found.sum() + known.contacts.sum()) >= 0.95, f"{style} {gait}"


@pytest.mark.parametrize("gait", GAITS)
def test_joints_stay_within_human_ranges_and_nothing_snaps(gait):
    limits = {"Knee": (0, 150), "Elbow": (0, 150), "Ankle": (-65, 65), "Hip": (-60, 140)}  # degrees of flexion
    for style in STYLES:
        clip = take(style, gait)[0]
        for part, (low, high) in limits.items():
            for side in LEFT_TO_RIGHT:
                angle = flexion(clip, side, part)
                assert low <= angle.min() <= angle.max() <= high, f"{style} {gait} {part}: {angle.min()} to {angle.max()}"
        jolt = float(clip.global_positions.double().diff(n=2, dim=0).norm(dim=-1).max()) * 3600
        assert jolt < (12 if gait == "ID" else 320), f"{style} {gait}: a joint is accelerated by {jolt:.0f} m/s2"


def flexion(clip, side, part):
    """Flexion in degrees: of knee and elbow between two bones, of ankle and hip from standing upright."""
    joint = {n: clip.global_positions[:, SKELETON.index(f"{side}{n}")].double() for n in
             ("Shoulder", "Elbow", "Wrist", "Hip", "Knee", "Ankle", "Toe")}
    a, b, c = {"Knee": ("Hip", "Knee", "Ankle"), "Elbow": ("Shoulder", "Elbow", "Wrist"), "Ankle": ("Knee", "Ankle", "Toe"),
               "Hip": ("Hip", "Hip", "Knee")}[part]
    if part == "Hip":
        thigh = root_like(clip, joint["Knee"] - joint["Hip"])
        return torch.rad2deg(torch.atan2(thigh[:, 2], -thigh[:, 1]))
    between = torch.rad2deg(
        torch.acos(torch.cosine_similarity(joint[b] - joint[a], joint[c] - joint[b], dim=-1).clamp(-1, 1))
    )
    rest = SKELETON.offsets[SKELETON.index(f"{side}Toe")].double()
    flat = math.degrees(math.acos(-float(rest[1]) / float(rest.norm())))  # of a foot at right angles to the shin
    return between - flat if part == "Ankle" else between


def root_like(clip, vectors):
    """World vectors in the frame of the pelvis."""
    pelvis = clip.rotations[:, 0].double()
    return R.rotate(R.inverse(pelvis), vectors)


def test_the_drunk_staggers_and_the_sober_do_not():
    t = torch.arange(1800) / 60

    def unrest(style):
        known = procedural.truth(style, path=torch.stack((0 * t, 0.8 * t, 0 * t), 1))[1]
        strikes = known.contacts[:, 0].diff().gt(0).nonzero()[:, 0].float().diff()
        return float(strikes.std() / strikes.mean())

    assert unrest("Drunk") > 0.08 > 0.04 > unrest("Neutral")
    drunk, neutral = (take(s, "FW", 16.0)[0] for s in ("Drunk", "Neutral"))
    tilt = [root_like(c, column(c, "Neck").double() - column(c, "Hips").double())[:, 0].std() for c in (drunk, neutral)]
    assert float(tilt[0]) > 2 * float(tilt[1])


def test_a_transition_takes_its_time_whatever_its_length():
    for seconds in (4.0, 8.0, 20.0):
        clip = procedural.generate("Neutral", "TR1", seconds)
        roots = root_frames(clip)
        speed = (roots.positions[30:] - roots.positions[:-30]).norm(dim=-1) * 2
        moving = (speed > 0.25).int()
        starts = int((moving.diff() > 0).sum())
        rounds = max(1, round(seconds / 9.6))
        assert rounds <= starts <= 2 * rounds  # turning from forwards to backwards is another start
        assert 0.6 < float(moving.float().mean()) < 0.97


def test_gaits_go_where_they_say():
    def local_velocity(gait):
        clip = take("Neutral", gait, 8.0)[0]
        roots = root_frames(clip)
        return roots.turn_to_local(torch.cat((roots.positions.diff(dim=0), torch.zeros(1, 3))) * 60)[:-1]

    speed = {g: local_velocity(g) for g in GAITS}
    assert 0.8 < float(speed["FW"][:, 2].mean()) < 1.4
    assert float(speed["FR"][:, 2].mean()) > 1.9
    assert float(speed["BR"][:, 2].mean()) < float(speed["BW"][:, 2].mean()) < -0.5
    assert float(speed["SW"][:, 0].abs().mean()) > 3 * float(speed["SW"][:, 2].abs().mean())
    assert float(speed["SW"][:, 0].max()) > 0.3 > -0.3 > float(speed["SW"][:, 0].min())
    assert float(speed["ID"].norm(dim=-1).max()) < 0.1
    transition = speed["TR1"].norm(dim=-1)
    assert float(transition.max()) > 2.0
    assert float(transition[:10].max()) < 0.2
    assert float(transition[-10:].max()) < 0.2


def test_walks_turn_left_and_right():
    clip = procedural.generate("Neutral", "FW", 30.0)
    roots = root_frames(clip).rotations
    turn = torch.atan2(roots[:, 2], roots[:, 0]) * 2
    rate = torch.remainder(turn.diff() + math.pi, 2 * math.pi) - math.pi
    assert float((rate * 60 > 0.4).float().mean()) > 0.1
    assert float((rate * 60 < -0.4).float().mean()) > 0.1


def test_a_given_path_and_a_style_of_ones_own():
    t = torch.arange(180) / 60
    path = torch.stack((torch.sin(t), 1 - torch.cos(t), t + math.pi / 2), 1)  # a circle of one metre, to the right
    mine = dataclasses.replace(STYLES["Neutral"], cadence=1.2, width=0.3)
    clip = procedural.generate(mine, path=path)
    assert (len(clip), clip.style) == (180, "custom")
    assert float((clip.root_positions[:, [0, 2]] - path[:, :2]).norm(dim=-1).max()) < 0.08


def test_pinned_hands_stay_by_the_hips():
    clip = take("HandsInPockets", "FW")[0]
    hips = column(clip, "Hips")
    for side in LEFT_TO_RIGHT:
        reach = (column(clip, f"{side}Wrist") - hips).norm(dim=-1)
        assert float(reach.max() - reach.min()) < 5e-3


def test_written_like_100style_and_read_back_equal(tmp_path):
    gaits = ["FW", "SW", "TR1"]
    procedural.write(tmp_path / "a", gaits=gaits, seconds=1.5)
    again = {(c.style, c.gait): c for c in datasets.load("100style", tmp_path / "a")}
    assert set(again) == {(f"Procedural{s}", g) for s in STYLES for g in gaits}
    for style in STYLES:
        for gait in gaits:
            clip, known = procedural.truth(style, gait, 1.5)
            other = again[f"Procedural{style}", gait]
            assert (other.fps, other.skeleton.names) == (pytest.approx(60, abs=1e-4), SKELETON.names)
            assert float((other.global_positions - clip.global_positions).abs().max()) < 2e-5
            with np.load(tmp_path / "a" / f"Procedural{style}_{gait}.npz") as beside:
                for name, values in dataclasses.asdict(known).items():
                    assert np.array_equal(beside[name], values.numpy())
    infos = style100.styles(tmp_path / "a")
    assert all(info.description == f"procedural: {name.removeprefix('Procedural')}" for name, info in infos.items())
    assert [n for n, info in infos.items() if info.stochastic] == ["ProceduralDrunk"]
    lopsided = {n.removeprefix("Procedural") for n, info in infos.items() if not info.symmetric}
    assert lopsided == {"DragRightLeg", "HopLeft", "HopRight", "LimpLeft", "PendulumHands", "Zombie"}
    with pytest.raises(ValueError, match="already holds a dataset"):
        procedural.write(tmp_path / "a", "Old", "FW", 1.0)
    with pytest.raises(ValueError, match="a second clip of ProceduralOld FW"):
        procedural.write(tmp_path / "b", ["Old", "Old"], "FW", 1.0)
    assert not (tmp_path / "b" / "Frame_Cuts.csv").exists()


def test_the_verb_writes_the_same_bytes_every_time(tmp_path, capsys):
    for folder in ("a", "b"):
        with pytest.raises(SystemExit, match=r"^0$"):
            main(["data", "write", "procedural", "--out", str(tmp_path / folder), "--styles", "Old", "--gaits", "FW",
                  "--clip-seconds", "1"])
    files = sorted(p.name for p in (tmp_path / "a").iterdir())
    assert files == ["Dataset_List.csv", "Frame_Cuts.csv", "ProceduralOld_FW.bvh", "ProceduralOld_FW.npz"]
    assert all((tmp_path / "a" / f).read_bytes() == (tmp_path / "b" / f).read_bytes() for f in files)
    assert main(["data", "write", "xia", "--out", str(tmp_path)]) == 2
    assert "only the procedural dataset can be written" in capsys.readouterr().err


def test_files_have_the_layout_of_the_recordings(tmp_path, shared):
    bvh.save(take("Neutral", "FW")[0], tmp_path / "x.bvh")

    def layout(path):
        words = [line.split() for line in path.read_text().split("MOTION")[0].splitlines()]
        return [w for w in words if w and w[0] != "OFFSET"]

    assert layout(tmp_path / "x.bvh") == layout(shared / "100style" / "Neutral_FW.bvh")


def test_a_straight_walk_is_measured_right():
    t = torch.arange(600) / 60
    style = dataclasses.replace(STYLES["Neutral"], noise=0.0)
    clip = procedural.generate(style, path=torch.stack((0 * t, 1.2 * t, 0 * t), 1))
    found = realism.measure(clip)
    assert found["speed (m/s)"] == pytest.approx(1.2, abs=0.02)
    assert found["cadence (steps/min)"] == pytest.approx(108, abs=3)
    assert found["step length (m)"] == pytest.approx(1.2 * 60 / found["cadence (steps/min)"], abs=0.02)
    assert 25 < found["hips bob per stride (mm)"] < 47
    assert 0.40 < found["stance ratio of a toe"] < 0.48
    assert sum(len(part) for part in realism.straight_parts(clip)) > 270


def test_unknown_names_list_the_known_ones():
    with pytest.raises(ValueError, match=r"'Moonwalk'; known are Neutral, .*Zombie"):
        procedural.load(["Moonwalk"])
    with pytest.raises(ValueError, match=r"'XX'; known are FW, BW"):
        procedural.generate("Neutral", "XX")
    with pytest.raises(ValueError, match="at least two frames, got 0"):
        procedural.generate("Neutral", "FW", 0)
