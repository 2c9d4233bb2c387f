import dataclasses
import itertools
import math
from functools import cache

import numpy as np
import pytest
import torch
import unchanged
from refusal import refusal

from toolkit import datasets
from toolkit.datasets import procedural, style100
from toolkit.datasets.procedural import GAITS, SKELETON, STYLES
from toolkit.io import bvh
from toolkit.motion import contacts

SIDES = ("Right", "Left")
HOPS = ("HopLeft", "HopRight")
# every style walks; some that are unlike each other have every gait
TAKES = [(style, "FW") for style in STYLES]
TAKES += [(style, gait) for style in ("Neutral", "Drunk", "HopLeft", "MarchKick")
          for gait in GAITS if gait != "FW"]
#: Models were trained on such clips, so they must not change.
PINNED = "Neutral FW, Drunk SW, HopRight FR, MarchKick BR, HandsInPockets ID, LimpLeft TR1"


@cache
def take(style, gait, seconds=4.0, seed=0):
    return procedural.truth(style, gait, seconds, seed)


def column(clip, joint):
    return clip.global_positions[:, SKELETON.index(joint)]


def test_there_are_25_styles_and_eight_gaits_and_they_stay_as_they_are():
    assert (len(STYLES), len(GAITS), len(SKELETON)) == (25, 8, 28)
    for name in PINNED.split(", "):
        clip, known = take(*name.split(), 2.0, 1)
        unchanged.check(f"procedural {name}", [clip.global_positions, known.contacts, known.phase],
                        near=1e-6)


@pytest.mark.parametrize(("style", "gait"), TAKES)
def test_feet_are_planted_and_bodies_upright_and_smooth(style, gait):
    clip, known = take(style, gait)
    assert (clip.style, clip.gait, clip.fps, len(clip)) == (style, gait, 60, 240)
    for i, side in enumerate(SIDES):
        toe = column(clip, f"{side}Toe")
        planted = known.contacts[:, i] > 0
        slide = toe.diff(dim=0).norm(dim=-1)[planted[1:] & planted[:-1]]
        assert not len(slide) or slide.max() < 1e-3, f"{side} slides"
        assert not planted.any() or (toe[planted, 1] - 0.021).abs().max() < 0.012
        knee = clip.rotations[:, SKELETON.index(f"{side}Knee")]
        knee = knee * knee[:, :1].sign()
        assert knee[:, 1].min() >= 0, f"{side} knee bends backwards"
        assert knee[:, 2:].abs().max() < 1e-3, f"{side} knee is no hinge"
    hips = column(clip, "Hips")[:, 1]
    assert 0.5 < hips.min() < hips.max() < 1.1
    assert clip.global_positions[..., 1].min() > -0.02, "sinks into the floor"
    assert clip.global_positions.diff(dim=0).norm(dim=-1).max() < 0.3, "jumps"
    jolt = float(clip.global_positions.double().diff(n=2, dim=0).norm(dim=-1).max()) * 3600
    assert jolt < (12 if gait == "ID" else 320), f"a joint is accelerated by {jolt:.0f} m/s2"
    if gait != "ID":
        found = contacts.detect(clip)
        both = float((found * known.contacts).sum())
        assert 2 * both / float(found.sum() + known.contacts.sum()) >= 0.95


def test_another_seed_gives_another_path():
    one, other = (procedural.load("Drunk", "TR1", 3.0, seed)[0] for seed in (7, 8))
    assert (one.root_positions - other.root_positions).abs().max() > 0.1


def test_a_given_path_and_a_style_of_ones_own():
    t = torch.arange(180) / 60
    circle = (torch.sin(t), 1 - torch.cos(t), t + math.pi / 2)  # of one metre, to the right
    path = torch.stack(circle, 1)
    mine = dataclasses.replace(STYLES["Neutral"], cadence=1.2, width=0.3)
    clip = procedural.generate(mine, path=path)
    assert (len(clip), clip.style) == (180, "custom")
    assert (clip.root_positions[:, [0, 2]] - path[:, :2]).norm(dim=-1).max() < 0.08
    short = procedural.generate(mine, path=path[:40])  # shorter than the margin beyond its ends
    assert (short.root_positions[:, [0, 2]] - path[:40, :2]).norm(dim=-1).max() < 0.1


def test_written_like_100style_and_read_back_equal(tmp_path, command, shared):
    styles, gaits = ["Drunk", "HopLeft", "Old"], ["FW", "TR1"]
    command(f"data write procedural --out {tmp_path}/a --styles {','.join(styles)} "
            f"--gaits {','.join(gaits)} --clip-seconds 1")
    clips = datasets.load("100style", tmp_path / "a")
    again = {(clip.style.removeprefix("Procedural"), clip.gait): clip for clip in clips}
    assert set(again) == set(itertools.product(styles, gaits))
    for (style, gait), other in again.items():
        clip, known = procedural.truth(style, gait, 1.0)
        assert (other.fps, other.skeleton.names) == (pytest.approx(60, abs=1e-4), SKELETON.names)
        assert (other.global_positions - clip.global_positions).abs().max() < 2e-5
        with np.load(tmp_path / "a" / f"Procedural{style}_{gait}.npz") as beside:
            for name, values in dataclasses.asdict(known).items():
                assert np.array_equal(beside[name], values.numpy())
    infos = style100.styles(tmp_path / "a")
    assert [info.stochastic for info in infos.values()] == [True, False, False]
    assert [info.symmetric for info in infos.values()] == [True, False, True]
    lopsided = {name for name, style in STYLES.items() if not style.symmetric}
    assert lopsided == {"DragRightLeg", *HOPS, "LimpLeft", "PendulumHands", "Zombie"}
    with refusal("already holds a dataset"):
        procedural.write(tmp_path / "a", "Old", "FW", 1.0)

    def layout(path):
        words = [line.split() for line in path.read_text().split("MOTION")[0].splitlines()]
        return [word for word in words if word and word[0] != "OFFSET"]

    bvh.save(take("Neutral", "FW")[0], tmp_path / "x.bvh")
    assert layout(tmp_path / "x.bvh") == layout(shared / "100style" / "Neutral_FW.bvh")
