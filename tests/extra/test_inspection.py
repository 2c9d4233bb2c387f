"""`toolkit.inspect` and its verb."""

import math

import pytest
import rigs
from test_interpretation import written

import toolkit as tk


def test_an_inspection_says_all_that_was_found(tmp_path, command):
    path = tmp_path / "walk.bvh"
    written(rigs.walk("Unreal", seconds=2.0), path, rigs.TABLE["Unreal"])
    found = tk.inspect(path)
    assert (found.format, found.fps) == ("BVH", 60.0)
    assert found.floor == pytest.approx(0.02, abs=0.01)
    assert "root" in found.joints
    assert all(0.3 < share < 0.6 for share in found.contact.values())
    assert set(found.rules) == set(found.roles)
    said = command("inspect", path).out
    assert repr(found) in said
    for line in ("up        z", "unit      0.01 m (cm)", "upright   yes",
                 "pairs     14 of left and right joints", "hip       thigh_l, thigh_r (name)"):
        assert line in said
    said = command("inspect --unit inch --up z --roles left_toe=foot_l", path).out
    assert "unit      0.0254 m (inch)" in said
    assert "toe       foot_l, ball_r (given/name)" in said


def test_a_file_that_is_no_person_is_inspected(tmp_path):
    skeleton = tk.Skeleton(("base", "arm", "tip"), (-1, 0, 1), [[0, 0, 0], [0, 1, 0], [0, 1, 0]])
    still = tk.motion.rotations.identity(5, 3)
    tk.bvh.save(tk.Clip(skeleton, still, still[:, 0, 1:], 30.0), tmp_path / "crane.bvh")
    found = tk.inspect(tmp_path / "crane.bvh")
    assert math.isnan(found.height)
    assert not found.upright
    assert found.contact == {}
    assert "found for shoulder, elbow, hand, hip, knee, foot, toe: " in found.doubts[0]
    advice = [doubt.rsplit("; ", 1)[1] for doubt in found.doubts]
    assert advice == ["roles= decides", "up= decides", "unit= decides"]
    assert "no toes" in repr(found)
