"""Legs without a toe joint: the end site of the foot, or the ankle, stands in for the toe."""

import pytest
import rigs
import torch

import toolkit as tk


@pytest.fixture(scope="module", params=["end site", "ankle"])
def clip(request):
    clip = rigs.walk("Perception Neuron", seconds=8.0)
    old = clip.skeleton
    clip = clip.replace(skeleton=tk.Skeleton(old.names, old.parents, old.offsets, None, old.ends))
    if request.param == "ankle":
        clip = clip.without_ends()
    toe = "LeftFootEnd" if request.param == "end site" else "LeftFoot"
    assert clip.skeleton.roles["left_toe"] == toe
    return clip


def test_feet_are_planted_and_contacts_found(clip):
    skeleton = clip.skeleton
    toes = [skeleton.role(f"{side}_toe") for side in ("right", "left")]
    targets = clip.global_positions[:20][:, toes] + torch.tensor([0.01, 0.01, 0.02])
    planted = tk.motion.ik.plant_feet(skeleton, clip.rotations[:20], clip.root_positions[:20],
                                      targets)
    reached = clip.cut(0, 20).replace(rotations=planted).global_positions[:, toes]
    assert (reached - targets).norm(dim=-1).mean() < 0.005
    assert tk.contacts.detect(clip).mean() > 0.2
