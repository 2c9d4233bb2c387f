import dataclasses
import itertools
import math
from functools import cache

import pytest
import torch

from toolkit import bvh, contacts
from toolkit.datasets import procedural
from toolkit.datasets.procedural import GAITS, SKELETON, STYLES
from toolkit.motion import root_frames

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
        assert float(torch.cos(known.phase[planted, foot]).mean()) > 0.5
        assert float(torch.cos(known.phase[~planted, foot]).mean()) < -0.3
    assert bool((known.phase.diff(dim=0) > -1e-3).all())
    assert 0.5 < float(known.frequency[:, 2].mean() / STYLES[style].cadence) < 1.3


@pytest.mark.parametrize(("style", "raised"), [("HopLeft", 0), ("HopRight", 1)])
def test_a_hopping_style_never_puts_the_other_foot_down(style, raised):
    for gait in ("FW", "SR", "ID", "TR1"):
        clip, known = take(style, gait)
        assert float(known.contacts[:, raised].sum()) == 0
        assert float(known.contacts[:, 1 - raised].sum()) > 30
        assert float(column(clip, f"{LEFT_TO_RIGHT[raised]}Toe")[:, 1].min()) > 0.12


@pytest.mark.parametrize("style", ["Neutral", "Zombie", "BigSteps", "Tiptoe"])
def test_the_contact_detector_finds_the_true_contacts(style):
    clip, known = take(style, "FW", 8.0)
    found = contacts.detect(clip)
    both = float((found * known.contacts).sum())
    assert 2 * both / float(found.sum() + known.contacts.sum()) > 0.94


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


def test_written_and_read_again(tmp_path):
    clip = take("Old", "FW")[0]
    bvh.save(clip, tmp_path / "Old_FW.bvh")
    again = bvh.load(tmp_path / "Old_FW.bvh")
    assert again.skeleton.names == SKELETON.names
    assert float((again.global_positions - clip.global_positions).abs().max()) < 1e-4


def test_unknown_names_list_the_known_ones():
    with pytest.raises(ValueError, match=r"'Moonwalk'; known are Neutral, .*Zombie"):
        procedural.load(["Moonwalk"])
    with pytest.raises(ValueError, match=r"'XX'; known are FW, BW"):
        procedural.generate("Neutral", "XX")
    with pytest.raises(ValueError, match="at least two frames, got 0"):
        procedural.generate("Neutral", "FW", 0)
