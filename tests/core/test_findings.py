"""The gate finds what is broken, with its joint and time, and is silent on recorded people."""

import math

import damages
import pytest
import torch
from refusal import refusal

import toolkit as tk
from experiments.defects import alarms, part, takes
from experiments.tables import Result
from toolkit.evaluation import defects, findings, table
from toolkit.motion import rotations as R


@pytest.fixture(scope="module")
def walk():
    return tk.datasets.procedural.generate("Neutral", seconds=4.0)


@pytest.fixture(scope="module")
def stand():
    return tk.datasets.procedural.generate("Neutral", "ID", 3.0)


def kinds(clip, **options):
    return {finding.kind for finding in defects(clip, **options)}


def test_a_walk_at_any_rate_has_no_defects(walk, stand):
    for clip in (walk, stand, walk.resample(30), walk.resample(120), walk.mirrored()):
        assert defects(clip) == []
    assert defects(walk.cut(0, 1)) == []


@pytest.mark.parametrize(("damage", "size", "kind"), [
    (damages.carried, 0.15, "slide"), (damages.carried, 0.8, "slide"),
    (damages.noise, 1.0, "pop"), (damages.jumped, 0.03, "pop"),
    (damages.shaken, 0.005, "shake"), (damages.through, 0.9, "body"),
    (damages.leg, 0.03, "floor"), (damages.leg, -0.04, "floor"),
])
def test_each_damage_is_found_at_each_rate(walk, damage, size, kind):
    for fps in (30, 60, 120):
        assert kind in kinds(damage(walk.resample(fps), size))


def test_slides_on_a_sloping_floor_are_those_on_a_level_one():
    walk = tk.datasets.procedural.generate("Neutral", seconds=8.0)
    tilt, rotations = torch.tensor([math.cos(0.01), -math.sin(0.01), 0, 0]), walk.rotations.clone()
    rotations[:, 0] = R.multiply(tilt, rotations[:, 0])
    slope = walk.replace(rotations=rotations, root_positions=R.rotate(tilt, walk.root_positions))
    level, uphill = (sum(f.end - f.start for f in defects(damages.carried(clip, 0.3)))
                     for clip in (walk, slope))
    assert uphill == pytest.approx(level, rel=0.2)


def test_a_finding_says_where_and_when(walk):
    found = [f for f in defects(damages.jumped(walk, 0.05)) if f.kind == "pop"]
    assert {f.joint for f in found} >= {"hips", "left_hand", "right_hand"}
    for finding in found:
        assert 1.8 < finding.start < 2.0 < finding.end < 2.2
        assert finding.excess > 1
    (hand,) = [f for f in defects(damages.through(walk, 1.0)) if f.joint == "left_hand and trunk"]
    assert hand.value == pytest.approx(0.0, abs=1e-3)  # at the chest


def test_a_standing_body_that_glides_drifts(stand):
    for speed in (0.24, 0.5):
        assert "drift" in kinds(damages.carried(stand, speed))
    assert "drift" in kinds(damages.carried(damages.frozen(stand, 1.0), 0.3))
    for speed, stands in ((0.2, True), (0.4, False)):  # a toe that moves shows no floor
        assert ("floor" in kinds(damages.carried(damages.leg(stand, 0.03), speed))) == stands


def test_a_foot_on_its_toes_is_not_flat(stand):
    """From the first second on, so that the heels are up in most frames."""
    points = damages.carried(stand, 0.15).global_positions.clone()
    ankles = [stand.skeleton.role(f"{side}_foot") for side in ("left", "right")]
    points[60:, ankles, 1] += 0.05
    found = defects([table.Joints(points, stand.skeleton, stand.fps)])
    assert 0.5 < max(f.end for f in found if f.kind == "slide") < 1.2


def test_a_standing_foot_that_trembles_does_not_slide(stand):
    """At 0.18 m/s from frame to frame, above the limit, but not over a tenth of a second."""
    sway = 0.003 * torch.tensor([1.0, 1.0, -1.0, -1.0]).repeat(len(stand))[: len(stand)]
    root = stand.root_positions.clone()
    root[:, 0] += sway
    assert not {"slide", "short slide", "drift"} & kinds(stand.replace(root_positions=root))


def test_a_knee_that_bends_backwards(walk):
    skeleton, twist = walk.skeleton, torch.zeros(len(walk), 1, 3)
    upper = skeleton.offsets[skeleton.role("left_knee")]
    half = upper / upper.norm() * torch.pi
    made = damages.turned(walk, [skeleton.role("left_hip")], twist + half)
    assert "knee" in kinds(made)


def test_characters_in_each_others_way(walk):
    beside = {gap: walk.moved(shift=(gap, 0.0, 0.0)) for gap in (0.25, 0.6, 3.0)}
    assert kinds([walk, beside[3.0]], apart=0.7) == set()
    (near,) = [f for f in defects([walk, beside[0.6]], apart=0.7) if f.kind == "apart"]
    assert (near.value, near.limit) == (pytest.approx(0.6, abs=1e-4), 0.7)
    assert "body" in kinds([walk, beside[0.25]])


def test_a_shot_is_rendered_first(fast):
    shot = tk.shots.Shot([(0.0, 0.0), (0.0, 2.0)], "Neutral")
    assert all(f.unit for f in defects(shot, fast))
    with refusal("give the model and its bank"):
        defects(shot)


def test_published_styles_are_marked_if_the_gate_finds_something_in_half_of_their_walk(shared):
    model, bank = tk.published.load(shared / "lpn_film_100style")
    fast = tk.runtime.compile(model)
    ahead = torch.tensor([[0.0, bank.speed(style)] for style in bank])
    states = list(tk.runtime.states(fast, [tk.runtime.Command(ahead)] * 660, bank.vectors))
    for i, (style, label) in enumerate(bank.labels().items()):
        clip = tk.runtime.record(model, states, character=i).cut(180)
        bad = torch.zeros(len(clip), dtype=torch.bool)
        for found in defects(clip):
            bad[round(60 * found.start) : round(60 * found.end) + 1] = True
        seconds = bad.unflatten(0, (-1, 60)).any(-1).float().mean()
        assert (label == f"{style} (broken)") == (seconds >= 0.5), (style, seconds)


def test_the_limits_are_those_that_the_stored_run_found():
    """In three digits or in two. That of drift is ours."""
    stored = Result.load("defects").numbers
    for kind, joints in findings.LIMITS.items():
        for joint, limits in joints.items() if kind != "drift" else ():
            for limit, found in zip(limits, stored[kind][joint], strict=True):
                assert limit in (found, float(f"{found:.2g}"))


def test_recorded_takes_that_made_no_limit_are_seldom_alarmed(shared):
    clips = [clip for clip in takes(shared, 8) if part(clip) == "alarms"]
    seconds, found = alarms(clips)
    assert seconds > 100
    assert found.get("any", 0) <= 0.05 * seconds  # of few takes


@pytest.mark.parametrize("axis", [0, 2])
def test_a_character_runs_in_any_direction_of_the_floor_and_not_upwards(walk, axis):
    still = walk.replace(root_positions=walk.root_positions[:1].expand(len(walk), 3))
    for along, found in ((axis, True), (1, False)):
        roots = still.root_positions.clone()
        roots[:, along] += 4.0 * torch.arange(len(still)) / still.fps
        assert bool(findings.runs(still.replace(root_positions=roots))[60:-60].all()) == found
