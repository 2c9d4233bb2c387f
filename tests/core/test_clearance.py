"""Arms that keep clear of the body."""

import damages
import pytest
import torch
from torch.testing import assert_close

from toolkit.evaluation import defects
from toolkit.motion.clearance import EASE, THIGH, TRUNK, arms_out, covering, limbs, trunk


@pytest.mark.parametrize("turn", [0.0, 2.0])
def test_an_arm_in_the_trunk_is_turned_out_and_all_else_stays(walk_clip, turn):
    clip = walk_clip.cut(60, 300).moved(turn=turn)
    broken = damages.through(clip, 0.9)
    assert {found.kind for found in defects(broken)} == {"body"}
    made = arms_out(broken)
    assert defects(made) == []
    for side in ("left", "right"):
        assert torch.cdist(limbs(made)[f"{side}_hand"], trunk(made)).min() > TRUNK - 0.003
    assert_close(made.root_positions, broken.root_positions)
    arms = {j for side in ("left", "right")
            for j in clip.skeleton.tree.below(clip.skeleton.role(f"{side}_shoulder"))}
    rest = [j for j in range(len(clip.skeleton)) if j not in arms]
    assert_close(made.global_positions[:, rest], broken.global_positions[:, rest])
    assert arms_out(clip) is clip
    assert defects(arms_out(clip, thigh_gap=2 * THIGH)) == []


def test_a_correction_comes_and_goes_smoothly_and_is_enough():
    need = torch.zeros(200)
    need[80], need[100:104] = 0.3, 0.2
    curve = covering(need, 60.0)
    assert (curve >= need - 1e-6).all()
    assert curve[: 80 - int(2 * EASE * 60)].abs().max() == 0
    assert curve.diff(n=2).abs().max() < 0.01
