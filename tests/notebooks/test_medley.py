"""Clips one after the other."""

import torch
from course.medley import medley

import toolkit as tk


def test_a_medley_goes_on_where_the_last_clip_ended():
    clips = tk.datasets.procedural.load("Neutral", ["FW", "SW", "FR"], 3.0)
    whole = medley(clips, overlap=0.5)
    assert len(whole) == sum(map(len, clips)) - 2 * 30
    assert torch.equal(whole.rotations[:150], tk.motion.rotations.unroll(clips[0].rotations)[:150])
    middle = (
        whole.cut(180, 300),
        clips[1].cut(30, 150),
    )  # the second clip alone: relative to its root it is what it was
    assert torch.allclose(
        *(tk.motion.root_frames(c).to_local(c.global_positions) for c in middle), atol=1e-4
    )
    speed = tk.contacts.velocities(whole.global_positions, whole.fps).norm(dim=-1)
    fastest = max(
        tk.contacts.velocities(c.global_positions, c.fps).norm(dim=-1).max() for c in clips
    )
    assert speed.max() < 1.3 * fastest  # nothing jumps
