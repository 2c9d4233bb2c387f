"""Legs without a toe joint, all the way through: the end site of the foot, or the ankle, stands in for the toe."""

import pytest
import rigs
import torch

import toolkit as tk


@pytest.fixture(scope="module", params=["end site", "ankle"])
def trained(request):
    clip = rigs.walk("Perception Neuron", seconds=8.0)
    skeleton = clip.skeleton
    clip = clip.replace(skeleton=tk.Skeleton(skeleton.names, skeleton.parents, skeleton.offsets, None, skeleton.ends))
    clip = clip if request.param == "end site" else clip.without_ends()
    assert clip.skeleton.roles["left_toe"] == ("LeftFootEnd" if request.param == "end site" else "LeftFoot")
    sizes = tk.networks.Sizes(hidden=32, experts=4, gating=8, film_channels=8, film_kernel=5, film_dense=16, dropout=0.0)
    return clip, tk.training.fit(tk.features.build(clip), tk.training.Config.quick(steps=40, sizes=sizes))


def test_a_toeless_rig_walks(trained):
    clip, run = trained
    commands = tk.runtime.straight(1.0, 1.5)
    plain, compiled = (tk.runtime.rollout(model, commands, run.bank["Neutral"])
                       for model in (run.model, tk.runtime.compile(run.model)))
    assert plain.skeleton.names == clip.skeleton.names
    assert plain.global_positions.isfinite().all()
    torch.testing.assert_close(compiled.global_positions, plain.global_positions, atol=5e-3, rtol=0)


def test_feet_are_planted_and_contacts_found(trained):
    clip, _ = trained
    skeleton = clip.skeleton
    toes = [skeleton.role(f"{side}_toe") for side in ("right", "left")]
    targets = clip.global_positions[:20][:, toes] + torch.tensor([0.01, 0.01, 0.02])
    planted = tk.motion.ik.plant_feet(skeleton, clip.rotations[:20], clip.root_positions[:20], targets)
    reached = clip.cut(0, 20).replace(rotations=planted).global_positions[:, toes]
    assert (reached - targets).norm(dim=-1).mean() < 0.005
    assert tk.contacts.detect(clip).mean() > 0.2


def test_a_style_is_learnt_from_a_toeless_rig(trained):
    clip, run = trained
    made = tk.styles.fine_tune(run.model, [clip], name="New", bank=run.bank, steps=3)
    assert "New" in made.bank
