"""Clips one after the other."""

import torch
from course.medley import medley

import toolkit as tk


def test_a_medley_goes_on_where_the_last_clip_ended():
    clips = tk.datasets.procedural.load("Neutral", ["FW", "SW", "FR"], 3.0)
    whole = medley(clips, overlap=0.5)
    assert len(whole) == sum(map(len, clips)) - 2 * 30
    assert torch.equal(whole.rotations[:150], tk.motion.rotations.unroll(clips[0].rotations)[:150])
    # the second clip alone: relative to its root it is what it was
    middle = (tk.motion.root_frames(clip).to_local(clip.global_positions)
              for clip in (whole.cut(180, 300), clips[1].cut(30, 150)))
    assert torch.allclose(*middle, atol=1e-4)
    speed, *fastest = (tk.contacts.velocities(clip.global_positions, clip.fps).norm(dim=-1).max()
                       for clip in (whole, *clips))
    assert speed < 1.3 * max(fastest)  # nothing jumps
